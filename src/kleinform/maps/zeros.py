"""Where a function vanishes: triangles over a grid of a box, polylines over one of a rectangle.

Marching simplices: a function that is affine on each tetrahedron or triangle of the grid has no
ambiguous cases. Every vertex is then moved along its edge to where the function itself changes
its sign, by halving.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.mesh import HALVINGS, marched, tetrahedra_of

__all__ = ["Triangles", "zero_curves", "zero_mesh"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]
Function = Callable[[Array], Array]


class Triangles(NamedTuple):
    """A surface; the corners of a triangle are counter-clockwise seen from its negative side.

    Attributes
    ----------
    vertices : array (N, 3)
    triangles : int array (M, 3)
    """

    vertices: Array
    triangles: Index


def zero_mesh(function: Function, bounds: Array, count: int) -> Triangles:
    """Where a function of positions (..., 3) changes its sign in a box, ``count`` cells an edge."""
    nodes = _grid(bounds, count)
    kept = function(nodes) > 0.0
    ends, corners = marched(kept, tetrahedra_of(kept, np.full(3, count + 1)))
    vertices, places = _vertices(function, nodes, ends)
    return Triangles(vertices, places[corners])


def zero_curves(function: Function, bounds: Array, count: int) -> list[Array]:
    """Where a function of positions (..., 2) changes its sign in a rectangle: polylines (N, 2).

    The first and the last point of a closed one are the same.
    """
    nodes = _grid(bounds, count)
    kept = function(nodes) > 0.0
    vertices, places = _vertices(function, nodes, _crossed(kept, count))
    return [vertices[chain] for chain in _chains(places.reshape(-1, 2))]


def _grid(bounds: Array, count: int) -> Array:
    """The nodes of a grid, the last axis first in turn: (N, axes)."""
    axes = [np.linspace(low, high, count + 1) for low, high in bounds.T]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))


def _vertices(function: Function, nodes: Array, ends: Index) -> tuple[Array, Index]:
    """The vertex of each edge (kept node, lost node) once, and which one each edge has."""
    keys, places = np.unique(ends[:, 0] * len(nodes) + ends[:, 1], return_inverse=True)
    kept, lost = nodes[keys // len(nodes)], nodes[keys % len(nodes)]
    low, high = np.zeros((len(keys), 1)), np.ones((len(keys), 1))
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        within = (function(kept + middle * (lost - kept)) > 0.0)[:, np.newaxis]
        low, high = np.where(within, middle, low), np.where(within, high, middle)
    return kept + low * (lost - kept), places.reshape(-1).astype(np.intp)


def _crossed(kept: Mask, count: int) -> Index:
    """Two edges (kept node, lost node) after another for each triangle that the curve crosses."""
    width = count + 1
    corner = np.arange(width * width).reshape(width, width)[:-1, :-1].ravel()
    lower, upper = (0, 1, width + 1), (0, width + 1, width)
    triangles = np.concatenate([corner[:, np.newaxis] + steps for steps in (lower, upper)])
    inside = kept[triangles]
    mixed = np.isin(inside.sum(axis=1), (1, 2))
    triangles, inside = triangles[mixed], inside[mixed]
    single = inside == (inside.sum(axis=1) == 1)[:, np.newaxis]
    alone = triangles[single]
    rest = triangles[~single].reshape(-1, 2)
    pairs = np.stack([np.broadcast_to(alone[:, np.newaxis], rest.shape), rest], axis=-1)
    swap = ~kept[alone]
    pairs[swap] = pairs[swap][..., ::-1]
    found: Index = pairs.reshape(-1, 2)
    return found


def _chains(segments: Index) -> list[list[int]]:
    """Segments (N, 2) of vertices joined end to end; a vertex is in one or two of them."""
    neighbours: dict[int, list[int]] = {}
    for one, other in segments.tolist():
        neighbours.setdefault(one, []).append(other)
        neighbours.setdefault(other, []).append(one)
    ends = [vertex for vertex, near in neighbours.items() if len(near) == 1]
    chains, left = [], set(neighbours)
    for start in [*ends, *neighbours]:
        if start not in left:
            continue
        chain = [start]
        left.discard(start)
        while following := [near for near in neighbours[chain[-1]] if near in left]:
            chain.append(following[0])
            left.discard(following[0])
        if len(neighbours[start]) == 2:
            chain.append(start)
        chains.append(chain)
    return chains
