"""Newton's method in the angle of leg 1 and the turn about n_1.

Here F_1 = 0 holds by construction and F_2, F_3 are left. It works where C lies in the plane
of leg 1 too, where two angles of the leg belong to the same n_1.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Cross, Dot, Norm, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import LENGTHS, cone, third
from derivations.uncoupled.correction import turned
from derivations.uncoupled.eliminant import arm, cosine, leg_arm, sine
from derivations.uncoupled.geometry import HALF, ROOT, a, base_k, c, constants, n1

#: n_2 of the last step: its part along n_1 is set right first.
guess = vector("guess")
n2 = vector("n2")
by_angle = vector("by_angle")
angle_step, turn_step = scalar("dtheta"), scalar("dphi")


def first_leg() -> list[Equation]:
    """n_1 at the angle, how it turns with the angle, and n_2 at 120° from it."""
    t = vector("t1")
    tangent, side = vector("tangent"), vector("side_part")
    return [
        leg_arm(),
        Equation(scalar("span"), Norm(arm), "distance from C to B_1", unit="m"),
        Equation(n1, (1 / scalar("span")) * arm, "direction from C to B_1", "(3)"),
        Equation(
            tangent,
            LENGTHS[0] * (cosine * base_k - sine * t),
            "derivative of B_1 by theta",
            unit="m",
        ),
        Equation(
            by_angle,
            (1 / scalar("span")) * Cross(n1, tangent),
            "the turn that takes n_1 along with theta",
        ),
        Equation(side, guess - Dot(guess, n1) * n1, "part of the guess normal to n_1"),
        Equation(n2, -HALF * n1 + (ROOT / Norm(side)) * side, "direction from C to B_2", "(5)"),
        Equation(third, -n1 - n2, "the third direction", "(5)"),
    ]


def slopes(i: int | str) -> list[Equation]:
    """The derivatives of F_i by both angles."""
    by_turn = vector(f"G{i}")
    return [
        turned(i),
        Equation(scalar(f"Ft{i}"), Dot(by_turn, by_angle), "derivative of F_i by theta", unit="m²"),
        Equation(scalar(f"Fp{i}"), Dot(by_turn, n1), "derivative of F_i by phi", unit="m²"),
    ]


def steps() -> list[Equation]:
    """The 2×2 system for the steps, and where they lead."""
    f2, f3, t2, t3, p2, p3 = (scalar(f"{name}{i}") for name in ("F", "Ft", "Fp") for i in (2, 3))
    determinant, half = scalar("det_leg"), scalar("half_step")
    leg, moved = matrix("next_leg", 2, 1), vector("next_guess")
    next_arm, next_side, next_span = vector("next_arm"), vector("next_side"), scalar("next_span")
    next_n1 = vector("next_n1")
    return [
        *slopes(2),
        *slopes(3),
        Equation(determinant, t2 * p3 - t3 * p2, "determinant of the derivatives", unit="m⁴"),
        Equation(angle_step, (p2 * f3 - p3 * f2) / determinant, "step of theta", unit="rad"),
        Equation(turn_step, (t3 * f2 - t2 * f3) / determinant, "step of phi", unit="rad"),
        Equation(half, HALF * angle_step, "half of the step of theta"),
        Equation(
            leg,
            ImmutableDenseMatrix(
                [
                    ((1 - half**2) * cosine - 2 * half * sine) / (1 + half**2),
                    ((1 - half**2) * sine + 2 * half * cosine) / (1 + half**2),
                ]
            ),
            "cosine and sine of theta after the step",
        ),
        Equation(
            moved,
            n2 + turn_step * Cross(n1, n2) + angle_step * Cross(by_angle, n2),
            "n_2 moved by both steps, in first order",
        ),
        Equation(
            next_arm,
            a * vector("u1") - c + LENGTHS[0] * (leg[0, 0] * vector("t1") + leg[1, 0] * base_k),
            "from C to B_1 after the step",
            unit="m",
        ),
        Equation(next_span, Norm(next_arm), "distance from C to B_1 after the step", unit="m"),
        Equation(next_n1, (1 / next_span) * next_arm, "n_1 after the step", "(3)"),
        Equation(
            next_side,
            moved - Dot(moved, next_n1) * next_n1,
            "part of the moved n_2 normal to n_1 after the step",
        ),
        Equation(
            vector("next_n2"),
            -HALF * next_n1 + (ROOT / Norm(next_side)) * next_side,
            "n_2 after the step",
            "(5)",
        ),
        Equation(
            matrix("steps", 2, 1),
            ImmutableDenseMatrix([angle_step, turn_step]),
            "steps of theta and phi",
            unit="rad",
        ),
    ]


def leg_graph() -> Graph:
    """From the angle of leg 1 and n_2 to better ones."""
    graph = Graph((a, c, *LENGTHS, cosine, sine, guess))
    graph.add(constants())
    graph.add(first_leg())
    for i in (2, 3):
        graph.add(cone(i))
    graph.add(steps())
    pair = Rows(vector("next_n1"), vector("next_n2"))
    graph.add([Equation(matrix("pair", 2, 3), pair, "n_1 and n_2 after the step")])
    return graph
