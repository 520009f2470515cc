"""Folds, where two assembly modes meet, and on which side of one the joint values are.

At a fold the three gradients G_i of the closure equations by a turn of the platform are
coplanar: y·G = 0 and G v = 0. Near it, along the direction v that they leave free, y·F is a
parabola ``height + bend s²/2``. Its height decides: of one sign there are two modes, of the
other none, and within what the joint values' tolerance can move it the two have merged.

Where the rounding of float64 could hide that, the closure equations are computed anew in
decimal numbers (`sharp`). What is left are errors of second order: of the place, y and v.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from kleinform.forward import sharp
from kleinform.forward.cases import reach_of
from kleinform.forward.circle import Rows
from kleinform.forward.polish import polished, turn_by
from kleinform.generated import kernels
from kleinform.sums import dot, turned_by

__all__ = ["Folds", "bend_of_equations", "folds", "rounding_of_equations", "split"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
STEPS = 8
#: Newton's last step to a fold.
CONVERGED = 1e-9
#: A fold is where the second singular value of G is above this, relative to the first.
CORANK_ONE = 1e-5
#: Rounding of F_i and of G_i, in eps times the square of a + |c| + q_i: F_i is a sum of three
#: squares of at most twice that, each after some twenty roundings, its frame is orthonormal
#: to 2 eps, and so are sines and cosines.
ROUNDING = 256.0
#: Second derivatives of F_i by a turn, at most, in the same squares: four times the norm of
#: a cone, which has three squares.
BEND = 12.0
#: Rounding of a singular value decomposition of a 3×3 matrix of unit rows, in eps.
SVD_ROUNDING = 16.0
#: A mode beside a fold has converged when Newton's last step is below this, relative to its
#: distance from the fold.
SIDE = 0.05
SHARP_STEPS = 3


@dataclass(frozen=True)
class Folds:
    """Folds that were found: directions at each, and its parabola.

    ``merged`` where the tolerance covers the height, ``apart`` where there are two modes at
    ``±reach`` along ``free``, ``lost`` where no fold was found, ``hidden`` where one was, and
    not its side.
    """

    directions: Array
    free: Array
    reach: Array
    merged: Mask
    apart: Mask
    lost: Mask
    hidden: Mask


def rounding_of_equations(rows: Rows) -> Array:
    """A bound on the rounding of F_i and G_i (N, 3)."""
    return np.asarray(ROUNDING * EPS * reach_of(rows) ** 2)


def bend_of_equations(rows: Rows) -> Array:
    """A bound on the second derivatives of F_i by a turn (N, 3)."""
    return np.asarray(BEND * reach_of(rows) ** 2)


@np.errstate(divide="ignore", invalid="ignore")
def folds(rows: Rows, row: Integers, directions: Array, tolerance: float) -> Folds:
    """Find the fold nearest to some directions, and decide on which side of it the row is."""
    rows = rows[row]
    local = kernels.fold(rows.radius, rows.joints, directions)
    norms = np.linalg.norm(local.gradient, axis=2)
    rounding = rounding_of_equations(rows) / norms
    local = _scaled(local, norms)
    toward, aside = _toward(local.gradient, norms), np.zeros(len(rows))
    for _ in range(STEPS):
        directions, aside, size = _stepped(local, directions, toward, aside)
        local = _scaled(kernels.fold(rows.radius, rows.joints, directions), norms)
    near = _judged(rows, local, directions, toward, norms, rounding, tolerance)
    near.lost[~(size <= CONVERGED)] = True
    for _ in range(SHARP_STEPS):
        left = np.flatnonzero(near.hidden & ~near.lost)
        if not len(left):
            break
        own, place = rows[left], near.directions[left]
        local = _scaled(_sharp_fold(own, place), norms[left])
        given = toward[left], norms[left], 0.0 * rounding[left]
        sharper = _judged(own, local, place, *given, tolerance)
        ahead, _, _ = _stepped(local, place, toward[left], aside[left])
        sharper.directions[sharper.hidden] = ahead[sharper.hidden]
        for field in fields(Folds):
            getattr(near, field.name)[left] = getattr(sharper, field.name)
    for mask in (near.merged, near.apart, near.hidden):
        mask[near.lost] = False
    return near


def _scaled(local: kernels.Fold, norms: Array) -> kernels.Fold:
    """The same with gradients of about unit size: C near the plane of a leg makes F_i small."""
    product = norms.prod(axis=1)
    return local._replace(
        residual=local.residual / norms,
        gradient=local.gradient / norms[..., np.newaxis],
        volume=local.volume / product,
        volume_gradient=local.volume_gradient / product[:, np.newaxis],
        by_joints=local.by_joints / norms[..., np.newaxis],
    )


def _sharp_fold(rows: Rows, directions: Array) -> kernels.Fold:
    """What the kernel gives, its equations without the rounding of float64."""
    local = kernels.fold(rows.radius, rows.joints, directions)
    equations = [sharp.closure(rows[[k]], own) for k, own in enumerate(directions)]
    residual, gradient = map(np.array, zip(*equations, strict=True))
    return local._replace(residual=residual, gradient=gradient, volume=np.linalg.det(gradient))


def _stepped(
    local: kernels.Fold, directions: Array, toward: Array, aside: Array
) -> tuple[Array, Array, Array]:
    """A step of Newton's method to where F is along ``toward`` and the G_i are coplanar.

    Returns the directions, how far F is along, and how far the step turned.
    """
    matrix = np.zeros((len(directions), 4, 4))
    matrix[:, :3, :3], matrix[:, :3, 3] = local.gradient, -toward
    matrix[:, 3, :3] = local.volume_gradient
    side = np.concatenate(
        [local.residual - aside[:, np.newaxis] * toward, local.volume[:, np.newaxis]], axis=1
    )
    step = _solved(matrix, -side)
    size: Array = np.linalg.norm(step[:, :3], axis=1)
    return turn_by(directions, step[:, :3]), aside + step[:, 3], size


def _toward(gradient: Array, norms: Array) -> Array:
    """Where F may point at a fold: the combination y of the equations as they were.

    A limb with C near its plane then misses its equation, and the others hold.
    """
    y = np.linalg.svd(np.where(np.isfinite(gradient), gradient, 0.0))[0][:, :, 2]
    toward = y * (norms.min(axis=1, keepdims=True) / norms) ** 2
    return np.asarray(toward / np.linalg.norm(toward, axis=1, keepdims=True))


def _solved(matrix: Array, side: Array) -> Array:
    """Solutions of small systems, NaN where one is singular."""
    good = np.asarray(np.isfinite(matrix).all((1, 2)) & np.isfinite(side).all(1))
    good[good] = np.linalg.det(matrix[good]) != 0.0
    result = np.full(side.shape, np.nan)
    result[good] = np.linalg.solve(matrix[good], side[good][..., np.newaxis])[..., 0]
    return result


def _judged(
    rows: Rows,
    local: kernels.Fold,
    directions: Array,
    toward: Array,
    norms: Array,
    rounding: Array,
    tolerance: float,
) -> Folds:
    """The folds at these directions, one a row, where F points ``toward``.

    ``local`` was divided by ``norms`` (K, 3), and ``rounding`` (K, 3) bounds what its F_i and
    G_i are off. The height is off by the rounding and, in second order, because
    the directions are not just at the fold, nor y and v just normal: how far away the fold
    is say the equations other than y·F, which should hold there, and the smallest singular
    value, which should vanish.
    """
    gradient, residual = local.gradient, local.residual
    finite = np.asarray(np.isfinite(gradient).all((1, 2)) & np.isfinite(residual).all(1))
    left, singular, right = np.linalg.svd(
        np.where(finite[:, np.newaxis, np.newaxis], gradient, 0.0)
    )
    y, free = left[:, :, 2], right[:, 2]
    height = dot(y, residual)
    sign = np.sign(np.linalg.det(left) * np.linalg.det(right))
    bend = dot(local.volume_gradient, free) * sign
    bend /= singular[:, 0] * singular[:, 1]
    lost = ~finite | ~(singular[:, 1] >= CORANK_ONE * singular[:, 0]) | ~(abs(bend) > 0.0)

    aside = height / dot(y, toward)
    others = np.linalg.norm(residual - toward * aside[:, np.newaxis], axis=1)
    turned = np.linalg.norm(rounding, axis=1) + SVD_ROUNDING * EPS
    away = 2.0 * others / singular[:, 1] + (singular[:, 2] + turned) / abs(bend)
    most = np.linalg.norm(bend_of_equations(rows) / norms, axis=1)
    error = dot(abs(y), rounding) + (most * away + turned) * away
    allowed = tolerance * abs(turned_by(local.by_joints.swapaxes(1, 2), y)).sum(axis=1)
    merged = ~lost & (tolerance > 0.0) & (abs(height) + error <= allowed)
    hidden = ~lost & ~merged & ~(abs(height) > error)
    apart = ~lost & ~merged & ~hidden & (height * bend < 0.0)
    reach = np.sqrt(-2.0 * height / bend)
    return Folds(directions, free, reach, merged, apart, lost, hidden)


def split(rows: Rows, row: Integers, near: Folds, which: Mask) -> tuple[Array, Mask]:
    """The two modes (2, K, 2, 3) beside some of the folds, and where both are sure (2, K).

    The nearer two modes are, the less sharply rounding leaves them defined; what counts is
    that each stays on its side of the fold.
    """
    center, reach = near.directions[which], np.tile(near.reach[which], 2)
    turn = near.reach[which][:, np.newaxis] * near.free[which]
    start = np.concatenate([turn_by(center, turn), turn_by(center, -turn)])
    own = np.tile(row[which], 2)
    directions, converged = polished(rows, own, start, SIDE * reach)
    sure = converged & _beside(directions, start, reach)
    again = np.flatnonzero(~sure)
    directions[again], converged[again] = _sharpened(
        rows[own[again]], start[again], SIDE * reach[again]
    )
    sure = converged & _beside(directions, start, reach)
    return directions.reshape(2, -1, 2, 3), sure.reshape(2, -1)


def _beside(directions: Array, start: Array, reach: Array) -> Mask:
    """Where Newton's method stayed on its side."""
    moved: Mask = abs(directions - start).max(axis=(1, 2), initial=0.0) <= 0.5 * reach
    return moved


def _sharpened(rows: Rows, directions: Array, allowed: Array) -> tuple[Array, Mask]:
    """Newton's method with the sharp equations, one a row, and where it converged."""
    size = np.full(len(directions), np.inf)
    for _ in range(SHARP_STEPS if len(directions) else 0):
        gradient = kernels.fold(rows.radius, rows.joints, directions).gradient
        residual = np.array([sharp.closure(rows[[k]], own)[0] for k, own in enumerate(directions)])
        turn = _solved(gradient, -residual)
        directions = turn_by(directions, turn)
        size = np.linalg.norm(turn, axis=1)
    return directions, size <= allowed
