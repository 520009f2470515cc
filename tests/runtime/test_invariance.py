"""What must not change, or change in a known way, when the manipulator is moved or renamed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from kleinform import UncoupledManipulator
from tests.runtime.poses import in_radii, regular_cases, twists
from tests.support import Case

THIRD = Rotation.from_euler("z", 120.0, degrees=True).as_matrix()
HALF = np.diag([-1.0, -1.0, 1.0])
MIRROR = np.diag([1.0, -1.0, 1.0])
#: What turning a regular pose, entries of size one, may change in results of size one.
TURNING = 1e-12
LENGTHS, RATE_LENGTHS = [0, 1, 2, 5], [3, 4, 5]


def unit(case: Case) -> tuple[np.ndarray, np.ndarray]:
    return case.position / case.radius, case.rotation


def same(left: np.ndarray, right: np.ndarray, rel: float = TURNING) -> bool:
    return bool(np.linalg.norm(left - right) <= rel * max(1.0, np.linalg.norm(right)))


def angles_apart(left: float, right: float) -> float:
    return float(abs(np.angle(np.exp(1j * (left - right)))))


@given(regular_cases(), twists())
def test_a_third_of_a_turn_about_z_renames_the_limbs(case: Case, motion: np.ndarray) -> None:
    place, turn = unit(case)
    turned = (THIRD @ place, THIRD @ turn @ THIRD.T)
    robot = UncoupledManipulator()
    before, after = robot.survey(place, turn), robot.survey(*turned)
    assert same(np.roll(before.joints[:3], 1), after.joints[:3])
    assert angles_apart(before.joints[3] + 2.0 * np.pi / 3.0, after.joints[3]) <= TURNING
    assert same(before.joints[4:], after.joints[4:])
    assert same(np.roll(before.extension, 1), after.extension)
    assert same(before.direct_determinant, after.direct_determinant)
    assert same(before.inverse_determinant, after.inverse_determinant)
    rates = robot.inverse_velocity(place, turn, motion)
    turned_motion = np.concatenate([THIRD @ motion[:3], THIRD @ motion[3:]])
    turned_rates = robot.inverse_velocity(*turned, turned_motion)
    assert same(np.roll(rates[:3], 1), turned_rates[:3], 1e-11)
    assert same(rates[3:], turned_rates[3:], 1e-11)


@given(regular_cases())
def test_the_mirror_image_swaps_limbs_2_and_3(case: Case) -> None:
    place, turn = unit(case)
    robot = UncoupledManipulator()
    before = robot.survey(place, turn)
    after = robot.survey(MIRROR @ place, MIRROR @ turn @ MIRROR)
    order = [0, 2, 1, 4, 5]
    assert same(before.joints[order], after.joints[[0, 1, 2, 4, 5]])
    assert angles_apart(-before.joints[3], after.joints[3]) <= TURNING
    assert same(before.extension[[0, 2, 1]], after.extension)
    assert same(np.abs(before.direct_determinant), np.abs(after.direct_determinant))


@given(regular_cases())
def test_half_a_turn_of_the_platform_reflects_the_extensions(case: Case) -> None:
    """n → −n, e → −e: the same B_i, the same joint values."""
    place, turn = unit(case)
    robot = UncoupledManipulator()
    before, after = robot.survey(place, turn), robot.survey(place, turn @ HALF)
    assert same(before.joints, after.joints)
    assert same(before.extension, -after.extension)


@given(regular_cases(), twists(), st.sampled_from([-300, -10, 10, 300]))
def test_a_manipulator_of_another_size(case: Case, motion: np.ndarray, power: int) -> None:
    """A power of two changes lengths and nothing else, to the bit."""
    factor = 2.0**power if abs(power) < 100 else 2.0 ** (power / 4)
    small, place, turn = UncoupledManipulator(), *unit(case)
    large = UncoupledManipulator(factor)
    joints = large.inverse_displacement(factor * place, turn)
    assert np.array_equal(
        joints, in_radii(small.inverse_displacement(place, turn), factor, LENGTHS)
    )
    twist = in_radii(motion, factor, RATE_LENGTHS)
    rates = large.inverse_velocity(factor * place, turn, twist)
    expected = in_radii(small.inverse_velocity(place, turn, motion), factor, LENGTHS)
    assert np.array_equal(rates, expected)
    one, other = small.survey(place, turn), large.survey(factor * place, turn)
    assert other.inverse_determinant == one.inverse_determinant * factor**2
    assert other.direct_determinant == one.direct_determinant * factor**3
    units = {"extension": 1, "orientation": 3, "central": 2, "limb": 0, "wrist": 0}
    for name, value in one.factors.items():
        exponent = units[name.split("_")[0]]
        assert other.factors[name] == value * factor**exponent
        assert other.scales[name] == one.scales[name] * factor**exponent


@given(regular_cases(), twists())
def test_velocity_maps_are_linear(case: Case, motion: np.ndarray) -> None:
    place, turn = unit(case)
    robot = UncoupledManipulator()
    columns = robot.inverse_velocity(place, turn, np.eye(6))
    rates = robot.inverse_velocity(place, turn, motion)
    assert same(motion @ columns, rates, 1e-11)
    columns = robot.forward_velocity(place, turn, np.eye(6))
    assert same(motion @ columns, robot.forward_velocity(place, turn, motion), 1e-11)


@given(regular_cases())
def test_azimuth_is_ignored_off_the_axis(case: Case) -> None:
    place, turn = unit(case)
    robot = UncoupledManipulator()
    free, given_one = (
        [
            robot.inverse_displacement(place, turn, azimuth=azimuth),
            *robot.screws(place, turn, azimuth=azimuth),
            *robot.jacobians(place, turn, azimuth=azimuth),
            robot.forward_velocity(place, turn, np.ones(6), azimuth=azimuth),
        ]
        for azimuth in (None, 1.25)
    )
    for left, right in zip(free, given_one, strict=True):
        assert np.array_equal(left, right)


def test_radii_broadcast() -> None:
    """A radius for every pose, and every radius against every pose."""
    rng = np.random.default_rng(8)
    radii, places = rng.uniform(0.5, 2.0, size=4), rng.uniform(0.1, 0.4, size=(4, 3))
    turn = Rotation.from_euler("ZYX", [0.1, 0.2, 0.3]).as_matrix()
    paired = UncoupledManipulator(radii).inverse_displacement(places, turn)
    table = UncoupledManipulator(radii[:, np.newaxis]).inverse_displacement(places, turn)
    assert table.shape == (4, 4, 6)
    for i in range(4):
        for j in range(4):
            alone = UncoupledManipulator(radii[i]).inverse_displacement(places[j], turn)
            assert np.allclose(table[i, j], alone, rtol=1e-15, atol=0.0)
        assert np.array_equal(paired[i], table[i, i])


@pytest.mark.parametrize("shape", [(), (5,), (2, 3)])
def test_scipy_rotations_are_accepted(shape: tuple[int, ...]) -> None:
    rng = np.random.default_rng(9)
    turns = Rotation.from_rotvec(rng.normal(size=(*shape, 3)))
    place, robot = np.array([0.3, 0.2, 1.1]), UncoupledManipulator()
    matrices = turns.as_matrix()
    motion = rng.normal(size=6)
    calls = [
        lambda turn: [robot.inverse_displacement(place, turn)],
        lambda turn: robot.jacobians(place, turn),
        lambda turn: [robot.inverse_velocity(place, turn, motion)],
        lambda turn: [robot.survey(place, turn).direct_determinant],
    ]
    for call in calls:
        for left, right in zip(call(turns), call(matrices), strict=True):
            assert np.array_equal(left, right)
            assert left.shape[: len(shape)] == shape
