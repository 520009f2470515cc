"""Section III: displacement analysis.

The paper divides by ``n_i·u_i`` early. Kernels divide as late as they can: they carry
``g_i = p_i (b_i − a_i)`` with ``p_i = n_i·u_i``, which is finite and free of cancellation
for every pose, and is normal to ``u_i`` by construction.
"""

from __future__ import annotations

from sympy import Abs, ImmutableDenseMatrix, atan2, cos, sin, sqrt

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.vectors import Dot, Norm, Rows, matrix, scalar, vector
from derivations.uncoupled.geometry import (
    LIMBS,
    POSE,
    a,
    base_i,
    base_j,
    base_joint,
    base_k,
    c,
    constants,
    platform_directions,
    rotation,
)

#: Central limb: azimuth, elevation, length, unit vector and distance of C from the Z axis.
q4, q5, q6 = scalar("q4"), scalar("q5"), scalar("q6")
lam, r = vector("lambda"), scalar("r")


def central_direction() -> Equation:
    """(1): the unit vector of the central limb from its two angles."""
    return Equation(
        lam,
        cos(q4) * cos(q5) * base_i + sin(q4) * cos(q5) * base_j + sin(q5) * base_k,
        "unit vector along the central limb, from O to C",
        "(1)",
        computed_as=c / q6,
    )


def central_inverse() -> list[Equation]:
    """(11): the joint values of the central limb from the position of C."""
    return [
        Equation(q6, Norm(c), "length of the central limb", "(11)", "m"),
        Equation(
            r,
            sqrt(Dot(c, base_i) ** 2 + Dot(c, base_j) ** 2),
            "distance of C from the Z axis",
            "(11)",
            "m",
        ),
        Equation(q5, atan2(Dot(c, base_k), r), "elevation of the central limb", "(11)", "rad"),
        Equation(
            q4,
            atan2(Dot(c, base_j), Dot(c, base_i)),
            "azimuth of the central limb, measured from the X axis",
            "(11)",
            "rad",
        ),
    ]


def central_forward() -> list[Equation]:
    """(1): the position of C from the joint values of the central limb."""
    direction = central_direction()
    return [
        Equation(lam, direction.expression, direction.words, direction.number),
        Equation(c, q6 * lam, "position of the platform's centre C", "(1)", "m"),
    ]


def limb_inverse(i: int | str) -> list[Equation]:
    """(2)-(4), (10): from the pose to the joint value of an outer limb."""
    n, u, t = vector(f"n{i}"), vector(f"u{i}"), vector(f"t{i}")
    a_i, b = vector(f"a{i}"), vector(f"b{i}")
    h, p, e, q = (scalar(f"{name}{i}") for name in "hpeq")
    gt, gz, length = scalar(f"gt{i}"), scalar(f"gz{i}"), scalar(f"l{i}")
    return [
        base_joint(i),
        Equation(h, a - Dot(c, u), "distance of C from the plane of the limb", "(4)", "m"),
        Equation(p, Dot(n, u), "cosine of the angle between n_i and u_i", "(4)"),
        Equation(
            e,
            (a - Dot(c, u)) / Dot(n, u),
            "signed distance from C to B_i",
            "(4)",
            "m",
            computed_as=h / p,
        ),
        Equation(b, c + e * n, "position of B_i", "(3)", "m"),
        Equation(
            gt,
            p * Dot(b - a_i, t),
            "p_i times the horizontal part of the leg",
            unit="m",
            computed_as=p * Dot(c, t) + h * Dot(n, t),
        ),
        Equation(
            gz,
            p * Dot(b - a_i, base_k),
            "p_i times the vertical part of the leg",
            unit="m",
            computed_as=p * Dot(c, base_k) + h * Dot(n, base_k),
        ),
        Equation(length, sqrt(gt**2 + gz**2), "p_i times the leg, its length", unit="m"),
        Equation(
            q,
            sqrt(Dot(b, b) - a**2),
            "length of the outer limb",
            "(10)",
            "m",
            computed_as=length / Abs(p),
        ),
    ]


def limb_geometry(i: int | str) -> list[Equation]:
    """(7) and Section IV: the leg's unit vector w_i and the point D_i."""
    n, u, t = vector(f"n{i}"), vector(f"u{i}"), vector(f"t{i}")
    a_i, b, d, w = (vector(f"{name}{i}") for name in "abdw")
    p, q, gt, gz = (scalar(f"{name}{i}") for name in ("p", "q", "gt", "gz"))
    along, delta = scalar(f"ng{i}"), scalar(f"delta{i}")
    return [
        Equation(
            w,
            (b - a_i) / q,
            "unit vector along the outer limb",
            "Section IV",
            computed_as=(gt * t + gz * base_k) / (p * q),
        ),
        Equation(
            along,
            p * Dot(b - a_i, n),
            "p_i times the part of the leg along n_i",
            unit="m",
            computed_as=gt * Dot(n, t) + gz * Dot(n, base_k),
        ),
        Equation(
            delta,
            Dot(b, n) / Dot(u, n),
            "signed distance from O to D_i",
            "(7)",
            "m",
            computed_as=a + along / p**2,
        ),
        Equation(d, delta * u, "position of D_i", "(7)", "m"),
    ]


def collected() -> list[Equation]:
    """The arrays that kernels return: joint values, extensions, platform joints."""
    joints = matrix("q", 6, 1)
    names = [f"q{index}" for index in range(1, 7)]
    return [
        Equation(
            joints,
            ImmutableDenseMatrix([scalar(name) for name in names]),
            "joint values",
            "(10), (11)",
            "m, rad",
        ),
        Equation(
            matrix("e", 3, 1),
            ImmutableDenseMatrix([scalar(f"e{i}") for i in LIMBS]),
            "signed distances from C to B_i",
            "(4)",
            "m",
        ),
        Equation(
            matrix("B", 3, 3),
            Rows(*(vector(f"b{i}") for i in LIMBS)),
            "positions of the B_i, a row each",
            "(3)",
            "m",
        ),
    ]


def pose_graph() -> Graph:
    """Everything of this section that follows from the pose."""
    graph = Graph(POSE)
    graph.add(constants())
    graph.add(platform_directions())
    graph.add([rotation(), *central_inverse(), central_direction()])
    for i in LIMBS:
        graph.add(limb_inverse(i))
        graph.add(limb_geometry(i))
    graph.add(collected())
    return graph


def central_graph() -> Graph:
    """(1), from the joint values of the central limb to the position of C."""
    graph = Graph((q4, q5, q6))
    graph.add(constants())
    graph.add(central_forward())
    return graph
