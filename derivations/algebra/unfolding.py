"""Reading a graph's expressions down to a few symbols, for proofs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from sympy import Basic, Expr, ImmutableDenseMatrix, MatrixSymbol, Symbol, symbols

from derivations.algebra.equations import Graph, bindings, substitute
from derivations.algebra.identities import Identity, IdentityError
from derivations.algebra.vectors import components

__all__ = [
    "QUATERNION",
    "UNIT_QUATERNION",
    "Unfolding",
    "computed_form",
    "covers",
    "quaternion_rotation",
]

#: Euler parameters of a rotation, and the relation that makes them those of a rotation.
QUATERNION = symbols("euler0:4", real=True)
UNIT_QUATERNION = sum(entry**2 for entry in QUATERNION) - 1
COMPUTED = "computed "


def quaternion_rotation() -> ImmutableDenseMatrix:
    """Any rotation, in four symbols with the one relation `UNIT_QUATERNION`."""
    w, x, y, z = QUATERNION
    return ImmutableDenseMatrix(
        [
            [w**2 + x**2 - y**2 - z**2, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w**2 - x**2 + y**2 - z**2, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2],
        ]
    )


@dataclass(frozen=True)
class Unfolding:
    """Reads expressions of a graph down to a few symbols, by the forms the paper prints.

    Parameters
    ----------
    graph
        Where names are defined.
    facts
        What stands for what: a symbol or a node such as ``Norm(d − b)``, and an equal form
        that another identity proves (or the parameters of a family of poses).
    keep
        Names that stay symbols.
    settle
        Applied to every component as it is found, to keep exact numbers short.
    """

    graph: Graph
    facts: dict[Basic, Basic]
    keep: tuple[str, ...] = ()
    settle: Callable[[Expr], Expr] | None = None

    @cached_property
    def values(self) -> dict[Symbol | MatrixSymbol, dict[Symbol, Expr]]:
        """What was unfolded so far."""
        return {}

    def __call__(self, expression: Basic) -> Basic:
        """The components of an expression, in kept symbols and leaves without a fact."""
        nodes = {node: fact for node, fact in self.facts.items() if not _is_name(node)}
        expression = expression.xreplace(nodes)
        known: dict[Symbol, Expr] = {}
        for symbol in sorted(expression.free_symbols, key=lambda symbol: symbol.name):
            known.update(self._value(symbol))
        value = substitute(components(expression), known)
        if self.settle is None:
            return value
        return value.applyfunc(self.settle) if value.is_Matrix else self.settle(value)

    def _value(self, symbol: Symbol | MatrixSymbol) -> dict[Symbol, Expr]:
        if symbol.name in self.keep:
            return {}
        if symbol not in self.values:
            if symbol in self.facts:
                meaning = self.facts[symbol]
            elif symbol.name in self.graph.equations:
                meaning = self.graph[symbol.name].expression
            else:
                return {}
            self.values[symbol] = bindings(symbol, self(meaning))
        return self.values[symbol]


def computed_form(
    unfolding: Unfolding, name: str, relations: tuple[Expr, ...] = (), squared: bool = False
) -> Identity:
    """The claim that the form a kernel computes equals the form the paper prints.

    ``squared`` compares the squares of two roots; the computed one must show that it is not
    negative.
    """
    equation = unfolding.graph[name]

    def difference() -> list[Basic]:
        printed, computed = unfolding(equation.expression), unfolding(equation.computed_as)
        if not squared:
            return [printed - computed]
        if not computed.is_nonnegative:
            raise IdentityError(f"{name}: {computed} may be negative, its square proves nothing")
        return [printed**2 - computed**2]

    squares = ", by their squares: neither is negative" if squared else ""
    claim = f"{equation.words}: computed = printed form{squares}"
    return Identity(COMPUTED + name, claim, difference, relations, equation.number)


def covers(identity: Identity) -> str:
    """The name of the equation whose computed form an identity proves, or ""."""
    return identity.name.removeprefix(COMPUTED) if identity.name.startswith(COMPUTED) else ""


def _is_name(node: Basic) -> bool:
    return isinstance(node, Symbol | MatrixSymbol)
