"""Kinematics and singularities of the uncoupled parallel manipulator 3-RPRRC+RRPRU."""

import kleinform.starting  # noqa: F401  # what follows takes a while

# isort: split
from typing import TYPE_CHECKING, Any

from kleinform.backend import Backend, backend, set_threads, threads
from kleinform.classification import Classes, PoseClass
from kleinform.errors import (
    BackendError,
    DtypeError,
    GeneratedCodeError,
    InputError,
    JointRangeError,
    KleinformError,
    MissingExtraError,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    SingularPoseError,
    TrackingError,
)
from kleinform.limits import Limits
from kleinform.manipulator import UncoupledManipulator
from kleinform.results import Jacobians, Screws, Singularity, Survey
from kleinform.rotations import (
    RollPitchYaw,
    rotation_from_directions,
    rotation_from_rpy,
    rpy_from_rotation,
)

if TYPE_CHECKING:
    from kleinform.forward.modes import AssemblyModes, AssemblyModesBatch

__all__ = [
    "AssemblyModes",
    "AssemblyModesBatch",
    "Backend",
    "BackendError",
    "Classes",
    "DtypeError",
    "GeneratedCodeError",
    "InputError",
    "Jacobians",
    "JointRangeError",
    "KleinformError",
    "Limits",
    "MissingExtraError",
    "NotARotationError",
    "NotFiniteError",
    "PoseClass",
    "RollPitchYaw",
    "Screws",
    "ShapeError",
    "SingularPoseError",
    "Singularity",
    "Survey",
    "TrackingError",
    "UncoupledManipulator",
    "backend",
    "rotation_from_directions",
    "rotation_from_rpy",
    "rpy_from_rotation",
    "set_threads",
    "threads",
]


def __getattr__(name: str) -> Any:
    """What costs more than importing kleinform, loaded when asked for."""
    if name == "__version__":
        from importlib.metadata import version

        return version("kleinform")
    if name in ("AssemblyModes", "AssemblyModesBatch"):
        from kleinform.forward import modes

        return getattr(modes, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
