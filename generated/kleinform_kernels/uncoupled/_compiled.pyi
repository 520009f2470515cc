# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""The extension that is compiled from extension.c, lanes.c and kernels.c."""

from typing import Generic, TypeVar

import numpy as np

Result = TypeVar("Result", bound=tuple[np.ndarray, ...])

CHECKSUM: int

def instructions() -> str: ...
def use(name: str) -> bool: ...

class OnePose(Generic[Result]):
    def __init__(self, name: str, result: type[Result]) -> None: ...
    def __call__(self, *arguments: object) -> Result | None: ...

inverse_displacement: np.ufunc
central_forward: np.ufunc
central_inverse: np.ufunc
closure: np.ufunc
cones: np.ufunc
eliminant: np.ufunc
half_turn: np.ufunc
turned_directions: np.ufunc
circles: np.ufunc
arms: np.ufunc
newton_step: np.ufunc
leg_step: np.ufunc
fold: np.ufunc
rotation_from_rpy: np.ufunc
rpy_from_rotation: np.ufunc
rotation_from_directions: np.ufunc
rotation_defect: np.ufunc
limb_geometry: np.ufunc
screws: np.ufunc
jacobians: np.ufunc
joints_and_jacobians: np.ufunc
inverse_velocity: np.ufunc
forward_velocity: np.ufunc
joint_rates: np.ufunc
platform_wrench: np.ufunc
actuator_forces: np.ufunc
inverse_acceleration: np.ufunc
forward_acceleration: np.ufunc
inverse_singularity: np.ufunc
direct_singularity: np.ufunc
survey: np.ufunc
direct_locus: np.ufunc
orientation_locus: np.ufunc
