"""Where the determinants vanish, as surfaces.

At one orientation the factor det[n_i × (d_i − c)] of det J_v vanishes on a cubic surface in the
position c, and the others on planes. The factors of det J_q vanish on lines and planes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError
from kleinform.generated import kernels
from kleinform.manipulator import UncoupledManipulator
from kleinform.maps.checks import box, cells, one_radius, positions
from kleinform.maps.cubics import DEGREES, cube, division, points_of, tensor_of
from kleinform.maps.zeros import Triangles, zero_curves, zero_mesh
from kleinform.results import Array
from kleinform.screening import RotationLike, is_whole, one_rotation
from kleinform.zero import EPS, threshold, within

__all__ = [
    "DirectLocus",
    "InverseLocus",
    "SignedBoxes",
    "direct_locus",
    "inverse_locus",
]

#: How far a coefficient is off, in units of a to its power, over what directions are known to:
#: it is a sum of three products of three.
SIZE = 9.0
#: Directions are known no better than this when a sign is proven: the kernel's own rounding.
LEAST = 16.0 * EPS
#: Rounding of an evaluation over eps, in units of its terms' sizes: more than it has steps.
STEPS = 64.0
#: Most boxes that may be open at once.
MOST_BOXES = 2_000_000
BASE_AXES = np.array([[1.0, 0.0, 0.0], [-0.5, np.sqrt(0.75), 0.0], [-0.5, -np.sqrt(0.75), 0.0]])
BASE_NORMALS = np.cross([0.0, 0.0, 1.0], BASE_AXES)


class SignedBoxes(NamedTuple):
    """Boxes that fill a box, each with the sign that the polynomial is proven to have in it.

    Attributes
    ----------
    low, high : array (N, 3)
        Corners [m].
    sign : int8 array (N,)
        1 or −1 in all of the box; 0 is undecided.
    """

    low: Array
    high: Array
    sign: NDArray[np.int8]


@dataclass(frozen=True, eq=False)
class DirectLocus:
    """The direct singularities of one orientation.

    Attributes
    ----------
    radius : float
        Radius a [m].
    rotation : array (3, 3)
    coefficients : array (20,)
        Of the cubic at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z,
        yz², z³; in m³, m², m, 1 by degree.
    incidence : array (3,)
        ``p_i = n_i·u_i``: ``(p_1 p_2 p_3)² orientation = √3/2 value``. Where one is 0, no pose
        has a B_i, but on the plane ``e_i = 0``.
    slack : float
        What directions are known to: ``rounding eps`` of the robot, and nine times the rotation's
        own defect. A coefficient of degree d counts as zero up to ``9 slack a^(3−d)``.
    """

    radius: float
    rotation: Array
    coefficients: Array
    incidence: Array
    slack: float

    @property
    def planes(self) -> dict[str, Array]:
        """The other factors: ``extension_i``, ``a − c·u_i``, and ``wrist``, ``√3/2 ν·c``.

        Each is (4,), the constant [m] and the normal: ``plane[0] + plane[1:]·c``.
        """
        found = {
            f"extension_{i + 1}": np.concatenate([[self.radius], -axis])
            for i, axis in enumerate(BASE_AXES)
        }
        found["wrist"] = np.concatenate([[0.0], np.sqrt(0.75) * self.rotation[:, 2]])
        return found

    @cached_property
    def kind(self) -> str:
        """What the cubic is, within rounding.

        "identically zero", "cubic", "plane and quadric", "double plane", "double plane and
        plane", or so many planes. Planes are looked for among those that are proven to occur:
        ``z = 0``, ``c·t_i = 0`` and ``c·u_i = a``; each is verified by division.
        """
        if self._is_zero(self._unit):
            return "identically zero"
        rest = self._divided[1]
        if len(rest) == 20:
            return "cubic"
        if len(rest) == 10:
            return "plane and quadric"
        distinct = len(self._distinct)
        if len(self.factors) > distinct:
            return ("double plane", "double plane and plane")[distinct - 1]
        return ("plane", "two planes", "three planes")[distinct - 1]

    @property
    def factors(self) -> Array:
        """The planes that divide the cubic, a row each as in `planes`, double ones twice."""
        if self._is_zero(self._unit):
            return np.empty((0, 4))
        planes, rest = self._divided
        if len(rest) == 4 and not self._is_zero(rest[1:]):
            planes = [*planes, rest / np.linalg.norm(rest[1:])]
        return np.array(planes).reshape(-1, 4) * self._scale

    def value(self, position: ArrayLike) -> Array:
        """The polynomial [m³] at positions (..., 3)."""
        points = points_of(positions(position))
        return np.asarray(cube(self._tensor, points))[()]

    def gradient(self, position: ArrayLike) -> Array:
        """Its derivative by the position [m²], (..., 3)."""
        points = points_of(positions(position))
        found: Array = 3.0 * np.einsum("abk,...a,...b->...k", self._tensor, points, points)[..., 1:]
        return found

    def signed_boxes(self, bounds: ArrayLike, depth: int) -> SignedBoxes:
        """Boxes in which the polynomial, and with it `orientation`, is proven to have one sign.

        Parameters
        ----------
        bounds : array_like (2, 3)
            Lowest and highest corner [m].
        depth : int
            How often an undecided box is cut in eight.

        Returns
        -------
        SignedBoxes
            The proof is a bound of the polynomial over the box by its Taylor series about the
            centre, with room for the rounding of the coefficients and of the bound itself.

        Raises
        ------
        InputError
        """
        if not is_whole(depth) or not 0 <= depth <= 20:
            raise InputError(f"depth: a whole number 0 to 20 is needed, {depth!r} arrived")
        low, high = box("bounds", bounds, 3)[:, np.newaxis]
        decided = []
        for level in range(int(depth) + 1):
            sign = self._proven(low, high)
            done = (sign != 0) if level < depth else np.ones(len(sign), dtype=bool)
            decided.append((low[done], high[done], sign[done]))
            if 8 * (~done).sum() > MOST_BOXES:
                raise InputError(f"depth: more than {MOST_BOXES} boxes at {depth!r}")
            low, high = _cut(low[~done], high[~done])
        return SignedBoxes(*(np.concatenate(parts) for parts in zip(*decided, strict=True)))

    def mesh(self, bounds: ArrayLike, resolution: int) -> Triangles:
        """The surface in a box, its vertices on it to rounding.

        Parameters
        ----------
        bounds : array_like (2, 3)
            Lowest and highest corner [m].
        resolution : int
            Cells along each edge. Sheets that are nearer to each other may be missed.

        Raises
        ------
        InputError
            Every position is singular, or an argument broke a rule.
        """
        limits = box("bounds", bounds, 3)
        return zero_mesh(self._reduced, limits, cells("resolution", resolution))

    def section(self, z: float, bounds: ArrayLike, resolution: int) -> list[Array]:
        """The curves at a height, as polylines (N, 3) with their points on it to rounding.

        Parameters
        ----------
        z : float
            [m]
        bounds : array_like (2, 2)
            Lowest and highest x and y [m].
        resolution
            As in `mesh`.

        Raises
        ------
        InputError
            As `mesh`.
        """
        height = float(positions([0.0, 0.0, z], "z")[2])

        def lifted(points: Array) -> Array:
            heights = np.full((*points.shape[:-1], 1), height)
            return np.concatenate([points, heights], axis=-1)

        limits, count = box("bounds", bounds, 2), cells("resolution", resolution)
        curves = zero_curves(lambda points: self._reduced(lifted(points)), limits, count)
        return [lifted(curve) for curve in curves]

    @cached_property
    def _tensor(self) -> Array:
        return tensor_of(self.coefficients)

    @property
    def _scale(self) -> Array:
        """Turns a plane in units of the radius into one in metres."""
        return np.array([self.radius, 1.0, 1.0, 1.0])

    @property
    def _unit(self) -> Array:
        """The coefficients for a radius of 1."""
        found: Array = self.coefficients * self.radius ** (DEGREES - 3.0)
        return found

    def _is_zero(self, coefficients: Array) -> bool:
        """Whether coefficients for a radius of 1 are rounding."""
        return bool(within(coefficients, SIZE, self.slack).all())

    @cached_property
    def _divided(self) -> tuple[list[Array], Array]:
        """The planes that divide the cubic, and what is left of it, for a radius of 1."""
        planes: list[Array] = []
        rest = self._unit
        for plane in _candidates():
            while len(rest) > 4 or (len(rest) == 4 and not self._is_zero(rest[1:])):
                quotient, left = division(rest, plane)
                if not self._is_zero(left):
                    break
                planes.append(plane)
                rest = quotient
        return planes, rest

    @cached_property
    def _distinct(self) -> Array:
        """The planes that divide the cubic, double ones once."""
        rounded = np.round(self.factors / self._scale, 6)
        found: Array = self.factors[np.unique(rounded, axis=0, return_index=True)[1]]
        return found

    def _reduced(self, points: Array) -> Array:
        """A polynomial with the same zeros, each of its factors once."""
        if self.kind == "identically zero":
            raise InputError("every position is singular at this orientation: no surface")
        if not self.kind.startswith("double plane"):
            return cube(self._tensor, points_of(points))
        found: Array = np.prod(points_of(points) @ self._distinct.T, axis=-1)
        return found

    def _proven(self, low: Array, high: Array) -> NDArray[np.int8]:
        """The sign in boxes (N, 3), 0 where it is undecided."""
        center, half = (low + high) / 2.0, (high - low) / 2.0
        half = half + 4.0 * EPS * (abs(low) + abs(high))
        point, aside = points_of(center), np.concatenate([np.zeros((len(half), 1)), half], axis=1)
        once = np.einsum("abc,na->nbc", self._tensor, point)
        twice = np.einsum("nbc,nb->nc", once, point)
        middle = (twice * point).sum(axis=1)
        spread = 3.0 * (abs(twice) * aside).sum(axis=1)
        spread += 3.0 * np.einsum("nbc,nb,nc->n", abs(once), aside, aside)
        spread += cube(abs(self._tensor), aside)
        largest = abs(point) + aside
        own = STEPS * EPS * cube(abs(self._tensor), largest)
        given = SIZE * max(self.slack, LEAST) * (self.radius + largest[:, 1:].sum(axis=1)) ** 3
        proven = abs(middle) > (1.0 + STEPS * EPS) * (spread + own + given)
        return np.where(proven, np.sign(middle), 0.0).astype(np.int8)


def direct_locus(robot: UncoupledManipulator, rotation: RotationLike) -> DirectLocus:
    """The surfaces of direct singularities at one orientation of the platform, equation (27).

    Parameters
    ----------
    robot : UncoupledManipulator
        Of one radius.
    rotation : array_like (3, 3), or anything with ``as_matrix()``

    Returns
    -------
    DirectLocus

    Raises
    ------
    InputError
    """
    turn, radius = one_rotation("rotation", rotation), one_radius(robot)
    result = kernels.direct_locus(robot.radius, turn)
    slack = threshold(robot.rounding) + SIZE * float(kernels.rotation_defect(turn).defect)
    return DirectLocus(radius, turn, result.coefficients, result.incidence, slack)


class InverseLocus(NamedTuple):
    """Where J_q is singular at one orientation, in closed form.

    Attributes
    ----------
    incidence : array (3,)
        ``n_i·u_i``. Where one is 0, limb i has no B_i wherever C is.
    axis : array (3,)
        C on this line through O: ``q6 cos q5 = 0``.
    wrist : array (4,)
        C on this plane, ``wrist[0] + wrist[1:]·c = 0``: the central limb lies in the platform.
    points, directions : array (3, 3)
        C on the line through ``points[i]`` along ``directions[i]``: ``q_i = 0``.
    """

    incidence: Array
    axis: Array
    wrist: Array
    points: Array
    directions: Array


def inverse_locus(robot: UncoupledManipulator, rotation: RotationLike) -> InverseLocus:
    """The lines and the plane of inverse singularities at one orientation, (25) and (10).

    Parameters, errors as in `direct_locus`.

    Returns
    -------
    InverseLocus
    """
    locus = direct_locus(robot, rotation)
    directions = BASE_AXES @ locus.rotation.T
    points = locus.radius * BASE_AXES
    axis = np.array([0.0, 0.0, 1.0])
    return InverseLocus(locus.incidence, axis, locus.planes["wrist"], points, directions)


def _candidates() -> list[Array]:
    """The planes that are proven to divide the cubic of some rotations, for a radius of 1."""
    level = np.array([[0.0, 0.0, 0.0, 1.0]])
    upright = np.insert(BASE_NORMALS, 0, 0.0, axis=1)
    extensions = np.insert(-BASE_AXES, 0, 1.0, axis=1)
    return list(np.concatenate([level, upright, extensions]))


def _cut(low: Array, high: Array) -> tuple[Array, Array]:
    """Each box (N, 3) in eight."""
    middle = (low + high) / 2.0
    lows, highs = [], []
    for corner in np.ndindex(2, 2, 2):
        upper = np.array(corner, dtype=bool)
        lows.append(np.where(upper, middle, low))
        highs.append(np.where(upper, high, middle))
    return np.concatenate(lows), np.concatenate(highs)
