"""The paper's printed numbers and worked motions beside what kleinform computes."""

from kleinform.lazy import submodules

__getattr__ = submodules(__name__, ("examples",))
