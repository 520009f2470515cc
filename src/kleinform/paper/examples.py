"""The two worked motions of Section VI."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.paper import printed

__all__ = ["example_1", "example_2", "quintic_coefficients"]

Array = NDArray[np.float64]


def example_1(time: Array) -> Array:
    """Joint values (T, 6) of Example 1, periodic, for 0 <= t <= 2π s."""
    sine, product = np.sin(time), np.sin(time) * np.cos(time)
    return np.stack(
        [
            1.0 + 0.25 * product,
            1.191 + 0.3 * product,
            0.869 + 0.2 * product,
            0.6747 + np.pi / 18.0 * sine,
            1.2609 - np.pi / 9.0 * sine**2,
            1.05 + 0.25 * product,
        ],
        axis=-1,
    )


def quintic_coefficients(start: Array, end: Array, duration: float) -> Array:
    """``mu_0, mu_3, mu_4, mu_5`` (n, 4) of the quintics that go from rest to rest.

    Velocity and acceleration vanish at both ends, so that with s = t/T the motion is
    ``start + (end − start)(10 s³ − 15 s⁴ + 6 s⁵)``.
    """
    powers = np.array([10.0 / duration**3, -15.0 / duration**4, 6.0 / duration**5])
    return np.column_stack([start, (end - start)[:, np.newaxis] * powers])


def example_2(time: Array, coefficients: Array | None = None) -> Array:
    """Joint values (T, 6) of Example 2, with the printed coefficients unless others are given."""
    if coefficients is None:
        coefficients = np.array(printed.TABLE_2, dtype=np.float64)
    powers = np.stack([np.ones_like(time), time**3, time**4, time**5])
    return (coefficients @ powers).T
