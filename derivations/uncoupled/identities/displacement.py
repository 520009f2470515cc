"""Section III: (1)-(5), (7), (10), (11)."""

from __future__ import annotations

from sympy import Basic, Expr, Matrix, atan2, cos, eye, sin, symbols

from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Columns, Cross, Dot, components, scalar, vector
from derivations.uncoupled.displacement import central_graph, q4, q5, q6, r
from derivations.uncoupled.geometry import LIMB_ANGLE, LIMBS, a, c, m1, n1, nu
from derivations.uncoupled.identities.facts import (
    QUATERNION_RELATION,
    X,
    Y,
    Z,
    absolute,
    central_facts,
    directions,
    leg,
    named,
    own_directions,
    pose,
    scalars,
    stated,
    vectors,
)

DIRECTIONS = (n1, vector("n2"), vector("n3"))


def identities() -> list[Identity]:
    """Everything of this section."""
    proofs = [*platform_directions(), *central_limb(), *round_trips()]
    for i in LIMBS:
        proofs += [*legs(i), *feet(i)]
    return proofs


def unit_directions() -> list[Expr]:
    """Lengths of the n_i and cosines between them, less 1 and less −1/2."""
    unfold = Unfolding(pose(), directions())
    lengths = [Dot(n, n) - 1 for n in DIRECTIONS]
    angles = [2 * Dot(DIRECTIONS[k - 1], DIRECTIONS[k]) + 1 for k in range(3)]
    return [unfold(entry) for entry in lengths + angles]


def limb_frames() -> list[Basic]:
    """[n_i, m_i, nu] less [n_1, m_1, nu] turned, and that the turn is a rotation."""
    unfold = Unfolding(pose(), own_directions(), ("n1", "m1", "nu"))
    entries: list[Basic] = []
    for i, (cosine, sine) in LIMB_ANGLE.items():
        turn = Matrix([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        turned = components(Columns(n1, m1, nu)) * turn
        entries.append(unfold(Columns(*vectors("n m", i), nu)) - turned)
        entries += [turn.T * turn - eye(3), turn.det() - 1]
    return entries


def platform_directions() -> list[Identity]:
    """(5) and the frames [n_i, m_i, nu]."""
    unfold = Unfolding(pose(), directions())
    return [
        computed_form(unfold, "m2", QUATERNION_RELATION),
        computed_form(unfold, "m3", QUATERNION_RELATION),
        Identity(
            "directions sum",
            "n_1 + n_2 + n_3 = 0",
            lambda: [unfold(n1 + vector("n2") + vector("n3"))],
            number="(5)",
        ),
        Identity(
            "directions unit",
            "the n_i are unit vectors and each two are 120° apart",
            unit_directions,
            QUATERNION_RELATION,
            "(5)",
        ),
        Identity(
            "limb frames",
            "[n_i, m_i, nu] is [n_1, m_1, nu] times a rotation, so any rotation stands for it",
            limb_frames,
            number="(5)",
        ),
    ]


def by_angles() -> Unfolding:
    """Reads (11) with the cosines and sines of both angles in components of c."""
    facts = central_facts()
    angles = {node: facts[node] for node in (cos(q4), sin(q4), cos(q5), sin(q5))}
    return Unfolding(pose(), angles, ("q6", "r"))


def central_limb() -> list[Identity]:
    """(11): what the joint values of the central limb are."""
    from_position = Unfolding(pose(), {})

    def lengths() -> list[Expr]:
        squares = {q6: X**2 + Y**2 + Z**2, r: X**2 + Y**2}
        return [from_position(length) ** 2 - square for length, square in squares.items()]

    return [
        stated(
            "azimuth and elevation",
            "the cosines and sines of (11) are c_x/r, c_y/r, r/q6 and c_z/q6",
            by_angles().facts,
            from_position,
            number="(11)",
        ),
        Identity(
            "central lengths",
            "r² and q6² are sums of squares of the position of C",
            lengths,
            number="(11)",
        ),
        computed_form(by_angles(), "lambda"),
    ]


def round_trips() -> list[Identity]:
    """(11) inverts (1), both ways."""
    return [
        Identity(
            "position from joints of position",
            "(1) at the joint values (11) gives back the position of C",
            lambda: [central_position().xreplace(angles_of_position()) - components(c)],
            number="(1), (11)",
        ),
        Identity(
            "joints from position of joints",
            "(11) at the position (1): each atan2 has the sine and the cosine of its angle "
            "times q6 cos q5 or q6, neither negative",
            joints_of_position_of_joints,
            tuple(sine**2 + cosine**2 - 1 for sine, cosine in ANGLES.values()),
            "(1), (11)",
        ),
    ]


#: Sine and cosine of both angles as symbols.
ANGLES = {q4: symbols("s4 c4", real=True), q5: symbols("s5 c5", real=True)}


def central_position() -> Expr:
    """(1) in components."""
    return Unfolding(central_graph(), {})(central_graph()["c"].expression)


def angles_of_position() -> dict[Expr, Expr]:
    """Cosines and sines of q4 and q5 in components of c."""
    return {node: components(value) for node, value in by_angles().facts.items()}


def joints_of_position_of_joints() -> list[Expr]:
    """What (11) takes, at the position (1), less what it must find there."""
    trigonometry: dict[Expr, Expr] = {}
    for angle, (sine, cosine) in ANGLES.items():
        trigonometry |= {sin(angle): sine, cos(angle): cosine}
    position = central_position().xreplace(trigonometry)
    unfold = Unfolding(pose(), {c: position}, ("q6", "r"))
    (s4, c4), (s5, c5) = ANGLES.values()
    azimuth, elevation = pose()["q4"].expression, pose()["q5"].expression
    assert azimuth.func is elevation.func is atan2
    pairs = [
        (unfold(pose()["q6"].expression ** 2), q6**2),
        (unfold(pose()["r"].expression ** 2), (q6 * c5) ** 2),
        (unfold(azimuth.args[0]), q6 * c5 * s4),
        (unfold(azimuth.args[1]), q6 * c5 * c4),
        (unfold(elevation.args[0]), q6 * s5),
        (unfold(elevation.args[1]), r),
    ]
    return [found - wanted for found, wanted in pairs]


def legs(i: int) -> list[Identity]:
    """(2)-(4), (6), (10): the leg of limb i and its length."""
    b, a_i, u = vectors("b a u", i)
    direct = Unfolding(pose(), {}, named("n", i))
    size, nonnegative = absolute(scalar(f"p{i}"))
    by_length = Unfolding(pose(), leg(i) | size, named("n p gt gz", i))
    return [
        Identity(
            f"leg {i} normal to u",
            f"(b_{i} − a_{i})·u_{i} = 0",
            lambda: [direct(Dot(b - a_i, u))],
            number="(2)",
        ),
        *(computed_form(direct, f"{name}{i}") for name in ("e", "gt", "gz")),
        stated(
            f"leg {i}",
            f"p_{i} (b_{i} − a_{i}) = gt_{i} t_{i} + gz_{i} k",
            leg(i),
            direct,
            number="(2)-(4)",
        ),
        computed_form(by_length, f"q{i}", nonnegative, squared=True),
        Identity(
            f"length of leg {i}",
            f"b_{i}·b_{i} − a² = |b_{i} − a_{i}|², so q_{i} is the length of the leg",
            lambda: [direct(Dot(b, b) - a**2 - Dot(b - a_i, b - a_i))],
            number="(6), (10)",
        ),
    ]


def feet(i: int) -> list[Identity]:
    """(7) and Section IV: the unit vector w_i and the point D_i."""
    b, u, n, d, w = vectors("b u n d w", i)
    p, q, gt, gz = scalars("p q gt gz", i)
    direct = Unfolding(pose(), {}, named("n", i))
    by_leg = Unfolding(pose(), leg(i), named("n p q gt gz ng", i))
    return [
        computed_form(by_leg, f"w{i}"),
        Identity(
            f"leg {i} unit",
            f"w_{i} is a unit vector",
            lambda: [by_leg(Dot(w, w) - 1)],
            (p**2 * q**2 - gt**2 - gz**2,),
            "Section IV",
        ),
        computed_form(by_leg, f"ng{i}"),
        computed_form(Unfolding(pose(), leg(i), named("n gt gz", i)), f"delta{i}"),
        Identity(
            f"D {i}",
            f"(d_{i} − b_{i})·n_{i} = 0 and D_{i} lies on the line OA_{i}",
            lambda: [direct(Dot(d - b, n)), *direct(Cross(d, u))],
            number="(7)",
        ),
    ]
