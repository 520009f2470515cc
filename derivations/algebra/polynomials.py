"""Polynomials by their coefficients, rising powers in a column or, of two unknowns, a table."""

from __future__ import annotations

from itertools import product

from sympy import Basic, Expr, ImmutableDenseMatrix, Matrix
from sympy.matrices.expressions import MatrixExpr

from derivations.algebra.vectors import components

__all__ = ["Convolution"]


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


def _places(table: Basic) -> list[tuple[int, int]]:
    rows, columns = table.shape
    return list(product(range(rows), range(columns)))
