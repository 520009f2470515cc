"""Poses from what other software gives: quaternions, 4×4 matrices, rotations that were rounded."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, NotARotationError
from kleinform.screening import (
    Errors,
    HasMatrix,
    RotationLike,
    Screen,
    allowed_defect,
    real_array,
    reject_bad_numbers,
    reject_bad_rotations,
    rotation_array,
)

__all__ = [
    "PositionAndRotation",
    "nearest_rotation",
    "pose_from_matrix",
    "rotation_from_quaternion",
]

Array = NDArray[np.float64]

#: Relative to the largest: a smaller singular value of a 3×3 matrix may be nothing but rounding.
RANK = 3.0 * float(np.finfo(np.float64).eps)


class PositionAndRotation(NamedTuple):
    """A pose: position ``(..., 3)`` [m] and rotation ``(..., 3, 3)`` of the platform."""

    position: Array
    rotation: Array


def rotation_from_quaternion(
    quaternion: ArrayLike, *, scalar_first: bool = False, errors: Errors = "raise"
) -> Array:
    """Rotation of a quaternion, ``x, y, z, w`` as in SciPy and ROS unless said otherwise.

    Parameters
    ----------
    quaternion : array_like (..., 4)
        The scalar part w is last. The length does not matter: Euler parameters are homogeneous.
    scalar_first : bool
        The order is ``w, x, y, z``, as in Eigen's constructor and MATLAB.
    errors : {"raise", "nan"}
        What happens for a quaternion that is zero, NaN or inf.

    Returns
    -------
    array (..., 3, 3)

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError
    NotARotationError
        The quaternion is zero.

    Examples
    --------
    >>> kleinform.rotation_from_quaternion([0, 0, 1, 1])  # a quarter turn about Z
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    given = real_array("quaternion", quaternion, (4,))
    screen = Screen(given.shape[:-1], errors)
    reject_bad_numbers(screen, "quaternion", given, 1)
    largest = abs(given).max(axis=-1, keepdims=True)
    rule = "quaternion: zero is no rotation"
    screen.reject(largest[..., 0] == 0.0, NotARotationError, rule, given, 1)
    screen.settle()
    with np.errstate(invalid="ignore"):  # only in rows that are refused
        parts = np.moveaxis(given / largest, -1, 0)
        w, x, y, z = parts if scalar_first else parts[[3, 0, 1, 2]]
        entries = (
            *(w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
            *(2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)),
            *(2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z),
        )
        square = w * w + x * x + y * y + z * z
        rotation = np.stack([entry / square for entry in entries], axis=-1)
    rotation = rotation.reshape(*screen.lead, 3, 3)
    screen.blank(rotation)
    return rotation


def pose_from_matrix(
    matrix: ArrayLike | HasMatrix, *, errors: Errors = "raise"
) -> PositionAndRotation:
    """Position and rotation of a homogeneous transformation ``[[R, c], [0, 1]]``.

    Parameters
    ----------
    matrix : array_like (..., 4, 4), or anything with ``as_matrix()``
        From the platform's frame to the base frame; lengths in m.
    errors : {"raise", "nan"}
        What happens for a matrix that is no such transformation.

    Returns
    -------
    PositionAndRotation
        Positions (..., 3) and rotations (..., 3, 3), as most calls take them:
        ``robot.inverse_displacement(*pose_from_matrix(matrix))``.

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError, NotARotationError
    InputError
        The last row is not (0, 0, 0, 1), to within 1e-9 (2e-6 if float32).

    Examples
    --------
    >>> matrix = [[1, 0, 0, 0.25], [0, 1, 0, 0.2], [0, 0, 1, 1], [0, 0, 0, 1]]
    >>> pose = kleinform.pose_from_matrix(matrix)
    >>> pose.position
    array([0.25, 0.2 , 1.  ])
    """
    given = matrix.as_matrix() if isinstance(matrix, HasMatrix) else matrix
    array, tolerance = real_array("matrix", given, (4, 4)), allowed_defect(given)
    screen = Screen(array.shape[:-2], errors)
    reject_bad_numbers(screen, "matrix", array, 2)
    off = abs(array[..., 3, :] - [0.0, 0.0, 0.0, 1.0]).max(axis=-1)
    rule = f"matrix: the last row must be (0, 0, 0, 1) (to within {tolerance})"
    screen.reject(off > tolerance, InputError, rule, off)
    pose = PositionAndRotation(array[..., :3, 3].copy(), array[..., :3, :3].copy())
    reject_bad_rotations(screen, "matrix", pose.rotation, tolerance)
    screen.blank(*pose)
    return pose


def nearest_rotation(matrix: RotationLike, *, errors: Errors = "raise") -> Array:
    """The rotation nearest to a matrix, such as a rotation that was rounded to few digits.

    It is ``U Vᵀ`` of the singular value decomposition ``U Σ Vᵀ``, the rotation of the polar
    decomposition: no other one has a smaller sum of squared differences of entries.

    Parameters
    ----------
    matrix : array_like (..., 3, 3), or anything with ``as_matrix()``
    errors : {"raise", "nan"}
        What happens for a matrix that is singular, or a reflection, or not finite.

    Returns
    -------
    array (..., 3, 3)

    Raises
    ------
    ShapeError, DtypeError, NotFiniteError
    NotARotationError
        The matrix is singular, to within 3 eps of its largest singular value, or its
        determinant is negative: a frame that is left-handed is no rotation that was rounded.

    Examples
    --------
    >>> kleinform.nearest_rotation([[0.707, -0.707, 0], [0.707, 0.707, 0], [0, 0, 1]]).round(9)
    array([[ 0.70710678, -0.70710678,  0.        ],
           [ 0.70710678,  0.70710678,  0.        ],
           [ 0.        ,  0.        ,  1.        ]])
    """
    array, _ = rotation_array("matrix", matrix)
    screen = Screen(array.shape[:-2], errors)
    reject_bad_numbers(screen, "matrix", array, 2)
    screen.settle()
    finite = np.where(screen.valid[..., np.newaxis, np.newaxis], array, np.eye(3))
    left, values, right = np.linalg.svd(finite)
    singular = values[..., 2] <= RANK * values[..., 0]
    screen.reject(singular, NotARotationError, "matrix: singular", values[..., 2])
    sign = np.linalg.det(left) * np.linalg.det(right)
    rule = "matrix: a reflection, its determinant is negative"
    screen.reject((sign < 0.0) & ~singular, NotARotationError, rule, sign * values.prod(axis=-1))
    # Sums of three products, not of a library: the same bits alone and in a batch.
    first, second, third = (
        left[..., :, k, np.newaxis] * right[..., np.newaxis, k, :] for k in range(3)
    )
    rotation: Array = first + second + third
    screen.blank(rotation)
    return rotation
