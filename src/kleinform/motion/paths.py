"""Poses at any time of a motion, whether it is given by the platform or by the joints."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import TrackingError
from kleinform.joints import unwrapped
from kleinform.motion.joint_motion import JointMotion
from kleinform.motion.pose_motion import PoseMotion

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["RESOLUTION", "FollowedPath", "GivenPath", "ModeEndedError", "Poses"]

Array = NDArray[np.float64]
#: Times are told apart down to this [s].
RESOLUTION = 1e-10


class ModeEndedError(Exception):
    """The assembly mode that is followed ends between two samples."""


class Poses(NamedTuple):
    """Poses with their joint values: (T, 3), (T, 3, 3), (T, 6)."""

    positions: Array
    rotations: Array
    joints: Array


class GivenPath:
    """A motion of the platform."""

    #: It ends where it says.
    stopped = False

    def __init__(self, robot: UncoupledManipulator, motion: PoseMotion, count: int) -> None:
        self._robot = robot
        self._motion = motion
        self.times = motion.sampled(count).times
        self._azimuths: Array | None = None
        self.samples = self.poses(self.times)
        self._azimuths = unwrapped(self.samples.joints[:, 3])
        self.samples.joints[:, 3] = self._azimuths

    def poses(self, times: Array) -> Poses:
        """Poses at some times; q4 is that of the sample next to it, but for whole turns."""
        states = self._motion.at(times)
        joints = self._robot.survey(states.positions, states.rotations).joints
        if self._azimuths is not None:
            near = np.interp(times, self.times, self._azimuths)
            turns = np.round((near - joints[:, 3]) / (2.0 * np.pi))
            joints[:, 3] += 2.0 * np.pi * turns
        return Poses(states.positions, states.rotations, joints)


class FollowedPath:
    """A motion of the joints, followed along one assembly mode as far as it can be.

    Attributes
    ----------
    stopped : bool
        Whether the mode ends before the motion does: at the last of the times, to RESOLUTION.
    """

    def __init__(
        self, robot: UncoupledManipulator, motion: JointMotion, count: int, start: Array
    ) -> None:
        self._robot = robot
        self._motion = motion
        states = motion.sampled(count)
        positions, rotations = self._followed(states.joints, start)
        followed = len(positions)
        self.times = states.times[:followed]
        self.samples = Poses(positions, rotations, states.joints[:followed])
        self.stopped = False
        if followed < count:
            self._approach(float(states.times[followed]))

    def poses(self, times: Array) -> Poses:
        """Poses at some increasing times, followed from the last sample before them.

        Next to the end of a mode rounding decides how far that is: there may be fewer poses
        than times.

        Raises
        ------
        ModeEndedError
            The mode ends at one of them; the path ends there from now on.
        """
        first = int(np.searchsorted(self.times, times[0], side="right")) - 1
        joints = self._motion.at(times).joints
        chain = np.concatenate([self.samples.joints[first : first + 1], joints])
        positions, rotations = self._followed(chain, self.samples.rotations[first])
        count = len(positions) - 1
        poses = Poses(positions[1:], rotations[1:], joints[:count])
        if count == len(times) or (self.stopped and first >= len(self.times) - 2):
            return poses
        before = int(np.searchsorted(self.times, times[0]))
        self.times = np.concatenate([self.times[:before], times[:count]])
        kept = (field[:before] for field in self.samples)
        self.samples = Poses(*map(np.concatenate, zip(kept, poses, strict=True)))
        self._approach(float(times[count]))
        raise ModeEndedError

    def _followed(self, joints: Array, start: Array) -> tuple[Array, Array]:
        """Poses from a known one on, as many as can be followed."""
        while True:
            try:
                return self._robot.track(joints, start)
            except TrackingError as error:
                if error.sample == 0:
                    raise
                joints = joints[: error.sample]

    def _approach(self, beyond: float) -> None:
        """Add one more sample: the last time to which the mode can be followed."""
        self.stopped = True
        reached, last = self.times[-1], None
        while beyond - reached > RESOLUTION:
            middle = 0.5 * (reached + beyond)
            if not reached < middle < beyond:
                break
            try:
                last = self._from(reached, last, middle)
            except TrackingError:
                beyond = middle
            else:
                reached = middle
        if last is not None:
            self.times = np.append(self.times, reached)
            self.samples = Poses(*map(np.concatenate, zip(self.samples, last, strict=True)))

    def _from(self, time: float, poses: Poses | None, later: float) -> Poses:
        """The pose at a time from that at an earlier one, or from the last sample."""
        joints = self._motion.at([time, later]).joints
        start = self.samples.rotations[-1] if poses is None else poses.rotations[-1]
        positions, rotations = self._robot.track(joints, start)
        return Poses(positions[1:], rotations[1:], joints[1:])
