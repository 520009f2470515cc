"""Rotations: from roll, pitch and yaw (9), from platform directions (8), and back."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import NotARotationError
from kleinform.generated import kernels
from kleinform.screening import (
    Errors,
    RotationLike,
    Screen,
    allowed_defect,
    lead_of,
    real_array,
    reject_bad_numbers,
    reject_bad_rotations,
    rotation_array,
)
from kleinform.sums import dot

__all__ = ["RollPitchYaw", "rotation_from_directions", "rotation_from_rpy", "rpy_from_rotation"]

Array = NDArray[np.float64]


class RollPitchYaw(NamedTuple):
    """Angles in radians, each ``(...)``: γ about X first, β about Y, α about Z last."""

    roll: Array
    pitch: Array
    yaw: Array


def rotation_from_rpy(
    *, roll: ArrayLike, pitch: ArrayLike, yaw: ArrayLike, errors: Errors = "raise"
) -> Array:
    """Rotation ``R = Rz(yaw) Ry(pitch) Rx(roll)``, equation (9).

    Parameters
    ----------
    roll, pitch, yaw : array_like (...)
        Angles in radians (γ, β, α of the paper); they broadcast.
    errors : {"raise", "nan"}
        What happens for an angle that is NaN or inf: an error, or a NaN rotation.

    Returns
    -------
    array (..., 3, 3)
        Columns are the platform's x axis n_1, its y axis and its normal, in the base frame.

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError
    """
    angles = {
        name: real_array(name, value, ())
        for name, value in (("roll", roll), ("pitch", pitch), ("yaw", yaw))
    }
    screen = Screen(lead_of({name: angle.shape for name, angle in angles.items()}), errors)
    for name, angle in angles.items():
        reject_bad_numbers(screen, name, angle, 0)
    rotation = kernels.rotation_from_rpy(**angles).rotation
    screen.blank(rotation)
    return rotation


def rpy_from_rotation(rotation: RotationLike, *, errors: Errors = "raise") -> RollPitchYaw:
    """Roll, pitch and yaw of a rotation, equation (9) solved.

    At pitch ±90° only yaw ∓ roll is defined. There yaw is zero where ``R_11 = R_21 = 0``
    exactly, and otherwise what these two entries say; roll follows, so that the angles give
    back the rotation in every case.

    Parameters
    ----------
    rotation : array_like (..., 3, 3), or anything with ``as_matrix()``
    errors : {"raise", "nan"}
        What happens for a matrix that is no rotation.

    Returns
    -------
    RollPitchYaw
        In radians; roll and yaw in [−π, π], pitch in [−π/2, π/2].

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError, NotARotationError
    """
    array, tolerance = rotation_array("rotation", rotation)
    screen = Screen(array.shape[:-2], errors)
    reject_bad_rotations(screen, "rotation", array, tolerance)
    angles = kernels.rpy_from_rotation(array)
    screen.blank(*angles)
    return RollPitchYaw(*(angle[()] for angle in angles))


def rotation_from_directions(n1: ArrayLike, n2: ArrayLike, *, errors: Errors = "raise") -> Array:
    """Rotation from the platform directions n_1 and n_2, equation (8) with unit columns.

    Parameters
    ----------
    n1, n2 : array_like (..., 3)
        Unit vectors from C to B_1 and B_2 in the base frame, 120° apart; they broadcast.
    errors : {"raise", "nan"}
        What happens for directions that break these rules.

    Returns
    -------
    array (..., 3, 3)

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError
    NotARotationError
        The directions are not unit vectors 120° apart, to within 1e-9 (2e-6 if float32).
    """
    first, second = real_array("n1", n1, (3,)), real_array("n2", n2, (3,))
    screen = Screen(lead_of({"n1": first.shape[:-1], "n2": second.shape[:-1]}), errors)
    reject_bad_numbers(screen, "n1", first, 1)
    reject_bad_numbers(screen, "n2", second, 1)
    gaps = (
        dot(first, first) - 1.0,
        dot(second, second) - 1.0,
        dot(first, second) + 0.5,
    )
    worst = np.maximum(np.maximum(abs(gaps[0]), abs(gaps[1])), abs(gaps[2]))
    tolerance = allowed_defect(n1, n2)
    screen.reject(
        ~(worst <= tolerance),
        NotARotationError,
        f"n1, n2: not unit vectors 120° apart (to within {tolerance})",
        worst,
    )
    rotation = kernels.rotation_from_directions(first, second).rotation
    screen.blank(rotation)
    return rotation
