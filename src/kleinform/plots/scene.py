"""The points of the robot at a pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import ShapeError
from kleinform.generated import kernels
from kleinform.manipulator import UncoupledManipulator
from kleinform.screening import RotationLike, one_rotation, real_array

__all__ = ["STAR", "Scene", "scene"]

Array = NDArray[np.float64]
ANGLES = np.radians([0.0, 120.0, 240.0])
#: u_i in the base frame, and n_i in the platform's, a row each.
STAR = np.stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros(3)], axis=1)


class Scene(NamedTuple):
    """What a pose is drawn from, a row for each limb where there are three.

    Attributes
    ----------
    radius : float
        a [m].
    centre : array (3,)
        C [m].
    rotation : array (3, 3)
    directions : array (3, 3)
        n_1, n_2, n_3.
    base, platform, ends : array (3, 3)
        A_i, B_i and D_i [m].
    """

    radius: float
    centre: Array
    rotation: Array
    directions: Array
    base: Array
    platform: Array
    ends: Array


def scene(robot: UncoupledManipulator, position: ArrayLike, rotation: RotationLike) -> Scene:
    """The points of one pose of one robot.

    Raises
    ------
    SingularPoseError
        ``n_i·u_i = 0`` (B_i is at infinity), or C at O.
    InputError
    """
    centre, turned = real_array("position", position, (3,)), one_rotation("rotation", rotation)
    if robot.radius.ndim or centre.ndim > 1:
        raise ShapeError(
            f"one radius and a position (3,) are needed, {robot.radius.shape} and "
            f"{centre.shape} arrived"
        )
    # Refuses the poses that have no points; q4 is not drawn, so on the Z axis any will do.
    robot.inverse_displacement(centre, turned, azimuth=0.0)
    extension = robot.survey(centre, turned).extension
    radius, directions = float(robot.radius), STAR @ turned.T
    platform = centre + extension[:, np.newaxis] * directions
    ends = kernels.limb_geometry(radius, centre, turned).d
    return Scene(radius, centre, turned, directions, radius * STAR, platform, ends)
