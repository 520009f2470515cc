"""What peers get: a kernel's outputs as scalar expressions of the components of a pose.

They are the same equations in the same forms that kernels evaluate, without the names between:
every output is expanded to the components of (a, c, R), and whoever makes a function of them
shares what repeats, with SymPy's `cse`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from sympy import Basic, Expr, Symbol

from derivations.algebra.equations import bindings, substitute
from derivations.algebra.vectors import components
from derivations.codegen.kernel import Kernel
from derivations.uncoupled.kernels import kernels

__all__ = ["Expressions", "expressions", "split"]

Shape = tuple[int, ...]


class Expressions(NamedTuple):
    """Entries of all outputs in order, flat, in terms of the thirteen arguments a, c, R."""

    arguments: list[Symbol]
    entries: list[Expr]
    shapes: list[Shape]


def expressions(name: str) -> Expressions:
    """The outputs of the kernel of this name."""
    named = {kernel.name: kernel for kernel in kernels()}
    kernel, pose = named[name], named["survey"].inputs
    arguments = [symbol for field in pose for symbol in _flat(field.entries)]
    # C is off the Z axis here, so that the azimuth of the heading is that of C.
    x, y = (Symbol(f"heading_{index}", real=True) for index in (1, 2))
    heading = {x: arguments[1], y: arguments[2]}
    values = _expanded(kernel)
    entries = [
        entry.xreplace(heading)
        for output in kernel.outputs
        for entry in _flat(substitute(output.entries, values))
    ]
    return Expressions(arguments, entries, [output.shape for output in kernel.outputs])


def split(flat: np.ndarray, shapes: list[Shape]) -> list[np.ndarray]:
    """Views of the last axis, one an output."""
    views, start = [], 0
    for shape in shapes:
        stop = start + math.prod(shape)
        views.append(flat[..., start:stop].reshape(flat.shape[:-1] + shape))
        start = stop
    return views


def _expanded(kernel: Kernel) -> dict[Symbol, Basic]:
    """Every component of the kernel's equations in terms of its inputs."""
    values: dict[Symbol, Basic] = {}
    for equation in kernel.graph.needed(kernel.wanted, kernel.given):
        value = substitute(components(equation.evaluated), values)
        values.update(bindings(equation.symbol, value))
    return values


def _flat(value: Basic) -> list[Basic]:
    return list(value) if getattr(value, "is_Matrix", False) else [value]
