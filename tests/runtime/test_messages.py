"""What an error says of a batch: the first offending pose, whatever rule it broke."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import kleinform

ROBOT = kleinform.UncoupledManipulator()
POSITION = np.array([0.25, 0.2, 1.0])
TURN = kleinform.rotation_from_rpy(roll=0.2, pitch=0.1, yaw=0.3)
QUARTER = kleinform.rotation_from_rpy(roll=0.0, pitch=0.0, yaw=np.pi / 2.0)


def for_limb_2(rotation: np.ndarray) -> np.ndarray:
    """The rotation that limb 2 meets as limb 1 meets the given one."""
    third = kleinform.rotation_from_rpy(roll=0.0, pitch=0.0, yaw=2.0 * np.pi / 3.0)
    return third @ rotation @ third.T


def test_two_rules_are_one_error_of_the_first_pose() -> None:
    pitched = kleinform.rotation_from_rpy(roll=0.0, pitch=np.pi / 2.0, yaw=0.0)
    rotations = np.stack([TURN, for_limb_2(pitched), TURN, pitched])
    expected = r"^n_2·u_2 = 0, .*, first at pose 1; 2 of 4 poses$"
    with pytest.raises(kleinform.SingularPoseError, match=expected) as caught:
        ROBOT.inverse_displacement(POSITION, rotations)
    np.testing.assert_array_equal(caught.value.mask, [False, True, False, True])


def test_the_error_type_is_that_of_the_first_pose() -> None:
    positions = np.stack([POSITION, POSITION, [np.nan, 0.0, 1.0]])
    rotations = np.stack([TURN, 2.0 * TURN, TURN])
    with pytest.raises(kleinform.NotARotationError, match=r"first at pose 1; 2 of 3 poses$"):
        ROBOT.survey(positions, rotations)


def test_a_masked_array_is_refused() -> None:
    masked = np.ma.array([POSITION, [9.0, 9.0, 9.0]], mask=[[0, 0, 0], [1, 1, 1]])
    with pytest.raises(kleinform.DtypeError, match=r"^position: .*masked array arrived"):
        ROBOT.inverse_displacement(masked, TURN)


def test_the_radius_stays_as_it_was_checked() -> None:
    radii = np.array([1.0, 2.0])
    robot = kleinform.UncoupledManipulator(radii)
    radii[0] = -1.0
    assert robot.radius.tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="read-only"):
        robot.radius[0] = -1.0
    with pytest.raises(AttributeError):
        robot.radius = -1.0


def test_a_tracking_error_survives_another_process() -> None:
    error = pickle.loads(pickle.dumps(kleinform.TrackingError("stopped", sample=3)))
    assert (str(error), error.sample) == ("stopped", 3)


def test_a_limb_that_is_singular_at_finite_joint_values_is_named() -> None:
    """n_1·u_1 = 0 = a − c·u_1: the Klein form of limb 1 is 0/0, and so is e_1."""
    upright = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
    survey = ROBOT.survey([1.0, 0.2, 0.5], upright)
    undefined = {name for name, where in survey.undefined().items() if where}
    assert undefined == {"limb_1", "extension_1", "orientation"}


def test_a_leg_of_no_length_is_named() -> None:
    """q_1 = 0: B_1 at A_1."""
    turn = kleinform.rotation_from_rpy(roll=0.3, pitch=0.0, yaw=0.0)
    undefined = ROBOT.inverse_singularity([0.25, 0.0, 0.0], turn).undefined()
    assert [name for name, where in undefined.items() if where] == ["limb_1"]


def test_blanked_rows_are_not_undefined() -> None:
    survey = ROBOT.survey([POSITION, [np.nan, 0.0, 1.0]], TURN, errors="nan")
    np.testing.assert_array_equal(survey.valid, [True, False])
    assert not any(where.any() for where in survey.undefined().values())
