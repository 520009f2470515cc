"""(13), (14), (20): the Klein form, whatever the mechanism."""

from __future__ import annotations

from sympy import Expr, eye

from derivations.algebra.identities import Identity
from derivations.algebra.screws import POLARITY, Klein, Screw, line, prismatic
from derivations.algebra.vectors import Cross, Dot, components, matrix, scalar, vector

ONE, OTHER = matrix("screw_a", 6, 1), matrix("screw_b", 6, 1)
S1, S2, M1, M2, ARM, SHIFT = (vector(name) for name in ("s_a", "s_b", "m_a", "m_b", "arm", "shift"))


def identities() -> list[Identity]:
    """Everything that the paper says about the Klein form."""
    return [*form(), *operator(), *lines(), *translations()]


def form() -> list[Identity]:
    """A symmetric bilinear form."""
    factor = scalar("factor")
    apart = factor * Klein(ONE, OTHER) + Klein(OTHER, OTHER)
    printed = Dot(S1, M2) + Dot(S2, M1)
    return [
        Identity(
            "Klein form",
            "{$1; $2} = s1·s_O2 + s2·s_O1",
            lambda: [components(Klein(Screw(S1, M1), Screw(S2, M2)) - printed)],
            number="(13)",
        ),
        Identity(
            "Klein form symmetric",
            "{$1; $2} = {$2; $1}",
            lambda: [components(Klein(ONE, OTHER) - Klein(OTHER, ONE))],
            number="(13)",
        ),
        Identity(
            "Klein form linear",
            "{f $1 + $2; $2} = f {$1; $2} + {$2; $2}",
            lambda: [components(Klein(factor * ONE + OTHER, OTHER) - apart)],
            number="(13)",
        ),
    ]


def operator() -> list[Identity]:
    """The operator Δ, and what a change of pole does."""
    moved = [Screw(s, m + Cross(s, SHIFT)) for s, m in ((S1, M1), (S2, M2))]
    return [
        Identity(
            "polarity",
            "{$1; $2} = $1ᵀ Δ $2 and Δ Δ = 1",
            lambda: [by_polarity(), POLARITY * POLARITY - eye(6)],
            number="(13), (20)",
        ),
        Identity(
            "Klein form at another pole",
            "a change of pole, s_O → s_O + s × shift, leaves {$1; $2} as it is",
            lambda: [components(Klein(*moved) - Klein(Screw(S1, M1), Screw(S2, M2)))],
            number="(13)",
        ),
    ]


def by_polarity() -> Expr:
    """$1ᵀ Δ $2, less the form in components."""
    one, other = components(ONE), components(OTHER)
    return (one.T * POLARITY * other)[0, 0] - components(Klein(ONE, OTHER))


def lines() -> list[Identity]:
    """Lines that are reciprocal."""
    return [
        Identity(
            "lines that meet",
            "lines through a common point are reciprocal",
            lambda: [components(Klein(line(S1, ARM), line(S2, ARM)))],
            number="(13), (14)",
        ),
        Identity(
            "parallel lines",
            "parallel lines are reciprocal",
            lambda: [components(Klein(line(S1, ARM), line(S1, SHIFT)))],
            number="(13), (14)",
        ),
    ]


def translations() -> list[Identity]:
    """A line and a prismatic joint."""
    length = Dot(S1, S1).expanded() - 1
    return [
        Identity(
            "prismatic joint across a line",
            "a translation normal to a line is reciprocal to it",
            lambda: [components(Klein(line(S1, ARM), prismatic(Cross(S1, S2))))],
            number="(13)",
        ),
        Identity(
            "prismatic joint along a line",
            "a translation along a line has the Klein form 1 with it, for one unit vector",
            lambda: [components(Klein(line(S1, ARM), prismatic(S1))) - 1],
            (length,),
            "(13)",
        ),
    ]
