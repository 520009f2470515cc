"""Quaternions, 4×4 matrices and rounded rotations against SciPy, and the errors that name them."""

from __future__ import annotations

import doctest

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import RigidTransform, Rotation

import kleinform
from kleinform import (
    DtypeError,
    InputError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    UncoupledManipulator,
    conversions,
    nearest_rotation,
    pose_from_matrix,
    rotation_from_quaternion,
)
from tests.runtime.poses import floats, rotations
from tests.support import EPS, many

ROBOT = UncoupledManipulator()
PLACE = np.array([0.25, 0.2, 1.0])
ENTRIES = 8.0 * EPS
QUATERNION = st.tuples(*(floats(-1.0, 1.0) for _ in range(4))).filter(any)


def matrix_of(position: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """``[[R, c], [0, 1]]``, for batches too."""
    matrix = np.zeros((*rotation.shape[:-2], 4, 4))
    matrix[..., :3, :3], matrix[..., :3, 3], matrix[..., 3, 3] = rotation, position, 1.0
    return matrix


@given(QUATERNION, st.floats(-90.0, 90.0))
def test_quaternions_are_those_of_scipy(quaternion: tuple[float, ...], power: float) -> None:
    """In both orders, and of any length."""
    q = np.array(quaternion)
    theirs = Rotation.from_quat(q / np.linalg.norm(q / abs(q).max()) / abs(q).max()).as_matrix()
    for length in (1.0, 10.0**power, -1.0):
        if abs(length * q).max() < 1e-300:
            continue
        ours = rotation_from_quaternion(length * q)
        assert np.max(np.abs(ours - theirs)) <= ENTRIES
        first = rotation_from_quaternion(length * np.roll(q, 1), scalar_first=True)
        np.testing.assert_array_equal(first, ours)
    ROBOT.survey(PLACE, ours)


def test_batches_of_quaternions() -> None:
    turns = Rotation.random(60, rng=np.random.default_rng(1))
    q = turns.as_quat().reshape(3, 20, 4)
    found = rotation_from_quaternion(q)
    assert found.shape == (3, 20, 3, 3)
    assert np.max(np.abs(found.reshape(-1, 3, 3) - turns.as_matrix())) <= ENTRIES
    each = [rotation_from_quaternion(row) for row in q.reshape(-1, 4)]
    np.testing.assert_array_equal(found.reshape(-1, 3, 3), each)
    assert rotation_from_quaternion([0, 0, 0, 2]).tolist() == np.eye(3).tolist()
    assert rotation_from_quaternion(np.zeros((0, 4))).shape == (0, 3, 3)


@pytest.mark.parametrize(
    ("quaternion", "error", "message"),
    [
        ([0, 0, 0, 0], NotARotationError, "quaternion: zero is no rotation"),
        ([0, 0, np.nan, 1], NotFiniteError, "quaternion: NaN or inf"),
        ([0, 0, np.inf, 1], NotFiniteError, "quaternion: NaN or inf"),
        ([0, 0, 1e200, 1], InputError, "quaternion: above 1e[+]100"),
        ([0, 0, 1], ShapeError, r"quaternion: shape \(..., 4\) is needed, \(3,\) arrived"),
        (np.eye(3), ShapeError, r"quaternion: shape \(..., 4\) is needed"),
        ([0, 0, 1j, 1], DtypeError, "quaternion: real numbers"),
        ([True, False, False, False], DtypeError, "quaternion: real numbers"),
    ],
)
def test_bad_quaternions(quaternion, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=f"^{message}"):
        rotation_from_quaternion(quaternion)
    if not issubclass(error, (ShapeError, DtypeError)):
        batch = np.array([[0, 0, 0, 1], quaternion, [1, 0, 0, 0]])
        with pytest.raises(error, match="first at pose 1; 1 of 3"):
            rotation_from_quaternion(batch)
        found = rotation_from_quaternion(batch, errors="nan")
        assert np.isnan(found[1]).all()
        np.testing.assert_array_equal(found[[0, 2]], rotation_from_quaternion(batch[[0, 2]]))


@given(rotations(), st.lists(floats(-2.0, 2.0), min_size=3, max_size=3))
def test_poses_of_matrices(rotation: np.ndarray, position: list[float]) -> None:
    matrix = matrix_of(np.array(position), rotation)
    pose = pose_from_matrix(matrix)
    np.testing.assert_array_equal(pose.position, position)
    np.testing.assert_array_equal(pose.rotation, rotation)
    theirs = RigidTransform.from_matrix(matrix)
    place, turn = pose_from_matrix(theirs)
    assert np.max(np.abs(turn - theirs.rotation.as_matrix())) <= ENTRIES
    np.testing.assert_array_equal(place, theirs.translation)


def test_batches_of_matrices() -> None:
    rng = np.random.default_rng(2)
    turns = Rotation.random(6, rng=rng).as_matrix().reshape(2, 3, 3, 3)
    places = rng.uniform(0.2, 1.0, (2, 3, 3))
    matrix = matrix_of(places, turns)
    place, turn = pose_from_matrix(matrix)
    assert (place.shape, turn.shape) == ((2, 3, 3), (2, 3, 3, 3))
    joints = ROBOT.inverse_displacement(*pose_from_matrix(matrix))
    np.testing.assert_array_equal(joints, ROBOT.inverse_displacement(places, turns))
    place[:] = 0.0
    assert matrix[0, 0, 0, 3] == places[0, 0, 0]
    single = pose_from_matrix(matrix.astype(np.float32)).rotation
    assert np.max(np.abs(single - turns)) < 1e-6


def change(row: int, column: int, value: float) -> np.ndarray:
    matrix = matrix_of(PLACE, np.eye(3))
    matrix[row, column] = value
    return matrix


@pytest.mark.parametrize(
    ("matrix", "error", "message"),
    [
        (matrix_of(PLACE, np.eye(3)).T, InputError, r"matrix: the last row must be \(0, 0, 0, 1\)"),
        (change(3, 3, 0.0), InputError, r"matrix: the last row .*; 1.0 arrived"),
        (change(3, 0, 1e-8), InputError, "matrix: the last row"),
        (change(0, 0, 2.0), NotARotationError, "matrix: not a rotation"),
        (change(0, 0, -1.0), NotARotationError, "matrix: not a rotation"),
        (change(0, 0, 1.0 + 1e-6), NotARotationError, "matrix: .*kleinform.nearest_rotation"),
        (change(0, 3, np.nan), NotFiniteError, "matrix: NaN or inf"),
        (change(3, 1, np.inf), NotFiniteError, "matrix: NaN or inf"),
        (np.eye(3), ShapeError, r"matrix: shape \(..., 4, 4\) is needed, \(3, 3\) arrived"),
        (np.eye(4, dtype=bool), DtypeError, "matrix: real numbers"),
    ],
)
def test_bad_matrices(matrix: np.ndarray, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=f"^{message}"):
        pose_from_matrix(matrix)
    if not issubclass(error, (ShapeError, DtypeError)):
        batch = np.array([np.eye(4), matrix])
        place, turn = pose_from_matrix(batch, errors="nan")
        assert np.isnan(place[1]).all()
        assert np.isnan(turn[1]).all()
        np.testing.assert_array_equal(turn[0], np.eye(3))


def test_a_rotation_is_nearest_to_itself() -> None:
    turns = Rotation.random(200, rng=np.random.default_rng(3)).as_matrix()
    assert np.max(np.abs(nearest_rotation(turns) - turns)) <= ENTRIES
    assert np.max(np.abs(nearest_rotation(Rotation.from_matrix(turns)) - turns)) <= ENTRIES


@given(rotations(), st.integers(1, 12))
def test_rounded_rotations(rotation: np.ndarray, digits: int) -> None:
    """Their nearest rotation is no farther away than they are, and is taken by the robot."""
    rounded = rotation.round(digits)
    found = nearest_rotation(rounded)
    assert np.linalg.norm(found - rounded) <= np.linalg.norm(rotation - rounded) + ENTRIES
    ROBOT.survey(PLACE, found)
    theirs, _ = Rotation.align_vectors(rounded.T, np.eye(3))
    assert np.max(np.abs(found - theirs.as_matrix())) <= 2.0 * ENTRIES


@pytest.mark.long
def test_no_rotation_is_nearer() -> None:
    """Among random ones and near ones."""
    rng = np.random.default_rng(6)
    for _ in range(many(200, 20_000)):
        matrix = rng.normal(size=(3, 3)) * 10.0 ** rng.uniform(-3.0, 3.0)
        if np.linalg.det(matrix) <= 0.0:
            matrix[0] = -matrix[0]
        found = nearest_rotation(matrix)
        spread = rng.choice([1e-4, 1e-2, 1.0])
        others = Rotation.from_rotvec(rng.normal(size=(50, 3)) * spread).as_matrix() @ found
        least = np.linalg.norm(others - matrix, axis=(1, 2)).min()
        assert np.linalg.norm(found - matrix) <= least * (1.0 + 4.0 * EPS)


def test_batches_of_rounded_rotations() -> None:
    turns = Rotation.random(24, rng=np.random.default_rng(3)).as_matrix().round(3)
    found = nearest_rotation(turns.reshape(4, 6, 3, 3))
    assert found.shape == (4, 6, 3, 3)
    np.testing.assert_array_equal(found.reshape(-1, 3, 3), [nearest_rotation(r) for r in turns])


@pytest.mark.parametrize(
    ("matrix", "error", "message"),
    [
        (np.diag([1.0, 1.0, -1.0]), NotARotationError, "matrix: a reflection"),
        (-np.eye(3) * 1e-60, NotARotationError, "matrix: a reflection"),
        (np.zeros((3, 3)), NotARotationError, "matrix: singular; 0.0 arrived"),
        (np.diag([1.0, 1.0, 0.0]), NotARotationError, "matrix: singular"),
        (np.arange(9.0).reshape(3, 3), NotARotationError, "matrix: singular"),
        (np.diag([1.0, np.nan, 1.0]), NotFiniteError, "matrix: NaN or inf"),
        (np.eye(4), ShapeError, "matrix: shape .*kleinform.pose_from_matrix"),
        (np.eye(3, dtype=complex), DtypeError, "matrix: real numbers"),
    ],
)
def test_what_has_no_nearest_rotation(
    matrix: np.ndarray, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=f"^{message}"):
        nearest_rotation(matrix)
    if not issubclass(error, (ShapeError, DtypeError)):
        found = nearest_rotation(np.array([np.eye(3), matrix]), errors="nan")
        assert np.isnan(found[1]).all()
        np.testing.assert_array_equal(found[0], np.eye(3))


CALLS = {
    "survey": lambda rotation: ROBOT.survey(PLACE, rotation),
    "inverse": lambda rotation: ROBOT.inverse_displacement(PLACE, rotation),
    "classify": lambda rotation: ROBOT.classify(PLACE, rotation),
    "track": lambda rotation: ROBOT.track(np.ones((2, 6)), rotation),
    "rpy": kleinform.rpy_from_rotation,
    "locus": lambda rotation: kleinform.maps.direct_locus(ROBOT, rotation),
}


@pytest.mark.parametrize("call", CALLS)
def test_errors_name_the_helper(call: str) -> None:
    """Where the shape or the defect says what arrived, and only there."""
    turn = Rotation.from_euler("ZYX", [0.1, 0.05, 0.17])
    helpers = {
        "rotation_from_quaternion": turn.as_quat(),
        "pose_from_matrix": matrix_of(PLACE, turn.as_matrix()),
        "nearest_rotation": turn.as_matrix().round(6),
        None: 2.0 * turn.as_matrix(),
        "": -turn.as_matrix(),
        " ": np.ones(3),
    }
    for helper, arrived in helpers.items():
        with pytest.raises(InputError) as caught:
            CALLS[call](arrived)
        named = str(caught.value).partition("kleinform.")[2]
        assert named.startswith(helper) if helper and helper.strip() else not named


@pytest.mark.long
def test_defects_of_rounded_rotations_name_the_helper() -> None:
    """Two to eight digits; and matrices that are no rotation at all do not."""
    rng = np.random.default_rng(5)
    for _ in range(many(100, 5_000)):
        turn = Rotation.random(rng=rng).as_matrix()
        for digits in range(3, 9):
            rounded = turn.round(digits)
            with pytest.raises(NotARotationError, match=r"a rounded one\? kleinform\.nearest_rot"):
                ROBOT.survey(PLACE, rounded)
        with pytest.raises(NotARotationError) as caught:
            ROBOT.survey(PLACE, turn + rng.uniform(0.1, 1.0) * np.eye(3)[rng.permutation(3)])
        assert "nearest" not in str(caught.value)


def test_the_examples() -> None:
    found = doctest.testmod(conversions, extraglobs={"kleinform": kleinform})
    assert found.attempted >= 4
    assert found.failed == 0
