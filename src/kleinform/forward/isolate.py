"""All real zeros of trigonometric polynomials, many polynomials at once, none missed.

On each of a few cells of the circle the polynomial is written in Bernstein's basis. Its number
of zeros in the cell is at most the number of sign changes of the coefficients, and differs
from it by an even number: no change proves that there is none, one change that there is
just one. Other cells are halved. A cell that stays undecided when it is as narrow as NARROW,
or in which coefficients are within rounding of zero, is reported as a cluster.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import comb, factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Zeros", "isolate"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

CELLS = 64
#: Local polynomials are cut off here: what is left out of a degree of 16 is below 1e-15.
LOCAL = 14
#: Those of LOCAL, a row each.
BINOMIALS = np.array([[float(comb(LOCAL, power))] for power in range(LOCAL + 1)])
#: Where the first cell starts, in cells: zeros at multiples of 30° should not lie on edges.
OFFSET = 0.37
#: Cells are halved at most so often.
HALVINGS = 6
#: Newton's steps from where the control polygon crosses zero: 1e-12 of a cell at the median.
REFINEMENTS = 3


class Zeros(NamedTuple):
    """Cells with zeros: which polynomial, from where to where, a guess, and whether it is one.

    ``simple`` cells hold just one zero; others hold zero, two or more that lie together.
    """

    row: Integers
    low: Array
    high: Array
    guess: Array
    simple: Mask


def isolate(coefficients: Array, rounding: Array) -> Zeros:
    """Isolate the zeros of polynomials given by cosine and sine coefficients (N, 2d + 1).

    ``rounding`` (N,) bounds the errors of the values.
    """
    degree = coefficients.shape[1] // 2
    # One row of the table after the other for any number of polynomials, unlike by BLAS.
    local = np.einsum("nk,kc->nc", coefficients, _cells(degree)).reshape(-1, LOCAL + 1)
    width = 2.0 * float(np.pi) / CELLS
    changes, doubtful = _judge(local, np.repeat(rounding, CELLS))
    index = np.flatnonzero((changes > 0) | doubtful)
    row = index // CELLS
    low = ((index % CELLS).astype(np.float64) + OFFSET) * width
    local, changes, doubtful = local[index], changes[index], doubtful[index]
    found = []
    for _ in range(HALVINGS + 1):
        done = (changes == 1) & ~doubtful
        found.append(_zeros(row[done], low[done], width, local[done], simple=True))
        keep = (changes > 1) | doubtful
        row, low, local = row[keep], low[keep], local[keep]
        if not len(row):
            break
        coarse = _zeros(row, low, width, local, simple=False)
        width /= 2.0
        left, right = _halves(local)
        local = np.concatenate([left, right])
        row, low = np.concatenate([row, row]), np.concatenate([low, low + width])
        changes, doubtful = _judge(local, rounding[row])
    else:
        found.append(coarse)
    return Zeros._make(map(np.concatenate, zip(*found, strict=True)))


def _judge(local: Array, rounding: Array) -> tuple[Integers, Mask]:
    """Sign changes of the coefficients, and whether one of them may be zero."""
    positive = local > 0.0
    changes: Integers = (positive[:, 1:] != positive[:, :-1]).sum(axis=1)
    doubtful: Mask = np.any(abs(local) <= rounding[:, np.newaxis], axis=1)
    return changes, doubtful


def _zeros(row: Integers, low: Array, width: float, local: Array, simple: bool) -> Zeros:
    place = _crossing(local) if simple else np.full(len(row), 0.5)
    return Zeros(row, low, low + width, low + width * place, np.full(len(row), simple))


def _crossing(local: Array) -> Array:
    """The zero of polynomials on [0, 1] that change their sign once, by safeguarded Newton."""
    if not len(local):
        return np.empty(0)
    low, high = np.zeros(len(local)), np.ones(len(local))
    rising = local[:, -1] > local[:, 0]
    # Start where the control polygon crosses zero.
    first = np.argmax((local[:, 1:] > 0.0) == rising[:, np.newaxis], axis=1)
    take = np.arange(len(local))
    before, after = local[take, first], local[take, first + 1]
    place = (first + before / (before - after)) / LOCAL
    powers = _powers(local)
    for _ in range(REFINEMENTS):
        value = np.zeros(len(local))
        slope = np.zeros(len(local))
        for power in range(LOCAL, -1, -1):
            slope = slope * place + value
            value = value * place + powers[power]
        above = (value > 0.0) == rising
        high, low = np.where(above, place, high), np.where(above, low, place)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = place - value / slope
        inside = (step >= low) & (step <= high)
        place = np.where(inside, step, 0.5 * (low + high))
    return np.asarray(place)


def _halves(local: Array) -> tuple[Array, Array]:
    """De Casteljau's subdivision at the middle."""
    left, right = np.empty_like(local), np.empty_like(local)
    current = local
    for step in range(LOCAL + 1):
        left[:, step], right[:, LOCAL - step] = current[:, 0], current[:, -1]
        current = 0.5 * (current[:, 1:] + current[:, :-1])
    return left, right


@cache
def _cells(degree: int) -> Array:
    """From cosine and sine coefficients to Bernstein coefficients on every cell."""
    half = np.pi / CELLS
    middle = (np.arange(CELLS) + OFFSET + 0.5) * 2.0 * half
    basis = np.zeros((2 * degree + 1, CELLS, LOCAL + 1))
    for power, row in enumerate(_bernstein()):
        scale = half**power / factorial(power)
        for harmonic in range(degree + 1):
            phase = harmonic * middle + power * np.pi / 2.0
            size = scale * float(harmonic) ** power
            basis[harmonic] += size * np.cos(phase)[:, np.newaxis] * row
            if harmonic:
                basis[degree + harmonic] += size * np.sin(phase)[:, np.newaxis] * row
    return basis.reshape(2 * degree + 1, -1)


def _bernstein() -> Array:
    """Row j: the Bernstein coefficients of x^j on [−1, 1], exact before rounding."""
    rows = []
    for power in range(LOCAL + 1):
        # x^j = Σ_k C(j, k) 2^k (−1)^(j−k) u^k with u = (x + 1)/2 in [0, 1].
        monomial = [comb(power, k) * 2**k * (-1) ** (power - k) for k in range(power + 1)]
        rows.append(
            [
                float(
                    sum(
                        Fraction(comb(i, k), comb(LOCAL, k)) * monomial[k]
                        for k in range(min(i, power) + 1)
                    )
                )
                for i in range(LOCAL + 1)
            ]
        )
    return np.array(rows)


def _powers(local: Array) -> Array:
    """Coefficients of powers (LOCAL + 1, K) from Bernstein's on [0, 1]: differences."""
    powers: Array = local.T.copy()
    for order in range(1, LOCAL + 1):
        for power in range(LOCAL, order - 1, -1):
            powers[power] -= powers[power - 1]
    powers *= BINOMIALS
    return powers
