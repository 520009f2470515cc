"""Random joint values, by the distributions that benchmarks and the census name."""

from __future__ import annotations

import numpy as np

import kleinform
from kleinform_kernels import uncoupled

__all__ = ["DISTRIBUTIONS", "joint_values"]

#: What the joint values are drawn from, by name; the radius is 1 m.
DISTRIBUTIONS = {
    "work": "poses around (0, 0, 1) m, roll, pitch and yaw within ±1.2 rad",
    "anywhere": "positions around O by 1 m, any rotation",
    "joints": "joint values drawn one by one: q1, q2, q3 in 0.1 to 3 m, q6 in 0.05 to 2.5 m",
}


def joint_values(distribution: str, count: int, seed: int) -> np.ndarray:
    """Joint values (count, 6) of a distribution."""
    generator = np.random.default_rng(seed)
    if distribution == "joints":
        lengths = generator.uniform(0.1, 3.0, size=(count, 3))
        azimuth = generator.uniform(-np.pi, np.pi, size=count)
        elevation = generator.uniform(-1.5, 1.5, size=count)
        return np.column_stack(
            [lengths, azimuth, elevation, generator.uniform(0.05, 2.5, size=count)]
        )
    if distribution == "work":
        position = generator.normal(scale=0.4, size=(count, 3)) + np.array([0.0, 0.0, 1.0])
        roll, pitch, yaw = generator.uniform(-1.2, 1.2, size=(3, count))
        rotation = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    else:
        position = generator.normal(size=(count, 3))
        w, x, y, z = np.moveaxis(_quaternions(generator, count), -1, 0)
        rotation = np.moveaxis(
            np.array(
                [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
                ]
            ),
            -1,
            0,
        )
    joints = uncoupled.inverse_displacement(1.0, position, rotation).joints
    return np.ascontiguousarray(joints)


def _quaternions(generator: np.random.Generator, count: int) -> np.ndarray:
    values = generator.normal(size=(count, 4))
    return np.asarray(values / np.linalg.norm(values, axis=1, keepdims=True))
