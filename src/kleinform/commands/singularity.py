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
    errors: options.Errors = "raise",
    radius: options.Radius = 1.0,
) -> None:
    """Determinants of both Jacobians, by factors.

    Says which factors vanish. A singular pose is an answer here: only bad input is an error.

    Columns in: x, y, z [m], roll, pitch, yaw [rad].

    Columns out: inverse_determinant [m²], direct_determinant [m³], limb_1, limb_2, limb_3 [1],
    central [m²], wrist [1], extension_1, extension_2, extension_3 [m], orientation [m³],
    vanishing (the names of the factors that count as zero, with spaces between).

    \b
    Examples:
      kleinform singularity --position 0.25 0.2 1.0 --rpy 10 3 6 --degrees
      kleinform singularity --input poses.csv --degrees --output factors.csv
    """
    robot = UncoupledManipulator(radius)

    def compute(poses: Table) -> Answer:
        survey = robot.survey(*pose_of(poses, errors), errors=errors)
        determinants = (survey.inverse_determinant, survey.direct_determinant)
        answer = {
            **dict(zip(DETERMINANTS, determinants, strict=True)),
            **{name: survey.factors[name] for name in FACTORS},
            "vanishing": _vanishing(survey),
        }
        return Answer(answer, ~survey.valid)

    streams = Streams(table, output, format, degrees)
    given = {"--position": (POSITION, position), "--rpy": (ANGLES, rpy)}
    answer_rows(streams, given, lambda _: POSE, compute)


def _vanishing(survey: Survey) -> NDArray[np.str_]:
    """For each pose the names of the factors that count as zero."""
    zero = survey.vanishing()
    return joined(FACTORS, np.stack([zero[name] for name in FACTORS], axis=-1))
