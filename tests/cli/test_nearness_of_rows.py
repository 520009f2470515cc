"""Rows next to a singularity: answers, and one line on standard error for a whole table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from kleinform import UncoupledManipulator, rotation_from_rpy
from kleinform.commands.source import ROWS
from tests.cli.support import random_poses, read, write

TWIST = ("wx", "wy", "wz", "vx", "vy", "vz")


def twists(count: int, near: dict[int, float]) -> dict[str, np.ndarray]:
    """Poses with twists, some rows as near to the Z axis as they say."""
    table = random_poses(count) | {name: np.ones(count) for name in TWIST}
    for row, distance in near.items():
        table["x"][row], table["y"][row], table["z"][row] = distance, 0.0, 1.0
    return table


@pytest.mark.parametrize("suffix", [".csv", ".npz"])
def test_one_line_for_a_whole_table(run, tmp_path: Path, suffix: str) -> None:
    """Though it is read in two blocks."""
    near = {7: 2e-9, ROWS - 1: 1e-12, ROWS + 5: 1e-10}
    path = write(tmp_path / f"twists{suffix}", twists(ROWS + 9, near))
    ran = run("velocity", "--input", path, "--degrees", "--output", tmp_path / "rates.npz")
    place = "line 9" if suffix == ".csv" else "row 7"
    assert ran.code == 0
    assert ran.err == (
        "kleinform: near a singularity: |f|/scale below √eps = 1.5e-08, central 1e-12; "
        f"rows: 3, the first at {path}, {place}\n"
    )
    assert np.isfinite(read(tmp_path / "rates.npz")["dq4"]).all()


def test_refused_rows_are_not_near(run, tmp_path: Path) -> None:
    path = write(tmp_path / "twists.csv", twists(4, {1: 0.0, 2: 1e-9}))
    ran = run("velocity", "--input", path, "--degrees", "--errors", "nan")
    assert ran.code == 0
    assert ran.err.splitlines() == [
        "kleinform: near a singularity: |f|/scale below √eps = 1.5e-08, central 1e-09; "
        f"rows: 1, the first at {path}, line 4",
        f"kleinform: rows refused: 1, the first at {path}, line 3",
    ]


@pytest.mark.parametrize("command", ["velocity", "singularity", "classify"])
def test_conditioning_adds_its_columns(run, tmp_path: Path, command: str) -> None:
    table = twists(5, {})
    path = write(tmp_path / "twists.csv", table)
    plain = tmp_path / "plain.csv", "--degrees"
    more = tmp_path / "more.csv", "--degrees", "--conditioning"
    for output, *others in (plain, more):
        assert run(command, "--input", path, "--output", output, *others).err == ""
    places = np.stack([table[name] for name in ("x", "y", "z")], axis=1)
    angles = {name: np.radians(table[name]) for name in ("roll", "pitch", "yaw")}
    found = UncoupledManipulator().conditioning(places, rotation_from_rpy(**angles))
    header = (tmp_path / "plain.csv").read_text().splitlines()[0]
    lines = (tmp_path / "more.csv").read_text().splitlines()
    assert lines[0].startswith(header + ",ratio_limb_1,")
    columns = dict(
        zip(lines[0].split(","), zip(*(r.split(",") for r in lines[1:]), strict=True), strict=True)
    )
    for name, ratio in found.ratios.items():
        assert np.array_equal(np.array(columns[f"ratio_{name}"], float), ratio)
    for name, values in found.singular_values.items():
        for index, value in enumerate(values.T, 1):
            assert np.array_equal(np.array(columns[f"{name}_{index}"], float), value)
