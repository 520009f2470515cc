"""Section III: the rotation from directions (8), from angles (9), and the angles back."""

from __future__ import annotations

from sympy import Basic, Expr, ImmutableDenseMatrix, Matrix, Symbol, cos, eye, sin, symbols

from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding
from derivations.algebra.vectors import Columns, Cross, Norm
from derivations.uncoupled.geometry import LIMB_ANGLE, ROOT, n1
from derivations.uncoupled.identities.facts import QUATERNION_RELATION, stated
from derivations.uncoupled.identities.facts import ROTATION as ANY_ROTATION
from derivations.uncoupled.orientation import (
    ROTATION,
    directions_graph,
    from_angles_graph,
    n2,
    pitch,
    roll,
    to_angles_graph,
    yaw,
)

#: Sine and cosine of yaw, pitch and roll as symbols.
SINE_COSINE = {
    yaw: symbols("sa ca", real=True),
    pitch: symbols("sb cb", real=True),
    roll: symbols("sg cg", real=True),
}
PYTHAGORAS = tuple(sine**2 + cosine**2 - 1 for sine, cosine in SINE_COSINE.values())


def identities() -> list[Identity]:
    """(8) and (9)."""
    return [*printed_columns(), *from_directions(), *from_angles(), *to_angles()]


NORMAL = Cross(n1, n2)
INWARD = Cross(NORMAL, n1)
#: n_1 and n_2 of any rotation, then the columns of (8) as printed, and their norms.
APART = {
    n1: ANY_ROTATION[:, 0],
    n2: LIMB_ANGLE[2][0] * ANY_ROTATION[:, 0] + LIMB_ANGLE[2][1] * ANY_ROTATION[:, 1],
}
ALONG = {NORMAL: ROOT * ANY_ROTATION[:, 2]}
ACROSS = {INWARD: ROOT * ANY_ROTATION[:, 1]}
NORMS = {Norm(NORMAL): ROOT, Norm(INWARD): ROOT}


def printed_columns() -> list[Identity]:
    """(8) as printed is no rotation."""
    plain = Unfolding(directions_graph(), APART)
    by_normal = Unfolding(directions_graph(), APART | ALONG)
    unfold = Unfolding(directions_graph(), APART | ALONG | ACROSS)
    relations, number = QUATERNION_RELATION, "(8)"
    printed = Columns(n1, INWARD, NORMAL)
    return [
        stated("normal of (8)", "n_1 × n_2 = √3/2 ν", ALONG, plain, relations, number),
        stated("middle of (8)", "(n_1×n_2)×n_1 = √3/2 m_1", ACROSS, by_normal, relations, number),
        Identity(
            "norms of (8)",
            "the second and the third column of (8), as printed, have the norm √3/2",
            lambda: [unfold(norm) ** 2 - value**2 for norm, value in NORMS.items()],
            relations,
            number,
        ),
        Identity(
            "determinant of (8)",
            "the matrix of (8), as printed, has the determinant 3/4",
            lambda: [unfold(printed).det(method="berkowitz") - ROOT**2],
            relations,
            number,
        ),
    ]


def from_directions() -> list[Identity]:
    """(8) normalised is a rotation."""
    return [
        stated(
            "rotation from directions",
            "the normalised columns of (8) are the rotation that n_1 and n_2 belong to",
            {ROTATION: ANY_ROTATION},
            Unfolding(directions_graph(), APART | ALONG | ACROSS | NORMS),
            QUATERNION_RELATION,
            "(8)",
        ),
        Identity(
            "any rotation",
            "the matrix of four Euler parameters is orthonormal, its determinant is 1",
            lambda: orthonormal(ANY_ROTATION),
            QUATERNION_RELATION,
        ),
    ]


def orthonormal(rotation: ImmutableDenseMatrix) -> list[Basic]:
    """What vanishes for a rotation."""
    return [rotation.T * rotation - eye(3), rotation.det(method="berkowitz") - 1]


def printed_rotation() -> ImmutableDenseMatrix:
    """(9) in sines and cosines as symbols."""
    trigonometry: dict[Expr, Symbol] = {}
    for angle, (sine, cosine) in SINE_COSINE.items():
        trigonometry |= {sin(angle): sine, cos(angle): cosine}
    return from_angles_graph()["R"].expression.xreplace(trigonometry)


def turns() -> Matrix:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (sa, ca), (sb, cb), (sg, cg) = SINE_COSINE.values()
    about_z = Matrix([[ca, -sa, 0], [sa, ca, 0], [0, 0, 1]])
    about_y = Matrix([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    about_x = Matrix([[1, 0, 0], [0, cg, -sg], [0, sg, cg]])
    return about_z * about_y * about_x


def from_angles() -> list[Identity]:
    """(9) is a rotation, and which one."""
    return [
        Identity(
            "order of turns",
            "(9) is Rz(yaw) Ry(pitch) Rx(roll)",
            lambda: [printed_rotation() - turns()],
            number="(9)",
        ),
        Identity(
            "rotation from angles",
            "(9) is orthonormal, its determinant is 1",
            lambda: orthonormal(printed_rotation()),
            PYTHAGORAS,
            "(9)",
        ),
    ]


def to_angles() -> list[Identity]:
    """Both branches of the angles from a rotation."""
    return [
        Identity(
            "angles from rotation of angles",
            "for cos(pitch) > 0 each atan2 has the sine and the cosine of its angle times "
            "cos(pitch) or 1",
            regular_angles,
            PYTHAGORAS,
            "(9)",
        ),
        Identity(
            "angles at pitch ±90°",
            "for R_11 = R_21 = 0 and yaw 0, (9) at the angles found gives back the rotation",
            upright_angles,
            UPRIGHT,
            "(9)",
        ),
    ]


def regular_angles() -> list[Expr]:
    """Arguments of each atan2 at the rotation (9), less what they must be."""
    (sa, ca), (sb, cb), (sg, cg) = SINE_COSINE.values()
    known = {ROTATION: printed_rotation(), sin(yaw): sa, cos(yaw): ca}
    unfold = Unfolding(to_angles_graph(), known)
    arguments = {angle: to_angles_graph()[angle.name].expression.args for angle in SINE_COSINE}
    pairs = [
        (arguments[yaw][0], cb * sa),
        (arguments[yaw][1], cb * ca),
        (arguments[pitch][0], sb),
        (arguments[pitch][1] ** 2, cb**2),
        (arguments[roll][0], sg),
        (arguments[roll][1], cg),
    ]
    return [unfold(found) - wanted for found, wanted in pairs]


UPWARD, EAST, NORTH = symbols("upward east north", real=True)
#: R_31 = ∓1, and the second column (x, y, 0) has length one.
UPRIGHT = (UPWARD**2 - 1, EAST**2 + NORTH**2 - 1)


def upright_angles() -> list[Basic]:
    """Every rotation with R_11 = R_21 = 0, and (9) at its angles."""
    first, second = Matrix([0, 0, -UPWARD]), Matrix([EAST, NORTH, 0])
    rotation = Matrix.hstack(first, second, first.cross(second))
    known = {ROTATION: ImmutableDenseMatrix(rotation), sin(yaw): 0, cos(yaw): 1}
    unfold = Unfolding(to_angles_graph(), known)
    rise, run = (unfold(entry) for entry in to_angles_graph()["beta"].expression.args)
    sine, cosine = (unfold(entry) for entry in to_angles_graph()["gamma"].expression.args)
    (sa, ca), (sb, cb), (sg, cg) = SINE_COSINE.values()
    values = {sa: 0, ca: 1, sb: rise, cb: run, sg: sine, cg: cosine}
    return [printed_rotation().subs(values) - rotation, sine**2 + cosine**2 - 1]
