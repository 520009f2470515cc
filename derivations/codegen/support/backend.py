"""Which kernels run: the compiled ones where they are installed, those on NumPy otherwise.

The environment variable ``KLEINFORM_BACKEND`` chooses: ``compiled`` (an error where there are
none) or ``numpy``.
"""

from __future__ import annotations

import os
import warnings
from importlib import import_module

from kleinform_kernels import COMPILED

__all__ = ["BACKEND", "INSTRUCTIONS", "REASON"]


def _chosen() -> tuple[str, str, str]:
    """The backend, the instructions that it uses, and why it is not the compiled one."""
    wish = os.environ.get("KLEINFORM_BACKEND", "")
    if wish not in ("", "compiled", "numpy"):
        raise ImportError(f'KLEINFORM_BACKEND: "compiled" or "numpy" is needed, {wish!r} arrived')
    if wish == "numpy":
        return "numpy", "", "KLEINFORM_BACKEND=numpy"
    try:
        compiled = import_module("kleinform_kernels.uncoupled._compiled")
    except ImportError as error:
        reason = f"there are no compiled kernels (they need a C compiler to install): {error}"
    else:
        if compiled.CHECKSUM == COMPILED:
            return "compiled", compiled.instructions(), ""
        reason = "the compiled kernels are of other sources: reinstall kleinform"
        if not wish:
            warnings.warn(reason, RuntimeWarning, stacklevel=2)
    if wish == "compiled":
        raise ImportError(f"KLEINFORM_BACKEND=compiled, but {reason}")
    return "numpy", "", reason


BACKEND, INSTRUCTIONS, REASON = _chosen()
