"""The closure equations of exactly these float64 values, where rounding hides a sign.

Beside a fold a sign decides between two modes and none, and float64 knows it only down to
the rounding of sines, of C and of the equations: some ulp of the joint values. Here they are
computed in decimal numbers, which hold every float64 as it is, from an orthonormal frame.
"""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, Context, Decimal, localcontext

import numpy as np
from numpy.typing import NDArray

from kleinform.forward.circle import Rows

__all__ = ["closure"]

Array = NDArray[np.float64]
Vector = list[Decimal]

#: Digits that count, whatever the angles: errors stay below 1e-50 of the terms.
DIGITS = 60


def closure(row: Rows, directions: Array) -> tuple[Array, Array]:
    """F_1, F_2, F_3 and their gradients by a turn, as the kernel `fold` gives them.

    Parameters
    ----------
    row : Rows
        One set of joint values.
    directions : array (2, 3)
        n_1 and n_2, unit vectors 120° apart up to rounding: the frame is the orthonormal one
        that n_1 and the plane of both give.

    Returns
    -------
    residual : array (3,)
    gradient : array (3, 3)
        Both rounded once, at the end.
    """
    joints = [Decimal(value) for value in row.joints[0].tolist()]
    # Turns are taken out of an angle: as many digits more as it has before the point.
    digits = DIGITS + max(0, joints[3].adjusted() + 1)
    with localcontext(Context(prec=digits, rounding=ROUND_HALF_EVEN)):
        radius = Decimal(float(row.radius[0]))
        position = _position(joints[3], joints[4], joints[5])
        first, across = _frame([[Decimal(x) for x in n] for n in directions.tolist()])
        limbs = [
            # The axes u_i stand in the base as the n_i do in the platform.
            _cone([cosine, sine], _turned(cosine, first, sine, across), position, radius, length)
            for (cosine, sine), length in zip(_star(), joints[:3], strict=True)
        ]
        return (
            np.array([float(value) for value, _ in limbs]),
            np.array([[float(x) for x in gradient] for _, gradient in limbs]),
        )


def _star() -> list[Vector]:
    """Cosine and sine of the limbs' angles."""
    one, half, root = Decimal(1), Decimal("0.5"), Decimal("0.75").sqrt()
    return [[one, Decimal(0)], [-half, root], [-half, -root]]


def _cone(
    axis: Vector, n: Vector, c: Vector, radius: Decimal, length: Decimal
) -> tuple[Decimal, Vector]:
    """F_i = gt² + gz² − p² q², and n_i × its gradient in n_i."""
    cosine, sine = axis
    along, aside = cosine * c[0] + sine * c[1], cosine * c[1] - sine * c[0]
    p, t = cosine * n[0] + sine * n[1], cosine * n[1] - sine * n[0]
    h = radius - along
    gt, gz, square = aside * p + h * t, c[2] * p + h * n[2], length * length
    # The gradient along u_i, t_i and k.
    by_p, by_t, by_z = gt * aside + gz * c[2] - p * square, gt * h, gz * h
    slope = [2 * (cosine * by_p - sine * by_t), 2 * (sine * by_p + cosine * by_t), 2 * by_z]
    return gt * gt + gz * gz - p * p * square, _cross(n, slope)


def _turned(cosine: Decimal, one: Vector, sine: Decimal, other: Vector) -> Vector:
    return [cosine * x + sine * y for x, y in zip(one, other, strict=True)]


def _position(azimuth: Decimal, elevation: Decimal, length: Decimal) -> Vector:
    (sin_4, cos_4), (sin_5, cos_5) = _sine_cosine(azimuth), _sine_cosine(elevation)
    return [length * cos_5 * cos_4, length * cos_5 * sin_4, length * sin_5]


def _frame(pair: list[Vector]) -> tuple[Vector, Vector]:
    """n_1, and the unit vector a quarter turn ahead of it in the platform's plane."""
    first, second = pair
    first = _unit(first)
    normal = _unit(_cross(first, second))
    return first, _cross(normal, first)


def _unit(vector: Vector) -> Vector:
    length = sum((x * x for x in vector), Decimal(0)).sqrt()
    return [x / length for x in vector]


def _cross(one: Vector, two: Vector) -> Vector:
    (a, b, c), (x, y, z) = one, two
    return [b * z - c * y, c * x - a * z, a * y - b * x]


def _sine_cosine(angle: Decimal) -> tuple[Decimal, Decimal]:
    """By Taylor's series of an eighth of the angle, doubled three times."""
    if abs(angle) > 4:
        angle = angle.remainder_near(2 * _pi())
    part = angle / 8
    square = part * part
    sine, versine = part, square / 2
    term, number = part, 1
    least = Decimal(10) ** -(DIGITS + 4)
    while abs(term) > least:
        number += 2
        term *= -square / (number * (number - 1))
        sine += term
        versine += term * part / (number + 1)
    # 1 − cos, which is small where the angle is: its digits are kept.
    for _ in range(3):
        sine, versine = 2 * sine * (1 - versine), 2 * versine * (2 - versine)
    return sine, 1 - versine


def _pi() -> Decimal:
    """By Machin's formula 16 arctan 1/5 − 4 arctan 1/239."""
    return 16 * _arctangent_of_inverse(5) - 4 * _arctangent_of_inverse(239)


def _arctangent_of_inverse(number: int) -> Decimal:
    power = total = 1 / Decimal(number)
    odd, changed = 1, True
    while changed:
        odd += 2
        power /= -number * number
        changed, total = total + power / odd != total, total + power / odd
    return total
