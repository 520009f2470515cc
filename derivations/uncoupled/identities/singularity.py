"""Section V: both determinants, derived from the matrices, factor by factor."""

from __future__ import annotations

from sympy import Basic, Expr, cos

from derivations.algebra.determinants import determinant, laplace
from derivations.algebra.identities import Identity
from derivations.algebra.screws import Klein
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import (
    Columns,
    Cross,
    Dot,
    Stack,
    components,
    matrix,
    scalar,
    vector,
)
from derivations.uncoupled.displacement import lam, q5, q6, r
from derivations.uncoupled.geometry import LIMBS, ROOT, base_i, base_j, base_k, c, m1, n1, nu
from derivations.uncoupled.identities.facts import (
    QUATERNION_RELATION,
    RADIAL,
    Facts,
    absolute,
    central_facts,
    directions,
    factor_facts,
    limb_forms,
    moment,
    named,
    own_directions,
    pose,
    scalars,
    span,
)
from derivations.uncoupled.singularity import (
    ORIENTATION,
    WRIST,
    central,
    orientation,
    product,
    wrist,
)
from derivations.uncoupled.velocity import ZERO, axis, screw

det_moments = scalar("det_moments")
MIDDLE = Cross(Cross(n1, vector("n2")), n1)


def identities() -> list[Identity]:
    """Factors, determinants, and the conditions (25) and (26)."""
    return [
        *factors(),
        inverse_blocks(),
        forward_blocks(),
        *determinants(),
        moments_in_platform(),
        *conditions(),
        printed_condition(),
        *wrist_screws(),
    ]


def limb_facts() -> tuple[Facts, tuple[Expr, ...]]:
    """q_i, |d_i − b_i| and the Klein forms of all limbs by p_i, l_i and rho_i."""
    facts, nonnegative = absolute(*(scalar(f"p{i}") for i in LIMBS))
    for i in LIMBS:
        for symbol in scalars("q limb", i):
            facts = {**facts, symbol: pose()[symbol.name].computed_as}
        facts = {**facts, **span(i)}
    return facts, nonnegative


def factors() -> list[Identity]:
    """Each factor as it is computed."""
    by_normal = {**central_facts(), nu: Cross(n1, m1)}
    moments = dict(own_directions() | directions())
    for i in LIMBS:
        moments |= moment(i)
    kept = named("p tau sigma", *LIMBS)
    return [
        computed_form(Unfolding(pose(), central_facts(), ("q6", "r")), "central"),
        computed_form(Unfolding(pose(), by_normal, ("n1", "m1", "c", "q6")), "wrist"),
        computed_form(Unfolding(pose(), {}, named("tau sigma", *LIMBS)), "tilt"),
        computed_form(Unfolding(pose(), moments, kept), "orientation", QUATERNION_RELATION),
        Identity(
            "central times wrist",
            "q6² cos q5 (n1×n2)·lambda = sqrt(c_x² + c_y²) (n1×n2)·c, finite at C = O too",
            lambda: [
                Unfolding(pose(), by_normal | factor_facts(), ("n1", "m1", "c", "q6", "r"))(
                    central * wrist - r * Dot(Cross(n1, vector("n2")), c)
                )
            ],
            number="(26)",
        ),
    ]


def inverse_blocks() -> Identity:
    """det J_q, off the 6×6 as printed."""
    forms = {
        Klein(screw(4, row), screw(4, column)): scalar(f"form_{row}{column}")
        for row in (4, 5, 6)
        for column in (1, 2, 3)
    }
    first_row = dict(zip(forms, (0, 0, 1), strict=False))
    unfold = Unfolding(pose(), limb_forms() | forms | first_row, named("limb", *LIMBS))

    def difference() -> list[Expr]:
        limbs = product(scalar(f"limb{i}") for i in LIMBS)
        condition = unfold(pose()["condition25"].expression)
        return [laplace(unfold(pose()["J_q"].expression)) - limbs * condition]

    return Identity(
        "det J_q by blocks",
        "det J_q = {S_1; $_1²} {S_2; $_2²} {S_3; $_3²} times the condition (25); the first row "
        "of (24) is (0, 0, 1) by the computed form of J_q",
        difference,
        number="(22)-(25)",
    )


def forward_blocks() -> Identity:
    """det J_v, off the 6×6 as printed."""
    unfold = Unfolding(pose(), {}, ("lambda", "n1", "n2", *named("S", *LIMBS)))
    lines = Columns(*(matrix(f"S{i}", 6, 1) for i in LIMBS))

    def difference() -> list[Expr]:
        primal = determinant(unfold(Columns(lam, n1, MIDDLE)))
        moments = determinant(unfold(lines).extract([3, 4, 5], [0, 1, 2]))
        return [laplace(unfold(pose()["J_v"].expression)) + primal * moments]

    return Identity(
        "det J_v by blocks",
        "det J_v = −det[lambda, n1, (n1×n2)×n1] det[moments of S_1, S_2, S_3]",
        difference,
        number="(18), (27)",
    )


def determinants() -> list[Identity]:
    """Both determinants as products of their factors."""
    facts, nonnegative = limb_facts()
    unfold = Unfolding(
        pose(),
        {**facts, WRIST: factor_facts()[wrist], cos(q5): r / q6},
        (*named("p l rho", *LIMBS), "nu", "c", "q6", "r"),
    )
    tilted = {ORIENTATION: pose()[orientation.name].computed_as}
    moments = Unfolding(pose(), {**facts, **tilted}, named("p e rho tau sigma", *LIMBS))
    factored = Unfolding(
        pose(),
        {det_moments: pose()[det_moments.name].expression, ORIENTATION: orientation, WRIST: wrist},
        (*named("b d e", *LIMBS), "orientation", "wrist"),
    )
    return [
        computed_form(unfold, "det_J_q", nonnegative),
        computed_form(moments, "det_moments", nonnegative),
        computed_form(factored, "det_J_v"),
    ]


def moments_in_platform() -> Identity:
    """The determinant of the moments of S_1, S_2, S_3 from their columns."""
    facts = {vector(f"so{i}"): pose()[f"so{i}"].computed_as for i in LIMBS} | own_directions()
    axes = dict(zip((n1, m1, nu), (base_i, base_j, base_k), strict=True))
    kept = named("e rho tau sigma", *LIMBS)
    base_frame = Unfolding(pose(), facts, (*kept, "n1", "m1", "nu"))
    platform_frame = Unfolding(pose(), facts | axes, kept)
    printed = Columns(*(vector(f"so{i}") for i in LIMBS))

    def difference() -> list[Basic]:
        entries = platform_frame(printed)
        return [
            base_frame(printed) - components(Columns(n1, m1, nu)) * entries,
            determinant(entries) - platform_frame(pose()["det_moments"].computed_as),
        ]

    return Identity(
        "determinant of moments",
        "det[moments of S_1, S_2, S_3] = √3/2 ∏(e_i/rho_i) (τ1 σ2 σ3 + τ2 σ3 σ1 + τ3 σ1 σ2), "
        "in the platform frame: the moments are a rotation times their components there",
        difference,
        number="(27)",
    )


def conditions() -> list[Identity]:
    """(25) and (26), its axis corrected."""
    in_vectors = Unfolding(pose(), {}, ("lambda", "n1", "n2", "axis", "c"))
    facts = {**central_facts(), MIDDLE: ROOT * m1, nu: Cross(n1, m1), **factor_facts()}
    factored = Unfolding(pose(), facts, ("n1", "m1", "c", "q6", "r"))
    condition = pose()["condition26"].expression
    return [
        Identity(
            "(26) from (25)",
            "(25) in vectors is (26) with the axis sin q4 i − cos q4 j",
            lambda: [in_vectors(pose()["condition25"].expression - condition)],
            number="(25), (26)",
        ),
        Identity(
            "(26) factored",
            "(26) with the axis sin q4 i − cos q4 j is q6² cos q5 (n1×n2)·lambda",
            lambda: [factored(condition) - factored(central * wrist)],
            RADIAL,
            "(25), (26)",
        ),
    ]


def printed_condition() -> Identity:
    """(26), its axis as printed."""
    printed = {axis: Dot(lam, base_i) * base_i + Dot(lam, base_j) * base_j}
    unfold = Unfolding(pose(), {**printed, c: q6 * lam}, ("lambda", "n1", "n2", "q6"))
    return Identity(
        "(26) as printed",
        "(26) with the axis λ_X i + λ_Y j, as printed, is zero at every pose",
        lambda: [unfold(pose()["condition26"].expression)],
        number="(26)",
    )


def wrist_screws() -> list[Identity]:
    """The 6×3 of the wrist screws: not always of Gram determinant 1."""
    middle = {MIDDLE: ROOT * m1}
    unfold = Unfolding(pose(), middle, ("lambda", "n1", "m1"))
    factor = Dot(Cross(n1, vector("n2")), lam)

    def gram() -> list[Expr]:
        screws = unfold(Columns(Stack(lam, ZERO), Stack(n1, ZERO), Stack(MIDDLE, ZERO)))
        return [determinant(screws.T * screws) - unfold(factor) ** 2]

    return [
        Identity(
            "wrist determinant",
            "det[lambda, n1, (n1×n2)×n1] = (n1×n2)·lambda",
            lambda: [determinant(unfold(Columns(lam, n1, MIDDLE))) - unfold(factor)],
            number="(27)",
        ),
        Identity(
            "wrist Gram determinant",
            "det(J̄_vᵀ J̄_v) = ((n1×n2)·lambda)², not 1",
            gram,
            number="(27)",
        ),
    ]
