"""Polynomials by their coefficients, rising powers in a column or, of two unknowns, a table.

Those of three unknowns x, y, z are a column in the order of `monomials`.
"""

from __future__ import annotations

from itertools import combinations_with_replacement, product
from math import comb

from sympy import Basic, Expr, ImmutableDenseMatrix, Integer, Matrix, S
from sympy.matrices.expressions import MatrixExpr

from derivations.algebra.vectors import components

__all__ = ["Convolution", "SpatialConvolution", "monomials"]


class Convolution(MatrixExpr):
    """The coefficients of the product of two polynomials, from the coefficients of both."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        left, right = (factor.shape for factor in self.args)
        return (left[0] + right[0] - 1, left[1] + right[1] - 1)

    def expanded(self) -> ImmutableDenseMatrix:
        left, right = map(components, self.args)
        table = Matrix.zeros(*self.shape)
        for (i, j), (k, m) in product(_places(left), _places(right)):
            table[i + k, j + m] += left[i, j] * right[k, m]
        return ImmutableDenseMatrix(table)


class SpatialConvolution(Convolution):
    """The same for polynomials in x, y, z, each a column in the order of `monomials`."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        degree = sum(_degree(int(factor.shape[0])) for factor in self.args)
        return (Integer(_count(degree)), S.One)

    def expanded(self) -> ImmutableDenseMatrix:
        left, right = map(components, self.args)
        places = {powers: place for place, powers in enumerate(monomials(_degree(int(self.rows))))}
        column = Matrix.zeros(*self.shape)
        for (i, first), (j, second) in product(enumerate(places), repeat=2):
            if i < left.rows and j < right.rows:
                total = tuple(map(sum, zip(first, second, strict=True)))
                column[places[total]] += left[i] * right[j]
        return ImmutableDenseMatrix(column)


def monomials(degree: int) -> list[tuple[int, ...]]:
    """The powers of x, y, z of each monomial up to a degree: 1, x, y, z, x², xy, xz, y², ..."""
    return [
        tuple(map(factors.count, range(3)))
        for total in range(degree + 1)
        for factors in combinations_with_replacement(range(3), total)
    ]


def _places(table: Basic) -> list[tuple[int, int]]:
    rows, columns = table.shape
    return list(product(range(rows), range(columns)))


def _count(degree: int) -> int:
    """How many monomials in x, y, z there are up to a degree."""
    return comb(degree + 3, 3)


def _degree(count: int) -> int:
    """The degree of a polynomial in x, y, z with so many coefficients."""
    return next(degree for degree in range(count) if _count(degree) == count)
