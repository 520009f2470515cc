"""Tables for the tests of the command line."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np

Table = dict[str, np.ndarray]
#: The paper's pose, angles in degrees.
PAPER = ("--position", 0.25, 0.2, 1.0, "--rpy", 10, 3, 6, "--degrees")


def random_poses(count: int) -> Table:
    """Regular poses, angles in degrees, so small that they may pass for radians."""
    rng = np.random.default_rng(5)
    names = ("x", "y", "z", "roll", "pitch", "yaw")
    low, high = [-0.3, -0.3, 0.8, -6, -6, -6], [0.3, 0.3, 1.5, 6, 6, 6]
    return dict(zip(names, rng.uniform(low, high, (count, 6)).T, strict=True))


def write(path: Path, table: Table) -> Path:
    """Write a table in the format that the name of the file tells."""
    rows = [dict(zip(table, row, strict=True)) for row in zip(*table.values(), strict=True)]
    if path.suffix == ".npz":
        np.savez(path, **table)
    elif path.suffix == ".csv":
        lines = (",".join(map(repr, map(float, row.values()))) for row in rows)
        path.write_text("\n".join([",".join(table), *lines]) + "\n")
    else:
        path.write_text("".join(json.dumps(row) + "\n" for row in rows))
    return path


def read(path: Path) -> Table:
    """The numbers of a table; null is NaN."""
    if path.suffix == ".npz":
        with np.load(path) as arrays:
            return dict(arrays)
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".csv":
        return read_csv(text)
    rows = [json.loads(line) for line in text.splitlines()]
    return {name: np.array([row[name] for row in rows], dtype=float) for name in rows[0]}


def read_csv(text: str) -> Table:
    """The columns of a CSV; those with words as words."""
    names, *rows = csv.reader(io.StringIO(text))
    columns = np.array(rows).reshape(-1, len(names)).T
    table = {}
    for name, column in zip(names, columns, strict=True):
        try:
            table[name] = column.astype(float)
        except ValueError:
            table[name] = column
    return table


def array(table: Table) -> np.ndarray:
    """The columns side by side."""
    return np.stack(list(table.values()), axis=-1)
