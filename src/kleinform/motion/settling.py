"""When exactly something is met: where a polynomial through the values before it vanishes.

The values of what is touched tell when only to the root of their rounding, 1e-7 s or so: down
there they all count as zero. Their slope tells it to the rounding itself over the width of the
values that it is taken from. So the time is that at which a polynomial over a wide stretch turns
or, where it changes its sign, vanishes. The stretch lies before the meeting: what a motion does
after it, such as to rest or to end, does not matter.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial import Chebyshev, polynomial
from numpy.typing import NDArray

from kleinform.motion.paths import RESOLUTION
from kleinform.zero import EPS

__all__ = ["TOLD", "settled", "touched"]

Array = NDArray[np.float64]
#: A polynomial of this degree over so many values, which lie no farther apart than samples do.
DEGREE = 6
VALUES = 33
#: So many roundings of the largest value are left between a smooth quantity and a polynomial.
ROUNDINGS = 16.0
#: Values that change by less than so many times their blur show no more than their rounding.
TELLING = 1e3
#: A parabola is seen when it rises by so many times what counts as zero.
VISIBLE = 4.0
#: Times are told to this [s]; a dip is a touch when it is no deeper than what the motion makes
#: of it in this time.
TOLD = 1e-9


def settled(
    at: Callable[[Array], tuple[Array, Array]], start: float, time: float, step: float
) -> float:
    """The time [s] at which a quantity that comes down to zero is met.

    Parameters
    ----------
    at : callable
        From increasing times (T,) to the values of the quantity (T,), or fewer, and up to what
        size they count as zero (T,).
    start, time, step : float
        The first sample, when the value first counts as zero, and how far samples are apart [s].

    Returns
    -------
    float
        From the stretch that leaves the least doubt about the slope; ``time`` where none of
        them is smooth.
    """
    found, doubt = time, np.inf
    width = min((VALUES - 1) * step, time - start)
    while width > RESOLUTION:
        times = np.linspace(time - width, time, VALUES)
        value, zero = at(times)
        if len(value) == VALUES and np.isfinite(value).all():
            blur = float(zero.max() + ROUNDINGS * EPS * abs(value).max())
            if np.ptp(value) <= TELLING * blur:
                break
            fit = Chebyshev.fit(times - time, value, DEGREE, domain=[-width, 0.0])
            residual = float(abs(fit(times - time) - value).max())
            if residual <= blur:
                if residual / width >= doubt:
                    break
                doubt = residual / width
                found = time + _met(fit, blur, width)
        width *= 0.5
    return found


def _met(fit: Chebyshev, blur: float, width: float) -> float:
    """Where a polynomial turns at zero or passes it, near 0; 0 where it comes to rest there."""
    slope, bend = fit.deriv(), fit.deriv(2)
    for turn in _nearest(slope, width):
        if abs(fit(turn)) <= blur and bend(turn) > 0.0:
            away = 2.0 * np.sqrt(2.0 * blur / bend(turn))
            # A parabola is 4 blurs higher there, on both sides.
            if min(fit(turn - away), fit(turn + away)) >= 2.0 * blur:
                return turn
    for root in _nearest(fit, width):
        if slope(root) < 0.0:
            away = -2.0 * blur / slope(root)
            # A straight line is 2 blurs higher there, and 2 lower beyond.
            if blur <= fit(root - away) <= 4.0 * blur and fit(root + away) <= -blur:
                return root
    return 0.0


def _nearest(fit: Chebyshev, width: float) -> list[float]:
    """The real root of a polynomial that is nearest to 0, if one is in a quarter of a width."""
    roots = fit.roots()
    real = np.real(roots[(np.imag(roots) == 0.0) & (abs(roots) <= 0.25 * width)])
    return [float(root) for root in real[np.argsort(abs(real))[:1]]]


def touched(times: Array, value: Array, zero: Array) -> float | None:
    """Where a quantity turns that does not change its sign, if it comes down to zero there."""
    middle, most = times[len(times) // 2], zero.max()
    unit = times[-1] - middle
    share = (times - middle) / unit
    floor, slope, bend = parabola = polynomial.polyfit(share, value, 2)
    if bend <= VISIBLE * most or abs(slope) > 2.0 * bend:
        return None
    if abs(polynomial.polyval(share, parabola) - value).max() > most:  # it turns otherwise
        return None
    turn = -0.5 * slope / bend
    near = floor + 0.5 * slope * turn <= most + bend * (TOLD / unit) ** 2
    return float(middle + unit * turn) if near else None
