"""Checks the generated kernels against their checksums before they are imported."""

from __future__ import annotations

import os
from zlib import crc32

from kleinform.errors import GeneratedCodeError

__all__ = ["MEND", "SCHEMA", "verify"]

SCHEMA = 1
MEND = 'run "make derive", or reinstall kleinform'


def verify() -> None:
    """Refuse kernels of another schema, or edited since they were generated.

    Raises
    ------
    GeneratedCodeError
        The message names the command that mends it.
    """
    try:
        import kleinform_kernels
    except (ImportError, SyntaxError) as error:
        raise GeneratedCodeError(
            f"the generated kernels do not import ({error}): {MEND}"
        ) from error
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
        if _checksum(os.path.join(root, *name.split("/"))) != checksum:
            raise GeneratedCodeError(f"kleinform_kernels/{name} is not as generated: {MEND}")


def _checksum(path: str) -> int:
    try:
        with open(path, "rb") as file:
            return crc32(file.read())
    except OSError as error:
        raise GeneratedCodeError(f"a generated kernel cannot be read ({error}): {MEND}") from error


verify()
