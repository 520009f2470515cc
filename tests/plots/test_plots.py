"""Figures: what is drawn is what was computed, and the files are whole and the same each time."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

import kleinform
from kleinform.limits import Limits
from kleinform.maps.curves import Curve
from kleinform.maps.loci import direct_locus
from kleinform.maps.modes import conditioning, joint_map
from kleinform.maps.section import Arc, Loop, Section
from kleinform.maps.workspace import constant_orientation_workspace
from kleinform.motion import PlatformStates
from kleinform.paper import printed
from kleinform.paper.examples import example_1
from kleinform.plots import (
    draw_directions,
    draw_reciprocal_lines,
    draw_robot,
    draw_screws,
    histories,
    maps,
    paper,
    regions,
    robots,
    settle,
)
from kleinform.plots.drawing import write
from kleinform.plots.palette import LIMITS, LOCUS
from kleinform.plots.scene import scene
from kleinform.verification.report import ours

NAMES = [f"fig-{number}" for number in range(2, 9)]
NAMES += ["joined", "loci", "mode-maps", "modes"]
POSE = (robots.POSITION, robots.ROTATION)
SAMPLES = 41
JOINTS = robots.ROBOT.inverse_displacement(*POSE)


@pytest.fixture(scope="module")
def states() -> PlatformStates:
    return ours(example_1().sampled(SAMPLES))


@pytest.fixture
def axes():
    return Figure().add_subplot(projection="3d")


@pytest.fixture
def without_engine(monkeypatch):
    """Our own states stand for the engine's."""

    def followed(motion, samples):
        own = ours(motion.sampled(samples))
        return own, own

    monkeypatch.setattr(paper, "followed", followed)


def segments(axes) -> np.ndarray:
    """Both ends (n, 2, 3) of every straight line that was drawn."""
    drawn = [np.transpose(line.get_data_3d()) for line in axes.lines]
    return np.array([ends for ends in drawn if len(ends) == 2])


def has_segment(axes, start: np.ndarray, end: np.ndarray) -> bool:
    gaps = abs(segments(axes) - np.stack([start, end])).max(axis=(1, 2))
    return bool(gaps.min() < 1e-12)


def names(axes) -> set[str]:
    return {text.get_text() for text in axes.texts}


# Time histories --------------------------------------------------------------------------


def test_fig_5_shows_position_and_orientation_over_time(states) -> None:
    moved = states._replace(positions=states.positions + 1e-3)
    left, right = histories.poses(states, moved, "Engine", "Example 1").axes
    for line, component in zip(left.lines[:3], states.positions.T, strict=True):
        np.testing.assert_array_equal(line.get_xdata(), states.times)
        np.testing.assert_array_equal(line.get_ydata(), component)
    for line, component in zip(left.lines[3:], moved.positions.T, strict=True):
        assert line.get_linestyle() == "None"
        np.testing.assert_array_equal(line.get_ydata(), component)
    angles = np.stack([line.get_ydata() for line in right.lines[:3]], axis=1)
    np.testing.assert_allclose(angles[0], [5.827, 2.961, 9.963], atol=5e-4)
    yaw, pitch, roll = np.radians(angles).T
    rebuilt = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    np.testing.assert_allclose(rebuilt, states.rotations, atol=1e-14)
    legend = [text.get_text() for text in right.get_legend().get_texts()]
    assert [name.split()[0] for name in legend] == ["yaw", "pitch", "roll"] * 2


def test_fig_6_shows_our_curves_and_the_engines_markers(states) -> None:
    moved = states._replace(twists=states.twists + 2e-3, twist_rates=states.twist_rates - 3e-2)
    figure = histories.rates(states, moved, "Engine", "Example 1")
    panels = np.array(figure.axes).reshape(4, 2)
    own = np.hstack([states.twists, states.twist_rates])
    theirs = np.hstack([moved.twists, moved.twist_rates])
    for row, (left, right) in enumerate(panels):
        part = slice(3 * row, 3 * row + 3)
        for axes in (left, right):
            curves = np.stack([line.get_ydata() for line in axes.lines[:3]], axis=1)
            np.testing.assert_array_equal(curves, own[:, part])
        assert len(left.lines) == 3
        assert [line.get_marker() for line in right.lines[3:]] == ["o", "s", "^"]
        marked = np.stack([line.get_ydata() for line in right.lines[3:]], axis=1)
        np.testing.assert_array_equal(marked, theirs[:, part])
    titles = [axes.get_title() for axes in panels[:, 1]]
    bounds = ["10^{-2}$ rad/s", "10^{-2}$ m/s", "10^{-1}$ rad/s²", "10^{-1}$ m/s²"]
    for title, bound in zip(titles, bounds, strict=True):
        assert title.endswith(f"less than ${bound}")


def test_a_difference_that_is_rounding_is_bounded_the_same_on_every_machine(states) -> None:
    moved = states._replace(twists=states.twists + 1e-16)
    titles = [axes.get_title() for axes in histories.rates(states, moved, "E", "").axes[1::2]]
    assert all("10^{-12}" in title for title in titles)


def test_every_axis_says_its_quantity_and_unit(states) -> None:
    pose = histories.poses(states, states, "Engine", "")
    rate = histories.rates(states, states, "Engine", "")
    assert [axes.get_ylabel() for axes in pose.axes] == ["position of $C$ [m]", "orientation [deg]"]
    units = ["[rad/s]", "[m/s]", "[rad/s²]", "[m/s²]"]
    assert [axes.get_ylabel().split()[-1] for axes in rate.axes[::2]] == units
    assert {axes.get_xlabel() for axes in (*pose.axes, *rate.axes[-2:])} == {"$t$ [s]"}


# The robot -------------------------------------------------------------------------------


@pytest.mark.parametrize("radius", [1.0, 2.5])
def test_legs_and_central_limb_are_as_long_as_their_joint_values(axes, radius: float) -> None:
    robot = kleinform.UncoupledManipulator(radius)
    draw_robot(axes, robot, *POSE)
    joints = robot.inverse_displacement(*POSE)
    here = scene(robot, *POSE)
    for i in range(3):
        angle = np.radians(120.0 * i)
        base = radius * np.array([np.cos(angle), np.sin(angle), 0.0])
        assert has_segment(axes, base, here.platform[i])
        assert has_segment(axes, here.centre, here.platform[i])
        assert np.linalg.norm(here.platform[i] - base) == pytest.approx(joints[i], rel=1e-14)
    assert has_segment(axes, np.zeros(3), robots.POSITION)
    points = {f"${name}_{i}$" for name in "AB" for i in (1, 2, 3)}
    assert points | {"$O$", "$C$"} <= names(axes)


@pytest.mark.parametrize("radius", [0.1, 1.0])
def test_names_keep_their_distance_over_the_radius(axes, radius: float) -> None:
    robot = kleinform.UncoupledManipulator(radius)
    draw_robot(axes, robot, radius * robots.POSITION, robots.ROTATION)
    name = next(text for text in axes.texts if text.get_text() == "$C$")
    apart = np.linalg.norm(name.get_position_3d() - radius * robots.POSITION)
    assert apart == pytest.approx(0.12 * radius)


def test_directions_begin_at_their_points(axes) -> None:
    draw_directions(axes, robots.ROBOT, *POSE)
    here = scene(robots.ROBOT, *POSE)
    starts = {tuple(np.round(start, 12)) for start, _ in segments(axes)}
    assert {tuple(np.round(place, 12)) for place in (*here.base, *here.platform)} <= starts
    assert {f"$q_{k}$" for k in (1, 2, 3, 6)} <= names(axes)


@pytest.mark.parametrize("limb", [1, 2, 3, 4])
def test_arrows_of_screws_lie_on_their_axes(axes, limb: int) -> None:
    draw_screws(axes, robots.ROBOT, *POSE, limb)
    screws = robots.ROBOT.screws(*POSE)
    arrows = segments(axes)
    assert len(arrows) == 6
    for joint, (start, end) in enumerate(arrows, start=1):
        screw, vector = screws.screw(limb, joint), (end - start) / 0.32
        if screw[:3].any():
            moment = np.cross(vector, robots.POSITION - start)
            np.testing.assert_allclose(np.hstack([vector, moment]), screw, atol=1e-13)
        else:
            np.testing.assert_allclose(vector, screw[3:], atol=1e-13)
    wanted = {f"${{}}^{{{k - 1}}}\\$_{{{limb}}}^{{{k}}}$" for k in range(1, 7)}
    assert names(axes) == wanted


def test_prismatic_screws_are_dashed(axes) -> None:
    draw_screws(axes, robots.ROBOT, *POSE, 1)
    arrows = [line for line in axes.lines if len(line.get_data_3d()[0]) == 2]
    assert [line.get_linestyle() for line in arrows] == ["-", "--", "-", "-", "-", "--"]


def test_reciprocal_lines_meet_the_base_axes_at_right_angles_to_n(axes) -> None:
    draw_reciprocal_lines(axes, robots.ROBOT, *POSE)
    here = scene(robots.ROBOT, *POSE)
    for i, d in enumerate(here.ends):
        np.testing.assert_allclose(np.cross(d, here.base[i]), 0.0, atol=1e-14)  # on O A_i
        assert (d - here.platform[i]) @ here.directions[i] == pytest.approx(0.0, abs=1e-14)
        assert has_segment(axes, here.platform[i], d)
    assert {"$D_1$", "$D_2$", "$D_3$"} <= names(axes)


def test_modes_are_the_rows_of_table_1() -> None:
    figure = robots.modes()
    rows = np.array(printed.TABLE_1, dtype=np.float64)
    assert len(figure.axes) == len(rows)
    for k, (axes, row) in enumerate(zip(figure.axes, rows, strict=True)):
        drawn = np.array([line.get_data_3d() for line in axes.lines if line.get_marker() == "o"])
        gaps = abs(drawn[..., 0][:, np.newaxis] - row).max(axis=2)
        assert (gaps.min(axis=0) < 2e-5).all()
        assert axes.get_title().startswith(f"row {k + 1}: ")
    feasible = ["not" not in axes.get_title() for axes in figure.axes]
    assert feasible == [True, True, False, False]


def test_three_dimensional_axes_have_equal_units(axes) -> None:
    draw_robot(axes, robots.ROBOT, *POSE)
    settle(axes, zoom=1.0)
    limits = np.ptp([axes.get_xlim(), axes.get_ylim(), axes.get_zlim()], axis=1)
    ratios = axes._box_aspect / limits
    np.testing.assert_allclose(ratios, ratios[0])


def test_a_robot_with_c_on_the_z_axis_is_drawn(axes) -> None:
    draw_robot(axes, robots.ROBOT, [0.0, 0.0, 1.0], robots.ROTATION)
    assert has_segment(axes, np.zeros(3), np.array([0.0, 0.0, 1.0]))


def test_a_pose_that_cannot_be_drawn_is_refused(axes) -> None:
    upright = kleinform.rotation_from_rpy(roll=0.0, pitch=np.pi / 2, yaw=np.pi / 2)
    with pytest.raises(kleinform.SingularPoseError, match="n_1·u_1 = 0"):
        draw_robot(axes, robots.ROBOT, [0.1, 0.2, 1.0], upright)
    with pytest.raises(kleinform.ShapeError, match="one radius"):
        draw_robot(axes, kleinform.UncoupledManipulator([1.0, 2.0]), *POSE)


# Maps ------------------------------------------------------------------------------------


def test_a_map_shows_its_numbers_and_curves() -> None:
    counted = joint_map(robots.ROBOT, JOINTS, ("q1", "q2"), ((0.6, 1.4), (0.6, 1.4)), resolution=9)
    figure = Figure()
    axes = figure.add_subplot()
    maps.draw_modes(axes, counted)
    mesh, curves = axes.collections
    np.testing.assert_array_equal(mesh.get_array().reshape(9, 9), counted.counts.T)
    np.testing.assert_array_equal(curves.get_segments(), counted.segments)
    scale = figure.axes[1]
    assert scale.get_ylabel().startswith("assembly modes")
    assert scale.get_yticks().tolist() == np.unique(counted.counts).tolist()


def test_a_map_shows_the_conditioning() -> None:
    figure = Figure()
    axes = figure.add_subplot()
    ends = np.linspace(-0.4, 0.5, 7)
    maps.draw_conditioning(axes, ends)
    shown = axes.collections[0].get_array().reshape(7, 7)
    for i, j in ((0, 0), (2, 5), (6, 1)):
        place = [ends[j], ends[i], 1.0]
        assert shown[i, j] == conditioning(robots.ROBOT, place, robots.ROTATION)[2]
    assert "[m]" in figure.axes[1].get_ylabel()


def test_the_way_between_two_modes_begins_and_ends_at_the_same_joint_values() -> None:
    *_, history = maps.joined(samples=15).axes
    assert len(history.lines) == 3
    for line in history.lines:
        lengths = line.get_ydata()
        assert abs(lengths[0] - lengths[-1]) <= 1e-14
        assert np.ptp(lengths) >= 0.05
    assert "[m]" in history.get_ylabel()


# The workspace ---------------------------------------------------------------------------


def room(positions: np.ndarray) -> dict[str, np.ndarray]:
    """How far each end of a range is away, in the paper's orientation."""
    joints = robots.ROBOT.inverse_displacement(positions, robots.ROTATION)
    extension = robots.ROBOT.survey(positions, robots.ROTATION).extension
    return Limits.typical().room(joints, extension)


def test_sections_of_fig_3_keep_every_limit_and_meet_that_of_their_colour() -> None:
    panels = regions.fig_3(resolution=9).axes[2:]
    assert len(panels) == len(regions.HEIGHTS)
    for axes, z in zip(panels, regions.HEIGHTS, strict=True):
        assert axes.get_title().startswith(f"$Z$ = {z} m")
        arcs = [line for line in axes.lines if line.get_color() != LOCUS]
        assert len(arcs) >= 2
        for line in arcs:
            found = room(np.insert(line.get_xydata(), 2, z, axis=1))
            assert min(gap.min() for gap in found.values()) >= -1e-12
            name = next(name for name in LIMITS if LIMITS[name] == line.get_color())
            own = [abs(gap).max() for end, gap in found.items() if end.startswith(name)]
            assert min(own) <= 1e-12


def test_triangles_have_the_colour_of_the_limit_that_their_corners_meet() -> None:
    workspace = constant_orientation_workspace(robots.ROBOT, robots.ROTATION, Limits.typical())
    vertices = workspace.mesh(9).vertices
    names, normals = regions.limits_met(workspace, vertices)
    found = room(vertices)
    for k, name in enumerate(names):
        gaps = [abs(gap[k]) for end, gap in found.items() if end.startswith(name)]
        assert min(gaps) <= 1e-12
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-12)
    assert not workspace.contains(vertices + 1e-6 * normals).any()


@pytest.mark.parametrize("draw", [regions.fig_3, regions.loci])
def test_the_orientation_factor_vanishes_on_the_dashed_curves(draw) -> None:
    orientations = {"fig_3": [robots.ROTATION] * 6, "loci": [case[1] for case in regions.CASES]}
    panels = [axes for axes in draw(resolution=9).axes if axes.name != "3d"]
    for axes, rotation in zip(panels, orientations[draw.__name__], strict=True):
        z = float(axes.get_title().split()[2])
        curves = [line.get_xydata() for line in axes.lines if line.get_color() == LOCUS]
        assert curves
        positions = np.insert(np.concatenate(curves), 2, z, axis=1)
        factors = robots.ROBOT.survey(positions, rotation).factors
        assert abs(factors["orientation"]).max() <= 1e-12


def test_shades_are_the_signs_of_the_factor() -> None:
    axes = Figure().add_subplot()
    regions.draw_signs(axes, direct_locus(robots.ROBOT, robots.ROTATION), 0.65, count=5)
    shown = axes.collections[0].get_array().reshape(5, 5)
    for (row, column), positive in np.ndenumerate(shown):
        x, y = np.linspace(-1.1, 1.1, 5)[[column, row]]
        factors = robots.ROBOT.survey([x, y, 0.65], robots.ROTATION).factors
        assert bool(positive) == (factors["orientation"] > 0.0)


def test_a_hole_in_a_section_is_not_filled() -> None:
    def circle(radius: float, end: float) -> Loop:
        curve = Curve(np.zeros(2), np.array([radius, 0.0]), np.array([0.0, radius]), True)
        return Loop((Arc("q6", "low", curve, 0.0, end),), 0.0)

    axes = Figure().add_subplot()
    turn = 2.0 * np.pi
    regions.draw_section(axes, Section(1.0, (circle(1.0, turn), circle(0.5, -turn))))
    path = axes.patches[0].get_path()
    windings = [signed_area(part) for part in path.to_polygons()]
    assert windings[0] > 0.0 > windings[1]


def signed_area(polygon: np.ndarray) -> float:
    x, y = polygon.T
    return 0.5 * float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


# The files -------------------------------------------------------------------------------


def test_every_figure_is_written_with_the_same_bytes(tmp_path, without_engine) -> None:
    folders = [tmp_path / "not" / "there", tmp_path / "again"]
    first, second = (
        {path.name: path.read_bytes() for path in paper.write_figures(folder, SAMPLES)}
        for folder in folders
    )
    assert sorted(first) == [f"{name}.svg" for name in NAMES]
    assert first == second
    assert all(b"<svg" in content and b"<dc:date>" not in content for content in first.values())
    assert sorted(path.name for path in folders[0].iterdir()) == sorted(first)


def test_the_callers_style_changes_nothing(tmp_path) -> None:
    import matplotlib as mpl

    write(robots.diagram, tmp_path / "a.svg")
    with mpl.rc_context({"font.size": 30.0, "lines.linewidth": 9.0}):
        write(robots.diagram, tmp_path / "b.svg")
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_a_figure_that_fails_leaves_the_old_file(tmp_path) -> None:
    path = tmp_path / "figure.svg"
    path.write_text("old")

    def fails() -> Figure:
        raise RuntimeError("half-way")

    with pytest.raises(RuntimeError, match="half-way"):
        write(fails, path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


# The command -----------------------------------------------------------------------------


def run(code: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", code, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("module", "extra"), [("matplotlib", "plots"), ("pinocchio", "verify")])
def test_the_command_names_the_missing_extra_in_one_line(
    tmp_path: Path, module: str, extra: str
) -> None:
    code = (
        f"import sys; sys.modules[{module!r}] = None\n"
        "from kleinform.plots.__main__ import main\n"
        "sys.exit(main(sys.argv[1:]))"
    )
    done = run(code, tmp_path / "figures")
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert f"{module}: pip install 'kleinform[{extra}]'" in done.stderr
    assert not (tmp_path / "figures").exists()


def test_drawing_without_matplotlib_raises_missing_extra_error() -> None:
    code = "import sys; sys.modules['matplotlib'] = None; import kleinform.plots.histories"
    done = run(code)
    assert "kleinform.errors.MissingExtraError" in done.stderr


def test_the_command_needs_one_folder(capsys) -> None:
    from kleinform.plots.__main__ import main

    assert main([]) == 2
    assert "usage" in capsys.readouterr().err
