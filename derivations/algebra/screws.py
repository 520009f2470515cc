"""Screws at a pole, the Klein form and reciprocity: no mechanism here.

A screw is ``[primal; dual] = [s; s_O]``, its dual part taken at a pole C. A line in
Plücker coordinates is a screw of pitch zero. The twist of a body is ``[omega; v_C]``,
angular part first. The Klein form of twist and wrench is their power.
"""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, S, ZeroMatrix
from sympy.matrices.expressions import MatrixExpr

from derivations.algebra.vectors import Cross, Stack, components

__all__ = [
    "POLARITY",
    "Klein",
    "Lie",
    "Screw",
    "cylindrical",
    "line",
    "prismatic",
    "revolute",
]

#: The operator of polarity Δ (20): it swaps the primal and the dual part.
POLARITY = ImmutableDenseMatrix(6, 6, lambda row, column: int(abs(row - column) == 3))


class Screw(Stack):
    """The screw ``[primal; dual]``."""


class Klein(Expr):
    """The Klein form ``{$1; $2} = s1·s_O2 + s2·s_O1 = $1ᵀ Δ $2`` (13), with the polarity Δ (20)."""

    is_commutative = True
    is_real = True

    def expanded(self) -> Expr:
        first, second = map(components, self.args)
        return (first.T * POLARITY * second)[0, 0]


class Lie(MatrixExpr):
    """The Lie product ``[$1 $2] = [s1 × s2; s1 × s_O2 − s2 × s_O1]`` of two screws."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        return (S(6), S.One)

    def expanded(self) -> ImmutableDenseMatrix:
        (first, first_dual), (second, second_dual) = map(_halves, self.args)
        primal = components(Cross(first, second))
        dual = components(Cross(first, second_dual)) - components(Cross(second, first_dual))
        return ImmutableDenseMatrix.vstack(primal, dual)


def _halves(screw: Basic) -> tuple[ImmutableDenseMatrix, ImmutableDenseMatrix]:
    """The primal and the dual part."""
    whole = components(screw)
    return whole[0:3, 0], whole[3:6, 0]


def revolute(axis: Basic, arm: Basic) -> Screw:
    """A revolute joint: ``arm`` leads from a point of the axis to the pole."""
    return Screw(axis, Cross(axis, arm))


def prismatic(direction: Basic) -> Screw:
    """A prismatic joint: a translation, the same at every pole."""
    return Screw(ZeroMatrix(3, 1), direction)


def cylindrical(axis: Basic, arm: Basic) -> tuple[Screw, Screw]:
    """A cylindrical joint: rotation about an axis and translation along it."""
    return revolute(axis, arm), prismatic(axis)


def line(direction: Basic, arm: Basic) -> Screw:
    """A line in Plücker coordinates (14): ``arm`` leads from a point of it to the pole."""
    return Screw(direction, Cross(direction, arm))
