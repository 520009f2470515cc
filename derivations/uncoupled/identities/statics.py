"""Statics by duality: the power of the wrench is that of the actuators."""

from __future__ import annotations

from functools import cache

from sympy import Expr

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein, Screw
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import components, matrix
from derivations.uncoupled.geometry import LIMBS
from derivations.uncoupled.identities.facts import (
    Facts,
    forward_velocity,
    inverse_velocity,
    named,
    vectors,
)
from derivations.uncoupled.identities.rates import TWIST, line_facts
from derivations.uncoupled.rates import RATES, omega, velocity
from derivations.uncoupled.statics import (
    FORCES,
    actuator_forces_graph,
    force,
    moment,
    platform_wrench_graph,
)

WRENCH = Screw(force, moment)
CENTRAL = ("c", "lambda", "r", "q6", "axis")


@cache
def wrench() -> Graph:
    return platform_wrench_graph()


@cache
def forces() -> Graph:
    return actuator_forces_graph()


def identities() -> list[Identity]:
    """Both ways the same power."""
    return [power_of_forces(), power_of_wrench()]


def power_of_forces() -> Identity:
    """The wrench from forces, against the rates from any twist."""
    lines = {matrix(f"S{i}", 6, 1): Screw(*vectors("s so", i)) for i in LIMBS}
    kept = (*named("s so limb", *LIMBS), *CENTRAL)
    unfold, rate = Unfolding(wrench(), lines, kept), Unfolding(inverse_velocity(), lines, kept)

    def difference() -> list[Expr]:
        actuators = sum(one * rate(speed) for one, speed in zip(FORCES, RATES, strict=True))
        return [unfold(Klein(WRENCH, TWIST)) - actuators]

    return Identity(
        "power of platform_wrench",
        "F·v + M·omega = Σ f_j q̇_j for any forces of the actuators and any twist, with the joint "
        "rates of (15) and (16)",
        difference,
        number="(15), (16), (17)",
    )


def power_of_wrench() -> Identity:
    """The forces from a wrench, against the twist from any rates."""
    facts, nonnegative = all_lines()
    kept = (*named("n m p h l tau sigma rho", *LIMBS), "nu", "tilt", *CENTRAL)
    unfold, speed = Unfolding(forces(), facts, kept), Unfolding(forward_velocity(), facts, kept)

    def difference() -> list[Expr]:
        twist = Screw(speed(omega), speed(velocity))
        actuators = sum(unfold(one) * rate for one, rate in zip(FORCES, RATES, strict=True))
        return [components(Klein(WRENCH, twist)) - actuators]

    return Identity(
        "power of actuator_forces",
        "F·v + M·omega = Σ f_j q̇_j for any wrench of the platform and any joint rates, with the "
        "twist of (17)",
        difference,
        nonnegative,
        "(16), (17)",
    )


def all_lines() -> tuple[Facts, tuple[Expr, ...]]:
    """What stands for S_i, its Klein form and e_i, for all limbs."""
    facts: Facts = {}
    relations: tuple[Expr, ...] = ()
    for i in LIMBS:
        of_limb, nonnegative = line_facts(i)
        facts, relations = facts | of_limb, relations + nonnegative
    return facts, relations
