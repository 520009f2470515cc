"""Peers: functions of (a, c, R) that others make of the same expressions.

All return one array an output, shaped as the kernel's. Those named "out=" write into arrays
that were made beforehand, the same ones at every call; the others return new ones.

lambdify
    ``sympy.lambdify(..., "numpy", cse=True)`` for many poses, ``"math"`` on floats for one,
    which is the faster there.
Numba
    ``njit`` of what lambdify prints, in a loop over poses. ``error_model="numpy"`` gives inf
    and NaN as the kernels do; without ``fastmath``, which takes them for impossible.
CasADi
    SX expressions as generated C, compiled by ``gcc -O3``, ``map`` in series for many poses.
    It reads and writes the arrays in place through ``Function.buffer``: a call with DM copies
    them, which takes some twenty times as long.
JAX
    ``jit`` of what lambdify prints, 64 bits, on arrays of components, which are faster than
    ``vmap``; `placed` puts the arguments on its device beforehand.
"""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from sympy import lambdify

from benchmarks.expressions import Expressions, Shape, expressions, split

__all__ = ["batch_peers", "check", "lambdified", "missing", "placed", "single_peers"]

Array = np.ndarray
Function = Callable[[float, Any, Any], Sequence[Array]]
#: (a, c, R, out) with all outputs side by side in the last axis of ``out``.
Fill = Callable[[float, Array, Array, Array], object]

PACKAGES = {"Numba": "numba", "CasADi": "casadi", "JAX": "jax"}
#: Of a peer and the kernel, relative to the value or to 1: poses near a singular one amplify
#: the rounding.
TOLERANCE = 1e-11


def missing() -> list[str]:
    """The peers that are not installed; CasADi needs gcc as well."""
    return [
        name
        for name, package in PACKAGES.items()
        if find_spec(package) is None or (name == "CasADi" and shutil.which("gcc") is None)
    ]


def batch_peers(poses: int) -> dict[str, Function]:
    """Functions for so many poses, with the outputs of ``survey``."""
    return _installed(expressions("survey"), (poses,))


def single_peers() -> dict[str, Function]:
    """Functions for one pose, with the outputs of ``inverse_displacement``."""
    wanted = expressions("inverse_displacement")
    return {"lambdify": _on_floats(wanted), **_installed(wanted, ())}


def lambdified(name: str) -> Function:
    """One lambdify on NumPy's arrays of all outputs of the kernel of this name.

    lambdify ignores ``cse`` on nested lists, so that it returns a flat list, which is then
    written into one array an output.
    """
    wanted = expressions(name)
    function = lambdify(wanted.arguments, wanted.entries, "numpy", cse=True)

    def call(a: float, c: Array, rotation: Array) -> list[Array]:
        entries = iter(function(a, *c.T, *rotation.reshape(len(c), 9).T))
        arrays = []
        for shape in wanted.shapes:
            array = np.empty((len(c), math.prod(shape)))
            for index in range(array.shape[1]):
                array[:, index] = next(entries)
            arrays.append(array.reshape(len(c), *shape))
        return arrays

    return call


def placed(name: str, c: Array, rotation: Array) -> tuple[Any, Any]:
    """A peer's arguments where and as it wants them: for JAX by component, on its device."""
    if name != "JAX":
        return c, rotation
    import jax

    flat = rotation.reshape(*c.shape[:-1], 9)
    return jax.device_put(c.T.copy()), jax.device_put(flat.T.copy())


def check(name: str, results: Sequence[Array], expected: Sequence[Array]) -> None:
    """Raise ArithmeticError where a peer's outputs are not those of the kernel."""
    for result, value in zip(results, expected, strict=True):
        if result.shape != value.shape:
            raise ArithmeticError(f"{name}: shape {result.shape}, the kernel's is {value.shape}")
        error = float(np.max(abs(result - value) / np.maximum(abs(value), 1.0)))
        if not error <= TOLERANCE:
            raise ArithmeticError(f"{name} and the kernel differ by {error:.0e}")


def _installed(wanted: Expressions, lead: Shape) -> dict[str, Function]:
    absent = missing()
    functions: dict[str, Function] = {}
    for name, make in {"Numba": _numba, "CasADi": _casadi}.items():
        if name not in absent:
            out = np.empty((*lead, len(wanted.entries)))
            fill = make(wanted, out)
            functions[name] = _into_new(fill, out, wanted.shapes)
            functions[f"{name}, out="] = _into_same(fill, out, wanted.shapes)
    if "JAX" not in absent:
        functions["JAX"] = _jax(wanted, lead)
    return functions


def _into_new(fill: Fill, like: Array, shapes: list[Shape]) -> Function:
    def call(a: float, c: Array, rotation: Array) -> list[Array]:
        out = np.empty(like.shape)
        fill(a, c, rotation, out)
        return split(out, shapes)

    return call


def _into_same(fill: Fill, out: Array, shapes: list[Shape]) -> Function:
    views = split(out, shapes)

    def call(a: float, c: Array, rotation: Array) -> list[Array]:
        fill(a, c, rotation, out)
        return views

    return call


def _on_floats(wanted: Expressions) -> Function:
    function = lambdify(wanted.arguments, wanted.entries, "math", cse=True)

    def call(a: float, c: Array, rotation: Array) -> list[Array]:
        flat = function(a, *c.tolist(), *rotation.ravel().tolist())
        return split(np.array(flat), wanted.shapes)

    return call


def _numba(wanted: Expressions, out: Array) -> Fill:
    import numba

    compiled = numba.njit(error_model="numpy")
    pose = compiled(lambdify(wanted.arguments, tuple(wanted.entries), "math", cse=True))
    size = len(wanted.entries)

    def one(a, c, R, out):  # type: ignore[no-untyped-def]
        values = pose(
            a, c[0], c[1], c[2],
            R[0, 0], R[0, 1], R[0, 2], R[1, 0], R[1, 1], R[1, 2], R[2, 0], R[2, 1], R[2, 2],
        )  # fmt: skip
        for j in range(size):
            out[j] = values[j]

    def many(a, c, R, out):  # type: ignore[no-untyped-def]
        for k in range(len(c)):
            values = pose(
                a, c[k, 0], c[k, 1], c[k, 2],
                R[k, 0, 0], R[k, 0, 1], R[k, 0, 2],
                R[k, 1, 0], R[k, 1, 1], R[k, 1, 2],
                R[k, 2, 0], R[k, 2, 1], R[k, 2, 2],
            )  # fmt: skip
            for j in range(size):
                out[k, j] = values[j]

    return compiled(one if out.ndim == 1 else many)


def _casadi(wanted: Expressions, out: Array) -> Fill:
    import casadi

    names = {"sqrt": casadi.sqrt, "atan2": casadi.atan2, "Abs": casadi.fabs, "abs": casadi.fabs}
    function = lambdify(wanted.arguments, wanted.entries, names, cse=True)
    inputs = [casadi.SX.sym(name, size) for name, size in (("a", 1), ("c", 3), ("R", 9))]
    scalars = [scalar for symbol in inputs for scalar in casadi.vertsplit(symbol)]
    pose = casadi.Function("pose", inputs, [casadi.vertcat(*function(*scalars))])
    if out.ndim == 1:
        return _one_in_place(_by_gcc(casadi, pose), out)
    return _many_in_place(_by_gcc(casadi, pose.map(len(out), "serial")), len(out))


def _by_gcc(casadi: Any, function: Any) -> Any:
    """The function as generated C, compiled and loaded."""
    generator = casadi.CodeGenerator("generated.c")
    generator.add(function)
    with tempfile.TemporaryDirectory() as folder:
        source, library = Path(generator.generate(f"{folder}/")), Path(folder, "generated.so")
        command = ["gcc", "-fPIC", "-shared", "-O3", str(source), "-o", str(library)]
        subprocess.run(command, check=True)
        return casadi.external(function.name(), str(library))


def _buffer(function: Any) -> tuple[Any, Any]:
    """CasADi's buffer and the function that evaluates it, which by itself has its address only."""
    buffer, evaluate = function.buffer()
    evaluate.buffer = buffer
    return buffer, evaluate


def _many_in_place(function: Any, poses: int) -> Fill:
    """CasADi's columns are a pose each, so that NumPy's rows are what it reads and writes."""
    buffer, evaluate = _buffer(function)
    radius = np.empty(poses)

    def fill(a: float, c: Array, rotation: Array, out: Array) -> None:
        radius[...] = a
        for index, array in enumerate((radius, c, rotation)):
            buffer.set_arg(index, array.data)
        buffer.set_res(0, out.data)
        evaluate()

    return fill


def _one_in_place(function: Any, same: Array) -> Fill:
    """For one pose, copies into and out of the same memory are faster than new addresses."""
    buffer, evaluate = _buffer(function)
    radius, position, matrix = np.empty(()), np.empty(3), np.empty((3, 3))
    for index, array in enumerate((radius, position, matrix)):
        buffer.set_arg(index, array.data)
    buffer.set_res(0, same.data)

    def fill(a: float, c: Array, rotation: Array, out: Array) -> None:
        radius[...], position[...], matrix[...] = a, c, rotation
        evaluate()
        if out is not same:
            out[...] = same

    return fill


def _jax(wanted: Expressions, lead: Shape) -> Function:
    # Read when JAX starts; the affinity of the process keeps its threads on one core as well.
    os.environ.setdefault(
        "XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"
    )
    import jax
    from jax import numpy as jnp

    jax.config.update("jax_enable_x64", True)
    function = lambdify(wanted.arguments, wanted.entries, "jax", cse=True)
    sizes = [math.prod(shape) for shape in wanted.shapes]

    def stacked(a: Any, c: Any, rotation: Any) -> list[Any]:
        """One array an output with components first, or one of all outputs of a pose."""
        entries = iter(jnp.broadcast_arrays(*function(a, *c, *rotation)))
        groups = sizes if lead else [sum(sizes)]
        return [jnp.stack(list(islice(entries, size))) for size in groups]

    compiled = jax.jit(stacked)

    def many(a: float, c: Any, rotation: Any) -> list[Array]:
        arrays = jax.block_until_ready(compiled(a, c, rotation))
        return [
            np.asarray(array).T.reshape(lead + shape)
            for array, shape in zip(arrays, wanted.shapes, strict=True)
        ]

    def one(a: float, c: Any, rotation: Any) -> list[Array]:
        return split(np.asarray(compiled(a, c, rotation)[0]), wanted.shapes)

    return many if lead else one
