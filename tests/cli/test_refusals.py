"""Errors: one line that says what and where, exit code 2, and no file half written."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from kleinform import cli
from tests.cli.support import random_poses, write

HEADER = "x,y,z,roll,pitch,yaw\n"
GOOD = "0.25,0.2,1.0,0.1,0.2,0.3\n"
POSE = '{"x": 0.25, "y": 0.2, "z": 1.0, "roll": 0.1, "pitch": 0.2, "yaw": 0.3}\n'


def refused(ran) -> str:
    """The message of a command that stopped."""
    assert ran.code == 2
    assert ran.err.startswith("kleinform: ")
    assert ran.err.count("\n") == 1
    return ran.err.removeprefix("kleinform: ").removesuffix("\n")


@pytest.mark.parametrize("suffix", [".csv", ".json", ".npz"])
@pytest.mark.parametrize("kept", [False, True])
def test_a_singular_row_in_a_later_block(run, tmp_path: Path, suffix: str, kept: bool) -> None:
    """Its place in the whole input; what was in the output's place stays."""
    poses = random_poses(20_000)
    poses["x"][10_000] = poses["y"][10_000] = 0.0
    write(tmp_path / f"poses{suffix}", poses)
    before = {path.name for path in tmp_path.iterdir()}
    for target in ("q.csv", "q.json", "q.npz"):
        if kept:
            (tmp_path / target).write_text("kept")
            before.add(target)
        message = refused(run("inverse", "--input", f"poses{suffix}", "--output", target))
        place = {".csv": "line 10002", ".json": "line 10001", ".npz": "row 10000"}[suffix]
        rule = "C is on the Z axis, q4 is free: give --azimuth; 0.0 arrived"
        assert message == f"poses{suffix}, {place}: {rule}"
        assert {path.name for path in tmp_path.iterdir()} == before
        assert not kept or (tmp_path / target).read_text() == "kept"


def test_blocks_before_the_error_are_written_to_a_stream(run) -> None:
    """That is the nature of streams."""
    ran = run("inverse", "--input", "-", stdin=HEADER + 9000 * GOOD + "0,0,1,0,0,0\n")
    assert refused(ran).startswith("standard input, line 9002: C is on the Z axis")
    assert ran.out.count("\n") == 8193


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("0.25,abc,1.0,0.1,0.2,0.3", "y: a number is needed, 'abc' arrived"),
        ("0.25,,1.0,0.1,0.2,0.3", "y: a finite number is needed, a blank arrived"),
        ("0.25,0.2,1.0,0.1,0.2", "6 fields are needed, 5 arrived"),
        ("0.25,0.2,1.0,0.1,0.2,0.3,", "6 fields are needed, 7 arrived"),
        ('0.25,0.2,1.0,0.1,0.2,"0.3', "unexpected end of data"),
        ("0.25,0.2,1.0,0.1,0.2,nan", "yaw: a finite number is needed, nan arrived"),
        ("0.25,NA,1.0,0.1,0.2,0.3", "y: a finite number is needed, NA arrived"),
        ("0.25,1_0,1.0,0.1,0.2,0.3", "y: a number is needed, '1_0' arrived"),
    ],
)
def test_a_malformed_line_of_csv(run, line: str, message: str) -> None:
    text = HEADER + 9000 * GOOD + "\n" + line + "\n" + GOOD
    assert refused(run("inverse", "--input", "-", stdin=text)) == (
        f"standard input, line 9003: {message}"
    )


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (POSE.replace("1.0", '"1.0"'), 'z: a number is needed, "1.0" arrived'),
        (POSE.replace("1.0", "true"), "z: a number is needed, true arrived"),
        (POSE.replace("1.0", "1" + 400 * "0"), "z: beyond float64"),
        (POSE.replace('"z": 1.0, ', ""), "z is missing; x, y, roll, pitch, yaw arrived"),
        (POSE.replace("1.0", "null"), "z: a finite number is needed, null arrived"),
        (POSE.replace('"z"', '"y"'), "no JSON: y is there twice"),
        ("[1, 2]", "an object is needed, [1, 2] arrived"),
        ("{", "no JSON: Expecting property name enclosed in double quotes: line 2 column 1 "),
    ],
)
def test_a_malformed_line_of_json(run, line: str, message: str) -> None:
    text = 9000 * POSE + line.rstrip() + "\n" + POSE
    ran = run("inverse", "--input", "-", "--format", "json", stdin=text)
    assert refused(ran).startswith(f"standard input, line 9001: {message}")


def test_a_malformed_array_of_json(run) -> None:
    arguments = ("inverse", "--input", "-", "--format", "json")
    assert "line 1: no JSON array: " in refused(run(*arguments, stdin="[1,\n2"))
    assert "row 1: an object is needed" in refused(run(*arguments, stdin=f"[{POSE}, 3]"))


@pytest.mark.parametrize("form", ["csv", "json"])
def test_an_empty_input(run, form: str) -> None:
    for text in ("", "\n\n"):
        message = refused(run("inverse", "--input", "-", "--format", form, stdin=text))
        assert message.startswith("standard input: empty, ")


def test_columns_that_are_missing_or_there_twice(run) -> None:
    text = "x,y,roll,yaw,id\n1,2,3,4,5\n"
    assert refused(run("inverse", "--input", "-", stdin=text)) == (
        "standard input: column z, pitch is missing; x, y, roll, yaw, id arrived"
    )
    text = HEADER.replace("x,", "x,x,") + "1," + GOOD
    message = refused(run("inverse", "--input", "-", stdin=text))
    assert message == "standard input: column x is there twice"


def test_a_text_that_is_none(run, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_bytes(HEADER.encode() + b"\xff\n")
    assert refused(run("inverse", "--input", "poses.csv")).startswith("poses.csv: not a text in ")


@pytest.mark.parametrize(
    ("arrays", "message"),
    [
        ({"x": np.ones((2, 2))}, "x: an array (rows,) of real numbers up to float64 is needed, "),
        ({"x": np.array([None, 1])}, "x: an array (rows,) of real numbers"),
        ({"x": np.ones(2, dtype=bool)}, "x: an array (rows,) of real numbers"),
        ({"y": np.ones(3)}, "x has 2 rows, y 3"),
    ],
)
def test_an_npz_that_is_no_table(run, tmp_path: Path, arrays, message: str) -> None:
    table = {name: np.ones(2) for name in HEADER.strip().split(",")}
    np.savez(tmp_path / "poses.npz", **(table | arrays))
    assert refused(run("inverse", "--input", "poses.npz")).startswith(f"poses.npz: {message}")


@pytest.mark.parametrize("rates", [False, True])
@pytest.mark.parametrize(
    ("times", "line"), [((0.0, "nan"), 3), ((0.1, 0.1), 3), ((0.0, 0.1, 0.1), 4), ((1.0, 0.5), 3)]
)
def test_times_that_do_not_go_on(run, tmp_path: Path, rates: bool, times, line: int) -> None:
    """With rates and without, the row is named."""
    names = [f"q{i}" for i in range(1, 7)]
    values = [1.0, 1.19, 0.87, 0.67, 1.26, 1.05]
    if rates:
        names += [f"dq{i}" for i in range(1, 7)] + [f"ddq{i}" for i in range(1, 7)]
        values += [0.0] * 12
    rows = [",".join(["t", *names]), *(",".join(map(str, [t, *values])) for t in times)]
    (tmp_path / "motion.csv").write_text("\n".join(rows) + "\n")
    message = refused(run("trajectory", "--input", "motion.csv", "--mode", 0))
    rule = "t: a finite number is needed, nan" if "nan" in times else "times: each after the one"
    assert message.startswith(f"motion.csv, line {line}: {rule}")


def test_an_npz_that_is_damaged(run, tmp_path: Path) -> None:
    path = write(tmp_path / "poses.npz", random_poses(1000))
    data = path.read_bytes()
    path.write_bytes(data[:5000])
    assert refused(run("inverse", "--input", path.name)).startswith("poses.npz: not an NPZ: ")
    path.write_bytes(data[:4000] + b"\0" + data[4001:])
    assert refused(run("inverse", "--input", path.name)) == (
        "poses.npz: x: cut off: Bad CRC-32 for file 'x.npy'"
    )
    path.write_bytes(data.replace(b"NUMPY", b"numpy"))
    assert refused(run("inverse", "--input", path.name)).startswith("poses.npz: x: not an array: ")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("inverse", "either --position and --rpy, or --input is needed"),
        ("inverse --position 0 0 1 --rpy 0 0 0 --input a.csv", "either --position and --rpy, or "),
        ("inverse --position 0 0 1", "--position, --rpy belong together: --rpy is missing"),
        ("inverse --position 0 0", "Option '--position' requires 3 arguments."),
        ("inverse --position 0 0 a --rpy 0 0 0", "Invalid value for '--position'"),
        ("inverse --input none.csv", "none.csv: No such file or directory"),
        ("inverse --input poses.txt", "poses.txt: the name must end in one of .csv, .json, "),
        ("inverse --input - --format npz", "Invalid value for '--format'"),
        ("inverse --input . ", ".: the name must end in "),
        (
            "inverse --position 0 0 1 --rpy 0 0 nan",
            "--rpy: yaw: a finite number is needed",
        ),
        (
            "inverse --position 0.1 0 1 --rpy 0 0 0 --radius 0",
            "--radius: positive, at least",
        ),
        ("inverse --position 0.1 0 1 --rpy 0 0 0 --errors no", "Invalid value for '--errors'"),
        ("inverse --position 0.1 0 1 --rpy 0 0 0 --output a/b.csv", "a/b.csv: there is no folder"),
        ("inverse --position 0.1 0 1 --rpy 0 0 0 --output folder.csv", "folder.csv: not a file"),
        ("inverse --position 0.1 0 1 --rpy 0 0 0 --output /dev/null", "/dev/null: the name must"),
        ("inverse --colour", "No such option: --colour"),
        ("turn", "No such command 'turn'."),
        ("velocity --position 0.1 0 1 --rpy 0 0 0", "--position, --rpy, --twist belong together"),
        (
            "velocity --twist 0 0 0 0 0 0 --rates 0 0 0 0 0 0",
            "either --twist or --rates is needed, both arrived",
        ),
        ("velocity --input poses.csv", "poses.csv: either the columns wx, wy, wz, vx, vy, vz or "),
        ("forward --joints 1 1 1 0 2 1", "--joints: q5 in [−π/2, π/2] is needed; 2.0 arrived"),
        ("forward --input poses.csv --certify", "--certify is for one set of joint values"),
        ("trajectory", "either --example or --input is needed"),
        ("trajectory --input poses.csv --example 1", "either --example or --input is needed"),
        ("trajectory --input poses.csv", "--input needs either --mode or --start-rpy"),
        ("trajectory --example 1 --mode 9", "--mode: the first sample has 4 modes, 9 arrived"),
        ("trajectory --example 1 --samples 1", "--samples: at least 2 samples are needed"),
        (
            "trajectory --example 1 --mode 1 --start-rpy 0 0 0",
            "either --mode or --start-rpy is needed, both arrived",
        ),
        ("trajectory --input poses.csv --mode 0", "poses.csv: column t, q1, q2, q3, q4, q5, q6 is"),
        ("latex j_Q", "no formula is called 'j_Q'; close: J_q"),
    ],
)
def test_what_cannot_be_done(run, tmp_path: Path, arguments: str, message: str) -> None:
    (tmp_path / "poses.csv").write_text(HEADER + GOOD)
    (tmp_path / "folder.csv").mkdir()
    ran = run(*arguments.split())
    assert refused(ran).startswith(message)
    assert ran.out == ""


def test_a_motion_that_cannot_be_followed(run, tmp_path: Path) -> None:
    """The line of the sample at which it ends."""
    joints = np.tile([1.0, 1.2, 0.9, 0.7, 1.26, 1.05], (5, 1))
    joints[3, :3] = 0.01
    names = ["t", *(f"q{i}" for i in range(1, 7))]
    table = dict(zip(names, [np.arange(5.0), *joints.T], strict=True))
    write(tmp_path / "motion.csv", table)
    message = refused(run("trajectory", "--input", "motion.csv", "--mode", 0))
    assert message.startswith("motion.csv, line 5: sample 3: ")
    table["q1"][2] = -1.0
    write(tmp_path / "motion.csv", table)
    message = refused(run("trajectory", "--input", "motion.csv", "--mode", 0))
    assert message == "motion.csv, line 4: joints: q1 >= 0 is needed; -1.0 arrived"


def test_a_missing_engine_is_one_line(run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    assert "kleinform[verify]" in refused(run("verify"))


@pytest.mark.parametrize("package", ["typer", "rich"])
def test_without_the_extra_one_line_says_what_to_install(
    run, monkeypatch: pytest.MonkeyPatch, package: str
) -> None:
    for name in list(sys.modules):
        if name.startswith(("kleinform.commands", "rich.")):
            monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, package, None)
    assert refused(run()) == (
        f"{package} is missing; install the extra: pip install 'kleinform[cli]'"
    )


def test_an_error_of_another_kind_is_not_hidden(run, monkeypatch: pytest.MonkeyPatch) -> None:
    from kleinform import UncoupledManipulator

    monkeypatch.setattr(UncoupledManipulator, "survey", None)
    monkeypatch.setattr(
        sys,
        "argv",
        ["kleinform", "singularity", "--position", "0", "0", "1", "--rpy", "0", "0", "0"],
    )
    with pytest.raises(TypeError):
        cli.main()
