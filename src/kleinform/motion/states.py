"""What is known of a motion at some times: of the joints, and of the platform."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import NotFiniteError
from kleinform.screening import real_array
from kleinform.sums import turned_by

__all__ = ["JointStates", "PlatformStates", "PointStates"]

Array = NDArray[np.float64]

#: The trailing axes of what stands beside the times.
JOINT_SHAPES = {"joints": (6,), "rates": (6,), "accelerations": (6,)}
PLATFORM_SHAPES = {"positions": (3,), "rotations": (3, 3), "twists": (6,), "twist_rates": (6,)}


class JointStates(NamedTuple):
    """The joints over time.

    Attributes
    ----------
    times : array (T,)
        [s].
    joints, rates, accelerations : array (T, 6)
        q, q̇ and q̈ in the order q1 ... q6, in m, m, m, rad, rad, m, per second and per second
        squared. q4 does not jump by 2π.
    """

    times: Array
    joints: Array
    rates: Array
    accelerations: Array


class PointStates(NamedTuple):
    """A point over time, in the base frame.

    Attributes
    ----------
    times : array (T,)
        [s].
    positions, velocities, accelerations : array (T, 3)
        In m, m/s and m/s².
    """

    times: Array
    positions: Array
    velocities: Array
    accelerations: Array


class PlatformStates(NamedTuple):
    """The platform over time, in the base frame.

    Attributes
    ----------
    times : array (T,)
        [s].
    positions : array (T, 3)
        C [m].
    rotations : array (T, 3, 3)
    twists, twist_rates : array (T, 6)
        ``[omega, v_C]`` [rad/s, m/s], and its derivative [rad/s², m/s²].
    """

    times: Array
    positions: Array
    rotations: Array
    twists: Array
    twist_rates: Array

    def of_point(self, offset: ArrayLike) -> PointStates:
        """Position, velocity and acceleration of a point that is fixed to the platform.

        Parameters
        ----------
        offset : array_like (3,)
            From C to the point, in the platform's frame [m].

        Raises
        ------
        ShapeError, DtypeError, NotFiniteError
        """
        arm = real_array("offset", offset, (3,))
        if not np.isfinite(arm).all():
            raise NotFiniteError(f"offset: NaN or inf, {arm} arrived")
        turned = turned_by(self.rotations, arm)
        omega, velocity = self.twists[:, :3], self.twists[:, 3:]
        angular, linear = self.twist_rates[:, :3], self.twist_rates[:, 3:]
        moved = np.cross(omega, turned)
        return PointStates(
            self.times,
            self.positions + turned,
            velocity + moved,
            linear + np.cross(angular, turned) + np.cross(omega, moved),
        )
