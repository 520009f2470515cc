"""Times of a motion, and what its function returns at them, checked."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, ShapeError
from kleinform.screening import LARGEST, Screen, is_whole, real_array, reject_bad_numbers

__all__ = [
    "checked_duration",
    "checked_span",
    "checked_times",
    "even_times",
    "increasing_times",
    "over_time",
    "refuse_wild_motions",
    "values_at",
]

Array = NDArray[np.float64]


def checked_span(start: float, end: float) -> tuple[float, float]:
    """When a motion begins and ends."""
    span = real_array("start, end", (start, end), (2,))
    if not (np.isfinite(span).all() and span[0] < span[1]):
        raise InputError(f"start < end, both finite, is needed, {start!r} and {end!r} arrived")
    return float(span[0]), float(span[1])


def checked_duration(duration: float) -> float:
    """How long a motion takes [s]."""
    value = real_array("duration", duration, ())
    if value.ndim or not 0.0 < value < np.inf:
        raise InputError(f"duration: a finite time above 0 s is needed, {duration!r} arrived")
    return float(value)


def checked_times(times: ArrayLike, start: float, end: float) -> Array:
    """Times (T,) within a motion."""
    when = real_array("times", times, ())
    if when.ndim != 1:
        raise ShapeError(f"times: shape (T,) is needed, {when.shape} arrived")
    screen = Screen(when.shape, "raise")
    reject_bad_numbers(screen, "times", when, 0)
    outside = ~((start <= when) & (when <= end))
    screen.reject(outside, InputError, f"times: from {start!r} to {end!r} s is needed", when)
    screen.settle()
    return when


def increasing_times(times: ArrayLike, least: int) -> Array:
    """At least so many times (T,), each after the one before."""
    when = real_array("times", times, ())
    if when.ndim != 1 or len(when) < least:
        raise ShapeError(f"times: shape (T,) with T >= {least} is needed, {when.shape} arrived")
    screen = Screen(when.shape, "raise")
    reject_bad_numbers(screen, "times", when, 0)
    late = np.diff(when, prepend=-np.inf) <= 0.0
    screen.reject(late, InputError, "times: each after the one before is needed", when)
    screen.settle()
    return when


def even_times(start: float, end: float, count: int) -> Array:
    """So many evenly spaced times, the first and the last among them."""
    if not is_whole(count) or count < 2:
        raise InputError(f"count: at least 2 samples are needed, {count!r} arrived")
    return np.linspace(start, end, count)


def over_time(name: str, value: Any, core: tuple[int, ...], times: Array) -> Array:
    """Finite numbers (T, *core), one entry a time."""
    array = real_array(name, value, core)
    if array.shape != (len(times), *core):
        wanted = (len(times), *core)
        raise ShapeError(f"{name}: shape {wanted} is needed, {array.shape} arrived")
    screen = Screen(times.shape, "raise")
    reject_bad_numbers(screen, name, array, len(core))
    screen.settle()
    return array


def refuse_wild_motions(function: Callable[[Array], tuple[Any, ...]], times: Array) -> None:
    """Refuse times at which a motion goes so fast that its numbers leave the allowed ones."""
    with np.errstate(all="ignore"):
        most = max(float(abs(np.asarray(order)).max()) for order in function(times))
    if not most <= LARGEST:
        raise InputError(
            f"times: over {times[-1] - times[0]:.3g} s, {np.diff(times).min():.3g} s apart at "
            f"least, its values, rates or accelerations reach {most:.3g}; at most {LARGEST:g} is "
            "needed"
        )


def values_at(
    function: Callable[[Array], tuple[Any, ...]],
    times: Array,
    shapes: Mapping[str, tuple[int, ...]],
) -> list[Array]:
    """What a motion's function returns: for each name a finite array (T, *shape)."""
    returned = function(times)
    if not isinstance(returned, tuple) or len(returned) != len(shapes):
        raise InputError(f"the motion's function: a tuple ({', '.join(shapes)}) is needed")
    return [
        over_time(name, value, shape, times)
        for (name, shape), value in zip(shapes.items(), returned, strict=True)
    ]
