"""Acceleration analysis against second differences in 50 digits, and both ways."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

import kleinform
from kleinform_kernels.uncoupled import mpmath_kernels
from tests.support import EPS, batch, random_cases

ROBOT = kleinform.UncoupledManipulator(1.0)
CASES = random_cases(np.random.default_rng(41), 12)
RNG = np.random.default_rng(42)
MOTIONS = RNG.normal(size=(len(CASES), 2, 6))
STEP = mpmath.mpf(10) ** -12


def turned(vector: list, rotation: np.ndarray) -> list:
    """exp(vector ×) R, by Rodrigues' formula in mpmath's numbers."""
    x, y, z = vector
    angle = mpmath.sqrt(x * x + y * y + z * z)
    cross = mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    first, second = mpmath.sin(angle) / angle, (1 - mpmath.cos(angle)) / angle**2
    turn = mpmath.eye(3) + first * cross + second * cross * cross
    return (turn * mpmath.matrix(rotation.tolist())).tolist()


def joints_at(index: int, time: mpmath.mpf) -> list:
    """Joint values on a path with this twist and derivative of the twist at time 0."""
    case, (twist, change) = CASES[index], MOTIONS[index]
    moved = [
        mpmath.mpf(float(v)) * time + mpmath.mpf(float(a)) * time**2 / 2
        for v, a in zip(twist, change, strict=True)
    ]
    place = [mpmath.mpf(float(c)) + d for c, d in zip(case.position, moved[3:], strict=True)]
    turn = turned(moved[:3], case.rotation) if time else case.rotation.tolist()
    return mpmath_kernels.inverse_displacement(1, place, turn).joints


@pytest.mark.parametrize("index", range(len(CASES)))
def test_second_differences(index: int) -> None:
    case, (twist, change) = CASES[index], MOTIONS[index]
    with mpmath.workdps(60):
        before, now, after = (joints_at(index, k * STEP) for k in (-1, 0, 1))
        wanted = [(a - 2 * b + c) / STEP**2 for a, b, c in zip(before, now, after, strict=True)]
        wanted = np.array(wanted, dtype=float)
    found = ROBOT.inverse_acceleration(case.position, case.rotation, twist, change)
    scale = 1.0 + np.max(abs(wanted))
    np.testing.assert_allclose(found, wanted, atol=1e-11 * scale, rtol=1e-11)


def test_there_and_back() -> None:
    """As far as the condition of the forward problem lets it."""
    _, place, turn = batch(CASES)
    twist, change = MOTIONS[:, 0], MOTIONS[:, 1]
    rates = ROBOT.inverse_velocity(place, turn, twist)
    accelerations = ROBOT.inverse_acceleration(place, turn, twist, change)
    back = ROBOT.forward_acceleration(place, turn, rates, accelerations)
    assert np.linalg.norm(back - change) <= 1e-9 * np.linalg.norm(accelerations)
    by_hand = np.stack(
        [
            ROBOT.forward_acceleration(c, R, dq, ddq)
            for c, R, dq, ddq in zip(place, turn, rates, accelerations, strict=True)
        ]
    )
    np.testing.assert_allclose(by_hand, back, rtol=64 * EPS, atol=64 * EPS * abs(back).max())


def test_at_rest_accelerations_are_as_rates() -> None:
    """Without rates, (15) to (17) hold for accelerations."""
    _, place, turn = batch(CASES)
    change = MOTIONS[:, 1]
    found = ROBOT.inverse_acceleration(place, turn, np.zeros((len(CASES), 6)), change)
    np.testing.assert_allclose(found, ROBOT.inverse_velocity(place, turn, change), rtol=1e-12)
    back = ROBOT.forward_acceleration(place, turn, np.zeros((len(CASES), 6)), found)
    np.testing.assert_allclose(back, ROBOT.forward_velocity(place, turn, found), rtol=1e-12)


@pytest.mark.parametrize("name", ["inverse_acceleration", "forward_acceleration"])
def test_refusals(name: str) -> None:
    call = getattr(ROBOT, name)
    case = CASES[0]
    zero = np.zeros(6)
    with pytest.raises(kleinform.ShapeError):
        call(case.position, case.rotation, zero, np.zeros(5))
    with pytest.raises(kleinform.NotFiniteError):
        call(case.position, case.rotation, zero, np.full(6, np.nan))
    with pytest.raises(kleinform.SingularPoseError):
        call([0.0, 0.0, 1.0], case.rotation, zero, zero)
    places = np.stack([case.position, [0.0, 0.0, 1.0]])
    found = call(places, case.rotation, zero, zero, errors="nan")
    assert np.all(np.isfinite(found[0]))
    assert np.all(np.isnan(found[1]))


def test_at_a_direct_singularity_there_is_no_answer() -> None:
    """The platform level: det[n_i × (d_i − c)] = 0."""
    with pytest.raises(kleinform.SingularPoseError, match="direct singularity"):
        ROBOT.forward_acceleration([0.2, 0.1, 1.0], np.eye(3), np.zeros(6), np.ones(6))


def test_rates_that_overflow_are_refused() -> None:
    """Each is allowed, their products are not."""
    case = CASES[0]
    for name in ("inverse_acceleration", "forward_acceleration"):
        call = getattr(ROBOT, name)
        with pytest.raises(kleinform.InputError, match="overflows"):
            call(case.position * 1e60, case.rotation, np.full(6, 9e99), np.zeros(6))
        batch = call(
            np.stack([case.position, case.position * 1e60]),
            case.rotation,
            np.stack([np.ones(6), np.full(6, 9e99)]),
            np.zeros(6),
            errors="nan",
        )
        assert np.array_equal(np.isnan(batch).all(axis=-1), [False, True])
