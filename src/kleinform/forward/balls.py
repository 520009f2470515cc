"""Boxes that are proven to hold one solution, in ball arithmetic (needs python-flint).

Krawczyk's theorem: let F be n polynomials in n unknowns, P the polydisc of radius r around x,
and Y any matrix with

    |Y F(x)|_i + r Σ_j |(1 − Y F'(P))_ij| < r   for every i.

Then T(y) = y − Y F(y) maps the convex P into itself and contracts it, by the mean value
theorem, so that F has exactly one zero in P, a simple one. Every quantity is a ball around
all its possible values, those for all joint values within a tolerance among them, and a
comparison of balls is true when it is so for all members: what is proven holds for each of
these joint values, roundings included. x and Y are approximations that need not be good.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from flint import acb, acb_mat, arb
from numpy.typing import NDArray

__all__ = ["Box", "Chart", "enclose", "exact"]

Complex = NDArray[np.complex128]
Index = NDArray[np.intp]
Balls = Sequence[acb]

#: Newton's method has converged when its step is below STEP, or below SMALL and no longer
#: shrinking; relative to 1 + |x|.
STEP = 1e-13
SMALL = 1e-6
MOST_STEPS = 16
SHARPER_STEPS = 5
#: Where the imaginary part is smaller, the real part alone is tried first.
NEARLY_REAL = 1e-6
#: Radii are no smaller, so that an exact solution has a box too, and no larger.
LEAST_RADIUS = 1e-30
MOST_RADIUS = 0.25


@dataclass(frozen=True, eq=False)
class Box:
    """A polydisc ``|x - center|_j <= radius`` with exactly one solution.

    Either the center is real: then so is the solution, because its conjugate is a solution
    in the same box. Or no point of the box is real.

    Attributes
    ----------
    center : complex array (n,)
    radius : float
    label : int
        Index of the pair (n_1, n_2) that led here.
    """

    center: Complex
    radius: float
    label: int

    @property
    def is_real(self) -> bool:
        """Whether the solution is real."""
        return not self.center.imag.any()

    def conjugate(self) -> Box:
        """The box of the conjugate solution: the coefficients of the system are real."""
        return Box(self.center.conj(), self.radius, self.label)


class Chart(Protocol):
    """A square polynomial system with real coefficients, and approximate solutions.

    Attributes
    ----------
    name : str
    antipodal : bool
        Whether -x is a solution with x.
    candidates : complex array (k, n)
    labels : int array (k,)
        Index of the pair (n_1, n_2) that a candidate is from.
    """

    name: str
    antipodal: bool
    candidates: Complex
    labels: Index

    def evaluate(self, x: Balls) -> tuple[acb_mat, acb_mat]:
        """The system and its Jacobian."""

    def directions(self, box: Box) -> tuple[Complex, float]:
        """The pair (n_1, n_2), an array (2, 3), and the radius of its box."""


def enclose(chart: Chart, start: Complex, label: int) -> Box | None:
    """A box around the solution that Newton's method finds, or None: nothing is proven.

    The nearer another solution is, the sharper the center must be: one of double precision
    serves down to distances of about 1e-6, one of all bits is tried after it.
    """
    try:
        point, inverse = _converged(chart, start)
        box = _boxed(chart, exact(point), inverse, label)
        return box if box is not None else _boxed(chart, *_sharper(chart, point), label)
    except ZeroDivisionError:
        return None


def _boxed(chart: Chart, center: list[acb], inverse: acb_mat, label: int) -> Box | None:
    """The box around a center, a real one if it may be; None where nothing is proven."""
    imaginary = max(float(abs(entry.imag).lower()) for entry in center)
    if imaginary <= NEARLY_REAL:
        real = [acb(entry.real) for entry in center]
        radius = _proven_radius(chart, real, inverse)
        if radius is not None:
            return _rounded(real, radius, label)
    radius = _proven_radius(chart, center, inverse)
    box = _rounded(center, radius, label) if radius is not None else None
    return box if box is not None and float(np.max(np.abs(box.center.imag))) > box.radius else None


def _rounded(center: list[acb], radius: float, label: int) -> Box:
    """The box with a center of double precision, wider by what that moves it."""
    point = np.array([complex(entry) for entry in center])
    moved = [abs(sharp - rough) for sharp, rough in zip(center, exact(point), strict=True)]
    # A sum rounds to the nearest, by less than this factor.
    return Box(point, (1.0 + 1e-15) * (radius + max(float(e.upper()) for e in moved)), label)


def exact(point: Complex) -> list[acb]:
    """The same numbers, as balls without a radius."""
    return [acb(entry) for entry in point.tolist()]


def _converged(chart: Chart, point: Complex) -> tuple[Complex, acb_mat]:
    """Where Newton's method ends, and an approximate inverse of the Jacobian there."""
    identity = acb_mat(np.eye(len(point)).tolist())
    last = np.inf
    for _ in range(MOST_STEPS):
        residual, jacobian = chart.evaluate(exact(point))
        inverse = jacobian.solve(identity, algorithm="approx").mid()
        step = [complex(entry) for entry in (inverse * residual).entries()]
        size = max(map(abs, step)) / (1.0 + max(map(abs, point.tolist())))
        point = point - step
        if size <= STEP or last / 2.0 <= size <= SMALL:
            break
        last = size
    return point, inverse


def _sharper(chart: Chart, point: Complex) -> tuple[list[acb], acb_mat]:
    """The same in all bits of the working precision."""
    identity = acb_mat(np.eye(len(point)).tolist())
    center = exact(point)
    for _ in range(SHARPER_STEPS):
        residual, jacobian = chart.evaluate(center)
        inverse = jacobian.solve(identity, algorithm="approx").mid()
        step = (inverse * residual).entries()
        center = [(entry - own).mid() for entry, own in zip(center, step, strict=True)]
    return center, inverse


def _proven_radius(chart: Chart, center: list[acb], inverse: acb_mat) -> float | None:
    """The radius r of Krawczyk's theorem, about the smallest; None where it does not apply."""
    steps = [abs(entry) for entry in (inverse * chart.evaluate(center)[0]).entries()]
    # The sum over j grows with r; where it is 1/2 at the best r, that r is twice the step.
    radius = max(2.0 * max(float(step.upper()) for step in steps), LEAST_RADIUS)
    if not radius <= MOST_RADIUS:
        return None
    square = acb(arb(0, radius), arb(0, radius))
    _, jacobian = chart.evaluate([entry + square for entry in center])
    rows = (inverse * jacobian).tolist()
    for index, (step, row) in enumerate(zip(steps, rows, strict=True)):
        row[index] -= 1
        if not step + radius * sum(map(abs, row)) < radius:
            return None
    return radius
