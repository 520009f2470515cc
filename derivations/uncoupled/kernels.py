"""What is generated for this manipulator."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix

from derivations.algebra.vectors import matrix, scalar, vector
from derivations.codegen.kernel import Input, Kernel, Output
from derivations.uncoupled.accelerations import (
    forward_acceleration_graph,
    inverse_acceleration_graph,
)
from derivations.uncoupled.displacement import central_graph, lam, pose_graph, q4, q5, q6
from derivations.uncoupled.fields import (
    ACCELERATIONS_IN,
    ACCELERATIONS_OUT,
    CENTRAL,
    CENTRAL_SCALE,
    EXTENSION,
    EXTENSION_SCALE,
    FORCES_IN,
    HEADING,
    INCIDENCE,
    JOINTS,
    LEGS,
    LENGTH,
    LIMB,
    LIMB_SCALE,
    ORIENTATION,
    ORIENTATION_SCALE,
    POSE,
    POSITION,
    RADIAL,
    RADIUS,
    RATES_IN,
    RATES_OUT,
    REACH,
    ROTATION_IN,
    TWIST,
    TWIST_RATE,
    WRENCH_IN,
    WRIST,
    WRIST_SCALE,
)
from derivations.uncoupled.forward_kernels import forward_kernels
from derivations.uncoupled.geometry import LIMBS, c, n1
from derivations.uncoupled.joint_rates import joint_rates_graph
from derivations.uncoupled.loci import (
    CUBIC,
    direct_locus_graph,
    orientation_locus_graph,
    tilt_shift,
    tilt_turn,
)
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
from derivations.uncoupled.rates import forward_velocity_graph, inverse_velocity_graph
from derivations.uncoupled.singularity import singularity_graph, tilt
from derivations.uncoupled.statics import actuator_forces_graph, platform_wrench_graph
from derivations.uncoupled.velocity import velocity_graph


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
    both = (
        Output("J_v", matrix("J_v", 6, 6), "1, m", "forward Jacobian"),
        Output("J_q", matrix("J_q", 6, 6), "1, m", "inverse Jacobian"),
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
            (*both, *checks),
        ),
        Kernel(
            "joints_and_jacobians",
            "Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.",
            "(10), (11), (17)-(19), (22)-(24)",
            with_scales,
            (*POSE, HEADING),
            (JOINTS, *both),
        ),
        Kernel(
            "inverse_velocity",
            "Joint rates from the twist.",
            "(15), (16)",
            inverse_velocity_graph(),
            (*POSE, TWIST),
            (RATES_OUT, *checks),
        ),
        Kernel(
            "forward_velocity",
            "Twist from the joint rates, and the determinant of its 3×3 with its factors.",
            "(12), (17)",
            forward_velocity_graph(),
            (*POSE, HEADING, RATES_IN),
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
        Kernel(
            "joint_rates",
            "The rates of all joints of the four limbs from the twist.",
            "(12)",
            joint_rates_graph(),
            (*POSE, HEADING, TWIST),
            (
                Output("rates", matrix("limb_rates", 4, 6), "rad/s, m/s", "a row a limb"),
                WRIST,
                WRIST_SCALE,
                *checks,
            ),
        ),
    ]


def statics_kernels() -> list[Kernel]:
    """The dual of Section IV."""
    checks = (INCIDENCE, LEGS, RADIAL, LENGTH, REACH)
    return [
        Kernel(
            "platform_wrench",
            "Wrench that the platform exerts from the forces of the actuators.",
            "(15), (16), by duality",
            platform_wrench_graph(),
            (*POSE, FORCES_IN),
            (
                Output("wrench", matrix("wrench", 6, 1), "N, N m", "[force, moment at C]"),
                *checks,
            ),
        ),
        Kernel(
            "actuator_forces",
            "Forces of the actuators from the wrench that the platform exerts.",
            "(16), (17), by duality",
            actuator_forces_graph(),
            (*POSE, HEADING, WRENCH_IN),
            (
                Output("forces", matrix("forces", 6, 1), "N, N m", "f1 ... f6"),
                EXTENSION,
                EXTENSION_SCALE,
                ORIENTATION,
                ORIENTATION_SCALE,
                *checks,
            ),
        ),
    ]


def acceleration_kernels() -> list[Kernel]:
    """The derivative of Section IV."""
    checks = (INCIDENCE, LEGS, RADIAL, LENGTH, REACH)
    return [
        Kernel(
            "inverse_acceleration",
            "Joint rates and accelerations from the twist and its derivative.",
            "(15), (16), differentiated",
            inverse_acceleration_graph(),
            (*POSE, TWIST, TWIST_RATE),
            (RATES_OUT, ACCELERATIONS_OUT, *checks),
        ),
        Kernel(
            "forward_acceleration",
            "Twist and its derivative from the joint rates and accelerations.",
            "(12), (17), differentiated",
            forward_acceleration_graph(),
            (*POSE, HEADING, RATES_IN, ACCELERATIONS_IN),
            (
                Output("twist", matrix("V", 6, 1), "rad/s, m/s", "[omega, v_C]"),
                Output("twist_rate", matrix("dV", 6, 1), "rad/s², m/s²", "its derivative"),
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
                INCIDENCE,
            ),
        ),
    ]


def locus_kernels() -> list[Kernel]:
    """Section V, as surfaces."""
    return [
        Kernel(
            "direct_locus",
            "The cubic in c on which `orientation` vanishes, at one orientation of the platform: "
            "√3/2 times its value is (p_1 p_2 p_3)² orientation.",
            "(27)",
            direct_locus_graph(),
            (RADIUS, ROTATION_IN),
            (
                Output(
                    "coefficients",
                    CUBIC,
                    "m³, m², m, 1",
                    "at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, "
                    "y²z, yz², z³",
                ),
                INCIDENCE,
            ),
        ),
        Kernel(
            "orientation_locus",
            "The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: "
            "√3/2 times it is (p_1 p_2 p_3)² orientation.",
            "(27)",
            orientation_locus_graph(),
            POSE,
            (
                Output("value", tilt, "m³", "tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + ..."),
                Output("by_turn", tilt_turn, "m³", "its derivative by a turn of the platform"),
                Output("by_position", tilt_shift, "m²", "its derivative by the position"),
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
        *statics_kernels(),
        *acceleration_kernels(),
        *singularity_kernels(),
        *locus_kernels(),
    ]
