"""The forward displacement reduced to two unknowns, the half angles of legs 1 and 2.

B_1 and B_2 lie on circles, at t = tan of half the angle of leg 1 and s of leg 2. Two
conditions are left, of degree four in t and in s: the angle of 120° between n_1 and n_2, and
the cone of limb 3. Two such equations have 4·4 + 4·4 = 32 common zeros.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, MatrixSymbol, Symbol

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.polynomials import Convolution
from derivations.algebra.vectors import Dot, Rows, matrix, scalar, vector
from derivations.uncoupled.closure import FORMS, LENGTHS, forms
from derivations.uncoupled.geometry import a, base_k, c, constants

#: Cosine and sine of the angles at which t = 0 and s = 0.
STARTS = ImmutableDenseMatrix(
    2, 2, lambda row, column: scalar(f"{('cos', 'sin')[column]}_start{row + 1}")
)
#: The tangents of half the angles from there.
HALVES = (scalar("t"), scalar("s"))
ANGLE, CONE = matrix("angle", 5, 5), matrix("cone", 5, 5)
#: (1 + t²)(b_1 − c) and (1 + s²)(b_2 − c) at 1, t, t² and 1, s, s², a row each.
FIRST, SECOND = matrix("V1", 3, 3), matrix("V2", 3, 3)
ARMS = matrix("arms", 2, 3)


def parts(i: int | str) -> list[MatrixSymbol]:
    """The arm to B_i, from C, as a polynomial in the half angle's tangent: rising powers."""
    return [vector(f"{name}{i}") for name in ("va", "vb", "vc")]


def circle(i: int | str, half: Symbol) -> list[Equation]:
    """b_i − c, times 1 + half², as a vector at each power of the half angle's tangent."""
    u, t = vector(f"u{i}"), vector(f"t{i}")
    near, up = vector(f"near{i}"), vector(f"up{i}")
    cosine, sine = scalar(f"cos_start{i}"), scalar(f"sin_start{i}")
    center, q = vector(f"center{i}"), scalar(f"q{i}")
    constant, linear, square = parts(i)
    at_power = f"from C to B_{i} times 1 + {half}², its part at"
    return [
        Equation(center, a * u - c, f"from C to A_{i}", unit="m"),
        Equation(near, cosine * t + sine * base_k, f"direction of leg {i} at half angle 0"),
        Equation(up, cosine * base_k - sine * t, f"direction of leg {i} a quarter turn on"),
        Equation(constant, center + q * near, f"{at_power} 1", unit="m"),
        Equation(linear, 2 * q * up, f"{at_power} {half}", unit="m"),
        Equation(square, center - q * near, f"{at_power} {half}²", unit="m"),
    ]


def along_arm(i: int | str) -> list[MatrixSymbol]:
    """The forms of limb 3 along the arm to B_i."""
    return [matrix(f"{name}v{i}", 3, 1) for name in FORMS]


def own_products(i: int | str) -> list[Equation]:
    """The polynomials in one unknown: the square of the arm to B_i, and limb 3's cone there."""
    constant, linear, square = parts(i)
    rows = matrix(f"V{i}", 3, 3)
    norm = [
        Dot(constant, constant),
        2 * Dot(constant, linear),
        Dot(linear, linear) + 2 * Dot(constant, square),
        2 * Dot(linear, square),
        Dot(square, square),
    ]
    horizontal, vertical, along = (Convolution(values, values) for values in along_arm(i))
    words = f"form of limb 3 along the arm to B_{i}, its coefficients"
    return [
        Equation(rows, Rows(*parts(i)), f"the arm to B_{i}, a row for each power", unit="m"),
        Equation(
            matrix(f"N{i}", 5, 1),
            ImmutableDenseMatrix(norm),
            f"square of the arm to B_{i}, its coefficients",
            unit="m²",
        ),
        *(
            Equation(values, rows * vector(f"{name}3"), words, unit="m²")
            for name, values in zip(FORMS, along_arm(i), strict=True)
        ),
        Equation(
            matrix(f"C{i}", 5, 1),
            horizontal + vertical - along,
            f"cone of limb 3 at the arm to B_{i}, its coefficients",
            unit="m⁴",
        ),
    ]


def mixed_products() -> list[Equation]:
    """The polynomials in both unknowns: the product of the arms, and limb 3's cone between."""
    horizontal, vertical, along = (
        left * right.T for left, right in zip(along_arm(1), along_arm(2), strict=True)
    )
    return [
        Equation(
            matrix("N12", 3, 3),
            FIRST * SECOND.T,
            "product of the arms to B_1 and B_2, its coefficients",
            unit="m²",
        ),
        Equation(
            matrix("C12", 3, 3),
            horizontal + vertical - along,
            "cone of limb 3 between the arms to B_1 and B_2, its coefficients",
            unit="m⁴",
        ),
    ]


def conditions() -> list[Equation]:
    """The two equations in (t, s): entry [k, l] belongs to t^k s^l."""
    dot, mixed = matrix("N12", 3, 3), matrix("C12", 3, 3)
    norm1, norm2, cone1, cone2 = (matrix(f"{name}{i}", 5, 1) for name in ("N", "C") for i in (1, 2))
    return [
        Equation(
            ANGLE,
            4 * Convolution(dot, dot) - norm1 * norm2.T,
            "condition that n_1 and n_2 are 120° apart, its coefficients",
            "(5)",
            "m⁴",
        ),
        Equation(
            CONE,
            cone1 * norm2.T - 4 * Convolution(dot, mixed) + norm1 * cone2.T,
            "condition that limb 3 closes, its coefficients",
            "(6)",
            "m⁶",
        ),
    ]


def both_circles() -> list[Equation]:
    """The circles of B_1 and B_2."""
    return [equation for i, half in enumerate(HALVES, 1) for equation in circle(i, half)]


def arm(i: int | str, half: Symbol) -> Equation:
    """b_i − c."""
    constant, linear, square = parts(i)
    whole = constant + half * linear + half**2 * square
    return Equation(vector(f"arm{i}"), (1 / (1 + half**2)) * whole, f"from C to B_{i}", unit="m")


def circles_graph() -> Graph:
    """From joint values to the two equations in (t, s)."""
    graph = Graph((a, c, *LENGTHS, *STARTS))
    graph.add([*constants(), *both_circles(), *forms(3)])
    graph.add([*own_products(1), *own_products(2)])
    graph.add([*mixed_products(), *conditions()])
    return graph


def arms_graph() -> Graph:
    """b_1 − c and b_2 − c at half angles t, s, as rows."""
    graph = Graph((a, c, *LENGTHS, *STARTS, *HALVES))
    graph.add([*constants(), *both_circles()])
    graph.add([arm(i, half) for i, half in enumerate(HALVES, 1)])
    arms = Rows(vector("arm1"), vector("arm2"))
    graph.add([Equation(ARMS, arms, "from C to B_1 and B_2", unit="m")])
    return graph
