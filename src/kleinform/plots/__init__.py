"""The paper's figures, and the robot in 3D axes of Matplotlib."""

from kleinform.lazy import submodules
from kleinform.plots.draw import (
    draw_directions,
    draw_reciprocal_lines,
    draw_robot,
    draw_screws,
)
from kleinform.plots.strokes import settle

__all__ = ["draw_directions", "draw_reciprocal_lines", "draw_robot", "draw_screws", "settle"]

__getattr__ = submodules(__name__, ("maps",))
