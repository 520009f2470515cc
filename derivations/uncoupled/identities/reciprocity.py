"""Section IV: (15), (16) and the rows of the inverse Jacobian."""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Basic, Expr, ZeroMatrix

from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Dot, Norm, matrix, scalar
from derivations.uncoupled.geometry import LIMBS
from derivations.uncoupled.identities.facts import (
    CENTRAL,
    absolute,
    central_facts,
    from_platform,
    leg,
    limb_forms,
    line_from_leg,
    named,
    pose,
    scalars,
    span,
    vectors,
)
from derivations.uncoupled.velocity import screw

JOINTS = range(1, 7)
PASSIVE = (1, 3, 4, 5, 6)
WRIST = (4, 5, 6)
#: Any six joint rates.
ANY_RATES = {joint: scalar(f"rate{joint}") for joint in JOINTS}


def identities() -> list[Identity]:
    """Who is reciprocal to whom, and what is left over."""
    proofs = []
    for i in LIMBS:
        proofs += [*outer_limb(i), *diagonal(i), diagonal_by_angles(i)]
    return [*proofs, *central_limb(), *inverse_jacobian()]


def combination(limb: int, joints: Iterable[int] = JOINTS) -> Basic:
    """The right side of (12): joint rates times screws."""
    total = ZeroMatrix(6, 1)
    for joint in joints:
        total += ANY_RATES[joint] * screw(limb, joint)
    return total


def on_leg(i: int) -> Unfolding:
    """Limb i from its foot: b_i from the leg, c from b_i, d_i from both."""
    b, d = vectors("b d", i)
    length = {Norm(d - b): scalar(f"span{i}")}
    facts = leg(i) | from_platform(i) | line_from_leg(i) | length
    return Unfolding(pose(), facts, named("n e gt gz q", i))


def outer_limb(i: int) -> list[Identity]:
    """(15): S_i is reciprocal to each passive screw, so only q̇_i is left of (12)."""
    unfold, line = on_leg(i), matrix(f"S{i}", 6, 1)

    def reciprocal(joint: int) -> Identity:
        return Identity(
            f"reciprocity {i}{joint}",
            f"S_{i} is reciprocal to the passive screw {joint} of limb {i}",
            lambda: [unfold(Klein(line, screw(i, joint)))],
            number="(15)",
        )

    actuated = ANY_RATES[2] * Klein(line, screw(i, 2))
    return [
        *(reciprocal(joint) for joint in PASSIVE),
        Identity(
            f"row {i} of J_q",
            f"{{S_{i}; V}} = q̇_{i} {{S_{i}; $_{i}²}} for any rates of limb {i}: no other actuator "
            "stands in this row",
            lambda: [unfold(Klein(line, combination(i)) - actuated)],
            number="(15), (22)",
        ),
    ]


def diagonal(i: int) -> list[Identity]:
    """(23): the Klein form of S_i and the actuated screw."""
    b, d = vectors("b d", i)
    p, q, gt, gz, length = scalars("p q gt gz l", i)
    sizes, nonnegative = absolute(p)
    (size,) = sizes.values()
    joint_value = {q: length / size}
    leg_line = leg(i) | line_from_leg(i)
    by_leg = Unfolding(
        pose(), leg_line | span(i) | sizes | joint_value, (*named("n p gt gz l rho", i), "c")
    )
    ratio = Unfolding(pose(), span(i) | sizes | joint_value, named("p l rho", i))
    return [
        computed_form(by_leg, f"limb{i}", (length**2 - gt**2 - gz**2, *nonnegative)),
        Identity(
            f"diagonal {i} by lengths",
            f"{{S_{i}; $_{i}²}} = −q_{i}/|d_{i} − b_{i}|",
            lambda: [ratio(pose()[f"limb{i}"].computed_as + q / Norm(d - b))],
            nonnegative,
            "(23)",
        ),
    ]


def diagonal_by_angles(i: int) -> Identity:
    """The same without q_i: (q_i/|d_i − b_i|)² ((n·u)² + (n·w)²) = (n·u)²."""
    b, d, n, w = vectors("b d n w", i)
    p, q, gt, gz = scalars("p q gt gz", i)
    unfold = Unfolding(pose(), leg(i) | line_from_leg(i), named("n p q gt gz", i))
    return Identity(
        f"diagonal {i} by angles",
        f"{{S_{i}; $_{i}²}} = −|n_{i}·u_{i}|/sqrt((n_{i}·u_{i})² + (n_{i}·w_{i})²), by the "
        "squares: neither form is positive",
        lambda: [unfold(q**2 * (p**2 + Dot(n, w) ** 2) - p**2 * Dot(d - b, d - b))],
        (p**2 * q**2 - gt**2 - gz**2,),
        "(23)",
    )


def central_limb() -> list[Identity]:
    """(16): the wrist screws are reciprocal to each other."""
    unfold = Unfolding(pose(), {}, ("lambda", "n1", "n2", "q4", "c"))

    def reciprocal(row: int) -> Identity:
        return Identity(
            f"reciprocity 4{row}",
            f"the passive screw {row} of limb 4 is reciprocal to its screws 4, 5 and 6",
            lambda: [unfold(Klein(screw(4, row), screw(4, joint))) for joint in WRIST],
            number="(16)",
        )

    return [reciprocal(row) for row in WRIST]


def inverse_jacobian() -> list[Identity]:
    """(22), (24): the rows of the central limb."""
    kept = (*named("limb", *LIMBS), "n1", "n2", "c", "q6", "r")
    unfold = Unfolding(pose(), central_facts() | limb_forms(), kept)
    symbolic = Unfolding(pose(), {}, ("lambda", "n1", "n2", "axis", "c"))

    def rows() -> list[Expr]:
        actuated = [ANY_RATES[joint] * screw(4, joint) for joint in (1, 2, 3)]
        whole = combination(4)
        return [
            symbolic(Klein(screw(4, row), whole))
            - sum(symbolic(Klein(screw(4, row), part)) for part in actuated)
            for row in WRIST
        ]

    return [
        computed_form(unfold, "J_q", CENTRAL),
        Identity(
            "rows 4 to 6 of J_q",
            "{$; V} = q̇4 {$; $_4¹} + q̇5 {$; $_4²} + q̇6 {$; $_4³}: any rates, each wrist screw",
            rows,
            number="(16), (22), (24)",
        ),
    ]
