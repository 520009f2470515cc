"""The six quadratics of the assembly modes, solved for many joint values at once."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import KleinformError
from kleinform.homotopy.endpoints import Endpoints, follow
from kleinform.homotopy.total_degree import MOST_TRIES, TIGHTER, persist, solve
from kleinform.homotopy.tracker import PREDICTION, Homotopy, System

__all__ = ["quadratics", "solve_cones"]

Complex = NDArray[np.complex128]
Real = NDArray[np.float64]
Index = NDArray[np.intp]

#: The quadratics are even in (n_1, n_2): their 2⁶ solutions come in pairs.
PAIRS = 32
MIRROR = np.array([1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0])


def solve_cones(cones: ArrayLike) -> Endpoints:
    """The solutions of `quadratics` for many real cones, one of each pair ±(n_1, n_2).

    Parameters
    ----------
    cones : array (N, 3, 3, 3)
        A symmetric matrix for each of n_1, n_2, n_3; their scale does not matter.

    Returns
    -------
    Endpoints
        Of shape (N, 32): x is ``(x_0, n_1, n_2)``.
    """
    ends = np.asarray(cones, dtype=float)
    norms = np.linalg.norm(ends, axis=(-2, -1), keepdims=True)
    ends = ends / np.where(norms == 0.0, 1.0, norms)

    def attempt(number: int, problems: Index) -> Endpoints:
        start, points = _generic_cones(number)
        starts = np.tile(points, (len(problems), 1))
        homotopy = _between(start, ends[problems])
        return follow(homotopy, starts, PREDICTION * TIGHTER**number)

    return persist(attempt, (len(ends), PAIRS), MIRROR)


def quadratics(cones: Complex) -> System:
    """The six quadratics of the assembly modes, in ``(x_0, n_1, n_2)``.

    ``n_iᵀ M_i n_i = 0`` for the three symmetric matrices, with ``n_3 = -n_1 - n_2``, and
    ``n_1·n_1 = n_2·n_2 = -2 n_1·n_2 = x_0²``. Generically there are 64 solutions.

    Parameters
    ----------
    cones : complex array (3, 3, 3) or (P, 3, 3, 3)
        One set of three for all points, or one set a point.
    """

    def system(x: Complex) -> tuple[Complex, Complex]:
        n = _directions(x)
        images = np.einsum("...ijk,...ik->...ij", cones, n)
        values = np.empty((len(x), 6), dtype=complex)
        derivatives = np.zeros((len(x), 6, 7), dtype=complex)
        values[:, :3] = np.sum(images * n, axis=-1)
        derivatives[:, 0, 1:4] = 2.0 * images[:, 0]
        derivatives[:, 1, 4:] = 2.0 * images[:, 1]
        derivatives[:, 2, 1:4] = derivatives[:, 2, 4:] = -2.0 * images[:, 2]
        square = x[:, 0] ** 2
        values[:, 3] = np.sum(n[:, 0] ** 2, axis=-1) - square
        values[:, 4] = np.sum(n[:, 1] ** 2, axis=-1) - square
        values[:, 5] = 2.0 * np.sum(n[:, 0] * n[:, 1], axis=-1) + square
        derivatives[:, 3:, 0] = 2.0 * x[:, :1] * np.array([-1.0, -1.0, 1.0])
        derivatives[:, 3, 1:4] = derivatives[:, 5, 4:] = 2.0 * n[:, 0]
        derivatives[:, 4, 4:] = derivatives[:, 5, 1:4] = 2.0 * n[:, 1]
        return values, derivatives

    return system


def _directions(x: Complex) -> Complex:
    """n_1, n_2, n_3, a row each."""
    n = x[:, 1:].reshape(-1, 2, 3)
    return np.concatenate([n, -np.sum(n, axis=1, keepdims=True)], axis=1)


def _between(start: Complex, ends: Real) -> Homotopy:
    """The way from one set of cones to many, with PAIRS paths to each."""
    change = ends - start

    def homotopy(x: Complex, t: Real | Complex, paths: Index) -> tuple[Complex, Complex, Complex]:
        moved, n = change[paths // PAIRS], _directions(x)
        values, by_x = quadratics(start + t[:, np.newaxis, np.newaxis, np.newaxis] * moved)(x)
        by_t = np.zeros_like(values)
        by_t[:, :3] = np.einsum("pij,pijk,pik->pi", n, moved, n)
        return values, by_x, by_t

    return homotopy


@lru_cache(maxsize=MOST_TRIES)
def _generic_cones(seed: int) -> tuple[Complex, Complex]:
    """Complex cones that nothing is special about, and one of each pair of their solutions."""
    rng = np.random.default_rng(seed)
    cones = rng.normal(size=(3, 3, 3)) + 1j * rng.normal(size=(3, 3, 3))
    cones = cones + cones.swapaxes(-1, -2)
    cones /= np.linalg.norm(cones, axis=(-2, -1), keepdims=True)
    found = solve(quadratics(cones), (2,) * 6, seed=seed)
    points = found.points[(found.status == "regular") & (found.points[:, 1].real > 0.0)]
    if len(points) != PAIRS:
        raise KleinformError(
            f"generic cones {seed}: {len(points)} of {PAIRS} pairs of solutions were found"
        )
    return cones, points
