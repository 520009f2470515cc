"""Section IV, (15)-(17) solved in closed form: joint rates from the twist and back."""

from __future__ import annotations

from sympy import Abs, ImmutableDenseMatrix, ZeroMatrix

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Klein, Screw
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.displacement import lam, q6, r
from derivations.uncoupled.geometry import LIMBS, ROOT, base_i, base_j, base_k, c, nu
from derivations.uncoupled.singularity import singularity_graph, tilt
from derivations.uncoupled.velocity import axis

#: Twist of the platform: angular velocity and velocity of C.
omega, velocity = vector("omega"), vector("v")
RATES = tuple(scalar(f"dq{index}") for index in range(1, 7))
ZERO = ZeroMatrix(3, 1)


def inverse_rates() -> list[Equation]:
    """(15), (16) solved for the joint rates, without forming a matrix."""
    radial = Dot(c, base_i) * Dot(velocity, base_i) + Dot(c, base_j) * Dot(velocity, base_j)
    twist = Screw(omega, velocity)
    equations = []
    for i in LIMBS:
        p, length = scalar(f"p{i}"), scalar(f"l{i}")
        h, m = scalar(f"h{i}"), vector(f"m{i}")
        tau, sigma = scalar(f"tau{i}"), scalar(f"sigma{i}")
        force = p * Dot(tau * m + sigma * nu, velocity)
        torque = h * Dot(tau * nu - sigma * m, omega)
        equations.append(
            Equation(
                RATES[i - 1],
                Klein(matrix(f"S{i}", 6, 1), twist) / scalar(f"limb{i}"),
                f"rate of the outer limb {i}",
                "(15)",
                "m/s",
                computed_as=-(force + torque) / (p * Abs(p) * length),
            )
        )
    return [
        *equations,
        Equation(
            RATES[3], Dot(Cross(base_k, c), velocity) / r**2, "rate of the azimuth", "(16)", "rad/s"
        ),
        Equation(
            RATES[4],
            (r * Dot(velocity, base_k) - Dot(c, base_k) * radial / r) / q6**2,
            "rate of the elevation",
            "(16)",
            "rad/s",
        ),
        Equation(RATES[5], Dot(lam, velocity), "rate of the central limb's length", "(16)", "m/s"),
        Equation(
            matrix("dq", 6, 1), ImmutableDenseMatrix(RATES), "joint rates", "(21)", "m/s, rad/s"
        ),
    ]


def inverse_velocity_graph() -> Graph:
    """From pose and twist to the joint rates."""
    graph = singularity_graph()
    graph.leaves = (*graph.leaves, omega, velocity)
    graph.add(inverse_rates())
    return graph


def forward_twist() -> list[Equation]:
    """(17) solved for the twist: first v_C, which is decoupled, then omega.

    In the platform frame the rows of the 3×3 for omega are ``τ_i ν − σ_i m_i``; its
    determinant is √3/2 times ``tilt = τ1 σ2 σ3 + τ2 σ3 σ1 + τ3 σ1 σ2``.
    """
    v = velocity
    equations = [
        Equation(
            v,
            RATES[3] * Cross(base_k, c) + RATES[4] * Cross(axis, c) + RATES[5] * lam,
            "velocity of C",
            "(12), (16)",
            "m/s",
        )
    ]
    total = ZERO
    for i in LIMBS:
        j, k = i % 3 + 1, (i + 1) % 3 + 1
        h, p, length, drive = (scalar(f"{name}{i}") for name in ("h", "p", "l", "drive"))
        tau, sigma = scalar(f"tau{i}"), scalar(f"sigma{i}")
        force = Dot(tau * vector(f"m{i}") + sigma * nu, v)
        equations.append(
            Equation(
                drive,
                -(Abs(p) * length * RATES[i - 1] + force) * p / h,
                f"what limb {i} asks of omega: (τ_i ν − σ_i m_i)·omega",
                "(15)",
                "m/s",
            )
        )
        tau_j, sigma_j = scalar(f"tau{j}"), scalar(f"sigma{j}")
        tau_k, sigma_k = scalar(f"tau{k}"), scalar(f"sigma{k}")
        total += drive * (
            tau_j * sigma_k * vector(f"n{k}")
            - sigma_j * tau_k * vector(f"n{j}")
            + ROOT * sigma_j * sigma_k * nu
        )
    return [
        *equations,
        Equation(omega, total / (ROOT * tilt), "angular velocity", "(17)", "rad/s"),
        Equation(matrix("V", 6, 1), Screw(omega, v), "twist of the platform", "(12)", "rad/s, m/s"),
    ]


def forward_velocity_graph() -> Graph:
    """From pose and joint rates to the twist."""
    graph = singularity_graph()
    graph.leaves = (*graph.leaves, *RATES)
    graph.add(forward_twist())
    return graph
