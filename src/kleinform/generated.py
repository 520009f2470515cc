"""The generated kernels, checked against their manifest when the runtime is imported."""

from __future__ import annotations

import hashlib
import json
from importlib.resources import files

from kleinform.errors import GeneratedCodeError

__all__ = ["SCHEMA", "kernels"]

SCHEMA = 1
MEND = 'run "make derive", or reinstall kleinform'
CHECKED = ("uncoupled/numpy_kernels.py", "_apply.py")

try:
    from kleinform_kernels import uncoupled as kernels
except ImportError as error:
    raise GeneratedCodeError(f"the generated kernels do not import ({error}): {MEND}") from error


def verify() -> None:
    """Refuse kernels of another schema, or that differ from their manifest.

    Raises
    ------
    GeneratedCodeError
        The message names the command that mends it.
    """
    root = files("kleinform_kernels")
    manifest = json.loads((root / "manifest.json").read_text(encoding="utf-8"))
    if manifest["schema"] != SCHEMA:
        raise GeneratedCodeError(
            f"the generated kernels have schema {manifest['schema']}, {SCHEMA} is needed: {MEND}"
        )
    for name in CHECKED:
        digest = hashlib.sha256(root.joinpath(name).read_bytes()).hexdigest()
        if digest != manifest["files"][name]:
            raise GeneratedCodeError(f"kleinform_kernels/{name} is not as generated: {MEND}")


verify()
