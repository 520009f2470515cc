"""Files of limits spoiled at random: the right limits come out, or a typed error on few lines."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import partial
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from kleinform import InputError, Limits
from tests.support import many

GOOD = b"""# a machine
unit = "deg"
[ranges]
q1 = [0.6, 1.5]
q4 = [-170, 170.0]
q5 = [40, 90]
q6 = [0.7, inf]
"e1" = [2e-1, 1_0]
[margins]
orientation = 0.01
wrist = 1e-3
"""
#: What is put in the place of some bytes, or between them.
PIECES = (
    *(b"9" * 6000, b"0x" + b"f" * 6000, b"0b" + b"1" * 20_000, b"1" + b"0" * 400, b"1e999"),
    *(b"[" * 5000, b"{a=" * 3000, b"[[]," * 2000, b"q1." * 4000, b"a" * 100_000),
    *(b"nan", b"-inf", b"true", b'"0.6"', b"1979-05-27", b"07:32:00", b"9999-99-99T99:99:99Z"),
    *(b"\xff", b"\x00", b"\xef\xbb\xbf", "√3".encode(), b'"\\ud800"', b'"""', b"'", b"#", b"\r"),
    *(b"[ranges]\n", b"[margins]\n", b"[ranges.q1]\n", b"[[ranges]]\n", b"unit = 'rad'\n"),
    *(b"q1 = [-2, -1]\n", b"q5 = [100, 120]\n", b"q5 = [0, 400]\n", b"q2 = 0x10\n", b"[", b"]"),
    *(b"0", b"-", b"=", b"\n", b",", b"{}", b"", b" "),
)
LENGTHS = ("q1", "q2", "q3", "q6")


def or_message(made: Callable[[], Limits]) -> Limits | str:
    """What is made, or what a typed error says."""
    try:
        return made()
    except InputError as error:
        return str(error)


def spoiled(rng: np.random.Generator) -> bytes:
    """The good file with one to four changes."""
    text = GOOD
    for _ in range(rng.integers(1, 5)):
        start = int(rng.integers(len(text) + 1))
        stop = start + int(rng.integers(0, 4)) if rng.random() < 0.7 else start
        piece = PIECES[rng.integers(len(PIECES))] if rng.random() < 0.8 else rng.bytes(1)
        text = text[:start] + piece + text[stop:]
    return text


def check(limits: Limits, text: bytes) -> None:
    """The limits are those that the file has, by another reading of it."""
    tables = tomllib.loads(text.decode())
    turn = radians(1.0) if tables.get("unit") == "deg" else 1.0
    assert set(limits.ranges) == set(tables.get("ranges", {}))
    for name, (low, high) in limits.ranges.items():
        wanted = np.array([float(end) for end in tables["ranges"][name]])
        np.testing.assert_allclose(
            (low, high), wanted * (turn if name in ("q4", "q5") else 1.0), rtol=1e-15
        )
        assert low < high
        assert name not in LENGTHS or high >= 0.0
        assert name != "q5" or (low <= pi / 2.0 and high >= -pi / 2.0)
    assert limits.margins == tables.get("margins", {})


@pytest.mark.long
def test_spoiled_files(tmp_path: Path) -> None:
    rng = np.random.default_rng(12)
    path = tmp_path / "limits.toml"
    read = 0
    for _ in range(many(1_500, 50_000)):
        text = spoiled(rng)
        path.write_bytes(text)
        limits = or_message(partial(Limits.from_toml, path))
        if isinstance(limits, str):
            assert limits.startswith(f"{path}: ")
            assert len(limits) < len(str(path)) + 400
        else:
            check(limits, text)
            read += 1
    assert read > 20


DEEP: list = []
for _ in range(100_000):
    DEEP = [DEEP]
ODD = (
    *(10**6000, -(10**6000), DEEP, "a" * 10_000, None, True, b"1", np.nan, np.inf, -np.inf),
    *(1, 0.5, -1.0, np.float32(2.0), np.int8(-3), np.array(1.0), np.array([1.0]), 1j, {}, [], ()),
    *(2.0 * pi, 7.0, -7.0, 40, 90, np.datetime64("2000-01-01"), object, [0, 1], (1, 0), {0: 1}),
)


@pytest.mark.long
@pytest.mark.parametrize("name", ["q1", "q4", "q5", "q6", "e1"])
def test_odd_values(name: str) -> None:
    rng = np.random.default_rng(3)
    for _ in range(many(500, 20_000)):
        first, second, unit = (ODD[rng.integers(len(ODD))] for _ in range(3))
        given = {name: (first, second) if rng.random() < 0.8 else first}
        words = {} if rng.random() < 0.6 else {"unit": rng.choice(["deg", "rad"])}
        if rng.random() < 0.1:
            words = {"unit": unit}
        margins = {"wrist": ODD[rng.integers(len(ODD))]}
        limits = or_message(partial(Limits, given, margins, **words))
        if isinstance(limits, str):
            assert len(limits) < 400
        else:
            low, high = limits.ranges[name]
            assert low < high
            assert name not in LENGTHS or high >= 0.0
            assert 0.0 <= limits.margins["wrist"] < np.inf
