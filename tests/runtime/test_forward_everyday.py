"""The poses one tries first: level, symmetric, on an axis. Most are direct singularities."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import AssemblyModesBatch, UncoupledManipulator
from tests.runtime.modes_support import (
    Poses,
    distances,
    double_root_within,
    nearest,
    posed,
    row_of,
    statuses,
)
from tests.support import EPS

ROBOT = UncoupledManipulator()
#: A pose is found this near: at the end of a fold that is flat to the second order, rounding
#: moves it by the root of eps.
NEAR = 1e-6
DECIDED = ("regular", "merged")


def rotations(roll: np.ndarray, pitch: np.ndarray, yaw: np.ndarray) -> np.ndarray:
    angles = np.broadcast_arrays(yaw, pitch, roll)
    return Rotation.from_euler("ZYX", np.stack(angles, axis=-1)).as_matrix()


def checked(poses: Poses) -> tuple[AssemblyModesBatch, np.ndarray]:
    """The modes, and the rows that are decided: their pose is among their modes."""
    batch = ROBOT.forward_displacement_batch(poses.joints)
    names = np.array(batch.STATUS)[batch.status_codes]
    assert set(names) <= {*DECIDED, "infinite", "undecided"}
    decided = np.isin(names, DECIDED)
    assert np.max(nearest(batch, poses.rotation)[decided]) <= NEAR
    assert not np.any(batch.count[~decided])
    row = row_of(batch)
    number = np.bincount(row, weights=batch.multiplicity, minlength=len(batch))
    assert not np.any(number % 2)
    return batch, decided


def multiplicity(batch: AssemblyModesBatch, poses: Poses) -> np.ndarray:
    """How many solutions there are where the pose is."""
    near = distances(batch, poses.rotation) <= NEAR
    row, number = row_of(batch)[near], batch.multiplicity[near]
    return np.bincount(row, weights=number, minlength=len(batch)).astype(int)


def test_a_grid() -> None:
    """Round numbers for everything."""
    places = list(itertools.product((0, 0.1, 0.25, -0.2, 0.5), (0, 0.1, -0.3), (0, 0.5, 1.0, 1.3)))
    yaws = (0, 0.1, np.pi / 6, -0.4, np.pi / 2, np.pi)
    turns = np.array(list(itertools.product((0, 0.1, -0.3), (0, 0.2, -0.1), yaws)))
    position = np.repeat(np.array(places, dtype=float), len(turns), axis=0)
    rotation = np.tile(rotations(*turns.T), (len(places), 1, 1))
    poses = posed(position, rotation, least=1e-9)
    assert len(poses.joints) == 2700
    batch, decided = checked(poses)
    assert statuses(batch)["infinite"] == 0
    # Half a turn about Z with C on the line through O and A_1: B_1 is A_1 but for rounding, and
    # q_1 is 1e-16 and not zero.
    assert np.sum(~decided) <= 5
    assert np.max(poses.joints[~decided, 0], initial=0.0) <= 2.0 * EPS


def test_the_reference_orientation() -> None:
    """R = I: two modes have merged, wherever C is."""
    rng = np.random.default_rng(31)
    position = rng.normal(size=(300, 3))
    poses = posed(position, np.broadcast_to(np.eye(3), (300, 3, 3)))
    batch, decided = checked(poses)
    assert np.all(decided)
    assert statuses(batch)["merged"] == 300
    assert np.array_equal(multiplicity(batch, poses), np.full(300, 2))
    assert np.max(nearest(batch, poses.rotation)) <= 1e-9
    double = np.flatnonzero(batch.multiplicity == 2)
    for mode, row in zip(double[:50], row_of(batch)[double[:50]], strict=True):
        assert double_root_within(poses.joints[row], batch.directions[mode]) <= 8.0


@pytest.mark.parametrize("limb", [0, 1, 2])
def test_mirrored_poses(limb: int) -> None:
    """Pure pitch with C in the XZ plane, which is a plane of symmetry; and its turned copies."""
    rng = np.random.default_rng(32)
    position = rng.normal(size=(200, 3)) * [1.0, 0.0, 1.0]
    turn = Rotation.from_euler("z", 120.0 * limb, degrees=True).as_matrix()
    rotation = turn @ rotations(0.0, rng.uniform(-1.2, 1.2, 200), 0.0) @ turn.T
    poses = posed(position @ turn.T, rotation, least=1e-3)
    _, decided = checked(poses)
    assert np.mean(decided) == 1.0


@pytest.mark.parametrize("angle", ["roll", "pitch", "yaw", "any"])
def test_on_the_z_axis(angle: str) -> None:
    """C on the Z axis. There q4 says nothing, and any value is as good."""
    rng = np.random.default_rng(33)
    position = np.array([0.0, 0.0, 1.0]) * rng.uniform(0.2, 2.0, (150, 1))
    angles = rng.uniform(-1.2, 1.2, (3, 150))
    kept = {"roll": [0], "pitch": [1], "yaw": [2], "any": [0, 1, 2]}[angle]
    turns = np.zeros((3, 150))
    turns[kept] = angles[kept]
    poses = posed(position, rotations(*turns), least=1e-3)
    poses.joints[:, 3] = rng.uniform(-np.pi, np.pi, len(poses.joints))
    _, decided = checked(poses)
    assert np.all(decided)


@pytest.mark.parametrize("angle", [0, 1, 2])
def test_turns_about_one_axis(angle: int) -> None:
    rng = np.random.default_rng(34)
    turns = np.zeros((3, 300))
    turns[angle] = np.linspace(-1.4, 1.4, 300)
    poses = posed(rng.normal([0.0, 0.0, 1.0], 0.4, (300, 3)), rotations(*turns), least=1e-3)
    _, decided = checked(poses)
    assert np.all(decided)


def test_the_platform_in_the_base_plane() -> None:
    """Four solutions merge: above, below, and both ways round."""
    rng = np.random.default_rng(35)
    position = rng.normal(0.0, 0.4, (100, 3)) * [1.0, 1.0, 0.0]
    turns = rotations(0.0, 0.0, rng.uniform(-1.2, 1.2, 100))
    poses = posed(position, turns, least=1e-3)
    batch, decided = checked(poses)
    assert np.mean(decided) >= 0.98
    assert np.all(multiplicity(batch, poses)[decided] >= 4)


def test_c_in_the_base_plane() -> None:
    """c_z = 0: everything can be mirrored in the base plane."""
    rng = np.random.default_rng(36)
    position = rng.normal(0.0, 0.4, (200, 3)) * [1.0, 1.0, 0.0]
    poses = posed(position, rotations(*rng.uniform(-1.2, 1.2, (3, 200))), least=1e-3)
    batch, decided = checked(poses)
    assert np.all(decided)
    mirrored = poses.rotation * np.outer([1.0, 1.0, -1.0], [1.0, 1.0, -1.0])
    assert np.max(nearest(batch, mirrored)) <= NEAR
