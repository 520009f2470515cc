"""From rows to answers, block by block, in constant memory."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.commands.columns import Table, in_degrees, in_radians
from kleinform.commands.nearness import Nearness
from kleinform.commands.progress import progress
from kleinform.commands.source import Block, Given, Source, require
from kleinform.commands.streams import Streams
from kleinform.commands.wording import in_columns
from kleinform.errors import KleinformError, TrackingError

__all__ = ["Answer", "answer_rows", "named_row"]


class Answer(NamedTuple):
    """What comes out for a block of rows, and which of them were refused."""

    table: Table
    refused: NDArray[np.bool_]


def answer_rows(
    streams: Streams,
    given: Given,
    needed: Callable[[Source], Sequence[str]],
    compute: Callable[[Table], Answer],
) -> None:
    """Read rows, compute in radians, write answers; say how many rows were refused or near.

    Parameters
    ----------
    streams, given
        Where the rows come from, and where the answers go.
    needed : callable
        The columns that are needed of a source.
    compute : callable
        From a block of them to its answer.

    Raises
    ------
    KleinformError
        It names the row by its place in the whole input.
    """
    count, place = 0, ""
    near = Nearness()
    writer = streams.writer(one_answer=streams.table is None)
    with streams.source(given) as source, writer as write:
        names = needed(source)
        require(source, names)
        with progress(not streams.on_terminal) as report:
            for block in source.blocks(names):
                with near.noted(block):
                    answer = _answer(block, compute, streams.degrees)
                write(in_degrees(answer.table) if streams.degrees else answer.table)
                if answer.refused.any():
                    place = place or block.where(int(np.argmax(answer.refused)))
                    count += int(np.sum(answer.refused))
                report(block.done)
    near.tell()
    if count:
        first = f", the first at {place}" if place else ""
        print(f"kleinform: rows refused: {count}{first}", file=sys.stderr)


def named_row(error: KleinformError, block: Block, degrees: bool) -> KleinformError:
    """An error of a row of a block, with the row's place in the whole input, and the column."""
    if isinstance(error, TrackingError):
        row = error.sample
    elif error.mask is not None:
        row = int(np.argmax(error.mask))
    else:
        return error
    rule = in_columns(error, block, row, degrees)
    place = block.where(row)
    return type(error)(f"{place}: {rule}" if place else rule)


def _answer(block: Block, compute: Callable[[Table], Answer], degrees: bool) -> Answer:
    try:
        return compute(in_radians(block.table, degrees))
    except KleinformError as error:
        raise named_row(error, block, degrees) from None
