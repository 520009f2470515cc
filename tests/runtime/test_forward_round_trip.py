"""100,000 random poses: each is among the modes of its joint values, and every mode holds."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import UncoupledManipulator
from tests.runtime.modes_support import SPREADS, gradients, nearest, row_of, solved, statuses
from tests.support import BASE_AXES, EPS, platform_directions

ROBOT = UncoupledManipulator()
#: What the closure equations are sums of, relative to the largest of their terms.
TERMS = 1e-12
#: Newton's method ends with a step of 1e-14.
LAST_STEP = 1e-14


def test_there_are_100000() -> None:
    assert sum(len(solved(spread)[0].joints) for spread in SPREADS) >= 100_000


@pytest.mark.parametrize("spread", SPREADS)
def test_every_pose_is_found(spread: str) -> None:
    """As close to the pose as the rounding of its joint values leaves it."""
    poses, batch = solved(spread)
    count = statuses(batch)
    assert count["regular"] + count["merged"] == len(batch), count
    n = platform_directions(poses.rotation)
    incidence = abs(np.sum(n * BASE_AXES, axis=-1))
    reach = 1.0 + np.linalg.norm(poses.position, axis=1)[:, np.newaxis]
    # Terms of F_i are products of two such lengths; the inverse of the gradients says how far
    # a change of the F_i turns the platform.
    size = (incidence * (reach + poses.joints[:, :3]) + reach) ** 2
    inverse = np.linalg.inv(gradients(poses.position, poses.rotation, poses.joints[:, :3]))
    expected = np.max(np.einsum("nij,nj->ni", abs(inverse), size), axis=1) * EPS
    distance = nearest(batch, poses.rotation)
    assert np.max(distance / (2.0 * LAST_STEP + expected)) <= 1.0
    # Above it are poses with C near the circle of a B, where that limb hardly holds anything.
    assert np.mean(distance > 1e-9) <= 1e-4


@pytest.mark.parametrize("spread", SPREADS)
def test_every_mode_satisfies_the_closure_equations(spread: str) -> None:
    """(3), (4) and (6), and that the platform is rigid."""
    _, batch = solved(spread)
    points, row = batch.platform_joints, row_of(batch)
    place, lengths = batch.position[row][:, np.newaxis], batch.joints[row, :3]
    squares, terms = np.sum(points**2, axis=-1), 1.0 + lengths**2
    assert np.max(abs(squares - terms) / (squares + terms)) <= TERMS
    in_plane = np.sum(points * BASE_AXES, axis=-1) - 1.0
    assert np.max(abs(in_plane) / (1.0 + np.sqrt(squares))) <= TERMS
    along = place + batch.extension[..., np.newaxis] * batch.directions
    assert np.max(abs(along - points).max(axis=-1) / np.sqrt(squares)) <= 4.0 * EPS
    products = np.einsum("mij,mkj->mik", batch.directions, batch.directions)
    assert np.max(abs(products - (1.5 * np.eye(3) - 0.5))) <= 16.0 * EPS
    assert np.max(abs(platform_directions(batch.rotation) - batch.directions)) <= 16.0 * EPS
    assert np.max(abs(np.linalg.det(batch.rotation) - 1.0)) <= 16.0 * EPS


@pytest.mark.parametrize("spread", SPREADS)
def test_joint_values_are_regained(spread: str) -> None:
    _, batch = solved(spread)
    row = row_of(batch)
    # At n_i·u_i = 0 the length of the leg says nothing about the direction.
    incidence = np.sum(batch.directions * BASE_AXES, axis=-1)
    plain = np.all(abs(incidence) > 1e-3, axis=1)
    assert np.mean(plain) > 0.98
    place, rotation, joints = batch.position[row], batch.rotation, batch.joints[row]
    back = ROBOT.inverse_displacement(place[plain], rotation[plain])
    lengths = [0, 1, 2, 5]
    relative = abs(back[:, lengths] / joints[plain][:, lengths] - 1.0)
    assert np.max(relative) <= 1e-9
    assert np.max(abs(back[:, 3:5] - joints[plain, 3:5])) <= 1e-12


@pytest.mark.parametrize("spread", SPREADS)
def test_number_representative_and_order(spread: str) -> None:
    _, batch = solved(spread)
    row, feasible = row_of(batch), (batch.extension > 0.0).all(axis=1)
    number = np.bincount(row, weights=batch.multiplicity, minlength=len(batch))
    assert not np.any(number % 2)
    assert np.max(number) <= 32
    assert np.array_equal(batch.feasible, feasible)
    # No e_i is zero at random: of ±n, one has two or three that are positive.
    assert np.min(np.sum(batch.extension > 0.0, axis=1)) >= 2
    angle = np.arctan2(batch.platform_joints[:, 0, 2], batch.platform_joints[:, 0, 1]) % (2 * np.pi)
    same = row[1:] == row[:-1]
    later = feasible[1:].astype(int) - feasible[:-1]
    assert np.all(later[same] <= 0)
    assert np.all((angle[1:] <= angle[:-1])[same & (later == 0)])
    # No mode is listed twice.
    apart = np.minimum(
        *(
            np.max(abs(batch.rotation[1:] - turned), axis=(1, 2))
            for turned in (batch.rotation[:-1], batch.rotation[:-1] * [-1.0, -1.0, 1.0])
        )
    )
    assert np.min(apart[same]) > 1e-8


@pytest.mark.parametrize("spread", SPREADS)
def test_determinant_of_each_mode(spread: str) -> None:
    _, batch = solved(spread)
    expected = ROBOT.direct_singularity(batch.position[row_of(batch)], batch.rotation)
    assert np.array_equal(batch.direct_determinant, expected.determinant)
