"""The forward displacement reduced to one unknown, the angle of leg 1 in its plane.

B_1 lies on a circle about A_1, so that its angle theta gives n_1. What is left is the turn
phi of the platform about n_1. In the half angle x = cos(phi/2), y = sin(phi/2) the closure
equations of limbs 2 and 3 are two quartics; their resultant, the eliminant, vanishes at the
angles theta of the assembly modes. It is the determinant of their Bezoutian, the adjugate
of which gives the half angle.
"""

from __future__ import annotations

from sympy import Expr, ImmutableDenseMatrix, MatrixSymbol, S, prod

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.polynomials import Convolution
from derivations.algebra.vectors import Cross, Dot, Norm, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import FORMS, LENGTHS, forms
from derivations.uncoupled.geometry import HALF, ROOT, a, base_k, c, constants, n1

#: Cosine and sine of the angle theta of leg 1, from t_1 towards k.
cosine, sine = scalar("cos_theta"), scalar("sin_theta")
#: Any vector that is not parallel to n_1: it fixes where the turn phi starts.
reference = vector("reference")
#: The half angle of the turn about n_1.
x, y = scalar("x"), scalar("y")
f, g, arm = vector("f"), vector("g"), vector("arm")
frame = Rows(n1, f, g)
#: n_i is −n_1/2 and √3/2 along cos phi f + sin phi g, on this side.
SIDES = {2: S.One, 3: S.NegativeOne}
K2, K3 = matrix("K2", 5, 1), matrix("K3", 5, 1)
W, Z = matrix("brackets", 5, 5), matrix("Z", 4, 4)
UPPER, LOWER = matrix("upper", 6, 1), matrix("lower", 6, 1)
eliminant, bound, powers = scalar("eliminant"), scalar("bound"), matrix("powers", 2, 4)
#: The pairs of columns of the minors of two rows, in their order.
PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))


def leg_arm() -> Equation:
    """The way from C to B_1."""
    u, t = vector("u1"), vector("t1")
    return Equation(
        arm,
        a * u - c + LENGTHS[0] * (cosine * t + sine * base_k),
        "from C to B_1, leg 1 at the angle theta",
        unit="m",
    )


def first_limb() -> list[Equation]:
    """n_1 from the angle of leg 1, and the plane normal to it."""
    across = Cross(reference, n1)
    return [
        leg_arm(),
        Equation(n1, arm / Norm(arm), "direction from C to B_1", "(3)"),
        Equation(f, across / Norm(across), "a unit vector normal to n_1"),
        Equation(g, Cross(n1, f), "completes the frame of n_1"),
    ]


def quartic(i: int | str, side: Expr) -> list[Equation]:
    """F_i in the half angle of the turn: n_i = −n_1/2 ± √3/2 (cos phi f + sin phi g)."""
    equations = []
    for name in FORMS:
        form = vector(f"{name}{i}")
        along, over = -HALF * Dot(form, n1), side * ROOT * Dot(form, f)
        parts = [along + over, 2 * side * ROOT * Dot(form, g), along - over]
        words = f"form of limb {i} in the half angle of the turn, at x², xy, y²"
        equations.append(
            Equation(matrix(f"{name}x{i}", 3, 1), ImmutableDenseMatrix(parts), words, unit="m")
        )
    horizontal, vertical, along = (Convolution(each.symbol, each.symbol) for each in equations)
    return [
        *equations,
        Equation(
            matrix(f"K{i}", 5, 1),
            horizontal + vertical - along,
            f"coefficients of (x² + y²)² F_{i} at x⁴, x³y, x²y², xy³, y⁴",
            "(6)",
            "m²",
        ),
    ]


def bezoutian() -> list[Equation]:
    """The Bezoutian of the two quartics and its determinant."""
    entries = [[bracket_sum(i, j) for j in range(4)] for i in range(4)]
    m, n = ([symbol[k, 0] for k in range(6)] for symbol in (UPPER, LOWER))
    determinant = m[0] * n[5] - m[1] * n[4] + m[2] * n[3] + m[3] * n[2] - m[4] * n[1] + m[5] * n[0]
    rows = [ImmutableDenseMatrix([Z[i, j] for j in range(4)]) for i in range(4)]
    return [
        Equation(W, K2 * K3.T - K3 * K2.T, "brackets of the two quartics", unit="m⁴"),
        Equation(Z, ImmutableDenseMatrix(entries), "Bezoutian of the two quartics", unit="m⁴"),
        Equation(UPPER, minors(0, 1), "minors of rows 1 and 2 of the Bezoutian", unit="m⁸"),
        Equation(LOWER, minors(2, 3), "minors of rows 3 and 4 of the Bezoutian", unit="m⁸"),
        Equation(
            eliminant, determinant, "resultant of the two quartics, the determinant", unit="m¹⁶"
        ),
        Equation(
            bound,
            prod(map(Norm, rows)),
            "Hadamard's bound on the eliminant: the product of the lengths of the rows",
            unit="m¹⁶",
        ),
    ]


def bracket_sum(i: int, j: int) -> Expr:
    """Entry [i, j] of the Bezoutian."""
    return sum(W[k, i + j + 1 - k] for k in range(max(0, i + j - 3), min(i, j) + 1))


def minors(row: int, other: int) -> ImmutableDenseMatrix:
    """The 2×2 minors of two rows of the Bezoutian."""
    return ImmutableDenseMatrix(
        [Z[row, i] * Z[other, j] - Z[row, j] * Z[other, i] for i, j in PAIRS]
    )


def null_vectors() -> list[Equation]:
    """Rows 1 and 4 of the adjugate of Z: where det Z = 0 both are along (x³, x²y, xy², y³)."""
    first, last = matrix("adj1", 4, 1), matrix("adj4", 4, 1)
    return [
        Equation(first, cofactors(1, LOWER, 1), "row 1 of the adjugate", unit="m¹²"),
        Equation(last, cofactors(2, UPPER, -1), "row 4 of the adjugate", unit="m¹²"),
        Equation(powers, Rows(first, last), "along x³, x²y, xy², y³ twice", unit="m¹²"),
    ]


def cofactors(row: int, minor: MatrixSymbol, sign: int) -> ImmutableDenseMatrix:
    """The cofactors of the row beside a row and two rows of which the minors are known."""
    entries = []
    for left_out in range(4):
        i, j, k = (column for column in range(4) if column != left_out)
        value = (
            Z[row, i] * minor[PAIRS.index((j, k)), 0]
            - Z[row, j] * minor[PAIRS.index((i, k)), 0]
            + Z[row, k] * minor[PAIRS.index((i, j)), 0]
        )
        entries.append(sign * (-1) ** left_out * value)
    return ImmutableDenseMatrix(entries)


def eliminant_graph() -> Graph:
    """From the angle of leg 1 to the eliminant."""
    graph = Graph((a, c, *LENGTHS, cosine, sine, reference))
    graph.add(constants())
    graph.add(first_limb())
    for i, side in SIDES.items():
        graph.add([*forms(i), *quartic(i, side)])
    graph.add([*bezoutian(), *null_vectors()])
    return graph


def turn_graph() -> Graph:
    """n_2 from the frame about n_1 and the half angle (x : y)."""
    graph = Graph((n1, f, g, x, y))
    square = x**2 + y**2
    turned = ((x**2 - y**2) / square) * f + (2 * x * y / square) * g
    graph.add(
        [
            Equation(
                vector("n2"),
                -HALF * n1 + ROOT * turned,
                "direction from C to B_2, the platform turned by phi about n_1",
                "(5)",
            ),
        ]
    )
    return graph
