"""The positions of the platform that keep every limit while its orientation stays the same."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import frexp

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, SingularPoseError
from kleinform.generated import kernels
from kleinform.limits import Limits
from kleinform.manipulator import UncoupledManipulator
from kleinform.maps.components import Components, components_of
from kleinform.maps.emptiness import excluding
from kleinform.maps.lines import inside
from kleinform.maps.mesh import Mesh, mesh_of
from kleinform.maps.patches import extent
from kleinform.maps.quadrics import Constraint, constraints_of, slabs_of
from kleinform.maps.section import Section, section_of
from kleinform.maps.volume import Volume, volume_of
from kleinform.pose import LIMBS, RULES
from kleinform.screening import RotationLike, is_whole, one_rotation, real_array
from kleinform.zero import threshold, within

__all__ = ["Workspace", "constant_orientation_workspace"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Workspace:
    """The constant-orientation workspace; made by `constant_orientation_workspace`.

    It is bounded by quadrics: elliptic cylinders along n_i where q_i is at an end of its range,
    planes for e_i and q4, spheres for q6, cones for q5. Everything is in the base frame, in m.

    Attributes
    ----------
    radius : float
        Radius a of the base circle [m].
    rotation : array (3, 3)
        Taken as it is: its columns need not be exactly orthonormal.
    limits : Limits
    """

    radius: float
    rotation: Array
    limits: Limits

    @cached_property
    def constraints(self) -> list[Constraint]:
        """Every finite end of a range as a quadric, in float64."""
        return constraints_of(self.radius, self.rotation, self.limits)

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """The corners (3,), (3,) of a box that holds the workspace, not the least one [m].

        Raises
        ------
        InputError
            The ranges leave the workspace unbounded, or are not known to bound it: high ends
            of q1, q2, q3, q6 and ranges of e1, e2, e3 are looked at.
        """
        slabs = slabs_of(self.radius, self.rotation, self.limits)
        low, high = np.array([extent(slabs, axis) for axis in np.eye(3)]).T
        return low, np.maximum(low, high)

    @cached_property
    def _unit(self) -> float:
        """A power of two near the size of the box [m].

        Lengths in this unit are exact, and numbers of unit 1, m and m² may be compared.
        """
        size = float(max(abs(corner).max() for corner in self.box))
        return 2.0 ** frexp(size)[1] if size > 0.0 else 1.0

    @cached_property
    def _in_units(self) -> Workspace:
        """The same with its lengths in units."""
        unit = self._unit
        ranges = {
            name: ends if name in ("q4", "q5") else (ends[0] / unit, ends[1] / unit)
            for name, ends in self.limits.ranges.items()
        }
        return Workspace(self.radius / unit, self.rotation, Limits(ranges))

    def contains(self, positions: ArrayLike) -> Mask:
        """Which positions (..., 3) keep every limit, as a mask (...)."""
        return inside(self.constraints, real_array("positions", positions, (3,)))

    def conflict(self) -> tuple[str, ...]:
        """Why there is no position: limits that exclude each other, such as ``"q1 low"``.

        Named as by `Limits.room`. None of them can be left out: without it there would be
        positions, or the rest would not bound the workspace, or miss a position by so little
        that it is not sure. Ends of q4 go together.

        Returns
        -------
        tuple of str
            Empty where there are positions, or where it is not sure that there are none, as
            where surfaces touch.

        Raises
        ------
        InputError
            As `box`.
        """
        inner = self._in_units
        return excluding(inner.radius, inner.rotation, inner.limits)

    def section(self, z: float) -> Section:
        """The section by the plane at height z [m]: closed loops of arcs of conics.

        Every conic is cut where it meets the others, and the arcs are kept on which all other
        limits hold. Exact up to float64: curves that touch, or three through one point, to
        within about 1e-7 radii may be taken for such that cross, or the other way round.

        Raises
        ------
        InputError
            As `box`, or z is not one finite number.
        """
        height = real_array("z", z, ())
        if height.ndim or not np.isfinite(height):
            raise InputError(f"z: one finite number is needed, {z!r} arrived")
        inner, unit = self._in_units, self._unit
        low, high = inner.box
        far = np.maximum(abs(low), abs(high))
        reach = float(np.hypot(far[0], far[1]))
        return section_of(inner.constraints, float(height) / unit, reach).enlarged(unit)

    def volume(self, relative: float = 1e-6) -> Volume:
        """The volume, with a proven bound of its error (extra ``certify``).

        The volume is what the field (0, 0, z) carries through the boundary. On each quadric
        the piece that bounds the workspace is found and integrated in small panels, and
        what is not proven in one of them counts as an error. Proven for the inputs as they
        are, in float64 with bounds of all roundings, if NumPy's cosine and sine are right to
        a hundred units in the last place.

        Parameters
        ----------
        relative : float
            The relative error to reach, from 1e-9 to 1. Where surfaces touch along a curve, or
            two limits have the same surface, it may be out of reach: `Volume.proven` tells.

        Returns
        -------
        Volume

        Raises
        ------
        MissingExtraError
            python-flint is not installed.
        InputError
            As `box`, or ``relative`` is smaller.
        """
        wanted = real_array("relative", relative, ())
        if wanted.ndim or not 1e-9 <= wanted < 1.0:
            raise InputError(f"relative: from 1e-9 to 1 is needed, {relative!r} arrived")
        inner, cube = self._in_units, self._unit**3
        found = volume_of(inner.radius, inner.rotation, inner.limits, float(wanted))
        return Volume(cube * found.value, cube * found.error, found.proven, found.panels)

    def components(self, lines: int = 64) -> Components:
        """The connected pieces, by ``lines`` vertical lines along the longer side of `box`.

        Raises
        ------
        InputError
            As `box`, or ``lines`` is no positive number.
        """
        return components_of(self.constraints, *self.box, _positive("lines", lines))

    def mesh(self, resolution: int = 64) -> Mesh:
        """A closed mesh of the boundary, ``resolution`` cells along the longest side of `box`.

        Raises
        ------
        InputError
            As `box`, or ``resolution`` is no positive number.
        """
        return mesh_of(self.constraints, *self.box, _positive("resolution", resolution))


def constant_orientation_workspace(
    robot: UncoupledManipulator, rotation: RotationLike, limits: Limits
) -> Workspace:
    """The positions of the platform's centre that keep every limit at one orientation.

    Parameters
    ----------
    robot : UncoupledManipulator
        With one radius.
    rotation : array_like (3, 3), or anything with ``as_matrix()``
        Rotation of the platform.
    limits : Limits
        Ranges of joints and extensions, no margins: `UncoupledManipulator.watch` alone takes
        those. A range of q4 is one modulo 2π.

    Returns
    -------
    Workspace

    Raises
    ------
    SingularPoseError
        ``n_i·u_i = 0``: B_i is not defined at any position.
    InputError
        There are margins, which no quadrics bound, or more than one radius, or the rotation
        is none.
    """
    if robot.radius.ndim:
        raise InputError(f"radius: one is needed, shape {robot.radius.shape} arrived")
    if not isinstance(limits, Limits):
        raise InputError(f"limits: Limits are needed, {limits!r} arrived")
    if limits.margins:
        raise InputError(
            f"limits: margins are not bounded by quadrics, {', '.join(limits.margins)} arrived: "
            "a workspace takes ranges alone, robot.watch takes margins too"
        )
    turned = one_rotation("rotation", rotation)
    incidence = kernels.direct_locus(robot.radius, turned).incidence
    for i in np.flatnonzero(within(incidence, 1.0, threshold(robot.rounding))):
        p = float(incidence[i])
        raise SingularPoseError(f"{RULES[LIMBS[i]]}; {p!r} arrived")
    return Workspace(float(robot.radius), turned.copy(), limits)


def _positive(name: str, value: int) -> int:
    if not (is_whole(value) and value > 0):
        raise InputError(f"{name}: a positive integer is needed, {value!r} arrived")
    return int(value)
