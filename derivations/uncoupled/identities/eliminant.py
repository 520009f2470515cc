"""Section III: one unknown, the angle of leg 1, and the resultant that is left of (6)."""

from __future__ import annotations

from functools import cache

from sympy import Basic, Expr, ImmutableDenseMatrix, symbols

from derivations.algebra.determinants import laplace, sylvester
from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import (
    Cross,
    Dot,
    Norm,
    component_symbols,
    components,
    scalar,
    vector,
)
from derivations.uncoupled.closure import LENGTHS, closure_graph, third
from derivations.uncoupled.eliminant import (
    K2,
    K3,
    Z,
    arm,
    cosine,
    eliminant,
    eliminant_graph,
    f,
    g,
    powers,
    reference,
    sine,
    turn_graph,
    x,
    y,
)
from derivations.uncoupled.geometry import a, n1
from derivations.uncoupled.identities.facts import QUATERNION_RELATION, ROTATION, Facts, named

#: Lengths that the frame divides by.
SPAN, ACROSS = symbols("span across_size", positive=True)
#: Two values of the ratio y/x.
LEFT, RIGHT = symbols("X Y", real=True)


def identities() -> list[Identity]:
    """The frame, the quartics, and their Bezoutian."""
    return [
        leg(),
        frame(),
        *(quartic(i) for i in (2, 3)),
        turned(),
        bezoutian(),
        resultant(),
        adjugate(),
    ]


@cache
def graph() -> Graph:
    return eliminant_graph()


def leg() -> Identity:
    """Limb 1 closes at any angle of its leg."""
    by_angle = Unfolding(graph(), {Norm(arm): SPAN})
    unfold = Unfolding(closure_graph(), {n1: by_angle(n1)})

    def difference() -> list[Expr]:
        way = by_angle(arm - a * vector("u1")) + components(vector("c"))
        length = sum(entry**2 for entry in way) - LENGTHS[0] ** 2
        return [length, unfold(scalar("F1"))]

    return Identity(
        "limb 1 by its angle",
        "|b_1 − a_1| = q_1 and F_1 = 0 at every angle theta",
        difference,
        (cosine**2 + sine**2 - 1,),
        "(6)",
    )


def frame() -> Identity:
    """[n_1, f, g] is a rotation."""
    across = vector("across")
    direct = Unfolding(graph(), {Norm(arm): SPAN}, ("arm",))
    lengths: Facts = {Cross(reference, n1): across, Norm(Cross(reference, n1)): ACROSS}
    normal = Unfolding(graph(), lengths, ("n1", "across"))
    in_frame = Unfolding(graph(), {}, ("n1", "f"))

    def difference() -> list[Expr]:
        gram = Dot(n1, n1).expanded() * Dot(f, f).expanded() - Dot(n1, f).expanded() ** 2
        return [
            direct(Dot(n1, n1)) - 1,
            normal(Dot(f, f)) - 1,
            components(Dot(n1, Cross(reference, n1))),
            in_frame(Dot(g, n1)),
            in_frame(Dot(g, f)),
            in_frame(Dot(g, g)) - gram,
            in_frame(Dot(n1, Cross(f, g))) - gram,
        ]

    relations = ((SPAN, arm), (ACROSS, across))
    return Identity(
        "frame of leg 1",
        "n_1, f, g are unit vectors normal to each other, and right-handed",
        difference,
        tuple(size**2 - components(Dot(each, each)) for size, each in relations),
        "(3)",
    )


def directions() -> dict[int, Basic]:
    """n_2 and n_3 in the frame and the half angle."""
    second = components(turn_graph()["n2"].expression)
    return {2: second, 3: -components(n1) - second}


def quartic(i: int) -> Identity:
    """K_i is F_i in the half angle."""
    kept = (*named("ht hz q", i), "n1", "f", "g")
    printed = Unfolding(graph(), {}, kept)
    unfold = Unfolding(closure_graph(), {vector(f"n{i}"): directions()[i]}, kept)

    def difference() -> list[Expr]:
        terms = [k * x ** (4 - j) * y**j for j, k in enumerate(printed(graph()[f"K{i}"].symbol))]
        return [sum(terms) - (x**2 + y**2) ** 2 * unfold(scalar(f"F{i}"))]

    return Identity(
        f"quartic {i}",
        f"K_{i} at (x, y) is (x² + y²)² F_{i} at the platform turned by phi about n_1, "
        "cos phi = (x² − y²)/(x² + y²), sin phi = 2xy/(x² + y²)",
        difference,
        number="(5), (6)",
    )


def turned() -> Identity:
    """The directions fulfil (5)."""
    any_frame = {n1: ROTATION[:, 0], f: ROTATION[:, 1], g: ROTATION[:, 2]}
    by_frame = Unfolding(turn_graph(), dict(any_frame))
    unfold = Unfolding(closure_graph(), {n1: ROTATION[:, 0], vector("n2"): by_frame(vector("n2"))})
    return Identity(
        "turned directions",
        "n_1, n_2, n_3 = −n_1 − n_2 are unit vectors, and n_1, n_2 are 120° apart",
        lambda: [
            *(unfold(scalar(f"F{index}")) for index in (4, 5, 6)),
            unfold(Dot(third, third)) - 1,
        ],
        QUATERNION_RELATION,
        "(5)",
    )


def polynomial(symbol: Basic, value: Expr) -> Expr:
    """A quartic at y/x = value."""
    return sum(symbol[k, 0] * value**k for k in range(5))


def bezoutian() -> Identity:
    """Z is the Bezoutian; at a common zero of both quartics its powers span the kernel of Z."""
    unfold = Unfolding(graph(), {}, ("K2", "K3"))

    def difference() -> list[Expr]:
        entries = unfold(Z)
        form = sum(entries[i, j] * LEFT**i * RIGHT**j for i in range(4) for j in range(4))
        left, right = (
            [components(polynomial(symbol, value)) for symbol in (K2, K3)]
            for value in (LEFT, RIGHT)
        )
        determinant = left[0] * right[1] - right[0] * left[1]
        return [form * (RIGHT - LEFT) - determinant, *(entries - entries.T)]

    return Identity(
        "Bezoutian",
        "Σ Z_ij X^i Y^j (Y − X) = K_2(X) K_3(Y) − K_2(Y) K_3(X), and Z is symmetric",
        difference,
        number="(6)",
    )


def resultant() -> Identity:
    """The eliminant is the resultant of both quartics."""
    unfold = Unfolding(graph(), {}, ("K2", "K3"))
    rows = sylvester(*(list(component_symbols(symbol)) for symbol in (K2, K3)))
    return Identity(
        "eliminant",
        "det Z is the resultant of K_2 and K_3, the determinant of their Sylvester matrix",
        lambda: [unfold(eliminant) - laplace(rows)],
        number="(6)",
    )


def adjugate() -> Identity:
    """Where det Z = 0, Z takes both rows to zero: they are along the powers of y/x."""
    unfold = Unfolding(graph(), {}, ("Z",))
    entries = ImmutableDenseMatrix(4, 4, lambda i, j: component_symbols(Z)[min(i, j), max(i, j)])
    symmetric = dict(zip(component_symbols(Z), entries, strict=True))

    def difference() -> list[Basic]:
        first, last = (unfold(powers).xreplace(symmetric)[row, :].T for row in range(2))
        whole = unfold(eliminant).xreplace(symmetric) * ImmutableDenseMatrix.eye(4)
        return [entries * first - whole[:, 0], entries * last - whole[:, 3]]

    return Identity(
        "adjugate",
        "Z times row 1 and row 4 of its adjugate is det Z times the first and the last axis",
        difference,
        number="(6)",
    )
