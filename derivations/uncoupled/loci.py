"""Section V: where a determinant vanishes, as surfaces, which the paper leaves out.

With one orientation, τ_i and σ_i are affine in the position c, so that
``τ1 σ2 σ3 + τ2 σ3 σ1 + τ3 σ1 σ2 = 0`` is a cubic surface: nothing divides. At one position the
same sum is a polynomial of degree six in the entries of the rotation, and of degree twelve in
its Euler parameters.
"""

from __future__ import annotations

from sympy import Expr, ImmutableDenseMatrix, MatrixSymbol

from derivations.algebra.equations import Equation, Graph
from derivations.algebra.polynomials import SpatialConvolution
from derivations.algebra.vectors import Cross, Dot, matrix, scalar, vector
from derivations.uncoupled.displacement import limb_inverse
from derivations.uncoupled.geometry import LIMBS, a, c, constants, m1, n1, nu, platform_directions
from derivations.uncoupled.rates import others
from derivations.uncoupled.singularity import per_limb, singularity_graph
from derivations.uncoupled.velocity import ZERO

#: Coefficients of the cubic in c = (x, y, z), in the order of `polynomials.monomials`.
CUBIC = matrix("cubic", 20, 1)
#: The derivatives of the sum by a turn of the platform and by the position.
tilt_turn, tilt_shift = vector("tilt_turn"), vector("tilt_shift")


def incidence(i: int) -> Equation:
    """p_i, as in Section III."""
    return next(equation for equation in limb_inverse(i) if equation.name == f"p{i}")


def affine_parts(i: int | str) -> list[Equation]:
    """τ_i and σ_i as polynomials in c: the coefficients at 1, x, y, z."""
    u, m, p = vector(f"u{i}"), vector(f"m{i}"), scalar(f"p{i}")
    tau_shift, sigma_shift = vector(f"tau_shift{i}"), vector(f"sigma_shift{i}")

    def coefficients(name: str, constant: Expr, shift: MatrixSymbol) -> Equation:
        entries = [constant, *(shift[axis, 0] for axis in range(3))]
        words = f"{name}_{i}, its coefficients in c"
        return Equation(
            matrix(f"{name}_part{i}", 4, 1), ImmutableDenseMatrix(entries), words, unit="m, 1"
        )

    return [
        Equation(
            tau_shift,
            p * Cross(u, nu) - Dot(m, u) * u,
            f"derivative of tau_{i} by the position",
        ),
        Equation(
            sigma_shift,
            p * Cross(m, u) - Dot(nu, u) * u,
            f"derivative of sigma_{i} by the position",
        ),
        coefficients("tau", a * Dot(m, u), tau_shift),
        coefficients("sigma", a * Dot(nu, u), sigma_shift),
    ]


def cubic() -> list[Equation]:
    """The sum ``tilt`` as a polynomial in c."""
    (t1, t2, t3), (s1, s2, s3) = (
        [matrix(f"{name}_part{i}", 4, 1) for i in LIMBS] for name in ("tau", "sigma")
    )
    both, either = matrix("sigma23", 10, 1), matrix("tau23", 10, 1)
    return [
        Equation(
            both,
            SpatialConvolution(s2, s3),
            "sigma_2 sigma_3, its coefficients in c",
            unit="m², m, 1",
        ),
        Equation(
            either,
            SpatialConvolution(t2, s3) + SpatialConvolution(t3, s2),
            "tau_2 sigma_3 + tau_3 sigma_2, its coefficients in c",
            unit="m², m, 1",
        ),
        Equation(
            CUBIC,
            SpatialConvolution(t1, both) + SpatialConvolution(s1, either),
            "cubic of direct singularities at one orientation, its coefficients in c",
            "(27)",
            "m³, m², m, 1",
        ),
    ]


def direct_locus_graph() -> Graph:
    """From radius and rotation to the cubic."""
    graph = Graph((a, n1, m1, nu))
    graph.add([*constants(), *platform_directions()])
    for i in LIMBS:
        graph.add([incidence(i), *affine_parts(i)])
    graph.add(cubic())
    return graph


def limb_slopes(i: int | str) -> list[Equation]:
    """How τ_i and σ_i grow with a turn of the platform."""
    n, m, u, lever = (vector(f"{name}{i}") for name in ("n", "m", "u", "lever"))
    p, h = scalar(f"p{i}"), scalar(f"h{i}")
    return [
        Equation(lever, Cross(u, c), f"moment about O of a unit force along u_{i} at C", unit="m"),
        Equation(
            vector(f"tau_turn{i}"),
            h * Cross(m, u) - Dot(nu, lever) * Cross(n, u) - p * Cross(nu, lever),
            f"derivative of tau_{i} by a turn of the platform",
            unit="m",
        ),
        Equation(
            vector(f"sigma_turn{i}"),
            h * Cross(nu, u) + Dot(m, lever) * Cross(n, u) + p * Cross(m, lever),
            f"derivative of sigma_{i} by a turn of the platform",
            unit="m",
        ),
    ]


def slopes() -> list[Equation]:
    """The derivatives of the sum ``tilt``."""
    tau, sigma = (dict(zip(LIMBS, per_limb(name), strict=True)) for name in ("tau", "sigma"))
    equations = []
    for symbol, way, words, unit in (
        (tilt_turn, "turn", "a turn of the platform", "m³"),
        (tilt_shift, "shift", "the position", "m²"),
    ):
        total = ZERO
        for i in LIMBS:
            j, k = others(i)
            total += sigma[j] * sigma[k] * vector(f"tau_{way}{i}")
            total += (tau[j] * sigma[k] + tau[k] * sigma[j]) * vector(f"sigma_{way}{i}")
        equations.append(Equation(symbol, total, f"derivative of theta by {words}", "(27)", unit))
    return equations


def orientation_locus_graph() -> Graph:
    """From the pose to the sum ``tilt`` and its derivatives."""
    graph = singularity_graph()
    for i in LIMBS:
        graph.add([*affine_parts(i)[:2], *limb_slopes(i)])
    graph.add(slopes())
    return graph
