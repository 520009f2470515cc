"""``kleinform classify``: the classes of poses."""

from __future__ import annotations

import numpy as np

from kleinform.classification import PoseClass, name_of
from kleinform.commands import options
from kleinform.commands.columns import ANGLES, FACTORS, POSE, POSITION, Table
from kleinform.commands.inverse import pose_of
from kleinform.commands.nearness import columns
from kleinform.commands.rows import Answer, answer_rows
from kleinform.commands.streams import Streams
from kleinform.manipulator import UncoupledManipulator

__all__ = ["classify"]

#: The names by code, with spaces instead of commas: a column of CSV.
NAMES = np.array([name_of(code).replace(",", "") for code in range(32)])


def classify(
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
    """Classes of poses: regular, or what is singular.

    A singular pose is an answer here: only bad input is an error. At a terminal, one pose also
    has its geometry in words.

    Columns in: x, y, z [m], roll, pitch, yaw [rad].

    Columns out: code (a sum: inverse 1, direct 2, wrist 4, limb 8, invalid 16), class (regular,
    or inverse, direct, combined, wrist, limb, invalid, with spaces between), limb_1, limb_2,
    limb_3 [1], central [m²], wrist [1], extension_1, extension_2, extension_3 [m], orientation
    [m³].

    With --conditioning also |f|/scale of every factor, ratio_limb_1 ... ratio_leg_3 [1], and the
    singular values moments_1 ... 3 [m], q123_by_omega_1 ... 3 [m], q123_by_velocity_1 ... 3 [1],
    q45_by_velocity_1, 2 [1/m], omega_by_q123_1 ... 3 [1/m], velocity_by_q45_1, 2 [m], radians
    counted as 1 also with --degrees.

    \b
    Examples:
      kleinform classify --position 0 0 1 --rpy 0 0 6 --degrees
      kleinform classify --input poses.csv --degrees --output classes.csv
    """
    robot = UncoupledManipulator(radius)
    streams = Streams(table, output, format, degrees)
    meaning: list[str] = []

    def compute(poses: Table) -> Answer:
        place, rotation = pose_of(poses, errors)
        classes = robot.classify(place, rotation, errors=errors)
        if streams.aligned and table is None:
            meaning.extend(robot.classify(place[0], rotation[0], errors=errors).meaning)
        answer = {
            "code": classes.code,
            "class": NAMES[classes.code],
            **{name: classes.survey.factors[name] for name in FACTORS},
        }
        if conditioning:
            answer |= columns(robot.conditioning(place, rotation, errors=errors))
        return Answer(answer, classes.code == PoseClass.INVALID)

    given = {"--position": (POSITION, position), "--rpy": (ANGLES, rpy)}
    answer_rows(streams, given, lambda _: POSE, compute)
    for line in meaning:
        print(line)
