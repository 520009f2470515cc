"""What forward_displacement returns, by Table 1 of the paper and by random joint values."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import (
    AssemblyModes,
    InputError,
    JointRangeError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    UncoupledManipulator,
)
from kleinform.paper import printed
from tests.runtime.modes_support import HOME, SPREADS, random_poses
from tests.support import EPS, platform_directions

ROBOT = UncoupledManipulator()
START = ROBOT.inverse_displacement(HOME[0], HOME[1].as_matrix())
PAPER = ROBOT.forward_displacement(START)
ARRAYS = (
    "joints",
    "position",
    "rotation",
    "directions",
    "platform_joints",
    "extension",
    "direct_determinant",
    "multiplicity",
)
NOWHERE = np.array([0.0, 0.0, 0.0, 0.4, 1.0, 1.0])


def some_modes(count: int = 20) -> list[AssemblyModes]:
    rng = np.random.default_rng(11)
    joints = [random_poses(rng, count, spread).joints for spread in SPREADS]
    return [ROBOT.forward_displacement(row) for row in np.concatenate(joints)]


def same(one: AssemblyModes, other: AssemblyModes) -> bool:
    pairs = [(getattr(one, name), getattr(other, name)) for name in ARRAYS]
    facts = ("status", "degenerate", "tolerance", "certificate")
    return all(np.array_equal(*pair, equal_nan=True) for pair in pairs) and all(
        getattr(one, name) == getattr(other, name) for name in facts
    )


def test_table_1() -> None:
    """The four real solutions, in the order of the paper."""
    assert PAPER.status == "regular"
    assert len(PAPER) == 4
    # Six digits are printed, cut off and not rounded.
    table = np.array(printed.TABLE_1, dtype=np.float64)
    assert np.max(abs(PAPER.platform_joints - table)) <= 1e-6
    assert PAPER.feasible.tolist() == [True, True, False, False]
    assert PAPER.nearest(HOME[1]) == 1
    assert np.max(abs(PAPER.rotation[1] - HOME[1].as_matrix())) <= 1e-13


def test_fields() -> None:
    shapes = [(6,), (3,), (4, 3, 3), (4, 3, 3), (4, 3, 3), (4, 3), (4,), (4,)]
    for name, shape in zip(ARRAYS, shapes, strict=True):
        kind = np.int64 if name == "multiplicity" else np.float64
        assert getattr(PAPER, name).shape == shape
        assert getattr(PAPER, name).dtype == kind
    assert PAPER.feasible.dtype == bool
    assert np.array_equal(PAPER.joints, START)
    assert np.max(abs(PAPER.position - HOME[0])) <= 2.0 * EPS
    assert PAPER.multiplicity.tolist() == [1, 1, 1, 1]
    assert PAPER.tolerance == 4.0 * EPS
    assert PAPER.degenerate == ()
    assert PAPER.certificate is None
    assert PAPER.reason == "every solution is simple"


def test_no_pose() -> None:
    modes = ROBOT.forward_displacement(NOWHERE)
    assert (modes.status, len(modes)) == ("none", 0)
    assert modes.rotation.shape == modes.platform_joints.shape == (0, 3, 3)
    assert modes.extension.shape == (0, 3)
    assert modes.feasible.shape == modes.multiplicity.shape == (0,)
    assert "no pose" in modes.reason
    assert len(modes.reflected()) == 0
    with pytest.raises(InputError, match="nearest: there is no mode, the status is 'none'"):
        modes.nearest(np.eye(3))


def test_unreachable() -> None:
    """Legs too long or too short for any orientation."""
    for lengths in ([0.01, 5.0, 0.01], [0.01, 0.01, 0.01], [9.0, 0.1, 0.1]):
        modes = ROBOT.forward_displacement([*lengths, 0.4, 1.0, 1.0])
        assert (modes.status, len(modes)) == ("none", 0)


def test_reflected() -> None:
    for modes in some_modes():
        other = modes.reflected()
        assert np.array_equal(other.platform_joints, modes.platform_joints)
        assert np.array_equal(other.directions, -modes.directions)
        assert np.array_equal(other.extension, -modes.extension)
        assert np.max(abs(np.linalg.det(other.rotation) - 1.0)) <= 16.0 * EPS
        assert np.max(abs(platform_directions(other.rotation) + modes.directions)) <= 16.0 * EPS
        assert not np.any(modes.feasible & other.feasible)
        # The same B_i: the same legs.
        back = ROBOT.inverse_displacement(modes.position, other.rotation)
        front = ROBOT.inverse_displacement(modes.position, modes.rotation)
        assert np.max(abs(back - front) / (1.0 + abs(front))) <= 1e-12
        assert same(other.reflected(), modes)


def test_nearest() -> None:
    turn = Rotation.from_rotvec([1e-3, -2e-3, 1e-3])
    for modes in some_modes(5):
        for number, rotation in enumerate(modes.rotation):
            assert modes.nearest(rotation) == number
            assert modes.nearest(Rotation.from_matrix(rotation)) == number
            assert modes.nearest(rotation * [-1.0, -1.0, 1.0]) == number
            assert modes.reflected().nearest(rotation) == number
    for number, rotation in enumerate(PAPER.rotation):
        assert PAPER.nearest(turn * Rotation.from_matrix(rotation)) == number


def test_nearest_refuses_what_is_no_rotation() -> None:
    with pytest.raises(NotARotationError, match="rotation: not a rotation"):
        PAPER.nearest(2.0 * np.eye(3))
    with pytest.raises(ShapeError, match=r"rotation: shape \(3, 3\) is needed"):
        PAPER.nearest(np.eye(3)[np.newaxis])
    with pytest.raises(NotFiniteError, match="rotation"):
        PAPER.nearest(np.full((3, 3), np.nan))


def test_the_same_every_time() -> None:
    for modes in some_modes(3):
        assert same(ROBOT.forward_displacement(modes.joints), modes)


@pytest.mark.parametrize("radius", [2.0**-10, 1e-3, 7.3, 1e3, 2.0**20])
def test_manipulators_of_other_sizes(radius: float) -> None:
    robot = UncoupledManipulator(radius)
    for modes in [PAPER, *some_modes(4)]:
        other = robot.forward_displacement(modes.joints * ([radius] * 3 + [1.0] * 2 + [radius]))
        assert len(other) == len(modes)
        assert other.status == modes.status
        assert np.array_equal(other.multiplicity, modes.multiplicity)
        assert np.max(abs(other.rotation - modes.rotation)) <= 1e-9
        if np.log2(radius) % 1.0 == 0.0:
            # A power of two changes no digit.
            assert np.array_equal(other.rotation, modes.rotation)
            assert np.array_equal(other.extension / radius, modes.extension)
        size = np.linalg.norm(modes.platform_joints, axis=-1)[..., np.newaxis]
        assert np.max(abs(other.platform_joints / radius - modes.platform_joints) / size) <= 1e-8


@pytest.mark.parametrize("limb", [1, 2])
def test_limbs_renumbered(limb: int) -> None:
    """Turned about Z by the angle of a limb, the mechanism is itself: the same modes, turned."""
    turn = Rotation.from_euler("z", -120.0 * limb, degrees=True).as_matrix()
    for modes in [PAPER, *some_modes(4)]:
        joints = modes.joints.copy()
        joints[:3] = np.roll(joints[:3], -limb)
        joints[3] -= 2.0 * np.pi / 3.0 * limb
        other = ROBOT.forward_displacement(joints)
        assert len(other) == len(modes)
        expected = turn @ modes.rotation @ turn.T
        numbers = [other.nearest(rotation) for rotation in expected]
        assert sorted(numbers) == list(range(len(modes)))
        for number, rotation in zip(numbers, expected, strict=True):
            assert abs(other.rotation[number][:, 2] - rotation[:, 2]).max() <= 1e-9


def test_bad_joint_values() -> None:
    for joint, value in ((0, -0.1), (2, -1e-9), (5, -1.0), (4, 1.6), (4, -1.6)):
        joints = START.copy()
        joints[joint] = value
        with pytest.raises(JointRangeError, match=rf"q{joint + 1} .*; {value!r} arrived"):
            ROBOT.forward_displacement(joints)
    for value in (np.nan, np.inf):
        with pytest.raises(NotFiniteError, match="joints: NaN or inf"):
            ROBOT.forward_displacement([value, *START[1:]])


@pytest.mark.parametrize("shape", [(5,), (7,), (1, 6), (2, 6), (0, 6), ()])
def test_shapes(shape: tuple[int, ...]) -> None:
    with pytest.raises(ShapeError, match="joints: shape "):
        ROBOT.forward_displacement(np.ones(shape))
    if len(shape) < 2 or shape[-1] != 6:
        with pytest.raises(ShapeError, match="joints: shape "):
            ROBOT.forward_displacement_batch(np.ones(shape))


@pytest.mark.parametrize("tolerance", [-1e-16, 1.0, 2.0, np.nan, np.inf, [0.0, 0.0]])
def test_tolerances_out_of_range(tolerance: float) -> None:
    with pytest.raises(InputError, match="tolerance: one number in "):
        ROBOT.forward_displacement(START, tolerance=tolerance)
    with pytest.raises(InputError, match="tolerance: one number in "):
        ROBOT.forward_displacement_batch(START[np.newaxis], tolerance=tolerance)


def test_motions_from_a_mode() -> None:
    """mode= is the start_rotation of that mode."""
    share = np.linspace(0.0, 0.3, 20)[:, np.newaxis]
    motion = START + share * np.array([0.02, -0.01, 0.01, 0.01, -0.01, 0.02])
    for number, rotation in enumerate(PAPER.rotation):
        positions, rotations = ROBOT.track(motion, mode=number)
        assert np.max(abs(rotations[0] - rotation)) <= 1e-13
        expected = ROBOT.track(motion, rotation)
        assert np.array_equal(positions, expected[0])
        assert np.array_equal(rotations, expected[1])


def test_motions_from_no_mode() -> None:
    motion = np.stack([START, START])
    for mode in (4, -1, 1.5):
        with pytest.raises(InputError, match=r"mode: the first sample has 4 modes, .* arrived"):
            ROBOT.track(motion, mode=mode)
    with pytest.raises(InputError, match="mode: the first sample has 0 modes, 0 arrived"):
        ROBOT.track(NOWHERE[np.newaxis], mode=0)
    with pytest.raises(InputError, match="either start_rotation or mode= is needed"):
        ROBOT.track(motion)
    with pytest.raises(InputError, match="either start_rotation or mode= is needed"):
        ROBOT.track(motion, HOME[1], mode=0)
    for shape in ((6,), (0, 6)):
        with pytest.raises(ShapeError, match="joints: shape "):
            ROBOT.track(np.ones(shape), mode=0)
