"""Motions that touch something, or barely pass it, at a time that is known by construction.

Each depends on the time through one shallow function alone, so that whatever is watched turns,
or is passed, where that function does.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from kleinform import TrackingError, UncoupledManipulator
from kleinform.limits import LIMITED, Limits
from kleinform.motion import JointMotion, PoseMotion

ROBOT = UncoupledManipulator()
#: Roll 10°, pitch 3°, yaw 6°.
START = Rotation.from_euler("ZYX", np.deg2rad([6.0, 3.0, 10.0]))
HOME = np.array([0.25, 0.2, 1.0])
COUNTS = (11, 34, 101, 1001)
#: How far from a sample it is met [s]; None: anywhere between two samples.
OFF = (0.0, 1e-17, 1e-16, 1e-15, 1e-13, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, None)


class Touch(NamedTuple):
    """A motion of one second, what it meets and when, and with how many samples it is watched.

    A motion of the joints has the rotation that it starts from.
    """

    motion: JointMotion | PoseMotion
    limits: Limits
    name: str
    time: float
    count: int
    start: np.ndarray | None = None


class Shallow(NamedTuple):
    """k τ² (1 + c τ) − depth, where τ is the time since the turn."""

    turn: float
    k: float
    c: float
    depth: float

    def __call__(self, times: np.ndarray) -> np.ndarray:
        since = times - self.turn
        return self.k * since**2 * (1.0 + self.c * since) - self.depth


def a_time(rng: np.random.Generator, count: int) -> float:
    """On a sample, near one, or between two."""
    times = np.linspace(0.0, 1.0, count)
    sample = int(rng.integers(count // 4, 3 * count // 4))
    off = OFF[rng.integers(len(OFF))]
    if off is None:
        return float(rng.uniform(times[sample], times[sample + 1]))
    return float(times[sample] + rng.choice([-1.0, 1.0]) * off)


def shallow(rng: np.random.Generator, time: float, slope: float, change: float) -> Shallow:
    """It comes to zero at a time: with a slope of what is watched there, or turning.

    ``change`` is the derivative of what is watched by the shallow function.
    """
    k = float(10.0 ** rng.uniform(-2.0, 0.0))
    if slope == 0.0:
        return Shallow(time, k, float(rng.uniform(-0.8, 0.8)), 0.0)
    early = slope / (2.0 * k * change)
    return Shallow(time + early, k, 0.0, k * early**2)


def along(
    share: Callable[[np.ndarray], np.ndarray], move: np.ndarray, turn: np.ndarray
) -> PoseMotion:
    """C and the platform go from a pose as far as a function of the time says."""

    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        shares, still = share(times)[:, np.newaxis], np.zeros((len(times), 6))
        turned = Rotation.from_rotvec(shares * turn) * START
        return HOME + shares * move, turned.as_matrix(), still, still

    return PoseMotion(function, 0.0, 1.0)


def limit_of_poses(rng: np.random.Generator, slope: float = 0.0) -> Touch:
    """A joint or an extension comes to a limit along a motion of the platform."""
    while True:
        touch = _limit_of_poses(rng, slope)
        states = touch.motion.at(np.linspace(0.0, touch.time, 500))
        factor = ROBOT.survey(states.positions, states.rotations).factors["orientation"]
        if (factor * factor[0] > 0.0).all():  # no other thing is met before
            return touch


def _limit_of_poses(rng: np.random.Generator, slope: float) -> Touch:
    while True:
        move, turn = 0.3 * rng.normal(size=(2, 3))
        states = along(lambda times: times - 0.5, move, turn).at([0.5, 0.5 + 1e-6])
        survey = ROBOT.survey(states.positions, states.rotations)
        values = np.concatenate([survey.joints, survey.extension], axis=1)
        changes = (values[1] - values[0]) / 1e-6
        index = int(rng.integers(9))
        if abs(changes[index]) >= 0.1:
            break
    count = int(rng.choice(COUNTS))
    time = a_time(rng, count)
    u = shallow(rng, time, slope, abs(changes[index]))
    limits, name = a_limit(index, values[0, index], changes[index])
    return Touch(along(u, move, turn), limits, name, time, count)


def limit_of_joints(rng: np.random.Generator, slope: float = 0.0) -> Touch:
    """A joint comes to a limit along a motion of the joints."""
    start = ROBOT.inverse_displacement(HOME, START)
    while True:
        move = 0.1 * rng.normal(size=6)
        index, count = int(rng.integers(6)), int(rng.choice(COUNTS))
        move[index] = rng.choice([-1.0, 1.0]) * rng.uniform(0.1, 0.3)
        time = a_time(rng, count)
        u = shallow(rng, time, slope, abs(move[index]))
        shares = u(np.linspace(u.turn, 0.0, 50))[:, np.newaxis]
        try:
            rotation = ROBOT.track(start + shares * move, START)[1][-1]
        except TrackingError:  # another mode meets this one before
            continue
        break

    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        still = np.zeros((len(times), 6))
        return start + u(times)[:, np.newaxis] * move, still, still

    limits, name = a_limit(index, start[index], move[index])
    return Touch(JointMotion(function, 0.0, 1.0), limits, name, time, count, rotation)


def a_limit(index: int, value: float, change: float) -> tuple[Limits, str]:
    """At a value, with the side that its change comes from within."""
    joint, end = LIMITED[index], "low" if change > 0.0 else "high"
    ends = (float(value), np.inf) if change > 0.0 else (-np.inf, float(value))
    return Limits({joint: ends}), f"{joint} {end}"


def factor(rng: np.random.Generator, slope: float = 0.0) -> Touch:
    """C comes into the plane of limb 1, c·u_1 = a, and turns there or passes it."""
    count = int(rng.choice(COUNTS))
    time = a_time(rng, count)
    return factor_along(shallow(rng, time, slope, 1.0), time, count)


def factor_along(u: Shallow, time: float, count: int) -> Touch:
    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        positions = np.broadcast_to([1.0, 0.2, 1.0], (len(times), 3)).copy()
        positions[:, 0] -= u(times)
        matrices = np.broadcast_to(START.as_matrix(), (len(times), 3, 3))
        still = np.zeros((len(times), 6))
        return positions, matrices, still, still

    return Touch(PoseMotion(function, 0.0, 1.0), Limits(), "extension_1", time, count)


KINDS = {"limit of poses": limit_of_poses, "limit of joints": limit_of_joints, "factor": factor}


def error(touch: Touch) -> float:
    """How far the time that `watch` finds is off [s]; infinite when it meets something else."""
    first = ROBOT.watch(
        touch.motion, touch.count, limits=touch.limits, start_rotation=touch.start
    ).first
    if first is None or first.name != touch.name:
        return np.inf
    return abs(first.time - touch.time)
