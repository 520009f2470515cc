"""Motions through what is known at some times, by SciPy's splines (extra ``motion``)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, MissingExtraError
from kleinform.joints import checked_joints, unwrapped
from kleinform.motion.clock import increasing_times, over_time, values_at
from kleinform.motion.joint_motion import JointMotion
from kleinform.motion.pose_motion import PoseMotion
from kleinform.motion.states import JOINT_SHAPES, JointStates
from kleinform.screening import RotationLike, Screen, reject_bad_rotations, rotation_array

try:
    from scipy.interpolate import BPoly, CubicSpline, make_interp_spline
    from scipy.spatial.transform import Rotation, RotationSpline
except ModuleNotFoundError as missing:  # pragma: no cover
    raise MissingExtraError("splines need SciPy: pip install 'kleinform[motion]'") from missing

__all__ = ["interpolated", "through_joints", "through_poses"]

Array = NDArray[np.float64]


def through_joints(times: ArrayLike, joints: ArrayLike) -> JointMotion:
    """Through waypoints of the joints, at rest at both ends.

    The quintic spline with velocity and acceleration zero at the first and the last waypoint:
    four times continuously differentiable, and `rest_to_rest` for two waypoints.

    Parameters
    ----------
    times : array_like (T,)
        Increasing [s], T >= 2.
    joints : array_like (T, 6)
        q4 goes the shorter way round from each to the next.
    """
    when = increasing_times(times, 2)
    points = _waypoints(over_time("joints", joints, (6,), when))
    rest = [(1, np.zeros(6)), (2, np.zeros(6))]
    return _joint_motion(make_interp_spline(when, points, k=5, bc_type=(rest, rest)), when)


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
    return _joint_motion(BPoly.from_derivatives(when, np.stack(orders, axis=1)), when)


def through_poses(times: ArrayLike, positions: ArrayLike, rotations: RotationLike) -> PoseMotion:
    """Through poses of the platform.

    Natural cubic splines for C, and SciPy's `RotationSpline` for the platform: position and
    rotation are twice continuously differentiable.

    Parameters
    ----------
    times : array_like (T,)
        Increasing [s], T >= 2.
    positions : array_like (T, 3)
        C [m].
    rotations : array_like (T, 3, 3), or anything with ``as_matrix()``
    """
    when = increasing_times(times, 2)
    points = over_time("positions", positions, (3,), when)
    turns, tolerance = rotation_array("rotations", rotations)
    turns = over_time("rotations", turns, (3, 3), when)
    screen = Screen(when.shape, "raise")
    reject_bad_rotations(screen, "rotations", turns, tolerance)
    screen.settle()
    place = CubicSpline(when, points, bc_type="natural")
    turn = RotationSpline(when, Rotation.from_matrix(turns))

    def function(at: Array) -> tuple[Array, ...]:
        matrices = turn(at).as_matrix()
        # SciPy's angular rate and acceleration are in the platform's frame.
        omega, angular = (np.einsum("tij,tj->ti", matrices, turn(at, order)) for order in (1, 2))
        twists = np.concatenate([omega, place(at, 1)], axis=1)
        return place(at), matrices, twists, np.concatenate([angular, place(at, 2)], axis=1)

    return PoseMotion(function, float(when[0]), float(when[-1]))


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


def _joint_motion(spline: Any, when: Array) -> JointMotion:
    """A motion from a piecewise polynomial and its derivatives."""
    orders = [spline, spline.derivative(1), spline.derivative(2)]
    return JointMotion(
        lambda at: tuple(order(at) for order in orders), float(when[0]), float(when[-1])
    )
