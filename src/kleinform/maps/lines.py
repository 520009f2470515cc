"""Where straight lines are in the workspace: on a line every form is a quadratic."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.quadrics import Constraint

__all__ = ["inside", "room", "stretches", "wholly_inside"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def room(constraints: list[Constraint], positions: Array) -> Array:
    """The least g over the constraints (...) at positions (..., 3); negative outside."""
    x, y, z = np.moveaxis(positions, -1, 0)
    monomials = (x * x, y * y, z * z, x * y, x * z, y * z, x, y, z, np.ones_like(x))
    least = np.full(x.shape, np.inf)
    for constraint in constraints:
        values = [_value(_entries(form.matrix), monomials) for form in constraint.forms]
        least = np.minimum(least, np.max(values, axis=0))
    return least


def _value(entries: Array, monomials: tuple[Array, ...]) -> Array:
    """A quadric at points, the same bits for a point whatever others there are."""
    total = entries[0] * monomials[0]
    for entry, monomial in zip(entries[1:], monomials[1:], strict=True):
        total = total + entry * monomial
    return np.asarray(total)


def _entries(g: Array) -> Array:
    """The coefficients (10,) of a quadric by monomial."""
    mixed = [2.0 * g[i, k] for i, k in ((0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3))]
    return np.array([g[0, 0], g[1, 1], g[2, 2], *mixed, g[3, 3]])


def inside(constraints: list[Constraint], positions: Array) -> Mask:
    """Whether positions (..., 3) keep every constraint, as a mask (...)."""
    found: Mask = room(constraints, positions) >= 0.0
    return found


def stretches(
    constraints: list[Constraint], start: Array, direction: Array, low: float, high: float
) -> tuple[Array, Mask]:
    """Lines ``start + t direction`` cut where a form vanishes.

    Parameters
    ----------
    start, direction : array (N, 3)
    low, high : float
        Range of t.

    Returns
    -------
    edges : array (N, E + 1)
        Ascending t, from low to high.
    inside : bool array (N, E)
        Whether the middle of a stretch, and so all of it, is in the workspace.
    """
    cuts = [np.full((len(start), 1), low), np.full((len(start), 1), high)]
    point = np.concatenate([start, np.ones((len(start), 1))], axis=1)
    along = np.concatenate([direction, np.zeros((len(start), 1))], axis=1)
    for form in (form for constraint in constraints for form in constraint.forms):
        image = along @ form.matrix
        roots = _roots(
            (image * along).sum(axis=1),
            (image * point).sum(axis=1),
            ((point @ form.matrix) * point).sum(axis=1),
        )
        cuts.append(np.clip(np.where(np.isfinite(roots), roots, low), low, high))
    edges = np.sort(np.concatenate(cuts, axis=1), axis=1)
    middle = (edges[:, 1:] + edges[:, :-1])[..., np.newaxis] / 2.0
    return edges, inside(constraints, start[:, np.newaxis] + middle * direction[:, np.newaxis])


def wholly_inside(constraints: list[Constraint], start: Array, end: Array) -> Mask:
    """Whether whole segments from start to end, (N, 3) each, are in the workspace."""
    edges, kept = stretches(constraints, start, end - start, 0.0, 1.0)
    found: Mask = (kept | (np.diff(edges, axis=1) == 0.0)).all(axis=1)
    return found


def _roots(a: Array, b: Array, c: Array) -> Array:
    """Roots (N, 2) of a t² + 2 b t + c, NaN or infinite where there are none."""
    with np.errstate(all="ignore"):
        q = -(b + np.copysign(np.sqrt(b * b - a * c), b))
        return np.stack([q / a, c / q], axis=1)
