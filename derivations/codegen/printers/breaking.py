"""Long formulas over several lines, cut where a reader would cut them.

A formula is cut between the terms of a sum, then between bracketed factors, then inside
brackets and under a root; never inside a fraction or a matrix.
"""

from __future__ import annotations

import re

from derivations.codegen.printers.latex import brace_group, width

__all__ = ["lines"]

STEP = re.compile(r"\\(?:left|right|begin|end)\b|[{}()\[\]]")
OPENING = ("{", "(", "[", r"\left", r"\begin")
BRACKET = re.compile(r"(?:\\left)?([(\[])(.*?)(?:\\right)?([)\]])")
BEFORE_BRACKET = r" (?=(?:\\left)?[(\[])"
#: A factor in front of a bracket that is at most so wide stays with it.
HEAD = 20


def lines(text: str, room: int) -> list[str]:
    """The text in lines as full as ``room`` allows."""
    filled: list[str] = []
    for piece in _pieces(text, room):
        if filled and width(filled[-1]) + width(piece) <= room:
            filled[-1] += f" {piece}"
        else:
            filled.append(piece)
    return filled


def _pieces(text: str, room: int) -> list[str]:
    if width(text) <= room:
        return [text]
    parts = _cut(text, r" (?=[+-] )")
    if len(parts) == 1:
        parts = _with_head(_cut(text, BEFORE_BRACKET))
    if len(parts) > 1:
        return [piece for part in parts for piece in _pieces(part, room)]
    return _opened(text, room)


def _cut(text: str, where: str) -> list[str]:
    """The text cut wherever the pattern matches outside all braces and brackets."""
    parts, start, depth = [], 0, 0
    for match in re.finditer(f"(?P<cut>{where})|{STEP.pattern}", text):
        if match["cut"] is None:
            depth += 1 if match[0] in OPENING else -1
        elif depth == 0:
            parts.append(text[start : match.start()])
            start = match.end()
    return [*parts, text[start:]]


def _with_head(parts: list[str]) -> list[str]:
    """A short factor in front stays with the bracket that follows it."""
    first, *others = parts
    if others and width(first) <= HEAD:
        return [f"{first} {others[0]}", *others[1:]]
    return parts


def _opened(text: str, room: int) -> list[str]:
    """The inside of the bracket or the root that ends the text, cut in pieces."""
    *head, end = _cut(text, BEFORE_BRACKET)
    bracket = BRACKET.fullmatch(end)
    if bracket:
        before, after = rf"\Bigl{bracket[1]}", rf"\Bigr{bracket[3]}"
        inside = bracket[2]
    elif end.startswith(r"\sqrt") and brace_group(end[5:])[1] == "":
        before, after = r"\Bigl[", r"\Bigr]^{1/2}"
        inside = brace_group(end[5:])[0]
    else:
        return [text]
    first, *others = _pieces(inside, room)
    *middle, last = [" ".join([*head, before + first]), *others]
    return [*middle, last + after]
