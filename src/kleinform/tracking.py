"""Follow one assembly mode along a motion of the joints.

Newton's method on the six quadratics in (n_1, n_2), generated with their Jacobian. Because
the system is quadratic its Jacobian has a constant derivative, so that Kantorovich's
theorem can be evaluated exactly: with ``h = ω η``, where η is the length of the first Newton
step and ω bounds the change of the Jacobian, ``h <= 1/2`` proves that the iteration converges
and that the solution is the only one around. A step along the motion is taken only when
``h <= TRUST`` at its end, and is halved otherwise.

Such steps, one after the other, go from station to station, over as many samples as the trust
allows. The samples between are then found from their nearest station, all in one batch
(`kleinform.polishing`); where one of them is in doubt, its stretch is followed sample by
sample instead.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import ShapeError, TrackingError
from kleinform.generated import kernels
from kleinform.joints import checked_joints, unwrapped
from kleinform.polishing import polish
from kleinform.results import Singularity
from kleinform.screening import RotationLike, one_rotation

__all__ = ["newton", "refuse_crossings", "track"]

Array = NDArray[np.float64]

#: Kantorovich's number up to which a step is taken; 1/2 would prove convergence at its end,
#: and the margin covers the joint values in between.
TRUST = 0.125
#: A segment between two samples is halved at most so often.
MOST_HALVINGS = 24
MOST_ITERATIONS = 12
#: In so many parts of a stretch the trust is looked at.
PARTS = 4
#: Newton's method has converged when its step is below STEP, or below SMALL and no longer
#: shrinking; directions are unit vectors.
STEP = 4.0 * float(np.finfo(np.float64).eps)
SMALL = 1e-9

#: The pairs (n_1, n_2) that span their space: the Jacobian is linear in (n_1, n_2).
BASIS = np.eye(6).reshape(6, 2, 3)


def track(radius: Array, joints: ArrayLike, start_rotation: RotationLike) -> tuple[Array, Array]:
    """Positions and rotations along a motion; see `UncoupledManipulator.track`."""
    motion = _checked_motion(radius, joints)
    start = one_rotation("start_rotation", start_rotation)
    size = float(radius)
    positions = kernels.central_forward(motion[:, 3:]).position
    stations = _stations(size, motion, _first(size, motion[0], start))
    known, numbers = _turned(np.array(list(stations.values()))), np.array(list(stations))
    found, sure = polish(size, positions, motion[:, :3], numbers, known)
    found[numbers] = known
    here = stations[0]
    for before, after in pairwise(stations):
        # A stretch that was followed may have led elsewhere than to its station.
        if here is stations[before] and sure[before : after + 1].all():
            here = stations[after]
            continue
        stretch = _follow(size, motion, here, before, after)
        found[before + 1 : after + 1] = _turned(stretch)
        apart = np.abs(stretch[-1] - stations[after]).max()
        here = stations[after] if apart <= SMALL else stretch[-1]
    return positions, found


def _turned(directions: Array) -> Array:
    """Rotations (T, 3, 3) from n_1 and n_2, (T, 2, 3)."""
    return kernels.rotation_from_directions(directions[:, 0], directions[:, 1]).rotation


def _stations(radius: float, motion: Array, start: Array) -> dict[int, Array]:
    """The directions at some samples, the first and the last among them, by their number."""
    stations, sample, stride = {0: start}, 0, 1
    while sample < len(motion) - 1:
        stride = min(stride, len(motion) - 1 - sample)
        reached = _reach(radius, motion[sample : sample + stride + 1], stations[sample])
        if reached is None and stride > 1:
            stride //= 2
            continue
        if reached is None:
            reached = _follow(radius, motion, stations[sample], sample, sample + 1)[0]
        sample += stride
        stations[sample] = reached
        stride *= 2
    return stations


def _reach(radius: float, stretch: Array, directions: Array) -> Array | None:
    """The directions at the end of a stretch of samples, or None where they are not sure.

    Newton's method must be trusted at the end, and in each of some parts of the stretch at the
    sample that is farthest from the first: a motion may come back to where it was.
    """
    away = np.linalg.norm(_changes(stretch) / [radius, radius, radius, 1, 1, radius], axis=1)
    parts = np.array_split(np.arange(1, len(stretch)), min(PARTS, len(stretch) - 1))
    looked_at = [part[np.argmax(away[part])] for part in parts]
    looked_at.append(len(stretch) - 1)
    if (_kantorovich(radius, stretch[looked_at], directions) > TRUST).any():
        return None
    return newton(radius, stretch[-1], directions)


def _changes(stretch: Array) -> Array:
    """How far each sample of a stretch is from its first, q4 the shorter way round."""
    changes: Array = stretch - stretch[0]
    changes[:, 3] = unwrapped(stretch[:, 3]) - stretch[0, 3]
    return changes


def _follow(radius: float, motion: Array, directions: Array, before: int, after: int) -> Array:
    """The directions at samples ``before + 1`` to ``after``, one after the other."""
    followed = []
    for sample in range(before + 1, after + 1):
        directions = _advance(radius, motion[sample - 1], motion[sample], directions, sample)
        followed.append(directions)
    return np.array(followed)


def refuse_crossings(direct: Singularity) -> None:
    """Refuse a motion along which a direct factor vanishes or changes its sign.

    Raises
    ------
    TrackingError
        It names the sample and the factor. The wrist factor is left out: it cancels.
    """
    vanishing = direct.vanishing()
    for name, factor in direct.factors.items():
        if name == "wrist":
            continue
        bad = vanishing[name].copy()
        bad[1:] |= np.sign(factor[1:]) != np.sign(factor[:-1])
        if bad.any():
            sample = int(np.argmax(bad))
            raise TrackingError(
                f"sample {sample}: the direct factor {name} vanishes or changes its sign "
                f"({factor[max(sample - 1, 0)]:.6g} to {factor[sample]:.6g}): another assembly "
                "mode meets this one",
                sample=sample,
            )


def _checked_motion(radius: Array, joints: ArrayLike) -> Array:
    motion = checked_joints(joints)
    if motion.ndim != 2 or len(motion) == 0:
        raise ShapeError(f"joints: shape (T, 6) with T >= 1 is needed, {motion.shape} arrived")
    if radius.ndim:
        raise ShapeError(f"radius: one radius is needed, shape {radius.shape} arrived")
    return motion


def _first(radius: float, joints: Array, guess: Array) -> Array:
    """The solution at the first sample that Newton's method finds from the guess."""
    turned = np.array([guess[:, 0], -0.5 * guess[:, 0] + np.sqrt(0.75) * guess[:, 1]])
    solution = newton(radius, joints, turned)
    if solution is None:
        raise TrackingError(
            "sample 0: Newton's method does not converge from start_rotation; give one nearer "
            "to an assembly mode of these joint values",
            sample=0,
        )
    return solution


def _advance(radius: float, start: Array, end: Array, directions: Array, sample: int) -> Array:
    """Follow the mode along one segment of joint space, halving it where needed."""
    done, size, change = 0.0, 1.0, _changes(np.stack([start, end]))[1]
    while done < 1.0:
        size = min(size, 1.0 - done)
        joints = start + (done + size) * change
        number = _kantorovich(radius, joints[np.newaxis], directions)[0]
        reached = newton(radius, joints, directions) if number <= TRUST else None
        if reached is None:
            size /= 2.0
            if size < 2.0**-MOST_HALVINGS:
                raise TrackingError(
                    f"sample {sample}: the mode cannot be followed beyond {done:.6g} of the "
                    f"segment from sample {sample - 1}: Newton's method cannot be trusted "
                    f"there (Kantorovich's number {number:.3g}, at most {TRUST} is "
                    "needed)",
                    sample=sample,
                )
            continue
        directions, done, size = reached, done + size, 2.0 * size
    return directions


def _kantorovich(radius: float, joints: Array, directions: Array) -> Array:
    """Kantorovich's number (S,) of Newton's method from some directions, affine invariant.

    For joint values (S, 6).
    """
    pairs = np.concatenate([directions[np.newaxis], BASIS])
    center = kernels.central_forward(joints[:, np.newaxis, 3:]).position
    system = kernels.closure(radius, center, joints[:, np.newaxis, :3], pairs)
    # Columns: the residual, then the derivative of the Jacobian in each of six directions.
    change = np.moveaxis(system.jacobian[:, 1:], 1, 2).reshape(len(joints), 6, 36)
    sides = np.concatenate([system.residual[:, 0, :, np.newaxis], change], axis=2)
    try:
        solved = np.linalg.solve(system.jacobian[:, 0], sides)
    except np.linalg.LinAlgError:
        return np.full(len(joints), np.inf)
    first, rest = solved[..., 0], solved[..., 1:]
    number: Array = np.linalg.norm(first, axis=1) * np.linalg.norm(rest, axis=(1, 2))
    return number


def newton(radius: float, joints: Array, directions: Array) -> Array | None:
    """Newton's method to the end, or None when it does not get there."""
    center = kernels.central_forward(joints[3:]).position
    last = np.inf
    for _ in range(MOST_ITERATIONS):
        system = kernels.closure(radius, center, joints[:3], directions)
        try:
            step = np.linalg.solve(system.jacobian, system.residual)
        except np.linalg.LinAlgError:
            return None
        size = float(np.linalg.norm(step))
        directions = directions - step.reshape(2, 3)
        # Quadratic convergence leaves rounding alone: a small step that no longer shrinks.
        if size <= SMALL and (size <= STEP or size >= last / 2.0):
            return directions
        last = size
    return None
