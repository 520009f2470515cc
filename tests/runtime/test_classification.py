"""Classes of poses against numerical ranks, and against screws built from geometry alone.

Poses are constructed to lie on each locus: in floating point within the default rounding.
"""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import null_space, subspace_angles
from scipy.optimize import brentq, least_squares
from scipy.spatial.transform import Rotation

import kleinform
from kleinform import InputError, SingularityWarning, UncoupledManipulator, rotation_from_rpy
from kleinform.classification import Classes, PoseClass
from kleinform.codes import BLOCK, by_numpy
from kleinform.zero import EPS
from tests.runtime.poses import POLARITY, limb_of
from tests.support import (
    BASE_AXES,
    NEAR,
    Case,
    batch,
    platform_directions,
    random_cases,
    random_position,
    random_rotation,
    rotation_with_direction,
    scaled,
    unit_normal_to,
)

REGULAR, INVERSE, DIRECT, COMBINED, WRIST, LIMB, INVALID = PoseClass.__members__.values()
COUNT = 20
RADII = (1e-3, 1.0, 1e3)
#: Singular values below it, beside the largest one, are zero: rounding is 1e-15, and the
#: smallest that is none here 1e-4.
RANK = 1e-10


def regular(rng: np.random.Generator) -> Case:
    return random_cases(rng, 1)[0]


def vertical(rng: np.random.Generator) -> Case:
    return Case(1.0, np.array([0.0, 0.0, rng.uniform(0.3, 2.0)]), random_rotation(rng))


def at_origin(rng: np.random.Generator) -> Case:
    return Case(1.0, np.zeros(3), random_rotation(rng))


def in_the_platform(rng: np.random.Generator) -> Case:
    """(n_1 × n_2)·c = 0."""
    return NEAR["wrist"](rng, 0.0)


def extended(rng: np.random.Generator) -> Case:
    """c·u_i = a."""
    return NEAR["extension"](rng, 0.0)


def extended_twice(rng: np.random.Generator) -> Case:
    """c·u_1 = c·u_2 = a."""
    place = -2.0 * BASE_AXES[2] + [0.0, 0.0, rng.uniform(0.3, 2.0)]
    return Case(1.0, place, random_rotation(rng))


def without_leg(rng: np.random.Generator) -> Case:
    """C on the line through A_i along n_i: q_i = 0."""
    return NEAR["leg"](rng, 0.0)


def without_leg_and_extended(rng: np.random.Generator) -> Case:
    """q_1 = 0 and c·u_2 = a."""
    rotation = random_rotation(rng)
    n = platform_directions(rotation)[0]
    return Case(1.0, BASE_AXES[0] + 1.5 / (n @ BASE_AXES[1]) * n, rotation)


def at_infinity(rng: np.random.Generator) -> Case:
    """n_i·u_i = 0."""
    return NEAR["incidence"](rng, 0.0)


def sliding(rng: np.random.Generator) -> Case:
    """n_1·u_1 = 0, and C in the plane of leg 1."""
    n = unit_normal_to(BASE_AXES[0], rng)
    place = random_position(rng) * [0.0, 1.0, 1.0] + BASE_AXES[0]
    return Case(1.0, place, rotation_with_direction(0, n, rng))


def level(rng: np.random.Generator) -> Case:
    """R = I."""
    return Case(1.0, random_position(rng), np.eye(3))


def level_and_extended(rng: np.random.Generator) -> Case:
    return Case(1.0, extended(rng).position, np.eye(3))


def level_and_vertical(rng: np.random.Generator) -> Case:
    """All four limbs parallel."""
    return Case(1.0, vertical(rng).position, np.eye(3))


def flat(rng: np.random.Generator) -> Case:
    """A pure yaw with C in the base plane: everything is coplanar."""
    turn = rotation_from_rpy(roll=0.0, pitch=0.0, yaw=rng.uniform(0.2, 0.9))
    return Case(1.0, random_position(rng) * [1.0, 1.0, 0.0], turn)


def orientation(case: Case) -> float:
    result = UncoupledManipulator(case.radius).direct_singularity(case.position, case.rotation)
    return float(result.factors["orientation"])


def root(
    path: Callable[[float], Case], value: Callable[[Case], float] = orientation
) -> Case | None:
    """The pose on a path over 0 to 1 where a value vanishes to rounding."""
    times = np.linspace(0.0, 1.0, 30)
    values = [value(path(time)) for time in times]
    for k, (one, other) in enumerate(itertools.pairwise(values)):
        # Not a pole, where values on both sides are large.
        if one * other < 0.0 and max(abs(one), abs(other)) < 1.0:
            ends = times[k : k + 2]
            return path(brentq(lambda time: value(path(time)), *ends, xtol=1e-16))
    return None


def crossed(rng: np.random.Generator) -> Case:
    """A direct singularity on a segment of positions, C at any height."""
    found = None
    while found is None:
        rotation, start, end = random_rotation(rng), random_position(rng), random_position(rng)
        found = root(functools.partial(shifted, rotation, start, end))
    return found


def to_origin(rotation: np.ndarray) -> np.ndarray:
    """The matrix M of M c = −(1, 1, 1): every D_i is at O where b_i·n_i = 0."""
    directions = platform_directions(rotation)
    return np.sum(directions * BASE_AXES, axis=1, keepdims=True) * directions - BASE_AXES


def lines_to_origin(rotation: np.ndarray) -> Case:
    return Case(1.0, np.linalg.solve(to_origin(rotation), -np.ones(3)), rotation)


def through_origin(rng: np.random.Generator) -> Case:
    """All lines S_i pass through O."""
    return lines_to_origin(random_rotation(rng))


def through_origin_in_one_plane(rng: np.random.Generator) -> Case:
    """All lines S_i pass through O and are coplanar, C lies in their plane, and the wrist too."""
    found = None
    while found is None or abs(extents(found)).min() < 0.2:
        turn = functools.partial(rotated, np.zeros(3), random_rotation(rng), rng.normal(size=3))
        found = root(lambda time, turn=turn: lines_to_origin(turn(time).rotation), spread)
    return found


def spread(case: Case) -> float:
    """The determinant of the directions of S_1, S_2, S_3, without a pole where C is far."""
    limbs = [limb_of(case, i) for i in range(3)]
    lines = [limb.foot - limb.platform for limb in limbs]
    directions = [line / np.linalg.norm(line) for line in lines]
    return float(np.linalg.det(directions) * np.linalg.det(to_origin(case.rotation)))


def shifted(rotation: np.ndarray, start: np.ndarray, end: np.ndarray, time: float) -> Case:
    return Case(1.0, start + time * (end - start), rotation)


def turned(rng: np.random.Generator) -> Case:
    """A direct singularity on a turn of the platform, C on the Z axis."""
    found = None
    while found is None:
        place, start, axis = vertical(rng).position, random_rotation(rng), rng.normal(size=3)
        found = root(functools.partial(rotated, place, start, axis))
    return found


def rotated(place: np.ndarray, start: np.ndarray, axis: np.ndarray, time: float) -> Case:
    return Case(1.0, place, Rotation.from_rotvec(time * axis).as_matrix() @ start)


#: Name: construction, class, k of the twists, k of the joint rates.
LOCI = {
    "regular": (regular, REGULAR, 0, 0),
    "vertical": (vertical, INVERSE, 0, 1),
    "at origin": (at_origin, INVERSE, 0, 2),
    "in the platform": (in_the_platform, WRIST, 0, 0),
    "extended": (extended, DIRECT, 1, 0),
    "extended twice": (extended_twice, DIRECT, 2, 0),
    "crossed": (crossed, DIRECT, 1, 0),
    "through origin": (through_origin, DIRECT, 1, 0),
    "through origin in one plane": (through_origin_in_one_plane, DIRECT | WRIST, 2, 0),
    "level": (level, DIRECT, 1, 0),
    "level and extended": (level_and_extended, DIRECT, 1, 0),
    "flat": (flat, DIRECT | WRIST, 2, 0),
    "turned": (turned, COMBINED, 1, 1),
    "level and vertical": (level_and_vertical, COMBINED, 1, 1),
    "without leg": (without_leg, LIMB, 0, 0),
    "without leg and extended": (without_leg_and_extended, DIRECT | LIMB, 0, 0),
    "at infinity": (at_infinity, INVERSE | LIMB, 0, 1),
    "sliding": (sliding, INVERSE | LIMB, 0, 1),
}


@functools.cache
def constructed(locus: str) -> tuple[Case, ...]:
    rng = np.random.default_rng(11)
    return tuple(LOCI[locus][0](rng) for _ in range(COUNT))


def everything() -> Case:
    """All constructed poses, and those close by, as one batch."""
    rng = np.random.default_rng(12)
    cases = [case for locus in LOCI for case in constructed(locus)]
    cases += [near(rng, 10.0**-k) for near in NEAR.values() for k in range(3, 17) for _ in range(9)]
    return batch(cases)


def classes(case: Case, **more: float) -> Classes:
    return UncoupledManipulator(case.radius, **more).classify(case.position, case.rotation)


@pytest.mark.parametrize("radius", RADII)
@pytest.mark.parametrize("locus", LOCI)
def test_poses_on_a_locus_have_its_class(locus: str, radius: float) -> None:
    _, expected, _, _ = LOCI[locus]
    assert [int(classes(scaled(case, radius)).code) for case in constructed(locus)] == [
        expected
    ] * COUNT


@pytest.mark.parametrize("radius", RADII)
@pytest.mark.parametrize("locus", LOCI)
def test_bases_are_orthonormal_and_as_large_as_the_locus_says(locus: str, radius: float) -> None:
    _, _, free, still = LOCI[locus]
    for case in constructed(locus):
        found = classes(scaled(case, radius))
        for basis, count in ((found.uncontrollable, free), (found.idle, still)):
            assert basis.shape == (count, 6)
            assert np.allclose(basis @ basis.T, np.eye(count), rtol=0.0, atol=16.0 * EPS)


@pytest.mark.parametrize(
    "locus", [name for name, (_, code, _, _) in LOCI.items() if not code & LIMB]
)
def test_ranks_and_null_spaces_are_those_of_the_jacobians(locus: str) -> None:
    """The wrist takes one more from both ranks. At O there are no Jacobians."""
    if locus == "at origin":
        return
    for case in constructed(locus):
        found = classes(case)
        robot = UncoupledManipulator(case.radius)
        forward, inverse = robot.jacobians(case.position, case.rotation, azimuth=0.4)
        wrist = bool(found.code & WRIST)
        assert rank(forward) == 6 - len(found.uncontrollable) - wrist
        assert rank(inverse) == 6 - len(found.idle) - wrist
        size = abs(forward).max() * max(1.0, *1.0 / abs(extents(case)))
        assert np.all(abs(found.uncontrollable @ POLARITY @ forward) <= RANK * size)
        assert np.all(abs(inverse @ found.idle.T) <= RANK)
        if not wrist and len(found.uncontrollable):
            angles = subspace_angles(
                null_space(forward.T @ POLARITY, rcond=RANK), found.uncontrollable.T
            )
            assert angles.max() <= 1e-9


def rank(matrix: np.ndarray) -> int:
    return int(np.linalg.matrix_rank(matrix, tol=RANK * np.linalg.norm(matrix, 2)))


def extents(case: Case) -> np.ndarray:
    """n_i·u_i: lines and feet are known to eps over its square."""
    return np.sum(platform_directions(case.rotation) * BASE_AXES, axis=1)


@pytest.mark.parametrize("locus", [name for name in LOCI if name != "at infinity"])
def test_uncontrollable_twists_are_those_that_all_passive_limbs_allow(locus: str) -> None:
    """Limbs of passive screws, from points and axes; the central one turns about C freely."""
    for case in constructed(locus):
        found = classes(case).uncontrollable if LOCI[locus][1] & DIRECT else np.zeros((0, 6))
        allowed = np.vstack([np.zeros((3, 3)), np.eye(3)])
        forbidden = [allowed.T] + [null_space(passive(case, i), rcond=1e-9).T for i in range(3)]
        assert len(null_space(np.concatenate(forbidden), rcond=1e-8).T) == len(found)
        for rows in forbidden:
            assert np.all(abs(found @ rows.T) <= 1e-9)


def passive(case: Case, i: int) -> np.ndarray:
    """Twists [omega, v_C] (n, 6) of the joints of limb i while its prismatic joint is locked."""
    if abs(extents(case)[i]) < 1e-12:
        # C lies in the plane of the leg: B_i is anywhere.
        axis, n = BASE_AXES[i], platform_directions(case.rotation)[i]
        base, b = case.radius * axis, case.position + 0.7 * n
    else:
        limb = limb_of(case, i)
        axis, n, base, b = limb.axis, limb.direction, limb.base, limb.platform
    leg = b - base
    along = np.cross(axis, n) if np.linalg.norm(leg) < 1e-12 else leg
    along = along / np.linalg.norm(along)
    turns = [(axis, base), (along, b), (np.cross(n, along), b), (n, b)]
    screws = [[*s, *np.cross(point - case.position, s)] for s, point in turns]
    return np.array([*screws, [0.0, 0.0, 0.0, *n]])


def test_limbs_are_those_that_the_jacobians_refuse() -> None:
    """At O they refuse the central limb; poses a little off the loci are near them."""
    case = everything()
    off = np.linalg.norm(case.position, axis=1) > 0.0
    robot = UncoupledManipulator()
    with pytest.warns(SingularityWarning):
        refused = robot.jacobians(case.position, case.rotation, azimuth=0.4, errors="nan")
    limb = classes(case).code & LIMB > 0
    assert np.array_equal(limb[off], np.isnan(refused.J_v[off, 0, 0]))


def test_classes_are_what_vanishes_in_the_survey() -> None:
    case = everything()
    found = classes(case)
    zero, undefined = found.survey.vanishing(), found.survey.undefined()
    parallel = [zero[f"limb_{i}"] | undefined[f"extension_{i}"] for i in (1, 2, 3)]
    inverse = np.any(parallel, axis=0) | zero["central"]
    assert np.array_equal(found.code & INVERSE > 0, inverse)
    assert np.array_equal(found.code & WRIST > 0, zero["wrist"])
    limb = found.code & LIMB > 0
    direct = zero["orientation"] | np.any([zero[f"extension_{i}"] for i in (1, 2, 3)], axis=0)
    assert np.array_equal((found.code & DIRECT > 0)[~limb], direct[~limb])


def test_both_backends_have_the_same_codes() -> None:
    case = everything()
    assert len(case.radius) > 1000
    for rounding in (0.0, 16.0, 1e6):
        found = classes(case, rounding=rounding)
        again = by_numpy(found.survey.result, case.radius, rounding)
        assert found.code.dtype == again.dtype == np.uint8
        assert np.array_equal(found.code, again)


def test_a_batch_is_its_poses() -> None:
    case = everything()
    alone = [classes(Case(*parts)) for parts in zip(*case, strict=True)]
    assert np.array_equal(classes(case).code, [one.code for one in alone])
    assert classes(case).names().tolist() == [str(one.names()) for one in alone]


@pytest.mark.parametrize("threads", [1, 2])
def test_blocks_and_threads_change_nothing(threads: int) -> None:
    case = everything()
    times = 3 * BLOCK // len(case.radius) + 1
    many = Case(*(np.concatenate([part] * times) for part in case))
    kleinform.set_threads(threads)
    try:
        assert np.array_equal(classes(many).code, np.tile(classes(case).code, times))
        one_radius = UncoupledManipulator().classify(many.position, many.rotation)
        assert np.array_equal(one_radius.code, classes(many).code)
        grid = UncoupledManipulator([[1.0], [1.0]]).classify(many.position, many.rotation)
        assert np.array_equal(grid.code, [classes(many).code] * 2)
    finally:
        kleinform.set_threads(None)


def test_leading_axes_broadcast() -> None:
    places = np.stack([case.position for case in constructed("level")])
    turns = np.stack([np.eye(3), random_rotation(np.random.default_rng(1))])
    found = UncoupledManipulator([1.0, 2.0]).classify(places[:, np.newaxis], turns)
    assert found.code.tolist() == [[DIRECT, REGULAR]] * COUNT
    assert UncoupledManipulator([[1.0], [2.0]]).classify(places, np.eye(3)).code.shape == (2, COUNT)


@pytest.mark.parametrize("shape", [(0,), (3, 0), (0, 4)])
def test_an_empty_batch_has_no_codes(shape: tuple[int, ...]) -> None:
    found = UncoupledManipulator().classify(np.zeros((*shape, 3)), np.eye(3))
    assert found.code.shape == found.names().shape == shape
    assert found.code.dtype == np.uint8
    assert found.survey.joints.shape == (*shape, 6)


def test_rows_that_are_no_poses_are_invalid() -> None:
    case = batch(constructed("level"))
    case.position[3] = np.nan
    case.rotation[5] = 2.0
    robot = UncoupledManipulator()
    with pytest.raises(InputError, match="first at pose 3; 2 of 20 poses"):
        robot.classify(case.position, case.rotation)
    found = robot.classify(case.position, case.rotation, errors="nan")
    assert np.flatnonzero(found.code == INVALID).tolist() == [3, 5]
    assert np.flatnonzero(found.code == DIRECT).tolist() == np.delete(range(COUNT), [3, 5]).tolist()
    assert found.names()[3:6].tolist() == ["invalid", "direct", "invalid"]
    assert np.isnan(found.survey.joints[[3, 5]]).all()
    alone = robot.classify(case.position[3], np.eye(3), errors="nan")
    assert alone.code == INVALID
    assert alone.meaning == ["no pose: the row was refused"]
    assert alone.uncontrollable.shape == alone.idle.shape == (0, 6)


@pytest.mark.parametrize("asked", ["meaning", "uncontrollable", "idle"])
def test_what_only_one_pose_has_is_refused_to_a_batch(asked: str) -> None:
    found = UncoupledManipulator().classify(np.ones((2, 3)), np.eye(3))
    with pytest.raises(InputError, match=rf"{asked}: one pose is needed, .* shape \(2,\) arrived"):
        getattr(found, asked)


def test_names() -> None:
    found = UncoupledManipulator().classify([[0.3, 0.2, 1.0], [0.0, 0.0, 1.0]], np.eye(3))
    assert found.names().tolist() == ["direct", "combined"]
    assert repr(found) == "Classes(['direct' 'combined'])"
    assert str(classes(constructed("flat")[0]).names()) == "direct, wrist"
    assert str(classes(constructed("regular")[0]).names()) == "regular"


#: Locus: what its words must contain, a pattern a line.
WORDS = {
    "regular": [],
    "vertical": ["on the Z axis, elevation 90°: q4 moves nothing"],
    "at origin": ["C is at O, .* q4 and q5 move nothing"],
    "in the platform": ["lies in the platform's plane"],
    "extended": ["e_. = 0: B_. is at C"],
    "extended twice": ["e_1 = 0: B_1 is at C", "e_2 = 0: B_2 is at C"],
    "crossed": ["the axis through C along"],
    "through origin": [r"meet in the point \(0, 0, 0\)", "the axis through C along"],
    "through origin in one plane": [
        "platform's plane",
        "S_1, S_2, S_3 and C lie in one plane",
        r"meet in the point \(0, 0, 0\)",
    ],
    "level": ["the axis through C along"],
    "flat": ["platform's plane", "S_1, S_2, S_3 and C lie in one plane"],
    "level and vertical": ["on the Z axis", "S_1, S_2 and S_3 are parallel", "along .*1.*"],
    "without leg": ["q. = 0: B_. and D_. are at A_."],
    "at infinity": ["n_. is parallel to the plane of leg .: B_. is at infinity"],
    "sliding": ["C lies in it too, B_1 is anywhere .* and q1 moves nothing"],
}


@pytest.mark.parametrize("locus", WORDS)
def test_words_say_what_the_locus_is(locus: str) -> None:
    for case in constructed(locus):
        found = classes(case).meaning
        assert len(found) == len(WORDS[locus])
        for line, pattern in zip(found, WORDS[locus], strict=True):
            assert re.search(pattern, line), line


def test_two_lines_and_c_in_one_plane() -> None:
    """Found by least squares, so that what is zero is so within 1e4 roundings."""
    rng = np.random.default_rng(13)
    found = 0
    while found < 3:
        place, start = random_position(rng), rng.normal(size=3)
        result = least_squares(lambda turn, place=place: crossing(place, turn), start, xtol=1e-15)
        case = Case(1.0, place, Rotation.from_rotvec(result.x).as_matrix())
        if result.cost > 1e-28 or abs(extents(case)).min() < 0.2:
            continue
        found += 1
        meaning = classes(case, rounding=1e4).meaning
        assert meaning[0] == "S_1, S_2 and C lie in one plane"
        assert len(meaning) == 2


def crossing(place: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """The cross product of the normals of the planes of C with S_1 and with S_2."""
    case = Case(1.0, place, Rotation.from_rotvec(turn).as_matrix())
    limbs = [limb_of(case, i) for i in range(2)]
    normals = [np.cross(limb.direction, limb.foot - limb.platform) for limb in limbs]
    return np.cross(*(normal / np.linalg.norm(normal) for normal in normals))
