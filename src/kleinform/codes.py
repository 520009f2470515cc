"""The class of every pose of a batch as one byte, by the factors of its survey."""

from __future__ import annotations

from enum import IntFlag
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.generated import kernels
from kleinform.pose import Geometry, Pose
from kleinform.quick import classes, sound
from kleinform.screening import LARGEST, ROTATION_TOLERANCE, SMALLEST
from kleinform.zero import factors, legs, threshold
from kleinform_kernels._threads import in_parts

__all__ = [
    "PoseClass",
    "by_numpy",
    "degenerate_limbs",
    "sound_survey_and_codes",
    "survey_and_codes",
]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Codes = NDArray[np.uint8]

#: Poses that stay in the caches while they are looked at.
BLOCK = 16384


class PoseClass(IntFlag):
    """What a pose is; classes add up, and a pose of none of them is regular.

    ``INVERSE``: det J_q vanishes, the wrist factor left out. ``DIRECT``: det J_v vanishes, the
    wrist factor left out. ``COMBINED`` is both. ``WRIST``: (n_1 × n_2)·λ = 0, which divides
    both determinants and cancels in the velocity map. ``LIMB``: an outer limb degenerates,
    q_i = 0 or n_i·u_i = 0; the latter is ``INVERSE`` too, because limb_i vanishes.
    ``INVALID``: no pose, a row that ``errors="nan"`` marks.
    """

    REGULAR = 0
    INVERSE = 1
    DIRECT = 2
    COMBINED = 3
    WRIST = 4
    LIMB = 8
    INVALID = 16


class Limbs(NamedTuple):
    """For each outer limb (..., 3): n_i·u_i = 0; q_i = 0; e_i = 0 where B_i is defined."""

    parallel: Mask
    legless: Mask
    extended: Mask


def degenerate_limbs(survey: Any, radius: Array, rounding: float) -> Limbs:
    """What vanishes in each outer limb, by a kernel's survey of valid poses."""
    judged = factors(survey)
    parallel = judged.limb.zero(rounding)
    extended = judged.extension.zero(rounding)
    return Limbs(parallel, legs(survey, radius).zero(rounding), extended & ~parallel)


def by_numpy(survey: Any, radius: Array, rounding: float) -> Codes:
    """The codes (...) of a kernel's survey of valid poses.

    The tilts of S_i say nothing of a limb without direction: the factor ``orientation`` counts
    only where every limb has one.
    """
    limbs = degenerate_limbs(survey, radius, rounding)
    undirected = (limbs.parallel | limbs.legless).any(axis=-1)
    judged = factors(survey)
    inverse = limbs.parallel.any(axis=-1) | judged.central.zero(rounding)
    orientation = judged.orientation.zero(rounding)
    direct = limbs.extended.any(axis=-1) | (orientation & ~undirected)
    codes: Codes = (
        inverse * np.uint8(PoseClass.INVERSE)
        + direct * np.uint8(PoseClass.DIRECT)
        + judged.wrist.zero(rounding) * np.uint8(PoseClass.WRIST)
        + undirected * np.uint8(PoseClass.LIMB)
    )
    return codes


def survey_and_codes(pose: Pose) -> tuple[Any, Codes]:
    """The kernel's survey of checked poses, and their codes (...)."""
    survey = kernels.survey(pose.radius, pose.position, pose.rotation)
    codes = np.asarray(_codes(survey, pose.radius, pose.rounding))
    codes[~pose.screen.valid] = PoseClass.INVALID
    return survey, codes


def sound_survey_and_codes(
    robot: Geometry, position: Any, rotation: Any
) -> tuple[Any, Codes] | None:
    """The same of poses (N, 3) and (N, 3, 3) that are sound, or None where a closer look is needed.

    Block by block: poses are checked, surveyed and classified while they are in the caches.
    """
    if kernels.BACKEND != "compiled" or robot.radius.ndim or not _is_batch(position, rotation):
        return None
    from kleinform_kernels.uncoupled import gufuncs

    none = kernels.survey(1.0, np.empty((0, 3)), np.empty((0, 3, 3)))
    survey = type(none)(*(np.empty((len(position), *field.shape[1:])) for field in none))
    codes: Codes = np.empty(len(position), dtype=np.uint8)
    unsound = []

    def look(start: int, stop: int) -> None:
        part = slice(start, stop)
        poses = position[part], rotation[part]
        if not sound(*poses, SMALLEST, LARGEST, ROTATION_TOLERANCE):
            unsound.append(part)
            return
        found = type(none)(*(field[part] for field in survey))
        gufuncs.survey(robot.radius, *poses, out=tuple(found))
        codes[part] = _codes(found, robot.radius, robot.rounding)

    in_parts(look, len(position), BLOCK)
    return None if unsound else (survey, codes)


def _is_batch(position: Any, rotation: Any) -> bool:
    """Whether both are arrays of poses along one axis."""
    arrays = isinstance(position, np.ndarray) and isinstance(rotation, np.ndarray)
    return arrays and position.shape[1:] == (3,) and rotation.shape == (*position.shape, 3)


def _codes(survey: Any, radius: Array, rounding: float) -> Codes:
    """The codes of a kernel's survey, compiled where the backend is."""
    codes = classes(
        survey.joints,
        survey.incidence,
        survey.extension,
        survey.extension_scale,
        survey.central,
        survey.central_scale,
        survey.wrist,
        survey.wrist_scale,
        survey.orientation,
        survey.orientation_scale,
        radius,
        threshold(rounding),
    )
    return by_numpy(survey, radius, rounding) if codes is None else codes
