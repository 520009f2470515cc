"""The benchmark runs, and its peer computes the same as the kernels it is measured against."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks import __main__ as bench
from benchmarks import census, modes
from benchmarks.peers import lambdified
from kleinform_kernels import uncoupled


@pytest.mark.parametrize("wanted", [bench.SURVEY, bench.VELOCITY], ids=["survey", "velocity"])
def test_the_peer_returns_what_the_kernels_return(wanted) -> None:
    c, rotation = bench.poses(50)
    peer = iter(lambdified(wanted)(1.0, c, rotation))
    for kernel, outputs in wanted.items():
        heading = (c[:, :2],) if kernel == "jacobians" else ()
        result = getattr(uncoupled, kernel)(1.0, c, rotation, *heading)
        for name in outputs:
            np.testing.assert_allclose(next(peer), getattr(result, name), rtol=1e-9, atol=1e-12)
    assert next(peer, None) is None


def test_the_table_has_a_row_for_each_who(monkeypatch, capsys) -> None:
    monkeypatch.setattr(bench, "POSES", 20)
    bench.throughput()
    rows = capsys.readouterr().out.splitlines()[2:]
    assert [row[14:32].strip() for row in rows] == ["lambdify", "kernel", "validated call"] * 2


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
