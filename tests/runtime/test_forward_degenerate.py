"""Limbs that are special: C in the plane of a leg, on the circle of B, lengths of zero."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import UncoupledManipulator
from kleinform_kernels.uncoupled import mpmath_kernels
from tests.runtime.modes_support import cross, posed
from tests.support import BASE_AXES, platform_directions, random_rotation

ROBOT = UncoupledManipulator()
SIDE = np.cross([0.0, 0.0, 1.0], BASE_AXES)


def central(position: np.ndarray) -> list[float]:
    x, y, z = position
    radial = np.hypot(x, y)
    return [np.arctan2(y, x), np.arctan2(z, radial), np.hypot(radial, z)]


def in_the_plane(limbs: list[int], rng: np.random.Generator) -> np.ndarray:
    """C with c·u_i = a."""
    height = rng.uniform(0.4, 1.5)
    if len(limbs) == 1:
        across = rng.uniform(-0.6, 0.6) * SIDE[limbs[0]]
        return BASE_AXES[limbs[0]] + across + [0.0, 0.0, height]
    x, y = np.linalg.solve(BASE_AXES[limbs, :2], np.ones(2))
    return np.array([x, y, height])


def platform_at(position: np.ndarray, limb: int, rng: np.random.Generator) -> np.ndarray:
    """A rotation with n_i normal to u_i: B_i may be anywhere on the line through C along n_i."""
    axis, side = BASE_AXES[limb], SIDE[limb]
    angle = rng.uniform(0.0, np.pi)
    n = np.cos(angle) * side + np.sin(angle) * np.array([0.0, 0.0, 1.0])
    other = rng.uniform(-1.0, 1.0) * axis + rng.uniform(-1.0, 1.0) * np.cross(n, axis)
    frame = np.column_stack([n, other / np.linalg.norm(other), np.zeros(3)])
    frame[:, 2] = np.cross(frame[:, 0], frame[:, 1])
    return frame @ Rotation.from_euler("z", -120.0 * limb, degrees=True).as_matrix()


@pytest.mark.parametrize("limb", [0, 1, 2])
def test_c_in_the_plane_of_a_leg(limb: int) -> None:
    """n_i turns in that plane, and its line meets the circle of B_i twice: two modes, one R."""
    rng = np.random.default_rng(40 + limb)
    found = 0
    for _ in range(40):
        position = in_the_plane([limb], rng)
        rotation = platform_at(position, limb, rng)
        n = platform_directions(rotation)
        others = [i for i in range(3) if i != limb]
        if np.min(abs(np.sum(n * BASE_AXES, axis=1))[others]) < 0.1:
            continue
        e = np.zeros(3)
        e[others] = [(1.0 - position @ BASE_AXES[i]) / (n[i] @ BASE_AXES[i]) for i in others]
        e[limb] = rng.uniform(0.5, 2.0)
        legs = position + e[:, np.newaxis] * n - BASE_AXES
        joints = np.array([*np.linalg.norm(legs, axis=1), *central(position)])
        modes = ROBOT.forward_displacement(joints)
        assert modes.status == "regular"
        assert modes.degenerate == (f"c·u_{limb + 1} = a",)
        same = np.minimum(*(abs(modes.directions - sign * n).max((1, 2)) for sign in (1.0, -1.0)))
        pair = np.flatnonzero(same <= 1e-9)
        assert len(pair) == 2
        first, second = modes.platform_joints[pair]
        assert np.max(abs(first - second)[others]) <= 1e-8
        assert np.linalg.norm((first - second)[limb]) > 1e-3
        wanted = position + e[limb] * n[limb]
        assert min(abs(first[limb] - wanted).max(), abs(second[limb] - wanted).max()) <= 1e-8
        # Either has the length of the leg, as all modes have.
        lengths = np.linalg.norm(modes.platform_joints - BASE_AXES, axis=2)
        assert np.max(abs(lengths / joints[:3] - 1.0)) <= 1e-9
        assert np.max(abs(np.sum(modes.platform_joints * BASE_AXES, axis=2) - 1.0)) <= 1e-9
        assert len(modes) % 2 == 0
        found += 1
    assert found >= 20


@pytest.mark.parametrize("limbs", [[0, 1], [0, 2], [1, 2]])
def test_c_in_the_planes_of_two_legs(limbs: list[int]) -> None:
    rng = np.random.default_rng(44)
    third = 3 - sum(limbs)
    counts = []
    for _ in range(15):
        position = in_the_plane(limbs, rng)
        lengths = rng.uniform(0.8, 3.0, 3)
        modes = ROBOT.forward_displacement([*lengths, *central(position)])
        assert modes.status in ("regular", "none")
        assert modes.degenerate == tuple(f"c·u_{i + 1} = a" for i in limbs)
        incidence = np.sum(modes.directions * BASE_AXES, axis=2)
        assert np.max(abs(incidence[:, limbs]), initial=0.0) <= 1e-7
        legs = np.linalg.norm(modes.platform_joints - BASE_AXES, axis=2)
        assert np.max(abs(legs / lengths - 1.0), initial=0.0) <= 1e-9
        along = abs(modes.platform_joints[:, third] @ BASE_AXES[third] - 1.0)
        assert np.max(along, initial=0.0) <= 1e-9
        counts.append(len(modes))
    # Both e of both limbs: modes come in fours.
    assert not np.any(np.array(counts) % 4)
    assert max(counts) >= 4


@pytest.mark.parametrize("limb", [0, 1, 2])
def test_c_on_the_circle_of_b(limb: int) -> None:
    """With B_i at C the limb holds nothing."""
    rng = np.random.default_rng(50 + limb)
    for _ in range(20):
        position = in_the_plane([limb], rng)
        lengths = rng.uniform(0.5, 2.0, 3)
        lengths[limb] = np.linalg.norm(position - BASE_AXES[limb])
        modes = ROBOT.forward_displacement([*lengths, *central(position)])
        assert (modes.status, len(modes)) == ("infinite", 0)
        assert "circle of B_i" in modes.reason
        assert modes.degenerate == (f"c·u_{limb + 1} = a",)


def at_its_base(limb: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """A pose with B_i at A_i."""
    position = rng.normal([0.0, 0.0, 1.0], 0.4)
    n = BASE_AXES[limb] - position
    n /= np.linalg.norm(n)
    m = np.cross(n, rng.normal(size=3))
    frame = np.column_stack([n, m / np.linalg.norm(m), np.zeros(3)])
    frame[:, 2] = np.cross(frame[:, 0], frame[:, 1])
    return position, frame @ Rotation.from_euler("z", -120.0 * limb, degrees=True).as_matrix()


def rounded_at_its_base(limb: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Joint values with q_i = 0 that a pose has, rounded once from 30 digits; and its n_i."""
    position, rotation = at_its_base(limb, rng)
    joints = [0.0, 0.0, 0.0, *central(position)]
    with mpmath.workdps(30):
        c = mpmath_kernels.central_forward(joints[3:]).position
        third = [mpmath.mpf(-1) / 2, mpmath.sqrt(3) / 2]
        axes = [[1, 0, 0], [third[0], third[1], 0], [third[0], -third[1], 0]]
        arm = [axes[limb][k] - c[k] for k in range(3)]
        own = [entry / mpmath.norm(arm) for entry in arm]
        side = cross(own, [mpmath.mpf(entry) for entry in rotation[:, 2].tolist()])
        side = [entry / mpmath.norm(side) for entry in side]
        for step in (1, 2):
            other = (limb + step) % 3
            sign = 1 if step == 1 else -1
            n = [third[0] * x + sign * third[1] * y for x, y in zip(own, side, strict=True)]
            across = 1 - sum(x * y for x, y in zip(c, axes[other], strict=True))
            e = across / sum(x * y for x, y in zip(n, axes[other], strict=True))
            leg = [c[k] + e * n[k] - axes[other][k] for k in range(3)]
            joints[other] = float(mpmath.norm(leg))
    values = np.array([[float(entry) for entry in row] for row in (own, side)])
    following = -0.5 * values[0] + np.sqrt(0.75) * values[1]
    three = np.array([values[0], following, -values[0] - following])
    return np.array(joints), np.roll(three, limb, axis=0)


@pytest.mark.parametrize("limb", [0, 1, 2])
def test_a_leg_of_length_zero(limb: int) -> None:
    """Two equations for one turn: joint values of a pose have it, others have none."""
    rng = np.random.default_rng(60 + limb)
    undecided = 0
    for _ in range(40):
        joints, n = rounded_at_its_base(limb, rng)
        modes = ROBOT.forward_displacement(joints)
        # Where another n_j·u_j is small, rounded joint values miss (6) by more than 1e-12.
        if modes.status == "undecided":
            undecided += 1
            continue
        assert modes.status == "merged"
        assert modes.degenerate == (f"q_{limb + 1} = 0",)
        gaps = [abs(modes.directions - sign * n).max((1, 2)) for sign in (1.0, -1.0)]
        assert np.min(gaps) <= 1e-7
        assert modes.multiplicity.tolist() == [2] * len(modes)
        assert np.max(abs(modes.platform_joints[:, limb] - BASE_AXES[limb])) <= 1e-12
        joints[(limb + 1) % 3] *= 1.1
        modes = ROBOT.forward_displacement(joints)
        assert (modes.status, len(modes)) == ("none", 0)
    assert undecided <= 3


def test_a_short_leg_is_no_leg_of_length_zero() -> None:
    """The pose is found, whatever merges with it."""
    rng = np.random.default_rng(63)
    for length in (1e-3, 1e-6):
        for _ in range(20):
            position, rotation = at_its_base(0, rng)
            nudge = Rotation.from_rotvec(length * rng.normal(size=3)).as_matrix()
            poses = posed(position[np.newaxis], (nudge @ rotation)[np.newaxis])
            modes = ROBOT.forward_displacement(poses.joints[0])
            assert modes.status in ("regular", "merged")
            gap = abs(modes.rotation - poses.rotation[0]).max((1, 2))
            other = abs(modes.reflected().rotation - poses.rotation[0]).max((1, 2))
            assert min(gap.min(), other.min()) <= 1e-7


def test_c_at_o() -> None:
    """q_6 = 0: the angles of the central limb say nothing, any will do."""
    rng = np.random.default_rng(64)
    for _ in range(40):
        poses = posed(np.zeros((1, 3)), random_rotation(rng)[np.newaxis], least=0.05)
        if not len(poses.joints):
            continue
        joints = poses.joints[0]
        joints[3:] = rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5), 0.0
        modes = ROBOT.forward_displacement(joints)
        assert modes.status in ("regular", "merged")
        assert modes.degenerate == ("q_6 = 0",)
        assert np.array_equal(modes.position, np.zeros(3))
        gap = abs(modes.rotation - poses.rotation[0]).max((1, 2))
        other = abs(modes.reflected().rotation - poses.rotation[0]).max((1, 2))
        assert min(gap.min(), other.min()) <= 1e-7


def test_all_lengths_zero() -> None:
    """Every B_i at A_i and C at O: R = I."""
    modes = ROBOT.forward_displacement(np.zeros(6))
    assert modes.degenerate == ("q_1 = 0", "q_2 = 0", "q_3 = 0", "q_6 = 0")
    assert modes.status == "merged"
    assert np.max(abs(modes.platform_joints - BASE_AXES)) <= 1e-12
    assert np.min(abs(modes.rotation - np.eye(3)).max((1, 2))) <= 1e-12
