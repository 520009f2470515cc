"""Section II: topology and geometry of the manipulator.

Everything is in the base frame O_XYZ: positions in metres, angles in radians, Z up.
The pose is the position ``c`` of the platform's centre C and the rotation
``R = [n1, m1, nu]``: the direction of the first platform joint, the direction that
completes the frame, and the normal of the platform.

Each function of a limb takes ``i`` = 1, 2, 3, or ``"i"`` to show the formula as the paper
prints it.
"""

from __future__ import annotations

from sympy import ImmutableDenseMatrix, Rational, eye, sqrt

from derivations.algebra.equations import Equation
from derivations.algebra.vectors import Columns, Cross, matrix, scalar, vector

LIMBS = (1, 2, 3)
HALF, ROOT = Rational(1, 2), sqrt(3) / 2

#: Radius of the circle through A_1, A_2, A_3.
a = scalar("a")
#: Position of the platform's centre C.
c = vector("c")
#: The columns of the rotation: platform x axis, platform y axis, platform normal.
n1, m1, nu = vector("n1"), vector("m1"), vector("nu")
#: The base vectors i, j, k.
base_i, base_j, base_k = vector("i"), vector("j"), vector("k")

#: (cos, sin) of the angle of limb i, about Z in the base and about nu in the platform.
LIMB_ANGLE = {1: (1, 0), 2: (-HALF, ROOT), 3: (-HALF, -ROOT)}

POSE = (a, c, n1, m1, nu)


def constants() -> list[Equation]:
    """The base vectors and the axes u_i of the base revolutes."""
    unit = ImmutableDenseMatrix(eye(3))
    axes = [
        Equation(symbol, unit[:, index], f"base vector {symbol.name}")
        for index, symbol in enumerate((base_i, base_j, base_k))
    ]
    return axes + [equation for i in LIMBS for equation in limb_constants(i)]


def limb_constants(i: int) -> list[Equation]:
    """The axis u_i of the base revolute and its normal t_i in the base plane."""
    cosine, sine = LIMB_ANGLE[i]
    return [
        Equation(
            vector(f"u{i}"),
            ImmutableDenseMatrix([cosine, sine, 0]),
            f"axis of the base revolute of limb {i}, from O to A_{i}",
        ),
        Equation(
            vector(f"t{i}"),
            Cross(base_k, vector(f"u{i}")),
            f"horizontal normal of u_{i}",
        ),
    ]


def platform_directions() -> list[Equation]:
    """n_2, n_3 and, for every limb, the platform direction m_i normal to n_i."""
    equations = []
    for i in (2, 3):
        cosine, sine = LIMB_ANGLE[i]
        equations += [
            Equation(
                vector(f"n{i}"),
                cosine * n1 + sine * m1,
                f"direction from C to B_{i}, n_1 turned by {120 * (i - 1)}° about nu",
                "(5)",
            ),
            Equation(
                vector(f"m{i}"),
                Cross(nu, vector(f"n{i}")),
                f"platform direction normal to n_{i}",
                computed_as=-sine * n1 + cosine * m1,
            ),
        ]
    return equations


def base_joint(i: int | str) -> Equation:
    """The nominal position A_i of the base revolute."""
    return Equation(
        vector(f"a{i}"), a * vector(f"u{i}"), f"position of A_{i}", "Section II", unit="m"
    )


def rotation() -> Equation:
    """The rotation by its columns."""
    return Equation(matrix("R", 3, 3), Columns(n1, m1, nu), "rotation of the platform", "(8)")
