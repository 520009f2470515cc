"""Compiled and NumPy kernels compute the same: to the bit, but for sin, cos and atan2."""

from __future__ import annotations

import numpy as np
import pytest
from sympy import atan2, cos, sin

from derivations.codegen.lower import lower
from kleinform_kernels.uncoupled import BACKEND, numpy_kernels
from tests.kernels.accuracy import KERNELS, Arguments, arguments
from tests.support import DISTANCES, EPS, NEAR, Case, random_cases, scaled

if BACKEND != "compiled":
    pytest.skip(f"the backend is {BACKEND}", allow_module_level=True)

from kleinform_kernels.uncoupled import _compiled, compiled_kernels, gufuncs

#: Results of sin, cos and atan2 differ by so many eps between NumPy and C, and by no more after
#: what little is computed from them.
MOST = 4.0 * EPS
INSTRUCTIONS = ("baseline", "avx2", "avx512")


def cases() -> list[Case]:
    """Random poses, and poses next to every kind of singular one; not a multiple of LANES."""
    rng = np.random.default_rng(11)
    near = [NEAR[family](rng, distance) for family in NEAR for distance in DISTANCES]
    poses = [*random_cases(rng, 101), *near]
    return [scaled(case, (1e-3, 1.0, 1e3)[index % 3]) for index, case in enumerate(poses)]


def batch(name: str) -> Arguments:
    rng = np.random.default_rng(12)
    rows = [arguments(name, case, rng) for case in cases()]
    return {entry: np.stack([row[entry] for row in rows]) for entry in rows[0]}


def angular(name: str) -> bool:
    """Whether a kernel calls sin, cos or atan2."""
    return any(line.expression.has(sin, cos, atan2) for line in lower(KERNELS[name]).lines)


@pytest.fixture
def instructions():
    """Any instructions may be used in a test; afterwards those from before are."""
    before = _compiled.instructions()
    yield
    _compiled.use(before)


@pytest.mark.parametrize("name", KERNELS)
def test_both_backends_agree(name: str) -> None:
    values = batch(name)
    on_numpy = getattr(numpy_kernels, name)(**values)
    compiled = getattr(compiled_kernels, name)(**values)
    assert type(on_numpy) is type(compiled)
    allowed = MOST if angular(name) else 0.0
    for field, one, other in zip(on_numpy._fields, on_numpy, compiled, strict=True):
        scale = np.max(abs(one), axis=tuple(range(1, one.ndim)), keepdims=True)
        with np.errstate(invalid="ignore"):
            bad = ~(abs(one - other) <= allowed * scale) & ~(np.isnan(one) & np.isnan(other))
        assert not np.any(bad & (one != other)), f"{name}.{field}"


@pytest.mark.parametrize("name", KERNELS)
def test_all_instructions_give_the_same_bits(name: str, instructions: None) -> None:
    """Also one pose at a time, and blocks of poses and what is left over."""
    values = batch(name)
    results = []
    for wanted in INSTRUCTIONS:
        if _compiled.use(wanted):
            assert _compiled.instructions() == wanted
            kernel = getattr(compiled_kernels, name)
            results.append(kernel(**values))
            rows = [kernel(**{k: v[i] for k, v in values.items()}) for i in range(20)]
            results.append([np.stack(parts) for parts in zip(*rows, strict=True)])
            results.append(kernel(**{k: v[3:] for k, v in values.items()}))
    assert _compiled.use("baseline")
    whole = results[0]
    for result, part in zip(results, [slice(None), slice(20), slice(3, None)] * 3, strict=False):
        for one, other in zip(whole, result, strict=True):
            assert np.array_equal(one[part], other, equal_nan=True)


def test_unknown_instructions_are_not_used(instructions: None) -> None:
    before = _compiled.instructions()
    assert not _compiled.use("mmx")
    assert _compiled.instructions() == before


def test_the_angle_is_within_three_ulp() -> None:
    """atan2 of C, in extended precision and at what is special."""
    rng = np.random.default_rng(13)
    x, y = rng.normal(size=(2, 400_000)) * 10.0 ** rng.uniform(-12, 12, size=(2, 400_000))
    y[:100_000] = x[:100_000] * np.tan(rng.uniform(-np.pi, np.pi, 100_000))
    angle = gufuncs.central_inverse(np.stack([x, y, 0.0 * x], axis=-1))[0][:, 0]
    exact = np.arctan2(y.astype(np.longdouble), x.astype(np.longdouble))
    if np.finfo(np.longdouble).eps < EPS:
        assert np.max(abs(angle - exact) / np.spacing(abs(angle))) <= 3.0
    special = np.array([0.0, -0.0, 1.0, -1.0, 1e-300, np.inf, -np.inf, np.nan])
    y, x = (entry.ravel() for entry in np.meshgrid(special, special))
    angle = gufuncs.central_inverse(np.stack([x, y, np.ones(len(x))], axis=-1))[0][:, 0]
    wanted = np.arctan2(y, x)
    np.testing.assert_allclose(angle, wanted, rtol=3.0 * EPS, atol=0.0)
    numbers = ~np.isnan(wanted)
    assert np.array_equal(np.signbit(angle[numbers]), np.signbit(wanted[numbers]))


def test_out_strides_casting_and_broadcasting() -> None:
    """What every ufunc of NumPy can do."""
    values = batch("jacobians")
    place, turn, heading = values["c"], values["R"], values["heading"]
    wanted = gufuncs.jacobians(1.0, place, turn, heading)
    out = tuple(np.full(result.shape, np.nan) for result in wanted)
    given = gufuncs.jacobians(1.0, place, turn, heading, out=out)
    assert all(one is other for one, other in zip(given, out, strict=True))
    spread = np.full((2 * len(place), 6, 7), np.nan)[::2, :, :6]
    gufuncs.jacobians(1.0, place, turn, heading, out=(spread, *out[1:]))
    turned = np.asfortranarray(np.moveaxis(turn, 0, -1))
    moved = gufuncs.jacobians(1.0, place, np.moveaxis(turned, -1, 0), heading)
    reverse = gufuncs.jacobians(1.0, place[::-1], turn[::-1], heading[::-1])
    one = gufuncs.jacobians(1.0, place[:, None], turn[4], heading[:, None])
    for index, result in enumerate(wanted):
        assert np.array_equal(result, out[index], equal_nan=True)
        assert np.array_equal(result, moved[index], equal_nan=True)
        assert np.array_equal(result[::-1], reverse[index], equal_nan=True)
        assert np.array_equal(result[4], one[index][4, 0], equal_nan=True)
    assert np.array_equal(spread, wanted[0], equal_nan=True)
    single = gufuncs.jacobians(1, place.astype(np.float32), turn.tolist(), heading)
    assert single[0].dtype == np.float64
    with pytest.raises(ValueError, match=r"broadcast|core dimension"):
        gufuncs.jacobians(1.0, turn, turn, heading)
    with pytest.raises(TypeError, match="safely coerced"):
        gufuncs.jacobians(1.0, place * 1j, turn, heading)


def test_large_results_bypass_the_caches_and_are_the_same() -> None:
    """Streamed stores need 16-byte alignment; what is not aligned is stored as usual."""
    values = {k: np.tile(v, (300,) + (1,) * (v.ndim - 1)) for k, v in batch("jacobians").items()}
    few = gufuncs.jacobians(*batch("jacobians").values())
    count = len(values["c"])
    for shift in (0, 1):
        store = np.full(36 * count + 1, np.nan)
        out = store[shift : shift + 36 * count].reshape(count, 6, 6)
        rest = [np.empty((count, *result.shape[1:])) for result in few[1:]]
        gufuncs.jacobians(*values.values(), out=(out, *rest))
        for index, result in enumerate((out, *rest)):
            rows = result.reshape(300, -1, *result.shape[1:])
            assert np.array_equal(rows[0], few[index], equal_nan=True)
            assert np.array_equal(rows[299], few[index], equal_nan=True)


def test_singular_poses_give_no_warning() -> None:
    """inf and NaN come without a floating-point error, also if the caller raises at them."""
    with np.errstate(all="raise"):
        results = gufuncs.survey(1.0, np.zeros((40, 3)), np.zeros((3, 3)))
        compiled_kernels.survey(1.0, np.zeros(3), np.zeros((3, 3)))
    assert np.isnan(results[0][:, 0]).all()


def test_a_pose_is_refused_in_the_same_words() -> None:
    """What is no single pose of float64 goes the way of batches."""
    for module in (numpy_kernels, compiled_kernels):
        with pytest.raises(ValueError, match=r"c: trailing axes \(3,\) are needed"):
            module.survey(1.0, np.zeros(4), np.eye(3))
        with pytest.raises(TypeError, match="R: real numbers are needed"):
            module.survey(1.0, np.zeros(3), np.eye(3, dtype=complex))


def test_an_output_must_be_a_tuple() -> None:
    with pytest.raises(ValueError, match="no kernel"):
        _compiled.OnePose("nothing", tuple)
    with pytest.raises(ValueError, match="no kernel"):
        _compiled.OnePose("survey", list)
