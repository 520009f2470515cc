"""Checks of arguments and of poses, over batches: raise, or mark rows and go on."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, Literal, NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import (
    DtypeError,
    InputError,
    KleinformError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
)
from kleinform.generated import kernels

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Errors = Literal["raise", "nan"]

#: The dtype that is taken as it is.
FLOAT64 = np.dtype(np.float64)
#: Largest defect of a rotation matrix: the root of its squared defects of orthonormality.
#: float32 matrices are judged by what float32 can hold.
ROTATION_TOLERANCE = 1e-9
ROTATION_TOLERANCE_FLOAT32 = 2e-6
#: Larger numbers are refused: products of three of them overflow. So are positions that are
#: smaller and not zero: their products underflow.
LARGEST = 1e100
SMALLEST = 1e-100
#: A matrix with a smaller defect is taken for a rotation that was rounded, to two digits or more.
ROUNDED = 0.01
#: More leading axes are refused: results have more axes than arguments, and some functions of
#: NumPy end at 32.
MOST_AXES = 24
#: NumPy looks no deeper into sequences, and takes texts as they are.
MOST_NESTED = 65
TEXTS = (str, bytes, bytearray, memoryview, range)


@runtime_checkable
class HasMatrix(Protocol):
    """Anything that gives its matrix, such as SciPy's Rotation."""

    def as_matrix(self) -> ArrayLike: ...


RotationLike = ArrayLike | HasMatrix


def real_array(name: str, value: ArrayLike, core: tuple[int, ...]) -> Array:
    """The value as float64, its trailing axes checked.

    Raises
    ------
    DtypeError
        It is not of real numbers (booleans, complex, objects), wider than float64, or masked.
    ShapeError
        It is ragged, or its trailing axes are not ``core``.
    """
    if type(value) is np.ndarray and value.dtype is FLOAT64 and value.shape[-len(core) :] == core:
        return value
    array = plain_array(name, value)
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise DtypeError(f"{name}: real numbers up to float64 are needed, {array.dtype} arrived")
    if array.shape[max(0, array.ndim - len(core)) :] != core:
        wanted = "(" + ", ".join(["...", *map(str, core)]) + ")"
        hint = _helper(array.shape) if core == (3, 3) else ""
        raise ShapeError(f"{name}: shape {wanted} is needed, {array.shape} arrived{hint}")
    return as_float64(array)


def as_float64(array: NDArray[Any]) -> Array:
    """The numbers as float64; a signalling NaN is one, without a warning."""
    with np.errstate(invalid="ignore"):
        return array.astype(np.float64, copy=False)


def _helper(shape: tuple[int, ...]) -> str:
    """What makes rotations (..., 3, 3) of what has such a shape, in words."""
    if shape[-2:] == (4, 4):
        return "; a pose as a matrix? kleinform.pose_from_matrix"
    if shape[-1:] == (4,):
        return "; a quaternion? kleinform.rotation_from_quaternion"
    return ""


def plain_array(name: str, value: Any) -> NDArray[Any]:
    """The value as an array without a mask.

    Raises
    ------
    DtypeError
        It has a mask, somewhere, or what it does to become an array raises.
    ShapeError
        It is ragged.
    """
    masked = DtypeError(f"{name}: a plain array is needed, a masked array arrived: fill it")
    if _has_mask(value):
        raise masked
    try:
        array = np.asanyarray(value)
    except ValueError as error:
        raise ShapeError(f"{name}: not an array: {error}") from error
    except Exception as error:  # somebody's __array__ or __getitem__ may raise anything
        raise DtypeError(f"{name}: not an array: {error!r}") from error
    if isinstance(array, np.ma.MaskedArray):  # somebody's __array__ gave it
        raise masked
    return np.asarray(array)


def _has_mask(value: Any) -> bool:
    """Whether it is a masked array, or has one in sequences of sequences."""
    level = [value]
    for _ in range(MOST_NESTED):
        kinds = set(map(type, level))
        if any(issubclass(kind, np.ma.MaskedArray) for kind in kinds):
            return True
        nested = tuple(k for k in kinds if issubclass(k, Sequence) and not issubclass(k, TEXTS))
        if not nested:
            return False
        level = list(chain.from_iterable(entry for entry in level if isinstance(entry, nested)))
    return False


def is_whole(value: object) -> bool:
    """Whether it is a whole number, of Python or of NumPy, and no boolean."""
    return isinstance(value, (int, np.integer)) and not isinstance(value, bool)


def check_axes(lead: tuple[int, ...]) -> None:
    """Refuse more leading axes than every function of NumPy can have.

    Raises
    ------
    ShapeError
    """
    if len(lead) > MOST_AXES:
        raise ShapeError(f"up to {MOST_AXES} leading axes are possible, {len(lead)} arrived")


class Broken(NamedTuple):
    """A rule, the rows that broke it, what arrived in them, and beside what it counts as zero."""

    mask: Mask
    error: type[KleinformError]
    rule: str
    arrived: Any
    core: int
    beside: Any

    def text(self, row: tuple[int, ...]) -> str:
        """The rule, and what arrived in a row."""
        value = self._of_row(self.arrived, row)
        text = f"{self.rule}; {value!r} arrived"
        if self.beside is not None and value != 0.0:
            text += f", rounding beside {self._of_row(self.beside, row):.3g}"
        return text

    def _of_row(self, values: Any, row: tuple[int, ...]) -> Any:
        array = np.asarray(values)
        core = array.shape[array.ndim - self.core :]
        return np.broadcast_to(array, self.mask.shape + core)[row].tolist()


class Screen:
    """Collects the rows of a batch that broke a rule.

    With ``errors="raise"`` `settle` raises, naming the first row and the number of rows. With
    ``errors="nan"`` the rows are remembered and blanked in the results.
    """

    __slots__ = ("broken", "errors", "lead")

    def __init__(self, lead: tuple[int, ...], errors: Errors) -> None:
        if not isinstance(errors, str) or errors not in ("raise", "nan"):
            raise InputError(f'errors: "raise" or "nan" is needed, {errors!r} arrived')
        if lead:
            check_axes(lead)
        self.lead = lead
        self.errors = errors
        self.broken: list[Broken] = []

    def reject(
        self,
        rows: Any,
        error: type[KleinformError],
        rule: str,
        arrived: Any,
        core: int = 0,
        *,
        beside: Any = None,
    ) -> None:
        """Refuse some rows.

        ``arrived`` has what to show of each row, with so many axes; ``beside`` the scale of
        what counts as zero.
        """
        if np.any(rows):
            mask = np.broadcast_to(np.asarray(rows, dtype=bool), self.lead)
            self.broken.append(Broken(mask, error, rule, arrived, core, beside))

    def settle(self) -> None:
        """Raise for the first row that was refused, if rows are not to be blanked."""
        if self.errors == "nan" or not self.broken:
            return
        rejected = ~self.valid
        first = tuple(map(int, np.argwhere(rejected)[0]))
        broken = next(entry for entry in self.broken if entry.mask[first])
        text = broken.text(first)
        if self.lead:
            where = first[0] if len(first) == 1 else first
            text += f", first at pose {where}; {int(rejected.sum())} of {rejected.size} poses"
        raise broken.error(text, rejected)

    def blank(self, *results: Array) -> None:
        """Settle, or write NaN into the rows of results that were refused."""
        if self.broken:
            self.settle()
            rejected = ~self.valid
            for result in results:
                result[rejected] = np.nan

    @property
    def valid(self) -> Mask:
        """True for the rows that kept every rule."""
        valid = np.ones(self.lead, dtype=bool)
        for entry in self.broken:
            valid &= ~entry.mask
        return valid


def lead_of(shapes: dict[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The common leading axes of arguments, given the leading axes of each by its name.

    Raises
    ------
    ShapeError
        They do not broadcast.
    """
    leads = set(shapes.values())
    if len(leads) == 1:
        return leads.pop()
    for lead in leads:
        check_axes(lead)
    try:
        return np.broadcast_shapes(*leads)
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
        raise ShapeError(f"leading axes do not broadcast: {listed}") from None


def rotation_array(name: str, value: RotationLike) -> tuple[Array, float]:
    """The rotation as float64 ``(..., 3, 3)`` and the defect that its precision allows."""
    given = _matrix_of(name, value) if isinstance(value, HasMatrix) else value
    return real_array(name, given, (3, 3)), allowed_defect(given)


def _matrix_of(name: str, value: HasMatrix) -> ArrayLike:
    """What gives its matrix, asked for it."""
    try:
        return value.as_matrix()
    except Exception as error:  # it is somebody's
        raise DtypeError(f"{name}: as_matrix() gave {error!r}") from error


def allowed_defect(*given: Any) -> float:
    """How far from orthonormal a rotation, or its columns, may be at their precision."""
    single = any(getattr(value, "dtype", None) == np.dtype("float32") for value in given)
    return ROTATION_TOLERANCE_FLOAT32 if single else ROTATION_TOLERANCE


def reject_bad_numbers(screen: Screen, name: str, array: Array, core: int) -> None:
    """Refuse rows with NaN, inf or numbers whose squares and cubes overflow.

    ``core`` is the number of trailing axes.
    """
    size = abs(array)
    if (size <= LARGEST).all():
        return
    trailing = tuple(range(size.ndim - core, size.ndim))
    for fits, error, rule in (
        (np.isfinite(size), NotFiniteError, f"{name}: NaN or inf"),
        (size <= LARGEST, InputError, f"{name}: above {LARGEST:g}"),
    ):
        screen.reject(~fits.all(trailing), error, rule, array, core)


def reject_bad_rotations(screen: Screen, name: str, rotation: Array, tolerance: float) -> None:
    """Refuse rows that are no rotation, NaN and inf among them."""
    defect = kernels.rotation_defect(rotation).defect
    if (defect <= tolerance).all():
        return
    reject_bad_numbers(screen, name, rotation, 2)
    rule = f"{name}: not a rotation (its defect may be {tolerance}"
    rounded = (tolerance < defect) & (defect < ROUNDED)
    mended = f"{rule}; a rounded one? kleinform.nearest_rotation)"
    screen.reject(rounded, NotARotationError, mended, defect)
    screen.reject(~(defect <= tolerance) & ~rounded, NotARotationError, f"{rule})", defect)


def one_rotation(name: str, value: RotationLike) -> Array:
    """A single rotation (3, 3), checked."""
    rotation, tolerance = rotation_array(name, value)
    if rotation.shape != (3, 3):
        raise ShapeError(f"{name}: shape (3, 3) is needed, {rotation.shape} arrived")
    screen = Screen((), "raise")
    reject_bad_rotations(screen, name, rotation, tolerance)
    screen.settle()
    return rotation
