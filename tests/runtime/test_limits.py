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
        {"q1": (0, 10**5000)},
        {"q1": np.array(1.0)},
        {"q1": np.ones((2, 2))},
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


@pytest.mark.parametrize("name", ["q1", "q2", "q3", "q6"])
def test_ranges_that_no_length_is_in(name: str) -> None:
    with pytest.raises(InputError, match=rf"{name}: no joint value is in this range \({name} >= 0"):
        Limits({name: (-2.0, -1.0)})
    assert Limits({name: (-2.0, 0.0)}).range_of(name) == (-2.0, 0.0)


@pytest.mark.parametrize("given", [(1.6, 2.0), (-5.0, -1.6), (1.6, np.inf), (-np.inf, -3.0)])
def test_ranges_that_no_elevation_is_in(given: tuple[float, float]) -> None:
    with pytest.raises(InputError, match=r"q5: no joint value is in this range \(q5 in \[−π/2"):
        Limits({"q5": given})


@pytest.mark.parametrize("given", [(40, 90), (-10, 0.5), (0, 60), (7.0, np.inf)])
def test_degrees_that_are_not_said_to_be_degrees(given: tuple[float, float]) -> None:
    with pytest.raises(InputError, match='if these are degrees, say unit = "deg"'):
        Limits({"q5": given})


def test_degrees() -> None:
    given = {"q1": (1.0, 100.0), "q4": (-170, 170), "q5": (40, 90), "e1": (-9.0, np.inf)}
    limits = Limits(given, {"wrist": 0.1}, unit="deg")
    radians = {"q4": tuple(np.radians((-170, 170))), "q5": tuple(np.radians((40, 90)))}
    assert limits == Limits(given | radians, {"wrist": 0.1})
    assert limits.range_of("q5")[1] == np.pi / 2.0
    for copied in (copy.deepcopy(limits), pickle.loads(pickle.dumps(limits))):
        assert copied == limits
    with pytest.raises(InputError, match=r"q5: within a full turn is needed, \(0, 400\) arrived$"):
        Limits({"q5": (0, 400)}, unit="deg")


@pytest.mark.parametrize("unit", ["grad", "Deg", "", None, 1, ["deg"]])
def test_other_units(unit: object) -> None:
    with pytest.raises(InputError, match='unit: "rad" or "deg" is needed'):
        Limits({"q5": (0.0, 1.0)}, unit=unit)


def test_from_toml_in_degrees(tmp_path: Path) -> None:
    path = tmp_path / "limits.toml"
    text = "[ranges]\nq1 = [0.6, 1.5]\nq5 = [40, 90]\n"
    path.write_text(f'unit = "deg"\n{text}')
    assert Limits.from_toml(path) == Limits({"q1": (0.6, 1.5), "q5": (40, 90)}, unit="deg")
    path.write_text(text)
    with pytest.raises(InputError, match=r'limits.toml: q5: .*\[40, 90\] arrived.* unit = "deg"'):
        Limits.from_toml(path)


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
