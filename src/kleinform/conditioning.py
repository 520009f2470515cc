"""How near a pose is to each singularity, and the gains of the velocity map, each with its unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.generated import kernels
from kleinform.pose import Pose, check_pose
from kleinform.screening import Errors, RotationLike
from kleinform.zero import factors, legs

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["SINGULAR_VALUES", "Conditioning", "conditioning", "singular_values"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

#: The parts of the velocity map by name: how many singular values each has, and their unit.
SINGULAR_VALUES: Mapping[str, tuple[int, str]] = MappingProxyType(
    {
        "moments": (3, "m"),
        "q123_by_omega": (3, "m"),
        "q123_by_velocity": (3, "1"),
        "q45_by_velocity": (2, "1/m"),
        "omega_by_q123": (3, "1/m"),
        "velocity_by_q45": (2, "m"),
    }
)


@dataclass(frozen=True, eq=False)
class Conditioning:
    """How near poses are to singularities; there is no one number that says it on SE(3).

    Attributes
    ----------
    ratios : mapping of name to array (...)
        |f|/scale of every factor of `Survey`, and of ``leg_i`` (q_i = 0): 0 where it vanishes,
        at most about 1, NaN where it is 0/0. Up to ``rounding eps`` it counts as zero, below
        √eps a call that divides by it warns.
    singular_values : mapping of name to array (..., k)
        Of the parts of the velocity map that have one unit, each falling:

        - ``moments`` (3) [m]: of S_1, S_2, S_3 about C; 0 at a direct singularity.
        - ``q123_by_omega`` (3) [m]: q̇1, q̇2, q̇3 of an angular velocity, C at rest.
        - ``q123_by_velocity`` (3) [1]: q̇1, q̇2, q̇3 of a velocity of C.
        - ``q45_by_velocity`` (2) [1/m]: q̇4, q̇5 of a velocity of C; inf on the Z axis.
        - ``omega_by_q123`` (3) [1/m]: the angular velocity of q̇1, q̇2, q̇3, the central limb
          at rest; inf at a direct singularity.
        - ``velocity_by_q45`` (2) [m]: the velocity of C of q̇4, q̇5.

        Radians count as 1. Those of q̇6 along the central limb are 1. The first, second, third
        and fifth are NaN where n_i·u_i = 0 or q_i = 0: a line S_i has no place or no direction.
    valid : bool array (...)
        False in rows that ``errors="nan"`` blanked.
    """

    ratios: Mapping[str, Array]
    singular_values: Mapping[str, Array]
    valid: Mask

    def __repr__(self) -> str:
        return f"Conditioning({', '.join((*self.ratios, *self.singular_values))})"


def conditioning(
    robot: UncoupledManipulator, position: ArrayLike, rotation: RotationLike, errors: Errors
) -> Conditioning:
    """See `UncoupledManipulator.conditioning`."""
    pose = check_pose(robot, position, rotation, errors)
    survey = kernels.survey(pose.radius, pose.position, pose.rotation)
    pose.screen.blank(*survey)
    judged, legged = factors(survey), legs(survey, pose.radius)
    named = {**judged.by_name(), **legged.by_limb("leg")}
    undefined = judged.limb.zero(pose.rounding) | legged.zero(pose.rounding)
    known = pose.screen.valid & ~undefined.any(axis=-1)
    outer = _outer(pose, known)
    with np.errstate(divide="ignore"):
        outer["omega_by_q123"] = 1.0 / outer["q123_by_omega"][..., ::-1]
        length = survey.joints[..., 5]
        radial = np.hypot(pose.position[..., 0], pose.position[..., 1]) + 0.0 * length
        lengths = np.stack([length, radial], axis=-1)
        central = {"velocity_by_q45": lengths, "q45_by_velocity": 1.0 / lengths[..., ::-1]}
    values = {**outer, **central}
    return Conditioning(
        {name: factor.ratio()[()] for name, factor in named.items()},
        {name: values[name] for name in SINGULAR_VALUES},
        pose.screen.valid,
    )


def _outer(pose: Pose, known: Mask) -> dict[str, Array]:
    """Singular values of what the outer limbs feel: κ_i q̇_i = m_i·omega + s_i·v_C."""
    result = kernels.jacobians(pose.radius, pose.position, pose.rotation, pose.heading())
    # The first columns of J_v are the lines S_i = [s_i; m_i], and the κ_i begin J_q's diagonal.
    directions, moments = result.J_v[..., :3, :3], result.J_v[..., 3:, :3]
    forms = np.diagonal(result.J_q, axis1=-2, axis2=-1)[..., np.newaxis, :3]
    with np.errstate(all="ignore"):
        return {
            "moments": singular_values(moments, known),
            "q123_by_omega": singular_values(moments / forms, known),
            "q123_by_velocity": singular_values(directions / forms, known),
        }


def singular_values(matrices: Array, known: Mask) -> Array:
    """Of matrices (..., n, n), falling (..., n); NaN for those that are not known."""
    chosen = np.where(known[..., np.newaxis, np.newaxis], matrices, 0.0)
    values: Array = np.linalg.svd(chosen, compute_uv=False)
    values[~known] = np.nan
    return values
