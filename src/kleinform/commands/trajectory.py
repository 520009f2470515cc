"""``kleinform trajectory``: the platform along a motion of the joints."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
import typer

from kleinform.commands import options
from kleinform.commands.columns import (
    ACCELERATIONS,
    ANGLES,
    JOINTS,
    POSITION,
    RATES,
    TWIST,
    TWIST_RATE,
    Array,
    Table,
    in_degrees,
    in_radians,
    named,
    stacked,
)
from kleinform.commands.inverse import rotation_of
from kleinform.commands.rows import named_row
from kleinform.commands.source import Block, Source, require, whole
from kleinform.commands.streams import Streams
from kleinform.errors import InputError, KleinformError
from kleinform.manipulator import UncoupledManipulator
from kleinform.motion import JointStates
from kleinform.motion.clock import increasing_times
from kleinform.rotations import rpy_from_rotation

__all__ = ["trajectory"]

TIME = ("t",)
Example = Annotated[
    Literal["1", "2"] | None,
    typer.Option(help="Instead of a table, a motion of the paper, from its pose."),
]
Samples = Annotated[int, typer.Option(help="With --example: evenly spaced times.")]
Mode = Annotated[
    int | None, typer.Option(help="Follow the mode that has this number in `kleinform forward`.")
]
StartRpy = Annotated[
    options.Three | None,
    typer.Option(
        metavar="ROLL PITCH YAW", help="Follow the mode whose rotation at the start is near this."
    ),
]


def trajectory(
    table: options.Input = None,
    example: Example = None,
    samples: Samples = 101,
    mode: Mode = None,
    start_rpy: StartRpy = None,
    output: options.Output = None,
    format: options.Format = None,
    degrees: options.Degrees = False,
    radius: options.Radius = 1.0,
) -> None:
    """The platform along a motion of the joints.

    Follows one assembly mode. The motion is read whole: a mode can be followed only from its start.

    Columns in: t [s], q1, q2, q3 [m], q4, q5 [rad], q6 [m], and, if twists are wanted, both
    dq1 ... dq6 per second and ddq1 ... ddq6 per second squared.

    Columns out: t [s], x, y, z [m], roll, pitch, yaw [rad], and, with rates, the twist wx, wy,
    wz [rad/s], vx, vy, vz [m/s] and its derivative dwx, dwy, dwz [rad/s²], dvx, dvy, dvz [m/s²].

    \b
    Examples:
      kleinform trajectory --example 2 --samples 6 --degrees
      kleinform trajectory --input motion.csv --mode 1 --output platform.csv
    """
    if (example is None) == (table is None):
        raise InputError("either --example or --input is needed")
    if mode is not None and start_rpy is not None:
        raise InputError("either --mode or --start-rpy is needed, both arrived")
    robot = UncoupledManipulator(radius)
    start = None if start_rpy is None else rotation_of(start_rpy, degrees, "--start-rpy")
    streams = Streams(table, output, format, degrees)
    if example is not None:
        motion, paper_start = _of_paper(example, samples)
        if mode is None and start is None:
            start = paper_start
        answer = _with_twists(robot, motion, start, mode)
    elif mode is None and start is None:
        raise InputError("--input needs either --mode or --start-rpy")
    else:
        with streams.source({}) as source:
            block = whole(source, _needed(source))
        answer = _of_block(robot, block, start, mode, degrees)
    with streams.writer(one_answer=False) as write:
        write(in_degrees(answer) if degrees else answer)


def _needed(source: Source) -> tuple[str, ...]:
    """Times and joint values; rates and accelerations where there are any."""
    names = TIME + JOINTS
    if any(name in source.columns for name in RATES + ACCELERATIONS):
        names += RATES + ACCELERATIONS
    require(source, names)
    return names


def _of_block(
    robot: UncoupledManipulator, block: Block, start: Array | None, mode: int | None, degrees: bool
) -> Table:
    """The platform along a motion that was read."""
    try:
        motion = in_radians(block.table, degrees)
        times = increasing_times(motion["t"], 1)
        if RATES[0] not in motion:
            return _poses(times, *robot.track(stacked(motion, JOINTS), start, mode=mode))
        joints, rates, accelerations = (
            stacked(motion, names) for names in (JOINTS, RATES, ACCELERATIONS)
        )
        states = JointStates(times, joints, rates, accelerations)
        return _with_twists(robot, states, start, mode)
    except KleinformError as error:
        raise named_row(error, block, degrees) from None


def _with_twists(
    robot: UncoupledManipulator, motion: JointStates, start: Array | None, mode: int | None
) -> Table:
    platform = robot.forward_motion(motion, start, mode=mode)
    return {
        **_poses(platform.times, platform.positions, platform.rotations),
        **named(TWIST, platform.twists),
        **named(TWIST_RATE, platform.twist_rates),
    }


def _poses(times: Array, positions: Array, rotations: Array) -> Table:
    angles = np.stack(rpy_from_rotation(rotations), axis=-1)
    return {"t": times, **named(POSITION, positions), **named(ANGLES, angles)}


def _of_paper(example: str, samples: int) -> tuple[JointStates, Array]:
    """A motion of the paper, and the rotation at its start."""
    from kleinform.paper import printed
    from kleinform.paper.examples import example_1, example_2

    motion = example_1() if example == "1" else example_2()
    return motion.sampled(samples), rotation_of(printed.ROLL_PITCH_YAW_DEGREES, degrees=True)
