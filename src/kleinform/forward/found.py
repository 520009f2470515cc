"""Modes as they are found, before anything is computed from them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Found", "found", "nothing", "some", "together"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]


class Found(NamedTuple):
    """Modes as they are found.

    The row of each, n_1 and n_2 (K, 2, 3), how many solutions have merged in it, and the e_i
    (K, 3) where they do not follow from n_i, NaN where they do.
    """

    row: Integers
    directions: Array
    multiplicity: Integers
    extension: Array


def found(row: Integers, directions: Array, multiplicity: Integers | int) -> Found:
    """Modes whose e_i follow from their directions."""
    number = np.broadcast_to(np.asarray(multiplicity, dtype=np.int64), row.shape)
    return Found(row, directions.reshape(-1, 2, 3), number, np.full((len(row), 3), np.nan))


def nothing() -> Found:
    """No mode."""
    return found(np.empty(0, dtype=np.int64), np.empty((0, 2, 3)), 1)


def together(parts: list[Found]) -> Found:
    """The modes of all parts."""
    parts = [part for part in parts if len(part.row)] or [nothing()]
    return (
        parts[0] if len(parts) == 1 else Found._make(map(np.concatenate, zip(*parts, strict=True)))
    )


def some(modes: Found, which: Mask) -> Found:
    """The modes of a mask."""
    return Found._make(entry[which] for entry in modes)
