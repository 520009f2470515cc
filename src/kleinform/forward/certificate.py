"""A proof that the assembly modes found are all there are, with python-flint.

Each candidate gets a box that is proven to hold exactly one solution. As many disjoint boxes
as Bézout's theorem allows solutions hold all of them, real and complex.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kleinform.precision import working_precision

if TYPE_CHECKING:
    from kleinform.forward.balls import Box, Chart

__all__ = ["Certificate", "certify"]

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
Complex = NDArray[np.complex128]

#: Pairs ±(n_1, n_2), real and complex, of the forward displacement.
PAIRS = 32
#: Bits.
PRECISION = 128
#: Covers the roundings of one subtraction, one sum and their comparison.
ROUNDING = 1.0 + 1e-15


@dataclass(frozen=True, eq=False)
class Certificate:
    """What is proven about the assembly modes of all joint values within a tolerance.

    Attributes
    ----------
    complete : bool
        Proven: the boxes hold all solutions, real and complex, and each of them one.
    reason : str
        What was proven, or why nothing was.
    tolerance : float
        Proven for all joint values ``q_j (1 ± tolerance)``.
    chart : str
        ``"directions"``: the boxes of all ±(n_1, n_2) are disjoint. ``"circles"``: those of
        (B_1, B_2, B_3) are; there two modes may share their directions.
    precision : int
        Bits of the arithmetic.
    real : int
        Assembly modes proven: real pairs ±(n_1, n_2).
    pairs : int
        Pairs with a box of their own, 32 when complete.
    centers : complex array (pairs, 2, 3)
        One (n_1, n_2) of each pair.
    radii : array (pairs,)
        The solution is within ``|x - center| <= radius`` in every coordinate.
    is_real : bool array (pairs,)
    """

    complete: bool
    reason: str
    tolerance: float
    chart: str
    precision: int
    real: int
    pairs: int
    centers: Complex
    radii: Array
    is_real: Bools


def certify(radius: float, joints: Array, tolerance: float, candidates: Complex) -> Certificate:
    """Prove that the solutions near the candidates are all there are.

    Parameters
    ----------
    radius : float
        Radius a of the base circle [m], as it is.
    joints : array (6,)
    tolerance : float
        Relative; everything is proven for all joint values ``q_j (1 ± tolerance)``.
    candidates : complex array (k, 2, 3)
        Approximations of one (n_1, n_2) of each pair. Those of a conjugate, copies, and rows
        with NaN do no harm.

    Raises
    ------
    MissingExtraError
        python-flint is not installed.
    """
    # Approximations may overflow: then nothing is proven.
    with working_precision(PRECISION), np.errstate(all="ignore"):
        from kleinform.forward import charts

        problem = charts.Problem.of(radius, joints, tolerance)
        first = _attempt(charts.Directions(problem, candidates), tolerance)
        if first.complete:
            return first
        second = _attempt(charts.Circles(problem, candidates), tolerance)
    return second if second.pairs > first.pairs else first


def _attempt(chart: Chart, tolerance: float) -> Certificate:
    """The certificate of one chart."""
    from kleinform.forward.balls import enclose

    boxes: list[Box] = []
    lost: list[int] = []
    for index in _leaders(chart):
        box = enclose(chart, chart.candidates[index], int(chart.labels[index]))
        if box is None:
            lost.append(index)
        else:
            boxes += [box] if box.is_real else [box, box.conjugate()]
    boxes, copies = _disjoint(boxes, chart.antipodal)
    pairs = [chart.directions(box) for box in boxes]
    is_real = np.array([box.is_real for box in boxes], dtype=bool)
    real = int(np.sum(is_real))
    complete = len(boxes) == PAIRS
    if complete:
        reason = (
            f"{PAIRS} disjoint boxes have one pair of solutions each, as many as Bézout's "
            f"theorem allows, {real} of them real"
        )
    else:
        reason = f"{len(boxes)} of {PAIRS} pairs of solutions have a box"
        reason += _obstacle(chart, lost, copies)
    return Certificate(
        complete,
        f"chart {chart.name}, {PRECISION} bits, joint values within a relative "
        f"{tolerance:.2g}: {reason}",
        tolerance,
        chart.name,
        PRECISION,
        real,
        len(boxes),
        np.array([center for center, _ in pairs], dtype=complex).reshape(-1, 2, 3),
        np.array([radius for _, radius in pairs]),
        is_real,
    )


def _leaders(chart: Chart) -> list[int]:
    """All candidates but the second of two that are each other's nearest conjugate.

    A box has its conjugate's for free.
    """
    if not len(chart.candidates):
        return []
    nearest = np.argmin(_separations(chart, chart.candidates.conj()), axis=1)
    return [
        index for index, other in enumerate(nearest) if other >= index or nearest[other] != index
    ]


def _disjoint(boxes: list[Box], antipodal: bool) -> tuple[list[Box], list[tuple[int, int]]]:
    """Disjoint ones among the boxes, and the labels of one kept and one left out for it."""
    if not boxes:
        return [], []
    centers = np.stack([box.center for box in boxes])
    radii = np.array([box.radius for box in boxes])
    reach = ROUNDING * (radii[:, np.newaxis] + radii)
    meets = _distances(centers, centers) <= reach
    np.fill_diagonal(meets, False)
    if antipodal:
        meets |= _distances(centers, -centers) <= reach
    if not meets.any():
        return boxes, []
    kept: list[int] = []
    copies: list[tuple[int, int]] = []
    for index, box in enumerate(boxes):
        met = [other for other in (*kept, index) if meets[index, other]]
        if met:
            copies.append((boxes[met[0]].label, box.label))
        else:
            kept.append(index)
    return [boxes[index] for index in kept], copies


def _separations(chart: Chart, points: Complex) -> Array:
    """Distances of candidates from other points, or from their opposites; inf for NaN."""
    distances = _distances(chart.candidates, points)
    if chart.antipodal:
        distances = np.minimum(distances, _distances(chart.candidates, -points))
    return np.nan_to_num(distances, nan=np.inf)


def _obstacle(chart: Chart, lost: list[int], copies: list[tuple[int, int]]) -> str:
    """What is in the way of more boxes."""
    if lost:
        separations = _separations(chart, chart.candidates)[lost[0]]
        separations[lost[0]] = np.inf
        return (
            f"; near candidate {chart.labels[lost[0]]} none is proven to hold exactly one, the "
            f"next candidate is {np.min(separations):.1e} away"
        )
    if copies:
        return (
            "; those of candidates {} and {} meet: they lead to one pair, or to two that cannot "
            "be separated".format(*copies[0])
        )
    return f"; {len(chart.candidates)} candidates are not enough"


def _distances(first: Complex, second: Complex) -> Array:
    """Distances (k, m) of points (k, n) and (m, n), or less: the largest of all real parts."""
    parts = (first[:, np.newaxis] - second).view(np.float64)
    distances: Array = np.max(np.abs(parts), axis=-1)
    return distances
