"""Why a workspace is empty: limits that exclude each other, each of them needed."""

from math import inf

import numpy as np
import pytest

pytest.importorskip("flint")

from kleinform import InputError, Limits
from kleinform.maps.workspace import Workspace
from tests.maps.workspace_support import LEGS, PAPER, ROBOT, SPACES, workspace
from tests.support import many, random_rotation


@pytest.mark.parametrize(
    ("ranges", "conflict"),
    [
        ({"q6": (0.7, 1.4), "q1": (4.0, 5.0)}, ("q1 low", "q6 high")),
        ({"q6": (3.0, 4.0), **LEGS}, ("q1 high", "q2 high", "q3 high", "q6 low")),
        ({"q6": (0.7, 1.4), "e1": (4.0, inf), "q5": (0.1, 0.2)}, ("e1 low", "q6 high")),
        ({"q6": (0.7, 1.4), "e1": (-9.0, -8.0)}, ("e1 high", "q6 high")),
        (
            {"q6": (1.0, 1.4), "q4": (-0.1, 0.1), "q5": (-0.1, 0.1), "q1": (0.9, 1.0)},
            ("q1 low", "q4 low", "q4 high", "q5 low", "q5 high", "q6 low", "q6 high"),
        ),
    ],
)
def test_known_conflicts(ranges: dict, conflict: tuple[str, ...]) -> None:
    found = workspace(PAPER, ranges).conflict()
    assert set(found) <= set(conflict)
    assert check(workspace(PAPER, ranges), found) == 0


@pytest.mark.parametrize("name", SPACES)
def test_no_conflict(name: str) -> None:
    assert SPACES[name].conflict() == ()


def test_what_is_not_sure_is_no_conflict() -> None:
    """The point O is the workspace; in another orientation the three lines do not meet."""
    points = dict.fromkeys(("q1", "q2", "q3"), (-1.0, 0.0))
    assert workspace(np.eye(3), points).conflict() == ()
    assert len(workspace(PAPER, points).conflict()) == 2
    with pytest.raises(InputError, match="unbounded"):
        workspace(PAPER, {"q1": (0.5, 1.0)}).conflict()


def positions_of(space: Workspace) -> np.ndarray:
    """Random positions in the box that keep every limit by the robot's survey."""
    low, high = space.box
    positions = np.random.default_rng(1).uniform(low, high, (20_000, 3))
    survey = ROBOT.survey(positions, space.rotation, errors="nan")
    room = space.limits.room(survey.joints, survey.extension)
    return positions[np.all([value >= 0.0 for value in room.values()], axis=0)]


def is_bounded(space: Workspace) -> bool:
    try:
        return np.isfinite(space.box).all()
    except InputError:
        return False


def has_positions(space: Workspace) -> bool:
    """By random positions, or by a proven volume where they are few."""
    if len(positions_of(space)):
        return True
    volume = space.volume(1e-3)
    return volume.value > volume.error


def without(limits: Limits, ends: set[str]) -> Limits:
    """The limits but for some ends."""
    ranges = {}
    for name, (low, high) in limits.ranges.items():
        low = -inf if f"{name} low" in ends else low
        ranges[name] = (low, inf if f"{name} high" in ends else high)
    return Limits(ranges)


def check(space: Workspace, conflict: tuple[str, ...]) -> int:
    """These ends exclude each other, and without one of them they do not, if they bound.

    How many of them could be left out, if it were not within a hair of a position.
    """
    undecided = 0
    ends = {f"{name} {end}" for name in space.limits.ranges for end in ("low", "high")}
    alone = workspace(space.rotation, without(space.limits, ends - set(conflict)).ranges)
    assert len(conflict) >= 2
    assert len(positions_of(alone)) == 0
    for end in conflict:
        other = {end.replace("low", "high")} if end.startswith("q4") else set()
        left_out = without(alone.limits, {end} | other)
        fewer = workspace(space.rotation, left_out.ranges)
        if is_bounded(fewer):
            assert fewer.conflict() == ()
            undecided += not has_positions(fewer)
    return undecided


def random_ranges(rng: np.random.Generator) -> dict:
    """Some limits of a machine, or all."""
    ranges = {}
    typical = Limits.typical().ranges | {"q4": (-1.0, 1.0)}
    for name, (low, high) in typical.items():
        low, high = np.sort(rng.uniform(low, high, 2)) if rng.random() < 0.3 else (low, high)
        if rng.random() < 0.8:
            ranges[name] = (low if rng.random() < 0.8 else -inf, high)
    return ranges | {"q6": (0.3, 1.4)}


@pytest.mark.long
def test_conflicts_at_random() -> None:
    """A conflict exactly where there are no positions."""
    rng = np.random.default_rng(7)
    empty = undecided = 0
    for _ in range(many(20, 200)):
        space = workspace(random_rotation(rng), random_ranges(rng))
        conflict = space.conflict()
        if conflict:
            empty += 1
            undecided += check(space, conflict)
        else:
            assert has_positions(space)
    assert empty > 5
    assert undecided <= 0.02 * empty
