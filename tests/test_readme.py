"""What README prints is what its code prints."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import numpy as np
import pytest

import kleinform

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", README, flags=re.DOTALL)


@pytest.fixture(scope="module")
def example() -> tuple[dict[str, object], str]:
    """The names that the first Python block leaves, and what it printed."""
    code = next(text for language, text in BLOCKS if language == "python")
    names: dict[str, object] = {}
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, names)
    return names, printed.getvalue()


def test_the_example_prints_what_readme_shows(example) -> None:
    _, printed = example
    shown = next(text for language, text in BLOCKS if not language)
    assert printed == shown


def test_the_error_is_the_one_that_readme_shows(example) -> None:
    names, _ = example
    code = [text for language, text in BLOCKS if language == "python"][1]
    call, comment = code.strip().split("\n")
    with pytest.raises(kleinform.SingularPoseError) as caught:
        exec(call, dict(names))
    assert comment == f"# kleinform.errors.SingularPoseError: {caught.value}"


@pytest.mark.parametrize(
    ("name", "section"),
    [
        ("assembly-modes.md", ""),
        ("motion.md", ""),
        ("maps.md", ""),
        ("singularities.md", "## Near a singularity\n"),
    ],
)
def test_a_page_prints_what_it_shows(name: str, section: str) -> None:
    page = (Path(__file__).parents[1] / "docs" / name).read_text(encoding="utf-8")
    page = page[page.index(section) :]
    blocks = re.findall(r"```(\w*)\n(.*?)```", page, flags=re.DOTALL)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(next(text for language, text in blocks if language == "python"), {})
    assert printed.getvalue() == next(text for language, text in blocks if not language)


@pytest.mark.skipif(kleinform.backend().name != "compiled", reason="gufuncs are compiled kernels")
def test_the_page_on_backends_runs() -> None:
    """All its blocks, in order, the second with poses and room for results of the reader's."""
    page = (Path(__file__).parents[1] / "docs" / "backends.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```(\w*)\n(.*?)```", page, flags=re.DOTALL)
    names = {"c": np.full((4, 3), 0.5), "R": np.broadcast_to(np.eye(3), (4, 3, 3))}
    names |= {"q": np.empty((4, 6)), "J_v": np.empty((4, 6, 6)), "J_q": np.empty((4, 6, 6))}
    printed = io.StringIO()
    for code in (text for language, text in blocks if language == "python"):
        printed.truncate(printed.seek(0))
        with contextlib.redirect_stdout(printed):
            exec(code, names)
    assert printed.getvalue() == next(text for language, text in blocks if not language)
    joints = kleinform.UncoupledManipulator().inverse_displacement(names["c"], names["R"])
    np.testing.assert_array_equal(names["q"], joints)


def test_the_figures_are_those_of_the_benchmark() -> None:
    """The tables as `make bench` has written them."""
    saved = (Path(__file__).parents[1] / "benchmarks" / "results.md").read_text(encoding="utf-8")
    assert [text for language, text in BLOCKS if language == "text"] == re.findall(
        r"```text\n(.*?)```", saved, flags=re.DOTALL
    )


def test_every_target_that_readme_names_exists() -> None:
    makefile = (Path(__file__).parents[1] / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"make ([a-z-]+)", README)) - {"are"}:
        assert re.search(rf"^{target}:", makefile, flags=re.MULTILINE), target
