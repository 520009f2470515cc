"""Everything that writes a file, as functions of the file's path."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

from kleinform import cli
from tests.cli.support import random_poses, write

POSE = ("--position", 0.25, 0.2, 1.0, "--rpy", 0.1, 0.2, 0.3)
TWIST = ("--twist", 0, 0, 5, 0.2, 0, 0)
JOINTS = ("--joints", 1.0, 1.191, 0.869, 0.6747, 1.2609, 1.05)
TURN = ("--rpy", 0.1, 0.2, 0.3)
#: A folder for the input of `table`.
POSES = TemporaryDirectory()
#: Commands with an option for a file, without it, and the ends that its name may have.
TABLES = (".csv", ".json", ".npz")
COMMANDS: dict[str, tuple[tuple[object, ...], tuple[str, ...]]] = {
    "inverse": ((*POSE, "--output"), TABLES),
    "forward": ((*JOINTS, "--output"), TABLES),
    "velocity": ((*POSE, *TWIST, "--output"), TABLES),
    "singularity": ((*POSE, "--output"), TABLES),
    "classify": ((*POSE, "--output"), TABLES),
    "trajectory": (("--example", 2, "--samples", 5, "--output"), TABLES),
    "singularities": ((*TURN, "--resolution", 4, "--mesh"), (".stl", ".ply")),
    "workspace": ((*TURN, "--tolerance", 0.5, "--resolution", 4, "--mesh"), (".stl",)),
}


def command(name: str, *arguments: object) -> int:
    """Run a command in this process, and return its exit code."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["kleinform", name, *map(str, arguments)])
        try:
            cli.main()
        except SystemExit as stopped:
            return int(stopped.code or 0)
    raise AssertionError("cli.main returned")


def table(path: Path) -> int:
    """Several blocks of a table."""
    source = Path(POSES.name) / "poses.npz"
    if not source.exists():
        write(source, random_poses(9000))
    return command("inverse", "--input", source, "--degrees", "--output", path)


def audit(path: Path) -> int:
    from kleinform.paper import __main__ as paper

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(paper, "report", dict)
        patch.setattr(paper, "audit", lambda _: 3000 * "audit\n")
        return paper.main([str(path)])


def figure(path: Path) -> int:
    from kleinform.plots.drawing import Figure
    from kleinform.plots.drawing import write as draw

    draw(Figure, path)
    return 0


def benchmark(path: Path) -> int:
    from benchmarks.report import saved

    with saved(path):
        print(3000 * "result ")
    return 0


def census(path: Path) -> int:
    from benchmarks.census import DISTRIBUTIONS, picture

    picture(dict.fromkeys(list(DISTRIBUTIONS)[:2], (np.ones(33), np.ones(33))), path)
    return 0


OUTPUTS: dict[str, Callable[[Path], int]] = {
    "audit.md": audit,
    "figure.svg": figure,
    "results.md": benchmark,
    "census.svg": census,
    **{f"table{end}": table for end in TABLES},
    **{
        f"{name}{end}": lambda path, name=name, given=given: command(name, *given, path)
        for name, (given, ends) in COMMANDS.items()
        for end in ends
    },
}
