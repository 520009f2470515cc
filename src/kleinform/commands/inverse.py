"""``kleinform inverse``: joint values of poses."""

from __future__ import annotations

import numpy as np

from kleinform.commands import options
from kleinform.commands.columns import (
    ANGLES,
    JOINTS,
    POSE,
    POSITION,
    Array,
    Table,
    in_radians,
    named,
    stacked,
)
from kleinform.commands.rows import Answer, answer_rows
from kleinform.commands.streams import Streams
from kleinform.errors import KleinformError
from kleinform.manipulator import UncoupledManipulator
from kleinform.rotations import rotation_from_rpy
from kleinform.screening import Errors, Screen, reject_bad_numbers

__all__ = ["azimuth_of", "inverse", "pose_of", "rotation_of"]


def inverse(
    position: options.Position = None,
    rpy: options.Rpy = None,
    table: options.Input = None,
    output: options.Output = None,
    format: options.Format = None,
    degrees: options.Degrees = False,
    azimuth: options.Azimuth = None,
    errors: options.Errors = "raise",
    radius: options.Radius = 1.0,
) -> None:
    """Joint values of poses.

    Columns in: x, y, z [m], roll, pitch, yaw [rad].

    Columns out: q1, q2, q3 [m], q4, q5 [rad], q6 [m].

    \b
    Examples:
      kleinform inverse --position 0.25 0.2 1.0 --rpy 10 3 6 --degrees
      kleinform inverse --input poses.csv --degrees --output joints.csv
    """
    robot = UncoupledManipulator(radius)
    turn = azimuth_of(azimuth, degrees)

    def compute(poses: Table) -> Answer:
        place, rotation = pose_of(poses, errors)
        joints = robot.inverse_displacement(place, rotation, azimuth=turn, errors=errors)
        return Answer(named(JOINTS, joints), np.isnan(joints[:, 0]))

    streams = Streams(table, output, format, degrees)
    given = {"--position": (POSITION, position), "--rpy": (ANGLES, rpy)}
    answer_rows(streams, given, lambda _: POSE, compute)


def pose_of(poses: Table, errors: Errors) -> tuple[Array, Array]:
    """Positions (rows, 3) and rotations (rows, 3, 3)."""
    angles = {name: poses[name] for name in ANGLES}
    return stacked(poses, POSITION), rotation_from_rpy(**angles, errors=errors)


def azimuth_of(azimuth: float | None, degrees: bool) -> float | None:
    """The azimuth in radians."""
    if azimuth is None:
        return None
    screen = Screen((), "raise")  # it is of no row
    reject_bad_numbers(screen, "azimuth", np.array(azimuth), 0)
    screen.settle()
    return float(np.radians(azimuth)) if degrees else azimuth


def rotation_of(rpy: options.Three, degrees: bool, option: str = "--rpy") -> Array:
    """The rotation (3, 3) that an option gives."""
    given = dict(zip(ANGLES, map(np.array, rpy), strict=True))
    try:
        angles = in_radians(given, degrees)
        return rotation_from_rpy(roll=angles["roll"], pitch=angles["pitch"], yaw=angles["yaw"])
    except KleinformError as error:
        raise type(error)(f"{option}: {error}") from None
