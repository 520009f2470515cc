"""``kleinform forward``: all assembly modes of joint values."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray

from kleinform.commands import options
from kleinform.commands.columns import (
    ANGLES,
    DEGENERATE,
    EXTENSIONS,
    JOINTS,
    POSITION,
    Table,
    joined,
    named,
    stacked,
)
from kleinform.commands.rows import Answer, answer_rows
from kleinform.commands.streams import Streams
from kleinform.errors import InputError
from kleinform.forward.certificate import Certificate
from kleinform.forward.modes import AssemblyModes, AssemblyModesBatch
from kleinform.forward.solve import STATUS
from kleinform.manipulator import UncoupledManipulator
from kleinform.rotations import rpy_from_rotation

__all__ = ["forward"]

Joints = Annotated[
    options.Six | None, typer.Option(metavar="Q1 ... Q6", help="One set of joint values.")
]
Certify = Annotated[
    bool,
    typer.Option(
        "--certify", help="With --joints: prove that no mode is missing (extra kleinform[certify])."
    ),
]


def forward(
    joints: Joints = None,
    table: options.Input = None,
    output: options.Output = None,
    format: options.Format = None,
    degrees: options.Degrees = False,
    certify: Certify = False,
    errors: options.Errors = "raise",
    radius: options.Radius = 1.0,
) -> None:
    """All assembly modes of joint values.

    Every pose that has these joint values, a row a mode.

    Columns in: q1, q2, q3 [m], q4, q5 [rad], q6 [m].

    Columns out: row (of the input, from 0), mode (from 0; -1 and NaN where there is none),
    status, x, y, z [m], roll, pitch, yaw [rad], e1, e2, e3 [m], direct_determinant [m³],
    multiplicity, feasible, degenerate (what is special, with spaces between).

    \b
    Examples:
      kleinform forward --joints 1.0 1.191 0.869 38.657 72.247 1.05 --degrees
      kleinform forward --input joints.csv --degrees --output modes.csv
    """
    if certify and joints is None:
        raise InputError("--certify is for one set of joint values, --joints")
    robot = UncoupledManipulator(radius)
    proofs: list[Certificate] = []
    done = 0

    def compute(rows: Table) -> Answer:
        nonlocal done
        values = stacked(rows, JOINTS)
        if certify:
            modes = robot.forward_displacement(values[0], certify=True)
            proofs.extend(filter(None, [modes.certificate]))
            batch = _batch_of_one(modes)
        else:
            batch = robot.forward_displacement_batch(values, errors=errors)
        answer = _rows_of(batch)
        answer["row"] += done
        done += len(values)
        return Answer(answer, batch.status_codes == STATUS.index("invalid"))

    given = {"--joints": (JOINTS, joints)}
    answer_rows(Streams(table, output, format, degrees), given, lambda _: JOINTS, compute)
    for proof in proofs:
        verdict = "proven" if proof.complete else "not proven"
        print(f"kleinform: {verdict}: {proof.reason}", file=sys.stderr)
        if not proof.complete:
            raise typer.Exit(1)


def _rows_of(batch: AssemblyModesBatch) -> Table:
    """A row a mode, and a row with NaN for joint values without any."""
    row = np.repeat(np.arange(len(batch)), np.maximum(batch.count, 1))
    there = batch.count[row] > 0
    mode = np.full(len(row), -1)
    mode[there] = np.arange(len(batch.rotation)) - batch.offsets[row[there]]

    def at_modes(values: NDArray[Any], missing: float) -> NDArray[Any]:
        filled = np.full((len(row), *values.shape[1:]), missing, dtype=values.dtype)
        filled[there] = values
        return filled

    angles = np.stack(rpy_from_rotation(batch.rotation), axis=-1)
    return {
        "row": row,
        "mode": mode,
        "status": np.array(STATUS)[batch.status_codes[row]],
        **named(POSITION, batch.position[row]),
        **named(ANGLES, at_modes(angles, np.nan)),
        **named(EXTENSIONS, at_modes(batch.extension, np.nan)),
        "direct_determinant": at_modes(batch.direct_determinant, np.nan),
        "multiplicity": at_modes(batch.multiplicity, 0),
        "feasible": at_modes(batch.feasible, False),
        "degenerate": joined(DEGENERATE, batch.degenerate_codes)[row],
    }


def _batch_of_one(modes: AssemblyModes) -> AssemblyModesBatch:
    """The modes of one set of joint values as a batch."""
    return AssemblyModesBatch(
        radius=np.array([modes.radius]),
        joints=modes.joints[np.newaxis],
        position=modes.position[np.newaxis],
        offsets=np.array([0, len(modes)]),
        rotation=modes.rotation,
        directions=modes.directions,
        platform_joints=modes.platform_joints,
        extension=modes.extension,
        multiplicity=modes.multiplicity,
        tolerance=modes.tolerance,
        status_codes=np.array([STATUS.index(modes.status)]),
        degenerate_codes=np.isin(AssemblyModesBatch.DEGENERATE, modes.degenerate)[np.newaxis],
    )
