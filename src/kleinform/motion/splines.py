"""Motions through what is known at some times, by SciPy's splines (extra ``motion``)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from math import factorial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, MissingExtraError
from kleinform.joints import checked_joints, unwrapped
from kleinform.motion.clock import increasing_times, over_time, refuse_wild_motions, values_at
from kleinform.motion.joint_motion import JointMotion
from kleinform.motion.states import JOINT_SHAPES, JointStates
from kleinform.motion.waypoints import (
    WaypointMotion,
    WaypointPoseMotion,
    joint_sizes,
    overshoot,
    warn_of_swings,
)
from kleinform.screening import RotationLike, Screen, reject_bad_rotations, rotation_array

try:
    from scipy.interpolate import (
        BPoly,
        CubicHermiteSpline,
        CubicSpline,
        PchipInterpolator,
        PPoly,
        make_interp_spline,
    )
    from scipy.spatial.transform import Rotation, RotationSpline
except ModuleNotFoundError as missing:  # pragma: no cover
    raise MissingExtraError("splines need SciPy: pip install 'kleinform[motion]'") from missing

__all__ = ["interpolated", "through_joints", "through_poses"]

Array = NDArray[np.float64]
#: A spline meets its waypoints to this, beside the longest length and one radian.
MISS = 1e-9


def through_joints(
    times: ArrayLike, joints: ArrayLike, *, shape_preserving: bool = False
) -> WaypointMotion:
    """Through waypoints of the joints, at rest at both ends.

    The quintic spline with velocity and acceleration zero at the first and the last waypoint:
    four times continuously differentiable, and `rest_to_rest` for two waypoints. Where times
    are uneven it swings beyond its waypoints; ``.overshoot`` says how far.

    Parameters
    ----------
    times : array_like (T,)
        Increasing [s], T >= 2.
    joints : array_like (T, 6)
        q4 goes the shorter way round from each to the next.
    shape_preserving : bool
        Cubics with the slopes of Fritsch and Butland instead (SciPy's `PchipInterpolator`),
        zero at both ends: between two waypoints no joint leaves the range of these two. Rates
        are continuous; accelerations jump at the waypoints, both ends among them.

    Raises
    ------
    InputError
        Times are so uneven that the spline misses its waypoints, or so near each other that
        its accelerations exceed 1e100.

    Warns
    -----
    MotionWarning
        A joint swings farther beyond its waypoints than these lie apart.
    """
    when = increasing_times(times, 2)
    points = _waypoints(over_time("joints", joints, (6,), when))
    # From the first waypoint on: a joint that rests there rests exactly.
    ways = points - points[0]
    with _named_times(when):
        spline = _monotone(when, ways) if shape_preserving else _quintic(when, ways)
    _refuse_misses(spline, when, points)
    motion = _joint_motion(spline, when, points[0])
    beyond = overshoot(spline, ways)
    warn_of_swings("more even times, or shape_preserving=True", beyond, points, joint_sizes(points))
    return WaypointMotion(motion.function, motion.start, motion.end, beyond)


def _quintic(when: Array, ways: Array) -> PPoly:
    """The quintic spline at rest at both ends."""
    rest = [(1, np.zeros(6)), (2, np.zeros(6))]
    spline = make_interp_spline(when, ways, k=5, bc_type=(rest, rest))
    powers = [spline.derivative(k)(when[:-1]) / factorial(k) for k in range(5, -1, -1)]
    return PPoly(np.stack(powers), when)


def _refuse_misses(spline: PPoly, when: Array, points: Array) -> None:
    """Refuse times that make of rounding, or of an overflow, another curve."""
    with np.errstate(all="ignore"):
        miss = abs(points[0] + spline(when) - points)
    if not (miss <= MISS * joint_sizes(points)).all():
        raise InputError(
            f"times: {_gaps(when)}, are too uneven, too near or too far: rounding makes the spline "
            f"miss its waypoints by {miss.max():.3g}"
        )


def _monotone(when: Array, ways: Array) -> PPoly:
    """Cubics that stay between their waypoints, at rest at both ends."""
    slopes = PchipInterpolator(when, ways).derivative()(when)
    slopes[[0, -1]] = 0.0
    return CubicHermiteSpline(when, ways, slopes)


def interpolated(states: JointStates) -> JointMotion:
    """Between samples of the joints with their rates and accelerations.

    Quintic polynomials that meet all three at every sample, and so are twice continuously
    differentiable.

    Parameters
    ----------
    states : JointStates
        At least two samples; q4 goes the shorter way round from each to the next.

    Raises
    ------
    InputError
        The rates and accelerations of q4 make more than half a turn more or less of it.
    """
    when = increasing_times(states.times, 2)
    orders = values_at(lambda _: tuple(states[1:]), when, JOINT_SHAPES)
    orders[0] = _waypoints(orders[0])
    _refuse_other_turns(when, *(order[:, 3] for order in orders))
    with _named_times(when):
        quintics = BPoly.from_derivatives(when, np.stack(orders, axis=1))
    return _joint_motion(quintics, when, np.zeros(6))


def through_poses(
    times: ArrayLike, positions: ArrayLike, rotations: RotationLike
) -> WaypointPoseMotion:
    """Through poses of the platform.

    Natural cubic splines for C, and SciPy's `RotationSpline` for the platform: position and
    rotation are twice continuously differentiable. Where times are uneven C swings beyond its
    waypoints; ``.overshoot`` says how far.

    Parameters
    ----------
    times : array_like (T,)
        Increasing [s], T >= 2.
    positions : array_like (T, 3)
        C [m].
    rotations : array_like (T, 3, 3), or anything with ``as_matrix()``

    Raises
    ------
    InputError
        SciPy's iteration diverges over times so uneven, or velocities and accelerations
        exceed 1e100.

    Warns
    -----
    MotionWarning
        C swings farther beyond its waypoints than these lie apart.
    """
    when = increasing_times(times, 2)
    points = over_time("positions", positions, (3,), when)
    turns, tolerance = rotation_array("rotations", rotations)
    turns = over_time("rotations", turns, (3, 3), when)
    screen = Screen(when.shape, "raise")
    reject_bad_rotations(screen, "rotations", turns, tolerance)
    screen.settle()
    with _named_times(when):
        place = CubicSpline(when, points - points[0], bc_type="natural")
        turn = RotationSpline(when, Rotation.from_matrix(turns))

    def function(at: Array) -> tuple[Array, ...]:
        matrices = turn(at).as_matrix()
        # SciPy's angular rate and acceleration are in the platform's frame.
        omega, angular = (np.einsum("tij,tj->ti", matrices, turn(at, order)) for order in (1, 2))
        twists = np.concatenate([omega, place(at, 1)], axis=1)
        return (
            points[0] + place(at),
            matrices,
            twists,
            np.concatenate([angular, place(at, 2)], axis=1),
        )

    refuse_wild_motions(function, when)
    beyond = overshoot(place, points - points[0])
    warn_of_swings("more even times", beyond, points, abs(points).max())
    return WaypointPoseMotion(function, float(when[0]), float(when[-1]), beyond)


@contextmanager
def _named_times(when: Array) -> Iterator[None]:
    """What SciPy cannot make a spline of, or only with an overflow, is refused by its times."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            yield
    except (ValueError, FloatingPointError, np.linalg.LinAlgError) as error:
        raise InputError(f"times: {_gaps(when)}: SciPy makes no spline of them: {error}") from None


def _gaps(when: Array) -> str:
    gaps = np.diff(when)
    return f"{gaps.min():.3g} to {gaps.max():.3g} s apart"


def _waypoints(joints: Array) -> Array:
    """Checked joint values (T, 6) whose q4 counts turns."""
    points = checked_joints(joints).copy()
    points[:, 3] = unwrapped(points[:, 3])
    return points


def _refuse_other_turns(when: Array, azimuth: Array, rate: Array, acceleration: Array) -> None:
    """Refuse samples between which the rates of q4 make other turns than the shorter way."""
    spans, steps = np.diff(when), np.diff(azimuth)
    # Hermite's rule: exact where the rate is a cubic.
    made = spans * (rate[1:] + rate[:-1]) / 2.0 - spans**2 * np.diff(acceleration) / 12.0
    bad = np.append(False, ~(abs(steps - made) <= np.pi))
    if bad.any():
        k = int(np.argmax(bad))
        raise InputError(
            f"rates: sample {k}: q4 goes by {steps[k - 1]:.6g} rad from sample {k - 1}, the "
            f"shorter way round from {azimuth[k - 1]:.6g} to {azimuth[k]:.6g}, but its rates and "
            f"accelerations make {made[k - 1]:.6g} rad of it in {spans[k - 1]:.6g} s: less than "
            "half a turn from one sample to the next is needed",
            bad,
        )


def _joint_motion(spline: Any, when: Array, start: Array) -> JointMotion:
    """A motion from a piecewise polynomial, which begins at ``start``, and its derivatives."""
    orders = [spline, spline.derivative(1), spline.derivative(2)]

    def function(at: Array) -> tuple[Array, ...]:
        ways, rates, accelerations = (order(at) for order in orders)
        return start + ways, rates, accelerations

    refuse_wild_motions(function, np.sort(np.append(when, 0.5 * (when[1:] + when[:-1]))))
    return JointMotion(function, float(when[0]), float(when[-1]))
