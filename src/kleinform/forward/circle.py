"""The angle of one leg as the only unknown: the eliminant along its circle.

A row is a set of joint values with its geometry. One limb of each row, its base, carries
the unknown angle theta of its leg. Where C lies near one side of the circle of B, the
direction n turns fast there and the eliminant varies by many orders of magnitude. In the
angle psi with ``tan((theta − theta_far)/2) = stretch tan(psi/2)``, where theta_far belongs to
the point of the circle farthest from C and stretch² is the ratio of the longest to the
shortest distance, both are even, and the eliminant times a known weight is a trigonometric
polynomial of degree 16.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from kleinform.generated import kernels

__all__ = ["DEGREE", "Circles", "Rows", "circles_of", "fourier", "turned"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Vectors = TypeVar("Vectors", Array, NDArray[np.complex128])

#: Degree of the weighted eliminant in psi: 32 zeros, as many as there are pairs ±n.
DEGREE = 16
#: Samples on the circle: two more than needed, which show the rounding.
SAMPLES = 2 * DEGREE + 4
#: C is almost in the plane of a leg at a distance below this, in radii.
NEAR_PLANE = 0.01
#: Cosine and sine of the turn about Z that takes limb 1, 2, 3 to the place of limb 1.
COSINE = np.array([1.0, -0.5, -0.5])
SINE = np.array([0.0, -np.sqrt(0.75), np.sqrt(0.75)])
#: u_1, u_2, u_3.
AXES = np.stack([COSINE, -SINE, np.zeros(3)], axis=-1)


@dataclass(frozen=True)
class Rows:
    """Joint values as they enter the closure equations: radius (N,), c (N, 3), lengths (N, 3)."""

    radius: Array
    position: Array
    lengths: Array
    joints: Array

    def __len__(self) -> int:
        return len(self.radius)

    def __getitem__(self, index: slice | Integers | list[int]) -> Rows:
        return Rows(
            self.radius[index], self.position[index], self.lengths[index], self.joints[index]
        )


@dataclass(frozen=True)
class Circles:
    """The circle of B of the base limb, the limbs relabelled so that the base is limb 1."""

    base: Integers
    position: Array
    lengths: Array
    far: Array
    stretch: Array

    def leg(self, row: Integers, psi: Array) -> Array:
        """Cosine and sine of theta at psi, (..., 2)."""
        x, y = np.cos(psi / 2.0), self.stretch[row] * np.sin(psi / 2.0)
        square = x * x + y * y
        cosine, sine = (x * x - y * y) / square, 2.0 * x * y / square
        far_cosine, far_sine = np.cos(self.far[row]), np.sin(self.far[row])
        return np.stack(
            [
                far_cosine * cosine - far_sine * sine,
                far_sine * cosine + far_cosine * sine,
            ],
            axis=-1,
        )

    def psi(self, row: Integers, theta: Array) -> Array:
        """The inverse of `leg`, in [−π, π]."""
        half = (theta - self.far[row]) / 2.0
        return 2.0 * np.arctan2(np.sin(half), self.stretch[row] * np.cos(half))

    def reference(self, row: Integers, radius: Array, angle: Array) -> Array:
        """A vector that is not parallel to n_1 at these angles of leg 1: i or k."""
        across = radius[row] - self.position[row, 0]
        height = self.lengths[row, 0] * angle[..., 1] - self.position[row, 2]
        upright = abs(across) <= abs(height)
        return np.where(upright[..., np.newaxis], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])


def turned(vectors: Vectors, base: Integers, back: bool = False) -> Vectors:
    """Turn vectors (N, ..., 3) about Z so that the base limb comes to limb 1, or back."""
    axes = (slice(None),) + (np.newaxis,) * (vectors.ndim - 2)
    cosine, sine = COSINE[base][axes], SINE[base][axes] * (-1.0 if back else 1.0)
    result = np.empty(vectors.shape, dtype=vectors.dtype)
    x, y = vectors[..., 0], vectors[..., 1]
    result[..., 0], result[..., 1] = cosine * x - sine * y, sine * x + cosine * y
    result[..., 2] = vectors[..., 2]
    return result


def relabel(rows: Rows, base: Integers) -> tuple[Array, Array]:
    """C (N, 3) and the leg lengths (N, 3) with the base limb in the place of limb 1."""
    order = (base[:, np.newaxis] + np.arange(3)) % 3
    return turned(rows.position, base), np.take_along_axis(rows.lengths, order, axis=1)


def circles_of(rows: Rows, rank: int) -> Circles:
    """The circles of base limbs: the best of each row, the second best or the third.

    The best keeps B at the most even distance from C. A limb with C almost in the plane of
    its leg comes first: in pairs of its modes B is far apart, and the platform is not.
    """
    x, y, z = rows.position.T
    # One row a limb, the mechanism turned so that it is limb 1.
    across = rows.radius - COSINE[:, np.newaxis] * x + SINE[:, np.newaxis] * y
    aside = SINE[:, np.newaxis] * x + COSINE[:, np.newaxis] * y
    offset, lengths = np.hypot(aside, z), rows.lengths.T
    longest, shortest = np.hypot(across, offset + lengths), np.hypot(across, offset - lengths)
    with np.errstate(divide="ignore", invalid="ignore"):
        stretch = np.sqrt(longest / shortest)
    stretch = np.where(np.isfinite(stretch), stretch, np.inf)
    score = np.where(abs(across) <= NEAR_PLANE * rows.radius, -stretch, stretch)
    base = np.argsort(score, axis=0, kind="stable")[rank]
    row = np.arange(len(rows))
    position, own_lengths = relabel(rows, base)
    return Circles(
        base=base,
        position=position,
        lengths=own_lengths,
        far=np.arctan2(-z, -aside[base, row]),
        stretch=stretch[base, row],
    )


def fourier(rows: Rows, circles: Circles) -> tuple[Array, Array]:
    """Cosine and sine coefficients (N, 33) of the weighted eliminant, and its rounding (N,).

    The eliminant is scaled to largest sample 1. Its rounding is read off the harmonics above
    the degree, which are zero but for it.
    """
    psi: Array = 2.0 * np.pi / SAMPLES * np.arange(SAMPLES, dtype=np.float64)
    row = np.arange(len(rows))[:, np.newaxis]
    angle = circles.leg(row, psi)
    sampled = kernels.eliminant(
        rows.radius[:, np.newaxis],
        circles.position[:, np.newaxis],
        circles.lengths[:, np.newaxis],
        angle,
        circles.reference(row, rows.radius, angle),
    )
    x2, y2 = np.cos(psi / 2.0) ** 2, np.sin(psi / 2.0) ** 2
    square = circles.stretch[:, np.newaxis] ** 2
    # Its power DEGREE/2.
    even = (x2 + square * y2) * (x2 + y2 / square)
    fourth = (even * even) * (even * even)
    values = sampled.eliminant * (fourth * fourth)
    with np.errstate(divide="ignore", invalid="ignore"):
        values /= abs(values).max(axis=1, keepdims=True)
    spectrum = np.fft.rfft(values, axis=1) / SAMPLES
    kept, rest = spectrum[:, : DEGREE + 1], spectrum[:, DEGREE + 1 :]
    coefficients = np.concatenate(
        [kept[:, :1].real, 2.0 * kept[:, 1:].real, -2.0 * kept[:, 1:].imag], axis=1
    )
    return coefficients, abs(rest).max(axis=1)
