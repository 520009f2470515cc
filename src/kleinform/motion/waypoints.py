"""Motions through waypoints, and how far they leave the box of these."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import MotionWarning
from kleinform.joints import TOLERANCE
from kleinform.motion.joint_motion import JointMotion
from kleinform.motion.pose_motion import PoseMotion

__all__ = ["WaypointMotion", "WaypointPoseMotion", "joint_sizes", "overshoot", "warn_of_swings"]

Array = NDArray[np.float64]
#: Names and units of what goes through waypoints: the joints, or C.
JOINTS = (("q1", "m"), ("q2", "m"), ("q3", "m"), ("q4", "rad"), ("q5", "rad"), ("q6", "m"))
PLACES = (("x", "m"), ("y", "m"), ("z", "m"))


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


@dataclass(frozen=True)
class WaypointPoseMotion(PoseMotion):
    """A motion of the platform through poses.

    Attributes
    ----------
    overshoot : array (3,)
        How far each coordinate of C leaves the range of its waypoints [m].
    """

    overshoot: Array = field(compare=False)


def overshoot(curve: Any, points: Array) -> Array:
    """How far a piecewise polynomial (SciPy's PPoly) leaves the box (n,) of its waypoints (T, n).

    Between two waypoints it can do so only where its derivative vanishes.
    """
    turns = curve.derivative().roots(discontinuity=False, extrapolate=False)
    beyond = np.zeros(len(turns))
    for column, times in enumerate(turns):  # NaN marks a piece that rests
        values = curve(times[np.isfinite(times)])[:, column]
        low, high = points[:, column].min(), points[:, column].max()
        beyond[column] = np.max([values - high, low - values], initial=0.0)
    return beyond


def joint_sizes(points: Array) -> Array:
    """What joint values (T, 6) are large or small beside (6,): the longest length, one radian."""
    longest = points[:, [0, 1, 2, 5]].max()
    return np.array([longest, longest, longest, 1.0, 1.0, longest])


def warn_of_swings(advice: str, beyond: Array, points: Array, sizes: Array) -> None:
    """Warn of what swings farther beyond its waypoints (T, n) than these lie apart.

    What rests, but for the rounding of its values, is left out.
    """
    ways = np.ptp(points, axis=0)
    wild = (beyond > ways) & (ways > TOLERANCE * sizes)
    if wild.any():
        names = JOINTS if len(ways) == len(JOINTS) else PLACES
        told = ", ".join(
            f"{names[k][0]} by {beyond[k]:.3g} {names[k][1]} (of a way of {ways[k]:.3g})"
            for k in np.flatnonzero(wild)
        )
        warnings.warn(
            f"the spline swings beyond its waypoints, {told}: take {advice}",
            MotionWarning,
            stacklevel=3,
        )
