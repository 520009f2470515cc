"""Which backend runs, how it is chosen, and how many threads it uses."""

from __future__ import annotations

import json
import multiprocessing
import os
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import kleinform
from kleinform_kernels import _apply, _backend, _threads, uncoupled
from tests.support import batch, random_cases

COMPILED = kleinform.backend().name == "compiled"
needs_compiled = pytest.mark.skipif(not COMPILED, reason="there are no compiled kernels here")


def fresh(script: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """A script in a fresh interpreter with some environment variables."""
    environment = {**os.environ, **variables}
    command = [sys.executable, "-c", script]
    return subprocess.run(command, env=environment, text=True, capture_output=True, check=False)


def test_the_variable_chooses_numpy() -> None:
    script = "import kleinform, json; print(json.dumps(kleinform.backend()))"
    result = fresh(script, KLEINFORM_BACKEND="numpy")
    assert json.loads(result.stdout) == ["numpy", "", "KLEINFORM_BACKEND=numpy"]


@needs_compiled
def test_the_variable_chooses_what_is_compiled() -> None:
    script = "import kleinform, json; print(json.dumps(kleinform.backend()))"
    name, instructions, reason = json.loads(fresh(script, KLEINFORM_BACKEND="compiled").stdout)
    assert (name, reason) == ("compiled", "")
    assert instructions in ("baseline", "avx2", "avx512")


def test_another_wish_is_refused() -> None:
    result = fresh("import kleinform", KLEINFORM_BACKEND="fortran")
    assert result.returncode == 1
    assert "BackendError" in result.stderr
    assert "'fortran' arrived" in result.stderr


@needs_compiled
def test_older_compiled_kernels_are_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a warning, or an error where they were asked for."""
    monkeypatch.setattr(_backend, "COMPILED", -1)
    monkeypatch.delenv("KLEINFORM_BACKEND", raising=False)
    with pytest.warns(RuntimeWarning, match="of other sources: reinstall"):
        name, _, reason = _backend._chosen()
    assert name == "numpy"
    assert "other sources" in reason
    monkeypatch.setenv("KLEINFORM_BACKEND", "compiled")
    with pytest.raises(ImportError, match="of other sources"):
        _backend._chosen()


def test_no_compiled_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    """NumPy, and the reason; an error where they were asked for."""
    monkeypatch.setitem(sys.modules, "kleinform_kernels.uncoupled._compiled", None)
    monkeypatch.delattr(uncoupled, "_compiled", raising=False)
    monkeypatch.delenv("KLEINFORM_BACKEND", raising=False)
    name, _, reason = _backend._chosen()
    assert name == "numpy"
    assert reason.startswith("there are no compiled kernels: ")
    monkeypatch.setenv("KLEINFORM_BACKEND", "compiled")
    with pytest.raises(ImportError, match="no compiled kernels"):
        _backend._chosen()


# Threads --------------------------------------------------------------------------------


@pytest.fixture
def default_threads(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv("KLEINFORM_THREADS", raising=False)
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    kleinform.set_threads(None)
    yield monkeypatch
    kleinform.set_threads(None)


def test_the_number_of_threads(default_threads: pytest.MonkeyPatch) -> None:
    if hasattr(os, "sched_getaffinity"):
        assert kleinform.threads() == len(os.sched_getaffinity(0))
    default_threads.setenv("OMP_NUM_THREADS", "3")
    assert kleinform.threads() == 3
    default_threads.setenv("KLEINFORM_THREADS", "5")
    assert kleinform.threads() == 5
    kleinform.set_threads(7)
    assert kleinform.threads() == 7
    kleinform.set_threads(None)
    assert kleinform.threads() == 5


@pytest.mark.parametrize("count", [0, -1, 2.0, "2", True])
def test_other_numbers_are_refused(default_threads: pytest.MonkeyPatch, count: object) -> None:
    with pytest.raises(kleinform.InputError, match="a positive integer is needed"):
        kleinform.set_threads(count)


def test_a_wrong_variable_is_refused(default_threads: pytest.MonkeyPatch) -> None:
    default_threads.setenv("KLEINFORM_THREADS", "many")
    with pytest.raises(kleinform.InputError, match=r"KLEINFORM_THREADS: .* 'many' arrived"):
        kleinform.threads()


def test_parallel_callers_get_one_thread(default_threads: pytest.MonkeyPatch) -> None:
    kleinform.set_threads(4)
    with ThreadPoolExecutor(1) as pool:
        assert pool.submit(kleinform.threads).result() == 1
    with multiprocessing.get_context("spawn").Pool(1) as processes:
        assert processes.apply(kleinform.threads) == 1


@needs_compiled
def test_results_do_not_depend_on_threads(
    default_threads: pytest.MonkeyPatch,
) -> None:
    """Whatever axis is long, and where inputs broadcast."""
    case = batch(random_cases(np.random.default_rng(3), 240))
    default_threads.setattr(_apply, "PART", 16)
    shapes = ((240,), (240, 1), (1, 240), (3, 80), (80, 3), (2, 1, 120))
    for lead in shapes:
        place = case.position.reshape(*lead, 3)
        for turn in (case.rotation.reshape(*lead, 3, 3), case.rotation[0]):
            results = []
            for count in (1, 2, 5):
                kleinform.set_threads(count)
                results.append(uncoupled.survey(1.0, place, turn))
            for other in results[1:]:
                assert all(map(np.array_equal, results[0], other))


@needs_compiled
def test_several_threads_do_run(default_threads: pytest.MonkeyPatch) -> None:
    seen = set()

    def task(start: int, stop: int) -> None:
        seen.add(threading.current_thread().name)
        barrier.wait(timeout=30.0)

    barrier = threading.Barrier(2)
    kleinform.set_threads(2)
    _threads.in_parts(task, 4, 2)
    assert len(seen) == 2


def test_an_error_in_a_thread_is_raised(default_threads: pytest.MonkeyPatch) -> None:
    def task(start: int, stop: int) -> None:
        raise RuntimeError(f"part {start}")

    kleinform.set_threads(2)
    with pytest.raises(RuntimeError, match="part 0"):
        _threads.in_parts(task, 4, 2)


@needs_compiled
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork on this system")
def test_a_forked_child_has_its_own_threads(default_threads: pytest.MonkeyPatch) -> None:
    """Threads do not survive a fork; waiting for those of the parent would hang."""
    script = """
import os, numpy as np, kleinform
from kleinform_kernels import uncoupled
kleinform.set_threads(2)
place = np.random.default_rng(1).normal(size=(100_000, 3))
before = uncoupled.survey(1.0, place, np.eye(3))
child = os.fork()
if child == 0:
    after = uncoupled.survey(1.0, place, np.eye(3))
    os._exit(0 if all(map(np.array_equal, before, after)) else 3)
print(os.waitpid(child, 0)[1])
"""
    result = fresh(script)
    assert result.stdout.strip() == "0", result.stderr
