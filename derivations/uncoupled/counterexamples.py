"""Printed claims that fail, each at a pose in exact numbers.

A check computes the pose from the forms that the paper prints, over the rational numbers
and √3, and returns the facts that contradict the claim.
"""

from __future__ import annotations

from functools import cache

from sympy import (
    Basic,
    Expr,
    ImmutableDenseMatrix,
    Integer,
    Matrix,
    Rational,
    cos,
    expand,
    linsolve,
    radsimp,
    sin,
    sqrt,
    symbols,
)
from sympy.polys.matrices import DomainMatrix

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Counterexample, IdentityError
from derivations.algebra.screws import Klein, line
from derivations.algebra.unfolding import QUATERNION, Unfolding, quaternion_rotation
from derivations.algebra.vectors import Columns, Cross, Dot, Norm, scalar, vector
from derivations.uncoupled.displacement import lam, q4, q5, q6
from derivations.uncoupled.geometry import LIMBS, a, base_i, base_j, c, m1, n1, nu
from derivations.uncoupled.singularity import central, orientation, singularity_graph, wrist
from derivations.uncoupled.velocity import axis, heading, screw

N2 = vector("n2")
MIDDLE = Cross(Cross(n1, N2), n1)
E1, B1 = scalar("e1"), vector("b1")
#: 3/5 and 4/5: an angle of which sine and cosine are rational.
SHORT, LONG = Rational(3, 5), Rational(4, 5)
Facts = dict[str, Expr]


@cache
def graph() -> Graph:
    return singularity_graph()


def about_z(cosine: Expr, sine: Expr) -> ImmutableDenseMatrix:
    return ImmutableDenseMatrix([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])


def about_y(cosine: Expr, sine: Expr) -> ImmutableDenseMatrix:
    return ImmutableDenseMatrix([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]])


LEVEL, PITCHED, UPRIGHT = about_z(1, 0), about_y(SHORT, LONG), about_y(0, 1)


def exact(number: Expr) -> Expr:
    """One form for every number of Q(√3), so that zero is recognised."""
    return expand(radsimp(expand(number)))


def at_pose(rotation: ImmutableDenseMatrix, position: tuple) -> Unfolding:
    """Evaluates expressions at a pose with a = 1, by the printed forms."""
    facts: dict[Basic, Basic] = {
        symbol: rotation[:, column] for column, symbol in enumerate((n1, m1, nu))
    }
    facts |= {c: ImmutableDenseMatrix(position), a: Integer(1)}
    facts |= {heading[row, 0]: facts[c][row] for row in range(2)}
    return Unfolding(graph(), facts, settle=exact)


def ensure(facts: Facts, **conditions: bool) -> Facts:
    """Return the facts, unless a condition on them fails: then they contradict nothing."""
    for name, holds in conditions.items():
        if not holds:
            raise IdentityError(f"the counter-example fails, {name}: {facts}")
    return facts


def rank(points: list[Matrix]) -> int:
    """Dimension of what the points span: 1 a line, 2 a plane, 3 space."""
    edges = Matrix.hstack(*(point - points[0] for point in points[1:]))
    return DomainMatrix.from_Matrix(edges, extension=True).to_field().rank()


def coplanar_lines() -> Facts:
    """B_1, B_2, B_3 on a line that misses C, the D_i on a parallel to it.

    Without roll m_1 is horizontal. e_2 = e_3 = −2 e_1 puts the B_i on a parallel to m_1, and
    for one height of C the D_i are too.
    """
    rotation = about_z(LONG, SHORT) * about_y(SHORT, -LONG)
    value = at_pose(rotation, (Rational(8, 5), Rational(-3, 10), 1))
    ends = [value(vector(f"{name}{i}")) for name in "bd" for i in LIMBS]
    facts = {f"e_{i}": value(scalar(f"e{i}")) for i in LIMBS}
    facts |= {"span of lines": rank(ends), "span with C": rank([*ends, value(c)])}
    facts |= {"orientation": value(orientation), "wrist": value(wrist)}
    return ensure(
        facts,
        coplanar=facts["span of lines"] == 2,
        beside=facts["span with C"] == 3,
        regular=all(facts[name] != 0 for name in ("e_1", "e_2", "e_3", "orientation", "wrist")),
    )


def lines_through_origin() -> Facts:
    """Every D_i = O: three linear equations (p_i n_i − u_i)·c = −a for the position."""
    euler = dict(zip(QUATERNION, (2, 1, 1, 0), strict=True))
    rotation = quaternion_rotation().subs(euler) / 6
    unknown = symbols("x y z")
    anywhere = at_pose(rotation, unknown)
    rows = [
        anywhere(Dot(scalar(f"p{i}") * vector(f"n{i}") - vector(f"u{i}"), c) + a) for i in LIMBS
    ]
    (position,) = linsolve([expand(row) for row in rows], unknown)
    value = at_pose(rotation, tuple(exact(entry) for entry in position))
    facts = {f"delta_{i}": value(scalar(f"delta{i}")) for i in LIMBS}
    facts |= {f"e_{i}": value(scalar(f"e{i}")) for i in LIMBS}
    facts |= {f"p_{i}": value(scalar(f"p{i}")) for i in LIMBS}
    facts["sum of e"] = exact(facts["e_1"] + facts["e_2"] + facts["e_3"])
    signs = {bool(facts[f"e_{i}"] > 0) for i in LIMBS}
    return ensure(
        facts,
        concurrent=all(facts[f"delta_{i}"] == 0 for i in LIMBS),
        finite=all(facts[f"p_{i}"] != 0 for i in LIMBS),
        mixed=signs == {True, False} and facts["sum of e"] == 0,
    )


def printed_diagonal() -> Facts:
    """(23): off the plane of symmetry of a pitched platform limbs 2 and 3 differ."""
    value = at_pose(PITCHED, (Rational(1, 4), Rational(1, 5), 1))
    second, third = (value(scalar(f"limb{i}")) for i in (2, 3))
    entry = value(graph()["J_q"].expression)[1, 1]
    facts = {"{S_2; ¹$_2²}²": exact(second**2), "{S_3; ¹$_3²}²": exact(third**2)}
    facts["square of the second entry of J_q"] = exact(entry**2)
    other, printed, true = facts.values()
    return ensure(facts, index=entry == second and other == true != printed)


def vanishing_diagonal() -> Facts:
    """n_1·u_1 = 0 = a − c·u_1: e_1 is free, D_1 is at infinity and S_1 parallel to u_1."""
    value = at_pose(UPRIGHT, (1, Rational(1, 2), 2))
    u, n, w = vector("u1"), vector("n1"), vector("w1")
    free = {E1: Integer(1), scalar("q1"): Norm(B1 - vector("a1"))}
    pose = {c: value(c), n1: value(n1), m1: value(m1), nu: value(nu), a: Integer(1)}
    limb = Unfolding(graph(), pose | free, settle=exact)
    passive = [limb(Klein(line(u, c - B1), screw(1, joint))) for joint in (1, 3, 4, 5, 6)]
    facts = {"n·u": limb(Dot(n, u)), "a − c·u": limb(a - Dot(c, u)), "q_1": limb(scalar("q1"))}
    root = sqrt(Dot(n, u) ** 2 + Dot(n, w) ** 2)
    facts["root"] = limb(root)
    facts["diagonal"] = exact(-abs(facts["n·u"]) / facts["root"])
    facts["Klein form"] = limb(Klein(line(u, c - B1), screw(1, 2)))
    return ensure(
        facts,
        finite=facts["q_1"] > 0 and facts["root"] > 0,
        reciprocal=all(form == 0 for form in passive),
        vanishing=facts["diagonal"] == 0 == facts["Klein form"],
    )


def wrist_gram() -> Facts:
    """Central limb at the elevation of sine 4/5, platform level."""
    value = at_pose(LEVEL, (SHORT, 0, LONG))
    screws = value(Columns(lam, n1, MIDDLE))
    facts = {"det(J̄_vᵀ J̄_v)": exact((screws.T * screws).det()), "wrist": value(wrist)}
    gram = facts["det(J̄_vᵀ J̄_v)"]
    return ensure(facts, other=gram != 1, square=exact(gram - facts["wrist"] ** 2) == 0)


def printed_rotation() -> Facts:
    """(8) at a pitched platform."""
    value = at_pose(PITCHED, (0, 0, 1))
    facts = {"det R": exact(value(Columns(n1, MIDDLE, Cross(n1, N2))).det())}
    return ensure(facts, no_rotation=facts["det R"] == Rational(3, 4))


def printed_extension() -> Facts:
    """(4): the left side is a vector of another length than the right side."""
    value = at_pose(LEVEL, (Rational(1, 4), Rational(1, 5), 1))
    quotient = (a - Dot(c, vector("u1"))) / Dot(n1, vector("u1"))
    facts = {"right side": value(quotient), "e_1": value(Dot(B1 - c, n1))}
    facts["|b_1|²"] = value(Dot(B1, B1))
    return ensure(
        facts,
        distance=facts["right side"] == facts["e_1"],
        no_position=facts["|b_1|²"] != facts["right side"] ** 2,
    )


def printed_condition() -> Facts:
    """(26) is zero with the printed axis, while det J_q is not."""
    value = at_pose(PITCHED, (SHORT, 0, LONG))
    printed = {axis: Dot(lam, base_i) * base_i + Dot(lam, base_j) * base_j}
    condition = graph()["condition26"].expression
    facts = {"(26) as printed": value(condition.xreplace(printed))}
    facts["(26) with the axis of Section IV"] = value(condition)
    facts |= {f"limb {i}": value(graph()[f"limb{i}"].expression) for i in LIMBS}
    facts |= {"central": value(central), "wrist": value(wrist)}
    factors = [facts[f"limb {i}"] for i in LIMBS] + [facts["central"], facts["wrist"]]
    return ensure(
        facts,
        printed_vanishes=facts["(26) as printed"] == 0,
        regular=all(factor != 0 for factor in factors),
    )


def tilted_and_singular() -> Facts:
    """The central limb in the platform's plane, and no longer than zero: neither vertical."""
    in_plane = at_pose(PITCHED, (SHORT, 0, -LONG))
    facts = {"wrist": in_plane(wrist), "central": in_plane(central)}
    facts["cos q5, in plane"] = in_plane(cos(q5))
    facts["(25), in plane"] = in_plane(graph()["condition25"].expression)
    joints = {q6: Integer(0), c: q6 * lam, lam: LONG * base_i + SHORT * vector("k")}
    angles = {cos(q4): Integer(1), sin(q4): Integer(0), cos(q5): LONG, sin(q5): SHORT}
    frame = {n1: PITCHED[:, 0], m1: PITCHED[:, 1], nu: PITCHED[:, 2]}
    short = Unfolding(graph(), joints | angles | frame, settle=exact)
    facts["cos q5, q6 = 0"] = short(cos(q5))
    facts["(25), q6 = 0"] = short(graph()["condition25"].expression)
    return ensure(
        facts,
        in_plane=facts["wrist"] == 0 == facts["(25), in plane"] and facts["central"] != 0,
        short=facts["(25), q6 = 0"] == 0,
        tilted=facts["cos q5, in plane"] != 0 != facts["cos q5, q6 = 0"],
    )


REFUTED = (
    Counterexample(
        "(4) as printed",
        "b_i = (a − c·u_i)/(n_i·u_i)",
        "e_i = (a − c·u_i)/(n_i·u_i), the signed distance from C to B_i; b_i = c + e_i n_i (3)",
        printed_extension,
        "(4)",
    ),
    Counterexample(
        "(8) as printed",
        "R = [n_1, (n_1×n_2)×n_1, n_1×n_2]",
        "the second and the third column have norm √3/2 and must be divided by it",
        printed_rotation,
        "(8)",
    ),
    Counterexample(
        "(23) as printed",
        "J̃_q = diag[{S_1; ¹$_1²}, {S_3; ¹$_3²}, {S_3; ¹$_3²}]",
        "the second entry is {S_2; ¹$_2²}, as (15) and (22) have it",
        printed_diagonal,
        "(23)",
    ),
    Counterexample(
        "diagonal of (23)",
        "no element of the diagonal of J̃_q can vanish",
        "element i is −|n_i·u_i| / √((n_i·u_i)² + (n_i·w_i)²); it vanishes at finite joint values "
        "where n_i·u_i = 0 = a − c·u_i",
        vanishing_diagonal,
        "Section V, on (23)",
    ),
    Counterexample(
        "vertical limb only",
        "det J̄_q vanishes, for example, when the central limb is vertical",
        "that is one case of three: (25) is q6² cos q5 (n_1×n_2)·λ = 0",
        tilted_and_singular,
        "Section V, on (25)",
    ),
    Counterexample(
        "(26) as a condition",
        "the axis of the second revolute is λ_X i + λ_Y j, and (26) the condition of inverse "
        "singularity",
        "the axis is sin q4 i − cos q4 j, as in Section IV; with the printed one (26) vanishes at "
        "every pose",
        printed_condition,
        "(26)",
    ),
    Counterexample(
        "wrist Gram determinant",
        "det(J̄_vᵀ J̄_v) = 1: the central limb causes no direct singularity",
        "it is ((n_1×n_2)·λ)² with the paper's own screws; the factor also divides det J_q and "
        "cancels in the velocity map",
        wrist_gram,
        "Section V, on (27)",
    ),
    Counterexample(
        "coplanar lines S",
        "the manipulator is at a direct singularity if the lines S_i are coplanar",
        "if C lies in their plane, as it does when every e_i > 0; else only if they are also "
        "parallel or meet in a point",
        coplanar_lines,
        "Section V, on (27)",
    ),
    Counterexample(
        "lines S through O",
        "the lines S_i cannot all meet at O",
        "they can, with e_i of both signs and Σ e_i = 0; never when every e_i > 0",
        lines_through_origin,
        "Section V, on (27)",
    ),
)


def counterexamples() -> list[Counterexample]:
    """Every refuted claim, in the order of the paper."""
    return list(REFUTED)
