"""The command line: ``kleinform latex``."""

from __future__ import annotations

import subprocess
import sys

import pytest

pytest.importorskip("typer", reason="the extra kleinform[cli] is not installed")

from kleinform import cli
from kleinform.formulas import Formulas, UnknownFormulaError


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "kleinform.cli", *arguments],
        capture_output=True,
        check=False,
        encoding="utf-8",
    )


def test_one_formula() -> None:
    result = run("latex", "h_i")
    assert result.returncode == 0
    assert result.stdout == "h_{i} = a - \\mathbf{c} \\cdot \\mathbf{u}_{i}\n"
    assert result.stderr == ""


def test_components() -> None:
    vectors, entries = run("latex", "b_i"), run("latex", "b_i", "--components")
    assert vectors.stdout == "\\mathbf{b}_{i} = \\mathbf{c} + e_{i} \\mathbf{n}_{i}\n"
    assert "b_{ix} &= c_{x} + e_{i} n_{ix}" in entries.stdout
    assert entries.returncode == 0


def test_without_a_name_the_names_are_listed() -> None:
    result = run("latex")
    assert result.returncode == 0
    names = [line.split()[0] for line in result.stdout.splitlines()]
    assert names == sorted(names) == Formulas().names
    assert "inverse Jacobian matrix" in result.stdout
    assert "\x1b" not in result.stdout


def test_an_unknown_name_is_an_error_that_names_close_ones() -> None:
    result = run("latex", "j_Q")
    assert result.returncode == 2
    assert result.stdout == ""
    *listing, _, error = result.stderr.splitlines()
    assert error.startswith("no formula is called 'j_Q'; close: J_q")
    assert len(listing) == len(Formulas().names)


def test_a_name_close_to_none() -> None:
    with pytest.raises(UnknownFormulaError, match=r"^no formula is called 'zzzzzzzz'$"):
        Formulas().latex("zzzzzzzz")


def test_a_name_is_no_path() -> None:
    with pytest.raises(UnknownFormulaError):
        Formulas().latex("components/e_i")


def test_every_listed_formula_can_be_read() -> None:
    formulas = Formulas()
    for name in formulas.names:
        for components in (False, True):
            text = formulas.latex(name, components=components)
            assert text
            assert "%" not in text


def test_without_the_extra_one_line_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delitem(sys.modules, "kleinform.commands", raising=False)
    monkeypatch.setitem(sys.modules, "typer", None)
    with pytest.raises(SystemExit) as stopped:
        cli.main()
    assert stopped.value.code == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert "kleinform[cli]" in error


def test_importing_kleinform_imports_no_typer() -> None:
    code = "import sys, kleinform; sys.exit('typer' in sys.modules or 'rich' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
