"""Sections: closed loops of arcs of conics against random positions."""

from math import pi

import numpy as np
import pytest

from tests.maps.workspace_support import PAPER, SPACES, workspace

HEIGHTS = np.linspace(-1.2, 1.35, 12)


@pytest.mark.parametrize("name", SPACES)
def test_areas_against_monte_carlo(name):
    space = SPACES[name]
    rng = np.random.default_rng(4)
    low, high = space.box
    for z in HEIGHTS:
        section = space.section(z)
        points = rng.uniform(low, high, (20_000, 3))
        points[:, 2] = z
        inside = space.contains(points)
        box = float(np.prod((high - low)[:2]))
        deviation = box * max(inside.std(), 1e-3) / 20_000**0.5
        assert abs(section.area - box * inside.mean()) < 4.0 * deviation + 1e-4


@pytest.mark.parametrize("name", SPACES)
def test_loops_are_closed_with_the_workspace_on_their_left(name):
    space = SPACES[name]
    for z in HEIGHTS:
        for loop in space.section(z).loops:
            assert loop.gap < 1e-7
            for arc in loop.arcs:
                middle = (arc.start + arc.end) / 2.0
                tangent = arc.curve.tangent(middle) * np.sign(arc.end - arc.start)
                left = np.array([-tangent[1], tangent[0]]) / np.hypot(*tangent)
                point = arc.curve.points(np.array(middle))
                size = float(np.hypot(*(arc.points(2)[1] - arc.points(2)[0])))
                if not arc.whole and size < 1e-3:
                    continue
                sides = np.array([[*(point + step * left), z] for step in (1e-7, -1e-7)])
                assert space.contains(sides).tolist() == [True, False]


def test_arcs_are_on_their_limits():
    space = SPACES["paper"]
    section = space.section(0.75)
    assert section.components == 1
    for arc in section.loops[0].arcs:
        points = np.concatenate(
            [arc.points(9), np.full((9, 1), section.z), np.ones((9, 1))], axis=1
        )
        own = next(c for c in space.constraints if (c.name, c.end) == (arc.name, arc.edge))
        values = np.einsum("ni,ij,nj->n", points, own.forms[0].matrix, points)
        assert abs(values).max() < 1e-13
    assert section.loops[0].points(5).shape == (5 * len(section.loops[0].arcs), 2)


def test_a_ring_has_a_hole():
    section = workspace(PAPER, {"q6": (0.5, 1.3)}).section(0.3)
    assert (section.components, section.holes) == (1, 1)
    assert abs(section.area - pi * (1.3**2 - 0.5**2)) < 1e-13
    assert all(loop.arcs[0].whole for loop in section.loops)
    assert workspace(PAPER, {"q6": (0.5, 1.3)}).section(1.31).loops == ()


def test_parallel_lines_and_copies():
    """n_1 level: two lines a leg. A limit given twice counts once."""
    strip = workspace(np.eye(3), {"q1": (0.4, 1.1), "e1": (0.2, 1.8), "q6": (0.0, 9.0)})
    section = strip.section(0.3)
    wide, slim = ((q * q - 0.09) ** 0.5 for q in (1.1, 0.4))
    assert section.components == 2
    assert abs(section.area - 1.6 * 2.0 * (wide - slim)) < 1e-12
    twice = workspace(PAPER, {"q6": (0.5, 1.0), "q5": (np.pi / 6.0, 2.0)})
    assert abs(twice.section(0.5).area - pi * 0.75) < 1e-7
