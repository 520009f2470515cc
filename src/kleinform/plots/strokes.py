"""Lines, arrows and names in 3D axes that are seen from one side, in parallel projection."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["TURN", "Axes3D", "Pen", "settle", "widest_gap"]

Array = NDArray[np.float64]
#: mplot3d has no types.
Axes3D = Any
ELEVATION, AZIMUTH = np.radians(24.0), np.radians(-75.0)
#: What is right and what is up on the screen, in the base frame, a row each.
SCREEN = np.array(
    [
        [-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0],
        [
            -np.sin(ELEVATION) * np.cos(AZIMUTH),
            -np.sin(ELEVATION) * np.sin(AZIMUTH),
            np.cos(ELEVATION),
        ],
    ]
)
#: Over the unit of a pen: the head of an arrow, and from a point to its name.
HEAD, APART = 0.07, 0.12
#: Half the angle of a head, and where the name stands from the arrow's direction [rad].
SPREAD, TURN = np.radians(20.0), np.radians(-50.0)


class Pen(NamedTuple):
    """Axes to draw in, and the length [m] that heads and distances of names scale with."""

    axes: Axes3D
    unit: float

    def line(self, start: Array, end: Array, **style: Any) -> None:
        """A straight line between two points."""
        self.axes.plot(*np.stack([start, end], axis=1), **style)

    def text(self, place: Array, angle: float, words: str, colour: str) -> None:
        """Words beside a point, at an angle on the screen from the right."""
        spot = place + APART * self.unit * _towards(angle)
        self.axes.text(*spot, words, color=colour, ha="center", va="center", zorder=20)

    def point(self, place: Array, name: str, leaving: list[Array], colour: str) -> None:
        """A dot, and its name in the widest gap between the directions that leave it."""
        self.axes.plot(*place[:, np.newaxis], "o", color=colour, markersize=4.0)
        self.text(place, widest_gap(leaving), name, colour)

    def arrow(
        self,
        start: Array,
        vector: Array,
        name: str,
        colour: str,
        linestyle: str = "-",
        turn: float = TURN,
    ) -> None:
        """An arrow with its name beside the tip, turned from the arrow's direction."""
        tip, angle = start + vector, _angle(vector)
        self.line(start, tip, color=colour, linewidth=1.4, linestyle=linestyle)
        sides = [HEAD * self.unit * _towards(angle + side) for side in (SPREAD, -SPREAD)]
        head = np.stack([tip - sides[0], tip, tip - sides[1]], axis=1)
        self.axes.plot(*head, color=colour, linewidth=1.4)
        self.text(tip, angle + turn, name, colour)


def widest_gap(directions: list[Array]) -> float:
    """The angle on the screen in the middle of the widest gap between directions."""
    angles = np.sort([_angle(direction) for direction in directions])
    gaps = np.diff(angles, append=angles[0] + 2.0 * np.pi)
    widest = int(np.argmax(gaps))
    return float(angles[widest] + 0.5 * gaps[widest])


def settle(axes: Axes3D, zoom: float) -> None:
    """Equal units on all three axes, the parallel view that the names are placed for, no frame.

    Parameters
    ----------
    axes : mpl_toolkits.mplot3d.axes3d.Axes3D
        With everything drawn.
    zoom : float
    """
    axes.set_proj_type("ortho")
    axes.view_init(elev=float(np.degrees(ELEVATION)), azim=float(np.degrees(AZIMUTH)))
    axes.set_axis_off()
    limits = np.array([axes.get_xlim(), axes.get_ylim(), axes.get_zlim()])
    axes.set_box_aspect(np.ptp(limits, axis=1), zoom=zoom)


def _angle(direction: Array) -> float:
    """The angle of a direction on the screen, from the right [rad]."""
    right, up = SCREEN @ direction
    return float(np.arctan2(up, right))


def _towards(angle: float) -> Array:
    """The unit vector (3,) in the screen at an angle."""
    vector: Array = np.array([np.cos(angle), np.sin(angle)]) @ SCREEN
    return vector
