"""Statics by its duality with the velocity analysis, and against the Jacobians inverted."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

import kleinform
from kleinform import UncoupledManipulator
from tests.runtime.poses import POLARITY, in_radii, is_regular, regular_cases, twists
from tests.support import EPS, NEAR, Case, batch, near_identity, near_wrist, random_cases

ROBOT = UncoupledManipulator()
RNG = np.random.default_rng(51)
CASES = [case for case in random_cases(RNG, 400) if is_regular(case)]
_, PLACES, TURNS = batch(CASES)
FORCES = RNG.normal(size=(len(CASES), 6))
#: Entries that are torques, in N m.
TORQUES, MOMENT = [3, 4], [3, 4, 5]
NAMES = ("platform_wrench", "actuator_forces")


def conditions(case: Case) -> float:
    """What both Jacobians, in units of the radius, make of rounding."""
    forward, inverse = UncoupledManipulator().jacobians(case.position / case.radius, case.rotation)
    return float(np.linalg.cond(forward) * np.linalg.cond(inverse))


def power(wrench: np.ndarray, twist: np.ndarray) -> float:
    """F·v + M·omega."""
    return float(wrench[:3] @ twist[3:] + wrench[3:] @ twist[:3])


@given(regular_cases(), twists(), twists())
def test_power_of_forces(case: Case, drives: np.ndarray, motion: np.ndarray) -> None:
    """Any twist: the wrench does the work of the actuators."""
    robot = UncoupledManipulator(case.radius)
    forces = in_radii(drives, case.radius, TORQUES)
    twist = in_radii(motion, case.radius, [3, 4, 5])
    wrench = robot.platform_wrench(*case[1:], forces)
    rates = robot.inverse_velocity(*case[1:], twist)
    scale = case.radius * np.linalg.norm(drives) * np.linalg.norm(motion)
    gap = abs(power(wrench, twist) - forces @ rates)
    assert gap <= 8.0 * EPS * conditions(case) * scale


@given(regular_cases(), twists(), twists())
def test_power_of_a_wrench(case: Case, given_wrench: np.ndarray, drives: np.ndarray) -> None:
    """Any joint rates: the actuators do the work of the wrench."""
    robot = UncoupledManipulator(case.radius)
    wrench = in_radii(given_wrench, case.radius, MOMENT)
    rates = in_radii(drives, case.radius, [0, 1, 2, 5])
    forces = robot.actuator_forces(*case[1:], wrench)
    twist = robot.forward_velocity(*case[1:], rates)
    scale = case.radius * np.linalg.norm(given_wrench) * np.linalg.norm(drives)
    gap = abs(power(wrench, twist) - forces @ rates)
    assert gap <= 8.0 * EPS * conditions(case) * scale


def test_against_the_jacobians() -> None:
    """(17) says q̇ = J_q⁻¹ J_vᵀ Δ V, so the wrench is J_v J_q⁻ᵀ f, the force first."""
    J_v, J_q = ROBOT.jacobians(PLACES, TURNS)
    sizes = np.linalg.cond(J_v) * np.linalg.cond(J_q)
    wrenches = ROBOT.platform_wrench(PLACES, TURNS, FORCES)
    wanted = (J_v @ np.linalg.solve(J_q.mT, FORCES[..., np.newaxis]))[..., 0]
    gaps = np.linalg.norm(wrenches - wanted, axis=1)
    assert np.all(gaps <= 8.0 * EPS * sizes * np.linalg.norm(wanted, axis=1))
    forces = ROBOT.actuator_forces(PLACES, TURNS, wanted)
    by_matrix = (J_q.mT @ np.linalg.solve(J_v, wanted[..., np.newaxis]))[..., 0]
    gaps = np.linalg.norm(forces - by_matrix, axis=1)
    assert np.all(gaps <= 8.0 * EPS * sizes * np.linalg.norm(by_matrix, axis=1))


def test_each_outer_limb_carries_a_force_along_its_line() -> None:
    """Its wrench alone is a multiple of S_i, and the central limb's is a force through C."""
    for case in CASES[:20]:
        J_v, _ = ROBOT.jacobians(*case[1:])
        wrenches = ROBOT.platform_wrench(*case[1:], np.eye(6))
        for i in range(3):
            line = J_v[:, i]
            assert np.linalg.matrix_rank([line, wrenches[i]], tol=1e-9) == 1
        assert np.array_equal(wrenches[3:, 3:], np.zeros((3, 3)))


def test_polarity_makes_the_klein_form() -> None:
    """Wrench and twist have their halves in opposite order, so their product is Wᵀ Δ V."""
    case, motion = CASES[0], np.arange(1.0, 7.0)
    wrench = ROBOT.platform_wrench(*case[1:], FORCES[0])
    rates = ROBOT.inverse_velocity(*case[1:], motion)
    assert wrench @ POLARITY @ motion == pytest.approx(FORCES[0] @ rates, rel=1e-12)


@given(regular_cases(), twists())
def test_there_and_back(case: Case, drives: np.ndarray) -> None:
    robot = UncoupledManipulator(case.radius)
    forces = in_radii(drives, case.radius, TORQUES)
    again = robot.actuator_forces(*case[1:], robot.platform_wrench(*case[1:], forces))
    gap = in_radii(again - forces, 1.0 / case.radius, TORQUES)
    assert np.linalg.norm(gap) <= 8.0 * EPS * conditions(case) * np.linalg.norm(drives)


@pytest.mark.parametrize("radius", [1e-3, 1e3])
def test_radii(radius: float) -> None:
    """The same forces in N make the same force, and a moment as large as the radius."""
    small, large = ROBOT, UncoupledManipulator(radius)
    case = CASES[0]
    wrench = small.platform_wrench(case.position, case.rotation, FORCES[0])
    scaled = large.platform_wrench(
        radius * case.position, case.rotation, in_radii(FORCES[0], radius, TORQUES)
    )
    np.testing.assert_allclose(scaled, in_radii(wrench, radius, MOMENT), rtol=1e-12)
    forces = large.actuator_forces(radius * case.position, case.rotation, scaled)
    np.testing.assert_allclose(forces, in_radii(FORCES[0], radius, TORQUES), rtol=1e-10)


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_is_its_rows(name: str) -> None:
    call = getattr(ROBOT, name)
    together = call(PLACES, TURNS, FORCES)
    assert together.shape == (len(CASES), 6)
    for row, case in enumerate(CASES):
        alone = call(case.position, case.rotation, FORCES[row])
        np.testing.assert_allclose(together[row], alone, rtol=0.0, atol=64 * EPS * abs(alone).max())
    table = call(PLACES[:3, np.newaxis], TURNS[:3, np.newaxis], FORCES[:4])
    assert table.shape == (3, 4, 6)
    assert call(np.zeros((0, 3)), np.zeros((0, 3, 3)), np.zeros(6)).shape == (0, 6)


@pytest.mark.parametrize("name", NAMES)
def test_integers_lists_and_single_precision(name: str) -> None:
    call, case = getattr(ROBOT, name), CASES[0]
    wanted = call(case.position, case.rotation, np.arange(6.0))
    for given_one in (list(range(6)), np.arange(6), np.arange(6, dtype=np.float32)):
        found = call(case.position, case.rotation, given_one)
        assert found.dtype == np.float64
        assert np.array_equal(found, wanted)


@pytest.mark.parametrize("name", NAMES)
def test_refusals(name: str) -> None:
    call, case = getattr(ROBOT, name), CASES[0]
    argument = {"platform_wrench": "forces", "actuator_forces": "wrench"}[name]
    with pytest.raises(kleinform.ShapeError, match=argument):
        call(case.position, case.rotation, np.zeros(5))
    with pytest.raises(kleinform.NotFiniteError, match=argument):
        call(case.position, case.rotation, np.full(6, np.nan))
    with pytest.raises(kleinform.DtypeError, match=argument):
        call(case.position, case.rotation, np.ones(6, dtype=bool))
    with pytest.raises(kleinform.NotARotationError):
        call(case.position, 2.0 * case.rotation, np.ones(6))
    with pytest.raises(kleinform.SingularPoseError):
        call([0.0, 0.0, 1.0], case.rotation, np.ones(6))
    places = np.stack([case.position, [0.0, 0.0, 1.0], case.position])
    wrenches = np.stack([np.ones(6), np.ones(6), np.full(6, np.inf)])
    found = call(places, case.rotation, wrenches, errors="nan")
    assert np.isnan(found).all(axis=-1).tolist() == [False, True, True]
    assert np.array_equal(found[0], call(case.position, case.rotation, np.ones(6)))


# 1e-7 beside the identity the orientation factor is below √eps for its scale.
@pytest.mark.filterwarnings("ignore:near a singularity.*1.5e-08, orientation")
@pytest.mark.parametrize("radius", [1e-99, 1e99])
def test_sizes_at_the_end_of_the_range(radius: float) -> None:
    """Nothing overflows or underflows on the way, next to singular poses either."""
    rng = np.random.default_rng(53)
    robot = UncoupledManipulator(radius)
    for family in NEAR.values():
        case = family(rng, 1e-7)
        forces = robot.platform_wrench(radius * case.position, case.rotation, np.full(6, 1e100))
        wanted = ROBOT.platform_wrench(
            case.position, case.rotation, in_radii(np.full(6, 1.0), 1.0 / radius, TORQUES)
        )
        np.testing.assert_allclose(forces, 1e100 * in_radii(wanted, radius, MOMENT), rtol=1e-5)
        forces = robot.actuator_forces(radius * case.position, case.rotation, np.full(6, 1e100))
        wanted = ROBOT.actuator_forces(
            case.position, case.rotation, in_radii(np.full(6, 1.0), 1.0 / radius, MOMENT)
        )
        np.testing.assert_allclose(forces, 1e100 * in_radii(wanted, radius, TORQUES), rtol=1e-5)


def test_a_wrench_that_overflows_is_refused() -> None:
    """A platform of 1e-100 m next to det[n_i × (d_i − c)] = 0."""
    robot = UncoupledManipulator(1e-100)
    near, regular = near_identity(np.random.default_rng(64), 1e-10), CASES[0]
    places = 3e-100 * np.stack([near.position, regular.position])
    turns = np.stack([near.rotation, regular.rotation])
    message = r"the result overflows; .* arrived, first at pose 0; 1 of 2"
    with pytest.raises(kleinform.InputError, match=message):
        robot.actuator_forces(places, turns, np.full(6, 1e100))
    found = robot.actuator_forces(places, turns, np.full(6, 1e100), errors="nan")
    assert np.isnan(found).all(axis=-1).tolist() == [True, False]
    assert np.isfinite(found[1]).all()


def test_an_azimuth_settles_the_axis() -> None:
    """As for the velocity: on the Z axis there are forces for a wrench, not the other way."""
    case, place = CASES[0], np.array([0.0, 0.0, 1.0])
    forces = ROBOT.actuator_forces(place, case.rotation, np.ones(6), azimuth=0.3)
    near = 1e-9 * np.array([np.cos(0.3), np.sin(0.3), 0.0]) + place
    with pytest.warns(kleinform.SingularityWarning, match="central 1e-09"):
        closing_in = ROBOT.actuator_forces(near, case.rotation, np.ones(6))
    np.testing.assert_allclose(forces, closing_in, atol=1e-6)
    with pytest.raises(kleinform.SingularPoseError, match="q6 cos q5 = 0"):
        ROBOT.platform_wrench(place, case.rotation, np.ones(6))


def test_direct_singularities_have_no_forces() -> None:
    """The platform level: some wrench cannot be exerted."""
    with pytest.raises(kleinform.SingularPoseError, match="direct singularity, det"):
        ROBOT.actuator_forces([0.2, 0.1, 1.0], np.eye(3), np.ones(6))
    assert np.isfinite(ROBOT.platform_wrench([0.2, 0.1, 1.0], np.eye(3), np.ones(6))).all()


def test_the_wrist_singularity_cancels() -> None:
    rng = np.random.default_rng(52)
    poses = [near_wrist(rng, 0.0) for _ in range(100)]
    poses = [case for case in poses if is_regular(case, wrist=False)]
    assert len(poses) > 5
    for case in poses:
        forces = rng.normal(size=6)
        wrench = ROBOT.platform_wrench(*case[1:], forces)
        again = ROBOT.actuator_forces(*case[1:], wrench)
        assert np.linalg.norm(again - forces) <= 1e-11 * np.linalg.norm(forces)
