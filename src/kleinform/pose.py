"""A pose as it arrived, checked, and what makes it singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, SingularPoseError
from kleinform.generated import kernels
from kleinform.quick import none_zero, sized, sound
from kleinform.screening import (
    LARGEST,
    ROTATION_TOLERANCE,
    SMALLEST,
    Errors,
    RotationLike,
    Screen,
    lead_of,
    real_array,
    reject_bad_numbers,
    reject_bad_rotations,
    rotation_array,
)
from kleinform.warning import Near, warn_near
from kleinform.zero import NEAR, Factor, central, factors, guard, legs, within

__all__ = ["Pose", "check_pose"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

HUGE = float(np.finfo(np.float64).max)
LIMBS, LEGS = (tuple(f"{name}_{i}" for i in (1, 2, 3)) for name in ("limb", "leg"))
EXTENSIONS = ("extension_1", "extension_2", "extension_3")
#: What a call says of a pose at which a factor vanishes that it divides by.
RULES = {
    **{name: f"n_{i}·u_{i} = 0, B_{i} is not defined" for i, name in enumerate(LIMBS, 1)},
    **{name: f"q_{i} = 0, leg {i} has no direction" for i, name in enumerate(LEGS, 1)},
    **{name: f"direct singularity, e_{i} = 0" for i, name in enumerate(EXTENSIONS, 1)},
    "central": "inverse singularity, q6 cos q5 = 0",
    "wrist": "(n_1 × n_2)·λ = 0, wrist",
    "orientation": "direct singularity, det[n_i × (d_i − c)] = 0",
}
AXIS = "C is on the Z axis, q4 is free: give azimuth="


class Geometry(Protocol):
    """What a pose needs to know of the manipulator."""

    @property
    def radius(self) -> Array: ...

    @property
    def rounding(self) -> float: ...


@dataclass(slots=True)
class Pose:
    """Checked arguments; every method refuses the rows in which something vanishes.

    Rows in which it nearly does are remembered in ``near``, for one warning at the end.
    """

    radius: Array
    rounding: float
    position: Array
    rotation: Array
    azimuth: Array | None
    screen: Screen
    near: list[Near] | None = None

    def reject_incidence(self, incidence: Array) -> None:
        """Refuse ``n_i·u_i = 0``: the line of B_i is parallel to the plane of its leg."""
        if not none_zero(incidence, 1.0, guard(self.rounding)):
            self._judge(LIMBS, (incidence, 1.0))

    def reject_legs(self, result: Any) -> None:
        """Refuse ``n_i·u_i = 0`` and ``q_i = 0``."""
        most = guard(self.rounding)
        legs_are_far = none_zero(result.scaled_legs, result.reach, most)
        if not (legs_are_far and none_zero(result.incidence, 1.0, most)):
            self._judge(LIMBS + LEGS, *_of_legs(result))

    def reject_inverse(self, result: Any) -> None:
        """Refuse what leaves the joint rates without an answer: the wrist factor cancels."""
        self.reject_legs(result)
        radial, length = result.radial, result.central_length
        if not none_zero(radial, length, guard(self.rounding)):
            self._judge(("central",), (radial, length))

    def reject_wrist(self, result: Any) -> None:
        """Refuse ``(n_1 × n_2)·λ = 0``: the wrist screws span no rotation."""
        if not none_zero(result.wrist, result.wrist_scale, guard(self.rounding)):
            self._judge(("wrist",), (result.wrist, result.wrist_scale))

    def reject_direct(self, result: Any) -> None:
        """Refuse what leaves the twist without an answer: the wrist factor cancels."""
        most = guard(self.rounding)
        if not (
            none_zero(result.incidence, 1.0, most)
            and none_zero(result.scaled_legs, result.reach, most)
            and none_zero(result.extension, result.extension_scale, most)
            and none_zero(result.orientation, result.orientation_scale, most)
        ):
            self._judge(
                (*LIMBS, *LEGS, *EXTENSIONS, "orientation"),
                *_of_legs(result),
                (result.extension, result.extension_scale),
                (result.orientation, result.orientation_scale),
            )
        self.reject_axis(result.radial, result.central_length)

    def _judge(self, names: tuple[str, ...], *checks: tuple[Array, Array | float]) -> None:
        """Refuse the poses at which one of some factors vanishes, and remember those near it.

        Most poses are far from it by the kernel's own ``checks``, values (...), or (..., 3) for
        the limbs, and their scales; for the others it is told by their survey.
        """
        most = guard(self.rounding)
        close = np.asarray(np.any([self._within(*check, most) for check in checks], axis=0))
        if close.any():
            found = self._factors(close)
            for name in names:
                self._settle(close, name, RULES[name], found[name])

    def _within(self, value: Array, scale: Array | float, most: float) -> Mask:
        """Where a value of a pose, or one of its limbs', is at most so many times its scale."""
        if value.ndim == len(self.screen.lead):
            return within(value, scale, most)
        sizes = np.asarray(scale)
        shaped = sizes if sizes.ndim in (0, value.ndim) else sizes[..., np.newaxis]
        return np.asarray(within(value, shaped, most).any(axis=-1))

    def _factors(self, close: Mask) -> dict[str, Factor]:
        """All factors of some poses (...), one after the other."""
        lead = close.shape
        radius = np.broadcast_to(self.radius, lead)[close]
        place = np.broadcast_to(self.position, (*lead, 3))[close]
        turn = np.broadcast_to(self.rotation, (*lead, 3, 3))[close]
        survey = kernels.survey(radius, place, turn)
        return {**factors(survey).by_name(), **legs(survey, radius).by_limb("leg")}

    def _settle(self, close: Mask, name: str, rule: str, factor: Factor) -> None:
        """Refuse some poses (...) where a factor is zero, and remember them where it nearly is."""
        zero, ratio = factor.zero(self.rounding), factor.ratio()
        if zero.any():
            rows = np.zeros(close.shape, dtype=bool)
            value, scale = np.zeros(close.shape), np.zeros(close.shape)
            rows[close], value[close], scale[close] = zero, factor.value, factor.scale
            self.screen.reject(rows, SingularPoseError, rule, value, beside=scale)
        near = (ratio <= NEAR) & ~zero
        if near.any():
            self._remember(Near(name, np.flatnonzero(close)[near], ratio[near]))

    def _remember(self, near: Near) -> None:
        self.near = [*(self.near or ()), near]

    def reject_overflow(self, result: Array) -> None:
        """Refuse what is singular no more, and still not finite: products of such numbers."""
        if not sized(result, 0.0, HUGE):
            rule = "the numbers are so large or so small that the result overflows"
            overflown = ~np.isfinite(result).all(axis=-1)
            self.screen.reject(overflown, InputError, rule, self.position, 1)

    def on_axis(self, radial: Array, length: Array) -> Mask:
        """Where C lies on the Z axis within rounding."""
        return central(radial, length).zero(self.rounding)

    def reject_axis(self, radial: Array, length: Array, *, divided: bool = True) -> None:
        """Refuse C at O, and C on the Z axis unless an azimuth is given.

        ``divided`` says whether the call divides by the distance from the axis.
        """
        if none_zero(radial, length, guard(self.rounding)):
            return
        at_origin = "q6 = 0, the central limb has no direction"
        self.screen.reject(length == 0.0, SingularPoseError, at_origin, length)
        factor = central(radial, length)
        zero, ratio = factor.zero(self.rounding), factor.ratio()
        if self.azimuth is None:
            self.screen.reject(zero, SingularPoseError, AXIS, radial, beside=length)
        near = (ratio <= NEAR) & ~zero
        if divided and near.any():
            self._remember(Near("central", np.flatnonzero(near), ratio[near]))

    def blank(self, *results: Array) -> None:
        """Settle, or write NaN into the rows of results that were refused; warn of near ones."""
        if self.screen.broken:
            self.screen.blank(*results)
        if self.near:
            warn_near(self.near, self.screen.valid)

    def heading(self) -> Array:
        """A horizontal vector at azimuth q4: (c_x, c_y), or as given on the Z axis."""
        planar = self.position[..., :2]
        if self.azimuth is None:
            return planar
        limb = kernels.central_inverse(self.position)
        on_axis = self.on_axis(limb.radial, limb.joints[..., 2])
        with np.errstate(invalid="ignore"):  # an infinite azimuth is refused already
            given = np.stack([np.cos(self.azimuth), np.sin(self.azimuth)], axis=-1)
        return np.where(on_axis[..., np.newaxis], given, planar)


def _of_legs(result: Any) -> tuple[tuple[Array, Array | float], ...]:
    """What a kernel says of the outer legs, and its scales."""
    return (result.incidence, 1.0), (result.scaled_legs, result.reach)


def reject_underflow(screen: Screen, position: Array) -> None:
    """Refuse positions so close to O, and not at O, that their squares underflow."""
    size = abs(position)
    if size.min(initial=1.0) >= SMALLEST:
        return
    largest = size.max(axis=-1)
    screen.reject(
        (largest > 0.0) & (largest < SMALLEST),
        InputError,
        f"position: nearer to O than {SMALLEST:g} m and not O",
        largest,
    )


def check_pose(
    robot: Geometry,
    position: ArrayLike,
    rotation: RotationLike,
    errors: Errors,
    *,
    azimuth: ArrayLike | None = None,
    **others: Array,
) -> Pose:
    """Check a pose and what comes with it; ``others`` are arrays ``(..., n)`` by name."""
    place: Any = position
    turn: Any = rotation
    quickly = sound(position, rotation, SMALLEST, LARGEST, ROTATION_TOLERANCE)
    if not quickly:
        place = real_array("position", position, (3,))
        turn, tolerance = rotation_array("rotation", rotation)
    angle = None if azimuth is None else real_array("azimuth", azimuth, ())
    lead = _lead(robot.radius, place, turn, angle, others)
    screen = Screen(lead, errors)
    if angle is not None:
        # Only the position depends on the azimuth: it carries the azimuth's axes from here on.
        lead = np.broadcast_shapes(place.shape[:-1], angle.shape)
        place = np.broadcast_to(place, (*lead, 3))
    if not quickly:
        reject_bad_numbers(screen, "position", place, 1)
        reject_underflow(screen, place)
        reject_bad_rotations(screen, "rotation", turn, tolerance)
    if angle is not None:
        reject_bad_numbers(screen, "azimuth", angle, 0)
    for name, array in others.items():
        if not sized(array, 0.0, LARGEST):
            reject_bad_numbers(screen, name, array, 1)
    if screen.broken:
        screen.settle()
    return Pose(robot.radius, robot.rounding, place, turn, angle, screen)


def _lead(
    radius: Array, position: Array, rotation: Array, azimuth: Array | None, others: dict[str, Array]
) -> tuple[int, ...]:
    """The common leading axes of checked arguments."""
    axes = position.ndim - 1 + rotation.ndim - 2 + radius.ndim
    for array in others.values():
        axes += array.ndim - 1
    if axes == 0 and azimuth is None:
        return ()
    shapes = {
        "radius": radius.shape,
        "position": position.shape[:-1],
        "rotation": rotation.shape[:-2],
        **{name: array.shape[:-1] for name, array in others.items()},
    }
    if azimuth is not None:
        shapes["azimuth"] = azimuth.shape
    return lead_of(shapes)
