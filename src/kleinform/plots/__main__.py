"""``python -m kleinform.plots FOLDER``: write the figures into a folder."""

from __future__ import annotations

import sys
from pathlib import Path

from kleinform.errors import KleinformError


def main(arguments: list[str]) -> int:
    """Run the command."""
    if len(arguments) != 1:
        print("usage: python -m kleinform.plots FOLDER", file=sys.stderr)
        return 2
    try:
        from kleinform.plots.paper import write_figures

        paths = write_figures(Path(arguments[0]))
    except (KleinformError, OSError) as error:
        print(f"kleinform.plots: {error}", file=sys.stderr)
        return 2
    for path in paths:
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
