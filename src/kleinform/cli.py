"""The command line's entry point; `kleinform.commands` holds the commands.

``import kleinform`` needs neither Typer nor Rich, so they are imported here and not before.
"""

from __future__ import annotations

import sys

__all__ = ["main"]

#: What the extra brings, with what it stands on.
EXTRA = frozenset({"typer", "rich", "click"})


def main() -> None:
    """Run the command that ``sys.argv`` names.

    Exits with code 2 and one line if the extra ``kleinform[cli]`` is not installed.
    """
    try:
        from kleinform.commands import app
    except ModuleNotFoundError as error:
        if error.name not in EXTRA:
            raise
        print(
            f"kleinform: {error.name} is missing; install the extra: pip install 'kleinform[cli]'",
            file=sys.stderr,
        )
        sys.exit(2)
    app(prog_name="kleinform")


if __name__ == "__main__":
    main()
