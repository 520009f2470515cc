# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Generated kernels, one subpackage a mechanism; NumPy is all they need."""

#: Version of the interface between the kernels and the runtime.
SCHEMA = 1
#: CRC-32 of each module, so that no edited kernel runs unnoticed.
CHECKSUMS = {
    "_apply.py": 1048383769,
    "_backend.py": 2767283170,
    "_threads.py": 3407211179,
    "uncoupled/__init__.py": 1983591608,
    "uncoupled/numpy_kernels.py": 85757756,
    "uncoupled/compiled_kernels.py": 3021822613,
    "uncoupled/gufuncs.py": 1487877828,
    "uncoupled/_compiled.pyi": 168279017,
    "uncoupled/mpmath_kernels.py": 92675862,
    "uncoupled/arb_kernels.py": 2070791960,
}
#: CRC-32 of the C sources: an extension that was compiled from others is not used.
COMPILED = 3533486438
