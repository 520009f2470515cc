"""What is watched along a motion: smooth quantities that vanish where something is met.

A factor with a pole where another one vanishes is multiplied by it, and one that cannot
change its sign is squared. Which of them is zero is told by `kleinform.zero` all the same.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.limits import Limits
from kleinform.motion.paths import Poses
from kleinform.results import Survey
from kleinform.sums import dot
from kleinform.zero import Factor, factors, legs, threshold

if TYPE_CHECKING:
    from kleinform.manipulator import UncoupledManipulator

__all__ = ["KINDS", "Quantity", "quantities", "room"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
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
    judged, legged = factors(survey.result), legs(survey.result, robot.radius)
    small = threshold(robot.rounding)
    incidence = judged.limb.value.T
    size = np.linalg.norm(poses.positions, axis=1)
    span = robot.radius - dot(DIRECTIONS[:, np.newaxis], poses.positions[:, :2])  # a − c·u_i
    plain = {
        **{f"limb_{i + 1}": (incidence[i], small + 0.0 * size) for i in range(3)},
        **{f"leg_{i + 1}": _squared(legged, i, small) for i in range(3)},
        **{f"extension_{i + 1}": (span[i], small * (robot.radius + size)) for i in range(3)},
        "central": ((poses.positions[:, :2] ** 2).sum(axis=1), (small * size) ** 2),
        "wrist": _without_poles(judged.wrist, 1.0 + 0.0 * size, small),
        "orientation": _without_poles(judged.orientation, incidence.prod(axis=0) ** 2, small),
    }
    zero = {**judged.by_name(), **legged.by_limb("leg")}
    found = {name: _judged(*plain[name], zero[name].zero(robot.rounding)) for name in plain}
    for name, away in room(poses, survey, limits).items():
        found[name] = Quantity(away, small * (abs(away) + abs(_bound(name, limits))))
    return found


def _squared(legged: Factor, i: int, small: float) -> tuple[Array, Array]:
    """A leg, which cannot change its sign."""
    return legged.value[:, i] ** 2, (small * np.asarray(legged.scale)[:, 0]) ** 2


@np.errstate(invalid="ignore")  # on a pole another quantity vanishes
def _without_poles(factor: Factor, poles: Array, small: float) -> tuple[Array, Array]:
    """A factor without its poles."""
    return factor.value * poles, small * factor.scale * poles


def _judged(value: Array, zero: Array, vanishes: Mask) -> Quantity:
    """A quantity that counts as zero where its factor does, and there alone, to the bit."""
    size = abs(value)
    most = np.minimum(zero, np.nextafter(size, -np.inf))
    return Quantity(value, np.where(vanishes, np.maximum(zero, size), most))


def _bound(name: str, limits: Limits) -> float:
    """The limit that a name of `room` means."""
    what, end = name.split()
    if end == "margin":
        return limits.margins[what.partition("_")[0]]
    return limits.range_of(what)[end == "high"]
