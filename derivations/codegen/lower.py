"""From a kernel to a straight line of assignments: the only place that calls `cse`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sympy import Basic, Expr, ImmutableDenseMatrix, Symbol, count_ops, cse, sqrt

from derivations.algebra.equations import DerivationError, Equation, bindings
from derivations.algebra.vectors import components
from derivations.codegen.kernel import Kernel, Output

__all__ = ["SQRT3_2", "Line", "Program", "lower", "prove_lowering"]

#: √3/2 as one symbol, so that printers give it as one exactly rounded constant.
SQRT3_2 = Symbol("SQRT3_2", real=True)


@dataclass(frozen=True)
class Line:
    """One assignment; ``equation`` is None for a common subexpression."""

    symbol: Symbol
    expression: Expr
    equation: Equation | None


@dataclass(frozen=True)
class Program:
    """A kernel as assignments in order, and its outputs in terms of them."""

    kernel: Kernel
    lines: tuple[Line, ...]
    outputs: tuple[tuple[Output, Basic], ...]
    named: tuple[Line, ...]
    results: tuple[Basic, ...]

    @property
    def operations(self) -> int:
        """Operations of the program as it is printed."""
        return _count([line.expression for line in self.lines]) + _count(
            entry for _, value in self.outputs for entry in _flat(value)
        )

    @property
    def operations_before(self) -> int:
        """Operations of the named equations, before common subexpressions are shared."""
        return _count([line.expression for line in self.named]) + _count(
            entry for value in self.results for entry in _flat(value)
        )


def lower(kernel: Kernel) -> Program:
    """Order a kernel's equations, expand each to components, share what they repeat."""
    named, inlined = _named_lines(kernel)
    results = tuple(_with_constants(output.entries.xreplace(inlined)) for output in kernel.outputs)
    named = _alive(named, results)
    expressions = [line.expression for line in named]
    expressions += [entry for value in results for entry in _flat(value)]
    replacements, reduced = cse(
        expressions, symbols=_temporaries(), order="canonical", optimizations=None
    )
    lines = _interleave(named, replacements, reduced)
    outputs = []
    rest = iter(reduced[len(named) :])
    for output, value in zip(kernel.outputs, results, strict=True):
        outputs.append((output, _rebuild(value, rest)))
    program = Program(kernel, tuple(lines), tuple(outputs), tuple(named), results)
    _check_defined(program)
    return program


def prove_lowering(program: Program) -> int:
    """Substitute every temporary back; each line must be its equation, exactly.

    Returns the number of expressions compared.
    """
    temporaries: dict[Symbol, Expr] = {}
    named = {line.symbol: line.expression for line in program.named}
    pairs = []
    for line in program.lines:
        whole = line.expression.xreplace(temporaries)
        if line.equation is None:
            temporaries[line.symbol] = whole
        else:
            pairs.append((line.symbol, whole, named[line.symbol]))
    for (output, value), original in zip(program.outputs, program.results, strict=True):
        for left, right in zip(_flat(value), _flat(original), strict=True):
            pairs.append((output.name, left.xreplace(temporaries), right))
    for name, left, right in pairs:
        if left != right and (left - right).expand() != 0:
            raise DerivationError(f"lowering {program.kernel.name} changed {name}")
    return len(pairs)


def _named_lines(kernel: Kernel) -> tuple[list[Line], dict[Symbol, Expr]]:
    """The kernel's equations by component; numbers and mere renamings are inlined."""
    lines: list[Line] = []
    inlined: dict[Symbol, Expr] = {}
    for equation in kernel.graph.needed(kernel.wanted, kernel.given):
        value = components(equation.evaluated).xreplace(inlined)
        for symbol, entry in bindings(equation.symbol, value).items():
            if entry.is_Symbol or entry.is_number:
                inlined[symbol] = entry
            else:
                lines.append(Line(symbol, _with_constants(entry), equation))
    return lines, inlined


def _with_constants(value: Basic) -> Basic:
    return value.xreplace({sqrt(3): 2 * SQRT3_2})


def _alive(lines: list[Line], results: Iterable[Basic]) -> list[Line]:
    """Drop components that no output needs."""
    wanted = set().union(*(value.free_symbols for value in results))
    kept = []
    for line in reversed(lines):
        if line.symbol in wanted:
            wanted |= line.expression.free_symbols
            kept.append(line)
    return kept[::-1]


def _temporaries() -> Iterator[Symbol]:
    index = 0
    while True:
        yield Symbol(f"x{index}", real=True)
        index += 1


def _interleave(
    named: list[Line], replacements: list[tuple[Symbol, Expr]], reduced: list[Expr]
) -> list[Line]:
    """Put every temporary right before the first line that uses it."""
    waiting = dict(replacements)
    lines: list[Line] = []
    for line, expression in zip(named, reduced, strict=False):
        lines += _pull(expression, waiting)
        lines.append(Line(line.symbol, expression, line.equation))
    for expression in reduced[len(named) :]:
        lines += _pull(expression, waiting)
    return lines


def _pull(expression: Expr, waiting: dict[Symbol, Expr]) -> list[Line]:
    """The temporaries that an expression needs and that are not there yet, in order."""
    lines: list[Line] = []
    for symbol in sorted(expression.free_symbols & waiting.keys(), key=lambda s: int(s.name[1:])):
        if symbol in waiting:
            value = waiting.pop(symbol)
            lines += [*_pull(value, waiting), Line(symbol, value, None)]
    return lines


def _check_defined(program: Program) -> None:
    known = {SQRT3_2}.union(*(entry.entries.free_symbols for entry in program.kernel.inputs))
    for line in program.lines:
        if unknown := line.expression.free_symbols - known:
            raise DerivationError(f"{line.symbol} is computed before {sorted(map(str, unknown))}")
        known.add(line.symbol)
    for output, value in program.outputs:
        if unknown := value.free_symbols - known:
            raise DerivationError(f"{output.name} needs {sorted(map(str, unknown))}")


def _flat(value: Basic) -> list[Expr]:
    return list(value) if isinstance(value, ImmutableDenseMatrix) else [value]


def _rebuild(value: Basic, rest: Iterator[Expr]) -> Basic:
    if isinstance(value, ImmutableDenseMatrix):
        return ImmutableDenseMatrix(*value.shape, [next(rest) for _ in value])
    return next(rest)


def _count(expressions: Iterable[Expr]) -> int:
    return int(sum(count_ops(expression) for expression in expressions))
