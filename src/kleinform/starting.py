"""The command while it loads: an interrupt ends it at once, without a traceback.

Nothing is written by then. `cli.main` takes over when it can handle an interrupt itself.
"""

from __future__ import annotations

import os
import signal
import sys
from contextlib import suppress

__all__ = ["loaded"]


def _leave(number: int, _: object) -> None:
    os._exit(128 + number)


def _is_command() -> bool:
    """Whether this process is the command, as a script or as ``python -m kleinform``."""
    if sys.argv[0] == "-m":  # until Python has found the module to run
        return sys.orig_argv[-len(sys.argv)] in ("kleinform", "-mkleinform")
    return os.path.splitext(os.path.basename(sys.argv[0]))[0] == "kleinform"


def loaded() -> None:
    """Interrupts raise KeyboardInterrupt from now on."""
    if signal.getsignal(signal.SIGINT) is _leave:
        signal.signal(signal.SIGINT, signal.default_int_handler)


# An interrupt that the shell has told the process to ignore stays ignored.
if _is_command() and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    with suppress(ValueError):  # no thread but the main one may set it
        signal.signal(signal.SIGINT, _leave)
