"""Statics as the dual of Section IV, which the paper leaves out.

A wrench is ``[F; M]`` with its moment M at C; its Klein form with the twist is the power
``F·v + M·omega``. The wrench here is the one that the platform exerts on its surroundings,
quasi-static and without gravity: ``F·v + M·omega = Σ f_j q̇_j`` for every twist, where f_j is
the force or the torque of actuator j. Each outer limb carries a force along S_i alone, since
S_i is reciprocal to its passive screws, and the central limb a force through C.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, ZeroMatrix

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Screw
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.displacement import lam, q6, r
from derivations.uncoupled.geometry import LIMBS, ROOT, base_i, base_j, base_k, c
from derivations.uncoupled.rates import others, response
from derivations.uncoupled.singularity import singularity_graph, tilt
from derivations.uncoupled.velocity import axis

#: Force, and moment at C, of the wrench that the platform exerts.
force, moment = vector("force"), vector("moment")
#: Forces of the actuators of q1, q2, q3, q6 and torques of those of q4, q5.
FORCES = tuple(scalar(f"force{index}") for index in range(1, 7))
#: The force through C that the central limb carries.
central_force = vector("central_force")
ZERO = ZeroMatrix(3, 1)


def exerted_wrench() -> list[Equation]:
    """(15), (16) by duality: the wrench from the forces of the actuators."""
    f4, f5, f6 = FORCES[3:]
    horizontal = Dot(c, base_i) * base_i + Dot(c, base_j) * base_j
    along = f4 * vector("grad_q4") + f5 * vector("grad_q5") + f6 * lam
    about = ZERO
    for i in LIMBS:
        carried = FORCES[i - 1] / scalar(f"limb{i}")
        along += carried * vector(f"s{i}")
        about += carried * vector(f"so{i}")
    return [
        Equation(
            vector("grad_q4"),
            Cross(base_k, c) / r**2,
            "force through C that a torque of 1 about the azimuth makes",
            "(16)",
            "1/m",
        ),
        Equation(
            vector("grad_q5"),
            (r * base_k - (Dot(c, base_k) / r) * horizontal) / q6**2,
            "force through C that a torque of 1 about the elevation makes",
            "(16)",
            "1/m",
        ),
        Equation(force, along, "force that the platform exerts", "(15), (16)", "N"),
        Equation(moment, about, "moment at C that the platform exerts", "(15)", "N m"),
        Equation(
            matrix("wrench", 6, 1),
            Screw(force, moment),
            "wrench that the platform exerts",
            "(17)",
            "N, N m",
        ),
    ]


def platform_wrench_graph() -> Graph:
    """From pose and forces of the actuators to the wrench of the platform."""
    graph = singularity_graph()
    graph.leaves = (*graph.leaves, *FORCES)
    graph.add(exerted_wrench())
    return graph


def line_load(i: int | str, j: int | str, k: int | str) -> list[Equation]:
    """What limb i carries: the forces along the lines S_i alone have a moment about C."""
    share, e, rho = scalar(f"share{i}"), scalar(f"e{i}"), scalar(f"rho{i}")
    return [
        Equation(
            share,
            Dot(response(j, k), moment) / (ROOT * tilt),
            f"power of the moment at the omega that a drive of 1 of limb {i} alone makes",
            "(17)",
            "N",
        ),
        Equation(scalar(f"load{i}"), share * rho / e, f"force along S_{i}", "(17)", "N"),
    ]


def required_forces() -> list[Equation]:
    """The way back: first the forces along the S_i, then what is left for the central limb."""
    equations, left = [], force
    for i in LIMBS:
        load = scalar(f"load{i}")
        left -= load * vector(f"s{i}")
        equations += [
            *line_load(i, *others(i)),
            Equation(
                FORCES[i - 1],
                load * scalar(f"limb{i}"),
                f"force of the actuator of limb {i}",
                "(15)",
                "N",
            ),
        ]
    return [
        *equations,
        Equation(
            central_force,
            left,
            "force through C that the central limb carries",
            "(16)",
            "N",
        ),
        Equation(
            FORCES[3],
            Dot(Cross(base_k, c), central_force),
            "torque of the actuator of the azimuth",
            "(16)",
            "N m",
        ),
        Equation(
            FORCES[4],
            Dot(Cross(axis, c), central_force),
            "torque of the actuator of the elevation",
            "(16)",
            "N m",
        ),
        Equation(
            FORCES[5],
            Dot(lam, central_force),
            "force of the actuator of the central limb's length",
            "(16)",
            "N",
        ),
        Equation(
            matrix("forces", 6, 1),
            ImmutableDenseMatrix(FORCES),
            "forces and torques of the actuators",
            "(17)",
            "N, N m",
        ),
    ]


def actuator_forces_graph() -> Graph:
    """From pose and wrench of the platform to the forces of the actuators."""
    graph = singularity_graph()
    graph.leaves = (*graph.leaves, force, moment)
    graph.add(required_forces())
    return graph
