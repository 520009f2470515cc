"""What a motion meets: singularities, limits, and the first time of it.

Every quantity that is watched is positive at the start, and is met when it comes down to
zero. Between two samples it is looked for where it changes its sign, and where the lines
through the samples on both sides come down to zero; there the motion is sampled anew, finer
and finer.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.limits import Limits
from kleinform.motion.joint_motion import JointMotion
from kleinform.motion.paths import RESOLUTION, FollowedPath, GivenPath, ModeEndedError
from kleinform.motion.pose_motion import PoseMotion
from kleinform.motion.quantities import KINDS, Quantity, quantities, room
from kleinform.motion.settling import TOLD, settled, touched
from kleinform.results import Survey
from kleinform.screening import RotationLike, one_rotation

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["Meeting", "Watch", "watch"]

Array = NDArray[np.float64]
#: With how many samples a stretch is looked at anew.
FINER = 17
#: Over so many times what counts as zero, a parabola settles where a quantity turns.
SHALLOW = 1e5
#: From how many values the end of a mode is extrapolated, and how often from nearer ones.
POINTS = 5
HALVINGS = 12


class Meeting(NamedTuple):
    """The first thing that a motion meets.

    Attributes
    ----------
    time : float
        [s]. To 1e-9 where a quantity changes its sign, or turns at zero with a curvature that
        rounding does not hide; where it comes to rest at zero, when it first counts as zero.
    name : str
        A factor of `Survey`, ``leg_i`` for q_i = 0, or a limit: ``"q1 high"``,
        ``"orientation margin"``.
    kind : {"direct", "inverse", "wrist", "limb", "limit"}
    """

    time: float
    name: str
    kind: str


@dataclass(frozen=True)
class Watch:
    """Singularities and limits along a motion.

    Attributes
    ----------
    times : array (T,)
        The samples [s]; where the assembly mode ends before the motion does, up to there.
    positions, rotations, joints : array (T, 3), (T, 3, 3), (T, 6)
        The motion at the samples; q4 does not jump.
    survey : Survey
        Factors, determinants and extensions over time.
    room : mapping of name to array (T,)
        How far each limit is away, in its unit; negative beyond it.
    first : Meeting or None
        What is met first.
    """

    times: Array
    positions: Array
    rotations: Array
    joints: Array
    survey: Survey
    room: Mapping[str, Array]
    first: Meeting | None


@dataclass(frozen=True)
class Watched:
    """A motion with its poses at any time, and the limits."""

    robot: UncoupledManipulator
    path: GivenPath | FollowedPath
    limits: Limits

    def at_samples(self) -> dict[str, Quantity]:
        return quantities(self.robot, self.path.samples, self.limits)

    def at(self, times: Array) -> dict[str, Quantity]:
        return quantities(self.robot, self.path.poses(times), self.limits)


def watch(
    robot: UncoupledManipulator,
    motion: JointMotion | PoseMotion,
    count: int,
    limits: Limits,
    start_rotation: RotationLike | None,
    mode: int | None,
) -> Watch:
    """See `UncoupledManipulator.watch`."""
    if not isinstance(limits, Limits):
        raise InputError(f"limits: Limits are needed, {limits!r} arrived")
    path = _path(robot, motion, count, start_rotation, mode)
    watched = Watched(robot, path, limits)
    while True:
        try:
            first = first_meeting(watched)
            break
        except ModeEndedError:  # the path is shorter now
            continue
    samples = path.samples
    survey = robot.survey(samples.positions, samples.rotations)
    away = room(samples, survey, limits)
    return Watch(path.times, *samples, survey, away, first)


def first_meeting(watched: Watched) -> Meeting | None:
    """What is met first; the end of the assembly mode when nothing is met before it.

    Of several at one time it is the first in the order of `quantities`, which names the limb
    that has no length before the factor that vanishes with it.
    """
    path, at_samples = watched.path, watched.at_samples()
    meetings = []
    for name, (value, zero) in at_samples.items():
        time = _first_time(watched, name, value, zero)
        if time is not None:
            meetings.append(Meeting(time, name, KINDS.get(name, "limit")))
    if path.stopped and not meetings:
        meetings.append(_end_of_mode(watched, at_samples))
    if not meetings:
        return None
    earliest = min(meeting.time for meeting in meetings)
    return next(meeting for meeting in meetings if meeting.time - earliest <= TOLD)


def _first_time(watched: Watched, name: str, value: Array, zero: Array) -> float | None:
    """The first time at which a quantity is met, from its values at the samples."""
    times = watched.path.times
    if abs(value[0]) <= zero[0]:
        return float(times[0])
    sign = -1.0 if name in KINDS and value[0] < 0.0 else 1.0
    if sign * value[0] < 0.0:  # beyond a limit
        return float(times[0])
    for low, high in _suspects(times, sign * value, zero):
        time = _zoom(watched, name, sign, low, high)
        if time is not None:
            return _settled(watched, name, sign, time)
    return None


def _settled(watched: Watched, name: str, sign: float, time: float) -> float:
    """When exactly a quantity is met that first counts as zero at a time."""
    times = watched.path.times

    def at(when: Array) -> tuple[Array, Array]:
        value, zero = watched.at(when)[name]
        return sign * value, zero

    exact = settled(at, float(times[0]), time, float(np.diff(times).max()))
    return min(exact, float(times[-1]))


def _zoom(watched: Watched, name: str, sign: float, low: float, high: float) -> float | None:
    """The first time in a stretch at which a quantity is met."""
    times = np.linspace(low, high, FINER)
    if high - low <= RESOLUTION or not (np.diff(times) > 0.0).all():
        return high
    value, zero = watched.at(times)[name]
    times = times[: len(value)]
    if len(times) < 3:
        return None
    value = sign * value
    if np.ptp(value) <= SHALLOW * zero.max() and (value >= -zero).all():
        turn = touched(times, value, zero)
        if turn is not None:
            return turn
    for ends in _suspects(times, value, zero):
        found = _zoom(watched, name, sign, *ends)
        if found is not None:
            return found
    return None


def _suspects(times: Array, value: Array, zero: Array) -> Iterator[tuple[float, float]]:
    """Stretches in which a quantity may come down to zero, up to the first in which it does.

    A curve that bends upwards lies above the lines through its points: it can come down to
    zero between two samples only if the lines from both sides do.
    """
    met = np.flatnonzero(value <= zero)
    last = int(met[0]) if met.size else len(times) - 1
    slopes = np.diff(value) / np.diff(times)
    ahead, behind = np.full((2, len(slopes)), -np.inf)
    ahead[1:] = value[1:-1] + slopes[:-1] * np.diff(times)[1:]
    behind[:-1] = value[1:-1] - slopes[1:] * np.diff(times)[:-1]
    doubtful = (ahead <= 0.0) & (behind <= 0.0)
    if met.size:
        doubtful[max(last - 1, 0)] = True
    for i in np.flatnonzero(doubtful[: max(last, 1)]):
        yield float(times[i]), float(times[i + 1])


def _end_of_mode(watched: Watched, at_samples: Mapping[str, Quantity]) -> Meeting:
    """Where the mode ends: the direct factor that is nearest to zero for its rounding."""
    near = {
        name: abs(float(value[-1] / zero[-1]))
        for name, (value, zero) in at_samples.items()
        if KINDS.get(name) == "direct"
    }
    name = min(near, key=near.__getitem__)
    return Meeting(_vanishing_time(watched, name), name, "direct")


def _vanishing_time(watched: Watched, name: str) -> float:
    """When a factor vanishes at the last sample, to which the mode could be followed, or later.

    Where modes merge a factor vanishes as the root of the time that is left, and the mode can
    be followed to the end. Where they cross, it vanishes as the time itself, and rounding
    hides the last stretch: it is extrapolated, from nearer and nearer until the time settles.
    """
    start, end = map(float, watched.path.times[-2:])
    found = [end]
    for halving in range(HALVINGS):
        left: Array = -0.125 * (end - start) / 2.0**halving * np.arange(POINTS, 0.0, -1.0)
        value = watched.at(end + left)[name].value
        if len(value) < POINTS:
            break
        if _curvature(value**2) < _curvature(value):
            return end
        found.append(end + _root(left, value))
        if abs(found[-1] - found[-2]) <= RESOLUTION:
            break
    return found[int(np.argmin(abs(np.diff(found)))) + 1] if len(found) > 1 else end


def _curvature(value: Array) -> float:
    """How much a sequence bends, for how much it changes."""
    return float(abs(value[0] - 2.0 * value[2] + value[4]) / abs(value[4] - value[0]))


def _root(left: Array, value: Array) -> float:
    """The time at which a value comes to zero: Lagrange's polynomial over the values."""
    total = 0.0
    for i, time in enumerate(left):
        others = np.delete(value, i)
        total += time * float(np.prod(others / (others - value[i])))
    return total


def _path(
    robot: UncoupledManipulator,
    motion: JointMotion | PoseMotion,
    count: int,
    start_rotation: RotationLike | None,
    mode: int | None,
) -> GivenPath | FollowedPath:
    if isinstance(motion, PoseMotion):
        if start_rotation is not None or mode is not None:
            raise InputError("watch: a motion of the platform needs no start_rotation and no mode=")
        return GivenPath(robot, motion, count)
    if (start_rotation is None) == (mode is None):
        raise InputError("watch: either start_rotation or mode= is needed")
    if start_rotation is None:
        from kleinform.forward.displacement import start_of

        start_rotation = start_of(robot.radius, motion.at([motion.start]).joints, mode)
    return FollowedPath(robot, motion, count, one_rotation("start_rotation", start_rotation))
