"""Follow all paths of a homotopy to their ends, and say what each end is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kleinform.homotopy import tracker as tracking
from kleinform.homotopy.endgame import FAR, NEAR, SHORT, SINGULAR, VANISHING, Ends, endgame
from kleinform.homotopy.tracker import (
    PREDICTION,
    SETTLED,
    Complex,
    Homotopy,
    Index,
    Mask,
    Real,
    Tracker,
    unit,
)

__all__ = ["Endpoints", "follow"]

EPS = float(np.finfo(np.float64).eps)
#: The rounding errors of a system with coefficients of order 1, in units of eps.
ROUNDING = 16.0


@dataclass(frozen=True, eq=False)
class Endpoints:
    """Where the paths end, a row a path.

    Attributes
    ----------
    points : complex array (..., n + 1)
        Unit vectors whose x_0 is real and not negative: a real solution has a real vector.
    status : array (...) of str
        - ``"regular"``: a simple solution to which Newton's method converges, of a condition
          of at most 1e6, with ``|x_0|`` above its rounding error.
        - ``"singular"``: a multiple solution, or one of a continuum, with ``|x_0|`` above 1e-6.
          Solutions that are about 1e-6 apart count as one.
        - ``"infinity"``: x_0 = 0 within its error, and ``|x_0|`` is at most 1e-12. Where Newton's
          method does not converge, x_0 falls along the path with a positive power of ``1 - t``.
        - ``"failed"``: the path was lost, or its end is none of these for certain. The point
          is where it was lost.
    condition : array (...)
        Of the system's derivatives in the chart normal to the point; infinite where failed.
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
        that these are. Homogeneous in x, and analytic in t at 1; t is complex around it.
    starts : complex array (P, n + 1)
        Solutions at t = 0.
    prediction : float
        How far off a prediction may be; see PREDICTION.
    """
    count = len(starts)
    tracker = Tracker(homotopy, prediction, np.zeros(count, dtype=np.intp))
    starts = unit(starts)
    points, condition, status = _ends(tracker, starts)
    lost = np.flatnonzero(status == "failed")
    points[lost], condition[lost], status[lost] = _far_ends(tracker, starts[lost], lost)
    simple = np.flatnonzero(status == "regular")
    points[simple], status[simple] = _simple(tracker, points[simple], simple)
    phase = np.where(points[:, 0] == 0.0, 1.0, np.exp(-1j * np.angle(points[:, 0])))
    tries = np.ones(count, dtype=np.intp)
    return Endpoints(points * phase[:, np.newaxis], status, condition, tracker.steps, tries)


def _ends(tracker: Tracker, starts: Complex) -> Ends:
    """The ends of paths, of most by Newton's method."""
    near, paths = NEAR[0][0], np.arange(len(starts))
    points, alive = tracker.track(starts, paths, 0.0, 1.0 - near, most=tracking.MOST_STEPS)
    rest = np.flatnonzero(alive)
    ends, arrived = tracker.track(points[rest], rest, 1.0 - near, 1.0, first=1.0, most=SHORT)
    condition, status = np.full(len(starts), np.inf), np.full(len(starts), "failed", dtype="<U8")
    reached = rest[arrived]
    condition[reached] = np.linalg.cond(tracker.matrices(ends[arrived], reached)[1])
    sharp = condition <= 1.0 / SINGULAR
    status[sharp] = "regular"
    circled = np.flatnonzero(alive & ~sharp)
    condition[circled] = np.inf
    found = endgame(tracker, points[circled], circled, NEAR)
    points[sharp] = ends[sharp[rest]]
    points[circled], condition[circled], status[circled] = found
    return points, condition, status


def _far_ends(tracker: Tracker, starts: Complex, paths: Index) -> Ends:
    """The ends of paths that rounding spoils near t = 1, from larger circles."""
    points, alive = tracker.track(starts, paths, 0.0, 1.0 - FAR[0][0], most=tracking.MOST_STEPS)
    condition, status = np.full(len(starts), np.inf), np.full(len(starts), "failed", dtype="<U8")
    found = endgame(tracker, points[alive], paths[alive], FAR)
    points[alive], condition[alive], status[alive] = found
    return points, condition, status


def _simple(tracker: Tracker, points: Complex, paths: Index) -> tuple[Complex, NDArray[np.str_]]:
    """Simple ends to the last digits: finite where x_0 is more than its rounding error.

    That may be as much as 1e-9 where the condition is large: x_0 is neither 0 nor finite then,
    unless it is as small as at infinity.
    """
    points, moved = tracker.refine(points, paths, 1.0, 3)
    _, matrices = tracker.matrices(points, paths)
    by_rounding = np.linalg.norm(np.linalg.inv(matrices)[:, 0], axis=-1)
    x_0 = np.abs(points[:, 0])
    finite: Mask = x_0 > ROUNDING * EPS * by_rounding
    names = np.select([finite, x_0 <= VANISHING], ["regular", "infinity"], default="failed")
    return points, np.where(moved <= SETTLED, names, "failed")
