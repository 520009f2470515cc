"""Joint values as they arrive: shape, finiteness, ranges."""

from __future__ import annotations

from math import inf, pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import JointRangeError
from kleinform.screening import Errors, Screen, real_array, reject_bad_numbers

__all__ = ["POSSIBLE", "TOLERANCE", "TURN", "checked_joints", "screened_joints", "unwrapped"]

Array = NDArray[np.float64]

#: Relative: joint values that were computed and rounded to float64 are off by a few roundings.
TOLERANCE = 4.0 * float(np.finfo(np.float64).eps)
#: What joint values can be, in m and rad; q4 can be anything.
POSSIBLE = {**dict.fromkeys(("q1", "q2", "q3", "q6"), (0.0, inf)), "q5": (-pi / 2.0, pi / 2.0)}
#: A full turn: of angles that do not add up over turns, those beyond it are not meant in rad.
TURN = 2.0 * pi


def checked_joints(value: ArrayLike) -> Array:
    """Joint values (..., 6) within their ranges.

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError
    JointRangeError
        A length q1, q2, q3, q6 is negative, or q5 is outside [−π/2, π/2].
    """
    joints, screen = screened_joints(value, "raise")
    screen.settle()
    return joints


def unwrapped(azimuth: Array) -> Array:
    """q4 over time (T,), an angle on a circle, as one that counts turns.

    It begins as it is; whole turns are added to the rest, so that none is farther than half a
    turn from the one before.
    """
    turns = np.cumsum(np.round(np.diff(azimuth, prepend=azimuth[:1]) / (2.0 * pi)))
    return azimuth - 2.0 * pi * turns


def screened_joints(value: ArrayLike, errors: Errors) -> tuple[Array, Screen]:
    """Joint values (..., 6), and a screen with the rows that are out of their ranges."""
    joints = real_array("joints", value, (6,))
    screen = Screen(joints.shape[:-1], errors)
    reject_bad_numbers(screen, "joints", joints, 1)
    for index in (0, 1, 2, 5):
        length = joints[..., index]
        rule = f"joints: q{index + 1} >= 0 is needed"
        screen.reject(length < 0.0, JointRangeError, rule, length)
    elevation = joints[..., 4]
    rule = "joints: q5 in [−π/2, π/2] is needed"
    screen.reject(abs(elevation) > pi / 2.0, JointRangeError, rule, elevation)
    return joints, screen
