"""The volume of a workspace, with a proven bound of its error (needs python-flint)."""

from __future__ import annotations

from dataclasses import dataclass
from math import fsum

import numpy as np
from numpy.typing import NDArray

from kleinform.limits import Limits
from kleinform.maps.panels import examine
from kleinform.maps.patches import PRECISION, Patch, extent, patches_of
from kleinform.maps.quadrics import constraints_of, slabs_of
from kleinform.precision import working_precision

__all__ = ["Volume", "volume_of"]

Array = NDArray[np.float64]

#: Panels of each patch at first, and those that one is cut into.
FIRST = 8
PARTS = 4
MOST_PANELS = 100_000
#: Panels are no narrower, relative to the range of v: what they leave open stays an error.
NARROWEST = 1e-11
#: An error that is small enough for a workspace without volume, relative to a box around it.
EMPTY = 1e-9


@dataclass(frozen=True)
class Volume:
    """A volume, ``|value - true| <= error`` [m³].

    Attributes
    ----------
    value, error : float
    proven : bool
        Whether the error is at most what was asked for, or at most 1e-9 of the box around a
        workspace that is nearly empty. The bound is proven in any case.
    panels : int
        Pieces of the boundary that were integrated.
    """

    value: float
    error: float
    proven: bool
    panels: int


@dataclass(eq=False)
class Sheet:
    """The panels of one patch, and what they carry."""

    patch: Patch
    low: Array
    high: Array
    carried: Array
    error: Array

    @classmethod
    def of(cls, patch: Patch) -> Sheet:
        """The first panels."""
        edges = np.linspace(patch.low, patch.high, FIRST + 1)
        return cls(patch, edges[:-1], edges[1:], *examine(patch, edges[:-1], edges[1:]))

    def refine(self, share: float) -> bool:
        """Cut the panels whose error is larger; whether there were any that can be cut."""
        least = NARROWEST * (self.patch.high - self.patch.low)
        large = (self.error >= share) & (self.high - self.low > least)
        if not large.any():
            return False
        edges = np.linspace(self.low[large], self.high[large], PARTS + 1)
        low, high = edges[:-1].ravel(), edges[1:].ravel()
        carried, error = examine(self.patch, low, high)
        kept = ~large
        self.low = np.concatenate([self.low[kept], low])
        self.high = np.concatenate([self.high[kept], high])
        self.carried = np.concatenate([self.carried[kept], carried])
        self.error = np.concatenate([self.error[kept], error])
        return True


def volume_of(radius: float, rotation: Array, limits: Limits, relative: float) -> Volume:
    """The volume of the workspace of one orientation, as `Workspace.volume` says."""
    with working_precision(PRECISION):
        from flint import arb

        slabs = slabs_of(radius, rotation, limits, arb)
        constraints = constraints_of(radius, rotation, limits, arb)
    sides = [np.diff(extent(slabs, axis)).item() for axis in np.eye(3)]
    if min(sides) <= 0.0:
        return Volume(0.0, 0.0, True, 0)
    with working_precision(PRECISION):
        patches = patches_of(constraints, slabs)
    with np.errstate(all="ignore"):
        return _refined([patch for patch in patches if patch.low < patch.high], relative, sides)


def _refined(patches: list[Patch], relative: float, sides: list[float]) -> Volume:
    """Cut panels until the error is small enough, or until no panel can be cut."""
    sheets = [Sheet.of(patch) for patch in patches]
    smallest = EMPTY * float(np.prod(sides))
    while True:
        errors = np.sort(np.concatenate([np.zeros(0), *(sheet.error for sheet in sheets)]))
        value = fsum(x for sheet in sheets for x in sheet.carried)
        error = fsum(errors) * (1.0 + 1e-12)
        reached = error <= max(relative * (abs(value) - error), smallest)
        if reached or len(errors) > MOST_PANELS:
            break
        # Those with the least errors, half of what is allowed together, need not be cut.
        allowed = max(relative * abs(value), smallest) / 2.0
        kept = int(np.searchsorted(np.cumsum(errors), allowed))
        share = float(errors[min(kept, len(errors) - 1)])
        if not sum(sheet.refine(share) for sheet in sheets):
            break
    return Volume(value, error, bool(reached), len(errors))
