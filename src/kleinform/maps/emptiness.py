"""Why no position keeps all limits of one orientation: some of them that exclude each other.

A box is cut into boxes, and those are left out on which a constraint is negative. On a box with
the middle m and the half sides h a quadric is at most ``g(m) + |∇g(m)|·h + Σ |A_ik| h_i h_k``, A
the part of second order, its negative squares left out. All in float64: what is negative by less
than `ROUNDING` of its terms is not taken to be.
"""

from __future__ import annotations

from itertools import product
from math import inf

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.limits import Limits
from kleinform.maps.patches import extent
from kleinform.maps.quadrics import Constraint, constraints_of, slabs_of

__all__ = ["excluding"]

Array = NDArray[np.float64]

ROUNDING = 1e-9
#: Boxes that are looked at together, at most: what needs more is not known to be empty.
MOST_BOXES = 1_000_000
CORNERS = np.array(list(product((-0.5, 0.5), repeat=3)))
#: In this order ends are left out on trial: last those that bound the workspace.
ENDS = (
    *((f"q{i}", "low") for i in (1, 2, 3, 6)),
    *product(("q4", "q5", "e1", "e2", "e3"), ("low", "high")),
    *((f"q{i}", "high") for i in (1, 2, 3, 6)),
)


def excluding(radius: float, rotation: Array, limits: Limits) -> tuple[str, ...]:
    """Ends of ranges that no position keeps together, as `Workspace.conflict` says."""
    if not _is_empty(radius, rotation, limits):
        return ()
    left = []
    for name, end in ENDS:
        if abs(limits.range_of(name)[end == "high"]) == inf:
            continue
        fewer = _without(limits, name, end)
        if _is_empty(radius, rotation, fewer):
            limits = fewer
        else:
            left.append(f"{name} {end}")
    return tuple(sorted(left, key=lambda end: (end[:2], end.endswith("high"))))


def _without(limits: Limits, name: str, end: str) -> Limits:
    low, high = limits.range_of(name)
    return Limits({**limits.ranges, name: (-inf, high) if end == "low" else (low, inf)})


def _is_empty(radius: float, rotation: Array, limits: Limits) -> bool:
    """Whether the limits bound a workspace in which there is no position for sure."""
    slabs = slabs_of(radius, rotation, limits)
    try:
        low, high = np.array([extent(slabs, axis) for axis in np.eye(3)]).T
    except InputError:  # unbounded
        return False
    if (low > high).any():
        return True
    constraints = constraints_of(radius, rotation, limits)
    middle, half = (low + high)[np.newaxis] / 2.0, (high - low) / 2.0
    while 0 < len(middle) <= MOST_BOXES and half.any():
        least, most = _bounds(constraints, middle, half)
        if (least >= 0.0).any():
            return False
        middle = (middle[most >= 0.0, np.newaxis] + CORNERS * half).reshape(-1, 3)
        half = half / 2.0
    return len(middle) == 0


def _bounds(constraints: list[Constraint], middle: Array, half: Array) -> tuple[Array, Array]:
    """The least constraint at the middles (N, 3) of boxes, and at most what it is in the boxes."""
    points = np.append(middle, np.ones((len(middle), 1)), axis=1)
    reach = np.append(abs(middle) + half, np.ones((len(middle), 1)), axis=1)
    least, most = (np.full(len(middle), inf) for _ in range(2))
    for constraint in constraints:
        at_middle, in_box = (np.full(len(middle), -inf) for _ in range(2))
        for form in constraint.forms:
            image = points @ form.matrix
            value = (image * points).sum(axis=1)
            bend = abs(form.matrix[:3, :3])
            bend[np.diag_indices(3)] = np.maximum(np.diag(form.matrix)[:3], 0.0)
            size = ((reach @ abs(form.matrix)) * reach).sum(axis=1)
            top = value + 2.0 * abs(image[:, :3]) @ half + half @ bend @ half + ROUNDING * size
            at_middle, in_box = np.maximum(at_middle, value), np.maximum(in_box, top)
        least, most = np.minimum(least, at_middle), np.minimum(most, in_box)
    return least, most
