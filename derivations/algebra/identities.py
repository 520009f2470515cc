"""Claims that SymPy reduces to exactly zero, and claims that a counter-example refutes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from sympy import Basic, Expr, Matrix, Poly, S, Symbol, fraction, reduced, sqrt, together

__all__ = ["Counterexample", "Identity", "IdentityError", "vanishes"]

SQRT3 = Symbol("_sqrt3")


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
        for entry in _scalars(self.difference()):
            rest = remainder(entry, self.relations)
            if rest != 0:
                raise IdentityError(f"{self.name}: {self.claim}\nnot zero, this is left: {rest}")
            count += 1
        if count == 0:
            raise IdentityError(f"{self.name}: {self.claim}\nthere was nothing to prove")
        return count


@dataclass(frozen=True)
class Counterexample:
    """A printed claim and a pose in exact numbers at which it fails.

    ``check`` computes the pose and returns the exact facts that contradict the claim; it
    raises `IdentityError` if they do not.
    """

    name: str
    claim: str
    check: Callable[[], dict[str, Expr]]
    number: str = ""


def vanishes(expression: Basic, relations: tuple[Expr, ...] = ()) -> bool:
    """Whether every entry of an expression is exactly zero, given the relations."""
    return all(remainder(entry, relations) == 0 for entry in _scalars([expression]))


def remainder(expression: Expr, relations: tuple[Expr, ...]) -> Expr:
    """The numerator of an expression, reduced by the relations and by √3·√3 = 3."""
    numerator, _ = fraction(together(expression.xreplace({sqrt(3): SQRT3})))
    numerator = numerator.expand()
    if numerator == 0:
        return S.Zero
    rules = [rule for rule in relations if rule.free_symbols & numerator.free_symbols]
    if SQRT3 in numerator.free_symbols or any(SQRT3 in rule.free_symbols for rule in rules):
        rules.append(SQRT3**2 - 3)
    if not rules:
        return numerator
    generators = sorted(
        set(numerator.free_symbols).union(*(rule.free_symbols for rule in rules)),
        key=lambda symbol: symbol.name,
    )
    _check_coprime(rules, generators)
    return reduced(numerator, rules, *generators, order="grevlex")[1]


def _check_coprime(rules: list[Expr], generators: list[Symbol]) -> None:
    """Refuse relations whose leading terms share a symbol: no Gröbner basis, no proof."""
    taken: set[Symbol] = set()
    for rule in rules:
        exponents = Poly(rule, *generators).monoms(order="grevlex")[0]
        leading = {g for g, power in zip(generators, exponents, strict=True) if power}
        if leading & taken:
            raise IdentityError(f"the leading terms of the relations share {leading & taken}")
        taken |= leading


def _scalars(expressions: Iterable[Basic]) -> Iterable[Expr]:
    for expression in expressions:
        if getattr(expression, "is_Matrix", False):
            yield from Matrix(expression)
        else:
            yield expression
