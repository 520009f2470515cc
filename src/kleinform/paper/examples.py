"""The two worked motions of Section VI."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.motion import JointMotion, polynomials
from kleinform.paper import printed

__all__ = ["example_1", "example_2"]

Array = NDArray[np.float64]
#: Example 1: q = CONSTANT + SWING sin t + DOUBLE sin t cos t + SQUARE sin² t.
CONSTANT = np.array([1.0, 1.191, 0.869, 0.6747, 1.2609, 1.05])
SWING = np.array([0.0, 0.0, 0.0, np.pi / 18.0, 0.0, 0.0])
DOUBLE = np.array([0.25, 0.3, 0.2, 0.0, 0.0, 0.25])
SQUARE = np.array([0.0, 0.0, 0.0, 0.0, -np.pi / 9.0, 0.0])


def example_1() -> JointMotion:
    """Example 1: periodic generalized coordinates, for 0 <= t <= 2π s."""

    def function(times: Array) -> tuple[Array, Array, Array]:
        t = times[:, np.newaxis]
        sine, cosine, sine2, cosine2 = np.sin(t), np.cos(t), np.sin(2.0 * t), np.cos(2.0 * t)
        return (
            CONSTANT + SWING * sine + 0.5 * DOUBLE * sine2 + SQUARE * sine**2,
            SWING * cosine + DOUBLE * cosine2 + SQUARE * sine2,
            -SWING * sine - 2.0 * DOUBLE * sine2 + 2.0 * SQUARE * cosine2,
        )

    return JointMotion(function, 0.0, 2.0 * np.pi)


def example_2() -> JointMotion:
    """Example 2: quintics from rest to rest, with the coefficients that Table 2 prints."""
    mu = np.zeros((6, 6))
    mu[:, [0, 3, 4, 5]] = np.array(printed.TABLE_2, dtype=np.float64)
    return polynomials(mu, 0.0, printed.END_TIME)
