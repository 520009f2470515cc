"""Ctrl-C while the command loads: exit code 130, and not a word."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.support import many

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")

#: Sends the signal at the import of a module, counted from the first after `starting`.
SITE = """
import os, signal, sys

class Finder:
    left = None

    def find_spec(self, name, path=None, target=None):
        if self.left is None and "kleinform.starting" in sys.modules:
            self.left = int(os.environ["INTERRUPTED_AT"])
        if self.left is not None:
            self.left -= 1
            if self.left == 0:
                os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Finder())
"""
SCRIPT = Path(sys.executable).with_name("kleinform")
WAYS = {"module": [sys.executable, "-m", "kleinform"], "script": [str(SCRIPT)]}
POSE = ("inverse", "--position", "0.25", "0.2", "1.0", "--rpy", "0.1", "0.2", "0.3")


def heed_interrupts() -> None:
    """Tests that run in the background of a shell ignore them, and so would what they start."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def interrupted(way: str, at: int, folder: Path) -> subprocess.CompletedProcess[str]:
    (folder / "sitecustomize.py").write_text(SITE)
    environment = {**os.environ, "PYTHONPATH": str(folder), "INTERRUPTED_AT": str(at)}
    command = [*WAYS[way], *POSE]
    return subprocess.run(
        command,
        capture_output=True,
        check=False,
        text=True,
        env=environment,
        preexec_fn=heed_interrupts,
    )


@pytest.mark.long
@pytest.mark.parametrize("way", WAYS)
def test_an_interrupt_at_any_import(tmp_path: Path, way: str) -> None:
    """Of about 450 modules, in whichever order they come."""
    if way == "script" and not SCRIPT.exists():
        pytest.skip("the script is not installed")
    rng = np.random.default_rng(10)
    wrong = {}
    for at in [1, *rng.integers(2, 430, many(5, 150)).tolist()]:
        ran = interrupted(way, at, tmp_path)
        if (ran.returncode, ran.stdout, ran.stderr) != (130, "", ""):
            wrong[at] = ran
    assert wrong == {}


def test_an_ignored_interrupt_stays_ignored(tmp_path: Path) -> None:
    """As in the background of a shell."""
    (tmp_path / "sitecustomize.py").write_text(SITE)
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "INTERRUPTED_AT": "50"}
    ran = subprocess.run(
        [*WAYS["module"], *POSE],
        capture_output=True,
        check=False,
        env=environment,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN),
    )
    assert (ran.returncode, ran.stderr) == (0, b"")


def test_a_program_that_imports_kleinform_keeps_its_handler() -> None:
    code = "import signal, kleinform, kleinform.cli; print(signal.getsignal(signal.SIGINT))"
    command = [sys.executable, "-c", code]
    ran = subprocess.run(
        command, capture_output=True, check=True, text=True, preexec_fn=heed_interrupts
    )
    assert ran.stdout == f"{signal.default_int_handler}\n"
