"""The limits of joints and extensions as quadrics in the position, for one orientation.

A form is a symmetric G of a quadric, ``g(c) = (c, 1)ᵀ G (c, 1)``, and g >= 0 where it holds. A
constraint holds where one of its forms does, a position is in the workspace where every
constraint holds. Two forms are needed for what is no intersection: the outside of one half
of a double cone, and a wedge wider than π.

Everything is written for numbers of any kind, float64 or balls of python-flint.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import inf, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.limits import Limits

__all__ = ["Constraint", "Form", "Slab", "Surface", "constraints_of", "slabs_of"]

#: Of float64, or of objects.
Values = NDArray[Any]
Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Surface:
    """Points ``Σ_a Σ_b points[a, b] f_a(u) h_b(v)`` of a quadric, homogeneous.

    f is (1, cos u, sin u); h is (1, v), or (1, cos v, sin v) on a sphere.

    Attributes
    ----------
    kind : "cylinder", "sphere" or "cone"
    limb : int
        Index of the limb of a cylinder.
    points : array (3, 2 or 3, 4)
    flux : array (3,)
        What `kleinform.maps.patches` says.
    """

    kind: str
    limb: int
    points: Values
    flux: Values


@dataclass(frozen=True, eq=False)
class Form:
    """A quadric ``matrix`` (4, 4), and its surface unless that is a vertical or level plane."""

    matrix: Values
    surface: Surface | None = None


@dataclass(frozen=True, eq=False)
class Constraint:
    """One end of one range: it holds where one of the forms is not negative.

    Attributes
    ----------
    name : str
        As in `Limits`: "q1" ... "q6", "e1", "e2", "e3".
    end : "low" or "high"
    forms : tuple of Form
    """

    name: str
    end: str
    forms: tuple[Form, ...]


@dataclass(frozen=True, eq=False)
class Slab:
    """``|normal·c + offset| <= reach`` for all positions of the workspace."""

    normal: Values
    offset: Any
    reach: Any


@dataclass(frozen=True, eq=False)
class Limb:
    """What is affine in c: ``q² = y² + w²`` and ``e``; rows of coefficients of (c, 1)."""

    index: int
    y: Values
    w: Values
    e: Values
    axis: Values = field(repr=False)
    across: Values = field(repr=False)
    radius: Any
    lean: tuple[Any, Any]


def limbs_of(radius: float, rotation: Array, make: Callable[[float], Any]) -> list[Limb]:
    """The three limbs in numbers that ``make`` makes.

    b_i − a u_i is c − a u_i projected along n_i onto the plane normal to u_i. With
    ``s = c·u_i − a``, v_i = k × u_i and ``n_i/(n_i·u_i) = u_i + α v_i + β k`` it has the
    coordinates ``y = c·v_i − α s`` and ``w = c_z − β s``.
    """
    zero, one, a = make(0.0), make(1.0), make(radius)
    half, root = make(0.5), np.sqrt(make(3.0)) / make(2.0)
    first, second = ([make(float(x)) for x in rotation[:, k]] for k in (0, 1))
    limbs = []
    for index, (cos, sin) in enumerate(((one, zero), (-half, root), (-half, -root))):
        u = np.array([cos, sin, zero])
        v = np.array([-sin, cos, zero])
        n = np.array([cos * f + sin * g for f, g in zip(first, second, strict=True)])
        p = n[0] * u[0] + n[1] * u[1]
        alpha, beta = (n[0] * v[0] + n[1] * v[1]) / p, n[2] / p
        up = np.array([zero, zero, one])
        y = np.append(v - alpha * u, alpha * a)
        w = np.append(up - beta * u, beta * a)
        e = np.append(-u / p, a / p)
        limbs.append(Limb(index, y, w, e, u, v, a, (alpha, beta)))
    return limbs


def constraints_of(
    radius: float, rotation: Array, limits: Limits, make: Callable[[float], Any] = np.float64
) -> list[Constraint]:
    """Every finite end of every range.

    A range of q4 is one modulo 2π, and no limit where it is at least 2π long. An end of q5
    beyond ±π/2 is no limit, and one that leaves only the Z axis is a form that is negative off
    it.
    """
    limbs = limbs_of(radius, rotation, make)
    found: list[Constraint] = []
    for limb in limbs:
        found += _leg(limb, limits.range_of(f"q{limb.index + 1}"), make)
        found += _extension(limb, limits.range_of(f"e{limb.index + 1}"), make)
    found += _azimuth(limits.range_of("q4"), make)
    found += _elevation(limits.range_of("q5"), make)
    found += _length(limits.range_of("q6"), make)
    return found


def slabs_of(
    radius: float, rotation: Array, limits: Limits, make: Callable[[float], Any] = np.float64
) -> list[Slab]:
    """Slabs that hold the workspace, from the ends of ranges that bound it on two sides."""
    slabs = []
    for limb in limbs_of(radius, rotation, make):
        high = limits.range_of(f"q{limb.index + 1}")[1]
        if high < inf:
            slabs += [Slab(row[:3], row[3], high) for row in (limb.y, limb.w)]
        low, high = limits.range_of(f"e{limb.index + 1}")
        if -inf < low and high < inf:
            middle, half = (
                (make(high) + make(low)) / make(2.0),
                (make(high) - make(low)) / make(2.0),
            )
            slabs.append(Slab(limb.e[:3], limb.e[3] - middle, half))
    high = limits.range_of("q6")[1]
    if high < inf:
        slabs += [Slab(row, 0.0, high) for row in np.eye(3)]
    return slabs


def _leg(limb: Limb, ends: tuple[float, float], make: Callable[[float], Any]) -> list[Constraint]:
    squares = np.outer(limb.y, limb.y) + np.outer(limb.w, limb.w)
    found = []
    for end, q in _lengths(ends):
        sign = make(-1.0 if end == "low" else 1.0)
        length = make(q)
        matrix = -sign * squares
        matrix[3, 3] = matrix[3, 3] + sign * length * length
        surface = _cylinder(limb, length, sign, make) if q > 0.0 else None
        found.append(Constraint(f"q{limb.index + 1}", end, (Form(matrix, surface),)))
    return found


def _cylinder(limb: Limb, length: Any, sign: Any, make: Callable[[float], Any]) -> Surface:
    """v is s, u turns from v_i to the vertical."""
    zero, one = make(0.0), make(1.0)
    alpha, beta = limb.lean
    up = np.array([zero, zero, one])
    points = np.full((3, 2, 4), zero, dtype=limb.y.dtype)
    points[0, 0] = np.append(limb.radius * limb.axis, one)
    points[0, 1, :3] = limb.axis + alpha * limb.across + beta * up
    points[1, 0, :3] = length * limb.across
    points[2, 0, :3] = length * up
    flux = np.array([sign * length * length / make(2.0), sign * beta * length, zero])
    return Surface("cylinder", limb.index, points, flux)


def _extension(
    limb: Limb, ends: tuple[float, float], make: Callable[[float], Any]
) -> list[Constraint]:
    found = []
    for end, value in zip(("low", "high"), ends, strict=True):
        if abs(value) < inf:
            row = limb.e if end == "low" else -limb.e
            row = row + np.array([make(0.0)] * 3 + [make(-value if end == "low" else value)])
            found.append(Constraint(f"e{limb.index + 1}", end, (_plane(row, make),)))
    return found


def _length(ends: tuple[float, float], make: Callable[[float], Any]) -> list[Constraint]:
    zero, one = make(0.0), make(1.0)
    found = []
    for end, q in _lengths(ends):
        sign, length = make(-1.0 if end == "low" else 1.0), make(q)
        matrix = _diagonal([-sign, -sign, -sign, sign * length * length], make)
        points = np.full((3, 3, 4), zero, dtype=matrix.dtype)
        points[0, 0, 3] = one
        points[0, 2, 2] = points[1, 1, 0] = points[2, 1, 1] = length
        flux = np.array([sign * length * length * length, zero, zero])
        surface = Surface("sphere", -1, points, flux) if q > 0.0 else None
        found.append(Constraint("q6", end, (Form(matrix, surface),)))
    return found


def _lengths(ends: tuple[float, float]) -> list[tuple[str, float]]:
    """The ends that limit a length."""
    low, high = ends
    found = [("low", low)] if low > 0.0 else []
    return [*found, ("high", high)] if high < inf else found


def _elevation(ends: tuple[float, float], make: Callable[[float], Any]) -> list[Constraint]:
    """``q5 <= high`` is ``-q5 >= -high``: the same below the base."""
    low, high = ends
    found = []
    if low > -pi / 2.0:
        found += [Constraint("q5", "low", forms) for forms in _above(low, 1.0, make)]
    if high < pi / 2.0:
        found += [Constraint("q5", "high", forms) for forms in _above(-high, -1.0, make)]
    if 0.0 in ends:
        # The base bounds one side already: it need not stand beside the cone of the other.
        found = [replace(constraint, forms=constraint.forms[:1]) for constraint in found]
    return found


def _above(angle: float, side: float, make: Callable[[float], Any]) -> list[tuple[Form, ...]]:
    """The forms of ``side * q5 >= angle``."""
    zero, one = make(0.0), make(1.0)
    level = _plane(np.array([zero, zero, make(side), zero]), make)
    if angle == 0.0:
        return [(level,)]
    if angle >= pi / 2.0:
        return [(Form(_diagonal([zero, zero, zero, -one], make)),)]
    # Inside the half of the double cone on this side, or outside that on the other side.
    sign = make(1.0 if angle > 0.0 else -1.0)
    sin, cos = np.sin(make(angle)), np.cos(make(angle))
    matrix = _diagonal([-sign * sin * sin, -sign * sin * sin, sign * cos * cos, zero], make)
    points = np.full((3, 2, 4), zero, dtype=matrix.dtype)
    points[0, 0, 3] = points[0, 1, 2] = one
    points[1, 1, 0] = points[2, 1, 1] = cos / sin
    flux = np.array([-sign * cos * cos / (sin * sin), zero, zero])
    cone = Form(matrix, Surface("cone", -1, points, flux))
    return [(cone,), (level,)] if angle > 0.0 else [(cone, level)]


def _azimuth(ends: tuple[float, float], make: Callable[[float], Any]) -> list[Constraint]:
    low, high = ends
    if high - low >= 2.0 * pi:
        return []
    zero = make(0.0)
    planes = []
    for angle, sign in ((low, 1.0), (high, -1.0)):
        x, y = -np.sin(make(angle)), np.cos(make(angle))
        planes.append(_plane(np.array([make(sign) * x, make(sign) * y, zero, zero]), make))
    if high - low > pi:
        return [Constraint("q4", "low and high", tuple(planes))]
    return [
        Constraint("q4", end, (plane,)) for end, plane in zip(("low", "high"), planes, strict=True)
    ]


def _plane(row: Values, make: Callable[[float], Any]) -> Form:
    """``row·(c, 1)`` as a quadric."""
    matrix = np.full((4, 4), make(0.0), dtype=row.dtype)
    matrix[3, :] = row / make(2.0)
    matrix[:, 3] = row / make(2.0)
    matrix[3, 3] = row[3]
    return Form(matrix)


def _diagonal(entries: list[Any], make: Callable[[float], Any]) -> Values:
    values = np.array(entries)
    matrix = np.full((4, 4), make(0.0), dtype=values.dtype)
    np.fill_diagonal(matrix, values)
    return matrix
