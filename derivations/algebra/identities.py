"""Claims that SymPy reduces to exactly zero, and claims that a counter-example refutes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from sympy import (
    QQ,
    Basic,
    Dummy,
    Expr,
    Matrix,
    Rational,
    S,
    default_sort_key,
)
from sympy.polys.orderings import grevlex
from sympy.polys.rings import PolyElement, PolyRing

__all__ = [
    "Counterexample",
    "Identity",
    "IdentityError",
    "remainder",
    "vanishes",
]


class IdentityError(Exception):
    """A claim did not reduce to zero; the message shows what is left of it."""


@dataclass(frozen=True)
class Identity:
    """A claim of the form "this is zero", and how to build it.

    Parameters
    ----------
    name
        A short name, unique.
    claim
        The claim in one line of plain text.
    difference
        Called without arguments, gives the expressions that must vanish.
    relations
        Polynomials that vanish by the meaning of the symbols (a unit vector, a sine and
        its cosine). Their leading terms must be coprime, so that they are a Gröbner basis
        and remainder zero is a proof.
    number
        The number of the paper's equation that it bears on, or "".
    """

    name: str
    claim: str
    difference: Callable[[], Iterable[Basic]]
    relations: tuple[Expr, ...] = ()
    number: str = ""

    def prove(self) -> int:
        """Reduce every expression to exactly zero and return how many there were."""
        count = 0
        entries = list(_scalars(self.difference()))
        ideal = Ideal(self.relations, entries)
        for entry in entries:
            rest = ideal.remainder(entry)
            if rest != 0:
                raise IdentityError(f"{self.name}: {self.claim}\nnot zero, this is left: {rest}")
            count += 1
        if count == 0:
            raise IdentityError(f"{self.name}: {self.claim}\nthere was nothing to prove")
        return count


@dataclass(frozen=True)
class Counterexample:
    """A printed claim, a pose in exact numbers at which it fails, and what is true instead.

    ``number`` is "(8)" where the numbered equation itself is wrong, and names the place where
    it is the text. ``check`` computes the pose and returns the exact facts that contradict
    the claim; it raises `IdentityError` if they do not.
    """

    name: str
    claim: str
    correction: str
    check: Callable[[], dict[str, Expr]]
    number: str = ""


def vanishes(expression: Basic, relations: tuple[Expr, ...] = ()) -> bool:
    """Whether every entry of an expression is exactly zero, given the relations."""
    return all(remainder(entry, relations) == 0 for entry in _scalars([expression]))


def remainder(expression: Expr, relations: tuple[Expr, ...]) -> Expr:
    """The numerator of an expression, reduced by the relations and by √3·√3 = 3."""
    return Ideal(relations, (expression,)).remainder(expression)


class Ideal:
    """Relations, and the ring of polynomials that some expressions live in.

    Expressions become polynomials over the rational numbers right away: to bring them over
    one denominator as trees of symbols takes several times as long.
    """

    def __init__(self, relations: tuple[Expr, ...], expressions: Iterable[Expr]):
        atoms = {atom for entry in (*relations, *expressions) for atom in _atoms(entry)}
        self.atoms = sorted(atoms, key=default_sort_key)
        self.ring = PolyRing([Dummy(str(atom)) for atom in self.atoms] or "none", QQ, grevlex)
        self.generators = dict(zip(self.atoms, self.ring.gens, strict=False))
        self.fractions: dict[Expr, tuple[PolyElement, Counter]] = {}
        self.rules = [self.fraction(rule)[0] for rule in relations]
        self.rules += [
            generator**2 - int(atom**2)
            for atom, generator in self.generators.items()
            if atom.is_number and (atom**2).is_Integer
        ]
        self._check_coprime()

    def remainder(self, expression: Expr) -> Expr:
        """What is left of the numerator."""
        numerator, denominator = self.fraction(expression)
        if any(not factor.rem(self.rules) for factor in denominator):
            raise IdentityError(f"{expression} divides by zero")
        rest = numerator.rem(self.rules) if self.rules else numerator
        return rest.as_expr(*self.atoms) if rest else S.Zero

    def fraction(self, expression: Expr) -> tuple[PolyElement, Counter]:
        """Numerator, and the factors of the denominator with their powers."""
        if expression not in self.fractions:
            self.fractions[expression] = self._fraction(expression)
        return self.fractions[expression]

    def _fraction(self, expression: Expr) -> tuple[PolyElement, Counter]:
        if expression.is_Rational:
            return self.ring.ground_new(QQ(expression.p, expression.q)), Counter()
        if expression.is_Add:
            return self._sum([self.fraction(term) for term in expression.args])
        if expression.is_Mul:
            product: PolyElement = self.ring.one
            below: Counter = Counter()
            for factor in expression.args:
                numerator, denominator = self.fraction(factor)
                product, below = product * numerator, below + denominator
            return product, below
        base, power = _as_power(expression)
        numerator, denominator = (
            (self.generators[base], Counter()) if base in self.generators else self.fraction(base)
        )
        if power < 0:
            numerator, denominator = self._inverse(numerator, denominator)
        below = Counter({factor: times * abs(power) for factor, times in denominator.items()})
        return numerator ** abs(power), below

    def _sum(self, terms: list[tuple[PolyElement, Counter]]) -> tuple[PolyElement, Counter]:
        common: Counter = Counter()
        for _, denominator in terms:
            common |= denominator
        total = self.ring.zero
        for numerator, denominator in terms:
            total += numerator * self._product(common - denominator)
        return total, common

    def _inverse(self, above: PolyElement, below: Counter) -> tuple[PolyElement, Counter]:
        if not above:
            raise IdentityError("a claim divides by zero")
        return self._product(below), Counter({above: 1})

    def _product(self, factors: Counter) -> PolyElement:
        product = self.ring.one
        for factor, times in factors.items():
            product *= factor**times
        return product

    def _check_coprime(self) -> None:
        """Refuse relations whose leading terms share a symbol: no Gröbner basis, no proof."""
        taken: set[int] = set()
        for rule in self.rules:
            leading = {place for place, power in enumerate(rule.leading_expv()) if power}
            if leading & taken:
                shared = ", ".join(str(self.atoms[place]) for place in sorted(leading & taken))
                raise IdentityError(f"the leading terms of the relations share {shared}")
            taken |= leading


def _as_power(expression: Expr) -> tuple[Expr, int]:
    """Base and whole exponent; a root is a base of its own."""
    if expression.is_Pow and expression.exp.is_Rational:
        base, power = expression.args
        return (base if power.q == 1 else base ** Rational(1, power.q)), int(power.p)
    return expression, 1


def _atoms(expression: Expr) -> Iterator[Expr]:
    """What no sum, product or whole power is made of: symbols, roots, functions."""
    if expression.is_Rational:
        return
    if expression.is_Add or expression.is_Mul:
        parts = expression.args
    else:
        base, _ = _as_power(expression)
        if base == expression or not (base.is_Symbol or base.is_Add or base.is_Mul):
            yield base
            return
        parts = (base,)
    for part in parts:
        yield from _atoms(part)


def _scalars(expressions: Iterable[Basic]) -> Iterable[Expr]:
    for expression in expressions:
        if getattr(expression, "is_Matrix", False):
            yield from Matrix(expression)
        else:
            yield expression
