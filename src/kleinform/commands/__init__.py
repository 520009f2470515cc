"""The commands of ``kleinform``, a module each."""

from __future__ import annotations

import sys
from typing import Any

import typer

from kleinform.commands.classify import classify
from kleinform.commands.forward import forward
from kleinform.commands.inverse import inverse
from kleinform.commands.reports import latex, paper, verify
from kleinform.commands.singularities import singularities
from kleinform.commands.singularity import singularity
from kleinform.commands.trajectory import trajectory
from kleinform.commands.velocity import velocity
from kleinform.commands.workspace import workspace

__all__ = ["app"]


def flush(*_: Any, **__: Any) -> None:
    """Write what is left while Typer still listens for a closed pipe."""
    sys.stdout.flush()


app = typer.Typer(
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    result_callback=flush,
)


@app.callback()
def kleinform() -> None:
    """Kinematics and singularities of the uncoupled parallel manipulator 3-RPRRC+RRPRU.

    Positions are in metres, angles in radians or, with --degrees, in degrees; everything is in
    the base frame. Rows come as options or as a table, CSV, JSON lines or NPZ, with columns by
    name; other columns are ignored.
    """


COMMANDS = (
    *(inverse, forward, velocity, singularity, classify, trajectory),
    *(workspace, singularities, verify, paper, latex),
)
for command in COMMANDS:
    app.command()(command)
