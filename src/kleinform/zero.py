"""What counts as zero: ``|f| <= k eps scale(f)``, here and nowhere else.

Every factor is judged by one kernel, `survey`, so that all calls see the same bits. Kernels that
divide by a factor also return it, but their common subexpressions round otherwise: by those it is
told only that a pose is far from all that is singular.
"""

from __future__ import annotations

from functools import cache
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "EPS",
    "NEAR",
    "Factor",
    "Factors",
    "central",
    "factors",
    "guard",
    "legs",
    "threshold",
    "within",
]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
#: A pose is near a singularity where |f|/scale is below √eps: half of all digits are lost there.
NEAR = sqrt(EPS)


def threshold(rounding: float) -> float:
    """Up to which |f|/scale a factor counts as zero, for the robot's ``rounding`` k."""
    return rounding * EPS


@cache
def guard(rounding: float) -> float:
    """Above which |f|/scale a factor is neither zero nor near it, whichever kernel computed it."""
    return max(2.0 * NEAR, 2.0 * threshold(rounding))


@np.errstate(invalid="ignore")
def within(value: Array, scale: Array | float, most: float) -> Mask:
    """Where a finite value is at most so many times its scale."""
    # An infinite value against an infinite scale is no zero.
    return (abs(value) <= most * np.asarray(scale)) & np.isfinite(value)


class Factor(NamedTuple):
    """Values and the sizes that they are judged by: one a pose (...), or one a limb (..., 3)."""

    value: Array
    scale: Array | float

    def zero(self, rounding: float) -> Mask:
        """Where it counts as zero."""
        return within(self.value, self.scale, threshold(rounding))

    def ratio(self) -> Array:
        """|f|/scale; NaN where the factor is 0/0."""
        with np.errstate(all="ignore"):
            found: Array = abs(self.value) / self.scale
        return found

    def by_limb(self, name: str) -> dict[str, Factor]:
        """That of each limb, ``name_1``, ``name_2`` and ``name_3``."""
        scales = np.broadcast_to(self.scale, self.value.shape)
        return {f"{name}_{i + 1}": Factor(self.value[..., i], scales[..., i]) for i in range(3)}


class Factors(NamedTuple):
    """The factors of both determinants.

    Attributes
    ----------
    limb : Factor (..., 3)
        n_i·u_i, beside 1. The Klein form ``limb_i`` over its scale is the same, but for its
        rounding and where it is 0/0.
    extension : Factor (..., 3)
    central, wrist, orientation : Factor (...)
        As in `Survey`.
    """

    limb: Factor
    extension: Factor
    central: Factor
    wrist: Factor
    orientation: Factor

    def by_name(self) -> dict[str, Factor]:
        """Each of them alone: limb_1, limb_2, limb_3, extension_1, ..., orientation."""
        return {
            **self.limb.by_limb("limb"),
            **self.extension.by_limb("extension"),
            "central": self.central,
            "wrist": self.wrist,
            "orientation": self.orientation,
        }


def factors(survey: Any) -> Factors:
    """What the kernel `survey` says of poses."""
    return Factors(
        Factor(survey.incidence, 1.0),
        Factor(survey.extension, survey.extension_scale),
        Factor(survey.central, survey.central_scale),
        Factor(survey.wrist, survey.wrist_scale),
        Factor(survey.orientation, survey.orientation_scale),
    )


@np.errstate(invalid="ignore")
def legs(survey: Any, radius: Array) -> Factor:
    """``leg_i``: q_i |n_i·u_i| [m] beside a + 2 q6, (..., 3); at 0 the leg has no direction."""
    reach = np.asarray(radius + 2.0 * survey.joints[..., 5])
    return Factor(survey.joints[..., :3] * abs(survey.incidence), reach[..., np.newaxis])


def central(radial: Array, length: Array) -> Factor:
    """The factor ``central`` from the distances of C from the Z axis and from O, to the bit."""
    return Factor(length * radial, length * length)
