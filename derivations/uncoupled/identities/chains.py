"""(12): the screws of Section IV are the derivatives of limbs built joint by joint."""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, Matrix, cos, sin, symbols

from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Columns, vector
from derivations.uncoupled.displacement import central_graph, q4, q5, q6
from derivations.uncoupled.geometry import LIMBS, a, base_k, c
from derivations.uncoupled.identities.facts import named, pose, scalars, vectors
from derivations.uncoupled.velocity import screw

#: Sine and cosine of each turn of an outer limb; it slides by q_i and by −e_i between them.
BASE, SPIN, UPPER, LAST = (symbols(f"s_{n} c_{n}", real=True) for n in ("1", "3", "4", "5"))
#: Sine and cosine of the two base angles of the central limb, and of its turn about itself.
AZIMUTH, ELEVATION, ROLL = (symbols(f"s_{n} c_{n}", real=True) for n in ("q4", "q5", "roll"))
Turn = tuple[Expr, Expr]


def identities() -> list[Identity]:
    """One chain a limb."""
    return [*(outer_limb(i) for i in LIMBS), central_base(), central_limb()]


def about(axis: int, turn: Turn) -> Matrix:
    """The rotation about X, Y or Z (0, 1, 2)."""
    sine, cosine = turn
    rotation = Matrix.eye(3)
    after, last = (axis + 1) % 3, (axis + 2) % 3
    rotation[after, after] = rotation[last, last] = cosine
    rotation[after, last], rotation[last, after] = -sine, sine
    return rotation


def derivative(value: Basic, joint: Turn | Expr) -> Basic:
    """The derivative by a joint's angle or by its slide."""
    if isinstance(joint, tuple):
        sine, cosine = joint
        return cosine * value.diff(sine) - sine * value.diff(cosine)
    return value.diff(joint)


def pythagoras(*turns: Turn) -> tuple[Expr, ...]:
    return tuple(sine**2 + cosine**2 - 1 for sine, cosine in turns)


def moves(rotation: Matrix, position: Basic, joint: Turn | Expr, twist: Matrix) -> list[Basic]:
    """What vanishes if a joint turns and moves the platform as its screw, pole C, says."""
    turning = Matrix([twist[0:3]]).T
    columns = [turning.cross(rotation[:, k]) for k in range(3)]
    return [
        derivative(rotation, joint) - Matrix.hstack(*columns),
        derivative(position, joint) - Matrix(twist[3:6]),
    ]


def assembled(i: int) -> tuple[Matrix, dict[Basic, ImmutableDenseMatrix]]:
    """The platform's rotation and the vectors of limb i, by its joints."""
    (b, n, w), (q, e) = vectors("b n w", i), scalars("q e", i)
    foot = Matrix(Unfolding(pose(), {})(Columns(vector(f"u{i}"), vector(f"t{i}"), base_k)))
    swung = foot * about(0, BASE)
    bent = swung * about(2, SPIN) * about(0, UPPER)
    leg, joint_axis = swung[:, 2], bent[:, 1]
    joint = a * foot[:, 0] + q * leg
    values = {n: joint_axis, w: leg, b: joint, c: joint - e * joint_axis}
    facts = {symbol: ImmutableDenseMatrix(value) for symbol, value in values.items()}
    return bent * about(1, LAST), facts


def outer_limb(i: int) -> Identity:
    """R, P, R, R, C: from the base revolute along the leg to the platform."""

    def difference() -> list[Basic]:
        q, e = scalars("q e", i)
        rotation, facts = assembled(i)
        unfold = Unfolding(pose(), facts, named("e q", i))
        # The hinge n × w has the length cos θ4, so its screw turns at the rate θ4' / cos θ4;
        # the platform slides along n at the rate −ė, since e counts from C to B.
        factors = (1, 1, 1, 1 / UPPER[1], 1, -1)
        joints = (BASE, q, SPIN, UPPER, LAST, e)
        entries = []
        for index, (joint, factor) in enumerate(zip(joints, factors, strict=True), start=1):
            entries += moves(rotation, facts[c], joint, factor * unfold(screw(i, index)))
        return entries

    return Identity(
        f"chain {i}",
        f"limb {i}, built joint by joint: each joint turns the platform and moves C as its screw",
        difference,
        pythagoras(BASE, SPIN, UPPER, LAST),
        "(12)",
    )


def central_facts() -> dict[Basic, Basic]:
    """(1) in sines and cosines as symbols."""
    values: dict[Basic, Basic] = {}
    for angle, (sine, cosine) in ((q4, AZIMUTH), (q5, ELEVATION)):
        values |= {sin(angle): sine, cos(angle): cosine}
    direction = central_graph()["lambda"]
    return values | {direction.symbol: direction.expression, c: q6 * direction.symbol}


def central_base() -> Identity:
    """R, R, P: the actuated joints carry C."""
    unfold = Unfolding(pose(), central_facts(), ("q6",))

    def difference() -> list[Basic]:
        center = unfold(c)
        joints = ((AZIMUTH, 1), (ELEVATION, 2), (q6, 3))
        return [derivative(center, joint) - unfold(screw(4, k))[3:6, 0] for joint, k in joints]

    return Identity(
        "chain 4, position",
        "the derivatives of (1) by q4, q5 and q6 are the dual parts of the actuated screws",
        difference,
        pythagoras(AZIMUTH, ELEVATION),
        "(1), (12)",
    )


def central_limb() -> Identity:
    """The turns of the central limb up to its revolute; the wrist turns about C."""
    unfold = Unfolding(pose(), central_facts(), ("q6", "n1", "n2"))

    def difference() -> list[Basic]:
        down = (-ELEVATION[0], ELEVATION[1])
        rotation = about(2, AZIMUTH) * about(1, down) * about(0, ROLL)
        entries: list[Basic] = [rotation[:, 0] - unfold(vector("lambda"))]
        for joint, index in ((AZIMUTH, 1), (ELEVATION, 2), (ROLL, 4)):
            entries += moves(rotation, unfold(c), joint, unfold(screw(4, index)))
        return entries + [unfold(screw(4, index))[3:6, 0] for index in (4, 5, 6)]

    return Identity(
        "chain 4, orientation",
        "the central limb turns about k, the axis and lambda; the screws of its wrist do not "
        "move C, and span every rotation unless (n1×n2)·lambda = 0",
        difference,
        pythagoras(AZIMUTH, ELEVATION, ROLL),
        "(12)",
    )
