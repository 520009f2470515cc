"""Every command with closed and full standard streams: its answer and its exit code."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.outputs import COMMANDS
from tests.support import many

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="/dev/full of Linux")

CALLS: dict[str, tuple[object, ...]] = {
    **{name: given[:-1] for name, (given, _) in COMMANDS.items()},
    "latex": ("J_q",),
    "paper": (),
    "forward --certify": (*COMMANDS["forward"][0][:-1], "--certify"),
    "workspace": ("--rpy", 0.1, 0.2, 0.3, "--tolerance", 0.5),
    "singularity": ("--input", "rows.csv", "--errors", "nan"),
    "inverse": ("--input", "rows.csv", "--errors", "nan"),
    "velocity": ("--position", 0, 0, 1, "--rpy", 0, 0, 0, "--twist", *range(6)),
    "--help": (),
    "turn": (),
}
#: The second row is refused, which standard error says.
ROWS = "x,y,z,roll,pitch,yaw\n0.25,0.2,1.0,0.1,0.2,0.3\n0,nan,1,0,0,0\n"
SILENT = ("2>&-", "2>/dev/full", "<&-", "<&- 2>&-")
MUTE = (">&-", ">/dev/full", "<&- >&- 2>&-", ">/dev/full 2>/dev/full")


def ran(
    name: str, redirected: str, folder: Path, given: tuple[object, ...] | None = None
) -> subprocess.CompletedProcess[str]:
    """A command in a shell, whose Python keeps what is printed until the end."""
    arguments = [*name.split(), *map(str, CALLS[name] if given is None else given)]
    line = f'"$0" -m kleinform "$@" {redirected}'
    return subprocess.run(
        ["sh", "-c", line, sys.executable, *arguments],
        capture_output=True,
        cwd=folder,
        env={name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"},
        check=False,
        text=True,
    )


@pytest.mark.long
@pytest.mark.parametrize(("turn", "name"), list(enumerate(CALLS)))
def test_closed_and_full_streams(tmp_path: Path, turn: int, name: str) -> None:
    """Who does not listen changes nothing; an answer that nobody can hear is an error."""
    if name in ("workspace", "forward --certify"):
        pytest.importorskip("flint")
    (tmp_path / "rows.csv").write_text(ROWS)
    usual = ran(name, "", tmp_path)
    for silent in rotated(SILENT, turn)[: many(1, 4)]:
        found = ran(name, silent, tmp_path)
        assert (found.returncode, found.stdout) == (usual.returncode, usual.stdout)
        assert found.stderr == ("" if "2>" in silent else usual.stderr)
    for mute in rotated(MUTE, turn)[: many(1, 4)]:
        found = ran(name, mute, tmp_path)
        assert (found.returncode, found.stdout) == (2, "")
        if "2>" not in mute and usual.stdout:
            reason = "Bad file descriptor" if "&-" in mute else "No space left on device"
            assert found.stderr.splitlines()[-1] == f"kleinform: standard output: {reason}"
            assert "Traceback" not in found.stderr


def rotated(choices: tuple[str, ...], turn: int) -> tuple[str, ...]:
    """The same, from another one on."""
    turn %= len(choices)
    return choices[turn:] + choices[:turn]


@pytest.mark.parametrize("form", ["csv", "json"])
def test_a_closed_input_that_is_needed(tmp_path: Path, form: str) -> None:
    """One line, and the file that is written meanwhile has none of the closed numbers."""
    for redirected in ("<&-", "<&- >&-"):
        (tmp_path / "q.csv").write_text("kept")
        arguments = f"--input - --format {form} --output q.csv {redirected}"
        found = ran("inverse", arguments, tmp_path, given=())
        assert found.returncode == 2
        assert found.stderr == "kleinform: standard input: Bad file descriptor\n"
        assert (tmp_path / "q.csv").read_text() == "kept"


def test_a_file_needs_no_standard_stream(tmp_path: Path) -> None:
    redirected = "--output q.csv <&- >&- 2>&-"
    assert ran("inverse", redirected, tmp_path, given=COMMANDS["inverse"][0][:-1]).returncode == 0
    usual = ran("inverse", "", tmp_path, given=COMMANDS["inverse"][0][:-1])
    assert (tmp_path / "q.csv").read_text() == usual.stdout
