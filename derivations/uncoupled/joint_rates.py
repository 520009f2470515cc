"""(12) solved for all 24 joint rates: six a limb, the actuated ones those of (15) and (16).

A line that is reciprocal to every screw of a limb but one gives the rate of that one, as S_i
does for the actuated screw. What is left of omega then gives the rates along the leg and of
the upper revolute.
"""

from __future__ import annotations

from sympy import Expr, ImmutableDenseMatrix, MatrixSymbol, Symbol

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Klein, Screw, line
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.displacement import lam
from derivations.uncoupled.geometry import LIMBS, ROOT, base_k, c, m1, n1, nu
from derivations.uncoupled.rates import RATES, inverse_velocity_graph, omega, velocity
from derivations.uncoupled.singularity import wrist
from derivations.uncoupled.velocity import axis, screw

#: The part of omega that the passive joints of the central limb make.
spin = vector("spin")
JOINTS = range(1, 7)


def joint_rate(limb: int | str, joint: int) -> Symbol:
    """The rate of a joint; the actuated ones have the names of (15) and (16)."""
    if limb == 4 and joint <= 3:
        return RATES[joint + 2]
    return scalar(f"dq{limb}") if limb != 4 and joint == 2 else scalar(f"rate{limb}{joint}")


def across_twist(reciprocal: MatrixSymbol, own: MatrixSymbol) -> Expr:
    """The rate of the one screw of a limb that a line is not reciprocal to."""
    return Klein(reciprocal, Screw(omega, velocity)) / Klein(reciprocal, own)


def outer_rates(i: int | str) -> list[Equation]:
    """(12) for the passive joints of an outer limb."""
    n, u, w, a_i, b, hinge = (vector(f"{name}{i}") for name in ("n", "u", "w", "a", "b", "nw"))
    e, p, q = (scalar(f"{name}{i}") for name in "epq")
    foot, guide = matrix(f"foot{i}", 6, 1), matrix(f"guide{i}", 6, 1)
    left = omega - joint_rate(i, 5) * n
    return [
        Equation(
            foot,
            line(hinge, c - a_i),
            f"line through A_{i} along n_{i} × w_{i}",
            "(12), (14)",
            "1, m",
        ),
        Equation(
            guide,
            line(u, c - b),
            f"line through B_{i} along u_{i}",
            "(12), (14)",
            "1, m",
        ),
        Equation(
            joint_rate(i, 1),
            across_twist(screw(i, 4), screw(i, 1)),
            "rate of the base revolute",
            "(12)",
            "rad/s",
            computed_as=(Dot(hinge, velocity) + e * Dot(Cross(n, hinge), omega)) / (p * q),
        ),
        Equation(
            joint_rate(i, 5),
            across_twist(foot, screw(i, 5)),
            "rate of the cylindrical joint's rotation",
            "(12)",
            "rad/s",
            computed_as=-(Dot(hinge, velocity) + Dot(Cross(hinge, c - a_i), omega))
            / (q * Dot(hinge, hinge)),
        ),
        Equation(
            joint_rate(i, 6),
            across_twist(guide, screw(i, 6)),
            "rate of the cylindrical joint's translation",
            "(12)",
            "m/s",
            computed_as=(Dot(u, velocity) + e * Dot(u, Cross(omega, n))) / p,
        ),
        Equation(
            joint_rate(i, 3),
            Dot(w, left),
            "rate of the revolute along the leg",
            "(12)",
            "rad/s",
        ),
        Equation(
            joint_rate(i, 4),
            Dot(Cross(u, w), left) / p,
            "rate of the upper revolute, whose axis is no unit vector",
            "(12)",
            "rad/s",
        ),
    ]


def central_rates() -> list[Equation]:
    """(12) for the passive joints of the central limb: a turn made of three."""
    normal = Cross(n1, vector("n2"))
    left = spin - joint_rate(4, 4) * lam
    return [
        Equation(
            spin,
            omega - RATES[3] * base_k - RATES[4] * axis,
            "angular velocity that the passive joints of the central limb make",
            "(12)",
            "rad/s",
        ),
        Equation(
            joint_rate(4, 4),
            Dot(normal, spin) / wrist,
            "rate of the revolute along the central limb",
            "(12)",
            "rad/s",
            computed_as=ROOT * Dot(nu, spin) / wrist,
        ),
        Equation(
            joint_rate(4, 5),
            Dot(n1, left),
            "rate of the universal joint's first axis",
            "(12)",
            "rad/s",
        ),
        Equation(
            joint_rate(4, 6),
            Dot(m1, left) / ROOT,
            "rate of the universal joint's second axis, of norm √3/2",
            "(12)",
            "rad/s",
        ),
    ]


def all_rates() -> Equation:
    """The rates as an array: a row a limb, a column a joint."""
    rows = [[joint_rate(limb, joint) for joint in JOINTS] for limb in (*LIMBS, 4)]
    return Equation(
        matrix("limb_rates", 4, 6),
        ImmutableDenseMatrix(rows),
        "rates of all joints, a row a limb",
        "(12)",
        "rad/s, m/s",
    )


def joint_rates_graph() -> Graph:
    """From pose and twist to the rates of all joints."""
    graph = inverse_velocity_graph()
    for i in LIMBS:
        graph.add(outer_rates(i))
    graph.add([*central_rates(), all_rates()])
    return graph
