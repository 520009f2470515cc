# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Run a kernel over arrays of poses: on NumPy block by block, or compiled.

On NumPy, blocks keep the body's temporaries in cache, and a block's inputs are gathered once, since
the components of a pose lie apart in memory. Inputs are broadcast by the body itself, so
that none is ever copied to the shape of the batch.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kleinform_kernels._threads import in_parts

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

Shape = tuple[int, ...]
#: Poses in a block.
BLOCK = 8192
#: Poses that a thread takes at once from compiled kernels: some milliseconds.
PART = 32768


def apply(
    body: Callable[..., None],
    inputs: tuple[tuple[str, ArrayLike, Shape], ...],
    outputs: tuple[Shape, ...],
) -> list[Array]:
    """Broadcast named inputs against each other and return one array an output.

    Raises
    ------
    TypeError
        An input is not of real numbers.
    ValueError
        The trailing axes of an input are not its mathematical shape, or the leading axes
        of the inputs do not broadcast.
    """
    arrays, lead = _broadcast(inputs)
    cores = [len(core) for _, _, core in inputs]
    parts = [
        _components_first(array, core, lead) for array, core in zip(arrays, cores, strict=True)
    ]
    # Zeros, so that entries that are zero for every pose need not be written.
    results: list[Array] = [np.zeros(core + lead) for core in outputs]
    with np.errstate(all="ignore"):
        if math.prod(lead) <= BLOCK:
            body(*results, *(np.asarray(part, order="C") for part in parts))
        else:
            for slab in slabs(lead):
                body(
                    *(result[_index(slab)] for result in results),
                    *(np.ascontiguousarray(part[_index(_fit(slab, part))]) for part in parts),
                )
    return [
        result.transpose(*range(len(core), result.ndim), *range(len(core)))
        for result, core in zip(results, outputs, strict=True)
    ]


def apply_compiled(
    kernel: np.ufunc,
    inputs: tuple[tuple[str, ArrayLike, Shape], ...],
    outputs: tuple[Shape, ...],
) -> list[Array]:
    """The same with a compiled kernel, on several threads if the batch is large."""
    arrays, lead = _broadcast(inputs)
    cores = [len(core) for _, _, core in inputs]
    results: list[Array] = [np.empty(lead + core) for core in outputs]
    poses = math.prod(lead)
    if poses <= PART:  # a 0-d batch has no axis to cut
        kernel(*arrays, out=tuple(results))
        return results
    axis = lead.index(max(lead))

    def run(start: int, stop: int) -> None:
        slab = slice(start, stop)
        kernel(
            *(
                _part(array, axis - len(lead) - core, slab)
                for array, core in zip(arrays, cores, strict=True)
            ),
            out=tuple(result[(slice(None),) * axis + (slab,)] for result in results),
        )

    in_parts(run, lead[axis], -(-lead[axis] * PART // poses))
    return results


def _part(array: Array, axis: int, slab: slice) -> Array:
    """A slab of an array along an axis counted from its end, unless it is broadcast there."""
    if array.ndim < -axis or array.shape[axis] == 1:
        return array
    return array[(..., slab) + (slice(None),) * (-1 - axis)]


def _broadcast(inputs: tuple[tuple[str, ArrayLike, Shape], ...]) -> tuple[list[Array], Shape]:
    """The inputs as arrays of float64, and their common leading axes."""
    arrays = [_as_float(name, value, core) for name, value, core in inputs]
    leads = {
        array.shape[: array.ndim - len(core)]
        for array, (_, _, core) in zip(arrays, inputs, strict=True)
    }
    return arrays, leads.pop() if len(leads) == 1 else np.broadcast_shapes(*leads)


def slabs(lead: Shape) -> Iterator[tuple[slice, ...]]:
    """Slices that cover the leading axes in order, each of at most a block of poses."""
    if not lead:
        return
    first, rest = lead[0], math.prod(lead[1:])
    whole = tuple(slice(None) for _ in lead[1:])
    step = max(1, BLOCK // rest) if rest else max(1, first)
    for start in range(0, first, step):
        outer = slice(start, min(start + step, first))
        if rest <= BLOCK:
            yield (outer, *whole)
        else:
            yield from ((outer, *inner) for inner in slabs(lead[1:]))


def _index(slab: tuple[slice, ...]) -> Any:
    """All components of a slab."""
    return (..., *slab)


def _as_float(name: str, value: ArrayLike, core: Shape) -> Array:
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: real numbers are needed, {array.dtype} arrived")
    if core != array.shape[array.ndim - len(core) :]:
        raise ValueError(f"{name}: trailing axes {core} are needed, shape {array.shape} arrived")
    return array.astype(np.float64, copy=False)


def _components_first(array: Array, core: int, lead: Shape) -> Array:
    """The array with its mathematical axes in front and all leading axes present."""
    own = array.ndim - core
    front = array.transpose(*range(own, array.ndim), *range(own)) if core else array
    if own == len(lead):
        return front
    return front.reshape(front.shape[:core] + (1,) * (len(lead) - own) + front.shape[core:])


def _fit(slab: tuple[slice, ...], part: Array) -> tuple[slice, ...]:
    """The slab for an input whose axes of length one are broadcast."""
    sizes = part.shape[part.ndim - len(slab) :]
    return tuple(
        slice(None) if size == 1 else piece for piece, size in zip(slab, sizes, strict=True)
    )
