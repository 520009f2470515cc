"""Named equations and the graph they form.

A derivation is a list of equations, each a symbol and an expression in earlier
symbols. Whoever wants an outcome names it; what it needs follows from the graph.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from sympy import Basic, Expr, ImmutableDenseMatrix, MatrixSymbol, Symbol

from derivations.algebra.vectors import component_symbols

__all__ = ["DerivationError", "Equation", "Graph", "free_names"]


class DerivationError(Exception):
    """A derivation contradicts itself; the message names the equation."""


@dataclass(frozen=True)
class Equation:
    """One equation of the paper, or of ours between two of the paper's.

    Parameters
    ----------
    symbol
        What the equation defines.
    expression
        Its definition in earlier symbols, written as the paper writes it.
    words
        One line of prose.
    number
        The equation's number in the paper, or "" if it has none.
    unit
        The unit of every component, "1" if it has none.
    computed_as
        The form a kernel evaluates where the paper's form divides by zero, cancels
        or costs more. `derivations.uncoupled.identities` proves both equal.
    """

    symbol: Symbol | MatrixSymbol
    expression: Basic
    words: str
    number: str = ""
    unit: str = "1"
    computed_as: Basic | None = None

    @property
    def name(self) -> str:
        return self.symbol.name

    @property
    def evaluated(self) -> Basic:
        """The form that kernels evaluate."""
        return self.expression if self.computed_as is None else self.computed_as


def free_names(expression: Basic) -> list[str]:
    """The names of an expression's symbols, in alphabetical order."""
    return sorted(symbol.name for symbol in expression.free_symbols)


@dataclass
class Graph:
    """Equations in the order of their derivation, over some free symbols (leaves)."""

    leaves: tuple[Symbol | MatrixSymbol, ...]
    equations: dict[str, Equation] = field(default_factory=dict)

    def add(self, equations: Iterable[Equation]) -> None:
        """Append equations; each may only use leaves and what was defined before it."""
        known = {leaf.name for leaf in self.leaves} | set(self.equations)
        for equation in equations:
            if equation.name in known:
                raise DerivationError(f"{equation.name} is defined twice")
            for form in (equation.expression, equation.evaluated):
                unknown = [name for name in free_names(form) if name not in known]
                if unknown:
                    raise DerivationError(
                        f"{equation.name} uses {', '.join(unknown)} before they are defined"
                    )
            known.add(equation.name)
            self.equations[equation.name] = equation

    def __getitem__(self, name: str) -> Equation:
        return self.equations[name]

    def __iter__(self) -> Iterator[Equation]:
        return iter(self.equations.values())

    def needed(self, wanted: Iterable[str], given: Iterable[str]) -> list[Equation]:
        """The equations that lead from the ``given`` names to the ``wanted`` ones."""
        stop = set(given)
        reached: set[str] = set()
        waiting = [name for name in wanted if name not in stop]
        while waiting:
            name = waiting.pop()
            if name in reached:
                continue
            if name not in self.equations:
                raise DerivationError(f"{name} is neither given nor defined")
            reached.add(name)
            waiting += [
                used for used in free_names(self.equations[name].evaluated) if used not in stop
            ]
        return [equation for equation in self if equation.name in reached]


def bindings(symbol: Symbol | MatrixSymbol, value: Basic) -> dict[Symbol, Expr]:
    """Pair each component symbol with its value."""
    names = component_symbols(symbol)
    if isinstance(names, Symbol):
        return {names: value}
    return dict(zip(names, ImmutableDenseMatrix(value), strict=True))


def substitute(expression: Basic, values: Mapping[Symbol, Expr]) -> Basic:
    """Replace symbols by values, each once and all together."""
    return expression.xreplace(dict(values))
