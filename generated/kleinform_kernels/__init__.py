# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Generated kernels, one subpackage a mechanism; NumPy is all they need."""

#: Version of the interface between the kernels and the runtime.
SCHEMA = 1
#: CRC-32 of each module, so that no edited kernel runs unnoticed.
CHECKSUMS = {
    "_apply.py": 187388923,
    "uncoupled/__init__.py": 1231556797,
    "uncoupled/numpy_kernels.py": 1587106956,
    "uncoupled/mpmath_kernels.py": 1036715596,
    "uncoupled/arb_kernels.py": 2885271091,
}
