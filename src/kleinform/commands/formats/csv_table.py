"""Tables as CSV: a line with the names of the columns, then a line a row."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from kleinform.commands.columns import Array, Table, named
from kleinform.commands.formats.lines import LineBlock, Lines
from kleinform.commands.source import Block, shown
from kleinform.errors import InputError

__all__ = ["CsvSource"]

#: Cells that say that there is no number.
MISSING = ("", "NA")


class CsvSource:
    """A CSV that is read in blocks; columns that nobody asks for may hold anything."""

    def __init__(self, lines: Lines) -> None:
        self.name = lines.name
        self._lines = lines
        header, number = lines.first()
        if not header:
            raise InputError(f"{self.name}: empty, a line with the names of columns is needed")
        self.columns = [name.strip() for name in _fields(header, f"{self.name}, line {number}")]

    def blocks(self, names: Sequence[str]) -> Iterator[Block]:
        used = [self.columns.index(name) for name in names]
        empty: Table = {name: np.empty(0) for name in names}
        yield Block(empty, str, shown(empty), 0.0)
        for block in self._lines.blocks():
            self._check_fields(block)
            table = named(names, _numbers(block, dict(zip(names, used, strict=True))))
            yield Block(table, block.where, self._cells(block), block.done)

    def _cells(self, block: LineBlock) -> Callable[[int, str], str]:
        def cell(row: int, name: str) -> str:
            fields = _fields(block.lines[row], block.where(row))
            return fields[self.columns.index(name)].strip() or "a blank"

        return cell

    def _check_fields(self, block: LineBlock) -> None:
        """Every line has as many fields as there are columns."""
        commas = len(self.columns) - 1
        for row, line in enumerate(block.lines):
            if line.count(",") == commas and '"' not in line:
                continue
            fields = _fields(line, block.where(row))
            if len(fields) != len(self.columns):
                raise InputError(
                    f"{block.where(row)}: {len(self.columns)} fields are needed, "
                    f"{len(fields)} arrived"
                )


def _fields(line: str, where: str) -> list[str]:
    """The fields of one line."""
    try:
        return next(csv.reader([line], strict=True))
    except csv.Error as error:
        raise InputError(f"{where}: {error}") from None


def _numbers(block: LineBlock, used: Mapping[str, int]) -> Array:
    """Some columns, by their names, of some lines."""
    if not block.lines:
        return np.empty((0, len(used)))
    try:
        columns = list(used.values())
        return np.loadtxt(
            block.lines, delimiter=",", usecols=columns, ndmin=2, comments=None, quotechar='"'
        )
    except ValueError:
        return _one_by_one(block, used)


def _one_by_one(block: LineBlock, used: Mapping[str, int]) -> Array:
    """The same with cells that are missing, which are NaN, or that are no numbers."""
    numbers = np.empty((len(block.lines), len(used)))
    for row, line in enumerate(block.lines):
        where = block.where(row)
        fields = _fields(line, where)
        for index, (name, place) in enumerate(used.items()):
            numbers[row, index] = _number(fields[place].strip(), f"{where}: {name}")
    return numbers


def _number(text: str, where: str) -> float:
    if text in MISSING:
        return np.nan
    try:
        # Python reads more than CSV should have: 1_000, and digits of other scripts.
        if text.isascii() and "_" not in text:
            return float(text)
    except ValueError:
        pass
    raise InputError(f"{where}: a number is needed, {text!r} arrived")
