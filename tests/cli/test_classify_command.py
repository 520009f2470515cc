"""``kleinform classify``: codes, names and factors of poses, and of one pose its meaning."""

from __future__ import annotations

import json

import numpy as np
import pytest

from kleinform import UncoupledManipulator
from kleinform.commands.columns import FACTORS
from kleinform.commands.inverse import rotation_of
from kleinform.commands.streams import Streams
from tests.cli.support import PAPER, random_poses, read_csv, write

#: C on the Z axis, and C at O.
AXIS = ("--position", 0, 0, 1, "--rpy", 0, 0, 6, "--degrees")
ORIGIN = ("--position", 0, 0, 0, "--rpy", 0, 0, 6, "--degrees")


def test_one_pose(run) -> None:
    answer = read_csv(run("classify", *PAPER).out)
    assert list(answer) == ["code", "class", *FACTORS]
    assert (answer["code"], answer["class"]) == ([0], ["regular"])
    survey = UncoupledManipulator().survey([0.25, 0.2, 1.0], rotation_of((10, 3, 6), True))
    for name in FACTORS:
        assert answer[name] == [survey.factors[name]]


def test_a_table(run, tmp_path) -> None:
    """Several classes stand in one column, with spaces between."""
    poses = random_poses(4)
    for name in ("x", "y"):
        poses[name][1] = 0.0
    for name in ("z", "roll", "pitch"):
        poses[name][2] = 0.0
    write(tmp_path / "poses.csv", poses)
    answer = read_csv(run("classify", "--input", "poses.csv", "--degrees").out)
    np.testing.assert_array_equal(answer["code"], [0, 1, 6, 0])
    assert answer["class"].tolist() == ["regular", "inverse", "direct wrist", "regular"]


def test_a_row_that_is_no_pose(run) -> None:
    text = "x,y,z,roll,pitch,yaw\n0,0,1,0,0,nan\n0,0,1,0,0,0.1\n"
    ran = run("classify", "--input", "-", "--errors", "nan", stdin=text)
    assert read_csv(ran.out)["class"].tolist() == ["invalid", "inverse"]
    assert ran.err == "kleinform: rows refused: 1, the first at standard input, line 2\n"
    assert run("classify", "--input", "-", stdin=text).code == 2


def test_the_meaning_is_for_terminals(run, monkeypatch: pytest.MonkeyPatch) -> None:
    line = "C is at O, the central limb has no direction: q4 and q5 move nothing"
    assert line not in run("classify", *ORIGIN).out
    monkeypatch.setattr(Streams, "on_terminal", True)
    shown = run("classify", *ORIGIN).out
    assert shown.startswith("code ")
    assert line in shown.splitlines()
    answer = json.loads(run("classify", *AXIS, "--format", "json").out)
    assert (answer["code"], answer["class"], answer["central"]) == (1, "inverse", 0.0)
