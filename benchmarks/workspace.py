"""The volume of the constant-orientation workspace: value, proven bound and seconds."""

from __future__ import annotations

import time

import numpy as np

import kleinform
from kleinform.maps.workspace import Workspace, constant_orientation_workspace

__all__ = ["table"]

ROBOT = kleinform.UncoupledManipulator(radius=1.0)
#: Roll, pitch and yaw in degrees, the paper's of Fig. 3 first.
ORIENTATIONS = {
    "Fig. 3": (10.0, 3.0, 6.0),
    "R = I": (0.0, 0.0, 0.0),
    "pitch 30°": (0.0, 30.0, 0.0),
}
RELATIVE = (1e-4, 1e-6)
SAMPLES = 1_000_000


def table() -> None:
    """Print proven volumes, the time they take, and Monte Carlo beside them."""
    print("\nconstant-orientation workspace, Limits.typical(1.0), one process")
    print(f"{'orientation':12}{'method':>14}{'volume m³':>14}{'bound':>10}{'panels':>8}{'s':>8}")
    for name, angles in ORIENTATIONS.items():
        roll, pitch, yaw = np.radians(angles)
        rotation = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
        workspace = constant_orientation_workspace(ROBOT, rotation, kleinform.Limits.typical(1.0))
        for relative in RELATIVE:
            start = time.perf_counter()
            volume = workspace.volume(relative)
            seconds = time.perf_counter() - start
            method = f"proven {relative:.0e}" if volume.proven else "not reached"
            print(
                f"{name:12}{method:>14}{volume.value:14.8f}{volume.error:10.1e}"
                f"{volume.panels:8}{seconds:8.2f}"
            )
        start = time.perf_counter()
        value, deviation = monte_carlo(workspace, SAMPLES)
        seconds = time.perf_counter() - start
        print(f"{name:12}{'Monte Carlo':>14}{value:14.8f}{deviation:10.1e}{'':8}{seconds:8.2f}")


def monte_carlo(workspace: Workspace, samples: int) -> tuple[float, float]:
    """The volume by random positions in the box, and its standard error."""
    low, high = workspace.box
    rng = np.random.default_rng(0)
    blocks = [
        workspace.contains(rng.uniform(low, high, (samples // 40, 3))).mean() for _ in range(40)
    ]
    box = float(np.prod(high - low))
    share = float(np.mean(blocks))
    return box * share, box * float(np.sqrt(share * (1.0 - share) / samples))
