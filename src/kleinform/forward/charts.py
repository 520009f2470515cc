"""The forward displacement as a polynomial system in ball arithmetic, in two charts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from flint import acb, acb_mat, arb, fmpq
from numpy.typing import NDArray

from kleinform.forward.balls import Box
from kleinform.forward.chords import AZIMUTHS, leg_angles
from kleinform_kernels.uncoupled import arb_kernels

__all__ = ["Circles", "Directions", "Problem"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.intp]
Balls = Sequence[acb]

#: Angles of a leg at which its half tangent may be 0.
STARTS = np.arange(8) * (np.pi / 4.0)


class Problem(NamedTuple):
    """The radius, and balls around the position of C and the lengths of the limbs."""

    radius: float
    position: list[arb]
    lengths: list[arb]

    @classmethod
    def of(cls, radius: float, joints: Array, tolerance: float) -> Problem:
        """All joint values ``q_j (1 ± tolerance)``."""
        values = [arb(value) * arb(1, tolerance) for value in joints.tolist()]
        return cls(radius, arb_kernels.central_forward(values[3:]).position, values[:3])


class Directions:
    """x = (n_1, n_2): three cones and three products of unit vectors, all of degree two.

    By Bézout's theorem there are no more than 2⁶ isolated solutions, and with so many nothing
    else. Whether a pair ±x is real needs no test against −conj(x): where that is x, x is
    imaginary, and n·n < 0.
    """

    name = "directions"
    antipodal = True

    def __init__(self, problem: Problem, pairs: Complex) -> None:
        self.candidates = pairs.reshape(-1, 6)
        self.labels = np.arange(len(pairs))
        self._cones = [2 * acb_mat(cone) for cone in arb_kernels.cones(*problem)]
        self._constants = acb_mat(6, 1, [0, 0, 0, 1, 1, arb(-0.5)])

    def evaluate(self, x: Balls) -> tuple[acb_mat, acb_mat]:
        """The system and its Jacobian."""
        first, second = list(x[:3]), list(x[3:])
        third = [one + other for one, other in zip(first, second, strict=True)]
        gradients = [
            (cone * acb_mat(3, 1, n)).entries()
            for cone, n in zip(self._cones, (first, second, third), strict=True)
        ]
        zeros = [acb()] * 3
        jacobian = acb_mat(
            [
                gradients[0] + zeros,
                zeros + gradients[1],
                gradients[2] + gradients[2],
                [2 * entry for entry in first] + zeros,
                zeros + [2 * entry for entry in second],
                second + first,
            ]
        )
        # Quadratic and constant terms alone: the Jacobian times x is twice the former.
        return jacobian * acb_mat(6, 1, x) / 2 - self._constants, jacobian

    def directions(self, box: Box) -> tuple[Complex, float]:
        """The pair (n_1, n_2), an array (2, 3), and the radius of its box."""
        return box.center.reshape(2, 3), box.radius


class Circles:
    """x = (t, s), tangents of half the angles of two legs: two equations of degree (4, 4).

    On P¹ × P¹ there are no more than 4·4 + 4·4 isolated solutions, and with so many nothing
    else. A limb with c·u_i = a does no harm here unless it is the third: the frame is turned
    so that the third has the largest ``|a − c·u_i|``.
    """

    name = "circles"
    antipodal = False

    def __init__(self, problem: Problem, pairs: Complex) -> None:
        radius, position, lengths = problem
        place = np.array([float(entry) for entry in position])
        planes = radius - place[0] * np.cos(AZIMUTHS) - place[1] * np.sin(AZIMUTHS)
        self._shift = (int(np.argmax(np.abs(planes))) + 1) % 3
        sine, cosine = arb.sin_cos_pi_fmpq(fmpq(2 * self._shift, 3))
        # A row times this is turned back by that angle.
        self._turn = acb_mat([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        position = [entry.real for entry in (acb_mat([position]) * self._turn).entries()]
        lengths = lengths[self._shift :] + lengths[: self._shift]
        angles, self.labels = leg_angles(
            radius,
            np.array([float(entry) for entry in position]),
            np.array([float(entry) for entry in lengths]),
            self._turned(pairs),
        )
        starts = [_start(leg) for leg in angles.T]
        self.candidates = np.tan((angles - starts) / 2.0)
        frames = [[arb(start).cos(), arb(start).sin()] for start in starts]
        tables = arb_kernels.circles(radius, position, lengths, frames)
        self._tables = [acb_mat(tables.angle), acb_mat(tables.cone)]
        self._arms = [acb_mat(tables.first), acb_mat(tables.second)]

    def evaluate(self, x: Balls) -> tuple[acb_mat, acb_mat]:
        """The system and its Jacobian."""
        left, right = (acb_mat([_powers(half), _slopes(half)]) for half in x)
        products = [(left * table * right.transpose()).tolist() for table in self._tables]
        values = acb_mat([[product[0][0]] for product in products])
        return values, acb_mat([[product[1][0], product[0][1]] for product in products])

    def directions(self, box: Box) -> tuple[Complex, float]:
        """The pair (n_1, n_2), an array (2, 3), and the radius of its box.

        Pairs may coincide where boxes do not: with c·u_i = a there are two B_i to one n_i.
        """
        square = acb(arb(0, box.radius), arb(0, box.radius))
        rows = []
        for half, arm in zip(box.center.tolist(), self._arms, strict=True):
            vector = (acb_mat([_powers(half + square)[:3]]) * arm).entries()
            rows.append(_unit(vector))
        # Their product is −1/2; a ball around both signs makes the box as wide.
        sign = -_dot(*rows).real.sgn()
        rows[1] = [sign * entry for entry in rows[1]]
        rows.append([-one - other for one, other in zip(*rows, strict=True)])
        rows = rows[-self._shift :] + rows[: -self._shift] if self._shift else rows
        entries = (acb_mat(rows[:2]) * self._turn.transpose()).entries()
        center = np.array([complex(entry) for entry in entries])
        errors = [
            float(abs(ball - acb(value)).upper())
            for ball, value in zip(entries, center.tolist(), strict=True)
        ]
        # float() rounds to the nearest, by less than this factor.
        return center.reshape(2, 3), (1.0 + 1e-15) * float(np.max(errors))

    def _turned(self, pairs: Complex) -> Complex:
        """The directions of the first two limbs in the turned frame."""
        turn = np.array([[complex(entry) for entry in row] for row in self._turn.tolist()])
        three = np.stack([pairs[:, 0], pairs[:, 1], -pairs[:, 0] - pairs[:, 1]], axis=1)
        turned: Complex = np.roll(three, -self._shift, axis=1)[:, :2] @ turn
        return turned


def _powers(half: acb) -> list[acb]:
    square = half * half
    return [acb(1), half, square, square * half, square * square]


def _slopes(half: acb) -> list[acb]:
    square = half * half
    return [acb(0), acb(1), 2 * half, 3 * square, 4 * square * half]


def _dot(first: Sequence[acb], second: Sequence[acb]) -> acb:
    return sum((one * other for one, other in zip(first, second, strict=True)), acb())


def _unit(vector: Sequence[acb]) -> list[acb]:
    """One of the two unit vectors along a vector; far from the cut of the square root."""
    square = _dot(vector, vector)
    root = square.sqrt() if complex(square).real >= 0.0 else acb(0, 1) * (-square).sqrt()
    return [entry / root for entry in vector]


def _start(angles: Complex) -> float:
    """The start from which no angle is near to a half turn."""
    distances = np.abs(np.cos((angles[:, np.newaxis] - STARTS) / 2.0))
    return float(STARTS[np.argmax(np.min(distances, axis=0, initial=1.0))])
