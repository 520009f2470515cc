"""Vector expressions that stay vectors.

Scalars are SymPy expressions and vectors are SymPy matrix expressions of shape
(3, 1), so that ``c + e * n`` and ``(a - Dot(c, u)) / Dot(n, u)`` need nothing of
ours. What SymPy lacks for vectors without coordinates stands here: `Dot`, `Cross`,
`Norm`, and the two ways to put vectors side by side, `Rows` and `Columns`.

Nothing is expanded until `components` asks for it.
"""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Basic, Expr, ImmutableDenseMatrix, MatrixSymbol, S, Symbol, sqrt
from sympy.matrices.expressions import MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

__all__ = [
    "Columns",
    "Cross",
    "Dot",
    "Norm",
    "Rows",
    "Stack",
    "component_symbols",
    "components",
    "matrix",
    "scalar",
    "vector",
]

AXES = ("x", "y", "z")
SCREW_AXES = (*AXES, "ox", "oy", "oz")


def scalar(name: str) -> Symbol:
    """A real scalar."""
    return Symbol(name, real=True)


def vector(name: str) -> MatrixSymbol:
    """A vector of the base frame."""
    return MatrixSymbol(name, 3, 1)


def matrix(name: str, rows: int, columns: int) -> MatrixSymbol:
    """A matrix of ``rows`` times ``columns``; a screw is one of 6 times 1."""
    return MatrixSymbol(name, rows, columns)


class Dot(Expr):
    """The scalar product of two vectors."""

    is_commutative = True
    is_real = True

    def expanded(self) -> Expr:
        x, y = map(components, self.args)
        return (x.T * y)[0, 0]


class Norm(Expr):
    """The Euclidean norm of a vector."""

    is_commutative = True
    is_real = True
    is_nonnegative = True

    def expanded(self) -> Expr:
        x = components(self.args[0])
        return sqrt((x.T * x)[0, 0])


class Cross(MatrixExpr):
    """The vector product of two vectors."""

    shape = (S(3), S.One)

    def expanded(self) -> ImmutableDenseMatrix:
        (a, b, c), (x, y, z) = map(components, self.args)
        return ImmutableDenseMatrix([b * z - c * y, c * x - a * z, a * y - b * x])


class Columns(MatrixExpr):
    """The matrix whose columns are the given vectors or screws."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        return (self.args[0].shape[0], S(len(self.args)))

    def expanded(self) -> ImmutableDenseMatrix:
        return ImmutableDenseMatrix.hstack(*map(components, self.args))


class Rows(MatrixExpr):
    """The matrix whose rows are the given vectors or screws."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        return (S(len(self.args)), self.args[0].shape[0])

    def expanded(self) -> ImmutableDenseMatrix:
        return ImmutableDenseMatrix.vstack(*(components(row).T for row in self.args))


class Stack(MatrixExpr):
    """Vectors one above the other in a single column."""

    @property
    def shape(self) -> tuple[Expr, Expr]:
        return (S(sum(int(part.shape[0]) for part in self.args)), S.One)

    def expanded(self) -> ImmutableDenseMatrix:
        return ImmutableDenseMatrix.vstack(*map(components, self.args))


def component_symbols(symbol: Symbol | MatrixSymbol) -> Symbol | ImmutableDenseMatrix:
    """The scalars that stand for the components of a symbol: ``b1`` has ``b1_x``."""
    if isinstance(symbol, Symbol):
        return symbol
    rows, columns = map(int, symbol.shape)
    return ImmutableDenseMatrix(
        rows, columns, [scalar(f"{symbol.name}_{suffix}") for suffix in _suffixes(rows, columns)]
    )


def _suffixes(rows: int, columns: int) -> Iterable[str]:
    if columns == 1:
        named = {3: AXES, 6: SCREW_AXES}.get(rows)
        return named or [str(row + 1) for row in range(rows)]
    return [f"{row + 1}{column + 1}" for row in range(rows) for column in range(columns)]


def components(expression: Basic) -> Basic:
    """Expand one expression into components of the symbols it names, and no further."""
    if isinstance(expression, MatrixSymbol):
        return component_symbols(expression)
    if isinstance(expression, MatrixElement):
        parent, row, column = expression.args
        return components(parent)[row, column]
    if isinstance(expression, ImmutableDenseMatrix):
        return expression.applyfunc(components)
    if hasattr(expression, "expanded"):
        return expression.expanded()
    if isinstance(expression, MatrixExpr):
        return expression.func(*map(components, expression.args)).doit().as_explicit()
    if not expression.args:
        return expression
    return expression.func(*map(components, expression.args))
