"""Joint values with q_i = 0: B_i is A_i, n_i is known, and two equations are left for one turn.

Such joint values have a pose only if the two agree. The angle of leg i is then of no
meaning, and the cones meet in n_i with multiplicity two.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.cases import reach_of
from kleinform.forward.circle import COSINE, SINE, Rows, turned
from kleinform.forward.polish import unlabelled
from kleinform.generated import kernels

__all__ = ["by_zero_leg"]

Array = NDArray[np.float64]

EPS = float(np.finfo(np.float64).eps)
SAMPLES = 8
STEPS = 12
#: A zero z of a quartic in z = exp(i phi) may be off the unit circle by this: where the two
#: equations agree in a double zero only, rounding moves it.
OFF_CIRCLE = 1e-4
#: The legs may miss their lengths by the tolerance and this many eps, times the reach.
ROUNDING = 8.0
SAME = 1e-6


def by_zero_leg(row: Rows, limb: int, tolerance: float) -> Array:
    """n_1 and n_2 (m, 2, 3) of the modes of one set of joint values with q of ``limb`` zero."""
    base = np.array([limb])
    position = turned(row.position, base)
    lengths = np.roll(row.lengths, -limb, axis=1)
    own = np.array([row.radius[0], 0.0, 0.0]) - position[0]
    own /= np.linalg.norm(own)
    f = np.cross(own, np.eye(3)[np.argmin(abs(own))])
    f /= np.linalg.norm(f)
    frame = np.stack([own, f, np.cross(own, f)])
    allowed = (tolerance + ROUNDING * EPS) * np.roll(reach_of(row)[0], -limb)
    modes: list[Array] = []
    fitted = [
        _fitted(row.radius, position, lengths, frame, start)
        for start in _starts(row.radius, position, lengths, frame)
    ]
    for directions in [*_known(row.radius, position, lengths, frame), *fitted]:
        missed = _missed(row.radius, position, lengths, directions)
        near = [mode for mode in modes if np.linalg.norm(mode - directions) <= SAME]
        if (missed <= allowed).all() and not near:
            modes.append(directions)
    if not modes:
        return np.empty((0, 2, 3))
    found = turned(np.array(modes), np.full(len(modes), limb), back=True)
    return unlabelled(found, np.full(len(modes), limb))


def _known(radius: Array, position: Array, lengths: Array, frame: Array) -> Array:
    """The two turns at which the direction of another limb of length zero is right."""
    known = [
        COSINE[limb] * np.array([1.0, 0.0, 0.0]) - SINE[limb] * np.array([0.0, 1.0, 0.0])
        for limb in (1, 2)
        if lengths[0, limb] == 0.0
    ]
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


def _missed(radius: Array, position: Array, lengths: Array, directions: Array) -> Array:
    """By how much each leg misses its length [m]."""
    rotation = kernels.rotation_from_directions(directions[0], directions[1]).rotation
    legs = kernels.inverse_displacement(radius[0], position[0], rotation).joints[:3]
    return abs(legs - lengths[0])
