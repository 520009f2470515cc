"""A table that is read in blocks of rows, wherever it comes from."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from kleinform.commands.columns import Table
from kleinform.errors import InputError

__all__ = ["ROWS", "Block", "Given", "Source", "given_row", "numbered", "require", "shown", "whole"]

#: Rows of a block: enough for the batches to pay, few enough to stay in cache.
ROWS = 8192
#: For each option the columns that it fills, and what arrived.
Given = Mapping[str, tuple[Sequence[str], Sequence[float] | None]]


@dataclass(frozen=True)
class Block:
    """Some rows of a table.

    Attributes
    ----------
    table : dict of name to array (rows,)
    where : callable
        From the index of a row in this block to its place in the input, in words.
    cell : callable
        From the index of a row and the name of a column to what stands there, in words.
    done : float
        How much of the input is read with this block, from 0 to 1.
    """

    table: Table
    where: Callable[[int], str]
    cell: Callable[[int, str], str]
    done: float


class Source(Protocol):
    """A table that knows its columns before it is read."""

    @property
    def name(self) -> str:
        """What an error calls it."""

    @property
    def columns(self) -> Sequence[str]: ...

    def blocks(self, names: Sequence[str]) -> Iterator[Block]:
        """The columns of these names, all float64; at least one block, though it be empty."""


@dataclass(frozen=True)
class GivenRow:
    """One row, from the options of a command."""

    table: Table
    name: str = "the options"

    @property
    def columns(self) -> Sequence[str]:
        return tuple(self.table)

    def blocks(self, names: Sequence[str]) -> Iterator[Block]:
        table = {name: self.table[name] for name in names}
        yield Block(table, lambda _: "", shown(table), 1.0)


def given_row(given: Given) -> Source | None:
    """The row that options give, or None where none of them is there.

    Raises
    ------
    InputError
        Some of the options are there, and others are missing.
    """
    missing = [option for option, (_, values) in given.items() if values is None]
    if len(missing) == len(given):
        return None
    if missing:
        raise InputError(f"{', '.join(given)} belong together: {', '.join(missing)} is missing")
    table = {
        name: np.array([value])
        for names, values in given.values()
        for name, value in zip(names, values or (), strict=True)
    }
    return GivenRow(table)


def require(source: Source, names: Sequence[str]) -> None:
    """Refuse a table that lacks a column, or has it twice.

    Raises
    ------
    InputError
    """
    missing = [name for name in names if name not in source.columns]
    if missing:
        raise InputError(
            f"{source.name}: column {', '.join(missing)} is missing; "
            f"{', '.join(source.columns)} arrived"
        )
    twice = [name for name in names if source.columns.count(name) > 1]
    if twice:
        raise InputError(f"{source.name}: column {', '.join(twice)} is there twice")


def numbered(name: str, first: int) -> Callable[[int], str]:
    """The places of rows that have no lines, counted from 0, in a block that begins at first."""
    return lambda row: f"{name}, row {first + row}"


def shown(table: Table) -> Callable[[int, str], str]:
    """What stands in a table of numbers."""
    return lambda row, name: repr(table[name][row].item())


def whole(source: Source, names: Sequence[str]) -> Block:
    """All rows in one block."""
    blocks = list(source.blocks(names))
    table = {name: np.concatenate([block.table[name] for block in blocks]) for name in names}
    sizes = [len(block.table[names[0]]) for block in blocks]
    ends = np.cumsum(sizes)

    def place(row: int) -> tuple[Block, int]:
        index = int(np.searchsorted(ends, row, side="right"))
        return blocks[index], row - int(ends[index]) + sizes[index]

    def where(row: int) -> str:
        block, own = place(row)
        return block.where(own)

    def cell(row: int, name: str) -> str:
        block, own = place(row)
        return block.cell(own, name)

    return Block(table, where, cell, 1.0)
