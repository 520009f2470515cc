"""Motions of the joints, followed along one assembly mode."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import (
    DtypeError,
    JointRangeError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    TrackingError,
    UncoupledManipulator,
    rotation_from_rpy,
)

ROBOT = UncoupledManipulator()


def degrees(yaw: float, pitch: float, roll: float) -> np.ndarray:
    yaw, pitch, roll = np.deg2rad([yaw, pitch, roll])
    return rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)


HOME = (np.array([0.25, 0.2, 1.0]), degrees(6.0, 3.0, 10.0))
GOAL = (np.array([0.2, 0.1, 1.5]), degrees(10.0, 5.0, 12.0))


def example_1(times: np.ndarray) -> np.ndarray:
    """The periodic joint values of the paper's first example."""
    sine, wave = np.sin(times), np.sin(times) * np.cos(times)
    columns = [1.0 + 0.25 * wave, 1.191 + 0.3 * wave, 0.869 + 0.2 * wave]
    columns += [0.6747 + np.pi / 18.0 * sine, 1.2609 - np.pi / 9.0 * sine**2, 1.05 + 0.25 * wave]
    return np.stack(columns, axis=-1)


def example_2(count: int) -> np.ndarray:
    """The second example: rest to rest from one pose to another by quintic polynomials."""
    share = np.linspace(0.0, 1.0, count)[:, np.newaxis]
    smooth = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    start, end = (ROBOT.inverse_displacement(*pose) for pose in (HOME, GOAL))
    return start + smooth * (end - start)


def closure(joints: np.ndarray, positions: np.ndarray, rotations: np.ndarray) -> float:
    """How far the joint values of the poses are from those asked for."""
    return float(np.max(np.abs(ROBOT.inverse_displacement(positions, rotations) - joints)))


def test_example_1() -> None:
    joints = example_1(np.linspace(0.0, 2.0 * np.pi, 400))
    positions, rotations = ROBOT.track(joints, HOME[1])
    assert positions.shape == (400, 3)
    assert rotations.shape == (400, 3, 3)
    assert closure(joints, positions, rotations) <= 1e-12
    # The joint values are periodic, and so is the motion along one mode.
    assert np.max(np.abs(rotations[-1] - rotations[0])) <= 1e-12


def test_example_2() -> None:
    joints = example_2(200)
    positions, rotations = ROBOT.track(joints, HOME[1])
    assert closure(joints, positions, rotations) <= 1e-12
    for index, (place, turn) in ((0, HOME), (-1, GOAL)):
        assert np.max(np.abs(positions[index] - place)) <= 1e-12
        assert np.max(np.abs(rotations[index] - turn)) <= 1e-12


def pose_path(rng: np.random.Generator, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A smooth path around the home pose."""
    shift, turn = 0.1 * rng.normal(size=(2, 3)), 0.1 * rng.normal(size=(2, 3))
    waves = np.stack([np.sin(times), np.sin(2.0 * times)], axis=-1)
    turns = Rotation.from_rotvec(waves @ turn) * Rotation.from_matrix(HOME[1])
    return HOME[0] + waves @ shift, turns.as_matrix()


def test_paths_come_back() -> None:
    """From poses to joints and, tracked, to the poses, where no direct factor comes near zero."""
    rng, tracked = np.random.default_rng(3), 0
    for _ in range(20):
        positions, rotations = pose_path(rng, np.linspace(0.0, 6.0, 60))
        direct = ROBOT.direct_singularity(positions, rotations)
        factors = np.stack([value for name, value in direct.factors.items() if name != "wrist"])
        if np.min(np.abs(factors)) < 0.02 or np.any(np.ptp(np.sign(factors), axis=1)):
            continue
        tracked += 1
        joints = ROBOT.inverse_displacement(positions, rotations)
        found = ROBOT.track(joints, rotations[0])
        assert np.max(np.abs(found[0] - positions)) <= 1e-14
        # Rounding of the joints, divided by the smallest factor over its scale, at least 1e-3.
        assert np.max(np.abs(found[1] - rotations)) <= 1e-11
        assert closure(joints, *found) <= 1e-12
    assert tracked >= 3


def test_sampling_does_not_matter() -> None:
    """Few samples and many follow the same mode to the same poses, by straight segments."""
    corners = example_1(np.linspace(0.0, 2.0 * np.pi, 13))
    share = np.linspace(0.0, 1.0, 40, endpoint=False)[:, np.newaxis]
    fine = [a + share * (b - a) for a, b in pairwise(corners)]
    dense = np.concatenate([*fine, corners[-1:]])
    coarse_result, dense_result = ROBOT.track(corners, HOME[1]), ROBOT.track(dense, HOME[1])
    for few, many in zip(coarse_result, dense_result, strict=True):
        assert np.max(np.abs(few - many[::40])) <= 1e-12


def test_back_and_forth() -> None:
    joints = example_2(30)
    forth = ROBOT.track(joints, HOME[1])
    back = ROBOT.track(joints[::-1], GOAL[1])
    assert np.max(np.abs(forth[1] - back[1][::-1])) <= 1e-12


def through_the_reference(count: int) -> np.ndarray:
    """Joint values from the home pose through R = I, a direct singularity, and on."""
    vector = Rotation.from_matrix(HOME[1]).as_rotvec()
    shares = np.linspace(1.0, -1.0, count)[:, np.newaxis]
    return ROBOT.inverse_displacement(HOME[0], Rotation.from_rotvec(shares * vector).as_matrix())


@pytest.mark.parametrize("count", [3, 11, 201])
def test_a_direct_singularity_is_not_crossed(count: int) -> None:
    """The middle sample is R = I, where modes meet: no way to tell them apart beyond it."""
    with pytest.raises(TrackingError, match=r"^sample \d+: ") as caught:
        ROBOT.track(through_the_reference(count), HOME[1])
    assert 1 <= caught.value.sample <= count // 2
    assert f"sample {caught.value.sample}:" in str(caught.value)


def test_a_direct_singularity_between_samples_is_not_crossed() -> None:
    """One straight segment of joint space whose middle is the singular pose."""
    start, middle, _ = through_the_reference(3)
    with pytest.raises(TrackingError, match=r"^sample 1: ") as caught:
        ROBOT.track(np.stack([start, 2.0 * middle - start]), HOME[1])
    assert caught.value.sample == 1


def test_the_reference_pose_is_singular() -> None:
    joints = ROBOT.inverse_displacement(HOME[0], np.eye(3))
    with pytest.raises(TrackingError, match=r"^sample 0: ") as caught:
        ROBOT.track(joints[np.newaxis], np.eye(3))
    assert caught.value.sample == 0


def test_guesses_at_the_start() -> None:
    """A guess leads to a pose with these joint values, or to an error: nothing in between."""
    joints = ROBOT.inverse_displacement(*HOME)[np.newaxis]
    samples, reached = [], 0
    for guess in Rotation.random(60, rng=np.random.default_rng(4)):
        try:
            positions, rotations = ROBOT.track(joints, guess)
        except TrackingError as error:
            samples.append(error.sample)
        else:
            reached += 1
            assert closure(joints, positions, rotations) <= 1e-11
    assert reached > 0
    assert set(samples) <= {0}


def test_a_guess_nearby_is_enough() -> None:
    nudge = Rotation.from_rotvec([0.02, -0.02, 0.02]).as_matrix()
    joints = ROBOT.inverse_displacement(*HOME)[np.newaxis]
    _, rotations = ROBOT.track(joints, nudge @ HOME[1])
    assert np.max(np.abs(rotations[0] - HOME[1])) <= 1e-13


def test_joint_values_without_a_pose() -> None:
    """With all q_i = 0 every n_i points to A_i; off the base plane these are not 120° apart."""
    joints = ROBOT.inverse_displacement(*HOME)
    nowhere = joints * [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]
    with pytest.raises(TrackingError, match=r"^sample 0: "):
        ROBOT.track(nowhere[np.newaxis], HOME[1])
    with pytest.raises(TrackingError, match=r"^sample 1: ") as caught:
        ROBOT.track(np.stack([joints, nowhere]), HOME[1])
    assert caught.value.sample == 1


@pytest.mark.parametrize("radius", [1e-3, 1e3])
def test_manipulators_of_other_sizes(radius: float) -> None:
    joints = example_2(20)
    joints[:, [0, 1, 2, 5]] *= radius
    positions, rotations = UncoupledManipulator(radius).track(joints, HOME[1])
    unit_positions, unit_rotations = ROBOT.track(example_2(20), HOME[1])
    assert np.max(np.abs(positions / radius - unit_positions)) <= 1e-14
    assert np.max(np.abs(rotations - unit_rotations)) <= 1e-12


def test_a_motion_of_one_sample_and_repeated_samples() -> None:
    joints = ROBOT.inverse_displacement(*HOME)
    _, alone = ROBOT.track(joints[np.newaxis], HOME[1])
    _, repeated = ROBOT.track(np.stack([joints] * 5), Rotation.from_matrix(HOME[1]))
    assert np.max(np.abs(alone - HOME[1])) <= 1e-13
    assert np.max(np.abs(repeated - HOME[1])) <= 1e-13


JOINTS = np.array([[1.0, 1.2, 0.9, 0.7, 1.2, 1.05]])


@pytest.mark.parametrize("shape", [(6,), (0, 6), (2, 1, 6), (1, 5), (1, 7)])
def test_shapes_of_motions(shape: tuple[int, ...]) -> None:
    with pytest.raises(ShapeError, match="joints: "):
        ROBOT.track(np.ones(shape), HOME[1])


@pytest.mark.parametrize(
    ("joint", "value"), [(0, -0.1), (1, -1e-9), (2, -2.0), (5, -1.0), (4, 1.6), (4, -1.6)]
)
def test_joint_ranges(joint: int, value: float) -> None:
    motion = np.repeat(JOINTS, 4, axis=0)
    motion[2:, joint] = value
    message = rf"q{joint + 1} .*; {value!r} arrived, first at pose 2; 2 of 4 poses$"
    with pytest.raises(JointRangeError, match=message) as caught:
        ROBOT.track(motion, HOME[1])
    assert caught.value.mask.tolist() == [False, False, True, True]


def test_bad_arguments() -> None:
    broken = JOINTS.copy()
    broken[0, 3] = np.nan
    arrived = r"joints: NaN or inf; \[1.0, 1.2, 0.9, nan, 1.2, 1.05\] arrived, first at pose 0"
    with pytest.raises(NotFiniteError, match=arrived):
        ROBOT.track(broken, HOME[1])
    with pytest.raises(DtypeError, match="joints: "):
        ROBOT.track(JOINTS + 0j, HOME[1])
    with pytest.raises(NotARotationError, match="rotation: not a rotation"):
        ROBOT.track(JOINTS, 2.0 * HOME[1])
    with pytest.raises(ShapeError, match=r"start_rotation: shape \(3, 3\) is needed"):
        ROBOT.track(JOINTS, HOME[1][np.newaxis])
    with pytest.raises(ShapeError, match="one radius is needed"):
        UncoupledManipulator([1.0, 2.0]).track(JOINTS, HOME[1])
