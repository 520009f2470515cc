"""Balls that hold one solution each, in float64 with bounds on all its rounding.

F is a square system, x a point, and Y the inverse of F'(x). For any bounds in the norm of the
largest entry

    η ≥ |Y F(x)|,  α ≥ |1 − Y F'(x)|,  β ≥ |Y| sup |F''| / 2,

if α + 2βη < 1/2 then y − Y F(y) maps the ball of radius 2η around x into itself and
contracts it: η + 2αη + 4βη² < 2η and α + 4βη < 1. There is one solution in it, a simple one
(Krawczyk's theorem). A ball around a real point holds a real one, because with a solution its
conjugate is one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.cases import reach_of
from kleinform.forward.circle import Rows
from kleinform.forward.pencil import DEGREE
from kleinform.generated import kernels

__all__ = ["radii_of_angles", "radii_of_directions"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

EPS = float(np.finfo(np.float64).eps)
#: Terms of the two equations, in (1 + |t|)⁴ (1 + |s|)⁴ times the squares of the reaches: an
#: arm is at most reach (1 + |t|)², and a form of limb 3 at most twice its reach.
TERMS = np.array([5.0, 72.0])
#: Terms of a cone in |n|² times the square of its reach: three squares of at most 2, 2 and 1.
CONE_TERMS = 5.0
#: Roundings on the way to a value or a derivative, in eps.
ROUNDINGS = 16.0
#: Balls are no larger: so far the second derivatives are bounded.
MOST_RADIUS = 0.1


@np.errstate(all="ignore")
def radii_of_angles(tables: kernels.Circles, reaches: Array, half_tangents: Complex) -> Array:
    """Radii (N, P) of balls, as angles, that hold one solution each; inf where none is proven.

    Parameters
    ----------
    tables : kernels.Circles
        Of N sets of joint values.
    reaches : array (N, 3)
        a + |c| + q of the limbs, in the order of the tables.
    half_tangents : complex array (N, P, 2)
    """
    sizes = np.stack([reaches[:, :2].prod(axis=1), reaches.prod(axis=1)], axis=1) ** 2
    scaled = np.stack([tables.angle, tables.cone], axis=1) / sizes[..., np.newaxis, np.newaxis]
    # Beyond 1 the inverse of a tangent is the unknown: its powers come in reverse order.
    beyond = abs(half_tangents) > 1.0
    x = np.where(beyond, 1.0 / half_tangents, half_tangents)
    own = np.broadcast_to(scaled[:, np.newaxis], (*x.shape[:2], *scaled.shape[1:]))
    for axis in (-2, -1):
        flipped = beyond[..., 2 + axis, np.newaxis, np.newaxis, np.newaxis]
        own = np.where(flipped, np.flip(own, axis), own)
    values, jacobian, bend = _expanded(own, x)
    terms = TERMS * np.prod((1.0 + abs(x)) ** DEGREE, axis=-1)[..., np.newaxis]
    radius = _radii(values, jacobian, ROUNDINGS * EPS * terms, bend)
    # An angle is twice the half angle, which its tangent exceeds.
    return np.where(radius <= MOST_RADIUS, 2.0 * radius, np.inf)


@np.errstate(all="ignore")
def radii_of_directions(row: Rows, pairs: Complex) -> Array:
    """Radii (P,) of balls around (n_1, n_2), (P, 2, 3), of one set of joint values."""
    reach = reach_of(row)[0]
    cones = np.stack(kernels.cones(row.radius, row.position, row.lengths), axis=1)[0]
    cones = cones / reach[:, np.newaxis, np.newaxis] ** 2
    n = np.concatenate([pairs, -pairs.sum(axis=1, keepdims=True)], axis=1)
    slopes = 2.0 * np.einsum("ijk,pik->pij", cones, n)
    jacobian = np.zeros((len(pairs), 6, 2, 3), dtype=np.complex128)
    for own in range(2):
        jacobian[:, own, own] = slopes[:, own]
        jacobian[:, 2, own] = -slopes[:, 2]
        jacobian[:, 3 + own, own] = 2.0 * n[:, own]
        jacobian[:, 5, own] = n[:, 1 - own]
    products = np.einsum("pix,pjx->pij", pairs, pairs)
    unit = [products[:, 0, 0] - 1.0, products[:, 1, 1] - 1.0, products[:, 0, 1] + 0.5]
    values = np.concatenate(
        [0.5 * np.einsum("pij,pij->pi", n, slopes), np.stack(unit, axis=1)], axis=1
    )
    largest = np.sum(abs(n) ** 2, axis=2).max(axis=1)
    terms = CONE_TERMS * (1.0 + largest)[:, np.newaxis] * np.ones(6)
    sums = abs(cones).sum(axis=(1, 2)) * [1.0, 1.0, 4.0]
    bend = np.broadcast_to(np.concatenate([sums, [3.0, 3.0, 3.0]]), terms.shape)
    return _radii(values, jacobian.reshape(-1, 6, 6), ROUNDINGS * EPS * terms, bend)


def _radii(values: Complex, jacobian: Complex, rounding: Array, bend: Array) -> Array:
    """2η where the theorem applies, else inf; all (..., n) but the Jacobian (..., n, n).

    ``bend`` bounds half of what the second derivatives of each equation add up to. A
    derivative has at most eight times the rounding of a value, summed over the unknowns.
    """
    good = np.isfinite(jacobian).all(axis=(-2, -1)) & (np.linalg.det(jacobian) != 0.0)
    identity = np.eye(jacobian.shape[-1])
    inverse = abs(np.linalg.inv(np.where(good[..., np.newaxis, np.newaxis], jacobian, identity)))
    eta, alpha, beta = (
        np.einsum("...ij,...j->...i", inverse, side).max(axis=-1)
        for side in (abs(values) + rounding, 8.0 * rounding, bend)
    )
    return np.where(good & (alpha + 2.0 * beta * eta < 0.5), 2.0 * eta, np.inf)


def _expanded(tables: Array, x: Complex) -> tuple[Complex, Complex, Array]:
    """Values (N, P, 2), derivatives (N, P, 2, 2), and half of bounds (N, P, 2) on the second."""
    powers = np.arange(DEGREE + 1)
    power = x[..., np.newaxis] ** powers
    slope = powers * np.concatenate([np.zeros_like(power[..., :1]), power[..., :-1]], axis=-1)
    left, right = power[..., 0, :], power[..., 1, :]
    values = np.einsum("npk,npekl,npl->npe", left, tables, right)
    by_t = np.einsum("npk,npekl,npl->npe", slope[..., 0, :], tables, right)
    by_s = np.einsum("npk,npekl,npl->npe", left, tables, slope[..., 1, :])
    # |∂²| summed over both unknowns twice, on all of the largest ball.
    along = (abs(x)[..., np.newaxis] + MOST_RADIUS) ** np.maximum(powers - 2, 0)
    far = (abs(x)[..., np.newaxis] + MOST_RADIUS) ** powers
    near = powers * (abs(x)[..., np.newaxis] + MOST_RADIUS) ** np.maximum(powers - 1, 0)
    twice = powers * (powers - 1) * along
    size = abs(tables)
    most = np.einsum("npk,npekl,npl->npe", twice[..., 0, :], size, far[..., 1, :])
    most += np.einsum("npk,npekl,npl->npe", far[..., 0, :], size, twice[..., 1, :])
    most += 2.0 * np.einsum("npk,npekl,npl->npe", near[..., 0, :], size, near[..., 1, :])
    return values, np.stack([by_t, by_s], axis=-1), 0.5 * most
