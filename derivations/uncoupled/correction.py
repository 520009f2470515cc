"""The closure equations on rotations: Newton's step, and the fold where two modes meet.

A turn omega of the platform moves n_i by omega × n_i, so that F_i grows by G_i·omega with
``G_i = n_i × dF_i``. Two assembly modes meet where the three G_i are coplanar.
"""

from __future__ import annotations

from sympy import Basic, ImmutableDenseMatrix, Rational, cos, sin

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Cross, Dot, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import LENGTHS, cone, first, second, third
from derivations.uncoupled.displacement import central_forward, q4, q5, q6
from derivations.uncoupled.geometry import LIMBS, a, base_i, base_j, base_k, c, constants

turn, half = vector("turn"), vector("half_turn")
volume = scalar("volume")
AXES = (base_i, base_j, base_k)


def gradients() -> list[Equation]:
    """G_i, and their triple product."""
    rows = [vector(f"G{i}") for i in LIMBS]
    return [
        *(
            Equation(
                vector(f"G{i}"),
                Cross(vector(f"n{i}"), vector(f"dF{i}")),
                f"derivative of F_{i} by a turn of the platform",
                "(6)",
                "m²",
            )
            for i in LIMBS
        ),
        Equation(
            volume,
            Dot(rows[0], Cross(rows[1], rows[2])),
            "triple product of the G_i: zero where modes meet",
            unit="m⁶",
        ),
    ]


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
            "Newton's turn: G_i·turn = −F_i",
            unit="rad",
        ),
        Equation(half, Rational(1, 2) * turn, "half of it"),
        Equation(scale, 2 / (1 + Dot(half, half)), "factor of Cayley's rotation"),
        Equation(vector("next1"), moved[0], "n_1 turned"),
        Equation(vector("next2"), moved[1], "n_2 turned"),
    ]


def curvature(i: int) -> list[Equation]:
    """How G_i changes by a turn about each base axis."""
    n, u, t = vector(f"n{i}"), vector(f"u{i}"), vector(f"t{i}")
    q = LENGTHS[i - 1]
    horizontal = Dot(c, t) * u + scalar(f"h{i}") * t
    vertical = Dot(c, base_k) * u + scalar(f"h{i}") * base_k
    equations = []
    for axis, base in zip("xyz", AXES, strict=True):
        slide, bend = vector(f"dn{i}{axis}"), vector(f"ddF{i}{axis}")
        equations += [
            Equation(slide, Cross(base, n), f"change of n_{i} by a turn about {axis}"),
            Equation(
                bend,
                2 * Dot(horizontal, slide) * horizontal
                + 2 * Dot(vertical, slide) * vertical
                - 2 * q**2 * Dot(u, slide) * u,
                f"change of dF_{i}",
                unit="m²",
            ),
            Equation(
                vector(f"dG{i}{axis}"),
                Cross(slide, vector(f"dF{i}")) + Cross(n, bend),
                f"change of G_{i}",
                unit="m²",
            ),
        ]
    return equations


def fold() -> list[Equation]:
    """The derivative of the triple product of the G_i by a turn."""
    g1, g2, g3 = (vector(f"G{i}") for i in LIMBS)
    slopes = [
        Dot(vector(f"dG1{axis}"), Cross(g2, g3))
        + Dot(vector(f"dG2{axis}"), Cross(g3, g1))
        + Dot(vector(f"dG3{axis}"), Cross(g1, g2))
        for axis in "xyz"
    ]
    return [
        Equation(
            vector("dvolume"),
            ImmutableDenseMatrix(slopes),
            "derivative of the triple product by a turn",
            unit="m⁶",
        )
    ]


def by_joints() -> list[Equation]:
    """q_j ∂F_i/∂q_j: what a relative change of each joint value does to each cone."""
    rows = []
    equations = [
        Equation(
            vector("dc5"),
            -cos(q4) * sin(q5) * base_i - sin(q4) * sin(q5) * base_j + cos(q5) * base_k,
            "change of lambda by the elevation",
        ),
        Equation(
            vector("dc4"),
            -sin(q4) * cos(q5) * base_i + cos(q4) * cos(q5) * base_j,
            "change of lambda by the azimuth",
        ),
    ]
    for i in LIMBS:
        n, u, t = vector(f"n{i}"), vector(f"u{i}"), vector(f"t{i}")
        p, q, gt, gz = (scalar(f"{name}{i}") for name in ("p", "q", "gt", "gz"))
        slope = vector(f"cF{i}")
        equations.append(
            Equation(
                slope,
                2 * gt * (p * t - Dot(n, t) * u) + 2 * gz * (p * base_k - Dot(n, base_k) * u),
                f"gradient of F_{i} by the position of C",
                "(6)",
                "m",
            )
        )
        own = -2 * p**2 * q**2
        row = [own if limb == i else 0 for limb in LIMBS]
        row += [
            q4 * q6 * Dot(slope, vector("dc4")),
            q5 * q6 * Dot(slope, vector("dc5")),
            Dot(slope, c),
        ]
        rows.append(row)
    equations.append(
        Equation(
            matrix("qF", 3, 6),
            ImmutableDenseMatrix(rows),
            "derivatives of F by the logarithms of q1 ... q6",
            "(6)",
            "m²",
        )
    )
    return equations


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
    for i in LIMBS:
        graph.add(curvature(i))
    graph.add([*fold(), *by_joints()])
    return graph


def cones_graph() -> Graph:
    """The symmetric matrices M_i of the cones: F_i = n_iᵀ M_i n_i."""
    graph = Graph((a, c, *LENGTHS))
    graph.add(constants())
    for i in LIMBS:
        u, t, h = vector(f"u{i}"), vector(f"t{i}"), scalar(f"h{i}")
        horizontal, vertical = vector(f"ht{i}"), vector(f"hz{i}")
        graph.add(
            [
                Equation(h, a - Dot(c, u), "distance of C from the plane of the limb", "(4)", "m"),
                Equation(horizontal, Dot(c, t) * u + h * t, "gt_i = ht_i · n_i", unit="m"),
                Equation(vertical, Dot(c, base_k) * u + h * base_k, "gz_i = hz_i · n_i", unit="m"),
                Equation(
                    matrix(f"M{i}", 3, 3),
                    symmetric_form(horizontal, vertical, u, LENGTHS[i - 1]),
                    f"cone of limb {i}: F_{i} = n_{i}ᵀ M_{i} n_{i}",
                    "(6)",
                    "m²",
                ),
            ]
        )
    return graph


def symmetric_form(horizontal: Basic, vertical: Basic, u: Basic, q: Basic) -> ImmutableDenseMatrix:
    """The matrix of gt² + gz² − p² q² as a quadratic form in n."""
    return ImmutableDenseMatrix(
        3,
        3,
        lambda i, j: horizontal[i, 0] * horizontal[j, 0]
        + vertical[i, 0] * vertical[j, 0]
        - q**2 * u[i, 0] * u[j, 0],
    )
