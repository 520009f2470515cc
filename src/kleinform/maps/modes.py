"""How many assembly modes there are, over sections of joint space and of the workspace."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.conditioning import singular_values
from kleinform.errors import InputError, ShapeError
from kleinform.generated import kernels
from kleinform.manipulator import UncoupledManipulator
from kleinform.pose import check_pose
from kleinform.screening import Errors, RotationLike, is_whole, one_rotation, real_array

__all__ = ["ModeMap", "conditioning", "joint_map", "workspace_map"]

Array = NDArray[np.float64]
Counts = NDArray[np.int64]
Range = tuple[float, float]
JOINTS = ("q1", "q2", "q3", "q4", "q5", "q6")
#: What `ModeMap.counts` has where the modes are infinitely many, undecided, or refused.
UNKNOWN = -1
#: Statuses whose modes are counted: regular, merged, none.
COUNTED = (0, 1, 2)
#: Halvings of a grid's edge. Nearer to where modes merge every count is slow.
HALVINGS = 16


@dataclass(frozen=True, eq=False)
class ModeMap:
    """The number of assembly modes over a rectangle.

    Attributes
    ----------
    first, second : array (n,)
        Values along both axes.
    counts : int array (n, n)
        Modes at ``(first[i], second[j])``, one of each pair ±n; −1 where they are infinitely
        many or not decided.
    curves : array (m, 2)
        Points on the singularity curves that separate regions of different numbers, one on
        each edge of the grid whose ends differ, to 1e-4 of the edge.
    segments : array (k, 2, 2)
        The two points of each cell that has two, which a line may join.
    """

    first: Array
    second: Array
    counts: Counts
    curves: Array
    segments: Array


def joint_map(
    robot: UncoupledManipulator,
    joints: ArrayLike,
    axes: tuple[str, str],
    ranges: tuple[Range, Range],
    resolution: int = 101,
) -> ModeMap:
    """The number of modes over two joint values, the others fixed.

    Parameters
    ----------
    robot : UncoupledManipulator
    joints : array_like (6,)
        The joint values that stay; those of both axes are not used.
    axes : two of "q1" ... "q6"
    ranges : two of (low, high)
        In m or rad.
    resolution : int
        Samples along each axis.

    Raises
    ------
    InputError, JointRangeError
    """
    fixed = real_array("joints", joints, (6,))
    if fixed.ndim != 1:
        raise ShapeError(f"joints: shape (6,) is needed, {fixed.shape} arrived")
    if len(axes) != 2 or axes[0] == axes[1] or not all(axis in JOINTS for axis in axes):
        raise InputError(f"axes: two of {', '.join(JOINTS)} are needed, {axes!r} arrived")
    columns = [JOINTS.index(axis) for axis in axes]

    def count(points: Array) -> Counts:
        rows = np.broadcast_to(fixed, (len(points), 6)).copy()
        rows[:, columns] = points
        return _counts(robot, rows)

    return _map(count, ranges, resolution)


def workspace_map(
    robot: UncoupledManipulator,
    rotation: RotationLike,
    height: float,
    ranges: tuple[Range, Range],
    resolution: int = 101,
) -> ModeMap:
    """The number of modes of the joint values that poses of one orientation have.

    Parameters
    ----------
    robot : UncoupledManipulator
    rotation : array_like (3, 3), or anything with ``as_matrix()``
    height : float
        z of C [m].
    ranges : two of (low, high)
        x and y of C [m].
    resolution : int
        Samples along each axis.

    Raises
    ------
    InputError, SingularPoseError
    """
    turn = one_rotation("rotation", rotation)
    level = _finite("height", height)

    def count(points: Array) -> Counts:
        positions = np.column_stack([points, np.full(len(points), level)])
        return _counts(robot, robot.inverse_displacement(positions, turn, azimuth=0.0))

    return _map(count, ranges, resolution)


def conditioning(
    robot: UncoupledManipulator,
    position: ArrayLike,
    rotation: RotationLike,
    *,
    errors: Errors = "raise",
) -> Array:
    """Singular values of the moments of S_1, S_2, S_3 about C.

    They map the angular velocity to what the outer limbs feel of it; C is moved by the
    central limb alone. The smallest is zero at a direct singularity, and the largest over the
    smallest is a condition number. `UncoupledManipulator.conditioning` has them among others.

    Parameters
    ----------
    robot : UncoupledManipulator
    position : array_like (..., 3)
        C [m].
    rotation : array_like (..., 3, 3), or anything with ``as_matrix()``
    errors : {"raise", "nan"}

    Returns
    -------
    array (..., 3)
        Falling [m].

    Raises
    ------
    SingularPoseError
        ``n_i·u_i = 0`` or ``q_i = 0``: a line S_i has no place or no direction.
    InputError
    """
    pose = check_pose(robot, position, rotation, errors)
    result = kernels.jacobians(pose.radius, pose.position, pose.rotation, pose.heading())
    pose.reject_legs(result)
    pose.screen.settle()
    # The first columns of J_v are S_1, S_2, S_3.
    return singular_values(result.J_v[..., 3:, :3], pose.screen.valid)


def _counts(robot: UncoupledManipulator, joints: Array) -> Counts:
    """The number of modes of each row."""
    batch = robot.forward_displacement_batch(joints)
    known = np.isin(batch.status_codes, COUNTED)
    return np.where(known, np.diff(batch.offsets), UNKNOWN)


def _map(count: Callable[[Array], Counts], ranges: tuple[Range, Range], resolution: int) -> ModeMap:
    """Count on a grid, and find where the number changes along its edges."""
    if len(ranges) != 2:
        raise InputError(f"ranges: two of (low, high) are needed, {ranges!r} arrived")
    first, second = (_even(limits, resolution) for limits in ranges)
    grid = np.stack(np.meshgrid(first, second, indexing="ij"), axis=-1)
    counts = count(grid.reshape(-1, 2)).reshape(resolution, resolution)
    points, cells = [], []
    for axis in (0, 1):
        before = (slice(None, -1), slice(None)) if axis == 0 else (slice(None), slice(None, -1))
        after = (slice(1, None), slice(None)) if axis == 0 else (slice(None), slice(1, None))
        edges = np.argwhere(counts[before] != counts[after])
        ends = grid[before][tuple(edges.T)], grid[after][tuple(edges.T)]
        points.append(_between(count, *ends, counts[before][tuple(edges.T)]))
        # An edge belongs to the cells on both of its sides.
        cells += [edges, edges - np.eye(2, dtype=np.int64)[1 - axis]]
    curves = np.concatenate(points)
    return ModeMap(first, second, counts, curves, _segments(curves, points, cells))


def _even(limits: Range, resolution: int) -> Array:
    ends = real_array("ranges", limits, (2,))
    if ends.ndim != 1:
        raise ShapeError(f"ranges: (low, high) is needed, {limits!r} arrived")
    low, high = (_finite("ranges", end) for end in ends)
    if not low < high:
        raise InputError(f"ranges: low < high is needed, {limits!r} arrived")
    if not is_whole(resolution) or resolution < 2:
        raise InputError(f"resolution: at least 2 is needed, {resolution!r} arrived")
    return np.linspace(low, high, resolution)


def _finite(name: str, value: ArrayLike) -> float:
    number = real_array(name, value, ())
    if number.ndim or not np.isfinite(number):
        raise InputError(f"{name}: one finite number is needed, {value!r} arrived")
    return float(number)


def _between(count: Callable[[Array], Counts], low: Array, high: Array, at_low: Counts) -> Array:
    """Where the number changes between two points each, by bisection of all at once."""
    low, high = low.copy(), high.copy()
    if len(low):
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            same = count(middle) == at_low
            low[same], high[~same] = middle[same], middle[~same]
    return high


def _segments(curves: Array, points: list[Array], cells: list[Counts]) -> Array:
    """The points of cells that have two."""
    upright, level = len(points[0]), len(points[1])
    numbers = [np.arange(upright)] * 2 + [upright + np.arange(level)] * 2
    cell, number = np.concatenate(cells), np.concatenate(numbers)
    order = np.lexsort((cell[:, 1], cell[:, 0]))
    _, start, size = np.unique(cell[order], axis=0, return_index=True, return_counts=True)
    two = start[size == 2]
    pairs: Array = curves[np.stack([number[order][two], number[order][two + 1]], axis=1)]
    return pairs
