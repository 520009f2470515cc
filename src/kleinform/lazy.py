"""Submodules that are loaded when somebody asks for them, not with their package."""

from __future__ import annotations

from collections.abc import Callable, Collection
from importlib import import_module
from types import ModuleType

__all__ = ["submodules"]


def submodules(package: str, names: Collection[str]) -> Callable[[str], ModuleType]:
    """A package's ``__getattr__`` for these submodules: importing one sets the attribute."""

    def attribute(name: str) -> ModuleType:
        if name in names:
            return import_module(f"{package}.{name}")
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return attribute
