"""The forward displacement reduced to two unknowns, the half angles of legs 1 and 2.

B_1 and B_2 lie on circles, at t = tan of half the angle of leg 1 and s of leg 2. Two
conditions are left, of degree four in t and in s: the angle of 120° between n_1 and n_2, and
the cone of limb 3. Two such equations have 4·4 + 4·4 = 32 common zeros.
"""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, S

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Dot, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import LENGTHS
from derivations.uncoupled.eliminant import forms
from derivations.uncoupled.geometry import a, base_k, c, constants

#: Cosine and sine of the angles at which t = 0 and s = 0.
STARTS = matrix("start", 2, 2)
TABLE = 3
ANGLE, CONE = matrix("angle", 5, 5), matrix("cone", 5, 5)
FIRST, SECOND = matrix("first", 3, 3), matrix("second", 3, 3)


def circle(i: int) -> list[Equation]:
    """(1 + t²)(b_i − c) as a vector at 1, t and t²."""
    u, t = vector(f"u{i}"), vector(f"t{i}")
    near, up = vector(f"near{i}"), vector(f"up{i}")
    cosine, sine = STARTS[i - 1, 0], STARTS[i - 1, 1]
    center, q = vector(f"center{i}"), LENGTHS[i - 1]
    return [
        Equation(center, a * u - c, f"from C to A_{i}", unit="m"),
        Equation(near, cosine * t + sine * base_k, f"direction of leg {i} at half angle 0"),
        Equation(up, cosine * base_k - sine * t, f"direction of leg {i} a quarter turn on"),
        Equation(vector(f"v{i}0"), center + q * near, f"(1 + t²)(b_{i} − c) at 1", unit="m"),
        Equation(vector(f"v{i}1"), 2 * q * up, f"(1 + t²)(b_{i} − c) at t", unit="m"),
        Equation(vector(f"v{i}2"), center - q * near, f"(1 + t²)(b_{i} − c) at t²", unit="m"),
    ]


def products() -> list[Equation]:
    """Coefficients of |v_1|², |v_2|², v_1·v_2 and of the cone of limb 3 between them."""
    first, second = ([vector(f"v{i}{k}") for k in range(TABLE)] for i in (1, 2))
    equations = []
    for i, own in ((1, first), (2, second)):
        equations.append(
            Equation(
                matrix(f"N{i}", 5, 1),
                ImmutableDenseMatrix(convolved(own, own, Dot)),
                f"coefficients of |v_{i}|²",
                unit="m²",
            )
        )
        for name in ("ht", "hz", "hp"):
            equations.append(
                Equation(
                    matrix(f"{name}v{i}", 3, 1),
                    ImmutableDenseMatrix([Dot(vector(f"{name}3"), entry) for entry in own]),
                    f"coefficients of {name}_3 · v_{i}",
                    unit="m²",
                )
            )
        squares = [
            [sign * entry for entry in convolved(values, values, product)]
            for values, sign in limb_3(i)
        ]
        equations.append(
            Equation(
                matrix(f"C{i}", 5, 1),
                ImmutableDenseMatrix([sum(column) for column in zip(*squares, strict=True)]),
                f"coefficients of v_{i}ᵀ M_3 v_{i}",
                unit="m⁴",
            )
        )
    mixed = [
        [
            sum(sign * left[row] * right[column] for (left, sign), (right, _) in pairs)
            for column in range(TABLE)
        ]
        for row in range(TABLE)
        for pairs in [list(zip(limb_3(1), limb_3(2), strict=True))]
    ]
    equations += [
        Equation(
            matrix("N12", 3, 3),
            ImmutableDenseMatrix([[Dot(v, w) for w in second] for v in first]),
            "coefficients of v_1 · v_2",
            unit="m²",
        ),
        Equation(
            matrix("C12", 3, 3),
            ImmutableDenseMatrix(mixed),
            "coefficients of v_1ᵀ M_3 v_2",
            unit="m⁴",
        ),
    ]
    return equations


def limb_3(i: int) -> list[tuple[list[Expr], int]]:
    """The three linear forms of limb 3 along v_i, and their signs in its cone."""
    return [
        ([matrix(f"{name}v{i}", 3, 1)[k, 0] for k in range(TABLE)], sign)
        for name, sign in (("ht", 1), ("hz", 1), ("hp", -1))
    ]


def conditions() -> list[Equation]:
    """The two equations in (t, s): entry [k, l] belongs to t^k s^l."""
    dot, mixed = matrix("N12", 3, 3), matrix("C12", 3, 3)
    norms = [[matrix(f"N{i}", 5, 1)[k, 0] for k in range(5)] for i in (1, 2)]
    cones = [[matrix(f"C{i}", 5, 1)[k, 0] for k in range(5)] for i in (1, 2)]
    angle, cone = (
        [[sign * 4 * entry for entry in row] for row in square_table(dot, other)]
        for sign, other in ((1, dot), (-1, mixed))
    )
    for row in range(5):
        for column in range(5):
            angle[row][column] -= norms[0][row] * norms[1][column]
            cone[row][column] += (
                cones[0][row] * norms[1][column] + norms[0][row] * cones[1][column]
            )
    return [
        Equation(
            ANGLE,
            ImmutableDenseMatrix(angle),
            "coefficients of 4 (v_1·v_2)² − |v_1|² |v_2|²",
            "(5)",
            "m⁴",
        ),
        Equation(
            CONE,
            ImmutableDenseMatrix(cone),
            "coefficients of |v_2|² v_1ᵀM_3v_1 − 4 (v_1·v_2) v_1ᵀM_3v_2 + |v_1|² v_2ᵀM_3v_2",
            "(6)",
            "m⁶",
        ),
    ]


def product(left: Expr, right: Expr) -> Expr:
    return left * right


def convolved(left: list, right: list, times) -> list[Expr]:  # type: ignore[no-untyped-def]
    """The coefficients of a product of two polynomials."""
    result: list[Expr] = [S.Zero] * (len(left) + len(right) - 1)
    for row, one in enumerate(left):
        for column, other in enumerate(right):
            result[row + column] += times(one, other)
    return result


def square_table(left: Basic, right: Basic) -> list[list[Expr]]:
    """The coefficients of a product of two polynomials in two unknowns."""
    table: list[list[Expr]] = [[S.Zero] * 5 for _ in range(5)]
    for i in range(TABLE):
        for j in range(TABLE):
            for k in range(TABLE):
                for m in range(TABLE):
                    table[i + k][j + m] += left[i, j] * right[k, m]
    return table


def circles_graph() -> Graph:
    """From joint values to the two equations in (t, s)."""
    graph = Graph((a, c, *LENGTHS, STARTS))
    graph.add(constants())
    graph.add(circle(1))
    graph.add(circle(2))
    graph.add(forms(3))
    graph.add(products())
    graph.add(conditions())
    for i, rows in ((1, FIRST), (2, SECOND)):
        parts = [vector(f"v{i}{k}") for k in range(TABLE)]
        graph.add([Equation(rows, Rows(*parts), f"(1 + t²)(b_{i} − c) at 1, t, t²", unit="m")])
    return graph


def arms_graph() -> Graph:
    """b_1 − c and b_2 − c at half angles t, s, as rows."""
    t, s = scalar("t"), scalar("s")
    graph = Graph((a, c, *LENGTHS, STARTS, t, s))
    graph.add(constants())
    graph.add(circle(1))
    graph.add(circle(2))
    arms = []
    for i, half in ((1, t), (2, s)):
        parts = [vector(f"v{i}{k}") for k in range(TABLE)]
        arm = vector(f"arm{i}")
        graph.add(
            [
                Equation(
                    arm,
                    (1 / (1 + half**2)) * (parts[0] + half * parts[1] + half**2 * parts[2]),
                    f"from C to B_{i}",
                    unit="m",
                )
            ]
        )
        arms.append(arm)
    graph.add([Equation(matrix("arms", 2, 3), Rows(*arms), "from C to B_1 and B_2", unit="m")])
    return graph
