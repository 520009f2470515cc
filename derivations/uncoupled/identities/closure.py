"""Section III: the closure equations (6) and their derivatives."""

from __future__ import annotations

from functools import cache

from sympy import Expr, ImmutableDenseMatrix

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Dot, component_symbols, components, vector
from derivations.uncoupled.closure import closure_graph
from derivations.uncoupled.geometry import LIMBS, a, n1
from derivations.uncoupled.identities.facts import named, pose, scalars, vectors


def identities() -> list[Identity]:
    """Each cone, its gradient, and how the six equations depend on n_1 and n_2."""
    return [*(proof for i in LIMBS for proof in cone(i)), system()]


@cache
def graph() -> Graph:
    return closure_graph()


def cone(i: int) -> list[Identity]:
    """F_i is (6) times p_i², and dF_i is its gradient."""
    (b,) = vectors("b", i)
    p, q, residual = scalars("p q F", i)
    n, gradient = vectors("n dF", i)
    by_pose = Unfolding(pose(), {}, named("n q", i))
    by_closure = Unfolding(graph(), {}, named("n", i))

    def slope() -> list[Expr]:
        value = by_closure(residual)
        return [by_closure(gradient)[k] - value.diff(x) for k, x in enumerate(components(n))]

    return [
        Identity(
            f"cone {i}",
            f"F_{i} = p_{i}² (b_{i}·b_{i} − a² − q_{i}²)",
            lambda: [by_pose(p**2 * (Dot(b, b) - a**2 - q**2)) - by_closure(residual)],
            number="(6)",
        ),
        Identity(
            f"cone {i} gradient", f"dF_{i} is the gradient of F_{i} in n_{i}", slope, (), "(6)"
        ),
    ]


def system() -> Identity:
    """The chain rule through n_3 = −n_1 − n_2."""
    directions = [*components(n1), *components(vector("n2"))]
    unfold = Unfolding(graph(), {}, named("F", *LIMBS) + named("dF", *LIMBS))
    third = Unfolding(graph(), {})

    def difference() -> list[ImmutableDenseMatrix]:
        residuals = unfold(graph()["F"].expression)
        rows = []
        for row, residual in enumerate(residuals):
            rows.append([slope(residual, row, x) for x in directions])
        return [unfold(graph()["dF"].expression) - ImmutableDenseMatrix(rows)]

    def slope(residual: Expr, row: int, x: Expr) -> Expr:
        if row >= 3:
            return residual.diff(x)
        own = components(vector(f"n{row + 1}"))
        partial = component_symbols(vector(f"dF{row + 1}"))
        value = own if row < 2 else third(vector("n3"))
        return sum(partial[k] * value[k].diff(x) for k in range(3))

    return Identity(
        "closure derivatives",
        "dF is the derivative of F by (n_1, n_2), n_3 = −n_1 − n_2",
        difference,
        number="(5), (6)",
    )
