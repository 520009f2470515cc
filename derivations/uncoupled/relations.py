"""Equations of the paper that define nothing: both sides are expressions.

They are shown and not computed. Each function gives a file name and the relation.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Basic, MatMul, S, Transpose, ZeroMatrix

from derivations.algebra.screws import POLARITY, Klein, Lie, Screw
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.accelerations import angular, linear
from derivations.uncoupled.geometry import LIMBS, a
from derivations.uncoupled.rates import omega, velocity
from derivations.uncoupled.velocity import screw

__all__ = ["TWIST", "TWIST_RATE", "Relation"]

TWIST, TWIST_RATE = matrix("V", 6, 1), matrix("dV", 6, 1)
REDUCED = matrix("reduced", 6, 1)


@dataclass(frozen=True)
class Relation:
    """An equation between two expressions; the fields are those of an `Equation`."""

    symbol: Basic
    expression: Basic
    words: str
    number: str = ""
    unit: str = "1"
    computed_as: Basic | None = None


Named = tuple[str, Relation]


def platform_symmetry() -> Named:
    """(5)."""
    total = vector("n1") + vector("n2") + vector("n3")
    return "platform_symmetry", Relation(total, ZeroMatrix(3, 1), "symmetry of the platform", "(5)")


def base_revolute() -> Named:
    """(2)."""
    leg = vector("bi") - vector("ai")
    words = "the leg is normal to the axis of its base revolute"
    return "base_revolute_i", Relation(Dot(leg, vector("ui")), S.Zero, words, "(2)", "m")


def leg_length() -> Named:
    """(6)."""
    b = vector("bi")
    right = a**2 + scalar("qi") ** 2
    return "leg_length_i", Relation(Dot(b, b), right, "closure of an outer limb", "(6)", "m²")


def line_normal() -> Named:
    """(7)."""
    line = vector("di") - vector("bi")
    words = "B_iD_i is normal to n_i"
    return "line_normal_i", Relation(Dot(line, vector("ni")), S.Zero, words, "(7)", "m")


def klein_form() -> Named:
    """(13)."""
    first, second, first_dual, second_dual = map(vector, ("s1", "s2", "so1", "so2"))
    form = Klein(Screw(first, first_dual), Screw(second, second_dual))
    right = Dot(first, second_dual) + Dot(second, first_dual)
    return "klein_form", Relation(form, right, "Klein form of two screws", "(13)", "m")


def lie_product() -> Named:
    """The Lie product of two screws, of which (12), differentiated, is made."""
    first, second, first_dual, second_dual = map(vector, ("s1", "s2", "so1", "so2"))
    left = Lie(Screw(first, first_dual), Screw(second, second_dual))
    right = Screw(Cross(first, second), Cross(first, second_dual) - Cross(second, first_dual))
    return "lie_product", Relation(left, right, "Lie product of two screws", "(12)", "1, m")


def reduced_acceleration() -> Named:
    """(12), differentiated: its left side."""
    change = Screw(angular, linear - Cross(omega, velocity))
    words = "reduced acceleration state of the platform"
    return "reduced_acceleration", Relation(REDUCED, change, words, "(12)", "rad/s², m/s²")


def limb_acceleration() -> Named:
    """(15), differentiated."""
    line = matrix("Si", 6, 1)
    right = scalar("ddqi") * Klein(line, screw("i", 2))
    words = "acceleration of an outer limb, passive joints eliminated"
    left = Klein(line, REDUCED - matrix("liei", 6, 1))
    return "limb_acceleration_i", Relation(left, right, words, "(15)", "m/s²")


def limb_velocity() -> Named:
    """(15)."""
    line = matrix("Si", 6, 1)
    right = scalar("dqi") * Klein(line, screw("i", 2))
    words = "velocity of an outer limb, passive joints eliminated"
    return "limb_velocity_i", Relation(Klein(line, TWIST), right, words, "(15)", "m/s")


def central_velocity() -> Named:
    """(16)."""
    passive = matrix("screw", 6, 1)
    right = sum(scalar(f"dq{joint + 3}") * Klein(passive, screw(4, joint)) for joint in LIMBS)
    words = "velocity of the central limb, for each $ of its last three screws"
    return "central_velocity", Relation(Klein(passive, TWIST), right, words, "(16)", "m/s")


def input_output() -> Named:
    """(17)."""
    left = MatMul(Transpose(matrix("J_v", 6, 6)), matrix("Delta", 6, 6), TWIST)
    right = MatMul(matrix("J_q", 6, 6), matrix("dq", 6, 1))
    words = "input-output equation of velocity"
    return "input_output", Relation(left, right, words, "(17)", "m/s, rad/s")


def polarity() -> Named:
    """(20)."""
    return "polarity", Relation(matrix("Delta", 6, 6), POLARITY, "operator of polarity", "(20)")
