"""Tables as CSV: a line with the names of the columns, then a line a row."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence

import numpy as np

from kleinform.commands.columns import Array
from kleinform.commands.formats.lines import LineBlock, Lines
from kleinform.commands.source import Block
from kleinform.errors import InputError

__all__ = ["CsvSource"]


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
        yield Block({name: np.empty(0) for name in names}, str, 0.0)
        for block in self._lines.blocks():
            self._check_fields(block)
            numbers = _numbers(block, used)
            table = {name: numbers[:, index] for index, name in enumerate(names)}
            yield Block(table, block.where, block.done)

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


def _numbers(block: LineBlock, used: Sequence[int]) -> Array:
    """Some columns of some lines."""
    if not block.lines:
        return np.empty((0, len(used)))
    try:
        return _parsed(block.lines, used)
    except ValueError as error:
        for row, line in enumerate(block.lines):
            try:
                _parsed([line], used)
            except ValueError as culprit:
                what = str(culprit).partition(" at row")[0]
                raise InputError(f"{block.where(row)}: {what}") from None
        raise InputError(f"{block.name}: {error}") from None


def _parsed(lines: list[str], used: Sequence[int]) -> Array:
    return np.loadtxt(lines, delimiter=",", usecols=used, ndmin=2, comments=None, quotechar='"')
