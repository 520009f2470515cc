"""Workspaces of any size, ranges that end at the base, and what is asked wrongly."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import InputError, Limits, UncoupledManipulator
from kleinform.maps import Workspace, constant_orientation_workspace, direct_locus

BOUNDS = [[-1.0, -1.0, 0.3], [1.0, 1.0, 1.5]]
ROTATION = Rotation.from_euler("ZYX", np.deg2rad([6.0, 3.0, 10.0])).as_matrix()


def typical(radius: float) -> Workspace:
    robot = UncoupledManipulator(radius)
    return constant_orientation_workspace(robot, ROTATION, Limits.typical(radius))


@pytest.mark.parametrize("radius", [1e-90, 1e-6, 1e-3, 1e3, 1e7, 1e99])
def test_the_size_does_not_matter(radius: float) -> None:
    unit, scaled = typical(1.0), typical(radius)
    volume, one = scaled.volume(1e-3), unit.volume(1e-3)
    assert volume.proven
    assert abs(volume.value / radius**3 - one.value) <= volume.error / radius**3 + one.error
    for height in (0.55, 1.1):
        section, small = scaled.section(height * radius), unit.section(height)
        assert section.area == pytest.approx(small.area * radius**2, rel=1e-9)
        assert section.components == small.components
        assert section.z == pytest.approx(height * radius, rel=1e-15)
        points, others = (found.loops[0].points(5) for found in (section, small))
        assert abs(points - others * radius).max() <= 1e-9 * radius


@pytest.mark.parametrize("elevation", [(-1.0, 0.0), (0.0, 1.2)])
def test_an_elevation_that_ends_at_the_base(elevation: tuple[float, float]) -> None:
    turn = Rotation.from_rotvec([0.24544, 0.09871, -0.38930]).as_matrix()
    ranges = {"q2": (0.66, 1.14), "q3": (0.645, 1.44), "q6": (0.746, 1.258)}
    ranges |= {"e2": (-1.0, 1.0), "e3": (0.2, 1.8), "q5": elevation}
    workspace = constant_orientation_workspace(UncoupledManipulator(), turn, Limits(ranges))
    volume = workspace.volume(1e-3)
    assert volume.proven
    assert volume.panels < 10_000
    low, high = workspace.box
    kept = workspace.contains(np.random.default_rng(0).uniform(low, high, (400_000, 3))).mean()
    box = float(np.prod(high - low))
    deviation = box * float(np.sqrt(kept * (1.0 - kept) / 400_000))
    assert abs(volume.value - box * kept) <= 4.0 * deviation + volume.error


@pytest.mark.parametrize("height", [np.nan, np.inf, "a", None, [1.0, 2.0]])
def test_heights_that_are_none(height: object) -> None:
    with pytest.raises(InputError, match=r"^z: "):
        typical(1.0).section(height)


@pytest.mark.parametrize("relative", [0.0, 1e-10, 1.0, np.inf, np.nan, "a", None])
def test_accuracies_that_are_none(relative: object) -> None:
    with pytest.raises(InputError, match=r"^relative: "):
        typical(1.0).volume(relative)


@pytest.mark.parametrize("limits", [None, {"q1": (0.0, 1.0)}])
def test_limits_are_needed(limits: object) -> None:
    with pytest.raises(InputError, match=r"^limits: "):
        constant_orientation_workspace(UncoupledManipulator(), ROTATION, limits)


@pytest.mark.parametrize("resolution", [True, 2.0, "8", 0, -1])
def test_resolutions_are_whole_numbers(resolution: object) -> None:
    with pytest.raises(InputError, match=r"^resolution: "):
        typical(1.0).mesh(resolution)
    with pytest.raises(InputError, match=r"^resolution: "):
        direct_locus(UncoupledManipulator(), ROTATION).mesh(BOUNDS, resolution)


def test_whole_numbers_of_numpy_are_whole_numbers() -> None:
    locus = direct_locus(UncoupledManipulator(), ROTATION)
    for one, other in zip(locus.mesh(BOUNDS, np.int8(6)), locus.mesh(BOUNDS, 6), strict=True):
        assert np.array_equal(one, other)
    assert len(typical(1.0).mesh(np.int8(6)).triangles) == len(typical(1.0).mesh(6).triangles)
