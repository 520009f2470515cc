"""Poses by the thousand, their joint values by plain geometry, and modes found beside them."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import mpmath
import numpy as np
from scipy.spatial.transform import Rotation

from kleinform import AssemblyModesBatch, UncoupledManipulator
from kleinform_kernels.uncoupled import mpmath_kernels
from tests.support import BASE_AXES, EPS, platform_directions

#: The paper's pose, Section VI.
HOME = (np.array([0.25, 0.2, 1.0]), Rotation.from_euler("ZYX", [6, 3, 10], degrees=True))
#: Random poses: C and the orientation, from the middle of the workspace to anywhere.
SPREADS = ("workspace", "around", "far")


class Poses(NamedTuple):
    """Poses of a manipulator of radius 1, and their joint values (N, 6)."""

    position: np.ndarray
    rotation: np.ndarray
    joints: np.ndarray


def posed(position: np.ndarray, rotation: np.ndarray, least: float = 0.0) -> Poses:
    """Poses with every ``|n_i·u_i| > least``, and the joint values from B_i = c + e_i n_i."""
    directions = platform_directions(rotation)
    incidence = np.sum(directions * BASE_AXES, axis=-1)
    kept = np.all(abs(incidence) > least, axis=-1)
    position, rotation, directions = position[kept], rotation[kept], directions[kept]
    extension = (1.0 - position @ BASE_AXES.T) / incidence[kept]
    legs = position[:, np.newaxis] + extension[..., np.newaxis] * directions - BASE_AXES
    radial = np.hypot(position[:, 0], position[:, 1])
    azimuth = np.arctan2(position[:, 1], position[:, 0])
    central = azimuth, np.arctan2(position[:, 2], radial), np.hypot(radial, position[:, 2])
    joints = np.column_stack([np.linalg.norm(legs, axis=-1), *central])
    return Poses(position, rotation, joints)


def random_poses(rng: np.random.Generator, count: int, spread: str) -> Poses:
    """About as many random poses, those with B_i very far out left out."""
    if spread == "workspace":
        position = rng.normal([0.0, 0.0, 1.0], 0.4, (count, 3))
        rotation = Rotation.from_euler("ZYX", rng.uniform(-1.2, 1.2, (count, 3)))
    else:
        position = rng.normal(size=(count, 3)) * (3.0 if spread == "far" else 1.0)
        rotation = Rotation.random(count, rng=rng)
    return posed(position, rotation.as_matrix(), least=1e-3)


def random_joints(rng: np.random.Generator, count: int) -> np.ndarray:
    """Joint values of no pose in particular: a third of them have none."""
    lengths, central = rng.uniform(0.2, 3.0, (count, 3)), rng.uniform(0.2, 2.5, count)
    azimuth, elevation = rng.uniform(-np.pi, np.pi, count), rng.uniform(-1.5, 1.5, count)
    return np.column_stack([lengths, azimuth, elevation, central])


@cache
def solved(spread: str) -> tuple[Poses, AssemblyModesBatch]:
    """A third of 100,000 random poses, and all modes of their joint values."""
    poses = random_poses(np.random.default_rng(7), 33_500, spread)
    return poses, UncoupledManipulator().forward_displacement_batch(poses.joints)


def row_of(batch: AssemblyModesBatch) -> np.ndarray:
    """The row of each mode of a batch."""
    return np.repeat(np.arange(len(batch)), batch.count)


def distances(batch: AssemblyModesBatch, rotation: np.ndarray) -> np.ndarray:
    """How far (n_1, n_2) of each mode, or of its reflection, is from that of its row's pose."""
    wanted = platform_directions(rotation)[row_of(batch), :2]
    found = batch.directions[:, :2]
    both = [np.linalg.norm(found - sign * wanted, axis=(1, 2)) for sign in (1.0, -1.0)]
    return np.minimum(*both)


def nearest(batch: AssemblyModesBatch, rotation: np.ndarray) -> np.ndarray:
    """How far the nearest mode of each row is from its pose, inf where there is none."""
    least = np.full(len(batch), np.inf)
    np.minimum.at(least, row_of(batch), distances(batch, rotation))
    return least


def statuses(batch: AssemblyModesBatch) -> dict[str, int]:
    """How many rows have each status."""
    count = np.bincount(batch.status_codes, minlength=len(batch.STATUS))
    return {name: int(number) for name, number in zip(batch.STATUS, count, strict=True)}


def turned(rotation: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Rotations turned further by rotation vectors of the base frame."""
    return Rotation.from_rotvec(turn).as_matrix() @ rotation


def cones(position: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    """Matrices (..., 3, 3, 3) with ``n_i·M_i n_i = 0`` for B_i at its distance from A_i.

    With B_i = c + (h_i/n_i·u_i) n_i, it is |B_i|² − a² − q_i², times (n_i·u_i)².
    """
    c, u = position[..., np.newaxis, :], BASE_AXES
    h = (1.0 - np.sum(c * u, axis=-1))[..., np.newaxis, np.newaxis]
    kappa = (np.sum(c * c, axis=-1) - 1.0 - lengths**2)[..., np.newaxis, np.newaxis]
    across = c[..., :, np.newaxis] * u[:, np.newaxis, :]
    along = kappa * u[:, :, np.newaxis] * u[:, np.newaxis, :]
    return along + h * (across + across.swapaxes(-1, -2)) + h**2 * np.eye(3)


def gradients(position: np.ndarray, rotation: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    """How the cones' values change with a turn of the platform, a row a limb (..., 3, 3)."""
    directions = platform_directions(rotation)
    slopes = 2.0 * np.einsum("...ijk,...ik->...ij", cones(position, lengths), directions)
    return np.cross(directions, slopes)


def poses_on_the_locus(
    rng: np.random.Generator, count: int, spread: str
) -> tuple[Poses, np.ndarray]:
    """Poses at which two modes merge, and the turns that no closure equation feels (N, 3).

    Along random turns the determinant of the gradients changes its sign, and the place is
    halved in. e_i and n_i·u_i are kept from the ends of their ranges, and poses near a cusp,
    where three modes merge, are left out.
    """
    found = random_poses(rng, 10 * count, spread)
    way = 0.4 * rng.normal(size=(len(found.joints), 3))

    def at(share: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Rotation, n_i·u_i, e_i and the determinant on the way."""
        there = turned(found.rotation, way * share[:, np.newaxis])
        directions = platform_directions(there)
        incidence = np.sum(directions * BASE_AXES, axis=-1)
        # Some ways pass n_i·u_i = 0, where B_i is at infinity.
        with np.errstate(divide="ignore", invalid="ignore"):
            extension = (1.0 - found.position @ BASE_AXES.T) / incidence
            legs = found.position[:, np.newaxis] + extension[..., np.newaxis] * directions
            lengths = np.linalg.norm(legs - BASE_AXES, axis=-1)
            volume = np.linalg.det(gradients(found.position, there, lengths))
        return there, incidence, extension, volume

    low, high = np.zeros(len(way)), np.ones(len(way))
    first, last = at(low)[3], at(high)[3]
    for _ in range(60):
        middle = 0.5 * (low + high)
        left = np.sign(at(middle)[3]) == np.sign(first)
        low, high = np.where(left, middle, low), np.where(left, high, middle)
    there, incidence, extension, volume = at(low)
    there, extension = Rotation.from_matrix(there).as_matrix(), abs(extension)
    kept = (np.sign(first) != np.sign(last)) & (abs(volume) < 1e-10)
    kept &= np.all((abs(incidence) > 0.05) & (extension > 0.05) & (extension < 20.0), axis=-1)
    poses = posed(found.position[kept], there[kept])
    lengths = poses.joints[:, :3]
    _, singular, right = np.linalg.svd(gradients(poses.position, poses.rotation, lengths))
    free, ahead = right[:, 2], turned(poses.rotation, 1e-3 * right[:, 2])
    bend = np.linalg.det(gradients(poses.position, ahead, lengths)) / 1e-3
    plain = np.flatnonzero(abs(bend) >= 0.03 * singular[:, 0] ** 2 * singular[:, 1])[:count]
    assert len(plain) == count
    return Poses(*(entry[plain] for entry in poses)), free[plain]


def rounded_joints(poses: Poses) -> np.ndarray:
    """Joint values of the poses as 30 digits say, rounded once."""
    rows = []
    with mpmath.workdps(30):
        for position, rotation in zip(poses.position, poses.rotation, strict=True):
            matrix = mpmath.matrix(rotation.tolist())
            # What 16 digits miss of a rotation, by Newton's method.
            for _ in range(2):
                matrix = matrix * (3 * mpmath.eye(3) - matrix.T * matrix) / 2
            exact = mpmath_kernels.inverse_displacement(1, position.tolist(), matrix.tolist())
            rows.append([float(value) for value in exact.joints])
    return np.array(rows)


def double_root_within(joints: np.ndarray, directions: np.ndarray) -> float:
    """How many eps the joint values must change, each relatively, to have a double root.

    30 digits, and Newton's method to the fold that is nearest to the directions: the place
    where a combination y of the closure equations is stationary and the others hold. The
    height of y·F there, over the sum of how much each ln q_j moves it.
    """
    with mpmath.workdps(30):
        exact = [mpmath.mpf(value) for value in joints.tolist()]
        n = unit_pair([[mpmath.mpf(entry) for entry in row] for row in directions[:2].tolist()])
        weights = None
        for _ in range(4):
            local = mpmath_kernels.fold(1, exact, n)
            gradient = mpmath.matrix(local.gradient)
            if weights is None:
                weights = left_null(gradient)
                aside = mpmath.mpf(0)
            system, side = mpmath.matrix(4, 4), mpmath.matrix(4, 1)
            for i in range(3):
                for j in range(3):
                    system[i, j] = gradient[i, j]
                system[i, 3], system[3, i] = -weights[i], local.volume_gradient[i]
                side[i] = local.residual[i] - aside * weights[i]
            side[3] = local.volume
            step = mpmath.lu_solve(system, -side)
            aside += step[3]
            n = [turned_exactly(row, list(step[:3])) for row in n]
        assert max(abs(entry) for entry in step) < 1e-20
        local = mpmath_kernels.fold(1, exact, n)
        weights = left_null(mpmath.matrix(local.gradient))
        height = sum(weights[i] * local.residual[i] for i in range(3))
        slopes = [sum(weights[i] * local.by_joints[i][j] for i in range(3)) for j in range(6)]
        return float(abs(height) / sum(map(abs, slopes)) / EPS)


def unit_pair(pair: list[list[mpmath.mpf]]) -> list[list[mpmath.mpf]]:
    """Unit vectors 120° apart: the first, and the second in the plane of both."""
    first = [entry / mpmath.norm(pair[0]) for entry in pair[0]]
    normal = cross(first, pair[1])
    across = [entry / mpmath.norm(normal) for entry in cross(normal, first)]
    root = mpmath.sqrt(mpmath.mpf(3)) / 2
    return [first, [-x / 2 + root * y for x, y in zip(first, across, strict=True)]]


def left_null(matrix: mpmath.matrix) -> list[mpmath.mpf]:
    """The unit combination of the rows of a singular matrix that vanishes."""
    columns = [[matrix[i, j] for i in range(3)] for j in range(3)]
    crosses = [cross(columns[j], columns[(j + 1) % 3]) for j in range(3)]
    longest = max(crosses, key=mpmath.norm)
    return [entry / mpmath.norm(longest) for entry in longest]


def cross(one: list[mpmath.mpf], two: list[mpmath.mpf]) -> list[mpmath.mpf]:
    ahead, behind = (1, 2, 0), (2, 0, 1)
    return [one[ahead[i]] * two[behind[i]] - one[behind[i]] * two[ahead[i]] for i in range(3)]


def turned_exactly(vector: list[mpmath.mpf], turn: list[mpmath.mpf]) -> list[mpmath.mpf]:
    """Cayley's rotation."""
    half = [entry / 2 for entry in turn]
    inner = [x + y for x, y in zip(vector, cross(half, vector), strict=True)]
    factor = 2 / (1 + sum(entry**2 for entry in half))
    return [x + factor * y for x, y in zip(vector, cross(half, inner), strict=True)]
