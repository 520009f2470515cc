"""Maps: numbers of assembly modes over sections, and two modes that can be joined."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import BoundaryNorm, ListedColormap
from numpy.typing import NDArray

from kleinform import UncoupledManipulator, rotation_from_rpy
from kleinform.maps.joining import join_modes
from kleinform.maps.modes import ModeMap, conditioning, joint_map, workspace_map
from kleinform.paper import printed
from kleinform.plots.draw import draw_robot
from kleinform.plots.drawing import Axes, Figure
from kleinform.plots.palette import LIMBS
from kleinform.plots.robots import share_limits
from kleinform.plots.strokes import settle

__all__ = ["draw_conditioning", "draw_modes", "joined", "mode_maps"]

Array = NDArray[np.float64]
ROBOT = UncoupledManipulator(radius=printed.RADIUS)
POSITION = np.array(printed.POSITION)
ROLL, PITCH, YAW = np.radians(printed.ROLL_PITCH_YAW_DEGREES)
ROTATION = rotation_from_rpy(roll=ROLL, pitch=PITCH, yaw=YAW)
#: A pose with twelve assembly modes, and two of them that a turn joins.
JOINED = ((0.1, -0.2, 1.2), (20.0, -35.0, 40.0))
PAIR = (1, 5)
#: From few modes to many, light to dark.
SHADES = ("#FFFFFF", "#E8F1FA", "#C9DFF2", "#9FC6E6", "#6BA6D6", "#3B82BF", "#1B5E9C", "#0B3C70")


def draw_modes(axes: Axes, counted: ModeMap) -> None:
    """Numbers of modes as shades with a scale, and the singularity curves between them.

    Parameters
    ----------
    axes : Axes
        Of Matplotlib.
    counted : ModeMap
    """
    numbers = np.unique(counted.counts)
    colours = ListedColormap([SHADES[i % len(SHADES)] for i in range(len(numbers))])
    edges = np.concatenate([numbers - 0.5, numbers[-1:] + 0.5])
    filled = axes.pcolormesh(
        counted.first,
        counted.second,
        counted.counts.T,
        cmap=colours,
        norm=BoundaryNorm(edges, len(numbers)),
        rasterized=True,
    )
    axes.add_collection(LineCollection(list(counted.segments), colors=LIMBS[0], linewidths=1.2))
    axes.grid(False)
    scale = axes.figure.colorbar(filled, ax=axes, ticks=numbers)
    scale.set_label("assembly modes, one of each pair")


def mode_maps(resolution: int) -> Figure:
    """Around the paper's pose: a section of joint space, and two of the workspace."""
    figure = Figure(figsize=(15.5, 4.4), layout="constrained")
    left, right, last = figure.subplots(1, 3)
    joints = ROBOT.inverse_displacement(POSITION, ROTATION)
    draw_modes(left, joint_map(ROBOT, joints, ("q1", "q2"), ((0.5, 1.8), (0.5, 1.8)), resolution))
    left.set(xlabel="$q_1$ [m]", ylabel="$q_2$ [m]", title="joint values, the others as printed")
    left.plot(*joints[:2], "k+", markersize=9)
    span = (-0.6, 0.6)
    draw_modes(right, workspace_map(ROBOT, ROTATION, 1.0, (span, span), resolution))
    right.set(xlabel="$X$ of $C$ [m]", ylabel="$Y$ of $C$ [m]", title="poses, $Z$ = 1 m")
    right.plot(*POSITION[:2], "k+", markersize=9)
    draw_conditioning(last, np.linspace(*span, resolution))
    last.set(xlabel="$X$ of $C$ [m]", ylabel="$Y$ of $C$ [m]", title="poses, $Z$ = 1 m")
    last.plot(*POSITION[:2], "k+", markersize=9)
    return figure


def draw_conditioning(axes: Axes, ends: Array) -> None:
    """The least singular value of the moments of S_i over positions with Z = 1 m.

    Parameters
    ----------
    axes : Axes
        Of Matplotlib.
    ends : array (n,)
        X and Y of the positions [m].
    """
    place = np.stack([*np.meshgrid(ends, ends), np.ones((len(ends), len(ends)))], axis=-1)
    least = conditioning(ROBOT, place, ROTATION)[..., 2]
    filled = axes.pcolormesh(ends, ends, least, cmap="cividis", vmin=0.0, rasterized=True)
    axes.grid(False)
    scale = axes.figure.colorbar(filled, ax=axes)
    scale.set_label("least singular value of the moments [m]")


def joined(samples: int = 121) -> Figure:
    """Two modes of the same joint values, and the legs on the way from one to the other."""
    position, angles = JOINED
    roll, pitch, yaw = np.radians(angles)
    rotation = rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    modes = ROBOT.forward_displacement(ROBOT.inverse_displacement(position, rotation))
    way = join_modes(ROBOT, modes, *PAIR)
    states = ROBOT.inverse_motion(way.motion(1.0).sampled(samples))
    figure = Figure(figsize=(12.0, 4.2))
    panels = [figure.add_axes((x, 0.0, 0.31, 0.9), projection="3d") for x in (0.0, 0.31)]
    for panel, number in zip(panels, PAIR, strict=True):
        draw_robot(panel, ROBOT, modes.position, modes.rotation[number])
        panel.set_title(f"mode {number}")
    share_limits(panels)
    for panel in panels:
        settle(panel, zoom=1.4)
    axes = figure.add_axes((0.69, 0.15, 0.29, 0.72))
    for limb, colour in enumerate(LIMBS):
        axes.plot(states.times, states.joints[:, limb], color=colour, label=f"$q_{limb + 1}$")
    axes.set(xlabel="share of the turn", ylabel="length of the outer legs [m]")
    least = np.floor(100.0 * min(way.least.values())) / 100.0
    axes.set_title(f"no direct factor below {least} m³ or m")
    axes.legend(frameon=False)
    return figure
