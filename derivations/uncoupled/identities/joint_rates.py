"""(12): the rates of all joints of a limb make the twist of the platform."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from sympy import Basic, Expr, MatAdd, MatrixSymbol, eye

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Columns, Dot, Norm, components, matrix, scalar
from derivations.uncoupled.geometry import LIMBS, base_i, base_j, base_k, m1, n1, nu
from derivations.uncoupled.identities.facts import (
    CENTRAL,
    QUATERNION_RELATION,
    Facts,
    central_facts,
    directions,
    from_platform,
    line_from_leg,
    named,
    scalars,
    vectors,
)
from derivations.uncoupled.identities.rates import TWIST
from derivations.uncoupled.joint_rates import JOINTS, joint_rate, joint_rates_graph, spin
from derivations.uncoupled.rates import omega, velocity
from derivations.uncoupled.velocity import axis, screw


@cache
def graph() -> Graph:
    return joint_rates_graph()


def identities() -> list[Identity]:
    """A limb after the other."""
    proofs = []
    for i in LIMBS:
        proofs += [*reciprocal_lines(i), *computed_rates(i), limb_twist(i)]
    return [base_frames(), *proofs, central_turn(), *central_twist()]


def base_frames() -> Identity:
    """Proofs of a limb may take u_i, t_i and k for the axes."""
    unfold = Unfolding(graph(), {})

    def difference() -> list[Basic]:
        frames = [unfold(Columns(*vectors("u t", i), base_k)) for i in LIMBS]
        return [part for frame in frames for part in (frame.T * frame - eye(3), frame.det() - 1)]

    return Identity(
        "base frames",
        "[u_i, t_i, k] is a rotation, so that components of vectors of limb i may be those in it",
        difference,
        number="Section II",
    )


def by_leg_angle(i: int) -> tuple[Facts, tuple[Expr, ...]]:
    """Limb i from its foot along any unit vector w_i normal to u_i, and any unit vector n_i.

    Components are those in the frame [u_i, t_i, k], which "base frames" proves to be one.
    """
    a_i, b, n, t, u, w = vectors("a b n t u w", i)
    p, q, gt, gz = scalars("p q gt gz", i)
    horizontal, vertical = scalars("wt wz", i)
    facts = from_platform(i) | line_from_leg(i)
    facts |= {
        u: base_i,
        t: base_j,
        w: horizontal * t + vertical * base_k,
        b: a_i + q * w,
        gt: p * q * horizontal,
        gz: p * q * vertical,
    }
    units = (horizontal**2 + vertical**2 - 1, components(Dot(n, n)) - 1)
    return facts, units


def on_limb(i: int) -> tuple[Unfolding, tuple[Expr, ...]]:
    """Reads down to the leg's angle and length, e_i and n_i."""
    facts, units = by_leg_angle(i)
    b, d = vectors("b d", i)
    length = {Norm(d - b): scalar(f"span{i}")}
    return Unfolding(graph(), facts | length, named("n e q", i)), units


def reciprocal_lines(i: int) -> list[Identity]:
    """Each line leaves one rate of (12); the upper revolute is such a line itself."""
    unfold, units = on_limb(i)

    def reciprocal(line: MatrixSymbol, only: int) -> Identity:
        others = [joint for joint in JOINTS if joint != only]
        return Identity(
            f"line for joint {only} of limb {i}",
            f"{graph()[line.name].words}: reciprocal to every screw of limb {i} but its "
            f"screw {only}",
            lambda: [unfold(Klein(line, screw(i, joint))) for joint in others],
            units,
            "(12), (14)",
        )

    foot, guide = matrix(f"foot{i}", 6, 1), matrix(f"guide{i}", 6, 1)
    return [reciprocal(screw(i, 4), 1), reciprocal(foot, 5), reciprocal(guide, 6)]


def computed_rates(i: int) -> list[Identity]:
    """Klein forms in numerators and denominators."""
    unfold, units = on_limb(i)
    return [computed_form(unfold, f"rate{i}{joint}", units) for joint in (1, 5, 6)]


def combination(limb: int, joints: Iterable[int] = JOINTS) -> Basic:
    """The right side of (12) with the rates in closed form."""
    return MatAdd(*(joint_rate(limb, joint) * screw(limb, joint) for joint in joints))


def limb_twist(i: int) -> Identity:
    """(12) for an outer limb."""
    unfold, units = on_limb(i)
    return Identity(
        f"rates of limb {i}",
        f"(12): the screws of limb {i} with their rates in closed form sum up to any twist",
        lambda: [unfold(combination(i)) - unfold(TWIST)],
        units,
        "(12), (15)",
    )


def central_turn() -> Identity:
    """The denominator of the wrist."""
    unfold = Unfolding(graph(), directions(), ("spin", "wrist"))
    return computed_form(unfold, "rate44", QUATERNION_RELATION)


def central_twist() -> list[Identity]:
    """(12) for the central limb, its two halves."""
    passive = named("rate4", 4, 5, 6)
    place = Unfolding(graph(), central_facts(), ("c", "r", "q6", "n1", "n2", *passive))
    axes = {n1: base_i, m1: base_j, nu: base_k}
    turn = Unfolding(graph(), axes, ("spin", "lambda"))
    base = Unfolding(graph(), {}, ("axis", "dq4", "dq5"))

    def position() -> list[Basic]:
        return [place(combination(4))[3:6, 0] - place(velocity)]

    def orientation() -> list[Basic]:
        left = omega - joint_rate(4, 1) * base_k - joint_rate(4, 2) * axis
        return [turn(combination(4, (4, 5, 6)))[0:3, 0] - turn(spin), base(left) - base(spin)]

    return [
        Identity(
            "rates of limb 4, position",
            "(12), dual parts: q̇4, q̇5 and q̇6 in closed form make any velocity of C",
            position,
            CENTRAL,
            "(12), (16)",
        ),
        Identity(
            "rates of limb 4, orientation",
            "(12), primal parts: the passive rates in closed form make what is left of any omega, "
            "in the platform frame",
            orientation,
            number="(12)",
        ),
    ]
