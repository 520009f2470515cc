"""What a patch carries over panels of v, with a bound of the error.

A panel is ``|v - v_c| <= h``. The zones of `kleinform.maps.zones` cut the circle of u into arcs;
on each arc outside of the zones every form has one sign for the whole panel, so that the arc is
proven to be on the boundary or not. Where every zone that matters holds one root U(v), proven
to be analytic for ``|v - v_c| <= SPREAD h``, the arcs end at these roots, and what they carry is
integrated by Gauss's rule: by Cauchy's inequality the error is at most
``4 h M SPREAD^(-2n) / (1 - 1/SPREAD)`` if the integrand is within M of a polynomial that the
rule integrates exactly. Elsewhere the zones that matter count as an error.
"""

from __future__ import annotations

from math import pi
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.patches import Patch
from kleinform.maps.zones import Roots, roots_of, values

__all__ = ["examine"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Mask = NDArray[np.bool_]
Signs = NDArray[np.int8]

#: Analytic in a disc that is larger than the panel by this factor.
SPREAD = 2.5
#: Gauss's rule.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(14)
RULE = 4.0 * SPREAD ** (-2.0 * len(NODES)) / (1.0 - 1.0 / SPREAD)
#: Where u begins to turn: an angle that no symmetry prefers.
SEAM = -2.0345
#: Wider zones are all of the circle; only narrower ones count as one root.
WIDEST = 0.5
NARROW = 0.2
#: Relative rounding of what is carried, weights of Gauss's rule among it.
ROUNDING = 1e-13
NEWTON = 5
#: At least 2 π times the roundings of the ends of a panel, relative to 1 + |v|.
ROUNDED_ENDS = 5e-15


class Zones(NamedTuple):
    """Zones of the forms whose sign is not the same all around the circle.

    Attributes
    ----------
    forms : int array (N, A)
        Those forms.
    slot : int array (N, Z)
        Which of them a zone is of.
    center, width : array (N, Z)
        A zone is ``|u - center| < width``, NaN where there is none; SEAM <= center.
    disc : array (N, Z)
        The radius around the root in which the complex one stays, NaN where it may not be one.
    """

    forms: Index
    slot: Index
    center: Array
    width: Array
    disc: Array


class Column(NamedTuple):
    """Panels, and what is known about the forms on them.

    Attributes
    ----------
    v, h : array (N,)
    at_center, slopes : array (N, J, 5)
        Coefficients of the forms at v, and their derivatives.
    signs : int8 array (N, J)
        Of forms that have one sign for all u and v, else 0.
    """

    v: Array
    h: Array
    at_center: Array
    slopes: Array
    signs: Signs

    def only(self, rows: Mask) -> Column:
        """Some of the panels."""
        parts: list[Any] = [part[rows] for part in self]
        return Column(*parts)


def examine(patch: Patch, low: Array, high: Array) -> tuple[Array, Array]:
    """What panels (N,) of a patch carry, and a bound of the error of each."""
    v, h = (low + high) / 2.0, (high - low) / 2.0
    at_center = patch.coefficients(v)
    slopes = patch.slopes(v)
    near = _amplitude(slopes, 0) * h[:, np.newaxis] + patch.bends(h) + patch.slack
    least = abs(at_center[..., 0]) - _amplitude(at_center, 1) - near
    signs = np.where(least > 0.0, np.sign(at_center[..., 0]), 0.0).astype(np.int8)
    carried, error = np.zeros(len(v)), np.zeros(len(v))
    rows = _together(patch, signs[:, :, np.newaxis])[:, 0] >= 0
    if rows.any():
        column = Column(v, h, at_center, slopes, signs).only(rows)
        carried[rows], error[rows] = _columns(patch, column)
        # The middle and the half width are rounded: panels may be that far apart.
        error += ROUNDED_ENDS * (1.0 + abs(v)) * patch.largest_flux(v, h)
    return carried, error


def _amplitude(coefficients: Array, lowest: int) -> Array:
    """At least the sum of the terms in u of order ``lowest`` and more, for all u."""
    _, c1, s1, c2, s2 = np.moveaxis(coefficients, -1, 0)
    total: Array = np.hypot(c1, s1) + np.hypot(c2, s2) + (abs(coefficients[..., 0]) * (lowest == 0))
    return total * (1.0 + 1e-12)


def _columns(patch: Patch, column: Column) -> tuple[Array, Array]:
    """Panels that may carry something."""
    zones = _zones(patch, column)
    edges, status = _arcs(patch, column, zones)
    carried, error = _crude(patch, column, edges, status)
    sharp, bound = _sharp(patch, column, zones, edges, status)
    return np.where(bound < error, sharp, carried), np.minimum(bound, error)


def _zones(patch: Patch, column: Column) -> Zones:
    open_forms = column.signs == 0
    most = max(1, int(open_forms.sum(axis=1).max()))
    forms = np.argsort(~open_forms, axis=1, kind="stable")[:, :most]
    center, width, disc = (np.full((*forms.shape, 4), np.nan) for _ in range(3))
    for degree in (1, 2):
        place = np.nonzero(
            np.take_along_axis(open_forms, forms, axis=1) & (patch.degree[forms] == degree)
        )
        row, form = place[0], forms[place]
        if not len(row):
            continue
        roots = roots_of(column.at_center[row, form], degree)
        narrow, wide = _widths(patch, column, row, form, roots)
        size = abs(roots.zeta)
        with np.errstate(invalid="ignore"):
            turn = np.arcsin(narrow / size) * (1.0 + 1e-9) + 1e-13
        turn = np.where(narrow <= WIDEST, turn, pi)
        met = ~(abs(size - 1.0) > narrow)  # so if a root is no number, too
        count = 2 * degree
        row, slot = place
        center[row, slot, :count] = np.where(met, np.nan_to_num(np.angle(roots.zeta)), np.nan)
        width[row, slot, :count] = np.where(met, turn, np.nan)
        alone = (wide <= roots.nearest) & (wide <= NARROW) & (abs(size - 1.0) <= wide / 20.0)
        disc[row, slot, :count] = np.where(met & alone, wide - abs(size - 1.0), np.nan)
    return _compact(forms, center, width, disc)


def _widths(
    patch: Patch, column: Column, row: Index, form: Index, roots: Roots
) -> tuple[Array, Array]:
    """Radii (M, n) around roots: of zones for real v, and of discs for complex v.

    At a distance x from a root ζ the derivative by v differs from that at the angle of ζ by no
    more than π x times its Lipschitz constant. On a disc of radius w < NARROW around ζ, itself
    within w / 20 of the unit circle, |log z − log ζ| < 1.4 w, |Im u| < 1/4, |z|² < 1.5, and the
    size of a form and of its derivatives is at most √2 cosh(1/2) times that for real u.
    """
    h, slopes = column.h[row, np.newaxis], column.slopes[row, form]
    rate = abs(values(slopes[:, np.newaxis], np.angle(roots.zeta))) * h
    known = (patch.slack[form] + roots.defect)[:, np.newaxis]
    steep = _amplitude(_slopes(slopes), 1)[:, np.newaxis] * h
    bend, far = (
        np.take_along_axis(patch.bends(reach)[row], form[:, np.newaxis], axis=1)
        for reach in (column.h, SPREAD * column.h)
    )
    narrow = roots.widths(rate + bend + known, pi * steep[:, 0])
    left = roots.tails[..., 0] - 3.5 * SPREAD * steep
    wide = (1.5 * SPREAD * rate + 1.7 * far + 2.2 * known) / left
    wide = np.where(left > 0.0, 1.01 * np.maximum(wide, narrow) + 1e-12, np.inf)
    return narrow, wide


def _compact(forms: Index, *parts: Array) -> Zones:
    """The zones (N, A, 4) side by side, those of each panel first."""
    center, width, disc = (part.reshape(len(forms), -1) for part in parts)
    center = SEAM + (center - SEAM) % (2.0 * pi)
    most = max(1, int(np.isfinite(center).sum(axis=1).max()))
    first = np.argsort(np.isnan(center), axis=1, kind="stable")[:, :most]
    center, width, disc = (np.take_along_axis(p, first, axis=1) for p in (center, width, disc))
    return Zones(forms, first // 4, center, width, disc)


def _arcs(patch: Patch, column: Column, zones: Zones) -> tuple[Array, Signs]:
    """Ends of arcs (N, E + 1) from SEAM around, and their status (N, E).

    1 is on the boundary for the whole panel, -1 is not, 0 is unknown.
    """
    count = len(column.v)
    ends = np.concatenate([zones.center - zones.width, zones.center + zones.width], axis=1)
    ends = SEAM + (ends - SEAM) % (2.0 * pi)
    ends = np.where(np.isnan(ends), SEAM, ends)
    whole = np.full((count, 1), SEAM)
    edges = np.sort(np.concatenate([whole, ends, whole + 2.0 * pi], axis=1), axis=1)
    middle = (edges[:, 1:] + edges[:, :-1]) / 2.0
    status = np.repeat(column.signs[:, :, np.newaxis], middle.shape[1], axis=2)
    coefficients = np.take_along_axis(column.at_center, zones.forms[..., np.newaxis], axis=1)
    value = values(coefficients[:, :, np.newaxis], middle[:, np.newaxis])
    sign = np.sign(value).astype(np.int8)
    inside = _inside(zones, middle)
    for slot in range(sign.shape[1]):
        sign[:, slot][(inside & (zones.slot == slot)[..., np.newaxis]).any(axis=1)] = 0
    known = np.take_along_axis(status, zones.forms[..., np.newaxis], axis=1)
    sign = np.where(known != 0, known, sign)
    np.put_along_axis(status, zones.forms[..., np.newaxis], sign, axis=1)
    return edges, _together(patch, status)


def _inside(zones: Zones, u: Array) -> Mask:
    """Which zones (N, Z) points u (N, E), SEAM <= u, are in: (N, Z, E)."""
    away = abs(u[:, np.newaxis] - zones.center[..., np.newaxis])
    found: Mask = np.minimum(away, 2.0 * pi - away) < zones.width[..., np.newaxis]
    return found


def _together(patch: Patch, status: Signs) -> Signs:
    """All clauses (N, E) from all forms (N, J, E)."""
    if not status.shape[1]:
        return np.ones((status.shape[0], status.shape[2]), dtype=np.int8)
    clauses = np.maximum.reduceat(status, patch.starts, axis=1)
    found: Signs = clauses.min(axis=1)
    return found


def _potential(flux: tuple[Array, Array, Array], u: Array) -> Array:
    """∫ F du."""
    f0, f1, f2 = flux
    total: Array = f0 * u - f1 * np.cos(u) + f2 * np.sin(2.0 * u) / 2.0
    return total


def _crude(patch: Patch, column: Column, edges: Array, status: Signs) -> tuple[Array, Array]:
    """By the rule of the midpoint over the arcs that are proven; the others may be anything."""
    flux = patch.fluxes(column.v[:, np.newaxis])
    arcs = np.diff(_potential(flux, edges), axis=1)
    carried = np.where(status > 0, arcs, np.where(status == 0, arcs / 2.0, 0.0)).sum(axis=1)
    unknown = np.where(status == 0, np.diff(edges, axis=1), 0.0).sum(axis=1)
    largest = patch.largest_flux(column.v, column.h)
    error = largest * (unknown + 1e-12) + pi * patch.flux_bend() * column.h**2
    return 2.0 * column.h * carried, 2.0 * column.h * error


def _sharp(
    patch: Patch, column: Column, zones: Zones, edges: Array, status: Signs
) -> tuple[Array, Array]:
    """By Gauss's rule, for panels whose arcs end at proven roots; else the error is infinite."""
    arcs = Arcs.of(edges, status)
    row, arc = np.nonzero(status == 0)
    empty = np.diff(edges, axis=1)[row, arc] == 0.0
    row, arc = row[~empty], arc[~empty]
    middle = (edges[row, arc] + edges[row, arc + 1]) / 2.0
    members = _inside(Zones(*(part[row] for part in zones)), middle[:, np.newaxis])[..., 0]
    at = (row, members.argmax(axis=1))
    length = edges[row, arc + 1] - edges[row, arc]
    before, after = arcs.before[row, arc], arcs.after[row, arc]
    good = (members.sum(axis=1) == 1) & (before * after == -1)
    good &= abs(length - 2.0 * zones.width[at]) <= 1e-3 * length
    good &= np.isfinite(zones.disc[at])
    root = zones.center[at]
    form = zones.forms[row, zones.slot[at]]
    h = column.h[row]
    nodes = column.v[row, np.newaxis] + h[:, np.newaxis] * NODES
    u, off = _followed(patch, form, nodes, root)
    good &= (abs(u - root[:, np.newaxis]) + off < zones.disc[at][:, np.newaxis]).all(axis=1)
    largest = patch.largest_flux(column.v, SPREAD * column.h)
    part = -after * h * (_potential(patch.fluxes(nodes), u) @ WEIGHTS)
    reach = 2.0 * zones.disc[at] + (2.0 * pi + 1.0 if patch.kind == "sphere" else 0.0)
    bound = largest[row] * h * (RULE * reach + 2.0 * off.max(axis=1) + ROUNDING * 20.0)
    part, bound = np.where(good, part, 0.0), np.where(good, bound, np.inf)
    count = len(column.v)
    turned, error = _turned(patch, column, arcs.seam)
    return turned + np.bincount(row, part, count), error + np.bincount(row, bound, count)


class Arcs(NamedTuple):
    """Status (N, E) of the arcs before and after each, around the circle; empty ones skipped.

    Attributes
    ----------
    seam : int8 array (N,)
        Status at SEAM.
    """

    before: Signs
    after: Signs
    seam: Signs

    @classmethod
    def of(cls, edges: Array, status: Signs) -> Arcs:
        """From the ends of arcs."""
        full = np.diff(edges, axis=1) > 0.0
        count = full.shape[1]
        twice = np.concatenate([full, full], axis=1)
        place = np.where(twice, np.arange(2 * count), -1)
        last = np.maximum.accumulate(place, axis=1)[:, count - 1 : -1] % count
        place = np.where(twice, np.arange(2 * count), 2 * count)
        following = np.minimum.accumulate(place[:, ::-1], axis=1)[:, ::-1]
        following = following[:, 1 : count + 1] % count
        before = np.take_along_axis(status, last, axis=1)
        after = np.take_along_axis(status, following, axis=1)
        first = np.take_along_axis(status, following[:, -1:], axis=1)[:, 0]
        return cls(before, after, first)


def _followed(patch: Patch, form: Index, nodes: Array, root: Array) -> tuple[Array, Array]:
    """The roots (N, n) of a form each at nodes v (N, n), and how far they may be off."""
    coefficients = patch.coefficients(nodes, form)
    slope = _slopes(coefficients)
    u = np.repeat(root[:, np.newaxis], nodes.shape[1], axis=1)
    for _ in range(NEWTON):
        u = u - values(coefficients, u) / values(slope, u)
    slack = patch.slack[form][:, np.newaxis]
    off = 4.0 * slack / abs(values(slope, u)) + 4e-16 * (1.0 + abs(u))
    left, right = values(coefficients, u - off), values(coefficients, u + off)
    proven = (left * right < 0.0) & (abs(left) > slack) & (abs(right) > slack)
    return u, np.where(proven, off, np.inf)


def _slopes(coefficients: Array) -> Array:
    """∂g/∂u."""
    _, c1, s1, c2, s2 = np.moveaxis(coefficients, -1, 0)
    return np.stack([0.0 * c1, s1, -c1, 2.0 * s2, -2.0 * c2], axis=-1)


def _turned(patch: Patch, column: Column, seam: Signs) -> tuple[Array, Array]:
    """Full turns of u, for the panels that have SEAM on the boundary."""
    nodes = column.v[:, np.newaxis] + column.h[:, np.newaxis] * NODES
    carried = 2.0 * pi * column.h * (patch.fluxes(nodes)[0] @ WEIGHTS)
    largest = patch.largest_flux(column.v, SPREAD * column.h)
    around = RULE if patch.kind == "sphere" else 0.0
    error = 2.0 * pi * column.h * largest * (around + ROUNDING)
    held = seam > 0
    return np.where(held, carried, 0.0), np.where(seam == 0, np.inf, np.where(held, error, 0.0))
