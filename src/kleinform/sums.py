"""Products and sums of the entries of each row, the same bits whatever stands beside the row.

BLAS goes by the size of a batch, and `numpy.einsum` and sums by how it lies in memory: both
then round the sums of a row in another order. Here a sum goes over its terms in their order,
one addition of whole arrays after the other, and these round every entry on its own.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["dot", "product", "turned_by"]

Numbers = NDArray[Any]


@np.errstate(all="ignore")
def dot(one: Numbers, other: Numbers) -> Numbers:
    """Σ_k ``one[..., k] other[..., k]``; leading axes broadcast.

    Rows that are not finite give NaN or inf without a warning, as those of `numpy.einsum` do.
    """
    total = one[..., 0] * other[..., 0]
    for k in range(1, one.shape[-1]):
        total = total + one[..., k] * other[..., k]
    return total


def turned_by(matrices: Numbers, vectors: Numbers) -> Numbers:
    """Matrices (..., m, n) times vectors (..., n)."""
    return dot(matrices, vectors[..., None, :])


def product(one: Numbers, other: Numbers) -> Numbers:
    """Matrices (..., m, n) times matrices (..., n, p)."""
    return dot(one[..., None, :], other.swapaxes(-1, -2)[..., None, :, :])
