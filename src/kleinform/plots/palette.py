"""Colours, told apart by colour-blind readers too (Okabe and Ito), and the style of figures."""

from __future__ import annotations

from typing import Any

__all__ = ["AXES", "BASE", "CENTRAL", "LIMBS", "LIMITS", "LOCUS", "PLATFORM", "SIGNS", "STYLE"]

#: Outer limbs 1, 2, 3.
LIMBS = ("#D55E00", "#0072B2", "#009E73")
CENTRAL = "#000000"
BASE = "#777777"
PLATFORM = "#F0E442"
#: Direct singularities; where the orientation factor is negative, and where it is positive.
LOCUS = "#A0257E"
SIGNS = ("#F7CFAE", "#B5D7F0")
#: What is limited: legs as their limbs, extensions lighter; q4, q5, q6.
LIMITS = {
    "q1": LIMBS[0],
    "q2": LIMBS[1],
    "q3": LIMBS[2],
    "e1": "#F2B98F",
    "e2": "#94C5E6",
    "e3": "#8FD3BC",
    "q4": CENTRAL,
    "q5": PLATFORM,
    "q6": "#8A8A8A",
}
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
