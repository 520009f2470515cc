"""The benchmarks run, and peers compute the same as the kernels they are measured against."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from benchmarks import census, classification, kernels, modes, motion
from benchmarks.peers import PACKAGES, check, lambdified
from benchmarks.report import machine, saved
from kleinform.paper.examples import example_1
from kleinform.verification.report import ours
from kleinform_kernels import uncoupled

ROOT = Path(__file__).parents[1]
#: A small run of all tables.
RUN = """
from benchmarks import kernels
kernels.POSES, kernels.CALLS, kernels.MANY, kernels.MEMORY, kernels.ROUNDS = 20, 3, 40, 0, 1
kernels.table()
"""


@pytest.fixture(scope="module")
def tables() -> list[str]:
    """What it prints, in a process of its own: after JAX has started, a fork is a warning."""
    command = [sys.executable, "-c", RUN]
    printed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert printed.returncode == 0, printed.stderr
    return printed.stdout.splitlines()


@pytest.mark.parametrize("kernel", ["survey", "joints_and_jacobians", "inverse_displacement"])
def test_lambdify_returns_what_the_kernel_returns(kernel) -> None:
    c, rotation = kernels.poses(50)
    heading = (c[:, :2],) if kernel == "joints_and_jacobians" else ()
    expected = getattr(uncoupled, kernel)(1.0, c, rotation, *heading)
    check("lambdify", lambdified(kernel)(1.0, c, rotation), expected)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [([1.0, 2.0 + 1e-9], "differ by 5e-10"), ([1.0, np.nan], "nan"), ([[1.0, 2.0]], "shape")],
)
def test_a_peer_that_differs_is_found(wrong, message) -> None:
    with pytest.raises(ArithmeticError, match=message):
        check("peer", [np.array(wrong)], [np.array([1.0, 2.0])])


@pytest.mark.parametrize("peer", PACKAGES)
def test_an_installed_peer_agrees_and_is_timed(tables, peer) -> None:
    rows = [line for line in tables if line.startswith(peer)]
    assert rows
    if "not installed" in rows[0]:
        pytest.skip(f"{peer} is not installed: kleinform[bench]")
    assert len(rows) == (2 if peer == "JAX" else 4)


def test_the_tables_have_a_row_for_each_who(tables) -> None:
    for who, times in (("lambdify", 3), ("kernel (NumPy)", 3), ("validated call", 3)):
        assert sum(line.startswith(who) for line in tables) == times
    assert sum(line.startswith("numpy.copyto") for line in tables) == 2
    assert "on one thread and on two" in tables[-1]


def test_what_is_printed_is_saved_whole_or_not_at_all(tmp_path, capsys) -> None:
    path = tmp_path / "results.md"
    with saved(path):
        print(machine())
    printed = capsys.readouterr().out
    assert "Python" in printed
    assert f"```text\n{printed}```" in path.read_text(encoding="utf-8")
    with pytest.raises(KeyError), saved(path):
        raise KeyError
    assert printed in path.read_text(encoding="utf-8")
    assert list(tmp_path.iterdir()) == [path]


def test_every_method_finds_every_mode(monkeypatch, capsys) -> None:
    for name, value in (("ROWS", 4), ("MANY", 20), ("FEW", 1)):
        monkeypatch.setattr(modes, name, value)
    modes.table()
    lines = capsys.readouterr().out.splitlines()
    rows = [line for line in lines if "%" in line]
    assert len(rows) >= 5
    assert all(row.split("%")[0].endswith("100.0") for row in rows)
    assert lines[-1].endswith("solves a second")


def test_the_census_counts_all_joint_values(capsys) -> None:
    found = census.table(200)
    for shares in found.values():
        np.testing.assert_allclose([share.sum() for share in shares], 1.0)
        # Complex solutions come in pairs.
        assert not shares[0][1::2].any()
    census.most()
    assert "most modes found: 24" in capsys.readouterr().out


def test_the_motion_is_timed_and_its_residual_shown(monkeypatch, capsys) -> None:
    monkeypatch.setattr(motion, "SAMPLES", 300)
    monkeypatch.setattr(motion, "ROUNDS", 1)
    motion.table()
    printed = capsys.readouterr().out
    assert float(re.search(r"equations (\S+)", printed)[1]) <= 1e-12
    rows = [line.split("  ")[0] for line in printed.splitlines()]
    assert {"kleinform", "kleinform (NumPy)"} <= set(rows)
    assert "Pinocchio, Newton" in rows or "not installed" in printed


def test_classes_are_timed_beside_the_survey(monkeypatch, capsys) -> None:
    monkeypatch.setattr(classification, "POSES", 100)
    monkeypatch.setattr(classification, "ROUNDS", 1)
    classification.table()
    rows = [line.split("  ")[0] for line in capsys.readouterr().out.splitlines()]
    assert rows[-4:] == ["survey kernel", "robot.survey", "robot.classify", "all singular"]


def test_a_wrong_pose_has_a_residual() -> None:
    states = example_1().sampled(20)
    platform = ours(states)
    assert motion.closure(states, platform) <= 1e-14
    moved = platform._replace(positions=platform.positions + 1e-6)
    assert motion.closure(states, moved) >= 1e-7
