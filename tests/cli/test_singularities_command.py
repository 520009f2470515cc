"""``kleinform singularities``: the cubic and the planes of one orientation, and a mesh."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from kleinform import UncoupledManipulator
from kleinform.commands.inverse import rotation_of
from kleinform.commands.singularities import MONOMIALS
from kleinform.commands.streams import Streams
from kleinform.maps.loci import direct_locus
from tests.cli.support import read_csv

PAPER = ("--rpy", 10, 3, 6, "--degrees")
LOCUS = direct_locus(UncoupledManipulator(), rotation_of((10, 3, 6), True))
SURFACES = ("orientation", "extension_1", "extension_2", "extension_3", "wrist")


def test_the_table(run) -> None:
    ran = run("singularities", *PAPER)
    assert (ran.code, ran.err) == (0, "")
    answer = read_csv(ran.out)
    assert tuple(dict.fromkeys(answer["surface"])) == SURFACES
    for name, expected in {"orientation": LOCUS.coefficients, **LOCUS.planes}.items():
        rows = answer["surface"] == name
        assert tuple(answer["monomial"][rows]) == MONOMIALS[: len(expected)]
        np.testing.assert_array_equal(answer["coefficient"][rows], expected)
    assert set(answer["kind"]) == {"cubic", "plane"}


def test_the_monomials() -> None:
    """Their names belong to the coefficients."""
    position = np.array([0.3, -0.7, 1.1])
    values = dict(zip("1xyz", [1.0, *position], strict=True))
    total = 0.0
    for monomial, coefficient in zip(MONOMIALS, LOCUS.coefficients, strict=True):
        letters = re.sub("(.)²", r"\1\1", re.sub("(.)³", r"\1\1\1", monomial))
        total += coefficient * np.prod([values[letter] for letter in letters])
    assert total == pytest.approx(LOCUS.value(position), rel=1e-12)


@pytest.mark.parametrize(
    ("rpy", "kind"),
    [
        ((0, 0, 0), "identically zero"),
        ((0, 0, 30), "double plane"),
        ((0, 20, 0), "plane and quadric"),
        ((180, 0, 0), "double plane and plane"),
    ],
)
def test_the_kind(run, rpy: tuple[float, ...], kind: str) -> None:
    ran = run("singularities", "--rpy", *rpy, "--degrees", "--format", "json")
    assert json.loads(ran.out.splitlines()[0])["kind"] == kind


def test_at_a_terminal(run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Streams, "on_terminal", True)
    lines = run("singularities", *PAPER).out.splitlines()
    assert lines[0] == "orientation: cubic"
    assert [line.split()[0] for line in lines[1:21]] == list(MONOMIALS)
    assert [line.split()[0] for line in lines[23:]] == list(SURFACES[1:])
    assert len(set(map(len, lines[1:21]))) == len(set(map(len, lines[22:]))) == 1


@pytest.mark.parametrize(
    ("box", "low", "high"),
    [
        ((), [-4.0, -4.0, -2.0], [4.0, 4.0, 6.0]),
        (("--box", -1, 2, -3, 4, 0, 5), [-1.0, -3.0, 0.0], [2.0, 4.0, 5.0]),
    ],
)
def test_the_mesh(run, box: tuple[object, ...], low: list[float], high: list[float]) -> None:
    ran = run(
        *("singularities", *PAPER, "--radius", 2, "--mesh", "cubic.ply", *box),
        *("--resolution", 10),
    )
    assert (ran.code, ran.err) == (0, "")
    locus = direct_locus(UncoupledManipulator(2.0), LOCUS.rotation)
    vertices = locus.mesh([low, high], 10).vertices
    header, body = Path("cubic.ply").read_bytes().split(b"end_header\n", 1)
    assert f"element vertex {len(vertices)}\n".encode() in header
    np.testing.assert_array_equal(np.frombuffer(body[: vertices.nbytes], "<f8"), vertices.ravel())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "Missing option '--rpy'"),
        ((*PAPER, "--mesh", "cubic.obj"), "cubic.obj: the name must end in one of .stl, .ply"),
        ((*PAPER, "--mesh", "c.stl", "--box", 1, 0, 0, 1, 0, 1), "--box: (low, high) with "),
        ((*PAPER, "--resolution", 1000), "Invalid value for '--resolution'"),
        (("--rpy", 0, 0, 0, "--mesh", "c.stl"), "every position is singular"),
        ((*PAPER, "--radius", -1), "--radius: "),
    ],
)
def test_bad_options(run, arguments: tuple[object, ...], message: str) -> None:
    ran = run("singularities", *arguments)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert ran.err.startswith(f"kleinform: {message}")
