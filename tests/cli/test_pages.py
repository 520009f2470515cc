"""What ``--help`` and docs/command-line.md show is what the commands do."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import numpy as np
import pytest

from kleinform.commands import app
from kleinform.commands.columns import UNITS
from kleinform.commands.streams import Streams
from kleinform.paper.examples import example_2
from kleinform.verification import __main__ as verification
from tests.cli.support import random_poses, write

COMMANDS = ["inverse", "forward", "velocity", "singularity", "classify", "trajectory"]
COMMANDS += ["workspace", "singularities", "verify", "paper", "latex"]
PAGE = Path(__file__).parents[2] / "docs" / "command-line.md"


@pytest.fixture
def files(tmp_path: Path, run) -> None:
    """The tables that the examples read."""
    poses = random_poses(3)
    twists = {name: np.ones(3) for name in ("wx", "wy", "wz", "vx", "vy", "vz")}
    write(tmp_path / "poses.csv", poses)
    write(tmp_path / "twists.csv", poses | twists)
    run("inverse", "--input", "poses.csv", "--degrees", "--output", "joints.csv")
    states = example_2().sampled(20)
    names = ("t", *(f"q{i}" for i in range(1, 7)))
    columns = (states.times, *states.joints.T)
    write(tmp_path / "motion.csv", dict(zip(names, columns, strict=True)))
    ranges = "".join(f"q{i} = [0.6, 1.5]\n" for i in (1, 2, 3, 6))
    (tmp_path / "limits.toml").write_text(f"[ranges]\n{ranges}")


def same(printed: str, shown: str) -> None:
    """The same words, and numbers that differ by rounding alone: backends may differ in it."""
    number = r"-?\d+(?:\.\d+)?(?:e[+-]\d+)?"
    assert re.sub(number, "0", printed).split() == re.sub(number, "0", shown).split()
    found, expected = (np.array(re.findall(number, text), float) for text in (printed, shown))
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)


def test_every_command_is_tested() -> None:
    assert [command.callback.__name__ for command in app.registered_commands] == COMMANDS


@pytest.mark.usefixtures("files")
@pytest.mark.parametrize("command", COMMANDS)
def test_the_examples_of_help(run, command: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if command == "workspace":
        pytest.importorskip("flint", reason="the extra kleinform[certify] is not installed")
    monkeypatch.setattr(verification, "main", lambda: print("verified"))
    text = run(command, "--help").out
    assert max(map(len, text.splitlines())) <= 80
    examples = re.findall(r"^ +kleinform ((?:.*\\\n)*.*)$", text, flags=re.MULTILINE)
    assert examples
    for example in examples:
        arguments = shlex.split(example.replace("\\\n", " "))
        assert arguments[0] == command
        ran = run(*arguments)
        assert (ran.code, ran.err) == (0, "")
        if "--output" in arguments:
            assert Path(arguments[arguments.index("--output") + 1]).stat().st_size > 100
        else:
            assert ran.out


@pytest.mark.usefixtures("files")
@pytest.mark.parametrize(
    "arguments",
    [
        "inverse --input poses.csv --degrees",
        "forward --input joints.csv --degrees",
        "singularity --input poses.csv --degrees",
        "classify --input poses.csv --degrees",
        "velocity --input twists.csv --degrees",
        "trajectory --example 2",
        "singularities --rpy 10 3 6 --degrees",
    ],
)
def test_help_and_page_name_every_column(run, arguments: str) -> None:
    header = run(*arguments.split()).out.splitlines()[0]
    command = arguments.split()[0]
    text = re.split(r"[\s,;()`|]+", run(command, "--help").out)
    page = re.split(r"[\s,;()`|]+", PAGE.read_text(encoding="utf-8"))
    for name in header.split(","):
        assert name in text
        assert name in page


def test_the_page_has_every_unit() -> None:
    """The tables of columns and units of the page are those of the commands."""
    rows = re.findall(r"^\| (`.*`) \| .* \| (\S+) \|$", PAGE.read_text(), flags=re.MULTILINE)
    shown = {name: unit for names, unit in rows for name in re.findall(r"`([\w]+)`", names)}
    assert {name: shown[name] for name in UNITS} == UNITS


def test_the_page_shows_what_the_commands_print(
    run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In order, as at a terminal; what ``cat`` shows is there as a file."""
    monkeypatch.setattr(Streams, "on_terminal", True)
    monkeypatch.setattr(verification, "main", lambda: None)
    blocks = re.findall(r"```console\n(.*?)```", PAGE.read_text(encoding="utf-8"), flags=re.DOTALL)
    seen = set()
    for block in blocks:
        for line, shown in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, flags=re.MULTILINE):
            program, *arguments = shlex.split(line)
            if program == "cat" and not Path(arguments[0]).exists():
                Path(arguments[0]).write_text(shown)
            elif program == "cat":
                assert Path(arguments[0]).read_text() == shown
            else:
                assert program == "kleinform"
                ran = run(*arguments)
                printed = ran.out + ran.err
                beginning, cut, _ = shown.partition("...\n")
                if cut:
                    printed = printed[: len(beginning)]
                same(printed, beginning)
                seen.add(arguments[0])
    assert seen == set(COMMANDS)
