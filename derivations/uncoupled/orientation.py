"""Section III: the rotation from directions (8), from roll, pitch and yaw (9), and back."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, atan2, cos, sin, sqrt

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Columns, Cross, Dot, Norm, matrix, scalar, vector
from derivations.uncoupled.geometry import m1, n1, nu

n2 = vector("n2")
ROTATION = matrix("R", 3, 3)
#: The paper's letters: yaw alpha, pitch beta, roll gamma.
roll, pitch, yaw = scalar("gamma"), scalar("beta"), scalar("alpha")


def directions_graph() -> Graph:
    """(8) from n_1 and n_2, its second and third column normalised."""
    graph = Graph((n1, n2))
    normal = Cross(n1, n2)
    inward = Cross(normal, n1)
    graph.add(
        [
            Equation(nu, normal / Norm(normal), "normal of the platform", "(8)"),
            Equation(m1, inward / Norm(inward), "platform y axis", "(8)"),
            Equation(ROTATION, Columns(n1, m1, nu), "rotation of the platform", "(8)"),
        ]
    )
    return graph


def from_angles_graph() -> Graph:
    """(9): R = Rz(yaw) Ry(pitch) Rx(roll)."""
    ca, sa, cb, sb = cos(yaw), sin(yaw), cos(pitch), sin(pitch)
    cg, sg = cos(roll), sin(roll)
    entries = [
        [ca * cb, ca * sb * sg - sa * cg, ca * sb * cg + sa * sg],
        [sa * cb, sa * sb * sg + ca * cg, sa * sb * cg - ca * sg],
        [-sb, cb * sg, cb * cg],
    ]
    graph = Graph((roll, pitch, yaw))
    graph.add(
        [Equation(ROTATION, ImmutableDenseMatrix(entries), "rotation of the platform", "(9)")]
    )
    return graph


def to_angles_graph() -> Graph:
    """(9) solved for the angles.

    Yaw comes first and roll from the rotation with yaw taken out. So the angles give back
    the rotation even at pitch ±90°, where only yaw ∓ roll is defined: where R_11 = R_21 = 0
    exactly, atan2(0, 0) = 0 makes yaw zero and roll takes it all.
    """
    ca, sa = cos(yaw), sin(yaw)
    graph = Graph((ROTATION,))
    graph.add(
        [
            Equation(yaw, atan2(ROTATION[1, 0], ROTATION[0, 0]), "yaw", "(9)", "rad"),
            Equation(
                pitch,
                atan2(-ROTATION[2, 0], sqrt(ROTATION[0, 0] ** 2 + ROTATION[1, 0] ** 2)),
                "pitch",
                "(9)",
                "rad",
            ),
            Equation(
                roll,
                atan2(
                    sa * ROTATION[0, 2] - ca * ROTATION[1, 2],
                    ca * ROTATION[1, 1] - sa * ROTATION[0, 1],
                ),
                "roll",
                "(9)",
                "rad",
            ),
        ]
    )
    return graph


def defect_graph() -> Graph:
    """How far a matrix [n1, m1, nu] is from a rotation."""
    size = scalar("defect")
    gap = vector("gap")
    squares = [
        (Dot(n1, n1) - 1) ** 2,
        (Dot(m1, m1) - 1) ** 2,
        Dot(n1, m1) ** 2,
        Dot(gap, gap),
    ]
    graph = Graph((n1, m1, nu))
    graph.add(
        [
            Equation(gap, Cross(n1, m1) - nu, "n_1 × m_1 − ν, zero for a rotation"),
            Equation(
                size,
                sqrt(sum(squares)),
                "root of the squared defects of |n_1| = |m_1| = 1, n_1·m_1 = 0, n_1 × m_1 = ν",
            ),
        ]
    )
    return graph
