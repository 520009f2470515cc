# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""The compiled kernels as NumPy's generalised ufuncs, one core each.

They take what every generalised ufunc takes: ``out=``, ``axes=``, strides, broadcasting and
casting; they give a tuple in the order of the kernel's results. Importing them where
``kleinform_kernels.uncoupled.BACKEND`` is not ``"compiled"`` is an ImportError.
"""

from kleinform_kernels._backend import BACKEND, REASON

if BACKEND != "compiled":
    raise ImportError(REASON)

from kleinform_kernels.uncoupled._compiled import (
    actuator_forces,
    arms,
    central_forward,
    central_inverse,
    circles,
    closure,
    cones,
    direct_locus,
    direct_singularity,
    eliminant,
    fold,
    forward_acceleration,
    forward_velocity,
    half_turn,
    inverse_acceleration,
    inverse_displacement,
    inverse_singularity,
    inverse_velocity,
    jacobians,
    joint_rates,
    joints_and_jacobians,
    leg_step,
    limb_geometry,
    newton_step,
    orientation_locus,
    platform_wrench,
    rotation_defect,
    rotation_from_directions,
    rotation_from_rpy,
    rpy_from_rotation,
    screws,
    survey,
    turned_directions,
)

__all__ = [
    "actuator_forces",
    "arms",
    "central_forward",
    "central_inverse",
    "circles",
    "closure",
    "cones",
    "direct_locus",
    "direct_singularity",
    "eliminant",
    "fold",
    "forward_acceleration",
    "forward_velocity",
    "half_turn",
    "inverse_acceleration",
    "inverse_displacement",
    "inverse_singularity",
    "inverse_velocity",
    "jacobians",
    "joint_rates",
    "joints_and_jacobians",
    "leg_step",
    "limb_geometry",
    "newton_step",
    "orientation_locus",
    "platform_wrench",
    "rotation_defect",
    "rotation_from_directions",
    "rotation_from_rpy",
    "rpy_from_rotation",
    "screws",
    "survey",
    "turned_directions",
]
