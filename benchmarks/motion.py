"""Example 1 forward, with velocities and accelerations, beside Pinocchio on the same samples."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from collections.abc import Callable

import numpy as np

import kleinform
from benchmarks.timing import medians
from kleinform.generated import kernels
from kleinform.motion import JointStates, PlatformStates
from kleinform.paper.examples import example_1
from kleinform.verification.report import ours, start_of

__all__ = ["closure", "table"]

SAMPLES = 100_000
ROUNDS = 5


def closure(states: JointStates, platform: PlatformStates) -> float:
    """Largest residual of the six quadratics (6) along a motion [m², 1]."""
    first, side = platform.rotations[..., 0], platform.rotations[..., 1]
    directions = np.stack([first, -0.5 * first + 0.75**0.5 * side], axis=1)
    system = kernels.closure(1.0, platform.positions, states.joints[:, :3], directions)
    return float(abs(system.residual).max())


def seconds(samples: int) -> dict[str, float]:
    """Median seconds of the motion on one core: ours, and Pinocchio's where it is installed."""
    kleinform.set_threads(1)
    states = example_1().sampled(samples)
    functions: dict[str, Callable[[], object]] = {"ours": lambda: ours(states)}
    if importlib.util.find_spec("pinocchio"):
        from kleinform.verification.by_pinocchio import PinocchioMechanism

        mechanism = PinocchioMechanism(start_of(ours(example_1().sampled(2))))
        functions["Pinocchio"] = lambda: mechanism.follow(states)
    found = medians(functions, ROUNDS)
    kleinform.set_threads(None)
    return found


def without_compiled_code(samples: int) -> float:
    """The same on NumPy's kernels, in a fresh interpreter."""
    code = f"from benchmarks.motion import only_ours; print(only_ours({samples}))"
    environment = {**os.environ, "KLEINFORM_BACKEND": "numpy", "OMP_NUM_THREADS": "1"}
    environment |= {"OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    printed = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    return float(printed.stdout)


def only_ours(samples: int) -> float:
    """Median seconds of our motion alone."""
    states = example_1().sampled(samples)
    return medians({"ours": lambda: ours(states)}, ROUNDS)["ours"]


def table() -> None:
    """Print a row each, and the residual along the motion."""
    states = example_1().sampled(SAMPLES)
    residual = closure(states, ours(states))
    print(f"\nExample 1 forward with velocities and accelerations, {SAMPLES} samples, one core;")
    print(f"medians of {ROUNDS} turns; residual of the closure equations {residual:.0e}")
    times = seconds(SAMPLES)
    rows = {"kleinform": times["ours"], "kleinform (NumPy)": without_compiled_code(SAMPLES)}
    if "Pinocchio" in times:
        rows["Pinocchio, Newton"] = times["Pinocchio"]
    else:
        print(f"{'Pinocchio':18} not installed")
    print(f"{'who':18}{'seconds':>9}{'us/sample':>11}{'times Pinocchio':>17}")
    for who, spent in rows.items():
        ratio = f"{times['Pinocchio'] / spent:17.1f}" if "Pinocchio" in times else ""
        print(f"{who:18}{spent:9.3f}{spent / SAMPLES * 1e6:11.2f}{ratio}")
