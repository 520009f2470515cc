"""Joint values with q_i = 0: B_i is A_i, n_i is known, and two equations are left for one turn.

Such joint values have a pose only if the two agree. The angle of leg i is then of no
meaning, and the cones meet in n_i with multiplicity two.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.cases import reach_of, zero_leg
from kleinform.forward.circle import AXES, Rows, relabel, turned
from kleinform.forward.folds import rounding_of_equations
from kleinform.forward.polish import unlabelled
from kleinform.generated import kernels

__all__ = ["by_zero_leg"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
SAMPLES = 8
STEPS = 12
#: A zero z of a quartic in z = exp(i phi) may be off the unit circle by this: where the two
#: equations agree in a double zero only, rounding moves it.
OFF_CIRCLE = 1e-4
#: What rounding may do, in eps, beside the tolerance.
ROUNDING = 8.0
SAME = 1e-6


def by_zero_leg(row: Rows, limb: int, tolerance: float) -> Array:
    """n_1 and n_2 (m, 2, 3) of the modes of one set of joint values with q of ``limb`` zero."""
    base = np.array([limb])
    position, lengths = relabel(row, base)
    own = np.array([row.radius[0], 0.0, 0.0]) - position[0]
    own /= np.linalg.norm(own)
    f = np.cross(own, np.eye(3)[np.argmin(abs(own))])
    f /= np.linalg.norm(f)
    frame = np.stack([own, f, np.cross(own, f)])
    modes: list[Array] = []
    zero = np.roll(zero_leg(row)[0], -limb)
    fitted = [
        _fitted(row.radius, position, lengths, frame, start)
        for start in _starts(row.radius, position, lengths, frame)
    ]
    for relabelled in [*_known(row.radius, position, zero, frame), *fitted]:
        back = turned(relabelled[np.newaxis], base, back=True)
        directions = unlabelled(back, base)[0]
        known = any(np.linalg.norm(mode - directions) <= SAME for mode in modes)
        if not known and _closes(row, limb, directions, tolerance):
            modes.append(directions)
    return np.array(modes).reshape(-1, 2, 3)


def _known(radius: Array, position: Array, zero: Mask, frame: Array) -> Array:
    """The two turns at which the direction of another limb of length zero is right."""
    known = [AXES[limb] for limb in (1, 2) if zero[limb]]
    arms = np.array(known).reshape(-1, 3) * radius - position
    phi: Array = np.arctan2(arms @ frame[2], arms @ frame[1])
    return _turned(frame, np.concatenate([phi, phi + np.pi]))


def _turned(frame: Array, phi: Array) -> Array:
    half = np.stack([np.cos(phi / 2.0), np.sin(phi / 2.0)], axis=-1)
    return kernels.turned_directions(frame, half).directions


def _starts(radius: Array, position: Array, lengths: Array, frame: Array) -> Array:
    """Turns at which one of the two equations has a zero."""
    phi: Array = 2.0 * np.pi / SAMPLES * np.arange(SAMPLES, dtype=np.float64)
    residual = kernels.closure(radius, position, lengths, _turned(frame, phi)).residual
    spectrum = np.fft.fft(residual[:, 1:3], axis=0)[[2, 1, 0, -1, -2]]
    starts = []
    for quartic in spectrum.T:
        zeros = np.roots(quartic)
        starts.append(np.angle(zeros[abs(abs(zeros) - 1.0) <= OFF_CIRCLE]))
    return np.concatenate(starts)


def _fitted(radius: Array, position: Array, lengths: Array, frame: Array, phi: float) -> Array:
    """Gauss and Newton's method for the turn that suits both equations best."""
    for _ in range(STEPS):
        directions = _turned(frame, np.array(phi))
        step = kernels.newton_step(radius[0], position[0], lengths[0], directions)
        slope = step.gradient[1:] @ frame[0]
        square = slope @ slope
        if square == 0.0:
            break
        change = float(slope @ step.residual[1:] / square)
        phi -= change
        if abs(change) <= EPS:
            break
    return _turned(frame, np.array(phi))


def _closes(row: Rows, limb: int, directions: Array, tolerance: float) -> bool:
    """Whether the other two equations agree, for joint values within the tolerance.

    Without a tolerance, whether they may: the difference is within a bound on its rounding.

    Of the two a combination is left that the turn about n_i does not change. What a relative
    change of the joint values by 1 does to it bounds what the tolerance, and rounding, can do.
    """
    local = kernels.fold(row.radius[0], row.joints[0], directions)
    n = np.array([*directions, -directions.sum(axis=0)])[limb]
    reach = reach_of(row)[0]
    # Another limb of length zero closes where its B is at its A.
    rotation = kernels.rotation_from_directions(*directions).rotation
    legs = kernels.inverse_displacement(row.radius[0], row.position[0], rotation).joints[:3]
    zero = zero_leg(row)[0]
    slack = tolerance + ROUNDING * EPS
    if not (legs[zero] <= slack * reach[zero]).all():
        return False
    # n_i turns with C, by about as much as C is changed over the distance of A_i.
    distance = np.linalg.norm(row.position[0] - row.radius[0] * AXES[limb])
    moved = np.linalg.norm(local.gradient, axis=1) * np.linalg.norm(row.position[0]) / distance
    scale = abs(local.by_joints).sum(axis=1) + moved
    first, second = (other for other in range(3) if other != limb)
    slope = local.gradient @ n
    y = np.zeros(3)
    y[first], y[second] = slope[second], -slope[first]
    y[zero] = 0.0
    allowed = rounding_of_equations(row)[0] if tolerance == 0.0 else slack * scale
    return bool(abs(y @ local.residual) <= abs(y) @ allowed)
