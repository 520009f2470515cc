# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Large batches on several cores.

Poses are independent, so that results do not depend on the number of threads. It is that of
`set_threads`, or else of the environment variable ``KLEINFORM_THREADS``, or of
``OMP_NUM_THREADS``, or else of the cores that the process may use. A call from another thread
than the main one, or from a process that multiprocessing has started, uses one thread: its
caller is parallel already.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

__all__ = ["in_parts", "set_threads", "threads"]

_wanted: int | None = None
_pool: ThreadPoolExecutor | None = None


def set_threads(count: int | None) -> None:
    """Use so many threads from now on; None for the default.

    Raises
    ------
    ValueError
        It is not a positive integer.
    """
    global _wanted
    if count is not None and (type(count) is not int or count < 1):
        raise ValueError(f"threads: a positive integer is needed, {count!r} arrived")
    _wanted = count
    _forget()


def threads() -> int:
    """Threads that a large batch uses when it is called from here.

    Raises
    ------
    ValueError
        KLEINFORM_THREADS is not a positive integer.
    """
    if _is_parallel():
        return 1
    return _wanted if _wanted is not None else _default()


def in_parts(task: Callable[[int, int], None], count: int, part: int) -> None:
    """Run ``task(start, stop)`` for parts of ``range(count)``, on threads if there are several."""
    number = threads() if count > part else 1
    if number == 1:
        task(0, count)
        return
    starts = range(0, count, part)
    for _ in _executor(number).map(lambda start: task(start, min(start + part, count)), starts):
        pass


def _default() -> int:
    given = os.environ.get("KLEINFORM_THREADS")
    if given is not None:
        if not given.isdecimal() or int(given) < 1:
            raise ValueError(f"KLEINFORM_THREADS: a positive integer is needed, {given!r} arrived")
        return int(given)
    others = os.environ.get("OMP_NUM_THREADS", "")
    if others.isdecimal() and int(others) >= 1:
        return int(others)
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def _is_parallel() -> bool:
    """Whether the caller is a thread or a process among others."""
    import threading

    if threading.current_thread() is not threading.main_thread():
        return True
    processes = sys.modules.get("multiprocessing")
    return processes is not None and processes.parent_process() is not None


def _executor(number: int) -> ThreadPoolExecutor:
    """The pool, made when it is first needed."""
    global _pool
    if _pool is None:
        from concurrent.futures import ThreadPoolExecutor

        _pool = ThreadPoolExecutor(number, thread_name_prefix="kleinform")
    return _pool


def _forget() -> None:
    """Make a new pool next time."""
    global _pool
    if _pool is not None:
        _pool.shutdown(wait=False)
    _pool = None


def _after_fork() -> None:
    """Threads do not survive a fork."""
    global _pool
    _pool = None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
