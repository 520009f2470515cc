"""The robot in three dimensions, with its joint screws and its reciprocal lines.

Each function draws into axes that the caller made, ``figure.add_subplot(projection="3d")``,
one unit of which is a metre. Names stand where they are legible from the side that
`kleinform.plots.settle` turns the axes to.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.manipulator import UncoupledManipulator
from kleinform.plots.palette import BASE, CENTRAL, LIMBS, PLATFORM
from kleinform.plots.scene import STAR, Scene, scene
from kleinform.plots.strokes import TURN, Axes3D, Pen, widest_gap
from kleinform.screening import RotationLike

__all__ = ["draw_base", "draw_directions", "draw_reciprocal_lines", "draw_robot", "draw_screws"]

Array = NDArray[np.float64]
#: Lengths over the radius a: from C to the platform's vertices, of arrows, beside an axis.
PLATE, ARROW, ASIDE = 0.45, 0.32, 0.1
ORIGIN = np.zeros(3)


def draw_robot(
    axes: Axes3D, robot: UncoupledManipulator, position: ArrayLike, rotation: RotationLike
) -> None:
    """Draw the robot at a pose, with the names of its points.

    The circle of the base, the platform as a triangle with its vertices along n_1, n_2, n_3,
    its normal, the lines C B_i on which the cylindrical joints slide (B_i is opposite to its
    vertex where e_i < 0), the legs A_i B_i and the central limb O C.

    Parameters
    ----------
    axes : mpl_toolkits.mplot3d.axes3d.Axes3D
        `settle` turns them to the right side afterwards.
    robot : UncoupledManipulator
        Of one radius.
    position : array_like (3,)
        C in the base frame [m].
    rotation : array_like (3, 3), or anything with ``as_matrix()``

    Raises
    ------
    SingularPoseError
        ``n_i·u_i = 0`` (B_i is at infinity), or C at O.
    InputError
    """
    here = scene(robot, position, rotation)
    pen = Pen(axes, here.radius)
    draw_base(pen, here.base)
    _platform(pen, here)
    pen.line(ORIGIN, here.centre, color=CENTRAL, linewidth=2.5)
    pen.point(ORIGIN, "$O$", [*np.eye(3), *STAR, here.centre], CENTRAL)
    leaving = [*here.directions, here.rotation[:, 2], -here.centre]
    pen.point(here.centre, "$C$", leaving, CENTRAL)
    for i in range(3):
        _limb(pen, here, i)


def draw_directions(
    axes: Axes3D, robot: UncoupledManipulator, position: ArrayLike, rotation: RotationLike
) -> None:
    """Draw u_i, n_i and λ, and write q_i beside the legs and the central limb.

    Parameters and errors are those of `draw_robot`.
    """
    here = scene(robot, position, rotation)
    pen = Pen(axes, here.radius)
    length = ARROW * here.radius
    limbs = zip(here.base, here.platform, here.directions, STAR, strict=True)
    for i, (a, b, n, u) in enumerate(limbs):
        pen.arrow(a, length * u, rf"$\mathbf{{u}}_{i + 1}$", LIMBS[i])
        pen.arrow(b, length * n, rf"$\mathbf{{n}}_{i + 1}$", LIMBS[i])
        pen.text(0.5 * (a + b), widest_gap([b - a, a - b, -u]), f"$q_{i + 1}$", LIMBS[i])
    c, n = here.centre, here.directions[0]
    along = c / np.linalg.norm(c)
    beside = 0.25 * c + ASIDE * here.radius * n
    pen.arrow(beside, length * along, r"$\mathbf{\lambda}$", CENTRAL)
    pen.text(0.7 * c, widest_gap([c, -c, n]), "$q_6$", CENTRAL)


def draw_screws(
    axes: Axes3D,
    robot: UncoupledManipulator,
    position: ArrayLike,
    rotation: RotationLike,
    limb: int,
) -> None:
    """Draw the joint screws of a limb, named as in the paper.

    A revolute joint is an arrow on its axis; a prismatic joint, whose screw is a free vector,
    a dashed arrow beside it.

    Parameters
    ----------
    axes, robot, position, rotation
        As in `draw_robot`.
    limb : int
        1, 2, 3, or 4 for the central limb.

    Raises
    ------
    SingularPoseError, InputError
        As `UncoupledManipulator.screws`.
    """
    here, screws = scene(robot, position, rotation), robot.screws(position, rotation)
    pen = Pen(axes, here.radius)
    for joint, place in enumerate(_joint_places(here, limb), start=1):
        screw = screws.screw(limb, joint)
        prismatic = not screw[:3].any()
        vector = ARROW * here.radius * (screw[3:] if prismatic else screw[:3])
        name = rf"${{}}^{{{joint - 1}}}\$_{{{limb}}}^{{{joint}}}$"
        colour = (*LIMBS, CENTRAL)[limb - 1]
        # Beside the Z axis there is room on the left alone.
        turn = -1.7 * TURN if (limb, joint) == (4, 1) else TURN
        pen.arrow(place, vector, name, colour, "--" if prismatic else "-", turn)


def draw_reciprocal_lines(
    axes: Axes3D, robot: UncoupledManipulator, position: ArrayLike, rotation: RotationLike
) -> None:
    """Draw the lines S_i from B_i to D_i (14), with an arrow from D_i on.

    Parameters are those of `draw_robot`.

    Raises
    ------
    SingularPoseError, InputError
        As `UncoupledManipulator.jacobians`.
    """
    here = scene(robot, position, rotation)
    pen = Pen(axes, here.radius)
    lines = robot.jacobians(position, rotation).J_v[:3, :3].T
    limbs = zip(here.base, here.platform, here.ends, LIMBS, strict=True)
    for i, (a, b, d, colour) in enumerate(limbs):
        pen.line(a, d, color=BASE, linewidth=1.0)
        pen.line(b, d, color=colour, linewidth=1.0, linestyle="--")
        pen.arrow(d, ARROW * here.radius * lines[i], rf"$\mathbf{{S}}_{i + 1}$", colour)
        pen.point(d, f"$D_{i + 1}$", [b - d, d - b, a - d], colour)


def _joint_places(here: Scene, limb: int) -> list[Array]:
    """Where the arrows of a limb's six joint screws begin, those of revolutes on their axes."""
    c, aside = here.centre, ASIDE * here.radius
    if limb == 4:
        return [ORIGIN, ORIGIN, 0.35 * c + aside * here.directions[0], 1.25 * c, c, c]
    a, b, n = here.base[limb - 1], here.platform[limb - 1], here.directions[limb - 1]
    beside = 0.8 * a + 0.2 * b - aside * STAR[limb - 1]
    return [a, beside, b, b, b, b + 1.3 * ARROW * here.radius * n]


def draw_base(pen: Pen, base: Array) -> None:
    """The circle of A_i (3, 3), its radii O A_i, and the frame XYZ; the pen's unit is a."""
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    circle = pen.unit * np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)])
    pen.axes.plot(*circle, color=BASE, linewidth=1.0)
    for a in base:
        pen.line(ORIGIN, a, color=BASE, linewidth=1.0)
    for vector, name in zip(np.eye(3), "XYZ", strict=True):
        pen.arrow(ORIGIN, 0.45 * pen.unit * vector, f"${name}$", BASE)


def _platform(pen: Pen, here: Scene) -> None:
    """The platform's triangle and its normal."""
    corners = here.centre + PLATE * here.radius * here.directions
    pen.axes.plot_trisurf(*corners.T, triangles=[[0, 1, 2]], color=PLATFORM, alpha=0.6, shade=False)
    pen.axes.plot(*corners[[0, 1, 2, 0]].T, color=BASE, linewidth=1.0)
    pen.arrow(here.centre, ARROW * here.radius * here.rotation[:, 2], "", BASE)


def _limb(pen: Pen, here: Scene, i: int) -> None:
    """An outer limb: the leg, the wider cylinder of its actuator, the line that B_i slides on."""
    a, b, d = here.base[i], here.platform[i], here.ends[i]
    c, n = here.centre, here.directions[i]
    pen.line(a, b, color=LIMBS[i], linewidth=1.8)
    pen.line(a, 0.5 * (a + b), color=LIMBS[i], linewidth=4.0)
    pen.line(c, b, color=LIMBS[i], linewidth=1.2)
    beyond = d + ARROW * (d - b)
    pen.point(a, f"$A_{i + 1}$", [-a, a, b - a, a - b, beyond - a], LIMBS[i])
    leaving = [c - b, n, a - b, b - a, np.cross(n, b - a)]
    pen.point(b, f"$B_{i + 1}$", leaving, LIMBS[i])
