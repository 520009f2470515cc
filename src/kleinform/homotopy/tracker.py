"""Follow paths of a homotopy, all at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["PREDICTION", "Complex", "Homotopy", "Index", "Mask", "Real", "System", "Tracker"]

Complex = NDArray[np.complex128]
Real = NDArray[np.float64]
Mask = NDArray[np.bool_]
Index = NDArray[np.intp]
#: ``system(x) -> (values, derivatives)``: x is (P, n + 1), the results (P, n), (P, n, n + 1).
System = Callable[[Complex], tuple[Complex, Complex]]
#: ``homotopy(x, t, paths) -> (H, dH/dx, dH/dt)``: t (P,), real or complex, and the numbers
#: (P,) of the paths.
Homotopy = Callable[[Complex, Real | Complex, Index], tuple[Complex, Complex, Complex]]

#: A step is kept when Newton's method moves its unit vector by no more than this: the
#: predictor is then closer to its own path than another path is likely to come.
PREDICTION = 1e-4
#: The second step of Newton's method over the first; Kantorovich's number is about twice this,
#: and 1/2 would prove convergence. Steps below SETTLED are rounding and have no ratio.
CONTRACTION = 1.0 / 16.0
SETTLED = 1e-10
FIRST_STEP = 0.02
#: A path that needs smaller steps in t meets another one: two that part at ``1 - t`` are about
#: ``(1 - t)^(1/2)`` apart, and closer than SINGULAR they count as one.
LEAST_STEP = 1e-13
#: Steps of one path before the endgame, the rejected ones included; the most that any of
#: 160000 paths to random poses needed on all of it is 112.
MOST_STEPS = 1000


@dataclass(frozen=True, eq=False)
class Tracker:
    """Paths of one homotopy; ``steps`` counts theirs."""

    homotopy: Homotopy
    prediction: float
    steps: Index

    def track(
        self,
        points: Complex,
        paths: Index,
        start: complex,
        end: complex,
        *,
        first: float = FIRST_STEP,
        most: int,
    ) -> tuple[Complex, Mask]:
        """Follow paths on a straight part of the way: where they are, and which got there.

        Parameters
        ----------
        start, end : float or complex
            Values of t.
        first : float
            The first step, as a share of the part.
        most : int
            Steps of one path, the rejected ones included.
        """
        points, shares = points.copy(), np.zeros(len(points))
        sizes = np.full(len(points), first)
        least = LEAST_STEP / abs(end - start)
        used = np.zeros_like(paths)
        active = np.arange(len(points))
        while len(active):
            left = 1.0 - shares[active]
            size = np.minimum(sizes[active], left)
            times = np.asarray(start + shares[active] * (end - start))
            steps = np.asarray(size * (end - start))
            reached, good, growth = self._step(points[active], times, steps, paths[active])
            moved = active[good]
            points[moved] = reached[good]
            shares[moved] = np.where(size < left, shares[active] + size, 1.0)[good]
            sizes[active] = size * growth
            used[active] += 1
            stuck = (sizes[active] < least) & ~good
            active = active[(shares[active] < 1.0) & ~stuck & (used[active] < most)]
        self.steps[paths] += used
        return points, shares == 1.0

    def _step(
        self, points: Complex, times: Real | Complex, sizes: Real | Complex, paths: Index
    ) -> tuple[Complex, Mask, Real]:
        """One step of each path: its end, whether it may be kept, and by how much to grow."""
        charts, step = points.conj(), sizes[:, np.newaxis]

        def slope(x: Complex, t: Real | Complex) -> Complex:
            _, by_x, by_t = self.homotopy(x, t, paths)
            return _solved(charts, by_x, by_t)

        middle, ends = times + sizes / 2.0, times + sizes
        # A path that meets a singularity may be thrown anywhere; the step is then rejected.
        with np.errstate(all="ignore"):
            first = slope(points, times)
            second = slope(points + step / 2.0 * first, middle)
            third = slope(points + step / 2.0 * second, middle)
            fourth = slope(points + step * third, ends)
            reached = points + step / 6.0 * (first + 2.0 * (second + third) + fourth)
            reached, moved = self._newton(charts, reached, ends, paths)
            reached, again = self._newton(charts, reached, ends, paths)
            good = (moved <= self.prediction) & (again <= np.maximum(CONTRACTION * moved, SETTLED))
            growth = 0.8 * (self.prediction / moved) ** 0.2
        growth = np.where(good, np.clip(growth, 0.5, 3.0), np.clip(growth, 0.1, 0.5))
        growth = np.where(np.isfinite(growth), growth, 0.1)
        return unit(reached), good, growth

    def _newton(
        self, charts: Complex, points: Complex, times: Real | Complex, paths: Index
    ) -> tuple[Complex, Real]:
        values, by_x, _ = self.homotopy(points, times, paths)
        step = _solved(charts, by_x, values)
        return points + step, np.linalg.norm(step, axis=-1)

    def refine(
        self, points: Complex, paths: Index, time: complex, steps: int
    ) -> tuple[Complex, Real]:
        """Points to their last digits by some steps of Newton's method, and the last one."""
        times, charts = np.full(len(points), time), points.conj()
        with np.errstate(all="ignore"):
            for _ in range(steps):
                points, moved = self._newton(charts, points, times, paths)
        return unit(points), moved

    def matrices(self, points: Complex, paths: Index) -> tuple[Complex, Complex]:
        """The system at t = 1, and its derivatives in the charts normal to the points."""
        values, by_x, _ = self.homotopy(points, np.ones(len(points)), paths)
        return values, np.concatenate([by_x, points.conj()[:, np.newaxis]], axis=1)


def unit(points: Complex) -> Complex:
    with np.errstate(all="ignore"):
        return np.asarray(points / np.linalg.norm(points, axis=-1, keepdims=True))


def _solved(charts: Complex, derivatives: Complex, values: Complex) -> Complex:
    """The x with ``derivatives x = -values`` in the charts; NaN where there is none."""
    matrices = np.concatenate([derivatives, charts[:, np.newaxis]], axis=1)
    sides = np.concatenate([-values, np.zeros_like(values[:, :1])], axis=1)[..., np.newaxis]
    try:
        return np.linalg.solve(matrices, sides)[..., 0]
    except np.linalg.LinAlgError:
        # One singular matrix stops the whole batch.
        matrices[np.linalg.det(matrices) == 0.0] = np.nan
        return np.linalg.solve(matrices, sides)[..., 0]
