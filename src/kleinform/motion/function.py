"""What motions of the joints and of the platform have in common: a function of time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.motion.clock import checked_span, checked_times, values_at

__all__ = ["FunctionOfTime"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FunctionOfTime:
    """A function of time, and when it begins and ends."""

    function: Callable[[Array], tuple[ArrayLike, ...]]
    start: float
    end: float

    def __post_init__(self) -> None:
        checked_span(self.start, self.end)

    def values(self, times: ArrayLike, shapes: Mapping[str, tuple[int, ...]]) -> list[Array]:
        """Times (T,) within the motion, and for each name a finite array (T, *shape)."""
        when = checked_times(times, self.start, self.end)
        return [when, *values_at(self.function, when, shapes)]
