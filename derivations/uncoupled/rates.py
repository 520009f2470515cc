"""Section IV, (15)-(17) solved in closed form: joint rates from the twist and back."""

from __future__ import annotations

from sympy import Abs, Basic, Expr, ImmutableDenseMatrix, ZeroMatrix

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


def line_on(i: int, angular: Basic, linear: Basic) -> Expr:
    """The Klein form of S_i and a twist, or its derivative, times p_i rho_i."""
    p, h = scalar(f"p{i}"), scalar(f"h{i}")
    m, tau, sigma = vector(f"m{i}"), scalar(f"tau{i}"), scalar(f"sigma{i}")
    force = p * Dot(tau * m + sigma * nu, linear)
    torque = h * Dot(tau * nu - sigma * m, angular)
    return force + torque


def lever(i: int) -> Expr:
    """The Klein form of S_i and the actuated screw, times −p_i rho_i."""
    p = scalar(f"p{i}")
    return p * Abs(p) * scalar(f"l{i}")


def drive_of_limb(i: int, along: Basic, linear: Basic) -> Expr:
    """What the limb's row asks of omega, or of its derivative, when q_i moves so."""
    h, p, length = (scalar(f"{name}{i}") for name in ("h", "p", "l"))
    force = Dot(scalar(f"tau{i}") * vector(f"m{i}") + scalar(f"sigma{i}") * nu, linear)
    return -(Abs(p) * length * along + force) * p / h


def others(i: int) -> tuple[int, int]:
    """The limbs that come after limb i."""
    return i % 3 + 1, (i + 1) % 3 + 1


def response(j: int | str, k: int | str) -> Basic:
    """√3/2 tilt times the omega that the drive of the limb before j and k makes when it is 1."""
    tau_j, sigma_j = scalar(f"tau{j}"), scalar(f"sigma{j}")
    tau_k, sigma_k = scalar(f"tau{k}"), scalar(f"sigma{k}")
    return (
        tau_j * sigma_k * vector(f"n{k}")
        - sigma_j * tau_k * vector(f"n{j}")
        + ROOT * sigma_j * sigma_k * nu
    )


def driven(name: str) -> Basic:
    """The 3×3 of the rows ``τ_i ν − σ_i m_i`` solved for the drives of this name."""
    total = ZERO
    for i in LIMBS:
        total += scalar(f"{name}{i}") * response(*others(i))
    return total / (ROOT * tilt)


def inverse_rates() -> list[Equation]:
    """(15), (16) solved for the joint rates, without forming a matrix."""
    radial = Dot(c, base_i) * Dot(velocity, base_i) + Dot(c, base_j) * Dot(velocity, base_j)
    twist = Screw(omega, velocity)
    equations = [
        Equation(
            RATES[i - 1],
            Klein(matrix(f"S{i}", 6, 1), twist) / scalar(f"limb{i}"),
            f"rate of the outer limb {i}",
            "(15)",
            "m/s",
            computed_as=-line_on(i, omega, velocity) / lever(i),
        )
        for i in LIMBS
    ]
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
    equations += [
        Equation(
            scalar(f"drive{i}"),
            drive_of_limb(i, RATES[i - 1], v),
            f"what limb {i} asks of omega: (τ_i ν − σ_i m_i)·omega",
            "(15)",
            "m/s",
        )
        for i in LIMBS
    ]
    return [
        *equations,
        Equation(omega, driven("drive"), "angular velocity", "(17)", "rad/s"),
        Equation(matrix("V", 6, 1), Screw(omega, v), "twist of the platform", "(12)", "rad/s, m/s"),
    ]


def forward_velocity_graph() -> Graph:
    """From pose and joint rates to the twist."""
    graph = singularity_graph()
    graph.leaves = (*graph.leaves, *RATES)
    graph.add(forward_twist())
    return graph
