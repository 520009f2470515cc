"""Rotations against SciPy's, and at the poles of roll, pitch and yaw."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from kleinform import (
    NotARotationError,
    ShapeError,
    rotation_from_directions,
    rotation_from_rpy,
    rpy_from_rotation,
)
from tests.runtime.poses import floats, rotations
from tests.support import EPS, platform_directions

ANGLE = floats(-3.14, 3.14)
#: Entries of a rotation are products of up to three sines and sums of two of those.
ENTRIES = 8.0 * EPS


@given(ANGLE, floats(-1.57, 1.57), ANGLE)
def test_rotation_from_rpy_is_that_of_scipy(roll: float, pitch: float, yaw: float) -> None:
    ours = rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    theirs = Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_matrix()
    assert np.max(np.abs(ours - theirs)) <= ENTRIES


@given(ANGLE, floats(-1.5, 1.5), ANGLE)
def test_angles_come_back(roll: float, pitch: float, yaw: float) -> None:
    """Away from pitch ±90°: cos(pitch) >= 0.07 divides the rounding of the entries."""
    angles = rpy_from_rotation(rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw))
    assert angles == pytest.approx((roll, pitch, yaw), abs=ENTRIES / np.cos(1.5))


@given(rotations())
def test_rotations_come_back(rotation: np.ndarray) -> None:
    """In every case, also next to pitch ±90° and at it."""
    roll, pitch, yaw = rpy_from_rotation(rotation)
    assert -np.pi <= roll <= np.pi
    assert -np.pi / 2.0 <= pitch <= np.pi / 2.0
    assert -np.pi <= yaw <= np.pi
    again = rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    assert np.max(np.abs(again - rotation)) <= 4.0 * ENTRIES


@given(rotations(), st.floats(-12.0, -3.0), st.sampled_from([-1.0, 1.0]))
def test_next_to_pitch_90(rotation: np.ndarray, power: float, sign: float) -> None:
    """As close to the pole as the entries can say, the angles still give the rotation."""
    tilt = Rotation.from_euler("Y", sign * (np.pi / 2.0 - 10.0**power)).as_matrix()
    yaw = Rotation.from_euler("Z", np.arctan2(rotation[1, 0], rotation[0, 0])).as_matrix()
    turn = yaw @ tilt @ yaw.T
    angles = rpy_from_rotation(turn)
    again = rotation_from_rpy(roll=angles.roll, pitch=angles.pitch, yaw=angles.yaw)
    assert np.max(np.abs(again - turn)) <= 4.0 * ENTRIES


@pytest.mark.parametrize("sign", [-1.0, 1.0])
@pytest.mark.parametrize("turn", [0.0, 0.5, -2.0, 3.0])
def test_at_pitch_90(sign: float, turn: float) -> None:
    """R_11 = R_21 = 0 exactly: yaw is zero, roll takes the whole turn."""
    cosine, sine = np.cos(turn), np.sin(turn)
    rotation = np.array([[0.0, sine, sign * cosine], [0.0, cosine, -sign * sine], [-sign, 0, 0]])
    assert np.linalg.det(rotation) == pytest.approx(1.0)
    angles = rpy_from_rotation(rotation)
    assert angles.yaw == 0.0
    assert angles.pitch == sign * np.pi / 2.0
    again = rotation_from_rpy(roll=angles.roll, pitch=angles.pitch, yaw=angles.yaw)
    assert np.max(np.abs(again - rotation)) <= ENTRIES


def test_ranges_at_half_a_turn() -> None:
    """−π is not given for angles: the range is (−π, π]."""
    for axis in range(3):
        angles = rpy_from_rotation(np.diag(2.0 * np.eye(3)[axis] - 1.0))
        assert min(angles.roll, angles.yaw) > -np.pi


def test_rpy_broadcasts() -> None:
    roll, pitch, yaw = np.zeros(4), np.linspace(-1.0, 1.0, 3)[:, np.newaxis], 0.25
    table = rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    assert table.shape == (3, 4, 3, 3)
    angles = rpy_from_rotation(table)
    assert angles.pitch.shape == (3, 4)
    assert np.allclose(angles.pitch, pitch, rtol=0.0, atol=ENTRIES)
    with pytest.raises(ShapeError, match=r"do not broadcast: roll \(4,\), pitch \(3,\)"):
        rotation_from_rpy(roll=roll, pitch=np.zeros(3), yaw=yaw)


def test_single_angles_are_numbers() -> None:
    angles = rpy_from_rotation(np.eye(3))
    assert all(isinstance(angle, np.float64) for angle in angles)
    assert rotation_from_rpy(roll=0, pitch=0, yaw=0).tolist() == np.eye(3).tolist()


@given(rotations())
def test_rotation_from_directions(rotation: np.ndarray) -> None:
    n1, n2, _ = platform_directions(rotation)
    assert np.max(np.abs(rotation_from_directions(n1, n2) - rotation)) <= ENTRIES


def test_rotation_from_directions_is_a_rotation() -> None:
    """Columns 2 and 3 of the printed (8) have norm √3/2; ours are unit vectors."""
    rng = np.random.default_rng(4)
    turns = Rotation.random(50, rng=rng).as_matrix()
    n1, n2 = np.moveaxis(platform_directions(turns)[:, :2], 1, 0)
    result = rotation_from_directions(n1, n2)
    assert result.shape == (50, 3, 3)
    gram = np.swapaxes(result, -1, -2) @ result
    assert np.max(np.abs(gram - np.eye(3))) <= ENTRIES
    assert np.linalg.det(result) == pytest.approx(np.ones(50), abs=ENTRIES)


@pytest.mark.parametrize(
    ("n1", "n2"),
    [
        ([1, 0, 0], [0, 1, 0]),
        ([1, 0, 0], [1, 0, 0]),
        ([2, 0, 0], [-0.5, np.sqrt(0.75), 0]),
        ([1, 0, 0], [-0.5, 0.866, 0]),
        ([0, 0, 0], [0, 0, 0]),
        ([1, 0, 0], [-1, np.sqrt(3.0), 0]),
    ],
)
def test_directions_that_are_not_120_degrees_apart(n1: list[float], n2: list[float]) -> None:
    with pytest.raises(NotARotationError, match=r"not unit vectors 120° apart.*arrived"):
        rotation_from_directions(n1, n2)
    assert np.isnan(rotation_from_directions(n1, n2, errors="nan")).all()


@given(rotations())
def test_matrices_of_scipy_are_accepted_as_they_are(rotation: np.ndarray) -> None:
    turn = Rotation.from_matrix(rotation)
    assert rpy_from_rotation(turn) == rpy_from_rotation(turn.as_matrix())
