"""A pose as it arrived, checked, and what makes it singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.errors import InputError, SingularPoseError
from kleinform.generated import kernels
from kleinform.quick import none_zero, sized, sound
from kleinform.results import EPS, is_zero
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

__all__ = ["Pose", "check_pose"]

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

HUGE = float(np.finfo(np.float64).max)
NO_PLATFORM_JOINT = tuple(f"n_{i}·u_{i} = 0, B_{i} is not defined" for i in (1, 2, 3))
NO_EXTENSION = tuple(f"direct singularity, e_{i} = 0" for i in (1, 2, 3))
NO_LEG = tuple(f"q_{i} = 0, leg {i} has no direction" for i in (1, 2, 3))


class Geometry(Protocol):
    """What a pose needs to know of the manipulator."""

    @property
    def radius(self) -> Array: ...

    @property
    def rounding(self) -> float: ...


@dataclass(slots=True)
class Pose:
    """Checked arguments; every method refuses the rows in which something vanishes."""

    radius: Array
    rounding: float
    position: Array
    rotation: Array
    azimuth: Array | None
    screen: Screen

    def reject_zero(self, rule: str, value: Array, scale: Array) -> None:
        """Refuse the poses at which a value is zero within its rounding."""
        if not none_zero(value, scale, self.rounding * EPS):
            zero = is_zero(value, scale, self.rounding)
            self.screen.reject(zero, SingularPoseError, rule, value, beside=scale)

    def reject_zeros(self, rules: tuple[str, ...], values: Array, scales: Array | float) -> None:
        """The same for values (..., 3), one a limb, each with its rule.

        There is a scale for each value (..., 3), one for each pose (...), or one for all.
        """
        if none_zero(values, scales, self.rounding * EPS):
            return
        scales = np.asarray(scales)
        shaped = scales if scales.ndim in (0, values.ndim) else scales[..., np.newaxis]
        zero = is_zero(values, shaped, self.rounding)
        if not zero.any():
            return
        for i, rule in enumerate(rules):
            scale = np.broadcast_to(shaped, values.shape)[..., i]
            self.screen.reject(zero[..., i], SingularPoseError, rule, values[..., i], beside=scale)

    def reject_incidence(self, incidence: Array) -> None:
        """Refuse ``n_i·u_i = 0``: the line of B_i is parallel to the plane of its leg."""
        self.reject_zeros(NO_PLATFORM_JOINT, incidence, 1.0)

    def reject_legs(self, result: Any) -> None:
        """Refuse ``n_i·u_i = 0`` and ``q_i = 0``."""
        self.reject_incidence(result.incidence)
        self.reject_zeros(NO_LEG, result.scaled_legs, result.reach)

    def reject_inverse(self, result: Any) -> None:
        """Refuse what leaves the joint rates without an answer: the wrist factor cancels."""
        self.reject_legs(result)
        self.reject_zero("inverse singularity, q6 cos q5 = 0", result.radial, result.central_length)

    def reject_direct(self, result: Any) -> None:
        """Refuse what leaves the twist without an answer: the wrist factor cancels."""
        self.reject_legs(result)
        self.reject_zeros(NO_EXTENSION, result.extension, result.extension_scale)
        self.reject_zero(
            "direct singularity, det[n_i × (d_i − c)] = 0",
            result.orientation,
            result.orientation_scale,
        )
        self.reject_axis(result.radial, result.central_length)

    def reject_overflow(self, result: Array) -> None:
        """Refuse what is singular no more, and still not finite: products of such numbers."""
        if not sized(result, 0.0, HUGE):
            rule = "the numbers are so large or so small that the result overflows"
            overflown = ~np.isfinite(result).all(axis=-1)
            self.screen.reject(overflown, InputError, rule, self.position, 1)

    def on_axis(self, radial: Array, length: Array) -> Mask:
        """Where C lies on the Z axis within rounding."""
        return is_zero(radial, length, self.rounding)

    def reject_axis(self, radial: Array, length: Array) -> None:
        """Refuse C at O, and C on the Z axis unless an azimuth is given."""
        if none_zero(radial, length, self.rounding * EPS):
            return
        self.screen.reject(
            length == 0.0, SingularPoseError, "q6 = 0, the central limb has no direction", length
        )
        if self.azimuth is None:
            rule = "C is on the Z axis, q4 is free: give azimuth="
            self.reject_zero(rule, radial, length)

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
