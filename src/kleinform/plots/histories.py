"""Time histories of the platform: Fig. 5 to 8."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kleinform.motion import PlatformStates
from kleinform.plots.drawing import Axes, Figure
from kleinform.plots.palette import AXES
from kleinform.rotations import rpy_from_rotation

__all__ = ["poses", "rates"]

Array = NDArray[np.float64]
#: About so many markers stand on a curve.
MARKERS = 32
TIME = "$t$ [s]"
#: The rows of Fig. 6 and 8, with their units.
QUANTITIES = (
    (r"angular velocity $\mathbf{\omega}$", "rad/s"),
    (r"velocity $\mathbf{v}_C$", "m/s"),
    (r"angular acceleration $\dot{\mathbf{\omega}}$", "rad/s²"),
    (r"acceleration $\dot{\mathbf{v}}_C$", "m/s²"),
)


def poses(ours: PlatformStates, others: PlatformStates, engine: str, title: str) -> Figure:
    """Fig. 5 and 7: position of C on the left, orientation on the right.

    Curves are ours, markers the engine's.

    Parameters
    ----------
    ours, others : PlatformStates
        At the same times.
    engine : str
        Its name.
    title : str
    """
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    figure.suptitle(title)
    left, right = figure.subplots(1, 2)
    for axes, quantity, names in (
        (left, lambda states: states.positions, ("$X$", "$Y$", "$Z$")),
        (right, _degrees, (r"yaw $\alpha$", r"pitch $\beta$", r"roll $\gamma$")),
    ):
        _curves(axes, ours.times, quantity(ours), names)
        _markers(axes, ours.times, quantity(others), [f"{name}, {engine}" for name in names])
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    left.set(xlabel=TIME, ylabel="position of $C$ [m]")
    right.set(xlabel=TIME, ylabel="orientation [deg]")
    return figure


def _degrees(states: PlatformStates) -> Array:
    """Yaw, pitch and roll (T, 3) in degrees."""
    angles = rpy_from_rotation(states.rotations)
    return np.degrees(np.stack([angles.yaw, angles.pitch, angles.roll], axis=1))


def rates(ours: PlatformStates, others: PlatformStates, engine: str, title: str) -> Figure:
    """Fig. 6 and 8: velocities and accelerations, ours on the left, an engine's on the right.

    On the right the engine's values are markers on our curves, and each panel says what the
    largest difference of a component, over all samples, is less than.

    Parameters
    ----------
    ours, others : PlatformStates
        At the same times.
    engine : str
        Its name.
    title : str
    """
    figure = Figure(figsize=(9.0, 10.5), layout="constrained")
    figure.suptitle(title)
    panels = figure.subplots(4, 2, sharex=True, sharey="row")
    values = zip(_thirds(ours), _thirds(others), strict=True)
    for (left, right), (name, unit), (own, theirs) in zip(panels, QUANTITIES, values, strict=True):
        for axes in (left, right):
            _curves(axes, ours.times, own, ("$X$", "$Y$", "$Z$"))
        _markers(right, ours.times, theirs, [f"${name}$, {engine}" for name in "XYZ"])
        left.set(title="screw theory", ylabel=f"{name} [{unit}]")
        bound = _decade_above(float(abs(theirs - own).max()))
        right.set_title(f"{engine}: differs by less than ${bound}$ {unit}")
    for axes in panels[-1]:
        axes.set_xlabel(TIME)
    lines, names = panels[0, 1].get_legend_handles_labels()
    figure.legend(lines, names, loc="outside lower center", ncols=6, frameon=False)
    return figure


def _thirds(states: PlatformStates) -> list[Array]:
    """omega, v_C and their derivatives, each (T, 3)."""
    halves = (states.twists, states.twist_rates)
    return [half[:, part] for half in halves for part in (slice(0, 3), slice(3, 6))]


def _curves(axes: Axes, times: Array, values: Array, names: tuple[str, ...]) -> None:
    """Three components (T, 3) as lines."""
    for component, name, (colour, style, _) in zip(values.T, names, AXES, strict=True):
        axes.plot(times, component, color=colour, linestyle=style, label=name)


def _markers(axes: Axes, times: Array, values: Array, names: list[str]) -> None:
    """Three components (T, 3) as markers at some of the times."""
    every = max(1, len(times) // MARKERS)
    for component, name, (colour, _, marker) in zip(values.T, names, AXES, strict=True):
        axes.plot(
            times,
            component,
            color=colour,
            linestyle="none",
            marker=marker,
            markersize=4.5,
            markerfacecolor="none",
            markevery=every,
            label=name,
        )


def _decade_above(value: float) -> str:
    """A power of ten above a value, at least 1e-12: rounding differs between machines."""
    exponent = math.floor(math.log10(max(value, 0.5e-12))) + 1
    return f"10^{{{exponent}}}"
