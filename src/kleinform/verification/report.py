"""Both examples of the paper by kleinform, beside Pinocchio and Exudyn."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from kleinform import UncoupledManipulator, rotation_from_rpy
from kleinform.motion import JointMotion, JointStates, PlatformStates
from kleinform.paper import printed
from kleinform.paper.examples import example_1, example_2
from kleinform.verification import by_exudyn, by_pinocchio
from kleinform.verification.mechanism import Mechanism, assembled

__all__ = [
    "BOUND",
    "EXAMPLES",
    "Differences",
    "differences",
    "exudyn_rows",
    "orders",
    "ours",
    "outer_twists",
    "pinocchio_row",
    "second_order",
    "start_of",
]

Array = NDArray[np.float64]
ROBOT = UncoupledManipulator(radius=printed.RADIUS)
EXAMPLES = {"Example 1": example_1(), "Example 2": example_2()}
#: Largest difference from Pinocchio in m, rad, per second and per second squared.
BOUND = 1e-10
#: Halving the step of a method of order 2 divides its error by about 4.
ORDERS = (1.7, 2.3)


class Pose(Protocol):
    """What both engines return."""

    @property
    def positions(self) -> Array: ...
    @property
    def rotations(self) -> Array: ...
    @property
    def twists(self) -> Array: ...


class Differences(NamedTuple):
    """The largest differences of a motion from kleinform's [m, rad, rad/s, m/s]."""

    position: float
    orientation: float
    angular_velocity: float
    linear_velocity: float


class PinocchioRow(NamedTuple):
    """One motion by Pinocchio.

    Attributes
    ----------
    samples : int
    differences : Differences
    angular_acceleration, linear_acceleration : float
        The largest differences [rad/s², m/s²].
    limbs : float
        The largest difference of the sums of (12), over the outer limbs, from the twist.
    closure : float
        The largest gap left in a loop [m, rad].
    seconds : float
    """

    samples: int
    differences: Differences
    angular_acceleration: float
    linear_acceleration: float
    limbs: float
    closure: float
    seconds: float

    @property
    def agrees(self) -> bool:
        """Whether no difference exceeds `BOUND`."""
        rates = (self.angular_acceleration, self.linear_acceleration, self.limbs)
        return max(*self.differences, *rates) <= BOUND


class ExudynRow(NamedTuple):
    """One motion by Exudyn: time steps, differences, seconds."""

    steps: int
    differences: Differences
    seconds: float


def ours(states: JointStates) -> PlatformStates:
    """kleinform's motion of the platform, from the assembly mode of the paper's pose."""
    roll, pitch, yaw = np.radians(printed.ROLL_PITCH_YAW_DEGREES)
    return ROBOT.forward_motion(states, rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw))


def start_of(platform: PlatformStates) -> Mechanism:
    """All that the engines learn of a motion of the platform: how it is assembled at first."""
    return assembled(platform.positions[0], platform.rotations[0], printed.RADIUS)


def differences(motion: Pose, own: PlatformStates) -> Differences:
    """The largest differences between two motions at the same times."""
    turned = np.linalg.norm(motion.rotations - own.rotations, axis=(1, 2)) / np.sqrt(2.0)
    return Differences(
        farthest(motion.positions - own.positions),
        float(turned.max()),  # angles this small equal their chords
        farthest(motion.twists[:, :3] - own.twists[:, :3]),
        farthest(motion.twists[:, 3:] - own.twists[:, 3:]),
    )


def farthest(vectors: Array) -> float:
    """The largest norm of vectors (T, 3)."""
    return float(np.linalg.norm(vectors, axis=1).max())


def outer_twists(joint_rates: Array, platform: PlatformStates) -> Array:
    """The platform's twist (3, T, 6) through each outer limb: rates times our screws (12).

    Not through the central limb: the paper writes both axes of its universal joint as fixed
    to the platform, which holds in no motion but spans the same rotations.
    """
    screws = np.stack(ROBOT.screws(platform.positions, platform.rotations)[:3])
    # A joint rate belongs to a unit axis, and n_i × w_i is none.
    revolute = np.linalg.norm(screws[..., :3], axis=-1, keepdims=True)
    units = screws / np.where(revolute > 0.0, revolute, 1.0)
    twists: Array = np.einsum("tij,itjk->itk", joint_rates[:, :3], units)
    return twists


def pinocchio_row(motion: JointMotion, samples: int) -> PinocchioRow:
    """A motion followed by Pinocchio."""
    states = motion.sampled(samples)
    own = ours(states)
    mechanism = by_pinocchio.PinocchioMechanism(start_of(own))
    begun = time.perf_counter()
    followed = mechanism.follow(states)
    seconds = time.perf_counter() - begun
    faster = followed.platform.twist_rates - own.twist_rates
    limbs = outer_twists(followed.joint_rates, own) - own.twists
    return PinocchioRow(
        samples,
        differences(followed.platform, own),
        farthest(faster[:, :3]),
        farthest(faster[:, 3:]),
        float(abs(limbs).max()),
        followed.closure,
        seconds,
    )


def exudyn_rows(motion: JointMotion, steps: tuple[int, ...]) -> Iterator[ExudynRow]:
    """A motion integrated by Exudyn with several step counts."""
    for count in steps:
        states = motion.sampled(count + 1)
        own = ours(states)
        begun = time.perf_counter()
        integrated = by_exudyn.follow(start_of(own), states)
        seconds = time.perf_counter() - begun
        yield ExudynRow(count, differences(integrated, own), seconds)


def orders(coarse: ExudynRow, fine: ExudynRow) -> tuple[float, float]:
    """Observed orders of the angular and of the linear velocity."""
    ratio = np.log(fine.steps / coarse.steps)
    angular, linear = np.log(np.divide(coarse.differences[2:], fine.differences[2:])) / ratio
    return float(angular), float(linear)


def second_order(coarse: ExudynRow, fine: ExudynRow) -> bool:
    """Whether both velocities converge with the order of the method, and poses agree."""
    low, high = ORDERS
    poses = max(fine.differences[:2]) <= BOUND
    return poses and all(low <= order <= high for order in orders(coarse, fine))
