"""What the NumPy and the mpmath printer share: Python expressions and signatures."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

from sympy import Basic, Expr, ImmutableDenseMatrix, Mul, S
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from derivations.codegen.kernel import Field, Input
from derivations.codegen.lower import Program

__all__ = [
    "Float64Expressions",
    "PythonExpressions",
    "comment_lines",
    "docstring",
    "entries",
    "result_class",
]


class PythonExpressions(StrPrinter):
    """Print one scalar expression; ``names`` maps SymPy functions to the target's."""

    def __init__(self, names: dict[object, str]) -> None:
        super().__init__()
        self.names = names

    def _print_Integer(self, expr: Expr) -> str:
        return f"{int(expr)}.0"

    def _print_Function(self, expr: Expr) -> str:
        arguments = ", ".join(self._print(argument) for argument in expr.args)
        return f"{self.names[expr.func]}({arguments})"

    _print_Abs = _print_Function

    def _print_Mul(self, expr: Expr) -> str:
        coefficient, rest = expr.as_coeff_Mul()
        sign = "-" if coefficient < 0 else ""
        over, under = [], []
        for factor in Mul.make_args(rest):
            power = factor.as_base_exp()[1]
            if power.is_Rational and power < 0:
                under.append(self.parenthesize(1 / factor, PRECEDENCE["Pow"]))
            else:
                over.append(self.parenthesize(factor, PRECEDENCE["Mul"]))
        if abs(coefficient) != 1:
            over.insert(0, self._print(abs(coefficient)))
        text = sign + ("*".join(over) or "1.0")
        if under:
            text += "/" + (under[0] if len(under) == 1 else f"({'*'.join(under)})")
        return text

    def _print_Pow(self, expr: Expr, **_: object) -> str:
        base, exponent = expr.args
        if exponent == S.Half:
            return f"{self.names['sqrt']}({self._print(base)})"
        if exponent.is_Integer and exponent > 1:
            factor = self.parenthesize(base, PRECEDENCE["Mul"])
            product = "*".join([factor] * int(exponent))
            return f"({product})"
        if exponent.is_Rational and exponent < 0:
            return f"1.0/{self.parenthesize(1 / expr, PRECEDENCE['Pow'])}"
        raise ValueError(f"no rule for the power {expr}")


class Float64Expressions(PythonExpressions):
    """Fractions as float64 numbers."""

    def _print_Rational(self, expr: Expr) -> str:
        return repr(int(expr.p) / int(expr.q))


def comment_lines(program: Program) -> Iterator[tuple[str, str, Expr]]:
    """Each line's comment ("" to go on under the last one), name and expression."""
    last = None
    for line in program.lines:
        comment = ""
        if line.equation is not None and line.equation is not last:
            number = f" {line.equation.number}" if line.equation.number else ""
            comment = f"{line.equation.words}{number} [{line.equation.unit}]"
            last = line.equation
        yield comment, line.symbol.name, line.expression


def entries(value: Basic) -> Iterator[tuple[tuple[int, ...], Expr]]:
    """The index and the expression of every entry of an output."""
    if not isinstance(value, ImmutableDenseMatrix):
        yield (), value
        return
    rows, columns = value.shape
    for row in range(rows):
        for column in range(columns):
            yield ((row,) if columns == 1 else (row, column)), value[row, column]


def docstring(program: Program, shape_of: str) -> str:
    """A NumPy-style docstring: shapes, units and where the equations stand in the paper."""
    kernel = program.kernel

    def section(title: str, fields: Iterable[Field]) -> list[str]:
        lines = [title, "-" * len(title)]
        for field in fields:
            lines += [f"{field.name} : {shape_of} {shape_text(field.shape)}"]
            lines += [f"    {field.words} [{field.unit}]"]
        return lines

    lines = [kernel.words, "", f"Equations {kernel.numbers} of the paper; base frame."]
    lines += [f"{program.operations} operations.", ""]
    lines += [*section("Parameters", kernel.inputs), "", *section("Returns", kernel.outputs)]
    text = '"""' + "\n".join(lines) + '\n"""'
    return textwrap.indent(text, "    ")


def shape_text(shape: tuple[int, ...]) -> str:
    """The shape of an argument with its leading axes: ``(..., 3)``."""
    return "(" + ", ".join(["...", *map(str, shape)]) + ")"


def result_class(program: Program, kind: str) -> str:
    """The named tuple that a kernel returns."""
    kernel = program.kernel
    lines = [f"class {class_name(kernel.name)}(NamedTuple):"]
    lines += [f'    """What `{kernel.name}` returns."""', ""]
    lines += [f"    {output.name}: {kind}" for output in kernel.outputs]
    return "\n".join(lines)


def class_name(name: str) -> str:
    """``inverse_displacement`` returns an ``InverseDisplacement``."""
    return "".join(word.capitalize() for word in name.split("_"))


def unpack(entry: Input) -> str:
    """The assignment that names an argument's entries, or "" for a scalar of that name."""
    value = entry.entries
    if not isinstance(value, ImmutableDenseMatrix):
        return "" if value.name == entry.name else f"{value.name} = {entry.name}"
    rows, columns = value.shape
    if columns == 1:
        return ", ".join(symbol.name for symbol in value) + f" = {entry.name}"
    groups = [
        "(" + ", ".join(value[row, column].name for column in range(columns)) + ")"
        for row in range(rows)
    ]
    return ", ".join(groups) + f" = {entry.name}"
