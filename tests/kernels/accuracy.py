"""How far a NumPy kernel is from its mpmath twin, in units of what its inputs' rounding does.

The unit is ``eps (size(out) + Σ_j |∂out/∂in_j| size(in_j))``: the rounding of the exact
result, and its change when every input moves by one rounding of its size. The size of a
component of a vector (a position, a direction, half a screw) is that of the vector. The
derivatives are differences of the mpmath kernels, never formulas.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import mpmath
import numpy as np

from derivations.uncoupled.kernels import kernels
from kleinform_kernels import uncoupled
from kleinform_kernels.uncoupled import mpmath_kernels
from tests.support import EPS, Case, platform_directions

DIGITS = 50
#: Relative step of the differences: half of the digits, which leaves 25 to the derivative.
STEP = mpmath.mpf(10) ** -25
KERNELS = {kernel.name: kernel for kernel in kernels()}
#: Outputs that hold vectors: the shape that lays them out, and the axis along each of them.
VECTORS = {
    "platform_joints": ((3, 3), 1),
    "position": ((3,), 0),
    "direction": ((3,), 0),
    "rotation": ((3, 3), 0),
    "d": ((3, 3), 1),
    "w": ((3, 3), 1),
    "lines": ((3, 2, 3), 2),
    "J_v": ((2, 3, 6), 1),
    "twist": ((2, 3), 1),
    "twist_rate": ((2, 3), 1),
    "wrench": ((2, 3), 1),
    "by_turn": ((3,), 0),
    "by_position": ((3,), 0),
    **{f"limb{limb}": ((6, 2, 3), 2) for limb in (1, 2, 3, 4)},
}
Arguments = dict[str, np.ndarray]


def arguments(name: str, case: Case, rng: np.random.Generator) -> Arguments:
    """What a kernel asks for at a pose, as float64 arrays."""
    radius, place, turn = case
    first, second, _ = platform_directions(turn)
    lengths = np.linalg.norm(place) * rng.uniform(0.5, 1.5, size=3)
    central = [*rng.uniform(-1.5, 1.5, size=2), lengths[0]]
    legs = rng.uniform(-np.pi, np.pi, size=2)
    start = np.column_stack([np.cos(legs), np.sin(legs)])
    known = {
        "a": np.float64(radius),
        "c": place,
        "R": turn,
        "heading": place[:2],
        "twist": rng.normal(size=(2, 3)) * np.array([[1.0], [radius]]),
        "rates": rng.normal(size=6) * np.array([radius, radius, radius, 1.0, 1.0, radius]),
        "twist_rate": rng.normal(size=(2, 3)) * np.array([[1.0], [radius]]),
        "accelerations": rng.normal(size=6) * np.array([radius, radius, radius, 1.0, 1.0, radius]),
        "forces": rng.normal(size=6) * np.array([1.0, 1.0, 1.0, radius, radius, 1.0]),
        "wrench": rng.normal(size=(2, 3)) * np.array([[1.0], [radius]]),
        "lengths": lengths,
        "directions": np.array([first, second]),
        "n1": first,
        "n2": second,
        "joints": np.array([*lengths, *central] if name == "fold" else central),
        "angle": start[0],
        "start": start,
        "half_tangents": rng.normal(size=2),
        "reference": turn[:, 2],
        "frame": turn.T,
        "half_angle": rng.normal(size=2),
        "second": second,
        "roll": rng.uniform(-3.0, 3.0),
        "pitch": rng.uniform(-1.5, 1.5),
        "yaw": rng.uniform(-3.0, 3.0),
    }
    return {entry.name: np.asarray(known[entry.name]) for entry in KERNELS[name].inputs}


def sizes(values: Arguments) -> Arguments:
    """The size of every component of every input."""
    found = {name: np.abs(value) for name, value in values.items()}
    for name in ("c", "heading"):
        if name in found:
            found[name] = np.full(values[name].shape, np.linalg.norm(values[name]))
    for name in ("R", "directions", "n1", "n2"):
        if name in found:
            found[name] = np.ones(values[name].shape)
    return found


def exact(name: str, values: dict[str, object]) -> np.ndarray:
    """The mpmath kernel's outputs in a row, as objects."""
    nested = {entry: np.asarray(value, dtype=object).tolist() for entry, value in values.items()}
    result = getattr(mpmath_kernels, name)(**nested)
    return np.concatenate([np.array(part, dtype=object).ravel() for part in result])


def nudged(values: Arguments, name: str, index: tuple[int, ...], step: object) -> dict:
    """The inputs with one component moved by a step, in mpmath's numbers."""
    moved = values[name].astype(object)
    moved[index] = mpmath.mpf(float(values[name][index])) + step
    return {**values, name: moved}


def output_sizes(name: str, center: np.ndarray) -> np.ndarray:
    """The size of every component of every output, in a row."""
    found, start = [], 0
    for output in KERNELS[name].outputs:
        stop = start + math.prod(output.shape)
        values = np.abs(center[start:stop])
        if output.name in VECTORS:
            layout, axis = VECTORS[output.name]
            values = values.reshape(layout)
            values = np.broadcast_to(values.max(axis=axis, keepdims=True), layout).ravel()
        found.append(values)
        start = stop
    return np.concatenate(found)


def unit(name: str, values: Arguments, center: np.ndarray) -> np.ndarray:
    """What rounding the outputs and each component of the inputs does, over eps."""
    total = output_sizes(name, center)
    for entry, size in sizes(values).items():
        for index in np.ndindex(size.shape):
            if size[index]:
                step = STEP * mpmath.mpf(float(size[index]))
                total = total + abs(exact(name, nudged(values, entry, index, step)) - center) / STEP
    return total


def ratios(name: str, values: Arguments) -> Iterator[tuple[str, float, float]]:
    """Each output's name, its worst error in units of eps times `unit`, and its value there."""
    with mpmath.workdps(DIGITS):
        center = exact(name, values)
        bound = unit(name, values, center)
        result = getattr(uncoupled, name)(**values)
        computed = np.concatenate([np.ravel(part) for part in result])
        errors = [abs(mpmath.mpf(float(x)) - y) for x, y in zip(computed, center, strict=True)]
        scaled = [_ratio(error, size) for error, size in zip(errors, bound, strict=True)]
    start = 0
    for output in KERNELS[name].outputs:
        stop = start + math.prod(output.shape)
        worst = start + int(np.argmax(scaled[start:stop]))
        yield output.name, scaled[worst], float(center[worst])
        start = stop


def _ratio(error: object, size: object) -> float:
    if error == 0:
        return 0.0
    return float(error / (size * EPS)) if size else float("inf")
