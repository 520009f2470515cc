"""The paper's printed numbers: what is confirmed, what is not, and that a wrong one is seen."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kleinform.paper import printed, report
from kleinform.paper.audit import audit, equation_verdicts, proofs

PAGE = Path(__file__).parents[2] / "docs" / "audit.md"


@pytest.fixture(scope="module")
def parts() -> dict[str, list[report.Row]]:
    return report.report()


def test_every_number_of_the_inverse_displacement_but_q4_is_confirmed(parts) -> None:
    rows = parts["Inverse displacement and e_i (Section VI)"]
    assert [row.item for row in rows if not row.confirmed] == ["q4 [deg]"]


def test_all_four_rows_of_table_1_are_solutions_within_a_truncated_digit(parts) -> None:
    rows = parts["Table 1, coordinates of B_i"]
    assert len(rows) == 1 + 4 * (1 + 9) + 3
    assert [row.item for row in rows if not row.confirmed] == []
    assert all(abs(row.difference) < 1e-6 for row in rows if "X of" in row.item)
    counts = {row.item: row.computed for row in rows if "real" in row.item}
    assert float(counts["real solutions, one of each pair"]) == 4.0
    assert float(counts["homotopy: real ends, in pairs ±n"]) == 8.0


@pytest.mark.parametrize(("row", "point", "axis"), [(0, 1, 2), (1, 0, 1), (2, 2, 0), (3, 1, 1)])
def test_a_wrong_digit_in_table_1_is_refuted(monkeypatch, row: int, point: int, axis: int) -> None:
    table = [[list(numbers) for numbers in points] for points in printed.TABLE_1]
    digits = table[row][point][axis]
    table[row][point][axis] = re.sub(r"\.(\d\d)\d", r".\g<1>", digits) + "9"
    monkeypatch.setattr(printed, "TABLE_1", table)
    assert not all(line.confirmed for line in report.closure_rows())


def test_rounded_truncated_and_wrong_numbers_are_told_apart() -> None:
    assert report.compare("x", "1.313", 1.31349).verdict == "confirmed"
    assert report.compare("x", "1.313", 1.31384).verdict == "confirmed (truncated)"
    assert report.compare("x", "-1.313", -1.31384).verdict == "confirmed (truncated)"
    assert report.compare("x", "1.313", 1.31184).verdict == "corrected: 1.312"


def test_both_motions_are_tracked_to_rounding(parts) -> None:
    rows = [row for row in parts["Worked motions"] if "tracked" in row.item]
    assert len(rows) == 2
    assert all(row.confirmed and row.difference < 1e-13 for row in rows)


def test_every_numbered_equation_has_a_verdict() -> None:
    verdicts = equation_verdicts(proofs())
    assert sorted(verdicts) == list(range(1, 28))
    assert "unproven" not in verdicts.values()
    assert verdicts[19] == "reconstructed"
    assert verdicts[26] == "corrected"
    assert verdicts[17] == "confirmed"


def test_the_audit_in_docs_is_what_make_paper_writes(parts) -> None:
    assert PAGE.read_text(encoding="utf-8") == audit(parts), "run make paper"
