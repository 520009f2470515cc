"""The generated kernels, checked against their manifest when the runtime is imported."""

from __future__ import annotations

import os
from zlib import crc32

from kleinform.errors import GeneratedCodeError

__all__ = ["SCHEMA", "kernels"]

SCHEMA = 1
MEND = 'run "make derive", or reinstall kleinform'

try:
    import kleinform_kernels
    from kleinform_kernels import uncoupled as kernels
except (ImportError, SyntaxError) as error:
    raise GeneratedCodeError(f"the generated kernels do not import ({error}): {MEND}") from error


def verify() -> None:
    """Refuse kernels of another schema, or edited since they were generated.

    Raises
    ------
    GeneratedCodeError
        The message names the command that mends it.
    """
    schema = getattr(kleinform_kernels, "SCHEMA", None)
    if schema != SCHEMA:
        raise GeneratedCodeError(
            f"the generated kernels have schema {schema}, {SCHEMA} is needed: {MEND}"
        )
    checksums = getattr(kleinform_kernels, "CHECKSUMS", {})
    if not checksums:
        raise GeneratedCodeError(f"the generated kernels have no checksums: {MEND}")
    root = os.path.dirname(kleinform_kernels.__file__)
    for name, checksum in checksums.items():
        with open(os.path.join(root, *name.split("/")), "rb") as file:
            if crc32(file.read()) != checksum:
                raise GeneratedCodeError(f"kleinform_kernels/{name} is not as generated: {MEND}")


verify()
