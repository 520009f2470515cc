"""The working precision of python-flint: one for the whole process, so one thread at a time.

Proofs in ball arithmetic wait for each other here. A program that uses python-flint from
other threads meanwhile finds its own precision changed: it can enter `working_precision` too.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock

from kleinform.errors import MissingExtraError

__all__ = ["working_precision"]

LOCK = RLock()


@contextmanager
def working_precision(bits: int) -> Iterator[None]:
    """Work with so many bits, alone, and restore the precision after that, also on errors.

    Raises
    ------
    MissingExtraError
        python-flint is not installed.
    """
    try:
        from flint import ctx
    except ImportError as error:
        raise MissingExtraError(
            "a proof in ball arithmetic needs python-flint: install kleinform[certify]"
        ) from error
    with LOCK, ctx.workprec(bits):
        yield
