"""Where on a circle a trigonometric polynomial may vanish, if it is known within ε.

``p(ζ) = ζ^d g(u)``, ζ = e^{iu}, has degree n = 2d. Let ζ_1 ... ζ_n be any numbers and c its
leading coefficient, d_l = |ζ_m − ζ_l| / 2, and on the unit circle

    |p − c Π(ζ − ζ_m)| <= ε_m + λ x,   x the distance from ζ_m.

If for x = w_m, and so for every larger x,

    |c| x Π_{l≠m} max(x, d_l) >= 5/4 ε_m    and    |c| Π_{l≠m} max(x, d_l) >= 5 λ,

then p vanishes on the unit circle only in the discs |z − ζ_m| < w_m: a point z that is in none
of them, and nearest to ζ_m, at the distance x, is at least max(x, d_l) from ζ_l. There p has
the sign of any approximation that is off by no more.

Where w_m <= d_l for all l, |c Π(ζ − ζ_l)| >= |c| w_m Π d_l on the circle around ζ_m: if p
differs by less, Rouché's theorem gives it exactly one root inside, which is analytic in any
parameter that p is analytic in.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Roots", "roots_of", "values"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Leading coefficients that are smaller, relative to the others, are made so large.
LEAST = 1e-14
#: Relative rounding of the product of up to four linear factors.
ROUNDING = 1e-14


class Roots(NamedTuple):
    """Approximate roots of N polynomials.

    Attributes
    ----------
    zeta : complex array (N, n)
    tails : array (N, n, n)
        ``|c| Π_{l>=k} d_l`` of the sorted d, k = 1 ... n; the last has no factor.
    nearest : array (N, n)
        The least d_l.
    defect : array (N,)
        At least ``|p − c Π(ζ − ζ_m)|`` on the unit circle, coefficient by coefficient.
    """

    zeta: Complex
    tails: Array
    nearest: Array
    defect: Array

    def widths(self, eps: Array, slope: Array) -> Array:
        """The least w_m (N, n) for ε (N, n) and λ (N,)."""
        powers = np.arange(1, self.zeta.shape[1] + 1)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            first = (1.25 * eps[..., np.newaxis] / self.tails) ** (1.0 / powers)
            ratio = 5.0 * slope[:, np.newaxis, np.newaxis] / self.tails
            second = np.where(ratio <= 1.0, 0.0, ratio ** (1.0 / np.maximum(powers - 1, 1)))
        second[..., 0] = np.where(ratio[..., 0] <= 1.0, 0.0, np.inf)
        least = np.maximum(_least(first), _least(second))
        return least * (1.0 + 1e-9)


def _least(powers: Array) -> Array:
    found: Array = np.where(np.isnan(powers), np.inf, powers).min(axis=-1)
    return found


def values(coefficients: Array, u: Array) -> Array:
    """g (...) for coefficients (..., 5) at u (...)."""
    cos, sin = np.cos(u), np.sin(u)
    c0, c1, s1, c2, s2 = np.moveaxis(coefficients, -1, 0)
    total: Array = c0 + c1 * cos + s1 * sin + c2 * (2.0 * cos * cos - 1.0) + 2.0 * s2 * sin * cos
    return total


def roots_of(coefficients: Array, degree: int) -> Roots:
    """Roots of the polynomials with coefficients (N, 5) of (1, cos u, sin u, cos 2u, sin 2u)."""
    p = _polynomials(coefficients, degree)
    scale = abs(p).max(axis=1, initial=1e-300)
    lead = np.where(abs(p[:, 0]) < LEAST * scale, LEAST * scale, p[:, 0])
    n = 2 * degree
    companion = np.zeros((len(p), n, n), dtype=np.complex128)
    companion[:, 0] = -p[:, 1:] / lead[:, np.newaxis]
    companion[:, np.arange(1, n), np.arange(n - 1)] = 1.0
    zeta = np.linalg.eigvals(companion).astype(np.complex128)
    apart: Array = np.abs(zeta[:, :, np.newaxis] - zeta[:, np.newaxis]) / 2.0
    apart[:, np.arange(n), np.arange(n)] = np.inf
    d: Array = np.sort(apart, axis=-1)[..., :-1]
    backwards = np.cumprod(np.append(np.ones((*d.shape[:2], 1)), d[..., ::-1], axis=-1), axis=-1)
    size: Array = np.abs(lead)
    tails: Array = size[:, np.newaxis, np.newaxis] * backwards[..., ::-1]
    return Roots(zeta, tails, d[..., 0], _defect(p, lead, zeta))


def _polynomials(coefficients: Array, degree: int) -> Complex:
    """Coefficients (N, n + 1) of p, the leading one first."""
    c0, c1, s1, c2, s2 = coefficients.T
    first, second = (c1 - 1j * s1) / 2.0, (c2 - 1j * s2) / 2.0
    half = [first] if degree == 1 else [second, first]
    return np.stack([*half, c0 + 0j, *(entry.conj() for entry in half[::-1])], axis=1)


def _defect(p: Complex, lead: Complex, zeta: Complex) -> Array:
    product = lead[:, np.newaxis]
    for k in range(zeta.shape[1]):
        shifted = np.pad(product, ((0, 0), (0, 1)))
        shifted[:, 1:] -= zeta[:, k, np.newaxis] * product
        product = shifted
    size = abs(lead) * np.prod(1.0 + abs(zeta), axis=1)
    total: Array = abs(p - product).sum(axis=1) + ROUNDING * size
    return total
