"""All assembly modes: this project's methods and other people's, on the same joint values."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

import kleinform
from benchmarks.joint_values import joint_values
from benchmarks.solvers import SOLVERS, nearby
from kleinform.forward.clusters import by_pencil
from kleinform.forward.displacement import rows_of
from kleinform.homotopy import solve_cones
from kleinform.joints import TOLERANCE
from kleinform_kernels import uncoupled

__all__ = ["table"]

#: Joint values for each method, fewer for those that are slow.
ROWS, MANY, FEW = 200, 20_000, 10
ROBOT = kleinform.UncoupledManipulator(radius=1.0)


class Answer(NamedTuple):
    """The row of each solution, n_1 and n_2, and the seconds it took for each row."""

    row: np.ndarray
    directions: np.ndarray
    seconds: np.ndarray


def table() -> None:
    """Print how complete, how exact and how fast each method is."""
    joints = nearby(joint_values("work", ROWS, seed=3))
    truth = certified(joints)
    proven = np.bincount(truth.row, minlength=ROWS)
    methods: dict[str, Callable[[np.ndarray], Answer | None]] = {
        "one by one": one_by_one,
        "batched": batched,
        "pencil alone, batched": pencil,
        "homotopy, batched": homotopy,
        **{name: peer(name) for name in SOLVERS},
    }
    print(f"\nall assembly modes: {ROWS} joint values, {proven.sum()} modes proven;", end=" ")
    print(f"{FEW} of them for {' and '.join(SOLVERS)}; one process")
    print(f"{'method':24}{'found':>7}{'complete':>10}{'residual':>10}{'median ms':>11}")
    show("certified", truth, joints, proven)
    for name, method in methods.items():
        given = joints[: FEW if name in SOLVERS else ROWS]
        answer = method(given)
        if answer is None:
            print(f"{name:24} not installed")
        else:
            show(name, answer, given, proven)
    many = joint_values("work", MANY, seed=4)
    start = time.perf_counter()
    ROBOT.forward_displacement_batch(many)
    seconds = time.perf_counter() - start
    print(f"{MANY} joint values in one batch: {MANY / seconds:.0f} solves a second")


def show(name: str, answer: Answer, joints: np.ndarray, proven: np.ndarray) -> None:
    """One line of the table."""
    number = np.bincount(answer.row, minlength=len(joints))
    complete = np.mean(number == proven[: len(joints)])
    worst = residual(answer, joints)
    median = np.median(answer.seconds) * 1e3
    print(f"{name:24}{len(answer.row):7}{complete:10.1%}{worst:10.0e}{median:11.3f}")


def residual(answer: Answer, joints: np.ndarray) -> float:
    """The largest residual of the six quadratics, the cones relative to their size."""
    rows = rows_of(np.ones(len(joints)), joints)
    cones = np.stack(uncoupled.cones(1.0, rows.position, rows.lengths), axis=1)
    n = np.concatenate([answer.directions, -answer.directions.sum(axis=1, keepdims=True)], axis=1)
    own = cones[answer.row]
    values = np.einsum("kij,kijl,kil->ki", n, own, n) / abs(own).max(axis=(2, 3))
    products = np.einsum("kij,klj->kil", n[:, :2], n[:, :2]) - np.array([[1, -0.5], [-0.5, 1]])
    return float(max(abs(values).max(), abs(products).max()))


def certified(joints: np.ndarray) -> Answer:
    """``forward_displacement(certify=True)``: the modes of rows that are proven complete."""
    row, directions, seconds, decided = [], [], [], 0
    for number, values in enumerate(joints):
        start = time.perf_counter()
        modes = ROBOT.forward_displacement(values, certify=True)
        seconds.append(time.perf_counter() - start)
        decided += modes.certificate is not None and modes.certificate.complete
        row += [number] * len(modes)
        directions.append(modes.directions[:, :2])
    if decided != len(joints):
        print(f"certified: {len(joints) - decided} of {len(joints)} undecided")
    return Answer(np.array(row), np.concatenate(directions), np.array(seconds))


def one_by_one(joints: np.ndarray) -> Answer:
    row, directions, seconds = [], [], []
    ROBOT.forward_displacement(joints[0])
    for number, values in enumerate(joints):
        start = time.perf_counter()
        modes = ROBOT.forward_displacement(values)
        seconds.append(time.perf_counter() - start)
        row += [number] * len(modes)
        directions.append(modes.directions[:, :2])
    return Answer(np.array(row), np.concatenate(directions), np.array(seconds))


def batched(joints: np.ndarray) -> Answer:
    start = time.perf_counter()
    modes = ROBOT.forward_displacement_batch(joints)
    seconds = (time.perf_counter() - start) / len(joints)
    row = np.repeat(np.arange(len(joints)), modes.count)
    return Answer(row, modes.directions[:, :2], np.array([seconds]))


def pencil(joints: np.ndarray) -> Answer:
    start = time.perf_counter()
    modes, _ = by_pencil(rows_of(np.ones(len(joints)), joints), TOLERANCE)
    seconds = (time.perf_counter() - start) / len(joints)
    return Answer(modes.row, modes.directions, np.array([seconds]))


def homotopy(joints: np.ndarray) -> Answer:
    rows = rows_of(np.ones(len(joints)), joints)
    start = time.perf_counter()
    ends = solve_cones(np.stack(uncoupled.cones(1.0, rows.position, rows.lengths), axis=1))
    seconds = (time.perf_counter() - start) / len(joints)
    x = ends.points[..., 1:] / ends.points[..., :1]
    real = (abs(x.imag).max(axis=-1) <= 1e-8) & (ends.status == "regular")
    row, path = np.nonzero(real)
    return Answer(row, x[row, path].real.reshape(-1, 2, 3), np.array([seconds]))


def peer(name: str) -> Callable[[np.ndarray], Answer | None]:
    """One of `benchmarks.solvers`, one of each pair ±n of its solutions."""

    def method(joints: np.ndarray) -> Answer | None:
        row, directions, seconds = [], [], []
        for number, values in enumerate(joints):
            start = time.perf_counter()
            both = SOLVERS[name](values)
            seconds.append(time.perf_counter() - start)
            if both is None:
                return None
            half = both[both.reshape(-1, 6)[:, 0] > 0.0]
            row += [number] * len(half)
            directions.append(half)
        return Answer(np.array(row), np.concatenate(directions), np.array(seconds))

    return method
