"""Kinematics and singularities of the uncoupled parallel manipulator 3-RPRRC+RRPRU."""

import kleinform.starting  # noqa: F401  # what follows takes a while

# isort: split
from typing import TYPE_CHECKING, Any

from kleinform.backend import Backend, backend, set_threads, threads
from kleinform.classification import Classes, PoseClass
from kleinform.conversions import (
    PositionAndRotation,
    nearest_rotation,
    pose_from_matrix,
    rotation_from_quaternion,
)
from kleinform.errors import (
    BackendError,
    DtypeError,
    GeneratedCodeError,
    InputError,
    JointRangeError,
    KleinformError,
    MissingExtraError,
    MotionWarning,
    NotARotationError,
    NotFiniteError,
    ShapeError,
    SingularityWarning,
    SingularPoseError,
    TrackingError,
)
from kleinform.lazy import submodules
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
    from kleinform import homotopy, maps, motion, paper, plots, verification
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
    "MotionWarning",
    "NotARotationError",
    "NotFiniteError",
    "PoseClass",
    "PositionAndRotation",
    "RollPitchYaw",
    "Screws",
    "ShapeError",
    "SingularPoseError",
    "Singularity",
    "SingularityWarning",
    "Survey",
    "TrackingError",
    "UncoupledManipulator",
    "backend",
    "homotopy",
    "maps",
    "motion",
    "nearest_rotation",
    "paper",
    "plots",
    "pose_from_matrix",
    "rotation_from_directions",
    "rotation_from_quaternion",
    "rotation_from_rpy",
    "rpy_from_rotation",
    "set_threads",
    "threads",
    "verification",
]


_submodule = submodules(__name__, ("homotopy", "maps", "motion", "paper", "plots", "verification"))


def __getattr__(name: str) -> Any:
    """What costs more than importing kleinform, loaded when asked for."""
    if name == "__version__":
        from importlib.metadata import version

        return version("kleinform")
    if name in ("AssemblyModes", "AssemblyModesBatch"):
        from kleinform.forward import modes

        return getattr(modes, name)
    return _submodule(name)


def __dir__() -> list[str]:
    """The public names alone."""
    return sorted(__all__)
