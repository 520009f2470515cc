"""certify=True: the modes together with the proof that they are all."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import UncoupledManipulator
from tests.runtime.modes_support import SPREADS, poses_on_the_locus, random_joints, random_poses
from tests.runtime.test_forward_modes import PAPER, START, same
from tests.support import EPS

pytest.importorskip("flint")
ROBOT = UncoupledManipulator()


def test_the_paper() -> None:
    for tolerance in (4.0 * EPS, 0.0):
        modes = ROBOT.forward_displacement(START, tolerance=tolerance, certify=True)
        proof = modes.certificate
        assert proof.complete, proof.reason
        assert proof.real == len(modes) == 4
        assert modes.tolerance == proof.tolerance == tolerance
        assert same(ROBOT.forward_displacement(START), PAPER)


@pytest.mark.parametrize("kind", [*SPREADS, "any"])
def test_random_joint_values(kind: str) -> None:
    rng = np.random.default_rng(70)
    joints = random_joints(rng, 6) if kind == "any" else random_poses(rng, 6, kind).joints
    for row in joints:
        modes = ROBOT.forward_displacement(row, certify=True)
        proof = modes.certificate
        assert proof.complete, proof.reason
        assert modes.status in ("regular", "none")
        assert proof.real == len(modes)
        assert (proof.pairs, proof.tolerance) == (32, 4.0 * EPS)
        # Every mode in a box of its own.
        real, radii = proof.centers[proof.is_real].real, proof.radii[proof.is_real]
        own = modes.directions[:, np.newaxis, :2]
        gaps = np.minimum(*(abs(own - sign * real).max((2, 3)) for sign in (1.0, -1.0)))
        held = gaps <= radii + 1e-13
        assert np.array_equal(held.sum(axis=0), np.ones(len(modes)))
        assert np.array_equal(held.sum(axis=1), np.ones(len(modes)))


def test_the_certificate_changes_nothing_else() -> None:
    joints = random_poses(np.random.default_rng(71), 5, "workspace").joints
    for row in joints:
        plain, proven = (ROBOT.forward_displacement(row, certify=how) for how in (False, True))
        assert np.array_equal(plain.rotation, proven.rotation)
        assert plain.certificate is None


def test_a_singular_pose_has_no_proof() -> None:
    """A double root is no simple one: nothing is claimed, and what was found stays."""
    poses, _ = poses_on_the_locus(np.random.default_rng(72), 4, "workspace")
    identity = ROBOT.inverse_displacement([0.25, 0.2, 1.0], np.eye(3))
    for joints in [*poses.joints, identity]:
        modes = ROBOT.forward_displacement(joints, certify=True)
        assert not modes.certificate.complete
        assert modes.certificate.reason
        assert modes.status == "merged"
        assert np.count_nonzero(modes.multiplicity == 2) == 1
        assert np.array_equal(modes.rotation, ROBOT.forward_displacement(joints).rotation)


def test_no_pose_and_special_ones() -> None:
    modes = ROBOT.forward_displacement([9.0, 0.1, 0.1, 0.4, 1.0, 1.0], certify=True)
    assert (modes.status, len(modes), modes.certificate.real) == ("none", 0, 0)
    assert modes.certificate.complete, modes.certificate.reason
    # C on the circle of B_1: infinitely many solutions, and no proof of anything.
    infinite = [1.0, 1.0, 1.0, 0.0, np.pi / 4.0, np.sqrt(2.0)]
    for joints, status in ((infinite, "infinite"), (np.zeros(6), "merged")):
        modes = ROBOT.forward_displacement(joints, certify=True)
        assert modes.status == status
        assert not modes.certificate.complete
