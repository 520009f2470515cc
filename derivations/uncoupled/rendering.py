"""The LaTeX side of the generated tree, as text."""

from __future__ import annotations

import json

from derivations.codegen.printers.document import NOTICE, Entry, html_page, tex_document
from derivations.codegen.printers.formula import component_form, vector_form
from derivations.codegen.printers.latex import VectorLatex
from derivations.uncoupled.display import SECTIONS, displayed, known_components
from derivations.uncoupled.notation import NOTATION

__all__ = ["entries", "latex_files"]

TITLE = "Equations of the uncoupled parallel manipulator 3-RPRRC+RRPRU"


def entries() -> list[Entry]:
    """Every displayed formula, printed."""
    printer, known = VectorLatex(NOTATION), known_components()
    return [
        Entry(
            name=shown.name,
            section=shown.section,
            title=SECTIONS[shown.section],
            words=shown.words,
            note=shown.note,
            number=shown.equation.number,
            unit=shown.equation.unit,
            latex=vector_form(shown.equation, printer),
            components=component_form(shown.equation, printer, known),
        )
        for shown in displayed()
    ]


def latex_files() -> dict[str, str]:
    """The text of every file below ``latex/``, by its path there."""
    shown = entries()
    files = {f"{entry.name}.tex": _formula(entry.latex) for entry in shown}
    files |= {f"components/{entry.name}.tex": _formula(entry.components) for entry in shown}
    files["equations.tex"] = tex_document(TITLE, shown)
    files["equations.html"] = html_page(TITLE, shown)
    files["names.json"] = _names(shown)
    return files


def _formula(latex: str) -> str:
    return f"% {NOTICE}\n{latex}\n"


def _names(shown: list[Entry]) -> str:
    """What the command line lists: every name with its words, number and unit."""
    formulas = {
        entry.name: {"words": entry.words, "number": entry.number, "unit": entry.unit}
        for entry in shown
    }
    content = {"generated": NOTICE, "formulas": formulas}
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"
