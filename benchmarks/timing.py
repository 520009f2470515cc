"""Time several functions in turns, so that a busy moment of the machine hits all of them."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable

__all__ = ["medians"]


def medians(functions: dict[str, Callable[[], object]], rounds: int = 9) -> dict[str, float]:
    """Median seconds of each function over the rounds, after one round to warm up."""
    times: dict[str, list[float]] = {name: [] for name in functions}
    for turn in range(rounds + 1):
        for name, function in functions.items():
            start = time.perf_counter()
            function()
            if turn:
                times[name].append(time.perf_counter() - start)
    return {name: statistics.median(values) for name, values in times.items()}
