"""Tables written as text: every float64 with as many digits as bring it back."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from kleinform.commands.columns import Table

__all__ = ["csv_writer", "json_writer"]

#: JSON has no NaN and no infinity; a number beyond float64 is read as infinity.
JSON = {"nan": "null", "inf": "1e999", "-inf": "-1e999"}


def csv_writer(out: Callable[[str], object]) -> Callable[[Table], None]:
    """Write tables, one below the other, with one line of names above the first."""
    named = False

    def write(table: Table) -> None:
        nonlocal named
        if not named:
            out(",".join(table) + "\n")
            named = True
        columns = [_texts(column) for column in table.values()]
        out("".join(line + "\n" for line in map(",".join, zip(*columns, strict=True))))

    return write


def json_writer(out: Callable[[str], object]) -> Callable[[Table], None]:
    """Write tables as JSON lines: an object a row, a row a line."""

    def write(table: Table) -> None:
        keys = (json.dumps(name).replace("%", "%%") for name in table)
        template = "{" + ", ".join(f"{key}: %s" for key in keys) + "}\n"
        columns = [_json_texts(column) for column in table.values()]
        out("".join(template % row for row in zip(*columns, strict=True)))

    return write


def _texts(column: NDArray[Any]) -> list[str]:
    """Each value as CSV and JSON write it; words as they are."""
    values = column.tolist()
    if column.dtype.kind == "b":
        return ["true" if value else "false" for value in values]
    return list(map(str, values))


def _json_texts(column: NDArray[Any]) -> list[str]:
    if column.dtype.kind == "U":
        return [json.dumps(value, ensure_ascii=False) for value in column.tolist()]
    return [JSON.get(text, text) for text in _texts(column)]
