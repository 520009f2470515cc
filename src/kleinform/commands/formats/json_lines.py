"""Tables as JSON: an object a line, or one array of objects, which is read whole."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from kleinform.commands.columns import Array, Table
from kleinform.commands.formats.lines import LineBlock, Lines
from kleinform.commands.source import ROWS, Block, numbered
from kleinform.errors import InputError

__all__ = ["JsonSource"]


class Objects(NamedTuple):
    """Some values that should be objects; the attributes are those of `Block`."""

    values: list[Any]
    where: Callable[[int], str]
    done: float


class JsonSource:
    """JSON that is read in blocks; the first object names the columns, null is NaN."""

    def __init__(self, lines: Lines) -> None:
        self.name = lines.name
        first, number = lines.first()
        start = LineBlock([first], [number], lines.name, 0.0)
        if first.lstrip().startswith("["):
            self._objects = _of_array(first + lines.rest(), start)
        elif first:
            self._objects = map(_of_lines, chain([start], lines.blocks()))
        else:
            self._objects = iter(())
        opening = next(self._objects, None)
        if opening is None:
            raise InputError(f"{self.name}: empty, the first object names the columns")
        self._objects = chain([opening], self._objects)
        _check(opening.values[0], (), opening.where, 0)
        self.columns = list(opening.values[0])

    def blocks(self, names: Sequence[str]) -> Iterator[Block]:
        for objects in self._objects:
            for index, value in enumerate(objects.values):
                _check(value, names, objects.where, index)
            table: Table = {name: _column(objects, name) for name in names}
            yield Block(table, objects.where, _cells(objects), objects.done)


def _of_lines(block: LineBlock) -> Objects:
    values = []
    for row, line in enumerate(block.lines):
        try:
            values.append(_loaded(line))
        except (ValueError, RecursionError) as error:
            raise InputError(f"{block.where(row)}: no JSON: {error}") from None
    return Objects(values, block.where, block.done)


def _of_array(text: str, start: LineBlock) -> Iterator[Objects]:
    """The elements of one array, whose first line is given for its place."""
    try:
        values = _loaded(text)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{start.where(0)}: no JSON array: {error}") from None
    for first in range(0, len(values), ROWS):
        part = values[first : first + ROWS]
        done = (first + len(part)) / len(values)
        yield Objects(part, numbered(start.name, first), done)


def _loaded(text: str) -> Any:
    """What a text says, if it says it once."""
    return json.loads(text, object_pairs_hook=_object)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in found if names.count(name) > 1)
        raise ValueError(f"{twice} is there twice")
    return found


def _cells(objects: Objects) -> Callable[[int, str], str]:
    return lambda row, name: _short(objects.values[row][name])


def _check(value: Any, names: Sequence[str], where: Callable[[int], str], index: int) -> None:
    """Refuse what is no object with these names."""
    if not isinstance(value, dict):
        raise InputError(f"{where(index)}: an object is needed, {_short(value)} arrived")
    for name in names:
        if name not in value:
            raise InputError(f"{where(index)}: {name} is missing; {', '.join(value)} arrived")


def _column(objects: Objects, name: str) -> Array:
    """The numbers of one name."""
    values = [value[name] for value in objects.values]
    if set(map(type, values)) <= {float}:
        return np.array(values)
    return np.array(
        [_number(value, objects.where, index, name) for index, value in enumerate(values)]
    )


def _number(value: Any, where: Callable[[int], str], index: int, name: str) -> float:
    """A number that may be written as an integer or as null."""
    if value is None:
        return np.nan
    if type(value) not in (int, float):
        raise InputError(f"{where(index)}: {name}: a number is needed, {_short(value)} arrived")
    try:
        return float(value)
    except OverflowError:
        raise InputError(f"{where(index)}: {name}: beyond float64") from None


def _short(value: Any) -> str:
    return json.dumps(value)[:40]
