"""Lowering and printing against the paper's own forms, and what is refused."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from sympy import Basic, Float, ImmutableDenseMatrix, Rational, Symbol, sqrt

from derivations.algebra.equations import DerivationError, Equation, Graph
from derivations.algebra.vectors import component_symbols, components, matrix, scalar, vector
from derivations.codegen.kernel import Input, Kernel, Output
from derivations.codegen.lower import Line, Program, lower, prove_lowering
from derivations.uncoupled.kernels import kernels
from kleinform_kernels import uncoupled
from kleinform_kernels.uncoupled import mpmath_kernels

KERNELS = {kernel.name: kernel for kernel in kernels()}
DIGITS = 40
#: Positions and rates of two poses; their rotations are from quaternions (w, x, y, z).
QUATERNIONS = ((1, 2, 3, 4), (7, -1, 2, 3))
POSITIONS = ((Rational(1, 4), Rational(1, 5), 1), (Rational(-1, 3), Rational(2, 7), Rational(3, 2)))


@pytest.fixture(scope="module", params=KERNELS)
def program(request: pytest.FixtureRequest) -> Program:
    return lower(KERNELS[request.param])


def rational_rotation(quaternion: tuple[int, int, int, int]) -> ImmutableDenseMatrix:
    """The rotation of a quaternion of integers: exact, since only its square norm divides."""
    w, *axis = quaternion
    x, y, z = axis
    skew = ImmutableDenseMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    square = w**2 + x**2 + y**2 + z**2
    return ImmutableDenseMatrix.eye(3) + (2 * w * skew + 2 * skew**2) / square


def exact_inputs(kernel: Kernel, pose: int) -> dict[str, Basic]:
    """Exact values of a kernel's inputs, those of a pose consistent with each other."""
    turn = rational_rotation(QUATERNIONS[pose])
    place = ImmutableDenseMatrix(POSITIONS[pose])
    n1, m1 = turn[:, 0], turn[:, 1]
    n2 = -n1 / 2 + sqrt(3) / 2 * m1
    lengths = [1, Rational(6, 5), Rational(7, 8)]
    central = [Rational(2, 3), Rational(5, 4), Rational(21, 20)]
    start = ImmutableDenseMatrix(
        [[Rational(3, 5), Rational(4, 5)], [Rational(5, 13), -Rational(12, 13)]]
    )
    known = {
        "a": Rational(3, 4 + pose),
        "c": place,
        "R": turn,
        "heading": place[:2, :],
        "twist": ImmutableDenseMatrix(2, 3, [Rational(k - 2, 3) for k in range(6)]),
        "rates": ImmutableDenseMatrix([Rational(2 * k - 5, 7) for k in range(6)]),
        "twist_rate": ImmutableDenseMatrix(2, 3, [Rational(3 - 2 * k, 5) for k in range(6)]),
        "accelerations": ImmutableDenseMatrix([Rational(7 - 3 * k, 4) for k in range(6)]),
        "forces": ImmutableDenseMatrix([Rational(5 - 3 * k, 2) for k in range(6)]),
        "wrench": ImmutableDenseMatrix(2, 3, [Rational(3 * k - 4, 5) for k in range(6)]),
        "lengths": ImmutableDenseMatrix(lengths),
        "directions": ImmutableDenseMatrix.vstack(n1.T, n2.T),
        "n1": n1,
        "n2": n2,
        "joints": ImmutableDenseMatrix([*lengths, *central] if kernel.name == "fold" else central),
        "angle": start[pose, :].T,
        "start": start,
        "half_tangents": ImmutableDenseMatrix([Rational(1, 3), Rational(-5, 4)]),
        "reference": turn[:, 2],
        "frame": turn.T,
        "half_angle": ImmutableDenseMatrix([Rational(2, 3), Rational(1, 7)]),
        "second": n2,
        "roll": Rational(1, 6),
        "pitch": Rational(1, 19) - pose,
        "yaw": Rational(1, 10) + 2 * pose,
    }
    return {entry.name: known[entry.name] for entry in kernel.inputs}


def flat(value: Basic) -> list[Basic]:
    return list(value) if isinstance(value, ImmutableDenseMatrix) else [value]


def as_printed_in_the_paper(kernel: Kernel, inputs: dict[str, Basic]) -> dict[str, list]:
    """Each output from `Equation.expression` alone, equation by equation, in SymPy's numbers."""
    values: dict[Symbol, Basic] = {}
    for entry in kernel.inputs:
        numbers = [number.evalf(DIGITS) for number in flat(inputs[entry.name])]
        values.update(zip(flat(entry.entries), numbers, strict=True))
    for equation in kernel.graph:
        value = components(equation.expression)
        if value.free_symbols <= values.keys():
            numbers = [entry.xreplace(values).evalf(DIGITS) for entry in flat(value)]
            values.update(zip(flat(component_symbols(equation.symbol)), numbers, strict=True))
    return {
        output.name: [mpmath.mpmathify(entry.xreplace(values)) for entry in flat(output.entries)]
        for output in kernel.outputs
    }


def scale_of(values: list) -> float:
    return max([1.0, *(abs(float(value)) for value in values)])


def test_lowering_is_proven(program: Program) -> None:
    """Every line and every entry of every output is compared."""
    entries = sum(len(flat(value)) for _, value in program.outputs)
    assert prove_lowering(program) == len(program.named) + entries


@pytest.mark.parametrize("pose", [0, 1])
def test_mpmath_kernels_are_the_papers_forms(program: Program, pose: int) -> None:
    """The mpmath printer and the forms that kernels compute, at 40 digits."""
    kernel = program.kernel
    inputs = exact_inputs(kernel, pose)
    with mpmath.workdps(DIGITS):
        expected = as_printed_in_the_paper(kernel, inputs)
        nested = {name: to_nested(value) for name, value in inputs.items()}
        result = getattr(mpmath_kernels, kernel.name)(**nested)
        for output in kernel.outputs:
            found = np.array(getattr(result, output.name), dtype=object).ravel()
            tolerance = mpmath.mpf(10) ** (8 - DIGITS) * scale_of(expected[output.name])
            for left, right in zip(found, expected[output.name], strict=True):
                assert abs(left - right) <= tolerance, output.name


@pytest.mark.parametrize("pose", [0, 1])
def test_numpy_kernels_are_the_papers_forms(program: Program, pose: int) -> None:
    """The NumPy printer, at double precision: a wrong constant or sign shows."""
    kernel = program.kernel
    inputs = exact_inputs(kernel, pose)
    with mpmath.workdps(DIGITS):
        expected = as_printed_in_the_paper(kernel, inputs)
    arrays = {
        name: np.array(to_nested(value), dtype=object).astype(float)
        for name, value in inputs.items()
    }
    result = getattr(uncoupled, kernel.name)(**arrays)
    for output in kernel.outputs:
        found = np.ravel(getattr(result, output.name))
        assert found.size == len(expected[output.name])
        gap = np.abs(found - np.array(expected[output.name], dtype=float))
        assert np.max(gap) <= 1e-13 * scale_of(expected[output.name]), output.name


def to_nested(value: Basic) -> object:
    """Numbers of mpmath in nested lists; a column becomes one list."""
    if not isinstance(value, ImmutableDenseMatrix):
        return mpmath.mpmathify(Float(value, DIGITS))
    rows = [[mpmath.mpmathify(entry.evalf(DIGITS)) for entry in row] for row in value.tolist()]
    return [row[0] for row in rows] if value.shape[1] == 1 else rows


def tampered(program: Program) -> Iterator[Program]:
    """The program with one line, one temporary or one output changed."""
    lines = program.lines
    for index in {0, len(lines) // 2, len(lines) - 1}:
        line = lines[index]
        changed = Line(line.symbol, line.expression + Rational(1, 10**9), line.equation)
        yield replace(program, lines=(*lines[:index], changed, *lines[index + 1 :]))
    output, value = program.outputs[0]
    wrong = -value if isinstance(value, ImmutableDenseMatrix) else value + 1
    yield replace(program, outputs=((output, wrong), *program.outputs[1:]))


def test_a_tampered_program_is_refused(program: Program) -> None:
    name = program.kernel.name
    for wrong in tampered(program):
        with pytest.raises(DerivationError, match=f"lowering {name} changed "):
            prove_lowering(wrong)


x, y, z = scalar("x"), scalar("y"), scalar("z")


def test_a_graph_refuses_what_is_not_defined() -> None:
    graph = Graph((x,))
    with pytest.raises(DerivationError, match="y uses z before they are defined"):
        graph.add([Equation(y, x + z, "too early"), Equation(z, x, "too late")])
    with pytest.raises(DerivationError, match="y uses z before"):
        Graph((x,)).add([Equation(y, x, "sound in the paper", computed_as=z)])
    with pytest.raises(DerivationError, match="y uses y before"):
        Graph((x,)).add([Equation(y, y + 1, "of itself")])


def test_a_graph_refuses_what_is_defined_twice() -> None:
    graph = Graph((x,))
    graph.add([Equation(y, x + 1, "first")])
    with pytest.raises(DerivationError, match="y is defined twice"):
        graph.add([Equation(y, x + 2, "second")])
    with pytest.raises(DerivationError, match="x is defined twice"):
        graph.add([Equation(x, y, "a leaf")])
    with pytest.raises(DerivationError, match="y is defined twice"):
        graph.add([Equation(Symbol("y", positive=True), x, "of other assumptions")])


def kernel_of(graph: Graph, inputs: tuple[Input, ...], symbol: Basic) -> Kernel:
    return Kernel("trial", "A trial.", "", graph, inputs, (Output("out", symbol, "1", "out"),))


def test_a_kernel_refuses_what_is_neither_given_nor_defined() -> None:
    graph = Graph((x, z))
    graph.add([Equation(y, x + z, "sum")])
    with pytest.raises(DerivationError, match="z is neither given nor defined"):
        lower(kernel_of(graph, (Input("x", x, "1", "x"),), y))
    with pytest.raises(DerivationError, match="bogus is neither given nor defined"):
        lower(kernel_of(graph, (Input("x", x, "1", "x"),), scalar("bogus")))


def test_a_kernel_refuses_a_symbol_of_other_assumptions() -> None:
    """The same name, another symbol: it would survive to run time unbound."""
    graph = Graph((x,))
    graph.add([Equation(y, Symbol("x") + 1, "of another x")])
    with pytest.raises(DerivationError, match="x"):
        lower(kernel_of(graph, (Input("x", x, "1", "x"),), y))


def test_shapes_of_symbols() -> None:
    for symbol, shape in ((x, ()), (vector("v"), (3,)), (matrix("M", 2, 3), (2, 3))):
        assert Input("name", symbol, "1", "").shape == shape
        assert Output("name", symbol, "1", "").shape == shape
