"""Motions of the joints as functions of time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError
from kleinform.joints import checked_joints, unwrapped
from kleinform.motion.clock import checked_duration, checked_span, even_times
from kleinform.motion.function import FunctionOfTime
from kleinform.motion.states import JOINT_SHAPES, JointStates
from kleinform.screening import LARGEST, real_array

__all__ = ["JointMotion", "polynomials", "rest_to_rest", "rest_to_rest_coefficients"]

Array = NDArray[np.float64]
#: 10 s³ − 15 s⁴ + 6 s⁵ goes from 0 to 1, at rest at both ends.
SMOOTH_STEP = np.array([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])


@dataclass(frozen=True)
class JointMotion(FunctionOfTime):
    """A motion of the joints: a function of time, and when it begins and ends.

    Parameters
    ----------
    function : callable
        From times (T,) to ``(q, q̇, q̈)``, each (T, 6), in the order and units of
        `JointStates`.
    start, end : float
        [s], ``start < end``.
    """

    def at(self, times: ArrayLike) -> JointStates:
        """The joints at some times (T,) [s].

        Raises
        ------
        InputError
            A time is outside the motion, or the function returned something else than three
            finite arrays (T, 6).
        JointRangeError
            A length is negative, or q5 is outside [−π/2, π/2].
        """
        when, joints, rates, accelerations = self.values(times, JOINT_SHAPES)
        return JointStates(when, checked_joints(joints), rates, accelerations)

    def sampled(self, count: int) -> JointStates:
        """The joints at so many evenly spaced times, the first and the last among them."""
        return self.at(even_times(self.start, self.end, count))


def polynomials(coefficients: ArrayLike, start: float, end: float) -> JointMotion:
    """Joints that move as polynomials in the time since the start.

    Parameters
    ----------
    coefficients : array_like (6, n)
        A row a joint, the constant first; powers of seconds.
    start, end : float
        [s].

    Raises
    ------
    InputError
        In this time a polynomial reaches numbers above 1e100.
    """
    first, last = checked_span(start, end)
    rows = real_array("coefficients", coefficients, ())
    rows = real_array("coefficients", rows, (6, *rows.shape[1:2]))
    columns = [np.asarray(polynomial.polyder(rows.T, order), np.float64) for order in range(3)]
    with np.errstate(all="ignore"):
        most = max(polynomial.polyval(last - first, abs(column)).max() for column in columns)
    if not most <= LARGEST:
        raise InputError(
            f"coefficients, start, end: in {last - first!r} s the polynomials may reach "
            f"{most:.3g}; at most {LARGEST:g} is needed"
        )

    def function(times: Array) -> tuple[ArrayLike, ...]:
        return tuple(polynomial.polyval(times - first, column).T for column in columns)

    return JointMotion(function, first, last)


def rest_to_rest_coefficients(start: ArrayLike, end: ArrayLike, duration: float) -> Array:
    """Coefficients (6, 6) of the quintics that go from rest to rest, the constant first.

    Velocity and acceleration vanish at both ends, so that with ``s = t/duration`` the motion
    is ``start + (end − start)(10 s³ − 15 s⁴ + 6 s⁵)``, which the paper writes as
    ``mu_0 + mu_3 t³ + mu_4 t⁴ + mu_5 t⁵``.

    Parameters
    ----------
    start, end : array_like (6,)
        Joint values q1 ... q6; q4 goes the shorter way round.
    duration : float
        [s].

    Raises
    ------
    InputError
        The coefficients leave the range of float64, or the accelerations exceed 1e100.
    JointRangeError
    """
    time = checked_duration(duration)
    first, last = checked_joints(start), checked_joints(end)
    ends = np.stack([real_array("start", first, (6,)), real_array("end", last, (6,))])
    ends[:, 3] = unwrapped(ends[:, 3])
    way = ends[1] - ends[0]
    with np.errstate(all="ignore"):
        coefficients = np.outer(way, SMOOTH_STEP / time ** np.arange(6.0))
        fastest = abs(coefficients[:, 3] * time).max()
    precise = (abs(coefficients[:, 3:]) >= np.finfo(np.float64).tiny).all(axis=1) | (way == 0.0)
    if not (fastest <= LARGEST and np.isfinite(coefficients).all() and precise.all()):
        raise InputError(
            "duration: one is needed whose fifth power, and whose accelerations, are numbers in "
            f"float64; {duration!r} s arrived"
        )
    coefficients[:, 0] = ends[0]
    return coefficients


def rest_to_rest(start: ArrayLike, end: ArrayLike, duration: float) -> JointMotion:
    """The smooth motion of Example 2: quintics from rest to rest, from t = 0 on.

    Parameters, errors
        As in `rest_to_rest_coefficients`.
    """
    return polynomials(rest_to_rest_coefficients(start, end, duration), 0.0, duration)
