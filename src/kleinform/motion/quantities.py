"""What is watched along a motion: smooth quantities that vanish where something is met.

A factor with a pole where another one vanishes is multiplied by it, and one that cannot
change its sign is squared.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.limits import Limits
from kleinform.motion.paths import Poses
from kleinform.results import EPS, Survey
from kleinform.sums import dot, turned_by

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["KINDS", "Quantity", "quantities", "room"]

Array = NDArray[np.float64]
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


def room(poses: Poses, survey: Survey, limits: Limits) -> dict[str, Array]:
    """How far each limit is away, by its name; negative beyond it.

    A factor's margin is "orientation margin" or "limb_1 margin".
    """
    found = limits.room(poses.joints, survey.extension)
    for name, factor in survey.factors.items():
        least = limits.margins.get(name.partition("_")[0])
        if least is not None:
            found[f"{name} margin"] = abs(factor) - least
    return found


def quantities(robot: UncoupledManipulator, poses: Poses, limits: Limits) -> dict[str, Quantity]:
    """Everything that is watched, at some poses."""
    survey = robot.survey(poses.positions, poses.rotations)
    small = robot.rounding * EPS
    size = np.linalg.norm(poses.positions, axis=1)
    reach = robot.radius + size
    axes = DIRECTIONS[:, np.newaxis]
    incidence = dot(axes, turned_by(poses.rotations[:, :2, :2], axes))
    span = robot.radius - dot(axes, poses.positions[:, :2])  # a − c·u_i
    found = {}
    for i in range(3):
        found[f"limb_{i + 1}"] = Quantity(incidence[i], small + 0.0 * size)
        found[f"leg_{i + 1}"] = Quantity(poses.joints[:, i] ** 2, (small * reach) ** 2)
        found[f"extension_{i + 1}"] = Quantity(span[i], small * reach)
    radial = (poses.positions[:, :2] ** 2).sum(axis=1)
    found["central"] = Quantity(radial, (small * size) ** 2)
    found["wrist"] = _factor(survey, "wrist", 1.0 + 0.0 * size, small)
    found["orientation"] = _factor(survey, "orientation", incidence.prod(axis=0) ** 2, small)
    for name, away in room(poses, survey, limits).items():
        found[name] = Quantity(away, small * (abs(away) + abs(_bound(name, limits))))
    return found


def _factor(survey: Survey, name: str, poles: Array, small: float) -> Quantity:
    """A factor without its poles."""
    with np.errstate(invalid="ignore"):  # on a pole another quantity vanishes
        return Quantity(survey.factors[name] * poles, small * survey.scales[name] * poles)


def _bound(name: str, limits: Limits) -> float:
    """The limit that a name of `room` means."""
    what, end = name.split()
    if end == "margin":
        return limits.margins[what.partition("_")[0]]
    return limits.range_of(what)[end == "high"]
