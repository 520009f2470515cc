"""Warnings of poses near a singularity, at the line of the user that called."""

from __future__ import annotations

import sys
import warnings
from types import FrameType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import SingularityWarning
from kleinform.zero import NEAR

__all__ = ["Near", "warn_near"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]
PACKAGE = __name__.partition(".")[0]


class Near(NamedTuple):
    """A factor, the flat indices of poses at which it nearly vanishes, and |f|/scale there."""

    name: str
    rows: Index
    ratio: Array


def warn_near(near: list[Near], valid: Mask) -> None:
    """Warn once of all poses near a singularity that were not refused.

    Parameters
    ----------
    near : list of Near
    valid : bool array (...)
        The poses that were not refused.
    """
    mask = np.zeros(valid.size, dtype=bool)
    ratios: dict[str, float] = {}
    for name, rows, ratio in near:
        kept = valid.ravel()[rows]
        if kept.any():
            mask[rows[kept]] = True
            ratios[name] = min(float(ratio[kept].min()), ratios.get(name, np.inf))
    if ratios:
        words = _words(ratios, mask, valid.shape)
        warning = SingularityWarning(words, mask.reshape(valid.shape), ratios)
        warnings.warn(warning, stacklevel=_level())


def _words(ratios: dict[str, float], mask: Mask, lead: tuple[int, ...]) -> str:
    named = ", ".join(
        f"{name} {ratios[name]:.2g}" for name in sorted(ratios, key=ratios.__getitem__)
    )
    text = f"near a singularity: |f|/scale below √eps = {NEAR:.2g}, {named}"
    if not lead:
        return text
    first = np.unravel_index(int(np.argmax(mask)), lead)
    where = int(first[0]) if len(lead) == 1 else tuple(map(int, first))
    return f"{text}, first at pose {where}; {int(mask.sum())} of {mask.size} poses"


def _is_ours(frame: FrameType) -> bool:
    return str(frame.f_globals.get("__name__")).partition(".")[0] == PACKAGE


def _level() -> int:
    """The number of frames from the caller of this one out to the first outside of kleinform."""
    frame, level = sys._getframe(1), 1
    while _is_ours(frame) and frame.f_back is not None:
        frame, level = frame.f_back, level + 1
    return level
