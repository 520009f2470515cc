"""The command line's entry point; `kleinform.commands` holds the commands.

``import kleinform`` needs neither Typer nor Rich, so they are imported here and not before.
"""

from __future__ import annotations

import signal
import sys
import warnings
from typing import NoReturn

from kleinform.errors import KleinformError
from kleinform.standard import prepare, settle
from kleinform.starting import loaded

__all__ = ["main"]

#: What the extra brings.
EXTRA = frozenset({"typer", "rich"})


def main() -> None:
    """Run the command that ``sys.argv`` names, and exit.

    Exits with code 2 and one line on standard error where the command cannot do what it is
    asked to, the extra ``kleinform[cli]`` missing among the reasons.
    """
    prepare()
    # Ended from outside, a command takes away what it has begun to write.
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        run()
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
    finally:
        settle()


def run() -> NoReturn:
    """Run the command, with every error on one line."""
    warnings.showwarning = told
    try:
        import typer

        from kleinform.commands import app
        from kleinform.commands.wording import in_options
    except ModuleNotFoundError as error:
        package = str(error.name).partition(".")[0]
        if package not in EXTRA:
            raise
        refuse(f"{package} is missing; install the extra: pip install 'kleinform[cli]'")
    loaded()
    try:
        code = app(sys.argv[1:] or ["--help"], prog_name="kleinform", standalone_mode=False)
    except typer.TyperException as error:
        refuse(error.format_message())
    except KleinformError as error:
        refuse(in_options(str(error)))
    except OSError as error:
        # Inputs and files say their names.
        refuse(f"{error.filename or 'standard output'}: {error.strerror or error}")
    sys.exit(code)


def told(message: Warning | str, *where: object, **more: object) -> None:
    """A warning, on one line of standard error."""
    print("kleinform:", " ".join(str(message).split()), file=sys.stderr)


def refuse(message: str) -> NoReturn:
    """One line on standard error, exit code 2."""
    print("kleinform:", " ".join(message.split()), file=sys.stderr)
    sys.exit(2)
