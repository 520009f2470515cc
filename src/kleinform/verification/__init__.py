"""Motions beside those of multibody programs that know the mechanism joint by joint."""

from kleinform.lazy import submodules

__getattr__ = submodules(__name__, ("mechanism",))
