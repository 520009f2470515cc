"""Names of the ends of paths: benchmark systems, and planted points checked at 50 digits."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import mpmath
import numpy as np
import pytest

from kleinform.homotopy import Endpoints, solve
from tests.runtime import polynomial_systems as systems
from tests.runtime.polynomial_systems import Benchmark, Polynomials
from tests.support import EPS, many

#: A multiple point that is closer to infinity may stay without a name; see `Endpoints`.
RESOLVED = 1e-6
#: Ends nearer to a planted point, as unit vectors, are copies of it.
NEAR = 1e-5


@dataclass(frozen=True)
class Planted:
    """A random system with a multiple point at each of two places.

    Attributes
    ----------
    change : complex array (n + 1, n + 1)
        The system is ``local(change @ x)``.
    places : complex array (2, n + 1)
        Unit vectors x, where ``change @ x`` are the first two axes.
    multiplicities : int array (2,)
    """

    local: Polynomials
    change: np.ndarray
    places: np.ndarray
    multiplicities: np.ndarray

    def __call__(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = self.local(x @ self.change.T)
        return values, derivatives @ self.change


def planted(rng: np.random.Generator, powers_of_ten: tuple[float, float] = (-9.0, -3.0)) -> Planted:
    """Some points simple, some multiple; finite, of an x_0 of some power of ten, or at infinity."""
    n = int(rng.integers(2, 4))
    degrees = rng.integers(2, 4 if n == 3 else 6, size=n)
    orders = np.empty((2, n), dtype=int)
    orders[0] = rng.integers(1, degrees)
    # The line through both places meets each hypersurface degree times.
    orders[1] = rng.integers(1, degrees - orders[0] + 1)

    def coefficient() -> complex:
        return complex(rng.normal(), rng.normal())

    polynomials = [
        {
            powers: coefficient()
            for powers in itertools.product(range(degree + 1), repeat=n)
            if sum(powers) <= degree and sum(powers) >= order[0] and degree - powers[0] >= order[1]
        }
        for degree, order in zip(degrees, orders.T, strict=True)
    ]
    columns = rng.normal(size=(n + 1, n + 1)) + 1j * rng.normal(size=(n + 1, n + 1))
    columns /= np.linalg.norm(columns, axis=0)
    sizes = [0.0, 1.0, 10.0 ** rng.uniform(*powers_of_ten)]
    columns[0, :2] *= rng.choice(sizes, size=2)
    places = columns[:, :2].T / np.linalg.norm(columns[:, :2], axis=0)[:, np.newaxis]
    return Planted(
        Polynomials(polynomials), np.linalg.inv(columns), places, np.prod(orders, axis=1)
    )


def expected(system: Planted, place: int) -> set[str]:
    """The names that are true at a planted point."""
    x_0, multiple = abs(system.places[place, 0]), system.multiplicities[place] > 1
    if x_0 == 0.0:
        return {"infinity"}
    if not multiple:
        return {"regular"}
    return {"singular"} if x_0 > 2.0 * RESOLVED else {"singular", "failed"}


def exact_newton(system: Planted, point: np.ndarray) -> tuple[float, float]:
    """How far Newton's method goes from a unit vector at 50 digits, and ``|x_0|`` there."""
    with mpmath.workdps(50):
        change, x = mpmath.matrix(system.change), mpmath.matrix(point)
        chart, start = x.H, x.copy()
        for _ in range(4):
            values, derivatives = local_terms(system.local, change * x)
            rows = mpmath.matrix(len(x), len(x))
            rows[: len(x) - 1, :] = derivatives * change
            rows[len(x) - 1, :] = chart
            side = mpmath.matrix([*values, 0])
            x -= mpmath.lu_solve(rows, side)
        return float(mpmath.norm(x - start)), float(abs(x[0]))


def local_terms(local: Polynomials, z: mpmath.matrix) -> tuple[list, mpmath.matrix]:
    """Values and derivatives at 50 digits."""
    n = len(z) - 1
    values, derivatives = [mpmath.mpc(0)] * n, mpmath.zeros(n, n + 1)
    for row, powers, factor in zip(
        local.rows.tolist(), local.exponents.tolist(), local.coefficients.tolist(), strict=True
    ):
        values[row] += factor * mpmath.fprod(z[k] ** p for k, p in enumerate(powers))
        for j, power in enumerate(powers):
            if power:
                lower = (z[k] ** (p - (k == j)) for k, p in enumerate(powers))
                derivatives[row, j] += factor * power * mpmath.fprod(lower)
    return values, derivatives


def verdicts(system: Planted, found: Endpoints) -> Counter[str]:
    """Every end, and whether its name is true."""
    verdict: Counter[str] = Counter()
    cosines = np.abs(found.points @ system.places.conj().T)
    at_place = 1.0 - cosines**2 <= NEAR**2
    for end, (status, point) in enumerate(zip(found.status, found.points, strict=True)):
        if status == "failed":
            verdict["failed"] += 1
        elif np.any(at_place[end]):
            right = status in expected(system, int(np.argmax(at_place[end])))
            verdict["right" if right else f"wrong: {status}"] += 1
        else:
            moved, x_0 = exact_newton(system, point)
            right = status == "regular" and moved <= 1e-9 and x_0 > 0.0
            verdict["right" if right else f"wrong: {status}"] += 1
    names = [expected(system, place) for place in range(2)]
    copies = np.sum(at_place & (found.status != "failed")[:, np.newaxis], axis=0)
    unnamed = sum(
        m for name, m in zip(names, system.multiplicities, strict=True) if "failed" in name
    )
    verdict["lost"] += max(0, verdict["failed"] - int(unnamed))
    for name, copy, multiplicity in zip(names, copies, system.multiplicities, strict=True):
        verdict["missed"] += int("failed" not in name and copy != multiplicity)
    return verdict


def search(count: int) -> Counter[str]:
    total: Counter[str] = Counter()
    for seed in range(count):
        system = planted(np.random.default_rng(seed))
        total += verdicts(system, solve(system, system.local.degrees, seed=seed))
    return total


#: How many of these run in `make test`.
SAMPLE = 4
BENCHMARKS: dict[str, Callable[[], Benchmark]] = {
    "katsura5": lambda: systems.katsura(5),
    "noon3": lambda: systems.noon(3),
    "reimer4": lambda: systems.reimer(4),
    "trinks": systems.trinks,
    "katsura6": lambda: systems.katsura(6),
    "noon4": lambda: systems.noon(4),
    "eco5": lambda: systems.eco(5),
    "cyclic5": lambda: systems.cyclic(5),
    "eco6": lambda: systems.eco(6),
    "puma": systems.puma,
    "cyclic6": lambda: systems.cyclic(6),
}
#: Rounding spoils some paths to infinity, of up to 15 windings, before they have a name.
HARD: dict[str, Callable[[], Benchmark]] = {
    "eco4": lambda: systems.eco(4),
    "eco7": lambda: systems.eco(7),
    "reimer5": lambda: systems.reimer(5),
}


@pytest.mark.long
@pytest.mark.parametrize("name", list(BENCHMARKS)[: many(SAMPLE, len(BENCHMARKS))])
def test_benchmark_systems(name: str) -> None:
    """As many simple solutions as are known; every other path ends at infinity."""
    system, solutions = BENCHMARKS[name]()
    found = solve(system, system.degrees, seed=0)
    names = Counter(found.status.tolist())
    assert names == +Counter(regular=solutions, infinity=system.paths - solutions)
    regular = found.points[found.status == "regular"]
    assert np.max(np.abs(system(regular)[0])) <= 1e-13


@pytest.mark.long
@pytest.mark.parametrize("name", list(HARD)[: many(1, len(HARD))])
def test_hard_systems(name: str) -> None:
    """All simple solutions; no other end is called a solution."""
    system, solutions = HARD[name]()
    found = solve(system, system.degrees, seed=0)
    names = Counter(found.status.tolist())
    assert names["regular"] == solutions
    assert names["singular"] == 0
    assert names["failed"] <= 0.1 * system.paths


@pytest.mark.parametrize("size", [1e3, 2e7, 1e9, 1e12])
def test_large_simple_roots(size: float) -> None:
    """x = size is a solution like any other, known to eps of its unit vector."""
    system = systems.parsed("xy", f"x - {size!r}", "x y - x + y y - 3")
    found = solve(system, system.degrees, seed=0)
    assert list(found.status) == ["regular", "regular"]
    assert np.max(np.abs(found.points[:, 1] / found.points[:, 0] / size - 1.0)) <= 8.0 * EPS * size


@pytest.mark.long
def test_every_name_is_true() -> None:
    """No wrong one; those without a name are multiple points nearly at infinity, but for 1 %."""
    total = search(many(5, 300))
    assert {name for name in total if name.startswith("wrong")} == set()
    # Beside a twelvefold point some paths are lost to rounding, and say so.
    assert total["lost"] <= 0.01 * total["right"]
    assert total["missed"] <= total["lost"]


#: Such an x_0 of a multiple point falls from circle to circle as at infinity; only the mean on
#: the smaller one tells it from 0.
TINY = (-11.0, -9.0)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(42, many(43, 100)))
def test_a_tiny_x_0_is_not_infinity(seed: int) -> None:
    """No name of a point nearly at infinity is wrong; many have none."""
    rng = np.random.default_rng(seed)
    system = planted(rng, TINY)
    total = verdicts(system, solve(system, system.local.degrees, seed=seed))
    assert {name for name in total if name.startswith("wrong")} == set()
