"""Motions over time: of the joints, of the platform, and what they meet."""

from typing import TYPE_CHECKING, Any

from kleinform.motion.joint_motion import (
    JointMotion,
    polynomials,
    rest_to_rest,
    rest_to_rest_coefficients,
)
from kleinform.motion.pose_motion import PoseMotion
from kleinform.motion.states import JointStates, PlatformStates, PointStates
from kleinform.motion.watch import Meeting, Watch
from kleinform.motion.waypoints import WaypointMotion, WaypointPoseMotion

if TYPE_CHECKING:
    from kleinform.motion.splines import interpolated, through_joints, through_poses

__all__ = [
    "JointMotion",
    "JointStates",
    "Meeting",
    "PlatformStates",
    "PointStates",
    "PoseMotion",
    "Watch",
    "WaypointMotion",
    "WaypointPoseMotion",
    "interpolated",
    "polynomials",
    "rest_to_rest",
    "rest_to_rest_coefficients",
    "through_joints",
    "through_poses",
]


def __getattr__(name: str) -> Any:
    """What needs SciPy, loaded when asked for."""
    if name in ("interpolated", "through_joints", "through_poses"):
        from kleinform.motion import splines

        return getattr(splines, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
