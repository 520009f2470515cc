"""All solutions of a square system, and paths that fail followed anew."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.homotopy.endpoints import Endpoints, follow
from kleinform.homotopy.tracker import PREDICTION, Homotopy, System

__all__ = ["MOST_TRIES", "TIGHTER", "persist", "solve"]

Complex = NDArray[np.complex128]
Real = NDArray[np.float64]
Mask = NDArray[np.bool_]
Index = NDArray[np.intp]

#: Regular endpoints that are closer are one, which two paths never share: SINGULAR keeps
#: different ones further apart, and copies agree to about ``eps / SINGULAR``.
SAME = 1e-7
#: Starts from which a system is solved before a failed path is reported, each with steps that
#: are ``TIGHTER**(1/5)`` as long as those before.
MOST_TRIES = 3
TIGHTER = 1e-2


def solve(system: System, degrees: tuple[int, ...], *, seed: int) -> Endpoints:
    """All isolated solutions of a system, by as many paths as the product of its degrees.

    Parameters
    ----------
    system : callable
        ``system(x) -> (values, derivatives)``, x of shape (P, n + 1), the results of shapes
        (P, n) and (P, n, n + 1): homogeneous polynomials with coefficients of order 1.
    degrees : n of int
        Degrees of the polynomials.
    seed : int
        Of the factors that keep the paths apart; the same seed gives the same result.
    """
    powers = np.array(degrees)
    rng = np.random.default_rng(seed)
    turns = np.indices(degrees).reshape(len(degrees), -1).T / powers
    starts = np.insert(np.exp(2j * np.pi * turns), 0, 1.0, axis=1)

    def attempt(number: int, _: Index) -> Endpoints:
        gamma = np.exp(2j * np.pi * rng.random(len(degrees)))
        homotopy = _total_degree(system, powers, gamma)
        return follow(homotopy, starts, PREDICTION * TIGHTER**number)

    found = persist(attempt, (1, len(starts)), np.ones(len(degrees) + 1))
    return Endpoints(*(part[0] for part in _parts(found)))


def persist(
    attempt: Callable[[int, Index], Endpoints], shape: tuple[int, int], mirror: Real
) -> Endpoints:
    """Solve problems of some paths each, and anew those where a path failed or met another.

    Of several tries the one with the fewest failures counts.
    """
    todo = np.arange(shape[0])
    for number in range(MOST_TRIES):
        parts = _parts(attempt(number, todo))
        found = Endpoints(*(part.reshape(len(todo), shape[1], *part.shape[1:]) for part in parts))
        found.status[_repeated(found, mirror)] = "failed"
        found.tries[...] = number + 1
        if number == 0:
            whole = found
        else:
            whole.steps[todo] += found.steps
            whole.tries[todo] = found.tries
            found.steps[...] = whole.steps[todo]
            better = _failures(found) < _failures(whole)[todo]
            for kept, part in zip(_parts(whole), _parts(found), strict=True):
                kept[todo[better]] = part[better]
        todo = np.flatnonzero(np.any(whole.status == "failed", axis=-1))
        if not len(todo):
            break
    return whole


def _parts(found: Endpoints) -> list[NDArray[Any]]:
    return [getattr(found, field.name) for field in fields(found)]


def _failures(found: Endpoints) -> Index:
    """How many paths of each problem failed."""
    return np.asarray(np.count_nonzero(found.status == "failed", axis=-1))


def _repeated(found: Endpoints, mirror: Real) -> Mask:
    """Regular endpoints that an earlier path, or its mirror image, has already."""
    same = np.zeros((*found.status.shape, found.status.shape[-1]), dtype=bool)
    for signs in (np.ones_like(mirror), mirror):
        cosines = np.abs((found.points * signs) @ found.points.conj().swapaxes(-1, -2))
        same |= 1.0 - cosines**2 <= SAME**2
    regular = found.status == "regular"
    same &= regular[..., :, np.newaxis] & regular[..., np.newaxis, :]
    return np.asarray(np.any(np.tril(same, -1), axis=-1))


def _total_degree(system: System, powers: Index, gamma: Complex) -> Homotopy:
    """From ``x_i^d_i = x_0^d_i`` to a system; gamma turns the straight way off all others."""

    def homotopy(x: Complex, t: Real | Complex, _: Index) -> tuple[Complex, Complex, Complex]:
        values, derivatives = system(x)
        start = gamma * (x[:, 1:] ** powers - x[:, :1] ** powers)
        by_x = np.zeros_like(derivatives)
        by_x[:, :, 0] = -gamma * powers * x[:, :1] ** (powers - 1)
        rows = np.arange(len(powers))
        by_x[:, rows, rows + 1] = gamma * powers * x[:, 1:] ** (powers - 1)
        share = t[:, np.newaxis]
        by_x = by_x + share[..., np.newaxis] * (derivatives - by_x)
        return start + share * (values - start), by_x, values - start

    return homotopy
