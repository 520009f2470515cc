"""What is proven of this manipulator: each claim reduces to exactly zero."""

from __future__ import annotations

from derivations.algebra.identities import Identity
from derivations.uncoupled.identities import (
    chains,
    closure,
    degenerate,
    displacement,
    klein,
    orientation,
    rates,
    reciprocity,
    singularity,
    velocity,
)

__all__ = ["identities"]

SECTIONS = (
    displacement,
    closure,
    orientation,
    klein,
    chains,
    velocity,
    reciprocity,
    rates,
    singularity,
    degenerate,
)


def identities() -> list[Identity]:
    """Every identity, in the order of the paper."""
    return [identity for section in SECTIONS for identity in section.identities()]
