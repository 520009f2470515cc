"""One answer, aligned for somebody who reads it at a terminal."""

from __future__ import annotations

from shutil import get_terminal_size
from typing import Any

import numpy as np

from kleinform.commands.columns import Table, unit

__all__ = ["WIDTH", "print_aligned", "word"]

#: Characters of a number.
WIDTH = 11


def print_aligned(table: Table, degrees: bool) -> None:
    """Print a line for each column of the table, with its unit; rows stand side by side."""
    titles = [_title(name, degrees) for name in table]
    width = max(map(len, titles))
    rows = list(zip(*(column.tolist() for column in table.values()), strict=True))
    beside = max(1, (get_terminal_size().columns - width) // (WIDTH + 1))
    for first in range(0, len(rows), beside):
        if first:
            print()
        for title, *values in zip(titles, *rows[first : first + beside], strict=True):
            line = " ".join([f"{title:{width}}", *(f"{word(value):>{WIDTH}}" for value in values)])
            print(line.rstrip())


def _title(name: str, degrees: bool) -> str:
    of = unit(name, degrees)
    return f"{name} [{of}]" if of else name


def word(value: Any) -> str:
    """A number in at most 11 characters; words are as long as they are."""
    if not isinstance(value, float):
        return str(value).lower()
    plain = value == 0.0 or not np.isfinite(value) or 1e-3 <= abs(value) < 1e3
    return f"{value:.6f}" if plain else f"{value:.4e}"
