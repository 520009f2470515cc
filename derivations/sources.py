"""Where in the derivations each of the paper's equation numbers stands, read from the source."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Callable
from pathlib import Path

__all__ = ["equation_sources", "numbers_in", "printed_equation", "source_of"]

ROOT = Path(__file__).resolve().parent
NUMBER = re.compile(r"\((\d+)\)")
RANGE = re.compile(r"\((\d+)\)-\((\d+)\)")


def numbers_in(text: str) -> list[int]:
    """The equation numbers that a text names: "(4), (22)-(24)" has 4, 22, 23, 24."""
    found = {int(number) for number in NUMBER.findall(text)}
    for first, last in RANGE.findall(text):
        found |= set(range(int(first), int(last) + 1))
    return sorted(found)


def printed_equation(place: str) -> list[int]:
    """The equation that is itself misprinted at a place such as "(8)"; none in "on (8)"."""
    return numbers_in(place) if NUMBER.fullmatch(place) else []


def equation_sources() -> dict[int, list[str]]:
    """For each equation number, ``file:function`` of what names it in the derivations."""
    places: dict[int, list[str]] = {}
    files = [ROOT / "algebra" / "screws.py", *sorted((ROOT / "uncoupled").glob("*.py"))]
    for path in files:
        if path.name in (
            "counterexamples.py",
            "display.py",
            "fields.py",
            "forward_kernels.py",
            "identities.py",
            "kernels.py",
            "notation.py",
        ):
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                place = f"{path.relative_to(ROOT.parent).as_posix()}:{node.name}"
                for number in _named_numbers(node):
                    places.setdefault(number, []).append(place)
    return dict(sorted(places.items()))


def source_of(function: Callable[..., object]) -> str:
    """The file of a function of the derivations, from the top of the project."""
    return Path(inspect.getfile(function)).resolve().relative_to(ROOT.parent).as_posix()


def _named_numbers(node: ast.AST) -> list[int]:
    """Numbers in the string constants of a definition, its docstring among them."""
    texts = [
        part.value
        for part in ast.walk(node)
        if isinstance(part, ast.Constant) and isinstance(part.value, str)
    ]
    return sorted({number for text in texts for number in numbers_in(text)})
