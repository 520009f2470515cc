"""Limits as data."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

from kleinform import InputError, Limits


def test_ranges_and_margins_by_name() -> None:
    limits = Limits({"q1": (1, 2), "e3": (0.1, np.inf)}, {"wrist": 0.1})
    assert limits.range_of("q1") == (1.0, 2.0)
    assert limits.range_of("q2") == (-np.inf, np.inf)
    assert limits.margins == {"wrist": 0.1}
    assert Limits() == Limits({}, {})


def test_room_is_how_far_each_end_is_away() -> None:
    limits = Limits({"q2": (1.0, 2.0), "e3": (0.1, np.inf)})
    joints = np.arange(12.0).reshape(2, 6)
    room = limits.room(joints, np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]))
    assert {name: value.tolist() for name, value in room.items()} == {
        "q2 low": [0.0, 6.0],
        "q2 high": [1.0, -5.0],
        "e3 low": [2.9, 5.9],
    }


def test_typical_limits_grow_with_the_machine() -> None:
    small, large = Limits.typical(1.0), Limits.typical(10.0)
    assert large.range_of("q1") == tuple(10.0 * end for end in small.range_of("q1"))
    assert large.range_of("q5") == small.range_of("q5")


@pytest.mark.parametrize(
    "given",
    [
        {"q7": (0.0, 1.0)},
        {"q1": (1.0, 0.0)},
        {"q1": (1.0, 1.0)},
        {"q1": (np.nan, 1.0)},
        {"q1": 3.0},
        {"q1": (0.0, 1.0, 2.0)},
        {"q1": "ab"},
        {"q1": "12"},
        {"q1": ("0.6", "1.5")},
        {"q1": (False, True)},
        {"q1": {1: 0, 2: 0}},
        {"q1": (0, 10**400)},
        [("q1", (0.0, 1.0))],
    ],
)
def test_bad_ranges_are_refused(given: object) -> None:
    with pytest.raises(InputError):
        Limits(given)


@pytest.mark.parametrize(
    "given",
    [
        {"q1": 0.1},
        {"wrist": -0.1},
        {"wrist": np.inf},
        {"wrist": np.nan},
        {"wrist": "a"},
        {"wrist": True},
        {"wrist": 10**400},
    ],
)
def test_bad_margins_are_refused(given: dict[str, object]) -> None:
    with pytest.raises(InputError):
        Limits(margins=given)


def test_limits_stay_as_they_were_checked() -> None:
    given = {"q1": (1, 2)}
    limits = Limits(given, {"wrist": np.float32(0.5)})
    given["q1"] = (5, -5)
    assert limits.ranges == {"q1": (1.0, 2.0)}
    with pytest.raises(TypeError):
        limits.ranges["q1"] = (5.0, -5.0)
    for copied in (copy.deepcopy(limits), pickle.loads(pickle.dumps(limits))):
        assert copied == limits


def test_from_toml(tmp_path: Path) -> None:
    path = tmp_path / "limits.toml"
    path.write_text("[ranges]\nq1 = [0.6, 1.5]\ne1 = [0.2, inf]\n[margins]\nwrist = 0.1\n")
    assert Limits.from_toml(path) == Limits({"q1": (0.6, 1.5), "e1": (0.2, np.inf)}, {"wrist": 0.1})


@pytest.mark.parametrize(
    "text", ["[ranges", "[other]\nq1 = [0, 1]", "[ranges]\nq1 = [2, 1]", "ranges = 3"]
)
def test_what_is_no_file_of_limits_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "limits.toml"
    path.write_text(text)
    with pytest.raises(InputError):
        Limits.from_toml(path)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        Limits.from_toml(tmp_path / "none.toml")
