"""The lines of a text, in blocks, with their numbers."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from typing import BinaryIO, TextIO

from kleinform.commands.source import ROWS
from kleinform.errors import InputError

__all__ = ["LineBlock", "Lines"]


@dataclass(frozen=True)
class LineBlock:
    """Some lines, none of them blank; the attributes are those of `Block`."""

    lines: list[str]
    numbers: list[int]
    name: str
    done: float

    def where(self, row: int) -> str:
        return f"{self.name}, line {self.numbers[row]}"


class Lines:
    """The lines of a text that was not read yet."""

    def __init__(self, text: TextIO, name: str) -> None:
        self.name = name
        self._text = text
        self._size = _size(text.buffer) if text.buffer.seekable() else 0
        self._read = 0

    def first(self) -> tuple[str, int]:
        """The first line that is not blank, and its number; empty at the end of the text."""
        for block in iter(lambda: self._next(1), None):
            if block.lines:
                return block.lines[0], block.numbers[0]
        return "", self._read

    def blocks(self) -> Iterator[LineBlock]:
        """The lines that were not read yet."""
        yield from iter(lambda: self._next(ROWS), None)

    def rest(self) -> str:
        """What was not read yet, as one text."""
        with self._named_errors():
            return self._text.read()

    def _next(self, count: int) -> LineBlock | None:
        """The next lines, None at the end."""
        with self._named_errors():
            lines = list(islice(self._text, count))
        if not lines:
            return None
        first = self._read + 1
        self._read += len(lines)
        numbered = [(n, line) for n, line in enumerate(lines, first) if not line.isspace()]
        done = self._text.buffer.tell() / self._size if self._size else 0.0
        return LineBlock([line for _, line in numbered], [n for n, _ in numbered], self.name, done)

    @contextmanager
    def _named_errors(self) -> Iterator[None]:
        """Errors of reading, with the name of what is read."""
        try:
            yield
        except UnicodeDecodeError as error:
            raise InputError(f"{self.name}: not a text in UTF-8: {error}") from None
        except OSError as error:
            error.filename = self.name
            raise


def _size(stream: BinaryIO) -> int:
    """How many bytes a stream has that knows its end."""
    here = stream.tell()
    size = stream.seek(0, os.SEEK_END)
    stream.seek(here)
    return size
