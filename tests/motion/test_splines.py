"""Motions through samples and waypoints."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kleinform.motion
from kleinform import InputError, MissingExtraError, NotARotationError, ShapeError
from kleinform.motion import (
    PoseMotion,
    interpolated,
    rest_to_rest,
    through_joints,
    through_poses,
)
from kleinform.paper.examples import example_1

RNG = np.random.default_rng(0)
TIMES = np.array([0.0, 1.0, 2.5, 3.0, 5.0])
WAYPOINTS = np.array([1.0, 1.2, 0.9, 0.7, 1.0, 1.05]) + 0.1 * RNG.normal(size=(5, 6))
POSITIONS = np.array([0.25, 0.2, 1.0]) + 0.1 * RNG.normal(size=(5, 3))
ROTATIONS = Rotation.from_rotvec(0.3 * RNG.normal(size=(5, 3))).as_matrix()


def test_waypoints_are_met_and_both_ends_at_rest() -> None:
    motion = through_joints(TIMES, WAYPOINTS)
    assert abs(motion.at(TIMES).joints - WAYPOINTS).max() <= 1e-14
    ends = motion.at([0.0, 5.0])
    assert abs(ends.rates).max() <= 1e-13
    assert abs(ends.accelerations).max() <= 1e-12


def test_accelerations_are_continuous_at_waypoints() -> None:
    motion, step = through_joints(TIMES, WAYPOINTS), 1e-9
    before, after = motion.at(TIMES[1:-1] - step), motion.at(TIMES[1:-1] + step)
    assert abs(before.accelerations - after.accelerations).max() <= 1e-7


def test_two_waypoints_are_the_motion_from_rest_to_rest() -> None:
    one = through_joints([0.0, 2.0], WAYPOINTS[:2]).sampled(21)
    other = rest_to_rest(*WAYPOINTS[:2], 2.0).sampled(21)
    for mine, theirs in zip(one, other, strict=True):
        assert abs(mine - theirs).max() <= 1e-13


def test_samples_with_derivatives_are_met_and_the_function_between() -> None:
    """The error of a quintic between samples falls with the sixth power of their distance."""
    exact, errors = example_1(), []
    for count in (21, 41):
        samples = exact.sampled(count)
        motion = interpolated(samples)
        for mine, theirs in zip(motion.at(samples.times), samples, strict=True):
            assert abs(mine - theirs).max() <= 1e-12
        fine = exact.sampled(1001)
        errors.append(abs(motion.at(fine.times).joints - fine.joints).max())
    assert 50.0 <= errors[0] / errors[1] <= 80.0


def test_poses_are_met_and_twists_are_derivatives() -> None:
    motion, step = through_poses(TIMES, POSITIONS, ROTATIONS), 1e-5
    met = motion.at(TIMES)
    assert abs(met.positions - POSITIONS).max() <= 1e-14
    assert abs(met.rotations - ROTATIONS).max() <= 1e-14
    times = np.linspace(0.1, 4.9, 30)
    before, here, after = (motion.at(times + shift) for shift in (-step, 0.0, step))
    velocity = (after.positions - before.positions) / (2.0 * step)
    assert abs(velocity - here.twists[:, 3:]).max() <= 1e-8
    turned = Rotation.from_matrix(after.rotations @ before.rotations.swapaxes(1, 2))
    assert abs(turned.as_rotvec() / (2.0 * step) - here.twists[:, :3]).max() <= 1e-8
    change = (after.twists - before.twists) / (2.0 * step)
    smooth = abs(times[:, np.newaxis] - TIMES).min(axis=1) > step
    assert abs(change - here.twist_rates)[smooth].max() <= 1e-7


def test_rotations_of_scipy_are_taken() -> None:
    one = through_poses(TIMES, POSITIONS, Rotation.from_matrix(ROTATIONS)).sampled(9)
    other = through_poses(TIMES, POSITIONS, ROTATIONS).sampled(9)
    assert abs(one.rotations - other.rotations).max() <= 1e-15


@pytest.mark.parametrize("times", [[0.0], [0.0, 0.0, 1.0, 2.0, 3.0], [0.0, 1.0, np.nan, 2.0, 3.0]])
def test_times_that_do_not_go_on_are_refused(times: list[float]) -> None:
    for make in (
        lambda: through_joints(times, WAYPOINTS[: len(times)]),
        lambda: through_poses(times, POSITIONS[: len(times)], ROTATIONS[: len(times)]),
    ):
        with pytest.raises(InputError, match=r"^times: "):
            make()


def test_what_does_not_fit_the_times_is_refused() -> None:
    with pytest.raises(ShapeError, match=r"^joints: "):
        through_joints(TIMES, WAYPOINTS[:4])
    with pytest.raises(ShapeError, match=r"^positions: "):
        through_poses(TIMES, POSITIONS[:4], ROTATIONS)
    with pytest.raises(ShapeError, match=r"^rotations: "):
        through_poses(TIMES, POSITIONS, ROTATIONS[:4])
    with pytest.raises(NotARotationError, match=r"^rotations: .*pose 0"):
        through_poses(TIMES, POSITIONS, 1.1 * ROTATIONS)


def test_a_spline_that_leaves_the_joint_ranges_says_so() -> None:
    steep = WAYPOINTS.copy()
    steep[1, 0], steep[2:, 0] = 3.0, 0.01
    with pytest.raises(InputError, match="q1 >= 0 is needed"):
        through_joints(TIMES, steep).sampled(101)


def test_a_pose_motion_must_return_rotations() -> None:
    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        count = len(times)
        still = np.zeros((count, 6))
        return np.ones((count, 3)), np.ones((count, 3, 3)), still, still

    with pytest.raises(NotARotationError, match=r"^rotations: "):
        PoseMotion(function, 0.0, 1.0).sampled(3)


def test_without_scipy_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "kleinform.motion.splines")
    monkeypatch.delattr(kleinform.motion, "splines")
    monkeypatch.setitem(sys.modules, "scipy.interpolate", None)
    with pytest.raises(MissingExtraError, match=r"kleinform\[motion\]"):
        kleinform.motion.through_joints  # noqa: B018
