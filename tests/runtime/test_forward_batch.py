"""Many joint values at once: each row as it is alone, whatever the rows beside it."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import (
    AssemblyModes,
    AssemblyModesBatch,
    DtypeError,
    InputError,
    JointRangeError,
    NotFiniteError,
    ShapeError,
    UncoupledManipulator,
)
from tests.runtime.modes_support import SPREADS, random_joints, random_poses, statuses
from tests.runtime.test_forward_modes import ARRAYS, START
from tests.support import EPS

ROBOT = UncoupledManipulator()
FLAT = ARRAYS[2:]
#: Rows that are refused, and why.
BAD = {
    "nan": (0, np.nan, NotFiniteError),
    "infinite": (3, np.inf, NotFiniteError),
    "too large": (3, 1e200, InputError),
    "negative": (1, -1e-3, JointRangeError),
    "steep": (4, 1.6, JointRangeError),
}


def mixed(count: int = 40) -> np.ndarray:
    """Random poses, joint values of no pose, and special ones in between."""
    rng = np.random.default_rng(13)
    parts = [random_poses(rng, count, spread).joints for spread in SPREADS]
    identity = ROBOT.inverse_displacement(rng.normal(size=(5, 3)), np.eye(3))
    zero = np.zeros((2, 6))
    joints = np.concatenate([*parts, random_joints(rng, count), identity, zero])
    return joints[rng.permutation(len(joints))]


def alike(one: AssemblyModes, other: AssemblyModes) -> bool:
    """The same modes in the same order, up to how matrix products of other sizes round."""
    facts = ("joints", "position", "multiplicity", "status", "degenerate", "tolerance")
    if not all(np.array_equal(getattr(one, name), getattr(other, name)) for name in facts):
        return False
    size = 1.0 + abs(other.platform_joints)
    gaps = [abs(one.rotation - other.rotation), abs(one.directions - other.directions)]
    gaps += [abs(one.platform_joints - other.platform_joints) / size]
    return all(np.max(gap, initial=0.0) <= 1e-9 for gap in gaps)


def all_alike(one: AssemblyModesBatch, other: AssemblyModesBatch) -> bool:
    return len(one) == len(other) and all(
        alike(one[index], other[index]) for index in range(len(one))
    )


def test_rows_are_those_of_single_calls() -> None:
    joints = mixed()
    batch = ROBOT.forward_displacement_batch(joints)
    assert {"regular", "merged", "none"} <= {name for name, n in statuses(batch).items() if n}
    for index, row in enumerate(joints):
        assert alike(batch[index], ROBOT.forward_displacement(row))
    assert alike(batch[-1], batch[len(joints) - 1])
    for index in (len(joints), -len(joints) - 1):
        with pytest.raises(IndexError):
            batch[index]


def test_offsets() -> None:
    joints = mixed()
    batch = ROBOT.forward_displacement_batch(joints)
    assert len(batch) == len(joints)
    assert batch.offsets.shape == (len(joints) + 1,)
    assert batch.offsets[0] == 0
    assert np.array_equal(np.diff(batch.offsets), batch.count)
    assert np.array_equal(batch.count, [len(batch[index]) for index in range(len(batch))])
    for name in FLAT:
        assert len(getattr(batch, name)) == batch.offsets[-1]
    assert batch.status_codes.shape == (len(joints),)
    assert batch.degenerate_codes.shape == (len(joints), 7)
    assert batch.position.shape == (len(joints), 3)
    assert batch.tolerance == 4.0 * EPS


def test_the_order_of_rows_does_not_matter() -> None:
    joints = mixed()
    batch = ROBOT.forward_displacement_batch(joints)
    order = np.random.default_rng(1).permutation(len(joints))
    other = ROBOT.forward_displacement_batch(joints[order])
    assert all(alike(other[new], batch[old]) for new, old in enumerate(order))


@pytest.mark.parametrize("why", BAD)
def test_bad_rows(why: str) -> None:
    """They alone are refused."""
    joint, value, error = BAD[why]
    joints = mixed()
    batch = ROBOT.forward_displacement_batch(joints)
    broken, rows = joints.copy(), [3, 50]
    broken[rows, joint] = value
    with pytest.raises(error, match=rf"first at pose 3; 2 of {len(joints)} poses") as caught:
        ROBOT.forward_displacement_batch(broken)
    assert np.flatnonzero(caught.value.mask).tolist() == rows
    other = ROBOT.forward_displacement_batch(broken, errors="nan")
    for index in range(len(joints)):
        if index in rows:
            assert other[index].status == "invalid"
            assert other[index].reason == "the joint values were refused"
            assert len(other[index]) == 0
            assert np.isnan(other[index].position).all()
            assert other[index].degenerate == ()
        else:
            assert alike(other[index], batch[index])


def test_only_bad_rows_and_no_rows() -> None:
    nothing = ROBOT.forward_displacement_batch(np.empty((0, 6)))
    assert len(nothing) == 0
    assert nothing.offsets.tolist() == [0]
    assert nothing.rotation.shape == (0, 3, 3)
    assert nothing.extension.shape == (0, 3)
    invalid = ROBOT.forward_displacement_batch(np.full((3, 6), np.nan), errors="nan")
    assert statuses(invalid)["invalid"] == 3
    assert invalid.offsets.tolist() == [0, 0, 0, 0]
    with pytest.raises(InputError, match="errors: "):
        ROBOT.forward_displacement_batch(START[np.newaxis], errors="ignore")


def test_a_radius_for_each_row() -> None:
    rng = np.random.default_rng(3)
    joints = mixed()
    radius = 10.0 ** rng.uniform(-3.0, 3.0, len(joints))
    batch = UncoupledManipulator(radius).forward_displacement_batch(joints)
    for index, own in enumerate(radius):
        assert alike(batch[index], UncoupledManipulator(own).forward_displacement(joints[index]))
    with pytest.raises(ShapeError, match=r"one radius .* see forward_displacement_batch"):
        UncoupledManipulator(radius).forward_displacement(joints[0])
    with pytest.raises(ShapeError, match="leading axes do not broadcast"):
        UncoupledManipulator(radius).forward_displacement_batch(joints[:-1])
    with pytest.raises(ShapeError, match=r"radius: shape \(\) or \(N,\) is needed"):
        UncoupledManipulator(radius[:, np.newaxis]).forward_displacement_batch(joints)
    with pytest.raises(ShapeError, match=r"radius: shape \(\) or \(N,\) is needed"):
        UncoupledManipulator(radius).forward_displacement_batch(joints[:1])


def test_arrays_of_other_kinds() -> None:
    joints = mixed(10)
    batch = ROBOT.forward_displacement_batch(joints)
    frozen = joints.copy()
    frozen.setflags(write=False)
    spread = np.zeros((2 * len(joints), 12))
    spread[::2, ::2] = joints
    for given in (frozen, spread[::2, ::2], np.asfortranarray(joints), joints.tolist()):
        assert all_alike(ROBOT.forward_displacement_batch(given), batch)
    single = joints.astype(np.float32)
    single[:, 4] = np.clip(single[:, 4], -1.57, 1.57)
    wide = ROBOT.forward_displacement_batch(single.astype(np.float64))
    assert all_alike(ROBOT.forward_displacement_batch(single), wide)
    whole = np.array([[1, 2, 1, 0, 1, 2], [0, 0, 0, 0, 0, 0], [2, 2, 2, 1, -1, 3]])
    wide = ROBOT.forward_displacement_batch(whole.astype(np.float64))
    assert all_alike(ROBOT.forward_displacement_batch(whole), wide)
    for kind in (complex, object, bool):
        with pytest.raises(DtypeError, match="joints: "):
            ROBOT.forward_displacement_batch(joints.astype(kind))
    with pytest.raises(ShapeError, match=r"joints: shape \(N, 6\) is needed"):
        ROBOT.forward_displacement_batch(START)


def test_what_arrived_is_not_changed() -> None:
    joints = mixed(10)
    given = joints.copy()
    batch = ROBOT.forward_displacement_batch(given)
    assert np.array_equal(given, joints)
    assert np.array_equal(batch.joints, joints)
