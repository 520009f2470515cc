"""Rates of all joints against the screws, linear algebra and the actuated ones."""

from __future__ import annotations

from contextlib import nullcontext

import numpy as np
import pytest
from hypothesis import given

import kleinform
from kleinform import UncoupledManipulator
from tests.runtime.poses import in_radii, is_regular, regular_cases, twists
from tests.support import (
    BASE_AXES,
    EPS,
    NEAR,
    Case,
    batch,
    near_incidence,
    near_wrist,
    random_cases,
)

ROBOT = UncoupledManipulator()
RNG = np.random.default_rng(61)
CASES = [case for case in random_cases(RNG, 400) if is_regular(case)]
_, PLACES, TURNS = batch(CASES)
MOTIONS = RNG.normal(size=(len(CASES), 6))
#: Columns that are lengths a second, in outer limbs and in the central one.
SLIDING, CENTRAL_SLIDING = [1, 5], [2]


def unit_of(rates: np.ndarray, radius: float) -> np.ndarray:
    """Lengths in radii."""
    found = rates.copy()
    found[..., :3, SLIDING] /= radius
    found[..., 3, CENTRAL_SLIDING] /= radius
    return found


@given(regular_cases(), twists())
def test_the_screws_times_their_rates_are_the_twist(case: Case, motion: np.ndarray) -> None:
    """(12), to the rounding of its terms."""
    robot = UncoupledManipulator(case.radius)
    twist = in_radii(motion, case.radius, [3, 4, 5])
    rates = robot.joint_rates(*case[1:], twist)
    for limb, screws in enumerate(robot.screws(*case[1:])):
        terms = in_radii(abs(rates[limb]) @ abs(screws), 1.0 / case.radius, [3, 4, 5])
        gap = in_radii(rates[limb] @ screws - twist, 1.0 / case.radius, [3, 4, 5])
        assert np.linalg.norm(gap) <= 64.0 * EPS * np.linalg.norm(terms)


@given(regular_cases(), twists())
def test_against_linear_algebra(case: Case, motion: np.ndarray) -> None:
    """The coordinates of the twist in the screws of each limb."""
    unit = (case.position / case.radius, case.rotation)
    rates = ROBOT.joint_rates(*unit, motion)
    for limb, screws in enumerate(ROBOT.screws(*unit)):
        along = np.linalg.solve(screws.T, motion)
        tolerance = 16.0 * EPS * np.linalg.cond(screws) * np.linalg.norm(along)
        assert np.linalg.norm(rates[limb] - along) <= tolerance


@given(regular_cases(), twists())
def test_actuated_rates_are_those_of_inverse_velocity(case: Case, motion: np.ndarray) -> None:
    robot = UncoupledManipulator(case.radius)
    twist = in_radii(motion, case.radius, [3, 4, 5])
    rates = robot.joint_rates(*case[1:], twist)
    actuated = np.concatenate([rates[:3, 1], rates[3, :3]])
    wanted = robot.inverse_velocity(*case[1:], twist)
    np.testing.assert_allclose(actuated, wanted, rtol=64 * EPS, atol=64 * EPS * abs(wanted).max())


@pytest.mark.parametrize("radius", [1e-3, 1e3])
def test_radii(radius: float) -> None:
    case, motion = CASES[0], MOTIONS[0]
    wanted = ROBOT.joint_rates(*case[1:], motion)
    found = UncoupledManipulator(radius).joint_rates(
        radius * case.position, case.rotation, in_radii(motion, radius, [3, 4, 5])
    )
    np.testing.assert_allclose(unit_of(found, radius), wanted, rtol=1e-12)


def test_a_batch_is_its_rows() -> None:
    together = ROBOT.joint_rates(PLACES, TURNS, MOTIONS)
    assert together.shape == (len(CASES), 4, 6)
    for row, case in enumerate(CASES):
        alone = ROBOT.joint_rates(case.position, case.rotation, MOTIONS[row])
        np.testing.assert_allclose(together[row], alone, rtol=0.0, atol=64 * EPS * abs(alone).max())
    table = ROBOT.joint_rates(PLACES[:3, np.newaxis], TURNS[:3, np.newaxis], MOTIONS[:5])
    assert table.shape == (3, 5, 4, 6)
    empty = ROBOT.joint_rates(np.zeros((0, 3)), np.zeros((0, 3, 3)), np.zeros(6))
    assert empty.shape == (0, 4, 6)


def test_integers_lists_and_single_precision() -> None:
    case = CASES[0]
    wanted = ROBOT.joint_rates(*case[1:], np.arange(6.0))
    for motion in (list(range(6)), np.arange(6), np.arange(6, dtype=np.float32)):
        found = ROBOT.joint_rates(*case[1:], motion)
        assert found.dtype == np.float64
        assert np.array_equal(found, wanted)


def test_refusals() -> None:
    case = CASES[0]
    with pytest.raises(kleinform.ShapeError, match="twist"):
        ROBOT.joint_rates(*case[1:], np.zeros(7))
    with pytest.raises(kleinform.NotFiniteError, match="twist"):
        ROBOT.joint_rates(*case[1:], np.full(6, np.inf))
    with pytest.raises(kleinform.DtypeError, match="twist"):
        ROBOT.joint_rates(*case[1:], np.ones(6, dtype=complex))


def test_singular_poses() -> None:
    """Each is refused by its name, and is NaN in a batch."""
    rng = np.random.default_rng(62)
    regular = CASES[0]
    wrist = next(case for case in iter(lambda: near_wrist(rng, 0.0), None) if wrist_alone(case))
    poses = {
        "q6 cos q5 = 0": (np.array([0.0, 0.0, 1.0]), regular.rotation),
        "n_[123]·u_[123] = 0": near_incidence(rng, 0.0)[1:],
        "q_1 = 0": (0.25 * BASE_AXES[0], np.eye(3)),
        "wrist": wrist[1:],
    }
    for message, (place, turn) in poses.items():
        with pytest.raises(kleinform.SingularPoseError, match=message):
            ROBOT.joint_rates(place, turn, np.ones(6))
        places = np.stack([regular.position, place])
        found = ROBOT.joint_rates(
            places, np.stack([regular.rotation, turn]), np.ones(6), errors="nan"
        )
        assert np.array_equal(found[0], ROBOT.joint_rates(*regular[1:], np.ones(6)))
        assert np.isnan(found[1]).all()


def wrist_alone(case: Case) -> bool:
    """Whether nothing but the wrist may be singular."""
    return is_regular(case, wrist=False)


def test_next_to_the_wrist_singularity() -> None:
    """Passive rates grow as one over the factor; (12) holds all the same."""
    rng = np.random.default_rng(63)
    for distance in (1e-4, 1e-8, 1e-12):
        case = near_wrist(rng, distance)
        near = distance < 1e-7  # below √eps for its scale
        with pytest.warns(kleinform.SingularityWarning, match="wrist") if near else nullcontext():
            rates = ROBOT.joint_rates(*case[1:], np.ones(6))
        central = ROBOT.screws(*case[1:]).central
        terms = np.linalg.norm(abs(rates[3]) @ abs(central))
        assert np.linalg.norm(rates[3] @ central - 1.0) <= 64 * EPS * terms


def test_twists_that_overflow_are_refused() -> None:
    """Each number is allowed, their products next to n_i·u_i = 0 are not."""
    robot = UncoupledManipulator(1e99)
    case = near_incidence(np.random.default_rng(64), 1e-7)
    place, large = 1e99 * case.position, np.full(6, 1e100)
    with pytest.raises(kleinform.InputError, match="the result overflows"):
        robot.joint_rates(place, case.rotation, large)
    mixed = robot.joint_rates(
        place, case.rotation, np.stack([large, np.ones(6), large]), errors="nan"
    )
    assert np.isnan(mixed).all(axis=(1, 2)).tolist() == [True, False, True]
    assert np.isfinite(mixed[1]).all()


@pytest.mark.parametrize("radius", [1e-99, 1e99])
def test_sizes_at_the_end_of_the_range(radius: float) -> None:
    """Nothing overflows or underflows on the way, next to singular poses either."""
    rng = np.random.default_rng(64)
    robot = UncoupledManipulator(radius)
    for family in NEAR.values():
        case = family(rng, 1e-7)
        motion = in_radii(np.ones(6), radius, [3, 4, 5])
        found = robot.joint_rates(radius * case.position, case.rotation, motion)
        wanted = ROBOT.joint_rates(case.position, case.rotation, np.ones(6))
        scale = abs(wanted).max(axis=-1, keepdims=True)
        assert np.all(abs(unit_of(found, radius) - wanted) <= 1e-5 * scale)
