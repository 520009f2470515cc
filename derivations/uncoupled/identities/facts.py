"""What the proofs of all sections share: symbols, graphs, and facts about a limb.

A fact is a dictionary from a symbol or node to an equal form. Each is itself an identity
(`stated`), proven without the facts that come after it, so that no proof goes in a circle.
"""

from __future__ import annotations

from functools import cache

from sympy import Abs, Basic, Expr, Symbol, cos, sin

from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import UNIT_QUATERNION, Unfolding, quaternion_rotation
from derivations.algebra.vectors import Cross, Dot, Norm, scalar, vector
from derivations.uncoupled.displacement import lam, q4, q5, q6, r
from derivations.uncoupled.geometry import LIMBS, ROOT, base_k, c, m1, n1, nu
from derivations.uncoupled.rates import forward_velocity_graph, inverse_velocity_graph
from derivations.uncoupled.singularity import central, singularity_graph, wrist
from derivations.uncoupled.velocity import axis, heading

Facts = dict[Basic, Basic]

ROTATION = quaternion_rotation()
QUATERNION_RELATION = (UNIT_QUATERNION,)


@cache
def pose() -> Graph:
    """Everything that follows from the pose, Sections III to V."""
    return singularity_graph()


@cache
def inverse_velocity() -> Graph:
    return inverse_velocity_graph()


@cache
def forward_velocity() -> Graph:
    return forward_velocity_graph()


def scalars(names: str, i: int) -> list[Symbol]:
    """Scalars of limb i: ``scalars("gt gz", 1)`` is gt1, gz1."""
    return [scalar(f"{name}{i}") for name in names.split()]


def vectors(names: str, i: int) -> list:
    """Vectors of limb i."""
    return [vector(f"{name}{i}") for name in names.split()]


def named(names: str, *limbs: int) -> tuple[str, ...]:
    """Names to keep: every name for every limb."""
    return tuple(f"{name}{i}" for name in names.split() for i in limbs)


def stated(
    name: str,
    claim: str,
    fact: Facts,
    unfolding: Unfolding,
    relations: tuple[Expr, ...] = (),
    number: str = "",
) -> Identity:
    """The claim that a fact holds: both sides, unfolded, are equal."""
    return Identity(
        name,
        claim,
        lambda: [unfolding(left) - unfolding(right) for left, right in fact.items()],
        relations,
        number,
    )


def size(p: Expr) -> Symbol:
    """A symbol for Abs(p), which no form divides by where it is zero."""
    return Symbol(f"abs_{p.name}", positive=True)


def absolute(*parameters: Symbol) -> tuple[Facts, tuple[Expr, ...]]:
    """Abs(p) as a symbol, and the relation that it has."""
    return {Abs(p): size(p) for p in parameters}, tuple(size(p) ** 2 - p**2 for p in parameters)


def any_frame(i: int = 1) -> Facts:
    """[n_i, m_i, nu] is any rotation: "limb frames" proves that it is one."""
    n, m = vectors("n m", i)
    return {n: ROTATION[:, 0], m: ROTATION[:, 1], nu: ROTATION[:, 2]}


def leg(i: int) -> Facts:
    """p_i (b_i − a_i) = gt_i t_i + gz_i k: the leg has no part along u_i."""
    p, gt, gz = scalars("p gt gz", i)
    b, a_i, t = vectors("b a t", i)
    return {b: a_i + (gt / p) * t + (gz / p) * base_k}


def limb_forms() -> Facts:
    """The Klein forms (23) under their names."""
    return {pose()[f"limb{i}"].expression: scalar(f"limb{i}") for i in LIMBS}


def from_platform(i: int) -> Facts:
    """(3) solved for c: the way to C from B_i."""
    b, n = vectors("b n", i)
    return {c: b - scalar(f"e{i}") * n}


def line_from_leg(i: int) -> Facts:
    """p_i² (d_i − b_i) = (n_i·g_i) u_i − p_i g_i = n_i × (u_i × g_i)."""
    b, d, u, n, t = vectors("b d u n t", i)
    p, gt, gz = scalars("p gt gz", i)
    g = gt * t + gz * base_k
    return {d: b + (Dot(n, g) / p**2) * u - (1 / p) * g}


def line_in_platform(i: int) -> Facts:
    """p_i² (d_i − b_i) = tau_i m_i + sigma_i nu: the line is normal to n_i."""
    b, d, m = vectors("b d m", i)
    p, tau, sigma = scalars("p tau sigma", i)
    return {d: b + (tau / p**2) * m + (sigma / p**2) * nu}


def span(i: int) -> Facts:
    """p_i² |d_i − b_i| = rho_i."""
    b, d = vectors("b d", i)
    p, rho = scalars("p rho", i)
    return {Norm(d - b): rho / p**2}


def moment(i: int) -> Facts:
    """n_i × (d_i − c) = (tau_i nu − sigma_i m_i)/p_i²."""
    n, d, m = vectors("n d m", i)
    p, tau, sigma = scalars("p tau sigma", i)
    return {Cross(n, d - c): (tau / p**2) * nu - (sigma / p**2) * m}


def central_facts() -> Facts:
    """Cosines and sines of (11), the direction of C and the axis of the second revolute."""
    x, y, z = (c[index, 0] for index in range(3))
    i, j = vector("i"), vector("j")
    return {
        cos(q4): x / r,
        sin(q4): y / r,
        cos(q5): r / q6,
        sin(q5): z / q6,
        lam: (1 / q6) * c,
        axis: (y / r) * i - (x / r) * j,
    }


def factor_facts() -> Facts:
    """The central and the wrist factor."""
    return {central: q6 * r, wrist: ROOT * Dot(nu, c) / q6}


def directions() -> Facts:
    """Any rotation, for n_1, n_2, n_3 and m_1, m_2, m_3 at once."""
    return {n1: ROTATION[:, 0], m1: ROTATION[:, 1], nu: ROTATION[:, 2]}


def azimuth() -> Facts:
    """The heading at azimuth q4, C off the Z axis: its angle is q4, its length r."""
    return {heading[0, 0]: c[0, 0], heading[1, 0]: c[1, 0]}


def own_directions() -> Facts:
    """m_i by its computed form in n_1 and m_1."""
    graph = pose()
    return {vector(f"m{i}"): graph[f"m{i}"].computed_as for i in (2, 3)}


#: |c|² and r² as relations between symbols, instead of roots.
X, Y, Z = (scalar(f"c_{suffix}") for suffix in "xyz")
RADIAL = (r**2 - X**2 - Y**2,)
CENTRAL = (r**2 - X**2 - Y**2, q6**2 - r**2 - Z**2)
