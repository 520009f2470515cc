"""The options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kleinform.commands.streams import Format as FormatName
from kleinform.screening import Errors as OnErrors

__all__ = [
    "AnswerFormat",
    "Azimuth",
    "Conditioning",
    "Degrees",
    "Errors",
    "Format",
    "Input",
    "Orientation",
    "Output",
    "Position",
    "Radius",
    "Rpy",
    "Six",
    "Three",
]

Three = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]

Position = Annotated[
    Three | None, typer.Option(metavar="X Y Z", help="The platform's centre C [m].")
]
Rpy = Annotated[
    Three | None,
    typer.Option(
        metavar="ROLL PITCH YAW", help="The rotation Rz(yaw) Ry(pitch) Rx(roll) of the platform."
    ),
]
Orientation = Annotated[
    Three,
    typer.Option(
        metavar="ROLL PITCH YAW", help="The rotation Rz(yaw) Ry(pitch) Rx(roll) of the platform."
    ),
]
Azimuth = Annotated[
    float | None, typer.Option(help="q4 where C is on the Z axis, which leaves it free.")
]
Conditioning = Annotated[
    bool,
    typer.Option(
        "--conditioning",
        help="Also |f|/scale of every factor, and singular values of the velocity map.",
    ),
]
Input = Annotated[
    Path | None,
    typer.Option(
        "--input",
        metavar="FILE",
        help="A table of rows instead, .csv, .json or .npz; - is standard input.",
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="Write the answers to a .csv, .json or .npz, whole or not at all.",
    ),
]
Format = Annotated[
    FormatName | None,
    typer.Option(
        "--format",
        help="Of standard input and output; csv unless given. json is an object a line.",
    ),
]
AnswerFormat = Annotated[
    FormatName | None,
    typer.Option(
        "--format",
        help="Of standard output; csv in pipes unless given. json is an object a line.",
    ),
]
Degrees = Annotated[
    bool,
    typer.Option(
        "--degrees",
        help="All angles in degrees, angular rates per second, in and out; without, in radians, "
        "and none but q4 beyond a full turn.",
    ),
]
Errors = Annotated[
    OnErrors,
    typer.Option(help="At a singular or bad row: stop with an error that names it, or write NaN."),
]
Radius = Annotated[
    float, typer.Option(help="Radius a of the circle of the base joints [m].", show_default=True)
]
