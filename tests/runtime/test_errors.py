"""Bad input, one at a time, for every public call."""

from __future__ import annotations

import copy
import pickle
import re
from collections.abc import Callable

import numpy as np
import pytest

import kleinform
from kleinform import (
    DtypeError,
    GeneratedCodeError,
    InputError,
    JointRangeError,
    KleinformError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    SingularPoseError,
    TrackingError,
    UncoupledManipulator,
    rotation_from_directions,
    rotation_from_rpy,
    rpy_from_rotation,
)

ROBOT = UncoupledManipulator()
PLACE = np.array([0.25, 0.2, 1.0])
TURN = rotation_from_rpy(roll=np.deg2rad(10.0), pitch=np.deg2rad(3.0), yaw=np.deg2rad(6.0))
POSE = {"position": PLACE, "rotation": TURN}
AZIMUTH = {"azimuth": np.array(0.4)}
MOTION = np.arange(1.0, 7.0)
#: Every public call with valid arguments by name.
CALLS: dict[str, tuple[Callable, dict[str, np.ndarray]]] = {
    "inverse_displacement": (ROBOT.inverse_displacement, {**POSE, **AZIMUTH}),
    "screws": (ROBOT.screws, {**POSE, **AZIMUTH}),
    "jacobians": (ROBOT.jacobians, {**POSE, **AZIMUTH}),
    "inverse_velocity": (ROBOT.inverse_velocity, {**POSE, "twist": MOTION}),
    "forward_velocity": (ROBOT.forward_velocity, {**POSE, "rates": MOTION, **AZIMUTH}),
    "inverse_singularity": (ROBOT.inverse_singularity, POSE),
    "direct_singularity": (ROBOT.direct_singularity, POSE),
    "survey": (ROBOT.survey, POSE),
    "rotation_from_rpy": (
        rotation_from_rpy,
        {"roll": np.array(0.1), "pitch": np.array(0.2), "yaw": np.array(0.3)},
    ),
    "rpy_from_rotation": (rpy_from_rotation, {"rotation": TURN}),
    "rotation_from_directions": (
        rotation_from_directions,
        {"n1": TURN[:, 0], "n2": TURN @ [-0.5, np.sqrt(0.75), 0.0]},
    ),
}
CORES = {"position": 1, "twist": 1, "rates": 1, "n1": 1, "n2": 1, "rotation": 2}
ARGUMENTS = [(call, name) for call, (_, good) in CALLS.items() for name in good]
ROTATIONS = [(call, name) for call, name in ARGUMENTS if name == "rotation"]


def run(call: str, **changes: object) -> object:
    function, good = CALLS[call]
    return function(**{**good, **changes})


def parts(result: object) -> list[np.ndarray]:
    """The arrays that a call returned."""
    if isinstance(result, (kleinform.Singularity, kleinform.Survey)):
        found = [*result.factors.values(), *result.scales.values()]
        named = ("determinant", "joints", "extension", "inverse_determinant", "direct_determinant")
        return found + [getattr(result, name) for name in named if hasattr(result, name)]
    return list(result) if isinstance(result, tuple) else [result]


def batch_of(call: str) -> dict[str, np.ndarray]:
    """Five times the valid arguments."""
    return {name: np.stack([value] * 5) for name, value in CALLS[call][1].items()}


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_numbers_that_are_not_finite(call: str, name: str, bad: float) -> None:
    """In each entry of each argument: an error, or a row of NaN and the others untouched."""
    good = CALLS[call][1][name]
    for index in np.ndindex(good.shape):
        single = good.copy()
        single[index] = bad
        with pytest.raises(NotFiniteError, match=rf"^{name}: NaN or inf; .* arrived$") as caught:
            run(call, **{name: single})
        assert caught.value.mask.tolist() is True
        batch = batch_of(call)
        batch[name][(3, *index)] = bad
        with pytest.raises(NotFiniteError, match=rf"^{name}: .* first at pose 3; 1 of 5 poses$"):
            run(call, **batch)
        check_blanked(run(call, **batch, errors="nan"), run(call, **batch_of(call)), [3])


def check_blanked(result: object, regular: object, rows: list[int]) -> None:
    """NaN in these rows, in all entries; every other row to the bit."""
    for part, whole in zip(parts(result), parts(regular), strict=True):
        keep = np.setdiff1d(np.arange(len(whole)), rows)
        assert np.isnan(part[rows]).all()
        assert np.array_equal(part[keep], whole[keep])
    if hasattr(result, "valid"):
        assert np.flatnonzero(~result.valid).tolist() == rows
        assert not any(mask[rows].any() for mask in result.vanishing().values())


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
@pytest.mark.parametrize("kind", [bool, complex, str, bytes, object, np.longdouble, "M8[s]"])
def test_dtypes_that_are_not_real(call: str, name: str, kind: object) -> None:
    wrong = np.ones(CALLS[call][1][name].shape, dtype=np.int64).astype(kind)
    for errors in ("raise", "nan"):
        arrived = re.escape(f"{wrong.dtype} arrived")
        with pytest.raises(DtypeError, match=rf"^{name}: real numbers .* {arrived}$"):
            run(call, **{name: wrong}, errors=errors)


@pytest.mark.parametrize(("call", "name"), [pair for pair in ARGUMENTS if pair[1] in CORES])
def test_shapes(call: str, name: str) -> None:
    good = CALLS[call][1][name]
    longer = np.concatenate([good, good[..., :1]], axis=-1)
    for wrong in (longer, good[..., :-1], np.array(1.0), np.zeros(0)):
        for errors in ("raise", "nan"):
            with pytest.raises(ShapeError) as caught:
                run(call, **{name: wrong}, errors=errors)
            assert f"{name}: shape (..., 3" in str(caught.value) or name in ("twist", "rates")
            assert f"{wrong.shape} arrived" in str(caught.value)


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
def test_ragged_lists(call: str, name: str) -> None:
    with pytest.raises(ShapeError, match=f"^{name}: not an array"):
        run(call, **{name: [[1.0, 2.0], [3.0]]})


@pytest.mark.parametrize(
    ("call", "name"), [pair for pair in ARGUMENTS if len(CALLS[pair[0]][1]) > 1]
)
def test_leading_axes_that_do_not_broadcast(call: str, name: str) -> None:
    batch = batch_of(call)
    with pytest.raises(ShapeError, match=rf"^leading axes do not broadcast: .*{name} \(3,\)"):
        run(call, **{**batch, name: batch[name][:3]})


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("errors", ["bogus", None, True, "", "ignore"])
def test_unknown_ways_with_errors(call: str, errors: object) -> None:
    with pytest.raises(InputError, match=r'errors: "raise" or "nan" is needed, .* arrived'):
        run(call, errors=errors)


@pytest.mark.parametrize(("call", "name"), ROTATIONS)
@pytest.mark.parametrize(
    "wrong",
    [
        -TURN,
        TURN @ np.diag([1.0, 1.0, -1.0]),
        TURN[[1, 0, 2]],
        2.0 * TURN,
        (1.0 + 1e-8) * TURN,
        TURN + 1e-7 * np.eye(3),
        np.zeros((3, 3)),
        np.ones((3, 3)),
    ],
    ids=["−R", "mirror", "swap", "double", "longer", "shifted", "zero", "one"],
)
def test_matrices_that_are_no_rotations(call: str, name: str, wrong: np.ndarray) -> None:
    with pytest.raises(NotARotationError, match=r"^rotation: not a rotation \(.* arrived$"):
        run(call, **{name: wrong})
    batch = batch_of(call)
    batch[name][[1, 4]] = wrong
    with pytest.raises(NotARotationError, match=r"arrived, first at pose 1; 2 of 5 poses$") as one:
        run(call, **batch)
    assert np.flatnonzero(one.value.mask).tolist() == [1, 4]
    check_blanked(run(call, **batch, errors="nan"), run(call, **batch_of(call)), [1, 4])


@pytest.mark.parametrize(("call", "name"), ROTATIONS)
def test_single_precision_rotations(call: str, name: str) -> None:
    """Judged by what float32 can hold; the same numbers as float64 are no rotation."""
    single = TURN.astype(np.float32)
    assert all(np.isfinite(part).all() for part in parts(run(call, **{name: single})))
    with pytest.raises(NotARotationError, match="may be 1e-09"):
        run(call, **{name: single.astype(np.float64)})
    with pytest.raises(NotARotationError, match="may be 2e-06"):
        run(call, **{name: single * np.float32(1.0 + 1e-5)})


@pytest.mark.parametrize("call", CALLS)
def test_several_kinds_of_bad_rows(call: str) -> None:
    """With errors="nan" the rows of all broken rules are blanked together."""
    batch = batch_of(call)
    first, last = next(iter(batch)), list(batch)[-1]
    batch[first][0] = np.nan
    batch[last][2] = np.inf
    check_blanked(run(call, **batch, errors="nan"), run(call, **batch_of(call)), [0, 2])


@pytest.mark.parametrize("call", CALLS)
def test_inputs_are_not_changed(call: str) -> None:
    batch = batch_of(call)
    for name in batch:
        batch[name][1] = np.nan
    before = {name: value.copy() for name, value in batch.items()}
    run(call, **batch, errors="nan")
    for name, value in batch.items():
        assert np.array_equal(value, before[name], equal_nan=True)


@pytest.mark.parametrize(
    ("radius", "error"),
    [
        (0.0, InputError),
        (-1.0, InputError),
        ([1.0, 0.0], InputError),
        (np.nan, NotFiniteError),
        (np.inf, NotFiniteError),
        ("1", DtypeError),
        (True, DtypeError),
        (1j, DtypeError),
        (None, DtypeError),
        ([[1.0], [1.0, 2.0]], ShapeError),
    ],
)
def test_radii(radius: object, error: type[KleinformError]) -> None:
    with pytest.raises(error, match=r"^radius: "):
        UncoupledManipulator(radius)


@pytest.mark.parametrize("rounding", [-1.0, np.nan, np.inf, "16", None, 1j, [1.0, 2.0]])
def test_roundings(rounding: object) -> None:
    with pytest.raises(InputError, match=r"^rounding: "):
        UncoupledManipulator(rounding=rounding)


def test_errors_are_also_pythons() -> None:
    """So that callers who know ValueError and TypeError alone can catch them."""
    for error in (ShapeError, DtypeError, NotFiniteError, NotARotationError, JointRangeError):
        assert issubclass(error, InputError)
    assert issubclass(InputError, ValueError)
    assert issubclass(DtypeError, TypeError)
    for error in (SingularPoseError, TrackingError, GeneratedCodeError):
        assert issubclass(error, KleinformError)
        assert not issubclass(error, ValueError)
    public = [getattr(kleinform, name) for name in kleinform.__all__ if name.endswith("Error")]
    assert all(issubclass(error, KleinformError) for error in public)
    assert KleinformError("text").mask is None


def test_names_of_the_package() -> None:
    assert sorted(kleinform.__all__) == kleinform.__all__
    assert all(hasattr(kleinform, name) for name in kleinform.__all__)
    name = "bogus"
    with pytest.raises(AttributeError, match="has no attribute 'bogus'"):
        getattr(kleinform, name)
    assert repr(ROBOT) == "UncoupledManipulator(radius=1.0, rounding=16.0)"


def test_copies_of_a_manipulator_are_read_only() -> None:
    robot = kleinform.UncoupledManipulator([1.0, 2.0])
    for other in (copy.deepcopy(robot), pickle.loads(pickle.dumps(robot))):
        assert np.array_equal(other.radius, robot.radius)
        with pytest.raises(ValueError, match="read-only"):
            other.radius[0] = -5.0
