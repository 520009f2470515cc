"""Generated kernels against peers: many poses, one pose, writing to memory, and two cores.

A, B and C run on one core, two cores against one come after them.
"""

from __future__ import annotations

import contextlib
import os
import re
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

import numpy as np

import kleinform
from benchmarks.peers import batch_peers, check, lambdified, missing, placed, single_peers
from benchmarks.timing import medians
from kleinform_kernels import uncoupled
from kleinform_kernels.uncoupled import numpy_kernels

__all__ = ["poses", "table"]

POSES, CALLS, MANY = 200_000, 1000, 10_000_000
#: Bytes for MANY poses: arguments of 96 a pose, results of 208 a pose, and as much again.
MEMORY = 6 * 10**9
ROUNDS = 9
ROBOT = kleinform.UncoupledManipulator(radius=1.0)
Functions = dict[str, Callable[[], object]]


def table() -> None:
    """Print every table."""
    with one_core():
        many_poses()
        jacobians()
        one_pose()
    two_cores()


def poses(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Random poses: positions around (0, 0, 1) m, rotations of any roll, pitch and yaw."""
    generator = np.random.default_rng(2021)
    position = generator.normal(scale=0.4, size=(count, 3)) + np.array([0.0, 0.0, 1.0])
    roll, pitch, yaw = generator.uniform(-1.2, 1.2, size=(3, count))
    rotation = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    return position, np.ascontiguousarray(rotation)


@contextlib.contextmanager
def one_core() -> Iterator[None]:
    """Keep this thread, and all that it starts, on one core."""
    pinned = hasattr(os, "sched_setaffinity")
    cores = os.sched_getaffinity(0) if pinned else set()
    kleinform.set_threads(1)
    if pinned:
        os.sched_setaffinity(0, {max(cores)})
    try:
        yield
    finally:
        kleinform.set_threads(None)
        if pinned:
            os.sched_setaffinity(0, cores)


def many_poses() -> None:
    """A: the survey of many poses."""
    c, rotation = poses(POSES)
    expected = uncoupled.survey(1.0, c, rotation)
    targets = [np.empty_like(array) for array in expected]
    functions: Functions = {}
    for name, function in {"lambdify": lambdified("survey"), **batch_peers(POSES)}.items():
        arguments = placed(name, c, rotation)
        check(name, function(1.0, *arguments), expected)
        functions[name] = partial(function, 1.0, *arguments)
    functions["kernel (NumPy)"] = lambda: numpy_kernels.survey(1.0, c, rotation)
    functions["kernel"] = lambda: uncoupled.survey(1.0, c, rotation)
    if uncoupled.BACKEND == "compiled":
        functions["kernel, out="] = into("survey", [1.0, c, rotation], targets)
    functions["validated call"] = lambda: ROBOT.survey(c, rotation)
    functions["numpy.copyto"] = partial(copy, expected, targets)
    print(f"\nA. survey of {POSES} poses, one core; medians of {ROUNDS} turns; copyto: its results")
    show(functions, "ns/pose", 1e9 / POSES, ("lambdify", "kernel"), missing())


def jacobians() -> None:
    """B: joint values and both Jacobians, so many numbers that memory is the limit."""
    c, rotation = poses(POSES)
    heading = c[:, :2]
    moved = lambdified("joints_and_jacobians")
    expected = uncoupled.joints_and_jacobians(1.0, c, rotation, heading)
    check("lambdify", moved(1.0, c, rotation), expected)
    targets = [np.empty_like(array) for array in expected]
    functions: Functions = {
        "lambdify": lambda: moved(1.0, c, rotation),
        "kernel (NumPy)": lambda: numpy_kernels.joints_and_jacobians(1.0, c, rotation, heading),
        "kernel": lambda: uncoupled.joints_and_jacobians(1.0, c, rotation, heading),
    }
    if uncoupled.BACKEND == "compiled":
        functions["kernel, out="] = into(
            "joints_and_jacobians", [1.0, c, rotation, heading], targets
        )
    functions["validated calls"] = lambda: (
        ROBOT.inverse_displacement(c, rotation),
        ROBOT.jacobians(c, rotation),
    )
    functions["numpy.copyto"] = partial(copy, expected, targets)
    print(f"\nB. q, J_v and J_q of {POSES} poses, one core; copyto: of three such arrays")
    show(functions, "ns/pose", 1e9 / POSES, ("lambdify", "numpy.copyto"))


def one_pose() -> None:
    """C: joint values of one pose a call, from Python."""
    pairs = list(zip(*poses(CALLS), strict=True))
    functions: Functions = {}
    for name, function in single_peers().items():
        arguments = [placed(name, *pair) for pair in pairs]
        for pair, place in zip(pairs, arguments, strict=True):
            check(name, function(1.0, *place), uncoupled.inverse_displacement(1.0, *pair))
        functions[name] = partial(each, partial(function, 1.0), arguments)
    alone = partial(numpy_kernels.inverse_displacement, 1.0)
    functions["kernel (NumPy)"] = partial(each, alone, pairs)
    functions["kernel"] = partial(each, partial(uncoupled.inverse_displacement, 1.0), pairs)
    functions["validated call"] = partial(each, ROBOT.inverse_displacement, pairs)
    print(f"\nC. inverse_displacement of one pose a call, one core; {CALLS} calls a turn")
    show(functions, "us/call", 1e6 / CALLS, ("lambdify", "kernel"), missing())


def two_cores() -> None:
    """The survey of very many poses on one thread and on two, results freed between runs.

    The fastest runs are compared: in others the system takes up to seconds to give the 2 GB.
    """
    print(f"\nsurvey of {MANY} poses on one thread and on two:", end=" ")
    if available_memory() < MEMORY:
        print(f"needs {MEMORY / 1e9:.0f} GB of memory")
        return
    c, rotation = (np.concatenate([array] * (MANY // POSES)) for array in poses(POSES))
    times: dict[int, list[float]] = {1: [], 2: []}
    for _ in range(ROUNDS):
        for threads, values in times.items():
            kleinform.set_threads(threads)
            start = time.perf_counter()
            result = uncoupled.survey(1.0, c, rotation)
            values.append(time.perf_counter() - start)
            del result
    kleinform.set_threads(None)
    one, two = map(min, times.values())
    print(f"{one:.2f} s and {two:.2f} s, {one / two:.2f} times (fastest of {ROUNDS})")


def into(name: str, arguments: list[object], out: list[np.ndarray]) -> Callable[[], object]:
    """The ufunc of a kernel, into arrays that are there."""
    from kleinform_kernels.uncoupled import gufuncs

    return lambda: getattr(gufuncs, name)(*arguments, out=tuple(out))


def copy(sources: Sequence[np.ndarray], targets: Sequence[np.ndarray]) -> None:
    """Nothing but moving memory: what writing results costs at least."""
    for source, target in zip(sources, targets, strict=True):
        np.copyto(target, source)


def each(function: Callable[..., object], arguments: Sequence[Sequence[object]]) -> None:
    """Call a function for one pose after the other."""
    for pair in arguments:
        function(*pair)


def show(
    functions: Functions, unit: str, scale: float, peers: Sequence[str], absent: Sequence[str] = ()
) -> None:
    """Time all in turns; a row each, beside how many times as fast as some of them it is."""
    times = medians(functions, ROUNDS)
    print(f"{'who':18}{unit:>9}" + "".join(f"{f'times {peer}':>20}" for peer in peers))
    for name in absent:
        print(f"{name:18} not installed")
    for who, seconds in times.items():
        ratios = "".join(f"{times[peer] / seconds:20.2f}" for peer in peers)
        print(f"{who:18}{seconds * scale:9.4g}{ratios}")


def available_memory() -> int:
    """Bytes that can be had without swapping, 0 where that is not known."""
    with contextlib.suppress(OSError):
        text = Path("/proc/meminfo").read_text(encoding="ascii")
        return 1024 * int(re.findall(r"MemAvailable:\s+(\d+)", text)[0])
    return 0
