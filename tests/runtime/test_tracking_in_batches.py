"""Samples polished in one batch are those that are followed one by one."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

import kleinform.tracking
from kleinform import TrackingError, UncoupledManipulator
from kleinform.paper.examples import example_1
from kleinform.polishing import polish
from kleinform.tracking import _first, _follow, _stations, _turned, track

ROBOT = UncoupledManipulator()
HOME = np.array([0.25, 0.2, 1.0])


def one_by_one(joints: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Rotations as every sample is followed from the one before."""
    first = _first(1.0, joints[0], start)
    rest = _follow(1.0, joints, first, 0, len(joints) - 1)
    return _turned(np.concatenate([first[np.newaxis], rest]))


def path(rng: np.random.Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    """A wild path of poses, near direct singularities or across them."""
    times = np.linspace(0.0, 6.0, count)
    waves = np.stack([np.sin(times), np.sin(2.0 * times)], axis=-1)
    turns = Rotation.from_rotvec(waves @ (0.5 * rng.normal(size=(2, 3)))) * Rotation.random(rng=rng)
    return HOME + waves @ (0.2 * rng.normal(size=(2, 3))), turns.as_matrix()


def test_wild_motions_lead_to_the_same_poses_or_to_errors() -> None:
    rng, same, refused, worst = np.random.default_rng(11), 0, 0, 0.0
    for _ in range(24):
        positions, rotations = path(rng, 90)
        joints = ROBOT.inverse_displacement(positions, rotations)
        joints[:, 3] = np.unwrap(joints[:, 3])
        try:
            expected = one_by_one(joints, rotations[0])
        except TrackingError:
            with pytest.raises(TrackingError):
                ROBOT.track(joints, rotations[0])
            refused += 1
            continue
        _, found = track(ROBOT.radius, joints, rotations[0])
        direct = ROBOT.direct_singularity(positions, found)
        near = min(
            float(np.min(abs(value) / direct.scales[name]))
            for name, value in direct.factors.items()
            if name != "wrist"
        )
        worst = max(worst, float(abs(found - expected).max()) * near)
        same += 1
    assert same >= 5
    assert refused >= 5
    # Rounding of the joints is divided by the smallest factor over its scale.
    assert worst <= 1e-14


def test_what_cannot_be_polished_is_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A stretch in doubt is followed sample by sample, to the same poses."""
    rng = np.random.default_rng(3)
    times = np.linspace(0.0, 1.0, 60)
    turns = Rotation.from_rotvec(times[:, np.newaxis] * 0.1 * rng.normal(size=3))
    start = Rotation.from_euler("ZYX", np.deg2rad([6.0, 3.0, 10.0]))
    rotations = (turns * start).as_matrix()
    joints = ROBOT.inverse_displacement(np.broadcast_to(HOME, (60, 3)), rotations)
    sound = ROBOT.track(joints, rotations[0])
    doubted = []

    def in_doubt(*arguments: object) -> tuple[np.ndarray, np.ndarray]:
        found, sure = polish(*arguments)
        assert sure.all()
        found[20:30], sure[20:30] = np.nan, False
        doubted.append(True)
        return found, sure

    monkeypatch.setattr(kleinform.tracking, "polish", in_doubt)
    followed = ROBOT.track(joints, rotations[0])
    assert doubted
    for one, other in zip(sound, followed, strict=True):
        assert abs(one - other).max() <= 1e-13


def test_an_excursion_after_a_rest_is_not_stepped_over() -> None:
    """At rest the stations are ever farther apart; what comes back has been away."""
    joints = example_1().sampled(64).joints
    start = Rotation.from_euler("ZYX", np.deg2rad([6.0, 3.0, 10.0]))
    rest = np.repeat(joints[:1], 300, axis=0)
    first = _first(1.0, joints[0], start.as_matrix())
    stations = list(_stations(1.0, np.concatenate([rest, joints, rest]), first))
    assert len(stations) < 300
    assert max(np.diff(stations)) > 100
    assert sum(300 < station < 364 for station in stations) >= 10
    _, found = track(ROBOT.radius, np.concatenate([rest, joints, rest]), start.as_matrix())
    expected = one_by_one(joints, start.as_matrix())
    assert abs(found[300:364] - expected).max() <= 1e-11


@pytest.mark.parametrize("parts", [1, kleinform.tracking.PARTS])
def test_a_loop_that_changes_the_mode_and_a_rest_after_it(
    parts: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The joint values come back, the platform does not; at rest it stays where it is.

    A turn between two modes of the same joint values meets no singularity. Looked at in one
    part, a stretch goes over the loop, and its station lies in the mode before it.
    """
    monkeypatch.setattr(kleinform.tracking, "PARTS", parts)
    place = np.array([-0.022299082198072133, -0.5289904259769532, 0.9043123949706929])
    ends = Rotation.from_rotvec(
        [
            [-0.38965806234088995, -0.5014126422663502, -0.7242842532669038],
            [-0.5227289327259365, -0.6564506035956945, -0.5868238265713555],
        ]
    )
    turn = Slerp([0.0, 1.0], ends)(np.linspace(0.0, 1.0, 100)).as_matrix()
    loop = ROBOT.inverse_displacement(np.broadcast_to(place, (100, 3)), turn)
    loop[-1] = loop[0]
    away = np.array([0.020745, 0.008467, 0.012381, 0.002724, -0.005737, 0.021173])
    share = np.concatenate([np.linspace(0.0, 1.0, 14), np.linspace(1.0, 0.0, 14)])
    rest = np.tile(loop[0], (128, 1))
    path = np.concatenate([rest, loop[0] + share[:, np.newaxis] * away, loop, rest])
    _, found = ROBOT.track(path, turn[0])
    assert abs(found - one_by_one(path, turn[0])).max() <= 1e-9
    assert abs(found[-1] - turn[-1]).max() <= 1e-9
    assert abs(found[128] - found[-1]).max() >= 0.1
