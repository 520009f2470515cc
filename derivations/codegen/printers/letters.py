"""How names become letters: ``gt1_x`` is an italic g with the index 1 and two marks.

A `Notation` is one table from names to letters; the mechanism owns the table. In a table's
key ``#`` stands for an index: a limb's number, or i for the whole family.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

__all__ = ["Letter", "Notation", "UnknownLetterError"]

INDEX = "([0-9ijk])"
COMPONENT = re.compile(r"(.+)_(x|y|z|ox|oy|oz|[1-9][0-9]?)")


class UnknownLetterError(LookupError):
    """A symbol has no letter; the message names it."""


@dataclass(frozen=True)
class Letter:
    """A letter and its marks.

    Parameters
    ----------
    body
        The letter. A ``#`` in it is replaced by the index, which then is no subscript.
    sub, sup
        Marks that belong to the letter, below and above.
    before
        What stands in front of it.
    accent
        A command that the letter wears, such as ``\\dot``.
    upright
        Never bold, not even as a whole vector.
    """

    body: str
    sub: str = ""
    sup: str = ""
    before: str = ""
    accent: str = ""
    upright: bool = False

    def latex(self, index: str = "", component: str = "", bold: bool = False) -> str:
        """The letter with its index, of one component or of the whole."""
        body = self.body.replace("#", index)
        if "#" in self.body:
            index = ""
        if bold and not self.upright:
            command = r"\boldsymbol" if body.startswith("\\") else r"\mathbf"
            body = f"{command}{{{body}}}"
        if self.accent:
            body = f"{self.accent}{{{body}}}"
        sub = _joined(_joined(self.sub, index, ","), *_component(component))
        text = self.before + body + (f"_{{{sub}}}" if sub else "")
        return text + (f"^{{{self.sup}}}" if self.sup else "")


def _joined(left: str, right: str, comma: str) -> str:
    return left + comma + right if left and right else left + right


def _component(component: str) -> tuple[str, str]:
    """A component's mark and what parts it from the index."""
    if component.startswith("o"):
        return "O" + component[1:], ","
    return component, "" if component in ("x", "y", "z") else ","


class Notation:
    """The letters of a mechanism, in the order in which terms and factors are written."""

    def __init__(self, table: Mapping[str, Letter | str]) -> None:
        self._rows = [
            (re.compile(re.escape(key).replace(r"\#", INDEX)), _letter(letter))
            for key, letter in table.items()
        ]
        self._resolved: dict[str, tuple[int, Letter, str, str]] = {}

    def _find(self, name: str) -> tuple[int, Letter, str] | None:
        for row, (pattern, letter) in enumerate(self._rows):
            match = pattern.fullmatch(name)
            if match:
                return row, letter, "".join(match.groups())
        return None

    def _resolve(self, name: str) -> tuple[int, Letter, str, str]:
        """The row of a name, its letter, index and component."""
        if name not in self._resolved:
            self._resolved[name] = self._split(name)
        return self._resolved[name]

    def _split(self, name: str) -> tuple[int, Letter, str, str]:
        found = self._find(name)
        if found:
            return (*found, "")
        match = COMPONENT.fullmatch(name)
        found = self._find(match[1]) if match else None
        if found is None or match is None:
            raise UnknownLetterError(f"{name} has no letter: add one to the table of notation")
        return (*found, match[2])

    def latex(self, name: str, bold: bool = False) -> str:
        """The LaTeX of a name, or of a component of it such as ``n1_x``."""
        _, letter, index, component = self._resolve(name)
        return letter.latex(index, component, bold)

    def rank(self, name: str) -> tuple[bool, int, str, int, str]:
        """Where a name stands among the others: components after scalars, x before ox."""
        row, _, index, component = self._resolve(name)
        return component != "", row, index, len(component), component


def _letter(entry: Letter | str) -> Letter:
    return Letter(entry) if isinstance(entry, str) else entry
