"""Loci of singularities: against the factors of poses, and where they degenerate."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kleinform
from kleinform.errors import InputError
from kleinform.generated import kernels
from kleinform.maps.cubics import division
from kleinform.maps.loci import direct_locus, inverse_locus
from kleinform.maps.rotation_locus import orientation_locus
from tests.support import BASE_AXES, platform_directions, random_position, random_rotation

ROOT = np.sqrt(0.75)
RADIUS = 0.7
ROBOT = kleinform.UncoupledManipulator(RADIUS)
TILTED = Rotation.from_euler("zyx", [0.1, 0.05, 0.17]).as_matrix()
BOX = [[-1.0, -1.0, 0.05], [1.0, 1.1, 2.0]]


def turned(axis: np.ndarray, angle: float) -> np.ndarray:
    return Rotation.from_rotvec(angle * np.asarray(axis, dtype=float)).as_matrix()


def slope(function, at: np.ndarray, step: float = 1e-6) -> np.ndarray:
    """Central differences."""
    moves = step * np.eye(3)
    return np.stack([(function(at + m) - function(at - m)) / (2.0 * step) for m in moves], axis=-1)


# At one orientation ------------------------------------------------------------------------


def test_the_cubic_is_the_factor() -> None:
    rng = np.random.default_rng(1)
    for radius in (1e-3, 1.0, 1e3):
        robot = kleinform.UncoupledManipulator(radius)
        for _ in range(20):
            rotation = random_rotation(rng)
            locus = direct_locus(robot, rotation)
            places = radius * np.array([random_position(rng) for _ in range(6)])
            result = robot.direct_singularity(places, rotation)
            squared = np.prod(locus.incidence) ** 2
            gap = abs(squared * result.factors["orientation"] - ROOT * locus.value(places))
            assert np.all(gap <= 64e-16 * (squared * result.scales["orientation"] + radius**3))
            assert locus.kind == "cubic"
            assert locus.factors.shape == (0, 4)


def test_the_gradient_is_that_of_the_value() -> None:
    rng = np.random.default_rng(2)
    locus, place = direct_locus(ROBOT, random_rotation(rng)), random_position(rng)
    assert np.allclose(locus.gradient(place), slope(locus.value, place), rtol=1e-7, atol=1e-7)


def test_the_planes_are_the_other_factors() -> None:
    rng = np.random.default_rng(3)
    rotation, place = random_rotation(rng), random_position(rng)
    factors = ROBOT.direct_singularity(place, rotation).factors
    locus = direct_locus(ROBOT, rotation)
    for name, plane in locus.planes.items():
        value = plane[0] + plane[1:] @ place
        over = np.linalg.norm(place) if name == "wrist" else locus.incidence[int(name[-1]) - 1]
        assert np.isclose(value / over, factors[name], rtol=1e-13)


T_1 = np.array([0.0, 1.0, 0.0])
DEGENERATE = {
    "identity": (np.eye(3), "identically zero", 0),
    "half a turn": (turned([0, 0, 1], np.pi), "identically zero", 0),
    "quarter of a turn": (turned([0, 0, 1], np.pi / 2), "identically zero", 0),
    "yaw": (turned([0, 0, 1], 0.3), "double plane", 2),
    "upside down": (turned([0, 0, 1], 0.4) @ turned([1, 0, 0], np.pi), "double plane and plane", 3),
    "upside down, X": (turned([1, 0, 0], np.pi), "double plane and plane", 3),
    "pitch": (turned(T_1, 0.4), "plane and quadric", 1),
    "about t_3": (turned(turned([0, 0, 1], -2 * np.pi / 3) @ T_1, -1.2), "plane and quadric", 1),
    "pitch, half a turn": (turned(T_1, 0.4) @ turned([0, 0, 1], np.pi), "plane and quadric", 1),
    "upright": (turned(T_1, np.pi / 2), "three planes", 3),
    "roll": (turned([1, 0, 0], 0.4), "cubic", 0),
}


@pytest.mark.parametrize("name", DEGENERATE)
def test_degenerate_orientations_are_named(name: str) -> None:
    rotation, kind, planes = DEGENERATE[name]
    locus = direct_locus(ROBOT, rotation)
    assert locus.kind == kind
    assert locus.factors.shape == (planes, 4)
    rng = np.random.default_rng(4)
    for plane in locus.factors:
        normal = plane[1:] / (plane[1:] @ plane[1:])
        places = rng.normal(size=(5, 3))
        places -= (places @ plane[1:] + plane[0])[:, np.newaxis] * normal
        assert np.all(abs(locus.value(places)) <= 1e-14)


def test_a_rotation_in_float32_is_judged_by_its_own_precision() -> None:
    yawed = turned([0, 0, 1], 0.3).astype(np.float32)
    assert direct_locus(ROBOT, yawed).kind == "double plane"
    assert direct_locus(ROBOT, turned([1e-4, 0, 1], 0.3)).kind == "cubic"


def test_pure_yaw_is_the_formula() -> None:
    for angle in np.linspace(-3.0, 3.0, 7):
        coefficients = direct_locus(ROBOT, turned([0, 0, 1], angle)).coefficients
        expected = np.zeros(20)
        expected[9] = -3.0 * RADIUS * np.sin(angle) * np.cos(angle) ** 4
        assert np.allclose(coefficients, expected, rtol=0.0, atol=2e-15)


def test_division_has_quotient_and_remainder() -> None:
    coefficients = np.arange(1.0, 21.0)
    quotient, left = division(coefficients, np.array([0.0, 0.0, 0.0, 1.0]))
    with_z = [3, 6, 8, 9, 12, 14, 15, 17, 18, 19]
    assert np.allclose(quotient, coefficients[with_z])
    assert np.allclose(left[with_z], 0.0, atol=1e-13)
    assert np.allclose(np.delete(left, with_z), np.delete(coefficients, with_z))


def test_vertices_of_the_mesh_are_singular_poses() -> None:
    mesh = direct_locus(ROBOT, TILTED).mesh(BOX, 25)
    assert len(mesh.vertices) > 1000
    assert np.unique(mesh.triangles).size == len(mesh.vertices)
    assert np.all(ROBOT.direct_singularity(mesh.vertices, TILTED).vanishing()["orientation"])
    low, high = np.array(BOX)
    assert np.all((mesh.vertices >= low) & (mesh.vertices <= high))


def test_the_mesh_is_oriented_and_only_ends_at_the_box() -> None:
    locus = direct_locus(ROBOT, TILTED)
    vertices, triangles = locus.mesh(BOX, 20)
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    both = {tuple(edge) for edge in edges.tolist()}
    assert len(both) == len(edges)
    alone = np.array([edge for edge in both if edge[::-1] not in both])
    outer = np.isclose(vertices, BOX[0]) | np.isclose(vertices, BOX[1])
    assert np.all(outer[alone].any(axis=-1))
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    downhill = -locus.gradient(corners.mean(axis=1))
    area = np.linalg.norm(normals, axis=1)
    assert np.mean((normals * downhill).sum(axis=1)[area > 1e-6] > 0.0) > 0.99


@pytest.mark.parametrize(("name", "planes"), [("yaw", 1), ("upside down", 2), ("pitch", 1)])
def test_degenerate_loci_have_meshes(name: str, planes: int) -> None:
    locus = direct_locus(ROBOT, DEGENERATE[name][0])
    vertices, _ = locus.mesh([[-1.0, -1.0, -1.1], [1.0, 1.1, 2.0]], 9)
    assert len(vertices) > 100
    assert np.all(abs(locus.value(vertices)) <= 1e-14)
    assert len(np.unique(np.round(locus.factors, 9), axis=0)) == planes


def test_points_of_a_section_are_singular_poses() -> None:
    locus = direct_locus(ROBOT, TILTED)
    curves = locus.section(1.0, [[-3.0, -3.0], [3.0, 3.1]], 60)
    assert curves
    for curve in curves:
        assert np.all(curve[:, 2] == 1.0)
        assert np.all(ROBOT.direct_singularity(curve, TILTED).vanishing()["orientation"])
        assert np.all(np.linalg.norm(np.diff(curve, axis=0), axis=1) <= 0.15)
        ends, edge = curve[[0, -1], :2], np.array([[-3.0, -3.0], [3.0, 3.1]])
        closed = np.array_equal(*ends)
        assert closed or np.all(np.isclose(ends[:, np.newaxis], edge).any(axis=(1, 2)))


def test_a_closed_section_comes_back() -> None:
    from kleinform.maps.zeros import zero_curves

    def circle(points: np.ndarray) -> np.ndarray:
        return 1.0 - (points**2).sum(axis=-1)

    (curve,) = zero_curves(circle, np.array([[-1.6, -1.5], [1.5, 1.7]]), 20)
    assert np.array_equal(curve[0], curve[-1])
    assert np.allclose(np.linalg.norm(curve, axis=1), 1.0, rtol=1e-14)
    swept = np.sum(curve[:-1, 0] * curve[1:, 1] - curve[1:, 0] * curve[:-1, 1]) / 2.0
    assert abs(abs(swept) - np.pi) < 0.02


def test_proven_signs_are_those_of_the_survey() -> None:
    rng = np.random.default_rng(5)
    boxes = direct_locus(ROBOT, TILTED).signed_boxes(BOX, 5)
    volume = np.prod(boxes.high - boxes.low, axis=1)
    assert np.isclose(volume.sum(), np.prod(np.subtract(*BOX[::-1])))
    assert volume[boxes.sign != 0].sum() > 0.9 * volume.sum()
    assert {-1, 0, 1} == set(boxes.sign.tolist())
    proven = boxes.sign != 0
    for _ in range(5):
        places = rng.uniform(boxes.low[proven], boxes.high[proven])
        found = ROBOT.survey(places, TILTED).factors["orientation"]
        assert np.array_equal(np.sign(found), boxes.sign[proven])


def test_every_vertex_is_in_an_undecided_box() -> None:
    locus = direct_locus(ROBOT, TILTED)
    boxes, (vertices, _) = locus.signed_boxes(BOX, 4), locus.mesh(BOX, 13)
    low, high = boxes.low[boxes.sign != 0], boxes.high[boxes.sign != 0]
    for vertex in vertices[::7]:
        assert not np.any((vertex > low).all(axis=1) & (vertex < high).all(axis=1))


def test_no_sign_is_proven_where_all_is_rounding() -> None:
    exact = kleinform.UncoupledManipulator(RADIUS, rounding=0.0)
    for robot in (ROBOT, exact):
        boxes = direct_locus(robot, np.eye(3)).signed_boxes(BOX, 2)
        assert np.all(boxes.sign == 0)
        assert len(boxes.sign) == 64


# At one position ----------------------------------------------------------------------------

PLACE = np.array([0.2, 0.1, 0.9])


def test_the_polynomial_in_the_rotation_is_the_cubic() -> None:
    rng = np.random.default_rng(6)
    turns = np.array([random_rotation(rng) for _ in range(10)])
    found = orientation_locus(ROBOT, PLACE).value(turns)
    cubics = [direct_locus(ROBOT, turn).value(PLACE) for turn in turns]
    assert np.allclose(found, cubics, rtol=1e-13, atol=1e-15)
    by_position = kernels.orientation_locus(np.float64(RADIUS), PLACE, turns).by_position
    gradients = [direct_locus(ROBOT, turn).gradient(PLACE) for turn in turns]
    assert np.allclose(by_position, gradients, rtol=1e-13, atol=1e-15)


def test_the_gradients_are_those_of_the_values() -> None:
    rng = np.random.default_rng(7)
    locus, g = orientation_locus(ROBOT, PLACE), rng.normal(size=3)
    value, gradient = locus.polynomial(g)
    assert np.allclose(gradient, slope(lambda at: locus.polynomial(at)[0], g), rtol=1e-7)
    turn = Rotation.from_quat([*g, 1.0])
    assert np.isclose(value, (1.0 + g @ g) ** 6 * locus.value(turn))

    def after(vector: np.ndarray) -> np.ndarray:
        return locus.value(Rotation.from_rotvec(vector) * turn)

    assert np.allclose(locus.gradient(turn), slope(after, np.zeros(3)), rtol=1e-7, atol=1e-8)


def test_its_degree_is_twelve() -> None:
    """On a line of Rodrigues's parameters: the thirteenth differences vanish, twelfth do not."""
    locus, along = orientation_locus(ROBOT, PLACE), np.array([0.3, -0.5, 0.7])
    values = locus.polynomial(np.arange(-7.0, 7.0)[:, np.newaxis] * along / 4.0)[0]
    size = abs(values).max()
    assert abs(np.diff(values, 13)).max() <= 1e-10 * size
    assert abs(np.diff(values, 12)).max() >= 1e-4 * size


def test_vertices_in_rodrigues_parameters_are_singular_poses() -> None:
    locus = orientation_locus(ROBOT, PLACE)
    mesh = locus.mesh([[-0.45, -0.4, -0.35], [0.3, 0.4, 0.5]], 20)
    assert len(mesh.vertices) > 500
    turns = Rotation.from_quat(np.insert(mesh.vertices, 3, 1.0, axis=1))
    result = ROBOT.direct_singularity(PLACE, turns)
    assert np.all(result.vanishing()["orientation"])


def test_wrist_normals_are_perpendicular_to_the_central_limb() -> None:
    normals = orientation_locus(ROBOT, PLACE).wrist_normals(np.linspace(0.0, 6.0, 9))
    assert np.allclose(normals @ PLACE, 0.0, atol=1e-15)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)
    assert np.linalg.matrix_rank(normals) == 2
    with pytest.raises(InputError, match="C at O"):
        orientation_locus(ROBOT, np.zeros(3)).wrist_normals(0.0)


# Inverse ------------------------------------------------------------------------------------


def test_inverse_loci_are_where_the_factors_vanish() -> None:
    rng = np.random.default_rng(8)
    rotation = random_rotation(rng)
    locus = inverse_locus(ROBOT, rotation)
    directions = platform_directions(rotation)
    assert np.allclose(locus.incidence, (directions * BASE_AXES).sum(axis=1))
    on_axis = ROBOT.inverse_singularity(1.3 * locus.axis, rotation)
    assert on_axis.vanishing()["central"]
    place = random_position(rng)
    place = place - (locus.wrist[1:] @ place) / 0.75 * locus.wrist[1:]
    assert ROBOT.inverse_singularity(place, rotation).vanishing()["wrist"]
    for i in range(3):
        place = locus.points[i] + 0.6 * locus.directions[i]
        assert abs(ROBOT.inverse_displacement(place, rotation)[i]) <= 1e-15


# Refusals -----------------------------------------------------------------------------------

LOCUS = direct_locus(ROBOT, TILTED)


@pytest.mark.parametrize(
    ("call", "rule"),
    [
        (lambda: direct_locus(ROBOT, 2.0 * np.eye(3)), "rotation: not a rotation"),
        (lambda: direct_locus(ROBOT, np.array([np.eye(3)])), r"rotation: shape \(3, 3\)"),
        (
            lambda: direct_locus(kleinform.UncoupledManipulator([1.0, 2.0]), np.eye(3)),
            "radius: one number",
        ),
        (lambda: orientation_locus(ROBOT, [[0.0, 0.0, 1.0]]), r"position: shape \(3,\)"),
        (lambda: orientation_locus(ROBOT, [0.0, np.nan, 1.0]), "position: NaN or inf"),
        (lambda: orientation_locus(ROBOT, PLACE).value(np.zeros((3, 3))), "not a rotation"),
        (lambda: LOCUS.value([0.0, 1.0]), "position: shape"),
        (lambda: LOCUS.mesh([BOX[1], BOX[0]], 5), "low < high"),
        (lambda: LOCUS.mesh([[0, 0, 0], [1, 1, np.inf]], 5), "low < high"),
        (lambda: LOCUS.mesh(BOX, 0), "resolution: a whole number 1 to 1000"),
        (lambda: LOCUS.section(np.inf, [[0, 0], [1, 1]], 5), "z: NaN or inf"),
        (lambda: LOCUS.section(1.0, BOX, 5), "bounds: shape"),
        (lambda: LOCUS.signed_boxes(BOX, -1), "depth: a whole number 0 to 20"),
        (lambda: LOCUS.signed_boxes(BOX, 20), "depth: more than"),
        (lambda: direct_locus(ROBOT, np.eye(3)).mesh(BOX, 5), "every position is singular"),
        (
            lambda: direct_locus(ROBOT, np.eye(3)).section(1.0, [[0, 0], [1, 1]], 5),
            "every position is singular",
        ),
    ],
)
def test_bad_input_is_refused(call, rule: str) -> None:
    with pytest.raises(InputError, match=rule):
        call()
