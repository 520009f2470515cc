"""Kernels on nested lists, one pose at a time: what mpmath and ball arithmetic share."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Abs, Expr, ImmutableDenseMatrix, atan2, cos, sin

from derivations.codegen.lower import Program
from derivations.codegen.printers.python import (
    PythonExpressions,
    class_name,
    comment_lines,
    docstring,
    result_class,
    unpack,
)

__all__ = ["Dialect", "print_module"]

NAMES = {Abs: "absolute", atan2: "atan2", cos: "cos", sin: "sin", "sqrt": "sqrt"}

SHARED = '''
Nested = Any


def _exact(value: Nested) -> Nested:
    """Turn every entry of a nested sequence into an {number}, without loss."""
    try:
        entries = iter(value)
    except TypeError:
        return {number}(value)
    return [_exact(entry) for entry in entries]
'''


@dataclass(frozen=True)
class Dialect:
    """A library of numbers: the module's head, and the name of its numbers."""

    head: str
    number: str


class NestedExpressions(PythonExpressions):
    def __init__(self, number: str) -> None:
        super().__init__(NAMES)
        self.number = number

    def _print_Rational(self, expr: Expr) -> str:
        return f"{self.number}({expr.p})/{expr.q}"


def print_module(programs: list[Program], dialect: Dialect) -> str:
    """The module's text."""
    parts = [dialect.head.rstrip() + "\n" + SHARED.format(number=dialect.number).rstrip()]
    for program in programs:
        parts += [result_class(program, "Nested"), _function(program, dialect.number)]
    return "\n\n\n".join(parts) + "\n"


def _function(program: Program, number: str) -> str:
    kernel, printer = program.kernel, NestedExpressions(number)
    arguments = ", ".join(f"{entry.name}: Nested" for entry in kernel.inputs)
    result = class_name(kernel.name)
    lines = [f"def {kernel.name}({arguments}) -> {result}:", docstring(program, "nested list")]
    lines += [f"    SQRT3_2 = sqrt({number}(3)) / 2"]
    lines += [f"    {entry.name} = _exact({entry.name})" for entry in kernel.inputs]
    lines += [f"    {line}" for line in map(unpack, kernel.inputs) if line]
    for comment, name, expression in comment_lines(program):
        if comment:
            lines.append(f"    # {comment}")
        lines.append(f"    {name} = {printer.doprint(expression)}")
    lines.append(f"    return {result}(")
    for _, value in program.outputs:
        lines.append(f"        {_nested(value, printer)},")
    return "\n".join([*lines, "    )"])


def _nested(value: object, printer: NestedExpressions) -> str:
    if not isinstance(value, ImmutableDenseMatrix):
        return printer.doprint(value)
    rows, columns = value.shape
    texts = [
        [printer.doprint(value[row, column]) for column in range(columns)] for row in range(rows)
    ]
    if columns == 1:
        return "[" + ", ".join(text for (text,) in texts) + "]"
    return "[" + ", ".join("[" + ", ".join(row) + "]" for row in texts) + "]"
