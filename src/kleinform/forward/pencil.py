"""All 32 pairs of solutions, the complex ones too, by an eigenvalue problem.

The half-angle tangents (t, s) of two legs satisfy two equations of degree 4 in each. Their
Sylvester matrix in s is a matrix polynomial S(t) of size 8 and degree 4: its 32 eigenvalues
are the t, and its null vectors are (1, s, ..., s⁷).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import Rows, relabel, turned
from kleinform.forward.polish import unlabelled
from kleinform.generated import kernels
from kleinform.sums import dot, turned_by

__all__ = ["PAIRS", "STARTS", "Pairs", "pairs_of", "refined", "tables_of"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int64]

#: Solutions modulo the reflection n → −n: 4·4 + 4·4 by Bézout's theorem.
PAIRS = 32
DEGREE = 4
STEPS = 6
#: Angles at which t = 0 and s = 0, in turn: none is special for the mechanism.
STARTS = (
    *((0.4, 1.1), (2.3, 0.7), (1.5, 2.9)),
    *((3.6, 2.1), (5.1, 4.3), (0.9, 5.3), (4.2, 0.2), (2.8, 3.7)),
)


@dataclass(frozen=True)
class Pairs:
    """One of each pair of solutions.

    Attributes
    ----------
    directions : complex array (N, 32, 2, 3)
        n_1 and n_2.
    half_tangents : complex array (N, 32, 2)
        t and s of the legs ``base`` and the one after it.
    extension : complex array (N, 32, 2)
        e of these two limbs.
    step : array (N, 32)
        Newton's last step in (t, s), as the angle of a half turn.
    """

    directions: Complex
    half_tangents: Complex
    extension: Complex
    step: Array


def pairs_of(rows: Rows, base: Integers, start: int = 0, steps: int = STEPS) -> Pairs:
    """The solutions of rows; legs ``base`` and the one after it carry the unknowns."""
    tables = tables_of(rows, base, start)
    with np.errstate(all="ignore"):
        angle, cone = (_scaled(table) for table in (tables.angle, tables.cone))
    return refined(tables, base, *_eigenpairs(angle, cone), steps)


def tables_of(rows: Rows, base: Integers, start: int) -> kernels.Circles:
    """The two equations in the half-angle tangents."""
    position, lengths = relabel(rows, base)
    angles = np.array(STARTS[start])
    turn = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return kernels.circles(rows.radius, position, lengths, turn)


def refined(tables: kernels.Circles, base: Integers, t: Complex, s: Complex, steps: int) -> Pairs:
    """Newton's method from half-angle tangents (N, P), and the directions that belong to them."""
    with np.errstate(all="ignore"):
        equations = np.stack([_scaled(tables.angle), _scaled(tables.cone)], axis=1)
        t, s, step = _newton(equations, t, s, steps)
        arms = np.stack(
            [_arms(table, half) for table, half in ((tables.first, t), (tables.second, s))], axis=2
        )
        extension = np.sqrt(dot(arms, arms)).astype(np.complex128)
        # The sign that makes n_1·n_2 = −1/2.
        facing = dot(arms[:, :, 0], arms[:, :, 1]) / extension.prod(axis=2)
        extension[:, :, 1] *= np.where(facing.real < 0.0, 1.0, -1.0)
        relabelled = arms / extension[..., np.newaxis]
        flat = turned(relabelled, base, back=True).reshape(-1, 2, 3)
        directions = unlabelled(flat, np.repeat(base, t.shape[1])).reshape(arms.shape)
    return Pairs(directions, np.stack([t, s], axis=2), extension, step)


def _scaled(table: Array) -> Array:
    return np.asarray(table / np.max(abs(table), axis=(1, 2), keepdims=True))


def _eigenpairs(angle: Array, cone: Array) -> tuple[Complex, Complex]:
    """Eigenvalues t of the Sylvester matrix polynomial, and s of their null vectors."""
    count, size = len(angle), 2 * DEGREE
    sylvester = np.zeros((count, DEGREE + 1, size, size))
    for shift in range(DEGREE):
        columns = slice(shift, shift + DEGREE + 1)
        sylvester[:, :, shift, columns] = angle
        sylvester[:, :, DEGREE + shift, columns] = cone
    companion = np.zeros((count, DEGREE * size, DEGREE * size))
    companion[:, :-size, size:] = np.eye((DEGREE - 1) * size)
    blocks = np.concatenate(list(np.moveaxis(sylvester[:, :DEGREE], 1, 0)), axis=2)
    companion[:, -size:] = -_solved(sylvester[:, DEGREE], blocks)
    known = np.asarray(np.isfinite(companion).all(axis=(1, 2), keepdims=True))
    values, vectors = np.linalg.eig(np.where(known, companion, 0.0))
    values = np.where(known[:, 0], values, np.nan).astype(np.complex128)
    # NumPy gives real ones where those of all rows are.
    null = vectors[:, :size].astype(np.complex128)
    low = abs(null[:, 0]) >= abs(null[:, -1])
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.where(low, null[:, 1] / null[:, 0], null[:, -1] / null[:, -2])
    return values, np.asarray(s)


def _solved(matrix: Array, side: Array) -> Array:
    """Solutions of many linear systems; zero where the matrix is singular."""
    try:
        return np.asarray(np.linalg.solve(matrix, side), dtype=np.float64)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.zeros_like(side)
        parts = [
            _solved(one[np.newaxis], own[np.newaxis]) for one, own in zip(matrix, side, strict=True)
        ]
        return np.concatenate(parts)


def _newton(tables: Array, t: Complex, s: Complex, steps: int) -> tuple[Complex, Complex, Array]:
    """Newton's method on the two equations, for all pairs of all rows."""
    powers = np.arange(DEGREE + 1)
    both = tables[:, 0, np.newaxis], tables[:, 1, np.newaxis]
    with np.errstate(all="ignore"):
        for _ in range(steps):
            left, right = t[..., np.newaxis] ** powers, s[..., np.newaxis] ** powers
            left_slope = powers * np.concatenate([left[..., :1], left[..., :-1]], axis=-1)
            right_slope = powers * np.concatenate([right[..., :1], right[..., :-1]], axis=-1)
            (f, fs), (g, gs) = (
                [dot(left, turned_by(table, side)) for side in (right, right_slope)]
                for table in both
            )
            ft, gt = (dot(left_slope, turned_by(table, right)) for table in both)
            determinant = ft * gs - fs * gt
            step_t, step_s = (f * gs - fs * g) / determinant, (ft * g - f * gt) / determinant
            t, s = t - step_t, s - step_s
        size = abs(step_t) / (1.0 + abs(t) ** 2) + abs(step_s) / (1.0 + abs(s) ** 2)
    return t, s, size


def _arms(table: Array, half: Complex) -> Complex:
    """From C to B at half-angle tangents (N, 32)."""
    powers = half[..., np.newaxis] ** np.arange(3)
    arms = turned_by(table.swapaxes(1, 2)[:, np.newaxis], powers)
    return np.asarray(arms / (1.0 + half**2)[..., np.newaxis])
