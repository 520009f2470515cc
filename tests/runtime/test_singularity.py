"""Determinants and factors against NumPy and against the mechanism's points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

from kleinform import InputError, UncoupledManipulator
from tests.runtime.poses import POLARITY, cases, limb_of, regular_cases
from tests.support import EPS, Case, platform_directions

LIMBS = (0, 1, 2)
#: What solving 4×4 systems for the points of a regular pose may lose.
POINTS = 1e-11


def units(case: Case) -> tuple[UncoupledManipulator, tuple[np.ndarray, np.ndarray]]:
    return UncoupledManipulator(case.radius), (case.position, case.rotation)


def determinant_rounding(matrix: np.ndarray) -> float:
    """LU with partial pivoting of order six: a modest number of eps of Hadamard's bound."""
    return 36.0 * EPS * float(np.prod(np.linalg.norm(matrix, axis=0)))


@given(regular_cases())
def test_determinants_are_those_of_the_jacobians(case: Case) -> None:
    robot, pose = units(case)
    # In radii, where Hadamard's bound does not mix units.
    unit = (case.position / case.radius, case.rotation)
    forward, inverse = UncoupledManipulator(1.0).jacobians(*unit)
    direct = robot.direct_singularity(*pose).determinant / case.radius**3
    indirect = robot.inverse_singularity(*pose).determinant / case.radius**2
    assert abs(direct - np.linalg.det(forward)) <= determinant_rounding(forward)
    assert abs(indirect - np.linalg.det(inverse)) <= determinant_rounding(inverse)


@given(regular_cases())
def test_inverse_determinant_is_the_product_of_its_factors(case: Case) -> None:
    robot, pose = units(case)
    result = robot.inverse_singularity(*pose)
    assert list(result.factors) == ["limb_1", "limb_2", "limb_3", "central", "wrist"]
    product = np.prod([float(factor) for factor in result.factors.values()])
    assert result.determinant == pytest.approx(product, rel=16.0 * EPS)


@given(regular_cases())
def test_direct_determinant_is_the_product_of_its_factors(case: Case) -> None:
    robot, pose = units(case)
    result = robot.direct_singularity(*pose)
    names = ["extension_1", "extension_2", "extension_3", "orientation", "wrist"]
    assert list(result.factors) == names
    limbs = [limb_of(case, i) for i in LIMBS]
    spans = np.prod([np.linalg.norm(limb.foot - limb.platform) for limb in limbs])
    product = -np.prod([float(factor) for factor in result.factors.values()]) / spans
    assert result.determinant == pytest.approx(product, rel=POINTS)


@given(regular_cases())
def test_factors_are_what_their_names_say(case: Case) -> None:
    robot, pose = units(case)
    survey = robot.survey(*pose)
    limbs = [limb_of(case, i) for i in LIMBS]
    for i, limb in enumerate(limbs):
        away = limb.platform - case.position
        assert survey.extension[i] == pytest.approx(away @ limb.direction, rel=POINTS)
        assert survey.factors[f"extension_{i + 1}"] == survey.extension[i]
        leg = np.linalg.norm(limb.platform - limb.base)
        span = np.linalg.norm(limb.foot - limb.platform)
        assert survey.factors[f"limb_{i + 1}"] == pytest.approx(-leg / span, rel=POINTS)
    moments = [np.cross(limb.direction, limb.foot - case.position) for limb in limbs]
    assert survey.factors["orientation"] == pytest.approx(np.linalg.det(moments), rel=100 * POINTS)
    n1, n2, _ = platform_directions(case.rotation)
    central = case.position / np.linalg.norm(case.position)
    assert survey.factors["wrist"] == pytest.approx(np.cross(n1, n2) @ central, rel=16.0 * EPS)
    elevation, length = survey.joints[4:]
    assert survey.factors["central"] == pytest.approx(length**2 * np.cos(elevation), rel=16 * EPS)


@given(cases())
def test_survey_is_the_other_analyses_in_one(case: Case) -> None:
    """For any pose, singular ones among them: none of the three raises."""
    robot, pose = units(case)
    survey = robot.survey(*pose)
    inverse, direct = robot.inverse_singularity(*pose), robot.direct_singularity(*pose)
    assert_near(survey.inverse_determinant, inverse.determinant)
    assert_near(survey.direct_determinant, direct.determinant)
    assert set(survey.factors) == set(inverse.factors) | set(direct.factors)
    for part in (inverse, direct):
        for name, factor in part.factors.items():
            assert_near(survey.factors[name], factor)
            assert_near(survey.scales[name], part.scales[name])
    assert bool(survey.valid)


def assert_near(left: float, right: float) -> None:
    """Equal but for how products are grouped; inf and NaN only together."""
    assert np.allclose(left, right, rtol=16.0 * EPS, atol=0.0, equal_nan=True)


@given(cases())
def test_scales_bound_their_factors(case: Case) -> None:
    """A scale is the size of the terms that a factor is a sum of."""
    robot, pose = units(case)
    survey = robot.survey(*pose)
    for name, factor in survey.factors.items():
        if np.isfinite(factor):
            assert abs(factor) <= survey.scales[name] * (1.0 + 16.0 * EPS)


def klein_size(one: np.ndarray, other: np.ndarray) -> float:
    """The size of the two scalar products that the Klein form of two screws adds."""
    (primal, dual), (primal_2, dual_2) = (
        np.linalg.norm(screw.reshape(2, 3), axis=1) for screw in (one, other)
    )
    return float(primal * dual_2 + dual * primal_2)


@given(regular_cases())
def test_the_lines_are_reciprocal_to_all_passive_screws(case: Case) -> None:
    """S_i, a column of J_v, meets or is parallel to every passive axis of its limb."""
    robot, pose = units(case)
    screws, (forward, inverse) = robot.screws(*pose), robot.jacobians(*pose)
    for i in LIMBS:
        limb, line = limb_of(case, i), forward[:, i]
        along = (limb.foot - limb.platform) / np.linalg.norm(limb.foot - limb.platform)
        moment = np.cross(along, case.position - limb.platform)
        expected = np.array([*along, *moment / case.radius])
        assert np.max(np.abs(line / ([1.0] * 3 + [case.radius] * 3) - expected)) <= POINTS
        powers = screws[i] @ POLARITY @ line
        sizes = np.array([klein_size(screw, line) for screw in screws[i]])
        powers[1] -= inverse[i, i]
        assert np.all(np.abs(powers) <= 64.0 * EPS * sizes)


@given(regular_cases())
def test_block_structure_of_the_inverse_jacobian(case: Case) -> None:
    """J_q is diagonal in the outer limbs and couples the central limb with itself alone."""
    robot, pose = units(case)
    forward, inverse = robot.jacobians(*pose)
    central = robot.screws(*pose).central
    assert np.all(inverse[:3, 3:] == 0.0)
    assert np.all(inverse[3:, :3] == 0.0)
    assert np.count_nonzero(inverse[:3, :3] - np.diag(np.diag(inverse[:3, :3]))) == 0
    assert np.array_equal(forward[:, 3:].T, central[3:])
    sizes = np.abs(central[3:]) @ POLARITY @ np.abs(central[:3].T)
    gap = inverse[3:, 3:] - central[3:] @ POLARITY @ central[:3].T
    assert np.all(np.abs(gap) <= 16.0 * EPS * sizes)


def test_screw_by_limb_and_joint() -> None:
    rng = np.random.default_rng(1)
    place, turn = rng.normal(size=(4, 3)), np.eye(3)
    screws = UncoupledManipulator().screws(place, turn)
    for limb, rows in enumerate((screws.limb_1, screws.limb_2, screws.limb_3, screws.central), 1):
        assert rows.shape == (4, 6, 6)
        for joint in range(1, 7):
            assert np.array_equal(screws.screw(limb, joint), rows[:, joint - 1])
    for limb, joint in ((0, 1), (5, 1), (1, 0), (1, 7)):
        with pytest.raises(InputError, match=f"limb {limb}, joint {joint} arrived"):
            screws.screw(limb, joint)


@pytest.mark.parametrize("lead", [(), (1,), (4,), (2, 3), (0,)])
def test_results_have_the_shape_of_the_batch(lead: tuple[int, ...]) -> None:
    place = np.full((*lead, 3), 0.5)
    robot = UncoupledManipulator()
    survey = robot.survey(place, np.eye(3))
    assert survey.joints.shape == (*lead, 6)
    assert survey.extension.shape == (*lead, 3)
    arrays = [survey.inverse_determinant, survey.direct_determinant, survey.valid]
    arrays += [*survey.factors.values(), *survey.scales.values(), *survey.vanishing().values()]
    assert {np.shape(array) for array in arrays} == {lead}
    assert robot.inverse_singularity(place, np.eye(3)).valid.shape == lead
    assert robot.direct_singularity(place, np.eye(3)).valid.all()
