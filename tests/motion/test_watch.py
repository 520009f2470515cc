"""What motions meet, and when, where the time is known from elsewhere."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

from kleinform import InputError, TrackingError, UncoupledManipulator
from kleinform.limits import Limits
from kleinform.motion import JointMotion, PoseMotion, rest_to_rest
from kleinform.paper.examples import example_1, example_2

ROBOT = UncoupledManipulator()
START = Rotation.from_euler("ZYX", np.deg2rad([6.0, 3.0, 10.0]))
HOME = np.array([0.25, 0.2, 1.0])
#: The issue's figure [s].
SOON = 1e-9


def poses(
    place: Callable[[np.ndarray], np.ndarray], turn: Callable[[np.ndarray], Rotation], end: float
) -> PoseMotion:
    """A motion of the platform; what is watched does not depend on its twists."""

    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        still = np.zeros((len(times), 6))
        matrices = np.broadcast_to(turn(times).as_matrix(), (len(times), 3, 3))
        return place(times[:, np.newaxis]), matrices, still, still

    return PoseMotion(function, 0.0, end)


def joints(path: Callable[[np.ndarray], np.ndarray], end: float) -> JointMotion:
    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        still = np.zeros((len(times), 6))
        return path(times[:, np.newaxis]), still, still

    return JointMotion(function, 0.0, end)


def test_the_examples_meet_nothing() -> None:
    for motion in (example_1(), example_2()):
        found = ROBOT.watch(motion, 101, start_rotation=START)
        assert found.first is None
        assert found.times.tolist() == motion.sampled(101).times.tolist()
        assert np.array_equal(found.joints, motion.sampled(101).joints)


def test_factors_are_those_of_the_survey() -> None:
    found = ROBOT.watch(example_1(), 33, start_rotation=START)
    survey = ROBOT.survey(found.positions, found.rotations)
    for name, value in survey.factors.items():
        assert np.array_equal(found.survey.factors[name], value)
        assert value.shape == (33,)


@pytest.mark.parametrize("count", [30, 101, 1001])
def test_a_limit_of_a_joint(count: int) -> None:
    """q2 = 1.191 + 0.15 sin 2t."""
    found = ROBOT.watch(example_1(), count, start_rotation=START, limits=Limits({"q2": (0.0, 1.3)}))
    assert found.first[1:] == ("q2 high", "limit")
    assert abs(found.first.time - 0.5 * np.arcsin((1.3 - 1.191) / 0.15)) <= SOON
    assert sorted(found.room) == ["q2 high", "q2 low"]
    assert np.array_equal(found.room["q2 high"], 1.3 - found.joints[:, 1])


def test_the_first_of_several_limits() -> None:
    limits = Limits({"q1": (0.5, 1.1), "q6": (0.9, 2.0), "e1": (0.73, 2.0)})
    found = ROBOT.watch(example_1(), 301, start_rotation=START, limits=limits)
    assert found.first[1:] == ("e1 low", "limit")
    sample = int(np.argmax(found.survey.extension[:, 0] <= 0.73))
    assert found.times[sample - 1] < found.first.time <= found.times[sample]
    assert found.first.time < 0.5 * np.arcsin(0.1 / 0.125)  # q1 high


@pytest.mark.parametrize("beyond", [1e-4, 1e-6, 1e-9])
def test_a_limit_that_is_passed_between_two_samples(beyond: float) -> None:
    """The peak 1.125 of q1 = 1 + 0.125 sin 2t, above the limit for a moment only."""
    limits = Limits({"q1": (0.0, 1.125 - beyond)})
    found = ROBOT.watch(example_1(), 60, start_rotation=START, limits=limits)
    early = 0.5 * np.arccos((0.125 - beyond) / 0.125)
    assert found.first.name == "q1 high"
    assert abs(found.first.time - (np.pi / 4.0 - early)) <= SOON


def test_a_limit_that_is_touched() -> None:
    found = ROBOT.watch(example_1(), 60, start_rotation=START, limits=Limits({"q1": (0.0, 1.125)}))
    assert found.first.name == "q1 high"
    assert abs(found.first.time - np.pi / 4.0) <= SOON


@pytest.mark.parametrize("short", [1e-6, 1e-12])
def test_a_limit_that_is_missed(short: float) -> None:
    limits = Limits({"q1": (0.0, 1.125 + short)})
    assert ROBOT.watch(example_1(), 60, start_rotation=START, limits=limits).first is None


def test_a_margin_of_a_factor() -> None:
    """The orientation factor comes down to its margin before it vanishes."""
    motion = poses(lambda t: HOME + 0.0 * t, turning_back, 2.0)
    found = ROBOT.watch(motion, 64, limits=Limits(margins={"orientation": 0.05}))
    assert found.first[1:] == ("orientation margin", "limit")
    place = np.array([found.first.time])
    factor = ROBOT.direct_singularity(HOME, turning_back(place)).factors["orientation"]
    assert abs(abs(factor[0]) - 0.05) <= 1e-9


def resting(top: float) -> JointMotion:
    """q1 rises to a value in a second, rests on it for two, and goes back."""
    start = ROBOT.inverse_displacement(HOME, START)

    def path(t: np.ndarray) -> np.ndarray:
        share = np.clip(np.minimum(t, 4.0 - t), 0.0, 1.0)
        moved = np.repeat(start[np.newaxis], len(t), axis=0)
        moved[:, :1] += (top - start[0]) * share
        return moved

    return joints(path, 4.0)


@pytest.mark.parametrize("short", [0, 1, 3, 8])
@pytest.mark.parametrize("count", [5, 11, 101, 102])
def test_a_rest_on_a_limit_within_rounding(short: int, count: int) -> None:
    """What counts as zero counts between the samples too."""
    top = 1.1
    limits = Limits({"q1": (0.5, top + short * np.spacing(top))})
    found = ROBOT.watch(resting(top), count, start_rotation=START, limits=limits)
    assert found.first.name == "q1 high"
    assert abs(found.first.time - 1.0) <= SOON


def test_a_motion_that_ends_on_a_limit() -> None:
    """From rest to rest: it counts as there a little before the end."""
    start = ROBOT.inverse_displacement(HOME, START)
    rng = np.random.default_rng(6)
    for top in start[0] + rng.uniform(0.01, 0.1, 30):
        end = np.add(start, [top - start[0], 0.01, 0.0, 0.0, 0.0, 0.0])
        motion = rest_to_rest(start, end, float(rng.uniform(0.5, 500.0)))
        limits = Limits({"q1": (0.5, float(end[0]))})
        first = ROBOT.watch(motion, 100, start_rotation=START, limits=limits).first
        assert first.name == "q1 high"
        assert 0.0 <= (motion.end - first.time) / motion.end <= 1e-3


def test_an_infinite_limit_is_none() -> None:
    limits = Limits({"q1": (-np.inf, np.inf), "q2": (0.5, np.inf)})
    found = ROBOT.watch(example_1(), 20, start_rotation=START, limits=limits)
    assert found.first is None
    assert list(found.room) == ["q2 low"]


def test_a_motion_that_begins_beyond_a_limit() -> None:
    limits = Limits({"q1": (0.0, 0.9)})
    found = ROBOT.watch(example_1(), 20, start_rotation=START, limits=limits)
    assert found.first == (0.0, "q1 high", "limit")


def test_limits_of_the_azimuth_count_turns() -> None:
    """C goes once around the Z axis; 4 rad come after the jump of atan2 at π."""

    def circle(t: np.ndarray) -> np.ndarray:
        return 0.25 * np.concatenate([np.cos(t), np.sin(t), 4.0 + 0.0 * t], axis=1)

    motion = poses(circle, lambda _: START, 6.0)
    found = ROBOT.watch(motion, 101, limits=Limits({"q4": (-1.0, 4.0)}))
    assert abs(found.joints[:, 3] - found.times).max() <= 1e-14
    assert found.first.name == "q4 high"
    assert abs(found.first.time - 4.0) <= SOON


def line(start: np.ndarray, through: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """From a point, and at t = 1 through another."""
    return lambda t: start + t * (through - start)


def test_the_wrist() -> None:
    """C comes into the platform's plane through O."""
    normal = START.as_matrix()[:, 2]
    through = np.array([0.4, 0.3, 0.0])
    through[2] = -(normal[:2] @ through[:2]) / normal[2]
    motion = poses(line(0.99 * through + 0.01 * HOME, through), lambda _: START, 1.5)
    found = ROBOT.watch(motion, 64)
    assert found.first[1:] == ("wrist", "wrist")
    assert abs(found.first.time - 1.0) <= SOON


def test_the_central_limb() -> None:
    """C comes through the Z axis, where q6² cos q5 = 0 without a change of sign."""
    motion = poses(line(HOME, np.array([0.0, 0.0, 1.1])), lambda _: START, 1.5)
    for count in (15, 64):
        found = ROBOT.watch(motion, count)
        assert found.first[1:] == ("central", "inverse")
        assert abs(found.first.time - 1.0) <= SOON


def test_near_the_axis_is_not_on_it() -> None:
    motion = poses(line(HOME, np.array([0.0, 1e-6, 1.1])), lambda _: START, 1.5)
    assert ROBOT.watch(motion, 64).first is None


@pytest.mark.parametrize("limb", [1, 2, 3])
def test_an_extension(limb: int) -> None:
    """C comes into the plane of a limb, c·u_i = a."""
    angle = np.deg2rad([0.0, 120.0, 240.0])[limb - 1]
    through = 1.0 * np.array([np.cos(angle), np.sin(angle), 0.0]) + [0.0, 0.0, 1.0]
    motion = poses(line(np.array([0.01, 0.02, 1.0]), through), lambda _: START, 1.5)
    found = ROBOT.watch(motion, 64)
    assert found.first[1:] == (f"extension_{limb}", "direct")
    assert abs(found.first.time - 1.0) <= SOON


@pytest.mark.parametrize("tilt", [0.3, -0.4, 0.8])
def test_a_limb(tilt: float) -> None:
    """n_i·u_i = 0: the extension has a pole there, and no zero."""

    def turn(times: np.ndarray) -> Rotation:
        return Rotation.from_euler("ZX", np.stack([1.3 + 0.3 * times, tilt + 0.0 * times], axis=1))

    def incidence(time: float, limb: int) -> float:
        angle = 2.0 * np.pi / 3.0 * limb
        u = np.array([np.cos(angle), np.sin(angle), 0.0])
        return float(turn(np.array([time])).as_matrix()[0] @ u @ u)

    roots = {}
    for limb in range(3):
        if incidence(0.0, limb) * incidence(1.6, limb) < 0.0:
            roots[f"limb_{limb + 1}"] = brentq(incidence, 0.0, 1.6, args=(limb,), xtol=1e-15)
    first = min(roots, key=roots.__getitem__)

    def later(times: np.ndarray) -> Rotation:
        return turn(times + roots[first] - 0.1)

    found = ROBOT.watch(poses(lambda t: HOME + 0.0 * t, later, 0.15), 50)
    assert found.first[1:] == (first, "inverse")
    assert abs(found.first.time - 0.1) <= SOON


def test_a_leg_without_length() -> None:
    """n_1 turns through the direction from C to A_1."""
    along = np.array([1.0, 0.0, 0.0]) - HOME
    along /= np.linalg.norm(along)
    side = np.cross(along, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side)
    frame = Rotation.from_matrix(np.stack([along, np.cross(side, along), side], axis=1))
    tilt = Rotation.from_rotvec(0.4 * along)

    def turn(t: np.ndarray) -> Rotation:
        return Rotation.from_rotvec((t[:, np.newaxis] - 1.0) * 0.1 * side) * tilt * frame

    found = ROBOT.watch(poses(lambda t: HOME + 0.0 * t, turn, 2.0), 40)
    assert found.first[1:] == ("leg_1", "limb")
    assert abs(found.first.time - 1.0) <= SOON


def turning_back(t: np.ndarray) -> Rotation:
    """From the paper's orientation through R = I at t = 1, where modes cross."""
    return Rotation.from_rotvec((1.0 - t)[:, np.newaxis] * START.as_rotvec())


def joints_turning_back(t: np.ndarray) -> np.ndarray:
    return ROBOT.inverse_displacement(HOME, turning_back(t[:, 0]))


@pytest.mark.parametrize("count", [20, 101])
def test_orientation_along_poses_and_where_modes_cross(count: int) -> None:
    found = ROBOT.watch(poses(lambda t: HOME + 0.0 * t, turning_back, 2.0), count)
    assert found.first[1:] == ("orientation", "direct")
    assert abs(found.first.time - 1.0) <= SOON
    assert len(found.times) == count
    followed = ROBOT.watch(joints(joints_turning_back, 2.0), count, start_rotation=START)
    assert followed.first[1:] == ("orientation", "direct")
    assert abs(followed.first.time - 1.0) <= SOON
    # The mode ends there, and so do the samples.
    assert followed.times[-1] < 1.0 < followed.times[-1] + 1e-5


def fold(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray, Rotation] | None:
    """Joint values of a singular pose, and those of a regular one and its rotation."""
    start = START * Rotation.from_rotvec(0.3 * rng.normal(size=3))
    axis, place = rng.normal(size=3), HOME + 0.1 * rng.normal(size=3)

    def orientation(angle: float) -> float:
        turned = Rotation.from_rotvec(angle * axis) * start
        return float(ROBOT.direct_singularity(place, turned).factors["orientation"])

    angles = np.linspace(0.0, 1.0, 40)
    values = np.array([orientation(angle) for angle in angles])
    change = np.flatnonzero((values[1:] * values[:-1] < 0.0) & (abs(values[1:]) < 0.5))
    if not change.size or change[0] < 3:
        return None
    root = brentq(orientation, angles[change[0]], angles[change[0] + 1], xtol=1e-15)
    regular, singular = (
        Rotation.from_rotvec(angle * axis) * start for angle in (angles[change[0] - 3], root)
    )
    return (
        ROBOT.inverse_displacement(place, singular),
        ROBOT.inverse_displacement(place, regular),
        regular,
    )


def test_where_modes_merge() -> None:
    """Straight to joint values of a singular pose: a fold at t = 1, or another one before."""
    rng, met = np.random.default_rng(1), 0
    while met < 5:
        found = fold(rng)
        if found is None:
            continue
        end, start, rotation = found
        motion = joints(lambda t, a=start, b=end: a + t * (b - a), 1.7)
        for count in (12, 90):
            watched = ROBOT.watch(motion, count, start_rotation=rotation)
            if watched.first is None:  # it passed on another mode
                break
            assert watched.first.kind == "direct"
            assert watched.first.time <= 1.0 + SOON
            if watched.first.time > 0.999:
                assert abs(watched.first.time - 1.0) <= SOON
                met += 1


def test_a_limit_before_the_end_of_a_mode() -> None:
    start, q1 = joints_turning_back(np.array([[0.0], [0.999]]))[:, 0]
    limits = {"q1": (0.0, q1)} if start < q1 else {"q1": (q1, 9.0)}
    found = ROBOT.watch(
        joints(joints_turning_back, 2.0), 40, start_rotation=START, limits=Limits(limits)
    )
    assert found.first.kind == "limit"
    assert abs(found.first.time - 0.999) <= SOON


def test_a_mode_by_its_number() -> None:
    motion = rest_to_rest(
        ROBOT.inverse_displacement(HOME, START),
        ROBOT.inverse_displacement([0.2, 0.1, 1.5], START),
        5.0,
    )
    modes = ROBOT.forward_displacement(motion.at([0.0]).joints[0])
    found = ROBOT.watch(motion, 40, mode=1)
    assert abs(found.rotations[0] - modes.rotation[1]).max() <= 1e-9


def test_what_is_asked_wrongly() -> None:
    motion = example_1()
    with pytest.raises(InputError, match=r"^count: "):
        ROBOT.watch(motion, 1, start_rotation=START)
    for count in (11.5, "11", None, True):
        with pytest.raises(InputError, match=r"^count: "):
            ROBOT.watch(motion, count, start_rotation=START)
    for mode in (0.0, True, 99, np.array([0, 1])):
        with pytest.raises(InputError, match=r"^mode: "):
            ROBOT.watch(motion, 20, mode=mode)
    with pytest.raises(InputError, match=r"^limits: "):
        ROBOT.watch(motion, 20, start_rotation=START, limits={"q1": (0.0, 1.0)})
    with pytest.raises(InputError, match="either start_rotation or mode="):
        ROBOT.watch(motion, 20)
    with pytest.raises(InputError, match="needs no start_rotation"):
        ROBOT.watch(poses(lambda t: HOME + 0.0 * t, lambda _: START, 1.0), 20, mode=0)
    with pytest.raises(TrackingError, match="sample 0"):
        ROBOT.watch(joints(lambda t: np.full((len(t), 6), 0.1), 1.0), 20, start_rotation=START)
