"""Joint values with C in the plane of a leg, c·u_i = a.

The cone of that limb is then a plane counted twice, n_i·u_i = 0, and two modes share the
directions of the platform: they differ in e_i, in (4) a 0/0. In the half angles of the legs
they are apart, so that the pencil finds them as two.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.cases import in_plane
from kleinform.forward.circle import Rows
from kleinform.forward.found import Found, together
from kleinform.forward.pencil import PAIRS, STARTS, pairs_of

__all__ = ["by_circles"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Mask = NDArray[np.bool_]

#: Half angles nearer than this are one: Newton's method leaves double ones so far apart.
NEAR = 1e-6
#: Newton's last step where it has converged, for double solutions too.
CONVERGED = 1e-6


def by_circles(rows: Rows, tolerance: float) -> tuple[Found, Mask]:
    """Modes of rows with C in the planes of one or two legs, and where all pairs were found.

    Angles nearer than the root of the tolerance count as merged.
    """
    planes = in_plane(rows)
    # The legs of `base` and the one after it carry the half angles: both planes are among them.
    base = np.where(planes[:, 0] & planes[:, 2], 2, np.argmax(planes, axis=1))
    solved = np.zeros(len(rows), dtype=bool)
    parts = []
    for start in range(len(STARTS)):
        left = np.flatnonzero(~solved)
        if not len(left):
            break
        pairs = pairs_of(rows[left], base[left], start)
        for index, number in enumerate(left):
            angles = 2.0 * np.arctan(pairs.half_tangents[index])
            groups = _groups(angles)
            settled = (pairs.step[index] <= CONVERGED).all()
            if not settled or sum(map(len, groups)) != PAIRS:
                continue
            solved[number] = True
            real = [group for group in groups if abs(angles[group].mean(axis=0).imag).max() <= NEAR]
            first = np.array([group[0] for group in real], dtype=np.int64)
            extension = np.full((len(real), 3), np.nan)
            carried = (base[number] + np.arange(2)) % 3
            extension[:, carried] = pairs.extension[index, first].real
            parts.append(
                Found(
                    np.full(len(real), number),
                    pairs.directions[index, first].real,
                    np.array([len(group) for group in real], dtype=np.int64),
                    extension,
                )
            )
    return together(parts), solved


def _groups(angles: Complex) -> list[NDArray[np.int64]]:
    """Pairs with the same angles (32, 2), modulo a full turn."""
    gap = angles[:, np.newaxis] - angles
    gap -= 2.0 * np.pi * np.round(gap.real / (2.0 * np.pi))
    near = abs(gap).max(axis=-1) <= NEAR
    return [
        np.flatnonzero(near[index]) for index in range(len(angles)) if not near[index, :index].any()
    ]
