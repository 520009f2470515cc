# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Generated kernels, one subpackage a mechanism; NumPy is all they need."""

#: Version of the interface between the kernels and the runtime.
SCHEMA = 1
#: CRC-32 of each module, so that no edited kernel runs unnoticed.
CHECKSUMS = {
    "_apply.py": 1048383769,
    "_backend.py": 1396773140,
    "_threads.py": 3407211179,
    "uncoupled/__init__.py": 411468905,
    "uncoupled/numpy_kernels.py": 3598518522,
    "uncoupled/compiled_kernels.py": 422091767,
    "uncoupled/gufuncs.py": 3106200842,
    "uncoupled/_compiled.pyi": 988906847,
    "uncoupled/mpmath_kernels.py": 3753336431,
    "uncoupled/arb_kernels.py": 2707108187,
}
#: CRC-32 of the C sources: an extension that was compiled from others is not used.
COMPILED = 1615187245
