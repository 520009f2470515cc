"""Kinematics and singularities of the uncoupled parallel manipulator 3-RPRRC+RRPRU."""

from kleinform.errors import (
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
from kleinform.forward.modes import AssemblyModes, AssemblyModesBatch
from kleinform.manipulator import UncoupledManipulator
from kleinform.results import Jacobians, Screws, Singularity, Survey
from kleinform.rotations import (
    RollPitchYaw,
    rotation_from_directions,
    rotation_from_rpy,
    rpy_from_rotation,
)

__all__ = [
    "AssemblyModes",
    "AssemblyModesBatch",
    "DtypeError",
    "GeneratedCodeError",
    "InputError",
    "Jacobians",
    "JointRangeError",
    "KleinformError",
    "MissingExtraError",
    "NotARotationError",
    "NotFiniteError",
    "RollPitchYaw",
    "Screws",
    "ShapeError",
    "SingularPoseError",
    "Singularity",
    "Survey",
    "TrackingError",
    "UncoupledManipulator",
    "rotation_from_directions",
    "rotation_from_rpy",
    "rpy_from_rotation",
]


def __getattr__(name: str) -> str:
    """``__version__``, read only when asked for: it costs more than importing kleinform."""
    if name == "__version__":
        from importlib.metadata import version

        return version("kleinform")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
