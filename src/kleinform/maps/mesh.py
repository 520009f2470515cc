"""A closed triangle mesh of the boundary, by marching tetrahedra, and its files."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations, product
from os import PathLike

import numpy as np
from numpy.typing import NDArray

from kleinform.files import write_bytes
from kleinform.maps.lines import inside
from kleinform.maps.quadrics import Constraint

__all__ = ["HALVINGS", "Mesh", "marched", "mesh_of", "tetrahedra_of"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]

#: Halvings of an edge of a tetrahedron: to rounding.
HALVINGS = 52
#: Empty cells around the box.
MARGIN = 0.5137


@dataclass(frozen=True, eq=False)
class Mesh:
    """Closed and oriented: every edge is in two triangles, once in each direction.

    Vertices are on the boundary to rounding. Triangles are not: they are off by the order of
    the square of a cell on smooth parts, and cut off edges and corners of the workspace within
    a cell of them.

    Attributes
    ----------
    vertices : array (N, 3)
        [m]
    triangles : int array (M, 3)
        Counter-clockwise seen from outside.
    """

    vertices: Array
    triangles: Index

    @property
    def volume(self) -> float:
        """Of what the triangles enclose [m³]."""
        a, b, c = np.moveaxis(self.vertices[self.triangles], 1, 0)
        return float((np.cross(a, b) * c).sum() / 6.0)

    @property
    def euler_characteristic(self) -> int:
        """Vertices less edges plus triangles: 2 for each piece, less 2 for each handle."""
        edges = np.concatenate([self.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        count = len(np.unique(np.sort(edges, axis=1), axis=0))
        return len(self.vertices) - count + len(self.triangles)

    def write_stl(self, path: str | PathLike[str]) -> None:
        """Write a binary STL, whole or not at all, in float32."""
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
        corners = self.vertices[self.triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        rows = np.zeros(len(corners), dtype=record)
        rows["normal"] = normal / np.where(length > 0.0, length, 1.0)
        rows["corners"] = corners
        header = b"kleinform, metres".ljust(80)
        write_bytes(path, header + np.uint32(len(rows)).astype("<u4").tobytes() + rows.tobytes())

    def write_ply(self, path: str | PathLike[str]) -> None:
        """Write a binary PLY, whole or not at all, in float64."""
        lines = [
            "ply",
            "format binary_little_endian 1.0",
            "comment kleinform, metres",
            f"element vertex {len(self.vertices)}",
            *(f"property double {axis}" for axis in "xyz"),
            f"element face {len(self.triangles)}",
            "property list uchar int vertex_indices",
            "end_header\n",
        ]
        faces = np.zeros(len(self.triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
        faces["count"], faces["corners"] = 3, self.triangles
        header = "\n".join(lines).encode("ascii")
        write_bytes(path, header + self.vertices.astype("<f8").tobytes() + faces.tobytes())


def mesh_of(constraints: list[Constraint], low: Array, high: Array, cells: int) -> Mesh:
    """The mesh over a grid of a box (3,), (3,) with ``cells`` cells along its longest side."""
    cell = float((high - low).max()) / cells
    if (high <= low).any():
        return Mesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.intp))
    counts = np.ceil((high - low) / cell).astype(int) + 2
    start = low - MARGIN * cell
    axes = [start[k] + cell * np.arange(counts[k] + 1) for k in range(3)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    kept = inside(constraints, nodes)
    ends, corners = marched(kept, tetrahedra_of(kept, counts + 1))
    keys, triangles = np.unique(ends[:, 0] * len(nodes) + ends[:, 1], return_inverse=True)
    vertices = _halved(constraints, nodes[keys // len(nodes)], nodes[keys % len(nodes)])
    return Mesh(vertices, triangles[corners].astype(np.intp))


def tetrahedra_of(kept: Mask, shape: Index) -> Index:
    """The tetrahedra (M, 4) of the cells that have nodes inside and outside.

    Kuhn's six around the diagonal of each cell, all with a positive volume; those of
    neighbouring cells share their faces.
    """
    steps = np.array([shape[1] * shape[2], shape[2], 1])
    number = np.arange(len(kept)).reshape(shape)[:-1, :-1, :-1].ravel()
    cube = np.array([np.dot(corner, steps) for corner in product((0, 1), repeat=3)])
    count = kept[number[:, np.newaxis] + cube].sum(axis=1)
    number = number[(count > 0) & (count < 8)]
    found = []
    for order in permutations(range(3)):
        path = np.cumsum([0, *steps[list(order)]])
        if np.linalg.det(np.eye(3)[list(order)]) < 0.0:
            path[[2, 3]] = path[[3, 2]]
        found.append(number[:, np.newaxis] + path)
    return np.concatenate(found)


def marched(kept: Mask, tetrahedra: Index) -> tuple[Index, Index]:
    """Edges (inside node, outside node) of corners of triangles, and the triangles of these.

    In a tetrahedron (a, b, c, d) with a positive volume that has a inside, the corners on
    ab, ac, ad are counter-clockwise seen from outside; with a, b inside, those on ac, ad, bd, bc.
    """
    code = kept[tetrahedra] @ np.array([1, 2, 4, 8])
    triangles = []
    for order in _even():
        a, b, c, d = (tetrahedra[:, corner] for corner in order)
        one = 1 << order[0]
        two = one | 1 << order[1]
        if order in _FIRST:
            triangles.append(_edges(code == one, (a, b), (a, c), (a, d)))
            triangles.append(_edges(code == 15 - one, (b, a), (d, a), (c, a)))
        if order[0] < order[1]:
            triangles.append(_edges(code == two, (a, c), (a, d), (b, d)))
            triangles.append(_edges(code == two, (a, c), (b, d), (b, c)))
    edges = np.concatenate(triangles)
    return edges.reshape(-1, 2), np.arange(3 * len(edges)).reshape(-1, 3)


def _even() -> list[tuple[int, ...]]:
    """The even permutations of four."""
    return [p for p in permutations(range(4)) if np.linalg.det(np.eye(4)[list(p)]) > 0.0]


#: One even permutation for each first entry.
_FIRST = [next(p for p in _even() if p[0] == first) for first in range(4)]


def _edges(rows: Mask, *corners: tuple[Index, Index]) -> Index:
    """Triangles (M, 3, 2) of the rows, by the edge of each corner."""
    return np.stack([np.stack([a[rows], b[rows]], axis=1) for a, b in corners], axis=1)


def _halved(constraints: list[Constraint], kept: Array, lost: Array) -> Array:
    """Where the boundary is between positions inside and outside, (N, 3) each."""
    low, high = np.zeros((len(kept), 1)), np.ones((len(kept), 1))
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        within = inside(constraints, kept + middle * (lost - kept))[:, np.newaxis]
        low, high = np.where(within, middle, low), np.where(within, high, middle)
    return kept + low * (lost - kept)
