"""Angles of the legs of platforms whose directions are known, both where there are two."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["leg_angles"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]

#: Azimuths of the axes u_i.
AZIMUTHS = np.arange(3) * (2.0 * np.pi / 3.0)
#: Both ends of the chord that a line through C cuts off a leg's circle are tried when both are
#: that near to the circle's plane, relative to the sizes of the manipulator.
NEAR_PLANE = 1e-3


def leg_angles(
    radius: float, position: Array, lengths: Array, pairs: Complex
) -> tuple[Complex, Index]:
    """Angles (m, 2) of legs 1 and 2 in their circles, and the pair that each is from.

    ``pairs`` are n_1 and n_2 (k, 2, 3), complex ones too.
    """
    options = []
    for limb in range(2):
        axis = np.array([np.cos(AZIMUTHS[limb]), np.sin(AZIMUTHS[limb]), 0.0])
        center = position - radius * axis
        options.append(_chord(center, float(lengths[limb]), axis, pairs[:, limb]))
    found, labels = [], []
    for first, first_fits in zip(*options[0], strict=True):
        for second, second_fits in zip(*options[1], strict=True):
            good = first_fits & second_fits & np.isfinite(first) & np.isfinite(second)
            found.append(np.stack([first, second], axis=1)[good])
            labels.append(np.flatnonzero(good))
    return np.concatenate(found), np.concatenate(labels)


def _chord(
    center: Array, length: float, axis: Array, n: Complex
) -> tuple[list[Complex], list[Mask]]:
    """Angles of a leg where the line along n meets its sphere, and which are in its plane.

    The better one of the two counts as in the plane, whatever its distance.
    """
    half = -(n @ center)
    root = np.sqrt(half**2 - center @ center + length**2)
    legs = [center + extension[:, np.newaxis] * n for extension in (half + root, half - root)]
    distances = [np.abs(leg @ axis) for leg in legs]
    sideways = np.cross([0.0, 0.0, 1.0], axis)
    angles = [-1j * np.log((leg @ sideways + 1j * leg[:, 2]) / np.float64(length)) for leg in legs]
    near = NEAR_PLANE * (length + np.abs(center).max())
    fits = [
        np.asarray((distance <= other) | (distance <= near))
        for distance, other in (distances, distances[::-1])
    ]
    return angles, fits
