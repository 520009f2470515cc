"""Who imports whom, and what a fresh interpreter loads."""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import kleinform
import kleinform_kernels

ROOT = Path(__file__).resolve().parents[2]
KERNELS = Path(kleinform_kernels.__file__).parent
RUNTIME = Path(kleinform.__file__).parent
HEAVY = {
    *("sympy", "mpmath", "scipy", "typer", "rich", "latex2mathml", "derivations", "hypothesis"),
    *("flint", "matplotlib"),
}


def run(script: str, path: list[Path], cwd: Path) -> subprocess.CompletedProcess[str]:
    """A script in a fresh interpreter that finds packages at ``path`` first.

    Without site, as an editable installation would be found before ``path``.
    """
    places = [*path, Path(np.__file__).resolve().parents[1]]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, places))}
    command = [sys.executable, "-S", "-c", script]
    return subprocess.run(
        command, env=environment, cwd=cwd, text=True, capture_output=True, check=False
    )


@pytest.mark.parametrize(
    "statement",
    [
        "import kleinform",
        "from kleinform_kernels import uncoupled",
        "import kleinform; kleinform.UncoupledManipulator().survey([0.3, 0.2, 1.0], "
        "[[1, 0, 0], [0, 1, 0], [0, 0, 1]])",
        "import kleinform; kleinform.UncoupledManipulator().forward_displacement("
        "[1.0, 1.2, 0.9, 0.7, 1.26, 1.05])",
    ],
)
def test_numpy_is_all_that_is_loaded(statement: str, tmp_path: Path) -> None:
    script = f"{statement}\nimport json, sys\nprint(json.dumps(sorted(sys.modules)))"
    result = run(script, [RUNTIME.parent, KERNELS.parent], tmp_path)
    assert result.returncode == 0, result.stderr
    assert result.stderr == ""
    loaded = {name.split(".")[0] for name in json.loads(result.stdout)}
    assert "numpy" in loaded
    assert not loaded & HEAVY


def imported(path: Path) -> Iterator[str]:
    """The top-level packages that a file imports, wherever in it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield str(node.module).split(".")[0]


def files_of(root: Path) -> list[Path]:
    found = sorted(root.rglob("*.py"))
    assert len(found) >= 4, f"no Python files under {root}"
    return found


@pytest.mark.parametrize(
    ("root", "forbidden"),
    [
        (ROOT / "derivations", {"kleinform", "kleinform_kernels", "numpy", "scipy"}),
        (ROOT / "generated", {"kleinform", "derivations", "sympy", "scipy"}),
        (ROOT / "src", {"derivations", "sympy"}),
    ],
    ids=["derivations", "generated", "src"],
)
def test_one_way(root: Path, forbidden: set[str]) -> None:
    """derivations → generated → src, and no way back."""
    for path in files_of(root):
        # What is copied into the kernels is not run by the derivations.
        if "support" not in path.relative_to(root).parts:
            assert not forbidden & set(imported(path)), path


def test_optional_packages_are_imported_late() -> None:
    """Outside functions the runtime's modules that `import kleinform` loads need NumPy alone."""
    allowed = sys.stdlib_module_names | {"numpy", "kleinform", "kleinform_kernels"}
    script = (
        "import kleinform, sys\n"
        "for name, module in sys.modules.items():\n"
        "    if name.split('.')[0] == 'kleinform':\n"
        "        print(module.__file__)"
    )
    result = run(script, [RUNTIME.parent, KERNELS.parent], ROOT)
    loaded = [Path(line) for line in result.stdout.split()]
    assert RUNTIME / "manipulator.py" in loaded
    for path in loaded:
        assert set(imported(path)) <= allowed, path


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """A copy of the kernels, found before the installed ones."""
    shutil.copytree(KERNELS, tmp_path / "kleinform_kernels", ignore=shutil.ignore_patterns("__py*"))
    return tmp_path / "kleinform_kernels"


def import_with(kernels: Path) -> subprocess.CompletedProcess[str]:
    script = (
        "try:\n    import kleinform\n"
        "except Exception as error:\n    print(type(error).__name__, '|', error)\n"
        "else:\n    print('imported', kleinform.generated.kernels.__file__)"
    )
    return run(script, [kernels.parent, RUNTIME.parent], kernels.parent)


def test_the_copied_kernels_are_those_used(copied: Path) -> None:
    assert import_with(copied).stdout.split() == ["imported", str(copied / "uncoupled/__init__.py")]


def append(path: Path, text: str) -> None:
    path.write_text(path.read_text(encoding="utf-8") + text, encoding="utf-8")


def change(path: Path, before: str, after: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert before in text
    path.write_text(text.replace(before, after), encoding="utf-8")


SPOILED = {
    "kernels": lambda root: append(root / "uncoupled/numpy_kernels.py", "# edited\n"),
    "a constant": lambda root: change(
        root / "uncoupled/numpy_kernels.py", "0.8660254037844386", "0.8660254037844387"
    ),
    "array loops": lambda root: append(root / "_apply.py", "BLOCK = 1\n"),
    "list of kernels": lambda root: append(root / "uncoupled/__init__.py", "x = 1\n"),
    "earlier schema": lambda root: change(root / "__init__.py", "SCHEMA = 1", "SCHEMA = 0"),
    "later schema": lambda root: change(root / "__init__.py", "SCHEMA = 1", "SCHEMA = 99"),
    "no schema": lambda root: change(root / "__init__.py", "SCHEMA = 1", ""),
    "no checksums": lambda root: change(root / "__init__.py", "CHECKSUMS", "OTHERS"),
    "no kernels": lambda root: (root / "uncoupled/numpy_kernels.py").unlink(),
    "no mpmath kernels": lambda root: (root / "uncoupled/mpmath_kernels.py").unlink(),
    "what fails when run": lambda root: append(root / "uncoupled/numpy_kernels.py", "1 / 0\n"),
    "no array loops": lambda root: (root / "_apply.py").unlink(),
    "no syntax": lambda root: append(root / "uncoupled/numpy_kernels.py", "def\n"),
    "no package": shutil.rmtree,
}


@pytest.mark.parametrize("spoil", SPOILED)
def test_spoiled_kernels_are_refused(copied: Path, spoil: str, tmp_path: Path) -> None:
    """With a typed error that names the command to run."""
    SPOILED[spoil](copied)
    if spoil == "no package":
        # Nothing at all may be found, wherever the tests themselves have the kernels from.
        (tmp_path / "kleinform_kernels.py").write_text("raise ImportError('gone')\n")
    result = import_with(copied)
    assert result.stdout.startswith("GeneratedCodeError | "), result.stdout + result.stderr
    assert "make derive" in result.stdout
