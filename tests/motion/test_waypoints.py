"""Splines that swing beyond their waypoints, those that do not, and times that allow neither."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import InputError, MotionWarning
from kleinform.motion import polynomials, rest_to_rest, through_joints, through_poses
from tests.support import EPS, many

HOME = np.array([1.0, 1.2, 0.9, 0.7, 1.0, 1.05])
#: The times of a recording with two samples that are almost one.
UNEVEN = np.array([0.0, 1e-3, 1.0, 1.0001, 5.0])
#: Times at which a piece between two waypoints is looked at.
DENSE = 4001


def uneven(rng: np.random.Generator, smallest: float) -> tuple[np.ndarray, np.ndarray]:
    """Random waypoints at times whose distances are of very different sizes."""
    count = int(rng.integers(2, 12))
    gaps = 10.0 ** rng.uniform(np.log10(smallest), 1.0, count - 1)
    ways = 0.1 * rng.normal(size=(count, 6)) * rng.integers(0, 2, size=6)
    return np.append(0.0, np.cumsum(gaps)), HOME + ways


def dense(times: np.ndarray) -> np.ndarray:
    """Times (pieces, DENSE), both ends of each piece among them."""
    return np.clip(
        times[:-1, np.newaxis] + np.diff(times)[:, np.newaxis] * np.linspace(0.0, 1.0, DENSE),
        times[:-1, np.newaxis],
        times[1:, np.newaxis],
    )


@pytest.mark.long
def test_the_overshoot_is_that_of_dense_samples() -> None:
    rng, swings = np.random.default_rng(61), 0
    for _ in range(many(40, 1000)):
        times, points = uneven(rng, 1e-2)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            motion = through_joints(times, points)
        values = motion.function(dense(times).ravel())[0]
        high, low = points.max(axis=0), points.min(axis=0)
        beyond = np.maximum(values.max(axis=0) - high, low - values.min(axis=0)).clip(0.0)
        size = 1.0 + abs(values).max(axis=0)
        assert (beyond <= motion.overshoot + 64 * EPS * size).all()
        # A parabola between two of them is lower at its top by a share of 1e-6 at most.
        assert (motion.overshoot <= beyond + 1e-5 * size).all()
        wild = (motion.overshoot > np.ptp(points, axis=0)).any()
        assert [entry.category for entry in caught] == [MotionWarning] * int(wild)
        swings += int(wild)
    assert swings >= many(5, 100)


@pytest.mark.long
def test_what_preserves_shape_stays_between_neighbours() -> None:
    rng = np.random.default_rng(62)
    for _ in range(many(60, 2000)):
        times, points = uneven(rng, 1e-7)
        motion = through_joints(times, points, shape_preserving=True)
        values = motion.function(dense(times).ravel())[0].reshape(len(times) - 1, DENSE, 6)
        low, high = np.minimum(points[1:], points[:-1]), np.maximum(points[1:], points[:-1])
        assert (values >= low[:, np.newaxis] - 4 * EPS).all()
        assert (values <= high[:, np.newaxis] + 4 * EPS).all()
        assert (motion.overshoot <= 4 * EPS).all()


def test_what_preserves_shape_meets_waypoints_with_continuous_rates() -> None:
    rng = np.random.default_rng(63)
    times, points = uneven(rng, 0.1)
    motion = through_joints(times, points, shape_preserving=True)
    assert abs(motion.at(times).joints - points).max() <= 1e-14
    assert abs(motion.at(times[[0, -1]]).rates).max() <= 1e-14
    before, after = motion.at(times[1:-1] - 1e-9), motion.at(times[1:-1] + 1e-9)
    assert abs(before.rates - after.rates).max() <= 1e-6


def test_the_swing_of_a_recording_is_told() -> None:
    points = np.tile(HOME, (5, 1))
    points[:, 0] += [0.0, 0.02, 0.05, 0.07, 0.1]
    with pytest.warns(MotionWarning, match=r"q1 by 5\.25e\+03 m \(of a way of 0\.1\)") as told:
        motion = through_joints(UNEVEN, points)
    assert told[0].filename == __file__
    assert not motion.overshoot[1:].any()
    assert not through_joints(UNEVEN, points, shape_preserving=True).overshoot.any()


def test_the_swing_of_poses_is_told() -> None:
    points = np.tile([0.25, 0.2, 1.0], (5, 1))
    points[:, 0] += [0.0, 0.02, 0.05, 0.07, 0.1]
    with pytest.warns(MotionWarning, match=r"x by 154 m \(of a way of 0\.1\)") as told:
        motion = through_poses(UNEVEN, points, np.broadcast_to(np.eye(3), (5, 3, 3)))
    assert told[0].filename == __file__
    x = motion.at(dense(UNEVEN).ravel()).positions[:, 0]
    beyond = max(x.max() - points[:, 0].max(), points[:, 0].min() - x.min())
    assert abs(motion.overshoot - [beyond, 0.0, 0.0]).max() <= 1e-5 * beyond


@pytest.mark.parametrize("duration", [1e-300, 1e-100, 1e-60, 1e62, 1e100, 1e300])
def test_absurd_durations_are_named(duration: float) -> None:
    with pytest.raises(
        InputError, match=rf"^duration: .*{duration!r} s arrived".replace("+", r"\+")
    ):
        rest_to_rest(HOME, 1.1 * HOME, duration)


@pytest.mark.parametrize("duration", [0.0, -1.0, np.nan, np.inf, "x", None, True, [1.0, 2.0]])
def test_what_is_no_duration_is_named(duration: object) -> None:
    with pytest.raises(InputError, match=r"^duration: "):
        rest_to_rest(HOME, HOME, duration)


@pytest.mark.parametrize("duration", [1e-20, 1e-9, 1e9, 1e50])
def test_durations_that_numbers_can_hold(duration: float) -> None:
    states = rest_to_rest(HOME, 1.1 * HOME, duration).sampled(5)
    assert abs(states.joints[[0, 2, -1]] / HOME - np.array([[1.0], [1.05], [1.1]])).max() <= 1e-14


def test_polynomials_that_leave_numbers_are_named() -> None:
    with pytest.raises(InputError, match=r"^coefficients, start, end: "):
        polynomials(np.ones((6, 6)), 0.0, 1e60)


@pytest.mark.parametrize("scale", [1e-300, 1e-100, 1e-60, 1e99])
@pytest.mark.parametrize("shape_preserving", [False, True])
def test_absurd_times_are_named(scale: float, shape_preserving: bool) -> None:
    """Refused, or right."""
    times = np.array([0.0, 1.0, 2.5, 3.0, 5.0]) * scale
    points = HOME * np.linspace(1.0, 1.2, 5)[:, np.newaxis]
    try:
        motion = through_joints(times, points, shape_preserving=shape_preserving)
    except InputError as error:
        assert str(error).startswith("times: ")  # noqa: PT017
    else:
        assert abs(motion.at(times).joints - points).max() <= 1e-9


@pytest.mark.parametrize("gap", [1e-6, 1e-12, 1e-30, 1e-100, 1e-300])
def test_waypoints_that_rounding_would_miss_are_refused(gap: float) -> None:
    times, points = np.array([0.0, gap, 1.0, 2.0]), HOME * np.array([[1.0], [1.1], [1.0], [1.1]])
    with pytest.raises(InputError, match=r"^times: "):
        through_joints(times, points)
    vectors = 0.3 * np.random.default_rng(64).normal(size=(4, 3))
    with pytest.raises(InputError, match=r"^times: "):
        through_poses(times, points[:, :3], Rotation.from_rotvec(vectors))
