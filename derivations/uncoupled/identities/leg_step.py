"""Section III: Newton's step in the angle of leg 1 and the turn about n_1."""

from __future__ import annotations

from functools import cache

from sympy import Basic, Expr, symbols

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Cross, Dot, Norm, components, matrix, scalar, vector
from derivations.uncoupled.eliminant import arm, cosine, sine
from derivations.uncoupled.geometry import HALF, ROOT, n1
from derivations.uncoupled.identities.facts import named
from derivations.uncoupled.leg_step import angle_step, by_angle, leg_graph, n2, turn_step

TANGENT, SIDE, SPAN = vector("tangent"), vector("side_part"), scalar("span")
SIZE = symbols("side_size", positive=True)
UNIT = (components(Dot(n1, n1)) - 1,)
CIRCLE = (cosine**2 + sine**2 - 1,)


def identities() -> list[Identity]:
    """How n_1 and n_2 are built and move, and the step."""
    directions = [second_direction(), next_direction()]
    return [along_leg(), *directions, step(), next_angle()]


@cache
def graph() -> Graph:
    return leg_graph()


def along_leg() -> Identity:
    """The turn that goes with the angle."""
    direct = Unfolding(graph(), {})
    by_names = Unfolding(graph(), {}, ("n1", "tangent", "span"))

    def difference() -> list[Basic]:
        way = direct(arm)
        slope = cosine * way.diff(sine) - sine * way.diff(cosine)
        across = TANGENT - Dot(n1, TANGENT) * n1
        return [direct(TANGENT) - slope, by_names(SPAN * Cross(by_angle, n1) - across)]

    return Identity(
        "turn by the angle of leg 1",
        "omega × n_1 is dn_1/dtheta = (b' − (b'·n_1) n_1)/|b_1 − c|, b' the derivative of b_1",
        difference,
        UNIT,
        "(3)",
    )


def second_direction() -> Identity:
    """n_2 from a guess."""
    by_guess = Unfolding(graph(), {}, ("n1", "guess"))
    by_side = Unfolding(graph(), {Norm(SIDE): SIZE}, ("n1", "side_part"))

    def difference() -> list[Expr]:
        slant = components(Dot(n1, SIDE))
        return [
            by_guess(Dot(n1, SIDE)),
            by_side(Dot(n1, n2)) + HALF - ROOT * slant / SIZE,
            by_side(Dot(n2, n2)) - 1 + ROOT * slant / SIZE,
        ]

    relations = (*UNIT, SIZE**2 - components(Dot(SIDE, SIDE)))
    return Identity(
        "n_2 beside leg 1",
        "n_2 is a unit vector 120° from n_1",
        difference,
        relations,
        "(5)",
    )


def next_direction() -> Identity:
    """n_2 after the step."""
    side, first, second = vector("next_side"), vector("next_n1"), vector("next_n2")
    by_moved = Unfolding(graph(), {}, ("next_n1", "next_guess"))
    by_side = Unfolding(graph(), {Norm(side): SIZE}, ("next_n1", "next_side"))

    def difference() -> list[Expr]:
        slant = components(Dot(first, side))
        return [
            by_moved(Dot(first, side)),
            by_side(Dot(first, second)) + HALF - ROOT * slant / SIZE,
            by_side(Dot(second, second)) - 1 + ROOT * slant / SIZE,
        ]

    relations = (components(Dot(first, first)) - 1, SIZE**2 - components(Dot(side, side)))
    return Identity(
        "n_2 beside leg 1 after the step",
        "n_2 is a unit vector 120° from n_1",
        difference,
        relations,
        "(5)",
    )


def step() -> Identity:
    """Newton's equations."""
    unfold = Unfolding(graph(), {}, named("F Ft Fp", 2, 3))

    def rest(i: int) -> Expr:
        value, by_theta, by_phi = (scalar(f"{name}{i}") for name in ("F", "Ft", "Fp"))
        return unfold(by_theta * angle_step + by_phi * turn_step + value)

    return Identity(
        "Newton's steps in two angles",
        "∂F_i/∂theta dtheta + ∂F_i/∂phi dphi = −F_i for limbs 2 and 3",
        lambda: [rest(2), rest(3)],
        number="(6)",
    )


def next_angle() -> Identity:
    """The angle after the step."""
    unfold = Unfolding(graph(), {}, ("half_step",))

    def difference() -> list[Expr]:
        turned = unfold(matrix("next_leg", 2, 1))
        return [turned.dot(turned) - 1]

    return Identity(
        "angle of leg 1 after the step",
        "its cosine and sine stay those of an angle",
        difference,
        CIRCLE,
        "(3)",
    )
