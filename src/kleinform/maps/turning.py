"""Proof in ball arithmetic that no direct factor vanishes while the platform turns (needs
python-flint)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import MissingExtraError

try:
    from flint import arb, arb_mat
except ModuleNotFoundError as missing:  # pragma: no cover
    raise MissingExtraError(
        "a proof needs python-flint: pip install 'kleinform[certify]'"
    ) from missing

from scipy.spatial.transform import Rotation

from kleinform.precision import working_precision
from kleinform_kernels.uncoupled import arb_kernels

__all__ = ["signs_stay"]

Array = NDArray[np.float64]
#: Bits.
PRECISION = 53
#: A stretch of the turn is halved at most so often.
DEPTH = 14


def signs_stay(radius: float, position: Array, start: Array, end: Array) -> bool:
    """Whether e_1, e_2, e_3 and the orientation factor keep their signs on a turn.

    Parameters
    ----------
    radius : float
    position : array (3,)
    start, end : array (3, 3)
        The turn is about one axis, by less than half a turn.
    """
    one = Rotation.from_matrix(start)
    vector = (Rotation.from_matrix(end) * one.inv()).as_rotvec()
    first = arb_mat([[arb(float(entry)) for entry in row] for row in start])
    with working_precision(PRECISION):
        return _definite_along(radius, position, first, vector)


def _definite_along(radius: float, position: Array, first: arb_mat, vector: Array) -> bool:
    """Halve the turn until all factors are of one sign on every stretch of it."""
    stretches = [(0.0, 1.0, 0)]
    while stretches:
        low, high, depth = stretches.pop()
        rotation = _rotated(vector, 0.5 * (low + high), 0.5 * (high - low)) * first
        if _definite(radius, position, rotation):
            continue
        if depth == DEPTH:
            return False
        middle = 0.5 * (low + high)
        stretches += [(low, middle, depth + 1), (middle, high, depth + 1)]
    return True


def _rotated(vector: Array, middle: float, radius: float) -> arb_mat:
    """Rotations by a vector times all shares of a ball, by Rodrigues' formula."""
    unit = arb_mat([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    if not vector.any():
        return unit
    x, y, z = (arb(float(entry)) for entry in vector)
    angle = (x * x + y * y + z * z).sqrt()
    turned = angle * arb(middle, radius)
    cross = arb_mat([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / angle
    return unit + cross * turned.sin() + cross * cross * (1 - turned.cos())


def _definite(radius: float, position: Array, rotation: arb_mat) -> bool:
    """Whether all factors have one sign over a ball of rotations."""
    rows = [[rotation[i, j] for j in range(3)] for i in range(3)]
    result = arb_kernels.direct_singularity(radius, position.tolist(), rows)
    return all(bool(f > 0) or bool(f < 0) for f in (*result.extension, result.orientation))
