"""NumPy kernels: one function a kernel over arrays of poses, in blocks."""

from __future__ import annotations

from sympy import Abs, atan2, cos, sin

from derivations.codegen.lower import Program
from derivations.codegen.printers.python import (
    Float64Expressions,
    class_name,
    comment_lines,
    docstring,
    entries,
    result_class,
    unpack,
)

NAMES = {Abs: "absolute", atan2: "arctan2", cos: "cos", sin: "sin", "sqrt": "sqrt"}

HEAD = '''"""NumPy kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

Leading axes broadcast, trailing axes are the mathematical shape, everything is float64.
A result holds its components one after the other in memory, so that ``result[..., i]`` is
contiguous. Nothing is raised for a singular pose: it gives inf, or NaN where 0/0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from numpy import absolute, arctan2, cos, sin, sqrt

from kleinform_kernels._apply import apply

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[float64]

#: √3/2, exactly rounded.
SQRT3_2 = 0.8660254037844386
'''


def print_module(programs: list[Program]) -> str:
    """The module's text."""
    parts = [HEAD.rstrip()]
    for program in programs:
        parts += [result_class(program, "Array"), _public(program), _body(program)]
    return "\n\n\n".join(parts) + "\n"


def _public(program: Program) -> str:
    return public(program, "", "apply", f"_{program.kernel.name}")


def public(program: Program, first: str, apply: str, body: str) -> str:
    """The public function: ``first`` is tried before ``apply`` runs ``body``."""
    kernel = program.kernel
    arguments = ", ".join(f"{entry.name}: ArrayLike" for entry in kernel.inputs)
    result = class_name(kernel.name)
    inputs = [f'("{entry.name}", {entry.name}, {entry.shape}),' for entry in kernel.inputs]
    outputs = [f"{output.shape}," for output in kernel.outputs]
    return "\n".join(
        [
            f"def {kernel.name}({arguments}) -> {result}:",
            docstring(program, "array"),
            f"    return {first}{result}(",
            f"        *{apply}(",
            f"            {body},",
            "            (",
            *(f"                {line}" for line in inputs),
            "            ),",
            "            (",
            *(f"                {line}" for line in outputs),
            "            ),",
            "        )",
            "    )",
        ]
    )


def _body(program: Program) -> str:
    kernel, printer = program.kernel, Float64Expressions(NAMES)
    names = [f"out_{output.name}" for output in kernel.outputs]
    names += [entry.name for entry in kernel.inputs]
    lines = [f"def _{kernel.name}("]
    lines += [f"    {name}: Array," for name in names]
    lines += [") -> None:"]
    lines += [f"    {line}" for line in map(unpack, kernel.inputs) if line]
    for comment, name, expression in comment_lines(program):
        if comment:
            lines.append(f"    # {comment}")
        lines.append(f"    {name} = {printer.doprint(expression)}")
    for output, value in program.outputs:
        for index, entry in entries(value):
            if entry != 0:
                place = ", ".join(map(str, index)) or "..."
                lines.append(f"    out_{output.name}[{place}] = {printer.doprint(entry)}")
    return "\n".join(lines)
