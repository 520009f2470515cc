"""Poses drawn by hypothesis, and the mechanism's points found by solving linear equations."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from tests.support import BASE_AXES, Case, platform_directions

#: Δ, which swaps the primal and the dual part of a screw.
POLARITY = np.roll(np.eye(6), 3, axis=0)


class Limb(NamedTuple):
    """Points and directions of one outer limb."""

    axis: np.ndarray
    direction: np.ndarray
    base: np.ndarray
    platform: np.ndarray
    foot: np.ndarray


def limb_of(case: Case, i: int) -> Limb:
    """B_i and D_i where a line meets a plane: a linear system for point and parameter."""
    axis, base = BASE_AXES[i], case.radius * BASE_AXES[i]
    direction = platform_directions(case.rotation)[i]
    platform = line_meets_plane(case.position, direction, base, axis)
    foot = line_meets_plane(np.zeros(3), axis, platform, direction)
    return Limb(axis, direction, base, platform, foot)


def line_meets_plane(
    point: np.ndarray, along: np.ndarray, on_plane: np.ndarray, normal: np.ndarray
) -> np.ndarray:
    """Solve x − t along = point, normal·x = normal·on_plane for (x, t)."""
    system = np.zeros((4, 4))
    system[:3, :3], system[:3, 3] = np.eye(3), -along
    system[3, :3] = normal
    return np.linalg.solve(system, [*point, normal @ on_plane])[:3]


def floats(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers that are zero or large enough for their powers not to underflow."""
    return st.floats(low, high).map(lambda x: x if abs(x) > 1e-30 else 0.0)


@st.composite
def rotations(draw: st.DrawFn) -> np.ndarray:
    quaternion = np.array([draw(floats(-1.0, 1.0)) for _ in range(4)])
    assume(np.linalg.norm(quaternion) > 0.1)
    return Rotation.from_quat(quaternion).as_matrix()


@st.composite
def cases(draw: st.DrawFn) -> Case:
    """Any pose, singular ones among them, of a manipulator of any radius."""
    radius = 10.0 ** draw(floats(-3.0, 3.0))
    place = [draw(floats(-1.5, 1.5)) for _ in range(3)]
    return Case(radius, radius * np.array(place), draw(rotations()))


@st.composite
def regular_cases(draw: st.DrawFn) -> Case:
    """Poses away from every singularity, by their geometry."""
    case = draw(cases())
    assume(is_regular(case))
    return case


def is_regular(case: Case, *, wrist: bool = True, margin: float = 0.2) -> bool:
    """Whether everything that may vanish is at least a margin, in units of the radius.

    Without ``wrist`` the angle of the central limb and the platform does not count.
    """
    place = case.position / case.radius
    directions = platform_directions(case.rotation)
    if np.min(np.abs(np.sum(directions * BASE_AXES, axis=1))) < margin:
        return False
    unit = Case(1.0, place, case.rotation)
    limbs = [limb_of(unit, i) for i in range(3)]
    legs = [np.linalg.norm(limb.platform - limb.base) for limb in limbs]
    extensions = [np.linalg.norm(limb.platform - place) for limb in limbs]
    moments = [np.cross(limb.direction, limb.foot - place) for limb in limbs]
    sizes = [np.linalg.norm(moment) for moment in moments]
    lengths = [*legs, *extensions, *sizes, np.hypot(*place[:2])]
    lengths += [abs(place @ case.rotation[:, 2])] if wrist else []
    return min(lengths) >= margin and abs(np.linalg.det(moments)) >= margin * np.prod(sizes)


def twists() -> st.SearchStrategy[np.ndarray]:
    """[omega, v_C], every entry between −1 and 1, the velocity in radii a second."""
    return st.lists(floats(-1.0, 1.0), min_size=6, max_size=6).map(np.array)


def in_radii(twist_or_rates: np.ndarray, radius: float, lengths: list[int]) -> np.ndarray:
    """Turn the entries that are lengths from radii to metres."""
    result = twist_or_rates.copy()
    result[lengths] *= radius
    return result
