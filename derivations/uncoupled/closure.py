"""Section III: the six quadratic equations in the directions (n_1, n_2).

Clearing the denominators of (4) from (6) leaves a cone in each n_i, homogeneous of
degree two; n_3 = −n_1 − n_2, and n_1, n_2 are unit vectors 120° apart.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, Rational, ZeroMatrix

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Dot, Rows, Stack, matrix, scalar, vector
from derivations.uncoupled.geometry import LIMBS, a, base_k, c, constants

first, second, third = (vector(f"n{i}") for i in LIMBS)
LENGTHS = tuple(scalar(f"q{i}") for i in LIMBS)
#: The forms of a limb: the squares of the first two less that of the third are its cone.
FORMS = ("ht", "hz", "hp")


def forms(i: int | str) -> list[Equation]:
    """Vectors of limb i: gt_i, gz_i and p_i q_i are their scalar products with n_i."""
    u, t, h = vector(f"u{i}"), vector(f"t{i}"), scalar(f"h{i}")
    return [
        Equation(h, a - Dot(c, u), "distance of C from the plane of the limb", "(4)", "m"),
        Equation(
            vector(f"ht{i}"),
            Dot(c, t) * u + h * t,
            "p_i times the horizontal part of the leg, as a form in n_i",
            unit="m",
        ),
        Equation(
            vector(f"hz{i}"),
            Dot(c, base_k) * u + h * base_k,
            "p_i times the vertical part of the leg, as a form in n_i",
            unit="m",
        ),
        Equation(
            vector(f"hp{i}"),
            scalar(f"q{i}") * u,
            "p_i times the length of the leg, as a form in n_i",
            unit="m",
        ),
    ]


def cone(i: int | str) -> list[Equation]:
    """(6) times p_i squared, and its gradient in n_i."""
    n, horizontal, vertical, along = (vector(f"{name}{i}") for name in ("n", "ht", "hz", "hp"))
    p, q, gt, gz = (scalar(f"{name}{i}") for name in ("p", "q", "gt", "gz"))
    return [
        *forms(i),
        Equation(p, Dot(n, vector(f"u{i}")), "cosine of the angle between n_i and u_i", "(4)"),
        Equation(gt, Dot(horizontal, n), "p_i times the horizontal part of the leg", unit="m"),
        Equation(gz, Dot(vertical, n), "p_i times the vertical part of the leg", unit="m"),
        Equation(
            scalar(f"F{i}"),
            gt**2 + gz**2 - p**2 * q**2,
            "closure equation of limb i, times p_i squared",
            "(6)",
            "m²",
        ),
        Equation(
            vector(f"dF{i}"),
            2 * gt * horizontal + 2 * gz * vertical - 2 * p * q * along,
            "gradient of F_i in n_i",
            "(6)",
            "m²",
        ),
    ]


def form_matrix(i: int | str) -> Equation:
    """The symmetric matrix M_i of the cone."""
    horizontal, vertical, along = (vector(f"{name}{i}") for name in FORMS)
    return Equation(
        matrix(f"M{i}", 3, 3),
        horizontal * horizontal.T + vertical * vertical.T - along * along.T,
        "matrix of the cone, which is F_i = n_i · M_i n_i",
        "(6)",
        "m²",
    )


def unit_conditions() -> list[Equation]:
    """|n_1| = |n_2| = 1 and n_1·n_2 = −1/2."""
    return [
        Equation(scalar("F4"), Dot(first, first) - 1, "n_1 is a unit vector", "(5)"),
        Equation(scalar("F5"), Dot(second, second) - 1, "n_2 is a unit vector", "(5)"),
        Equation(
            scalar("F6"), Dot(first, second) + Rational(1, 2), "n_1, n_2 are 120° apart", "(5)"
        ),
    ]


def system() -> list[Equation]:
    """The six residuals and the rows of their derivatives by (n_1, n_2)."""
    d1, d2, d3 = (vector(f"dF{i}") for i in LIMBS)
    nothing = ZeroMatrix(3, 1)
    rows = [(d1, nothing), (nothing, d2), (-d3, -d3)]
    rows += [(2 * first, nothing), (nothing, 2 * second), (second, first)]
    residuals = ImmutableDenseMatrix([scalar(f"F{index}") for index in range(1, 7)])
    unit = "m², 1"
    return [
        Equation(matrix("F", 6, 1), residuals, "closure equations in (n_1, n_2)", "(6)", unit),
        Equation(
            matrix("dF", 6, 6),
            Rows(*(Stack(left, right) for left, right in rows)),
            "derivatives of F by (n_1, n_2)",
            "(6)",
            unit,
        ),
    ]


def closure_graph() -> Graph:
    """From n_1, n_2 and joint values to the residual and its Jacobian."""
    graph = Graph((a, c, first, second, *LENGTHS))
    graph.add(constants())
    graph.add([Equation(third, -first - second, "the third direction", "(5)")])
    for i in LIMBS:
        graph.add(cone(i))
    graph.add(unit_conditions())
    graph.add(system())
    return graph


def cones_graph() -> Graph:
    """From joint values to the matrices M_i of the cones."""
    graph = Graph((a, c, *LENGTHS))
    graph.add(constants())
    for i in LIMBS:
        graph.add([*forms(i), form_matrix(i)])
    return graph
