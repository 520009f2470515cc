"""The examples run, and print what they say."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

import kleinform

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def run(name: str, *arguments: object) -> str:
    command = [sys.executable, str(EXAMPLES / name), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.skipif(
    kleinform.backend().name != "compiled", reason="examples/sweep.py needs the compiled kernels"
)
def test_a_sweep_needs_no_more_memory_than_its_chunks() -> None:
    """Five times the poses, whose results would be 1.3 GB, in the memory of the fewer."""
    few, many = (run("sweep.py", poses) for poses in (800_000, 4_000_000))
    counts = [int(re.search(r"(\d+) within", text)[1]) for text in (few, many)]
    memory = [int(re.search(r"(\d+) MB", text)[1]) for text in (few, many)]
    assert counts[1] / counts[0] == pytest.approx(5.0, rel=0.01)
    assert memory[1] < memory[0] + 100


@pytest.mark.skipif(
    importlib.util.find_spec("pinocchio") is None, reason="examples/tutorial.py needs Pinocchio"
)
def test_the_tutorial_prints_what_the_page_on_motion_shows() -> None:
    assert len((EXAMPLES / "tutorial.py").read_text(encoding="utf-8").splitlines()) <= 30
    page = (EXAMPLES.parent / "docs" / "motion.md").read_text(encoding="utf-8")
    shown = re.search(r"python examples/tutorial\.py\n(.*?)```", page, flags=re.DOTALL)[1]
    assert run("tutorial.py") == shown
