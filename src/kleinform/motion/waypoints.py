"""Motions through waypoints of the joints, and how far they leave the box of these."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import MotionWarning
from kleinform.joints import TOLERANCE
from kleinform.motion.joint_motion import JointMotion

__all__ = ["WaypointMotion", "joint_sizes", "overshoot", "warn_of_swings"]

Array = NDArray[np.float64]
UNITS = ("m", "m", "m", "rad", "rad", "m")


@dataclass(frozen=True)
class WaypointMotion(JointMotion):
    """A motion of the joints through waypoints.

    Attributes
    ----------
    overshoot : array (6,)
        How far each joint leaves the range of its waypoints [m, m, m, rad, rad, m], at the
        extrema of its polynomials; 0 where it does not.
    """

    overshoot: Array = field(compare=False)


def overshoot(curve: Any, points: Array) -> Array:
    """How far a piecewise polynomial (SciPy's PPoly) leaves the box (6,) of its waypoints.

    Between two waypoints it can do so only where its derivative vanishes.
    """
    turns = curve.derivative().roots(discontinuity=False, extrapolate=False)
    beyond = np.zeros(6)
    for joint, times in enumerate(turns):  # NaN marks a piece that rests
        values = curve(times[np.isfinite(times)])[:, joint]
        low, high = points[:, joint].min(), points[:, joint].max()
        beyond[joint] = np.max([values - high, low - values], initial=0.0)
    return beyond


def joint_sizes(points: Array) -> Array:
    """What joint values (T, 6) are large or small beside (6,): the longest length, one radian."""
    longest = points[:, [0, 1, 2, 5]].max()
    return np.array([longest, longest, longest, 1.0, 1.0, longest])


def warn_of_swings(beyond: Array, points: Array) -> None:
    """Warn of joints that swing farther beyond their waypoints than these lie apart.

    Joints that rest, but for the rounding of their values, are left out.
    """
    ways = np.ptp(points, axis=0)
    wild = (beyond > ways) & (ways > TOLERANCE * joint_sizes(points))
    if wild.any():
        told = ", ".join(
            f"q{j + 1} by {beyond[j]:.3g} {UNITS[j]} (their way is {ways[j]:.3g} {UNITS[j]})"
            for j in np.flatnonzero(wild)
        )
        warnings.warn(
            f"through_joints: the spline swings beyond its waypoints, {told}: take more even "
            "times, or shape_preserving=True",
            MotionWarning,
            stacklevel=3,
        )
