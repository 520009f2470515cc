"""Connected components of the workspace, through vertical lines and the segments between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.lines import stretches, wholly_inside
from kleinform.maps.quadrics import Constraint

__all__ = ["Components", "components_of"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]

UP = np.array([0.0, 0.0, 1.0])
#: What looks like a small component is tried again: so often, so many, to so many runs.
BRIDGES = 2
MOST_BRIDGED = 200
NEAREST = 64


@dataclass(frozen=True, eq=False)
class Components:
    """Pieces of the workspace, the largest first.

    What is one piece here is connected: its parts are joined by segments that are wholly in
    the workspace, vertical ones and others, on which every limit is a quadratic that is solved,
    not sampled. So no more pieces that a line meets exist than are counted. There may be fewer,
    if a passage narrower than ``cell`` joins two, and pieces as narrow may be missed.

    Attributes
    ----------
    count : int
    positions : array (count, 3)
        A position in each [m].
    volumes : array (count,)
        About their volumes, by the lengths of the vertical lines [m³].
    cell : float
        Distance of the vertical lines [m].
    """

    count: int
    positions: Array
    volumes: Array
    cell: float


def components_of(constraints: list[Constraint], low: Array, high: Array, lines: int) -> Components:
    """Components in the box (3,), (3,), with ``lines`` vertical lines along its longer side."""
    cell = float(max(high[:2] - low[:2])) / lines
    if (high <= low).any():
        return Components(0, np.zeros((0, 3)), np.zeros(0), cell)
    counts = np.maximum(np.ceil((high - low)[:2] / cell).astype(int), 1)
    x, y = (low[k] + cell * (np.arange(counts[k]) + 0.5) for k in (0, 1))
    feet = np.stack([*np.meshgrid(x, y, indexing="ij"), np.zeros((len(x), len(y)))], axis=-1)
    flat = feet.reshape(-1, 3)
    column, bottom, top = _runs(constraints, flat, float(low[2]), float(high[2]))
    length, middles = top - bottom, flat[column] + ((bottom + top) / 2.0)[:, np.newaxis] * UP
    label = _labels(len(column), _neighbours(constraints, flat, len(y), column, bottom, top))
    for _ in range(BRIDGES):
        label = label[_labels(len(column), _bridges(constraints, middles, length, label))]
    kinds, label = np.unique(label, return_inverse=True)
    volumes: Array = np.bincount(label, length * cell**2, len(kinds)).astype(np.float64)
    order = np.argsort(-volumes, kind="stable")
    longest = _longest(length, label)[order]
    return Components(len(kinds), middles[longest], volumes[order], cell)


def _longest(length: Array, label: Index) -> Index:
    """The longest run of each component, in the order of their labels."""
    order = np.lexsort((-length, label))
    _, first = np.unique(label[order], return_index=True)
    found: Index = order[first]
    return found


def _bridges(constraints: list[Constraint], middles: Array, length: Array, label: Index) -> Index:
    """Pairs (M, 2) of runs that a segment inside joins: the longest of each small component,
    and the runs of others that are nearest to it.
    """
    ends = _longest(length, label)
    ends = ends[length[ends] < length[ends].max(initial=0.0)][:MOST_BRIDGED]
    found = [np.stack([np.arange(len(label)), label], axis=1)]
    for end in ends.tolist():
        away = np.linalg.norm(middles - middles[end], axis=1)
        away[label == label[end]] = np.inf
        near = np.argsort(away)[:NEAREST]
        near = near[np.isfinite(away[near])]
        start = np.repeat(middles[end][np.newaxis], len(near), axis=0)
        joined = near[wholly_inside(constraints, start, middles[near])]
        found.append(np.stack([np.full(len(joined), end), joined], axis=1))
    return np.concatenate(found)


def _runs(
    constraints: list[Constraint], feet: Array, low: float, high: float
) -> tuple[Index, Array, Array]:
    """Where vertical lines are inside: the line, the lower and the upper end of each run."""
    edges, kept = stretches(constraints, feet, np.tile(UP, (len(feet), 1)), low, high)
    # Empty stretches do not end a run, but they start none.
    empty = np.diff(edges, axis=1) <= 0.0
    for k in range(1, kept.shape[1]):
        kept[:, k] = np.where(empty[:, k], kept[:, k - 1], kept[:, k])
    closed = np.pad(kept, ((0, 0), (1, 1)))
    line, first = np.nonzero(closed[:, 1:] & ~closed[:, :-1])
    _, last = np.nonzero(closed[:, :-1] & ~closed[:, 1:])
    bottom, top = edges[line, first], edges[line, last]
    real = top > bottom
    return line[real], bottom[real], top[real]


def _neighbours(
    constraints: list[Constraint], feet: Array, row: int, column: Index, bottom: Array, top: Array
) -> Index:
    """Pairs (M, 2) of runs on neighbouring lines that a horizontal segment inside joins."""
    found = []
    first = np.searchsorted(column, np.arange(len(feet) + 1))
    most = int(np.diff(first).max(initial=0))
    for step in (1, row):
        other = column + step
        same = (other < len(feet)) & ((step == row) | (other % row != 0))
        for k in range(most):
            here = np.flatnonzero(same)
            there = first[other[here]] + k
            here = here[there < first[other[here] + 1]]
            there = first[other[here]] + k
            floor = np.maximum(bottom[here], bottom[there])
            ceiling = np.minimum(top[here], top[there])
            meet = floor < ceiling
            here, there = here[meet], there[meet]
            level = ((floor + ceiling) / 2.0)[meet, np.newaxis] * UP
            joined = wholly_inside(
                constraints, feet[column[here]] + level, feet[column[there]] + level
            )
            found.append(np.stack([here[joined], there[joined]], axis=1))
    return np.concatenate(found) if found else np.zeros((0, 2), dtype=int)


def _labels(count: int, pairs: Index) -> Index:
    """The least number in the component of each node of a graph."""
    label = np.arange(count)
    while True:
        least = label.copy()
        joined = label[pairs].min(axis=1) if len(pairs) else np.zeros(0, dtype=int)
        for side in (0, 1):
            np.minimum.at(least, pairs[:, side], joined)
            np.minimum.at(least, label[pairs[:, side]], joined)
        least = least[least]
        if (least == label).all():
            return label
        label = least
