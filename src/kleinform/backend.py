"""Which kernels run, and on how many threads."""

from __future__ import annotations

from typing import NamedTuple

from kleinform.errors import InputError
from kleinform.generated import kernels
from kleinform_kernels import _backend, _threads

__all__ = ["Backend", "backend", "set_threads", "threads"]


class Backend(NamedTuple):
    """What computes.

    ``name`` is ``"compiled"`` or ``"numpy"``; ``instructions`` are those that compiled loops
    use on this machine (``"baseline"``, ``"avx2"``, ``"avx512"``); ``reason`` says why it is
    not the compiled one, and is empty if it is.
    """

    name: str
    instructions: str
    reason: str


def backend() -> Backend:
    """The backend in use.

    The compiled one is used where it is installed. The environment variable
    ``KLEINFORM_BACKEND`` chooses before the import: ``numpy``, or ``compiled``, which is an
    error where there is none.
    """
    return Backend(kernels.BACKEND, _backend.INSTRUCTIONS, _backend.REASON)


def threads() -> int:
    """Threads that a large batch uses when it is called from here.

    Those of `set_threads`, or else of the environment variable ``KLEINFORM_THREADS``, or of
    ``OMP_NUM_THREADS`` at the import, or else the cores that the process may use. It is one in
    other threads than the main one and in processes that multiprocessing started: their caller
    is parallel already. Results do not depend on it. The NumPy backend always uses one.
    """
    return _threads.threads()


def set_threads(count: int | None) -> None:
    """Use so many threads for large batches from now on; None for the default.

    Raises
    ------
    InputError
        It is not a positive integer.
    """
    try:
        _threads.set_threads(count)
    except ValueError as error:
        raise InputError(str(error)) from error
