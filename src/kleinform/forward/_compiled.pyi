"""The extension that is compiled from extension.c, solver.c and tables.c."""

from numpy import float64, int64
from numpy.typing import NDArray

def instructions() -> str: ...
def solve(
    radius: NDArray[float64],
    position: NDArray[float64],
    lengths: NDArray[float64],
    tolerance: float,
) -> tuple[
    NDArray[int64], NDArray[float64], NDArray[float64], NDArray[float64], NDArray[float64]
]: ...
def use(name: str) -> bool: ...
