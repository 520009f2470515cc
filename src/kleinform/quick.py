"""Quick checks: True where every rule is kept, False where a closer look is needed.

`classes` gives the codes of poses, or None where a closer look is needed. Compiled where the
backend is; on NumPy there is nothing quicker than the closer look. They look at plain C-ordered
float64 arrays alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import BackendError
from kleinform.generated import kernels

__all__ = ["classes", "none_zero", "sized", "sound"]

if kernels.BACKEND == "compiled":
    try:
        from kleinform._checks import classes, none_zero, sized, sound
    except ImportError as error:
        raise BackendError(f"compiled only in part: {error}; reinstall kleinform") from error
else:

    def classes(*survey_and_factor: object) -> NDArray[np.uint8] | None:
        """The codes of a survey's poses."""
        return None

    def none_zero(values: object, scales: object, factor: float) -> bool:
        """No value is finite and ``|value| <= factor scale``.

        There is a scale for each value, one for each row of values, or one float for all.
        """
        return False

    def sized(values: object, smallest: float, largest: float) -> bool:
        """Every value is 0 or ``smallest <= |value| <= largest``."""
        return False

    def sound(
        position: object, rotation: object, smallest: float, largest: float, defect: float
    ) -> bool:
        """Positions (..., 3) are sized, and rotations (..., 3, 3) have at most this defect."""
        return False
