"""Limits of the joints and extensions, and least distances from singularities, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import InitVar, dataclass, field
from math import inf, nan, pi, radians
from numbers import Real
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.joints import POSSIBLE, TURN

__all__ = ["ANGLES", "FACTORS", "LIMITED", "Limits"]

Array = NDArray[np.float64]
Range = tuple[float, float]

#: What may have a range.
LIMITED = ("q1", "q2", "q3", "q4", "q5", "q6", "e1", "e2", "e3")
#: Which factors may have a least size; one for all three limbs.
FACTORS = ("limb", "central", "wrist", "extension", "orientation")
ANGLES = ("q4", "q5")
UNITS = ("rad", "deg")
#: Characters of what arrived that a message shows.
SHOWN = 80


@dataclass(frozen=True)
class Limits:
    """Ranges of joints and extensions, and how near a factor of a singularity may come to zero.

    Parameters
    ----------
    ranges : mapping of name to (low, high)
        Of ``q1`` ... ``q6`` and ``e1``, ``e2``, ``e3`` in m and rad; infinite where there is
        no limit, as for a name that is not given. Each must have a value that the joint can
        have: q1, q2, q3, q6 >= 0, q5 in [−π/2, π/2]. q4 turns on and on: any range will do.
    margins : mapping of name to float
        The least size of ``limb`` [1], ``central`` [m²], ``wrist`` [1], ``extension`` [m] and
        ``orientation`` [m³]; those of limbs hold for all three.
    unit : {"rad", "deg"}
        Of the ranges of q4 and q5 as they are given; they are kept in rad.

    Raises
    ------
    InputError
        A name is unknown, or not low < high, or no joint value is in a range, or an end of q5
        is beyond a full turn, as degrees are, or a margin is negative or not finite.
    """

    ranges: Mapping[str, Range] = field(default_factory=dict)
    margins: Mapping[str, float] = field(default_factory=dict)
    unit: InitVar[str] = "rad"

    def __post_init__(self, unit: str) -> None:
        if not isinstance(unit, str) or unit not in UNITS:
            raise InputError(f'unit: "rad" or "deg" is needed, {_shown(unit)} arrived')
        ranges = {name: _range(name, given, unit) for name, given in _table("ranges", self.ranges)}
        margins = {name: _margin(name, given) for name, given in _table("margins", self.margins)}
        object.__setattr__(self, "ranges", MappingProxyType(ranges))
        object.__setattr__(self, "margins", MappingProxyType(margins))

    def __reduce__(self) -> tuple[Any, ...]:
        """Read-only views cannot be copied: what they show can."""
        return Limits, (dict(self.ranges), dict(self.margins))

    @classmethod
    def typical(cls, radius: float = 1.0) -> Limits:
        """Limits of a machine as it could be built, in proportion to its radius.

        The paper does not state those of its Fig. 3; these are ours. Outer legs from 0.6 to
        1.5 radii, the central limb from 0.7 to 1.4 radii and at least 40° above the base,
        extensions from 0.2 to 1.8 radii.
        """
        lengths = {**dict.fromkeys(("q1", "q2", "q3"), (0.6, 1.5)), "q6": (0.7, 1.4)}
        lengths |= dict.fromkeys(("e1", "e2", "e3"), (0.2, 1.8))
        ranges = {name: (low * radius, high * radius) for name, (low, high) in lengths.items()}
        return cls({**ranges, "q5": (radians(40.0), pi / 2.0)})

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> Limits:
        """Limits from a file with the tables ``[ranges]`` and ``[margins]``.

        ``q1 = [0.6, 1.5]``; ``inf`` is TOML's infinity. A line ``unit = "deg"`` above both has
        q4 and q5 in degrees.

        Raises
        ------
        InputError
            It is not TOML, or has other tables, or breaks a rule of `Limits`.
        OSError
            It cannot be read.
        """
        try:
            return cls(**_tables(Path(path).read_bytes()))
        except InputError as error:
            raise InputError(f"{path}: {error}") from None

    def range_of(self, name: str) -> Range:
        """The range of a joint or an extension, infinite where none is given."""
        return self.ranges.get(name, (-inf, inf))

    def room(self, joints: Array, extension: Array) -> dict[str, Array]:
        """How far each finite end of a range is away, in its unit; negative beyond it.

        Parameters
        ----------
        joints, extension : array (..., 6), (..., 3)

        Returns
        -------
        dict of name and "low" or "high" to array (...)
        """
        values = [*np.moveaxis(joints, -1, 0), *np.moveaxis(extension, -1, 0)]
        room = {}
        for name, value in zip(LIMITED, values, strict=True):
            low, high = self.range_of(name)
            if low > -inf:
                room[f"{name} low"] = value - low
            if high < inf:
                room[f"{name} high"] = high - value
        return room


def _tables(text: bytes) -> dict[str, Any]:
    """What a file of limits has."""
    import tomllib

    try:
        tables = tomllib.loads(text.decode())
    except RecursionError:
        raise InputError("not TOML of limits: nested too deep") from None
    except ValueError as error:  # of the syntax, of UTF-8, of whole numbers with 4300 digits
        raise InputError(f"not TOML: {_cut(str(error))}") from None
    unknown = sorted(set(tables) - {"ranges", "margins", "unit"})
    if unknown:
        raise InputError(f"[ranges], [margins], unit are known, {_shown(unknown[0])} arrived")
    return tables


def _table(name: str, given: Any) -> Any:
    """The entries of a table, its names checked."""
    known = LIMITED if name == "ranges" else FACTORS
    if not isinstance(given, Mapping):
        raise InputError(f"{name}: a table by name is needed, {_shown(given)} arrived")
    for key in given:
        if key not in known:
            raise InputError(f"{name}: one of {', '.join(known)} is needed, {_shown(key)} arrived")
    return given.items()


def _range(name: str, given: Any, unit: str) -> Range:
    """A range in m or rad, in which a joint value can be."""
    low, high = map(_number, given if _is_pair(given) else (nan, nan))
    if unit == "deg" and name in ANGLES:
        low, high = radians(low), radians(high)
    arrived = f"{_shown(given)} arrived"
    if not low < high:
        raise InputError(f"{name}: (low, high) with low < high is needed, {arrived}")
    if name == "q5" and any(TURN < abs(end) < inf for end in (low, high)):
        hint = "" if unit == "deg" else ': if these are degrees, say unit = "deg"'
        raise InputError(f"{name}: within a full turn is needed, {arrived}{hint}")
    least, most = POSSIBLE.get(name, (-inf, inf))
    if high < least or low > most:
        rule = f"{name} >= 0" if most == inf else f"{name} in [−π/2, π/2]"
        raise InputError(f"{name}: no joint value is in this range ({rule}), {arrived}")
    return low, high


def _is_pair(given: Any) -> bool:
    if isinstance(given, np.ndarray):
        return bool(given.shape == (2,))
    return isinstance(given, (list, tuple)) and len(given) == 2


def _number(given: Any) -> float:
    """A real number as a float, NaN for anything else."""
    if isinstance(given, bool) or not isinstance(given, Real):
        return nan
    try:
        return float(given)
    except OverflowError:
        return nan


def _margin(name: str, given: Any) -> float:
    value = _number(given)
    if not 0.0 <= value < inf:
        raise InputError(f"{name}: a number >= 0 is needed, {_shown(given)} arrived")
    return value


def _shown(given: Any) -> str:
    """What arrived, as a message shows it."""
    try:
        return _cut(repr(given))
    except (ValueError, RecursionError):  # a whole number with 4300 digits, lists too deep
        return f"{type(given).__name__} too large to show"


def _cut(text: str) -> str:
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."
