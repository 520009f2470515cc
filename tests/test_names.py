"""Every dotted name that README and the pages write is there after the import that they name."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import kleinform

ROOT = Path(__file__).parents[1]
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").glob("*.md")])
#: Where a name begins, and the import that the pages name for it.
IMPORTS = {
    "kleinform": "import kleinform",
    "kleinform_kernels": "import kleinform_kernels",
    "uncoupled": "from kleinform_kernels import uncoupled",
    "gufuncs": "from kleinform_kernels.uncoupled import gufuncs",
}
NAME = re.compile(rf"(?<![\w./-])({'|'.join(IMPORTS)})((?:\.[A-Za-z_]\w*)+)")
COMPILED_ONLY = re.compile(r"\bgufuncs\b|\bcompiled_kernels\b")


def names_in(page: Path) -> set[str]:
    """The dotted names, but for those of files."""
    found = {match[0] for match in NAME.finditer(page.read_text(encoding="utf-8"))}
    return {name for name in found if name.rpartition(".")[2] not in ("c", "h", "md", "so")}


NAMES = sorted(set().union(*map(names_in, PAGES)))


def test_the_search_finds_names() -> None:
    assert {"kleinform.maps.joining.join_modes", "uncoupled.gufuncs"} <= set(NAMES)
    assert len(NAMES) > 25


@pytest.mark.parametrize("name", NAMES)
def test_the_name_is_there(name: str) -> None:
    """In a fresh interpreter: an import elsewhere would hide what is missing."""
    if COMPILED_ONLY.search(name) and kleinform.backend().name != "compiled":
        pytest.skip("needs the compiled kernels")
    statement = IMPORTS[name.partition(".")[0]]
    script = f"{statement}\n{name}"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_dir_shows_the_public_names_alone() -> None:
    script = "import kleinform; print(*dir(kleinform))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stdout.split() == sorted(kleinform.__all__)
    for name in kleinform.__all__:
        assert not name.startswith("_")
        assert getattr(kleinform, name) is not None


def test_names_that_are_not_there() -> None:
    for module in (kleinform, kleinform.maps, kleinform.plots, kleinform.paper):
        with pytest.raises(AttributeError, match=f"module '{module.__name__}' has no attribute"):
            _ = module.nothing
    from kleinform_kernels import uncoupled

    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = uncoupled.nothing
