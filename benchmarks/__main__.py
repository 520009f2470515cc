"""``make bench``: every figure that README and docs name, measured in this run."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
from pathlib import Path

from benchmarks import classification, kernels, modes, motion, workspace
from benchmarks.report import machine, saved

RESULTS = Path(__file__).with_name("results.md")


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
    with saved(RESULTS):
        print(machine())
        kernels.table()
        classification.table()
        modes.table()
        motion.table()
        workspace.table()
        import_time()
