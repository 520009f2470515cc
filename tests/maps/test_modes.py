"""The number of assembly modes over sections, and where it changes."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import InputError, NotFiniteError, SingularPoseError, UncoupledManipulator
from kleinform.maps.modes import conditioning, joint_map, workspace_map
from kleinform.rotations import rotation_from_rpy

ROBOT = UncoupledManipulator()
ROLL, PITCH, YAW = np.deg2rad([10.0, 3.0, 6.0])
ROTATION = rotation_from_rpy(roll=ROLL, pitch=PITCH, yaw=YAW)
POSITION = np.array([0.25, 0.2, 1.0])
JOINTS = ROBOT.inverse_displacement(POSITION, ROTATION)


@pytest.fixture(scope="module")
def over_joints():
    return joint_map(ROBOT, JOINTS, ("q1", "q2"), ((0.5, 1.8), (0.5, 1.8)), 41)


def test_counts_are_those_of_the_forward_displacement(over_joints) -> None:
    assert over_joints.counts.shape == (41, 41)
    for i, j in ((0, 0), (20, 20), (40, 40), (40, 3), (7, 31)):
        joints = JOINTS.copy()
        joints[:2] = over_joints.first[i], over_joints.second[j]
        assert over_joints.counts[i, j] == len(ROBOT.forward_displacement(joints))
    assert set(np.unique(over_joints.counts)) >= {0, 2, 4, 6, 8}


def test_modes_merge_on_the_curves(over_joints) -> None:
    """A step to either side of a point, along its edge of the grid, the number differs."""
    step = 2.0 * (over_joints.first[1] - over_joints.first[0]) / 2.0**16
    assert len(over_joints.curves) > 100
    for point in over_joints.curves[::17]:
        numbers = set()
        for side in (-step, 0.0, step):
            for along in np.eye(2):
                joints = JOINTS.copy()
                joints[:2] = point + side * along
                numbers.add(len(ROBOT.forward_displacement(joints)))
        assert len(numbers) >= 2


def test_each_segment_lies_in_one_cell(over_joints) -> None:
    width = over_joints.first[1] - over_joints.first[0]
    assert len(over_joints.segments) > 50
    assert abs(over_joints.segments[:, 0] - over_joints.segments[:, 1]).max() <= 1.001 * width


def test_over_the_workspace_poses_have_modes(over_joints) -> None:
    found = workspace_map(ROBOT, ROTATION, 1.0, ((-0.5, 0.5), (-0.4, 0.6)), 21)
    assert (found.counts >= 1).all()
    i, j = 15, 12
    place = [found.first[i], found.second[j], 1.0]
    modes = ROBOT.forward_displacement(ROBOT.inverse_displacement(place, ROTATION))
    assert found.counts[i, j] == len(modes)


def test_conditioning_is_that_of_the_moments() -> None:
    rng = np.random.default_rng(0)
    positions = POSITION + 0.2 * rng.normal(size=(20, 3))
    values = conditioning(ROBOT, positions, ROTATION)
    assert values.shape == (20, 3)
    assert (np.diff(values, axis=1) <= 0.0).all()
    survey = ROBOT.survey(positions, ROTATION)
    determinant = ROBOT.direct_singularity(positions, ROTATION).determinant
    moments = abs(determinant / survey.factors["wrist"])
    np.testing.assert_allclose(values.prod(axis=1), moments, rtol=1e-12)


def test_conditioning_where_modes_meet() -> None:
    assert conditioning(ROBOT, POSITION, np.eye(3))[2] <= 1e-15


def test_conditioning_refuses_or_blanks() -> None:
    sideways = rotation_from_rpy(roll=0.3, pitch=0.0, yaw=np.pi / 2.0)
    with pytest.raises(SingularPoseError, match="n_1·u_1 = 0"):
        conditioning(ROBOT, POSITION, sideways)
    both = conditioning(ROBOT, POSITION, np.stack([ROTATION, sideways]), errors="nan")
    assert np.isfinite(both[0]).all()
    assert np.isnan(both[1]).all()


def test_what_is_asked_wrongly() -> None:
    unit = ((0.5, 1.0), (0.5, 1.0))
    for axes in (("q1", "q1"), ("q1", "q7"), ("q1",), ("q1", "q2", "q1"), ("q1", ["q2"])):
        with pytest.raises(InputError, match=r"^axes: "):
            joint_map(ROBOT, JOINTS, axes, unit, 3)
    with pytest.raises(InputError, match=r"^ranges: "):
        joint_map(ROBOT, JOINTS, ("q1", "q2"), ((1.0, 0.5), (0.5, 1.0)), 3)
    for resolution in (1, 5.5, "5", True):
        with pytest.raises(InputError, match=r"^resolution: "):
            joint_map(ROBOT, JOINTS, ("q1", "q2"), unit, resolution)
    for ranges in (unit[:1], ((0.5, np.inf), unit[1]), ((0.5, 0.7, 0.9), unit[1])):
        with pytest.raises(InputError, match=r"^ranges: "):
            joint_map(ROBOT, JOINTS, ("q1", "q2"), ranges, 3)
    with pytest.raises(InputError, match=r"^joints: "):
        joint_map(ROBOT, [JOINTS, JOINTS], ("q1", "q2"), unit, 3)
    with pytest.raises(InputError, match=r"^height: "):
        workspace_map(ROBOT, ROTATION, [1.0, 2.0], unit, 3)
    with pytest.raises(NotFiniteError):
        joint_map(ROBOT, JOINTS * np.nan, ("q1", "q2"), unit, 3)
    with pytest.raises(InputError, match="q1 >= 0"):
        joint_map(ROBOT, JOINTS, ("q1", "q2"), ((-1.0, 0.5), (0.5, 1.0)), 3)
