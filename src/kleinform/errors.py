"""Typed errors. Each says what arrived, which rule it broke and where."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "BackendError",
    "DtypeError",
    "GeneratedCodeError",
    "InputError",
    "JointRangeError",
    "KleinformError",
    "MissingExtraError",
    "MotionWarning",
    "NotARotationError",
    "NotFiniteError",
    "ShapeError",
    "SingularPoseError",
    "SingularityWarning",
    "TrackingError",
]


class KleinformError(Exception):
    """Base of every error that kleinform raises.

    Attributes
    ----------
    mask : bool array or None
        In a batch, the rows that broke the rule; None where the error is not of rows.
    """

    def __init__(self, message: str, mask: NDArray[np.bool_] | None = None) -> None:
        super().__init__(message)
        self.mask = mask


class InputError(KleinformError, ValueError):
    """An argument broke a rule."""


class ShapeError(InputError):
    """The trailing axes are wrong, or the leading axes do not broadcast."""


class DtypeError(InputError, TypeError):
    """An array is not of real numbers in at most double precision."""


class NotFiniteError(InputError):
    """An array has NaN or inf."""


class NotARotationError(InputError):
    """A matrix is not a rotation."""


class JointRangeError(InputError):
    """A joint value is outside its range: q1, q2, q3, q6 >= 0, |q5| <= π/2."""


class MissingExtraError(KleinformError, ImportError):
    """What was asked for needs a package that an extra of kleinform installs."""


class SingularPoseError(KleinformError):
    """A pose at which the answer does not exist; the message names what vanishes there."""


class SingularityWarning(UserWarning):
    """An answer was divided by a factor that nearly vanishes: |f|/scale is below √eps.

    Attributes
    ----------
    mask : bool array (...) or None
        The poses of the call near a singularity.
    ratios : dict of name to float
        The smallest |f|/scale of each factor that is so small at one of them.
    """

    def __init__(
        self,
        message: str,
        mask: NDArray[np.bool_] | None = None,
        ratios: dict[str, float] | None = None,
    ) -> None:
        super().__init__(message)
        self.mask = mask
        self.ratios = ratios or {}


class TrackingError(KleinformError):
    """A motion cannot be followed past a sample without risk of another assembly mode.

    Attributes
    ----------
    sample : int
        Index of the first sample that could not be reached.
    """

    def __init__(self, message: str, sample: int = 0) -> None:
        super().__init__(message)
        self.sample = sample


class MotionWarning(UserWarning):
    """A motion does what its waypoints do not show; the message says how far."""


class BackendError(KleinformError, ImportError):
    """The backend that KLEINFORM_BACKEND asks for is not there."""


class GeneratedCodeError(KleinformError):
    """The generated kernels are not those that this version of kleinform needs."""
