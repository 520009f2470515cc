"""``kleinform workspace``: the positions that keep every limit at one orientation."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from kleinform.commands import options
from kleinform.commands.columns import unit
from kleinform.commands.inverse import rotation_of
from kleinform.commands.meshes import MeshFile, Resolution, check_mesh_file, write_mesh
from kleinform.commands.progress import spinner
from kleinform.commands.streams import Streams
from kleinform.limits import ANGLES, Limits
from kleinform.manipulator import UncoupledManipulator

if TYPE_CHECKING:
    from kleinform.maps import Workspace

__all__ = ["workspace"]

LimitsFile = Annotated[
    Path | None,
    typer.Option(
        "--limits",
        metavar="FILE",
        help='A .toml with the table [ranges], in m and rad, or unit = "deg" above it; '
        "without, Limits.typical(radius).",
    ),
]
Tolerance = Annotated[
    float, typer.Option(help="The relative error of the volume to reach, from 1e-9 to 1.")
]


def workspace(
    rpy: options.Orientation,
    limits: LimitsFile = None,
    tolerance: Tolerance = 1e-6,
    mesh: MeshFile = None,
    resolution: Resolution = 64,
    format: options.AnswerFormat = None,
    degrees: options.Degrees = False,
    radius: options.Radius = 1.0,
) -> None:
    """The positions that keep every limit at one orientation.

    Needs the extra kleinform[certify]. The exit code is 1 if the error is proven, but larger
    than --tolerance asks for. That there are no positions is an answer: standard error then has
    the limits that exclude each other.

    Columns out: volume, volume_error [m³] (the proven bound of the error), components (pieces
    that a grid of 64 lines along the longer side finds).

    \b
    Examples:
      kleinform workspace --rpy 10 3 6 --degrees
      kleinform workspace --rpy 10 3 6 --degrees --limits limits.toml \\
          --mesh workspace.stl --resolution 40
    """
    check_mesh_file(mesh)
    from kleinform.maps import constant_orientation_workspace

    robot = UncoupledManipulator(radius)
    kept = Limits.typical(radius) if limits is None else Limits.from_toml(limits)
    space = constant_orientation_workspace(robot, rotation_of(rpy, degrees), kept)
    with spinner("workspace"):
        volume = space.volume(tolerance)
        components = space.components().count
        if mesh is not None:
            write_mesh(space.mesh(resolution), mesh)
    numbers = {
        "volume": volume.value,
        "volume_error": volume.error,
        "components": components,
    }
    with Streams(None, None, format, degrees).writer(one_answer=True) as write:
        write({name: np.array([number]) for name, number in numbers.items()})
    if components == 0:
        print(f"kleinform: {_why_empty(space, degrees)}", file=sys.stderr)
    if not volume.proven:
        print("kleinform: the error is larger than --tolerance asks for", file=sys.stderr)
        raise typer.Exit(1)


def _why_empty(space: Workspace, degrees: bool) -> str:
    """The limits that exclude each other, in words."""
    conflict = space.conflict()
    if not conflict:
        return "no position was found that keeps every limit"
    words = [_in_words(end, space.limits, degrees) for end in conflict]
    return f"the workspace is empty: at this orientation {', '.join(words)} exclude each other"


def _in_words(which: str, limits: Limits, degrees: bool) -> str:
    """An end of a range such as "q1 low", with its value and unit."""
    name, end = which.split()
    value = limits.range_of(name)[end == "high"]
    sign = ">=" if end == "low" else "<="
    turned = np.degrees(value) if degrees and name in ANGLES else value
    return f"{name} {sign} {turned:g} {unit(name, degrees)}"
