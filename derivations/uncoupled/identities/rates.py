"""Section IV: (15)-(17) as derivatives of the closure equations, and their solution."""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Basic, Expr, MatAdd, Symbol

from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein, Screw
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Cross, Dot, components, matrix, scalar, vector
from derivations.uncoupled.displacement import lam, q6, r
from derivations.uncoupled.geometry import LIMBS, c, nu
from derivations.uncoupled.identities.facts import (
    CENTRAL,
    QUATERNION_RELATION,
    Facts,
    X,
    Y,
    Z,
    absolute,
    central_facts,
    directions,
    forward_velocity,
    from_platform,
    inverse_velocity,
    leg,
    line_from_leg,
    named,
    own_directions,
    pose,
    scalars,
    span,
    vectors,
)
from derivations.uncoupled.rates import RATES, omega, velocity
from derivations.uncoupled.velocity import screw

TWIST = Screw(omega, velocity)


def identities() -> list[Identity]:
    """Rows of (17), joint rates and twist."""
    proofs = []
    for i in LIMBS:
        proofs += [extension_rate(i), length_rate(i), joint_rate(i), drive(i), forward_row(i)]
    return [*proofs, *central_limb(), forward_rows(), forward_and_back()]


def derivative(value: Expr, rates: Mapping[Basic, Basic]) -> Expr:
    """The derivative in time, by the chain rule over vectors or scalars and their rates."""
    total = 0
    for quantity, rate in rates.items():
        if isinstance(quantity, Symbol):
            total += value.diff(quantity) * rate
        else:
            pairs = zip(components(quantity), components(rate), strict=True)
            total += sum(value.diff(entry) * speed for entry, speed in pairs)
    return total


def motion(i: int) -> dict[Basic, Basic]:
    """How C and n_i move with the platform."""
    n = vector(f"n{i}")
    return {c: velocity, n: Cross(omega, n)}


def extension_speed(i: int) -> Expr:
    """The rate of e_i: p_i ė_i = −u_i·v − e_i u_i·(omega × n_i)."""
    u, n = vectors("u n", i)
    e, p = scalars("e p", i)
    return -(Dot(u, velocity) + e * Dot(u, Cross(omega, n))) / p


def extension_rate(i: int) -> Identity:
    """(4), differentiated."""
    e, h, p = scalars("e h p", i)
    unfold = Unfolding(pose(), {}, named("n", i))

    def difference() -> list[Expr]:
        top, bottom = unfold(h), unfold(p)
        quotient = (derivative(top, motion(i)) - unfold(e) * derivative(bottom, motion(i))) / bottom
        return [quotient - unfold(extension_speed(i))]

    return Identity(
        f"rate of extension {i}",
        f"d/dt of (4): p_{i} ė_{i} = −u_{i}·v − e_{i} u_{i}·(omega × n_{i})",
        difference,
        number="(4)",
    )


def length_rate(i: int) -> Identity:
    """(6) with (3) and (4), differentiated, is row i of (17)."""
    b, n = vectors("b n", i)
    e, p, rho = scalars("e p rho", i)
    facts = leg(i) | from_platform(i) | line_from_leg(i) | span(i)
    unfold = Unfolding(pose(), facts, named("n e gt gz rho", i))

    def difference() -> list[Expr]:
        # q q̇ = b·ḃ by (6), ḃ = v + ė n + e omega × n by (3); the actuated screw's Klein form
        # is −q/|d − b| = −q p²/rho (identity "diagonal by lengths").
        platform_joint = velocity + extension_speed(i) * n + e * Cross(omega, n)
        row = Klein(matrix(f"S{i}", 6, 1), TWIST)
        return [unfold(row) + unfold(p**2 / rho * Dot(b, platform_joint))]

    return Identity(
        f"row {i} of (17)",
        f"d/dt of b_{i}·b_{i} = a² + q_{i}² is {{S_{i}; V}} = q̇_{i} {{S_{i}; $_{i}²}}",
        difference,
        number="(6), (15), (17)",
    )


def line_facts(i: int) -> tuple[Facts, tuple[Expr, ...]]:
    """e_i, S_i and its Klein form as computed, and the size of p_i."""
    sizes, nonnegative = absolute(scalar(f"p{i}"))
    symbols = [scalar(f"e{i}"), *vectors("s so", i), matrix(f"S{i}", 6, 1), scalar(f"limb{i}")]
    return sizes | {symbol: pose()[symbol.name].computed_as for symbol in symbols}, nonnegative


def joint_rate(i: int) -> Identity:
    """(15) solved for q̇_i."""
    facts, nonnegative = line_facts(i)
    kept = (*named("m h p l tau sigma rho", i), "nu")
    return computed_form(Unfolding(inverse_velocity(), facts, kept), f"dq{i}", nonnegative)


def drive(i: int) -> Identity:
    """Row i of (17), solved for what it asks of omega."""
    facts, nonnegative = line_facts(i)
    h, p, rho, tau, sigma, asked = scalars("h p rho tau sigma drive", i)
    kept = (*named("m h p l tau sigma rho", i), "nu", "omega", "v")
    unfold = Unfolding(forward_velocity(), facts, kept)
    row = Klein(matrix(f"S{i}", 6, 1), TWIST) - scalar(f"limb{i}") * RATES[i - 1]
    asks = Dot(tau * nu - sigma * vector(f"m{i}"), omega) - asked
    return Identity(
        f"drive {i}",
        f"row {i} of (17) says (tau_{i} nu − sigma_{i} m_{i})·omega = drive_{i}",
        lambda: [unfold(row - h / (p * rho) * asks)],
        nonnegative,
        "(15), (17)",
    )


def forward_row(i: int) -> Identity:
    """The closed form of omega does what the drive asks."""
    tau, sigma, asked = scalars("tau sigma drive", i)
    facts = directions() | own_directions()
    unfold = Unfolding(forward_velocity(), facts, named("drive tau sigma", *LIMBS))
    return Identity(
        f"omega in row {i}",
        f"omega in closed form satisfies row {i} of (17) for any joint rates",
        lambda: [unfold(Dot(tau * nu - sigma * vector(f"m{i}"), omega) - asked)],
        QUATERNION_RELATION,
        "(17)",
    )


def central_limb() -> list[Identity]:
    """(11), differentiated."""
    radial = (X * velocity[0, 0] + Y * velocity[1, 0]) / r
    speeds = {c: velocity, r: components(radial)}
    unfold = Unfolding(inverse_velocity(), {lam: (1 / q6) * c}, ("r", "q6"))

    def rate(joint: int) -> Identity:
        return Identity(
            f"rate of q{joint}",
            f"q̇{joint} in closed form is d/dt of (11)",
            lambda: [joint_speed(joint)],
            CENTRAL,
            "(11), (16)",
        )

    def joint_speed(joint: int) -> Expr:
        closed_form = unfold(RATES[joint - 1])
        if joint == 6:
            squared = X**2 + Y**2 + Z**2
            return derivative(squared, speeds) - 2 * q6 * closed_form
        return derivative(unfold(scalar(f"q{joint}")), speeds) - closed_form

    return [rate(joint) for joint in (4, 5, 6)]


def forward_rows() -> Identity:
    """Rows 4 to 6 of (17)."""
    unfold = Unfolding(forward_velocity(), central_facts(), ("n1", "n2", "c", "r", "q6", "omega"))
    twist = Screw(omega, forward_velocity()["v"].expression)
    actuated = MatAdd(*(RATES[joint + 2] * screw(4, joint) for joint in (1, 2, 3)))

    def difference(row: int) -> Expr:
        return unfold(Klein(screw(4, row), twist) - Klein(screw(4, row), actuated))

    return Identity(
        "velocity of C in rows 4 to 6",
        "v = q̇4 k × c + q̇5 axis × c + q̇6 lambda satisfies rows 4 to 6 of (17) for any omega",
        lambda: [difference(row) for row in (4, 5, 6)],
        number="(16), (17)",
    )


def forward_and_back() -> Identity:
    """The velocity of C is decoupled and inverts the three rates."""
    speed = forward_velocity()["v"].expression
    kept = ("r", "q6", "dq4", "dq5", "dq6")
    unfold = Unfolding(inverse_velocity(), central_facts() | {velocity: speed}, kept)
    return Identity(
        "rates of the velocity of C",
        "q̇4, q̇5 and q̇6 of that v are the rates that it came from",
        lambda: [unfold(inverse_velocity()[rate.name].expression) - rate for rate in RATES[3:]],
        CENTRAL,
        "(16)",
    )
