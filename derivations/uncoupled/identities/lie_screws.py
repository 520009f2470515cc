"""Accelerations by screws: the reduced acceleration state and the Lie screws of the limbs.

``A_R = [d omega/dt; dv_C/dt − omega × v_C]`` is the sum of a limb's screws times what their
rates change by, plus the limb's Lie screw ``L = Σ_{j<k} rate_j rate_k [$_j $_k]``.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from sympy import Basic, Expr, ImmutableDenseMatrix, MatAdd, Matrix, ZeroMatrix

from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein, Lie, Screw
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Cross, Norm, components, matrix, scalar, vector
from derivations.uncoupled.accelerations import ACCELERATIONS, linear
from derivations.uncoupled.displacement import lam, q6
from derivations.uncoupled.geometry import LIMBS, c
from derivations.uncoupled.identities.accelerations import forward, inverse
from derivations.uncoupled.identities.chains import (
    BASE,
    LAST,
    SPIN,
    UPPER,
    Turn,
    assembled,
    derivative,
    pythagoras,
)
from derivations.uncoupled.identities.facts import named, pose, scalars, vectors
from derivations.uncoupled.identities.joint_rates import by_leg_angle
from derivations.uncoupled.identities.reciprocity import ANY_RATES, JOINTS, WRIST, combination
from derivations.uncoupled.rates import RATES, omega, velocity
from derivations.uncoupled.velocity import screw

ONE, OTHER, THIRD = (matrix(f"screw_{name}", 6, 1) for name in "abc")


def identities() -> list[Identity]:
    """The product, the outer limbs, the central limb."""
    proofs = [*product()]
    for i in LIMBS:
        proofs += [chain_acceleration(i), slide(i), bias(i)]
    return [*proofs, central_limb()]


def product() -> list[Identity]:
    """The Lie product, whatever the mechanism."""
    shift = vector("shift")

    def moved(one: Basic) -> Matrix:
        """The screw at another pole."""
        whole = components(one)
        primal, dual = whole[0:3, 0], whole[3:6, 0]
        return ImmutableDenseMatrix.vstack(primal, dual + components(Cross(primal, shift)))

    def jacobi() -> list[Basic]:
        cycle = ((ONE, OTHER, THIRD), (OTHER, THIRD, ONE), (THIRD, ONE, OTHER))
        return [sum((components(Lie(x, Lie(y, z))) for x, y, z in cycle), Matrix.zeros(6, 1))]

    return [
        Identity(
            "Lie product",
            "[$1 $2] = −[$2 $1], and [$1 [$2 $3]] + [$2 [$3 $1]] + [$3 [$1 $2]] = 0",
            lambda: [components(Lie(ONE, OTHER) + Lie(OTHER, ONE)), *jacobi()],
        ),
        Identity(
            "Lie product and Klein form",
            "{[$1 $2]; $3} = {$1; [$2 $3]}",
            lambda: [components(Klein(Lie(ONE, OTHER), THIRD) - Klein(ONE, Lie(OTHER, THIRD)))],
            number="(13)",
        ),
        Identity(
            "Lie product at another pole",
            "a change of pole, s_O → s_O + s × shift, changes [$1 $2] as it does any screw",
            lambda: [components(Lie(moved(ONE), moved(OTHER))) - moved(Lie(ONE, OTHER))],
        ),
    ]


def lie_screw(parts: list[Basic]) -> Basic:
    """L of a limb, from its screws times their rates in order."""
    return MatAdd(*(Lie(one, other) for one, other in combinations(parts, 2)))


def rated(limb: int) -> list[Basic]:
    """The screws of a limb times any rates."""
    return [ANY_RATES[joint] * screw(limb, joint) for joint in JOINTS]


def chain_acceleration(i: int) -> Identity:
    """The reduced acceleration state, by the joints of limb i."""

    def difference() -> Iterator[Basic]:
        q, e = scalars("q e", i)
        _, facts = assembled(i)
        unfold = Unfolding(pose(), facts, named("e q", i))
        factors = (1, 1, 1, 1 / UPPER[1], 1, -1)
        joints: tuple[Turn | Expr, ...] = (BASE, q, SPIN, UPPER, LAST, e)
        parts = [
            (joint, factor * unfold(screw(i, index)))
            for index, (joint, factor) in enumerate(zip(joints, factors, strict=True), start=1)
        ]
        # What stands at the product of two rates in A_R − Σ (rate)' $ and in L.
        for index, one in enumerate(parts):
            yield change(one, one)
            for other in parts[index + 1 :]:
                pair = components(Lie(one[1], other[1]))
                yield change(one, other) + change(other, one) - pair

    return Identity(
        f"reduced acceleration {i}",
        f"(12), differentiated along limb {i} joint by joint: A_R = Σ_j a_j $_{i}ʲ + L_{i} with "
        f"the accelerations a_j of its joints, a_2 = q̈{i}",
        difference,
        pythagoras(BASE, SPIN, UPPER, LAST),
        "(12)",
    )


def change(one: tuple[Turn | Expr, Matrix], other: tuple[Turn | Expr, Matrix]) -> Matrix:
    """What the rate of one joint makes of the other's screw, less its part of omega × v."""
    joint, by = one
    turned = components(Cross(by[0:3, 0], other[1][3:6, 0]))
    carried = ImmutableDenseMatrix.vstack(ImmutableDenseMatrix.zeros(3, 1), turned)
    return derivative(other[1], joint) - carried


def slide(i: int) -> Identity:
    """The last joint moves the platform against e_i."""
    facts, units = by_leg_angle(i)
    unfold = Unfolding(inverse(), facts | any_twist(i), named("n e q", i))
    return Identity(
        f"slide {i}",
        f"ė_{i} is minus the rate of screw 6 of limb {i}, for any rates of the limb",
        lambda: [unfold(scalar(f"de{i}")) + ANY_RATES[6]],
        units,
        "(4), (12)",
    )


def any_twist(i: int) -> dict[Basic, Basic]:
    """The twist that any rates of limb i make."""
    facts, _ = by_leg_angle(i)
    whole = Unfolding(pose(), facts, named("n e q", i))(combination(i))
    return {omega: whole[0:3, 0], velocity: whole[3:6, 0], scalar(f"dq{i}"): ANY_RATES[2]}


def bias(i: int) -> Identity:
    """Row i of the acceleration analysis, in screws."""
    facts, units = by_leg_angle(i)
    b, d = vectors("b d", i)
    given = {Norm(d - b): scalar(f"span{i}"), scalar(f"de{i}"): -ANY_RATES[6]}
    unfold = Unfolding(inverse(), facts | any_twist(i) | given, named("n e q", i))
    line = matrix(f"S{i}", 6, 1)
    carried = Screw(ZeroMatrix(3, 1), Cross(omega, velocity))
    alone = -Klein(line, lie_screw(rated(i))) - Klein(line, carried)
    return Identity(
        f"Lie screw {i}",
        f"{{S_{i}; A_R − L_{i}}} = q̈{i} {{S_{i}; $_{i}²}}: bias_{i} {{S_{i}; $_{i}²}} = "
        f"−{{S_{i}; L_{i}}} − s_{i}·(omega × v), for any rates of the limb",
        lambda: [unfold(scalar(f"bias{i}") * Klein(line, screw(i, 2)) - alone)],
        units,
        "(15)",
    )


def central_limb() -> Identity:
    """Rows 4 to 6, in screws."""
    values = {ANY_RATES[joint]: RATES[joint + 2] for joint in (1, 2, 3)}
    whole = combination(4).xreplace(values)
    kept = ("axis", "lambda", "q6", "n1", "n2", *(rate.name for rate in RATES[3:]))
    unfold = Unfolding(forward(), {c: q6 * lam}, kept)
    turning = unfold(whole)[0:3, 0]
    by_joints = Unfolding(forward(), {c: q6 * lam, omega: turning}, kept)

    def difference() -> list[Basic]:
        reduced = Screw(ZeroMatrix(3, 1), linear - Cross(omega, velocity))
        parts = [part.xreplace(values) for part in rated(4)]
        driven = MatAdd(*(ACCELERATIONS[k + 2] * screw(4, k) for k in (1, 2, 3)))
        left = reduced - lie_screw(parts) - driven
        return [by_joints(Klein(screw(4, row), left)) for row in WRIST]

    return Identity(
        "Lie screw 4",
        "{$; A_R − L_4} = q̈4 {$; $_4¹} + q̈5 {$; $_4²} + q̈6 {$; $_4³} for each wrist screw $ and "
        "any rates of the limb",
        difference,
        number="(16)",
    )
