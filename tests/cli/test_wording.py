"""What errors say: options and columns, never arguments of Python, and what arrived."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import numpy as np
import pytest

from kleinform import UncoupledManipulator, rotation_from_rpy
from tests.cli.support import write

BAD = ("nan", "inf", "-inf", "1e200", "-1e101", "NAN")
POSE = {"--position": 3, "--rpy": 3}
#: The options of numbers that each command has, and how many numbers they take.
OPTIONS: dict[str, dict[str, int]] = {
    "inverse": {**POSE, "--azimuth": 1, "--radius": 1},
    "forward": {"--joints": 6, "--radius": 1},
    "velocity --twist": {**POSE, "--twist": 6, "--radius": 1},
    "velocity --rates": {**POSE, "--rates": 6, "--azimuth": 1, "--radius": 1},
    "singularity": {**POSE, "--radius": 1},
    "classify": {**POSE, "--radius": 1},
    "trajectory": {"--start-rpy": 3, "--radius": 1},
    "workspace": {"--rpy": 3, "--tolerance": 1, "--radius": 1},
    "singularities": {"--rpy": 3, "--radius": 1},
}
VALUES = {
    "--position": (0.25, 0.2, 1.0),
    "--rpy": (0.1, 0.2, 0.3),
    "--start-rpy": (0.17, 0.05, 0.1),
    "--joints": (1.0, 1.191, 0.869, 0.6747, 1.2609, 1.05),
    "--twist": (0.0, 0.0, 5.0, 0.2, 0.0, 0.0),
    "--rates": (0.0, 0.0, 0.1, 0.2, 0.0, 0.0),
    "--azimuth": (0.3,),
    "--tolerance": (0.5,),
    "--radius": (1.0,),
}
ALWAYS = {"trajectory": ("--example", "2", "--samples", "3")}
#: Singular poses, and other rules, with what the message must have.
RULES = (
    ("inverse --position 0 0 1 --rpy 0 0 0", "--azimuth"),
    ("inverse --position 0 0 0 --rpy 0 0 0 --azimuth 1", "q6 = 0"),
    ("inverse --position 1e-120 0 0 --rpy 0 0 0", "--position: nearer to O"),
    ("inverse --position 0 1 1.8e19 --rpy 0 0 0", "1.0 arrived, rounding beside 1.8e+19"),
    ("velocity --position 0 0 1 --rpy 0.1 0.2 0.3 --rates 1 1 1 1 1 1", "--azimuth"),
    ("velocity --position 0 0 1 --rpy 0 0 0 --twist 1 1 1 1 1 1", "0.0 arrived"),
    ("velocity --position 1e99 1e99 1 --rpy 0 0 0 --twist 1e99 1 1 1e99 1 1", ""),
    ("forward --joints 1 1 1 0 100 1 --degrees", "--joints: q5 in"),
    ("forward --joints 1 1 1 0 100 1 --degrees", "100.0 deg arrived"),
    ("forward --joints -1.25 1 1 0 1 1", "--joints: q1 >= 0 is needed; -1.25 arrived"),
    ("trajectory --example 1 --mode 9", "--mode: "),
    ("trajectory --example 1 --mode -1", "--mode: "),
    ("trajectory --example 1 --samples 1", "--samples: "),
    ("trajectory --example 1 --start-rpy 3 1 0", ""),
    ("workspace --rpy 0 0 0 --tolerance 2", "--tolerance: from 1e-9 to 1 is needed, 2.0 arrived"),
    ("workspace --rpy 0 1.5707963267948966 0", ""),
    ("singularities --rpy 0 0 0 --mesh a.stl --box 1 0 0 1 0 1", "--box: "),
    ("singularities --rpy 0 0 0 --mesh a.stl --box 0 nan 0 1 0 1", "--box: "),
    ("inverse --position 1 1 1 --rpy 0 0 0 --radius -2.5", "--radius: positive"),
    ("inverse --position 1 1 1 --rpy 0 0 0 --radius -2.5", "-2.5 arrived"),
)


def python_names() -> set[str]:
    """Arguments of the public calls that are no words of the field."""
    names = set(inspect.signature(rotation_from_rpy).parameters)
    for _, method in inspect.getmembers(UncoupledManipulator, inspect.isfunction):
        names |= set(inspect.signature(method).parameters)
    return names | {"bounds", "relative", "count"}


def checked(ran) -> str:
    """The message of a command that refuses, in words of the command line."""
    assert ran.code in (0, 2)
    if ran.code == 0:
        return ""
    assert ran.err.count("\n") == 1
    assert "Traceback" not in ran.err
    message: str = ran.err.removeprefix("kleinform: ").rstrip("\n")
    assert not re.search(r"\b[a-z_]\w*=", message), message
    assert message.partition(": ")[0] not in python_names(), message
    assert not re.search(r"start_rotation|errors=|certify=", message), message
    return message


@pytest.mark.parametrize("name", OPTIONS)
def test_each_number_of_each_option(run, name: str) -> None:
    """The option is named, and what it was given is there."""
    if name == "workspace":
        pytest.importorskip("flint")
    command = name.split()[0]
    for option, count in OPTIONS[name].items():
        for index in range(count):
            for bad in BAD if command != "workspace" else BAD[:2]:
                values = {key: list(map(str, VALUES[key])) for key in OPTIONS[name]}
                values[option][index] = bad
                given = [word for key, words in values.items() for word in (key, *words)]
                message = checked(run(command, *ALWAYS.get(command, ()), *given))
                if not message:  # a number that is large, and no more
                    assert "n" not in bad.lower()
                elif "n" in bad.lower():
                    assert option in message, message
                    assert repr(float(bad)) in message, message


@pytest.mark.parametrize(("line", "expected"), RULES)
def test_rules(run, line: str, expected: str) -> None:
    if line.startswith("workspace"):
        pytest.importorskip("flint")
    assert expected in checked(run(*line.split()))


TABLES = {
    "inverse": ("x", "y", "z", "roll", "pitch", "yaw"),
    "forward": tuple(f"q{i}" for i in range(1, 7)),
    "velocity": (*"xyz", "roll", "pitch", "yaw", "wx", "wy", "wz", "vx", "vy", "vz"),
    "singularity": ("x", "y", "z", "roll", "pitch", "yaw"),
    "classify": ("x", "y", "z", "roll", "pitch", "yaw"),
    "trajectory": ("t", *(f"q{i}" for i in range(1, 7))),
}
GOOD = {"x": 0.25, "y": 0.2, "z": 1.0, "roll": 0.1, "pitch": 0.2, "yaw": 0.3, "t": 0.0}
GOOD |= {f"q{i + 1}": value for i, value in enumerate(VALUES["--joints"])}
GOOD |= dict(zip(("wx", "wy", "wz", "vx", "vy", "vz"), VALUES["--twist"], strict=True))


@pytest.mark.parametrize("command", TABLES)
@pytest.mark.parametrize("form", ["csv", "json", "npz"])
def test_a_missing_number_in_each_column(run, tmp_path: Path, command: str, form: str) -> None:
    """With NaN for errors a row of NaN, else the message names the column and the cell."""
    names = TABLES[command]
    more = ("--mode", 0) if command == "trajectory" else ()
    for column in names:
        for cell, said in CELLS[form]:
            rows = [[str(GOOD[name]) for name in names] for _ in range(3)]
            for number, row in enumerate(rows):
                if "t" in names:
                    row[0] = str(0.1 * number)
            rows[1][names.index(column)] = cell
            path = table(tmp_path / f"in.{form}", names, rows)
            place = {"csv": "line 3", "json": "line 2", "npz": "row 1"}[form]
            message = checked(run(command, "--input", path.name, *more))
            rule = f"{column}: a finite number is needed, {said} arrived"
            assert message == f"in.{form}, {place}: {rule}"
            if more:
                continue
            ran = run(command, "--input", path.name, "--errors", "nan")
            assert (ran.code, ran.err) == (
                0,
                f"kleinform: rows refused: 1, the first at in.{form}, {place}\n",
            )
            assert any("nan" in line for line in ran.out.splitlines()[2:-1])


CELLS = {
    "csv": (("", "a blank"), (" ", "a blank"), ("NA", "NA"), ("nan", "nan"), ("-inf", "-inf")),
    "json": (("null", "null"), ("NaN", "NaN"), ("1e999", "Infinity")),
    "npz": (("nan", "nan"), ("inf", "inf")),
}


def table(path: Path, names: tuple[str, ...], rows: list[list[str]]) -> Path:
    """A table of cells as they are."""
    if path.suffix == ".npz":
        return write(path, dict(zip(names, np.array(rows, dtype=float).T, strict=True)))
    if path.suffix == ".csv":
        path.write_text("\n".join(map(",".join, [names, *rows])) + "\n")
        return path
    objects = [", ".join(f'"{n}": {c}' for n, c in zip(names, row, strict=True)) for row in rows]
    path.write_text("".join(f"{{{text}}}\n" for text in objects))
    return path
