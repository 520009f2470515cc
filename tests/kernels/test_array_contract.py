"""Shapes, dtypes and blocks: a batch is its rows, whatever their layout in memory."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kleinform_kernels import _apply, uncoupled
from tests.kernels.accuracy import KERNELS, Arguments, arguments
from tests.support import EPS, random_cases

NAMES = list(KERNELS)


def rows_of(name: str, count: int, seed: int = 3) -> Arguments:
    """The inputs of a kernel for a batch of random poses."""
    rng = np.random.default_rng(seed)
    rows = [arguments(name, case, rng) for case in random_cases(rng, count)]
    return {entry: np.stack([row[entry] for row in rows]) for entry in rows[0]}


def call(name: str, values: Arguments) -> list[np.ndarray]:
    return list(getattr(uncoupled, name)(**values))


def cores(name: str) -> dict[str, int]:
    """How many trailing axes each input has."""
    return {entry.name: len(entry.shape) for entry in KERNELS[name].inputs}


def assert_same(left: list[np.ndarray], right: list[np.ndarray]) -> None:
    """Equal to the bit."""
    for one, other in zip(left, right, strict=True):
        assert one.dtype == other.dtype == np.float64
        assert one.shape == other.shape
        assert np.array_equal(one, other, equal_nan=True)


def assert_close(left: list[np.ndarray], right: list[np.ndarray]) -> None:
    """Equal to 4 ulp: vector and scalar versions of sin, cos, atan2 may differ in the last."""
    for one, other in zip(left, right, strict=True):
        assert one.shape == other.shape
        assert np.all(np.abs(one - other) <= 4.0 * EPS * np.abs(other))


@pytest.mark.parametrize("name", NAMES)
def test_shapes(name: str) -> None:
    values = rows_of(name, 12)
    for lead in ((), (1,), (12,), (3, 4), (2, 1, 6)):
        count = math.prod(lead)
        batch = {n: v[:count].reshape(lead + v.shape[1:]) for n, v in values.items()}
        for output, result in zip(KERNELS[name].outputs, call(name, batch), strict=True):
            assert result.shape == lead + output.shape
            assert result.dtype == np.float64


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_is_its_rows(name: str) -> None:
    values = rows_of(name, 9)
    together = call(name, values)
    for index in range(9):
        alone = call(name, {n: v[index] for n, v in values.items()})
        assert_close([result[index] for result in together], alone)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("lead", [(0,), (3, 0), (0, 3)])
def test_empty_batches(name: str, lead: tuple[int, ...]) -> None:
    entries = KERNELS[name].inputs
    empty = {entry.name: np.ones(lead + entry.shape) for entry in entries}
    for output, result in zip(KERNELS[name].outputs, call(name, empty), strict=True):
        assert result.shape == lead + output.shape
        assert result.dtype == np.float64


@pytest.mark.parametrize("name", [name for name in NAMES if len(cores(name)) > 1])
def test_outer_broadcast(name: str) -> None:
    """The first input as a column against the others as a row is every pair of them."""
    values = rows_of(name, 5)
    first, *others = values
    outer = {first: values[first][:, np.newaxis], **{n: values[n][np.newaxis, :4] for n in others}}
    table = call(name, outer)
    for i in range(5):
        for j in range(4):
            pair = {first: values[first][i], **{n: values[n][j] for n in others}}
            assert_close([result[i, j] for result in table], call(name, pair))


@pytest.mark.parametrize("name", [name for name in NAMES if len(cores(name)) > 1])
def test_one_input_broadcasts_against_a_batch(name: str) -> None:
    values = rows_of(name, 6)
    for single in values:
        spread = np.broadcast_to(values[single][0], values[single].shape)
        assert_close(
            call(name, {**values, single: values[single][0]}),
            call(name, {**values, single: spread}),
        )


def strided(array: np.ndarray) -> np.ndarray:
    """The same numbers, every other one of a larger array along the last axis."""
    wide = np.full((*array.shape[:-1], 2 * array.shape[-1]), np.nan)
    wide[..., ::2] = array
    return wide[..., ::2]


LAYOUTS = {
    "fortran": np.asfortranarray,
    "strided": strided,
    "negative": lambda array: array[::-1].copy()[::-1],
    "negative inside": lambda array: array[..., ::-1].copy()[..., ::-1],
    "unaligned": lambda array: (
        np.frombuffer(b"\0" + array.tobytes(), dtype=np.uint8)[1:]
        .view(np.float64)
        .reshape(array.shape)
    ),
}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_layout_in_memory_does_not_matter(name: str, layout: str) -> None:
    values = rows_of(name, 7)
    laid_out = {n: LAYOUTS[layout](v) for n, v in values.items()}
    assert_same(call(name, laid_out), call(name, values))


@pytest.mark.parametrize("name", NAMES)
def test_inputs_are_read_only(name: str) -> None:
    """Read-only inputs are accepted, and writable ones come back unchanged."""
    values = rows_of(name, 5)
    before = {n: v.copy() for n, v in values.items()}
    expected = call(name, values)
    assert all(np.array_equal(values[n], before[n]) for n in values)
    for value in values.values():
        value.flags.writeable = False
    results = call(name, values)
    assert_same(results, expected)
    for result in results:
        assert result.flags.writeable
        assert not any(np.shares_memory(result, value) for value in values.values())


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("kind", ["int64", "uint8", "float32", "float16", ">f8", "list"])
def test_other_real_numbers_are_widened(name: str, kind: str) -> None:
    values = {n: np.round(np.abs(v) * 4.0) for n, v in rows_of(name, 5).items()}
    given = {n: v.tolist() if kind == "list" else v.astype(kind) for n, v in values.items()}
    assert_same(call(name, given), call(name, values))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("kind", [bool, complex, str, object, "timedelta64[s]"])
def test_other_kinds_are_refused(name: str, kind: object) -> None:
    values = rows_of(name, 2)
    for entry in values:
        wrong = np.ones(values[entry].shape, dtype=np.int64).astype(kind)
        with pytest.raises(TypeError, match=f"{entry}: real numbers are needed"):
            call(name, {**values, entry: wrong})


@pytest.mark.parametrize("name", NAMES)
def test_wrong_trailing_axes_are_refused(name: str) -> None:
    values = rows_of(name, 4)
    for entry, core in cores(name).items():
        if core == 0:
            continue
        longer = np.concatenate([values[entry], values[entry][..., :1]], axis=-1)
        for wrong in (longer, values[entry][..., :-1], np.float64(1.0)):
            with pytest.raises(ValueError, match=f"{entry}: trailing axes"):
                call(name, {**values, entry: wrong})


@pytest.mark.parametrize("name", [name for name in NAMES if len(cores(name)) > 1])
def test_leading_axes_that_do_not_broadcast_are_refused(name: str) -> None:
    values = rows_of(name, 4)
    first = next(iter(values))
    with pytest.raises(ValueError, match="broadcast"):
        call(name, {**values, first: values[first][:3]})


@pytest.mark.parametrize("name", ["inverse_displacement", "jacobians", "survey", "central_inverse"])
def test_block_boundaries(name: str) -> None:
    """Batches around the size of a block are their rows."""
    block = _apply.BLOCK
    small = rows_of(name, 257)
    longest = 2 * block + 3
    pick = np.arange(longest) % 257
    whole = {n: v[pick] for n, v in small.items()}
    expected = [result[pick] for result in call(name, small)]
    for count in (block - 1, block, block + 1, longest):
        results = call(name, {n: v[:count] for n, v in whole.items()})
        assert_close(results, [result[:count] for result in expected])


@pytest.mark.parametrize("lead", [(3, 8193), (8193, 3), (2, 5, 4097), (3, 1, 8200)])
def test_many_leading_axes_larger_than_a_block(lead: tuple[int, ...]) -> None:
    small = rows_of("survey", 101)
    pick = np.arange(math.prod(lead)).reshape(lead) % 101
    results = call("survey", {n: v[pick] for n, v in small.items()})
    assert_close(results, [result[pick] for result in call("survey", small)])


@pytest.mark.parametrize("lead", [(), (5,), (2, 3)])
def test_constants_have_the_shape_of_the_batch(lead: tuple[int, ...]) -> None:
    """`wrist_scale` is a number, and most of J_q is zero, for every pose."""
    count = math.prod(lead)
    values = rows_of("jacobians", count)
    batch = {n: v[:count].reshape(lead + v.shape[1:]) for n, v in values.items()}
    jacobian = uncoupled.jacobians(**batch).J_q
    assert np.all(jacobian[..., :3, 3:] == 0.0)
    assert np.all(jacobian[..., 3:, :3] == 0.0)
    assert np.all(jacobian[..., 3, 5] == 1.0)
    batch.pop("heading")
    for kernel in (uncoupled.survey, uncoupled.inverse_singularity, uncoupled.direct_singularity):
        scale = kernel(**batch).wrist_scale
        assert scale.shape == lead
        assert np.all(scale == np.sqrt(0.75))


@given(st.lists(st.integers(0, 40), max_size=4), st.integers(1, 50))
def test_slabs_cover_every_pose_once_and_in_order(lead: list[int], block: int) -> None:
    indices = np.arange(math.prod(lead)).reshape(lead)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_apply, "BLOCK", block)
        pieces = [indices[slab] for slab in _apply.slabs(tuple(lead))]
    if lead:
        covered = np.concatenate([piece.ravel() for piece in pieces]) if pieces else []
        assert np.array_equal(covered, indices.ravel())
        assert all(piece.size <= block for piece in pieces)
    else:
        assert pieces == []
