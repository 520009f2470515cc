"""One displayed formula: a symbol, what it equals, and the lines that this needs.

Every formula is what stands between the dollars of a display: a single line, or amsmath's
``split``, which latex2mathml reads too.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from sympy import Basic, Expr, ImmutableDenseMatrix, Symbol

from derivations.algebra.vectors import Norm, components
from derivations.codegen.printers.breaking import lines
from derivations.codegen.printers.latex import VectorLatex, width

__all__ = ["Formula", "Length", "component_form", "keeping_norms", "vector_form"]

#: How wide a line may be, in letters as `width` counts them.
LINE = 66
#: A left side wider than this leaves no room for the right one.
WIDE_LEFT = 30
#: How wide a matrix may be before its entries are written one by one.
MATRIX = 94

COMPUTED = r"\text{computed as}\quad"
REST = r"\text{all other entries are zero}"

Row = tuple[str, str]


class Length(Norm):
    """A norm that components leave as it is."""

    def expanded(self) -> Expr:
        return self


class Formula(Protocol):
    """What is displayed: an `Equation`, or a relation with an expression on its left."""

    @property
    def symbol(self) -> Basic: ...
    @property
    def expression(self) -> Basic: ...
    @property
    def computed_as(self) -> Basic | None: ...


def vector_form(formula: Formula, printer: VectorLatex) -> str:
    """``symbol = expression``, and on a second line the form that kernels evaluate."""
    left = printer.doprint(formula.symbol)
    rows = _rows(left, formula.expression, printer)
    if formula.computed_as is not None:
        computed = _rows(COMPUTED, formula.computed_as, printer)
        if [text for _, text in computed] != [text for _, text in rows]:
            rows += computed
    return _display(rows)


def component_form(
    formula: Formula, printer: VectorLatex, known: Mapping[Symbol, Expr] | None = None
) -> str:
    """The formula in components of the symbols that it names.

    Components that are ``known`` are put in. A norm that divides a vector, and one of
    several norms, stays a norm.
    """
    values = dict(known or {})
    left = components(formula.symbol)
    if not formula.symbol.is_symbol:
        left = left.xreplace(values)
    right = components(keeping_norms(formula.expression)).xreplace(values)
    if not isinstance(right, ImmutableDenseMatrix):
        return _display(_rows(printer.doprint(left), right, printer))
    whole = right == formula.expression and right.shape[1] == 1
    if whole or (right.shape[1] > 1 and _matrix_width(right, printer) <= MATRIX):
        return _display([(printer.doprint(formula.symbol), f"= {printer.doprint(right)}")])
    return _display(_entries(ImmutableDenseMatrix(left), right, printer))


def keeping_norms(expression: Basic) -> Basic:
    norms = expression.atoms(Norm)
    if len(norms) == 1 and not expression.is_Matrix:
        return expression
    return expression.xreplace({norm: Length(*norm.args) for norm in norms})


def _entries(
    left: ImmutableDenseMatrix, right: ImmutableDenseMatrix, printer: VectorLatex
) -> list[Row]:
    """An equation for every entry; of a matrix only for those that are not zero."""
    column = right.shape[1] == 1
    rows: list[Row] = []
    for symbol, entry in zip(left, right, strict=True):
        if column or entry != 0:
            rows += _rows(printer.doprint(symbol), entry, printer)
    complete = column or all(entry != 0 for entry in right)
    return rows if complete else [*rows, ("", REST)]


def _matrix_width(matrix: ImmutableDenseMatrix, printer: VectorLatex) -> int:
    rows, columns = matrix.shape
    return sum(
        max(width(printer.doprint(matrix[row, column])) for row in range(rows)) + 2
        for column in range(columns)
    )


def _display(rows: list[Row]) -> str:
    if len(rows) == 1:
        return " ".join(rows[0])
    body = " \\\\\n".join(f"{left} &{right}" for left, right in rows)
    return f"\\begin{{split}}\n{body}\n\\end{{split}}"


def _rows(left: str, expression: Basic, printer: VectorLatex) -> list[Row]:
    """The lines of one equation; a wide left side has lines of its own."""
    text = printer.doprint(expression)
    if width(left) > WIDE_LEFT:
        first, *others = lines(left, LINE)
        rest = [*others, *lines(f"= {text}", LINE)]
    else:
        first, *rest = lines(text, LINE - width(left))
        return [(left, f"= {first}"), *(("", rf"\quad {line}") for line in rest)]
    return [("", first), *(("", rf"\quad {line}") for line in rest)]
