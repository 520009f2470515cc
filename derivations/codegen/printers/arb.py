"""Kernels in ball arithmetic: every result encloses the exact one, one pose at a time."""

from __future__ import annotations

from derivations.codegen.lower import Program
from derivations.codegen.printers import nested

HEAD = '''"""Kernels of the uncoupled manipulator 3-RPRRC+RRPRU in ball arithmetic (python-flint).

One pose at a time, nested sequences of ``arb`` or numbers in and nested lists out, at the
working precision of ``flint.ctx``: every result encloses what the exact kernel gives for
any arguments within the given balls.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import arb


def sqrt(value: Any) -> Any:
    """The square root; rounding puts a sum of squares next to zero below zero as well."""
    ball = arb(value)
    return (ball.nonnegative_part() if ball.contains(0) else ball).sqrt()


def cos(value: Any) -> Any:
    """The cosine."""
    return arb(value).cos()


def sin(value: Any) -> Any:
    """The sine."""
    return arb(value).sin()


def atan2(ordinate: Any, abscissa: Any) -> Any:
    """The angle of (abscissa, ordinate)."""
    return arb.atan2(arb(ordinate), arb(abscissa))


def absolute(value: Any) -> Any:
    """The size."""
    return abs(arb(value))
'''


def print_module(programs: list[Program]) -> str:
    """The module's text."""
    return nested.print_module(programs, nested.Dialect(HEAD, "arb"))
