"""The platform along motions of the joints, and back."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import (
    InputError,
    NotFiniteError,
    ShapeError,
    SingularPoseError,
    TrackingError,
    UncoupledManipulator,
    rotation_from_rpy,
)
from kleinform.motion import JointMotion, JointStates, PlatformStates, rest_to_rest, through_poses
from kleinform.paper.examples import example_1, example_2

ROBOT = UncoupledManipulator()
ROLL, PITCH, YAW = np.deg2rad([10.0, 3.0, 6.0])
START = rotation_from_rpy(roll=ROLL, pitch=PITCH, yaw=YAW)
EXAMPLES = {"1": example_1(), "2": example_2()}


@pytest.fixture(scope="module", params=EXAMPLES)
def motion(request: pytest.FixtureRequest) -> JointMotion:
    return EXAMPLES[request.param]


def test_twists_and_their_rates_are_derivatives(motion: JointMotion) -> None:
    """Sampled so densely that differences of neighbours are derivatives to 1e-8."""
    step = 1e-4
    middles = np.linspace(motion.start + 0.1, motion.end - 0.1, 40)
    times = (middles[:, np.newaxis] + step * np.array([-1.0, 0.0, 1.0])).ravel()
    states = ROBOT.forward_motion(motion.at(times), START)
    before, here, after = (PlatformStates(*(field[k::3] for field in states)) for k in range(3))
    velocity = (after.positions - before.positions) / (2.0 * step)
    assert abs(velocity - here.twists[:, 3:]).max() <= 1e-7
    turned = Rotation.from_matrix(after.rotations @ before.rotations.swapaxes(1, 2))
    assert abs(turned.as_rotvec() / (2.0 * step) - here.twists[:, :3]).max() <= 1e-7
    assert abs((after.twists - before.twists) / (2.0 * step) - here.twist_rates).max() <= 1e-6


def test_the_joints_come_back(motion: JointMotion) -> None:
    given = motion.sampled(301)
    found = ROBOT.inverse_motion(ROBOT.forward_motion(given, START))
    assert found.times.tolist() == given.times.tolist()
    for one, other in zip(found[1:], given[1:], strict=True):
        assert abs(one - other).max() <= 1e-12


def test_a_point_of_the_platform_moves_by_the_derivatives(motion: JointMotion) -> None:
    step = 1e-4
    times = 2.0 + step * np.array([-1.0, 0.0, 1.0])
    point = ROBOT.forward_motion(motion.at(times), START).of_point([0.1, -0.2, 0.3])
    velocity = (point.positions[2] - point.positions[0]) / (2.0 * step)
    acceleration = (point.velocities[2] - point.velocities[0]) / (2.0 * step)
    assert abs(velocity - point.velocities[1]).max() <= 1e-7
    assert abs(acceleration - point.accelerations[1]).max() <= 1e-6


def test_the_centre_is_a_point_of_the_platform(motion: JointMotion) -> None:
    states = ROBOT.forward_motion(motion.sampled(20), START)
    centre = states.of_point([0, 0, 0])
    assert np.array_equal(centre.positions, states.positions)
    assert np.array_equal(centre.velocities, states.twists[:, 3:])
    assert np.array_equal(centre.accelerations, states.twist_rates[:, 3:])


def test_a_mode_instead_of_a_start() -> None:
    states = EXAMPLES["2"].sampled(50)
    modes = ROBOT.forward_displacement(states.joints[0])
    for mode in range(2):
        found = ROBOT.forward_motion(states, mode=mode)
        assert abs(found.rotations[0] - modes.rotation[mode]).max() <= 1e-9


def test_ends_of_the_motion_between_two_poses() -> None:
    end = rotation_from_rpy(roll=np.deg2rad(12.0), pitch=np.deg2rad(5.0), yaw=np.deg2rad(10.0))
    poses = (([0.25, 0.2, 1.0], START), ([0.2, 0.1, 1.5], end))
    joints = [ROBOT.inverse_displacement(*pose) for pose in poses]
    states = ROBOT.forward_motion(rest_to_rest(*joints, 5.0).sampled(101), START)
    for index, (position, rotation) in zip((0, -1), poses, strict=True):
        assert abs(states.positions[index] - position).max() <= 1e-14
        assert abs(states.rotations[index] - rotation).max() <= 1e-13
        assert abs(states.twists[index]).max() <= 1e-13
        assert abs(states.twist_rates[index]).max() <= 1e-12


def test_the_azimuth_does_not_jump() -> None:
    """C goes once around the Z axis."""
    times = np.linspace(0.0, 2.0 * np.pi, 101)
    circle = np.stack([np.cos(times), np.sin(times), np.full(101, 4.0)], axis=1) * 0.25
    path = through_poses(times, circle, np.broadcast_to(START, (101, 3, 3)))
    azimuth = ROBOT.inverse_motion(path.sampled(101)).joints[:, 3]
    assert abs(azimuth - times).max() <= 1e-6


def test_the_azimuth_is_known_on_the_axis() -> None:
    """With a vertical central limb q4 comes from the joints."""
    joints = ROBOT.inverse_displacement([0.0, 0.0, 1.0], START, azimuth=0.3)
    joints = np.broadcast_to(joints, (2, 6))
    still = np.zeros((2, 6))
    rates = still.copy()
    rates[:, 4] = 0.1  # q5 moves C along the azimuth
    states = ROBOT.forward_motion(JointStates(np.array([0.0, 1.0]), joints, rates, still), START)
    expected = 0.1 * np.array([-np.cos(0.3), -np.sin(0.3), 0.0])
    assert abs(states.twists[0, 3:] - expected).max() <= 1e-15


def test_backwards_in_time_is_refused() -> None:
    states = EXAMPLES["1"].sampled(5)
    with pytest.raises(InputError, match="each after the one before"):
        ROBOT.forward_motion(states._replace(times=states.times[::-1]), START)


@pytest.mark.parametrize("field", ["joints", "rates", "accelerations"])
def test_what_is_no_motion_is_refused(field: str) -> None:
    states = EXAMPLES["1"].sampled(5)
    value = getattr(states, field)
    with pytest.raises(ShapeError, match=f"^{field}: "):
        ROBOT.forward_motion(states._replace(**{field: value[:4]}), START)
    with pytest.raises(ShapeError, match=f"^{field}: "):
        ROBOT.forward_motion(states._replace(**{field: value[:, :5]}), START)
    spoiled = value.copy()
    spoiled[2, 3] = np.nan
    with pytest.raises(NotFiniteError, match=f"^{field}: .*pose 2"):
        ROBOT.forward_motion(states._replace(**{field: spoiled}), START)


def test_a_singularity_on_the_way_is_named() -> None:
    """From the paper's pose straight through R = I, where modes meet."""
    vector = Rotation.from_matrix(START).as_rotvec()
    shares = np.linspace(1.0, -1.0, 21)
    turns = Rotation.from_rotvec(shares[:, np.newaxis] * vector).as_matrix()
    joints = ROBOT.inverse_displacement([0.25, 0.2, 1.0], turns)
    still = np.zeros((21, 6))
    with pytest.raises(TrackingError, match=r"^sample \d+: "):
        ROBOT.forward_motion(JointStates(np.arange(21.0), joints, still, still), START)


def test_the_axis_is_refused_on_the_way_back() -> None:
    turns = np.broadcast_to(START, (3, 3, 3))
    positions = np.array([[0.1, 0.0, 1.0], [0.0, 0.0, 1.0], [-0.1, 0.0, 1.0]])
    still = np.zeros((3, 6))
    states = PlatformStates(np.arange(3.0), positions, turns, still, still)
    with pytest.raises(SingularPoseError, match="pose 1"):
        ROBOT.inverse_motion(states)


@pytest.mark.parametrize("offset", [[0.0, 0.0], [0.0, np.nan, 0.0]])
def test_bad_offsets_are_refused(offset: list[float]) -> None:
    states = ROBOT.forward_motion(EXAMPLES["1"].sampled(3), START)
    with pytest.raises(InputError, match=r"^offset: "):
        states.of_point(offset)
