"""Section III: how many solutions the six quadratics have, at one example and so in general.

The count is taken modulo a prime at which 3 is a square. Reduction modulo the prime is a map
of rings, so a polynomial that keeps its formal degree there has that degree, and one that is
coprime to another there is coprime to it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from sympy import GF, Expr, ImmutableDenseMatrix, Integer, Poly, Rational, isprime, sqrt, symbols
from sympy.polys.matrices import DomainMatrix

from derivations.algebra.determinants import sylvester
from derivations.algebra.identities import Identity, remainder
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Cross, Dot, Norm, matrix
from derivations.uncoupled.circles import ANGLE, CONE, HALVES, STARTS, circles_graph
from derivations.uncoupled.closure import LENGTHS
from derivations.uncoupled.eliminant import (
    arm,
    cosine,
    eliminant,
    eliminant_graph,
    reference,
    sine,
)
from derivations.uncoupled.geometry import a, c, n1
from derivations.uncoupled.identities.facts import Facts

PRIME, ROOT_OF_3 = 1_000_033, 122_403
#: Pairs ±(n_1, n_2).
PAIRS = 32
#: Half angles of leg 1, as tangents.
HALF_ANGLES = (Integer(0), Integer(1), Rational(1, 2), Rational(-1, 3))
T, S = HALVES
#: 1/|b_1 − c| and 1/|reference × n_1|.
PER_SPAN, PER_ACROSS = symbols("per_span per_across", positive=True)


def identities() -> list[Identity]:
    """The count, and that both reductions have the same resultant."""
    return [count(), one_resultant()]


def example() -> Facts:
    """A manipulator and joint values in rational numbers, both half angles from t_i."""
    values: Facts = {a: Integer(1), c: ImmutableDenseMatrix([Rational(1, 4), Rational(-1, 3), 2])}
    values |= dict(zip(LENGTHS, (Integer(2), Rational(3, 2), Rational(7, 3)), strict=True))
    return values | dict(zip(STARTS, map(Integer, (1, 0, 1, 0)), strict=True))


def modulo(number: Expr) -> Integer:
    """A number of Q(√3) in the field of the prime."""
    whole = number.xreplace({sqrt(3): Integer(ROOT_OF_3)})
    return Integer(whole.p * pow(whole.q, -1, PRIME) % PRIME)


def powers_of(table: ImmutableDenseMatrix, half: Expr) -> list[Expr]:
    """Each column of a table as a polynomial in a half angle."""
    return [sum(table[k, m] * half**k for k in range(5)) for m in range(table.cols)]


@cache
def finite() -> Unfolding:
    return Unfolding(circles_graph(), example(), settle=modulo)


def polynomial(name: str, half: Expr) -> Poly:
    """A polynomial in one half angle, over the finite field."""
    (value,) = powers_of(finite()(matrix(name, 5, 1)), half)
    return Poly(value, half, modulus=PRIME)


def count() -> Identity:
    """The degree of the resultant of both conditions.

    A zero t of it has an s, and both have a pair ±(n_1, n_2) unless an arm v_i has v_i·v_i = 0.
    Then the resultant and v_1·v_1 share a zero; or the conditions leave v_2·M_3 v_2 = 0, which
    shares one with v_2·v_2. Other t are other lines CB_1; simple zeros are isolated solutions.
    """

    def difference() -> list[Integer]:
        rows = sylvester(*(powers_of(finite()(table), T) for table in (ANGLE, CONE)))
        determinant = DomainMatrix.from_Matrix(rows).convert_to(GF(PRIME)[T]).det()
        resultant = Poly(determinant.as_expr(), T, modulus=PRIME)
        first, second, cone = polynomial("N1", T), polynomial("N2", S), polynomial("C2", S)
        return [
            Integer(not isprime(PRIME)),
            Integer((ROOT_OF_3**2 - 3) % PRIME),
            Integer(resultant.degree() - PAIRS),
            Integer(resultant.gcd(resultant.diff()).degree()),
            Integer(resultant.gcd(first).degree()),
            Integer(second.degree() - 4),
            Integer(second.gcd(cone).degree()),
        ]

    return Identity(
        "number of solutions",
        "at one example the resultant in s of both conditions has degree 32 in t and no double "
        "zero, and no arm has length 0 there: 32 pairs ±(n_1, n_2), which are 64 solutions, and "
        "six quadratics have no more (2⁶); so it is at almost every problem",
        difference,
        number="(5), (6)",
    )


def settled(*relations: Expr) -> Callable[[Expr], Expr]:
    """Reduces a number by the relations of its roots."""
    return lambda number: remainder(number, relations)


@cache
def exact_conditions() -> tuple[ImmutableDenseMatrix, ...]:
    """The tables of both conditions at the example."""
    unfold = Unfolding(circles_graph(), example(), settle=settled())
    return unfold(ANGLE), unfold(CONE)


def by_circles(half: Expr) -> Expr:
    """The resultant of both conditions at a half angle of leg 1."""
    rows = sylvester(*(powers_of(table, half) for table in exact_conditions()))
    exact = DomainMatrix.from_Matrix(rows, extension=True).to_field()
    return exact.domain.to_sympy(exact.det())


def by_leg(half: Expr) -> Expr:
    """The eliminant at a half angle of leg 1, times (1 + t²)^16 |b_1 − c|^16."""
    angle = {cosine: (1 - half**2) / (1 + half**2), sine: 2 * half / (1 + half**2)}
    values: Facts = {**example(), **angle, reference: ImmutableDenseMatrix([0, 0, 1])}
    plain = Unfolding(eliminant_graph(), values)
    span = plain(Dot(arm, arm))
    across = plain(Dot(Cross(reference, arm), Cross(reference, arm)))
    relations = (PER_SPAN**2 - 1 / span, PER_ACROSS**2 - span / across)
    roots = {1 / Norm(arm): PER_SPAN, 1 / Norm(Cross(reference, n1)): PER_ACROSS}
    unfold = Unfolding(eliminant_graph(), values | roots, settle=settled(*relations))
    return unfold(eliminant) * ((1 + half**2) ** 2 * span) ** 8


def one_resultant() -> Identity:
    """Both reductions vanish at the same angles of leg 1."""

    def difference() -> list[Expr]:
        pairs = [(by_leg(half), by_circles(half)) for half in HALF_ANGLES]
        leg, circles = pairs[0]
        return [leg * other - own * circles for own, other in pairs[1:]]

    return Identity(
        "one resultant",
        "at the example, eliminant (1 + t²)^16 |b_1 − c|^16 over the resultant in s of both "
        "conditions is the same number at four angles of leg 1",
        difference,
        number="(5), (6)",
    )
