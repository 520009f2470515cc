"""Joint values that are no regular case, told apart before anything is solved."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import AXES, COSINE, SINE, Rows

__all__ = ["IN_PLANE", "in_plane_exactly", "near_plane", "on_circle", "reach_of", "zero_leg"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
#: Rounding of distances between C and the legs' planes, in eps times the reach.
ROUNDING = 8.0
#: C counts as near the plane of a leg below this distance, in reaches: of two modes that differ
#: in one B the platform's directions are then as near.
NEAR_PLANE = 1e-3
#: Below this one they are the same in float64.
IN_PLANE = 1e-9


def reach_of(rows: Rows) -> Array:
    """a + |c| + q: the size of what the closure equations add up (N, 3)."""
    size = rows.radius + np.linalg.norm(rows.position, axis=1)
    return np.asarray(size[:, np.newaxis] + rows.lengths)


def across(rows: Rows) -> Array:
    """h_i = a − c·u_i, the distance of C from the planes of the legs (N, 3)."""
    x, y = rows.position[:, :1], rows.position[:, 1:2]
    return np.asarray(rows.radius[:, np.newaxis] - COSINE * x + SINE * y)


def near_plane(rows: Rows, limit: float = NEAR_PLANE) -> Mask:
    """Limbs with C near the plane of their leg, c·u_i = a (N, 3)."""
    return np.asarray(abs(across(rows)) <= limit * reach_of(rows))


def in_plane_exactly(rows: Rows, tolerance: float) -> Mask:
    """Limbs with c·u_i = a within rounding and the tolerance of the joint values (N, 3)."""
    return np.asarray(abs(across(rows)) <= (ROUNDING * EPS + tolerance) * reach_of(rows))


def zero_leg(rows: Rows) -> Mask:
    """Limbs with q_i = 0 within rounding (N, 3)."""
    return np.asarray(rows.lengths <= ROUNDING * EPS * reach_of(rows))


def on_circle(rows: Rows, tolerance: float) -> Mask:
    """Limbs with C on the circle of their B: with B at C the limb holds nothing (N, 3)."""
    slack = (ROUNDING * EPS + tolerance) * reach_of(rows)
    foot = rows.radius[:, np.newaxis, np.newaxis] * AXES
    distance = np.linalg.norm(rows.position[:, np.newaxis] - foot, axis=2)
    return np.asarray((abs(across(rows)) <= slack) & (abs(distance - rows.lengths) <= slack))
