"""What is proven of this manipulator: each claim reduces to exactly zero."""

from __future__ import annotations

from derivations.algebra.identities import Identity
from derivations.uncoupled.identities import (
    accelerations,
    chains,
    circles,
    closure,
    correction,
    degenerate,
    degree,
    displacement,
    eliminant,
    klein,
    leg_step,
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
    eliminant,
    circles,
    degree,
    correction,
    leg_step,
    orientation,
    klein,
    chains,
    velocity,
    reciprocity,
    rates,
    accelerations,
    singularity,
    degenerate,
)


def identities() -> list[Identity]:
    """Every identity, in the order of the paper."""
    return [identity for section in SECTIONS for identity in section.identities()]
