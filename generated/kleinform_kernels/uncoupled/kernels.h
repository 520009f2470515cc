/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
/* Kernels of the uncoupled manipulator 3-RPRRC+RRPRU, one pose a call.

   Plain C99, also C++: no allocation, no globals, nothing but libm. Lengths in m, angles in
   rad, everything in the base frame. A matrix is an array of its rows, one after the other.
   Nothing is checked: a singular pose gives inf, or NaN where 0/0. Arrays must not overlap.
   What goes in is named in_, what comes out out_: no macro of yours, R or I, is in the way.

   Compile without value-changing optimisation (-ffast-math) and with -ffp-contract=off for
   the same results on every machine. */
#ifndef KLEINFORM_KERNELS_H
#define KLEINFORM_KERNELS_H

#ifndef KLEINFORM_API
#define KLEINFORM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Joint values from the pose.
   Equations (3), (4), (10), (11) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_joints[6]: q1 ... q6 [m, rad]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_platform_joints[3][3]: B_i, a row each [m]
   out_incidence[3]: n_i·u_i [1]
   out_radial: distance of C from the Z axis [m] */
KLEINFORM_API void kleinform_inverse_displacement(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double out_joints[6],
    double out_extension[3],
    double out_platform_joints[9],
    double out_incidence[3],
    double *out_radial);

/* Position of C from the joint values of the central limb.
   Equations (1) of the paper; base frame.
   in_joints[3]: q4, q5, q6 [rad, rad, m]
   out_position[3]: position of C [m]
   out_direction[3]: unit vector lambda [1] */
KLEINFORM_API void kleinform_central_forward(
    const double in_joints[3],
    double out_position[3],
    double out_direction[3]);

/* Joint values of the central limb from the position of C.
   Equations (11) of the paper; base frame.
   in_c[3]: position of the platform's centre C [m]
   out_joints[3]: q4, q5, q6 [rad, rad, m]
   out_radial: distance of C from the Z axis [m] */
KLEINFORM_API void kleinform_central_inverse(
    const double in_c[3],
    double out_joints[3],
    double *out_radial);

/* Residual of the six quadratics in (n_1, n_2), and its Jacobian.
   Equations (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_directions[2][3]: n_1 and n_2, a row each [1]
   out_residual[6]: three cones, three unit conditions [m², 1]
   out_jacobian[6][6]: by (n_1, n_2) [m², 1] */
KLEINFORM_API void kleinform_closure(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_directions[6],
    double out_residual[6],
    double out_jacobian[36]);

/* The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.
   Equations (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   out_cone_1[3][3]: M_1, symmetric [m²]
   out_cone_2[3][3]: M_2, symmetric [m²]
   out_cone_3[3][3]: M_3, symmetric [m²] */
KLEINFORM_API void kleinform_cones(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    double out_cone_1[9],
    double out_cone_2[9],
    double out_cone_3[9]);

/* The resultant that vanishes at the angles of leg 1 of the assembly modes.
   Equations (5), (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_angle[2]: cos, sin of leg 1's angle [1]
   in_reference[3]: a vector not parallel to n_1 [1]
   out_eliminant: resultant of the quartics of limbs 2, 3 [m¹⁶]
   out_bound: Hadamard's bound on it [m¹⁶] */
KLEINFORM_API void kleinform_eliminant(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_reference[3],
    double *out_eliminant,
    double *out_bound);

/* The turn about n_1 at a zero of the eliminant, as a half angle.
   Equations (5), (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_angle[2]: cos, sin of leg 1's angle [1]
   in_reference[3]: a vector not parallel to n_1 [1]
   out_frame[3][3]: n_1, f, g, a row each [1]
   out_powers[2][4]: along x³, x²y, xy², y³ twice [m¹²] */
KLEINFORM_API void kleinform_half_turn(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_reference[3],
    double out_frame[9],
    double out_powers[8]);

/* n_1 and n_2 from the frame about n_1 and the half angle of the turn.
   Equations (5) of the paper; base frame.
   in_frame[3][3]: n_1, f, g, a row each [1]
   in_half_angle[2]: (x, y), any length [1]
   out_directions[2][3]: n_1 and n_2, a row each [1] */
KLEINFORM_API void kleinform_turned_directions(
    const double in_frame[9],
    const double in_half_angle[2],
    double out_directions[6]);

/* Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.
   Equations (5), (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_start[2][2]: cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
   out_angle[5][5]: n_1 and n_2 are 120° apart [m⁴]
   out_cone[5][5]: limb 3 closes [m⁶]
   out_first[3][3]: (1 + t²)(b_1 − c) at 1, t, t², a row each [m]
   out_second[3][3]: (1 + s²)(b_2 − c) at 1, s, s², a row each [m] */
KLEINFORM_API void kleinform_circles(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_start[4],
    double out_angle[25],
    double out_cone[25],
    double out_first[9],
    double out_second[9]);

/* The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.
   Equations (3) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_start[2][2]: cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
   in_half_tangents[2]: t, s [1]
   out_arms[2][3]: from C to B_1 and B_2, a row each [m] */
KLEINFORM_API void kleinform_arms(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_start[4],
    const double in_half_tangents[2],
    double out_arms[6]);

/* One step of Newton's method on the rotation, for the three closure equations.
   Equations (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_directions[2][3]: n_1 and n_2, a row each [1]
   out_next[2][3]: n_1, n_2 turned [1]
   out_turn[3]: the step, a rotation vector [rad]
   out_residual[3]: F_1, F_2, F_3 [m²]
   out_gradient[3][3]: of F_i by a turn, a row each [m²]
   out_volume: determinant of the gradient [m⁶] */
KLEINFORM_API void kleinform_newton_step(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_directions[6],
    double out_next[6],
    double out_turn[3],
    double out_residual[3],
    double out_gradient[9],
    double *out_volume);

/* One step of Newton's method in the angle of leg 1 and the turn about n_1.
   Equations (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_lengths[3]: q1, q2, q3 [m]
   in_angle[2]: cos, sin of leg 1's angle [1]
   in_second[3]: n_2, or near it [1]
   out_angle[2]: cos, sin of leg 1's angle [1]
   out_directions[2][3]: n_1 and n_2 [1]
   out_extension: e_1, positive [m]
   out_steps[2]: of leg 1's angle and of the turn [rad] */
KLEINFORM_API void kleinform_leg_step(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_second[3],
    double out_angle[2],
    double out_directions[6],
    double *out_extension,
    double out_steps[2]);

/* What decides whether two assembly modes have merged.
   Equations (6) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_joints[6]: q1 ... q6 [m, rad]
   in_directions[2][3]: n_1 and n_2, a row each [1]
   out_residual[3]: F_1, F_2, F_3 [m²]
   out_gradient[3][3]: of F_i by a turn, a row each [m²]
   out_volume: determinant of the gradient [m⁶]
   out_volume_gradient[3]: of the volume by a turn [m⁶]
   out_by_joints[3][6]: of F_i by the logarithm of q_j [m²] */
KLEINFORM_API void kleinform_fold(
    double in_a,
    const double in_joints[6],
    const double in_directions[6],
    double out_residual[3],
    double out_gradient[9],
    double *out_volume,
    double out_volume_gradient[3],
    double out_by_joints[18]);

/* Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).
   Equations (9) of the paper; base frame.
   in_roll: about X, first [rad]
   in_pitch: about Y, second [rad]
   in_yaw: about Z, last [rad]
   out_rotation[3][3]: rotation of the platform [1] */
KLEINFORM_API void kleinform_rotation_from_rpy(
    double in_roll,
    double in_pitch,
    double in_yaw,
    double out_rotation[9]);

/* Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.
   Equations (9) of the paper; base frame.
   in_R[3][3]: rotation of the platform [1]
   out_roll: in [−π, π] [rad]
   out_pitch: in [−π/2, π/2] [rad]
   out_yaw: in [−π, π] [rad] */
KLEINFORM_API void kleinform_rpy_from_rotation(
    const double in_R[9],
    double *out_roll,
    double *out_pitch,
    double *out_yaw);

/* Rotation from the platform directions n_1 and n_2.
   Equations (8) of the paper; base frame.
   in_n1[3]: direction from C to B_1 [1]
   in_n2[3]: direction from C to B_2 [1]
   out_rotation[3][3]: rotation of the platform [1] */
KLEINFORM_API void kleinform_rotation_from_directions(
    const double in_n1[3],
    const double in_n2[3],
    double out_rotation[9]);

/* How far a matrix is from a rotation; zero for a rotation.
   Equations (8) of the paper; base frame.
   in_R[3][3]: rotation of the platform [1]
   out_defect: root of the squared defects [1] */
KLEINFORM_API void kleinform_rotation_defect(
    const double in_R[9],
    double *out_defect);

/* Points D_i, unit vectors w_i and reciprocal lines S_i.
   Equations (7), (14) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_d[3][3]: D_i, a row each [m]
   out_w[3][3]: w_i, a row each [1]
   out_lines[3][6]: S_i, a row each [1, m] */
KLEINFORM_API void kleinform_limb_geometry(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double out_d[9],
    double out_w[9],
    double out_lines[18]);

/* The joint screws of the four limbs at pole C, a row a joint.
   Equations Section IV of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out_limb1[6][6]: screws of limb 1 [1, m]
   out_limb2[6][6]: screws of limb 2 [1, m]
   out_limb3[6][6]: screws of limb 3 [1, m]
   out_limb4[6][6]: screws of limb 4 [1, m]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_screws(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    double out_limb1[36],
    double out_limb2[36],
    double out_limb3[36],
    double out_limb4[36],
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.
   Equations (17)-(19), (22)-(24) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out_J_v[6][6]: forward Jacobian [1, m]
   out_J_q[6][6]: inverse Jacobian [1, m]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_jacobians(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    double out_J_v[36],
    double out_J_q[36],
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.
   Equations (10), (11), (17)-(19), (22)-(24) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out_joints[6]: q1 ... q6 [m, rad]
   out_J_v[6][6]: forward Jacobian [1, m]
   out_J_q[6][6]: inverse Jacobian [1, m] */
KLEINFORM_API void kleinform_joints_and_jacobians(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    double out_joints[6],
    double out_J_v[36],
    double out_J_q[36]);

/* Joint rates from the twist.
   Equations (15), (16) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_twist[2][3]: [omega, v_C] [rad/s, m/s]
   out_rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_inverse_velocity(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_twist[6],
    double out_rates[6],
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Twist from the joint rates, and the determinant of its 3×3 with its factors.
   Equations (12), (17) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in_rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out_twist[6]: [omega, v_C] [rad/s, m/s]
   out_determinant: det of the moments of S_i [m³]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_extension_scale[3]: scales of the e_i [m]
   out_orientation: det[n_i × (d_i − c)] [m³]
   out_orientation_scale: scale of orientation [m³]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_forward_velocity(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    const double in_rates[6],
    double out_twist[6],
    double *out_determinant,
    double out_extension[3],
    double out_extension_scale[3],
    double *out_orientation,
    double *out_orientation_scale,
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* The rates of all joints of the four limbs from the twist.
   Equations (12) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in_twist[2][3]: [omega, v_C] [rad/s, m/s]
   out_rates[4][6]: a row a limb [rad/s, m/s]
   out_wrist: (n_1 × n_2)·lambda [1]
   out_wrist_scale: scale of wrist [1]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_joint_rates(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    const double in_twist[6],
    double out_rates[24],
    double *out_wrist,
    double *out_wrist_scale,
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Wrench that the platform exerts from the forces of the actuators.
   Equations (15), (16), by duality of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_forces[6]: f1 ... f6 [N, N m]
   out_wrench[6]: [force, moment at C] [N, N m]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_platform_wrench(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_forces[6],
    double out_wrench[6],
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Forces of the actuators from the wrench that the platform exerts.
   Equations (16), (17), by duality of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in_wrench[2][3]: [force, moment at C] [N, N m]
   out_forces[6]: f1 ... f6 [N, N m]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_extension_scale[3]: scales of the e_i [m]
   out_orientation: det[n_i × (d_i − c)] [m³]
   out_orientation_scale: scale of orientation [m³]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_actuator_forces(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    const double in_wrench[6],
    double out_forces[6],
    double out_extension[3],
    double out_extension_scale[3],
    double *out_orientation,
    double *out_orientation_scale,
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Joint rates and accelerations from the twist and its derivative.
   Equations (15), (16), differentiated of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_twist[2][3]: [omega, v_C] [rad/s, m/s]
   in_twist_rate[2][3]: [d omega/dt, dv_C/dt] [rad/s², m/s²]
   out_rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out_accelerations[6]: q̈1 ... q̈6 [m/s², rad/s²]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_inverse_acceleration(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_twist[6],
    const double in_twist_rate[6],
    double out_rates[6],
    double out_accelerations[6],
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* Twist and its derivative from the joint rates and accelerations.
   Equations (12), (17), differentiated of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   in_heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in_rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   in_accelerations[6]: q̈1 ... q̈6 [m/s², rad/s²]
   out_twist[6]: [omega, v_C] [rad/s, m/s]
   out_twist_rate[6]: its derivative [rad/s², m/s²]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_extension_scale[3]: scales of the e_i [m]
   out_orientation: det[n_i × (d_i − c)] [m³]
   out_orientation_scale: scale of orientation [m³]
   out_incidence[3]: n_i·u_i [1]
   out_scaled_legs[3]: |n_i·u_i| q_i [m]
   out_radial: distance of C from the Z axis [m]
   out_central_length: distance from O to C [m]
   out_reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_forward_acceleration(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    const double in_rates[6],
    const double in_accelerations[6],
    double out_twist[6],
    double out_twist_rate[6],
    double out_extension[3],
    double out_extension_scale[3],
    double *out_orientation,
    double *out_orientation_scale,
    double out_incidence[3],
    double out_scaled_legs[3],
    double *out_radial,
    double *out_central_length,
    double *out_reach);

/* det J_q and its factors: the product of limb, central and wrist.
   Equations (22)-(26) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_determinant: det J_q [m²]
   out_limb[3]: Klein forms of S_i and the actuated screw [1]
   out_central: q6² cos q5 [m²]
   out_wrist: (n_1 × n_2)·lambda [1]
   out_limb_scale[3]: scales of limb [1]
   out_central_scale: scale of central [m²]
   out_wrist_scale: scale of wrist [1] */
KLEINFORM_API void kleinform_inverse_singularity(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double *out_determinant,
    double out_limb[3],
    double *out_central,
    double *out_wrist,
    double out_limb_scale[3],
    double *out_central_scale,
    double *out_wrist_scale);

/* det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.
   Equations (27) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_determinant: det J_v [m³]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_orientation: det[n_i × (d_i − c)] [m³]
   out_wrist: (n_1 × n_2)·lambda [1]
   out_extension_scale[3]: scales of the e_i [m]
   out_orientation_scale: scale of orientation [m³]
   out_wrist_scale: scale of wrist [1] */
KLEINFORM_API void kleinform_direct_singularity(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double *out_determinant,
    double out_extension[3],
    double *out_orientation,
    double *out_wrist,
    double out_extension_scale[3],
    double *out_orientation_scale,
    double *out_wrist_scale);

/* Joint values, extensions, both determinants and their factors in one pass.
   Equations (4), (10), (11), (22)-(27) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_joints[6]: q1 ... q6 [m, rad]
   out_extension[3]: signed distances e_i from C to B_i [m]
   out_inverse_determinant: det J_q [m²]
   out_direct_determinant: det J_v [m³]
   out_limb[3]: Klein forms of S_i and the actuated screw [1]
   out_central: q6² cos q5 [m²]
   out_wrist: (n_1 × n_2)·lambda [1]
   out_orientation: det[n_i × (d_i − c)] [m³]
   out_limb_scale[3]: scales of limb [1]
   out_central_scale: scale of central [m²]
   out_wrist_scale: scale of wrist [1]
   out_extension_scale[3]: scales of the e_i [m]
   out_orientation_scale: scale of orientation [m³]
   out_incidence[3]: n_i·u_i [1] */
KLEINFORM_API void kleinform_survey(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double out_joints[6],
    double out_extension[3],
    double *out_inverse_determinant,
    double *out_direct_determinant,
    double out_limb[3],
    double *out_central,
    double *out_wrist,
    double *out_orientation,
    double out_limb_scale[3],
    double *out_central_scale,
    double *out_wrist_scale,
    double out_extension_scale[3],
    double *out_orientation_scale,
    double out_incidence[3]);

/* The cubic in c on which `orientation` vanishes, at one orientation of the platform: √3/2 times its value is (p_1 p_2 p_3)² orientation.
   Equations (27) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_R[3][3]: rotation of the platform [1]
   out_coefficients[20]: at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³ [m³, m², m, 1]
   out_incidence[3]: n_i·u_i [1] */
KLEINFORM_API void kleinform_direct_locus(
    double in_a,
    const double in_R[9],
    double out_coefficients[20],
    double out_incidence[3]);

/* The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: √3/2 times it is (p_1 p_2 p_3)² orientation.
   Equations (27) of the paper; base frame.
   in_a: radius of the circle through A_1, A_2, A_3 [m]
   in_c[3]: position of the platform's centre C [m]
   in_R[3][3]: rotation of the platform [1]
   out_value: tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + ... [m³]
   out_by_turn[3]: its derivative by a turn of the platform [m³]
   out_by_position[3]: its derivative by the position [m²] */
KLEINFORM_API void kleinform_orientation_locus(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double *out_value,
    double out_by_turn[3],
    double out_by_position[3]);

#ifdef __cplusplus
}
#endif

#endif
