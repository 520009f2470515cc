"""mpmath kernels: one pose at a time, at the precision that ``mpmath.mp`` holds."""

from __future__ import annotations

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

NAMES = {Abs: "absolute", atan2: "atan2", cos: "cos", sin: "sin", "sqrt": "sqrt"}

HEAD = '''"""mpmath kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

One pose at a time, nested sequences in and nested lists out, at the working precision of
``mpmath.mp``: the reference against which the NumPy kernels are tested.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from mpmath import atan2, cos, mpf, sin, sqrt
from mpmath import fabs as absolute

Nested = Any


def _exact(value: Nested) -> Nested:
    """Turn every entry of a nested sequence into an mpf, without loss."""
    try:
        entries = iter(value)
    except TypeError:
        return mpf(value)
    return [_exact(entry) for entry in entries]
'''


class MpmathExpressions(PythonExpressions):
    def __init__(self) -> None:
        super().__init__(NAMES)

    def _print_Rational(self, expr: Expr) -> str:
        return f"mpf({expr.p})/{expr.q}"


def print_module(programs: list[Program]) -> str:
    """The module's text."""
    parts = [HEAD.rstrip()]
    for program in programs:
        parts += [result_class(program, "Nested"), _function(program)]
    return "\n\n\n".join(parts) + "\n"


def _function(program: Program) -> str:
    kernel, printer = program.kernel, MpmathExpressions()
    arguments = ", ".join(f"{entry.name}: Nested" for entry in kernel.inputs)
    result = class_name(kernel.name)
    lines = [f"def {kernel.name}({arguments}) -> {result}:", docstring(program, "nested list")]
    lines += ["    SQRT3_2 = sqrt(mpf(3)) / 2"]
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


def _nested(value: object, printer: MpmathExpressions) -> str:
    if not isinstance(value, ImmutableDenseMatrix):
        return printer.doprint(value)
    rows, columns = value.shape
    texts = [
        [printer.doprint(value[row, column]) for column in range(columns)] for row in range(rows)
    ]
    if columns == 1:
        return "[" + ", ".join(text for (text,) in texts) + "]"
    return "[" + ", ".join("[" + ", ".join(row) + "]" for row in texts) + "]"
