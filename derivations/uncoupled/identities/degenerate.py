"""Section V: families of poses at which a determinant vanishes."""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, Matrix, ZeroMatrix, symbols

from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Cross, Dot, components, scalar, vector
from derivations.uncoupled.displacement import lam
from derivations.uncoupled.geometry import LIMBS, ROOT, a, base_i, base_j, base_k, c, m1, n1, nu
from derivations.uncoupled.identities.facts import (
    Facts,
    Z,
    named,
    own_directions,
    pose,
    scalars,
    vectors,
)
from derivations.uncoupled.singularity import orientation
from derivations.uncoupled.velocity import screw

SINE, COSINE = symbols("s_yaw c_yaw", real=True)
NORMAL, OFFSET = vector("normal"), scalar("offset")


def identities() -> list[Identity]:
    """Each family of poses."""
    return [
        *arrangements_of_lines(),
        plane_of_joints(),
        *(through_origin(i) for i in LIMBS),
        *concurrent(),
        *upright_platforms(),
        vertical_limb(),
        parallel_limbs(),
    ]


def triple(columns: list[Basic]) -> Expr:
    """The triple product of three vectors."""
    first, second, third = columns
    return components(Dot(first, Cross(second, third)))


def arrangements_of_lines() -> list[Identity]:
    """Lines S_i that are parallel, or in one plane with C."""
    common, across = vector("common"), vector("across")
    arms = [vector(f"arm{i}") for i in LIMBS]

    def in_plane(name: str, i: int) -> Basic:
        return scalar(f"{name}_x{i}") * common + scalar(f"{name}_y{i}") * across

    def beside(i: int) -> Basic:
        """The moment of a line of the plane about C at some height below the plane."""
        arm = in_plane("arm", i) + scalar("height") * Cross(common, across)
        return Cross(arm, in_plane("s", i))

    def in_plane_moment(i: int) -> list[Expr]:
        (arm_x, arm_y), (s_x, s_y) = (
            [scalar(f"{name}_{axis}{i}") for axis in "xy"] for name in ("arm", "s")
        )
        return [s_x, s_y, arm_x * s_y - arm_y * s_x]

    return [
        Identity(
            "coplanar lines S beside C",
            "if the S_i are in a plane at some height over C, the determinant of their moments "
            "about C is height² times that of their coordinates in the plane, which vanishes "
            "only if they are parallel or meet in a point",
            lambda: [
                triple([beside(i) for i in LIMBS])
                - scalar("height") ** 2
                * components(Dot(Cross(common, across), Cross(common, across))) ** 2
                * Matrix([in_plane_moment(i) for i in LIMBS]).det()
            ],
            number="(27)",
        ),
        Identity(
            "parallel lines S",
            "if the S_i are parallel, their moments about C are coplanar and det J_v = 0",
            lambda: [triple([Cross(common, arm) for arm in arms])],
            number="(27)",
        ),
        Identity(
            "coplanar lines S with C",
            "if the S_i and C are in one plane, the moments are parallel and det J_v = 0",
            lambda: [triple([Cross(in_plane("s", i), in_plane("arm", i)) for i in LIMBS])],
            number="(27)",
        ),
    ]


def plane_of_joints() -> Identity:
    """When coplanar lines S_i are in one plane with C: when that plane is determined."""

    def difference() -> list[Expr]:
        third = {vector("n3"): -n1 - vector("n2")}
        unfold = Unfolding(pose(), third, (*named("e", *LIMBS), "n1", "n2", "c"))
        e1, e2, e3 = (scalar(f"e{i}") for i in LIMBS)
        gaps = [unfold(Dot(NORMAL, vector(f"b{i}"))) - OFFSET for i in LIMBS]
        combined = e2 * e3 * gaps[0] + e3 * e1 * gaps[1] + e1 * e2 * gaps[2]
        return [combined - (e1 * e2 + e2 * e3 + e3 * e1) * (unfold(Dot(NORMAL, c)) - OFFSET)]

    return Identity(
        "plane of the B_i",
        "a plane through B_1, B_2, B_3 holds C too unless e1 e2 + e2 e3 + e3 e1 = 0: always "
        "if every e_i > 0",
        difference,
        number="(3), (5), (27)",
    )


def through_origin(i: int) -> Identity:
    """When D_i is the point O."""
    n, u = vectors("n u", i)
    e, delta = scalars("e delta", i)
    unfold = Unfolding(pose(), {}, (*named("n e", i), "c"))
    return Identity(
        f"line {i} through O",
        f"(n_{i}·u_{i}) delta_{i} = e_{i} + c·n_{i}: D_{i} = O where e_{i} = −c·n_{i}",
        lambda: [unfold(Dot(n, u) * delta) - unfold(e + Dot(c, n))],
        (Dot(n, n).expanded() - 1,),
        "(7)",
    )


def concurrent() -> list[Identity]:
    """Lines S_i that meet at O."""
    extensions: Facts = {scalar(f"e{i}"): -Dot(c, vector(f"n{i}")) for i in LIMBS}
    at_origin: Facts = {vector(f"d{i}"): ZeroMatrix(3, 1) for i in LIMBS}
    unfold = Unfolding(pose(), extensions | at_origin, ("n1", "m1", "c"))
    return [
        Identity(
            "concurrent at O, extensions",
            "if all S_i meet at O then e_1 + e_2 + e_3 = 0, so not every e_i is positive",
            lambda: [unfold(sum(scalar(f"e{i}") for i in LIMBS))],
            number="(4), (5), (7)",
        ),
        Identity(
            "concurrent at O, orientation",
            "if all S_i meet at O then det[n_i × (d_i − c)] = 0",
            lambda: [unfold(orientation)],
            number="(27)",
        ),
    ]


def computed_factors() -> Facts:
    """The orientation factor by its proven forms, down to the pose."""
    names = ("gt", "gz", "tau", "sigma")
    symbols_of_limbs = [symbol for i in LIMBS for symbol in scalars(" ".join(names), i)]
    known = [orientation, *symbols_of_limbs]
    return own_directions() | {symbol: pose()[symbol.name].computed_as for symbol in known}


def upright_platforms() -> list[Identity]:
    """The orientation factor of a platform whose normal is vertical."""
    straight = {n1: base_i, m1: base_j, nu: base_k}
    turned = {
        n1: ImmutableDenseMatrix([COSINE, SINE, 0]),
        m1: ImmutableDenseMatrix([-SINE, COSINE, 0]),
    }
    parallel = Unfolding(pose(), computed_factors() | straight, ("c",))
    yawed = Unfolding(pose(), computed_factors() | turned | {nu: base_k}, ("c",))
    return [
        Identity(
            "orientation at R = 1",
            "det[n_i × (d_i − c)] = 0 for every position of a platform parallel to the base",
            lambda: [parallel(orientation)],
            number="(27)",
        ),
        Identity(
            "orientation at pure yaw",
            "det[n_i × (d_i − c)] = −(3√3/2) a sin(yaw) c_z² / cos²(yaw): a double plane in C",
            lambda: [yawed(orientation) + 3 * ROOT * a * SINE * Z**2 / COSINE**2],
            (SINE**2 + COSINE**2 - 1,),
            "(27)",
        ),
    ]


def vertical_limb() -> Identity:
    """The paper's example of (25)."""
    upright = {lam: base_k, c: scalar("height") * base_k}
    unfold = Unfolding(pose(), upright, ("n1", "n2", "axis"))
    return Identity(
        "vertical central limb",
        "if the central limb is vertical every wrist screw is reciprocal to the base screw: "
        "(25) holds",
        lambda: [unfold(Klein(screw(4, joint), screw(4, 1))) for joint in (4, 5, 6)],
        number="(25)",
    )


def parallel_limbs() -> Identity:
    """The paper's example of a combined singularity."""
    upright = {lam: base_k, c: scalar("height") * base_k, n1: base_i, m1: base_j, nu: base_k}
    unfold = Unfolding(pose(), computed_factors() | upright)
    legs = [Cross(vector(f"b{i}") - vector(f"a{i}"), lam) for i in LIMBS]
    sideways = [Dot(c, base_i), Dot(c, base_j)]
    return Identity(
        "four parallel limbs",
        "at R = 1 and C above O all four limbs are parallel, r = 0 and det[n_i × (d_i − c)] = 0: "
        "a combined singularity",
        lambda: [unfold(entry) for entry in (*legs, *sideways, orientation)],
        number="Section V",
    )
