"""The Python side of the compiled kernels: the same functions as on NumPy, and types."""

from __future__ import annotations

from derivations.codegen.lower import Program
from derivations.codegen.printers.numpy import public
from derivations.codegen.printers.python import class_name

__all__ = ["print_gufuncs", "print_module", "print_stub"]

HEAD = '''"""Compiled kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

The same functions as on NumPy: leading axes broadcast, trailing axes are the mathematical
shape, everything is float64. Nothing is raised for a singular pose: it gives inf, or NaN where
0/0. Large batches run on several threads, see ``kleinform_kernels._threads``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kleinform_kernels._apply import apply_compiled
from kleinform_kernels.uncoupled import _compiled
from kleinform_kernels.uncoupled.numpy_kernels import (
{classes}
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
'''

GUFUNCS = '''"""The compiled kernels as NumPy's generalised ufuncs, one core each.

They take what every generalised ufunc takes: ``out=``, ``axes=``, strides, broadcasting and
casting; they give a tuple in the order of the kernel's results. Importing them where
``kleinform_kernels.uncoupled.BACKEND`` is not ``"compiled"`` is an ImportError.
"""

from kleinform_kernels._backend import BACKEND, REASON

if BACKEND != "compiled":
    raise ImportError(REASON)

from kleinform_kernels.uncoupled._compiled import (
{names}
)

__all__ = [
{quoted}
]
'''

STUB = '''"""The extension that is compiled from extension.c, lanes.c and kernels.c."""

from typing import Generic, TypeVar

import numpy as np

Result = TypeVar("Result", bound=tuple[np.ndarray, ...])

CHECKSUM: int

def instructions() -> str: ...
def use(name: str) -> bool: ...

class OnePose(Generic[Result]):
    def __init__(self, name: str, result: type[Result]) -> None: ...
    def __call__(self, *arguments: object) -> Result | None: ...

'''


def print_module(programs: list[Program]) -> str:
    """``compiled_kernels.py``."""
    classes = sorted(class_name(program.kernel.name) for program in programs)
    listed = "\n".join(f"    {name}," for name in classes)
    parts = [HEAD.format(classes=listed).rstrip()]
    parts += [_function(program) for program in programs]
    return "\n\n\n".join(parts) + "\n"


def print_gufuncs(programs: list[Program]) -> str:
    """``gufuncs.py``."""
    names = sorted(program.kernel.name for program in programs)
    listed = "\n".join(f"    {name}," for name in names)
    quoted = "\n".join(f'    "{name}",' for name in names)
    return GUFUNCS.format(names=listed, quoted=quoted)


def print_stub(programs: list[Program]) -> str:
    """``_compiled.pyi``."""
    return STUB + "\n".join(f"{program.kernel.name}: np.ufunc" for program in programs) + "\n"


def _function(program: Program) -> str:
    """One pose of float64 arrays goes straight to C, everything else through the ufunc."""
    name = program.kernel.name
    given = ", ".join(entry.name for entry in program.kernel.inputs)
    direct = f'_{name} = _compiled.OnePose("{name}", {class_name(name)})'
    general = public(program, f"_{name}({given}) or ", "apply_compiled", f"_compiled.{name}")
    return f"{direct}\n\n\n{general}"
