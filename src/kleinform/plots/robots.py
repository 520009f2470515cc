"""Figures of the robot at the paper's pose: Fig. 2, Fig. 4 and the solutions of Table 1."""

from __future__ import annotations

import numpy as np

from kleinform import UncoupledManipulator, rotation_from_rpy
from kleinform.paper import printed
from kleinform.plots.draw import (
    draw_directions,
    draw_reciprocal_lines,
    draw_robot,
    draw_screws,
)
from kleinform.plots.drawing import Figure
from kleinform.plots.strokes import Axes3D, settle

__all__ = ["diagram", "modes", "screws", "share_limits"]

ROBOT = UncoupledManipulator(radius=printed.RADIUS)
POSITION = np.array(printed.POSITION)
ROLL, PITCH, YAW = np.radians(printed.ROLL_PITCH_YAW_DEGREES)
ROTATION = rotation_from_rpy(roll=ROLL, pitch=PITCH, yaw=YAW)
#: The outer limb whose screws are seen best.
LIMB = 3


def diagram() -> Figure:
    """Fig. 2: the kinematic diagram, with points, directions and generalized coordinates."""
    figure = Figure(figsize=(5.6, 4.6))
    axes = _panel(figure, 1, 0)
    draw_robot(axes, ROBOT, POSITION, ROTATION)
    draw_directions(axes, ROBOT, POSITION, ROTATION)
    settle(axes, zoom=1.5)
    return figure


def screws() -> Figure:
    """Fig. 4: joint screws of an outer limb and of the central one; the reciprocal lines."""
    figure = Figure(figsize=(10.5, 5.0))
    left, right = (_panel(figure, 2, column) for column in range(2))
    for axes in (left, right):
        draw_robot(axes, ROBOT, POSITION, ROTATION)
    for limb in (LIMB, 4):
        draw_screws(left, ROBOT, POSITION, ROTATION, limb)
    draw_reciprocal_lines(right, ROBOT, POSITION, ROTATION)
    left.set_title(f"joint screws of limb {LIMB} and of the central limb 4")
    right.set_title("reciprocal lines $\\mathbf{S}_i$ from $B_i$ to $D_i$")
    share_limits([left, right])
    for axes in (left, right):
        settle(axes, zoom=1.55)
    return figure


def modes() -> Figure:
    """The solutions of Table 1 side by side, with the signs of e_i."""
    found = ROBOT.forward_displacement(ROBOT.inverse_displacement(POSITION, ROTATION))
    figure = Figure(figsize=(13.0, 4.4))
    panels = [_panel(figure, len(found), column) for column in range(len(found))]
    for k, axes in enumerate(panels):
        draw_robot(axes, ROBOT, found.position, found.rotation[k])
        signs = ", ".join("+" if distance > 0.0 else "−" for distance in found.extension[k])
        verdict = "feasible" if found.feasible[k] else "not feasible"
        axes.set_title(f"row {k + 1}: signs of $e_i$ {signs}\n{verdict}")
    share_limits(panels)
    for axes in panels:
        settle(axes, zoom=1.35)
    return figure


def share_limits(panels: list[Axes3D]) -> None:
    """One scale for all panels."""
    limits = np.array([[axes.get_xlim(), axes.get_ylim(), axes.get_zlim()] for axes in panels])
    x, y, z = np.stack([limits[..., 0].min(axis=0), limits[..., 1].max(axis=0)], axis=1)
    for axes in panels:
        axes.set(xlim=x, ylim=y, zlim=z)


def _panel(figure: Figure, columns: int, column: int) -> Axes3D:
    """3D axes that fill a column of the figure, but for a title."""
    place = (column / columns, 0.0, 1.0 / columns, 0.9)
    return figure.add_axes(place, projection="3d")
