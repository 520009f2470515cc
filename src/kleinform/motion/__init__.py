"""Motions over time: of the joints, of the platform, and what they meet."""

from kleinform.motion.joint_motion import (
    JointMotion,
    polynomials,
    rest_to_rest,
    rest_to_rest_coefficients,
)
from kleinform.motion.states import JointStates, PlatformStates, PointStates

__all__ = [
    "JointMotion",
    "JointStates",
    "PlatformStates",
    "PointStates",
    "polynomials",
    "rest_to_rest",
    "rest_to_rest_coefficients",
]
