"""The command's standard streams: any may be closed, and nobody need hear standard error."""

from __future__ import annotations

import io
import os
import sys
from contextlib import suppress
from typing import Any

__all__ = ["prepare", "settle"]


class Heard(io.FileIO):
    """Standard error: it is no reason to fail that nobody hears it."""

    def write(self, data: Any) -> int:
        """Write what can be written, and take the rest as written."""
        with suppress(OSError):
            super().write(data)
        return len(data)


def prepare() -> None:
    """Stand in for closed streams, and make standard error a stream that never fails."""
    # What is opened takes the lowest free number, so that no file has one of theirs. Opened
    # the other way around, standard input and output fail when they are used.
    if sys.stdin is None:
        sys.stdin = os.fdopen(os.open(os.devnull, os.O_WRONLY), encoding="utf-8")
    if sys.stdout is None:
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_RDONLY), "w", encoding="utf-8")
    if sys.stderr is None:
        sys.stderr = os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8")
    elif (own := sys.__stderr__) is sys.stderr and own is not None:
        heard: Any = Heard(own.fileno(), "w", closefd=False)
        sys.stderr = io.TextIOWrapper(
            heard, own.encoding, errors="backslashreplace", write_through=True
        )


def settle() -> None:
    """Forget what standard output does not take: Python would try again at its end, and fail."""
    try:
        sys.stdout.flush()
    except OSError:
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8")
