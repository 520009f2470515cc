"""Accelerations as second derivatives of the closure equations, both ways."""

from __future__ import annotations

from functools import cache

from sympy import Basic, Expr, cos, sin

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein, Screw
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Cross, Dot, components, matrix, scalar, vector
from derivations.uncoupled.accelerations import (
    ACCELERATIONS,
    angular,
    forward_acceleration_graph,
    inverse_acceleration_graph,
    linear,
)
from derivations.uncoupled.displacement import lam, q4, q6, r
from derivations.uncoupled.geometry import LIMBS, base_i, base_j, base_k, c, nu
from derivations.uncoupled.identities.facts import (
    CENTRAL,
    QUATERNION_RELATION,
    X,
    Y,
    any_frame,
    directions,
    from_platform,
    leg,
    line_from_leg,
    line_in_platform,
    named,
    own_directions,
    scalars,
    span,
    vectors,
)
from derivations.uncoupled.identities.rates import derivative, line_facts
from derivations.uncoupled.rates import RATES, omega, velocity
from derivations.uncoupled.velocity import axis

CHANGE = Screw(angular, linear)


@cache
def inverse() -> Graph:
    return inverse_acceleration_graph()


@cache
def forward() -> Graph:
    return forward_acceleration_graph()


def identities() -> list[Identity]:
    """The limbs, the central limb, and the way back."""
    proofs = []
    for i in LIMBS:
        proofs += [extension_acceleration(i), length_acceleration(i), bias(i), joint(i)]
        proofs += [drive(i), forward_row(i)]
    return [*proofs, *central_limb(), axis_rate(), forward_velocity_rate()]


def drag(i: int) -> Basic:
    """The acceleration of B_i but for d omega/dt, dv/dt and the second rate of e_i."""
    turned = Cross(omega, vector(f"n{i}"))
    return 2 * scalar(f"de{i}") * turned + scalar(f"e{i}") * Cross(omega, turned)


def extension_second(i: int) -> Expr:
    """From u_i·(d²/dt² of (3)) = 0."""
    n, u = vectors("n u", i)
    e, p = scalars("e p", i)
    return -(Dot(u, linear) + e * Dot(u, Cross(angular, n)) + Dot(u, drag(i))) / p


def extension_acceleration(i: int) -> Identity:
    """(4), differentiated twice."""
    n = vector(f"n{i}")
    unfold = Unfolding(inverse(), {}, named("n e", i))

    def difference() -> list[Expr]:
        rate = unfold(scalar(f"de{i}"))
        rates = {n: Cross(omega, n), scalar(f"e{i}"): rate, velocity: linear, omega: angular}
        return [derivative(rate, rates) - unfold(extension_second(i))]

    return Identity(
        f"second rate of extension {i}",
        f"d²/dt² of (4): p_{i} ë_{i} = −u_{i}·(dv/dt + e_{i} d omega/dt × n_{i} + 2 ė_{i} omega × "
        f"n_{i} + e_{i} omega × (omega × n_{i}))",
        difference,
        number="(4)",
    )


def length_acceleration(i: int) -> Identity:
    """(6), differentiated twice."""
    b, d, n = vectors("b d n", i)
    e, p, rho = scalars("e p rho", i)
    facts = leg(i) | from_platform(i) | line_from_leg(i) | span(i)
    unfold = Unfolding(inverse(), facts, named("n e de gt gz rho", i))

    def difference() -> list[Expr]:
        # q q̈ + q̇² = b·b̈ + ḃ·ḃ; {S; $²} = −q p²/rho (identity "diagonal by lengths"), and
        # q bias = (b − d)·drag + ḃ·ḃ − q̇².
        joint = linear + extension_second(i) * n + e * Cross(angular, n) + drag(i)
        row = Klein(matrix(f"S{i}", 6, 1), CHANGE)
        return [unfold(row) + unfold(p**2 / rho * (Dot(b, joint) - Dot(b - d, drag(i))))]

    return Identity(
        f"row {i} of (17), differentiated",
        f"d²/dt² of b_{i}·b_{i} = a² + q_{i}² is {{S_{i}; dV/dt}} = (q̈_{i} − bias_{i}) "
        f"{{S_{i}; $_{i}²}}",
        difference,
        number="(6), (15), (17)",
    )


def bias(i: int) -> Identity:
    """S_i is normal to n_i."""
    kept = (*named("b tau sigma p q de db e dq", i), "omega")
    return computed_form(Unfolding(inverse(), line_in_platform(i) | any_frame(i), kept), f"bias{i}")


def joint(i: int) -> Identity:
    """The row solved for q̈_i."""
    facts, nonnegative = line_facts(i)
    kept = (*named("m h p l tau sigma rho bias", i), "nu")
    return computed_form(Unfolding(inverse(), facts, kept), f"ddq{i}", nonnegative)


def drive(i: int) -> Identity:
    """The row solved for what it asks of d omega/dt."""
    facts, nonnegative = line_facts(i)
    h, p, rho, tau, sigma, asked = scalars("h p rho tau sigma ddrive", i)
    kept = (*named("m h p l tau sigma rho bias", i), "nu", "domega", "dv")
    unfold = Unfolding(forward(), facts, kept)
    free = ACCELERATIONS[i - 1] - scalar(f"bias{i}")
    row = Klein(matrix(f"S{i}", 6, 1), CHANGE) - scalar(f"limb{i}") * free
    asks = Dot(tau * nu - sigma * vector(f"m{i}"), angular) - asked
    return Identity(
        f"drive of acceleration {i}",
        f"row {i} of (17), differentiated, says (tau_{i} nu − sigma_{i} m_{i})·d omega/dt = "
        f"ddrive_{i}",
        lambda: [unfold(row - h / (p * rho) * asks)],
        nonnegative,
        "(15), (17)",
    )


def forward_row(i: int) -> Identity:
    """The closed form of d omega/dt does what the drive asks."""
    tau, sigma, asked = scalars("tau sigma ddrive", i)
    facts = directions() | own_directions()
    unfold = Unfolding(forward(), facts, named("ddrive tau sigma", *LIMBS))
    return Identity(
        f"angular acceleration in row {i}",
        f"d omega/dt in closed form satisfies row {i} of (17), differentiated",
        lambda: [unfold(Dot(tau * nu - sigma * vector(f"m{i}"), angular) - asked)],
        QUATERNION_RELATION,
        "(17)",
    )


def central_limb() -> list[Identity]:
    """(11), differentiated twice."""
    unfold = Unfolding(inverse(), {lam: (1 / q6) * c}, ("r", "q6"))
    speeds = {
        c: velocity,
        velocity: linear,
        r: components((X * velocity[0, 0] + Y * velocity[1, 0]) / r),
        q6: components(Dot(c, velocity)) / q6,
    }

    def acceleration(joint: int) -> Identity:
        def difference() -> list[Expr]:
            rate = unfold(RATES[joint - 1])
            return [derivative(rate, speeds) - unfold(ACCELERATIONS[joint - 1])]

        return Identity(
            f"acceleration of q{joint}",
            f"q̈{joint} in closed form is d²/dt² of (11)",
            difference,
            CENTRAL,
            "(11), (16)",
        )

    return [acceleration(joint) for joint in (4, 5, 6)]


def axis_rate() -> Identity:
    """The second revolute of the central limb is carried by the first."""
    turned = sin(q4) * base_i - cos(q4) * base_j
    unfold = Unfolding(inverse(), {}, ("q4",))

    def difference() -> list[Expr]:
        return list(unfold(turned).diff(q4) - unfold(Cross(base_k, turned)))

    return Identity(
        "rate of the axis of joint 2",
        "d axis/dt = q̇4 k × axis",
        difference,
        number="Section IV",
    )


def forward_velocity_rate() -> Identity:
    """dv/dt in closed form is the derivative of v in closed form."""
    unfold = Unfolding(forward(), {}, ("axis", "lambda", "q6", "v"))
    speeds = {
        c: velocity,
        axis: unfold(RATES[3] * Cross(base_k, axis)),
        lam: (velocity - RATES[5] * lam) / q6,
        **dict(zip(RATES[3:], ACCELERATIONS[3:], strict=True)),
    }

    def difference() -> list[Expr]:
        speed = unfold(forward()["v"].expression)
        closed = unfold(forward()["dv"].expression)
        return [derivative(one, speeds) - other for one, other in zip(speed, closed, strict=True)]

    return Identity(
        "acceleration of C",
        "dv/dt in closed form is d/dt of q̇4 k × c + q̇5 axis × c + q̇6 lambda, with c = q6 lambda",
        difference,
        number="(16)",
    )
