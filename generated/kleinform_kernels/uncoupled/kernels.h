/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
/* Kernels of the uncoupled manipulator 3-RPRRC+RRPRU, one pose a call.

   Plain C99, also C++: no allocation, no globals, nothing but libm. Lengths in m, angles in
   rad, everything in the base frame. A matrix is an array of its rows, one after the other.
   Nothing is checked: a singular pose gives inf, or NaN where 0/0. Arrays must not overlap.

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
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out joints[6]: q1 ... q6 [m, rad]
   out extension[3]: signed distances e_i from C to B_i [m]
   out platform_joints[3][3]: B_i, a row each [m]
   out incidence[3]: n_i·u_i [1]
   out radial: distance of C from the Z axis [m] */
KLEINFORM_API void kleinform_inverse_displacement(
    double a,
    const double c[3],
    const double R[9],
    double joints[6],
    double extension[3],
    double platform_joints[9],
    double incidence[3],
    double *radial);

/* Position of C from the joint values of the central limb.
   Equations (1) of the paper; base frame.
   in  joints[3]: q4, q5, q6 [rad, rad, m]
   out position[3]: position of C [m]
   out direction[3]: unit vector lambda [1] */
KLEINFORM_API void kleinform_central_forward(
    const double joints[3],
    double position[3],
    double direction[3]);

/* Joint values of the central limb from the position of C.
   Equations (11) of the paper; base frame.
   in  c[3]: position of the platform's centre C [m]
   out joints[3]: q4, q5, q6 [rad, rad, m]
   out radial: distance of C from the Z axis [m] */
KLEINFORM_API void kleinform_central_inverse(
    const double c[3],
    double joints[3],
    double *radial);

/* Residual of the six quadratics in (n_1, n_2), and its Jacobian.
   Equations (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  directions[2][3]: n_1 and n_2, a row each [1]
   out residual[6]: three cones, three unit conditions [m², 1]
   out jacobian[6][6]: by (n_1, n_2) [m², 1] */
KLEINFORM_API void kleinform_closure(
    double a,
    const double c[3],
    const double lengths[3],
    const double directions[6],
    double residual[6],
    double jacobian[36]);

/* The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.
   Equations (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   out cone_1[3][3]: M_1, symmetric [m²]
   out cone_2[3][3]: M_2, symmetric [m²]
   out cone_3[3][3]: M_3, symmetric [m²] */
KLEINFORM_API void kleinform_cones(
    double a,
    const double c[3],
    const double lengths[3],
    double cone_1[9],
    double cone_2[9],
    double cone_3[9]);

/* The resultant that vanishes at the angles of leg 1 of the assembly modes.
   Equations (5), (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  angle[2]: cos, sin of leg 1's angle [1]
   in  reference[3]: a vector not parallel to n_1 [1]
   out eliminant: resultant of the quartics of limbs 2, 3 [m¹⁶]
   out bound: Hadamard's bound on it [m¹⁶] */
KLEINFORM_API void kleinform_eliminant(
    double a,
    const double c[3],
    const double lengths[3],
    const double angle[2],
    const double reference[3],
    double *eliminant,
    double *bound);

/* The turn about n_1 at a zero of the eliminant, as a half angle.
   Equations (5), (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  angle[2]: cos, sin of leg 1's angle [1]
   in  reference[3]: a vector not parallel to n_1 [1]
   out frame[3][3]: n_1, f, g, a row each [1]
   out powers[2][4]: along x³, x²y, xy², y³ twice [m¹²] */
KLEINFORM_API void kleinform_half_turn(
    double a,
    const double c[3],
    const double lengths[3],
    const double angle[2],
    const double reference[3],
    double frame[9],
    double powers[8]);

/* n_1 and n_2 from the frame about n_1 and the half angle of the turn.
   Equations (5) of the paper; base frame.
   in  frame[3][3]: n_1, f, g, a row each [1]
   in  half_angle[2]: (x, y), any length [1]
   out directions[2][3]: n_1 and n_2, a row each [1] */
KLEINFORM_API void kleinform_turned_directions(
    const double frame[9],
    const double half_angle[2],
    double directions[6]);

/* Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.
   Equations (5), (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  start[2][2]: cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
   out angle[5][5]: n_1 and n_2 are 120° apart [m⁴]
   out cone[5][5]: limb 3 closes [m⁶]
   out first[3][3]: (1 + t²)(b_1 − c) at 1, t, t², a row each [m]
   out second[3][3]: (1 + s²)(b_2 − c) at 1, s, s², a row each [m] */
KLEINFORM_API void kleinform_circles(
    double a,
    const double c[3],
    const double lengths[3],
    const double start[4],
    double angle[25],
    double cone[25],
    double first[9],
    double second[9]);

/* The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.
   Equations (3) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  start[2][2]: cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
   in  half_tangents[2]: t, s [1]
   out arms[2][3]: from C to B_1 and B_2, a row each [m] */
KLEINFORM_API void kleinform_arms(
    double a,
    const double c[3],
    const double lengths[3],
    const double start[4],
    const double half_tangents[2],
    double arms[6]);

/* One step of Newton's method on the rotation, for the three closure equations.
   Equations (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  directions[2][3]: n_1 and n_2, a row each [1]
   out next[2][3]: n_1, n_2 turned [1]
   out turn[3]: the step, a rotation vector [rad]
   out residual[3]: F_1, F_2, F_3 [m²]
   out gradient[3][3]: of F_i by a turn, a row each [m²]
   out volume: determinant of the gradient [m⁶] */
KLEINFORM_API void kleinform_newton_step(
    double a,
    const double c[3],
    const double lengths[3],
    const double directions[6],
    double next[6],
    double turn[3],
    double residual[3],
    double gradient[9],
    double *volume);

/* One step of Newton's method in the angle of leg 1 and the turn about n_1.
   Equations (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  lengths[3]: q1, q2, q3 [m]
   in  angle[2]: cos, sin of leg 1's angle [1]
   in  second[3]: n_2, or near it [1]
   out angle_out[2]: cos, sin of leg 1's angle [1]
   out directions[2][3]: n_1 and n_2 [1]
   out extension: e_1, positive [m]
   out steps[2]: of leg 1's angle and of the turn [rad] */
KLEINFORM_API void kleinform_leg_step(
    double a,
    const double c[3],
    const double lengths[3],
    const double angle[2],
    const double second[3],
    double angle_out[2],
    double directions[6],
    double *extension,
    double steps[2]);

/* What decides whether two assembly modes have merged.
   Equations (6) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  joints[6]: q1 ... q6 [m, rad]
   in  directions[2][3]: n_1 and n_2, a row each [1]
   out residual[3]: F_1, F_2, F_3 [m²]
   out gradient[3][3]: of F_i by a turn, a row each [m²]
   out volume: determinant of the gradient [m⁶]
   out volume_gradient[3]: of the volume by a turn [m⁶]
   out by_joints[3][6]: of F_i by the logarithm of q_j [m²] */
KLEINFORM_API void kleinform_fold(
    double a,
    const double joints[6],
    const double directions[6],
    double residual[3],
    double gradient[9],
    double *volume,
    double volume_gradient[3],
    double by_joints[18]);

/* Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).
   Equations (9) of the paper; base frame.
   in  roll: about X, first [rad]
   in  pitch: about Y, second [rad]
   in  yaw: about Z, last [rad]
   out rotation[3][3]: rotation of the platform [1] */
KLEINFORM_API void kleinform_rotation_from_rpy(
    double roll,
    double pitch,
    double yaw,
    double rotation[9]);

/* Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.
   Equations (9) of the paper; base frame.
   in  R[3][3]: rotation of the platform [1]
   out roll: in [−π, π] [rad]
   out pitch: in [−π/2, π/2] [rad]
   out yaw: in [−π, π] [rad] */
KLEINFORM_API void kleinform_rpy_from_rotation(
    const double R[9],
    double *roll,
    double *pitch,
    double *yaw);

/* Rotation from the platform directions n_1 and n_2.
   Equations (8) of the paper; base frame.
   in  n1[3]: direction from C to B_1 [1]
   in  n2[3]: direction from C to B_2 [1]
   out rotation[3][3]: rotation of the platform [1] */
KLEINFORM_API void kleinform_rotation_from_directions(
    const double n1[3],
    const double n2[3],
    double rotation[9]);

/* How far a matrix is from a rotation; zero for a rotation.
   Equations (8) of the paper; base frame.
   in  R[3][3]: rotation of the platform [1]
   out defect: root of the squared defects [1] */
KLEINFORM_API void kleinform_rotation_defect(
    const double R[9],
    double *defect);

/* Points D_i, unit vectors w_i and reciprocal lines S_i.
   Equations (7), (14) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out d[3][3]: D_i, a row each [m]
   out w[3][3]: w_i, a row each [1]
   out lines[3][6]: S_i, a row each [1, m] */
KLEINFORM_API void kleinform_limb_geometry(
    double a,
    const double c[3],
    const double R[9],
    double d[9],
    double w[9],
    double lines[18]);

/* The joint screws of the four limbs at pole C, a row a joint.
   Equations Section IV of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out limb1[6][6]: screws of limb 1 [1, m]
   out limb2[6][6]: screws of limb 2 [1, m]
   out limb3[6][6]: screws of limb 3 [1, m]
   out limb4[6][6]: screws of limb 4 [1, m]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_screws(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    double limb1[36],
    double limb2[36],
    double limb3[36],
    double limb4[36],
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.
   Equations (17)-(19), (22)-(24) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out J_v[6][6]: forward Jacobian [1, m]
   out J_q[6][6]: inverse Jacobian [1, m]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_jacobians(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    double J_v[36],
    double J_q[36],
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.
   Equations (10), (11), (17)-(19), (22)-(24) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   out joints[6]: q1 ... q6 [m, rad]
   out J_v[6][6]: forward Jacobian [1, m]
   out J_q[6][6]: inverse Jacobian [1, m] */
KLEINFORM_API void kleinform_joints_and_jacobians(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    double joints[6],
    double J_v[36],
    double J_q[36]);

/* Joint rates from the twist.
   Equations (15), (16) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  twist[2][3]: [omega, v_C] [rad/s, m/s]
   out rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_inverse_velocity(
    double a,
    const double c[3],
    const double R[9],
    const double twist[6],
    double rates[6],
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Twist from the joint rates, and the determinant of its 3×3 with its factors.
   Equations (12), (17) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in  rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out twist[6]: [omega, v_C] [rad/s, m/s]
   out determinant: det of the moments of S_i [m³]
   out extension[3]: signed distances e_i from C to B_i [m]
   out extension_scale[3]: scales of the e_i [m]
   out orientation: det[n_i × (d_i − c)] [m³]
   out orientation_scale: scale of orientation [m³]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_forward_velocity(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    const double rates[6],
    double twist[6],
    double *determinant,
    double extension[3],
    double extension_scale[3],
    double *orientation,
    double *orientation_scale,
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* The rates of all joints of the four limbs from the twist.
   Equations (12) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in  twist[2][3]: [omega, v_C] [rad/s, m/s]
   out rates[4][6]: a row a limb [rad/s, m/s]
   out wrist: (n_1 × n_2)·lambda [1]
   out wrist_scale: scale of wrist [1]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_joint_rates(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    const double twist[6],
    double rates[24],
    double *wrist,
    double *wrist_scale,
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Wrench that the platform exerts from the forces of the actuators.
   Equations (15), (16), by duality of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  forces[6]: f1 ... f6 [N, N m]
   out wrench[6]: [force, moment at C] [N, N m]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_platform_wrench(
    double a,
    const double c[3],
    const double R[9],
    const double forces[6],
    double wrench[6],
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Forces of the actuators from the wrench that the platform exerts.
   Equations (16), (17), by duality of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in  wrench[2][3]: [force, moment at C] [N, N m]
   out forces[6]: f1 ... f6 [N, N m]
   out extension[3]: signed distances e_i from C to B_i [m]
   out extension_scale[3]: scales of the e_i [m]
   out orientation: det[n_i × (d_i − c)] [m³]
   out orientation_scale: scale of orientation [m³]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_actuator_forces(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    const double wrench[6],
    double forces[6],
    double extension[3],
    double extension_scale[3],
    double *orientation,
    double *orientation_scale,
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Joint rates and accelerations from the twist and its derivative.
   Equations (15), (16), differentiated of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  twist[2][3]: [omega, v_C] [rad/s, m/s]
   in  twist_rate[2][3]: [d omega/dt, dv_C/dt] [rad/s², m/s²]
   out rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   out accelerations[6]: q̈1 ... q̈6 [m/s², rad/s²]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_inverse_acceleration(
    double a,
    const double c[3],
    const double R[9],
    const double twist[6],
    const double twist_rate[6],
    double rates[6],
    double accelerations[6],
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* Twist and its derivative from the joint rates and accelerations.
   Equations (12), (17), differentiated of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   in  heading[2]: horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
   in  rates[6]: q̇1 ... q̇6 [m/s, rad/s]
   in  accelerations[6]: q̈1 ... q̈6 [m/s², rad/s²]
   out twist[6]: [omega, v_C] [rad/s, m/s]
   out twist_rate[6]: its derivative [rad/s², m/s²]
   out extension[3]: signed distances e_i from C to B_i [m]
   out extension_scale[3]: scales of the e_i [m]
   out orientation: det[n_i × (d_i − c)] [m³]
   out orientation_scale: scale of orientation [m³]
   out incidence[3]: n_i·u_i [1]
   out scaled_legs[3]: |n_i·u_i| q_i [m]
   out radial: distance of C from the Z axis [m]
   out central_length: distance from O to C [m]
   out reach: a + 2 |c|, against which the legs' rounding is judged [m] */
KLEINFORM_API void kleinform_forward_acceleration(
    double a,
    const double c[3],
    const double R[9],
    const double heading[2],
    const double rates[6],
    const double accelerations[6],
    double twist[6],
    double twist_rate[6],
    double extension[3],
    double extension_scale[3],
    double *orientation,
    double *orientation_scale,
    double incidence[3],
    double scaled_legs[3],
    double *radial,
    double *central_length,
    double *reach);

/* det J_q and its factors: the product of limb, central and wrist.
   Equations (22)-(26) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out determinant: det J_q [m²]
   out limb[3]: Klein forms of S_i and the actuated screw [1]
   out central: q6² cos q5 [m²]
   out wrist: (n_1 × n_2)·lambda [1]
   out limb_scale[3]: scales of limb [1]
   out central_scale: scale of central [m²]
   out wrist_scale: scale of wrist [1] */
KLEINFORM_API void kleinform_inverse_singularity(
    double a,
    const double c[3],
    const double R[9],
    double *determinant,
    double limb[3],
    double *central,
    double *wrist,
    double limb_scale[3],
    double *central_scale,
    double *wrist_scale);

/* det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.
   Equations (27) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out determinant: det J_v [m³]
   out extension[3]: signed distances e_i from C to B_i [m]
   out orientation: det[n_i × (d_i − c)] [m³]
   out wrist: (n_1 × n_2)·lambda [1]
   out extension_scale[3]: scales of the e_i [m]
   out orientation_scale: scale of orientation [m³]
   out wrist_scale: scale of wrist [1] */
KLEINFORM_API void kleinform_direct_singularity(
    double a,
    const double c[3],
    const double R[9],
    double *determinant,
    double extension[3],
    double *orientation,
    double *wrist,
    double extension_scale[3],
    double *orientation_scale,
    double *wrist_scale);

/* Joint values, extensions, both determinants and their factors in one pass.
   Equations (4), (10), (11), (22)-(27) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out joints[6]: q1 ... q6 [m, rad]
   out extension[3]: signed distances e_i from C to B_i [m]
   out inverse_determinant: det J_q [m²]
   out direct_determinant: det J_v [m³]
   out limb[3]: Klein forms of S_i and the actuated screw [1]
   out central: q6² cos q5 [m²]
   out wrist: (n_1 × n_2)·lambda [1]
   out orientation: det[n_i × (d_i − c)] [m³]
   out limb_scale[3]: scales of limb [1]
   out central_scale: scale of central [m²]
   out wrist_scale: scale of wrist [1]
   out extension_scale[3]: scales of the e_i [m]
   out orientation_scale: scale of orientation [m³]
   out incidence[3]: n_i·u_i [1] */
KLEINFORM_API void kleinform_survey(
    double a,
    const double c[3],
    const double R[9],
    double joints[6],
    double extension[3],
    double *inverse_determinant,
    double *direct_determinant,
    double limb[3],
    double *central,
    double *wrist,
    double *orientation,
    double limb_scale[3],
    double *central_scale,
    double *wrist_scale,
    double extension_scale[3],
    double *orientation_scale,
    double incidence[3]);

/* The cubic in c on which `orientation` vanishes, at one orientation of the platform: √3/2 times its value is (p_1 p_2 p_3)² orientation.
   Equations (27) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  R[3][3]: rotation of the platform [1]
   out coefficients[20]: at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³ [m³, m², m, 1]
   out incidence[3]: n_i·u_i [1] */
KLEINFORM_API void kleinform_direct_locus(
    double a,
    const double R[9],
    double coefficients[20],
    double incidence[3]);

/* The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: √3/2 times it is (p_1 p_2 p_3)² orientation.
   Equations (27) of the paper; base frame.
   in  a: radius of the circle through A_1, A_2, A_3 [m]
   in  c[3]: position of the platform's centre C [m]
   in  R[3][3]: rotation of the platform [1]
   out value: tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + ... [m³]
   out by_turn[3]: its derivative by a turn of the platform [m³]
   out by_position[3]: its derivative by the position [m²] */
KLEINFORM_API void kleinform_orientation_locus(
    double a,
    const double c[3],
    const double R[9],
    double *value,
    double by_turn[3],
    double by_position[3]);

#ifdef __cplusplus
}
#endif

#endif
