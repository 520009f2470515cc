"""Section III: two unknowns, the half angles of legs 1 and 2."""

from __future__ import annotations

from sympy import Basic, Expr, Matrix, MatrixSymbol, symbols

from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import components, matrix, scalar, vector
from derivations.uncoupled.circles import (
    ANGLE,
    CONE,
    HALVES,
    STARTS,
    arms_graph,
    circles_graph,
    parts,
)
from derivations.uncoupled.closure import LENGTHS, closure_graph, cones_graph
from derivations.uncoupled.geometry import LIMBS, a
from derivations.uncoupled.identities.facts import named, scalars, vectors

M3 = matrix("M3", 3, 3)
#: The parts of both arms, kept as they are.
PARTS = named("va vb vc", 1, 2)
#: Signed distances from C to B_1 and B_2.
EXTENSIONS = symbols("e1 e2", real=True)


def identities() -> list[Identity]:
    """The cones as matrices, the circles, and both conditions on them."""
    return [
        *(cone_matrix(i) for i in LIMBS),
        *(circle(i) for i in (1, 2)),
        angle_table(),
        cone_table(),
        limb_3(),
    ]


def cone_matrix(i: int) -> Identity:
    """F_i as a quadratic form."""
    (residual,), (n,) = scalars("F", i), vectors("n", i)
    kept = named("n ht hz q", i)
    form, whole = Unfolding(cones_graph(), {}, kept), Unfolding(closure_graph(), {}, kept)

    def difference() -> list[Expr]:
        entries, direction = form(matrix(f"M{i}", 3, 3)), components(n)
        value = (direction.T * entries * direction)[0, 0]
        return [value - whole(residual), *(entries - entries.T)]

    return Identity(
        f"matrix of cone {i}",
        f"F_{i} = n_{i} · M_{i} n_{i}, and M_{i} is symmetric",
        difference,
        number="(6)",
    )


def circle(i: int) -> Identity:
    """B_i stays on its circle."""
    unfold, by_parts = Unfolding(arms_graph(), {}), Unfolding(arms_graph(), {}, PARTS)
    cosine, sine = STARTS.row(i - 1)
    arm, half, u = vector(f"arm{i}"), HALVES[i - 1], vector(f"u{i}")

    def difference() -> list[Basic]:
        leg = unfold(arm) + components(vector("c")) - unfold(a * u)
        return [
            (leg.T * leg)[0, 0] - LENGTHS[i - 1] ** 2,
            (leg.T * unfold(u))[0, 0],
            (1 + half**2) * by_parts(arm) - whole_arm(i),
        ]

    return Identity(
        f"circle {i}",
        f"|b_{i} − a_{i}| = q_{i} and (b_{i} − a_{i})·u_{i} = 0 at every half angle",
        difference,
        (cosine**2 + sine**2 - 1,),
        "(2), (6)",
    )


def whole_arm(i: int) -> Matrix:
    """(1 + t²)(b_1 − c) or (1 + s²)(b_2 − c)."""
    constant, linear, square = map(components, parts(i))
    half = HALVES[i - 1]
    return constant + half * linear + half**2 * square


def in_forms(left: Matrix, right: Matrix) -> Expr:
    """The product of two vectors by M_3."""
    form = Unfolding(cones_graph(), {}, named("ht hz hp", 3))
    return (left.T * form(M3) * right)[0, 0]


def value_of(table: MatrixSymbol) -> Expr:
    """A polynomial in (t, s) from the table of its coefficients."""
    t, s = HALVES
    entries = Unfolding(circles_graph(), {}, PARTS + named("ht hz hp", 3))(table)
    return sum(entries[k, m] * t**k * s**m for k in range(5) for m in range(5))


def angle_table() -> Identity:
    """The first condition: n_1 and n_2 are 120° apart."""

    def difference() -> list[Expr]:
        first, second = whole_arm(1), whole_arm(2)
        return [
            value_of(ANGLE) - 4 * first.dot(second) ** 2 + first.dot(first) * second.dot(second)
        ]

    return Identity(
        "condition of the angle",
        "Σ A_kl t^k s^l = 4 (v_1·v_2)² − |v_1|² |v_2|², v_i the way from C to B_i "
        "times 1 + t² or 1 + s²",
        difference,
        number="(5)",
    )


def cone_table() -> Identity:
    """The second condition: limb 3 closes."""

    def difference() -> list[Expr]:
        first, second = whole_arm(1), whole_arm(2)
        mixed = 4 * first.dot(second) * in_forms(first, second)
        return [
            value_of(CONE)
            - second.dot(second) * in_forms(first, first)
            + mixed
            - first.dot(first) * in_forms(second, second)
        ]

    return Identity(
        "condition of limb 3",
        "Σ B_kl t^k s^l = |v_2|² v_1·M_3 v_1 − 4 (v_1·v_2) v_1·M_3 v_2 + |v_1|² v_2·M_3 v_2",
        difference,
        number="(6)",
    )


def limb_3() -> Identity:
    """Why the second condition is F_3 = 0."""
    (e1, e2), (v1, v2) = EXTENSIONS, (components(vector(f"arm{i}")) for i in (1, 2))
    kept = named("ht hz q", 3)
    closing = Unfolding(closure_graph(), {vector("n3"): -v1 / e1 - v2 / e2}, kept)
    form = Unfolding(cones_graph(), {}, kept)(M3)

    def difference() -> list[Expr]:
        own1, own2, mixed = (
            (left.T * form * right)[0, 0] for left, right in ((v1, v1), (v2, v2), (v1, v2))
        )
        norm1, norm2, dot = v1.dot(v1), v2.dot(v2), v1.dot(v2)
        condition = norm2 * own1 - 4 * dot * mixed + norm1 * own2
        of_lengths = (e2**2 - norm2) * own1 + (e1**2 - norm1) * own2
        of_angle = 2 * (e1 * e2 + 2 * dot) * mixed
        closure = e1**2 * e2**2 * closing(scalar("F3"))
        return [closure - condition - of_lengths - of_angle]

    return Identity(
        "closing limb 3",
        "e_1² e_2² F_3 at n_3 = −v_1/e_1 − v_2/e_2 is the condition of limb 3 and a combination of "
        "e_i² − |v_i|² and e_1 e_2 + 2 v_1·v_2, which vanish for signs of e_1, e_2 by the "
        "condition of the angle",
        difference,
        number="(5), (6)",
    )
