"""The closure equations on rotations: Newton's step, and the fold where two modes meet.

A turn omega of the platform moves n_i by omega × n_i, so that F_i grows by G_i·omega with
``G_i = n_i × dF_i``. Two assembly modes meet where the three G_i are coplanar.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, ZeroMatrix, cos, sin

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Cross, Dot, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import FORMS, LENGTHS, cone, first, second, third
from derivations.uncoupled.displacement import central_forward, q4, q5, q6
from derivations.uncoupled.geometry import HALF, LIMBS, a, base_i, base_j, base_k, c, constants

turn, half = vector("turn"), vector("half_turn")
volume = scalar("volume")


def turned(i: int | str) -> Equation:
    """G_i."""
    return Equation(
        vector(f"G{i}"),
        Cross(vector(f"n{i}"), vector(f"dF{i}")),
        "derivative of F_i by a turn of the platform",
        "(6)",
        "m²",
    )


def gradients() -> list[Equation]:
    """G_i, and their triple product."""
    g1, g2, g3 = (vector(f"G{i}") for i in LIMBS)
    words = "triple product of the derivatives: zero where modes meet"
    return [*map(turned, LIMBS), Equation(volume, Dot(g1, Cross(g2, g3)), words, unit="m⁶")]


def residuals() -> list[Equation]:
    """F_1, F_2, F_3 and their derivatives as arrays."""
    return [
        Equation(
            matrix("F", 3, 1),
            ImmutableDenseMatrix([scalar(f"F{i}") for i in LIMBS]),
            "closure equations of the limbs",
            "(6)",
            "m²",
        ),
        Equation(
            matrix("G", 3, 3),
            Rows(*(vector(f"G{i}") for i in LIMBS)),
            "derivatives of F by a turn of the platform",
            "(6)",
            "m²",
        ),
    ]


def newton() -> list[Equation]:
    """Newton's turn by Cramer's rule, and the directions turned by it (Cayley's rotation)."""
    g1, g2, g3 = (vector(f"G{i}") for i in LIMBS)
    f1, f2, f3 = (scalar(f"F{i}") for i in LIMBS)
    scale = scalar("cayley")
    moved = [
        direction + scale * Cross(half, direction + Cross(half, direction))
        for direction in (first, second)
    ]
    return [
        Equation(
            turn,
            (-1 / volume) * (f1 * Cross(g2, g3) + f2 * Cross(g3, g1) + f3 * Cross(g1, g2)),
            "Newton's turn, which cancels every F_i",
            unit="rad",
        ),
        Equation(half, HALF * turn, "half of the turn"),
        Equation(scale, 2 / (1 + Dot(half, half)), "factor of Cayley's rotation"),
        Equation(vector("next1"), moved[0], "n_1 turned"),
        Equation(vector("next2"), moved[1], "n_2 turned"),
    ]


def lever(i: int | str, j: int | str, k: int | str) -> list[Equation]:
    """How G_j × G_k meets n_i, and the second derivative of F_i along that."""
    across, slide, bend = (vector(f"{name}{i}") for name in ("across", "slide", "bend"))
    horizontal, vertical, along = (
        Dot(form, slide) * form for form in (vector(f"{name}{i}") for name in FORMS)
    )
    return [
        Equation(
            across,
            Cross(vector(f"G{j}"), vector(f"G{k}")),
            "cofactor of the derivative of F_i by a turn",
            unit="m⁴",
        ),
        Equation(slide, Cross(across, vector(f"n{i}")), "change of n_i by a turn", unit="m⁴"),
        Equation(
            bend,
            2 * (horizontal + vertical - along),
            "change of the gradient of F_i with n_i",
            unit="m⁶",
        ),
    ]


def fold() -> list[Equation]:
    """The derivative of the triple product of the G_i by a turn of the platform."""
    equations, total = [], ZeroMatrix(3, 1)
    for i, j, k in ((1, 2, 3), (2, 3, 1), (3, 1, 2)):
        equations += lever(i, j, k)
        turned_back = Cross(vector(f"dF{i}"), vector(f"across{i}")) + vector(f"bend{i}")
        total += Cross(vector(f"n{i}"), turned_back)
    words = "derivative of the triple product by a turn of the platform"
    return [*equations, Equation(vector("dvolume"), total, words, unit="m⁶")]


def central_slopes() -> list[Equation]:
    """The derivatives of lambda by the angles of the central limb."""
    return [
        Equation(
            vector("dlambda4"),
            -sin(q4) * cos(q5) * base_i + cos(q4) * cos(q5) * base_j,
            "derivative of lambda by q4",
        ),
        Equation(
            vector("dlambda5"),
            -cos(q4) * sin(q5) * base_i - sin(q4) * sin(q5) * base_j + cos(q5) * base_k,
            "derivative of lambda by q5",
        ),
    ]


def position_slope(i: int | str) -> Equation:
    """The gradient of F_i by the position of C."""
    n, u, t = vector(f"n{i}"), vector(f"u{i}"), vector(f"t{i}")
    p, gt, gz = (scalar(f"{name}{i}") for name in ("p", "gt", "gz"))
    return Equation(
        vector(f"cF{i}"),
        2 * gt * (p * t - Dot(n, t) * u) + 2 * gz * (p * base_k - Dot(n, base_k) * u),
        "gradient of F_i by the position of C",
        "(6)",
        "m",
    )


def by_joints() -> list[Equation]:
    """q_j ∂F_i/∂q_j: what a relative change of each joint value does to each cone."""
    rows = []
    for i in LIMBS:
        slope, own = vector(f"cF{i}"), -2 * scalar(f"p{i}") ** 2 * scalar(f"q{i}") ** 2
        row = [own if limb == i else 0 for limb in LIMBS]
        row += [q * q6 * Dot(slope, vector(f"dlambda{j}")) for j, q in ((4, q4), (5, q5))]
        rows.append([*row, Dot(slope, c)])
    return [
        *central_slopes(),
        *map(position_slope, LIMBS),
        Equation(
            matrix("qF", 3, 6),
            ImmutableDenseMatrix(rows),
            "derivatives of F by the logarithms of the joint values",
            "(6)",
            "m²",
        ),
    ]


def add_cones(graph: Graph) -> None:
    """Add the cones of the three limbs, where C is known."""
    graph.add([Equation(third, -first - second, "the third direction", "(5)")])
    for i in LIMBS:
        graph.add(cone(i))
    graph.add([*gradients(), *residuals()])


def newton_graph() -> Graph:
    """From n_1, n_2 and joint values to the next n_1, n_2."""
    graph = Graph((a, c, first, second, *LENGTHS))
    graph.add(constants())
    add_cones(graph)
    graph.add(newton())
    return graph


def fold_graph() -> Graph:
    """From n_1, n_2 and joint values to what decides whether two modes have merged."""
    graph = Graph((a, first, second, *LENGTHS, q4, q5, q6))
    graph.add(constants())
    graph.add(central_forward())
    add_cones(graph)
    graph.add([*fold(), *by_joints()])
    return graph
