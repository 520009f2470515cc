"""What is generated for the forward displacement of Section III."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix

from derivations.algebra.vectors import Rows, matrix, scalar, vector
from derivations.codegen.kernel import Input, Kernel, Output
from derivations.uncoupled.circles import (
    ANGLE,
    ARMS,
    CONE,
    FIRST,
    HALVES,
    SECOND,
    STARTS,
    arms_graph,
    circles_graph,
)
from derivations.uncoupled.closure import LENGTHS, closure_graph, cones_graph
from derivations.uncoupled.correction import fold_graph, newton_graph, turn, volume
from derivations.uncoupled.displacement import q4, q5, q6
from derivations.uncoupled.eliminant import (
    bound,
    cosine,
    eliminant,
    eliminant_graph,
    frame,
    powers,
    reference,
    sine,
    turn_graph,
    x,
    y,
)
from derivations.uncoupled.fields import POSITION, RADIUS
from derivations.uncoupled.geometry import LIMBS, n1
from derivations.uncoupled.leg_step import guess, leg_graph

PROBLEM = (RADIUS, POSITION, Input("lengths", ImmutableDenseMatrix(LENGTHS), "m", "q1, q2, q3"))
JOINTS = Input("joints", ImmutableDenseMatrix([*LENGTHS, q4, q5, q6]), "m, rad", "q1 ... q6")
PAIR = Rows(n1, vector("n2"))
DIRECTIONS = Input("directions", PAIR, "1", "n_1 and n_2, a row each")
LEG = Input("angle", ImmutableDenseMatrix([cosine, sine]), "1", "cos, sin of leg 1's angle")
REFERENCE = Input("reference", reference, "1", "a vector not parallel to n_1")
START = Input("start", STARTS, "1", "cos, sin of the angles of legs 1, 2 at t = s = 0")
CLOSED = (
    Output("residual", matrix("F", 3, 1), "m²", "F_1, F_2, F_3"),
    Output("gradient", matrix("G", 3, 3), "m²", "of F_i by a turn, a row each"),
    Output("volume", volume, "m⁶", "determinant of the gradient"),
)


def closure_kernels() -> list[Kernel]:
    """The six quadratics."""
    cones = tuple(
        Output(f"cone_{i}", matrix(f"M{i}", 3, 3), "m²", f"M_{i}, symmetric") for i in LIMBS
    )
    return [
        Kernel(
            "closure",
            "Residual of the six quadratics in (n_1, n_2), and its Jacobian.",
            "(6)",
            closure_graph(),
            (*PROBLEM, DIRECTIONS),
            (
                Output(
                    "residual", matrix("F", 6, 1), "m², 1", "three cones, three unit conditions"
                ),
                Output("jacobian", matrix("dF", 6, 6), "m², 1", "by (n_1, n_2)"),
            ),
        ),
        Kernel(
            "cones",
            "The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.",
            "(6)",
            cones_graph(),
            PROBLEM,
            cones,
        ),
    ]


def one_unknown() -> list[Kernel]:
    """By the angle of leg 1."""
    return [
        Kernel(
            "eliminant",
            "The resultant that vanishes at the angles of leg 1 of the assembly modes.",
            "(5), (6)",
            eliminant_graph(),
            (*PROBLEM, LEG, REFERENCE),
            (
                Output("eliminant", eliminant, "m¹⁶", "resultant of the quartics of limbs 2, 3"),
                Output("bound", bound, "m¹⁶", "Hadamard's bound on it"),
            ),
        ),
        Kernel(
            "half_turn",
            "The turn about n_1 at a zero of the eliminant, as a half angle.",
            "(5), (6)",
            eliminant_graph(),
            (*PROBLEM, LEG, REFERENCE),
            (
                Output("frame", frame, "1", "n_1, f, g, a row each"),
                Output("powers", powers, "m¹²", "along x³, x²y, xy², y³ twice"),
            ),
        ),
        Kernel(
            "turned_directions",
            "n_1 and n_2 from the frame about n_1 and the half angle of the turn.",
            "(5)",
            turn_graph(),
            (
                Input("frame", frame, "1", "n_1, f, g, a row each"),
                Input("half_angle", ImmutableDenseMatrix([x, y]), "1", "(x, y), any length"),
            ),
            (Output("directions", PAIR, "1", "n_1 and n_2, a row each"),),
        ),
    ]


def two_unknowns() -> list[Kernel]:
    """By the angles of legs 1 and 2."""
    return [
        Kernel(
            "circles",
            "Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.",
            "(5), (6)",
            circles_graph(),
            (*PROBLEM, START),
            (
                Output("angle", ANGLE, "m⁴", "n_1 and n_2 are 120° apart"),
                Output("cone", CONE, "m⁶", "limb 3 closes"),
                Output("first", FIRST, "m", "(1 + t²)(b_1 − c) at 1, t, t², a row each"),
                Output("second", SECOND, "m", "(1 + s²)(b_2 − c) at 1, s, s², a row each"),
            ),
        ),
        Kernel(
            "arms",
            "The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.",
            "(3)",
            arms_graph(),
            (*PROBLEM, START, Input("half_tangents", ImmutableDenseMatrix(HALVES), "1", "t, s")),
            (Output("arms", ARMS, "m", "from C to B_1 and B_2, a row each"),),
        ),
    ]


def steps() -> list[Kernel]:
    """Newton's method, and the folds where it fails."""
    return [
        Kernel(
            "newton_step",
            "One step of Newton's method on the rotation, for the three closure equations.",
            "(6)",
            newton_graph(),
            (*PROBLEM, DIRECTIONS),
            (
                Output("next", Rows(vector("next1"), vector("next2")), "1", "n_1, n_2 turned"),
                Output("turn", turn, "rad", "the step, a rotation vector"),
                *CLOSED,
            ),
        ),
        Kernel(
            "leg_step",
            "One step of Newton's method in the angle of leg 1 and the turn about n_1.",
            "(6)",
            leg_graph(),
            (*PROBLEM, LEG, Input("second", guess, "1", "n_2, or near it")),
            (
                Output("angle", matrix("next_leg", 2, 1), "1", "cos, sin of leg 1's angle"),
                Output("directions", matrix("pair", 2, 3), "1", "n_1 and n_2"),
                Output("extension", scalar("next_span"), "m", "e_1, positive"),
                Output("steps", matrix("steps", 2, 1), "rad", "of leg 1's angle and of the turn"),
            ),
        ),
        Kernel(
            "fold",
            "What decides whether two assembly modes have merged.",
            "(6)",
            fold_graph(),
            (RADIUS, JOINTS, DIRECTIONS),
            (
                *CLOSED,
                Output("volume_gradient", vector("dvolume"), "m⁶", "of the volume by a turn"),
                Output("by_joints", matrix("qF", 3, 6), "m²", "of F_i by the logarithm of q_j"),
            ),
        ),
    ]


def forward_kernels() -> list[Kernel]:
    """The closure equations, two reductions of them, and Newton's method."""
    return [*closure_kernels(), *one_unknown(), *two_unknowns(), *steps()]
