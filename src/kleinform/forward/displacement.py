"""From joint values as they arrive to their assembly modes."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, ShapeError
from kleinform.forward.cases import in_plane_exactly, zero_leg
from kleinform.forward.circle import Rows
from kleinform.forward.clusters import candidates, mirrored
from kleinform.forward.found import found, nothing
from kleinform.forward.modes import AssemblyModes, AssemblyModesBatch
from kleinform.forward.solve import (
    INFINITE,
    INVALID,
    STATUS,
    UNDECIDED,
    Solved,
    completed,
    solve,
    unit_size,
)
from kleinform.generated import kernels
from kleinform.joints import TOLERANCE, screened_joints
from kleinform.screening import Errors, is_whole, lead_of, real_array

if TYPE_CHECKING:
    from kleinform.forward.certificate import Certificate

__all__ = ["all_modes", "all_modes_batch", "start_of"]

Array = NDArray[np.float64]

#: Listed modes farther than this from the proven ones are replaced by them.
SHARP = 1e-9

LISTED = (
    "rotation",
    "directions",
    "platform_joints",
    "extension",
    "multiplicity",
)


def all_modes(radius: Array, joints: ArrayLike, tolerance: float, certify: bool) -> AssemblyModes:
    """See `UncoupledManipulator.forward_displacement`."""
    given = real_array("joints", joints, (6,))
    if given.ndim != 1 or radius.ndim:
        raise ShapeError(
            f"joints: shape (6,) and one radius are needed, {given.shape} and "
            f"{radius.shape} arrived; see forward_displacement_batch"
        )
    modes = all_modes_batch(radius, given[np.newaxis], tolerance, "raise")[0]
    return _certified(float(radius), modes) if certify else modes


def all_modes_batch(
    radius: Array, joints: ArrayLike, tolerance: float, errors: Errors
) -> AssemblyModesBatch:
    """See `UncoupledManipulator.forward_displacement_batch`."""
    allowed = _checked_tolerance(tolerance)
    values, screen = screened_joints(joints, errors)
    if values.ndim != 2:
        raise ShapeError(f"joints: shape (N, 6) is needed, {values.shape} arrived")
    lead = lead_of({"joints": values.shape[:-1], "radius": radius.shape})
    if lead != values.shape[:-1]:
        raise ShapeError(f"radius: shape () or (N,) is needed, {radius.shape} arrived")
    screen.settle()
    valid = np.flatnonzero(screen.valid)
    rows = rows_of(np.broadcast_to(radius, lead)[valid], values[valid])
    solved = solve(rows, allowed)
    status = np.full(len(values), INVALID)
    status[valid] = solved.status
    special = np.zeros((len(values), 7), dtype=bool)
    special[valid] = np.concatenate(
        [in_plane_exactly(rows, allowed), zero_leg(rows), rows.joints[:, 5:] == 0.0], axis=1
    )
    position = np.full((len(values), 3), np.nan)
    position[valid] = rows.position
    listed: slice | NDArray[np.bool_] = slice(None)
    if (solved.status == UNDECIDED).any():
        listed = solved.status[solved.row] != UNDECIDED
    count = np.bincount(valid[solved.row[listed]], minlength=len(values))
    return AssemblyModesBatch(
        radius=np.broadcast_to(radius, lead),
        joints=values.copy(),
        position=position,
        offsets=np.concatenate([[0], np.cumsum(count)]),
        **{name: getattr(solved, name)[listed] for name in LISTED},
        tolerance=allowed,
        status_codes=status,
        degenerate_codes=special,
    )


def start_of(radius: Array, joints: ArrayLike, mode: int | None) -> Array:
    """The rotation of a mode, by its number, at the first sample of a motion (T, 6)."""
    motion = real_array("joints", joints, (6,))
    if motion.ndim != 2 or not len(motion):
        raise ShapeError(f"joints: shape (T, 6) with T >= 1 is needed, {motion.shape} arrived")
    modes = all_modes(radius, motion[0], TOLERANCE, certify=False)
    if not (is_whole(mode) and mode in range(len(modes))):
        raise InputError(f"mode: the first sample has {len(modes)} modes, {mode!r} arrived")
    rotation: Array = modes.rotation[mode]
    return rotation


def rows_of(radius: Array, joints: Array) -> Rows:
    """Joint values (N, 6) as they enter the closure equations."""
    position = np.ascontiguousarray(kernels.central_forward(joints[:, 3:]).position)
    return Rows(radius, position, np.ascontiguousarray(joints[:, :3]), joints)


def _checked_tolerance(tolerance: float) -> float:
    value = real_array("tolerance", tolerance, ())
    if value.ndim or not 0.0 <= value < 1.0:
        raise InputError(f"tolerance: one number in [0, 1) is needed, {tolerance!r} arrived")
    return float(value)


def _certified(radius: float, modes: AssemblyModes) -> AssemblyModes:
    """The modes with their certificate, which also decides what rounding hides.

    Where the two cannot be made to agree no mode is listed.
    """
    from kleinform.forward.certificate import certify

    row = rows_of(np.array([radius]), modes.joints[np.newaxis])
    unit, _ = unit_size(row)
    pairs = candidates(unit)[0]
    proof = certify(radius, modes.joints, modes.tolerance, pairs)
    if not proof.complete:
        pairs = np.concatenate([pairs, mirrored(unit, pairs), _by_homotopy(unit)])
        proof = certify(radius, modes.joints, modes.tolerance, pairs)
    if proof.complete and not _are_proven(modes, proof):
        proven = found(np.zeros(proof.real, np.int64), proof.centers[proof.is_real].real, 1)
        agreed = proof.chart == "directions"
        modes = _relisted(modes, completed(row, proven), agreed)
    # Each real box holds a mode that is simple for all joint values within the tolerance.
    elif modes.status != STATUS[INFINITE] and proof.real > np.sum(modes.multiplicity == 1):
        modes = _relisted(modes, completed(row, nothing()), agreed=False)
    return replace(modes, certificate=proof)


def _are_proven(modes: AssemblyModes, proof: Certificate) -> bool:
    """Whether just the proven modes are listed, as sharp as float64 knows them elsewhere."""
    if modes.status == STATUS[UNDECIDED] or len(modes) != proof.real:
        return False
    if proof.chart != "directions":
        return True
    centers = proof.centers[proof.is_real].real
    gaps = [
        abs(modes.directions[:, np.newaxis, :2] - sign * centers).max(axis=(2, 3))
        for sign in (1.0, -1.0)
    ]
    near = np.minimum(*gaps) <= proof.radii[proof.is_real] + SHARP
    return bool(near.any(axis=0).all())


def _relisted(modes: AssemblyModes, solved: Solved, agreed: bool) -> AssemblyModes:
    """Other modes of the same joint values, or none, undecided."""
    decided = agreed and solved.status[0] != UNDECIDED
    count = len(solved.row) if decided else 0
    status = STATUS[solved.status[0] if decided else UNDECIDED]
    return replace(modes, **{name: getattr(solved, name)[:count] for name in LISTED}, status=status)


def _by_homotopy(row: Rows) -> NDArray[np.complex128]:
    """One of each pair of solutions (32, 2, 3), not finite where a path ends at infinity."""
    from kleinform.homotopy import solve_cones

    cones = kernels.cones(row.radius, row.position, row.lengths)
    paths = solve_cones(np.stack(cones, axis=1)).points[0]
    with np.errstate(all="ignore"):
        pairs: NDArray[np.complex128] = (paths[:, 1:] / paths[:, :1]).reshape(-1, 2, 3)
    return pairs
