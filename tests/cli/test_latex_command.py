"""``kleinform latex``."""

from __future__ import annotations

import pytest

from kleinform.formulas import Formulas, UnknownFormulaError


def test_one_formula(run) -> None:
    ran = run("latex", "h_i")
    assert ran == (0, "h_{i} = a - \\mathbf{c} \\cdot \\mathbf{u}_{i}\n", "")


def test_components(run) -> None:
    vectors, entries = run("latex", "b_i"), run("latex", "b_i", "--components")
    assert vectors.out == "\\mathbf{b}_{i} = \\mathbf{c} + e_{i} \\mathbf{n}_{i}\n"
    assert "b_{ix} &= c_{x} + e_{i} n_{ix}" in entries.out
    assert entries.code == 0


def test_without_a_name_the_names_are_listed(run) -> None:
    ran = run("latex")
    assert ran.code == 0
    names = [line.split()[0] for line in ran.out.splitlines()]
    assert names == sorted(names) == Formulas().names
    assert "inverse Jacobian matrix" in ran.out
    assert "\x1b" not in ran.out


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
