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
    "uncoupled/__init__.py": 2584009675,
    "uncoupled/numpy_kernels.py": 3805966629,
    "uncoupled/compiled_kernels.py": 2218288798,
    "uncoupled/gufuncs.py": 510360783,
    "uncoupled/_compiled.pyi": 2115720888,
    "uncoupled/mpmath_kernels.py": 1805688286,
    "uncoupled/arb_kernels.py": 2898959157,
}
#: CRC-32 of the C sources: an extension that was compiled from others is not used.
COMPILED = 4257696193
