"""Multibody programs, imported when they are needed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from kleinform.errors import MissingExtraError

__all__ = ["load"]


def load(name: str) -> Any:
    """The module of this name.

    Raises
    ------
    MissingExtraError
        It is not installed.
    """
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtraError(f"{name}: pip install 'kleinform[verify]'") from error
