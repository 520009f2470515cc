"""Modes that can be joined without a singularity, and modes that cannot."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import InputError, UncoupledManipulator, rotation_from_rpy
from kleinform.maps.joining import join_modes
from kleinform.maps.turning import signs_stay

ROBOT = UncoupledManipulator()


def modes_at(position, roll: float, pitch: float, yaw: float, robot=ROBOT):
    roll, pitch, yaw = np.deg2rad([roll, pitch, yaw])
    rotation = rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    return robot.forward_displacement(robot.inverse_displacement(position, rotation))


@pytest.fixture(scope="module")
def many():
    """Twelve modes, six of them feasible."""
    return modes_at([0.1, -0.2, 1.2], 20.0, -35.0, 40.0)


def test_feasible_modes_are_joined_by_one_turn(many) -> None:
    found = join_modes(ROBOT, many, 1, 5)
    assert found
    assert many.feasible[[1, 5]].all()
    assert np.array_equal(found.rotations, many.rotation[[1, 5]])
    assert found.least["orientation"] >= 1.0
    assert found.least["extension"] >= 1.0
    assert found.proven()


def test_the_way_is_a_motion_that_meets_nothing(many) -> None:
    """From joint values back to the same joint values, in another mode."""
    motion = join_modes(ROBOT, many, 1, 5).motion(2.0)
    watched = ROBOT.watch(motion, 201)
    assert watched.first is None
    assert abs(watched.joints[[0, -1]] - many.joints).max() <= 1e-14
    joints = ROBOT.inverse_motion(motion.sampled(201))
    followed = ROBOT.track(joints.joints, many.rotation[1])[1]
    assert abs(followed[-1] - many.rotation[5]).max() <= 1e-12
    assert abs(many.rotation[1] - many.rotation[5]).max() >= 0.1


def test_the_motion_turns_as_its_twist_says(many) -> None:
    motion, step = join_modes(ROBOT, many, 0, 4).motion(3.0), 1e-6
    times = np.linspace(0.05, 2.95, 24)
    before, here, after = (motion.at(times + shift) for shift in (-step, 0.0, step))
    change = (after.rotations - before.rotations) / (2.0 * step)
    spin = change @ here.rotations.swapaxes(1, 2)
    omega = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    assert abs(omega - here.twists[:, :3]).max() <= 1e-7


def test_a_way_through_other_orientations(many) -> None:
    found = join_modes(ROBOT, many, 0, 4)
    assert len(found.rotations) > 2
    assert "through" in found.reason
    assert found.proven()


def test_the_modes_of_table_1_cannot_be_joined() -> None:
    """Each pair differs in a sign that only a singularity changes."""
    modes = modes_at([0.25, 0.2, 1.0], 10.0, 3.0, 6.0)
    for first in range(4):
        for second in range(first):
            found = join_modes(ROBOT, modes, first, second)
            assert not found
            assert "no way exists" in found.reason
            with pytest.raises(InputError, match="there is no way"):
                found.motion()
            with pytest.raises(InputError, match="there is no way"):
                found.proven()


def test_a_turn_through_a_singularity_is_not_proven() -> None:
    modes = modes_at([0.25, 0.2, 1.0], 10.0, 3.0, 6.0)
    assert not signs_stay(1.0, modes.position, modes.rotation[0], modes.rotation[1])


def test_a_singular_mode_is_not_joined() -> None:
    joints = ROBOT.inverse_displacement([0.25, 0.2, 1.0], np.eye(3))
    modes = ROBOT.forward_displacement(joints)
    assert modes.multiplicity.tolist() == [2, 1, 1]
    found = join_modes(ROBOT, modes, 1, 0)
    assert not found
    assert "singular" in found.reason


@pytest.mark.parametrize("radius", [1e-3, 1e3])
def test_the_size_does_not_matter(radius: float) -> None:
    robot = UncoupledManipulator(radius)
    modes = modes_at(radius * np.array([0.1, -0.2, 1.2]), 20.0, -35.0, 40.0, robot)
    found = join_modes(robot, modes, 1, 5)
    assert found.proven()
    assert found.least["orientation"] >= 1.0 * radius**3


def test_a_mode_is_joined_to_itself(many) -> None:
    found = join_modes(ROBOT, many, 1, 1)
    assert found.proven()
    assert ROBOT.watch(found.motion(), 5).first is None


def test_another_robot_is_refused(many) -> None:
    for radius in (2.0, [1.0, 2.0]):
        with pytest.raises(InputError, match="radius"):
            join_modes(UncoupledManipulator(radius), many, 1, 5)


@pytest.mark.parametrize("duration", [0.0, -1.0, np.nan, np.inf])
def test_a_motion_takes_time(many, duration: float) -> None:
    with pytest.raises(InputError, match=r"^start < end"):
        join_modes(ROBOT, many, 1, 5).motion(duration)


@pytest.mark.parametrize("pair", [(0, 12), (-1, 0), ("a", 0), (0, 1.0), (0, True)])
def test_numbers_that_are_no_modes(many, pair) -> None:
    with pytest.raises(InputError, match="12 modes"):
        join_modes(ROBOT, many, *pair)
