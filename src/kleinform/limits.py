"""Limits of the joints and extensions, and least distances from singularities, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import inf, nan, pi, radians
from numbers import Real
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError

__all__ = ["FACTORS", "LIMITED", "Limits"]

Array = NDArray[np.float64]
Range = tuple[float, float]

#: What may have a range.
LIMITED = ("q1", "q2", "q3", "q4", "q5", "q6", "e1", "e2", "e3")
#: Which factors may have a least size; one for all three limbs.
FACTORS = ("limb", "central", "wrist", "extension", "orientation")


@dataclass(frozen=True)
class Limits:
    """Ranges of joints and extensions, and how near a factor of a singularity may come to zero.

    Parameters
    ----------
    ranges : mapping of name to (low, high)
        Of ``q1`` ... ``q6`` and ``e1``, ``e2``, ``e3`` in m and rad; infinite where there is
        no limit, as for a name that is not given.
    margins : mapping of name to float
        The least size of ``limb`` [1], ``central`` [m²], ``wrist`` [1], ``extension`` [m] and
        ``orientation`` [m³]; those of limbs hold for all three.

    Raises
    ------
    InputError
        A name is unknown, or not low < high, or a margin is negative or not finite.
    """

    ranges: Mapping[str, Range] = field(default_factory=dict)
    margins: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ranges = {name: _range(name, given) for name, given in _table("ranges", self.ranges)}
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

        ``q1 = [0.6, 1.5]``; ``inf`` is TOML's infinity.

        Raises
        ------
        InputError
            It is not TOML, or has other tables, or breaks a rule of `Limits`.
        OSError
            It cannot be read.
        """
        import tomllib

        try:
            tables = tomllib.loads(Path(path).read_text(encoding="utf-8"))
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise InputError(f"{path}: not TOML: {error}") from error
        unknown = set(tables) - {"ranges", "margins"}
        if unknown:
            raise InputError(f"{path}: [ranges] and [margins] are known, {min(unknown)!r} arrived")
        try:
            return cls(**tables)
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


def _table(name: str, given: Any) -> Any:
    """The entries of a table, its names checked."""
    known = LIMITED if name == "ranges" else FACTORS
    if not isinstance(given, Mapping):
        raise InputError(f"{name}: a table by name is needed, {given!r} arrived")
    for key in given:
        if key not in known:
            raise InputError(f"{name}: one of {', '.join(known)} is needed, {key!r} arrived")
    return given.items()


def _range(name: str, given: Any) -> Range:
    pair = given if isinstance(given, (list, tuple, np.ndarray)) and len(given) == 2 else (inf, inf)
    low, high = map(_number, pair)
    if not low < high:
        raise InputError(f"{name}: (low, high) with low < high is needed, {given!r} arrived")
    return low, high


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
        raise InputError(f"{name}: a number >= 0 is needed, {given!r} arrived")
    return value
