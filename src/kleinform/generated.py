"""The generated kernels, as every other module gets them: checked first, then imported."""

# The manifest's module checks the kernels when it is imported, so it must come first.
from kleinform.manifest import SCHEMA
from kleinform_kernels import uncoupled as kernels

__all__ = ["SCHEMA", "kernels"]
