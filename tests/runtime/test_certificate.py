"""The proof that all assembly modes were found."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor

import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import MissingExtraError, UncoupledManipulator, rotation_from_rpy
from kleinform.forward.certificate import Certificate, certify
from kleinform.generated import kernels
from kleinform_kernels.uncoupled import mpmath_kernels

ROBOT = UncoupledManipulator()
ROUNDING = 4.0 * float(np.finfo(np.float64).eps)
PAPER = ROBOT.inverse_displacement(
    [0.25, 0.2, 1.0],
    rotation_from_rpy(roll=np.deg2rad(10.0), pitch=np.deg2rad(3.0), yaw=np.deg2rad(6.0)),
)
TILTED = rotation_from_rpy(roll=0.2, pitch=0.3, yaw=0.5)
PAIRS, DEGREES = 32, np.arange(5)
AXES = np.exp(2j * np.pi / 3.0 * np.arange(3))


def half_tangents(tables: np.ndarray) -> np.ndarray:
    """All (t, s): eigenvalues of Sylvester's matrix in s, and Newton's method."""
    blocks = np.zeros((5, 8, 8))
    for shift in range(4):
        for row, table in ((shift, tables[0]), (4 + shift, tables[1])):
            blocks[:, row, shift : shift + 5] = table / abs(table).max()
    companion = np.eye(PAIRS, k=8)
    companion[24:] = -np.linalg.solve(blocks[4], np.hstack(list(blocks[:4])))
    t, vectors = np.linalg.eig(companion)
    largest, own = np.argmax(abs(vectors[:7]), axis=0), np.arange(PAIRS)
    found = np.stack([t, vectors[largest + 1, own] / vectors[largest, own]], axis=1)
    for _ in range(5):
        powers = found[..., np.newaxis] ** DEGREES
        slopes = DEGREES * np.insert(powers[..., :4], 0, 0.0, axis=-1)
        sides = (powers, powers), (slopes, powers), (powers, slopes)
        value, *columns = (
            np.einsum("ki,eij,kj->ke", left[:, 0], tables, right[:, 1]) for left, right in sides
        )
        step = np.linalg.solve(np.stack(columns, axis=-1), value[..., np.newaxis])[..., 0]
        found = found - step
    return found


def candidates(joints: np.ndarray, radius: float = 1.0) -> np.ndarray:
    """One (n_1, n_2) of each pair, from as many starts as it takes to find 32 pairs of legs."""
    center, rng = kernels.central_forward(joints[3:]).position, np.random.default_rng(5)
    pairs, legs = [], []
    for phases in rng.uniform(0.0, 6.0, (6, 2)):
        start = np.stack([np.cos(phases), np.sin(phases)], axis=1)
        result = kernels.circles(radius, center, joints[:3], start)
        found = half_tangents(np.array([result.angle, result.cone]))
        powers = found[..., np.newaxis] ** DEGREES[:3]
        parts = np.stack([powers[:, 0] @ result.first, powers[:, 1] @ result.second], axis=1)
        arms = parts / (1.0 + found**2)[..., np.newaxis]
        units = parts / np.sqrt(np.sum(parts**2, axis=-1, keepdims=True))
        product = np.sum(units[:, 0] * units[:, 1], axis=-1)
        units[:, 1] *= -np.sign(product.real)[:, np.newaxis]
        for unit, arm in zip(units, arms, strict=True):
            far = all(abs(arm - other).max() > 1e-9 * abs(arm).max() for other in legs)
            if far and len(pairs) < PAIRS:
                pairs.append(unit)
                legs.append(arm)
    return np.array(pairs)


def certified(joints: np.ndarray, tolerance: float = 0.0) -> Certificate:
    return certify(1.0, joints, tolerance, candidates(joints))


def random_pose(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    roll, pitch, yaw = rng.uniform(-1.2, 1.2, 3)
    position = rng.normal([0.0, 0.0, 1.0], 0.4)
    return position, rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)


def boxes_around(certificate: Certificate, rotation: np.ndarray) -> np.ndarray:
    """Which real boxes hold the directions of a pose, up to its own rounding."""
    second = -0.5 * rotation[:, 0] + np.sqrt(0.75) * rotation[:, 1]
    pair = np.stack([rotation[:, 0], second])
    gaps = [np.max(abs(certificate.centers - own), axis=(1, 2)) for own in (pair, -pair)]
    slack = 8.0 * np.finfo(np.float64).eps
    return certificate.is_real & (np.minimum(*gaps) <= certificate.radii + slack)


@pytest.mark.parametrize("tolerance", [0.0, ROUNDING, 1e-10, 1e-7])
def test_paper(tolerance: float) -> None:
    proof = certified(PAPER, tolerance)
    assert proof.complete, proof.reason
    assert (proof.pairs, proof.real, proof.chart) == (PAIRS, 4, "directions")
    assert proof.tolerance == tolerance
    assert proof.centers.shape == (PAIRS, 2, 3)
    assert proof.radii.shape == proof.is_real.shape == (PAIRS,)
    assert np.sum(proof.is_real) == 4
    assert not proof.centers[proof.is_real].imag.any()
    assert "4 of them real" in proof.reason


def test_random_poses() -> None:
    rng = np.random.default_rng(1)
    for _ in range(30):
        position, rotation = random_pose(rng)
        joints = ROBOT.inverse_displacement(position, rotation)
        exact, rounded = certified(joints), certified(joints, ROUNDING)
        assert exact.complete, exact.reason
        assert rounded.complete, rounded.reason
        assert exact.real == rounded.real
        # The joint values are of the pose up to rounding.
        assert np.sum(boxes_around(rounded, rotation)) == 1


def newton(cones: list[mpmath.matrix], x: mpmath.matrix) -> mpmath.matrix:
    """A step of Newton's method on the six quadratics, each from its matrix."""
    rows = [(1, 0), (0, 1), (-1, -1)]
    forms = [kron(row, row, cone) for row, cone in zip(rows, cones, strict=True)]
    unit = mpmath.eye(3)
    forms += [kron(row, row, unit) for row in rows]
    slopes = [(form * x).T for form in forms]
    values = [(slope * x)[0] - number // 3 for number, slope in enumerate(slopes)]
    jacobian = mpmath.matrix([list(2 * slope) for slope in slopes])
    return x - mpmath.lu_solve(jacobian, mpmath.matrix(values))


def kron(left: tuple[int, int], right: tuple[int, int], form: mpmath.matrix) -> mpmath.matrix:
    """The matrix of n·M·n in (n_1, n_2), where n is a combination of the two."""
    return mpmath.matrix(
        [
            [one * two * form[i, j] for two in right for j in range(3)]
            for one in left
            for i in range(3)
        ]
    )


def test_boxes_hold_the_solutions_to_fifty_digits() -> None:
    proof = certified(PAPER)
    with mpmath.workdps(50):
        joints = [mpmath.mpf(value) for value in PAPER.tolist()]
        center = mpmath_kernels.central_forward(joints[3:]).position
        cones = [mpmath.matrix(cone) for cone in mpmath_kernels.cones(1.0, center, joints[:3])]
        for pair, radius in zip(proof.centers, proof.radii, strict=True):
            start = mpmath.matrix(pair.ravel().tolist())
            x = start
            for _ in range(3):
                x = newton(cones, x)
            assert max(abs(entry) for entry in x - start) <= radius <= 1e-13


def test_every_joint_vector_of_the_tolerance() -> None:
    """A wide tolerance is refused, or every joint vector in it has as many modes."""
    rng, proven = np.random.default_rng(2), 0
    for tolerance in (1e-2, 1e-4, 1e-6, 1e-6, 1e-6):
        joints = ROBOT.inverse_displacement(*random_pose(rng))
        proof = certified(joints, tolerance)
        if not proof.complete:
            assert "none is proven" in proof.reason or "meet" in proof.reason
            continue
        proven += 1
        real = proof.centers[proof.is_real]
        for _ in range(5):
            inside = joints * (1.0 + tolerance * rng.choice([-1.0, 1.0], 6))
            there = certified(inside)
            assert there.complete, there.reason
            assert there.real == proof.real
            for pair in there.centers[there.is_real]:
                gaps = [np.max(abs(real - own), axis=(1, 2)) for own in (pair, -pair)]
                near = np.minimum(*gaps) <= proof.radii[proof.is_real] + 1e-14
                assert np.sum(near) == 1
    assert proven >= 2


def test_missing_candidates_and_copies() -> None:
    found = candidates(PAPER)
    real = np.flatnonzero(abs(found.imag).max(axis=(1, 2)) <= 1e-9)
    others = np.delete(found, real[0], axis=0)
    proof = certify(1.0, PAPER, ROUNDING, others)
    assert not proof.complete
    assert (proof.pairs, proof.real) == (31, 3)
    assert "31 of 32 pairs" in proof.reason
    assert "31 candidates are not enough" in proof.reason
    for copy in (found[real[1]], -found[real[1]]):
        copied = found.copy()
        copied[real[0]] = copy
        proof = certify(1.0, PAPER, ROUNDING, copied)
        assert not proof.complete
        assert f"candidates {real[0]} and {real[1]} meet" in proof.reason
    # Copies that come with all 32 do no harm.
    assert certify(1.0, PAPER, ROUNDING, np.concatenate([found[5:10], -found])).complete


def test_a_missing_conjugate_is_known() -> None:
    """The coefficients are real: one box of a complex pair proves the other."""
    found = candidates(PAPER)
    complex_ones = np.flatnonzero(abs(found.imag).max(axis=(1, 2)) > 1e-9)
    others = np.delete(found, complex_ones[0], axis=0)
    assert certify(1.0, PAPER, ROUNDING, others).complete


def test_wrong_candidates() -> None:
    """Newton's method may lead a wrong one to the missing mode; then the proof is right."""
    rng, found = np.random.default_rng(3), candidates(PAPER)
    real = np.flatnonzero(abs(found.imag).max(axis=(1, 2)) <= 1e-9)
    undecided = 0
    for _ in range(10):
        wrong = found.copy()
        wrong[real[0]] = rng.normal(size=(2, 3)) + 1j * rng.normal(size=(2, 3))
        proof = certify(1.0, PAPER, ROUNDING, wrong)
        assert proof.real == (4 if proof.complete else 3)
        undecided += not proof.complete
    assert undecided >= 5


@pytest.mark.parametrize("bad", [np.nan, np.inf, 0.0, 1e200])
def test_useless_candidates(bad: float) -> None:
    proof = certify(1.0, PAPER, ROUNDING, np.full((PAIRS, 2, 3), bad, dtype=complex))
    assert not proof.complete
    assert proof.pairs <= 1
    assert proof.centers.shape == (proof.pairs, 2, 3)


def test_no_candidates() -> None:
    proof = certify(1.0, PAPER, ROUNDING, np.empty((0, 2, 3), dtype=complex))
    assert not proof.complete
    assert "0 candidates are not enough" in proof.reason


def test_a_double_root_is_undecided() -> None:
    joints = ROBOT.inverse_displacement([0.1, 0.2, 1.0], np.eye(3))
    proof = certified(joints, ROUNDING)
    assert not proof.complete
    assert "30 of 32 pairs" in proof.reason
    assert "the next candidate is" in proof.reason


@pytest.mark.parametrize("turn", [1e-4, 1e-5, 1e-6])
def test_modes_close_together(turn: float) -> None:
    """Opposite turns have almost the same joint values, and modes near to each other."""
    rotation = Rotation.from_rotvec([turn, turn / 2.0, 0.0]).as_matrix()
    joints = ROBOT.inverse_displacement([0.1, 0.2, 1.0], rotation)
    proof = certified(joints)
    assert proof.complete, proof.reason
    real = proof.centers[proof.is_real].reshape(-1, 6)
    gaps = np.max(abs(real[:, np.newaxis] - real), axis=-1)
    signed = np.minimum(gaps, np.max(abs(real[:, np.newaxis] + real), axis=-1))
    np.fill_diagonal(signed, np.inf)
    assert np.min(signed) <= 10.0 * turn
    assert np.max(proof.radii) <= 1e-3 * np.min(signed)


@pytest.mark.parametrize("limbs", [(0,), (1,), (0, 1), (0, 2)])
@pytest.mark.parametrize("tolerance", [0.0, ROUNDING])
def test_c_in_the_plane_of_a_leg(limbs: tuple[int, ...], tolerance: float) -> None:
    """Two modes with the same directions and different B_i: told apart on the circles."""
    rows = np.stack([AXES.real, AXES.imag], axis=1)[list(limbs)]
    place = np.linalg.lstsq(rows, np.ones(len(limbs)))[0]
    place += 0.2 * (len(limbs) == 1) * np.array([-rows[0, 1], rows[0, 0]])
    joints = ROBOT.inverse_displacement([*place, 1.0], TILTED)
    # With its own length the limb has B_i in C, and infinitely many solutions.
    assert not certified(joints, tolerance).complete
    joints[:3] *= [1.3, 1.2, 1.1]
    proof = certified(joints, tolerance)
    assert proof.complete, proof.reason
    assert proof.chart == "circles"
    closure = kernels.closure(1.0, [*place, 1.0], joints[:3], proof.centers.real)
    assert np.max(abs(closure.residual[proof.is_real])) <= 1e-12


def test_the_third_limb_in_its_plane() -> None:
    """The candidates of these tests double there; the modes themselves do not."""
    joints = ROBOT.inverse_displacement([1.0, 0.2, 1.0], TILTED)
    joints[:3] *= [1.3, 1.2, 1.1]
    first = certified(joints)
    turned = joints.copy()
    turned[:3] = joints[[1, 2, 0]]
    turned[3] -= 2.0 * np.pi / 3.0
    known = candidates(joints)
    three = np.stack([known[:, 0], known[:, 1], -known[:, 0] - known[:, 1]], axis=1)
    back = Rotation.from_euler("z", -120.0, degrees=True).as_matrix()
    proof = certify(1.0, turned, ROUNDING, three[:, [1, 2]] @ back.T)
    assert proof.complete, proof.reason
    assert (proof.real, proof.chart) == (first.real, "circles")


@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_manipulators_of_other_sizes(scale: float) -> None:
    joints = PAPER * [scale, scale, scale, 1.0, 1.0, scale]
    proof = certify(scale, joints, ROUNDING, candidates(PAPER))
    assert proof.complete, proof.reason
    assert proof.real == 4


@pytest.mark.parametrize("zeros", [[0], [0, 1, 2], [5], [0, 1, 2, 5]])
def test_lengths_of_zero(zeros: list[int]) -> None:
    joints = PAPER.copy()
    joints[zeros] = 0.0
    proof = certify(1.0, joints, ROUNDING, candidates(PAPER))
    assert not proof.complete
    assert proof.reason


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(MissingExtraError, match=r"python-flint: install kleinform\[certify\]"):
        certify(1.0, PAPER, 0.0, np.empty((0, 2, 3), dtype=complex))


def test_threads_leave_the_precision_as_it_was() -> None:
    """python-flint has one precision for the whole process."""
    from flint import ctx

    before = ctx.prec
    rng = np.random.default_rng(4)
    poses = [random_pose(rng) for _ in range(4)]

    def work(number: int) -> list[int]:
        joints = ROBOT.inverse_displacement(*poses[number])
        if number == 3:
            with pytest.raises(TypeError):
                certify(1.0, joints, None, candidates(joints))
        return [certified(joints).precision for _ in range(3)]

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(work, range(4))) == [[128] * 3] * 4
    assert ctx.prec == before
