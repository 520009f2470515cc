"""Determinants without a division, and the matrix of a resultant."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from sympy import Expr, Matrix, S

__all__ = ["determinant", "laplace", "sylvester"]


def determinant(entries: Matrix) -> Expr:
    """The determinant, without a division."""
    return entries.det(method="berkowitz")


def laplace(entries: Matrix) -> Expr:
    """The determinant by Laplace's expansion along the upper half of the rows."""
    size, total = entries.rows, S.Zero
    above, below = list(range(size // 2)), list(range(size // 2, size))
    for chosen in combinations(range(size), len(above)):
        rest = [column for column in range(size) if column not in chosen]
        lower = determinant(entries.extract(below, rest))
        if lower != 0:
            upper = determinant(entries.extract(above, list(chosen)))
            total += (-1) ** (sum(chosen) - sum(above)) * upper * lower
    return total


def sylvester(first: Sequence[Expr], second: Sequence[Expr]) -> Matrix:
    """The matrix whose determinant is the resultant of two polynomials, by rising powers."""
    size = len(first) + len(second) - 2
    rows = []
    for coefficients, other in ((first, second), (second, first)):
        for shift in range(len(other) - 1):
            after = size - shift - len(coefficients)
            rows.append([S.Zero] * shift + list(coefficients) + [S.Zero] * after)
    return Matrix(rows)
