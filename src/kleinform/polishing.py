"""Orientations at many joint values at once, each from one nearby that is known.

Newton's method on the rotation itself: the joint values of a rotation are in closed form
(10), and so is the angular velocity for given leg rates (17); taken for a unit of time it is
the turn that Newton's method asks for. One pass over all samples costs two kernels and a
product of matrices, no matter how many samples there are.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.generated import kernels
from kleinform.sums import product

__all__ = ["polish"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

#: The second turn must be so much smaller than the first. Newton's method from an h of
#: Kantorovich's theorem contracts at first by about h/2, and a station is trusted up to 1/8.
CONTRACTION = 0.125
MOST_TURNS = 6
#: So many samples stay in the cache while they are turned.
BLOCK = 4096
#: A turn at the level of rounding [rad], and one after which rounding is all that is left.
ROUNDING = 1e-14
LAST = 1e-8


def polish(
    radius: float, positions: Array, lengths: Array, stations: NDArray[np.int64], known: Array
) -> tuple[Array, Mask]:
    """Rotations at all samples from those at some of them.

    Parameters
    ----------
    radius : float
    positions, lengths : array (T, 3)
        C, and q1, q2, q3 at every sample [m].
    stations : int array (S,)
        Increasing numbers of samples, the first and the last among them.
    known : array (S, 3, 3)
        The rotations there.

    Returns
    -------
    rotations : array (T, 3, 3)
    sure : bool array (T,)
        Whether Newton's method went straight from the station to the rotation.
    """
    middles = (stations[1:] + stations[:-1] + 1) // 2
    nearest = np.searchsorted(middles, np.arange(len(positions)), side="right")
    rotations, sure = known[nearest], np.ones(len(positions), dtype=bool)
    for start in range(0, len(positions), BLOCK):
        block = slice(start, start + BLOCK)
        _polish(radius, positions[block], lengths[block], rotations[block], sure[block])
    return rotations, sure


def _polish(radius: float, positions: Array, lengths: Array, rotations: Array, sure: Mask) -> None:
    """Turn rotations until they have these lengths, and say which of them did."""
    rows = np.arange(len(positions))
    before = np.full(len(positions), np.inf)
    for turn in range(MOST_TURNS):
        angle = _turn(radius, positions, lengths, rotations, rows)
        allowed = CONTRACTION * before[rows] if turn else np.inf
        straight = (angle <= allowed) | (angle <= ROUNDING)
        sure[rows[~straight]] = False
        before[rows] = angle
        rows = rows[straight & (angle > LAST)]
        if not rows.size:
            return
    sure[rows] = False


def _turn(
    radius: float, positions: Array, lengths: Array, rotations: Array, rows: NDArray[np.int64]
) -> Array:
    """Turn some rotations as Newton's method asks, and return by which angle."""
    place, rotation = positions[rows], rotations[rows]
    asked = np.zeros((len(rows), 6))
    with np.errstate(all="ignore"):  # what is 0/0 is not sure, and is followed otherwise
        now = kernels.inverse_displacement(radius, place, rotation).joints[:, :3]
        # The squares of the lengths are what is polynomial in the directions.
        asked[:, :3] = (lengths[rows] ** 2 - now**2) / (2.0 * now)
        twist = kernels.forward_velocity(radius, place, rotation, place[:, :2], asked).twist
        turns = _cayley(twist[:, :3])
        rotations[rows] = product(turns, rotation)
        angle: Array = np.linalg.norm(twist[:, :3], axis=1)
    return angle


def _cayley(vector: Array) -> Array:
    """Rotations (N, 3, 3) about vectors (N, 3), by their length to second order."""
    x, y, z = 0.5 * vector.T
    scale = 2.0 / (1.0 + x * x + y * y + z * z)
    rotation = np.empty((len(vector), 3, 3))
    for i, (a, b, c) in enumerate(((x, y, z), (y, z, x), (z, x, y))):
        j, k = (i + 1) % 3, (i + 2) % 3
        rotation[:, i, i] = 1.0 - scale * (b * b + c * c)
        rotation[:, i, j] = scale * (a * b - c)
        rotation[:, i, k] = scale * (a * c + b)
    return rotation
