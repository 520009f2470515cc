"""What the analyses return: arrays with names, the factors of singularities among them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.screening import Screen
from kleinform.zero import factors

__all__ = [
    "DirectSingularity",
    "InverseSingularity",
    "Jacobians",
    "Screws",
    "Singularity",
    "Survey",
]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


class Jacobians(NamedTuple):
    """``J_vᵀ Δ V = J_q q̇`` (17): the forward Jacobian (18) and the inverse one (19)."""

    J_v: Array
    J_q: Array


class Screws(NamedTuple):
    """The joint screws at pole C, in the base frame.

    Each field is ``(..., 6, 6)``: a row a joint in the order of the limb's chain from the
    base, each row ``[primal; dual]``. Joints of a limb 1 to 3: base revolute, prismatic
    (actuated), revolute along the leg, upper revolute, cylindrical rotation, cylindrical
    translation. Joints of the central limb: azimuth, elevation, prismatic (all actuated),
    revolute along the limb, first and second axis of the universal joint.
    """

    limb_1: Array
    limb_2: Array
    limb_3: Array
    central: Array

    def screw(self, limb: int, joint: int) -> Array:
        """The screw ``(..., 6)`` of joint 1 to 6 of limb 1 to 4, numbered as in the paper."""
        if limb not in (1, 2, 3, 4) or joint not in (1, 2, 3, 4, 5, 6):
            raise InputError(
                f"limb 1 to 4 and joint 1 to 6 are needed, limb {limb!r}, joint {joint!r} arrived"
            )
        return self[limb - 1][..., joint - 1, :]


@dataclass(eq=False, repr=False)
class _Factors:
    """Named factors, their scales, and which of them vanish."""

    result: Any
    rounding: float
    screen: Screen

    #: Which of a kernel's results are factors.
    NAMES: ClassVar[tuple[str, ...]]

    @cached_property
    def factors(self) -> Mapping[str, Array]:
        return self._named("")

    @cached_property
    def scales(self) -> Mapping[str, Array]:
        return self._named("_scale")

    @property
    def valid(self) -> Mask:
        return self.screen.valid

    def vanishing(self) -> dict[str, Mask]:
        """For each factor, where it counts as zero: ``|f| <= rounding eps scale``."""
        judged = factors(self.result).by_name()
        return {name: judged[name].zero(self.rounding) for name in self.factors}

    def undefined(self) -> dict[str, Mask]:
        """For each factor, where it is 0/0 in a valid row: a limb or the wrist has no form."""
        return {name: np.isnan(value) & self.valid for name, value in self.factors.items()}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(self.factors)})"

    def _named(self, suffix: str) -> Mapping[str, Array]:
        """Factors by name; those of limbs become ``name_1``, ``name_2``, ``name_3``."""
        named = {}
        for name in self.NAMES:
            value = getattr(self.result, name + suffix)
            if name in ("limb", "extension"):
                named.update({f"{name}_{i + 1}": value[..., i][()] for i in range(3)})
            else:
                named[name] = value[()]
        return named


class Singularity(_Factors):
    """A determinant and the factors that can make it vanish.

    Attributes
    ----------
    determinant : array (...)
        det J_q [m²] or det J_v [m³].
    factors, scales : mapping of name to array (...)
        Each factor, and the size of the terms that it is a sum of, in the factor's unit.
    rounding : float
        The k of "a factor is zero when |f| <= k eps scale".
    valid : bool array (...)
        False in rows that ``errors="nan"`` blanked.
    """

    #: Which of a kernel's results is the determinant.
    DETERMINANT: ClassVar[str]

    @property
    def determinant(self) -> Array:
        value: Array = getattr(self.result, self.DETERMINANT)[()]
        return value


class InverseSingularity(Singularity):
    """det J_q and its factors."""

    NAMES = ("limb", "central", "wrist")
    DETERMINANT = "inverse_determinant"


class DirectSingularity(Singularity):
    """det J_v and its factors."""

    NAMES = ("extension", "orientation", "wrist")
    DETERMINANT = "direct_determinant"


class Survey(_Factors):
    """Displacement and singularity analysis of poses in one pass.

    Attributes
    ----------
    joints : array (..., 6)
        q1 ... q6 in m, m, m, rad, rad, m.
    extension : array (..., 3)
        Signed distances e_i from C to B_i [m].
    inverse_determinant, direct_determinant : array (...)
        det J_q [m²] and det J_v [m³].
    factors, scales, rounding, valid
        As in `Singularity`; the factors of both determinants.
    """

    NAMES = ("limb", "central", "wrist", "extension", "orientation")

    @property
    def joints(self) -> Array:
        value: Array = self.result.joints
        return value

    @property
    def extension(self) -> Array:
        value: Array = self.result.extension
        return value

    @property
    def inverse_determinant(self) -> Array:
        value: Array = self.result.inverse_determinant[()]
        return value

    @property
    def direct_determinant(self) -> Array:
        value: Array = self.result.direct_determinant[()]
        return value
