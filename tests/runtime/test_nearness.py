"""Warnings next to singular poses, and the conditioning of any pose."""

from __future__ import annotations

import pickle
import warnings
from collections.abc import Callable

import numpy as np
import pytest

import kleinform
from kleinform import SingularityWarning, SingularPoseError, UncoupledManipulator
from kleinform.maps.modes import conditioning as moments
from kleinform.motion import PlatformStates
from kleinform.zero import NEAR as LIMIT
from tests.support import EPS, NEAR, Case, batch, many, random_cases, scaled

TWIST = np.array([0.3, -0.2, 0.5, 0.1, 0.4, -0.6])
ROBOT = UncoupledManipulator()
OUTER = tuple(f"{name}_{i}" for name in ("limb", "leg") for i in (1, 2, 3))
INVERSE = (*OUTER, "central")
DIRECT = (*OUTER, "extension_1", "extension_2", "extension_3", "orientation", "central")
#: The call, and the factors that it divides by.
CALLS: dict[str, tuple[Callable[..., object], tuple[str, ...]]] = {
    "inverse_displacement": (
        lambda robot, *pose, **more: robot.inverse_displacement(*pose, **more),
        OUTER[:3],
    ),
    "screws": (lambda robot, *pose, **more: robot.screws(*pose, **more), INVERSE),
    "jacobians": (lambda robot, *pose, **more: robot.jacobians(*pose, **more), INVERSE),
    **{
        name: (lambda robot, *pose, n=name, **more: getattr(robot, n)(*pose, TWIST, **more), used)
        for name, used in (
            ("inverse_velocity", INVERSE),
            ("forward_velocity", DIRECT),
            ("joint_rates", (*INVERSE, "wrist")),
            ("platform_wrench", INVERSE),
            ("actuator_forces", DIRECT),
        )
    },
    **{
        name: (
            lambda robot, *pose, n=name, **more: getattr(robot, n)(*pose, TWIST, TWIST, **more),
            used,
        )
        for name, used in (("inverse_acceleration", INVERSE), ("forward_acceleration", DIRECT))
    },
}


def cases(count: int, seed: int) -> list[Case]:
    """Random poses, and poses next to every kind of singular one, at distances around the limit."""
    rng = np.random.default_rng(seed)
    found = random_cases(rng, count)
    for number in range(count):
        family = [*NEAR][number % len(NEAR)]
        found.append(NEAR[family](rng, 10.0 ** rng.uniform(-15.0, -5.0)))
    return [scaled(case, (1.0, 1e-3, 1e3)[index % 3]) for index, case in enumerate(found)]


def warned(call: Callable[..., object], *arguments: object, **more: object) -> list[object]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call(*arguments, **more)
    return [entry.message for entry in caught]


@pytest.mark.long
@pytest.mark.parametrize("name", CALLS)
def test_one_warning_a_call_of_what_it_divides_by(name: str) -> None:
    call, used = CALLS[name]
    together = batch(cases(many(60, 3000), seed=3))
    robot = UncoupledManipulator(together.radius)
    pose = together.position, together.rotation
    ratios = robot.conditioning(*pose).ratios
    small = {factor: ratios[factor] <= LIMIT for factor in used}
    with np.errstate(invalid="ignore"):
        zero = {factor: ratios[factor] <= 16.0 * EPS for factor in used}
    refused = np.any(list(zero.values()), axis=0)
    near = np.any(list(small.values()), axis=0) & ~refused
    messages = warned(call, robot, *pose, errors="nan")
    assert [type(message) for message in messages] == [SingularityWarning]
    assert np.array_equal(messages[0].mask, near)
    for factor, mask in small.items():
        rows = mask & ~refused
        least = float(ratios[factor][rows].min()) if rows.any() else None
        assert messages[0].ratios.get(factor) == least
    first, count = int(np.argmax(near)), int(near.sum())
    assert f"first at pose {first}; {count} of {len(near)} poses" in str(messages[0])


@pytest.mark.parametrize("name", CALLS)
def test_one_pose_warns_as_a_batch_does(name: str) -> None:
    call, used = CALLS[name]
    for case in cases(20, seed=4):
        robot = UncoupledManipulator(case.radius)
        pose = case.position, case.rotation
        ratios = robot.conditioning(*pose).ratios
        small = {factor: float(ratios[factor]) for factor in used if ratios[factor] <= LIMIT}
        if any(ratio <= 16.0 * EPS for ratio in small.values()):
            with pytest.raises(SingularPoseError):  # and a warning would be an error here
                call(robot, *pose)
            continue
        messages = warned(call, robot, *pose)
        assert [message.ratios for message in messages] == ([small] if small else [])


def test_a_warning_points_at_the_line_that_called() -> None:
    pose = [1e-9, 0.0, 1.0], np.eye(3)
    with pytest.warns(SingularityWarning, match="near a singularity: .* central 1e-09$") as caught:
        ROBOT.inverse_velocity(*pose, TWIST)
    assert [entry.filename for entry in caught] == [__file__]
    still = np.zeros((1, 6))
    states = PlatformStates([0.0], [pose[0]], [pose[1]], still, still)
    with pytest.warns(SingularityWarning) as caught:
        ROBOT.inverse_motion(states)
    assert [entry.filename for entry in caught] == [__file__]
    again = pickle.loads(pickle.dumps(caught[0].message))
    assert (str(again), again.ratios) == (str(caught[0].message), {"central": 1e-9})


def test_an_azimuth_takes_the_axis_for_given() -> None:
    """On the axis nothing is divided by; next to it the heading still is."""
    on, off = [0.0, 0.0, 1.0], [1e-9, 0.0, 1.0]
    turn = kleinform.rotation_from_rpy(roll=0.2, pitch=0.1, yaw=0.1)
    assert warned(ROBOT.forward_velocity, on, turn, TWIST, azimuth=0.3) == []
    assert len(warned(ROBOT.forward_velocity, off, turn, TWIST, azimuth=0.3)) == 1
    assert warned(ROBOT.inverse_displacement, off, turn) == []


def test_conditioning_is_that_of_the_velocity_map() -> None:
    poses = batch(random_cases(np.random.default_rng(8), 40))
    robot = UncoupledManipulator(poses.radius)
    values = robot.conditioning(poses.position, poses.rotation).singular_values
    unit = np.eye(6)[:, np.newaxis]
    rates, twists = (
        np.moveaxis(call(poses.position, poses.rotation, unit), 0, -1)
        for call in (robot.inverse_velocity, robot.forward_velocity)
    )
    parts = {
        "q123_by_omega": rates[:, :3, :3],
        "q123_by_velocity": rates[:, :3, 3:],
        "q45_by_velocity": rates[:, 3:5, 3:],
        "omega_by_q123": twists[:, :3, :3],
        "velocity_by_q45": twists[:, 3:, 3:5],
    }
    for name, matrices in parts.items():
        expected = np.linalg.svd(matrices, compute_uv=False)
        assert np.allclose(values[name], expected, rtol=1e-9, atol=1e-12), name
        assert (np.diff(values[name]) <= 0.0).all()
    assert np.array_equal(
        values["moments"],
        moments(robot, poses.position, poses.rotation),
    )


@pytest.mark.parametrize("family", NEAR)
def test_conditioning_refuses_no_singular_pose(family: str) -> None:
    case = NEAR[family](np.random.default_rng(9), 0.0)
    found = ROBOT.conditioning(case.position, case.rotation)
    survey = ROBOT.survey(case.position, case.rotation)
    for name, zero in survey.vanishing().items():
        assert (found.ratios[name] <= 16.0 * EPS) == zero
    missing = {name for name, values in found.singular_values.items() if np.isnan(values).any()}
    lines = {"moments", "q123_by_omega", "q123_by_velocity", "omega_by_q123"}
    assert missing == (lines if family in ("incidence", "leg") else set())


def test_conditioning_of_a_batch_with_bad_rows() -> None:
    places = np.array([[0.25, 0.2, 1.0], [np.nan, 0.0, 1.0], [0.0, 0.0, 1.0]])
    found = ROBOT.conditioning(places, np.eye(3), errors="nan")
    assert found.valid.tolist() == [True, False, True]
    for values in (*found.ratios.values(), *found.singular_values.values()):
        assert np.isnan(values[1]).all()
        assert not np.isnan(values[[0, 2]]).any()
    assert found.singular_values["q45_by_velocity"][2, 0] == np.inf
    assert found.singular_values["velocity_by_q45"][2].tolist() == [1.0, 0.0]
