"""The columns of tables: names, order, units. Everything about degrees follows from the units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kleinform.conditioning import SINGULAR_VALUES
from kleinform.errors import InputError
from kleinform.joints import TURN

__all__ = [
    "ACCELERATIONS",
    "ANGLES",
    "DEGENERATE",
    "DETERMINANTS",
    "EXTENSIONS",
    "FACTORS",
    "JOINTS",
    "POSE",
    "POSITION",
    "RATES",
    "TWIST",
    "TWIST_RATE",
    "Array",
    "Table",
    "in_degrees",
    "in_radians",
    "joined",
    "named",
    "stacked",
    "unit",
]

Array = NDArray[np.float64]
#: Columns of equal length by their names.
Table = dict[str, NDArray[Any]]

POSITION = ("x", "y", "z")
ANGLES = ("roll", "pitch", "yaw")
POSE = POSITION + ANGLES
JOINTS = tuple(f"q{i}" for i in range(1, 7))
RATES = tuple(f"d{name}" for name in JOINTS)
ACCELERATIONS = tuple(f"dd{name}" for name in JOINTS)
TWIST = ("wx", "wy", "wz", "vx", "vy", "vz")
TWIST_RATE = tuple(f"d{name}" for name in TWIST)
EXTENSIONS = ("e1", "e2", "e3")
DETERMINANTS = ("inverse_determinant", "direct_determinant")
FACTORS = (
    *("limb_1", "limb_2", "limb_3", "central", "wrist"),
    *("extension_1", "extension_2", "extension_3", "orientation"),
)
#: What `AssemblyModes.degenerate` names, in a form without spaces.
DEGENERATE = ("c·u_1=a", "c·u_2=a", "c·u_3=a", "q_1=0", "q_2=0", "q_3=0", "q_6=0")

#: What `kleinform.commands.nearness.columns` makes of a `Conditioning`.
CONDITIONING_UNITS = {
    **{f"ratio_{name}": "1" for name in (*FACTORS, "leg_1", "leg_2", "leg_3")},
    **{
        f"{name}_{index + 1}": unit
        for name, (count, unit) in SINGULAR_VALUES.items()
        for index in range(count)
    },
}

LENGTHS_AND_ANGLES = ("m", "m", "m", "rad", "rad", "m")
#: Angles that do not count turns.
WITHIN_A_TURN = (*ANGLES, "q5")
UNITS = {
    "t": "s",
    **dict.fromkeys((*POSITION, *EXTENSIONS), "m"),
    **dict.fromkeys(ANGLES, "rad"),
    **dict(zip(JOINTS, LENGTHS_AND_ANGLES, strict=True)),
    **dict(zip(RATES, (f"{unit}/s" for unit in LENGTHS_AND_ANGLES), strict=True)),
    **dict(zip(ACCELERATIONS, (f"{unit}/s²" for unit in LENGTHS_AND_ANGLES), strict=True)),
    **dict(zip(TWIST, 3 * ("rad/s",) + 3 * ("m/s",), strict=True)),
    **dict(zip(TWIST_RATE, 3 * ("rad/s²",) + 3 * ("m/s²",), strict=True)),
    **dict.fromkeys(("volume", "volume_error"), "m³"),
    **dict(zip(DETERMINANTS, ("m²", "m³"), strict=True)),
    **dict(zip(FACTORS, ("1", "1", "1", "m²", "1", "m", "m", "m", "m³"), strict=True)),
    **CONDITIONING_UNITS,
}


def unit(name: str, degrees: bool) -> str:
    """The unit of a column, empty for numbers that count and for words."""
    known = UNITS.get(name, "")
    return known.replace("rad", "deg") if degrees else known


def in_radians(table: Table, degrees: bool) -> Table:
    """A table as it arrived, its angles and angular rates in radians.

    Raises
    ------
    InputError
        An angle in radians is beyond a full turn, as one in degrees would be. q4 is left alone,
        since it may count its turns. The mask has the rows.
    """
    if degrees:
        with np.errstate(invalid="ignore"):  # of a signalling NaN, which is told later on
            return {
                name: np.radians(column) if _turns(name) else column
                for name, column in table.items()
            }
    for name in WITHIN_A_TURN:
        if name in table:
            _reject_beyond_a_turn(name, table[name])
    return table


def in_degrees(table: Table) -> Table:
    """A table whose angles and angular rates are in radians, with them in degrees."""
    return {name: np.degrees(column) if _turns(name) else column for name, column in table.items()}


def stacked(table: Table, names: Sequence[str]) -> Array:
    """Some columns as one array (rows, columns)."""
    return np.stack([table[name] for name in names], axis=-1)


def named(names: Sequence[str], array: Array) -> Table:
    """One array (rows, columns) as columns."""
    return {name: array[:, index] for index, name in enumerate(names)}


def joined(names: Sequence[str], where: NDArray[np.bool_]) -> NDArray[np.str_]:
    """For each row of flags (rows, names) the names that are true, with spaces between."""
    words = np.zeros(len(where), dtype=f"U{len(' '.join(names))}")
    for row in np.flatnonzero(where.any(axis=1)):
        words[row] = " ".join(np.array(names)[where[row]])
    return words


def _turns(name: str) -> bool:
    return UNITS.get(name, "").startswith("rad")


def _reject_beyond_a_turn(name: str, angles: Array) -> None:
    """Refuse finite angles beyond 2π: the unit is wrong, and so the whole table."""
    beyond = (abs(angles) > TURN) & np.isfinite(angles)
    if beyond.any():
        first = float(angles[beyond][0])
        raise InputError(
            f"{name}: within a full turn in rad is needed, {first!r} arrived; "
            "if angles are in degrees, give --degrees",
            beyond,
        )
