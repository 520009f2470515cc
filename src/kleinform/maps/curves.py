"""Ellipses and lines of a horizontal plane, and where they meet conics."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.zones import roots_of

__all__ = ["Curve", "curves_of", "meetings"]

Array = NDArray[np.float64]

#: Quadratic parts that are smaller, relative to the largest entry of a conic, are none.
STRAIGHT = 1e-13
#: So near to the unit circle a root counts as real: a double root is known to half the digits.
REAL = 1e-6


@dataclass(frozen=True, eq=False)
class Curve:
    """``center + first cos t + second sin t``, or the line ``center + first t``.

    Attributes
    ----------
    center, first, second : array (2,)
    closed : bool
        Whether it is an ellipse.
    """

    center: Array
    first: Array
    second: Array
    closed: bool

    def points(self, t: Array) -> Array:
        """Points (N, 2) at parameters (N,)."""
        first, second = (np.cos(t), np.sin(t)) if self.closed else (t, 0.0 * t)
        found: Array = (
            self.center
            + np.multiply.outer(first, self.first)
            + np.multiply.outer(second, self.second)
        )
        return found

    def tangent(self, t: float) -> Array:
        """The derivative of the point (2,)."""
        if not self.closed:
            return self.first
        turned: Array = -self.first * np.sin(t) + self.second * np.cos(t)
        return turned

    def swept(self, start: float, end: float) -> float:
        """∫ (x dy − y dx) / 2 from start to end."""
        ends = self.points(np.array([start, end]))
        total = _cross(self.center, ends[1] - ends[0])
        if self.closed:
            total += _cross(self.first, self.second) * (end - start)
        return total / 2.0


def curves_of(conic: Array) -> list[Curve]:
    """The real curves of a conic (3, 3): an ellipse, a line, two parallel lines, or none."""
    quadratic, linear, constant = conic[:2, :2], conic[:2, 2], conic[2, 2]
    size = abs(conic).max()
    if abs(quadratic).max() <= STRAIGHT * size:
        norm = float(np.hypot(*linear))
        if norm <= STRAIGHT * size:
            return []
        return [_line(linear / norm, -constant / (2.0 * norm))]
    values, vectors = np.linalg.eigh(quadratic)
    order = np.argsort(-abs(values))
    values, vectors = values[order], vectors[:, order]
    if abs(values[1]) <= STRAIGHT * abs(values[0]):
        normal = vectors[:, 0]
        middle = -float(linear @ normal) / values[0]
        square = middle * middle - constant / values[0]
        if square <= 0.0:
            return []
        return [_line(normal, middle + side * np.sqrt(square)) for side in (-1.0, 1.0)]
    center: Array = -np.linalg.solve(quadratic, linear).astype(np.float64)
    squares = -(constant + linear @ center) / values
    if squares.min() <= 0.0:
        return []
    axes: Array = vectors * np.sqrt(squares)
    return [Curve(center, axes[:, 0], axes[:, 1], True)]


def meetings(curve: Curve, conic: Array, reach: float) -> list[float]:
    """Parameters at which a curve meets a conic; a line up to ±reach.

    Where they all but touch there is one too, which does no harm: arcs are cut there.
    """
    rows = np.array([[*curve.center, 1.0], [*curve.first, 0.0], [*curve.second, 0.0]])
    g = rows @ conic @ rows.T
    if not curve.closed:
        square = g[0, 1] ** 2 - g[0, 0] * g[1, 1]
        q = -(g[0, 1] + np.copysign(np.sqrt(max(square, 0.0)), g[0, 1]))
        roots = [q / g[1, 1]] if g[1, 1] else []
        roots += [g[0, 0] / q] if q else []
        return [float(t) for t in roots if abs(t) < reach]
    coefficients = np.array(
        [
            g[0, 0] + (g[1, 1] + g[2, 2]) / 2.0,
            2.0 * g[0, 1],
            2.0 * g[0, 2],
            (g[1, 1] - g[2, 2]) / 2.0,
            g[1, 2],
        ]
    )
    size = abs(coefficients).max()
    degree = 2 if abs(coefficients[3:]).max() > STRAIGHT * size else 1
    if degree == 1 and abs(coefficients[1:3]).max() <= STRAIGHT * size:
        return []
    with np.errstate(all="ignore"):
        zeta = roots_of(coefficients[np.newaxis], degree).zeta[0]
    near = abs(abs(zeta) - 1.0) < REAL
    return [float(t) for t in np.angle(zeta[near]) % (2.0 * pi)]


def _line(normal: Array, distance: float) -> Curve:
    along = np.array([-normal[1], normal[0]])
    return Curve(distance * normal, along, np.zeros(2), False)


def _cross(first: Array, second: Array) -> float:
    return float(first[0] * second[1] - first[1] * second[0])
