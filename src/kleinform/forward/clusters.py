"""Modes from all 32 pairs, for the rows that the eliminant left undecided."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.apart import radii_of_directions
from kleinform.forward.circle import Rows
from kleinform.forward.folds import Folds, folds, split
from kleinform.forward.found import Found, found, together
from kleinform.forward.pencil import PAIRS, pairs_of
from kleinform.forward.polish import CONVERGED, polished, turn_by
from kleinform.generated import kernels
from kleinform.sums import dot, product, turned_by

__all__ = ["by_pencil", "candidates", "mirrored"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
#: Newton's method on all pairs: where more follows, few steps in the half angles and one on
#: rotations will do; each step halves the distance of multiple ones.
HALF_ANGLES, NEWTON, NEWTON_MULTIPLE = 3, 1, 24
#: Starts of the angles that are tried, each with every limb as the base.
MOST_STARTS = 3
#: Longer turns of Newton's method lead astray, and are not made.
LONGEST_TURN = 0.1
#: The fold of two solutions is that near to their middle.
FARTHEST = 0.01
#: Steps to the center of a cluster, and the turn for differences of the gradient there.
CENTER_STEPS, TURN = 12, 1e-4
#: Rounding of what three and more solutions leave of the closure equations, in eps.
ROUNDING = 4.0
#: Singular values of the gradient below this, relative to the first, vanish at the center.
VANISHING = 1e-5
#: Solutions nearer than this belong to one cluster; a cluster of m that should be one point
#: is spread by rounding over eps^(1/m).
NEAR = (1e-3, 1e-5, 1e-7)
#: An imaginary part below this is rounding: a pair of conjugates so close is a cluster.
REAL = 1e-8
SAME = 1e-9
#: Newton's method in real numbers moves a solution that is one by no more than this.
NEARBY = 1e-6
#: A cluster of more than two is farther from all other solutions than this times its size.
APART = 20.0


def candidates(rows: Rows) -> Complex:
    """One of each pair ±n (N, 32, 2, 3) by the pencil, polished on the closure equations."""
    base = np.zeros(len(rows), dtype=np.int64)
    return polished_pairs(rows, pairs_of(rows, base, steps=HALF_ANGLES).directions, NEWTON)[0]


def mirrored(row: Rows, pairs: Complex) -> Complex:
    """For solutions close to a fold, the points on its other side (K, 2, 3).

    Two solutions may be so close that Newton's method leads from both to the same one.
    """
    points = []
    for members in _grouped(pairs, np.arange(len(pairs)), 0):
        if len(members) != 2:
            continue
        both = _aligned(pairs[members])
        center = _orthonormal(both.mean(axis=0).real.astype(np.complex128)).real
        near = folds(row, np.zeros(1, dtype=np.int64), center[np.newaxis], 0.0)
        points += [2.0 * near.directions[0] - solution for solution in both]
    return np.array(points, dtype=np.complex128).reshape(-1, 2, 3)


def polished_pairs(rows: Rows, directions: Complex, steps: int) -> tuple[Complex, Array]:
    """Newton's method on rotations, for complex directions (N, P, 2, 3), and its last turns."""
    cones = [
        cone[:, np.newaxis] for cone in kernels.cones(rows.radius, rows.position, rows.lengths)
    ]
    with np.errstate(all="ignore"):
        for _ in range(steps):
            first, second = directions[..., 0, :], directions[..., 1, :]
            all_three = (first, second, -first - second)
            slopes = [turned_by(cone, n) for cone, n in zip(cones, all_three, strict=True)]
            g = [2.0 * np.cross(n, slope) for n, slope in zip(all_three, slopes, strict=True)]
            f = [dot(n, slope)[..., np.newaxis] for n, slope in zip(all_three, slopes, strict=True)]
            sides = [np.cross(g[1], g[2]), np.cross(g[2], g[0]), np.cross(g[0], g[1])]
            volume = dot(g[0], sides[0])[..., np.newaxis]
            turn = -sum(entry * side for entry, side in zip(f, sides, strict=True)) / volume
            step = np.cross(turn[..., np.newaxis, :], directions)
            size = np.max(abs(turn), axis=-1)
            good = (size <= LONGEST_TURN)[..., np.newaxis, np.newaxis]
            directions = _orthonormal(np.where(good, directions + step, directions))
    return directions, size


def _orthonormal(directions: Complex) -> Complex:
    """Unit directions 120° apart again, by Newton's step on their products."""
    products = product(directions, directions.swapaxes(-1, -2))
    gram = np.linalg.inv(np.array([[1.0, -0.5], [-0.5, 1.0]]))
    excess = products - np.array([[1.0, -0.5], [-0.5, 1.0]])
    correction = product(product(excess, gram), directions)
    return np.asarray(directions - 0.5 * correction)


def by_pencil(rows: Rows, tolerance: float) -> tuple[Found, Mask]:
    """Modes of rows from all 32 pairs, and the rows in which all 32 are accounted for.

    A multiplicity above two counts only where two different pencils agree on it.
    """
    solved = np.zeros(len(rows), dtype=bool)
    parts, seen = [], set()
    for start in range(MOST_STARTS):
        for base in range(3):
            left = np.flatnonzero(~solved)
            if not len(left):
                break
            pairs = pairs_of(rows[left], np.full(len(left), base), start).directions
            pairs, turns = polished_pairs(rows[left], pairs, NEWTON_MULTIPLE)
            # Double solutions converge slowly, but for the last bits of a turn.
            settled = np.asarray((turns <= NEARBY).all(axis=1))
            for number, own, ready in zip(left, pairs, settled, strict=True):
                modes = _modes(rows[[int(number)]], own, tolerance) if ready else None
                if modes is None:
                    continue
                directions, multiplicity = modes
                answer = (number, *sorted(multiplicity.tolist()))
                if multiplicity.max(initial=1) <= 2 or answer in seen:
                    solved[number] = True
                    parts.append(found(np.full(len(directions), number), directions, multiplicity))
                seen.add(answer)
    return together(parts), solved


def _modes(row: Rows, pairs: Complex, tolerance: float) -> tuple[Array, NDArray[np.int64]] | None:
    """Real modes among 32 pairs and their multiplicities, or None if pairs are missing."""
    if not np.isfinite(pairs).all():
        return None
    directions, multiplicities = [], []
    for members in _grouped(pairs, np.arange(PAIRS), 0):
        if len(members) > 2 and not _set_apart(pairs, members):
            return None
        modes = _group(row, _aligned(pairs[members]), tolerance)
        if modes is None:
            return None
        directions += modes[0]
        multiplicities += modes[1]
    real = np.array(directions).reshape(-1, 2, 3)
    apart = _distances(real.astype(np.complex128)) + np.eye(len(real))
    if sum(multiplicities) % 2 or np.min(apart, initial=1.0) <= SAME:
        return None
    return real, np.array(multiplicities, dtype=np.int64)


def _grouped(pairs: Complex, members: NDArray[np.int64], level: int) -> list[NDArray[np.int64]]:
    """Clusters of pairs; those of three and more are looked at again more closely."""
    linked = _distances(pairs[members]) <= NEAR[level]
    for _ in range(5):
        linked = linked @ linked
    groups: list[NDArray[np.int64]] = []
    for index in range(len(members)):
        if not linked[index, :index].any():
            group = members[linked[index]]
            closer = len(group) > 2 and level + 1 < len(NEAR)
            parts = _grouped(pairs, group, level + 1) if closer else [group]
            # A looser cluster that does not fall apart into singles and couples stays whole.
            groups += parts if max(map(len, parts)) <= 2 else [group]
    return groups


def _distances(pairs: Complex) -> Array:
    """Distances between pairs ±n (m, m)."""
    flat = pairs.reshape(len(pairs), 6)
    nearer = np.minimum(
        abs(flat[:, np.newaxis] - flat).max(-1), abs(flat[:, np.newaxis] + flat).max(-1)
    )
    return np.asarray(nearer)


def _set_apart(pairs: Complex, members: NDArray[np.int64]) -> bool:
    """Whether a cluster is so tight that no member of it can belong to another one."""
    distances = _distances(pairs)[members]
    outside = np.delete(distances, members, axis=1)
    return bool(APART * distances[:, members].max() <= np.min(outside, initial=np.inf))


def _aligned(pairs: Complex) -> Complex:
    """The pairs of a cluster with the signs that bring them together."""
    near = abs(pairs - pairs[0]).max((1, 2)) <= abs(pairs + pairs[0]).max((1, 2))
    return np.asarray(np.where(near[:, np.newaxis, np.newaxis], pairs, -pairs))


Modes = tuple[list[Array], list[int]]


def _group(row: Rows, pairs: Complex, tolerance: float) -> Modes | None:
    """The modes of one cluster, or None where a simple solution was found twice."""
    mean = pairs.mean(axis=0)
    if len(pairs) == 1:
        return _single(row, pairs[0])
    if abs(mean.imag).max() > NEAR[0]:
        return None if _distances(pairs).max() <= SAME else ([], [])
    center = _orthonormal(mean.real.astype(np.complex128)).real
    if len(pairs) > 2:
        return _multiple(row, pairs, tolerance)
    index = np.zeros(1, dtype=np.int64)
    near = folds(row, index, center[np.newaxis], tolerance)
    if near.hidden[0]:
        return None
    if near.lost[0] or abs(near.directions[0] - center).max() > FARTHEST:
        return _couple(row, pairs)
    if near.merged[0]:
        return [near.directions[0]], [2]
    if _copies(pairs, near):
        return None
    if not near.apart[0]:
        return [], []
    both, sure = split(row, index, near, near.apart)
    return (list(both[:, 0]), [1, 1]) if sure.all() else None


def _copies(pairs: Complex, near: Folds) -> bool:
    """Whether two solutions that should lie on both sides of a fold lie on one, and away from it.

    Without real modes the sides are those of the imaginary direction.
    """
    center, free = near.directions[0], near.free[0]
    along = np.cross(free, center).ravel()
    offsets = (pairs - center).reshape(2, 6) @ along / (along @ along)
    if near.apart[0]:
        one, other = offsets.real
        return bool(one * other > 0.0 and min(abs(one), abs(other)) > 0.5 * near.reach[0])
    one, other = offsets.imag
    return bool(one * other > 0.0)


def _single(row: Rows, pair: Complex) -> Modes | None:
    if abs(pair.imag).max() > REAL:
        return [], []
    directions, converged = polished(
        row, np.zeros(1, dtype=np.int64), pair.real[np.newaxis], CONVERGED
    )
    stayed = abs(directions[0] - pair.real).max() <= NEARBY
    return ([directions[0]], [1]) if converged[0] and stayed else None


def _multiple(row: Rows, pairs: Complex, tolerance: float) -> Modes | None:
    """Three and more solutions that have merged in one point, if they have."""
    if tolerance == 0.0:
        return None
    middle = np.median(pairs.real, axis=0) + 1j * np.median(pairs.imag, axis=0)
    if abs(middle.imag).max() > NEAR[1]:
        return [], []
    center = _center(row, _orthonormal(middle).real)
    if center is None or abs(center - middle.real).max() > NEAR[0]:
        return None
    local = kernels.fold(row.radius[0], row.joints[0], center)
    covered = (tolerance + ROUNDING * EPS) * abs(local.by_joints).sum(axis=1)
    return ([center], [len(pairs)]) if (abs(local.residual) <= covered).all() else None


def _center(row: Rows, directions: Array) -> Array | None:
    """Where the closure equations hold in all directions but those that G leaves free, and
    where in these directions G stays zero: Gauss and Newton's method."""
    args = row.radius[0], row.position[0], row.lengths[0]
    for _ in range(CENTER_STEPS):
        local = kernels.newton_step(*args, directions)
        left, singular, right = np.linalg.svd(local.gradient)
        free = singular <= max(VANISHING, 10.0 * singular[2] / singular[0]) * singular[0]
        y, v = left[:, free], right[free].T
        turns = TURN * np.concatenate([np.eye(3), -np.eye(3)])
        around = kernels.newton_step(*args, turn_by(np.tile(directions, (6, 1, 1)), turns)).gradient
        bend = (around[:3] - around[3:]) / (2.0 * TURN)
        flat = np.einsum("ip,kij,jq->pqk", y, bend, v).reshape(-1, 3)
        matrix = np.concatenate([left[:, ~free].T @ local.gradient, flat])
        side = np.concatenate(
            [left[:, ~free].T @ local.residual, (y.T @ local.gradient @ v).ravel()]
        )
        turn = -np.linalg.lstsq(matrix, side, rcond=VANISHING)[0]
        if not np.isfinite(turn).all() or abs(turn).max() > 0.1:
            return None
        directions = turn_by(directions[np.newaxis], turn[np.newaxis])[0]
        if abs(turn).max() <= EPS:
            break
    return directions


def _couple(row: Rows, pairs: Complex) -> Modes | None:
    """Two solutions close together that are no fold: each in a ball of its own, or None."""
    real: Mask = np.max(abs(pairs.imag), axis=(1, 2)) <= REAL
    points = np.where(real[:, np.newaxis, np.newaxis], pairs.real, pairs)
    points, _ = polished_pairs(row, points[np.newaxis], NEWTON)
    radii = radii_of_directions(row, points[0])
    if not abs(points[0, 0] - points[0, 1]).max() > radii.sum():
        return None
    if not (real | (abs(points[0].imag).max(axis=(1, 2)) > radii)).all():
        return None
    modes = [point.real for point in points[0][real]]
    return modes, [1] * len(modes)
