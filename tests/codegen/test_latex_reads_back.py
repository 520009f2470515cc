"""Printed formulas mean what was derived: read back and evaluated in numbers.

The reader knows fractions, roots, powers, brackets and a few functions; letters are put in
by their LaTeX. So a lost sign, factor or term, or two names with one letter, shows.
"""

from __future__ import annotations

import math
import re
from random import Random

import pytest
from sympy import Expr, ImmutableDenseMatrix, Rational

from derivations.algebra.equations import Equation
from derivations.algebra.vectors import components
from derivations.codegen.printers.formula import Length, component_form, keeping_norms
from derivations.codegen.printers.latex import VectorLatex, brace_group
from derivations.uncoupled.display import Displayed, displayed, known_components
from derivations.uncoupled.notation import NOTATION

PRINTER = VectorLatex(NOTATION)
#: Matrices are shown as such, not an equation an entry.
LISTED = [
    shown
    for shown in displayed()
    if isinstance(shown.equation, Equation)
    and "bmatrix" not in component_form(shown.equation, PRINTER, known_components())
]
PLAIN = {
    r"\Bigl": "",
    r"\Bigr": "",
    r"\left|": "abs(",
    r"\right|": ")",
    r"\left": "",
    r"\right": "",
    r"\operatorname{atan2}": "atan2",
    r"\,": " ",
    r"\quad": " ",
    "[": "(",
    "]": ")",
}


def sides(latex: str) -> list[str]:
    """The right side of each equation of a display, on one line."""
    body = re.sub(r"\\(begin|end)\{split\}", "", latex).replace("\n", " ")
    joined: list[str] = []
    for row in body.split(r" \\ "):
        left, _, right = row.partition("&") if "&" in row else ("=", "", row)
        if left.strip():
            joined.append(right)
        elif r"\text" not in right:
            joined[-1] += right
    return [text.partition("=")[2] for text in joined]


def python(text: str) -> str:
    """The expression in Python, where a space or a bracket between factors multiplies."""
    for command in (r"\frac", r"\sqrt"):
        while command in text:
            before, _, after = text.partition(command)
            first, after = brace_group(after)
            if command == r"\frac":
                second, after = brace_group(after)
                text = f"{before} (({first})/({second})) {after}"
            else:
                text = f"{before} sqrt ({first}) {after}"
    text = re.sub(r"\\(cos|sin) +(\S+)", r"\1 (\2)", text)
    text = re.sub(r"\^\{([^{}]*)\}", r"**(\1) ", text)
    tokens = re.findall(r"\*\*|[A-Za-z]\w*|\d+|[-+/(),]", text)
    result = ""
    for last, token in zip(["(", *tokens], tokens, strict=False):
        ends = last == ")" or last[-1].isalnum()
        starts = token == "(" or token[0].isalnum()
        called = last in ("cos", "sin", "sqrt", "abs", "atan2")
        result += ("*" if ends and starts and not called else "") + token
    return result


def entries_of(equation: Equation) -> list[Expr]:
    """The entries that a component form lists: of a matrix those that are not zero."""
    whole = components(keeping_norms(equation.expression)).xreplace(known_components())
    if not isinstance(whole, ImmutableDenseMatrix):
        return [whole]
    return list(whole) if whole.shape[1] == 1 else [entry for entry in whole if entry != 0]


def read(text: str, letters: dict[str, float]) -> float:
    """The value of a printed expression."""
    scope: dict[str, object] = {"__builtins__": {}, "abs": abs}
    scope |= {name: getattr(math, name) for name in ("cos", "sin", "sqrt", "atan2")}
    for number, letter in enumerate(sorted(letters, key=len, reverse=True)):
        scope[f"value{number}"] = letters[letter]
        alone = rf"(?<![A-Za-z\\]){re.escape(letter)}(?![A-Za-z])"
        text = re.sub(alone, f" value{number} ", text)
    for command, plain in PLAIN.items():
        text = text.replace(command, plain)
    return float(eval(python(text), scope))


@pytest.mark.parametrize("shown", LISTED, ids=lambda shown: shown.name)
def test_component_forms_read_back(shown: Displayed) -> None:
    entries = entries_of(shown.equation)
    texts = sides(component_form(shown.equation, PRINTER, known_components()))
    atoms = set().union(*(entry.atoms(Length) | entry.free_symbols for entry in entries))
    random = Random(1)
    values = {atom: Rational(random.randint(2, 99), 16) for atom in sorted(atoms, key=str)}
    letters = {PRINTER.doprint(atom): float(value) for atom, value in values.items()}
    assert len(letters) == len(values), "two names have one letter"
    for text, entry in zip(texts, entries, strict=True):
        expected = float(entry.xreplace(values))
        assert math.isclose(read(text, letters), expected, rel_tol=1e-12, abs_tol=1e-9), text
