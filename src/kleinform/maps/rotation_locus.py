"""The direct singularities at one position: where a polynomial of degree twelve vanishes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kleinform.errors import InputError, ShapeError
from kleinform.generated import kernels
from kleinform.manipulator import UncoupledManipulator
from kleinform.maps.checks import box, cells, one_radius, positions, rotations
from kleinform.maps.zeros import Triangles, zero_mesh
from kleinform.results import Array
from kleinform.screening import RotationLike, real_array
from kleinform.sums import product

__all__ = ["OrientationLocus", "orientation_locus"]


@dataclass(frozen=True, eq=False)
class OrientationLocus:
    """The direct singularities at one position: rotations.

    Attributes
    ----------
    radius : float
        [m]
    position : array (3,)
        C [m].
    """

    radius: float
    position: Array
    #: Of the polynomial in the Euler parameters, and in Rodrigues's.
    degree = 12

    def value(self, rotation: RotationLike) -> Array:
        """``(p_1 p_2 p_3)² orientation / (√3/2)`` [m³] at rotations (..., 3, 3): no division."""
        found: Array = self._evaluated(rotations(rotation)).value[()]
        return found

    def gradient(self, rotation: RotationLike) -> Array:
        """Its derivative by a turn of the platform [m³], a vector (..., 3) in the base frame."""
        found: Array = self._evaluated(rotations(rotation)).by_turn
        return found

    def polynomial(self, rodrigues: ArrayLike) -> tuple[Array, Array]:
        """The polynomial of degree twelve in Rodrigues's parameters, and its gradient.

        Parameters
        ----------
        rodrigues : array_like (..., 3)
            Axis times the tangent of half the angle.

        Returns
        -------
        value : array (...)
            ``(1 + |g|²)⁶`` times `value` [m³].
        gradient : array (..., 3)
            By the parameters [m³].
        """
        g = positions(rodrigues, "rodrigues")
        result = self._evaluated(_from_rodrigues(g))
        square = 1.0 + (g * g).sum(axis=-1)
        # A change of g turns the platform by 2 (dg + g × dg) / (1 + |g|²).
        turned = 2.0 * (result.by_turn + np.cross(result.by_turn, g))
        radial = 12.0 * result.value[..., np.newaxis] * g
        fourth = square * square * square * square
        fifth = (fourth * square)[..., np.newaxis]
        return (fourth * square * square * result.value)[()], fifth * (turned + radial)

    def mesh(self, bounds: ArrayLike, resolution: int) -> Triangles:
        """The surface in a box of Rodrigues's parameters, its vertices on it to rounding.

        Parameters
        ----------
        bounds : array_like (2, 3)
            Lowest and highest corner; half turns are at infinity.
        resolution : int
            Cells along each edge. Sheets that are nearer to each other may be missed.

        Raises
        ------
        InputError
        """
        limits, count = box("bounds", bounds, 3), cells("resolution", resolution)
        return zero_mesh(lambda g: self._evaluated(_from_rodrigues(g)).value, limits, count)

    def wrist_normals(self, angle: ArrayLike) -> Array:
        """Unit normals ν (..., 3) of the platform with ``ν·c = 0``: all of them, by an angle.

        Raises
        ------
        InputError
            C at O: every normal is.
        """
        length = np.linalg.norm(self.position)
        if length == 0.0:
            raise InputError("position: C at O, where every normal is perpendicular to it")
        first = np.linalg.svd(self.position[np.newaxis])[2][1]
        second = np.cross(self.position / length, first)
        at = real_array("angle", angle, ())[..., np.newaxis]
        found: Array = np.cos(at) * first + np.sin(at) * second
        return found

    def _evaluated(self, rotation: Array) -> Any:
        return kernels.orientation_locus(np.float64(self.radius), self.position, rotation)


def orientation_locus(robot: UncoupledManipulator, position: ArrayLike) -> OrientationLocus:
    """The rotations that are direct singularities with C at one position, equation (27).

    Parameters
    ----------
    robot : UncoupledManipulator
        Of one radius.
    position : array_like (3,)
        C [m].

    Returns
    -------
    OrientationLocus

    Raises
    ------
    InputError
    """
    place = positions(position)
    if place.ndim != 1:
        raise ShapeError(f"position: shape (3,) is needed, {place.shape} arrived")
    return OrientationLocus(one_radius(robot), place)


def _from_rodrigues(g: Array) -> Array:
    """Rotations (..., 3, 3) by Cayley's formula."""
    skew = np.zeros((*g.shape[:-1], 3, 3))
    skew[..., [2, 0, 1], [1, 2, 0]] = g
    skew = skew - np.swapaxes(skew, -1, -2)
    square = 1.0 + (g * g).sum(axis=-1)
    found: Array = np.eye(3) + (2.0 / square)[..., np.newaxis, np.newaxis] * (
        skew + product(skew, skew)
    )
    return found
