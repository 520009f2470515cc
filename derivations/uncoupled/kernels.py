"""What is generated for this manipulator."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix

from derivations.algebra.vectors import Columns, Rows, matrix, scalar, vector
from derivations.codegen.kernel import Input, Kernel, Output
from derivations.uncoupled.circles import ANGLE, CONE, FIRST, SECOND, STARTS, arms_graph, circles_graph
from derivations.uncoupled.closure import LENGTHS, closure_graph
from derivations.uncoupled.correction import cones_graph, fold_graph, newton_graph, turn, volume
from derivations.uncoupled.displacement import central_graph, lam, pose_graph, q4, q5, q6, r
from derivations.uncoupled.eliminant import (
    cosine,
    eliminant,
    eliminant_graph,
    frame,
    reference,
    sine,
    turn_graph,
    x,
    y,
)
from derivations.uncoupled.geometry import LIMBS, a, c, m1, n1, nu
from derivations.uncoupled.orientation import (
    ROTATION,
    defect_graph,
    directions_graph,
    from_angles_graph,
    pitch,
    roll,
    to_angles_graph,
    yaw,
)
from derivations.uncoupled.rates import (
    RATES,
    forward_velocity_graph,
    inverse_velocity_graph,
    omega,
    velocity,
)
from derivations.uncoupled.singularity import (
    central,
    orientation,
    reach,
    singularity_graph,
    wrist,
)
from derivations.uncoupled.velocity import heading, velocity_graph

RADIUS = Input("a", a, "m", "radius of the circle through A_1, A_2, A_3")
POSITION = Input("c", c, "m", "position of the platform's centre C")
POSE = (RADIUS, POSITION, Input("R", Columns(n1, m1, nu), "1", "rotation of the platform"))
HEADING = Input(
    "heading", heading, "m", "horizontal vector at azimuth q4: (c_x, c_y) off the Z axis"
)
TWIST = Input("twist", Rows(omega, velocity), "rad/s, m/s", "[omega, v_C]")

LENGTHS_IN = Input("lengths", ImmutableDenseMatrix(LENGTHS), "m", "q1, q2, q3")
DIRECTIONS = Rows(n1, vector("n2"))
DIRECTIONS_IN = Input("directions", DIRECTIONS, "1", "n_1 and n_2, a row each")

RADIAL = Output("radial", r, "m", "distance of C from the Z axis")
LENGTH = Output("central_length", q6, "m", "distance from O to C")
REACH = Output("reach", reach, "m", "a + 2 |c|, against which the legs' rounding is judged")


def column(name: str) -> ImmutableDenseMatrix:
    """The scalars of the three limbs as an array (3,)."""
    return ImmutableDenseMatrix([scalar(f"{name}{i}") for i in LIMBS])


INCIDENCE = Output("incidence", column("p"), "1", "n_i·u_i")
LEGS = Output("scaled_legs", column("l"), "m", "|n_i·u_i| q_i")
JOINTS = Output("joints", matrix("q", 6, 1), "m, rad", "q1 ... q6")
EXTENSION = Output("extension", column("e"), "m", "signed distances e_i from C to B_i")
EXTENSION_SCALE = Output("extension_scale", column("e_scale"), "m", "scales of the e_i")
LIMB = Output("limb", column("limb"), "1", "Klein forms of S_i and the actuated screw")
LIMB_SCALE = Output("limb_scale", column("limb_scale"), "1", "scales of limb")
CENTRAL = Output("central", central, "m²", "q6² cos q5")
CENTRAL_SCALE = Output("central_scale", scalar("central_scale"), "m²", "scale of central")
WRIST = Output("wrist", wrist, "1", "(n_1 × n_2)·lambda")
WRIST_SCALE = Output("wrist_scale", scalar("wrist_scale"), "1", "scale of wrist")
ORIENTATION = Output("orientation", orientation, "m³", "det[n_i × (d_i − c)]")
ORIENTATION_SCALE = Output(
    "orientation_scale", scalar("orientation_scale"), "m³", "scale of orientation"
)


def displacement_kernels() -> list[Kernel]:
    """Section III."""
    pose = pose_graph()
    central_limb = ImmutableDenseMatrix([q4, q5, q6])
    return [
        Kernel(
            "inverse_displacement",
            "Joint values from the pose.",
            "(3), (4), (10), (11)",
            pose,
            POSE,
            (
                JOINTS,
                EXTENSION,
                Output("platform_joints", matrix("B", 3, 3), "m", "B_i, a row each"),
                INCIDENCE,
                RADIAL,
            ),
        ),
        Kernel(
            "central_forward",
            "Position of C from the joint values of the central limb.",
            "(1)",
            central_graph(),
            (Input("joints", central_limb, "rad, rad, m", "q4, q5, q6"),),
            (
                Output("position", c, "m", "position of C"),
                Output("direction", lam, "1", "unit vector lambda"),
            ),
        ),
        Kernel(
            "central_inverse",
            "Joint values of the central limb from the position of C.",
            "(11)",
            pose,
            (POSITION,),
            (Output("joints", central_limb, "rad, rad, m", "q4, q5, q6"), RADIAL),
        ),
        Kernel(
            "closure",
            "Residual of the six quadratics in (n_1, n_2), and its Jacobian.",
            "(6)",
            closure_graph(),
            (
                RADIUS,
                POSITION,
                LENGTHS_IN,
                DIRECTIONS_IN,
            ),
            (
                Output(
                    "residual", matrix("F", 6, 1), "m², 1", "three cones, three unit conditions"
                ),
                Output("jacobian", matrix("dF", 6, 6), "m², 1", "by (n_1, n_2)"),
            ),
        ),
    ]


def forward_kernels() -> list[Kernel]:
    """Section III, the forward displacement: two reductions, and Newton on rotations."""
    joints = ImmutableDenseMatrix([*LENGTHS, q4, q5, q6])
    leg = (
        Input("angle", ImmutableDenseMatrix([cosine, sine]), "1", "cos, sin of leg 1's angle"),
        Input("reference", reference, "1", "a vector not parallel to n_1"),
    )
    closed = (
        Output("residual", matrix("F", 3, 1), "m²", "F_1, F_2, F_3"),
        Output("gradient", matrix("G", 3, 3), "m²", "of F_i by a turn, a row each"),
        Output("volume", volume, "m⁶", "determinant of the gradient"),
    )
    return [
        Kernel(
            "cones",
            "The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.",
            "(6)",
            cones_graph(),
            (RADIUS, POSITION, LENGTHS_IN),
            tuple(
                Output(f"cone_{i}", matrix(f"M{i}", 3, 3), "m²", f"M_{i}, symmetric")
                for i in LIMBS
            ),
        ),
        Kernel(
            "eliminant",
            "The resultant that vanishes at the angles of leg 1 of the assembly modes.",
            "(5), (6)",
            eliminant_graph(),
            (RADIUS, POSITION, LENGTHS_IN, *leg),
            (
                Output("eliminant", eliminant, "m¹⁶", "resultant of the quartics of limbs 2, 3"),
                Output("bound", scalar("bound"), "m¹⁶", "Hadamard's bound on it"),
            ),
        ),
        Kernel(
            "half_turn",
            "The turn about n_1 at a zero of the eliminant, as a half angle.",
            "(5), (6)",
            eliminant_graph(),
            (RADIUS, POSITION, LENGTHS_IN, *leg),
            (
                Output("frame", frame, "1", "n_1, f, g, a row each"),
                Output("powers", matrix("powers", 2, 4), "m¹²", "along x³, x²y, xy², y³ twice"),
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
            (Output("directions", DIRECTIONS, "1", "n_1 and n_2, a row each"),),
        ),
        Kernel(
            "circles",
            "Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.",
            "(5), (6)",
            circles_graph(),
            (
                RADIUS,
                POSITION,
                LENGTHS_IN,
                Input("start", STARTS, "1", "cos, sin of the angles of legs 1, 2 at t = s = 0"),
            ),
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
            (
                RADIUS,
                POSITION,
                LENGTHS_IN,
                Input("start", STARTS, "1", "cos, sin of the angles of legs 1, 2 at t = s = 0"),
                Input("half_tangents", ImmutableDenseMatrix([scalar("t"), scalar("s")]), "1", "t, s"),
            ),
            (Output("arms", matrix("arms", 2, 3), "m", "from C to B_1 and B_2, a row each"),),
        ),
        Kernel(
            "newton_step",
            "One step of Newton's method on the rotation, for the three closure equations.",
            "(6)",
            newton_graph(),
            (RADIUS, POSITION, LENGTHS_IN, DIRECTIONS_IN),
            (
                Output("next", Rows(vector("next1"), vector("next2")), "1", "n_1, n_2 turned"),
                Output("turn", turn, "rad", "the step, a rotation vector"),
                *closed,
            ),
        ),
        Kernel(
            "fold",
            "What decides whether two assembly modes have merged.",
            "(6)",
            fold_graph(),
            (RADIUS, Input("joints", joints, "m, rad", "q1 ... q6"), DIRECTIONS_IN),
            (
                *closed,
                Output("volume_gradient", vector("dvolume"), "m⁶", "of the volume by a turn"),
                Output("by_joints", matrix("qF", 3, 6), "m²", "of F_i by the logarithm of q_j"),
            ),
        ),
    ]


def orientation_kernels() -> list[Kernel]:
    """Section III, (8) and (9)."""
    matrix_in = Input("R", ROTATION, "1", "rotation of the platform")
    matrix_out = Output("rotation", ROTATION, "1", "rotation of the platform")
    return [
        Kernel(
            "rotation_from_rpy",
            "Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).",
            "(9)",
            from_angles_graph(),
            (
                Input("roll", roll, "rad", "about X, first"),
                Input("pitch", pitch, "rad", "about Y, second"),
                Input("yaw", yaw, "rad", "about Z, last"),
            ),
            (matrix_out,),
        ),
        Kernel(
            "rpy_from_rotation",
            "Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.",
            "(9)",
            to_angles_graph(),
            (matrix_in,),
            (
                Output("roll", roll, "rad", "in [−π, π]"),
                Output("pitch", pitch, "rad", "in [−π/2, π/2]"),
                Output("yaw", yaw, "rad", "in [−π, π]"),
            ),
        ),
        Kernel(
            "rotation_from_directions",
            "Rotation from the platform directions n_1 and n_2.",
            "(8)",
            directions_graph(),
            (
                Input("n1", n1, "1", "direction from C to B_1"),
                Input("n2", vector("n2"), "1", "direction from C to B_2"),
            ),
            (matrix_out,),
        ),
        Kernel(
            "rotation_defect",
            "How far a matrix is from a rotation; zero for a rotation.",
            "(8)",
            defect_graph(),
            (POSE[2],),
            (Output("defect", scalar("defect"), "1", "root of the squared defects"),),
        ),
    ]


def velocity_kernels() -> list[Kernel]:
    """Section IV."""
    graph = velocity_graph()
    checks = (INCIDENCE, LEGS, RADIAL, LENGTH, REACH)
    with_scales = singularity_graph()
    screws = tuple(
        Output(f"limb{limb}", matrix(f"screws{limb}", 6, 6), "1, m", f"screws of limb {limb}")
        for limb in (*LIMBS, 4)
    )
    return [
        Kernel(
            "limb_geometry",
            "Points D_i, unit vectors w_i and reciprocal lines S_i.",
            "(7), (14)",
            graph,
            POSE,
            (
                Output("d", matrix("D", 3, 3), "m", "D_i, a row each"),
                Output("w", matrix("W", 3, 3), "1", "w_i, a row each"),
                Output("lines", matrix("S", 3, 6), "1, m", "S_i, a row each"),
            ),
        ),
        Kernel(
            "screws",
            "The joint screws of the four limbs at pole C, a row a joint.",
            "Section IV",
            with_scales,
            (*POSE, HEADING),
            (*screws, *checks),
        ),
        Kernel(
            "jacobians",
            "Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.",
            "(17)-(19), (22)-(24)",
            with_scales,
            (*POSE, HEADING),
            (
                Output("J_v", matrix("J_v", 6, 6), "1, m", "forward Jacobian"),
                Output("J_q", matrix("J_q", 6, 6), "1, m", "inverse Jacobian"),
                *checks,
            ),
        ),
        Kernel(
            "inverse_velocity",
            "Joint rates from the twist.",
            "(15), (16)",
            inverse_velocity_graph(),
            (*POSE, TWIST),
            (Output("rates", matrix("dq", 6, 1), "m/s, rad/s", "q̇1 ... q̇6"), *checks),
        ),
        Kernel(
            "forward_velocity",
            "Twist from the joint rates, and the determinant of its 3×3 with its factors.",
            "(12), (17)",
            forward_velocity_graph(),
            (
                *POSE,
                HEADING,
                Input("rates", ImmutableDenseMatrix(RATES), "m/s, rad/s", "q̇1 ... q̇6"),
            ),
            (
                Output("twist", matrix("V", 6, 1), "rad/s, m/s", "[omega, v_C]"),
                Output("determinant", scalar("det_moments"), "m³", "det of the moments of S_i"),
                EXTENSION,
                EXTENSION_SCALE,
                ORIENTATION,
                ORIENTATION_SCALE,
                *checks,
            ),
        ),
    ]


def singularity_kernels() -> list[Kernel]:
    """Section V."""
    graph = singularity_graph()
    inverse = Output("inverse_determinant", scalar("det_J_q"), "m²", "det J_q")
    direct = Output("direct_determinant", scalar("det_J_v"), "m³", "det J_v")
    return [
        Kernel(
            "inverse_singularity",
            "det J_q and its factors: the product of limb, central and wrist.",
            "(22)-(26)",
            graph,
            POSE,
            (
                Output("determinant", scalar("det_J_q"), "m²", "det J_q"),
                LIMB,
                CENTRAL,
                WRIST,
                LIMB_SCALE,
                CENTRAL_SCALE,
                WRIST_SCALE,
            ),
        ),
        Kernel(
            "direct_singularity",
            "det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.",
            "(27)",
            graph,
            POSE,
            (
                Output("determinant", scalar("det_J_v"), "m³", "det J_v"),
                EXTENSION,
                ORIENTATION,
                WRIST,
                EXTENSION_SCALE,
                ORIENTATION_SCALE,
                WRIST_SCALE,
            ),
        ),
        Kernel(
            "survey",
            "Joint values, extensions, both determinants and their factors in one pass.",
            "(4), (10), (11), (22)-(27)",
            graph,
            POSE,
            (
                JOINTS,
                EXTENSION,
                inverse,
                direct,
                LIMB,
                CENTRAL,
                WRIST,
                ORIENTATION,
                LIMB_SCALE,
                CENTRAL_SCALE,
                WRIST_SCALE,
                EXTENSION_SCALE,
                ORIENTATION_SCALE,
            ),
        ),
    ]


def kernels() -> list[Kernel]:
    """Every kernel, in the order of the paper."""
    return [
        *displacement_kernels(),
        *forward_kernels(),
        *orientation_kernels(),
        *velocity_kernels(),
        *singularity_kernels(),
    ]
