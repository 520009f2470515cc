"""Acceleration analysis: the time derivative of Section IV, which the paper leaves out.

Row i of (17) keeps its form with accelerations in the place of rates, but for what the rates
alone make: ``{S_i; A} = (q̈_i − bias_i) {S_i; ¹$_i²}`` with ``A = [d omega/dt, dv/dt]``.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, ZeroMatrix

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Klein, Screw
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.displacement import lam, q6, r
from derivations.uncoupled.geometry import LIMBS, base_i, base_j, base_k, c, nu
from derivations.uncoupled.rates import (
    RATES,
    drive_of_limb,
    driven,
    forward_velocity_graph,
    inverse_velocity_graph,
    lever,
    line_on,
    omega,
    velocity,
)
from derivations.uncoupled.velocity import axis

#: Angular acceleration of the platform, and acceleration of C.
angular, linear = vector("domega"), vector("dv")
ACCELERATIONS = tuple(scalar(f"ddq{index}") for index in range(1, 7))
ZERO = ZeroMatrix(3, 1)


def biases(i: int | str) -> list[Equation]:
    """How B_i moves, and the part of q̈_i that the rates alone make."""
    n, m, u = (vector(f"{name}{i}") for name in "nmu")
    b, d, speed = vector(f"b{i}"), vector(f"d{i}"), vector(f"db{i}")
    e, p, q, de, bias = (scalar(f"{name}{i}") for name in ("e", "p", "q", "de", "bias"))
    tau, sigma = scalar(f"tau{i}"), scalar(f"sigma{i}")
    turned = Cross(omega, n)
    drag = 2 * de * turned + e * Cross(omega, turned)
    line = tau * m + sigma * nu
    left = Dot(speed, speed) - scalar(f"dq{i}") ** 2
    return [
        Equation(
            de,
            -(Dot(u, velocity) + e * Dot(u, turned)) / p,
            "rate of e_i",
            "(4)",
            "m/s",
        ),
        Equation(speed, velocity + de * n + e * turned, "velocity of B_i", "(3)", "m/s"),
        Equation(
            bias,
            (Dot(b - d, drag) + left) / q,
            "the part of the acceleration of an outer limb that the rates alone make",
            "(6)",
            "m/s²",
            computed_as=(
                left - (2 * de * Dot(line, turned) + e * Dot(line, omega) * Dot(omega, n)) / p**2
            )
            / q,
        ),
    ]


def inverse_accelerations() -> list[Equation]:
    """q̈ from the twist and its derivative."""
    radial = Dot(c, base_i) * Dot(velocity, base_i) + Dot(c, base_j) * Dot(velocity, base_j)
    change = Screw(angular, linear)
    equations = []
    for i in LIMBS:
        bias = scalar(f"bias{i}")
        equations += biases(i)
        equations.append(
            Equation(
                ACCELERATIONS[i - 1],
                Klein(matrix(f"S{i}", 6, 1), change) / scalar(f"limb{i}") + bias,
                f"acceleration of the outer limb {i}",
                "(15)",
                "m/s²",
                computed_as=bias - line_on(i, angular, linear) / lever(i),
            )
        )
    height = Dot(c, base_k)
    dq4, dq5, dq6 = RATES[3:]
    ddq4, ddq5, ddq6 = ACCELERATIONS[3:]
    return [
        *equations,
        Equation(
            ddq4,
            (Dot(Cross(base_k, c), linear) - 2 * radial * dq4) / r**2,
            "acceleration of the azimuth",
            "(16)",
            "rad/s²",
        ),
        Equation(
            ddq6,
            (Dot(velocity, velocity) + Dot(c, linear) - dq6**2) / q6,
            "acceleration of the central limb's length",
            "(16)",
            "m/s²",
        ),
        Equation(
            ddq5,
            (Dot(linear, base_k) - (height / q6) * ddq6 - 2 * (r / q6) * dq5 * dq6) / r
            + (height / r) * dq5**2,
            "acceleration of the elevation",
            "(16)",
            "rad/s²",
        ),
        Equation(
            matrix("ddq", 6, 1),
            ImmutableDenseMatrix(ACCELERATIONS),
            "joint accelerations",
            "(21)",
            "m/s², rad/s²",
        ),
    ]


def inverse_acceleration_graph() -> Graph:
    """From pose, twist and its derivative to the joint accelerations."""
    graph = inverse_velocity_graph()
    graph.leaves = (*graph.leaves, angular, linear)
    graph.add(inverse_accelerations())
    return graph


def forward_accelerations() -> list[Equation]:
    """The derivative of the twist from rates and accelerations of the joints, as (17)."""
    dq4, dq5, dq6 = RATES[3:]
    ddq4, ddq5, ddq6 = ACCELERATIONS[3:]
    around = Cross(axis, c)
    equations = [
        Equation(
            linear,
            ddq4 * Cross(base_k, c)
            + ddq5 * around
            + ddq6 * lam
            + dq4 * Cross(base_k, velocity)
            + dq4 * dq5 * Cross(Cross(base_k, axis), c)
            + dq5 * Cross(axis, velocity)
            + (dq6 / q6) * (velocity - dq6 * lam),
            "acceleration of C",
            "(16)",
            "m/s²",
        )
    ]
    for i in LIMBS:
        equations += biases(i)
        equations.append(
            Equation(
                scalar(f"ddrive{i}"),
                drive_of_limb(i, ACCELERATIONS[i - 1] - scalar(f"bias{i}"), linear),
                f"what limb {i} asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt",
                "(15)",
                "m/s²",
            )
        )
    return [
        *equations,
        Equation(angular, driven("ddrive"), "angular acceleration", "(17)", "rad/s²"),
        Equation(
            matrix("dV", 6, 1),
            Screw(angular, linear),
            "derivative of the twist",
            "(12)",
            "rad/s², m/s²",
        ),
    ]


def forward_acceleration_graph() -> Graph:
    """From pose, joint rates and joint accelerations to the twist and its derivative."""
    graph = forward_velocity_graph()
    graph.leaves = (*graph.leaves, *ACCELERATIONS)
    graph.add(forward_accelerations())
    return graph
