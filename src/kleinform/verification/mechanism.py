"""The mechanism joint by joint at one assembled pose: points and axes, nothing that moves.

Elementary vector geometry only: no kernel of kleinform is called.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Joint", "Mechanism", "assembled", "freedoms", "screw", "start_rates"]

Array = NDArray[np.float64]
Z = np.array([0.0, 0.0, 1.0])
LIMB_ANGLES = np.radians([0.0, 120.0, -120.0])


class Joint(NamedTuple):
    """One joint between two links.

    Attributes
    ----------
    kind : {"R", "P", "C"}
        Revolute, prismatic, cylindrical.
    point, axis : array (3,)
        A point of the axis [m] and its unit direction, at the start.
    actuator : int or None
        Index of the joint value that drives it, 0 to 5; None if it is passive.
    """

    kind: str
    point: Array
    axis: Array
    actuator: int | None = None


class Mechanism(NamedTuple):
    """The four limbs at the start, each from the base to the platform.

    Attributes
    ----------
    position, rotation : array (3,), (3, 3)
        The platform's pose at the start.
    limbs : tuple of tuples of Joint
        Limbs 1, 2, 3: R, P, R, R, C. Central limb: R, R, P, R and the two of the U joint.
    """

    position: Array
    rotation: Array
    limbs: tuple[tuple[Joint, ...], ...]


def assembled(position: Array, rotation: Array, radius: float = 1.0) -> Mechanism:
    """The mechanism at a pose.

    Parameters
    ----------
    position : array (3,)
        C [m], not on the Z axis.
    rotation : array (3, 3)
        Columns: n_1, the platform's y axis, its normal.
    radius : float
        Of the circle through A_1, A_2, A_3 [m].
    """
    outer = [
        _outer_limb(i, radius * _turned(np.eye(3), angle), _turned(rotation, angle), position)
        for i, angle in enumerate(LIMB_ANGLES)
    ]
    return Mechanism(position, rotation, (*outer, _central_limb(position, rotation)))


def _turned(frame: Array, angle: float) -> Array:
    """The x axis of a frame, turned about its z axis."""
    direction: Array = np.cos(angle) * frame[:, 0] + np.sin(angle) * frame[:, 1]
    return direction


def _unit(vector: Array) -> Array:
    unit: Array = vector / np.linalg.norm(vector)
    return unit


def _outer_limb(i: int, a: Array, n: Array, c: Array) -> tuple[Joint, ...]:
    """Base revolute, leg, revolute along the leg, upper revolute, cylindrical joint."""
    u = _unit(a)
    b = c + (a - c) @ u / (n @ u) * n  # the line from C along n_i meets the plane of the leg
    w = _unit(b - a)
    return (
        Joint("R", a, u),
        Joint("P", a, w, i),
        Joint("R", b, w),
        Joint("R", b, _unit(np.cross(n, w))),
        Joint("C", b, n),
    )


def _central_limb(c: Array, rotation: Array) -> tuple[Joint, ...]:
    """Azimuth, elevation (positive upwards), length, revolute along the limb, U joint."""
    base, along = np.zeros(3), _unit(c)
    return (
        Joint("R", base, Z, 3),
        Joint("R", base, _unit(np.cross(along, Z)), 4),
        Joint("P", base, along, 5),
        Joint("R", c, along),
        Joint("R", c, rotation[:, 0]),
        Joint("R", c, rotation[:, 1]),
    )


def freedoms(limb: tuple[Joint, ...]) -> Iterator[Joint]:
    """The six joints of one freedom each, a cylindrical joint as R and P on its axis."""
    for joint in limb:
        for kind in "RP" if joint.kind == "C" else joint.kind:
            yield joint._replace(kind=kind)


def start_rates(mechanism: Mechanism, actuated: Array) -> Array:
    """Rates (4, 6) of all joints at the start, from those of the actuators (6,).

    Every limb moves the platform with the same twist: 18 equations for 18 passive joints.
    """
    joints = [joint for limb in mechanism.limbs for joint in freedoms(limb)]
    screws = [screw(joint) for joint in joints]
    equations: Array = np.zeros((24, 24))
    for i in range(3):
        equations[6 * i : 6 * i + 6, 6 * i : 6 * i + 6] = np.transpose(screws[6 * i : 6 * i + 6])
        equations[6 * i : 6 * i + 6, 18:] = -np.transpose(screws[18:])
    right = np.zeros(24)
    for column, joint in enumerate(joints):
        if joint.actuator is not None:
            equations[18 + joint.actuator, column] = 1.0
            right[18 + joint.actuator] = actuated[joint.actuator]
    return np.asarray(np.linalg.solve(equations, right), dtype=np.float64).reshape(4, 6)


def screw(joint: Joint) -> Array:
    """The twist ``[omega, v_O]`` (6,) of a joint of one freedom at unit rate, with pole O."""
    if joint.kind == "P":
        return np.concatenate([np.zeros(3), joint.axis])
    return np.concatenate([joint.axis, np.cross(joint.point, joint.axis)])
