"""C kernels: plain C99, one pose a call, and the same bodies on lanes of poses.

A body reads entry k of an array at ``k*stride``. With a stride of one that is an array of one
pose. With a stride of LANES it is a lane: one of LANES poses whose entries lie side by side,
and a loop over lanes is one that compilers turn into SIMD instructions.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sympy import Abs, Basic, Expr, atan2, cos, sin

from derivations.codegen.kernel import Field, Kernel
from derivations.codegen.lower import Program
from derivations.codegen.printers.arctangent import print_atan2
from derivations.codegen.printers.python import Float64Expressions, comment_lines, entries

__all__ = ["LICENSE", "print_header", "print_lanes", "print_source"]

NAMES = {Abs: "fabs", atan2: "angle_of", cos: "cos", sin: "sin", "sqrt": "sqrt"}

LICENSE = """\
/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
"""

HEADER = """\
/* Kernels of the uncoupled manipulator 3-RPRRC+RRPRU, one pose a call.

   Plain C99, also C++: no allocation, no globals, nothing but libm. Lengths in m, angles in
   rad, everything in the base frame. A matrix is an array of its rows, one after the other.
   Nothing is checked: a singular pose gives inf, or NaN where 0/0. Arrays must not overlap.
   What goes in is named in_, what comes out out_: no macro of yours, R or I, is in the way.

   Compile without value-changing optimisation (-ffast-math) and with -ffp-contract=off for
   the same results on every machine. */
#ifndef KLEINFORM_KERNELS_H
#define KLEINFORM_KERNELS_H

#ifndef KLEINFORM_API
#define KLEINFORM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif
"""

HEADER_END = """
#ifdef __cplusplus
}
#endif

#endif
"""

SOURCE = """\
#include "kernels.h"

#include <math.h>
#include <stddef.h>

#ifndef RESTRICT
#ifdef __cplusplus
#define RESTRICT
#else
#define RESTRICT restrict
#endif
#endif

#ifndef KLEINFORM_BODY
#define KLEINFORM_BODY static inline
#endif

/* sqrt(3)/2, exactly rounded. */
#define SQRT3_2 0.8660254037844386
"""

LANES = """\
/* Every kernel on LANES poses at once: entry k of a lane at [k*LANES], what goes in and what
   comes out each in one array. Compiled once for each set of instructions, VARIANT. */
#include "simd.h"
#include "table.h"

#define KLEINFORM_API static inline
#define KLEINFORM_BODY INLINE
#include "kernels.c"
"""


def print_header(programs: list[Program]) -> str:
    """``kernels.h``."""
    declared = [f"{_comment(program)}\n{_prototype(program)};" for program in programs]
    return LICENSE + HEADER + "\n" + "\n\n".join(declared) + "\n" + HEADER_END


def print_source(programs: list[Program]) -> str:
    """``kernels.c``."""
    parts = [LICENSE + SOURCE.rstrip(), print_atan2()]
    for program in programs:
        parts += [_body(program), _one_pose(program)]
    return "\n\n".join(parts) + "\n"


def print_lanes(programs: list[Program], checksum: int) -> str:
    """``lanes.c``: the lanes of every kernel, and the table of all kernels.

    ``checksum`` tells an extension that was compiled from older sources.
    """
    parts = [LICENSE + LANES.rstrip(), *map(_lanes, programs)]
    rows = "\n".join(map(_row, programs))
    table = f"static const struct kernel kernels[] = {{\n{rows}\n}};"
    found = "const struct table VARIANT_OF(kleinform_table) = {\n"
    found += f"    {len(programs)}, {checksum}UL, kernels,\n}};"
    return "\n\n".join([*parts, table, found]) + "\n"


def _comment(program: Program) -> str:
    """What a function does, and each argument with shape, words and unit."""
    kernel = program.kernel
    lines = [kernel.words, f"Equations {kernel.numbers} of the paper; base frame."]
    for name, field in _arguments(kernel):
        shape = "".join(f"[{size}]" for size in field.shape)
        lines.append(f"{name}{shape}: {field.words} [{field.unit}]")
    return "/* " + "\n   ".join(lines) + " */"


def _prototype(program: Program) -> str:
    kernel = program.kernel
    arguments = [_given(entry) for entry in kernel.inputs]
    arguments += [_returned(entry) for entry in kernel.outputs]
    return f"KLEINFORM_API void kleinform_{kernel.name}(\n    " + ",\n    ".join(arguments) + ")"


def _arguments(kernel: Kernel) -> list[tuple[str, Field]]:
    """Every argument by its name in C, a name that no macro has: R, I or pitch may be one."""
    given = [(f"in_{field.name}", field) for field in kernel.inputs]
    return given + [(f"out_{field.name}", field) for field in kernel.outputs]


def _given(field: Field) -> str:
    if not field.shape:
        return f"double in_{field.name}"
    return f"const double in_{field.name}[{math.prod(field.shape)}]"


def _returned(field: Field) -> str:
    name = f"out_{field.name}"
    return f"double {name}[{math.prod(field.shape)}]" if field.shape else f"double *{name}"


def _body(program: Program) -> str:
    kernel, printer = program.kernel, Float64Expressions(NAMES)
    arguments = [f"const double *RESTRICT in_{entry.name}" for entry in kernel.inputs]
    arguments += [f"double *RESTRICT out_{entry.name}" for entry in kernel.outputs]
    lines = [f"KLEINFORM_BODY void {kernel.name}_body(", "    size_t stride,"]
    lines += ["    " + ",\n    ".join(arguments) + ")", "{"]
    used = _used(program)
    for field in kernel.inputs:
        places = [(index, entry) for index, entry in _places(field.entries) if entry in used]
        if not places:
            lines.append(f"    (void)in_{field.name};")
        for index, entry in places:
            lines.append(f"    const double {entry} = in_{field.name}[{_at(index)}];")
    for comment, name, expression in comment_lines(program):
        if comment:
            lines.append(f"    /* {comment} */")
        lines.append(f"    const double {name} = {printer.doprint(expression)};")
    for output, value in program.outputs:
        for index, entry in _places(value):
            lines.append(f"    out_{output.name}[{_at(index)}] = {printer.doprint(entry)};")
    return "\n".join([*lines, "}"])


def _used(program: Program) -> set[Basic]:
    """The symbols that lines and outputs read."""
    read = set().union(*(line.expression.free_symbols for line in program.lines))
    return read.union(*(value.free_symbols for _, value in program.outputs))


def _places(value: Basic) -> Iterator[tuple[int, Expr]]:
    """Each entry with its index in the array."""
    for index, (_, entry) in enumerate(entries(value)):
        yield index, entry


def _at(index: int) -> str:
    return {0: "0", 1: "stride"}.get(index, f"{index} * stride")


def _one_pose(program: Program) -> str:
    kernel = program.kernel
    given = [f"in_{entry.name}" if entry.shape else f"&in_{entry.name}" for entry in kernel.inputs]
    given += [f"out_{entry.name}" for entry in kernel.outputs]
    return f"{_prototype(program)}\n{{\n    {kernel.name}_body(1, {', '.join(given)});\n}}"


def _lanes(program: Program) -> str:
    """Two functions on joined arrays: one pose, and LANES poses."""
    kernel = program.kernel

    def call(stride: str, lane: str) -> str:
        given = _joined(kernel.inputs, "in", stride, lane)
        given += _joined(kernel.outputs, "out", stride, lane)
        return f"{kernel.name}_body({stride}, {', '.join(given)});"

    arguments = "(const double *RESTRICT in, double *RESTRICT out)"
    return "\n".join(
        [
            f"static void {kernel.name}_one{arguments}",
            "{",
            f"    {call('1', '')}",
            "}",
            "",
            f"static void {kernel.name}_lanes{arguments}",
            "{",
            "    SIMD",
            "    for (size_t lane = 0; lane < LANES; ++lane)",
            f"        {call('LANES', ' + lane')}",
            "}",
        ]
    )


def _joined(fields: tuple[Field, ...], name: str, stride: str, lane: str) -> list[str]:
    start, given = 0, []
    for field in fields:
        offset = f"{start} * {stride}" if stride != "1" else str(start)
        given.append(f"{name} + {offset}{lane}")
        start += math.prod(field.shape)
    return given


def _row(program: Program) -> str:
    """The kernel's entry in the table: name, signature, words, sizes, functions."""
    kernel = program.kernel
    inputs = ",".join(_core(field) for field in kernel.inputs)
    outputs = ",".join(_core(field) for field in kernel.outputs)
    fields = (*kernel.inputs, *kernel.outputs)
    shapes = ", ".join(
        "{" + ", ".join(map(str, (*field.shape, 0, 0)[:2])) + "}" for field in fields
    )
    name = kernel.name
    return (
        f'    {{"{name}", "{inputs}->{outputs}",\n'
        f'     "{kernel.words}",\n'
        f"     {len(kernel.inputs)}, {len(kernel.outputs)}, {_size(kernel.inputs)}, "
        f"{_size(kernel.outputs)},\n"
        f"     {{{shapes}}},\n"
        f"     {name}_one, {name}_lanes}},"
    )


def _core(field: Field) -> str:
    return "(" + ",".join(map(str, field.shape)) + ")"


def _size(fields: tuple[Field, ...]) -> int:
    return sum(math.prod(field.shape) for field in fields)
