"""What is said of rows near a singularity: one line for a whole table, and columns when asked."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from kleinform.commands.columns import Table
from kleinform.commands.source import Block
from kleinform.conditioning import Conditioning
from kleinform.errors import SingularityWarning
from kleinform.zero import NEAR

__all__ = ["Nearness", "columns"]


class Nearness:
    """The rows of a table near a singularity, block by block."""

    def __init__(self) -> None:
        self._count, self._place = 0, ""
        self._ratios: dict[str, float] = {}

    @contextmanager
    def noted(self, block: Block) -> Iterator[None]:
        """Note what the calls for a block warn of; other warnings go on as they are."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", SingularityWarning)
            yield
        for entry in caught:
            if isinstance(entry.message, SingularityWarning):
                self._add(entry.message, block)
            else:
                warnings.warn_explicit(entry.message, entry.category, entry.filename, entry.lineno)

    def _add(self, warning: SingularityWarning, block: Block) -> None:
        mask = np.asarray(warning.mask)
        self._place = self._place or block.where(int(np.argmax(mask)))
        self._count += int(mask.sum())
        for name, ratio in warning.ratios.items():
            self._ratios[name] = min(ratio, self._ratios.get(name, ratio))

    def tell(self) -> None:
        """One line on standard error, if there is something to tell."""
        if not self._ratios:
            return
        smallest = sorted(self._ratios.items(), key=lambda entry: entry[1])
        named = ", ".join(f"{name} {ratio:.2g}" for name, ratio in smallest)
        rows = f"; rows: {self._count}, the first at {self._place}" if self._place else ""
        print(
            f"kleinform: near a singularity: |f|/scale below √eps = {NEAR:.2g}, {named}{rows}",
            file=sys.stderr,
        )


def columns(found: Conditioning) -> Table:
    """Ratios, and singular values with their numbers."""
    return {
        **{f"ratio_{name}": ratio for name, ratio in found.ratios.items()},
        **{
            f"{name}_{index + 1}": values[..., index]
            for name, values in found.singular_values.items()
            for index in range(values.shape[-1])
        },
    }
