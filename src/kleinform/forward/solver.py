"""All assembly modes of many joint values at once, by the eliminant."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import Circles, Rows, circles_of, fourier
from kleinform.forward.isolate import Zeros, isolate
from kleinform.forward.polish import directions_at, folds, polished, split
from kleinform.generated import kernels

__all__ = ["Found", "by_eliminant"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
#: Errors of the eliminant's values: the harmonics that should be zero show their size.
ROUNDING, LEAST_ROUNDING = 8.0, 64.0 * EPS
#: A polished mode lies in its cell, but for this angle.
EDGE = 1e-7
#: Two modes or folds nearer than this are one that was found twice.
SAME = 1e-7
#: A fold is looked for in a cell; the modes on its two sides are not farther apart than this.
FARTHEST = 0.05
#: More clusters in a row than this come from rounding.
MOST_CLUSTERS = 6


class Found(NamedTuple):
    """Modes in the order in which they were found: the row of each, n_1 and n_2, and how many
    solutions have merged in it."""

    row: Integers
    directions: Array
    multiplicity: Integers


def by_eliminant(rows: Rows, tolerance: float) -> tuple[Found, Mask]:
    """Modes of rows, and the rows for which all were found and every check held."""
    solved = np.zeros(len(rows), dtype=bool)
    found = []
    for rank in range(3):
        left = np.flatnonzero(~solved)
        if not len(left):
            break
        attempt, good = _attempt(rows[left], rank, tolerance)
        keep = good[attempt.row]
        found.append(
            Found(left[attempt.row[keep]], attempt.directions[keep], attempt.multiplicity[keep])
        )
        solved[left[good]] = True
    return Found(*map(np.concatenate, zip(*found, strict=True))), solved


def _attempt(rows: Rows, rank: int, tolerance: float) -> tuple[Found, Mask]:
    """One base limb for each row."""
    circles = circles_of(rows, rank)
    coefficients, rest = fourier(rows, circles)
    good = np.isfinite(coefficients).all(1) & np.isfinite(rest)
    coefficients[~good] = 0.0
    coefficients[~good, 0] = 1.0
    zeros = isolate(coefficients, np.where(good, ROUNDING * rest, 0.0) + LEAST_ROUNDING)
    clusters = np.bincount(zeros.row[~zeros.simple], minlength=len(rows))
    good &= clusters <= MOST_CLUSTERS
    zeros = Zeros(*(entry[good[zeros.row]] for entry in zeros))
    directions = directions_at(rows, circles, zeros.row, zeros.guess)
    simple = zeros.simple
    alone, held = _simple(rows, circles, Zeros(*(entry[simple] for entry in zeros)), directions[simple])
    good[alone.row[~held]] = False
    together, lost = _clusters(rows, zeros.row[~simple], directions[~simple], tolerance)
    good[lost] = False
    found = Found(*map(np.concatenate, zip(alone, together, strict=True)))
    return found, good & _consistent(found, len(rows))


def _simple(rows: Rows, circles: Circles, zeros: Zeros, directions: Array) -> tuple[Found, Mask]:
    """Modes at simple zeros, and where Newton's method converged within the cell."""
    directions, converged = polished(rows, zeros.row, directions)
    found = Found(zeros.row, directions, np.ones(len(zeros.row), dtype=np.int64))
    moved = circles.psi(zeros.row, base_angle(rows, circles, found)) - zeros.guess
    moved -= 2.0 * np.pi * np.round(moved / (2.0 * np.pi))
    inside = (moved >= zeros.low - zeros.guess - EDGE) & (moved <= zeros.high - zeros.guess + EDGE)
    return found, converged & inside


def base_angle(rows: Rows, circles: Circles, found: Found) -> Array:
    """The angle of the base leg of each mode."""
    rotation = kernels.rotation_from_directions(
        found.directions[:, 0], found.directions[:, 1]
    ).rotation
    legs = kernels.limb_geometry(rows.radius[found.row], rows.position[found.row], rotation).w
    own = legs[np.arange(len(found.row)), circles.base[found.row]]
    turns = 2.0 * np.pi / 3.0 * circles.base[found.row]
    return np.arctan2(own[:, 2], np.cos(turns) * own[:, 1] - np.sin(turns) * own[:, 0])


def _clusters(
    rows: Rows, row: Integers, directions: Array, tolerance: float
) -> tuple[Found, Integers]:
    """Modes at and beside folds, and the rows in which a cluster is no plain fold."""
    found = folds(rows, row, directions, tolerance)
    far = np.linalg.norm(found.directions - directions, axis=(1, 2)) > FARTHEST
    lost = found.lost | far | (found.apart & ~(found.reach <= FARTHEST))
    again = np.zeros(len(row), dtype=bool)
    same = (row[1:] == row[:-1]) & (
        np.linalg.norm(found.directions[1:] - found.directions[:-1], axis=(1, 2)) <= SAME
    )
    again[1:] = same & ~lost[1:] & ~lost[:-1]
    apart, merged = found.apart & ~lost & ~again, found.merged & ~lost & ~again
    two = np.tile(row[apart], 2)
    both, converged = polished(rows, two, split(found)[:, apart].reshape(-1, 2, 3))
    modes = Found(
        np.concatenate([row[merged], two]),
        np.concatenate([found.directions[merged], both]),
        np.concatenate([np.full(merged.sum(), 2), np.ones(len(two), dtype=np.int64)]),
    )
    return modes, np.concatenate([row[lost], two[~converged]])


def _consistent(found: Found, count: int) -> Mask:
    """Rows with an even number of modes, no two of them the same."""
    number = np.bincount(found.row, weights=found.multiplicity, minlength=count)
    good = number % 2 == 0
    # Each mode once, whichever of the pair ±n it is: sorted by what both have in common.
    shape = found.directions[:, 0] * np.sign(found.directions[:, :1, 2])
    order = np.lexsort((shape[:, 0], found.row))
    row, directions = found.row[order], found.directions[order]
    for shift in (1, 2):
        gap = np.minimum(
            np.linalg.norm(directions[shift:] - directions[:-shift], axis=(1, 2)),
            np.linalg.norm(directions[shift:] + directions[:-shift], axis=(1, 2)),
        )
        good[row[shift:][(row[shift:] == row[:-shift]) & (gap <= EPS)]] = False
    return good
