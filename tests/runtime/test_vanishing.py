"""What counts as zero: singular poses built in floating point, and regular ones close by."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import UncoupledManipulator, rotation_from_rpy
from tests.support import (
    BASE_AXES,
    NEAR,
    Case,
    batch,
    near_extension,
    near_incidence,
    near_wrist,
    platform_directions,
    scaled,
    unit_normal_to,
)

COUNT = 2000
#: The same poses of manipulators of these radii.
RADII = (1e-3, 0.7, 1.0, 1e3)


def random_turns(rng: np.random.Generator) -> np.ndarray:
    return Rotation.random(COUNT, rng=rng).as_matrix()


def random_places(rng: np.random.Generator) -> np.ndarray:
    return rng.uniform([-1.2, -1.2, 0.2], [1.2, 1.2, 2.0], size=(COUNT, 3))


def identity(rng: np.random.Generator) -> Case:
    """R = I, as a product of a rotation and its inverse gives it."""
    turns = random_turns(rng)
    return Case(1.0, random_places(rng), turns @ np.swapaxes(turns, -1, -2))


def quarter_yaw(rng: np.random.Generator) -> Case:
    """Yaw 90°: every n_i·u_i is zero."""
    turn = rotation_from_rpy(roll=0.0, pitch=0.0, yaw=np.pi / 2.0)
    return Case(1.0, random_places(rng), np.broadcast_to(turn, (COUNT, 3, 3)))


def yaw_in_the_base_plane(rng: np.random.Generator) -> Case:
    """A pure yaw with C in the base plane: the platform and the base are coplanar."""
    turns = rotation_from_rpy(roll=0.0, pitch=0.0, yaw=rng.uniform(-3.0, 3.0, size=COUNT))
    return Case(1.0, random_places(rng) * [1.0, 1.0, 0.0], turns)


def in_the_platform(rng: np.random.Generator) -> Case:
    """C, a combination of the platform's x and y axes, lies in its plane through O."""
    turns = random_turns(rng)
    weights = rng.normal(size=(COUNT, 2))
    return Case(1.0, np.einsum("nij,nj->ni", turns[..., :2], weights), turns)


def upright(rng: np.random.Generator) -> Case:
    """The central limb at elevation 90°, where cos(π/2) is not zero in floating point."""
    angle, length = rng.uniform(-3.0, 3.0, size=COUNT), rng.uniform(0.1, 3.0, size=COUNT)
    flat = np.cos(np.pi / 2.0) * length
    place = np.stack([flat * np.cos(angle), flat * np.sin(angle), length], axis=-1)
    return Case(1.0, place, random_turns(rng))


def extended(i: int) -> object:
    """C in the plane c·u_i = a."""

    def build(rng: np.random.Generator) -> Case:
        across = np.cross([0.0, 0.0, 1.0], BASE_AXES[i])
        shift = rng.normal(size=(COUNT, 2))
        place = BASE_AXES[i] + shift[:, :1] * across + shift[:, 1:] * [0.0, 0.0, 1.0]
        return Case(1.0, place, random_turns(rng))

    return build


def crossing(i: int) -> object:
    """n_i·u_i = 0."""

    def build(rng: np.random.Generator) -> Case:
        poses = []
        for _ in range(COUNT // 10):
            near = near_incidence(rng, 0.0)
            n = unit_normal_to(BASE_AXES[i], rng)
            m = unit_normal_to(n, rng)
            frame = np.column_stack([n, m, np.cross(n, m)])
            back = Rotation.from_euler("z", -120.0 * i, degrees=True).as_matrix()
            poses.append(Case(1.0, near.position, frame @ back))
        return batch(poses)

    return build


SINGULAR = {
    "identity": (identity, ["orientation"]),
    "quarter yaw": (quarter_yaw, ["limb_1", "limb_2", "limb_3"]),
    "yaw in the base plane": (yaw_in_the_base_plane, ["orientation", "wrist"]),
    "in the platform": (in_the_platform, ["wrist"]),
    "upright": (upright, ["central"]),
    **{f"c·u_{i + 1} = a": (extended(i), [f"extension_{i + 1}"]) for i in range(3)},
    **{f"n_{i + 1}·u_{i + 1} = 0": (crossing(i), [f"limb_{i + 1}"]) for i in range(3)},
}


@pytest.mark.parametrize("family", SINGULAR)
@pytest.mark.parametrize("radius", RADII)
def test_singular_poses_are_reported(family: str, radius: float) -> None:
    """With the default rounding; the worst of these needs 5.0 of its 16."""
    build, names = SINGULAR[family]
    pose = scaled(build(np.random.default_rng(1)), radius)
    vanishing = UncoupledManipulator(radius).survey(*pose[1:]).vanishing()
    for name in names:
        assert vanishing[name].all(), name
        assert vanishing[name].shape == pose.position.shape[:-1]


@pytest.mark.parametrize("family", NEAR)
@pytest.mark.parametrize("radius", RADII)
@pytest.mark.parametrize("distance", [1e-3, 1e-6, 1e-9])
def test_poses_close_to_singular_ones_are_not(family: str, radius: float, distance: float) -> None:
    rng = np.random.default_rng(2)
    poses = [scaled(NEAR[family](rng, distance), radius) for _ in range(50)]
    pose = batch(poses)
    vanishing = UncoupledManipulator(radius).survey(*pose[1:]).vanishing()
    assert not any(mask.any() for mask in vanishing.values())


@pytest.mark.parametrize(("near", "prefix"), [(near_wrist, "wrist"), (near_extension, "extension")])
def test_rounding_is_the_callers(near: object, prefix: str) -> None:
    """A pose 1e-9 off is zero to whoever rounds to 1e-8, and nothing is to who does not round."""
    pose = near(np.random.default_rng(3), 1e-9)[1:]
    for rounding, expected in ((1e-8 / np.finfo(float).eps, True), (16.0, False)):
        vanishing = UncoupledManipulator(rounding=rounding).survey(*pose).vanishing()
        assert any(vanishing[name] for name in vanishing if name.startswith(prefix)) is expected


def test_without_rounding_only_zero_is_zero() -> None:
    strict = UncoupledManipulator(rounding=0.0)
    exact = strict.inverse_singularity([0.0, 0.0, 1.0], np.eye(3)).vanishing()
    close = strict.inverse_singularity([0.0, 1e-150, 1.0], np.eye(3)).vanishing()
    assert exact["central"]
    assert not close["central"]


def test_infinite_factors_do_not_vanish() -> None:
    """At n_1·u_1 = 0 exactly e_1 is infinite, and so is its scale."""
    turn = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    direct = UncoupledManipulator().direct_singularity([0.25, 0.2, 1.0], turn)
    assert np.isinf(direct.factors["extension_1"])
    assert np.isinf(direct.scales["extension_1"])
    assert not direct.vanishing()["extension_1"]


def test_factors_are_nan_only_where_undefined() -> None:
    """``limb_i`` at q_i = 0 and ``wrist`` at c = 0 are 0/0."""
    robot, turn = UncoupledManipulator(), rotation_from_rpy(roll=0.3, pitch=0.2, yaw=0.1)
    at_base = BASE_AXES[0] - 0.75 * platform_directions(turn)[0]
    # C = A_1 − 3/4 n_1 for n_1 = (1, 0, 0): exact in floating point.
    level = rotation_from_rpy(roll=0.3, pitch=0.0, yaw=0.0)
    result = robot.inverse_singularity([0.25, 0.0, 0.0], level)
    assert np.isnan(result.factors["limb_1"])
    assert np.isfinite([result.factors["limb_2"], result.factors["wrist"]]).all()
    assert np.isfinite(list(robot.inverse_singularity(at_base, turn).factors.values())).all()
    at_origin = robot.inverse_singularity([0.0, 0.0, 0.0], turn)
    assert [name for name, value in at_origin.factors.items() if np.isnan(value)] == ["wrist"]
    assert at_origin.determinant == 0.0
