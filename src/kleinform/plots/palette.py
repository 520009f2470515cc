"""Colours, told apart by colour-blind readers too (Okabe and Ito), and the style of figures."""

from __future__ import annotations

from typing import Any

__all__ = ["AXES", "BASE", "CENTRAL", "LIMBS", "PLATFORM", "STYLE"]

#: Outer limbs 1, 2, 3.
LIMBS = ("#D55E00", "#0072B2", "#009E73")
CENTRAL = "#000000"
BASE = "#777777"
PLATFORM = "#F0E442"
#: X, Y, Z, or yaw, pitch, roll: colour, line style, marker.
AXES = (("#000000", "-", "o"), ("#E69F00", "--", "s"), ("#56B4E9", "-.", "^"))

#: Text is drawn as paths: the same everywhere. The salt makes the same bytes in every run.
STYLE: dict[str, Any] = {
    "svg.hashsalt": "kleinform",
    "svg.fonttype": "path",
    "font.size": 10.0,
    "axes.titlesize": 10.0,
    "axes.grid": True,
    "grid.color": "#DDDDDD",
    "lines.linewidth": 1.6,
}
