"""Rows alone and in company: what a call answers to each row, byte by byte."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

import kleinform
from tests.runtime.modes_support import SPREADS, poses_on_the_locus, random_joints, random_poses
from tests.runtime.test_forward_degenerate import SIDE, central
from tests.support import BASE_AXES, DISTANCES, NEAR, batch, random_cases

#: Around the lanes of processors and of the compiled kernels, and the rows that are solved at
#: once.
SIZES = (2, 3, 7, 8, 9, 17, 512, 513)
LAYOUTS = ("in a row", "strided", "backwards", "components first")
Columns = tuple[np.ndarray, ...]


class Call(NamedTuple):
    """A call on columns (N, ...): its answers to a batch, a tree of arrays and text a row.

    Where one row may come without its leading axis, ``alone`` is its answer to that.
    """

    name: str
    columns: Columns
    rows: Callable[..., list[object]]
    alone: Callable[..., object] | None = None


def rowwise(
    name: str, function: Callable[..., object], columns: Columns, single: bool = True
) -> Call:
    """A call whose answer to a batch is a tree of arrays (N, ...)."""

    def answer(*given: np.ndarray) -> object:
        return tree(function(*given))

    return Call(name, columns, lambda *given: each(answer(*given)), answer if single else None)


def tree(answer: object) -> object:
    """Arrays, and tuples of them as lists."""
    return list(map(tree, answer)) if isinstance(answer, (list, tuple)) else np.asarray(answer)


def each(answer: object) -> list[object]:
    """The rows of a tree of arrays (N, ...)."""
    if isinstance(answer, np.ndarray):
        return list(answer)
    return [list(row) for row in zip(*map(each, answer), strict=True)]


def bytes_of(answer: object) -> object:
    """The same tree, its arrays as shapes and bytes."""
    if isinstance(answer, (list, tuple)):
        return [bytes_of(entry) for entry in answer]
    if isinstance(answer, (np.ndarray, np.generic)):
        return answer.shape, answer.tobytes()
    return answer


def laid_out(column: np.ndarray, index: np.ndarray, layout: str) -> np.ndarray:
    """Some rows of a column, in one of `LAYOUTS`."""
    taken = np.ascontiguousarray(column[index])
    if layout == "strided":
        return np.repeat(taken, 3, axis=0)[::3]
    if layout == "backwards":
        return np.ascontiguousarray(taken[::-1])[::-1]
    if layout == "components first":
        return np.moveaxis(np.ascontiguousarray(np.moveaxis(taken, 0, -1)), -1, 0)
    return taken


def companies(rng: np.random.Generator, count: int) -> Iterator[tuple[np.ndarray, str]]:
    """All rows, shuffled, in batches of each size, and all together in each layout."""
    for number, size in enumerate(SIZES):
        order = rng.permutation(count)
        for start in range(0, count, size):
            yield order[start : start + size], LAYOUTS[(number + start // size) % len(LAYOUTS)]
    for layout in LAYOUTS:
        yield rng.permutation(count), layout


def differing(call: Call) -> np.ndarray:
    """Rows whose answer depends on their company, its order or layout, or on the threads."""
    count = len(call.columns[0])
    different, first = np.zeros(count, dtype=bool), []
    for row in range(count):
        one = (laid_out(column, np.array([row]), "in a row") for column in call.columns)
        first.append(bytes_of(call.rows(*one)[0]))
        if call.alone is not None:
            alone = bytes_of(call.alone(*(column[row] for column in call.columns)))
            different[row] = alone != first[row]
    for number, (index, layout) in enumerate(companies(np.random.default_rng(0), count)):
        kleinform.set_threads(1 + number % 2)
        answers = call.rows(*(laid_out(column, index, layout) for column in call.columns))
        for row, answer in zip(index, answers, strict=True):
            different[row] |= bytes_of(answer) != first[row]
    kleinform.set_threads(None)
    return np.flatnonzero(different)


def any_poses(rng: np.random.Generator, count: int) -> Columns:
    """Positions and rotations: three quarters of them anywhere, the others nearly singular."""
    names = list(NEAR)
    cases = random_cases(rng, count - count // 4)
    for number in range(count // 4):
        near = NEAR[names[number % len(names)]]
        cases.append(near(rng, DISTANCES[number // len(names) % len(DISTANCES)]))
    _, position, rotation = batch(cases)
    return position, rotation


def joint_values(rng: np.random.Generator, count: int) -> np.ndarray:
    """Of poses and of none, on both sides of folds, C near planes of legs, and short legs."""
    part = count // 8
    kinds = [random_poses(rng, 2 * part, spread).joints[:part] for spread in SPREADS]
    kinds.append(random_joints(rng, part))
    for nearness in (1e-7, 1e-12):
        fold = poses_on_the_locus(rng, part, "workspace")[0].joints
        kinds.append(fold * (1.0 + nearness * rng.normal(size=fold.shape)))
    planes, legs = random_joints(rng, part), random_joints(rng, part)
    for number in range(part):
        limb = number % 3
        across = rng.uniform(-0.6, 0.6) * SIDE[limb] + [0.0, 0.0, rng.uniform(0.4, 1.5)]
        away = rng.choice([0.0, 1e-12, 1e-8, 1e-5, 1e-3])
        planes[number, 3:] = central((1.0 + away) * BASE_AXES[limb] + across)
        legs[number, limb] = rng.choice([0.0, 1e-14, 1e-9, 1e-3])
    return np.concatenate([*kinds, planes, legs])
