"""Degrees that are not said to be degrees are refused, wherever they arrive, with a hint."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.cli.support import random_poses, write
from tests.support import many

HINT = "if angles are in degrees, give --degrees"
POSE = ("--position", 0.25, 0.2, 1.0)
JOINTS = ("--joints", 1.0, 1.191, 0.869, 38.657, 72.247, 1.05)
ZEROS = (0, 0, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("arguments", "start"),
    [
        (("inverse", *POSE, "--rpy", 10, 3, 6), "--rpy: roll: "),
        (("inverse", *POSE, "--rpy", 1, -7, 6), "--rpy: pitch: "),
        (("singularity", *POSE, "--rpy", 1, 3, 60), "--rpy: yaw: "),
        (("classify", *POSE, "--rpy", 10, 3, 6), "--rpy: roll: "),
        (("velocity", *POSE, "--rpy", 10, 3, 6, "--twist", *ZEROS), "--rpy: roll: "),
        (("velocity", *POSE, "--rpy", 10, 3, 6, "--rates", *ZEROS), "--rpy: roll: "),
        (("forward", *JOINTS), "q5: "),
        (("forward", *JOINTS, "--errors", "nan"), "q5: "),
        (("inverse", *POSE, "--rpy", 10, 3, 6, "--errors", "nan"), "--rpy: roll: "),
        (("workspace", "--rpy", 10, 3, 6), "--rpy: roll: "),
        (("singularities", "--rpy", 10, 3, 6), "--rpy: roll: "),
        (("trajectory", "--example", 1, "--start-rpy", 10, 3, 6), "--start-rpy: roll: "),
    ],
)
def test_options(run, arguments: tuple[object, ...], start: str) -> None:
    ran = run(*arguments)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert ran.err.startswith(f"kleinform: {start}")
    assert HINT in ran.err
    assert HINT not in run(*arguments, "--degrees").err


def test_what_is_within_a_turn_or_may_be_beyond(run) -> None:
    """A full turn; q4, which turns on and on; and with --degrees any angle."""
    turn = 2.0 * np.pi
    assert run("inverse", *POSE, "--rpy", turn, -turn, 0).code == 0
    assert run("inverse", *POSE, "--rpy", np.nextafter(turn, 7.0), 0, 0).code == 2
    assert run("inverse", "--position", 0, 0, 1, "--rpy", 0, 0, 1, "--azimuth", 40).code == 0
    assert run("forward", "--joints", 1.0, 1.191, 0.869, 38.657, 1.26, 1.05).code == 0
    assert run("inverse", *POSE, "--rpy", 370, -400, 725, "--degrees").code == 0
    ran = run("inverse", *POSE, "--rpy", "inf", 0, 0)
    assert (ran.code, HINT in ran.err) == (2, False)


@pytest.mark.parametrize("suffix", [".csv", ".json", ".npz"])
@pytest.mark.parametrize("name", ["roll", "pitch", "yaw"])
@pytest.mark.parametrize("errors", ["raise", "nan"])
def test_a_row_of_a_table(run, tmp_path: Path, suffix: str, name: str, errors: str) -> None:
    """The unit is that of the whole table: it is no row to write NaN for."""
    poses = {column: values / 60.0 for column, values in random_poses(9_000).items()}
    poses["z"] = poses["z"] + 1.0
    poses[name][8_500] = -6.3
    write(tmp_path / f"poses{suffix}", poses)
    ran = run("inverse", "--input", f"poses{suffix}", "--output", "q.npz", "--errors", errors)
    place = {".csv": "line 8502", ".json": "line 8501", ".npz": "row 8500"}[suffix]
    assert ran.code == 2
    assert ran.err == f"kleinform: poses{suffix}, {place}: {name}: {rule(-6.3)}\n"
    assert not (tmp_path / "q.npz").exists()


def rule(value: float) -> str:
    return f"within a full turn in rad is needed, {value!r} arrived; {HINT}"


def test_a_motion(run) -> None:
    header = "t,q1,q2,q3,q4,q5,q6\n"
    rows = "0.0,1.0,1.191,0.869,38.66,1.26,1.05\n0.1,1.01,1.201,0.879,38.56,72.35,1.06\n"
    ran = run("trajectory", "--input", "-", "--mode", 1, stdin=header + rows)
    assert ran.err == f"kleinform: standard input, line 3: q5: {rule(72.35)}\n"


@pytest.mark.long
def test_any_angles(run) -> None:
    """Refused exactly where one of them is beyond a full turn, q4 left alone."""
    rng = np.random.default_rng(4)
    for _ in range(many(60, 2_000)):
        spread = 10.0 ** rng.uniform(0.0, 2.5)
        rpy = rng.uniform(-spread, spread, 3)
        ran = run("inverse", *POSE, "--rpy", *rpy)
        assert (HINT in ran.err) == (abs(rpy) > 2.0 * np.pi).any(), rpy
        azimuth, elevation = rng.uniform(-spread, spread, 2)
        ran = run("forward", "--joints", 1.0, 1.2, 0.9, azimuth, elevation, 1.05)
        assert (HINT in ran.err) == (abs(elevation) > 2.0 * np.pi)
        assert (ran.code == 0) == (abs(elevation) <= np.pi / 2.0)
