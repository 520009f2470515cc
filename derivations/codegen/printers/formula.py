"""One displayed formula: a symbol, what it equals, and the lines that this needs.

Every formula is what stands between the dollars of a display: a single line, or amsmath's
``split``, which latex2mathml reads too.
"""

from __future__ import annotations

from typing import Protocol

from sympy import Basic, ImmutableDenseMatrix, MatAdd, MatMul, Mul, S, Add

from derivations.algebra.vectors import components
from derivations.codegen.printers.latex import VectorLatex, width

__all__ = ["Formula", "component_form", "vector_form"]

#: How wide a line may be, in letters as `width` counts them.
LINE = 84
#: How wide a matrix may be before its entries are written one by one.
MATRIX = 100

COMPUTED = r"\text{computed as}\quad"
REST = r"\text{all other entries are zero}"

Row = tuple[str, str]


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


def component_form(formula: Formula, printer: VectorLatex) -> str:
    """The same with every vector in components of the symbols that the formula names."""
    left, right = components(formula.symbol), components(formula.expression)
    if not isinstance(right, ImmutableDenseMatrix):
        return _display(_rows(printer.doprint(left), right, printer))
    whole = right == formula.expression and right.shape[1] == 1
    if whole or (right.shape[1] > 1 and _matrix_width(right, printer) <= MATRIX):
        return _display([(printer.doprint(formula.symbol), printer.doprint(right))])
    return _display(_entries(ImmutableDenseMatrix(left), right, printer))


def _entries(
    left: ImmutableDenseMatrix, right: ImmutableDenseMatrix, printer: VectorLatex
) -> list[Row]:
    """An equation for every entry; of a matrix only for those that are not zero."""
    column = right.shape[1] == 1
    rows: list[Row] = []
    for symbol, entry in zip(left, right, strict=True):
        if column or entry != 0:
            rows += _rows(printer.doprint(symbol), entry, printer)
    return rows if column else [*rows, ("", REST)]


def _matrix_width(matrix: ImmutableDenseMatrix, printer: VectorLatex) -> int:
    rows, columns = matrix.shape
    return sum(
        max(width(printer.doprint(matrix[row, column])) for row in range(rows)) + 2
        for column in range(columns)
    )


def _display(rows: list[Row]) -> str:
    if len(rows) == 1:
        return f"{rows[0][0]} = {rows[0][1]}"
    body = " \\\\\n".join(f"{left} &{_relation(left, text)}" for left, text in rows)
    return f"\\begin{{split}}\n{body}\n\\end{{split}}"


def _relation(left: str, text: str) -> str:
    if left:
        return f"= {text}"
    return text if text == REST else rf"\quad {text}"


def _rows(left: str, expression: Basic, printer: VectorLatex) -> list[Row]:
    """The lines of one equation; only the first has a left side."""
    first, *others = _lines(expression, printer)
    return [(left, first), *(("", line) for line in others)]


def _lines(expression: Basic, printer: VectorLatex) -> list[str]:
    text = printer.doprint(expression)
    if width(text) <= LINE:
        return [text]
    if isinstance(expression, (Add, MatAdd)):
        return _filled(printer.terms(expression), "", "")
    if isinstance(expression, (Mul, MatMul)):
        factors = [part for part in expression.args if printer.is_wide(part)]
        if len(factors) == 1:
            rest = [part for part in expression.args if part != factors[0]]
            head = printer.coefficient(Mul(S.One, *rest))
            return _filled(printer.terms(factors[0]), rf"{head}\Bigl[", r"\Bigr]")
    return [text]


def _filled(terms: list[str], head: str, end: str) -> list[str]:
    """Terms in lines as full as they may be."""
    lines = [head + terms[0]]
    for term in terms[1:]:
        if width(lines[-1]) + width(term) > LINE:
            lines.append(term)
        else:
            lines[-1] += f" {term}"
    lines[-1] += end
    return lines
