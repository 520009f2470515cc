"""Follow all paths of a homotopy at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

__all__ = ["PREDICTION", "Endpoints", "Homotopy", "System", "follow"]

Complex = NDArray[np.complex128]
Real = NDArray[np.float64]
Mask = NDArray[np.bool_]
Index = NDArray[np.intp]
#: ``system(x) -> (values, derivatives)``: x is (P, n + 1), the results (P, n), (P, n, n + 1).
System = Callable[[Complex], tuple[Complex, Complex]]
#: ``homotopy(x, t, paths) -> (H, dH/dx, dH/dt)``: t (P,) and the numbers (P,) of the paths.
Homotopy = Callable[[Complex, Real, Index], tuple[Complex, Complex, Complex]]
EPS = float(np.finfo(np.float64).eps)

#: A step is kept when Newton's method moves its unit vector by no more than this: the
#: predictor is then closer to its own path than another path is likely to come.
PREDICTION = 1e-4
#: The second step of Newton's method over the first; Kantorovich's number is about twice this,
#: and 1/2 would prove convergence. Steps below SETTLED are rounding and have no ratio.
CONTRACTION = 1.0 / 16.0
SETTLED = 1e-10
FIRST_STEP = 0.02
#: A path that needs smaller steps meets another one: two that part at ``1 - t`` are about
#: ``(1 - t)^(1/2)`` apart, and closer than SINGULAR they count as one.
LEAST_STEP = 1e-13
#: Steps of one path on one part of its way, the rejected ones included; the most that any of
#: 160000 paths to random poses needed on all of it is 112.
MOST_STEPS = 1000
#: Reciprocal condition below which an endpoint is singular. Rounding splits a double root into
#: two that are 1e-8 apart, and the condition of each is one over that.
SINGULAR = 1e-6
#: ``|x_0| / |x|`` below which an endpoint is at infinity; singular ones are known to 1e-8.
AT_INFINITY = 1e-7
#: The endgame samples a path at ``1 - t`` = NEAR and then at a quarter of the last, so often
#: that rounding spoils even a double root, and extrapolates from a few samples.
NEAR = 2.0**-6
QUARTERS = 17
SAMPLES = 4
MOST_WINDINGS = 8
#: Extrapolations that differ by less, in two successive ones, have found a singular endpoint.
AGREEMENT = 1e-5


@dataclass(frozen=True, eq=False)
class Endpoints:
    """Where the paths end, a row a path.

    Attributes
    ----------
    points : complex array (..., n + 1)
        Unit vectors whose x_0 is real and not negative: a real solution has a real vector.
    status : array (...) of str
        ``"regular"``, ``"singular"`` (a multiple solution, or one of a continuum),
        ``"infinity"``, or ``"failed"``: the path was lost, and the point is where.
    condition : array (...)
        Of the system's derivatives in the chart normal to the point.
    steps : int array (...)
        Steps of the path, the rejected ones included.
    tries : int array (...)
        Starts it took; more than 1 where paths failed or met, and were followed anew.
    """

    points: Complex
    status: NDArray[np.str_]
    condition: Real
    steps: Index
    tries: Index


def follow(homotopy: Homotopy, starts: Complex, prediction: float = PREDICTION) -> Endpoints:
    """Follow paths from t = 0 to t = 1.

    Parameters
    ----------
    homotopy : callable
        ``homotopy(x, t, paths) -> (H, dH/dx, dH/dt)`` of shapes (P, n), (P, n, n + 1), (P, n)
        for points x (P, n + 1), t (P,) and the numbers (P,) of the paths, rows of ``starts``,
        that these are. Homogeneous in x, and analytic in t at 1.
    starts : complex array (P, n + 1)
        Solutions at t = 0.
    prediction : float
        How far off a prediction may be; see PREDICTION.
    """
    paths = np.arange(len(starts))
    tracker = _Tracker(homotopy, prediction, np.zeros(len(starts), dtype=np.intp))
    points = _unit(starts)
    near, alive = tracker.track(points, paths, 0.0, 1.0 - NEAR)
    points, known = near.copy(), alive.copy()
    points[alive], known[alive] = tracker.track(near[alive], paths[alive], 1.0 - NEAR, 1.0)
    condition = np.full(len(starts), np.inf)
    condition[known] = tracker.condition(points[known], paths[known])
    rest = alive & ~(condition <= 1.0 / SINGULAR)
    limits, errors = tracker.extrapolate(near[rest], paths[rest])
    nearer = errors <= EPS * condition[rest]
    points[rest] = np.where(nearer[:, np.newaxis], limits, points[rest])
    known[rest] |= errors <= AGREEMENT
    condition[rest] = tracker.condition(points[rest], paths[rest])
    sharp = known & (condition <= 1.0 / SINGULAR)
    points[sharp], known[sharp] = tracker.polish(points[sharp], paths[sharp])
    infinite = np.abs(points[:, 0]) <= AT_INFINITY
    status = np.select(
        [~known, infinite, sharp], ["failed", "infinity", "regular"], default="singular"
    )
    phase = np.where(points[:, 0] == 0.0, 1.0, np.exp(-1j * np.angle(points[:, 0])))
    tries = np.ones(len(starts), dtype=np.intp)
    return Endpoints(points * phase[:, np.newaxis], status, condition, tracker.steps, tries)


@dataclass(frozen=True, eq=False)
class _Tracker:
    """Paths of one homotopy; ``steps`` counts theirs."""

    homotopy: Homotopy
    prediction: float
    steps: Index

    def track(
        self, points: Complex, paths: Index, start: float, end: float
    ) -> tuple[Complex, Mask]:
        """Follow paths over a part of the way: where they are then, and which got there."""
        points, times = points.copy(), np.full(len(points), start)
        sizes = np.full(len(points), FIRST_STEP * (end - start))
        used = np.zeros_like(paths)
        active = np.arange(len(points))
        while len(active):
            left = end - times[active]
            size = np.minimum(sizes[active], left)
            reached, good, growth = self._step(points[active], times[active], size, paths[active])
            moved = active[good]
            points[moved] = reached[good]
            times[moved] = np.where(size < left, times[active] + size, end)[good]
            sizes[active] = size * growth
            used[active] += 1
            stuck = (sizes[active] < LEAST_STEP) & ~good
            active = active[(times[active] < end) & ~stuck & (used[active] < MOST_STEPS)]
        self.steps[paths] += used
        return points, times == end

    def _step(
        self, points: Complex, times: Real, sizes: Real, paths: Index
    ) -> tuple[Complex, Mask, Real]:
        """One step of each path: its end, whether it may be kept, and by how much to grow."""
        charts, step = points.conj(), sizes[:, np.newaxis]

        def slope(x: Complex, t: Real) -> Complex:
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
        return _unit(reached), good, growth

    def _newton(
        self, charts: Complex, points: Complex, times: Real, paths: Index
    ) -> tuple[Complex, Real]:
        values, by_x, _ = self.homotopy(points, times, paths)
        step = _solved(charts, by_x, values)
        return points + step, np.linalg.norm(step, axis=-1)

    def polish(self, points: Complex, paths: Index) -> tuple[Complex, Mask]:
        """Regular endpoints to the last digits, and whether Newton's method settles there."""
        ends, charts = np.ones(len(points)), points.conj()
        for _ in range(3):
            points, moved = self._newton(charts, points, ends, paths)
        return _unit(points), moved <= SETTLED

    def condition(self, points: Complex, paths: Index) -> Real:
        """Condition at t = 1 of the derivatives, in the charts normal to the points."""
        _, by_x, _ = self.homotopy(points, np.ones(len(points)), paths)
        matrices = np.concatenate([by_x, points.conj()[:, np.newaxis]], axis=1)
        return np.asarray(np.linalg.cond(matrices))

    def extrapolate(self, points: Complex, paths: Index) -> tuple[Complex, Real]:
        """The endgame, from ``1 - t`` = NEAR: the ends of paths, and about how far off."""
        charts, distance = points.conj(), NEAR
        best, least = points.copy(), np.full(len(points), np.inf)
        samples, alive, last = [points], np.ones(len(points), dtype=bool), points
        for _ in range(QUARTERS):
            points = points.copy()
            points[alive], alive[alive] = self.track(
                points[alive], paths[alive], 1.0 - distance, 1.0 - distance / 4.0
            )
            distance /= 4.0
            scale = np.sum(charts * points, axis=-1, keepdims=True)
            samples = [*samples[1 - SAMPLES :], points / scale]
            if len(samples) < SAMPLES:
                continue
            estimate = _limit(samples)
            change = np.linalg.norm(estimate - last, axis=-1)
            better = alive & (change < least)
            best[better], least[better] = estimate[better], change[better]
            last = estimate
        return _unit(best), least


def _limit(samples: list[Complex]) -> Complex:
    """The limit of samples at distances that are each a quarter of the last, by Richardson."""
    before, after = (np.linalg.norm(b - a, axis=-1) for a, b in pairwise(samples[-3:]))
    with np.errstate(all="ignore"):
        windings = np.rint(-np.log(4.0) / np.log(after / before))
    windings = np.clip(np.nan_to_num(windings, nan=1.0), 1.0, MOST_WINDINGS)
    ratio = 4.0 ** (-1.0 / windings)[:, np.newaxis]
    for power in range(1, len(samples)):
        share = ratio**power
        samples = [(b - share * a) / (1.0 - share) for a, b in pairwise(samples)]
    return samples[0]


def _unit(points: Complex) -> Complex:
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
