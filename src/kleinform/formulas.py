"""The derived formulas as LaTeX, read from the generated package."""

from __future__ import annotations

import json
from difflib import get_close_matches
from importlib.resources import files

from kleinform.errors import KleinformError

__all__ = ["Formulas", "UnknownFormulaError"]


class UnknownFormulaError(KleinformError, LookupError):
    """There is no formula of that name; the message names those that come close."""


class Formulas:
    """The formulas by name, each with one line of words."""

    def __init__(self) -> None:
        self._root = files("kleinform_kernels.uncoupled") / "latex"
        index = json.loads((self._root / "names.json").read_text(encoding="utf-8"))
        self._index: dict[str, dict[str, str]] = index["formulas"]

    @property
    def names(self) -> list[str]:
        """Every name, sorted."""
        return sorted(self._index)

    def listing(self) -> str:
        """Every name with its words and the paper's number, a line each."""
        width = max(map(len, self._index))
        lines = []
        for name in self.names:
            entry = self._index[name]
            lines.append(f"{name:{width}}  {entry['words']}  {entry['number']}".rstrip())
        return "\n".join(lines)

    def latex(self, name: str, *, components: bool = False) -> str:
        """One formula, as it stands in a display of amsmath.

        Parameters
        ----------
        name
            One of `names`.
        components
            Print entries in components of the symbols that the formula names.

        Raises
        ------
        UnknownFormulaError
            There is none of that name.
        """
        if name not in self._index:
            folded = {known.casefold(): known for known in self._index}
            close = get_close_matches(name.casefold(), folded, n=4, cutoff=0.5)
            hint = f"; close: {', '.join(folded[match] for match in close)}" if close else ""
            raise UnknownFormulaError(f"no formula is called {name!r}{hint}")
        folder = self._root / "components" if components else self._root
        text = (folder / f"{name}.tex").read_text(encoding="utf-8")
        return "\n".join(line for line in text.splitlines() if not line.startswith("%"))
