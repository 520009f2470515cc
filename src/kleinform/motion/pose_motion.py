"""Motions of the platform as functions of time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.motion.clock import even_times
from kleinform.motion.function import FunctionOfTime
from kleinform.motion.states import PLATFORM_SHAPES, PlatformStates
from kleinform.screening import ROTATION_TOLERANCE, Screen, reject_bad_rotations

__all__ = ["PoseMotion"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PoseMotion(FunctionOfTime):
    """A motion of the platform: a function of time, and when it begins and ends.

    Parameters
    ----------
    function : callable
        From times (T,) to ``(positions, rotations, twists, twist_rates)`` in the shapes and
        units of `PlatformStates`.
    start, end : float
        [s], ``start < end``.
    """

    def at(self, times: ArrayLike) -> PlatformStates:
        """The platform at some times (T,) [s].

        Raises
        ------
        InputError
            A time is outside the motion, or the function returned something else than finite
            arrays of these shapes, with rotations among them.
        """
        states = PlatformStates(*self.values(times, PLATFORM_SHAPES))
        screen = Screen(states.times.shape, "raise")
        reject_bad_rotations(screen, "rotations", states.rotations, ROTATION_TOLERANCE)
        screen.settle()
        return states

    def sampled(self, count: int) -> PlatformStates:
        """The platform at so many evenly spaced times, the first and the last among them."""
        return self.at(even_times(self.start, self.end, count))
