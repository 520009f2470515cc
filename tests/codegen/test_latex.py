"""The LaTeX side: what is shown, with which letters, and that it typesets."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from sympy import MatAdd, Symbol

from derivations.algebra.screws import Klein, Lie
from derivations.algebra.vectors import Cross, Dot, Norm, scalar, vector
from derivations.codegen.printers.breaking import lines
from derivations.codegen.printers.document import Entry, mathml
from derivations.codegen.printers.latex import VectorLatex, width
from derivations.codegen.printers.letters import UnknownLetterError
from derivations.uncoupled import (
    circles,
    closure,
    correction,
    displacement,
    eliminant,
    joint_rates,
    leg_step,
    loci,
    orientation,
    rates,
    statics,
)
from derivations.uncoupled.display import COLLECTIONS, displayed, family_name
from derivations.uncoupled.notation import NOTATION
from derivations.uncoupled.rendering import entries, latex_files
from derivations.uncoupled.velocity import screw

ROOT = Path(__file__).resolve().parents[2]
GRAPHS = (
    displacement.central_graph,
    displacement.pose_graph,
    closure.closure_graph,
    closure.cones_graph,
    eliminant.eliminant_graph,
    eliminant.turn_graph,
    circles.circles_graph,
    circles.arms_graph,
    correction.newton_graph,
    correction.fold_graph,
    leg_step.leg_graph,
    orientation.directions_graph,
    orientation.defect_graph,
    orientation.from_angles_graph,
    orientation.to_angles_graph,
    rates.inverse_velocity_graph,
    rates.forward_velocity_graph,
    joint_rates.joint_rates_graph,
    statics.platform_wrench_graph,
    statics.actuator_forces_graph,
    loci.direct_locus_graph,
    loci.orientation_locus_graph,
)
#: Words in formulas, marks below and above, and commands: what is left are letters alone.
NOT_LETTERS = (
    r"\\(?:text|mathrm|operatorname|begin|end)\{[^{}]*\}",
    r"[_^]\{[^{}]*\}",
    r"\\[A-Za-z]+",
)
LEAK = re.compile(r"[A-Za-z]{2}|[A-Za-z]\d|_")

HASH = """
from hashlib import sha256
from derivations.uncoupled.rendering import latex_files
print(sha256(repr(list(latex_files().items())).encode()).hexdigest())
"""


@pytest.fixture(scope="module")
def shown() -> list[Entry]:
    return entries()


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    return latex_files()


@pytest.fixture
def printer() -> VectorLatex:
    return VectorLatex(NOTATION)


def test_names_are_unique_even_where_case_does_not_count(shown: list[Entry]) -> None:
    names = [entry.name.casefold() for entry in shown]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("graph", GRAPHS, ids=lambda graph: graph.__name__)
def test_every_equation_is_shown(graph) -> None:
    symbols = {
        entry.equation.symbol.name for entry in displayed() if entry.equation.symbol.is_symbol
    }
    missing = [
        equation.name
        for equation in graph()
        if equation.name not in COLLECTIONS
        and not symbols & {equation.name, family_name(equation.name)}
    ]
    assert missing == []


@pytest.mark.parametrize("name", ["J_v", "J_q", "det_J_v", "det_J_q", "e_i", "S_i", "screw_41"])
def test_the_paper_s_main_formulas_have_these_names(shown: list[Entry], name: str) -> None:
    assert name in {entry.name for entry in shown}


def test_no_internal_name_leaks(shown: list[Entry]) -> None:
    for entry in shown:
        for latex in (entry.latex, entry.components):
            text = latex
            for pattern in NOT_LETTERS:
                text = re.sub(pattern, " ", text)
            assert not LEAK.search(text), (entry.name, latex)


def test_a_symbol_without_a_letter_is_refused(printer: VectorLatex) -> None:
    with pytest.raises(UnknownLetterError, match="unheard has no letter"):
        printer.doprint(Symbol("unheard"))


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (MatAdd(-vector("bi"), vector("di")), r"\mathbf{d}_{i} - \mathbf{b}_{i}"),
        (
            Dot(vector("lambda"), Cross(vector("k"), vector("c"))),
            r"\boldsymbol{\lambda} \cdot (\mathbf{k} \times \mathbf{c})",
        ),
        (Norm(vector("c") - vector("b1")), r"\left|\mathbf{c} - \mathbf{b}_{1}\right|"),
        (Klein(screw(4, 5), screw(4, 1)), r"\{{}^{4}\$_{4}^{5};\, {}^{0}\$_{4}^{1}\}"),
        (Lie(screw(1, 2), screw(1, 3)), r"[{}^{1}\$_{1}^{2} \; {}^{2}\$_{1}^{3}]"),
        (scalar("rate12"), r"{}_{1}\omega_{2}^{1}"),
        (scalar("gt1") ** 2, r"(g_{1}^{t})^{2}"),
        (-scalar("h1") / scalar("p1"), r"-\frac{h_{1}}{p_{1}}"),
        (scalar("n1_x") * scalar("e1") + scalar("c_x"), r"c_{x} + e_{1} n_{1x}"),
        (scalar("screw41_ox"), r"{}^{0}\$_{4,Ox}^{1}"),
        (scalar("dq_ox"), r"\dot{q}_{4}"),
    ],
)
def test_printing_as_the_paper_does(printer: VectorLatex, expression, expected: str) -> None:
    assert printer.doprint(expression) == expected


def test_long_sums_are_cut_between_terms_and_in_brackets() -> None:
    text = r"\frac{1}{2} [a + b - \left(c + d\right) e]"
    assert lines(text, 100) == [text]
    assert lines(text, 7) == [r"\frac{1}{2} \Bigl[a + b", r"- \left(c + d\right) e\Bigr]"]
    assert width(r"\frac{a b}{c} + \mathbf{d}_{i}") == 5


def test_every_formula_becomes_well_formed_mathml(shown: list[Entry]) -> None:
    for entry in shown:
        for latex in (entry.latex, entry.components):
            root = ElementTree.fromstring(mathml(latex))
            texts = [element.text for element in root.iter() if element.text]
            assert not any("\\" in text for text in texts), (entry.name, texts)


def test_bold_greek_letters_are_letters_of_their_own() -> None:
    assert "&#x1D740;" in mathml(r"\boldsymbol{\lambda}")
    assert "&#x1D74E;" in mathml(r"\boldsymbol{\omega}")


def test_files(files: dict[str, str], shown: list[Entry]) -> None:
    names = [entry.name for entry in shown]
    expected = {f"{name}.tex" for name in names} | {f"components/{name}.tex" for name in names}
    assert set(files) == expected | {"equations.tex", "equations.html", "names.json"}
    for name, text in files.items():
        assert text.endswith("\n")
        assert "\r" not in text
        head = {"tex": "% Generated", "html": "<!-- Generated", "json": '{\n "generated"'}
        assert text.startswith(head[name.rpartition(".")[2]])


def test_the_page_needs_nothing_from_elsewhere(files: dict[str, str], shown: list[Entry]) -> None:
    page = files["equations.html"].replace("http://www.w3.org/1998/Math/MathML", "")
    assert not re.search(r"<script|<link|<img|https?:|url\(|@import", page)
    assert page.count("<article") == len(shown)


def test_same_bytes_for_every_hash_seed() -> None:
    digests = set()
    for seed in ("0", "4711"):
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
        run = subprocess.run(
            [sys.executable, "-c", HASH],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        digests.add(run.stdout)
    assert len(digests) == 1


def test_the_document_compiles(files: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "equations.tex").write_text(files["equations.tex"], encoding="utf-8")
    if shutil.which("pdflatex"):
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "equations.tex"]
    elif shutil.which("tectonic"):
        command = ["tectonic", "--keep-logs", "equations.tex"]
    else:
        pytest.skip("neither pdflatex nor tectonic is installed")
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False)
    log = (tmp_path / "equations.log").read_text(encoding="utf-8", errors="replace")
    assert run.returncode == 0, log[-3000:]
    assert (tmp_path / "equations.pdf").stat().st_size > 10_000
    overfull = map(float, re.findall(r"Overfull \\hbox \(([\d.]+)pt", log))
    assert [excess for excess in overfull if excess > 10] == []
