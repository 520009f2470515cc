"""``kleinform singularity``: determinants and their factors at poses."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.commands import options
from kleinform.commands.columns import (
    ANGLES,
    DETERMINANTS,
    FACTORS,
    POSE,
    POSITION,
    Table,
    joined,
)
from kleinform.commands.inverse import pose_of
from kleinform.commands.nearness import columns
from kleinform.commands.rows import Answer, answer_rows
from kleinform.commands.streams import Streams
from kleinform.manipulator import UncoupledManipulator
from kleinform.results import Survey

__all__ = ["singularity"]


def singularity(
    position: options.Position = None,
    rpy: options.Rpy = None,
    table: options.Input = None,
    output: options.Output = None,
    format: options.Format = None,
    degrees: options.Degrees = False,
    conditioning: options.Conditioning = False,
    errors: options.Errors = "raise",
    radius: options.Radius = 1.0,
) -> None:
    """Determinants of both Jacobians, by factors.

    Says which factors vanish. A singular pose is an answer here: only bad input is an error.

    Columns in: x, y, z [m], roll, pitch, yaw [rad].

    Columns out: inverse_determinant [m²], direct_determinant [m³], limb_1, limb_2, limb_3 [1],
    central [m²], wrist [1], extension_1, extension_2, extension_3 [m], orientation [m³],
    vanishing (the names of the factors that count as zero, with spaces between).

    With --conditioning also |f|/scale of every factor, ratio_limb_1 ... ratio_leg_3 [1], and the
    singular values moments_1 ... 3 [m], q123_by_omega_1 ... 3 [m], q123_by_velocity_1 ... 3 [1],
    q45_by_velocity_1, 2 [1/m], omega_by_q123_1 ... 3 [1/m], velocity_by_q45_1, 2 [m], radians
    counted as 1 also with --degrees.

    \b
    Examples:
      kleinform singularity --position 0.25 0.2 1.0 --rpy 10 3 6 --degrees
      kleinform singularity --input poses.csv --degrees --output factors.csv
    """
    robot = UncoupledManipulator(radius)

    def compute(poses: Table) -> Answer:
        place, rotation = pose_of(poses, errors)
        survey = robot.survey(place, rotation, errors=errors)
        determinants = (survey.inverse_determinant, survey.direct_determinant)
        answer = {
            **dict(zip(DETERMINANTS, determinants, strict=True)),
            **{name: survey.factors[name] for name in FACTORS},
            "vanishing": _vanishing(survey),
        }
        if conditioning:
            answer |= columns(robot.conditioning(place, rotation, errors=errors))
        return Answer(answer, ~survey.valid)

    streams = Streams(table, output, format, degrees)
    given = {"--position": (POSITION, position), "--rpy": (ANGLES, rpy)}
    answer_rows(streams, given, lambda _: POSE, compute)


def _vanishing(survey: Survey) -> NDArray[np.str_]:
    """For each pose the names of the factors that count as zero."""
    zero = survey.vanishing()
    return joined(FACTORS, np.stack([zero[name] for name in FACTORS], axis=-1))
