"""Section IV: screws, reciprocal lines and Jacobians.

The line S_i is normal to n_i, so it has two components in the platform frame,
``p_i² (d_i − b_i) = τ_i m_i + σ_i ν``. With them everything that the paper leaves without a
closed form (the 3×3 of the forward velocity analysis, det J_v) becomes a short sum.
"""

from __future__ import annotations

from sympy import Abs, Expr, ImmutableDenseMatrix, MatrixSymbol, S, ZeroMatrix, cos, sin, sqrt

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Klein, Screw, cylindrical, line, prismatic, revolute
from derivations.algebra.vectors import Columns, Cross, Dot, Norm, Rows, matrix, scalar, vector
from derivations.uncoupled.displacement import lam, pose_graph, q4
from derivations.uncoupled.geometry import (
    LIMBS,
    POSE,
    ROOT,
    base_i,
    base_j,
    base_k,
    c,
    m1,
    n1,
    nu,
)

#: A horizontal vector at the azimuth q4: (c_x, c_y), unless C lies on the Z axis.
heading = matrix("heading", 2, 1)
#: Axis of the second joint of the central limb.
axis = vector("axis")
ZERO = ZeroMatrix(3, 1)


def screw(limb: int | str, joint: int) -> MatrixSymbol:
    """The screw of a joint; the paper writes joint 1 of limb 4 as ⁰$₄¹."""
    return matrix(f"screw{limb}{joint}", 6, 1)


def central_screws() -> list[Equation]:
    """The six screws of the central limb, pole C."""
    hx, hy = heading[0, 0], heading[1, 0]
    planar = sqrt(hx**2 + hy**2)
    middle = Cross(Cross(n1, vector("n2")), n1)
    screws = [
        (revolute(base_k, c), None, "lower revolute, actuated by q4"),
        (revolute(axis, c), None, "second revolute, actuated by q5"),
        (prismatic(lam), None, "prismatic joint, actuated by q6"),
        (revolute(lam, ZERO), Screw(lam, ZERO), "revolute along the central limb"),
        (revolute(n1, ZERO), Screw(n1, ZERO), "universal joint, first axis"),
        (revolute(middle, ZERO), Screw(ROOT * m1, ZERO), "universal joint, second axis"),
    ]
    return [
        Equation(
            axis,
            sin(q4) * base_i - cos(q4) * base_j,
            "axis of the second revolute of the central limb",
            "Section IV",
            computed_as=(hy / planar) * base_i - (hx / planar) * base_j,
        )
    ] + [
        Equation(screw(4, joint), paper, words, "Section IV", "1, m", computed_as=computed)
        for joint, (paper, computed, words) in enumerate(screws, start=1)
    ]


def outer_screws(i: int | str) -> list[Equation]:
    """The six screws of an outer limb, pole C; b_i − c = e_i n_i."""
    n, u, t, w = (vector(f"{name}{i}") for name in "nutw")
    q, gt, gz = (scalar(f"{name}{i}") for name in ("q", "gt", "gz"))
    a_i, b, e, hinge = vector(f"a{i}"), vector(f"b{i}"), scalar(f"e{i}"), vector(f"nw{i}")
    rotation, translation = cylindrical(n, ZERO)
    screws = [
        (revolute(u, c - a_i), None, "base revolute"),
        (prismatic(w), None, f"prismatic joint, actuated by q{i}"),
        (revolute(w, c - b), Screw(w, Cross(w, c - a_i)), "revolute along the leg"),
        (revolute(hinge, c - b), Screw(hinge, e * Cross(n, hinge)), "upper revolute"),
        (rotation, Screw(n, ZERO), "cylindrical joint, rotation"),
        (translation, None, "cylindrical joint, translation"),
    ]
    return [
        Equation(
            hinge,
            Cross(n, w),
            "axis of the upper revolute, not a unit vector",
            "Section IV",
            # Along u_i the vector product cancels where the leg is parallel to n_i.
            computed_as=(
                (Dot(n, t) * Dot(c, base_k) - Dot(n, base_k) * Dot(c, t)) * u + gt * base_k - gz * t
            )
            / q,
        )
    ] + [
        Equation(screw(i, joint), paper, words, "Section IV", "1, m", computed_as=computed)
        for joint, (paper, computed, words) in enumerate(screws, start=1)
    ]


def reciprocal_line(i: int | str) -> list[Equation]:
    """(14), (23): the line S_i from B_i to D_i and its Klein form with the actuated screw."""
    m, t = vector(f"m{i}"), vector(f"t{i}")
    b, d = vector(f"b{i}"), vector(f"d{i}")
    e, p, gt, gz, length = (scalar(f"{name}{i}") for name in ("e", "p", "gt", "gz", "l"))
    tau, sigma, rho = (scalar(f"{name}{i}") for name in ("tau", "sigma", "rho"))
    s, moment = vector(f"s{i}"), vector(f"so{i}")
    direction = (d - b) / Norm(d - b)
    return [
        Equation(
            tau,
            p**2 * Dot(d - b, m),
            "p_i² times the part of B_iD_i in the platform's plane",
            unit="m",
            computed_as=gz * Dot(nu, t) - gt * Dot(nu, base_k),
        ),
        Equation(
            sigma,
            p**2 * Dot(d - b, nu),
            "p_i² times the part of B_iD_i normal to the platform",
            unit="m",
            computed_as=gt * Dot(m, base_k) - gz * Dot(m, t),
        ),
        Equation(
            rho,
            p**2 * Norm(d - b),
            "p_i² times the distance from B_i to D_i",
            unit="m",
            computed_as=sqrt(tau**2 + sigma**2),
        ),
        Equation(
            s,
            direction,
            "unit vector from B_i to D_i",
            "(14)",
            computed_as=(tau * m + sigma * nu) / rho,
        ),
        Equation(
            moment,
            Cross(direction, c - b),
            "moment of S_i about C",
            "(14)",
            "m",
            computed_as=e * (tau * nu - sigma * m) / rho,
        ),
        Equation(
            matrix(f"S{i}", 6, 1),
            line(direction, c - b),
            "reciprocal line from B_i to D_i",
            "(14)",
            "1, m",
            computed_as=Screw(s, moment),
        ),
        Equation(
            scalar(f"limb{i}"),
            Klein(matrix(f"S{i}", 6, 1), screw(i, 2)),
            "Klein form of S_i and the actuated screw",
            "(15), (23)",
            computed_as=-Abs(p) * length / rho,
        ),
    ]


def jacobians() -> list[Equation]:
    """(18), (19): the forward and the inverse Jacobian, ``J_vᵀ Δ V = J_q q̇`` (17)."""
    lines = [matrix(f"S{i}", 6, 1) for i in LIMBS]
    wrist = [screw(4, joint) for joint in (4, 5, 6)]
    actuated = [screw(4, joint) for joint in (1, 2, 3)]

    def entry(row: int, column: int) -> Expr:
        if row < 3:
            return Klein(lines[row], screw(row + 1, 2)) if row == column else S.Zero
        return Klein(wrist[row - 3], actuated[column - 3]) if column >= 3 else S.Zero

    def computed(row: int, column: int) -> Expr:
        if row < 3:
            return scalar(f"limb{row + 1}") if row == column else S.Zero
        if row == 3:
            return S.One if column == 5 else S.Zero
        return entry(row, column)

    return [
        Equation(
            matrix("J_v", 6, 6),
            Columns(*lines, *wrist),
            "forward Jacobian matrix",
            "(18), (27)",
            "1, m",
        ),
        Equation(
            matrix("J_q", 6, 6),
            ImmutableDenseMatrix(6, 6, entry),
            "inverse Jacobian matrix",
            "(19), (22)-(24)",
            "1, m",
            computed_as=ImmutableDenseMatrix(6, 6, computed),
        ),
    ]


def arrays() -> list[Equation]:
    """Rows of d_i, w_i, S_i and of the screws, as kernels return them."""

    def rows(name: str, size: int, entries: list) -> Equation:
        return Equation(matrix(name, len(entries), size), Rows(*entries), f"{name}, a row each")

    families = [(name, 3, [vector(f"{name.lower()}{i}") for i in LIMBS]) for name in "DW"]
    families += [("S", 6, [matrix(f"S{i}", 6, 1) for i in LIMBS])]
    families += [
        (f"screws{limb}", 6, [screw(limb, joint) for joint in range(1, 7)]) for limb in (*LIMBS, 4)
    ]
    return [rows(*family) for family in families]


def velocity_graph() -> Graph:
    """Everything of this section that follows from the pose."""
    graph = pose_graph()
    graph.leaves = (*POSE, heading)
    graph.add(central_screws())
    for i in LIMBS:
        graph.add(outer_screws(i))
        graph.add(reciprocal_line(i))
    graph.add(jacobians())
    graph.add(arrays())
    return graph
