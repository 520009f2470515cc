"""What several kernels take or give."""

from __future__ import annotations

from sympy import ImmutableDenseMatrix

from derivations.algebra.vectors import Columns, Rows, matrix, scalar
from derivations.codegen.kernel import Input, Output
from derivations.uncoupled.accelerations import ACCELERATIONS, angular, linear
from derivations.uncoupled.displacement import q6, r
from derivations.uncoupled.geometry import LIMBS, a, c, m1, n1, nu
from derivations.uncoupled.rates import RATES, omega, velocity
from derivations.uncoupled.singularity import central, orientation, reach, wrist
from derivations.uncoupled.statics import FORCES, force, moment
from derivations.uncoupled.velocity import heading

RADIUS = Input("a", a, "m", "radius of the circle through A_1, A_2, A_3")
POSITION = Input("c", c, "m", "position of the platform's centre C")
ROTATION_IN = Input("R", Columns(n1, m1, nu), "1", "rotation of the platform")
POSE = (RADIUS, POSITION, ROTATION_IN)
HEADING = Input(
    "heading", heading, "m", "horizontal vector at azimuth q4: (c_x, c_y) off the Z axis"
)
TWIST = Input("twist", Rows(omega, velocity), "rad/s, m/s", "[omega, v_C]")
TWIST_RATE = Input("twist_rate", Rows(angular, linear), "rad/s², m/s²", "[d omega/dt, dv_C/dt]")
RATES_IN = Input("rates", ImmutableDenseMatrix(RATES), "m/s, rad/s", "q̇1 ... q̇6")
RATES_OUT = Output("rates", matrix("dq", 6, 1), "m/s, rad/s", "q̇1 ... q̇6")
WRENCH_IN = Input("wrench", Rows(force, moment), "N, N m", "[force, moment at C]")
FORCES_IN = Input("forces", ImmutableDenseMatrix(FORCES), "N, N m", "f1 ... f6")
ACCELERATIONS_IN = Input(
    "accelerations", ImmutableDenseMatrix(ACCELERATIONS), "m/s², rad/s²", "q̈1 ... q̈6"
)
ACCELERATIONS_OUT = Output("accelerations", matrix("ddq", 6, 1), "m/s², rad/s²", "q̈1 ... q̈6")

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
