"""Section V: both determinants, factor by factor, with the size of their rounding.

A factor f counts as zero when ``|f| ≤ k eps scale(f)``. The scale is the sum of the terms
of f, each at the size that its inputs can have: 1 for a direction, |c| for the position and
a for the radius. It stands beside the factor, and k is the caller's.
"""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Abs, Expr, S, Symbol, cos

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.screws import Klein
from derivations.algebra.vectors import Cross, Dot, Norm, scalar, vector
from derivations.uncoupled.displacement import lam, q5, q6, r
from derivations.uncoupled.geometry import LIMBS, ROOT, a, base_k, c, n1, nu
from derivations.uncoupled.velocity import axis, screw, velocity_graph

central, wrist, orientation = scalar("central"), scalar("wrist"), scalar("orientation")
tilt, reach = scalar("tilt"), scalar("reach")

#: The factors of the determinants, in vectors.
CENTRAL = q6**2 * cos(q5)
WRIST = Dot(Cross(n1, vector("n2")), lam)
FIRST, SECOND, THIRD = (Cross(vector(f"n{i}"), vector(f"d{i}") - c) for i in LIMBS)
ORIENTATION = Dot(FIRST, Cross(SECOND, THIRD))


def per_limb(name: str) -> list[Symbol]:
    """The scalars of that name, one a limb."""
    return [scalar(f"{name}{i}") for i in LIMBS]


def product(factors: Iterable[Expr]) -> Expr:
    """Their product."""
    result = S.One
    for factor in factors:
        result *= factor
    return result


def inverse_condition() -> list[Equation]:
    """(25) and (26), the second corrected: the axis is sin q4 i − cos q4 j."""
    second = Cross(Cross(n1, vector("n2")), n1)

    def condition(first_a: Expr, second_b: Expr, second_a: Expr, first_b: Expr) -> Expr:
        return first_a * second_b - second_a * first_b

    return [
        Equation(
            scalar("condition25"),
            condition(
                Klein(screw(4, 5), screw(4, 1)),
                Klein(screw(4, 6), screw(4, 2)),
                Klein(screw(4, 6), screw(4, 1)),
                Klein(screw(4, 5), screw(4, 2)),
            ),
            "condition of inverse singularity, in Klein forms",
            "(25)",
            "m²",
        ),
        Equation(
            scalar("condition26"),
            condition(
                Dot(n1, Cross(base_k, c)),
                Dot(second, Cross(axis, c)),
                Dot(second, Cross(base_k, c)),
                Dot(n1, Cross(axis, c)),
            ),
            "condition of inverse singularity, in vectors",
            "(26)",
            "m²",
        ),
    ]


def tilt_parts() -> list[Equation]:
    """The three terms of ``tilt``, product by product.

    With a name for each product every kernel rounds them alike: what is zero for one of them is
    zero for all, whatever else they share.
    """
    equations = []
    for i in LIMBS:
        j, k = i % 3 + 1, (i + 1) % 3 + 1
        pair, part = scalar(f"sigma_pair{i}"), scalar(f"tilt_part{i}")
        both = scalar(f"sigma{j}") * scalar(f"sigma{k}")
        term = scalar(f"tau{i}") * pair
        equations += [
            Equation(pair, both, f"sigma of the limbs beside {i}", unit="m²"),
            Equation(part, term, f"term {i} of tilt", "(27)", "m³"),
        ]
    return equations


def factors() -> list[Equation]:
    """The factors of both determinants that can vanish."""
    (t1, t2, t3), (s1, s2, s3) = per_limb("tau"), per_limb("sigma")
    return [
        *tilt_parts(),
        Equation(central, CENTRAL, "central limb: q6² cos q5", "(26)", "m²", computed_as=q6 * r),
        Equation(
            wrist,
            WRIST,
            "wrist: the central limb in the platform's plane",
            "(26), (27)",
            computed_as=ROOT * Dot(nu, c) / q6,
        ),
        Equation(
            tilt,
            t1 * s2 * s3 + t2 * s3 * s1 + t3 * s1 * s2,
            "the three lines S_i in the platform frame",
            "(27)",
            "m³",
            computed_as=sum(per_limb("tilt_part")),
        ),
        Equation(
            orientation,
            ORIENTATION,
            "orientation: the moments of B_iD_i about C are coplanar",
            "(27)",
            "m³",
            computed_as=ROOT * tilt / product(per_limb("p")) ** 2,
        ),
    ]


def determinants() -> list[Equation]:
    """det J_q, det J_v, and the determinant of the 3×3 that gives the angular velocity."""
    spans = [Norm(vector(f"d{i}") - vector(f"b{i}")) for i in LIMBS]
    e, rho, limb = map(per_limb, ("e", "rho", "limb"))
    ratio = product(e_i / span for e_i, span in zip(e, spans, strict=True))
    return [
        Equation(
            scalar("det_J_q"),
            -product(q / span for q, span in zip(per_limb("q"), spans, strict=True))
            * CENTRAL
            * WRIST,
            "determinant of the inverse Jacobian",
            "(22)-(26)",
            "m²",
            computed_as=product(limb) * r * ROOT * Dot(nu, c),
        ),
        Equation(
            scalar("det_moments"),
            ratio * ORIENTATION,
            "determinant of the moments of S_1, S_2, S_3",
            "(27)",
            "m³",
            computed_as=ROOT * product(e) * tilt / product(rho),
        ),
        Equation(
            scalar("det_J_v"),
            -ratio * ORIENTATION * WRIST,
            "determinant of the forward Jacobian",
            "(27)",
            "m³",
            computed_as=-scalar("det_moments") * wrist,
        ),
    ]


def scales() -> list[Equation]:
    """The sizes against which rounding is judged."""
    equations = [Equation(reach, a + 2 * q6, "largest length in a leg's equations", unit="m")]
    sensitivity = 0
    for i in LIMBS:
        j, k = i % 3 + 1, (i + 1) % 3 + 1
        p, length, rho = (scalar(f"{name}{i}") for name in ("p", "l", "rho"))
        sj, sk = Abs(scalar(f"sigma{j}")), Abs(scalar(f"sigma{k}"))
        tj, tk = Abs(scalar(f"tau{j}")), Abs(scalar(f"tau{k}"))
        sensitivity += sj * sk + tj * sk + tk * sj
        equations += [
            Equation(scalar(f"limb_scale{i}"), length / rho, f"scale of limb {i}'s Klein form"),
            Equation(scalar(f"e_scale{i}"), (a + q6) / Abs(p), f"scale of e{i}", unit="m"),
        ]
    return [
        *equations,
        Equation(scalar("central_scale"), q6**2, "scale of the central factor", unit="m²"),
        Equation(scalar("wrist_scale"), ROOT, "scale of the wrist factor"),
        Equation(
            scalar("orientation_scale"),
            ROOT * reach * sensitivity / product(per_limb("p")) ** 2,
            "scale of the orientation factor",
            unit="m³",
        ),
    ]


def singularity_graph() -> Graph:
    """Both determinants, their factors and the scales of those."""
    graph = velocity_graph()
    graph.add(inverse_condition())
    graph.add(factors())
    graph.add(determinants())
    graph.add(scales())
    return graph
