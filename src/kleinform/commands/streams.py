"""Where a command reads its rows and writes its answers."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from kleinform.commands.columns import Table
from kleinform.commands.formats.csv_table import CsvSource
from kleinform.commands.formats.json_lines import JsonSource
from kleinform.commands.formats.lines import Lines
from kleinform.commands.formats.npz import NpzSource, npz_writer
from kleinform.commands.formats.text import csv_writer, json_writer
from kleinform.commands.source import Given, Source, given_row
from kleinform.commands.terminal import print_aligned
from kleinform.errors import InputError
from kleinform.files import folder_of, written

__all__ = ["Format", "Streams", "Writer"]

Format = Literal["csv", "json"]
Writer = Callable[[Table], None]

FORMATS = {".csv": "csv", ".json": "json", ".jsonl": "json", ".npz": "npz"}
TEXT_SOURCES: dict[str, Callable[[Lines], Source]] = {"csv": CsvSource, "json": JsonSource}
TEXT_WRITERS = {"csv": csv_writer, "json": json_writer}
STANDARD = Path("-")
#: With or without a byte order mark.
ENCODING = "utf-8-sig"


@dataclass(frozen=True)
class Streams:
    """The options of a command that say where rows come from and where answers go.

    Attributes
    ----------
    table : Path or None
        File to read, ``-`` for standard input.
    output : Path or None
        File to write, standard output without.
    format : "csv", "json" or None
        Of standard input and output.
    degrees : bool
    """

    table: Path | None
    output: Path | None
    format: Format | None
    degrees: bool

    @property
    def on_terminal(self) -> bool:
        """Whether somebody looks at the answers."""
        return self.output is None and sys.stdout.isatty()

    @property
    def aligned(self) -> bool:
        """Whether one answer is laid out for somebody who looks, no format being asked for."""
        return self.format is None and self.on_terminal

    @contextmanager
    def source(self, given: Given) -> Iterator[Source]:
        """The rows: those of the options, or those of the table."""
        row = given_row(given)
        if (row is None) == (self.table is None):
            raise InputError(f"either {' and '.join(given)}, or --input is needed")
        if row is not None:
            yield row
        elif self.table == STANDARD:
            with io.TextIOWrapper(sys.stdin.buffer, ENCODING) as text:
                yield TEXT_SOURCES[self.format or "csv"](Lines(text, "standard input"))
        elif self.table is not None:
            with _opened(self.table) as source:
                yield source

    @contextmanager
    def writer(self, *, one_answer: bool) -> Iterator[Writer]:
        """What writes the answers; a file is written whole or not at all.

        One answer is aligned at a terminal, unless a format is asked for.
        """
        if self.output is not None:
            with _file_writer(self.output) as write:
                yield write
        elif one_answer and self.aligned:
            yield lambda table: print_aligned(table, self.degrees)
        else:
            yield TEXT_WRITERS[self.format or "csv"](sys.stdout.write)


@contextmanager
def _opened(path: Path) -> Iterator[Source]:
    form = _format_of(path)
    if form == "npz":
        with path.open("rb") as stream:
            yield NpzSource(stream, str(path))
    else:
        with path.open(encoding=ENCODING) as text:
            yield TEXT_SOURCES[form](Lines(text, str(path)))


@contextmanager
def _file_writer(path: Path) -> Iterator[Writer]:
    """Write aside, and put the file in place at the end."""
    form = _format_of(path)
    with written(path) as stream:
        if form == "npz":
            with npz_writer(stream, folder_of(path)) as write:
                yield write
        else:
            yield TEXT_WRITERS[form](lambda text: stream.write(text.encode()))


def _format_of(path: Path) -> str:
    """The format that a file's name tells."""
    form = FORMATS.get(path.suffix.lower())
    if form is None:
        raise InputError(f"{path}: the name must end in one of {', '.join(FORMATS)}")
    return form
