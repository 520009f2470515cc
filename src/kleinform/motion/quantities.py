"""What is watched along a motion: smooth quantities that vanish where something is met.

A factor with a pole where another one vanishes is multiplied by it, and one that cannot
change its sign is squared.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.motion.paths import Poses
from kleinform.results import EPS, Survey

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["KINDS", "Bounds", "Quantity", "checked_bounds", "margins", "quantities"]

Array = NDArray[np.float64]
Bounds = Mapping[str, tuple[float, float]]

#: What may have limits.
LIMITED = ("q1", "q2", "q3", "q4", "q5", "q6", "e1", "e2", "e3")
#: What each singularity is, by the name of its factor; ``leg_i`` is q_i = 0.
KINDS = {
    **{f"limb_{i}": "inverse" for i in (1, 2, 3)},
    **{f"leg_{i}": "limb" for i in (1, 2, 3)},
    **{f"extension_{i}": "direct" for i in (1, 2, 3)},
    "central": "inverse",
    "wrist": "wrist",
    "orientation": "direct",
}
#: u_i in the base's plane, and n_i in the platform's.
DIRECTIONS = np.array([[1.0, 0.0], [-0.5, np.sqrt(0.75)], [-0.5, -np.sqrt(0.75)]])


class Quantity(NamedTuple):
    """A quantity over time, and up to what size it counts as zero."""

    value: Array
    zero: Array


def checked_bounds(limits: Mapping[str, tuple[float, float]]) -> Bounds:
    """Limits ``(low, high)`` by name; an infinite one is none.

    Raises
    ------
    InputError
        A name is not one of q1 ... q6, e1, e2, e3, or not low < high.
    """
    checked = {}
    for name, given in limits.items():
        if name not in LIMITED:
            raise InputError(f"limits: one of {', '.join(LIMITED)} is needed, {name!r} arrived")
        pair = np.asarray(given, dtype=np.float64)
        if pair.shape != (2,) or not pair[0] < pair[1]:
            raise InputError(f"limits: {name}: low < high is needed, {given!r} arrived")
        checked[name] = (float(pair[0]), float(pair[1]))
    return checked


def margins(joints: Array, extension: Array, bounds: Bounds) -> dict[str, Array]:
    """How far each finite limit is away, in its unit, by its name and "low" or "high"."""
    columns = dict(zip(LIMITED, [*joints.T, *extension.T], strict=True))
    ends: dict[str, Array] = {}
    for name, (low, high) in bounds.items():
        ends |= {f"{name} low": columns[name] - low, f"{name} high": high - columns[name]}
    return {name: margin for name, margin in ends.items() if np.isfinite(margin).any()}


def quantities(robot: UncoupledManipulator, poses: Poses, bounds: Bounds) -> dict[str, Quantity]:
    """Everything that is watched, at some poses."""
    survey = robot.survey(poses.positions, poses.rotations)
    small = robot.rounding * EPS
    size = np.linalg.norm(poses.positions, axis=1)
    reach = robot.radius + size
    incidence = np.einsum("tij,kj,ki->kt", poses.rotations[:, :2, :2], DIRECTIONS, DIRECTIONS)
    span = robot.radius - DIRECTIONS @ poses.positions[:, :2].T  # a − c·u_i
    found = {}
    for i in range(3):
        found[f"limb_{i + 1}"] = Quantity(incidence[i], small + 0.0 * size)
        found[f"leg_{i + 1}"] = Quantity(poses.joints[:, i] ** 2, (small * reach) ** 2)
        found[f"extension_{i + 1}"] = Quantity(span[i], small * reach)
    radial = (poses.positions[:, :2] ** 2).sum(axis=1)
    found["central"] = Quantity(radial, (small * size) ** 2)
    found["wrist"] = _factor(survey, "wrist", 1.0 + 0.0 * size, small)
    found["orientation"] = _factor(survey, "orientation", incidence.prod(axis=0) ** 2, small)
    for name, margin in margins(poses.joints, survey.extension, bounds).items():
        scale = max(abs(bound) for bound in bounds[name[:2]] if np.isfinite(bound))
        found[name] = Quantity(margin, small * scale + 0.0 * size)
    return found


def _factor(survey: Survey, name: str, poles: Array, small: float) -> Quantity:
    """A factor without its poles."""
    with np.errstate(invalid="ignore"):  # on a pole another quantity vanishes
        return Quantity(survey.factors[name] * poles, small * survey.scales[name] * poles)
