"""Joint values with C in the plane of a leg, c·u_i = a.

The cone of that limb is then a plane counted twice, n_i·u_i = 0, and two modes share the
directions of the platform: they differ in e_i, in (4) a 0/0. In the angles of the legs they
are apart, so that the pencil finds them as two.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.apart import radii_of_angles
from kleinform.forward.cases import near_plane, reach_of
from kleinform.forward.chords import leg_angles
from kleinform.forward.circle import Circles, Rows, relabel
from kleinform.forward.found import Found, together
from kleinform.forward.pencil import PAIRS, STARTS, Pairs, pairs_of, refined, tables_of
from kleinform.forward.polish import on_leg, relabelled, relabelled_back

__all__ = ["by_circles"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

#: Newton's steps: the eigenvalues alone are far off where C is near the circle of a leg.
STEPS, LAST_STEPS = 40, 3
#: Where the imaginary part of an angle is smaller, the real part alone is tried.
NEARLY_REAL = 1e-7


def by_circles(rows: Rows, tolerance: float) -> tuple[Found, Mask]:
    """Modes of rows with C in the planes of one or two legs, and where all pairs were found.

    Only simple solutions count: the tolerance is that of the other ways, and without effect.
    """
    planes = near_plane(rows)
    # The legs of `base` and the one after it carry the angles: both planes are among them.
    base = np.where(planes[:, 0] & planes[:, 2], 2, np.argmax(planes, axis=1))
    solved = np.zeros(len(rows), dtype=bool)
    known = [Distinct() for _ in range(len(rows))]
    parts = []
    for start in range(len(STARTS)):
        for shift in range(3):
            left = np.flatnonzero(~solved)
            if not len(left):
                break
            pairs = pairs_of(rows[left], (base[left] + shift) % 3, start, STEPS)
            for index, number in enumerate(left):
                own = int(number)
                directions = pairs.directions[index]
                halves = (
                    _chords(rows[[own]], base[[own]], directions, start)
                    if shift
                    else (pairs.half_tangents[index])
                )
                known[own].add(*_enclosed(rows[[own]], base[[own]], halves, start))
                if len(known[own].angles) == PAIRS:
                    solved[own] = True
                    parts.append(known[own].modes(own, int(base[own])))
    return _polished(rows, base, together(parts)), solved


def _polished(rows: Rows, base: Integers, modes: Found) -> Found:
    """Newton's method in the angle of the base leg, where it converges.

    Where C is in the planes of two legs it does not: F of the other one is a square.
    """
    row, own = modes.row, base[modes.row]
    place = np.arange(len(row)), own
    sign = np.sign(modes.extension[place])
    directions = relabelled(modes.directions * sign[:, np.newaxis, np.newaxis], own)
    (position, lengths), ones = relabel(rows, base), np.ones(len(rows))
    circles = Circles(base, position, lengths, 0.0 * ones, ones)
    leg = abs(modes.extension[place])[:, np.newaxis] * directions[:, 0] + position[row]
    angle = leg[:, 1:] / lengths[row, :1]
    _, found, distance, converged = on_leg(rows, circles, row, angle, directions)
    extension = modes.extension * sign[:, np.newaxis]
    extension[place] = np.where(converged, distance, extension[place])
    chosen = np.where(converged[:, np.newaxis, np.newaxis], found, directions)
    return Found(row, relabelled_back(chosen, own), modes.multiplicity, extension)


def _chords(row: Rows, base: Integers, directions: Complex, start: int) -> Complex:
    """Half tangents from directions that another pencil found: both B of a leg that has two."""
    position, lengths = (entry[0] for entry in relabel(row, base))
    pairs = relabelled(directions, np.repeat(base, len(directions)))
    with np.errstate(all="ignore"):
        angles, _ = leg_angles(float(row.radius[0]), position, lengths, pairs)
        halves = np.tan((angles - np.array(STARTS[start])) / 2.0)
    solutions: Complex = _refined(row, base, halves, start, STEPS).half_tangents[0]
    return solutions


def _refined(row: Rows, base: Integers, halves: Complex, start: int, steps: int) -> Pairs:
    tables = tables_of(row, base, start)
    return refined(tables, base, halves[np.newaxis, :, 0], halves[np.newaxis, :, 1], steps)


def _enclosed(
    row: Rows, base: Integers, halves: Complex, start: int
) -> tuple[Pairs, Complex, Array]:
    """Solutions, their angles (P, 2), and how far each may be off, inf where none is proven.

    A solution that is almost real is proven at a real point, or not at all.
    """
    with np.errstate(all="ignore"):
        angles = 2.0 * np.arctan(halves)
        real: Mask = np.max(abs(angles.imag), axis=1) <= NEARLY_REAL
    points = np.where(real[:, np.newaxis], halves.real, halves)
    pairs = _refined(row, base, points, start, LAST_STEPS)
    reaches = np.take_along_axis(reach_of(row), (base[:, np.newaxis] + np.arange(3)) % 3, axis=1)
    found = radii_of_angles(tables_of(row, base, start), reaches, pairs.half_tangents)[0]
    with np.errstate(all="ignore"):
        angles = 2.0 * np.arctan(pairs.half_tangents[0]) + np.array(STARTS[start])
        known = real | (abs(angles.imag).max(axis=1) > found)
    return pairs, angles, np.where(known, found, np.inf)


class Distinct:
    """Different solutions of one row, in the angles of two legs."""

    def __init__(self) -> None:
        self.angles: list[Complex] = []
        self.directions: list[Complex] = []
        self.radii: list[float] = []
        self.extension: list[Complex] = []

    def add(self, pairs: Pairs, angles: Complex, radius: Array) -> None:
        """Those of one pencil that are proven, and apart from all that are known."""
        for number in np.flatnonzero(np.isfinite(radius)):
            gaps = [_apart(angles[number], other) for other in self.angles]
            reach = radius[number] + np.array(self.radii)
            if (np.array(gaps) > reach).all():
                self.angles.append(angles[number])
                self.radii.append(radius[number])
                self.directions.append(pairs.directions[0, number])
                self.extension.append(pairs.extension[0, number])

    def modes(self, row: int, base: int) -> Found:
        """The real ones."""
        real = [i for i, angles in enumerate(self.angles) if not angles.imag.any()]
        extension = np.full((len(real), 3), np.nan)
        carried = (base + np.arange(2)) % 3
        extension[:, carried] = np.array([self.extension[i].real for i in real]).reshape(-1, 2)
        directions = np.array([self.directions[i].real for i in real]).reshape(-1, 2, 3)
        ones = np.ones(len(real), dtype=np.int64)
        return Found(row * ones, directions, ones, extension)


def _apart(first: Complex, second: Complex) -> float:
    """The distance of two sets of angles, modulo full turns."""
    gap = first - second
    gap = gap - 2.0 * np.pi * np.round(gap.real / (2.0 * np.pi))
    return float(abs(gap).max())
