"""The peer: one `sympy.lambdify(..., "numpy", cse=True)` of the same outputs.

It gets the same equations in the same forms, without the names between: every output is
expanded to the components of the pose, and lambdify shares what repeats. lambdify ignores
``cse`` on nested lists, so it returns a flat list, which is then written into arrays of the
same shapes that the kernels return.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from sympy import Basic, Symbol, lambdify

from derivations.algebra.equations import bindings, substitute
from derivations.algebra.vectors import components
from derivations.codegen.kernel import Kernel
from derivations.uncoupled.kernels import kernels

__all__ = ["lambdified"]


def lambdified(wanted: dict[str, tuple[str, ...]]) -> Callable[..., list[np.ndarray]]:
    """A function of (a, c, R) that returns the named outputs of the named kernels."""
    named = {kernel.name: kernel for kernel in kernels()}
    shapes, expressions = [], []
    for name, outputs in wanted.items():
        values = _expanded(named[name])
        for output in named[name].outputs:
            if output.name in outputs:
                shapes.append(output.shape)
                expressions += _flat(substitute(output.entries, values))
    pose = named["survey"].inputs
    arguments = [symbol for entry in pose for symbol in _flat(entry.entries)]
    # C is off the Z axis here, so that the azimuth of the heading is that of C.
    x, y = (Symbol(f"heading_{index}", real=True) for index in (1, 2))
    heading = {x: arguments[1], y: arguments[2]}
    expressions = [expression.xreplace(heading) for expression in expressions]
    function = lambdify(arguments, expressions, "numpy", cse=True)

    def call(a: float, c: np.ndarray, rotation: np.ndarray) -> list[np.ndarray]:
        flat = function(a, *c.T, *rotation.reshape(len(c), 9).T)
        return _collected(flat, shapes, len(c))

    return call


def _expanded(kernel: Kernel) -> dict[Symbol, Basic]:
    """Every component of the kernel's equations in terms of its inputs."""
    values: dict[Symbol, Basic] = {}
    for equation in kernel.graph.needed(kernel.wanted, kernel.given):
        value = substitute(components(equation.evaluated), values)
        values.update(bindings(equation.symbol, value))
    return values


def _flat(value: Basic) -> list[Basic]:
    return list(value) if getattr(value, "is_Matrix", False) else [value]


def _collected(flat: list, shapes: list[tuple[int, ...]], poses: int) -> list[np.ndarray]:
    """The flat list of components as one array an output."""
    rest = iter(flat)
    arrays = []
    for shape in shapes:
        array = np.empty((poses, math.prod(shape)))
        for index in range(array.shape[1]):
            array[:, index] = next(rest)
        arrays.append(array.reshape((poses, *shape)))
    return arrays
