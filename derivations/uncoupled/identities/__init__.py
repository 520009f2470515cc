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
    joint_rates,
    klein,
    leg_step,
    lie_screws,
    loci,
    motion,
    orientation,
    rates,
    reciprocity,
    singularity,
    statics,
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
    joint_rates,
    statics,
    accelerations,
    lie_screws,
    singularity,
    degenerate,
    loci,
    motion,
)


def identities() -> list[Identity]:
    """Every identity, in the order of the paper."""
    return [identity for section in SECTIONS for identity in section.identities()]
