"""What an error says of arguments of Python, in terms of the command's options and columns."""

from __future__ import annotations

import re

import numpy as np

from kleinform.commands.columns import unit
from kleinform.commands.source import Block
from kleinform.errors import JointRangeError, KleinformError, NotFiniteError

__all__ = ["in_columns", "in_options"]

#: The options that fill arguments.
OPTIONS = {
    **{name: f"--{name}" for name in ("position", "twist", "rates", "joints", "azimuth")},
    **{name: f"--{name}" for name in ("radius", "mode", "limits")},
    **{name: f"--rpy: {name}" for name in ("roll", "pitch", "yaw")},
    "rotation": "--rpy",
    "start_rotation": "--start-rpy",
    "count": "--samples",
    "relative": "--tolerance",
    "bounds": "--box",
}


def in_options(message: str) -> str:
    """A message that begins with an argument, or asks for one, with the option's name instead."""
    name, colon, rule = message.partition(": ")
    message = OPTIONS.get(name, name) + colon + rule
    asked_for = r"\b(start_rotation|\w+(?==))=?(?=[\s;,]|$)"
    return re.sub(asked_for, lambda asked: OPTIONS.get(asked[1], asked[0]), message)


def in_columns(error: KleinformError, block: Block, row: int, degrees: bool) -> str:
    """What an error says of a row: the column, and what stands there, where it is of one."""
    rule = str(error).partition(", first at pose ")[0]
    if isinstance(error, NotFiniteError):
        for name, values in block.table.items():
            if not np.isfinite(values[row]):
                # An option has its name in front, as a line has its place.
                argument = "" if block.where(row) else rule.partition(": ")[0]
                named = f"{argument}: {name}" if argument not in ("", name) else name
                return f"{named}: a finite number is needed, {block.cell(row, name)} arrived"
    joint = rule.removeprefix("joints: ")[:2]
    if isinstance(error, JointRangeError) and joint in block.table:
        angle = " deg" if unit(joint, degrees) == "deg" else ""
        return f"{rule.rpartition(';')[0]}; {block.cell(row, joint)}{angle} arrived"
    return rule
