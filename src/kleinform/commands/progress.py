"""A bar or a spinner on standard error while work takes long."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer

from rich.console import Console
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

__all__ = ["progress", "spinner"]

#: Seconds until something appears.
PATIENCE = 1.0


@contextmanager
def progress(shown: bool) -> Iterator[Callable[[float], None]]:
    """Show how much is done, from 0 to 1, if asked to and standard error is a terminal.

    0 is unknown, as of a pipe, and shows nothing.
    """
    if not (shown and sys.stderr.isatty()):
        yield lambda _: None
        return
    appears = time.monotonic() + PATIENCE
    bar = Progress(console=Console(stderr=True), transient=True)
    task = bar.add_task("rows", total=1.0)

    def report(done: float) -> None:
        bar.update(task, completed=done)
        if done and time.monotonic() >= appears:
            bar.start()

    try:
        yield report
    finally:
        bar.stop()


@contextmanager
def spinner(name: str) -> Iterator[None]:
    """Show that work goes on, of which nobody knows how much is done, at a terminal."""
    if not sys.stderr.isatty():
        yield
        return
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    shown = Progress(*columns, console=Console(stderr=True), transient=True)
    shown.add_task(name, total=None)
    timer = Timer(PATIENCE, shown.start)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        shown.stop()
