"""Workspaces for the tests."""

from math import radians

import numpy as np

import kleinform
from kleinform import Limits
from kleinform.maps.workspace import Workspace, constant_orientation_workspace

ROBOT = kleinform.UncoupledManipulator(1.0)
PAPER = kleinform.rotation_from_rpy(roll=radians(10), pitch=radians(3), yaw=radians(6))
OTHER = kleinform.rotation_from_rpy(roll=0.7, pitch=-1.0, yaw=2.0)
TILTED = kleinform.rotation_from_rpy(roll=0.3, pitch=-0.2, yaw=0.4)
YAW = kleinform.rotation_from_rpy(roll=0.0, pitch=0.0, yaw=0.3)
STEEP = kleinform.rotation_from_rpy(roll=0.0, pitch=radians(45), yaw=0.0)
LEGS = dict.fromkeys(("q1", "q2", "q3"), (0.6, 1.5))


def workspace(rotation: np.ndarray, ranges: dict | None = None) -> Workspace:
    limits = Limits.typical(1.0) if ranges is None else Limits(ranges)
    return constant_orientation_workspace(ROBOT, rotation, limits)


#: By name: a workspace each.
SPACES = {
    "paper": workspace(PAPER),
    "identity": workspace(np.eye(3)),
    "yaw": workspace(YAW),
    "steep": workspace(STEEP),
    "wedge": workspace(PAPER, {**LEGS, "q6": (0.7, 1.4), "q4": (-2.0, 2.0), "q5": (-0.5, 1.2)}),
    "legs": workspace(TILTED, dict.fromkeys(("q1", "q2", "q3"), (0.9, 1.5))),
}


def monte_carlo(space: Workspace, count: int, seed: int) -> tuple[float, float]:
    """The volume and its standard error, by random positions in the box and the robot's survey."""
    low, high = space.box
    positions = np.random.default_rng(seed).uniform(low, high, (count, 3))
    survey = ROBOT.survey(positions, space.rotation)
    room = space.limits.room(survey.joints, survey.extension)
    inside = np.all([value >= 0.0 for value in room.values()], axis=0)
    box = float(np.prod(high - low))
    return box * inside.mean(), box * inside.std() / count**0.5
