"""``kleinform velocity``: joint rates of twists, or twists of joint rates."""

from __future__ import annotations

from typing import Annotated

import numpy as np
import typer

from kleinform.commands import options
from kleinform.commands.columns import ANGLES, POSE, POSITION, RATES, TWIST, Table, named, stacked
from kleinform.commands.inverse import azimuth_of, pose_of
from kleinform.commands.nearness import columns
from kleinform.commands.rows import Answer, answer_rows
from kleinform.commands.source import Given, Source
from kleinform.commands.streams import Streams
from kleinform.errors import InputError
from kleinform.manipulator import UncoupledManipulator

__all__ = ["velocity"]

Twist = Annotated[
    options.Six | None,
    typer.Option(
        metavar="WX WY WZ VX VY VZ",
        help="Angular velocity, and velocity of C [m/s]: gives rates.",
    ),
]
Rates = Annotated[
    options.Six | None, typer.Option(metavar="DQ1 ... DQ6", help="Joint rates: give the twist.")
]


def velocity(
    position: options.Position = None,
    rpy: options.Rpy = None,
    twist: Twist = None,
    rates: Rates = None,
    table: options.Input = None,
    output: options.Output = None,
    format: options.Format = None,
    degrees: options.Degrees = False,
    conditioning: options.Conditioning = False,
    azimuth: options.Azimuth = None,
    errors: options.Errors = "raise",
    radius: options.Radius = 1.0,
) -> None:
    """Joint rates of twists, or twists of joint rates.

    Whichever is given, at a pose; the columns of a table tell.

    Columns in: x, y, z [m], roll, pitch, yaw [rad], and either wx, wy, wz [rad/s], vx, vy, vz
    [m/s], or dq1, dq2, dq3 [m/s], dq4, dq5 [rad/s], dq6 [m/s].

    Columns out: the other six.

    With --conditioning also |f|/scale of every factor, ratio_limb_1 ... ratio_leg_3 [1], and the
    singular values moments_1 ... 3 [m], q123_by_omega_1 ... 3 [m], q123_by_velocity_1 ... 3 [1],
    q45_by_velocity_1, 2 [1/m], omega_by_q123_1 ... 3 [1/m], velocity_by_q45_1, 2 [m], radians
    counted as 1 also with --degrees.

    \b
    Examples:
      kleinform velocity --position 0.25 0.2 1.0 --rpy 10 3 6 --degrees \\
          --twist 0 0 5 0.2 0 0
      kleinform velocity --input twists.csv --degrees --output rates.csv
      kleinform velocity --position 0.25 0.2 1.0 --rpy 10 3 6 --degrees \\
          --rates 0 0 0 5 0 0 --conditioning
    """
    robot = UncoupledManipulator(radius)
    turn = azimuth_of(azimuth, degrees)

    def compute(rows: Table) -> Answer:
        place, rotation = pose_of(rows, errors)
        if TWIST[0] in rows:
            names = RATES
            result = robot.inverse_velocity(place, rotation, stacked(rows, TWIST), errors=errors)
        else:
            names = TWIST
            result = robot.forward_velocity(
                place, rotation, stacked(rows, RATES), azimuth=turn, errors=errors
            )
        answer = named(names, result)
        if conditioning:
            answer |= columns(robot.conditioning(place, rotation, errors=errors))
        return Answer(answer, np.isnan(result[:, 0]))

    given: Given = {"--position": (POSITION, position), "--rpy": (ANGLES, rpy)}
    if rates is None:
        given = {**given, "--twist": (TWIST, twist)}
    elif twist is None:
        given = {**given, "--rates": (RATES, rates)}
    else:
        raise InputError("either --twist or --rates is needed, both arrived")
    answer_rows(Streams(table, output, format, degrees), given, _needed, compute)


def _needed(source: Source) -> tuple[str, ...]:
    """The pose, and the twist or the rates."""
    with_twist, with_rates = TWIST[0] in source.columns, RATES[0] in source.columns
    if with_twist == with_rates:
        arrived = "both" if with_twist else "neither"
        raise InputError(
            f"{source.name}: either the columns {', '.join(TWIST)} or {', '.join(RATES)} are "
            f"needed, {arrived} arrived"
        )
    return POSE + (TWIST if with_twist else RATES)
