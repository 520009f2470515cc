"""All assembly modes of many joint values at once, by the eliminant."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.cases import near_plane
from kleinform.forward.circle import Circles, Rows, circles_of, fourier, turned
from kleinform.forward.folds import folds, split
from kleinform.forward.found import Found, found, nothing, some, together
from kleinform.forward.isolate import Zeros, isolate
from kleinform.forward.polish import on_leg, relabelled_back, starts
from kleinform.generated import kernels
from kleinform.joints import TOLERANCE
from kleinform.sums import dot

__all__ = ["by_eliminant"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
#: Errors of the eliminant's values: the harmonics that should be zero show their size.
ROUNDING, LEAST_ROUNDING = 8.0, 64.0 * EPS
#: A polished mode lies in its cell, but for this angle.
EDGE = 1e-7
#: Two folds nearer than this are one that was found twice.
SAME_FOLD = 1e-7
#: So are two modes; those beside a fold are farther apart, or they have merged.
SAME_MODE = 1e-9
#: A fold belongs to a cell when it is not farther from its middle than the cell is wide, and
#: than this angle.
NEARBY = 0.01
#: Modes on the two sides of a fold are that near to it, or it is not the fold of these modes.
FARTHEST = 0.05
#: Zeros nearer than this times the root of the tolerance may merge within it; that of joint
#: values which were rounded to float64 covers the rounding of the eliminant too.
CLOSE = 1000.0
#: Any vector: (w·n_1)² puts modes in an order in which a mode and its copy, or that of −n,
#: are neighbours.
SORTER = np.array([0.36, 0.48, 0.8])
#: More clusters in a row than this come from rounding.
MOST_CLUSTERS = 6


def by_eliminant(rows: Rows, tolerance: float) -> tuple[Found, Mask]:
    """Modes of rows, and the rows for which all were found and every check held."""
    solved = np.zeros(len(rows), dtype=bool)
    parts = []
    for rank in range(3):
        left = np.flatnonzero(~solved)
        if not len(left):
            break
        attempt, good = _attempt(rows[left], rank, tolerance)
        kept = some(attempt, good[attempt.row])
        parts.append(kept._replace(row=left[kept.row]))
        solved[left[good]] = True
    return together(parts), solved


def _attempt(rows: Rows, rank: int, tolerance: float) -> tuple[Found, Mask]:
    """One base limb for each row."""
    circles = circles_of(rows, rank)
    coefficients, rest = fourier(rows, circles)
    good = np.isfinite(coefficients).all(1) & np.isfinite(rest)
    coefficients[~good] = 0.0
    coefficients[~good, 0] = 1.0
    zeros = isolate(coefficients, np.where(good, ROUNDING * rest, 0.0) + LEAST_ROUNDING)
    zeros = _joined(zeros, max(tolerance, TOLERANCE))
    clusters = np.bincount(zeros.row[~zeros.simple], minlength=len(rows))
    good &= clusters <= MOST_CLUSTERS
    zeros = Zeros._make(entry[good[zeros.row]] for entry in zeros)
    angle, directions = starts(rows, circles, zeros.row, zeros.guess)
    simple, cluster = zeros.simple, ~zeros.simple
    cells = Zeros._make(entry[simple] for entry in zeros)
    alone, held = _simple(rows, circles, cells, angle[simple], directions[simple])
    good[alone.row[~held]] = False
    cells = Zeros._make(entry[cluster] for entry in zeros)
    close, lost = _clusters(rows, circles, cells, directions[cluster], tolerance)
    good[lost] = False
    modes = together([alone, close])
    return modes, good & _consistent(modes, len(rows))


def _joined(zeros: Zeros, tolerance: float) -> Zeros:
    """Simple zeros so close that the tolerance may merge them, as clusters of two.

    Both get the angle between them, and lead to the same fold.
    """
    order = np.lexsort((zeros.guess, zeros.row))
    zeros = Zeros._make(entry[order] for entry in zeros)
    gap = zeros.guess[1:] - zeros.guess[:-1]
    near = (zeros.row[1:] == zeros.row[:-1]) & zeros.simple[1:] & zeros.simple[:-1]
    first = np.flatnonzero(near & (gap <= min(CLOSE * tolerance**0.5, FARTHEST)))
    middle = 0.5 * (zeros.guess[first] + zeros.guess[first + 1])
    zeros.guess[first] = zeros.guess[first + 1] = middle
    zeros.simple[first] = zeros.simple[first + 1] = False
    return zeros


def _simple(
    rows: Rows, circles: Circles, zeros: Zeros, angle: Array, directions: Array
) -> tuple[Found, Mask]:
    """Modes at simple zeros, and where Newton's method converged within the cell."""
    row, base = zeros.row, circles.base[zeros.row]
    angle, directions, distance, converged = on_leg(rows, circles, row, angle, directions)
    modes = found(row, relabelled_back(directions, base), 1)
    modes.extension[np.arange(len(row)), base] = distance
    moved = _turn(circles.psi(row, np.arctan2(angle[:, 1], angle[:, 0])) - zeros.guess)
    inside = (moved >= zeros.low - zeros.guess - EDGE) & (moved <= zeros.high - zeros.guess + EDGE)
    return modes, converged & inside


def _clusters(
    rows: Rows, circles: Circles, zeros: Zeros, directions: Array, tolerance: float
) -> tuple[Found, Integers]:
    """Modes at and beside folds, and the rows in which a cluster is no plain fold."""
    row = zeros.row
    if not len(row):
        return nothing(), row
    near = folds(rows, row, relabelled_back(directions, circles.base[row]), tolerance)
    away = abs(
        _turn(circles.psi(row, _base_angle(rows, circles, row, near.directions)) - zeros.guess)
    )
    flat = np.asarray(near_plane(rows).any(axis=1))
    lost = (
        near.lost | near.hidden | ~(away <= np.minimum(NEARBY, zeros.high - zeros.low)) | flat[row]
    )
    lost |= near.apart & ~(near.reach <= FARTHEST)
    # Cells side by side may lead to the same fold.
    again = np.zeros(len(row), dtype=bool)
    gap = _size(near.directions[1:] - near.directions[:-1])
    again[1:] = (row[1:] == row[:-1]) & (gap <= SAME_FOLD) & ~lost[1:] & ~lost[:-1]
    apart, merged = near.apart & ~lost & ~again, near.merged & ~lost & ~again
    both, sure = split(rows, row, near, apart)
    two = np.tile(row[apart], 2)
    modes = together([found(row[merged], near.directions[merged], 2), found(two, both, 1)])
    return modes, np.concatenate([row[lost], two[~sure.ravel()]])


def _consistent(modes: Found, count: int) -> Mask:
    """Rows with an even number of modes, no two of them the same."""
    number = np.bincount(modes.row, weights=modes.multiplicity, minlength=count)
    good: Mask = number % 2 == 0
    order = np.lexsort((dot(modes.directions[:, 0], SORTER) ** 2, modes.row))
    row, directions, extension = modes.row[order], modes.directions[order], modes.extension[order]
    for shift in (1, 2):
        gap = np.minimum(
            _size(directions[shift:] - directions[:-shift]),
            _size(directions[shift:] + directions[:-shift]),
        )
        same = (row[shift:] == row[:-shift]) & (gap <= SAME_MODE)
        # With C in the plane of the base leg two modes share their directions, not their e.
        other = abs(abs(extension[shift:]) - abs(extension[:-shift])) > SAME_MODE
        good[row[shift:][same & ~other.any(axis=1)]] = False
    return good


def _size(pairs: Array) -> Array:
    """The length of n_1 and n_2 (K, 2, 3) as one vector each."""
    flat = pairs.reshape(-1, 6)
    return np.asarray(np.sqrt(dot(flat, flat)))


def _turn(angle: Array) -> Array:
    """An angle in [−π, π]."""
    return angle - 2.0 * np.pi * np.round(angle / (2.0 * np.pi))


def _base_angle(rows: Rows, circles: Circles, row: Integers, directions: Array) -> Array:
    """The angle of the base leg of platforms with these n_1, n_2."""
    rotation = kernels.rotation_from_directions(directions[:, 0], directions[:, 1]).rotation
    legs = kernels.limb_geometry(rows.radius[row], rows.position[row], rotation).w
    own = turned(legs[np.arange(len(row)), circles.base[row]], circles.base[row])
    return np.asarray(np.arctan2(own[:, 2], own[:, 1]))
