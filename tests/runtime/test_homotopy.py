"""Continuation: systems with known roots, and the quadratics of the assembly modes."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from kleinform import KleinformError, UncoupledManipulator, rotation_from_rpy
from kleinform.homotopy import (
    Endpoints,
    quadratics,
    solve,
    solve_cones,
    total_degree,
    tracker,
)
from kleinform.homotopy import cones as many
from kleinform.homotopy.tracker import System
from tests.support import BASE_AXES, batch, platform_directions, random_cases

TURN = rotation_from_rpy(roll=np.deg2rad(10.0), pitch=np.deg2rad(3.0), yaw=np.deg2rad(6.0))
HOME = (np.array([0.25, 0.2, 1.0]), TURN)


def cones_of(positions: np.ndarray, rotations: np.ndarray) -> np.ndarray:
    """The cones on which n_1, n_2, n_3 lie, for the leg lengths of poses of radius 1."""
    lengths = UncoupledManipulator().inverse_displacement(positions, rotations)[..., :3]
    c, u = positions[..., np.newaxis, :], BASE_AXES
    h = 1.0 - np.sum(c * u, axis=-1)[..., np.newaxis, np.newaxis]
    kappa = (np.sum(c * c, axis=-1) - 1.0 - lengths**2)[..., np.newaxis, np.newaxis]
    across = c[..., :, np.newaxis] * u[:, np.newaxis, :]
    along = kappa * u[:, :, np.newaxis] * u[:, np.newaxis, :]
    return along + h * (across + across.swapaxes(-1, -2)) + h**2 * np.eye(3)


def unit_cones(positions: np.ndarray, rotations: np.ndarray) -> np.ndarray:
    cones = cones_of(positions, rotations)
    return cones / np.linalg.norm(cones, axis=(-2, -1), keepdims=True)


def finite(found: Endpoints) -> np.ndarray:
    """The solutions in affine coordinates."""
    return found.points[..., 1:] / found.points[..., :1]


def real(found: Endpoints) -> np.ndarray:
    return np.all(np.abs(finite(found).imag) <= 1e-9, axis=-1)


def decoupled(*polynomials: np.ndarray) -> System:
    """A polynomial in each unknown, by coefficients, the highest power first."""

    def system(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = np.zeros((len(x), len(polynomials)), dtype=complex)
        derivatives = np.zeros((*values.shape, len(polynomials) + 1), dtype=complex)
        for row, coefficients in enumerate(polynomials):
            degree, y, z = len(coefficients) - 1, x[:, row + 1], x[:, 0]
            for k, factor in enumerate(coefficients):
                values[:, row] += factor * y ** (degree - k) * z**k
                if k < degree:
                    derivatives[:, row, row + 1] += (
                        factor * (degree - k) * y ** (degree - k - 1) * z**k
                    )
                if k > 0:
                    derivatives[:, row, 0] += factor * k * y ** (degree - k) * z ** (k - 1)
        return values, derivatives

    return system


def line_and_hyperbola(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """x y = 1, x = 2: one solution, and one at infinity."""
    x_0, x_1, x_2 = x.T
    zero, one = np.zeros_like(x_0), np.ones_like(x_0)
    values = np.stack([x_1 * x_2 - x_0**2, x_1 - 2.0 * x_0], axis=-1)
    rows = np.stack([[-2.0 * x_0, x_2, x_1], [-2.0 * one, one, zero]])
    return values, np.moveaxis(rows, -1, 0)


def hyperbolas(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """x y = 1, x y = 2 x: one solution, and three at infinity, two of which are one."""
    x_0, x_1, x_2 = x.T
    values = np.stack([x_1 * x_2 - x_0**2, x_1 * x_2 - 2.0 * x_0 * x_1], axis=-1)
    rows = np.stack([[-2.0 * x_0, x_2, x_1], [-2.0 * x_1, x_2 - 2.0 * x_0, x_1]])
    return values, np.moveaxis(rows, -1, 0)


def line_and_point(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """x (y - 1) = 0, x (x - 2) = 0: all of x = 0, and (2, 1)."""
    x_0, x_1, x_2 = x.T
    zero = np.zeros_like(x_0)
    values = np.stack([x_1 * (x_2 - x_0), x_1 * (x_1 - 2.0 * x_0)], axis=-1)
    rows = np.stack([[-x_1, x_2 - x_0, x_1], [-2.0 * x_1, 2.0 * (x_1 - x_0), zero]])
    return values, np.moveaxis(rows, -1, 0)


def farthest(wanted: np.ndarray, found: np.ndarray) -> float:
    """How far the wanted points are, at most, from the nearest found one."""
    distances = np.linalg.norm(wanted[:, np.newaxis] - found[np.newaxis], axis=-1)
    return float(np.max(np.min(distances, axis=1)))


@pytest.mark.parametrize("seed", range(3))
def test_known_roots(seed: int) -> None:
    """The solutions are all combinations of roots that NumPy finds."""
    rng = np.random.default_rng(seed)
    polynomials = [rng.normal(size=d + 1) + 1j * rng.normal(size=d + 1) for d in (1, 3, 4)]
    found = solve(decoupled(*polynomials), (1, 3, 4), seed=seed)
    assert found.points.shape == (12, 4)
    assert np.all(found.status == "regular")
    wanted = np.array(list(itertools.product(*map(np.roots, polynomials))))
    assert farthest(wanted, finite(found)) <= 1e-12
    assert farthest(finite(found), wanted) <= 1e-12
    assert np.max(np.abs(np.linalg.norm(found.points, axis=-1) - 1.0)) <= 1e-15
    assert np.min(found.points[:, 0].real) > 0.0
    assert np.max(np.abs(found.points[:, 0].imag)) <= 1e-16


@pytest.mark.parametrize("seed", range(3))
def test_paper_case(seed: int) -> None:
    system = quadratics(unit_cones(*HOME))
    found = solve(system, (2,) * 6, seed=seed)
    assert np.all(found.status == "regular")
    assert np.max(np.abs(system(found.points)[0])) <= 1e-15
    solutions = finite(found)
    distances = np.linalg.norm(solutions[:, np.newaxis] - solutions, axis=-1)
    assert np.min(distances + 9.0 * np.eye(64)) >= 0.1
    assert farthest(-solutions, solutions) <= 1e-12
    assert np.count_nonzero(real(found)) == 8
    wanted = platform_directions(HOME[1])[:2].reshape(1, 6)
    assert farthest(wanted, solutions) <= 1e-13


def test_derivatives_of_the_quadratics() -> None:
    rng = np.random.default_rng(1)
    x = rng.normal(size=(5, 7)) + 1j * rng.normal(size=(5, 7))
    cones = rng.normal(size=(5, 3, 3, 3))
    system = quadratics(cones + cones.swapaxes(-1, -2))
    for column, unit in enumerate(np.eye(7)):
        # A quadratic has no third derivative: the central difference is exact.
        difference = (system(x + unit)[0] - system(x - unit)[0]) / 2.0
        assert np.max(np.abs(system(x)[1][..., column] - difference)) <= 1e-14


def test_infinity() -> None:
    found = solve(line_and_hyperbola, (2, 1), seed=0)
    assert sorted(found.status) == ["infinity", "regular"]
    assert np.max(np.abs(finite(found)[found.status == "regular"] - [2.0, 0.5])) <= 1e-14
    assert np.max(np.abs(found.points[found.status == "infinity", :2])) <= 1e-15
    found = solve(hyperbolas, (2, 2), seed=0)
    assert sorted(found.status) == ["infinity"] * 3 + ["regular"]
    assert sorted(found.condition > 1e8) == [False, False, True, True]


@pytest.mark.parametrize(
    ("roots", "accuracy"),
    [([1.0, 1.0, -2.0], 1e-9), ([0.5, 0.5, 0.5, -1.0, -1.0, 3.0], 1e-8), ([1.0] * 4, 1e-5)],
)
def test_multiple_roots(roots: list[float], accuracy: float) -> None:
    """Each as often as its multiplicity, and singular; the simple ones are regular."""
    coefficients = np.poly(roots)
    found = solve(decoupled(coefficients / np.abs(coefficients).max()), (len(roots),), seed=1)
    order = np.argsort(finite(found)[:, 0].real)
    assert np.max(np.abs(finite(found)[order, 0] - np.sort(roots))) <= accuracy
    simple = np.array([roots.count(root) == 1 for root in np.sort(roots)])
    assert list(found.status[order]) == list(np.where(simple, "regular", "singular"))
    assert np.all((found.condition[order] < 1e4) == simple)


def test_continuum() -> None:
    """Paths that end anywhere on a line of solutions are singular; the point is regular."""
    found = solve(line_and_point, (2, 2), seed=0)
    assert sorted(found.status) == ["regular"] + ["singular"] * 3
    assert np.max(np.abs(line_and_point(found.points)[0])) <= 1e-9
    assert np.max(np.abs(finite(found)[found.status == "regular"] - [2.0, 1.0])) <= 1e-14


def test_singular_matrix_in_a_batch() -> None:
    """One singular matrix leaves the others of its batch alone."""
    derivatives = np.array([[[0.0, 1.0]], [[0.0, 2.0]], [[1.0, 0.0]]], dtype=complex)
    charts = np.array([[1.0, 0.0]] * 3, dtype=complex)
    found = tracker._solved(charts, derivatives, np.ones((3, 1), dtype=complex))
    assert np.array_equal(found[:2], [[0.0, -1.0], [0.0, -0.5]])
    assert np.all(np.isnan(found[2]))


def test_failed_paths_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tried again as often as is allowed, and reported as failed."""
    monkeypatch.setattr(tracker, "MOST_STEPS", 10)
    found = solve(quadratics(unit_cones(*HOME)), (2,) * 6, seed=0)
    assert found.points.shape == (64, 7)
    lost = found.status == "failed"
    assert np.any(lost)
    assert np.all(found.tries == total_degree.MOST_TRIES)
    assert np.all(np.isinf(found.condition[lost]))
    assert np.max(found.steps) <= 10 * 2 * total_degree.MOST_TRIES
    many._generic_cones.cache_clear()
    with pytest.raises(KleinformError, match=r"generic cones 0: \d+ of 32 pairs"):
        solve_cones(unit_cones(*HOME)[np.newaxis])


def test_paths_that_met_are_followed_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """With steps so coarse that paths jump to others, tighter ones part them."""
    cases = batch(random_cases(np.random.default_rng(0), 40))
    cones = cones_of(cases.position, cases.rotation)
    for number in range(total_degree.MOST_TRIES):
        many._generic_cones(number)
    careful = solve_cones(cones)
    assert np.all(careful.tries == 1)
    for module in (many, total_degree):
        monkeypatch.setattr(module, "PREDICTION", 0.1)
    monkeypatch.setattr(tracker, "CONTRACTION", 0.5)
    coarse = solve_cones(cones)
    assert 0 < np.count_nonzero(coarse.tries[:, 0] > 1) < 40
    assert np.all(coarse.status == "regular")
    assert np.array_equal(np.sum(real(coarse), axis=-1), np.sum(real(careful), axis=-1))


def test_repeated_endpoints() -> None:
    """A second path at a point, or at its mirror image, is a lost one."""
    found = solve_cones(unit_cones(*HOME)[np.newaxis])
    assert not np.any(total_degree._repeated(found, many.MIRROR))
    found.points[0, 7] = found.points[0, 3]
    found.points[0, 9] = many.MIRROR * found.points[0, 5]
    repeated = total_degree._repeated(found, many.MIRROR)
    assert list(np.flatnonzero(repeated)) == [7, 9]


def test_the_same_seed_gives_the_same() -> None:
    system = quadratics(unit_cones(*HOME))
    first, second = (solve(system, (2,) * 6, seed=4) for _ in range(2))
    for name in ("points", "status", "condition", "steps", "tries"):
        assert np.array_equal(getattr(first, name), getattr(second, name))
    other = solve(system, (2,) * 6, seed=5)
    assert not np.array_equal(first.steps, other.steps)
    assert farthest(finite(first), finite(other)) <= 1e-12


def test_many_poses_at_once() -> None:
    """Every pose is among the solutions of its own cones, whatever their scale."""
    cases = batch(random_cases(np.random.default_rng(2), 50))
    cones = cones_of(cases.position, cases.rotation)
    found = solve_cones(cones * np.geomspace(1e-3, 1e3, 50)[:, np.newaxis, np.newaxis, np.newaxis])
    assert found.points.shape == (50, 32, 7)
    assert np.all(found.status == "regular")
    wanted = platform_directions(cases.rotation)[:, :2].reshape(-1, 1, 6)
    both = np.concatenate([finite(found), -finite(found)], axis=1)
    assert np.max(np.min(np.linalg.norm(both - wanted, axis=-1), axis=-1)) <= 1e-9
    for index in range(3):
        system = quadratics(unit_cones(cases.position[index], cases.rotation[index]))
        alone = solve(system, (2,) * 6, seed=index)
        assert np.all(alone.status == "regular")
        assert np.count_nonzero(real(alone)) == 2 * np.count_nonzero(real(found)[index])
        assert farthest(finite(alone), both[index]) <= 1e-9


def test_reference_pose_is_a_double_solution() -> None:
    """R = I is a direct singularity: two paths meet there, and 30 do not."""
    place, turn = HOME[0], np.eye(3)
    found = solve_cones(cones_of(place, turn)[np.newaxis])
    double = found.status[0] == "singular"
    assert np.count_nonzero(double) == 2
    assert np.all(found.status[0, ~double] == "regular")
    wanted = platform_directions(turn)[:2].reshape(6)
    there = finite(found)[0, double]
    there = there * np.sign(there[:, :1].real)
    assert np.max(np.abs(there - wanted)) <= 1e-9


def test_no_cones() -> None:
    """Zero is no condition at all: the solutions are a continuum. No problem has no solutions."""
    cones = unit_cones(*HOME)
    cones[1] = 0.0
    assert np.all(solve_cones(cones[np.newaxis]).status == "singular")
    assert solve_cones(np.empty((0, 3, 3, 3))).points.shape == (0, 32, 7)
