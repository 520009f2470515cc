"""The compiled solver beside the one on NumPy: the same modes in the same order, or none."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np
import pytest

import kleinform
from kleinform.forward.circle import Rows
from kleinform.forward.displacement import rows_of
from kleinform.forward.solve import NONE, REGULAR, Solved, by_numpy, solve
from kleinform.joints import TOLERANCE
from tests.runtime.modes_support import (
    SPREADS,
    posed,
    poses_on_the_locus,
    random_joints,
    random_poses,
    turned,
)
from tests.runtime.test_forward_degenerate import SIDE, central
from tests.support import BASE_AXES

if kleinform.backend().name != "compiled":
    pytest.skip(kleinform.backend().reason, allow_module_level=True)

from kleinform.forward import _compiled as solver

COUNT = 3000
KINDS = (*SPREADS, "joints")
#: Settled modes are 1000 sqrt(4 eps) = 3e-5 apart, and a mode this near to another is sharp
#: to some 1e-13 over the distance, as test_forward_near says.
SHARP = 1e-8


@cache
def rows_for(kind: str) -> Rows:
    rng = np.random.default_rng(90 + KINDS.index(kind))
    if kind == "joints":
        return as_rows(random_joints(rng, COUNT))
    return as_rows(random_poses(rng, COUNT, kind).joints)


def as_rows(joints: np.ndarray, radius: float = 1.0) -> Rows:
    scaled = joints * np.array([radius, radius, radius, 1.0, 1.0, radius])
    return rows_of(np.full(len(joints), radius), scaled)


def compiled(rows: Rows, tolerance: float = TOLERANCE) -> tuple[np.ndarray, ...]:
    return solver.solve(rows.radius, rows.position, rows.lengths, tolerance)


def identical(one: tuple[np.ndarray, ...], other: tuple[np.ndarray, ...]) -> bool:
    return all(a.tobytes() == b.tobytes() for a, b in zip(one, other, strict=True))


def assert_agreement(rows: Rows, tolerance: float = TOLERANCE) -> np.ndarray:
    """The compiled modes of the rows that were not left are those of NumPy; which these are."""
    count, rotation, directions, joints, extension = compiled(rows, tolerance)
    reference = by_numpy(rows, tolerance)
    number = np.bincount(reference.row, minlength=len(rows))
    settled = count >= 0
    assert np.array_equal(count[settled], number[settled])
    assert set(reference.status[settled]) <= {REGULAR, NONE}
    wanted = settled[reference.row]
    size = 1.0 + abs(reference.platform_joints[wanted]) / rows.radius[0]
    gaps = (
        abs(rotation - reference.rotation[wanted]),
        abs(directions - reference.directions[wanted]),
        abs(joints - reference.platform_joints[wanted]) / rows.radius[0] / size,
        abs(extension - reference.extension[wanted]) / rows.radius[0] / size.max(axis=2),
    )
    assert max(np.max(gap, initial=0.0) for gap in gaps) <= SHARP
    return settled


@pytest.mark.parametrize("radius", [1.0, 1e-3, 1e3])
@pytest.mark.parametrize("kind", KINDS)
def test_the_modes_of_numpy(kind: str, radius: float) -> None:
    rows = rows_for(kind)
    rows = as_rows(rows.joints[: None if radius == 1.0 else 300], radius)
    settled = assert_agreement(rows)
    assert np.mean(settled) >= 0.98


@pytest.mark.parametrize("kind", KINDS)
def test_a_power_of_two_changes_no_digit(kind: str) -> None:
    count, rotation, directions, joints, extension = compiled(rows_for(kind))
    large = compiled(as_rows(rows_for(kind).joints, 2.0**20))
    assert identical(large, (count, rotation, directions, joints * 2**20, extension * 2**20))


@pytest.mark.parametrize("kind", KINDS)
def test_all_instructions_give_the_same_bits(kind: str) -> None:
    names = [solver.instructions()]
    results = [compiled(rows_for(kind))]
    for name in ("baseline", "avx2", "avx512"):
        if name != names[0] and solver.use(name):
            assert solver.instructions() == name
            names.append(name)
            results.append(compiled(rows_for(kind)))
    assert solver.use(names[0])
    assert not solver.use("abacus")
    assert solver.instructions() == names[0]
    assert all(identical(results[0], result) for result in results[1:])


def test_a_row_is_as_it_is_alone() -> None:
    rows = as_rows(np.concatenate([rows_for(kind).joints for kind in KINDS]))
    rows = rows[np.random.default_rng(95).permutation(len(rows))]
    count, *modes = compiled(rows)
    ends = np.cumsum(np.maximum(count, 0))
    for index in range(0, len(rows), 11):
        alone = compiled(rows[index : index + 1])
        own = slice(ends[index] - max(count[index], 0), ends[index])
        assert identical(alone, (count[index : index + 1], *(entry[own] for entry in modes)))


def test_threads_do_not_disturb_one_another() -> None:
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(compiled, map(rows_for, KINDS * 3)))
    for kind, result in zip(KINDS * 3, results, strict=True):
        assert identical(result, compiled(rows_for(kind)))


@pytest.mark.parametrize("tolerance", [0.0, TOLERANCE, 1e-9])
@pytest.mark.parametrize("spread", SPREADS)
def test_near_folds(spread: str, tolerance: float) -> None:
    """Modes that may have merged are left, on either side of the fold."""
    rng = np.random.default_rng(96)
    fold, free = poses_on_the_locus(rng, 60, spread)
    assert not np.any(assert_agreement(as_rows(fold.joints), tolerance))
    for distance in (1e-7, 1e-5, 1e-4, 1e-3, 1e-2):
        # Two modes that far apart, and joint values with as much of a gap or none.
        apart = posed(fold.position, turned(fold.rotation, 0.5 * distance * free)).joints
        aside = fold.joints * (1.0 + distance**2 * rng.normal(size=fold.joints.shape))
        assert_agreement(as_rows(np.concatenate([apart, aside])), tolerance)


def special_joints() -> np.ndarray:
    """C in the plane of a leg, near it, on the circle of B; legs of length zero; C at O."""
    rng = np.random.default_rng(97)
    found = []
    for limb in range(3):
        for nudge in (0.0, 1e-12, 1e-8, 1e-5, 1e-3, 3e-3, 1e-2):
            across = rng.uniform(-0.6, 0.6) * SIDE[limb] + [0.0, 0.0, rng.uniform(0.4, 1.5)]
            position = (1.0 + nudge) * BASE_AXES[limb] + across
            lengths = rng.uniform(0.5, 2.0, 3)
            found.append([*lengths, *central(position)])
            lengths[limb] = np.linalg.norm(position - BASE_AXES[limb])
            found.append([*lengths, *central(position)])
        for short in (0.0, 1e-16, 1e-14, 1e-9, 1e-6, 1e-3):
            joints = random_joints(rng, 1)[0]
            joints[limb] = short
            found.append(joints)
    at_o = random_joints(rng, 5)
    at_o[:, 5] = 0.0
    on_axis = random_joints(rng, 5)
    on_axis[:, 4] = 0.5 * np.pi
    return np.concatenate([found, at_o, on_axis, np.zeros((1, 6))])


def test_special_rows_are_left_or_agree() -> None:
    joints = special_joints()
    settled = assert_agreement(as_rows(joints))
    assert not np.any(settled[np.any(joints[:, :3] == 0.0, axis=1)])


def test_rows_that_are_left_come_in_their_places() -> None:
    """Half of the rows of each kind, and all of them as NumPy has them."""
    rng = np.random.default_rng(98)
    joints = np.concatenate([special_joints(), random_joints(rng, 100)])
    rows = as_rows(joints[rng.permutation(len(joints))])
    both, reference = solve(rows, TOLERANCE), by_numpy(rows, TOLERANCE)
    assert np.any(compiled(rows)[0] < 0)
    assert np.any(compiled(rows)[0] >= 0)
    for name in ("row", "multiplicity", "status"):
        assert np.array_equal(getattr(both, name), getattr(reference, name))
    assert np.max(abs(both.directions - reference.directions)) <= SHARP


def test_no_rows() -> None:
    rows = rows_for("joints")[:0]
    shapes = [entry.shape for entry in compiled(rows)]
    assert shapes == [(0,), (0, 3, 3), (0, 3, 3), (0, 3, 3), (0, 3)]
    nothing = solve(rows, TOLERANCE)
    assert isinstance(nothing, Solved)
    assert len(nothing.row) == len(nothing.status) == 0


@pytest.mark.parametrize("odd", [np.nan, np.inf, -np.inf, 1e200, 1e-200, 5e-324, -1.0])
def test_odd_numbers_are_left(odd: float) -> None:
    """They are refused before; here they must not hang, nor touch the rows beside them."""
    rows = rows_for("workspace")[:90]
    radius, position, lengths = (
        entry.copy() for entry in (rows.radius, rows.position, rows.lengths)
    )
    radius[0:90:9] = position[1:90:9, 0] = lengths[2:90:9, 1] = odd
    count = solver.solve(radius, position, lengths, TOLERANCE)[0]
    touched = np.isin(np.arange(90) % 9, [0, 1, 2])
    if not np.isfinite(odd):
        assert np.all(count[touched] < 0)
    assert np.array_equal(count[~touched], compiled(rows)[0][~touched])


def test_arrays_of_any_layout_and_of_wrong_shapes() -> None:
    rows = rows_for("workspace")[:50]
    radius = np.broadcast_to(1.0, (50,))
    position, lengths = (np.asfortranarray(entry) for entry in (rows.position, rows.lengths))
    assert identical(solver.solve(radius, position, lengths, TOLERANCE), compiled(rows))
    for wrong in (
        (1.0, rows.position, rows.lengths),
        (rows.radius, rows.position[:10], rows.lengths),
        (rows.radius, rows.position, rows.lengths[:, :2]),
    ):
        with pytest.raises(ValueError, match="are needed"):
            solver.solve(*wrong, TOLERANCE)


def test_threads_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kleinform.forward.solve.PART", 64)
    rows = as_rows(np.concatenate([rows_for(kind).joints[:300] for kind in KINDS]))
    results = []
    for count in (1, 2, 3):
        kleinform.set_threads(count)
        results.append(tuple(solve(rows, TOLERANCE)))
    kleinform.set_threads(None)
    assert all(identical(results[0], other) for other in results[1:])
