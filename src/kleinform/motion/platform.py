"""From the joints over time to the platform over time, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kleinform.generated import kernels
from kleinform.joints import unwrapped
from kleinform.motion.clock import increasing_times, over_time
from kleinform.motion.states import JOINT_SHAPES, PLATFORM_SHAPES, JointStates, PlatformStates
from kleinform.pose import check_pose
from kleinform.screening import RotationLike

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["forward_motion", "inverse_motion"]

Array = NDArray[np.float64]


def forward_motion(
    robot: UncoupledManipulator,
    states: JointStates,
    start_rotation: RotationLike | None,
    mode: int | None,
) -> PlatformStates:
    """See `UncoupledManipulator.forward_motion`."""
    times, joints, rates, accelerations = _checked(states, JOINT_SHAPES)
    positions, rotations = robot.track(joints, start_rotation, mode=mode)
    pose = check_pose(
        robot,
        positions,
        rotations,
        "raise",
        azimuth=joints[:, 3],
        rates=rates,
        accelerations=accelerations,
    )
    result = kernels.forward_acceleration(
        pose.radius, pose.position, pose.rotation, pose.heading(), rates, accelerations
    )
    pose.reject_direct(result)
    pose.reject_overflow(result.twist_rate)
    pose.blank()
    return PlatformStates(times, positions, rotations, result.twist, result.twist_rate)


def inverse_motion(robot: UncoupledManipulator, states: PlatformStates) -> JointStates:
    """See `UncoupledManipulator.inverse_motion`."""
    times, positions, rotations, twists, twist_rates = _checked(states, PLATFORM_SHAPES)
    pose = check_pose(robot, positions, rotations, "raise", twists=twists, twist_rates=twist_rates)
    here = pose.radius, pose.position, pose.rotation
    displaced = kernels.inverse_displacement(*here)
    pose.reject_incidence(displaced.incidence)
    pose.reject_axis(displaced.radial, displaced.joints[:, 5], divided=False)
    halves = (array.reshape(-1, 2, 3) for array in (twists, twist_rates))
    result = kernels.inverse_acceleration(*here, *halves)
    pose.reject_inverse(result)
    pose.reject_overflow(result.rates)
    pose.reject_overflow(result.accelerations)
    pose.blank()
    joints = displaced.joints
    joints[:, 3] = unwrapped(joints[:, 3])
    return JointStates(times, joints, result.rates, result.accelerations)


def _checked(states: tuple[Array, ...], shapes: Mapping[str, tuple[int, ...]]) -> list[Array]:
    """Increasing times (T,), and an array (T, *shape) for each name."""
    times = increasing_times(states[0], 1)
    named = zip(shapes.items(), states[1:], strict=True)
    return [times, *(over_time(name, value, shape, times) for (name, shape), value in named)]
