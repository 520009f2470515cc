"""Checks of the arguments of loci."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, ShapeError
from kleinform.screening import (
    LARGEST,
    RotationLike,
    Screen,
    is_whole,
    real_array,
    reject_bad_numbers,
    reject_bad_rotations,
    rotation_array,
)

__all__ = ["box", "cells", "one_radius", "positions", "rotations"]

Array = NDArray[np.float64]

#: More cells along an edge are refused: a billion of nodes.
MOST_CELLS = 1000


class HasRadius(Protocol):
    """What is asked of a manipulator."""

    @property
    def radius(self) -> Array: ...


def box(name: str, bounds: ArrayLike, axes: int) -> Array:
    """The bounds ``(low, high)`` of a box, (2, axes), checked.

    Raises
    ------
    InputError
        Not low < high everywhere, or not finite.
    """
    found = real_array(name, bounds, (2, axes))
    if found.ndim != 2 or not (abs(found) <= LARGEST).all() or not (found[0] < found[1]).all():
        raise InputError(f"{name}: (low, high) with low < high is needed, {bounds!r} arrived")
    return found


def cells(name: str, count: int) -> int:
    """A number of cells, checked.

    Raises
    ------
    InputError
    """
    if not is_whole(count) or not 1 <= count <= MOST_CELLS:
        raise InputError(f"{name}: a whole number 1 to {MOST_CELLS} is needed, {count!r} arrived")
    return int(count)


def one_radius(robot: HasRadius) -> float:
    """The radius of a manipulator that has one.

    Raises
    ------
    ShapeError
    """
    if robot.radius.ndim:
        raise ShapeError(f"radius: one number is needed, {robot.radius.shape} arrived")
    return float(robot.radius)


def positions(value: ArrayLike, name: str = "position") -> Array:
    """Positions (..., 3), or other vectors, checked.

    Raises
    ------
    InputError
    """
    found = real_array(name, value, (3,))
    screen = Screen(found.shape[:-1], "raise")
    reject_bad_numbers(screen, name, found, 1)
    screen.settle()
    return found


def rotations(value: RotationLike) -> Array:
    """Rotations (..., 3, 3), checked.

    Raises
    ------
    InputError
    """
    found, tolerance = rotation_array("rotation", value)
    screen = Screen(found.shape[:-2], "raise")
    reject_bad_rotations(screen, "rotation", found, tolerance)
    screen.settle()
    return found
