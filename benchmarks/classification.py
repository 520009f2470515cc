"""The classes of many poses beside their survey, on one core."""

from __future__ import annotations

import numpy as np

from benchmarks.kernels import ROBOT, one_core, poses
from benchmarks.timing import medians
from kleinform_kernels import uncoupled

__all__ = ["table"]

POSES = 1_000_000
ROUNDS = 9


def table() -> None:
    """Print a row each: the bare kernel, and validated calls."""
    c, rotation = poses(POSES)
    # All are singular, so that none is passed over quickly.
    level = np.broadcast_to(np.eye(3), rotation.shape).copy()
    with one_core():
        times = medians(
            {
                "survey kernel": lambda: uncoupled.survey(1.0, c, rotation),
                "robot.survey": lambda: ROBOT.survey(c, rotation),
                "robot.classify": lambda: ROBOT.classify(c, rotation),
                "all singular": lambda: ROBOT.classify(c, level),
            },
            ROUNDS,
        )
    print(f"\nclasses of {POSES} poses, one core; medians of {ROUNDS} turns")
    print(f"{'who':18}{'ns/pose':>9}{'kernels':>9}")
    for who, seconds in times.items():
        ratio = seconds / times["survey kernel"]
        print(f"{who:18}{seconds / POSES * 1e9:9.4g}{ratio:9.2f}")
