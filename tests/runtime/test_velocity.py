"""Velocity analysis against differences of the displacement analysis, and against itself."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from scipy.spatial.transform import Rotation

from kleinform import UncoupledManipulator
from tests.runtime.poses import (
    POLARITY,
    in_radii,
    is_regular,
    limb_of,
    regular_cases,
    twists,
)
from tests.support import EPS, Case, near_wrist, random_cases

VELOCITY = [3, 4, 5]
LENGTH_RATES = [0, 1, 2, 5]
#: Weights of the central difference of order six.
WEIGHTS = {1: 45.0 / 60.0, 2: -9.0 / 60.0, 3: 1.0 / 60.0}
#: Its step [s]. A regular pose is at least ρ = 0.1 s from a singular one at these speeds and
#: its joint values are below 20 radii, so that Cauchy's bound of the truncation is
#: 36·20 STEP⁶/ρ⁷ = 2e-12; rounding gives 2 eps/STEP = 2e-12 times ∂q/∂pose, about 100.
STEP = 2.5e-4
DIFFERENCE_TOLERANCE = 1e-9


def moved(case: Case, twist: np.ndarray, time: float) -> Case:
    """The pose after some time of a motion with this twist at time zero."""
    turn = Rotation.from_rotvec(time * twist[:3]).as_matrix()
    return Case(case.radius, case.position + time * twist[3:], turn @ case.rotation)


def differences(case: Case, twist: np.ndarray) -> np.ndarray:
    robot = UncoupledManipulator(case.radius)
    total = np.zeros(6)
    for steps, weight in WEIGHTS.items():
        after = moved(case, twist, steps * STEP)
        before = moved(case, twist, -steps * STEP)
        change = robot.inverse_displacement(*after[1:]) - robot.inverse_displacement(*before[1:])
        change[3] = np.angle(np.exp(1j * change[3]))
        total += weight * change / STEP
    return total


@given(regular_cases(), twists())
def test_inverse_velocity_is_the_derivative_of_inverse_displacement(
    case: Case, motion: np.ndarray
) -> None:
    twist = in_radii(motion, case.radius, VELOCITY)
    rates = UncoupledManipulator(case.radius).inverse_velocity(*case[1:], twist)
    gap = in_radii(rates - differences(case, twist), 1.0 / case.radius, LENGTH_RATES)
    assert np.max(np.abs(gap)) <= DIFFERENCE_TOLERANCE


def unit_jacobians(case: Case) -> tuple[np.ndarray, np.ndarray]:
    """Both Jacobians of the pose in units of the radius."""
    place = case.position / case.radius
    return tuple(UncoupledManipulator(1.0).jacobians(place, case.rotation))


def round_trip_tolerance(case: Case) -> float:
    """Rounding of the solution of ``J_vᵀ Δ V = J_q q̇`` for one side after the other."""
    forward, inverse = unit_jacobians(case)
    return 8.0 * EPS * np.linalg.cond(forward) * np.linalg.cond(inverse)


@given(regular_cases(), twists())
def test_forward_velocity_undoes_inverse_velocity(case: Case, motion: np.ndarray) -> None:
    robot = UncoupledManipulator(case.radius)
    twist = in_radii(motion, case.radius, VELOCITY)
    again = robot.forward_velocity(*case[1:], robot.inverse_velocity(*case[1:], twist))
    gap = in_radii(again - twist, 1.0 / case.radius, VELOCITY)
    assert np.linalg.norm(gap) <= round_trip_tolerance(case) * np.linalg.norm(motion)


@given(regular_cases(), twists())
def test_inverse_velocity_undoes_forward_velocity(case: Case, motion: np.ndarray) -> None:
    robot = UncoupledManipulator(case.radius)
    rates = in_radii(motion, case.radius, LENGTH_RATES)
    again = robot.inverse_velocity(*case[1:], robot.forward_velocity(*case[1:], rates))
    gap = in_radii(again - rates, 1.0 / case.radius, LENGTH_RATES)
    assert np.linalg.norm(gap) <= round_trip_tolerance(case) * np.linalg.norm(motion)


@given(regular_cases(), twists())
def test_input_output_equation(case: Case, motion: np.ndarray) -> None:
    """(17) holds to the rounding of its own terms."""
    twist = in_radii(motion, case.radius, VELOCITY)
    robot = UncoupledManipulator(case.radius)
    rates = robot.inverse_velocity(*case[1:], twist)
    forward, inverse = robot.jacobians(*case[1:])
    left, right = forward.T @ POLARITY @ twist, inverse @ rates
    terms = np.abs(forward.T @ POLARITY) @ np.abs(twist) + np.abs(inverse) @ np.abs(rates)
    cond = np.linalg.cond(unit_jacobians(case)[1])
    assert np.all(np.abs(left - right) <= 8.0 * EPS * cond * terms)


@given(regular_cases(), twists())
def test_rates_are_coordinates_of_the_twist_in_each_limb(case: Case, motion: np.ndarray) -> None:
    """(12): the twist is the sum of a limb's screws, the actuated ones with the given rates."""
    unit = Case(1.0, case.position / case.radius, case.rotation)
    robot = UncoupledManipulator(1.0)
    rates = robot.inverse_velocity(*unit[1:], motion)
    limbs = robot.screws(*unit[1:])
    for limb, actuated in ((0, {1: 0}), (1, {1: 1}), (2, {1: 2}), (3, {0: 3, 1: 4, 2: 5})):
        along = np.linalg.solve(limbs[limb].T, motion)
        tolerance = 8.0 * EPS * np.linalg.cond(limbs[limb]) * np.linalg.norm(along)
        for joint, rate in actuated.items():
            assert abs(along[joint] - rates[rate]) <= tolerance


def test_the_wrist_singularity_cancels() -> None:
    """The velocity maps pass through C in the plane of the platform, where J_v is singular."""
    rng = np.random.default_rng(5)
    robot = UncoupledManipulator()
    poses = [near_wrist(rng, 0.0) for _ in range(400)]
    poses = [case for case in poses if is_regular(case, wrist=False)]
    assert len(poses) > 20
    for case in poses:
        assert robot.inverse_singularity(*case[1:]).vanishing()["wrist"]
        motion = rng.uniform(-1.0, 1.0, size=6)
        rates = robot.inverse_velocity(*case[1:], motion)
        assert np.max(np.abs(rates - differences(case, motion))) <= DIFFERENCE_TOLERANCE
        again = robot.forward_velocity(*case[1:], rates)
        assert np.linalg.norm(again - motion) <= 1e-12 * np.linalg.norm(motion)


@settings(max_examples=50)
@given(regular_cases())
def test_screws_are_the_joints_of_the_mechanism(case: Case) -> None:
    """Each outer screw from its axis and a point of it, found by solving linear equations."""
    robot = UncoupledManipulator(case.radius)
    limbs = robot.screws(*case[1:])
    for i in range(3):
        limb = limb_of(case, i)
        leg = (limb.platform - limb.base) / np.linalg.norm(limb.platform - limb.base)
        upper = np.cross(limb.direction, leg)
        c, b = case.position, limb.platform
        expected = [
            [*limb.axis, *np.cross(limb.axis, c - limb.base)],
            [0.0, 0.0, 0.0, *leg],
            [*leg, *np.cross(leg, c - limb.base)],
            [*upper, *np.cross(upper, c - b)],
            [*limb.direction, *np.zeros(3)],
            [0.0, 0.0, 0.0, *limb.direction],
        ]
        scale = np.array([1.0] * 3 + [case.radius] * 3)
        assert np.max(np.abs(limbs[i] - expected) / scale) <= 1e-11


def test_a_batch_is_its_rows() -> None:
    """A batch of regular poses is what each gives alone."""
    rng = np.random.default_rng(6)
    some = [case for case in random_cases(rng, 200) if is_regular(case)]
    assert len(some) > 10
    robot = UncoupledManipulator()
    places = np.stack([case.position for case in some])
    turns = np.stack([case.rotation for case in some])
    motion = rng.normal(size=(len(some), 6))
    together = robot.inverse_velocity(places, turns, motion)
    for row, case in enumerate(some):
        alone = robot.inverse_velocity(*case[1:], motion[row])
        assert np.allclose(together[row], alone, rtol=4.0 * EPS, atol=0.0)
