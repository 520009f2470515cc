"""Products and resultants by coefficients, against SymPy's own."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, Poly, expand, resultant, symbols

from derivations.algebra.determinants import determinant, laplace, sylvester
from derivations.algebra.polynomials import Convolution, SpatialConvolution, monomials
from derivations.algebra.vectors import component_symbols, components, matrix

X, Y, Z = symbols("x y z")
LEFT, RIGHT = matrix("left", 3, 2), matrix("right", 2, 3)


def value(table: ImmutableDenseMatrix):
    rows, columns = table.shape
    return sum(table[i, j] * X**i * Y**j for i in range(rows) for j in range(columns))


def test_convolution_is_the_product() -> None:
    product = Convolution(LEFT, RIGHT)
    assert product.shape == components(product).shape == (4, 4)
    factors = value(component_symbols(LEFT)) * value(component_symbols(RIGHT))
    assert expand(value(components(product)) - factors) == 0


def test_spatial_convolution_is_the_product() -> None:
    assert monomials(2)[:6] == [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 0, 0), (1, 1, 0)]
    powers = [X**i * Y**j * Z**k for i, j, k in monomials(3)]
    left, right = matrix("left", 4, 1), matrix("right", 10, 1)
    product = SpatialConvolution(left, right)
    assert product.shape == components(product).shape == (20, 1)
    values = [
        sum(entry * power for entry, power in zip(column, powers, strict=False))
        for column in (component_symbols(left), component_symbols(right), components(product))
    ]
    assert expand(values[0] * values[1] - values[2]) == 0


def test_sylvester_s_determinant_is_the_resultant() -> None:
    first, second = symbols("a0:4"), symbols("b0:3")
    rows = sylvester(first, second)
    assert rows.shape == (5, 5)
    left, right = (Poly(list(reversed(each)), X) for each in (first, second))
    assert expand(laplace(rows) - resultant(left, right)) == 0
    assert expand(laplace(rows) - determinant(rows)) == 0
