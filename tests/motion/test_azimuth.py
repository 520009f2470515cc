"""q4 is an angle on a circle: whoever joins joint values goes the shorter way round."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import InputError, TrackingError, UncoupledManipulator, rotation_from_rpy
from kleinform.motion import (
    JointStates,
    PlatformStates,
    interpolated,
    rest_to_rest,
    through_joints,
)
from tests.support import many

ROBOT = UncoupledManipulator()
START = rotation_from_rpy(roll=np.radians(10), pitch=np.radians(3), yaw=np.radians(6))
#: 10 s³ − 15 s⁴ + 6 s⁵: from rest to rest.
STEP = np.polynomial.Polynomial([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])


def circle(
    rng: np.random.Generator, shares: np.ndarray, turns: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """C about the Z axis: joint values as they come, the azimuth counted, and where C is."""
    angles = rng.uniform(-np.pi, np.pi) + 2.0 * np.pi * turns * shares
    radius, height = rng.uniform([0.05, 0.8], [0.5, 1.4])
    places = np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1)
    positions = np.concatenate([places, np.full((len(shares), 1), height)], axis=1)
    return ROBOT.inverse_displacement(positions, START), angles, positions


def some_turns(rng: np.random.Generator) -> float:
    return float(rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 4.0))


def around(rng: np.random.Generator, turns: float, count: int) -> tuple[JointStates, float]:
    """C at a steady speed: what `inverse_*` say at every sample, and the rate of q4."""
    times = np.linspace(0.0, rng.uniform(0.5, 20.0), count)
    joints, _, positions = circle(rng, times / times[-1], turns)
    rate = 2.0 * np.pi * turns / times[-1]
    twists, twist_rates = np.zeros((2, count, 6))
    twists[:, 3], twists[:, 4] = -rate * positions[:, 1], rate * positions[:, 0]
    twist_rates[:, 3:5] = -(rate**2) * positions[:, :2]
    turned = np.broadcast_to(START, (count, 3, 3))
    rates = ROBOT.inverse_velocity(positions, turned, twists)
    accelerations = ROBOT.inverse_acceleration(positions, turned, twists, twist_rates)
    return JointStates(times, joints, rates, accelerations), rate


@pytest.mark.long
def test_samples_on_circles_keep_their_rate() -> None:
    """Right, or refused where the samples are half a turn and more apart."""
    rng = np.random.default_rng(51)
    for _ in range(many(60, 2000)):
        turns = some_turns(rng)
        count = int(np.ceil(abs(turns) * rng.uniform(1.1, 40.0))) + 1
        states, rate = around(rng, turns, count)
        if abs(turns) / (count - 1) > 0.5:
            with pytest.raises(InputError, match=r"sample \d+: q4 goes by"):
                interpolated(states)
            continue
        found = interpolated(states).sampled(400)
        assert abs(found.rates[:, 3] - rate).max() <= 1e-9 * abs(rate)
        assert abs(np.diff(found.joints[:, 3])).max() <= 1.01 * abs(rate) * states.times[-1] / 399


@pytest.mark.long
def test_waypoints_on_circles_keep_their_rates() -> None:
    rng = np.random.default_rng(52)
    for _ in range(many(40, 1000)):
        turns, duration = some_turns(rng), rng.uniform(0.5, 20.0)
        times = np.linspace(0.0, duration, int(24 * abs(turns)) + 12)
        joints, angles, _ = circle(rng, STEP(times / duration), turns)
        motion = through_joints(times, joints)
        counted = joints.copy()
        counted[:, 3] = angles - angles[0] + joints[0, 3]
        fine = np.linspace(0.0, duration, 500)
        found, wanted = motion.at(fine), through_joints(times, counted).at(fine)
        assert abs(found.joints - wanted.joints).max() <= 1e-12
        analytic = 2.0 * np.pi * turns * STEP.deriv()(fine / duration) / duration
        assert abs(found.rates[:, 3] - analytic).max() <= 0.01 * abs(analytic).max()


@pytest.mark.long
def test_two_poses_across_the_jump() -> None:
    rng = np.random.default_rng(53)
    for _ in range(many(40, 1000)):
        turns = float(rng.uniform(-0.49, 0.49))
        (start, end), (first, last), _ = circle(rng, np.array([0.0, 1.0]), turns)
        for motion in (rest_to_rest(start, end, 2.0), through_joints([0.0, 2.0], [start, end])):
            moved = motion.at([0.0, 2.0]).joints[:, 3]
            assert abs(moved[1] - moved[0] - (last - first)) <= 1e-12


@pytest.mark.long
def test_a_mode_is_followed_the_shorter_way() -> None:
    """Samples that are far apart are joined by segments that do not go back a turn."""
    rng = np.random.default_rng(54)
    for _ in range(many(15, 300)):
        turns = some_turns(rng)
        shares = np.linspace(0.0, 1.0, int(np.ceil(abs(turns) * rng.uniform(3.0, 12.0))) + 1)
        joints, angles, _ = circle(rng, shares, turns)
        counted = joints.copy()
        counted[:, 3] = angles
        for wrapped, straight in zip(
            ROBOT.track(joints, START), ROBOT.track(counted, START), strict=True
        ):
            assert abs(wrapped - straight).max() <= 1e-12


@pytest.mark.long
def test_a_segment_across_the_jump_goes_the_shorter_way() -> None:
    """From one side of the jump to the other, the platform tilted and turning: ways of q4
    round the base would lead through singularities."""
    rng, found = np.random.default_rng(58), 0
    while found < many(3, 40):
        tilt, turn = 0.6 * rng.normal(size=3), 0.25 * rng.normal(size=3)
        start = Rotation.from_rotvec(tilt)
        angles = np.pi + rng.uniform(0.05, 1.0, 2) * [-1.0, 1.0]
        radii, heights = rng.uniform(0.2, 1.2, 2), rng.uniform(0.6, 1.5, 2)
        places = np.stack([radii * np.cos(angles), radii * np.sin(angles), heights], axis=1)
        turns = np.stack([start.as_matrix(), (Rotation.from_rotvec(turn) * start).as_matrix()])
        joints = ROBOT.inverse_displacement(places, turns)
        counted = joints.copy()
        counted[1, 3] += 2.0 * np.pi
        try:
            wanted = ROBOT.track(counted, start)
        except TrackingError:
            continue
        assert abs(ROBOT.track(joints, start)[1] - wanted[1]).max() <= 1e-12
        found += 1


@pytest.mark.long
def test_joints_of_a_motion_of_the_platform_count_turns() -> None:
    rng = np.random.default_rng(55)
    for _ in range(many(20, 500)):
        turns = some_turns(rng)
        times = np.linspace(0.0, 1.0, int(np.ceil(abs(turns) * rng.uniform(2.1, 20.0))) + 1)
        _, angles, positions = circle(rng, times, turns)
        still, turned = np.zeros((len(times), 6)), np.broadcast_to(START, (len(times), 3, 3))
        states = ROBOT.inverse_motion(PlatformStates(times, positions, turned, still, still))
        assert abs(np.diff(states.joints[:, 3]) - np.diff(angles)).max() <= 1e-12


def test_rates_that_do_not_belong_to_the_azimuth() -> None:
    """The message shows the sample and what arrived."""
    states, _ = around(np.random.default_rng(56), 1.0, 9)
    rates = states.rates.copy()
    rates[4:6, 3] *= 10.0
    with pytest.raises(InputError, match=r"^rates: sample 4: q4 goes by 0\.785") as caught:
        interpolated(states._replace(rates=rates))
    assert caught.value.mask.tolist() == [
        False,
        False,
        False,
        False,
        True,
        True,
        True,
        *[False] * 2,
    ]


def test_what_was_given_is_not_changed() -> None:
    states, _ = around(np.random.default_rng(57), 2.0, 40)
    before = states.joints.copy()
    interpolated(states)
    through_joints(states.times, states.joints)
    ROBOT.track(states.joints, START)
    assert np.array_equal(states.joints, before)
