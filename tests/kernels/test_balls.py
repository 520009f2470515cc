"""Kernels in ball arithmetic enclose what their mpmath twins find at 50 digits."""

from __future__ import annotations

from collections.abc import Iterator

import mpmath
import numpy as np
import pytest

from tests.kernels.accuracy import DIGITS, KERNELS, Arguments, arguments, exact
from tests.support import random_cases

flint = pytest.importorskip("flint", reason="no ball arithmetic: python-flint is not installed")
arb_kernels = pytest.importorskip("kleinform_kernels.uncoupled.arb_kernels")

#: Bits: fewer than the reference has, so that its own rounding is far inside every ball.
BITS = 100
RADIUS = 1e-6
SAMPLES = 8


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before, flint.ctx.prec = flint.ctx.prec, BITS
    with mpmath.workdps(DIGITS):
        yield
    flint.ctx.prec = before


def balls(name: str, values: Arguments, radius: float) -> np.ndarray:
    """The kernel's results in a row, from balls of a radius about the values."""
    wrapped = {
        entry: np.vectorize(lambda x: flint.arb(float(x), radius), otypes=[object])(value).tolist()
        for entry, value in values.items()
    }
    result = getattr(arb_kernels, name)(**wrapped)
    return np.concatenate([np.array(part, dtype=object).ravel() for part in result])


def enclose(results: np.ndarray, values: np.ndarray) -> bool:
    """Whether every result is finite and holds the value beside it."""
    pairs = zip(map(flint.arb, results), values, strict=True)
    return all(ball.is_finite() and ball.contains(flint.arb(value)) for ball, value in pairs)


@pytest.mark.parametrize("name", KERNELS)
def test_the_result_is_in_its_ball(name: str) -> None:
    rng = np.random.default_rng(4)
    for case in random_cases(rng, 5):
        values = arguments(name, case, rng)
        results = balls(name, values, 0.0)
        assert enclose(results, exact(name, values))
        assert all(ball.rad() < 1e-20 * (1 + abs(ball)) for ball in map(flint.arb, results))


@pytest.mark.parametrize("name", KERNELS)
def test_every_point_of_the_inputs_is_in_the_balls(name: str) -> None:
    rng = np.random.default_rng(5)
    for case in random_cases(rng, 3):
        values = arguments(name, case, rng)
        results = balls(name, values, RADIUS)
        for _ in range(SAMPLES):
            sample = {
                entry: value + RADIUS * rng.uniform(-0.999, 0.999, size=value.shape)
                for entry, value in values.items()
            }
            assert enclose(results, exact(name, sample))


def test_a_wrong_result_is_outside() -> None:
    """The comparison can fail: half of the last digit of a double away is too far."""
    rng = np.random.default_rng(6)
    values = arguments("cones", random_cases(rng, 1)[0], rng)
    results, wanted = balls("cones", values, 0.0), exact("cones", values)
    assert enclose(results, wanted)
    wanted[0] *= 1 + mpmath.mpf(2) ** -54
    assert not enclose(results, wanted)
