"""Tables in and out: every format, every way that it is written, exactly."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from kleinform.commands import progress
from kleinform.commands.streams import Streams
from tests.cli.support import PAPER, array, random_poses, read, read_csv, write

#: More than two blocks, the last of them not full.
COUNT = 20_000


@pytest.fixture(scope="module")
def poses():
    return random_poses(COUNT)


@pytest.mark.parametrize("suffix", [".csv", ".json", ".jsonl", ".npz"])
def test_all_formats_are_equal(run, tmp_path: Path, poses, suffix: str) -> None:
    """To the last bit, read and written."""
    write(tmp_path / "poses.npz", poses)
    write(tmp_path / f"poses{suffix}", poses)
    for source in ("poses.npz", f"poses{suffix}"):
        for target in ("q.npz", f"q{suffix}"):
            ran = run("inverse", "--input", source, "--output", target, "--degrees")
            assert (ran.code, ran.out, ran.err) == (0, "", "")
    np.testing.assert_array_equal(
        array(read(tmp_path / "q.npz")), array(read(tmp_path / f"q{suffix}"))
    )
    assert {path.name for path in tmp_path.iterdir()} == {
        "poses.npz",
        f"poses{suffix}",
        "q.npz",
        f"q{suffix}",
    }


@pytest.mark.parametrize("form", ["csv", "json"])
def test_standard_input_and_output(run, tmp_path: Path, form: str) -> None:
    poses = random_poses(10)
    path = write(tmp_path / f"poses.{form}", poses)
    piped = run("inverse", "--input", "-", "--degrees", "--format", form, stdin=path.read_text())
    run("inverse", "--input", path, "--degrees", "--output", f"q.{form}")
    assert piped.out == (tmp_path / f"q.{form}").read_text()


def test_columns_may_come_in_any_order_with_others(run) -> None:
    """With a byte order mark, blank lines, carriage returns, quotes, words."""
    text = '\ufeffid,yaw,x,y,z,roll,pitch\r\n\r\n"a, b",6,0.25,0.2,"1.0",10,3\r\n\r\n'
    ran = run("inverse", "--input", "-", "--degrees", stdin=text)
    assert ran.out == run("inverse", *PAPER).out


def test_an_array_of_objects_is_read(run) -> None:
    pose = {"x": 0.25, "y": 0.2, "z": 1, "roll": 10, "pitch": 3, "yaw": 6, "name": "a"}
    text = json.dumps([pose, pose], indent=1)
    ran = run("inverse", "--input", "-", "--degrees", "--format", "json", stdin=text)
    one = run("inverse", *PAPER, "--format", "json")
    assert ran.out == 2 * one.out


def test_no_rows_are_no_rows(run, tmp_path: Path) -> None:
    header = "x,y,z,roll,pitch,yaw\n"
    (tmp_path / "none.csv").write_text(header)
    write(tmp_path / "none.npz", {name: np.zeros(0) for name in header.strip().split(",")})
    for source in ("none.csv", "none.npz"):
        assert run("inverse", "--input", source).out == "q1,q2,q3,q4,q5,q6\n"
        assert run("inverse", "--input", source, "--output", "q.npz").code == 0
        assert all(column.shape == (0,) for column in read(tmp_path / "q.npz").values())
        for command in ("singularity", "inverse"):
            assert run(command, "--input", source).out.count("\n") == 1


def test_json_without_nan_and_infinity(run) -> None:
    """Null for NaN, a number beyond float64 for infinity: standard JSON."""
    pose = ("--position", 0.3, 0, 1, "--rpy", 90, 0, 90, "--degrees")
    ran = run("singularity", *pose, "--format", "json")
    assert "NaN" not in ran.out
    assert "Infinity" not in ran.out
    origin = run("singularity", "--position", 0, 0, 0, "--rpy", 0, 0, 0, "--format", "json")
    assert json.loads(origin.out)["wrist"] is None


def test_npz_with_float32_and_integers(run, tmp_path: Path) -> None:
    poses = random_poses(5)
    poses["x"] = np.array([0.25] * 5, dtype=np.float32)
    poses["z"] = np.ones(5, dtype=">i4")
    np.savez_compressed(tmp_path / "poses.npz", **poses)
    answer = run("inverse", "--input", "poses.npz", "--degrees").out
    write(tmp_path / "poses.csv", poses)
    assert answer == run("inverse", "--input", "poses.csv", "--degrees").out


def test_nan_rows(run, tmp_path: Path, poses) -> None:
    """Those rows and no others, in whichever block, and their number on standard error."""
    spoiled = {name: column.copy() for name, column in poses.items()}
    bad = np.array([3, 8191, 8192, 19_999])
    spoiled["x"][bad[:2]] = spoiled["y"][bad[:2]] = 0.0
    spoiled["roll"][bad[2:]] = np.nan
    for suffix in (".csv", ".json", ".npz"):
        write(tmp_path / f"poses{suffix}", spoiled)
        ran = run(
            *("inverse", "--input", f"poses{suffix}", "--output", f"q{suffix}"),
            *("--degrees", "--errors", "nan"),
        )
        assert ran.code == 0
        place = {".csv": "line 5", ".json": "line 4", ".npz": "row 3"}[suffix]
        assert ran.err == f"kleinform: rows refused: 4, the first at poses{suffix}, {place}\n"
        answer = array(read(tmp_path / f"q{suffix}"))
        assert np.array_equal(np.flatnonzero(np.isnan(answer).all(axis=1)), bad)
        assert np.isnan(answer).sum() == 24


@pytest.mark.parametrize("command", ["velocity", "singularity", "forward"])
def test_nan_rows_of_other_commands(run, tmp_path: Path, command: str) -> None:
    table = random_poses(4)
    if command == "velocity":
        table |= {name: np.ones(4) for name in ("wx", "wy", "wz", "vx", "vy", "vz")}
    if command == "forward":
        joints = [1.0, 1.2, 0.9, 40.0, 70.0, 1.0]
        table = {f"q{i + 1}": np.full(4, value) for i, value in enumerate(joints)}
    table[next(iter(table))][2] = np.nan
    write(tmp_path / "in.csv", table)
    ran = run(command, "--input", "in.csv", "--degrees", "--errors", "nan")
    assert ran.err == "kleinform: rows refused: 1, the first at in.csv, line 4\n"
    answer = read_csv(ran.out)
    if command == "forward":
        assert list(answer["status"][answer["row"] == 2]) == ["invalid"]
    else:
        assert np.array_equal(np.isnan(next(iter(answer.values()))), [False, False, True, False])


def test_an_existing_file_is_replaced_through_a_link(run, tmp_path: Path) -> None:
    (tmp_path / "old.csv").write_text("old")
    (tmp_path / "link.csv").symlink_to("old.csv")
    assert run("inverse", *PAPER, "--output", "link.csv").code == 0
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "old.csv").read_text() == run("inverse", *PAPER).out


def test_the_input_may_be_replaced(run, tmp_path: Path) -> None:
    write(tmp_path / "table.csv", random_poses(9000))
    assert run("inverse", "--input", "table.csv", "--output", "table.csv", "--degrees").code == 0
    assert len(read(tmp_path / "table.csv")["q1"]) == 9000


@pytest.mark.parametrize("terminal", [True, False])
def test_the_bar_is_for_terminals(
    run, tmp_path: Path, poses, monkeypatch: pytest.MonkeyPatch, terminal: bool
) -> None:
    write(tmp_path / "poses.csv", poses)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal)
    monkeypatch.setenv("TERM", "xterm")
    ran = run("inverse", "--input", "poses.csv", "--output", "q.csv")
    assert ran.code == 0
    assert ("rows" in ran.err) is terminal
    monkeypatch.setattr(Streams, "on_terminal", True)
    assert run("inverse", "--input", "poses.csv").err == ""
