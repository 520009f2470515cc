"""Section III: Newton's step on the rotation, and the fold of two assembly modes."""

from __future__ import annotations

from functools import cache
from itertools import product

from sympy import Basic, Expr, ImmutableDenseMatrix, cos, sin

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Dot, component_symbols, components, matrix, scalar, vector
from derivations.uncoupled.closure import LENGTHS, first, second
from derivations.uncoupled.correction import fold_graph, newton_graph, turn, volume
from derivations.uncoupled.displacement import q4, q5, q6
from derivations.uncoupled.geometry import LIMBS
from derivations.uncoupled.identities.facts import named

OMEGA = vector("omega")
NEXT = (vector("next1"), vector("next2"))
NAMES = named("G", *LIMBS)
JOINTS = (*LENGTHS, q4, q5, q6)


def identities() -> list[Identity]:
    """Derivatives, Newton's step, and the rotation that it is taken by."""
    return [*(gradient(i) for i in LIMBS), volume_gradient(), by_joints(), step(), rotation()]


@cache
def graph() -> Graph:
    return newton_graph()


@cache
def folds() -> Graph:
    return fold_graph()


def along_turn(value: Expr, *limbs: int) -> Expr:
    """The derivative of a value by a turn omega, under which n_i moves by omega × n_i."""
    moved = 0
    for i in limbs:
        n = components(vector(f"n{i}"))
        slide = components(OMEGA).cross(n)
        moved += sum(value.diff(x) * dx for x, dx in zip(n, slide, strict=True))
    return moved


def gradient(i: int) -> Identity:
    """G_i."""
    unfold = Unfolding(graph(), {}, named("n", *LIMBS))
    by_turn = vector(f"G{i}")
    return Identity(
        f"turn of cone {i}",
        f"F_{i} grows by G_{i}·omega where the platform turns by omega, n_{i} by omega × n_{i}",
        lambda: [unfold(Dot(by_turn, OMEGA)) - along_turn(unfold(scalar(f"F{i}")), i)],
        number="(6)",
    )


def volume_gradient() -> Identity:
    """The derivative of the triple product."""
    kept = named("n ht hz q", *LIMBS)
    by_limb, by_names = Unfolding(folds(), {}, kept), Unfolding(folds(), {}, NAMES + kept)

    def difference() -> list[Expr]:
        slope = 0
        for i in LIMBS:
            by_turn = vector(f"G{i}")
            changes = [along_turn(entry, i) for entry in by_limb(by_turn)]
            for name, change in zip(component_symbols(by_turn), changes, strict=True):
                slope += by_names(volume).diff(name) * change
        return [by_names(Dot(vector("dvolume"), OMEGA)) - slope]

    return Identity(
        "turn of the triple product",
        "dvolume is the derivative of G_1·(G_2 × G_3) by a turn of the platform",
        difference,
        number="(6)",
    )


def by_joints() -> Identity:
    """The derivatives by joint values."""
    unfold = Unfolding(folds(), {}, named("n", *LIMBS))

    def difference() -> list[Basic]:
        residuals = unfold(matrix("F", 3, 1))
        slopes = [[q * residual.diff(q) for q in JOINTS] for residual in residuals]
        return [unfold(matrix("qF", 3, 6)) - ImmutableDenseMatrix(slopes)]

    return Identity(
        "cones by joint values",
        "row i of qF is q_j ∂F_i/∂q_j, C where q_4, q_5, q_6 put it",
        difference,
        tuple(cos(q) ** 2 + sin(q) ** 2 - 1 for q in (q4, q5)),
        "(1), (6)",
    )


def step() -> Identity:
    """Newton's equations."""
    unfold = Unfolding(graph(), {}, named("F G", *LIMBS))
    return Identity(
        "Newton's turn",
        "G_i·turn = −F_i for every limb",
        lambda: [unfold(Dot(vector(f"G{i}"), turn) + scalar(f"F{i}")) for i in LIMBS],
        number="(6)",
    )


def rotation() -> Identity:
    """Cayley's rotation."""
    unfold = Unfolding(graph(), {}, ("half_turn", "n1", "n2"))
    pairs = list(product(zip(NEXT, (first, second), strict=True), repeat=2))
    return Identity(
        "Cayley's rotation",
        "the step keeps |n_1|, |n_2| and n_1·n_2",
        lambda: [unfold(Dot(left, right) - Dot(n, m)) for (left, n), (right, m) in pairs],
        number="(5)",
    )
