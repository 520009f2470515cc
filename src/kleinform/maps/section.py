"""Horizontal cross-sections of the workspace: conics, their arcs, and closed loops of them.

After I. A. Bonev and J. Ryu, "A geometrical method for computing the constant-orientation
workspace of 6-PRRS parallel manipulators", Mechanism and Machine Theory 36 (2001).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import pi

import numpy as np
from numpy.typing import NDArray

from kleinform.maps.curves import Curve, curves_of, meetings
from kleinform.maps.quadrics import Constraint

__all__ = ["Arc", "Loop", "Section", "section_of"]

Array = NDArray[np.float64]

#: Conics that agree so well, relative to their largest entries, are one.
SAME = 1e-12
#: Arcs that are shorter in their parameter are a point.
SHORT = 1e-12


@dataclass(frozen=True, eq=False)
class Arc:
    """A piece of a conic with the workspace on its left, from ``start`` to ``end``.

    Attributes
    ----------
    name, edge : str
        The limit that is met: "q1" and "high".
    curve : Curve
        ``.center``, ``.first``, ``.second`` (2,) and ``.closed``, as `Curve` says.
    start, end : float
        Its parameters, start > end where the arc runs backwards.
    """

    name: str
    edge: str
    curve: Curve
    start: float
    end: float

    @property
    def whole(self) -> bool:
        """Whether it is a full ellipse."""
        return self.curve.closed and abs(abs(self.end - self.start) - 2.0 * pi) < SHORT

    def points(self, count: int = 33) -> Array:
        """Points (count, 2) in m, both ends among them."""
        return self.curve.points(np.linspace(self.start, self.end, count))

    def enlarged(self, unit: float) -> Arc:
        """The same with lengths in m, from lengths in a unit [m]."""
        curve = self.curve
        if curve.closed:
            larger = Curve(unit * curve.center, unit * curve.first, unit * curve.second, True)
            return Arc(self.name, self.edge, larger, self.start, self.end)
        larger = Curve(unit * curve.center, curve.first, curve.second, False)
        return Arc(self.name, self.edge, larger, unit * self.start, unit * self.end)

    def backwards(self) -> Arc:
        """The same piece the other way."""
        return Arc(self.name, self.edge, self.curve, self.end, self.start)


@dataclass(frozen=True, eq=False)
class Loop:
    """Arcs that follow one another around; ``area`` [m²] is negative around a hole.

    Attributes
    ----------
    arcs : tuple of Arc
    gap : float
        The largest distance between the end of an arc and the start of the next [m].
    """

    arcs: tuple[Arc, ...]
    gap: float

    @cached_property
    def area(self) -> float:
        """By Green's theorem, in closed form."""
        return sum(arc.curve.swept(arc.start, arc.end) for arc in self.arcs)

    def points(self, count: int = 33) -> Array:
        """Points (arcs * count, 2) in m around the loop."""
        return np.concatenate([arc.points(count) for arc in self.arcs])


@dataclass(frozen=True, eq=False)
class Section:
    """The workspace at one height.

    Attributes
    ----------
    z : float
        [m]
    loops : tuple of Loop
        Outer ones counter-clockwise, those of holes clockwise.
    """

    z: float
    loops: tuple[Loop, ...]

    @property
    def area(self) -> float:
        """Area [m²]."""
        return sum(loop.area for loop in self.loops)

    @property
    def components(self) -> int:
        """Number of pieces: outer loops."""
        return sum(loop.area > 0.0 for loop in self.loops)

    def enlarged(self, unit: float) -> Section:
        """The same with lengths in m, from lengths in a unit [m]."""
        loops = tuple(
            Loop(tuple(arc.enlarged(unit) for arc in loop.arcs), unit * loop.gap)
            for loop in self.loops
        )
        return Section(unit * self.z, loops)

    @property
    def holes(self) -> int:
        """Number of holes in all pieces together."""
        return len(self.loops) - self.components


class Conic:
    """A form at one height."""

    def __init__(self, constraint: Constraint, index: int, z: float) -> None:
        lift = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, z], [0.0, 0.0, 1.0]])
        self.name, self.edge = constraint.name, constraint.end
        conic = lift.T @ constraint.forms[index].matrix @ lift
        self.matrix: Array = conic / max(abs(conic).max(), 1e-300)

    def __call__(self, point: Array) -> float:
        """g at a point (2,)."""
        full = np.append(point, 1.0)
        return float(full @ self.matrix @ full)

    def gradient(self, point: Array) -> Array:
        """Half of it (2,)."""
        half: Array = self.matrix[:2] @ np.append(point, 1.0)
        return half

    def same(self, other: Conic) -> bool:
        """Whether both are one conic with the same side."""
        return bool(abs(self.matrix - other.matrix).max() < SAME)


def section_of(constraints: list[Constraint], z: float, reach: float) -> Section:
    """The section at a height; no point of it is farther than ``reach`` from the Z axis."""
    clauses = _clauses(constraints, z)
    arcs = []
    for number, clause in enumerate(clauses):
        for own in clause:
            others = [[other] for other in clause if other is not own]
            rest = clauses[:number] + clauses[number + 1 :]
            for curve in curves_of(own.matrix):
                arcs += _arcs(own, curve, rest, others, reach)
    return Section(z, tuple(_linked(arcs)))


def _clauses(constraints: list[Constraint], z: float) -> list[list[Conic]]:
    """The conics of each constraint, without copies of earlier ones."""
    clauses: list[list[Conic]] = []
    for constraint in constraints:
        clause = [Conic(constraint, k, z) for k in range(len(constraint.forms))]
        single = [known[0] for known in clauses if len(known) == 1]
        if len(clause) > 1 or not any(clause[0].same(known) for known in single):
            clauses.append(clause)
    return clauses


def _arcs(
    own: Conic, curve: Curve, rest: list[list[Conic]], others: list[list[Conic]], reach: float
) -> list[Arc]:
    """The arcs of a curve that bound the workspace: there every other constraint holds.

    Of a constraint with two forms the other one must not hold.
    """
    far = 2.0 * reach
    cuts = [t for clause in rest + others for other in clause
            for t in meetings(curve, other.matrix, far)]  # fmt: skip
    if curve.closed:
        first = min(cuts, default=0.0)
        cuts = sorted([*cuts, first, first + 2.0 * pi])
    else:
        cuts = sorted([-far, *cuts, far])
    kept: list[Arc] = []
    for start, end in pairwise(cuts):
        point = curve.points(np.array((start + end) / 2.0))
        if end - start <= SHORT or not _bounds(point, rest, others):
            continue
        if kept and kept[-1].end == start:
            kept[-1] = Arc(own.name, own.edge, curve, kept[-1].start, end)
        else:
            kept.append(Arc(own.name, own.edge, curve, start, end))
    kept = _joined(kept, first, curve) if curve.closed and len(kept) > 1 else kept
    return [arc if _on_left(own, arc) else arc.backwards() for arc in kept]


def _joined(kept: list[Arc], first: float, curve: Curve) -> list[Arc]:
    """The last arc and the first as one, if they meet where the ellipse was opened."""
    head, tail = kept[0], kept[-1]
    if head.start != first or tail.end != first + 2.0 * pi:
        return kept
    whole = Arc(head.name, head.edge, curve, tail.start, head.end + 2.0 * pi)
    return [*kept[1:-1], whole]


def _bounds(point: Array, rest: list[list[Conic]], others: list[list[Conic]]) -> bool:
    held = all(max(conic(point) for conic in clause) >= 0.0 for clause in rest)
    return held and all(clause[0](point) < 0.0 for clause in others)


def _on_left(own: Conic, arc: Arc) -> bool:
    middle = (arc.start + arc.end) / 2.0
    tangent = arc.curve.tangent(middle)
    inwards = own.gradient(arc.curve.points(np.array(middle)))
    return bool(tangent[0] * inwards[1] - tangent[1] * inwards[0] > 0.0)


def _linked(arcs: list[Arc]) -> list[Loop]:
    """Loops of arcs, each followed by the one that starts nearest to its end."""
    loops = [Loop((arc,), 0.0) for arc in arcs if arc.whole]
    left = [arc for arc in arcs if not arc.whole]
    while left:
        chain, gap = [left.pop(0)], 0.0
        while True:
            end = chain[-1].points(2)[1]
            away = [float(np.hypot(*(arc.points(2)[0] - end))) for arc in left]
            home = float(np.hypot(*(chain[0].points(2)[0] - end)))
            if home <= min(away, default=np.inf):
                gap = max(gap, home)
                break
            nearest = int(np.argmin(away))
            gap = max(gap, away[nearest])
            chain.append(left.pop(nearest))
        loops.append(Loop(tuple(chain), gap))
    return loops
