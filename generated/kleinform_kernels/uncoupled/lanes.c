/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
/* Every kernel on LANES poses at once: entry k of a lane at [k*LANES], what goes in and what
   comes out each in one array. Compiled once for each set of instructions, VARIANT. */
#include "simd.h"
#include "table.h"

#define KLEINFORM_API static inline
#define KLEINFORM_BODY INLINE
#include "kernels.c"

static void inverse_displacement_one(const double *RESTRICT in, double *RESTRICT out)
{
    inverse_displacement_body(1, in + 0, in + 1, in + 4, out + 0, out + 6, out + 9, out + 18, out + 21);
}

static void inverse_displacement_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        inverse_displacement_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 18 * LANES + lane, out + 21 * LANES + lane);
}

static void central_forward_one(const double *RESTRICT in, double *RESTRICT out)
{
    central_forward_body(1, in + 0, out + 0, out + 3);
}

static void central_forward_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        central_forward_body(LANES, in + 0 * LANES + lane, out + 0 * LANES + lane, out + 3 * LANES + lane);
}

static void central_inverse_one(const double *RESTRICT in, double *RESTRICT out)
{
    central_inverse_body(1, in + 0, out + 0, out + 3);
}

static void central_inverse_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        central_inverse_body(LANES, in + 0 * LANES + lane, out + 0 * LANES + lane, out + 3 * LANES + lane);
}

static void closure_one(const double *RESTRICT in, double *RESTRICT out)
{
    closure_body(1, in + 0, in + 1, in + 4, in + 7, out + 0, out + 6);
}

static void closure_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        closure_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane);
}

static void cones_one(const double *RESTRICT in, double *RESTRICT out)
{
    cones_body(1, in + 0, in + 1, in + 4, out + 0, out + 9, out + 18);
}

static void cones_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        cones_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 9 * LANES + lane, out + 18 * LANES + lane);
}

static void eliminant_one(const double *RESTRICT in, double *RESTRICT out)
{
    eliminant_body(1, in + 0, in + 1, in + 4, in + 7, in + 9, out + 0, out + 1);
}

static void eliminant_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        eliminant_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, in + 9 * LANES + lane, out + 0 * LANES + lane, out + 1 * LANES + lane);
}

static void half_turn_one(const double *RESTRICT in, double *RESTRICT out)
{
    half_turn_body(1, in + 0, in + 1, in + 4, in + 7, in + 9, out + 0, out + 9);
}

static void half_turn_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        half_turn_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, in + 9 * LANES + lane, out + 0 * LANES + lane, out + 9 * LANES + lane);
}

static void turned_directions_one(const double *RESTRICT in, double *RESTRICT out)
{
    turned_directions_body(1, in + 0, in + 9, out + 0);
}

static void turned_directions_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        turned_directions_body(LANES, in + 0 * LANES + lane, in + 9 * LANES + lane, out + 0 * LANES + lane);
}

static void circles_one(const double *RESTRICT in, double *RESTRICT out)
{
    circles_body(1, in + 0, in + 1, in + 4, in + 7, out + 0, out + 25, out + 50, out + 59);
}

static void circles_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        circles_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, out + 0 * LANES + lane, out + 25 * LANES + lane, out + 50 * LANES + lane, out + 59 * LANES + lane);
}

static void arms_one(const double *RESTRICT in, double *RESTRICT out)
{
    arms_body(1, in + 0, in + 1, in + 4, in + 7, in + 11, out + 0);
}

static void arms_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        arms_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, in + 11 * LANES + lane, out + 0 * LANES + lane);
}

static void newton_step_one(const double *RESTRICT in, double *RESTRICT out)
{
    newton_step_body(1, in + 0, in + 1, in + 4, in + 7, out + 0, out + 6, out + 9, out + 12, out + 21);
}

static void newton_step_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        newton_step_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 12 * LANES + lane, out + 21 * LANES + lane);
}

static void leg_step_one(const double *RESTRICT in, double *RESTRICT out)
{
    leg_step_body(1, in + 0, in + 1, in + 4, in + 7, in + 9, out + 0, out + 2, out + 8, out + 9);
}

static void leg_step_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        leg_step_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 7 * LANES + lane, in + 9 * LANES + lane, out + 0 * LANES + lane, out + 2 * LANES + lane, out + 8 * LANES + lane, out + 9 * LANES + lane);
}

static void fold_one(const double *RESTRICT in, double *RESTRICT out)
{
    fold_body(1, in + 0, in + 1, in + 7, out + 0, out + 3, out + 12, out + 13, out + 16);
}

static void fold_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        fold_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 7 * LANES + lane, out + 0 * LANES + lane, out + 3 * LANES + lane, out + 12 * LANES + lane, out + 13 * LANES + lane, out + 16 * LANES + lane);
}

static void rotation_from_rpy_one(const double *RESTRICT in, double *RESTRICT out)
{
    rotation_from_rpy_body(1, in + 0, in + 1, in + 2, out + 0);
}

static void rotation_from_rpy_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        rotation_from_rpy_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 2 * LANES + lane, out + 0 * LANES + lane);
}

static void rpy_from_rotation_one(const double *RESTRICT in, double *RESTRICT out)
{
    rpy_from_rotation_body(1, in + 0, out + 0, out + 1, out + 2);
}

static void rpy_from_rotation_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        rpy_from_rotation_body(LANES, in + 0 * LANES + lane, out + 0 * LANES + lane, out + 1 * LANES + lane, out + 2 * LANES + lane);
}

static void rotation_from_directions_one(const double *RESTRICT in, double *RESTRICT out)
{
    rotation_from_directions_body(1, in + 0, in + 3, out + 0);
}

static void rotation_from_directions_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        rotation_from_directions_body(LANES, in + 0 * LANES + lane, in + 3 * LANES + lane, out + 0 * LANES + lane);
}

static void rotation_defect_one(const double *RESTRICT in, double *RESTRICT out)
{
    rotation_defect_body(1, in + 0, out + 0);
}

static void rotation_defect_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        rotation_defect_body(LANES, in + 0 * LANES + lane, out + 0 * LANES + lane);
}

static void limb_geometry_one(const double *RESTRICT in, double *RESTRICT out)
{
    limb_geometry_body(1, in + 0, in + 1, in + 4, out + 0, out + 9, out + 18);
}

static void limb_geometry_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        limb_geometry_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 9 * LANES + lane, out + 18 * LANES + lane);
}

static void screws_one(const double *RESTRICT in, double *RESTRICT out)
{
    screws_body(1, in + 0, in + 1, in + 4, in + 13, out + 0, out + 36, out + 72, out + 108, out + 144, out + 147, out + 150, out + 151, out + 152);
}

static void screws_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        screws_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, out + 0 * LANES + lane, out + 36 * LANES + lane, out + 72 * LANES + lane, out + 108 * LANES + lane, out + 144 * LANES + lane, out + 147 * LANES + lane, out + 150 * LANES + lane, out + 151 * LANES + lane, out + 152 * LANES + lane);
}

static void jacobians_one(const double *RESTRICT in, double *RESTRICT out)
{
    jacobians_body(1, in + 0, in + 1, in + 4, in + 13, out + 0, out + 36, out + 72, out + 75, out + 78, out + 79, out + 80);
}

static void jacobians_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        jacobians_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, out + 0 * LANES + lane, out + 36 * LANES + lane, out + 72 * LANES + lane, out + 75 * LANES + lane, out + 78 * LANES + lane, out + 79 * LANES + lane, out + 80 * LANES + lane);
}

static void joints_and_jacobians_one(const double *RESTRICT in, double *RESTRICT out)
{
    joints_and_jacobians_body(1, in + 0, in + 1, in + 4, in + 13, out + 0, out + 6, out + 42);
}

static void joints_and_jacobians_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        joints_and_jacobians_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 42 * LANES + lane);
}

static void inverse_velocity_one(const double *RESTRICT in, double *RESTRICT out)
{
    inverse_velocity_body(1, in + 0, in + 1, in + 4, in + 13, out + 0, out + 6, out + 9, out + 12, out + 13, out + 14);
}

static void inverse_velocity_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        inverse_velocity_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 12 * LANES + lane, out + 13 * LANES + lane, out + 14 * LANES + lane);
}

static void forward_velocity_one(const double *RESTRICT in, double *RESTRICT out)
{
    forward_velocity_body(1, in + 0, in + 1, in + 4, in + 13, in + 15, out + 0, out + 6, out + 7, out + 10, out + 13, out + 14, out + 15, out + 18, out + 21, out + 22, out + 23);
}

static void forward_velocity_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        forward_velocity_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, in + 15 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 7 * LANES + lane, out + 10 * LANES + lane, out + 13 * LANES + lane, out + 14 * LANES + lane, out + 15 * LANES + lane, out + 18 * LANES + lane, out + 21 * LANES + lane, out + 22 * LANES + lane, out + 23 * LANES + lane);
}

static void joint_rates_one(const double *RESTRICT in, double *RESTRICT out)
{
    joint_rates_body(1, in + 0, in + 1, in + 4, in + 13, in + 15, out + 0, out + 24, out + 25, out + 26, out + 29, out + 32, out + 33, out + 34);
}

static void joint_rates_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        joint_rates_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, in + 15 * LANES + lane, out + 0 * LANES + lane, out + 24 * LANES + lane, out + 25 * LANES + lane, out + 26 * LANES + lane, out + 29 * LANES + lane, out + 32 * LANES + lane, out + 33 * LANES + lane, out + 34 * LANES + lane);
}

static void platform_wrench_one(const double *RESTRICT in, double *RESTRICT out)
{
    platform_wrench_body(1, in + 0, in + 1, in + 4, in + 13, out + 0, out + 6, out + 9, out + 12, out + 13, out + 14);
}

static void platform_wrench_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        platform_wrench_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 12 * LANES + lane, out + 13 * LANES + lane, out + 14 * LANES + lane);
}

static void actuator_forces_one(const double *RESTRICT in, double *RESTRICT out)
{
    actuator_forces_body(1, in + 0, in + 1, in + 4, in + 13, in + 15, out + 0, out + 6, out + 9, out + 12, out + 13, out + 14, out + 17, out + 20, out + 21, out + 22);
}

static void actuator_forces_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        actuator_forces_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, in + 15 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 12 * LANES + lane, out + 13 * LANES + lane, out + 14 * LANES + lane, out + 17 * LANES + lane, out + 20 * LANES + lane, out + 21 * LANES + lane, out + 22 * LANES + lane);
}

static void inverse_acceleration_one(const double *RESTRICT in, double *RESTRICT out)
{
    inverse_acceleration_body(1, in + 0, in + 1, in + 4, in + 13, in + 19, out + 0, out + 6, out + 12, out + 15, out + 18, out + 19, out + 20);
}

static void inverse_acceleration_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        inverse_acceleration_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, in + 19 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 12 * LANES + lane, out + 15 * LANES + lane, out + 18 * LANES + lane, out + 19 * LANES + lane, out + 20 * LANES + lane);
}

static void forward_acceleration_one(const double *RESTRICT in, double *RESTRICT out)
{
    forward_acceleration_body(1, in + 0, in + 1, in + 4, in + 13, in + 15, in + 21, out + 0, out + 6, out + 12, out + 15, out + 18, out + 19, out + 20, out + 23, out + 26, out + 27, out + 28);
}

static void forward_acceleration_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        forward_acceleration_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, in + 13 * LANES + lane, in + 15 * LANES + lane, in + 21 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 12 * LANES + lane, out + 15 * LANES + lane, out + 18 * LANES + lane, out + 19 * LANES + lane, out + 20 * LANES + lane, out + 23 * LANES + lane, out + 26 * LANES + lane, out + 27 * LANES + lane, out + 28 * LANES + lane);
}

static void inverse_singularity_one(const double *RESTRICT in, double *RESTRICT out)
{
    inverse_singularity_body(1, in + 0, in + 1, in + 4, out + 0, out + 1, out + 4, out + 5, out + 6, out + 9, out + 10);
}

static void inverse_singularity_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        inverse_singularity_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 1 * LANES + lane, out + 4 * LANES + lane, out + 5 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 10 * LANES + lane);
}

static void direct_singularity_one(const double *RESTRICT in, double *RESTRICT out)
{
    direct_singularity_body(1, in + 0, in + 1, in + 4, out + 0, out + 1, out + 4, out + 5, out + 6, out + 9, out + 10);
}

static void direct_singularity_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        direct_singularity_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 1 * LANES + lane, out + 4 * LANES + lane, out + 5 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 10 * LANES + lane);
}

static void survey_one(const double *RESTRICT in, double *RESTRICT out)
{
    survey_body(1, in + 0, in + 1, in + 4, out + 0, out + 6, out + 9, out + 10, out + 11, out + 14, out + 15, out + 16, out + 17, out + 20, out + 21, out + 22, out + 25, out + 26);
}

static void survey_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        survey_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 6 * LANES + lane, out + 9 * LANES + lane, out + 10 * LANES + lane, out + 11 * LANES + lane, out + 14 * LANES + lane, out + 15 * LANES + lane, out + 16 * LANES + lane, out + 17 * LANES + lane, out + 20 * LANES + lane, out + 21 * LANES + lane, out + 22 * LANES + lane, out + 25 * LANES + lane, out + 26 * LANES + lane);
}

static void direct_locus_one(const double *RESTRICT in, double *RESTRICT out)
{
    direct_locus_body(1, in + 0, in + 1, out + 0, out + 20);
}

static void direct_locus_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        direct_locus_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, out + 0 * LANES + lane, out + 20 * LANES + lane);
}

static void orientation_locus_one(const double *RESTRICT in, double *RESTRICT out)
{
    orientation_locus_body(1, in + 0, in + 1, in + 4, out + 0, out + 1, out + 4);
}

static void orientation_locus_lanes(const double *RESTRICT in, double *RESTRICT out)
{
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        orientation_locus_body(LANES, in + 0 * LANES + lane, in + 1 * LANES + lane, in + 4 * LANES + lane, out + 0 * LANES + lane, out + 1 * LANES + lane, out + 4 * LANES + lane);
}

static const struct kernel kernels[] = {
    {"inverse_displacement", "(),(3),(3,3)->(6),(3),(3,3),(3),()",
     "Joint values from the pose.",
     3, 5, 13, 22,
     {{0, 0}, {3, 0}, {3, 3}, {6, 0}, {3, 0}, {3, 3}, {3, 0}, {0, 0}},
     inverse_displacement_one, inverse_displacement_lanes},
    {"central_forward", "(3)->(3),(3)",
     "Position of C from the joint values of the central limb.",
     1, 2, 3, 6,
     {{3, 0}, {3, 0}, {3, 0}},
     central_forward_one, central_forward_lanes},
    {"central_inverse", "(3)->(3),()",
     "Joint values of the central limb from the position of C.",
     1, 2, 3, 4,
     {{3, 0}, {3, 0}, {0, 0}},
     central_inverse_one, central_inverse_lanes},
    {"closure", "(),(3),(3),(2,3)->(6),(6,6)",
     "Residual of the six quadratics in (n_1, n_2), and its Jacobian.",
     4, 2, 13, 42,
     {{0, 0}, {3, 0}, {3, 0}, {2, 3}, {6, 0}, {6, 6}},
     closure_one, closure_lanes},
    {"cones", "(),(3),(3)->(3,3),(3,3),(3,3)",
     "The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.",
     3, 3, 7, 27,
     {{0, 0}, {3, 0}, {3, 0}, {3, 3}, {3, 3}, {3, 3}},
     cones_one, cones_lanes},
    {"eliminant", "(),(3),(3),(2),(3)->(),()",
     "The resultant that vanishes at the angles of leg 1 of the assembly modes.",
     5, 2, 12, 2,
     {{0, 0}, {3, 0}, {3, 0}, {2, 0}, {3, 0}, {0, 0}, {0, 0}},
     eliminant_one, eliminant_lanes},
    {"half_turn", "(),(3),(3),(2),(3)->(3,3),(2,4)",
     "The turn about n_1 at a zero of the eliminant, as a half angle.",
     5, 2, 12, 17,
     {{0, 0}, {3, 0}, {3, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 4}},
     half_turn_one, half_turn_lanes},
    {"turned_directions", "(3,3),(2)->(2,3)",
     "n_1 and n_2 from the frame about n_1 and the half angle of the turn.",
     2, 1, 11, 6,
     {{3, 3}, {2, 0}, {2, 3}},
     turned_directions_one, turned_directions_lanes},
    {"circles", "(),(3),(3),(2,2)->(5,5),(5,5),(3,3),(3,3)",
     "Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.",
     4, 4, 11, 68,
     {{0, 0}, {3, 0}, {3, 0}, {2, 2}, {5, 5}, {5, 5}, {3, 3}, {3, 3}},
     circles_one, circles_lanes},
    {"arms", "(),(3),(3),(2,2),(2)->(2,3)",
     "The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.",
     5, 1, 13, 6,
     {{0, 0}, {3, 0}, {3, 0}, {2, 2}, {2, 0}, {2, 3}},
     arms_one, arms_lanes},
    {"newton_step", "(),(3),(3),(2,3)->(2,3),(3),(3),(3,3),()",
     "One step of Newton's method on the rotation, for the three closure equations.",
     4, 5, 13, 22,
     {{0, 0}, {3, 0}, {3, 0}, {2, 3}, {2, 3}, {3, 0}, {3, 0}, {3, 3}, {0, 0}},
     newton_step_one, newton_step_lanes},
    {"leg_step", "(),(3),(3),(2),(3)->(2),(2,3),(),(2)",
     "One step of Newton's method in the angle of leg 1 and the turn about n_1.",
     5, 4, 12, 11,
     {{0, 0}, {3, 0}, {3, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 3}, {0, 0}, {2, 0}},
     leg_step_one, leg_step_lanes},
    {"fold", "(),(6),(2,3)->(3),(3,3),(),(3),(3,6)",
     "What decides whether two assembly modes have merged.",
     3, 5, 13, 34,
     {{0, 0}, {6, 0}, {2, 3}, {3, 0}, {3, 3}, {0, 0}, {3, 0}, {3, 6}},
     fold_one, fold_lanes},
    {"rotation_from_rpy", "(),(),()->(3,3)",
     "Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).",
     3, 1, 3, 9,
     {{0, 0}, {0, 0}, {0, 0}, {3, 3}},
     rotation_from_rpy_one, rotation_from_rpy_lanes},
    {"rpy_from_rotation", "(3,3)->(),(),()",
     "Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.",
     1, 3, 9, 3,
     {{3, 3}, {0, 0}, {0, 0}, {0, 0}},
     rpy_from_rotation_one, rpy_from_rotation_lanes},
    {"rotation_from_directions", "(3),(3)->(3,3)",
     "Rotation from the platform directions n_1 and n_2.",
     2, 1, 6, 9,
     {{3, 0}, {3, 0}, {3, 3}},
     rotation_from_directions_one, rotation_from_directions_lanes},
    {"rotation_defect", "(3,3)->()",
     "How far a matrix is from a rotation; zero for a rotation.",
     1, 1, 9, 1,
     {{3, 3}, {0, 0}},
     rotation_defect_one, rotation_defect_lanes},
    {"limb_geometry", "(),(3),(3,3)->(3,3),(3,3),(3,6)",
     "Points D_i, unit vectors w_i and reciprocal lines S_i.",
     3, 3, 13, 36,
     {{0, 0}, {3, 0}, {3, 3}, {3, 3}, {3, 3}, {3, 6}},
     limb_geometry_one, limb_geometry_lanes},
    {"screws", "(),(3),(3,3),(2)->(6,6),(6,6),(6,6),(6,6),(3),(3),(),(),()",
     "The joint screws of the four limbs at pole C, a row a joint.",
     4, 9, 15, 153,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {6, 6}, {6, 6}, {6, 6}, {6, 6}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     screws_one, screws_lanes},
    {"jacobians", "(),(3),(3,3),(2)->(6,6),(6,6),(3),(3),(),(),()",
     "Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.",
     4, 7, 15, 81,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {6, 6}, {6, 6}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     jacobians_one, jacobians_lanes},
    {"joints_and_jacobians", "(),(3),(3,3),(2)->(6),(6,6),(6,6)",
     "Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.",
     4, 3, 15, 78,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {6, 0}, {6, 6}, {6, 6}},
     joints_and_jacobians_one, joints_and_jacobians_lanes},
    {"inverse_velocity", "(),(3),(3,3),(2,3)->(6),(3),(3),(),(),()",
     "Joint rates from the twist.",
     4, 6, 19, 15,
     {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {6, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     inverse_velocity_one, inverse_velocity_lanes},
    {"forward_velocity", "(),(3),(3,3),(2),(6)->(6),(),(3),(3),(),(),(3),(3),(),(),()",
     "Twist from the joint rates, and the determinant of its 3×3 with its factors.",
     5, 11, 21, 24,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {6, 0}, {6, 0}, {0, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     forward_velocity_one, forward_velocity_lanes},
    {"joint_rates", "(),(3),(3,3),(2),(2,3)->(4,6),(),(),(3),(3),(),(),()",
     "The rates of all joints of the four limbs from the twist.",
     5, 8, 21, 35,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {2, 3}, {4, 6}, {0, 0}, {0, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     joint_rates_one, joint_rates_lanes},
    {"platform_wrench", "(),(3),(3,3),(6)->(6),(3),(3),(),(),()",
     "Wrench that the platform exerts from the forces of the actuators.",
     4, 6, 19, 15,
     {{0, 0}, {3, 0}, {3, 3}, {6, 0}, {6, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     platform_wrench_one, platform_wrench_lanes},
    {"actuator_forces", "(),(3),(3,3),(2),(2,3)->(6),(3),(3),(),(),(3),(3),(),(),()",
     "Forces of the actuators from the wrench that the platform exerts.",
     5, 10, 21, 23,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {2, 3}, {6, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     actuator_forces_one, actuator_forces_lanes},
    {"inverse_acceleration", "(),(3),(3,3),(2,3),(2,3)->(6),(6),(3),(3),(),(),()",
     "Joint rates and accelerations from the twist and its derivative.",
     5, 7, 25, 21,
     {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 3}, {6, 0}, {6, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     inverse_acceleration_one, inverse_acceleration_lanes},
    {"forward_acceleration", "(),(3),(3,3),(2),(6),(6)->(6),(6),(3),(3),(),(),(3),(3),(),(),()",
     "Twist and its derivative from the joint rates and accelerations.",
     6, 11, 27, 29,
     {{0, 0}, {3, 0}, {3, 3}, {2, 0}, {6, 0}, {6, 0}, {6, 0}, {6, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}},
     forward_acceleration_one, forward_acceleration_lanes},
    {"inverse_singularity", "(),(3),(3,3)->(),(3),(),(),(3),(),()",
     "det J_q and its factors: the product of limb, central and wrist.",
     3, 7, 13, 11,
     {{0, 0}, {3, 0}, {3, 3}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}},
     inverse_singularity_one, inverse_singularity_lanes},
    {"direct_singularity", "(),(3),(3,3)->(),(3),(),(),(3),(),()",
     "det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.",
     3, 7, 13, 11,
     {{0, 0}, {3, 0}, {3, 3}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}},
     direct_singularity_one, direct_singularity_lanes},
    {"survey", "(),(3),(3,3)->(6),(3),(),(),(3),(),(),(),(3),(),(),(3),(),(3)",
     "Joint values, extensions, both determinants and their factors in one pass.",
     3, 14, 13, 29,
     {{0, 0}, {3, 0}, {3, 3}, {6, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {3, 0}},
     survey_one, survey_lanes},
    {"direct_locus", "(),(3,3)->(20),(3)",
     "The cubic in c on which `orientation` vanishes, at one orientation of the platform: √3/2 times its value is (p_1 p_2 p_3)² orientation.",
     2, 2, 10, 23,
     {{0, 0}, {3, 3}, {20, 0}, {3, 0}},
     direct_locus_one, direct_locus_lanes},
    {"orientation_locus", "(),(3),(3,3)->(),(3),(3)",
     "The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: √3/2 times it is (p_1 p_2 p_3)² orientation.",
     3, 3, 13, 7,
     {{0, 0}, {3, 0}, {3, 3}, {0, 0}, {3, 0}, {3, 0}},
     orientation_locus_one, orientation_locus_lanes},
};

const struct table VARIANT_OF(kleinform_table) = {
    33, 832575509UL, kernels,
};
