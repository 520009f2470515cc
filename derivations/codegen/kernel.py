"""What a kernel is: inputs, outputs and the graph that leads from one to the other."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Basic, ImmutableDenseMatrix, MatrixSymbol, Symbol

from derivations.algebra.equations import Graph, free_names
from derivations.algebra.vectors import components

__all__ = ["Field", "Input", "Kernel", "Output"]


@dataclass(frozen=True)
class Field:
    """A named array: the symbols that its entries are, a unit and a line of words."""

    name: str
    symbols: Basic
    unit: str
    words: str

    @property
    def entries(self) -> Basic:
        return components(self.symbols)

    @property
    def shape(self) -> tuple[int, ...]:
        return core_shape(self.symbols)


class Input(Field):
    """An argument of a kernel."""


class Output(Field):
    """A result of a kernel."""


@dataclass(frozen=True)
class Kernel:
    """A function to generate: a pose or many go in, arrays come out."""

    name: str
    words: str
    numbers: str
    graph: Graph
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]

    @property
    def given(self) -> list[str]:
        return [name for entry in self.inputs for name in free_names(entry.symbols)]

    @property
    def wanted(self) -> list[str]:
        return [name for entry in self.outputs for name in free_names(entry.symbols)]


def core_shape(symbol: Basic) -> tuple[int, ...]:
    """The trailing axes: () for a scalar, (3,) for a vector, (6, 6) for a matrix."""
    if isinstance(symbol, Symbol):
        return ()
    rows, columns = map(int, symbol.shape)
    one_axis = isinstance(symbol, (MatrixSymbol, ImmutableDenseMatrix)) and columns == 1
    return (rows,) if one_axis else (rows, columns)
