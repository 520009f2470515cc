"""Every row by the way that suits it, and what is known of the rows in the end."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import BackendError
from kleinform.forward.cases import IN_PLANE, near_plane, on_circle, zero_leg
from kleinform.forward.circle import AXES, Rows
from kleinform.forward.clusters import by_pencil
from kleinform.forward.eliminant import by_eliminant
from kleinform.forward.found import Found, found, some, together
from kleinform.forward.in_plane import by_circles
from kleinform.forward.zero_legs import by_zero_leg
from kleinform.generated import kernels
from kleinform.sums import dot
from kleinform_kernels._threads import in_parts

if kernels.BACKEND == "compiled":
    try:
        from kleinform.forward import _compiled
    except ImportError as error:
        raise BackendError(f"compiled only in part: {error}; reinstall kleinform") from error

__all__ = [
    "INFINITE",
    "INVALID",
    "STATUS",
    "UNDECIDED",
    "Solved",
    "by_numpy",
    "completed",
    "solve",
    "unit_size",
]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

#: What is known of a row of joint values.
STATUS = ("regular", "merged", "none", "infinite", "undecided", "invalid")
REGULAR, MERGED, NONE, INFINITE, UNDECIDED, INVALID = range(len(STATUS))
#: Rows that a thread takes at once from the compiled solver: some milliseconds.
PART = 1024
#: Rows that are solved at once on NumPy, so that what lies between stays in cache.
BLOCK = 512
#: Closure equations (6) of a mode: their residual relative to the sum of their terms.
RESIDUAL = 1e-12
#: What is added to it for merged modes, in tolerances of the joint values.
MERGED_RESIDUAL = 16.0


class Solved(NamedTuple):
    """Modes of rows, sorted by row and within a row, and the status of each row."""

    row: Integers
    rotation: Array
    directions: Array
    platform_joints: Array
    extension: Array
    multiplicity: Integers
    status: Integers


def solve(rows: Rows, tolerance: float) -> Solved:
    """All assembly modes of rows of joint values.

    The compiled solver comes first, and NumPy does the rows that it leaves: those with modes
    that are close or special.
    """
    if kernels.BACKEND != "compiled":
        return by_numpy(rows, tolerance)
    count, *modes = _by_compiled(rows, tolerance)
    row = np.repeat(np.arange(len(rows)), np.maximum(count, 0))
    status = np.where(count == 0, NONE, REGULAR)
    settled = Solved._make((row, *modes, np.ones(len(row), dtype=np.int64), status))
    left = np.flatnonzero(count < 0)
    return _filled(settled, left, by_numpy(rows[left], tolerance)) if len(left) else settled


def _by_compiled(rows: Rows, tolerance: float) -> list[Any]:
    """What the compiled solver gives, on several threads if there are many rows."""
    parts: dict[int, tuple[Any, ...]] = {}

    def run(start: int, stop: int) -> None:
        part = rows[start:stop]
        parts[start] = _compiled.solve(part.radius, part.position, part.lengths, tolerance)

    if len(rows) <= PART:
        run(0, len(rows))
        return list(parts[0])
    in_parts(run, len(rows), PART)
    ordered = [parts[start] for start in sorted(parts)]
    return [np.concatenate(entries) for entries in zip(*ordered, strict=True)]


def by_numpy(rows: Rows, tolerance: float) -> Solved:
    """All assembly modes without the compiled solver, which it is the reference for."""
    scaled, scale = unit_size(rows)
    parts = []
    for start in range(0, len(rows), BLOCK):
        modes, status = _block(scaled[start : start + BLOCK], tolerance)
        parts.append((modes._replace(row=modes.row + start), status))
    modes = together([part for part, _ in parts])
    status = np.concatenate([np.empty(0, np.int64), *(part for _, part in parts)])
    modes = modes._replace(extension=modes.extension / scale[modes.row, np.newaxis])
    return _complete(rows, modes, status, tolerance)


def _filled(settled: Solved, left: Integers, others: Solved) -> Solved:
    """The modes of the rows that were left, in their places."""
    others = others._replace(row=left[others.row])
    place = np.searchsorted(settled.row, others.row)
    pairs = zip(settled[:-1], others[:-1], strict=True)
    entries = [np.insert(entry, place, other, axis=0) for entry, other in pairs]
    status = settled.status.copy()
    status[left] = others.status
    return Solved._make((*entries, status))


def completed(rows: Rows, modes: Found) -> Solved:
    """Everything that follows from modes that were found elsewhere, all of them simple."""
    return _complete(rows, modes, np.full(len(rows), REGULAR), 0.0)


def unit_size(rows: Rows) -> tuple[Rows, Array]:
    """The same mechanism of a size of about 1, and the scale (N,).

    The scale is a power of two, so that no digit changes.
    """
    position = np.max(abs(rows.position), axis=1)
    size = np.maximum(rows.radius, np.maximum(position, np.max(rows.lengths, axis=1)))
    scale: Array = np.ldexp(1.0, -np.frexp(size)[1])
    joints = rows.joints.copy()
    joints[:, [0, 1, 2, 5]] *= scale[:, np.newaxis]
    position, lengths = (entry * scale[:, np.newaxis] for entry in (rows.position, rows.lengths))
    return Rows(rows.radius * scale, position, lengths, joints), scale


def _block(rows: Rows, tolerance: float) -> tuple[Found, Integers]:
    infinite = on_circle(rows, tolerance).any(axis=1)
    zero = zero_leg(rows)
    pointlike = zero.any(axis=1) & ~infinite
    flat = near_plane(rows).any(axis=1)
    planes = near_plane(rows, IN_PLANE).sum(axis=1)
    ordinary = ~(infinite | pointlike)
    # Without a tolerance nothing says that equations agree: only that they do not.
    sharp = tolerance == 0.0
    status = np.where(infinite & (not sharp), INFINITE, UNDECIDED)
    parts = []
    for number in np.flatnonzero(pointlike):
        limb = int(np.argmax(zero[number]))
        directions = by_zero_leg(rows[[int(number)]], limb, tolerance)
        if not (sharp and len(directions)):
            status[number] = REGULAR
            parts.append(found(np.full(len(directions), number), directions, 2))
    ways = (
        # Two legs with C in their planes: the eliminant of one is a square.
        (ordinary & (planes < 2), by_eliminant),
        (ordinary & ~flat, by_pencil),
        (ordinary & flat, by_circles),
        (ordinary & flat & (planes == 0), by_pencil),
    )
    for mask, way in ways:
        chosen = np.flatnonzero(mask & (status == UNDECIDED))
        if len(chosen):
            modes, solved = way(rows[chosen], tolerance)
            kept = some(modes, solved[modes.row])
            parts.append(kept._replace(row=chosen[kept.row]))
            status[chosen[solved]] = REGULAR
    return together(parts), status


def _complete(rows: Rows, modes: Found, status: Integers, tolerance: float) -> Solved:
    """Everything that follows from the directions of each mode."""
    row, directions = modes.row, modes.directions
    radius, position = rows.radius[row], rows.position[row]
    three = np.concatenate([directions, -directions.sum(axis=1, keepdims=True)], axis=1)
    extension = _fitted(rows, modes, three)
    sign = np.where(_needs_reflection(extension), -1.0, 1.0)
    extension *= sign[:, np.newaxis]
    three *= sign[:, np.newaxis, np.newaxis]
    turned = kernels.rotation_from_directions(three[:, 0], three[:, 1])
    rotation = np.ascontiguousarray(turned.rotation)
    points = position[:, np.newaxis] + extension[..., np.newaxis] * three
    squares = dot(points, points)
    terms = radius[:, np.newaxis] ** 2 + rows.lengths[row] ** 2
    # Where modes have merged the equations hold for joint values within the tolerance.
    allowed = RESIDUAL + MERGED_RESIDUAL * tolerance * (modes.multiplicity > 1)
    residual = abs(squares - terms) / (squares + terms)
    bad = ~(residual <= allowed[:, np.newaxis]).all(axis=1)
    status = status.copy()
    status[row[bad]] = UNDECIDED
    status[row[(modes.multiplicity > 1) & (status[row] == REGULAR)]] = MERGED
    none = np.bincount(row, minlength=len(rows)) == 0
    status[none & (status == REGULAR)] = NONE
    return _sorted(Solved(row, rotation, three, points, extension, modes.multiplicity, status))


def _fitted(rows: Rows, modes: Found, directions: Array) -> Array:
    """The e_i, by (4) where they are not known yet, and one step of Gauss and Newton's method.

    B_i = c + e_i n_i lies in the plane of its leg and at the leg's length from A_i. Where n_i
    is almost parallel to the plane, (4) alone leaves e_i uncertain.
    """
    row = modes.row
    from_foot = rows.position[:, np.newaxis] - rows.radius[:, np.newaxis, np.newaxis] * AXES
    from_foot = from_foot[row]
    incidence = dot(directions, AXES)
    with np.errstate(divide="ignore", invalid="ignore"):
        by_plane = -dot(from_foot, AXES) / incidence
        extension: Array = np.where(np.isnan(modes.extension), by_plane, modes.extension)
        leg = from_foot + extension[..., np.newaxis] * directions
        length = np.sqrt(dot(leg, leg))
        along = dot(leg, directions) / length
        step = incidence * dot(leg, AXES)
        step += along * (length - rows.lengths[row])
        step /= incidence**2 + along**2
    return extension - np.where(length > 0.0, step, 0.0)


def _needs_reflection(extension: Array) -> Mask:
    """Of each pair ±n the one with more e_i > 0 than e_i < 0; of equals, the first e_i > 0."""
    signs = (extension > 0.0).astype(np.int64) - (extension < 0.0)
    balance = signs.sum(axis=1)
    first = signs[np.arange(len(signs)), np.argmax(signs != 0, axis=1)]
    return np.asarray((balance < 0) | ((balance == 0) & (first < 0)))


def _sorted(solved: Solved) -> Solved:
    """By row; then feasible modes first; then by the angles of legs 1 and 2, falling."""
    feasible = (solved.extension > 0.0).all(axis=1)
    keys = [-_leg_angle(solved, limb) for limb in (1, 0)]
    order = np.lexsort((*keys, ~feasible, solved.row))
    return Solved._make([*(entry[order] for entry in solved[:-1]), solved.status])


def _leg_angle(solved: Solved, limb: int) -> Array:
    """The angle of B_i about the axis of its base revolute, from t_i, in [0, 2π)."""
    turn = 2.0 * np.pi / 3.0 * limb
    points = solved.platform_joints[:, limb]
    along = np.cos(turn) * points[:, 1] - np.sin(turn) * points[:, 0]
    angle: Array = np.arctan2(points[:, 2], along) % (2.0 * np.pi)
    return angle
