"""Modes close together on purpose, and merged ones: none is lost, none is counted twice."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from kleinform import AssemblyModesBatch, UncoupledManipulator
from tests.runtime.modes_support import (
    SPREADS,
    Poses,
    distances,
    double_root_within,
    nearest,
    poses_on_the_locus,
    rounded_joints,
    row_of,
    statuses,
    turned,
)

ROBOT = UncoupledManipulator()
#: For each distance of two modes, and each of three distributions.
COUNT = 167
#: The tolerance of the joint values, in eps.
HIDDEN = 4.0


@cache
def pairs_apart(distance: float, spread: str) -> tuple[Poses, np.ndarray]:
    """Poses half of the distance from a fold, and their joint values, rounded once."""
    seed = SPREADS.index(spread)
    fold, free = poses_on_the_locus(np.random.default_rng(seed), COUNT, spread)
    half = 0.5 * distance * free
    poses = fold._replace(rotation=turned(fold.rotation, half))
    return poses, rounded_joints(poses)


def beside(
    batch: AssemblyModesBatch, poses: Poses, distance: float
) -> tuple[np.ndarray, np.ndarray]:
    """The modes about one distance from the pose, and how many solutions merge in them."""
    close = distances(batch, poses.rotation) < max(3.0 * distance, 1e-6)
    row, number = row_of(batch)[close], batch.multiplicity[close]
    modes = np.bincount(row, minlength=len(batch))
    solutions = np.bincount(row, weights=number, minlength=len(batch))
    return modes, solutions.astype(int)


@pytest.mark.parametrize("tolerance", [None, 0.0])
@pytest.mark.parametrize("spread", SPREADS)
@pytest.mark.parametrize("distance", [1e-3, 1e-5])
def test_modes_apart(distance: float, spread: str, tolerance: float | None) -> None:
    """Two simple modes, and the pose is one of them."""
    poses, joints = pairs_apart(distance, spread)
    given = {} if tolerance is None else {"tolerance": tolerance}
    batch = ROBOT.forward_displacement_batch(joints, **given)
    modes, solutions = beside(batch, poses, distance)
    assert statuses(batch)["regular"] == COUNT
    # A third mode may be there by chance, and then a fourth.
    assert np.min(modes) == 2
    assert np.mean(modes == 2) > 0.97
    assert np.array_equal(modes, solutions)
    # Rounding of the joint values moves a mode by eps over its distance from the fold.
    assert np.max(nearest(batch, poses.rotation)) <= 1e-13 / distance


@pytest.mark.parametrize("spread", SPREADS)
def test_modes_at_the_limit_of_float64(spread: str) -> None:
    """Two modes or one that counts twice, and that one with a reason, found in 30 digits."""
    distance = 1e-7
    poses, joints = pairs_apart(distance, spread)
    batch = ROBOT.forward_displacement_batch(joints)
    modes, solutions = beside(batch, poses, distance)
    count = statuses(batch)
    assert count["regular"] + count["merged"] == COUNT
    assert np.all(solutions == 2)
    # Both happen: the distance is where rounding begins to hide it.
    assert 0 < np.sum(modes == 1) < COUNT
    double = np.flatnonzero(batch.multiplicity == 2)
    for mode, row in zip(double, row_of(batch)[double], strict=True):
        assert double_root_within(joints[row], batch.directions[mode]) <= HIDDEN
    # Two modes that are listed are on both sides of the fold.
    assert np.max(nearest(batch, poses.rotation)) <= distance


@pytest.mark.parametrize("spread", SPREADS)
def test_modes_that_have_merged(spread: str) -> None:
    poses, joints = pairs_apart(0.0, spread)
    batch = ROBOT.forward_displacement_batch(joints)
    modes, solutions = beside(batch, poses, 0.0)
    assert statuses(batch)["merged"] == COUNT
    assert np.all(modes == 1)
    assert np.all(solutions == 2)
    # The place of a fold is sharp, though its two modes are not.
    assert np.max(nearest(batch, poses.rotation)) <= 1e-12
    double = np.flatnonzero(batch.multiplicity == 2)
    for mode, row in zip(double, row_of(batch)[double], strict=True):
        assert double_root_within(joints[row], batch.directions[mode]) <= HIDDEN


@pytest.mark.parametrize("spread", SPREADS)
def test_without_a_tolerance_nothing_is_merged(spread: str) -> None:
    """Joint values that count as exact: a double root is what rounding cannot tell."""
    poses, joints = pairs_apart(0.0, spread)
    poses, joints = Poses(*(entry[:30] for entry in poses)), joints[:30]
    batch = ROBOT.forward_displacement_batch(joints, tolerance=0.0)
    assert np.all(batch.multiplicity == 1)
    assert statuses(batch)["merged"] == 0
    undecided = np.array([batch.STATUS[code] == "undecided" for code in batch.status_codes])
    # Where it is decided, both or none.
    modes, _ = beside(batch, poses, 0.0)
    assert set(modes[~undecided]) <= {0, 2}
    assert not np.any(batch.count[undecided])


@pytest.mark.parametrize("spread", SPREADS)
def test_a_wide_tolerance_merges_more(spread: str) -> None:
    """Modes 1e-5 apart have joint values in common within 1e-9, not within 1e-13."""
    poses, joints = pairs_apart(1e-5, spread)
    wide = ROBOT.forward_displacement_batch(joints, tolerance=1e-9)
    modes, solutions = beside(wide, poses, 1e-5)
    assert np.all(solutions == 2)
    # A fold of which the parabola is steep, and which the joint values hardly move, stays two.
    assert np.mean(modes == 1) >= 0.99
    assert wide.tolerance == 1e-9
