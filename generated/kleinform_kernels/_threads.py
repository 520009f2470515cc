# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Large batches on several cores.

Poses are independent, so that results do not depend on the number of threads. It is that of
`set_threads`, or else of the environment variable ``KLEINFORM_THREADS``, or of
``OMP_NUM_THREADS`` (both read at the import), or else of the cores that the process may use.
A call from another thread than the main one, or from a process that multiprocessing has
started, uses one thread: its caller is parallel already.
"""

from __future__ import annotations

import os
import sys
from collections import deque
from collections.abc import Callable
from operator import index
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import threading

__all__ = ["in_parts", "set_threads", "threads"]


def _from_environment() -> int | None:
    given = os.environ.get("KLEINFORM_THREADS", "")
    if given and (not given.isdecimal() or int(given) < 1):
        raise ImportError(f"KLEINFORM_THREADS: a positive integer is needed, {given!r} arrived")
    # OpenMP's variable may be a list, a number for each level of nesting.
    wish = given or os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return int(wish) if wish.isdecimal() and int(wish) >= 1 else None


_GIVEN = _from_environment()
_wanted: int | None = None


def set_threads(count: int | None) -> None:
    """Use so many threads from now on; None for the default.

    Raises
    ------
    ValueError
        It is not a positive integer.
    """
    global _wanted
    try:
        number = None if count is None else index(count)
    except TypeError:
        number = 0
    if isinstance(count, bool) or (number is not None and number < 1):
        raise ValueError(f"threads: a positive integer is needed, {count!r} arrived")
    _wanted = number


def threads() -> int:
    """Threads that a large batch uses when it is called from here."""
    if _is_parallel():
        return 1
    return _wanted or _GIVEN or _cores()


def in_parts(task: Callable[[int, int], None], count: int, part: int) -> None:
    """Run ``task(start, stop)`` for parts of ``range(count)``, on threads if there are several.

    The caller takes parts like the other threads. When it is interrupted, or a part raises,
    no further part is begun.
    """
    starts = deque(range(0, count, part))
    errors: list[BaseException] = []

    def take() -> None:
        while starts:
            try:
                start = starts.popleft()
            except IndexError:  # another thread was faster
                return
            task(start, min(start + part, count))

    def help_out() -> None:
        try:
            take()
        except BaseException as error:
            starts.clear()
            errors.append(error)

    helpers = _started(help_out, min(threads(), len(starts)) - 1) if len(starts) > 1 else []
    try:
        take()
    finally:
        starts.clear()
        for helper in helpers:
            helper.join()
    if errors:
        raise errors[0]


def _started(work: Callable[[], None], number: int) -> list[threading.Thread]:
    """So many threads at work, or fewer where the system gives no more."""
    import threading

    helpers: list[threading.Thread] = []
    for _ in range(number):
        helper = threading.Thread(target=work, name="kleinform", daemon=True)
        try:
            helper.start()
        except RuntimeError:
            break
        helpers.append(helper)
    return helpers


def _is_parallel() -> bool:
    """Whether the caller is a thread or a process among others."""
    import threading

    if threading.current_thread() is not threading.main_thread():
        return True
    processes = sys.modules.get("multiprocessing")
    return processes is not None and processes.parent_process() is not None


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1
