"""mpmath kernels: one pose at a time, at the precision that ``mpmath.mp`` holds."""

from __future__ import annotations

from derivations.codegen.lower import Program
from derivations.codegen.printers import nested

HEAD = '''"""mpmath kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

One pose at a time, nested sequences in and nested lists out, at the working precision of
``mpmath.mp``: the reference against which the NumPy kernels are tested.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from mpmath import atan2, cos, mpf, sin, sqrt
from mpmath import fabs as absolute
'''


def print_module(programs: list[Program]) -> str:
    """The module's text."""
    return nested.print_module(programs, nested.Dialect(HEAD, "mpf"))
