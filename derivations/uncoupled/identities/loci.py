"""Section V: where a determinant vanishes, as surfaces."""

from __future__ import annotations

from functools import cache

from sympy import Basic, Expr, ImmutableDenseMatrix, Integer, MatrixSymbol, ZeroMatrix, symbols

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.polynomials import monomials
from derivations.algebra.unfolding import QUATERNION, Unfolding
from derivations.algebra.vectors import (
    Dot,
    component_symbols,
    components,
    matrix,
    scalar,
    vector,
)
from derivations.uncoupled.geometry import LIMBS, ROOT, a, base_i, base_j, base_k, c, m1, n1, nu
from derivations.uncoupled.identities.correction import OMEGA
from derivations.uncoupled.identities.degenerate import COSINE, SINE
from derivations.uncoupled.identities.facts import (
    QUATERNION_RELATION,
    Facts,
    X,
    Y,
    Z,
    directions,
    named,
    own_directions,
    pose,
    scalars,
    vectors,
)
from derivations.uncoupled.loci import (
    CUBIC,
    direct_locus_graph,
    orientation_locus_graph,
    tilt_shift,
    tilt_turn,
)
from derivations.uncoupled.singularity import orientation, product, tilt

#: Cosine and sine of one angle.
CIRCLE = (SINE**2 + COSINE**2 - 1,)
#: A number that Euler parameters, or a length along a line, are multiplied by.
FACTOR = symbols("factor", real=True)
#: The monomials of the cubic at the position c.
MONOMIALS = [X**i * Y**j * Z**k for i, j, k in monomials(3)]


def identities() -> list[Identity]:
    """The cubic, the orientations at which it degenerates, the derivatives, the other loci."""
    return [
        *(affine_parts(i) for i in LIMBS),
        *cubic(),
        *degenerate(),
        *(mirrored(i) for i in LIMBS),
        *(at_no_incidence(i) for i in LIMBS),
        half_turn(),
        *(turn_of_limb(i) for i in LIMBS),
        *slopes(),
        *(degree_of_limb(i) for i in LIMBS),
        *(leg_locus(i) for i in LIMBS),
    ]


@cache
def locus() -> Graph:
    return direct_locus_graph()


@cache
def derivatives() -> Graph:
    return orientation_locus_graph()


def part(name: str, i: int) -> Basic:
    """τ_i or σ_i by its coefficients."""
    return matrix(f"{name}_part{i}", 4, 1)


def value(coefficients: ImmutableDenseMatrix) -> Expr:
    """A polynomial in c from its coefficients."""
    pairs = zip(coefficients, MONOMIALS, strict=False)
    return sum(coefficient * monomial for coefficient, monomial in pairs)


def computed_parts(i: int) -> Facts:
    """τ_i and σ_i by their proven forms, down to the pose."""
    found = scalars("gt gz tau sigma", i)
    return own_directions() | {symbol: pose()[symbol.name].computed_as for symbol in found}


def affine_parts(i: int) -> Identity:
    """τ_i and σ_i are affine in c."""
    facts = computed_parts(i) | directions()
    printed = Unfolding(pose(), facts)
    unfold = Unfolding(locus(), own_directions() | directions())

    def difference() -> list[Expr]:
        names = ("tau", "sigma")
        return [printed(scalar(f"{name}{i}")) - value(unfold(part(name, i))) for name in names]

    return Identity(
        f"affine parts of line {i}",
        f"tau_{i} and sigma_{i} are polynomials of degree one in c, with these coefficients",
        difference,
        QUATERNION_RELATION,
        "(27)",
    )


def by_parts() -> Facts:
    """τ_i and σ_i as polynomials in c: "affine parts of line i" proves them."""
    return {
        scalar(f"{name}{i}"): value(component_symbols(part(name, i)))
        for name in ("tau", "sigma")
        for i in LIMBS
    }


def cubic() -> list[Identity]:
    """The sum of the three products as one polynomial, and the factor of det J_v by it."""
    whole = Unfolding(locus(), {}, named("tau_part sigma_part", *LIMBS))
    computed = {orientation: pose()[orientation.name].computed_as}
    printed = Unfolding(pose(), by_parts() | computed, named("p", *LIMBS))
    incidences = product(scalar(f"p{i}") for i in LIMBS)
    return [
        Identity(
            "direct locus",
            "Σ k_j x^l y^m z^n = tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + tau3 sigma1 sigma2, "
            "by the coefficients of tau_i and sigma_i in c",
            lambda: [value(whole(CUBIC)) - printed(tilt)],
            number="(27)",
        ),
        Identity(
            "orientation by the direct locus",
            "(p1 p2 p3)² det[n_i × (d_i − c)] = √3/2 Σ k_j x^l y^m z^n",
            lambda: [printed(incidences**2 * orientation) - ROOT * value(whole(CUBIC))],
            number="(27)",
        ),
    ]


def yawed(side: int) -> Facts:
    """A level platform, its normal up (side 1) or down (side −1), turned about Z."""
    return {
        n1: ImmutableDenseMatrix([COSINE, SINE, 0]),
        m1: ImmutableDenseMatrix([-side * SINE, side * COSINE, 0]),
        nu: side * base_k,
    }


def coefficients(facts: Facts) -> ImmutableDenseMatrix:
    """The coefficients of the cubic at a family of rotations."""
    return Unfolding(locus(), own_directions() | facts)(CUBIC)


def without(entries: ImmutableDenseMatrix, *kept: Expr) -> list[Expr]:
    """The coefficients but those of some monomials."""
    pairs = zip(entries, MONOMIALS, strict=True)
    return [entry for entry, monomial in pairs if monomial not in kept]


def degenerate() -> list[Identity]:
    """Level platforms, where the cubic is no proper one."""

    def upright() -> list[Expr]:
        entries = coefficients(yawed(1))
        square = entries[MONOMIALS.index(Z**2)]
        return [*without(entries, Z**2), square + 3 * a * SINE * COSINE**4]

    return [
        Identity(
            "direct locus at R = 1",
            "every coefficient of the cubic vanishes",
            lambda: [coefficients({n1: base_i, m1: base_j, nu: base_k})],
            number="(27)",
        ),
        Identity(
            "direct locus at pure yaw",
            "the cubic is −3 a sin(yaw) cos(yaw)^4 z²: a double plane, and nothing at all at "
            "multiples of 90°",
            upright,
            CIRCLE,
            "(27)",
        ),
        Identity(
            "direct locus upside down",
            "where the platform's normal points down, the cubic is z² times a polynomial of "
            "degree one in x and y",
            lambda: without(coefficients(yawed(-1)), Z**2, X * Z**2, Y * Z**2),
            CIRCLE,
            "(27)",
        ),
    ]


def about(axis: ImmutableDenseMatrix) -> Facts:
    """Rotations about a unit vector, by cosine and sine of the angle."""
    columns = []
    for place in range(3):
        start = ImmutableDenseMatrix.eye(3)[:, place]
        along = axis.dot(start) * axis
        columns.append(along + COSINE * (start - along) + SINE * axis.cross(start))
    return dict(zip((n1, m1, nu), columns, strict=True))


def mirrored(i: int) -> Identity:
    """A platform that the plane of u_i and Z mirrors to itself."""
    u, t = (Unfolding(locus(), {})(each) for each in vectors("u t", i))
    inside = dict(zip((X, Y), FACTOR * u, strict=False))

    def difference() -> list[Expr]:
        return [value(coefficients(about(t))).xreplace(inside)]

    return Identity(
        f"direct locus turned about t_{i}",
        f"the cubic of a platform turned about t_{i} = k × u_{i} alone vanishes at c·t_{i} = 0: "
        "a plane and a quadric",
        difference,
        CIRCLE,
        "(27)",
    )


def at_no_incidence(i: int) -> Identity:
    """n_i in the plane of the leg, where B_i is not defined."""
    unfold = Unfolding(locus(), {scalar(f"p{i}"): Integer(0)}, (*named("m", i), "nu"))
    (u, m), height = vectors("u m", i), a - Dot(c, vector(f"u{i}"))

    def difference() -> list[Expr]:
        return [
            value(unfold(part(name, i))) - unfold(height * Dot(normal, u))
            for name, normal in (("tau", m), ("sigma", nu))
        ]

    return Identity(
        f"direct locus at p_{i} = 0",
        f"where n_{i}·u_{i} = 0, tau_{i} and sigma_{i} are multiples of a − c·u_{i}: the cubic is "
        "that plane and a quadric",
        difference,
        number="(27)",
    )


def half_turn() -> Identity:
    """The two platforms of each pair of assembly modes."""
    unfold = Unfolding(locus(), own_directions())
    turned = {entry: -entry for symbol in (n1, m1) for entry in components(symbol)}

    def difference() -> list[Basic]:
        changes = []
        for name, sign in (("tau", -1), ("sigma", 1)):
            for i in LIMBS:
                before = unfold(part(name, i))
                changes.append(before.xreplace(turned) - sign * before)
        return changes

    return Identity(
        "direct locus after half a turn",
        "half a turn of the platform about its normal changes the sign of every tau_i and of no "
        "sigma_i: of the whole cubic, which is the same surface",
        difference,
        number="(27)",
    )


def in_entries(i: int) -> dict[str, Expr]:
    """τ_i and σ_i in the entries of n_i, m_i, ν: the polynomials of "affine parts of line i"."""
    unfold = Unfolding(locus(), {}, (*named("n m", i), "nu"))
    return {name: value(unfold(part(name, i))) for name in ("tau", "sigma")}


def turn_of_limb(i: int) -> Identity:
    """The derivatives of τ_i and σ_i by a turn."""
    unfold = Unfolding(derivatives(), {}, (*named("n m", i), "nu", "c"))

    def slope(entry: Expr) -> Expr:
        total = 0
        for direction in (*vectors("n m", i), nu):
            moved = components(OMEGA).cross(components(direction))
            total += sum(
                entry.diff(x) * dx for x, dx in zip(components(direction), moved, strict=True)
            )
        return total

    def difference() -> list[Expr]:
        return [
            unfold(Dot(vector(f"{name}_turn{i}"), OMEGA)) - slope(entry)
            for name, entry in in_entries(i).items()
        ]

    return Identity(
        f"turn of line {i}",
        f"tau_{i} and sigma_{i} grow by tau_turn_{i}·omega and sigma_turn_{i}·omega where the "
        "platform turns by omega",
        difference,
        number="(27)",
    )


def slopes() -> list[Identity]:
    """The rule of products, by a turn and by the position."""
    return [slope("turn", tilt_turn), slope("shift", tilt_shift)]


def slope(way: str, result: MatrixSymbol) -> Identity:
    """A derivative of the whole sum."""
    unfold = Unfolding(derivatives(), {}, named(f"tau sigma tau_{way} sigma_{way}", *LIMBS))

    def difference() -> list[Basic]:
        total = ZeroMatrix(3, 1).as_explicit()
        for i in LIMBS:
            for name in ("tau", "sigma"):
                by_part = unfold(tilt).diff(scalar(f"{name}{i}"))
                total += by_part * components(vector(f"{name}_{way}{i}"))
        return [unfold(result) - total]

    return Identity(
        f"{way} of the direct locus",
        f"{derivatives()[result.name].words}: the sum over its six factors",
        difference,
        number="(27)",
    )


def degree_of_limb(i: int) -> Identity:
    """τ_i and σ_i in Euler parameters of any length."""
    square = sum(entry**2 for entry in QUATERNION)
    unfold = Unfolding(locus(), own_directions() | directions())
    u, height = vector(f"u{i}"), a - Dot(c, vector(f"u{i}"))
    longer = {entry: FACTOR * entry for entry in QUATERNION}

    def homogeneous(name: str, normal: MatrixSymbol) -> Expr:
        """Its term of degree two times |q|²."""
        lower = unfold(height * Dot(normal, u))
        return value(unfold(part(name, i))) + (square - 1) * lower

    def difference() -> list[Expr]:
        forms = [homogeneous("tau", vector(f"m{i}")), homogeneous("sigma", nu)]
        return [form.xreplace(longer) - FACTOR**4 * form for form in forms]

    return Identity(
        f"degree of line {i}",
        f"tau_{i} and sigma_{i} are of degree four in the Euler parameters, with "
        f"(a − c·u_{i}) |q|² for a − c·u_{i}: their sum of products is of degree twelve",
        difference,
        number="(27)",
    )


def leg_locus(i: int) -> Identity:
    """Where a leg has no length."""
    n, a_i = vectors("n a", i)
    unfold = Unfolding(pose(), {c: a_i + FACTOR * n}, named("n", i))
    legs = [pose()[symbol.name].computed_as for symbol in scalars("gt gz", i)]
    return Identity(
        f"locus of q_{i} = 0",
        f"if C lies on the line through A_{i} along n_{i}, the leg has no length",
        lambda: [unfold(each) for each in legs],
        number="(10)",
    )
