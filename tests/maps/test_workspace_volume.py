"""Proven volumes: known ones, Monte Carlo, symmetries."""

import builtins
import sys
from math import pi, sin

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

pytest.importorskip("flint")

from kleinform import Limits, MissingExtraError
from kleinform.maps.workspace import Workspace, constant_orientation_workspace
from kleinform.maps.zones import roots_of, values
from tests.maps.workspace_support import OTHER, PAPER, SPACES, monte_carlo, workspace

BALLS = 2.0 / 3.0 * pi * (1.3**3 - 0.5**3)
RING = pi * (1.1**2 - 0.4**2) * 1.6
KNOWN = {
    "shell": (PAPER, {"q6": (0.5, 1.3)}, 2.0 * BALLS),
    "ball": (PAPER, {"q6": (0.0, 1.3)}, 4.0 / 3.0 * pi * 1.3**3),
    "sector": (PAPER, {"q6": (0.5, 1.3), "q5": (0.6, pi / 2.0)}, BALLS * (1.0 - sin(0.6))),
    "belt": (PAPER, {"q6": (0.5, 1.3), "q5": (-0.3, 0.6)}, BALLS * (sin(0.6) + sin(0.3))),
    "below": (PAPER, {"q6": (0.5, 1.3), "q5": (-1.2, -0.6)}, BALLS * (sin(1.2) - sin(0.6))),
    "upper half": (PAPER, {"q6": (0.5, 1.3), "q5": (0.0, 2.0)}, BALLS),
    "wedge": (PAPER, {"q6": (0.5, 1.3), "q4": (0.3, 1.5)}, BALLS * 1.2 / pi),
    "wide wedge": (PAPER, {"q6": (0.5, 1.3), "q4": (-1.3, 3.5)}, BALLS * 4.8 / pi),
    "cap off": (
        np.eye(3),
        {"q6": (0.0, 1.0), "e1": (0.2, 9.0)},
        4.0 / 3.0 * pi - pi * 0.04 * 2.8 / 3.0,
    ),
    "tube": (PAPER, {"q1": (0.4, 1.1), "e1": (0.2, 1.8)}, RING * PAPER[0, 0]),
    "level tube": (np.eye(3), {"q2": (0.4, 1.1), "e2": (0.2, 1.8)}, RING),
    "steep tube": (
        OTHER,
        {"q2": (0.4, 1.1), "e2": (0.2, 1.8)},
        RING * abs((OTHER @ [-0.5, 0.75**0.5, 0.0])[:2] @ [-0.5, 0.75**0.5]),
    ),
    "nothing": (PAPER, {"q1": (0.4, 0.5), "q2": (0.4, 0.5), "q6": (5.0, 9.0)}, 0.0),
    "points": (PAPER, dict.fromkeys(("q1", "q2", "q3"), (-1.0, 0.0)), 0.0),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_volumes(name):
    rotation, ranges, exact = KNOWN[name]
    volume = workspace(rotation, ranges).volume()
    assert abs(volume.value - exact) <= volume.error
    assert volume.proven
    assert volume.error <= max(1e-6 * exact, 1e-7)


@pytest.mark.parametrize("name", SPACES)
def test_monte_carlo(name):
    volume = SPACES[name].volume(1e-4)
    assert volume.proven
    value, deviation = monte_carlo(SPACES[name], 300_000, seed=8)
    assert abs(volume.value - value) < 4.0 * deviation


def test_the_papers_orientation():
    volume = SPACES["paper"].volume()
    assert volume.proven
    assert volume.error < 1.2e-6 * volume.value
    assert abs(volume.value - 1.2037384) < 1e-6 + volume.error


def test_bounds_of_two_precisions_meet():
    rough, fine = (SPACES["legs"].volume(relative) for relative in (1e-2, 1e-5))
    assert rough.proven
    assert fine.proven
    assert rough.error > fine.error
    assert abs(rough.value - fine.value) <= rough.error + fine.error


@pytest.mark.parametrize("seed", [0, 2, 3, 5])
def test_rough_bounds_hold_the_fine_value(seed):
    rng = np.random.default_rng(seed)
    ranges = {name: tuple(np.sort(rng.uniform(0.2, 2.5, 2))) for name in ("q1", "q2", "q3", "q6")}
    ranges["q5"] = tuple(np.sort(rng.uniform(-1.6, 1.6, 2)))
    space = workspace(Rotation.from_rotvec(0.3 * rng.normal(size=3)).as_matrix(), ranges)
    fine = space.volume(1e-3)
    for relative in (0.5, 0.1, 0.01):
        rough = space.volume(relative)
        assert abs(rough.value - fine.value) <= rough.error + fine.error


def test_volumes_scale_with_the_radius():
    import kleinform

    small = constant_orientation_workspace(
        kleinform.UncoupledManipulator(0.1), PAPER, Limits.typical(0.1)
    ).volume(1e-4)
    large = SPACES["paper"].volume(1e-4)
    assert abs(1000.0 * small.value - large.value) <= 1000.0 * small.error + large.error


def test_parts_add_up():
    ranges = {"q1": (0.6, 1.5), "q2": (0.6, 1.4), "q6": (0.5, 1.4)}
    whole = workspace(OTHER, ranges).volume(1e-5)
    parts = [
        workspace(OTHER, {**ranges, "q4": ends}).volume(1e-5)
        for ends in ((-0.7, 1.1), (1.1, 2.0 * pi - 0.7))
    ]
    total = sum(part.value for part in parts)
    assert abs(whole.value - total) <= whole.error + sum(part.error for part in parts)


def test_the_area_of_sections_integrates_to_the_volume():
    space = SPACES["legs"]
    volume = space.volume(1e-4)
    low, high = space.box[0][2], space.box[1][2]
    nodes, weights = np.polynomial.legendre.leggauss(60)
    heights = (low + high) / 2.0 + (high - low) / 2.0 * nodes
    areas = np.array([space.section(z).area for z in heights])
    assert abs((high - low) / 2.0 * areas @ weights - volume.value) < 3e-3 * volume.value


def test_without_flint(monkeypatch):
    real = builtins.__import__

    def absent(name, *rest):
        if name == "flint":
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", absent)
    monkeypatch.delitem(sys.modules, "flint")
    with pytest.raises(MissingExtraError, match=r"kleinform\[certify\]"):
        Workspace(1.0, np.eye(3), Limits.typical()).volume()


def test_no_polynomial_vanishes_outside_of_its_zones():
    """The lemma of `zones`, with random perturbations as large as it allows."""
    rng = np.random.default_rng(2)
    u = np.linspace(-pi, pi, 4001)
    for degree in (1, 2):
        exact = rng.normal(size=(40, 5))
        exact[:20, 0] = -np.hypot(exact[:20, 1], exact[:20, 2])  # nearly double roots
        if degree == 1:
            exact[:, 3:] = 0.0
        change = rng.normal(size=(40, 5)) * 1e-3
        change[:, 1 + 2 * degree :] = 0.0
        roots = roots_of(exact, degree)
        eps = np.repeat(abs(change).sum(axis=1, keepdims=True), 2 * degree, axis=1)
        width = roots.widths(eps + roots.defect[:, np.newaxis], np.zeros(40))
        away = abs(np.exp(1j * u) - roots.zeta[..., np.newaxis])
        free = (away > width[..., np.newaxis]).all(axis=1)
        before, after = (
            values(part[:, np.newaxis], u[np.newaxis]) for part in (exact, exact + change)
        )
        assert free.any(axis=1).all()
        assert (np.sign(before[free]) == np.sign(after[free])).all()
        assert free.mean() > 0.8
