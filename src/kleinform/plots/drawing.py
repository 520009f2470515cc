"""Matplotlib, or the error that says how to install it; figures drawn and written as SVG."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from pathlib import Path

from kleinform.errors import MissingExtraError
from kleinform.files import write_bytes
from kleinform.plots.palette import STYLE

try:
    from matplotlib import style
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
except ImportError as error:
    raise MissingExtraError("matplotlib: pip install 'kleinform[plots]'") from error

__all__ = ["Axes", "Figure", "write"]


def write(draw: Callable[[], Figure], path: Path) -> None:
    """Draw a figure, and write it whole or not at all; the same bytes in every run."""
    drawn = BytesIO()
    with style.context(STYLE, after_reset=True):
        draw().savefig(drawn, format="svg", metadata={"Date": None})
    write_bytes(path, drawn.getvalue())
