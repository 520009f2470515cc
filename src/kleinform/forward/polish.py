"""From an angle of the base leg to an assembly mode: Newton's method, and folds.

A fold is where two modes meet: the three gradients G_i of the closure equations by a turn
of the platform are coplanar. Near one, along the direction ``v`` that they leave free,
``y·F`` is a parabola ``height + bend s²/2``. Its height decides: of one sign there are two
modes, of the other none, and within what the joint values' tolerance can move it the two
have merged.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import Circles, Rows, Vectors, turned
from kleinform.generated import kernels
from kleinform.sums import dot, turned_by

__all__ = [
    "Folds",
    "folds",
    "on_leg",
    "polished",
    "relabelled",
    "relabelled_back",
    "split",
    "starts",
    "unlabelled",
]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
STEPS = 6
FOLD_STEPS = 8
#: Newton's last step in angle when it has converged: the next one would be its square.
CONVERGED = 1e-9
#: Where it has not to be looked at one by one, it goes on until a step is rounding.
SETTLED = 1e-14
#: A mode beside a fold has converged when Newton's last step is below this, relative to its
#: distance from the fold.
SIDE = 0.05
#: Rounding of the height of a fold, in eps times what a relative change of all joint values
#: by 1 does to it: 0.14 at the median of random folds, 2.2 at most.
ROUNDING = 4.0
#: A fold is where the second singular value of G is above this, relative to the first.
CORANK_ONE = 1e-5


def starts(rows: Rows, circles: Circles, row: Integers, psi: Array) -> tuple[Array, Array]:
    """Cosine and sine of the base leg's angle at zeros psi of the eliminants, and n_1, n_2.

    The limbs are relabelled: the base is limb 1.
    """
    angle = circles.leg(row, psi)
    turn = kernels.half_turn(
        rows.radius[row],
        circles.position[row],
        circles.lengths[row],
        angle,
        circles.reference(row, rows.radius, angle),
    )
    # Both rows of the adjugate are along (x³, x²y, xy², y³); the longer one has it best.
    squares = dot(turn.powers, turn.powers)
    first = (squares[:, 0] >= squares[:, 1])[:, np.newaxis]
    powers = np.where(first, turn.powers[:, 0], turn.powers[:, 1])
    half = np.where(first, powers[:, :2], powers[:, 2:])
    return angle, kernels.turned_directions(turn.frame, half).directions


def on_leg(
    rows: Rows, circles: Circles, row: Integers, angle: Array, directions: Array
) -> tuple[Array, Array, Array, Mask]:
    """Newton's method in the angle of the base leg and the turn about n_1.

    Returns the angle, n_1 and n_2 (K, 2, 3), the distance from C to B of the base limb, and
    where it converged; relabelled as in `starts`.
    """
    angle, directions = angle.copy(), directions.copy()
    distance, size = np.empty(len(row)), np.full(len(row), np.inf)
    active = np.arange(len(row))
    for _ in range(STEPS):
        own = row[active]
        step = kernels.leg_step(
            rows.radius[own],
            circles.position[own],
            circles.lengths[own],
            angle[active],
            directions[active, 1],
        )
        angle[active], directions[active] = step.angle, step.directions
        distance[active], size[active] = step.extension, abs(step.steps).max(axis=1, initial=0.0)
        active = active[~(size[active] <= CONVERGED)]
        if not len(active):
            break
    return angle, directions, distance, size <= CONVERGED


def relabelled_back(directions: Array, base: Integers) -> Array:
    """n_1 and n_2 of the platform from those that `starts` and `on_leg` give."""
    return unlabelled(turned(directions, base, back=True), base)


def relabelled(directions: Vectors, base: Integers) -> Vectors:
    """The inverse of `relabelled_back`."""
    three = np.concatenate([directions, -directions.sum(axis=1, keepdims=True)], axis=1)
    order = (base[:, np.newaxis] + np.arange(2)) % 3
    return turned(np.take_along_axis(three, order[:, :, np.newaxis], axis=1), base)


def unlabelled(directions: Vectors, base: Integers) -> Vectors:
    """n_1, n_2 from the directions of the base limb and the one after it."""
    own, following = directions[:, 0], directions[:, 1]
    ordered = np.stack([own, following, -own - following], axis=1)
    order = (np.arange(2) - base[:, np.newaxis]) % 3
    return np.take_along_axis(ordered, order[:, :, np.newaxis], axis=1)


def polished(
    rows: Rows, row: Integers, directions: Array, allowed: Array | float
) -> tuple[Array, Mask]:
    """Newton's method to the end, and where its last step is within what is allowed."""
    directions, size = directions.copy(), np.full(len(row), np.inf)
    active = np.arange(len(row))
    for _ in range(STEPS):
        own = row[active]
        step = kernels.newton_step(
            rows.radius[own], rows.position[own], rows.lengths[own], directions[active]
        )
        directions[active] = step.next
        size[active] = np.max(abs(step.turn), axis=1, initial=0.0)
        active = active[~(size[active] <= SETTLED)]
        if not len(active):
            break
    return directions, size <= allowed


@dataclass(frozen=True)
class Folds:
    """Folds that were found: directions at each, and its parabola.

    ``merged`` where the tolerance covers the height, ``apart`` where there are two modes at
    ``±reach`` along ``free``, ``lost`` where no fold was found or rounding hides the height.
    """

    directions: Array
    free: Array
    reach: Array
    merged: Mask
    apart: Mask
    lost: Mask


def folds(rows: Rows, row: Integers, directions: Array, tolerance: float) -> Folds:
    """Find the fold nearest to some directions, and decide on which side of it the row is."""
    radius, joints = rows.radius[row], rows.joints[row]
    aside = np.zeros(len(row))
    toward = None
    for _ in range(FOLD_STEPS):
        local = kernels.fold(radius, joints, directions)
        if toward is None:
            toward = _left(local.gradient)
        matrix = np.zeros((len(row), 4, 4))
        matrix[:, :3, :3], matrix[:, :3, 3] = local.gradient, -toward
        matrix[:, 3, :3] = local.volume_gradient
        side = np.concatenate(
            [local.residual - aside[:, np.newaxis] * toward, local.volume[:, np.newaxis]], axis=1
        )
        step = _solved(matrix, -side)
        directions = turn_by(directions, step[:, :3])
        aside = aside + step[:, 3]
    return _judged(kernels.fold(radius, joints, directions), directions, step, tolerance)


def _left(gradient: Array) -> Array:
    """The unit combination y of the closure equations that a turn changes least."""
    return np.linalg.svd(np.where(np.isfinite(gradient), gradient, 0.0))[0][:, :, 2]


def _solved(matrix: Array, side: Array) -> Array:
    """Solutions of small systems, NaN where one is singular."""
    good = np.asarray(np.isfinite(matrix).all((1, 2)) & np.isfinite(side).all(1))
    good[good] = np.linalg.det(matrix[good]) != 0.0
    result = np.full(side.shape, np.nan)
    result[good] = np.linalg.solve(matrix[good], side[good][..., np.newaxis])[..., 0]
    return result


def _judged(local: kernels.Fold, directions: Array, step: Array, tolerance: float) -> Folds:
    finite = np.asarray(np.isfinite(local.gradient).all((1, 2)) & np.isfinite(step).all(1))
    left, singular, right = np.linalg.svd(
        np.where(finite[:, np.newaxis, np.newaxis], local.gradient, 0.0)
    )
    y, free = left[:, :, 2], right[:, 2]
    sign = np.sign(np.linalg.det(left) * np.linalg.det(right))
    with np.errstate(divide="ignore", invalid="ignore"):
        bend = dot(local.volume_gradient, free) * sign
        bend /= singular[:, 0] * singular[:, 1]
        height = dot(y, local.residual)
        moved = turned_by(local.by_joints.swapaxes(1, 2), y)
        scale = abs(moved).sum(axis=1)
        reach = np.sqrt(-2.0 * height / bend)
        lost = ~finite | ~(np.linalg.norm(step[:, :3], axis=1) <= 1e-9)
        lost |= ~(singular[:, 1] >= CORANK_ONE * singular[:, 0]) | ~(abs(bend) > 0.0)
    merged = ~lost & (tolerance > 0.0) & (abs(height) <= tolerance * scale)
    # Rounding hides on which side of the fold the row is.
    lost |= ~merged & (abs(height) <= ROUNDING * EPS * scale)
    apart = ~lost & ~merged & (height * bend < 0.0)
    return Folds(directions, free, reach, merged, apart, lost)


def split(rows: Rows, row: Integers, near: Folds, which: Mask) -> tuple[Array, Mask]:
    """The two modes (2, K, 2, 3) beside some of the folds, and where both are sure (2, K).

    The nearer two modes are, the less sharply rounding leaves them defined; what counts is
    that each stays on its side of the fold.
    """
    center, reach = near.directions[which], near.reach[which]
    turn = reach[:, np.newaxis] * near.free[which]
    start = np.concatenate([turn_by(center, turn), turn_by(center, -turn)])
    allowed = np.tile(SIDE * reach, 2)
    directions, converged = polished(rows, np.tile(row[which], 2), start, allowed)
    moved = abs(directions - start).max(axis=(1, 2))
    sure = converged & (moved <= np.tile(reach, 2) * 0.5)
    return directions.reshape(2, -1, 2, 3), sure.reshape(2, -1)


def turn_by(directions: Array, turn: Array) -> Array:
    """Directions (K, 2, 3) turned by Cayley's rotation of some small rotation vectors."""
    half = 0.5 * turn[:, np.newaxis]
    inner = directions + np.cross(half, directions)
    factor = 2.0 / (1.0 + dot(half, half))
    moved: Array = directions + factor[:, :, np.newaxis] * np.cross(half, inner)
    return moved
