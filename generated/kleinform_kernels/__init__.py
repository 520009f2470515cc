# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Generated kernels, one subpackage a mechanism; NumPy is all they need."""

from importlib import import_module
from types import ModuleType

#: Version of the interface between the kernels and the runtime.
SCHEMA = 1
#: CRC-32 of each module, so that no edited kernel runs unnoticed.
CHECKSUMS = {
    "_apply.py": 1048383769,
    "_backend.py": 1396773140,
    "_threads.py": 3407211179,
    "uncoupled/__init__.py": 172836203,
    "uncoupled/numpy_kernels.py": 970623374,
    "uncoupled/compiled_kernels.py": 1858264932,
    "uncoupled/gufuncs.py": 920413247,
    "uncoupled/_compiled.pyi": 1404573163,
    "uncoupled/mpmath_kernels.py": 3385554436,
    "uncoupled/arb_kernels.py": 929901512,
}
#: CRC-32 of the C sources: an extension that was compiled from others is not used.
COMPILED = 832575509


def __getattr__(name: str) -> ModuleType:
    """Modules that are loaded when somebody asks for them."""
    if name in ("uncoupled",):
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
