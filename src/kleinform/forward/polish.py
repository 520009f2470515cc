"""From an angle of the base leg to an assembly mode: Newton's method."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import Circles, Rows, Vectors, turned
from kleinform.generated import kernels
from kleinform.sums import dot

__all__ = [
    "on_leg",
    "polished",
    "relabelled",
    "relabelled_back",
    "starts",
    "turn_by",
    "unlabelled",
]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

STEPS = 6
#: Newton's last step in angle when it has converged: the next one would be its square.
CONVERGED = 1e-9
#: Where it has not to be looked at one by one, it goes on until a step is rounding.
SETTLED = 1e-14


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


def turn_by(directions: Array, turn: Array) -> Array:
    """Directions (K, 2, 3) turned by Cayley's rotation of some small rotation vectors."""
    half = 0.5 * turn[:, np.newaxis]
    inner = directions + np.cross(half, directions)
    factor = 2.0 / (1.0 + dot(half, half))
    moved: Array = directions + factor[:, :, np.newaxis] * np.cross(half, inner)
    return moved
