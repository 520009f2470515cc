"""Which backend runs, how it is chosen, and how many threads it uses."""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
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
    return subprocess.run(
        command, env=environment, text=True, capture_output=True, check=False, timeout=120
    )


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
    monkeypatch.delenv("KLEINFORM_BACKEND", raising=False)
    name, _, reason = _backend._chosen()
    assert name == "numpy"
    assert reason.startswith("there are no compiled kernels (")
    monkeypatch.setenv("KLEINFORM_BACKEND", "compiled")
    with pytest.raises(ImportError, match="no compiled kernels"):
        _backend._chosen()


# Threads --------------------------------------------------------------------------------


@pytest.fixture
def default_threads(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(_threads, "_GIVEN", None)
    kleinform.set_threads(None)
    yield monkeypatch
    kleinform.set_threads(None)


def test_the_number_of_threads(default_threads: pytest.MonkeyPatch) -> None:
    if hasattr(os, "sched_getaffinity"):
        assert kleinform.threads() == len(os.sched_getaffinity(0))
    default_threads.setattr(_threads, "_GIVEN", 5)
    assert kleinform.threads() == 5
    kleinform.set_threads(7)
    assert kleinform.threads() == 7
    kleinform.set_threads(np.int64(3))
    assert kleinform.threads() == 3
    kleinform.set_threads(None)
    assert kleinform.threads() == 5


@pytest.mark.parametrize(
    ("own", "others", "number"),
    [("5", "3", "5"), ("", "3", "3"), ("", "3,2", "3"), ("2", "", "2")],
)
def test_the_variables(own: str, others: str, number: str) -> None:
    script = "import kleinform; print(kleinform.threads())"
    assert fresh(script, KLEINFORM_THREADS=own, OMP_NUM_THREADS=others).stdout.strip() == number


@pytest.mark.parametrize("count", [0, -1, 2.0, "2", True])
def test_other_numbers_are_refused(default_threads: pytest.MonkeyPatch, count: object) -> None:
    with pytest.raises(kleinform.InputError, match="a positive integer is needed"):
        kleinform.set_threads(count)


@pytest.mark.parametrize("given", ["many", "0", "-1", "1.5"])
def test_a_wrong_variable_is_refused(given: str) -> None:
    result = fresh("import kleinform", KLEINFORM_THREADS=given)
    assert "BackendError: KLEINFORM_THREADS: a positive integer is needed" in result.stderr


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


def test_several_threads_do_run(default_threads: pytest.MonkeyPatch) -> None:
    barrier, seen = threading.Barrier(2), set()

    def task(start: int, stop: int) -> None:
        seen.add(threading.current_thread().name)
        barrier.wait(timeout=30.0)

    kleinform.set_threads(2)
    _threads.in_parts(task, 4, 2)
    assert len(seen) == 2


@pytest.mark.parametrize("count", [1, 2, 4])
def test_every_part_is_done_once(default_threads: pytest.MonkeyPatch, count: int) -> None:
    kleinform.set_threads(count)
    for total in (0, 1, 7, 8, 9, 100):
        done = np.zeros(total, dtype=int)

        def task(start: int, stop: int, done: np.ndarray = done) -> None:
            done[start:stop] += 1

        _threads.in_parts(task, total, 8)
        assert np.all(done == 1)


@pytest.mark.parametrize("count", [1, 2])
def test_an_error_ends_the_call(default_threads: pytest.MonkeyPatch, count: int) -> None:
    """It is raised, and what was not begun is not begun any more."""
    begun = []

    def task(start: int, stop: int) -> None:
        begun.append(start)
        time.sleep(0.01)
        raise KeyboardInterrupt

    kleinform.set_threads(count)
    with pytest.raises(KeyboardInterrupt):
        _threads.in_parts(task, 100, 1)
    assert len(begun) <= count
    assert not any(thread.name == "kleinform" for thread in threading.enumerate())


def test_where_no_thread_can_be_started(default_threads: pytest.MonkeyPatch) -> None:
    """The caller does it all: as when the interpreter shuts down."""

    def refuse(self: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    default_threads.setattr(threading.Thread, "start", refuse)
    kleinform.set_threads(4)
    done = []
    _threads.in_parts(lambda start, stop: done.append(start), 10, 2)
    assert done == [0, 2, 4, 6, 8]


LARGE = """
import atexit, os, signal, numpy as np, kleinform
from kleinform_kernels import uncoupled
kleinform.set_threads(2)
place = np.random.default_rng(1).normal(size=(100_000, 3))
before = uncoupled.survey(1.0, place, np.eye(3))

def same():
    return all(map(np.array_equal, before, uncoupled.survey(1.0, place, np.eye(3))))
"""


@needs_compiled
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork on this system")
def test_in_a_forked_child() -> None:
    script = """
child = os.fork()
if child == 0:
    os._exit(0 if same() else 3)
print(os.waitpid(child, 0)[1])
"""
    result = fresh(LARGE + script)
    assert result.stdout.strip() == "0", result.stderr


@needs_compiled
def test_when_the_interpreter_ends() -> None:
    result = fresh(LARGE + "atexit.register(lambda: print(same()))")
    assert result.stdout.strip() == "True", result.stderr


@needs_compiled
@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there are no timers on this system")
def test_in_a_signal_handler() -> None:
    """The handler runs in the middle of a large call, and calls the same."""
    script = """
found = []
signal.signal(signal.SIGALRM, lambda *_: (kleinform.set_threads(2), found.append(same())))
for k in range(20):
    signal.setitimer(signal.ITIMER_REAL, 0.0005 + 0.0002 * k)
    uncoupled.rotation_defect(np.broadcast_to(np.eye(3), (2_000_000, 3, 3)))
print(len(found) > 0 and all(found))
"""
    result = fresh(LARGE + script)
    assert result.stdout.strip() == "True", result.stderr
