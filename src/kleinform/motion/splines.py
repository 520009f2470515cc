"""Motions through what is known at some times, by SciPy's splines (extra ``motion``)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import MissingExtraError
from kleinform.joints import checked_joints
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
    """
    when = increasing_times(times, 2)
    points = checked_joints(over_time("joints", joints, (6,), when))
    rest = [(1, np.zeros(6)), (2, np.zeros(6))]
    return _joint_motion(make_interp_spline(when, points, k=5, bc_type=(rest, rest)), when)


def interpolated(states: JointStates) -> JointMotion:
    """Between samples of the joints with their rates and accelerations.

    Quintic polynomials that meet all three at every sample, and so are twice continuously
    differentiable.

    Parameters
    ----------
    states : JointStates
        At least two samples.
    """
    when = increasing_times(states.times, 2)
    orders = values_at(lambda _: tuple(states[1:]), when, JOINT_SHAPES)
    checked_joints(orders[0])
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


def _joint_motion(spline: Any, when: Array) -> JointMotion:
    """A motion from a piecewise polynomial and its derivatives."""
    orders = [spline, spline.derivative(1), spline.derivative(2)]
    return JointMotion(
        lambda at: tuple(order(at) for order in orders), float(when[0]), float(when[-1])
    )
