"""Where paths end that Newton's method cannot follow to t = 1: Cauchy's integral around it.

Near t = 1 a path is a series in powers of ``(1 - t)^(1/w)``, w its winding number: after w
turns of t around 1 it is back where it was. The mean over these turns is its end, with an
error that falls with a high power of the radius (Morgan, Sommese, Wampler, Numer. Math. 58,
1991), and there t stays away from the singularity. The mean of ``log |x_0|`` falls by
``v/w log 4`` from one circle to another of a quarter of its radius, where ``x_0`` begins with the
power v (Jensen's formula): v is 0 for a finite end, and a positive integer at infinity.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kleinform.homotopy.tracker import SETTLED, Complex, Index, Mask, Real, Tracker, unit

__all__ = ["FAR", "NEAR", "SHORT", "SINGULAR", "VANISHING", "Ends", "endgame"]

#: Points, their condition, and names.
Ends = tuple[Complex, Real, NDArray[np.str_]]

#: The radii of circles around t = 1, and the turns until a path counts as one that does not
#: close: far from t = 1 it may wind around other points, too. On the smallest circle rounding
#: spoils even a double root.
NEAR = tuple((4.0**-k, min(8 * (k - 4), 32)) for k in range(5, 21))
#: Some paths go to infinity so fast that rounding spoils them sooner; few wind around others.
FAR = tuple((2.0**-k, 8) for k in range(2, 11))
#: Points on a turn.
CORNERS = 8
#: A path is back where it was within this share of how far it went.
CLOSED = 1e-3
#: Steps of one path on one part of the endgame. Fewer than 12 are usual.
SHORT = 64
#: The error of the mean of CORNERS points a turn falls with that power of the radius; this one
#: is counted on. What two circles then say of the error of the second is to be below AGREEMENT.
ORDER = CORNERS - 2
AGREEMENT = 1e-9
RESIDUAL = 1e-12
#: The mean of x_0 of an end at infinity is 0 to its rounding, long before the error that is
#: counted on says so. The power does not tell 0 from what is small beside x_0 on both circles.
#: Beside a twelvefold point rounding is more than this on small circles, and no name is found.
VANISHING = 1e-12
#: How far ``v`` may be from an integer.
INTEGER = 0.1
#: Reciprocal condition below which an end is singular. Rounding splits a double root into
#: two that are 1e-8 apart, and the condition of each is one over that.
SINGULAR = 1e-6


@dataclass(frozen=True, eq=False)
class _Circle:
    """Paths around t = 1: an integral a path.

    Attributes
    ----------
    radius : float
    windings : int array (P,)
        Turns until a path was back where it was; 0 where it was not.
    ends : complex array (P, n + 1)
        Unit vectors.
    logs : array (P,)
        The mean of ``log |x_0|``, in the chart normal to the end.
    noise : array (P,)
        The last step of Newton's method, at most, or how far from its start a path came back.
    """

    radius: float
    windings: Index
    ends: Complex
    logs: Real
    noise: Real

    def of(self, rows: Index | Mask) -> _Circle:
        return replace(
            self,
            windings=self.windings[rows],
            ends=self.ends[rows],
            logs=self.logs[rows],
            noise=self.noise[rows],
        )


def endgame(
    tracker: Tracker, points: Complex, paths: Index, circles: tuple[tuple[float, int], ...]
) -> Ends:
    """The ends of paths from where they are on the first circle, their condition and names."""
    found, condition = points.copy(), np.full(len(points), np.inf)
    status = np.full(len(points), "failed", dtype="<U8")
    rest = np.arange(len(points))
    last = _circle(tracker, points, paths, points, *circles[0])
    for radius, turns in circles[1:]:
        if not len(rest):
            break
        start, end = 1.0 - last.radius, 1.0 - radius
        points, arrived = tracker.track(points, paths[rest], start, end, most=SHORT)
        points, rest, last = points[arrived], rest[arrived], last.of(arrived)
        # The chart normal to the end, as far as it is known, has no point at infinity nearby.
        centres = np.where(last.windings[:, np.newaxis] > 0, last.ends, points)
        circle = _circle(tracker, points, paths[rest], centres, radius, turns)
        names, conditions = _names(tracker, last, circle, paths[rest])
        known = names != "failed"
        found[rest[known]] = circle.ends[known]
        status[rest[known]], condition[rest[known]] = names[known], conditions[known]
        # Rounding grows from circle to circle.
        useful = ~known & (circle.noise <= AGREEMENT)
        points, rest, last = points[useful], rest[useful], circle.of(useful)
    return found, condition, status


def _circle(
    tracker: Tracker, points: Complex, paths: Index, centres: Complex, radius: float, turns: int
) -> _Circle:
    """Follow paths around t = 1 until each is back; means in the charts normal to centres."""
    charts, count = centres.conj(), len(points)
    first = points / np.sum(charts * points, axis=-1, keepdims=True)
    sums, windings = np.zeros_like(points), np.zeros(count, dtype=np.intp)
    logs, noise, spread = np.zeros((3, count))
    points, open_ = points.copy(), np.arange(count)
    for corner in range(turns * CORNERS):
        start, end = (1.0 - radius * np.exp(2j * np.pi * k / CORNERS) for k in (corner, corner + 1))
        reached, arrived = tracker.track(
            points[open_], paths[open_], start, end, first=1.0, most=SHORT
        )
        open_ = open_[arrived]
        points[open_], moved = tracker.refine(reached[arrived], paths[open_], end, 2)
        sample = points[open_] / np.sum(charts[open_] * points[open_], axis=-1, keepdims=True)
        away = np.linalg.norm(sample - first[open_], axis=-1)
        sums[open_] += sample
        with np.errstate(divide="ignore"):
            logs[open_] += np.log(np.abs(sample[:, 0]))
        noise[open_] = np.maximum(noise[open_], moved)
        spread[open_] = np.maximum(spread[open_], away)
        if (corner + 1) % CORNERS == 0:
            back = away <= CLOSED * spread[open_] + SETTLED
            windings[open_[back]] = (corner + 1) // CORNERS
            noise[open_[back]] = np.maximum(noise[open_[back]], away[back])
            open_ = open_[~back]
        if not len(open_):
            break
    number = CORNERS * np.maximum(windings, 1)
    means = sums / number[:, np.newaxis]
    with np.errstate(divide="ignore"):
        logs = logs / number - np.log(np.linalg.norm(means, axis=-1))
    return _Circle(radius, windings, unit(means), logs, noise)


def _names(
    tracker: Tracker, last: _Circle, circle: _Circle, paths: Index
) -> tuple[NDArray[np.str_], Real]:
    """What two circles say of the ends, and their condition; "failed": not enough.

    An end that Newton's method finds is "regular", also at infinity.
    """
    ends, windings = circle.ends, circle.windings
    along = np.sum(last.ends.conj() * ends, axis=-1, keepdims=True)
    with np.errstate(all="ignore"):
        change = np.linalg.norm(ends / along - last.ends, axis=-1)
        power = windings * (last.logs - circle.logs) / np.log(last.radius / circle.radius)
        integer = (np.abs(power - np.rint(power)) <= INTEGER) & (power > 0.5)
    error = np.maximum(change * (circle.radius / last.radius) ** ORDER, circle.noise)
    agreed = (windings > 0) & (last.windings == windings) & (error <= AGREEMENT)
    condition = np.full(len(ends), np.inf)
    values, matrices = tracker.matrices(ends[agreed], paths[agreed])
    condition[agreed] = np.linalg.cond(matrices)
    agreed[agreed] = np.linalg.norm(values, axis=-1) <= RESIDUAL
    sharp = condition <= 1.0 / SINGULAR
    x_0 = np.abs(ends[:, 0])
    zero = np.minimum(error, VANISHING)
    # All of the larger circle may be at infinity, to rounding: there is no power then.
    vanishing = (x_0 <= zero) & (integer | (np.exp(last.logs) <= zero))
    # Closer to infinity than that, a multiple end may be one or several at infinity.
    resolved = x_0 >= SINGULAR
    names = np.select(
        [~agreed, sharp & (windings == 1), sharp, vanishing, resolved],
        ["failed", "regular", "failed", "infinity", "singular"],
        default="failed",
    )
    return names, condition
