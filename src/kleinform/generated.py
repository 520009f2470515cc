"""The generated kernels, as every other module gets them: checked first, then imported."""

# The manifest's module checks the kernels when it is imported, so it must come first.
from kleinform.errors import BackendError
from kleinform.manifest import SCHEMA

try:
    from kleinform_kernels import uncoupled as kernels
except ImportError as error:
    raise BackendError(str(error)) from error

__all__ = ["SCHEMA", "kernels"]
