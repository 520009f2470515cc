"""Anything that could be taken for an array, in every argument of every public call."""

from __future__ import annotations

import re
import warnings
from collections import UserList, deque
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import kleinform
from kleinform import KleinformError, NotFiniteError, ShapeError
from tests.runtime.test_errors import CALLS, parts
from tests.support import many

ROBOT = kleinform.UncoupledManipulator()
PLACE, TURN = CALLS["survey"][1]["position"], CALLS["survey"][1]["rotation"]
JOINTS = ROBOT.inverse_displacement(PLACE, TURN)
MOTION = np.arange(1.0, 7.0)
POSE = {"position": PLACE, "rotation": TURN}


def modes_of(**arguments: Any) -> np.ndarray:
    return ROBOT.forward_displacement(**arguments).rotation


#: The calls that test_errors has, and the others.
EVERY: dict[str, tuple[Callable[..., Any], dict[str, np.ndarray]]] = {
    **CALLS,
    "joint_rates": (ROBOT.joint_rates, {**POSE, "twist": MOTION}),
    "inverse_acceleration": (
        ROBOT.inverse_acceleration,
        {**POSE, "twist": MOTION, "twist_rate": MOTION},
    ),
    "forward_acceleration": (
        ROBOT.forward_acceleration,
        {**POSE, "rates": MOTION, "accelerations": MOTION},
    ),
    "platform_wrench": (ROBOT.platform_wrench, {**POSE, "forces": MOTION}),
    "actuator_forces": (ROBOT.actuator_forces, {**POSE, "wrench": MOTION}),
    "classify": (lambda **pose: ROBOT.classify(**pose).code, POSE),
    "forward_displacement": (modes_of, {"joints": JOINTS}),
    "forward_displacement_batch": (
        lambda joints: ROBOT.forward_displacement_batch(joints).rotation,
        {"joints": JOINTS[np.newaxis]},
    ),
    "track": (
        lambda **given: ROBOT.track(**given),
        {"joints": np.stack([JOINTS, JOINTS]), "start_rotation": TURN},
    ),
    "nearest": (
        lambda rotation: ROBOT.forward_displacement(JOINTS).nearest(rotation),
        {"rotation": TURN},
    ),
    "UncoupledManipulator": (
        lambda radius: kleinform.UncoupledManipulator(radius).radius,
        {"radius": np.array(1.5)},
    ),
}
ARGUMENTS = [(call, name) for call, (_, good) in EVERY.items() for name in good]


class Subclass(np.ndarray):
    """An array of somebody's own."""


class Holder:
    """Something that gives an array, whatever it is."""

    def __init__(self, value: Any) -> None:
        self.value = value

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        if isinstance(self.value, Exception):
            raise self.value
        return self.value


class WithMatrix:
    """Something like a rotation."""

    def __init__(self, value: Any) -> None:
        self.value = value

    def as_matrix(self) -> Any:
        if isinstance(self.value, Exception):
            raise self.value
        return self.value


def nested(value: Any, depth: int) -> Any:
    for _ in range(depth):
        value = [value]
    return value


def in_sequences(array: np.ndarray) -> list[Any]:
    """The entries, or the rows, in sequences; and in another order."""
    listed = array.tolist()
    return [deque(listed), UserList(listed), tuple(listed), list(array), np.asfortranarray(array)]


def same(array: np.ndarray) -> list[Any]:
    """Other ways to say the same numbers."""
    padded = np.zeros((*array.shape, 2))
    padded[..., 0] = array
    swapped = array.astype(array.dtype.newbyteorder())
    buffer = np.zeros(array.size * 8 + 1, dtype=np.uint8)[1:].view(np.float64)
    unaligned = buffer.reshape(array.shape)
    unaligned[...] = array
    return [
        array.tolist(),
        array.view(Subclass),
        padded[..., 0],
        swapped,
        unaligned,
        Holder(array),
        np.array(array, ndmin=array.ndim),
        *(in_sequences(array) if array.ndim else []),
    ]


def strange(array: np.ndarray, rng: np.random.Generator) -> list[Any]:
    """What is no array of real numbers, or may be one by chance."""
    index = tuple(int(rng.integers(size)) for size in array.shape)
    boxed, masked = array.astype(object), np.ma.array(array, mask=rng.random(array.shape) < 0.5)
    listed = array.tolist()
    odd: list[Any] = [None, "1", b"1", 1j, {}, set(), object(), Ellipsis, ..., int, np.float64]
    odd += [np.ma.masked, np.datetime64("2026-01-01"), np.timedelta64(1, "s"), 10**400, 2**64]
    odd += [float("nan"), True, [], [[]], iter([1.0]), range(3), np.zeros((0, 3)), "nan", ()]
    found: list[Any] = list(odd)
    for value in odd:
        changed = boxed.copy()
        changed[index] = value if np.ndim(value) == 0 else None
        found += [changed, changed.tolist()]
    found += [masked, [masked, masked], (masked,), deque([masked]), [[masked], [masked]]]
    found += [Holder(masked), UserList([masked]), Holder(ValueError("no")), Holder(3), Holder("x")]
    found += [np.ma.array(array), list(masked) if array.ndim else masked, Holder(OSError("no"))]
    found += [WithMatrix(value) for value in (array, masked, None, TypeError("no"), [1.0, [2.0]])]
    found += [WithMatrix, [[1.0, 2.0], [3.0]], [array, [array]], [listed, None], nested(1.0, 70)]
    found += [nested(listed, depth) for depth in (20, 30, 31, 32, 33, 40, 61, 62, 63, 64, 65)]
    found += [array.reshape((1,) * depth + array.shape) for depth in (24, 30, 31, 33, 50, 60)]
    found += [array.astype(np.longdouble), array.astype(np.complex128), array.astype("S8")]
    found += [array.astype("M8[s]"), array.astype("m8[s]"), array.astype(bool), array.astype("U8")]
    found += [array.astype([("x", "f8")]), np.rec.array(array.astype([("x", "f8")]))]
    found += [array.astype(np.float16), array.astype(np.float32), array.astype(np.int8)]
    found += [
        array.astype(np.uint64),
        [0, 1, 2**64 - 1],
        [2**63, -1, 0],
        np.array(7),
        memoryview(b"1"),
    ]
    return found


def outcome(call: str, name: str, value: Any) -> Any:
    """What comes out: the arrays, or an error of kleinform; anything else is a fault."""
    function, good = EVERY[call]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return parts(function(**{**good, name: value}))
        except KleinformError as error:
            return error


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
def test_the_same_numbers_in_other_ways(call: str, name: str, tmp_path) -> None:
    function, good = EVERY[call]
    whole = parts(function(**good))
    stored = np.memmap(tmp_path / "array", np.float64, "w+", shape=good[name].shape or (1,))
    stored[...] = good[name]
    for value in [*same(good[name]), stored if good[name].ndim else stored[0]]:
        found = outcome(call, name, value)
        assert not isinstance(found, KleinformError), value
        for one, other in zip(found, whole, strict=True):
            np.testing.assert_array_equal(one, other)


@pytest.mark.long
@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
def test_strange_values(call: str, name: str) -> None:
    """Errors of kleinform alone, that begin with the argument's name or with the leading axes."""
    rng = np.random.default_rng(16)
    wrong = []
    for _ in range(many(1, 20)):
        for value in strange(EVERY[call][1][name], rng):
            try:
                found = outcome(call, name, value)
            except BaseException as error:
                wrong.append((type(error).__name__, str(error)[:80], repr(value)[:80]))
                continue
            if has_mask(value) and not isinstance(found, KleinformError):
                wrong.append(("a mask is ignored", "", repr(value)[:80]))
    assert wrong == []


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
@pytest.mark.parametrize("width", [16, 32, 64])
def test_signalling_nan(call: str, name: str, width: int) -> None:
    """A NaN that raises a flag wherever it is touched is told like any other, without a warning."""
    array = np.array(EVERY[call][1][name], dtype=f"f{width // 8}")
    bits = {16: 0x7C01, 32: 0x7F800001, 64: 0x7FF0000000000001}[width]
    array.reshape(-1).view(f"u{width // 8}")[-1] = bits
    found = outcome(call, name, array)
    assert isinstance(found, NotFiniteError)


def has_mask(value: Any) -> bool:
    """Whether a masked array is in there somewhere."""
    if isinstance(value, (Holder, WithMatrix)):
        return has_mask(value.value)
    if isinstance(value, (list, tuple, deque, UserList)) and len(value):
        return any(map(has_mask, value))
    if isinstance(value, np.ndarray) and value.dtype == object:
        return any(map(has_mask, value.ravel().tolist()))
    return isinstance(value, np.ma.MaskedArray) or value is np.ma.masked


@pytest.mark.parametrize(("call", "name"), ARGUMENTS)
def test_too_many_axes(call: str, name: str) -> None:
    """As many as NumPy may have, and no error of NumPy's."""
    good = EVERY[call][1][name]
    for axes in range(10, 65 - good.ndim):
        found = outcome(call, name, good.reshape((1,) * axes + good.shape))
        if isinstance(found, KleinformError):
            assert isinstance(found, ShapeError)
            assert re.search(r"axes|shape", str(found))
