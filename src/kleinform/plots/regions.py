"""The workspace of one orientation, by the limits that bound it, and its direct singularities."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.colors import ListedColormap, to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

from kleinform import rotation_from_rpy
from kleinform.limits import LIMITED, Limits
from kleinform.maps.loci import DirectLocus, direct_locus
from kleinform.maps.section import Section
from kleinform.maps.workspace import Workspace, constant_orientation_workspace
from kleinform.plots.draw import draw_base
from kleinform.plots.drawing import Axes, Figure
from kleinform.plots.palette import CENTRAL, LIMITS, LOCUS, SIGNS
from kleinform.plots.robots import ROBOT, ROTATION
from kleinform.plots.scene import STAR
from kleinform.plots.strokes import Axes3D, Pen, settle

__all__ = ["draw_locus", "draw_section", "draw_signs", "fig_3", "limits_met", "loci"]

Array = NDArray[np.float64]
RADIUS = float(ROBOT.radius)
RANGES = Limits.typical(RADIUS)
#: Heights of the sections in Fig. 3 [m].
HEIGHTS = (0.55, 0.65, 0.75, 0.9, 1.1, 1.25)
#: Half the width of a section's panel, and the box that the locus is drawn in [m].
SPAN = 1.1 * RADIUS
BOX = RADIUS * np.array([[-1.1, -1.1, 0.3], [1.1, 1.1, 1.45]])
#: The orientations of the figure of loci; of each the height of a section [m], and the azimuth
#: that it is seen from [deg].
PITCHED = rotation_from_rpy(roll=0.0, pitch=np.radians(25.0), yaw=0.0)
CASES = (
    ("roll 10°, pitch 3°, yaw 6°", ROTATION, 0.65, -125.0),
    ("pitch 25°", PITCHED, 1.0, -60.0),
)
#: Points of an arc, and of an image of 3D surfaces per inch.
POINTS, DOTS = 33, 240
TINY = 1e-300
#: Where the light comes from: above, the left and the front.
LIGHT = np.array([-0.48, -0.6, 0.64])


def fig_3(resolution: int) -> Figure:
    """Fig. 3: the workspace in the paper's orientation, and horizontal sections of it."""
    workspace = constant_orientation_workspace(ROBOT, ROTATION, RANGES)
    locus = direct_locus(ROBOT, ROTATION)
    figure = Figure(figsize=(12.0, 6.6), dpi=DOTS)
    corners, colours = _outside(workspace, resolution)
    for below in (False, True):
        bottom = 0.03 if below else 0.45
        solid: Axes3D = figure.add_axes((0.0, bottom, 0.4, 0.6), projection="3d")
        _base(solid)
        # What is drawn last hides the rest: from below, the base.
        _add_triangles(solid, corners, colours, zorder=1 if below else 30)
        settle(solid, zoom=1.2)
        if below:
            solid.view_init(elev=-solid.elev, azim=solid.azim)
        figure.text(0.02, bottom + 0.48, "from below" if below else "from above")
    places = figure.add_gridspec(2, 3, left=0.45, right=0.99, top=0.95, bottom=0.17)
    for k, z in enumerate(HEIGHTS):
        axes = figure.add_subplot(places[k // 3, k % 3])
        section = workspace.section(z)
        draw_section(axes, section)
        draw_locus(axes, locus, z, resolution)
        _frame(axes, f"$Z$ = {z} m, area {section.area:.2f} m²")
        axes.label_outer()
    _legend(figure)
    return figure


def loci(resolution: int) -> Figure:
    """The workspace and its direct singularities, in space and in a section, twice."""
    figure = Figure(figsize=(9.5, 9.6), dpi=DOTS)
    for row, (name, rotation, z, azimuth) in enumerate(CASES):
        workspace = constant_orientation_workspace(ROBOT, rotation, RANGES)
        locus = direct_locus(ROBOT, rotation)
        bottom = 0.56 - 0.46 * row
        solid: Axes3D = figure.add_axes((0.0, bottom - 0.04, 0.52, 0.42), projection="3d")
        _base(solid)
        _add_triangles(solid, *_both(workspace, locus, resolution), zorder=30)
        settle(solid, zoom=1.5)
        solid.view_init(elev=solid.elev, azim=azimuth)
        solid.set_title(name)
        axes = figure.add_axes((0.58, bottom, 0.38, 0.37))
        draw_signs(axes, locus, z)
        draw_section(axes, workspace.section(z), dict.fromkeys(LIMITS, CENTRAL))
        draw_locus(axes, locus, z, resolution)
        _frame(axes, f"$Z$ = {z} m")
    words = ("orientation factor < 0", "orientation factor > 0")
    patches = [Patch(color=c, label=w) for c, w in zip(SIGNS, words, strict=True)]
    figure.legend(handles=[*patches, _dashed()], loc="lower center", ncols=3, frameon=False)
    return figure


def draw_section(axes: Axes, section: Section, colours: Mapping[str, str] = LIMITS) -> None:
    """The exact arcs in the colours of their limits, what they enclose lightly filled.

    Parameters
    ----------
    axes : Axes
        Of Matplotlib.
    section : Section
    colours : mapping of str to str
        By the name of a limit.
    """
    if section.loops:
        outlines = [Path(loop.points(POINTS), closed=True) for loop in section.loops]
        path = Path.make_compound_path(*outlines)
        axes.add_patch(PathPatch(path, color=CENTRAL, alpha=0.08, linewidth=0.0))
    for loop in section.loops:
        for arc in loop.arcs:
            axes.plot(*arc.points(POINTS).T, color=colours[arc.name], linewidth=2.2)


def draw_locus(axes: Axes, locus: DirectLocus, z: float, resolution: int) -> None:
    """The direct singularities at a height.

    Parameters
    ----------
    axes : Axes
        Of Matplotlib.
    locus : DirectLocus
    z : float
        [m]
    resolution : int
        As `DirectLocus.section`.
    """
    for curve in locus.section(z, [[-SPAN] * 2, [SPAN] * 2], resolution):
        axes.plot(*curve[:, :2].T, color=LOCUS, linestyle="--")


def draw_signs(axes: Axes, locus: DirectLocus, z: float, count: int = 241) -> None:
    """The sign of the orientation factor at a height, as two shades on a grid.

    Parameters
    ----------
    axes, locus, z
        As in `draw_locus`.
    count : int
        Points along both axes.
    """
    line = np.linspace(-SPAN, SPAN, count)
    x, y = np.meshgrid(line, line)
    signs = locus.value(np.stack([x, y, np.full_like(x, z)], axis=-1)) > 0.0
    shades = ListedColormap(list(SIGNS))
    axes.pcolormesh(x, y, signs, cmap=shades, vmin=0.0, vmax=1.0, rasterized=True)


def limits_met(workspace: Workspace, positions: Array) -> tuple[list[str], Array]:
    """The limit that is met nearest to each position, and the normal outwards of its quadric.

    Parameters
    ----------
    workspace : Workspace
    positions : array (N, 3)
        At the boundary.

    Returns
    -------
    list of str, array (N, 3)
    """
    forms = [(limit.name, form.matrix) for limit in workspace.constraints for form in limit.forms]
    full = np.insert(positions, 3, 1.0, axis=1)
    halves = np.stack([full @ matrix for _, matrix in forms])
    slopes = np.maximum(2.0 * np.linalg.norm(halves[..., :3], axis=2), TINY)
    nearest = np.argmin(abs((halves * full).sum(axis=2)) / slopes, axis=0)
    each = np.arange(len(positions))
    normals = -2.0 * halves[nearest, each, :3] / slopes[nearest, each, np.newaxis]
    return [forms[k][0] for k in nearest], normals


def _base(axes: Axes3D) -> None:
    """The circle of the base with A_i, behind what is drawn later."""
    axes.computed_zorder = False
    axes.patch.set_visible(False)
    pen = Pen(axes, RADIUS)
    draw_base(pen, RADIUS * STAR)
    for i, a in enumerate(RADIUS * STAR):
        pen.point(a, f"$A_{i + 1}$", [-a], LIMITS[f"q{i + 1}"])


def _outside(workspace: Workspace, resolution: int) -> tuple[Array, Array]:
    """Triangles (N, 3, 3) of the boundary, and their colours (N, 3) by the limit that is met."""
    mesh = workspace.mesh(resolution)
    corners = mesh.vertices[mesh.triangles]
    names, normals = limits_met(workspace, corners.mean(axis=1))
    return corners, _shaded(np.array([to_rgb(LIMITS[name]) for name in names]), normals)


def _both(workspace: Workspace, locus: DirectLocus, resolution: int) -> tuple[Array, Array]:
    """Triangles (N, 3, 3) of the workspace, by the sign of the factor, and of the locus."""
    mesh = workspace.mesh(resolution)
    outer = mesh.vertices[mesh.triangles]
    centres = outer.mean(axis=1)
    signs = np.array([to_rgb(colour) for colour in SIGNS])
    _, normals = limits_met(workspace, centres)
    solid = _shaded(signs[(locus.value(centres) > 0.0).astype(int)], normals)
    sheet = locus.mesh(BOX, resolution)
    inner = sheet.vertices[sheet.triangles]
    colours = [solid, np.tile(to_rgb(LOCUS), (len(inner), 1))]
    return np.concatenate([outer, inner]), np.concatenate(colours)


def _shaded(colours: Array, normals: Array) -> Array:
    """Colours (N, 3), darker where the normals turn away from the light."""
    shaded: Array = colours * (0.85 + 0.15 * normals @ LIGHT)[:, np.newaxis]
    return shaded


def _add_triangles(axes: Axes3D, corners: Array, colours: Array, zorder: int) -> None:
    """Triangles (N, 3, 3) with their colours as an image, sorted by depth."""
    faces = Poly3DCollection(
        corners, facecolors=colours, linewidths=0.0, antialiased=False, zorder=zorder
    )
    faces.set_rasterized(True)
    axes.add_collection3d(faces)


def _frame(axes: Axes, title: str) -> None:
    axes.set(xlim=(-SPAN, SPAN), ylim=(-SPAN, SPAN), aspect="equal", title=title)
    axes.set(xlabel="$X$ of $C$ [m]", ylabel="$Y$ of $C$ [m]")


def _legend(figure: Figure) -> None:
    """Which colour is which limit."""
    named = [(name, f"${name[0]}_{name[1]}$") for name in LIMITED if name in RANGES.ranges]
    lines = [
        Line2D([], [], color=LIMITS[name], linewidth=5.0, label=words) for name, words in named
    ]
    lines.append(_dashed())
    title = "limit that is met"
    figure.legend(handles=lines, loc="lower center", ncols=len(lines), frameon=False, title=title)


def _dashed() -> Line2D:
    return Line2D([], [], color=LOCUS, linestyle="--", label="direct singularity")
