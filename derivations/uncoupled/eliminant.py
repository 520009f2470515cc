"""The forward displacement reduced to one unknown, the angle of leg 1 in its plane.

B_1 lies on a circle about A_1, so that its angle theta gives n_1. What is left is the turn
phi of the platform about n_1. In the half angle x = cos(phi/2), y = sin(phi/2) the closure
equations of limbs 2 and 3 are two quartics; their resultant, the eliminant, vanishes at the
angles theta of the assembly modes. It is the determinant of their Bezoutian, the adjugate
of which gives the half angle.
"""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, sqrt

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Cross, Dot, Norm, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import LENGTHS
from derivations.uncoupled.geometry import HALF, ROOT, a, base_k, c, constants, n1

#: Cosine and sine of the angle theta of leg 1, from t_1 towards k.
cosine, sine = scalar("cos_theta"), scalar("sin_theta")
#: Any vector that is not parallel to n_1: it fixes where the turn phi starts.
reference = vector("reference")
#: The half angle of the turn about n_1.
x, y = scalar("x"), scalar("y")
f, g, arm = vector("f"), vector("g"), vector("arm")
frame = Rows(n1, f, g)
K2, K3, Z = matrix("K2", 5, 1), matrix("K3", 5, 1), matrix("Z", 4, 4)
UPPER, LOWER = matrix("upper", 6, 1), matrix("lower", 6, 1)
eliminant = scalar("eliminant")
PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))


def first_limb() -> list[Equation]:
    """n_1 from the angle of leg 1, and the plane normal to it."""
    u, t = vector("u1"), vector("t1")
    return [
        Equation(
            arm,
            a * u - c + LENGTHS[0] * (cosine * t + sine * base_k),
            "from C to B_1, leg 1 at the angle theta",
            unit="m",
        ),
        Equation(n1, arm / Norm(arm), "direction from C to B_1", "(3)"),
        Equation(
            f, Cross(reference, n1) / Norm(Cross(reference, n1)), "a unit vector normal to n_1"
        ),
        Equation(g, Cross(n1, f), "completes the frame [n_1, f, g]"),
    ]


def forms(i: int | str) -> list[Equation]:
    """Vectors of limb i: gt_i, gz_i and p_i are their scalar products with n_i."""
    u, t = vector(f"u{i}"), vector(f"t{i}")
    return [
        Equation(scalar(f"h{i}"), a - Dot(c, u), "distance of C from the plane of the limb", "(4)"),
        Equation(
            vector(f"ht{i}"),
            Dot(c, t) * u + scalar(f"h{i}") * t,
            "gt_i = ht_i · n_i",
            unit="m",
        ),
        Equation(
            vector(f"hz{i}"),
            Dot(c, base_k) * u + scalar(f"h{i}") * base_k,
            "gz_i = hz_i · n_i",
            unit="m",
        ),
        Equation(vector(f"hp{i}"), scalar(f"q{i}") * u, "p_i q_i = hp_i · n_i", unit="m"),
    ]


def quartic(i: int, side: int) -> list[Equation]:
    """F_i in the half angle of the turn: n_i = −n_1/2 ± √3/2 (cos phi f + sin phi g)."""
    equations = []
    coefficients = [0] * 5
    for name, sign in (("ht", 1), ("hz", 1), ("hp", -1)):
        form, values = vector(f"{name}{i}"), matrix(f"{name}x{i}", 3, 1)
        along, over = -HALF * Dot(form, n1), side * ROOT * Dot(form, f)
        parts = [along + over, 2 * side * ROOT * Dot(form, g), along - over]
        words = f"coefficients of {name}_{i} · n_{i} at x², xy, y²"
        equations.append(Equation(values, ImmutableDenseMatrix(parts), words, unit="m"))
        for row in range(3):
            for column in range(3):
                coefficients[row + column] += sign * values[row, 0] * values[column, 0]
    equations.append(
        Equation(
            matrix(f"K{i}", 5, 1),
            ImmutableDenseMatrix(coefficients),
            f"coefficients of F_{i} at x⁴, x³y, x²y², xy³, y⁴",
            "(6)",
            "m²",
        )
    )
    return equations


def minor(i: int, j: int) -> Basic:
    """The bracket [i j] of the two quartics."""
    return K2[i, 0] * K3[j, 0] - K2[j, 0] * K3[i, 0]


def bezoutian() -> list[Equation]:
    """The Bezoutian of the two quartics and its determinant."""
    entries = [
        [sum(minor(k, i + j + 1 - k) for k in range(max(0, i + j - 3), min(i, j) + 1)) for j in range(4)]
        for i in range(4)
    ]
    upper = [Z[0, i] * Z[1, j] - Z[0, j] * Z[1, i] for i, j in PAIRS]
    lower = [Z[2, i] * Z[3, j] - Z[2, j] * Z[3, i] for i, j in PAIRS]
    m, n = ([symbol[k, 0] for k in range(6)] for symbol in (UPPER, LOWER))
    determinant = m[0] * n[5] - m[1] * n[4] + m[2] * n[3] + m[3] * n[2] - m[4] * n[1] + m[5] * n[0]
    return [
        Equation(Z, ImmutableDenseMatrix(entries), "Bezoutian of the two quartics", unit="m⁴"),
        Equation(UPPER, ImmutableDenseMatrix(upper), "minors of rows 1 and 2 of Z", unit="m⁸"),
        Equation(LOWER, ImmutableDenseMatrix(lower), "minors of rows 3 and 4 of Z", unit="m⁸"),
        Equation(eliminant, determinant, "resultant of the two quartics, det Z", unit="m¹⁶"),
        Equation(
            scalar("bound"),
            sqrt(product_of([sum(Z[i, j] ** 2 for j in range(4)) for i in range(4)])),
            "Hadamard's bound on the eliminant: the product of the lengths of the rows of Z",
            unit="m¹⁶",
        ),
    ]


def product_of(factors: list[Expr]) -> Expr:
    result = factors[0]
    for factor in factors[1:]:
        result = result * factor
    return result


def null_vectors() -> list[Equation]:
    """Rows 1 and 4 of the adjugate of Z: where det Z = 0 both are along (x³, x²y, xy², y³)."""
    symmetric = ImmutableDenseMatrix(4, 4, lambda i, j: Z[min(i, j), max(i, j)])
    rows = [[symmetric.cofactor(i, j) for j in range(4)] for i in (0, 3)]
    return [
        Equation(
            matrix("powers", 2, 4),
            ImmutableDenseMatrix(rows),
            "rows 1 and 4 of the adjugate of Z",
            unit="m¹²",
        )
    ]


def eliminant_graph() -> Graph:
    """From the angle of leg 1 to the eliminant."""
    graph = Graph((a, c, *LENGTHS, cosine, sine, reference))
    graph.add(constants())
    graph.add(first_limb())
    for i, side in ((2, 1), (3, -1)):
        graph.add(forms(i))
        graph.add(quartic(i, side))
    graph.add(bezoutian())
    graph.add(null_vectors())
    return graph


def turn_graph() -> Graph:
    """n_2 from the frame about n_1 and the half angle (x : y)."""
    graph = Graph((n1, f, g, x, y))
    square = scalar("xy")
    turned = ((x**2 - y**2) / square) * f + (2 * x * y / square) * g
    graph.add(
        [
            Equation(square, x**2 + y**2, "square of the half angle's length"),
            Equation(
                vector("n2"),
                -HALF * n1 + ROOT * turned,
                "direction from C to B_2, the platform turned by phi about n_1",
                "(5)",
            ),
        ]
    )
    return graph
