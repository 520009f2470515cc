"""Poses for the tests, built from geometry alone: nothing here calls kleinform."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

EPS = float(np.finfo(np.float64).eps)
LIMB_ANGLES = np.deg2rad([0.0, 120.0, 240.0])
#: The axes u_i of the base revolutes, a row each.
BASE_AXES = np.array([[np.cos(angle), np.sin(angle), 0.0] for angle in LIMB_ANGLES])
DISTANCES = (1e-3, 1e-5, 1e-7, 1e-9)


def many(sample: int, long: int) -> int:
    """How many cases a search takes: a sample, or all of them in `make verify-long`."""
    return long if os.environ.get("KLEINFORM_LONG") == "1" else sample


class Case(NamedTuple):
    """A pose of a manipulator of some radius."""

    radius: float
    position: np.ndarray
    rotation: np.ndarray


def random_rotation(rng: np.random.Generator) -> np.ndarray:
    return Rotation.random(rng=rng).as_matrix()


def random_position(rng: np.random.Generator) -> np.ndarray:
    return rng.uniform([-1.2, -1.2, 0.2], [1.2, 1.2, 2.0])


def random_cases(rng: np.random.Generator, count: int) -> list[Case]:
    return [Case(1.0, random_position(rng), random_rotation(rng)) for _ in range(count)]


def batch(cases: list[Case]) -> Case:
    """The cases as one batch: radius (N,), position (N, 3), rotation (N, 3, 3)."""
    return Case(*(np.stack(parts) for parts in zip(*cases, strict=True)))


def unit_normal_to(vector: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A random unit vector normal to a unit vector."""
    other = np.cross(vector, rng.normal(size=3))
    return other / np.linalg.norm(other)


def rotation_with_direction(i: int, n: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A random rotation whose platform direction of limb i (0, 1, 2) is n."""
    m = unit_normal_to(n, rng)
    frame = np.column_stack([n, m, np.cross(n, m)])
    return frame @ Rotation.from_euler("z", -LIMB_ANGLES[i]).as_matrix()


def platform_directions(rotation: np.ndarray) -> np.ndarray:
    """n_1, n_2, n_3, a row each: R turns the axes u_i of the reference pose."""
    return np.einsum("...jk,ik->...ij", rotation, BASE_AXES)


def near_axis(rng: np.random.Generator, distance: float) -> Case:
    angle = rng.uniform(-np.pi, np.pi)
    x, y = distance * np.cos(angle), distance * np.sin(angle)
    return Case(1.0, np.array([x, y, rng.uniform(0.3, 2.0)]), random_rotation(rng))


def near_incidence(rng: np.random.Generator, distance: float) -> Case:
    """n_i·u_i = distance for a random limb."""
    i = int(rng.integers(3))
    across = unit_normal_to(BASE_AXES[i], rng)
    n = distance * BASE_AXES[i] + np.sqrt(1.0 - distance**2) * across
    return Case(1.0, random_position(rng), rotation_with_direction(i, n, rng))


def near_leg(rng: np.random.Generator, distance: float) -> Case:
    """q_i small for a random limb: C on a line through A_i along n_i, and a little off."""
    i, rotation = int(rng.integers(3)), random_rotation(rng)
    n = platform_directions(rotation)[i]
    off = distance * rng.normal(size=3)
    return Case(1.0, BASE_AXES[i] - rng.uniform(0.5, 1.5) * n + off, rotation)


def near_extension(rng: np.random.Generator, distance: float) -> Case:
    """e_i small for a random limb: C a little off the plane c·u_i = a."""
    axis = BASE_AXES[int(rng.integers(3))]
    place = random_position(rng)
    place = place + (1.0 - distance - place @ axis) * axis
    return Case(1.0, place, random_rotation(rng))


def near_wrist(rng: np.random.Generator, distance: float) -> Case:
    """C a little off the plane through O that the platform is parallel to."""
    rotation, place = random_rotation(rng), random_position(rng)
    normal = rotation[:, 2]
    return Case(1.0, place + (distance - place @ normal) * normal, rotation)


def near_identity(rng: np.random.Generator, distance: float) -> Case:
    turn = Rotation.from_rotvec(distance * unit_normal_to(np.eye(3)[2], rng))
    return Case(1.0, random_position(rng), turn.as_matrix())


def near_yaw(rng: np.random.Generator, distance: float) -> Case:
    """A pure yaw, and a little tilt."""
    turn = near_identity(rng, distance).rotation
    yaw = Rotation.from_euler("z", rng.uniform(-np.pi, np.pi)).as_matrix()
    return Case(1.0, random_position(rng), turn @ yaw)


NEAR = {
    "axis": near_axis,
    "incidence": near_incidence,
    "leg": near_leg,
    "extension": near_extension,
    "wrist": near_wrist,
    "identity": near_identity,
    "yaw": near_yaw,
}


def scaled(case: Case, factor: float) -> Case:
    """The same pose of a manipulator that is larger by a factor."""
    return Case(case.radius * factor, case.position * factor, case.rotation)
