"""``make bench``: every figure that README and docs name, measured in this run."""

from __future__ import annotations

import os
import platform
import statistics
import subprocess
import sys
from collections.abc import Callable

import numpy as np

import kleinform
from benchmarks import modes
from benchmarks.peers import lambdified
from benchmarks.timing import medians
from kleinform_kernels import uncoupled

POSES = 200_000
SURVEY = {"survey": tuple(uncoupled.Survey._fields)}
VELOCITY = {"inverse_displacement": ("joints",), "jacobians": ("J_v", "J_q")}


def poses(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Random poses: positions around (0, 0, 1) m, rotations of any roll, pitch and yaw."""
    generator = np.random.default_rng(2021)
    position = generator.normal(scale=0.4, size=(count, 3)) + np.array([0.0, 0.0, 1.0])
    roll, pitch, yaw = generator.uniform(-1.2, 1.2, size=(3, count))
    return position, kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)


def throughput() -> None:
    """Kernels and validated calls against lambdify."""
    c, rotation = poses(POSES)
    rotation = np.ascontiguousarray(rotation)
    robot = kleinform.UncoupledManipulator(radius=1.0)
    heading = c[:, :2]
    surveyed, moved = lambdified(SURVEY), lambdified(VELOCITY)
    works: dict[str, dict[str, Callable[[], object]]] = {
        "survey": {
            "lambdify": lambda: surveyed(1.0, c, rotation),
            "kernel": lambda: uncoupled.survey(1.0, c, rotation),
            "validated call": lambda: robot.survey(c, rotation),
        },
        "q, J_v, J_q": {
            "lambdify": lambda: moved(1.0, c, rotation),
            "kernel": lambda: (
                uncoupled.inverse_displacement(1.0, c, rotation),
                uncoupled.jacobians(1.0, c, rotation, heading),
            ),
            "validated call": lambda: (
                robot.inverse_displacement(c, rotation),
                robot.jacobians(c, rotation),
            ),
        },
    }
    print(f"{POSES} poses, one process; medians of 9 turns, nanoseconds a pose")
    print(f"{'work':14}{'who':18}{'ns/pose':>9}{'times lambdify':>16}")
    for work, functions in works.items():
        times = medians(functions)
        for who, seconds in times.items():
            ratio = times["lambdify"] / seconds
            print(f"{work:14}{who:18}{seconds / POSES * 1e9:9.0f}{ratio:16.2f}")


def import_time(rounds: int = 15) -> None:
    """``import kleinform`` against ``import numpy``, each in a fresh interpreter, in turns."""
    code = "import time; t = time.perf_counter(); import {}; print(time.perf_counter() - t)"
    times: dict[str, list[float]] = {"numpy": [], "kleinform": []}
    # Compiled modules are kept between runs, as in any installed package.
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    for turn in range(rounds + 1):
        for name, values in times.items():
            command = [sys.executable, "-c", code.format(name)]
            printed = subprocess.run(
                command, capture_output=True, text=True, check=True, env=environment
            )
            if turn:
                values.append(float(printed.stdout))
    numpy, ours = (statistics.median(times[name]) for name in ("numpy", "kleinform"))
    print(f"\nimport numpy {numpy * 1e3:.0f} ms, import kleinform {ours * 1e3:.0f} ms:", end=" ")
    print(f"{ours / numpy:.2f} times (medians of {rounds})")


if __name__ == "__main__":
    print(f"Python {platform.python_version()}, NumPy {np.__version__}, {platform.machine()}")
    throughput()
    modes.table()
    import_time()
