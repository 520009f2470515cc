"""The surfaces that bound the workspace, and every other form as a function on them.

On a patch with parameters (u, v) a form is ``c0 + c1 cos u + s1 sin u + c2 cos 2u + s2 sin 2u``,
its coefficients polynomials in v, trigonometric ones on a sphere. They are computed in ball
arithmetic, from the inputs as they are, and rounded once.

The divergence of (0, 0, z) is 1: the volume is what it carries through the boundary. Vertical
planes and the base plane carry nothing. Per du dv the others carry

    cylinder   σ (q²/2 + β q v sin u − q²/2 cos 2u)
    sphere     σ ρ³ sin² v cos v
    cone       −σ cot² v²

with σ = 1 where the workspace is inside. `Surface.flux` has the factors, in this order.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from math import cosh, pi

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.maps.quadrics import Constraint, Form, Slab, Surface, Values

__all__ = ["Patch", "extent", "patches_of"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]

#: Bits.
PRECISION = 128
#: Covers some 450 roundings relative to the size of the terms: those of coefficients, of a
#: value, and of cosines and sines that are off by up to a hundred units in the last place.
ROUNDING = 1e-13
#: Ranges are wider by this part: they are computed in float64.
WIDER = 1e-9
#: Three normals of slabs span the space when their determinant is larger.
INDEPENDENT = 1e-5

#: Products of (1, cos, sin) in terms of (1, cos, sin, cos 2, sin 2), and of (1, v).
TRIGONOMETRIC = np.zeros((5, 3, 3))
TRIGONOMETRIC[0, 0, 0] = 1.0
TRIGONOMETRIC[1, 0, 1] = TRIGONOMETRIC[1, 1, 0] = 1.0
TRIGONOMETRIC[2, 0, 2] = TRIGONOMETRIC[2, 2, 0] = 1.0
TRIGONOMETRIC[0, 1, 1] = TRIGONOMETRIC[0, 2, 2] = 0.5
TRIGONOMETRIC[3, 1, 1], TRIGONOMETRIC[3, 2, 2] = 0.5, -0.5
TRIGONOMETRIC[4, 1, 2] = TRIGONOMETRIC[4, 2, 1] = 0.5
POLYNOMIAL = np.zeros((3, 2, 2))
POLYNOMIAL[0, 0, 0] = POLYNOMIAL[1, 0, 1] = POLYNOMIAL[1, 1, 0] = POLYNOMIAL[2, 1, 1] = 1.0


@dataclass(frozen=True, eq=False)
class Patch:
    """A surface, a range of v, and what must hold at a point of it to be on the boundary.

    Attributes
    ----------
    kind : "cylinder", "sphere" or "cone"
    low, high : float
        Range of v; u turns once.
    flux : array (3,)
    table : array (J, 5, 3 or 5)
        Coefficients of the J other forms, (1, cos u, ...) by (1, v, v²) or (1, cos v, ...).
    degree : int array (J,)
        1 where there is nothing in 2u, else 2.
    starts : int array (clauses,)
        Where in J the forms of a clause begin; one of them must not be negative.
    slack : array (J,)
        Largest rounding of a value of the form.
    """

    kind: str
    low: float
    high: float
    flux: Array
    table: Array
    degree: Index
    starts: Index
    slack: Array

    def coefficients(self, v: Array, forms: Index | slice = slice(None)) -> Array:
        """Coefficients (..., J, 5) at v (...), or (N, n, 5) of one form (N,) each at v (N, n)."""
        basis = self._basis(v)
        if isinstance(forms, slice):
            total: Array = np.einsum("jmk,...k->...jm", self.table[forms], basis)
        else:
            total = np.einsum("imk,ink->inm", self.table[forms], basis)
        return total

    def slopes(self, v: Array) -> Array:
        """Derivatives (N, J, 5) of the coefficients at v (N,)."""
        if self.kind == "sphere":
            turns = (-np.sin(v), np.cos(v), -2.0 * np.sin(2.0 * v), 2.0 * np.cos(2.0 * v))
            basis = np.stack([0.0 * v, *turns], axis=-1)
        else:
            basis = np.stack([0.0 * v, 1.0 + 0.0 * v, 2.0 * v], axis=-1)
        total: Array = np.einsum("jmk,nk->njm", self.table, basis)
        return total

    def bends(self, reach: Array) -> Array:
        """How much the sum of the coefficients' sizes (N, J) may differ from its tangent.

        Within the complex discs of radius reach (N,) around any v.
        """
        size = abs(self.table).sum(axis=1)
        r = reach[:, np.newaxis]
        if self.kind == "sphere":
            most = (size[:, 1] + size[:, 2]) * np.cosh(r)
            most = most + 4.0 * (size[:, 3] + size[:, 4]) * np.cosh(2.0 * r)
        else:
            most = 2.0 * size[:, 2]
        total: Array = most * r * r / 2.0 * (1.0 + 1e-12)
        return total

    def fluxes(self, v: Array) -> tuple[Array, Array, Array]:
        """``F = f0 + f1 sin u + f2 cos 2u`` at v."""
        if self.kind == "cylinder":
            return self.flux[0] + 0.0 * v, self.flux[1] * v, -self.flux[0] + 0.0 * v
        factor = np.sin(v) ** 2 * np.cos(v) if self.kind == "sphere" else v * v
        return self.flux[0] * factor, 0.0 * v, 0.0 * v

    def largest_flux(self, v: Array, reach: Array) -> Array:
        """At least |F| for complex v in a disc, and complex u within 1/2 of the real line."""
        far = abs(v) + reach
        if self.kind == "cylinder":
            largest: Array = 2.0 * abs(self.flux[0]) + abs(self.flux[1]) * far
        else:
            largest = abs(self.flux[0]) * (np.cosh(reach) ** 3 if self.kind == "sphere" else far**2)
        return largest * cosh(1.0)

    def flux_bend(self) -> float:
        """At least |∂²F/∂v²| on the real patch."""
        factor = {"cylinder": 0.0, "sphere": 2.5, "cone": 2.0}[self.kind]
        return float(factor * abs(self.flux[0]))

    def _basis(self, v: Array) -> Array:
        if self.kind == "sphere":
            turns = (np.cos(v), np.sin(v), np.cos(2.0 * v), np.sin(2.0 * v))
            return np.stack([np.ones_like(v), *turns], axis=-1)
        return np.stack([np.ones_like(v), v, v * v], axis=-1)


def patches_of(constraints: list[Constraint], slabs: list[Slab]) -> list[Patch]:
    """The patches of constraints in ball arithmetic; call it at `PRECISION`.

    Raises
    ------
    InputError
        The slabs do not bound the workspace.
    """
    patches = []
    for index, own in enumerate(constraints):
        for form in own.forms:
            if form.surface is None:
                continue
            clauses = [
                list(other.forms) for other in constraints[:index] + constraints[index + 1 :]
            ]
            clauses += [[Form(-other.matrix)] for other in own.forms if other is not form]
            patches.append(_patch(form.surface, clauses or [[_always(form)]], slabs))
    return patches


def extent(slabs: list[Slab], direction: Array) -> tuple[float, float]:
    """A range that holds ``direction·c`` for all positions in the slabs.

    Raises
    ------
    InputError
        No three of them have independent normals.
    """
    low, high = -np.inf, np.inf
    for triple in combinations(slabs, 3):
        normals = np.array([slab.normal for slab in triple], dtype=np.float64)
        size = np.linalg.norm(normals, axis=1)
        if abs(np.linalg.det(normals / size[:, np.newaxis])) <= INDEPENDENT:
            continue
        share = np.linalg.solve(normals.T, direction)
        middle = -sum(s * float(slab.offset) for s, slab in zip(share, triple, strict=True))
        reach = sum(abs(s) * float(slab.reach) for s, slab in zip(share, triple, strict=True))
        far = WIDER * (abs(middle) + reach)
        low, high = max(low, middle - reach - far), min(high, middle + reach + far)
    if high == np.inf:
        raise InputError("limits: the workspace is unbounded: give more of q1, q2, q3, q6 high")
    return float(low), float(high)


def _always(form: Form) -> Form:
    """1, in the numbers of a form."""
    matrix = form.matrix * 0
    matrix[3, 3] = matrix[3, 3] + 1
    return Form(matrix)


def _patch(surface: Surface, clauses: list[list[Form]], slabs: list[Slab]) -> Patch:
    low, high = _range(surface, slabs)
    tables, slacks, doubled = [], [], []
    for form in (form for clause in clauses for form in clause):
        table, radius = _rounded(_pulled_back(form.matrix, surface))
        reach = 1.0 if surface.kind == "sphere" else max(1.0, abs(low), abs(high))
        power = reach ** np.arange(table.shape[1]) if surface.kind != "sphere" else 1.0
        size = abs(table) * power
        rounding = ROUNDING * size.sum()
        # What is at the level of rounding is left out, and counts as rounding.
        doubled.append(bool(size[3:].sum() > rounding))
        if not doubled[-1]:
            rounding += size[3:].sum()
            table[3:] = 0.0
        tables.append(table)
        slacks.append(float(rounding + (radius * power).sum()))
    table, slack, double = np.stack(tables), np.array(slacks), np.array(doubled)
    starts = np.cumsum([0, *map(len, clauses)])[:-1]
    flux, _ = _rounded(surface.flux)
    return Patch(surface.kind, low, high, flux, table, np.where(double, 2, 1), starts, 2.0 * slack)


def _range(surface: Surface, slabs: list[Slab]) -> tuple[float, float]:
    """What v may be."""
    if surface.kind == "cylinder":
        start, _ = _rounded(surface.points[0, 0, :3])
        level = np.array([start[0], start[1], 0.0]) / np.hypot(start[0], start[1])
        low, high = extent(slabs, level)
        radius = float(np.hypot(start[0], start[1]))
        return low - radius, high - radius
    low, high = extent(slabs, np.array([0.0, 0.0, 1.0]))
    if surface.kind == "cone":
        return low, high
    rho, _ = _rounded(surface.points[1, 1, :1])
    bottom, top = np.clip(np.array([low, high]) / rho[0], -1.0, 1.0)
    far = 1e-7 if bottom <= top else 0.0
    return max(float(np.arcsin(bottom)) - far, -pi / 2.0), min(
        float(np.arcsin(top)) + far, pi / 2.0
    )


def _pulled_back(matrix: Values, surface: Surface) -> Values:
    """The form on the surface (5, 3 or 5), in balls."""
    count = surface.points.shape[1]
    rows = surface.points.reshape(3 * count, 4)
    products = rows.dot(matrix).dot(rows.T).reshape(3, count, 3, count)
    outer = TRIGONOMETRIC if count == 3 else POLYNOMIAL
    products = products.transpose(0, 2, 1, 3).reshape(9, count * count)
    inner = TRIGONOMETRIC.reshape(5, 9).astype(object).dot(products)
    found: Values = inner.dot(outer.reshape(len(outer), -1).T.astype(object))
    return found


def _rounded(balls: Values) -> tuple[Array, Array]:
    """Midpoints in float64, and how far the true values may be from them but for rounding."""
    flat = balls.ravel().tolist()
    middle = np.array([float(ball.mid()) for ball in flat]).reshape(balls.shape)
    radius = np.array([float(ball.rad()) for ball in flat]).reshape(balls.shape)
    return middle, radius
