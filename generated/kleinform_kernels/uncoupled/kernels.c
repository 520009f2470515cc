/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
#include "kernels.h"

#include <math.h>
#include <stddef.h>

#ifndef RESTRICT
#ifdef __cplusplus
#define RESTRICT
#else
#define RESTRICT restrict
#endif
#endif

#ifndef KLEINFORM_BODY
#define KLEINFORM_BODY static inline
#endif

/* sqrt(3)/2, exactly rounded. */
#define SQRT3_2 0.8660254037844386

/* The angle of (x, y) in [-pi, pi] [rad], within 3 ulp; signed zeros, inf and NaN as in libm.
   Not for |x| + |y| that overflows, nor for x and y that are both subnormal. */
KLEINFORM_BODY double angle_of(double y, double x)
{
    const double across = fabs(x), along = fabs(y);
    const double low = along < across ? along : across;
    const double high = along < across ? across : along;
    const int steep = (low > 0.41421356237309503 * high) | ((low == high) & (high > 0.0));
    const double difference = low == high ? 0.0 : low - high;
    const double over = steep ? difference : low;
    const double under = steep ? low + high : (high == 0.0 ? 1.0 : high);
    const double t = over / under;
    const double z = t * t;
    const double p = ((((((((((-0.01917688711906226 * z + 0.03923165829558719) * z - 0.0508544973794026) * z + 0.0585814891280221) * z - 0.06664511447381948) * z + 0.07692183190826087) * z - 0.09090904578123903) * z + 0.11111111015256361) * z - 0.14285714284666542) * z + 0.1999999999999552) * z - 0.3333333333333333);
    const double first = t + t * (z * p);
    const double eighths = steep ? 1.0 : 0.0;
    const double second = along > across ? -first : first;
    const double quarters = along > across ? 2.0 - eighths : eighths;
    const double third = copysign(1.0, x) < 0.0 ? -second : second;
    const double halves = copysign(1.0, x) < 0.0 ? 4.0 - quarters : quarters;
    /* pi/4 in two parts, the first of so few bits that its multiples are exact. */
    return copysign(halves * 0.7853981633974483 + (third + halves * 3.061616997868383e-17), y);
}

KLEINFORM_BODY void inverse_displacement_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_joints,
    double *RESTRICT out_extension,
    double *RESTRICT out_platform_joints,
    double *RESTRICT out_incidence,
    double *RESTRICT out_radial)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    const double x6 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x6);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x6);
    /* elevation of the central limb (11) [rad] */
    const double q5 = angle_of(c_z, r);
    /* azimuth of the central limb, measured from the X axis (11) [rad] */
    const double q4 = angle_of(c_y, c_x);
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* position of B_i (3) [m] */
    const double b1_x = c_x + e1*n1_x;
    const double b1_y = c_y + e1*n1_y;
    const double b1_z = c_z + e1*n1_z;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    /* length of the outer limb (10) [m] */
    const double q1 = l1/fabs(n1_x);
    const double x7 = SQRT3_2*c_y;
    const double x8 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x7 + x8;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    /* position of B_i (3) [m] */
    const double b2_x = c_x + e2*n2_x;
    const double b2_y = c_y + e2*n2_y;
    const double b2_z = c_z + e2*n2_z;
    const double x9 = 0.5*c_y;
    const double x10 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x10 - x9);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* length of the outer limb (10) [m] */
    const double q2 = l2/fabs(p2);
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x7 + x8;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* position of B_i (3) [m] */
    const double b3_x = c_x + e3*n3_x;
    const double b3_y = c_y + e3*n3_y;
    const double b3_z = c_z + e3*n3_z;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(x10 - x9);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* length of the outer limb (10) [m] */
    const double q3 = l3/fabs(p3);
    out_joints[0] = q1;
    out_joints[stride] = q2;
    out_joints[2 * stride] = q3;
    out_joints[3 * stride] = q4;
    out_joints[4 * stride] = q5;
    out_joints[5 * stride] = q6;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_platform_joints[0] = b1_x;
    out_platform_joints[stride] = b1_y;
    out_platform_joints[2 * stride] = b1_z;
    out_platform_joints[3 * stride] = b2_x;
    out_platform_joints[4 * stride] = b2_y;
    out_platform_joints[5 * stride] = b2_z;
    out_platform_joints[6 * stride] = b3_x;
    out_platform_joints[7 * stride] = b3_y;
    out_platform_joints[8 * stride] = b3_z;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_radial[0] = r;
}

KLEINFORM_API void kleinform_inverse_displacement(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double out_joints[6],
    double out_extension[3],
    double out_platform_joints[9],
    double out_incidence[3],
    double *out_radial)
{
    inverse_displacement_body(1, &in_a, in_c, in_R, out_joints, out_extension, out_platform_joints, out_incidence, out_radial);
}

KLEINFORM_BODY void central_forward_body(
    size_t stride,
    const double *RESTRICT in_joints,
    double *RESTRICT out_position,
    double *RESTRICT out_direction)
{
    const double q4 = in_joints[0];
    const double q5 = in_joints[stride];
    const double q6 = in_joints[2 * stride];
    const double x0 = cos(q5);
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = x0*cos(q4);
    const double lambda_y = x0*sin(q4);
    const double lambda_z = sin(q5);
    /* position of the platform's centre C (1) [m] */
    const double c_x = lambda_x*q6;
    const double c_y = lambda_y*q6;
    const double c_z = lambda_z*q6;
    out_position[0] = c_x;
    out_position[stride] = c_y;
    out_position[2 * stride] = c_z;
    out_direction[0] = lambda_x;
    out_direction[stride] = lambda_y;
    out_direction[2 * stride] = lambda_z;
}

KLEINFORM_API void kleinform_central_forward(
    const double in_joints[3],
    double out_position[3],
    double out_direction[3])
{
    central_forward_body(1, in_joints, out_position, out_direction);
}

KLEINFORM_BODY void central_inverse_body(
    size_t stride,
    const double *RESTRICT in_c,
    double *RESTRICT out_joints,
    double *RESTRICT out_radial)
{
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double x0 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x0);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x0);
    /* elevation of the central limb (11) [rad] */
    const double q5 = angle_of(c_z, r);
    /* azimuth of the central limb, measured from the X axis (11) [rad] */
    const double q4 = angle_of(c_y, c_x);
    out_joints[0] = q4;
    out_joints[stride] = q5;
    out_joints[2 * stride] = q6;
    out_radial[0] = r;
}

KLEINFORM_API void kleinform_central_inverse(
    const double in_c[3],
    double out_joints[3],
    double *out_radial)
{
    central_inverse_body(1, in_c, out_joints, out_radial);
}

KLEINFORM_BODY void closure_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_directions,
    double *RESTRICT out_residual,
    double *RESTRICT out_jacobian)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double n1_x = in_directions[0];
    const double n1_y = in_directions[stride];
    const double n1_z = in_directions[2 * stride];
    const double n2_x = in_directions[3 * stride];
    const double n2_y = in_directions[4 * stride];
    const double n2_z = in_directions[5 * stride];
    /* the third direction (5) [1] */
    const double n3_x = -n1_x - n2_x;
    const double n3_y = -n1_y - n2_y;
    const double n3_z = -n1_z - n2_z;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    const double x0 = (n1_x*n1_x);
    const double x1 = (q1*q1);
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F1 = (gt1*gt1) + (gz1*gz1) - x0*x1;
    const double x2 = 2.0*gt1;
    const double x3 = 2.0*gz1;
    const double x4 = 2.0*n1_x;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF1_x = c_y*x2 + c_z*x3 - x1*x4;
    const double dF1_y = h1*x2;
    const double dF1_z = h1*x3;
    const double x5 = SQRT3_2*c_y;
    const double x6 = 0.5*c_x;
    const double x7 = a + x6;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x5 + x7;
    const double x8 = 0.25*c_y;
    const double x9 = SQRT3_2*x6;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x8 + x9;
    const double x10 = 0.5*c_y;
    const double x11 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x10 - x11) - 0.5*h2;
    const double x12 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x12;
    const double x13 = SQRT3_2*c_z;
    const double hz2_y = x13;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = ht2_x*n2_x + ht2_y*n2_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2);
    const double x14 = 2.0*gt2;
    const double x15 = 2.0*gz2;
    const double x16 = 2.0*p2*q2;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF2_x = -hp2_x*x16 + ht2_x*x14 + hz2_x*x15;
    const double dF2_y = -hp2_y*x16 + ht2_y*x14 + hz2_y*x15;
    const double dF2_z = h2*x15;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x5 + x7;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x8 - x9;
    const double ht3_y = -SQRT3_2*(-x10 + x11) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x12;
    const double hz3_y = -x13;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = ht3_x*n3_x + ht3_y*n3_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3);
    const double x17 = 2.0*gt3;
    const double x18 = 2.0*gz3;
    const double x19 = 2.0*p3*q3;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF3_x = -hp3_x*x19 + ht3_x*x17 + hz3_x*x18;
    const double dF3_y = -hp3_y*x19 + ht3_y*x17 + hz3_y*x18;
    const double dF3_z = h3*x18;
    /* n_1 is a unit vector (5) [1] */
    const double F4 = (n1_y*n1_y) + (n1_z*n1_z) + x0 - 1.0;
    /* n_2 is a unit vector (5) [1] */
    const double F5 = (n2_x*n2_x) + (n2_y*n2_y) + (n2_z*n2_z) - 1.0;
    /* n_1, n_2 are 120° apart (5) [1] */
    const double F6 = n1_x*n2_x + n1_y*n2_y + n1_z*n2_z + 0.5;
    const double x20 = -dF3_x;
    /* derivatives of F by (n_1, n_2) (6) [m², 1] */
    const double dF_31 = x20;
    const double x21 = -dF3_y;
    const double dF_32 = x21;
    const double x22 = -dF3_z;
    const double dF_33 = x22;
    const double dF_34 = x20;
    const double dF_35 = x21;
    const double dF_36 = x22;
    const double dF_41 = x4;
    const double dF_42 = 2.0*n1_y;
    const double dF_43 = 2.0*n1_z;
    const double dF_54 = 2.0*n2_x;
    const double dF_55 = 2.0*n2_y;
    const double dF_56 = 2.0*n2_z;
    out_residual[0] = F1;
    out_residual[stride] = F2;
    out_residual[2 * stride] = F3;
    out_residual[3 * stride] = F4;
    out_residual[4 * stride] = F5;
    out_residual[5 * stride] = F6;
    out_jacobian[0] = dF1_x;
    out_jacobian[stride] = dF1_y;
    out_jacobian[2 * stride] = dF1_z;
    out_jacobian[3 * stride] = 0.0;
    out_jacobian[4 * stride] = 0.0;
    out_jacobian[5 * stride] = 0.0;
    out_jacobian[6 * stride] = 0.0;
    out_jacobian[7 * stride] = 0.0;
    out_jacobian[8 * stride] = 0.0;
    out_jacobian[9 * stride] = dF2_x;
    out_jacobian[10 * stride] = dF2_y;
    out_jacobian[11 * stride] = dF2_z;
    out_jacobian[12 * stride] = dF_31;
    out_jacobian[13 * stride] = dF_32;
    out_jacobian[14 * stride] = dF_33;
    out_jacobian[15 * stride] = dF_34;
    out_jacobian[16 * stride] = dF_35;
    out_jacobian[17 * stride] = dF_36;
    out_jacobian[18 * stride] = dF_41;
    out_jacobian[19 * stride] = dF_42;
    out_jacobian[20 * stride] = dF_43;
    out_jacobian[21 * stride] = 0.0;
    out_jacobian[22 * stride] = 0.0;
    out_jacobian[23 * stride] = 0.0;
    out_jacobian[24 * stride] = 0.0;
    out_jacobian[25 * stride] = 0.0;
    out_jacobian[26 * stride] = 0.0;
    out_jacobian[27 * stride] = dF_54;
    out_jacobian[28 * stride] = dF_55;
    out_jacobian[29 * stride] = dF_56;
    out_jacobian[30 * stride] = n2_x;
    out_jacobian[31 * stride] = n2_y;
    out_jacobian[32 * stride] = n2_z;
    out_jacobian[33 * stride] = n1_x;
    out_jacobian[34 * stride] = n1_y;
    out_jacobian[35 * stride] = n1_z;
}

KLEINFORM_API void kleinform_closure(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_directions[6],
    double out_residual[6],
    double out_jacobian[36])
{
    closure_body(1, &in_a, in_c, in_lengths, in_directions, out_residual, out_jacobian);
}

KLEINFORM_BODY void cones_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    double *RESTRICT out_cone_1,
    double *RESTRICT out_cone_2,
    double *RESTRICT out_cone_3)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²] */
    const double M1_11 = (c_y*c_y) + (c_z*c_z) - (q1*q1);
    const double x0 = c_y*h1;
    const double M1_12 = x0;
    const double x1 = c_z*h1;
    const double M1_13 = x1;
    const double M1_21 = x0;
    const double x2 = (h1*h1);
    const double M1_22 = x2;
    const double M1_31 = x1;
    const double M1_33 = x2;
    const double x3 = SQRT3_2*c_y;
    const double x4 = 0.5*c_x;
    const double x5 = a + x4;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x3 + x5;
    const double x6 = 0.25*c_y;
    const double x7 = SQRT3_2*x4;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x6 + x7;
    const double x8 = 0.5*c_y;
    const double x9 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x8 - x9) - 0.5*h2;
    const double x10 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x10;
    const double x11 = SQRT3_2*c_z;
    const double hz2_y = x11;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    /* matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²] */
    const double M2_11 = -(hp2_x*hp2_x) + (ht2_x*ht2_x) + (hz2_x*hz2_x);
    const double x12 = -hp2_x*hp2_y + ht2_x*ht2_y + hz2_x*hz2_y;
    const double M2_12 = x12;
    const double x13 = h2*hz2_x;
    const double M2_13 = x13;
    const double M2_21 = x12;
    const double M2_22 = -(hp2_y*hp2_y) + (ht2_y*ht2_y) + (hz2_y*hz2_y);
    const double x14 = h2*hz2_y;
    const double M2_23 = x14;
    const double M2_31 = x13;
    const double M2_32 = x14;
    const double M2_33 = (h2*h2);
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x3 + x5;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x6 - x7;
    const double ht3_y = -SQRT3_2*(-x8 + x9) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x10;
    const double hz3_y = -x11;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    /* matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²] */
    const double M3_11 = -(hp3_x*hp3_x) + (ht3_x*ht3_x) + (hz3_x*hz3_x);
    const double x15 = -hp3_x*hp3_y + ht3_x*ht3_y + hz3_x*hz3_y;
    const double M3_12 = x15;
    const double x16 = h3*hz3_x;
    const double M3_13 = x16;
    const double M3_21 = x15;
    const double M3_22 = -(hp3_y*hp3_y) + (ht3_y*ht3_y) + (hz3_y*hz3_y);
    const double x17 = h3*hz3_y;
    const double M3_23 = x17;
    const double M3_31 = x16;
    const double M3_32 = x17;
    const double M3_33 = (h3*h3);
    out_cone_1[0] = M1_11;
    out_cone_1[stride] = M1_12;
    out_cone_1[2 * stride] = M1_13;
    out_cone_1[3 * stride] = M1_21;
    out_cone_1[4 * stride] = M1_22;
    out_cone_1[5 * stride] = 0.0;
    out_cone_1[6 * stride] = M1_31;
    out_cone_1[7 * stride] = 0.0;
    out_cone_1[8 * stride] = M1_33;
    out_cone_2[0] = M2_11;
    out_cone_2[stride] = M2_12;
    out_cone_2[2 * stride] = M2_13;
    out_cone_2[3 * stride] = M2_21;
    out_cone_2[4 * stride] = M2_22;
    out_cone_2[5 * stride] = M2_23;
    out_cone_2[6 * stride] = M2_31;
    out_cone_2[7 * stride] = M2_32;
    out_cone_2[8 * stride] = M2_33;
    out_cone_3[0] = M3_11;
    out_cone_3[stride] = M3_12;
    out_cone_3[2 * stride] = M3_13;
    out_cone_3[3 * stride] = M3_21;
    out_cone_3[4 * stride] = M3_22;
    out_cone_3[5 * stride] = M3_23;
    out_cone_3[6 * stride] = M3_31;
    out_cone_3[7 * stride] = M3_32;
    out_cone_3[8 * stride] = M3_33;
}

KLEINFORM_API void kleinform_cones(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    double out_cone_1[9],
    double out_cone_2[9],
    double out_cone_3[9])
{
    cones_body(1, &in_a, in_c, in_lengths, out_cone_1, out_cone_2, out_cone_3);
}

KLEINFORM_BODY void eliminant_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_angle,
    const double *RESTRICT in_reference,
    double *RESTRICT out_eliminant,
    double *RESTRICT out_bound)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double cos_theta = in_angle[0];
    const double sin_theta = in_angle[stride];
    const double reference_x = in_reference[0];
    const double reference_y = in_reference[stride];
    const double reference_z = in_reference[2 * stride];
    /* from C to B_1, leg 1 at the angle theta [m] */
    const double arm_x = a - c_x;
    const double arm_y = -c_y + cos_theta*q1;
    const double arm_z = -c_z + q1*sin_theta;
    const double x0 = 1.0/(sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z)));
    /* direction from C to B_1 (3) [1] */
    const double n1_x = arm_x*x0;
    const double n1_y = arm_y*x0;
    const double n1_z = arm_z*x0;
    const double x1 = -n1_y*reference_z + n1_z*reference_y;
    const double x2 = -n1_x*reference_y + n1_y*reference_x;
    const double x3 = n1_x*reference_z - n1_z*reference_x;
    const double x4 = 1.0/(sqrt((x1*x1) + (x2*x2) + (x3*x3)));
    /* a unit vector normal to n_1 [1] */
    const double f_x = x1*x4;
    const double f_y = x3*x4;
    const double f_z = x2*x4;
    /* completes the frame of n_1 [1] */
    const double g_x = -f_y*n1_z + f_z*n1_y;
    const double g_y = f_x*n1_z - f_z*n1_x;
    const double g_z = -f_x*n1_y + f_y*n1_x;
    const double x5 = SQRT3_2*c_y;
    const double x6 = 0.5*c_x;
    const double x7 = a + x6;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x5 + x7;
    const double x8 = 0.25*c_y;
    const double x9 = SQRT3_2*x6;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x8 + x9;
    const double x10 = 0.5*h2;
    const double x11 = 0.5*c_y;
    const double x12 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x11 - x12) - x10;
    const double x13 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x13;
    const double x14 = SQRT3_2*c_z;
    const double hz2_y = x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    const double x15 = SQRT3_2*(f_x*ht2_x + f_y*ht2_y);
    const double x16 = 0.5*n1_x;
    const double x17 = 0.5*n1_y;
    const double x18 = ht2_x*x16 + ht2_y*x17;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double htx2_x = x15 - x18;
    const double x19 = 2.0*SQRT3_2;
    const double htx2_y = x19*(g_x*ht2_x + g_y*ht2_y);
    const double htx2_z = -x15 - x18;
    const double x20 = SQRT3_2*(f_x*hz2_x + f_y*hz2_y + f_z*h2);
    const double x21 = hz2_x*x16 + hz2_y*x17 + n1_z*x10;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double hzx2_x = x20 - x21;
    const double hzx2_y = x19*(g_x*hz2_x + g_y*hz2_y + g_z*h2);
    const double hzx2_z = -x20 - x21;
    const double x22 = SQRT3_2*(f_x*hp2_x + f_y*hp2_y);
    const double x23 = hp2_x*x16 + hp2_y*x17;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double hpx2_x = x22 - x23;
    const double hpx2_y = x19*(g_x*hp2_x + g_y*hp2_y);
    const double hpx2_z = -x22 - x23;
    /* coefficients of (x² + y²)² F_2 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²] */
    const double K2_1 = -(hpx2_x*hpx2_x) + (htx2_x*htx2_x) + (hzx2_x*hzx2_x);
    const double x24 = 2.0*hpx2_x;
    const double x25 = 2.0*htx2_x;
    const double x26 = 2.0*hzx2_x;
    const double K2_2 = -hpx2_y*x24 + htx2_y*x25 + hzx2_y*x26;
    const double K2_3 = -(hpx2_y*hpx2_y) - hpx2_z*x24 + (htx2_y*htx2_y) + htx2_z*x25 + (hzx2_y*hzx2_y) + hzx2_z*x26;
    const double K2_4 = -2.0*hpx2_y*hpx2_z + 2.0*htx2_y*htx2_z + 2.0*hzx2_y*hzx2_z;
    const double K2_5 = -(hpx2_z*hpx2_z) + (htx2_z*htx2_z) + (hzx2_z*hzx2_z);
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x5 + x7;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x8 - x9;
    const double x27 = 0.5*h3;
    const double ht3_y = -SQRT3_2*(-x11 + x12) - x27;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x13;
    const double hz3_y = -x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    const double x28 = SQRT3_2*(f_x*ht3_x + f_y*ht3_y);
    const double x29 = ht3_x*x16 + ht3_y*x17;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double htx3_x = -x28 - x29;
    const double htx3_y = -x19*(g_x*ht3_x + g_y*ht3_y);
    const double htx3_z = x28 - x29;
    const double x30 = SQRT3_2*(f_x*hz3_x + f_y*hz3_y + f_z*h3);
    const double x31 = hz3_x*x16 + hz3_y*x17 + n1_z*x27;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double hzx3_x = -x30 - x31;
    const double hzx3_y = -x19*(g_x*hz3_x + g_y*hz3_y + g_z*h3);
    const double hzx3_z = x30 - x31;
    const double x32 = SQRT3_2*(f_x*hp3_x + f_y*hp3_y);
    const double x33 = hp3_x*x16 + hp3_y*x17;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double hpx3_x = -x32 - x33;
    const double hpx3_y = -x19*(g_x*hp3_x + g_y*hp3_y);
    const double hpx3_z = x32 - x33;
    /* coefficients of (x² + y²)² F_3 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²] */
    const double K3_1 = -(hpx3_x*hpx3_x) + (htx3_x*htx3_x) + (hzx3_x*hzx3_x);
    const double x34 = 2.0*hpx3_x;
    const double x35 = 2.0*htx3_x;
    const double x36 = 2.0*hzx3_x;
    const double K3_2 = -hpx3_y*x34 + htx3_y*x35 + hzx3_y*x36;
    const double K3_3 = -(hpx3_y*hpx3_y) - hpx3_z*x34 + (htx3_y*htx3_y) + htx3_z*x35 + (hzx3_y*hzx3_y) + hzx3_z*x36;
    const double K3_4 = -2.0*hpx3_y*hpx3_z + 2.0*htx3_y*htx3_z + 2.0*hzx3_y*hzx3_z;
    const double K3_5 = -(hpx3_z*hpx3_z) + (htx3_z*htx3_z) + (hzx3_z*hzx3_z);
    /* brackets of the two quartics [m⁴] */
    const double brackets_12 = K2_1*K3_2 - K2_2*K3_1;
    const double brackets_13 = K2_1*K3_3 - K2_3*K3_1;
    const double brackets_14 = K2_1*K3_4 - K2_4*K3_1;
    const double brackets_15 = K2_1*K3_5 - K2_5*K3_1;
    const double brackets_23 = K2_2*K3_3 - K2_3*K3_2;
    const double brackets_24 = K2_2*K3_4 - K2_4*K3_2;
    const double brackets_25 = K2_2*K3_5 - K2_5*K3_2;
    const double brackets_34 = K2_3*K3_4 - K2_4*K3_3;
    const double brackets_35 = K2_3*K3_5 - K2_5*K3_3;
    const double brackets_45 = K2_4*K3_5 - K2_5*K3_4;
    /* Bezoutian of the two quartics [m⁴] */
    const double Z_22 = brackets_14 + brackets_23;
    const double x37 = brackets_15 + brackets_24;
    const double Z_23 = x37;
    const double Z_32 = x37;
    const double Z_33 = brackets_25 + brackets_34;
    const double x38 = (brackets_13*brackets_13);
    /* minors of rows 1 and 2 of the Bezoutian [m⁸] */
    const double upper_x = Z_22*brackets_12 - x38;
    const double upper_y = Z_23*brackets_12 - brackets_13*brackets_14;
    const double upper_z = brackets_12*brackets_25 - brackets_13*brackets_15;
    const double upper_ox = -Z_22*brackets_14 + Z_23*brackets_13;
    const double upper_oy = -Z_22*brackets_15 + brackets_13*brackets_25;
    const double x39 = -brackets_14*brackets_25;
    const double upper_oz = -Z_23*brackets_15 - x39;
    /* minors of rows 3 and 4 of the Bezoutian [m⁸] */
    const double lower_x = -Z_32*brackets_15 - x39;
    const double lower_y = -Z_33*brackets_15 + brackets_14*brackets_35;
    const double lower_z = brackets_14*brackets_45 - brackets_15*brackets_35;
    const double lower_ox = Z_32*brackets_35 - Z_33*brackets_25;
    const double lower_oy = Z_32*brackets_45 - brackets_25*brackets_35;
    const double x40 = (brackets_35*brackets_35);
    const double lower_oz = Z_33*brackets_45 - x40;
    /* resultant of the two quartics, the determinant [m¹⁶] */
    const double eliminant = lower_ox*upper_z - lower_oy*upper_y + lower_oz*upper_x + lower_x*upper_oz - lower_y*upper_oy + lower_z*upper_ox;
    const double x41 = (brackets_25*brackets_25);
    const double x42 = (brackets_14*brackets_14);
    const double x43 = (brackets_15*brackets_15);
    /* Hadamard's bound on the eliminant: the product of the lengths of the rows [m¹⁶] */
    const double bound = sqrt((Z_22*Z_22) + (Z_23*Z_23) + x38 + x41)*sqrt((brackets_12*brackets_12) + x38 + x42 + x43)*sqrt((brackets_45*brackets_45) + x40 + x41 + x43)*sqrt((Z_32*Z_32) + (Z_33*Z_33) + x40 + x42);
    out_eliminant[0] = eliminant;
    out_bound[0] = bound;
}

KLEINFORM_API void kleinform_eliminant(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_reference[3],
    double *out_eliminant,
    double *out_bound)
{
    eliminant_body(1, &in_a, in_c, in_lengths, in_angle, in_reference, out_eliminant, out_bound);
}

KLEINFORM_BODY void half_turn_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_angle,
    const double *RESTRICT in_reference,
    double *RESTRICT out_frame,
    double *RESTRICT out_powers)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double cos_theta = in_angle[0];
    const double sin_theta = in_angle[stride];
    const double reference_x = in_reference[0];
    const double reference_y = in_reference[stride];
    const double reference_z = in_reference[2 * stride];
    /* from C to B_1, leg 1 at the angle theta [m] */
    const double arm_x = a - c_x;
    const double arm_y = -c_y + cos_theta*q1;
    const double arm_z = -c_z + q1*sin_theta;
    const double x0 = 1.0/(sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z)));
    /* direction from C to B_1 (3) [1] */
    const double n1_x = arm_x*x0;
    const double n1_y = arm_y*x0;
    const double n1_z = arm_z*x0;
    const double x1 = -n1_y*reference_z + n1_z*reference_y;
    const double x2 = -n1_x*reference_y + n1_y*reference_x;
    const double x3 = n1_x*reference_z - n1_z*reference_x;
    const double x4 = 1.0/(sqrt((x1*x1) + (x2*x2) + (x3*x3)));
    /* a unit vector normal to n_1 [1] */
    const double f_x = x1*x4;
    const double f_y = x3*x4;
    const double f_z = x2*x4;
    /* completes the frame of n_1 [1] */
    const double g_x = -f_y*n1_z + f_z*n1_y;
    const double g_y = f_x*n1_z - f_z*n1_x;
    const double g_z = -f_x*n1_y + f_y*n1_x;
    const double x5 = SQRT3_2*c_y;
    const double x6 = 0.5*c_x;
    const double x7 = a + x6;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x5 + x7;
    const double x8 = 0.25*c_y;
    const double x9 = SQRT3_2*x6;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x8 + x9;
    const double x10 = 0.5*h2;
    const double x11 = 0.5*c_y;
    const double x12 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x11 - x12) - x10;
    const double x13 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x13;
    const double x14 = SQRT3_2*c_z;
    const double hz2_y = x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    const double x15 = SQRT3_2*(f_x*ht2_x + f_y*ht2_y);
    const double x16 = 0.5*n1_x;
    const double x17 = 0.5*n1_y;
    const double x18 = ht2_x*x16 + ht2_y*x17;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double htx2_x = x15 - x18;
    const double x19 = 2.0*SQRT3_2;
    const double htx2_y = x19*(g_x*ht2_x + g_y*ht2_y);
    const double htx2_z = -x15 - x18;
    const double x20 = SQRT3_2*(f_x*hz2_x + f_y*hz2_y + f_z*h2);
    const double x21 = hz2_x*x16 + hz2_y*x17 + n1_z*x10;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double hzx2_x = x20 - x21;
    const double hzx2_y = x19*(g_x*hz2_x + g_y*hz2_y + g_z*h2);
    const double hzx2_z = -x20 - x21;
    const double x22 = SQRT3_2*(f_x*hp2_x + f_y*hp2_y);
    const double x23 = hp2_x*x16 + hp2_y*x17;
    /* form of limb 2 in the half angle of the turn, at x², xy, y² [m] */
    const double hpx2_x = x22 - x23;
    const double hpx2_y = x19*(g_x*hp2_x + g_y*hp2_y);
    const double hpx2_z = -x22 - x23;
    /* coefficients of (x² + y²)² F_2 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²] */
    const double K2_1 = -(hpx2_x*hpx2_x) + (htx2_x*htx2_x) + (hzx2_x*hzx2_x);
    const double x24 = 2.0*hpx2_x;
    const double x25 = 2.0*htx2_x;
    const double x26 = 2.0*hzx2_x;
    const double K2_2 = -hpx2_y*x24 + htx2_y*x25 + hzx2_y*x26;
    const double K2_3 = -(hpx2_y*hpx2_y) - hpx2_z*x24 + (htx2_y*htx2_y) + htx2_z*x25 + (hzx2_y*hzx2_y) + hzx2_z*x26;
    const double K2_4 = -2.0*hpx2_y*hpx2_z + 2.0*htx2_y*htx2_z + 2.0*hzx2_y*hzx2_z;
    const double K2_5 = -(hpx2_z*hpx2_z) + (htx2_z*htx2_z) + (hzx2_z*hzx2_z);
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x5 + x7;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x8 - x9;
    const double x27 = 0.5*h3;
    const double ht3_y = -SQRT3_2*(-x11 + x12) - x27;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x13;
    const double hz3_y = -x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    const double x28 = SQRT3_2*(f_x*ht3_x + f_y*ht3_y);
    const double x29 = ht3_x*x16 + ht3_y*x17;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double htx3_x = -x28 - x29;
    const double htx3_y = -x19*(g_x*ht3_x + g_y*ht3_y);
    const double htx3_z = x28 - x29;
    const double x30 = SQRT3_2*(f_x*hz3_x + f_y*hz3_y + f_z*h3);
    const double x31 = hz3_x*x16 + hz3_y*x17 + n1_z*x27;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double hzx3_x = -x30 - x31;
    const double hzx3_y = -x19*(g_x*hz3_x + g_y*hz3_y + g_z*h3);
    const double hzx3_z = x30 - x31;
    const double x32 = SQRT3_2*(f_x*hp3_x + f_y*hp3_y);
    const double x33 = hp3_x*x16 + hp3_y*x17;
    /* form of limb 3 in the half angle of the turn, at x², xy, y² [m] */
    const double hpx3_x = -x32 - x33;
    const double hpx3_y = -x19*(g_x*hp3_x + g_y*hp3_y);
    const double hpx3_z = x32 - x33;
    /* coefficients of (x² + y²)² F_3 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²] */
    const double K3_1 = -(hpx3_x*hpx3_x) + (htx3_x*htx3_x) + (hzx3_x*hzx3_x);
    const double x34 = 2.0*hpx3_x;
    const double x35 = 2.0*htx3_x;
    const double x36 = 2.0*hzx3_x;
    const double K3_2 = -hpx3_y*x34 + htx3_y*x35 + hzx3_y*x36;
    const double K3_3 = -(hpx3_y*hpx3_y) - hpx3_z*x34 + (htx3_y*htx3_y) + htx3_z*x35 + (hzx3_y*hzx3_y) + hzx3_z*x36;
    const double K3_4 = -2.0*hpx3_y*hpx3_z + 2.0*htx3_y*htx3_z + 2.0*hzx3_y*hzx3_z;
    const double K3_5 = -(hpx3_z*hpx3_z) + (htx3_z*htx3_z) + (hzx3_z*hzx3_z);
    /* brackets of the two quartics [m⁴] */
    const double brackets_12 = K2_1*K3_2 - K2_2*K3_1;
    const double brackets_13 = K2_1*K3_3 - K2_3*K3_1;
    const double brackets_14 = K2_1*K3_4 - K2_4*K3_1;
    const double brackets_15 = K2_1*K3_5 - K2_5*K3_1;
    const double brackets_23 = K2_2*K3_3 - K2_3*K3_2;
    const double brackets_24 = K2_2*K3_4 - K2_4*K3_2;
    const double brackets_25 = K2_2*K3_5 - K2_5*K3_2;
    const double brackets_34 = K2_3*K3_4 - K2_4*K3_3;
    const double brackets_35 = K2_3*K3_5 - K2_5*K3_3;
    const double brackets_45 = K2_4*K3_5 - K2_5*K3_4;
    /* Bezoutian of the two quartics [m⁴] */
    const double Z_22 = brackets_14 + brackets_23;
    const double x37 = brackets_15 + brackets_24;
    const double Z_23 = x37;
    const double Z_32 = x37;
    const double Z_33 = brackets_25 + brackets_34;
    /* minors of rows 1 and 2 of the Bezoutian [m⁸] */
    const double upper_x = Z_22*brackets_12 - (brackets_13*brackets_13);
    const double upper_y = Z_23*brackets_12 - brackets_13*brackets_14;
    const double upper_z = brackets_12*brackets_25 - brackets_13*brackets_15;
    const double upper_ox = -Z_22*brackets_14 + Z_23*brackets_13;
    const double upper_oy = -Z_22*brackets_15 + brackets_13*brackets_25;
    const double x38 = -brackets_14*brackets_25;
    const double upper_oz = -Z_23*brackets_15 - x38;
    /* minors of rows 3 and 4 of the Bezoutian [m⁸] */
    const double lower_x = -Z_32*brackets_15 - x38;
    const double lower_y = -Z_33*brackets_15 + brackets_14*brackets_35;
    const double lower_z = brackets_14*brackets_45 - brackets_15*brackets_35;
    const double lower_ox = Z_32*brackets_35 - Z_33*brackets_25;
    const double lower_oy = Z_32*brackets_45 - brackets_25*brackets_35;
    const double lower_oz = Z_33*brackets_45 - (brackets_35*brackets_35);
    /* row 1 of the adjugate [m¹²] */
    const double adj1_1 = Z_22*lower_oz - Z_23*lower_oy + brackets_25*lower_ox;
    const double adj1_2 = Z_23*lower_z - brackets_13*lower_oz - brackets_25*lower_y;
    const double adj1_3 = -Z_22*lower_z + brackets_13*lower_oy + brackets_25*lower_x;
    const double adj1_4 = Z_22*lower_y - Z_23*lower_x - brackets_13*lower_ox;
    /* row 4 of the adjugate [m¹²] */
    const double adj4_1 = -Z_32*upper_oz + Z_33*upper_oy - brackets_35*upper_ox;
    const double adj4_2 = -Z_33*upper_z + brackets_14*upper_oz + brackets_35*upper_y;
    const double adj4_3 = Z_32*upper_z - brackets_14*upper_oy - brackets_35*upper_x;
    const double adj4_4 = -Z_32*upper_y + Z_33*upper_x + brackets_14*upper_ox;
    out_frame[0] = n1_x;
    out_frame[stride] = n1_y;
    out_frame[2 * stride] = n1_z;
    out_frame[3 * stride] = f_x;
    out_frame[4 * stride] = f_y;
    out_frame[5 * stride] = f_z;
    out_frame[6 * stride] = g_x;
    out_frame[7 * stride] = g_y;
    out_frame[8 * stride] = g_z;
    out_powers[0] = adj1_1;
    out_powers[stride] = adj1_2;
    out_powers[2 * stride] = adj1_3;
    out_powers[3 * stride] = adj1_4;
    out_powers[4 * stride] = adj4_1;
    out_powers[5 * stride] = adj4_2;
    out_powers[6 * stride] = adj4_3;
    out_powers[7 * stride] = adj4_4;
}

KLEINFORM_API void kleinform_half_turn(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_reference[3],
    double out_frame[9],
    double out_powers[8])
{
    half_turn_body(1, &in_a, in_c, in_lengths, in_angle, in_reference, out_frame, out_powers);
}

KLEINFORM_BODY void turned_directions_body(
    size_t stride,
    const double *RESTRICT in_frame,
    const double *RESTRICT in_half_angle,
    double *RESTRICT out_directions)
{
    const double n1_x = in_frame[0];
    const double n1_y = in_frame[stride];
    const double n1_z = in_frame[2 * stride];
    const double f_x = in_frame[3 * stride];
    const double f_y = in_frame[4 * stride];
    const double f_z = in_frame[5 * stride];
    const double g_x = in_frame[6 * stride];
    const double g_y = in_frame[7 * stride];
    const double g_z = in_frame[8 * stride];
    const double x = in_half_angle[0];
    const double y = in_half_angle[stride];
    const double x0 = (x*x);
    const double x1 = (y*y);
    const double x2 = 1.0/(x0 + x1);
    const double x3 = 2.0*x*x2*y;
    const double x4 = x2*(x0 - x1);
    /* direction from C to B_2, the platform turned by phi about n_1 (5) [1] */
    const double n2_x = SQRT3_2*(f_x*x4 + g_x*x3) - 0.5*n1_x;
    const double n2_y = SQRT3_2*(f_y*x4 + g_y*x3) - 0.5*n1_y;
    const double n2_z = SQRT3_2*(f_z*x4 + g_z*x3) - 0.5*n1_z;
    out_directions[0] = n1_x;
    out_directions[stride] = n1_y;
    out_directions[2 * stride] = n1_z;
    out_directions[3 * stride] = n2_x;
    out_directions[4 * stride] = n2_y;
    out_directions[5 * stride] = n2_z;
}

KLEINFORM_API void kleinform_turned_directions(
    const double in_frame[9],
    const double in_half_angle[2],
    double out_directions[6])
{
    turned_directions_body(1, in_frame, in_half_angle, out_directions);
}

KLEINFORM_BODY void circles_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_start,
    double *RESTRICT out_angle,
    double *RESTRICT out_cone,
    double *RESTRICT out_first,
    double *RESTRICT out_second)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double cos_start1 = in_start[0];
    const double sin_start1 = in_start[stride];
    const double cos_start2 = in_start[2 * stride];
    const double sin_start2 = in_start[3 * stride];
    /* from C to A_1 [m] */
    const double center1_x = a - c_x;
    const double x0 = -c_y;
    const double center1_y = x0;
    const double x1 = -c_z;
    const double center1_z = x1;
    /* direction of leg 1 a quarter turn on [1] */
    const double up1_y = -sin_start1;
    const double x2 = cos_start1*q1;
    /* from C to B_1 times 1 + t², its part at 1 [m] */
    const double va1_y = center1_y + x2;
    const double x3 = q1*sin_start1;
    const double va1_z = center1_z + x3;
    /* from C to B_1 times 1 + t², its part at t [m] */
    const double vb1_y = 2.0*q1*up1_y;
    const double vb1_z = 2.0*x2;
    /* from C to B_1 times 1 + t², its part at t² [m] */
    const double vc1_y = center1_y - x2;
    const double vc1_z = center1_z - x3;
    /* from C to A_2 [m] */
    const double center2_x = -0.5*a - c_x;
    const double center2_y = SQRT3_2*a + x0;
    const double center2_z = x1;
    /* direction of leg 2 at half angle 0 [1] */
    const double near2_x = -SQRT3_2*cos_start2;
    const double near2_y = -0.5*cos_start2;
    /* direction of leg 2 a quarter turn on [1] */
    const double up2_x = SQRT3_2*sin_start2;
    const double up2_y = 0.5*sin_start2;
    const double x4 = near2_x*q2;
    /* from C to B_2 times 1 + s², its part at 1 [m] */
    const double va2_x = center2_x + x4;
    const double x5 = near2_y*q2;
    const double va2_y = center2_y + x5;
    const double x6 = q2*sin_start2;
    const double va2_z = center2_z + x6;
    const double x7 = 2.0*q2;
    /* from C to B_2 times 1 + s², its part at s [m] */
    const double vb2_x = up2_x*x7;
    const double vb2_y = up2_y*x7;
    const double vb2_z = cos_start2*x7;
    /* from C to B_2 times 1 + s², its part at s² [m] */
    const double vc2_x = center2_x - x4;
    const double vc2_y = center2_y - x5;
    const double vc2_z = center2_z - x6;
    const double x8 = 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = SQRT3_2*c_y + a + x8;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 - SQRT3_2*x8 + 0.25*c_y;
    const double ht3_y = -SQRT3_2*(SQRT3_2*c_x - 0.5*c_y) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = -0.5*c_z;
    const double hz3_y = -SQRT3_2*c_z;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    const double x9 = (center1_x*center1_x);
    /* square of the arm to B_1, its coefficients [m²] */
    const double N1_1 = (va1_y*va1_y) + (va1_z*va1_z) + x9;
    const double x10 = 2.0*va1_y;
    const double x11 = 2.0*va1_z;
    const double N1_2 = vb1_y*x10 + vb1_z*x11;
    const double N1_3 = (vb1_y*vb1_y) + (vb1_z*vb1_z) + vc1_y*x10 + vc1_z*x11 + 2.0*x9;
    const double N1_4 = 2.0*vb1_y*vc1_y + 2.0*vb1_z*vc1_z;
    const double N1_5 = (vc1_y*vc1_y) + (vc1_z*vc1_z) + x9;
    const double x12 = center1_x*ht3_x;
    /* form of limb 3 along the arm to B_1, its coefficients [m²] */
    const double htv1_x = ht3_y*va1_y + x12;
    const double htv1_y = ht3_y*vb1_y;
    const double htv1_z = ht3_y*vc1_y + x12;
    const double x13 = center1_x*hz3_x;
    /* form of limb 3 along the arm to B_1, its coefficients [m²] */
    const double hzv1_x = h3*va1_z + hz3_y*va1_y + x13;
    const double hzv1_y = h3*vb1_z + hz3_y*vb1_y;
    const double hzv1_z = h3*vc1_z + hz3_y*vc1_y + x13;
    const double x14 = center1_x*hp3_x;
    /* form of limb 3 along the arm to B_1, its coefficients [m²] */
    const double hpv1_x = hp3_y*va1_y + x14;
    const double hpv1_y = hp3_y*vb1_y;
    const double hpv1_z = hp3_y*vc1_y + x14;
    /* cone of limb 3 at the arm to B_1, its coefficients [m⁴] */
    const double C1_1 = -(hpv1_x*hpv1_x) + (htv1_x*htv1_x) + (hzv1_x*hzv1_x);
    const double x15 = 2.0*hpv1_x;
    const double x16 = 2.0*htv1_x;
    const double x17 = 2.0*hzv1_x;
    const double C1_2 = -hpv1_y*x15 + htv1_y*x16 + hzv1_y*x17;
    const double C1_3 = -(hpv1_y*hpv1_y) - hpv1_z*x15 + (htv1_y*htv1_y) + htv1_z*x16 + (hzv1_y*hzv1_y) + hzv1_z*x17;
    const double C1_4 = -2.0*hpv1_y*hpv1_z + 2.0*htv1_y*htv1_z + 2.0*hzv1_y*hzv1_z;
    const double C1_5 = -(hpv1_z*hpv1_z) + (htv1_z*htv1_z) + (hzv1_z*hzv1_z);
    /* square of the arm to B_2, its coefficients [m²] */
    const double N2_1 = (va2_x*va2_x) + (va2_y*va2_y) + (va2_z*va2_z);
    const double x18 = 2.0*va2_x;
    const double x19 = 2.0*va2_y;
    const double x20 = 2.0*va2_z;
    const double N2_2 = vb2_x*x18 + vb2_y*x19 + vb2_z*x20;
    const double N2_3 = (vb2_x*vb2_x) + (vb2_y*vb2_y) + (vb2_z*vb2_z) + vc2_x*x18 + vc2_y*x19 + vc2_z*x20;
    const double N2_4 = 2.0*vb2_x*vc2_x + 2.0*vb2_y*vc2_y + 2.0*vb2_z*vc2_z;
    const double N2_5 = (vc2_x*vc2_x) + (vc2_y*vc2_y) + (vc2_z*vc2_z);
    /* form of limb 3 along the arm to B_2, its coefficients [m²] */
    const double htv2_x = ht3_x*va2_x + ht3_y*va2_y;
    const double htv2_y = ht3_x*vb2_x + ht3_y*vb2_y;
    const double htv2_z = ht3_x*vc2_x + ht3_y*vc2_y;
    /* form of limb 3 along the arm to B_2, its coefficients [m²] */
    const double hzv2_x = h3*va2_z + hz3_x*va2_x + hz3_y*va2_y;
    const double hzv2_y = h3*vb2_z + hz3_x*vb2_x + hz3_y*vb2_y;
    const double hzv2_z = h3*vc2_z + hz3_x*vc2_x + hz3_y*vc2_y;
    /* form of limb 3 along the arm to B_2, its coefficients [m²] */
    const double hpv2_x = hp3_x*va2_x + hp3_y*va2_y;
    const double hpv2_y = hp3_x*vb2_x + hp3_y*vb2_y;
    const double hpv2_z = hp3_x*vc2_x + hp3_y*vc2_y;
    /* cone of limb 3 at the arm to B_2, its coefficients [m⁴] */
    const double C2_1 = -(hpv2_x*hpv2_x) + (htv2_x*htv2_x) + (hzv2_x*hzv2_x);
    const double x21 = 2.0*hpv2_x;
    const double x22 = 2.0*htv2_x;
    const double x23 = 2.0*hzv2_x;
    const double C2_2 = -hpv2_y*x21 + htv2_y*x22 + hzv2_y*x23;
    const double C2_3 = -(hpv2_y*hpv2_y) - hpv2_z*x21 + (htv2_y*htv2_y) + htv2_z*x22 + (hzv2_y*hzv2_y) + hzv2_z*x23;
    const double C2_4 = -2.0*hpv2_y*hpv2_z + 2.0*htv2_y*htv2_z + 2.0*hzv2_y*hzv2_z;
    const double C2_5 = -(hpv2_z*hpv2_z) + (htv2_z*htv2_z) + (hzv2_z*hzv2_z);
    const double x24 = center1_x*va2_x;
    /* product of the arms to B_1 and B_2, its coefficients [m²] */
    const double N12_11 = va1_y*va2_y + va1_z*va2_z + x24;
    const double x25 = center1_x*vb2_x;
    const double N12_12 = va1_y*vb2_y + va1_z*vb2_z + x25;
    const double x26 = center1_x*vc2_x;
    const double N12_13 = va1_y*vc2_y + va1_z*vc2_z + x26;
    const double N12_21 = va2_y*vb1_y + va2_z*vb1_z;
    const double N12_22 = vb1_y*vb2_y + vb1_z*vb2_z;
    const double N12_23 = vb1_y*vc2_y + vb1_z*vc2_z;
    const double N12_31 = va2_y*vc1_y + va2_z*vc1_z + x24;
    const double N12_32 = vb2_y*vc1_y + vb2_z*vc1_z + x25;
    const double N12_33 = vc1_y*vc2_y + vc1_z*vc2_z + x26;
    /* cone of limb 3 between the arms to B_1 and B_2, its coefficients [m⁴] */
    const double C12_11 = -hpv1_x*hpv2_x + htv1_x*htv2_x + hzv1_x*hzv2_x;
    const double C12_12 = -hpv1_x*hpv2_y + htv1_x*htv2_y + hzv1_x*hzv2_y;
    const double C12_13 = -hpv1_x*hpv2_z + htv1_x*htv2_z + hzv1_x*hzv2_z;
    const double C12_21 = -hpv1_y*hpv2_x + htv1_y*htv2_x + hzv1_y*hzv2_x;
    const double C12_22 = -hpv1_y*hpv2_y + htv1_y*htv2_y + hzv1_y*hzv2_y;
    const double C12_23 = -hpv1_y*hpv2_z + htv1_y*htv2_z + hzv1_y*hzv2_z;
    const double C12_31 = -hpv1_z*hpv2_x + htv1_z*htv2_x + hzv1_z*hzv2_x;
    const double C12_32 = -hpv1_z*hpv2_y + htv1_z*htv2_y + hzv1_z*hzv2_y;
    const double C12_33 = -hpv1_z*hpv2_z + htv1_z*htv2_z + hzv1_z*hzv2_z;
    /* condition that n_1 and n_2 are 120° apart, its coefficients (5) [m⁴] */
    const double angle_11 = 4.0*(N12_11*N12_11) - N1_1*N2_1;
    const double x27 = 8.0*N12_11;
    const double angle_12 = N12_12*x27 - N1_1*N2_2;
    const double angle_13 = 4.0*(N12_12*N12_12) + N12_13*x27 - N1_1*N2_3;
    const double x28 = 8.0*N12_12;
    const double angle_14 = N12_13*x28 - N1_1*N2_4;
    const double angle_15 = 4.0*(N12_13*N12_13) - N1_1*N2_5;
    const double angle_21 = N12_21*x27 - N1_2*N2_1;
    const double angle_22 = N12_21*x28 + N12_22*x27 - N1_2*N2_2;
    const double x29 = 8.0*N12_13;
    const double angle_23 = N12_21*x29 + N12_22*x28 + N12_23*x27 - N1_2*N2_3;
    const double angle_24 = N12_22*x29 + N12_23*x28 - N1_2*N2_4;
    const double angle_25 = N12_23*x29 - N1_2*N2_5;
    const double angle_31 = 4.0*(N12_21*N12_21) + N12_31*x27 - N1_3*N2_1;
    const double x30 = 8.0*N12_21;
    const double angle_32 = N12_22*x30 + N12_31*x28 + N12_32*x27 - N1_3*N2_2;
    const double angle_33 = 4.0*(N12_22*N12_22) + N12_23*x30 + N12_31*x29 + N12_32*x28 + N12_33*x27 - N1_3*N2_3;
    const double x31 = 8.0*N12_22;
    const double angle_34 = N12_23*x31 + N12_32*x29 + N12_33*x28 - N1_3*N2_4;
    const double angle_35 = 4.0*(N12_23*N12_23) + N12_33*x29 - N1_3*N2_5;
    const double angle_41 = N12_31*x30 - N1_4*N2_1;
    const double angle_42 = N12_31*x31 + N12_32*x30 - N1_4*N2_2;
    const double x32 = 8.0*N12_23;
    const double angle_43 = N12_31*x32 + N12_32*x31 + N12_33*x30 - N1_4*N2_3;
    const double angle_44 = N12_32*x32 + N12_33*x31 - N1_4*N2_4;
    const double angle_45 = N12_33*x32 - N1_4*N2_5;
    const double angle_51 = 4.0*(N12_31*N12_31) - N1_5*N2_1;
    const double x33 = 8.0*N12_31;
    const double angle_52 = N12_32*x33 - N1_5*N2_2;
    const double angle_53 = 4.0*(N12_32*N12_32) + N12_33*x33 - N1_5*N2_3;
    const double angle_54 = 8.0*N12_32*N12_33 - N1_5*N2_4;
    const double angle_55 = 4.0*(N12_33*N12_33) - N1_5*N2_5;
    const double x34 = 4.0*C12_11;
    /* condition that limb 3 closes, its coefficients (6) [m⁶] */
    const double cone_11 = C1_1*N2_1 + C2_1*N1_1 - N12_11*x34;
    const double x35 = 4.0*C12_12;
    const double cone_12 = C1_1*N2_2 + C2_2*N1_1 - N12_11*x35 - N12_12*x34;
    const double x36 = 4.0*C12_13;
    const double cone_13 = C1_1*N2_3 + C2_3*N1_1 - N12_11*x36 - N12_12*x35 - N12_13*x34;
    const double cone_14 = C1_1*N2_4 + C2_4*N1_1 - N12_12*x36 - N12_13*x35;
    const double cone_15 = C1_1*N2_5 + C2_5*N1_1 - N12_13*x36;
    const double x37 = 4.0*C12_21;
    const double cone_21 = C1_2*N2_1 + C2_1*N1_2 - N12_11*x37 - N12_21*x34;
    const double x38 = 4.0*C12_22;
    const double cone_22 = C1_2*N2_2 + C2_2*N1_2 - N12_11*x38 - N12_12*x37 - N12_21*x35 - N12_22*x34;
    const double x39 = 4.0*C12_23;
    const double cone_23 = C1_2*N2_3 + C2_3*N1_2 - N12_11*x39 - N12_12*x38 - N12_13*x37 - N12_21*x36 - N12_22*x35 - N12_23*x34;
    const double cone_24 = C1_2*N2_4 + C2_4*N1_2 - N12_12*x39 - N12_13*x38 - N12_22*x36 - N12_23*x35;
    const double cone_25 = C1_2*N2_5 + C2_5*N1_2 - N12_13*x39 - N12_23*x36;
    const double x40 = 4.0*C12_31;
    const double cone_31 = C1_3*N2_1 + C2_1*N1_3 - N12_11*x40 - N12_21*x37 - N12_31*x34;
    const double x41 = 4.0*C12_32;
    const double cone_32 = C1_3*N2_2 + C2_2*N1_3 - N12_11*x41 - N12_12*x40 - N12_21*x38 - N12_22*x37 - N12_31*x35 - N12_32*x34;
    const double x42 = 4.0*C12_33;
    const double cone_33 = C1_3*N2_3 + C2_3*N1_3 - N12_11*x42 - N12_12*x41 - N12_13*x40 - N12_21*x39 - N12_22*x38 - N12_23*x37 - N12_31*x36 - N12_32*x35 - N12_33*x34;
    const double cone_34 = C1_3*N2_4 + C2_4*N1_3 - N12_12*x42 - N12_13*x41 - N12_22*x39 - N12_23*x38 - N12_32*x36 - N12_33*x35;
    const double cone_35 = C1_3*N2_5 + C2_5*N1_3 - N12_13*x42 - N12_23*x39 - N12_33*x36;
    const double cone_41 = C1_4*N2_1 + C2_1*N1_4 - N12_21*x40 - N12_31*x37;
    const double cone_42 = C1_4*N2_2 + C2_2*N1_4 - N12_21*x41 - N12_22*x40 - N12_31*x38 - N12_32*x37;
    const double cone_43 = C1_4*N2_3 + C2_3*N1_4 - N12_21*x42 - N12_22*x41 - N12_23*x40 - N12_31*x39 - N12_32*x38 - N12_33*x37;
    const double cone_44 = C1_4*N2_4 + C2_4*N1_4 - N12_22*x42 - N12_23*x41 - N12_32*x39 - N12_33*x38;
    const double cone_45 = C1_4*N2_5 + C2_5*N1_4 - N12_23*x42 - N12_33*x39;
    const double cone_51 = C1_5*N2_1 + C2_1*N1_5 - N12_31*x40;
    const double cone_52 = C1_5*N2_2 + C2_2*N1_5 - N12_31*x41 - N12_32*x40;
    const double cone_53 = C1_5*N2_3 + C2_3*N1_5 - N12_31*x42 - N12_32*x41 - N12_33*x40;
    const double cone_54 = C1_5*N2_4 + C2_4*N1_5 - N12_32*x42 - N12_33*x41;
    const double cone_55 = C1_5*N2_5 + C2_5*N1_5 - N12_33*x42;
    out_angle[0] = angle_11;
    out_angle[stride] = angle_12;
    out_angle[2 * stride] = angle_13;
    out_angle[3 * stride] = angle_14;
    out_angle[4 * stride] = angle_15;
    out_angle[5 * stride] = angle_21;
    out_angle[6 * stride] = angle_22;
    out_angle[7 * stride] = angle_23;
    out_angle[8 * stride] = angle_24;
    out_angle[9 * stride] = angle_25;
    out_angle[10 * stride] = angle_31;
    out_angle[11 * stride] = angle_32;
    out_angle[12 * stride] = angle_33;
    out_angle[13 * stride] = angle_34;
    out_angle[14 * stride] = angle_35;
    out_angle[15 * stride] = angle_41;
    out_angle[16 * stride] = angle_42;
    out_angle[17 * stride] = angle_43;
    out_angle[18 * stride] = angle_44;
    out_angle[19 * stride] = angle_45;
    out_angle[20 * stride] = angle_51;
    out_angle[21 * stride] = angle_52;
    out_angle[22 * stride] = angle_53;
    out_angle[23 * stride] = angle_54;
    out_angle[24 * stride] = angle_55;
    out_cone[0] = cone_11;
    out_cone[stride] = cone_12;
    out_cone[2 * stride] = cone_13;
    out_cone[3 * stride] = cone_14;
    out_cone[4 * stride] = cone_15;
    out_cone[5 * stride] = cone_21;
    out_cone[6 * stride] = cone_22;
    out_cone[7 * stride] = cone_23;
    out_cone[8 * stride] = cone_24;
    out_cone[9 * stride] = cone_25;
    out_cone[10 * stride] = cone_31;
    out_cone[11 * stride] = cone_32;
    out_cone[12 * stride] = cone_33;
    out_cone[13 * stride] = cone_34;
    out_cone[14 * stride] = cone_35;
    out_cone[15 * stride] = cone_41;
    out_cone[16 * stride] = cone_42;
    out_cone[17 * stride] = cone_43;
    out_cone[18 * stride] = cone_44;
    out_cone[19 * stride] = cone_45;
    out_cone[20 * stride] = cone_51;
    out_cone[21 * stride] = cone_52;
    out_cone[22 * stride] = cone_53;
    out_cone[23 * stride] = cone_54;
    out_cone[24 * stride] = cone_55;
    out_first[0] = center1_x;
    out_first[stride] = va1_y;
    out_first[2 * stride] = va1_z;
    out_first[3 * stride] = 0.0;
    out_first[4 * stride] = vb1_y;
    out_first[5 * stride] = vb1_z;
    out_first[6 * stride] = center1_x;
    out_first[7 * stride] = vc1_y;
    out_first[8 * stride] = vc1_z;
    out_second[0] = va2_x;
    out_second[stride] = va2_y;
    out_second[2 * stride] = va2_z;
    out_second[3 * stride] = vb2_x;
    out_second[4 * stride] = vb2_y;
    out_second[5 * stride] = vb2_z;
    out_second[6 * stride] = vc2_x;
    out_second[7 * stride] = vc2_y;
    out_second[8 * stride] = vc2_z;
}

KLEINFORM_API void kleinform_circles(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_start[4],
    double out_angle[25],
    double out_cone[25],
    double out_first[9],
    double out_second[9])
{
    circles_body(1, &in_a, in_c, in_lengths, in_start, out_angle, out_cone, out_first, out_second);
}

KLEINFORM_BODY void arms_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_start,
    const double *RESTRICT in_half_tangents,
    double *RESTRICT out_arms)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double cos_start1 = in_start[0];
    const double sin_start1 = in_start[stride];
    const double cos_start2 = in_start[2 * stride];
    const double sin_start2 = in_start[3 * stride];
    const double t = in_half_tangents[0];
    const double s = in_half_tangents[stride];
    /* from C to A_1 [m] */
    const double center1_x = a - c_x;
    const double x0 = -c_y;
    const double center1_y = x0;
    const double x1 = -c_z;
    const double center1_z = x1;
    /* direction of leg 1 a quarter turn on [1] */
    const double up1_y = -sin_start1;
    const double x2 = cos_start1*q1;
    /* from C to B_1 times 1 + t², its part at 1 [m] */
    const double va1_y = center1_y + x2;
    const double x3 = q1*sin_start1;
    const double va1_z = center1_z + x3;
    /* from C to B_1 times 1 + t², its part at t [m] */
    const double vb1_y = 2.0*q1*up1_y;
    const double vb1_z = 2.0*x2;
    /* from C to B_1 times 1 + t², its part at t² [m] */
    const double vc1_y = center1_y - x2;
    const double vc1_z = center1_z - x3;
    /* from C to A_2 [m] */
    const double center2_x = -0.5*a - c_x;
    const double center2_y = SQRT3_2*a + x0;
    const double center2_z = x1;
    /* direction of leg 2 at half angle 0 [1] */
    const double near2_x = -SQRT3_2*cos_start2;
    const double near2_y = -0.5*cos_start2;
    /* direction of leg 2 a quarter turn on [1] */
    const double up2_x = SQRT3_2*sin_start2;
    const double up2_y = 0.5*sin_start2;
    const double x4 = near2_x*q2;
    /* from C to B_2 times 1 + s², its part at 1 [m] */
    const double va2_x = center2_x + x4;
    const double x5 = near2_y*q2;
    const double va2_y = center2_y + x5;
    const double x6 = q2*sin_start2;
    const double va2_z = center2_z + x6;
    const double x7 = 2.0*q2;
    /* from C to B_2 times 1 + s², its part at s [m] */
    const double vb2_x = up2_x*x7;
    const double vb2_y = up2_y*x7;
    const double vb2_z = cos_start2*x7;
    /* from C to B_2 times 1 + s², its part at s² [m] */
    const double vc2_x = center2_x - x4;
    const double vc2_y = center2_y - x5;
    const double vc2_z = center2_z - x6;
    const double x8 = (t*t);
    const double x9 = 1.0/(x8 + 1.0);
    /* from C to B_1 [m] */
    const double arm1_x = x9*(center1_x*x8 + center1_x);
    const double arm1_y = x9*(t*vb1_y + va1_y + vc1_y*x8);
    const double arm1_z = x9*(t*vb1_z + va1_z + vc1_z*x8);
    const double x10 = (s*s);
    const double x11 = 1.0/(x10 + 1.0);
    /* from C to B_2 [m] */
    const double arm2_x = x11*(s*vb2_x + va2_x + vc2_x*x10);
    const double arm2_y = x11*(s*vb2_y + va2_y + vc2_y*x10);
    const double arm2_z = x11*(s*vb2_z + va2_z + vc2_z*x10);
    out_arms[0] = arm1_x;
    out_arms[stride] = arm1_y;
    out_arms[2 * stride] = arm1_z;
    out_arms[3 * stride] = arm2_x;
    out_arms[4 * stride] = arm2_y;
    out_arms[5 * stride] = arm2_z;
}

KLEINFORM_API void kleinform_arms(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_start[4],
    const double in_half_tangents[2],
    double out_arms[6])
{
    arms_body(1, &in_a, in_c, in_lengths, in_start, in_half_tangents, out_arms);
}

KLEINFORM_BODY void newton_step_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_directions,
    double *RESTRICT out_next,
    double *RESTRICT out_turn,
    double *RESTRICT out_residual,
    double *RESTRICT out_gradient,
    double *RESTRICT out_volume)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double n1_x = in_directions[0];
    const double n1_y = in_directions[stride];
    const double n1_z = in_directions[2 * stride];
    const double n2_x = in_directions[3 * stride];
    const double n2_y = in_directions[4 * stride];
    const double n2_z = in_directions[5 * stride];
    /* the third direction (5) [1] */
    const double n3_x = -n1_x - n2_x;
    const double n3_y = -n1_y - n2_y;
    const double n3_z = -n1_z - n2_z;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    const double x0 = (q1*q1);
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F1 = (gt1*gt1) + (gz1*gz1) - x0*(n1_x*n1_x);
    const double x1 = 2.0*gt1;
    const double x2 = 2.0*gz1;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF1_x = c_y*x1 + c_z*x2 - 2.0*n1_x*x0;
    const double dF1_y = h1*x1;
    const double dF1_z = h1*x2;
    const double x3 = SQRT3_2*c_y;
    const double x4 = 0.5*c_x;
    const double x5 = a + x4;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x3 + x5;
    const double x6 = 0.25*c_y;
    const double x7 = SQRT3_2*x4;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x6 + x7;
    const double x8 = 0.5*c_y;
    const double x9 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x8 - x9) - 0.5*h2;
    const double x10 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x10;
    const double x11 = SQRT3_2*c_z;
    const double hz2_y = x11;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = ht2_x*n2_x + ht2_y*n2_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2);
    const double x12 = 2.0*gt2;
    const double x13 = 2.0*gz2;
    const double x14 = 2.0*p2*q2;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF2_x = -hp2_x*x14 + ht2_x*x12 + hz2_x*x13;
    const double dF2_y = -hp2_y*x14 + ht2_y*x12 + hz2_y*x13;
    const double dF2_z = h2*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x3 + x5;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x6 - x7;
    const double ht3_y = -SQRT3_2*(-x8 + x9) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x10;
    const double hz3_y = -x11;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = ht3_x*n3_x + ht3_y*n3_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3);
    const double x15 = 2.0*gt3;
    const double x16 = 2.0*gz3;
    const double x17 = 2.0*p3*q3;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF3_x = -hp3_x*x17 + ht3_x*x15 + hz3_x*x16;
    const double dF3_y = -hp3_y*x17 + ht3_y*x15 + hz3_y*x16;
    const double dF3_z = h3*x16;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G1_x = -dF1_y*n1_z + dF1_z*n1_y;
    const double G1_y = dF1_x*n1_z - dF1_z*n1_x;
    const double G1_z = -dF1_x*n1_y + dF1_y*n1_x;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G2_x = -dF2_y*n2_z + dF2_z*n2_y;
    const double G2_y = dF2_x*n2_z - dF2_z*n2_x;
    const double G2_z = -dF2_x*n2_y + dF2_y*n2_x;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G3_x = -dF3_y*n3_z + dF3_z*n3_y;
    const double G3_y = dF3_x*n3_z - dF3_z*n3_x;
    const double G3_z = -dF3_x*n3_y + dF3_y*n3_x;
    const double x18 = G2_y*G3_z - G2_z*G3_y;
    const double x19 = -G2_x*G3_z + G2_z*G3_x;
    const double x20 = G2_x*G3_y - G2_y*G3_x;
    /* triple product of the derivatives: zero where modes meet [m⁶] */
    const double volume = G1_x*x18 + G1_y*x19 + G1_z*x20;
    const double x21 = 1.0/volume;
    /* Newton's turn, which cancels every F_i [rad] */
    const double turn_x = -x21*(F1*x18 + F2*(-G1_y*G3_z + G1_z*G3_y) + F3*(G1_y*G2_z - G1_z*G2_y));
    const double turn_y = -x21*(F1*x19 + F2*(G1_x*G3_z - G1_z*G3_x) + F3*(-G1_x*G2_z + G1_z*G2_x));
    const double turn_z = -x21*(F1*x20 + F2*(-G1_x*G3_y + G1_y*G3_x) + F3*(G1_x*G2_y - G1_y*G2_x));
    /* half of the turn [1] */
    const double half_turn_x = 0.5*turn_x;
    const double half_turn_y = 0.5*turn_y;
    const double half_turn_z = 0.5*turn_z;
    /* factor of Cayley's rotation [1] */
    const double cayley = 2.0/((half_turn_x*half_turn_x) + (half_turn_y*half_turn_y) + (half_turn_z*half_turn_z) + 1.0);
    const double x22 = half_turn_x*n1_y - half_turn_y*n1_x + n1_z;
    const double x23 = -half_turn_x*n1_z + half_turn_z*n1_x + n1_y;
    /* n_1 turned [1] */
    const double next1_x = cayley*(half_turn_y*x22 - half_turn_z*x23) + n1_x;
    const double x24 = half_turn_y*n1_z - half_turn_z*n1_y + n1_x;
    const double next1_y = cayley*(-half_turn_x*x22 + half_turn_z*x24) + n1_y;
    const double next1_z = cayley*(half_turn_x*x23 - half_turn_y*x24) + n1_z;
    const double x25 = half_turn_x*n2_y - half_turn_y*n2_x + n2_z;
    const double x26 = -half_turn_x*n2_z + half_turn_z*n2_x + n2_y;
    /* n_2 turned [1] */
    const double next2_x = cayley*(half_turn_y*x25 - half_turn_z*x26) + n2_x;
    const double x27 = half_turn_y*n2_z - half_turn_z*n2_y + n2_x;
    const double next2_y = cayley*(-half_turn_x*x25 + half_turn_z*x27) + n2_y;
    const double next2_z = cayley*(half_turn_x*x26 - half_turn_y*x27) + n2_z;
    out_next[0] = next1_x;
    out_next[stride] = next1_y;
    out_next[2 * stride] = next1_z;
    out_next[3 * stride] = next2_x;
    out_next[4 * stride] = next2_y;
    out_next[5 * stride] = next2_z;
    out_turn[0] = turn_x;
    out_turn[stride] = turn_y;
    out_turn[2 * stride] = turn_z;
    out_residual[0] = F1;
    out_residual[stride] = F2;
    out_residual[2 * stride] = F3;
    out_gradient[0] = G1_x;
    out_gradient[stride] = G1_y;
    out_gradient[2 * stride] = G1_z;
    out_gradient[3 * stride] = G2_x;
    out_gradient[4 * stride] = G2_y;
    out_gradient[5 * stride] = G2_z;
    out_gradient[6 * stride] = G3_x;
    out_gradient[7 * stride] = G3_y;
    out_gradient[8 * stride] = G3_z;
    out_volume[0] = volume;
}

KLEINFORM_API void kleinform_newton_step(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_directions[6],
    double out_next[6],
    double out_turn[3],
    double out_residual[3],
    double out_gradient[9],
    double *out_volume)
{
    newton_step_body(1, &in_a, in_c, in_lengths, in_directions, out_next, out_turn, out_residual, out_gradient, out_volume);
}

KLEINFORM_BODY void leg_step_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_lengths,
    const double *RESTRICT in_angle,
    const double *RESTRICT in_second,
    double *RESTRICT out_angle,
    double *RESTRICT out_directions,
    double *RESTRICT out_extension,
    double *RESTRICT out_steps)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double q1 = in_lengths[0];
    const double q2 = in_lengths[stride];
    const double q3 = in_lengths[2 * stride];
    const double cos_theta = in_angle[0];
    const double sin_theta = in_angle[stride];
    const double guess_x = in_second[0];
    const double guess_y = in_second[stride];
    const double guess_z = in_second[2 * stride];
    const double x0 = a - c_x;
    /* from C to B_1, leg 1 at the angle theta [m] */
    const double arm_x = x0;
    const double arm_y = -c_y + cos_theta*q1;
    const double x1 = -q1*sin_theta;
    const double arm_z = -c_z - x1;
    /* distance from C to B_1 [m] */
    const double span = sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z));
    const double x2 = 1.0/span;
    /* direction from C to B_1 (3) [1] */
    const double n1_x = arm_x*x2;
    const double n1_y = arm_y*x2;
    const double n1_z = arm_z*x2;
    /* derivative of B_1 by theta [m] */
    const double tangent_y = x1;
    const double tangent_z = cos_theta*q1;
    /* the turn that takes n_1 along with theta [1] */
    const double by_angle_x = x2*(n1_y*tangent_z - n1_z*tangent_y);
    const double x3 = n1_x*x2;
    const double by_angle_y = -tangent_z*x3;
    const double by_angle_z = tangent_y*x3;
    const double x4 = -guess_x*n1_x - guess_y*n1_y - guess_z*n1_z;
    /* part of the guess normal to n_1 [1] */
    const double side_part_x = guess_x + n1_x*x4;
    const double side_part_y = guess_y + n1_y*x4;
    const double side_part_z = guess_z + n1_z*x4;
    const double x5 = SQRT3_2/(sqrt((side_part_x*side_part_x) + (side_part_y*side_part_y) + (side_part_z*side_part_z)));
    /* direction from C to B_2 (5) [1] */
    const double n2_x = -0.5*n1_x + side_part_x*x5;
    const double n2_y = -0.5*n1_y + side_part_y*x5;
    const double n2_z = -0.5*n1_z + side_part_z*x5;
    /* the third direction (5) [1] */
    const double n3_x = -n1_x - n2_x;
    const double n3_y = -n1_y - n2_y;
    const double n3_z = -n1_z - n2_z;
    const double x6 = SQRT3_2*c_y;
    const double x7 = 0.5*c_x;
    const double x8 = a + x7;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x6 + x8;
    const double x9 = 0.25*c_y;
    const double x10 = SQRT3_2*x7;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x10 + x9;
    const double x11 = 0.5*c_y;
    const double x12 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x11 - x12) - 0.5*h2;
    const double x13 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x13;
    const double x14 = SQRT3_2*c_z;
    const double hz2_y = x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = ht2_x*n2_x + ht2_y*n2_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2);
    const double x15 = 2.0*gt2;
    const double x16 = 2.0*gz2;
    const double x17 = 2.0*p2*q2;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF2_x = -hp2_x*x17 + ht2_x*x15 + hz2_x*x16;
    const double dF2_y = -hp2_y*x17 + ht2_y*x15 + hz2_y*x16;
    const double dF2_z = h2*x16;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x6 + x8;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 - x10 + x9;
    const double ht3_y = -SQRT3_2*(-x11 + x12) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x13;
    const double hz3_y = -x14;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = ht3_x*n3_x + ht3_y*n3_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y;
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3);
    const double x18 = 2.0*gt3;
    const double x19 = 2.0*gz3;
    const double x20 = 2.0*p3*q3;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF3_x = -hp3_x*x20 + ht3_x*x18 + hz3_x*x19;
    const double dF3_y = -hp3_y*x20 + ht3_y*x18 + hz3_y*x19;
    const double dF3_z = h3*x19;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G2_x = -dF2_y*n2_z + dF2_z*n2_y;
    const double G2_y = dF2_x*n2_z - dF2_z*n2_x;
    const double G2_z = -dF2_x*n2_y + dF2_y*n2_x;
    /* derivative of F_i by theta [m²] */
    const double Ft2 = G2_x*by_angle_x + G2_y*by_angle_y + G2_z*by_angle_z;
    /* derivative of F_i by phi [m²] */
    const double Fp2 = G2_x*n1_x + G2_y*n1_y + G2_z*n1_z;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G3_x = -dF3_y*n3_z + dF3_z*n3_y;
    const double G3_y = dF3_x*n3_z - dF3_z*n3_x;
    const double G3_z = -dF3_x*n3_y + dF3_y*n3_x;
    /* derivative of F_i by theta [m²] */
    const double Ft3 = G3_x*by_angle_x + G3_y*by_angle_y + G3_z*by_angle_z;
    /* derivative of F_i by phi [m²] */
    const double Fp3 = G3_x*n1_x + G3_y*n1_y + G3_z*n1_z;
    /* determinant of the derivatives [m⁴] */
    const double det_leg = -Fp2*Ft3 + Fp3*Ft2;
    const double x21 = 1.0/det_leg;
    /* step of theta [rad] */
    const double dtheta = x21*(-F2*Fp3 + F3*Fp2);
    /* step of phi [rad] */
    const double dphi = x21*(F2*Ft3 - F3*Ft2);
    /* half of the step of theta [1] */
    const double half_step = 0.5*dtheta;
    const double x22 = (half_step*half_step);
    const double x23 = 1.0/(x22 + 1.0);
    const double x24 = 2.0*half_step;
    const double x25 = 1.0 - x22;
    /* cosine and sine of theta after the step [1] */
    const double next_leg_1 = x23*(cos_theta*x25 - sin_theta*x24);
    const double next_leg_2 = x23*(cos_theta*x24 + sin_theta*x25);
    /* n_2 moved by both steps, in first order [1] */
    const double next_guess_x = dphi*(n1_y*n2_z - n1_z*n2_y) + dtheta*(by_angle_y*n2_z - by_angle_z*n2_y) + n2_x;
    const double next_guess_y = dphi*(-n1_x*n2_z + n1_z*n2_x) + dtheta*(-by_angle_x*n2_z + by_angle_z*n2_x) + n2_y;
    const double next_guess_z = dphi*(n1_x*n2_y - n1_y*n2_x) + dtheta*(by_angle_x*n2_y - by_angle_y*n2_x) + n2_z;
    /* from C to B_1 after the step [m] */
    const double next_arm_x = x0;
    const double next_arm_y = -c_y + next_leg_1*q1;
    const double next_arm_z = -c_z + next_leg_2*q1;
    /* distance from C to B_1 after the step [m] */
    const double next_span = sqrt((next_arm_x*next_arm_x) + (next_arm_y*next_arm_y) + (next_arm_z*next_arm_z));
    const double x26 = 1.0/next_span;
    /* n_1 after the step (3) [1] */
    const double next_n1_x = next_arm_x*x26;
    const double next_n1_y = next_arm_y*x26;
    const double next_n1_z = next_arm_z*x26;
    const double x27 = -next_guess_x*next_n1_x - next_guess_y*next_n1_y - next_guess_z*next_n1_z;
    /* part of the moved n_2 normal to n_1 after the step [1] */
    const double next_side_x = next_guess_x + next_n1_x*x27;
    const double next_side_y = next_guess_y + next_n1_y*x27;
    const double next_side_z = next_guess_z + next_n1_z*x27;
    const double x28 = SQRT3_2/(sqrt((next_side_x*next_side_x) + (next_side_y*next_side_y) + (next_side_z*next_side_z)));
    /* n_2 after the step (5) [1] */
    const double next_n2_x = -0.5*next_n1_x + next_side_x*x28;
    const double next_n2_y = -0.5*next_n1_y + next_side_y*x28;
    const double next_n2_z = -0.5*next_n1_z + next_side_z*x28;
    out_angle[0] = next_leg_1;
    out_angle[stride] = next_leg_2;
    out_directions[0] = next_n1_x;
    out_directions[stride] = next_n1_y;
    out_directions[2 * stride] = next_n1_z;
    out_directions[3 * stride] = next_n2_x;
    out_directions[4 * stride] = next_n2_y;
    out_directions[5 * stride] = next_n2_z;
    out_extension[0] = next_span;
    out_steps[0] = dtheta;
    out_steps[stride] = dphi;
}

KLEINFORM_API void kleinform_leg_step(
    double in_a,
    const double in_c[3],
    const double in_lengths[3],
    const double in_angle[2],
    const double in_second[3],
    double out_angle[2],
    double out_directions[6],
    double *out_extension,
    double out_steps[2])
{
    leg_step_body(1, &in_a, in_c, in_lengths, in_angle, in_second, out_angle, out_directions, out_extension, out_steps);
}

KLEINFORM_BODY void fold_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_joints,
    const double *RESTRICT in_directions,
    double *RESTRICT out_residual,
    double *RESTRICT out_gradient,
    double *RESTRICT out_volume,
    double *RESTRICT out_volume_gradient,
    double *RESTRICT out_by_joints)
{
    const double a = in_a[0];
    const double q1 = in_joints[0];
    const double q2 = in_joints[stride];
    const double q3 = in_joints[2 * stride];
    const double q4 = in_joints[3 * stride];
    const double q5 = in_joints[4 * stride];
    const double q6 = in_joints[5 * stride];
    const double n1_x = in_directions[0];
    const double n1_y = in_directions[stride];
    const double n1_z = in_directions[2 * stride];
    const double n2_x = in_directions[3 * stride];
    const double n2_y = in_directions[4 * stride];
    const double n2_z = in_directions[5 * stride];
    const double x0 = cos(q4);
    const double x1 = cos(q5);
    const double x2 = x0*x1;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = x2;
    const double x3 = sin(q4);
    const double x4 = x1*x3;
    const double lambda_y = x4;
    const double x5 = sin(q5);
    const double lambda_z = x5;
    /* position of the platform's centre C (1) [m] */
    const double c_x = lambda_x*q6;
    const double c_y = lambda_y*q6;
    const double c_z = lambda_z*q6;
    /* the third direction (5) [1] */
    const double n3_x = -n1_x - n2_x;
    const double n3_y = -n1_y - n2_y;
    const double n3_z = -n1_z - n2_z;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    const double x6 = (q1*q1);
    const double x7 = x6*(n1_x*n1_x);
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F1 = (gt1*gt1) + (gz1*gz1) - x7;
    const double x8 = 2.0*gt1;
    const double x9 = 2.0*gz1;
    const double x10 = 2.0*x6;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF1_x = c_y*x8 + c_z*x9 - n1_x*x10;
    const double dF1_y = h1*x8;
    const double dF1_z = h1*x9;
    const double x11 = SQRT3_2*c_y;
    const double x12 = 0.5*c_x;
    const double x13 = a + x12;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x11 + x13;
    const double x14 = 0.25*c_y;
    const double x15 = SQRT3_2*x12;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht2_x = -SQRT3_2*h2 + x14 + x15;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    const double ht2_y = SQRT3_2*(-x16 - x17) - 0.5*h2;
    const double x18 = -0.5*c_z;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz2_x = x18;
    const double x19 = SQRT3_2*c_z;
    const double hz2_y = x19;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp2_x = -0.5*q2;
    const double hp2_y = SQRT3_2*q2;
    const double x20 = 0.5*n2_x;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - x20;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = ht2_x*n2_x + ht2_y*n2_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y;
    const double x21 = (p2*p2)*(q2*q2);
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F2 = (gt2*gt2) + (gz2*gz2) - x21;
    const double x22 = 2.0*gt2;
    const double x23 = 2.0*gz2;
    const double x24 = 2.0*p2*q2;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF2_x = -hp2_x*x24 + ht2_x*x22 + hz2_x*x23;
    const double dF2_y = -hp2_y*x24 + ht2_y*x22 + hz2_y*x23;
    const double dF2_z = h2*x23;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x11 + x13;
    /* p_i times the horizontal part of the leg, as a form in n_i [m] */
    const double ht3_x = SQRT3_2*h3 + x14 - x15;
    const double ht3_y = -SQRT3_2*(-x16 + x17) - 0.5*h3;
    /* p_i times the vertical part of the leg, as a form in n_i [m] */
    const double hz3_x = x18;
    const double hz3_y = -x19;
    /* p_i times the length of the leg, as a form in n_i [m] */
    const double hp3_x = -0.5*q3;
    const double hp3_y = -SQRT3_2*q3;
    const double x25 = 0.5*n3_x;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - x25;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = ht3_x*n3_x + ht3_y*n3_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y;
    const double x26 = (p3*p3)*(q3*q3);
    /* closure equation of limb i, times p_i squared (6) [m²] */
    const double F3 = (gt3*gt3) + (gz3*gz3) - x26;
    const double x27 = 2.0*gt3;
    const double x28 = 2.0*gz3;
    const double x29 = 2.0*p3*q3;
    /* gradient of F_i in n_i (6) [m²] */
    const double dF3_x = -hp3_x*x29 + ht3_x*x27 + hz3_x*x28;
    const double dF3_y = -hp3_y*x29 + ht3_y*x27 + hz3_y*x28;
    const double dF3_z = h3*x28;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G1_x = -dF1_y*n1_z + dF1_z*n1_y;
    const double G1_y = dF1_x*n1_z - dF1_z*n1_x;
    const double G1_z = -dF1_x*n1_y + dF1_y*n1_x;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G2_x = -dF2_y*n2_z + dF2_z*n2_y;
    const double G2_y = dF2_x*n2_z - dF2_z*n2_x;
    const double G2_z = -dF2_x*n2_y + dF2_y*n2_x;
    /* derivative of F_i by a turn of the platform (6) [m²] */
    const double G3_x = -dF3_y*n3_z + dF3_z*n3_y;
    const double G3_y = dF3_x*n3_z - dF3_z*n3_x;
    const double G3_z = -dF3_x*n3_y + dF3_y*n3_x;
    const double x30 = G2_y*G3_z - G2_z*G3_y;
    const double x31 = -G2_x*G3_z + G2_z*G3_x;
    const double x32 = G2_x*G3_y - G2_y*G3_x;
    /* triple product of the derivatives: zero where modes meet [m⁶] */
    const double volume = G1_x*x30 + G1_y*x31 + G1_z*x32;
    /* cofactor of the derivative of F_i by a turn [m⁴] */
    const double across1_x = x30;
    const double across1_y = x31;
    const double across1_z = x32;
    /* change of n_i by a turn [m⁴] */
    const double slide1_x = across1_y*n1_z - across1_z*n1_y;
    const double slide1_y = -across1_x*n1_z + across1_z*n1_x;
    const double slide1_z = across1_x*n1_y - across1_y*n1_x;
    const double x33 = 2.0*slide1_x;
    const double x34 = 2.0*h1;
    const double x35 = c_y*x33 + slide1_y*x34;
    const double x36 = c_z*x33 + slide1_z*x34;
    /* change of the gradient of F_i with n_i [m⁶] */
    const double bend1_x = c_y*x35 + c_z*x36 - slide1_x*x10;
    const double bend1_y = h1*x35;
    const double bend1_z = h1*x36;
    /* cofactor of the derivative of F_i by a turn [m⁴] */
    const double across2_x = -G1_y*G3_z + G1_z*G3_y;
    const double across2_y = G1_x*G3_z - G1_z*G3_x;
    const double across2_z = -G1_x*G3_y + G1_y*G3_x;
    /* change of n_i by a turn [m⁴] */
    const double slide2_x = across2_y*n2_z - across2_z*n2_y;
    const double slide2_y = -across2_x*n2_z + across2_z*n2_x;
    const double slide2_z = across2_x*n2_y - across2_y*n2_x;
    const double x37 = 2.0*slide2_x;
    const double x38 = 2.0*slide2_y;
    const double x39 = -hp2_x*x37 - hp2_y*x38;
    const double x40 = ht2_x*x37 + ht2_y*x38;
    const double x41 = 2.0*h2*slide2_z + hz2_x*x37 + hz2_y*x38;
    /* change of the gradient of F_i with n_i [m⁶] */
    const double bend2_x = hp2_x*x39 + ht2_x*x40 + hz2_x*x41;
    const double bend2_y = hp2_y*x39 + ht2_y*x40 + hz2_y*x41;
    const double bend2_z = h2*x41;
    /* cofactor of the derivative of F_i by a turn [m⁴] */
    const double across3_x = G1_y*G2_z - G1_z*G2_y;
    const double across3_y = -G1_x*G2_z + G1_z*G2_x;
    const double across3_z = G1_x*G2_y - G1_y*G2_x;
    /* change of n_i by a turn [m⁴] */
    const double slide3_x = across3_y*n3_z - across3_z*n3_y;
    const double slide3_y = -across3_x*n3_z + across3_z*n3_x;
    const double slide3_z = across3_x*n3_y - across3_y*n3_x;
    const double x42 = 2.0*slide3_x;
    const double x43 = 2.0*slide3_y;
    const double x44 = -hp3_x*x42 - hp3_y*x43;
    const double x45 = ht3_x*x42 + ht3_y*x43;
    const double x46 = 2.0*h3*slide3_z + hz3_x*x42 + hz3_y*x43;
    /* change of the gradient of F_i with n_i [m⁶] */
    const double bend3_x = hp3_x*x44 + ht3_x*x45 + hz3_x*x46;
    const double bend3_y = hp3_y*x44 + ht3_y*x45 + hz3_y*x46;
    const double bend3_z = h3*x46;
    const double x47 = -across1_x*dF1_y + across1_y*dF1_x + bend1_z;
    const double x48 = -across2_x*dF2_y + across2_y*dF2_x + bend2_z;
    const double x49 = -across3_x*dF3_y + across3_y*dF3_x + bend3_z;
    const double x50 = across1_x*dF1_z - across1_z*dF1_x + bend1_y;
    const double x51 = across2_x*dF2_z - across2_z*dF2_x + bend2_y;
    const double x52 = across3_x*dF3_z - across3_z*dF3_x + bend3_y;
    /* derivative of the triple product by a turn of the platform [m⁶] */
    const double dvolume_x = n1_y*x47 - n1_z*x50 + n2_y*x48 - n2_z*x51 + n3_y*x49 - n3_z*x52;
    const double x53 = -across1_y*dF1_z + across1_z*dF1_y + bend1_x;
    const double x54 = -across2_y*dF2_z + across2_z*dF2_y + bend2_x;
    const double x55 = -across3_y*dF3_z + across3_z*dF3_y + bend3_x;
    const double dvolume_y = -n1_x*x47 + n1_z*x53 - n2_x*x48 + n2_z*x54 - n3_x*x49 + n3_z*x55;
    const double dvolume_z = n1_x*x50 - n1_y*x53 + n2_x*x51 - n2_y*x54 + n3_x*x52 - n3_y*x55;
    /* derivative of lambda by q4 [1] */
    const double dlambda4_x = -x4;
    const double dlambda4_y = x2;
    /* derivative of lambda by q5 [1] */
    const double dlambda5_x = -x0*x5;
    const double dlambda5_y = -x3*x5;
    const double dlambda5_z = x1;
    /* gradient of F_i by the position of C (6) [m] */
    const double cF1_x = -n1_y*x8 - n1_z*x9;
    const double cF1_y = n1_x*x8;
    const double cF1_z = n1_x*x9;
    const double x56 = gz2*n2_z;
    /* gradient of F_i by the position of C (6) [m] */
    const double cF2_x = x22*(-SQRT3_2*p2 - SQRT3_2*x20 - 0.25*n2_y) + x56;
    const double x57 = 2.0*SQRT3_2;
    const double cF2_y = 2.0*gt2*(SQRT3_2*(SQRT3_2*n2_x + 0.5*n2_y) - 0.5*p2) - x56*x57;
    const double cF2_z = p2*x23;
    const double x58 = gz3*n3_z;
    /* gradient of F_i by the position of C (6) [m] */
    const double cF3_x = x27*(SQRT3_2*p3 + SQRT3_2*x25 - 0.25*n3_y) + x58;
    const double cF3_y = x27*(-SQRT3_2*(-SQRT3_2*n3_x + 0.5*n3_y) - 0.5*p3) + x57*x58;
    const double cF3_z = p3*x28;
    /* derivatives of F by the logarithms of the joint values (6) [m²] */
    const double qF_11 = -2.0*x7;
    const double x59 = q4*q6;
    const double qF_14 = x59*(cF1_x*dlambda4_x + cF1_y*dlambda4_y);
    const double x60 = q5*q6;
    const double qF_15 = x60*(cF1_x*dlambda5_x + cF1_y*dlambda5_y + cF1_z*dlambda5_z);
    const double qF_16 = cF1_x*c_x + cF1_y*c_y + cF1_z*c_z;
    const double qF_22 = -2.0*x21;
    const double qF_24 = x59*(cF2_x*dlambda4_x + cF2_y*dlambda4_y);
    const double qF_25 = x60*(cF2_x*dlambda5_x + cF2_y*dlambda5_y + cF2_z*dlambda5_z);
    const double qF_26 = cF2_x*c_x + cF2_y*c_y + cF2_z*c_z;
    const double qF_33 = -2.0*x26;
    const double qF_34 = x59*(cF3_x*dlambda4_x + cF3_y*dlambda4_y);
    const double qF_35 = x60*(cF3_x*dlambda5_x + cF3_y*dlambda5_y + cF3_z*dlambda5_z);
    const double qF_36 = cF3_x*c_x + cF3_y*c_y + cF3_z*c_z;
    out_residual[0] = F1;
    out_residual[stride] = F2;
    out_residual[2 * stride] = F3;
    out_gradient[0] = G1_x;
    out_gradient[stride] = G1_y;
    out_gradient[2 * stride] = G1_z;
    out_gradient[3 * stride] = G2_x;
    out_gradient[4 * stride] = G2_y;
    out_gradient[5 * stride] = G2_z;
    out_gradient[6 * stride] = G3_x;
    out_gradient[7 * stride] = G3_y;
    out_gradient[8 * stride] = G3_z;
    out_volume[0] = volume;
    out_volume_gradient[0] = dvolume_x;
    out_volume_gradient[stride] = dvolume_y;
    out_volume_gradient[2 * stride] = dvolume_z;
    out_by_joints[0] = qF_11;
    out_by_joints[stride] = 0.0;
    out_by_joints[2 * stride] = 0.0;
    out_by_joints[3 * stride] = qF_14;
    out_by_joints[4 * stride] = qF_15;
    out_by_joints[5 * stride] = qF_16;
    out_by_joints[6 * stride] = 0.0;
    out_by_joints[7 * stride] = qF_22;
    out_by_joints[8 * stride] = 0.0;
    out_by_joints[9 * stride] = qF_24;
    out_by_joints[10 * stride] = qF_25;
    out_by_joints[11 * stride] = qF_26;
    out_by_joints[12 * stride] = 0.0;
    out_by_joints[13 * stride] = 0.0;
    out_by_joints[14 * stride] = qF_33;
    out_by_joints[15 * stride] = qF_34;
    out_by_joints[16 * stride] = qF_35;
    out_by_joints[17 * stride] = qF_36;
}

KLEINFORM_API void kleinform_fold(
    double in_a,
    const double in_joints[6],
    const double in_directions[6],
    double out_residual[3],
    double out_gradient[9],
    double *out_volume,
    double out_volume_gradient[3],
    double out_by_joints[18])
{
    fold_body(1, &in_a, in_joints, in_directions, out_residual, out_gradient, out_volume, out_volume_gradient, out_by_joints);
}

KLEINFORM_BODY void rotation_from_rpy_body(
    size_t stride,
    const double *RESTRICT in_roll,
    const double *RESTRICT in_pitch,
    const double *RESTRICT in_yaw,
    double *RESTRICT out_rotation)
{
    const double gamma = in_roll[0];
    const double beta = in_pitch[0];
    const double alpha = in_yaw[0];
    const double x0 = cos(alpha);
    const double x1 = cos(beta);
    /* rotation of the platform (9) [1] */
    const double R_11 = x0*x1;
    const double x2 = sin(alpha);
    const double x3 = cos(gamma);
    const double x4 = x2*x3;
    const double x5 = sin(beta);
    const double x6 = sin(gamma);
    const double R_12 = x0*x5*x6 - x4;
    const double x7 = x2*x6;
    const double x8 = x0*x3;
    const double R_13 = x5*x8 + x7;
    const double R_21 = x1*x2;
    const double R_22 = x5*x7 + x8;
    const double R_23 = -x0*x6 + x4*x5;
    const double R_31 = -x5;
    const double R_32 = x1*x6;
    const double R_33 = x1*x3;
    out_rotation[0] = R_11;
    out_rotation[stride] = R_12;
    out_rotation[2 * stride] = R_13;
    out_rotation[3 * stride] = R_21;
    out_rotation[4 * stride] = R_22;
    out_rotation[5 * stride] = R_23;
    out_rotation[6 * stride] = R_31;
    out_rotation[7 * stride] = R_32;
    out_rotation[8 * stride] = R_33;
}

KLEINFORM_API void kleinform_rotation_from_rpy(
    double in_roll,
    double in_pitch,
    double in_yaw,
    double out_rotation[9])
{
    rotation_from_rpy_body(1, &in_roll, &in_pitch, &in_yaw, out_rotation);
}

KLEINFORM_BODY void rpy_from_rotation_body(
    size_t stride,
    const double *RESTRICT in_R,
    double *RESTRICT out_roll,
    double *RESTRICT out_pitch,
    double *RESTRICT out_yaw)
{
    const double R_11 = in_R[0];
    const double R_12 = in_R[stride];
    const double R_13 = in_R[2 * stride];
    const double R_21 = in_R[3 * stride];
    const double R_22 = in_R[4 * stride];
    const double R_23 = in_R[5 * stride];
    const double R_31 = in_R[6 * stride];
    /* yaw (9) [rad] */
    const double alpha = angle_of(R_21, R_11);
    /* pitch (9) [rad] */
    const double beta = angle_of(-R_31, sqrt((R_11*R_11) + (R_21*R_21)));
    const double x0 = sin(alpha);
    const double x1 = cos(alpha);
    /* roll (9) [rad] */
    const double gamma = angle_of(R_13*x0 - R_23*x1, -R_12*x0 + R_22*x1);
    out_roll[0] = gamma;
    out_pitch[0] = beta;
    out_yaw[0] = alpha;
}

KLEINFORM_API void kleinform_rpy_from_rotation(
    const double in_R[9],
    double *out_roll,
    double *out_pitch,
    double *out_yaw)
{
    rpy_from_rotation_body(1, in_R, out_roll, out_pitch, out_yaw);
}

KLEINFORM_BODY void rotation_from_directions_body(
    size_t stride,
    const double *RESTRICT in_n1,
    const double *RESTRICT in_n2,
    double *RESTRICT out_rotation)
{
    const double n1_x = in_n1[0];
    const double n1_y = in_n1[stride];
    const double n1_z = in_n1[2 * stride];
    const double n2_x = in_n2[0];
    const double n2_y = in_n2[stride];
    const double n2_z = in_n2[2 * stride];
    const double x0 = n1_y*n2_z - n1_z*n2_y;
    const double x1 = n1_x*n2_y - n1_y*n2_x;
    const double x2 = -n1_x*n2_z + n1_z*n2_x;
    const double x3 = 1.0/(sqrt((x0*x0) + (x1*x1) + (x2*x2)));
    /* normal of the platform (8) [1] */
    const double nu_x = x0*x3;
    const double nu_y = x2*x3;
    const double nu_z = x1*x3;
    const double x4 = -n1_y*x1 + n1_z*x2;
    const double x5 = n1_x*x1 - n1_z*x0;
    const double x6 = -n1_x*x2 + n1_y*x0;
    const double x7 = 1.0/(sqrt((x4*x4) + (x5*x5) + (x6*x6)));
    /* platform y axis (8) [1] */
    const double m1_x = x4*x7;
    const double m1_y = x5*x7;
    const double m1_z = x6*x7;
    out_rotation[0] = n1_x;
    out_rotation[stride] = m1_x;
    out_rotation[2 * stride] = nu_x;
    out_rotation[3 * stride] = n1_y;
    out_rotation[4 * stride] = m1_y;
    out_rotation[5 * stride] = nu_y;
    out_rotation[6 * stride] = n1_z;
    out_rotation[7 * stride] = m1_z;
    out_rotation[8 * stride] = nu_z;
}

KLEINFORM_API void kleinform_rotation_from_directions(
    const double in_n1[3],
    const double in_n2[3],
    double out_rotation[9])
{
    rotation_from_directions_body(1, in_n1, in_n2, out_rotation);
}

KLEINFORM_BODY void rotation_defect_body(
    size_t stride,
    const double *RESTRICT in_R,
    double *RESTRICT out_defect)
{
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    /* n_1 × m_1 − ν, zero for a rotation [1] */
    const double gap_x = -m1_y*n1_z + m1_z*n1_y - nu_x;
    const double gap_y = m1_x*n1_z - m1_z*n1_x - nu_y;
    const double gap_z = -m1_x*n1_y + m1_y*n1_x - nu_z;
    /* root of the squared defects of |n_1| = |m_1| = 1, n_1·m_1 = 0, n_1 × m_1 = ν [1] */
    const double defect = sqrt((gap_x*gap_x) + (gap_y*gap_y) + (gap_z*gap_z) + ((m1_x*n1_x + m1_y*n1_y + m1_z*n1_z)*(m1_x*n1_x + m1_y*n1_y + m1_z*n1_z)) + (((m1_x*m1_x) + (m1_y*m1_y) + (m1_z*m1_z) - 1.0)*((m1_x*m1_x) + (m1_y*m1_y) + (m1_z*m1_z) - 1.0)) + (((n1_x*n1_x) + (n1_y*n1_y) + (n1_z*n1_z) - 1.0)*((n1_x*n1_x) + (n1_y*n1_y) + (n1_z*n1_z) - 1.0)));
    out_defect[0] = defect;
}

KLEINFORM_API void kleinform_rotation_defect(
    const double in_R[9],
    double *out_defect)
{
    rotation_defect_body(1, in_R, out_defect);
}

KLEINFORM_BODY void limb_geometry_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_d,
    double *RESTRICT out_w,
    double *RESTRICT out_lines)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    const double x12 = 1.0/n1_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1*x12;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    /* length of the outer limb (10) [m] */
    const double q1 = l1/fabs(n1_x);
    const double x13 = x12/q1;
    /* unit vector along the outer limb Section IV [1] */
    const double w1_y = gt1*x13;
    const double w1_z = gz1*x13;
    /* p_i times the part of the leg along n_i [m] */
    const double ng1 = gt1*n1_y + gz1*n1_z;
    /* signed distance from O to D_i (7) [m] */
    const double delta1 = a + ng1/((n1_x*n1_x));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x16 = 1.0/p2;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2*x16;
    const double x17 = -SQRT3_2*n2_x - 0.5*n2_y;
    const double x18 = 0.5*c_y;
    const double x19 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*x17 + p2*(-x18 - x19);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* length of the outer limb (10) [m] */
    const double q2 = l2/fabs(p2);
    const double x20 = x16/q2;
    const double x21 = gt2*x20;
    /* unit vector along the outer limb Section IV [1] */
    const double w2_x = -SQRT3_2*x21;
    const double w2_y = -0.5*x21;
    const double w2_z = gz2*x20;
    /* p_i times the part of the leg along n_i [m] */
    const double ng2 = gt2*x17 + gz2*n2_z;
    /* signed distance from O to D_i (7) [m] */
    const double delta2 = a + ng2/((p2*p2));
    /* position of D_i (7) [m] */
    const double d2_x = -0.5*delta2;
    const double d2_y = SQRT3_2*delta2;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x22 = 1.0/p3;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3*x22;
    const double x23 = SQRT3_2*n3_x - 0.5*n3_y;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*x23 + p3*(-x18 + x19);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* length of the outer limb (10) [m] */
    const double q3 = l3/fabs(p3);
    const double x24 = x22/q3;
    const double x25 = gt3*x24;
    /* unit vector along the outer limb Section IV [1] */
    const double w3_x = SQRT3_2*x25;
    const double w3_y = -0.5*x25;
    const double w3_z = gz3*x24;
    /* p_i times the part of the leg along n_i [m] */
    const double ng3 = gt3*x23 + gz3*n3_z;
    /* signed distance from O to D_i (7) [m] */
    const double delta3 = a + ng3/((p3*p3));
    /* position of D_i (7) [m] */
    const double d3_x = -0.5*delta3;
    const double d3_y = -SQRT3_2*delta3;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x26 = 1.0/rho1;
    /* unit vector from B_i to D_i (14) [1] */
    const double s1_x = x26*(m1_x*tau1 + nu_x*sigma1);
    const double s1_y = x26*(m1_y*tau1 + nu_y*sigma1);
    const double s1_z = x26*(m1_z*tau1 + nu_z*sigma1);
    const double x27 = e1*x26;
    /* moment of S_i about C (14) [m] */
    const double so1_x = x27*(-m1_x*sigma1 + nu_x*tau1);
    const double so1_y = x27*(-m1_y*sigma1 + nu_y*tau1);
    const double so1_z = x27*(-m1_z*sigma1 + nu_z*tau1);
    const double x28 = 0.5*nu_y;
    const double x29 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x28 - x29);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x30 = 1.0/rho2;
    /* unit vector from B_i to D_i (14) [1] */
    const double s2_x = x30*(m2_x*tau2 + nu_x*sigma2);
    const double s2_y = x30*(m2_y*tau2 + nu_y*sigma2);
    const double s2_z = x30*(m2_z*tau2 + nu_z*sigma2);
    const double x31 = e2*x30;
    /* moment of S_i about C (14) [m] */
    const double so2_x = x31*(-m2_x*sigma2 + nu_x*tau2);
    const double so2_y = x31*(-m2_y*sigma2 + nu_y*tau2);
    const double so2_z = x31*(-m2_z*sigma2 + nu_z*tau2);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x28 + x29);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x32 = 1.0/rho3;
    /* unit vector from B_i to D_i (14) [1] */
    const double s3_x = x32*(m3_x*tau3 + nu_x*sigma3);
    const double s3_y = x32*(m3_y*tau3 + nu_y*sigma3);
    const double s3_z = x32*(m3_z*tau3 + nu_z*sigma3);
    const double x33 = e3*x32;
    /* moment of S_i about C (14) [m] */
    const double so3_x = x33*(-m3_x*sigma3 + nu_x*tau3);
    const double so3_y = x33*(-m3_y*sigma3 + nu_y*tau3);
    const double so3_z = x33*(-m3_z*sigma3 + nu_z*tau3);
    out_d[0] = delta1;
    out_d[stride] = 0.0;
    out_d[2 * stride] = 0.0;
    out_d[3 * stride] = d2_x;
    out_d[4 * stride] = d2_y;
    out_d[5 * stride] = 0.0;
    out_d[6 * stride] = d3_x;
    out_d[7 * stride] = d3_y;
    out_d[8 * stride] = 0.0;
    out_w[0] = 0.0;
    out_w[stride] = w1_y;
    out_w[2 * stride] = w1_z;
    out_w[3 * stride] = w2_x;
    out_w[4 * stride] = w2_y;
    out_w[5 * stride] = w2_z;
    out_w[6 * stride] = w3_x;
    out_w[7 * stride] = w3_y;
    out_w[8 * stride] = w3_z;
    out_lines[0] = s1_x;
    out_lines[stride] = s1_y;
    out_lines[2 * stride] = s1_z;
    out_lines[3 * stride] = so1_x;
    out_lines[4 * stride] = so1_y;
    out_lines[5 * stride] = so1_z;
    out_lines[6 * stride] = s2_x;
    out_lines[7 * stride] = s2_y;
    out_lines[8 * stride] = s2_z;
    out_lines[9 * stride] = so2_x;
    out_lines[10 * stride] = so2_y;
    out_lines[11 * stride] = so2_z;
    out_lines[12 * stride] = s3_x;
    out_lines[13 * stride] = s3_y;
    out_lines[14 * stride] = s3_z;
    out_lines[15 * stride] = so3_x;
    out_lines[16 * stride] = so3_y;
    out_lines[17 * stride] = so3_z;
}

KLEINFORM_API void kleinform_limb_geometry(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double out_d[9],
    double out_w[9],
    double out_lines[18])
{
    limb_geometry_body(1, &in_a, in_c, in_R, out_d, out_w, out_lines);
}

KLEINFORM_BODY void screws_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    double *RESTRICT out_limb1,
    double *RESTRICT out_limb2,
    double *RESTRICT out_limb3,
    double *RESTRICT out_limb4,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    const double x6 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x6);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x6);
    const double x7 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x7;
    const double lambda_y = c_y*x7;
    const double lambda_z = c_z*x7;
    const double x8 = -c_x;
    const double x9 = a + x8;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = x9;
    const double x10 = 1.0/n1_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1*x10;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    /* length of the outer limb (10) [m] */
    const double q1 = l1/fabs(n1_x);
    const double x11 = 1.0/q1;
    const double x12 = gt1*x11;
    /* unit vector along the outer limb Section IV [1] */
    const double w1_y = x10*x12;
    const double x13 = gz1*x11;
    const double w1_z = x10*x13;
    const double x14 = -0.5*a;
    /* position of A_2 Section II [m] */
    const double a2_x = x14;
    const double x15 = SQRT3_2*a;
    const double a2_y = x15;
    const double x16 = SQRT3_2*c_y;
    const double x17 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x16 + x17;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x18 = 1.0/p2;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2*x18;
    const double x19 = -SQRT3_2*n2_x - 0.5*n2_y;
    const double x20 = 0.5*c_y;
    const double x21 = SQRT3_2*c_x;
    const double x22 = -x20 - x21;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*x19 + p2*x22;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* length of the outer limb (10) [m] */
    const double q2 = l2/fabs(p2);
    const double x23 = 1.0/q2;
    const double x24 = gt2*x23;
    const double x25 = x18*x24;
    /* unit vector along the outer limb Section IV [1] */
    const double w2_x = -SQRT3_2*x25;
    const double w2_y = -0.5*x25;
    const double w2_z = gz2*x18*x23;
    /* position of A_3 Section II [m] */
    const double a3_x = x14;
    const double a3_y = -x15;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x16 + x17;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x26 = 1.0/p3;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3*x26;
    const double x27 = SQRT3_2*n3_x - 0.5*n3_y;
    const double x28 = -x20;
    const double x29 = x21 + x28;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*x27 + p3*x29;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* length of the outer limb (10) [m] */
    const double q3 = l3/fabs(p3);
    const double x30 = 1.0/q3;
    const double x31 = gt3*x30;
    const double x32 = x26*x31;
    /* unit vector along the outer limb Section IV [1] */
    const double w3_x = SQRT3_2*x32;
    const double w3_y = -0.5*x32;
    const double w3_z = gz3*x26*x30;
    const double x33 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x33;
    const double axis_y = -heading_1*x33;
    const double x34 = -c_y;
    /* lower revolute, actuated by q4 Section IV [1, m] */
    const double screw41_ox = x34;
    /* second revolute, actuated by q5 Section IV [1, m] */
    const double screw42_ox = axis_y*c_z;
    const double screw42_oy = -axis_x*c_z;
    const double screw42_oz = axis_x*c_y - axis_y*c_x;
    /* universal joint, second axis Section IV [1, m] */
    const double screw46_x = x1;
    const double screw46_y = x3;
    const double screw46_z = x5;
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw1_x = x11*(-c_y*n1_z + c_z*n1_y);
    const double nw1_y = -x13;
    const double nw1_z = x12;
    /* base revolute Section IV [1, m] */
    const double screw11_oy = -c_z;
    /* revolute along the leg Section IV [1, m] */
    const double screw13_ox = -c_y*w1_z + c_z*w1_y;
    const double x35 = -x9;
    const double screw13_oy = w1_z*x35;
    const double screw13_oz = -w1_y*x35;
    /* upper revolute Section IV [1, m] */
    const double screw14_ox = e1*(n1_y*nw1_z - n1_z*nw1_y);
    const double screw14_oy = e1*(-n1_x*nw1_z + n1_z*nw1_x);
    const double screw14_oz = e1*(n1_x*nw1_y - n1_y*nw1_x);
    const double x36 = c_z*x19;
    const double x37 = n2_z*x22;
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw2_x = x23*(SQRT3_2*gz2 - 0.5*x36 + 0.5*x37);
    const double nw2_y = x23*(SQRT3_2*(x36 - x37) + 0.5*gz2);
    const double nw2_z = x24;
    const double x38 = SQRT3_2*c_z;
    /* base revolute Section IV [1, m] */
    const double screw21_ox = x38;
    const double x39 = 0.5*c_z;
    const double screw21_oy = x39;
    const double x40 = -a2_x - x8;
    const double screw21_oz = -SQRT3_2*x40 + 0.5*a2_y - x20;
    const double x41 = -a2_y - x34;
    /* revolute along the leg Section IV [1, m] */
    const double screw23_ox = c_z*w2_y - w2_z*x41;
    const double screw23_oy = -c_z*w2_x + w2_z*x40;
    const double screw23_oz = w2_x*x41 - w2_y*x40;
    /* upper revolute Section IV [1, m] */
    const double screw24_ox = e2*(n2_y*nw2_z - n2_z*nw2_y);
    const double screw24_oy = e2*(-n2_x*nw2_z + n2_z*nw2_x);
    const double screw24_oz = e2*(n2_x*nw2_y - n2_y*nw2_x);
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw3_x = x30*(-SQRT3_2*gz3 + 0.5*n3_z*x29 - x27*x39);
    const double nw3_y = x30*(-SQRT3_2*(c_z*x27 - n3_z*x29) + 0.5*gz3);
    const double nw3_z = x31;
    /* base revolute Section IV [1, m] */
    const double screw31_ox = -x38;
    const double screw31_oy = x39;
    const double x42 = -a3_x - x8;
    const double screw31_oz = SQRT3_2*x42 + 0.5*a3_y + x28;
    const double x43 = -a3_y - x34;
    /* revolute along the leg Section IV [1, m] */
    const double screw33_ox = c_z*w3_y - w3_z*x43;
    const double screw33_oy = -c_z*w3_x + w3_z*x42;
    const double screw33_oz = w3_x*x43 - w3_y*x42;
    /* upper revolute Section IV [1, m] */
    const double screw34_ox = e3*(n3_y*nw3_z - n3_z*nw3_y);
    const double screw34_oy = e3*(-n3_x*nw3_z + n3_z*nw3_x);
    const double screw34_oz = e3*(n3_x*nw3_y - n3_y*nw3_x);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    out_limb1[0] = 1.0;
    out_limb1[stride] = 0.0;
    out_limb1[2 * stride] = 0.0;
    out_limb1[3 * stride] = 0.0;
    out_limb1[4 * stride] = screw11_oy;
    out_limb1[5 * stride] = c_y;
    out_limb1[6 * stride] = 0.0;
    out_limb1[7 * stride] = 0.0;
    out_limb1[8 * stride] = 0.0;
    out_limb1[9 * stride] = 0.0;
    out_limb1[10 * stride] = w1_y;
    out_limb1[11 * stride] = w1_z;
    out_limb1[12 * stride] = 0.0;
    out_limb1[13 * stride] = w1_y;
    out_limb1[14 * stride] = w1_z;
    out_limb1[15 * stride] = screw13_ox;
    out_limb1[16 * stride] = screw13_oy;
    out_limb1[17 * stride] = screw13_oz;
    out_limb1[18 * stride] = nw1_x;
    out_limb1[19 * stride] = nw1_y;
    out_limb1[20 * stride] = nw1_z;
    out_limb1[21 * stride] = screw14_ox;
    out_limb1[22 * stride] = screw14_oy;
    out_limb1[23 * stride] = screw14_oz;
    out_limb1[24 * stride] = n1_x;
    out_limb1[25 * stride] = n1_y;
    out_limb1[26 * stride] = n1_z;
    out_limb1[27 * stride] = 0.0;
    out_limb1[28 * stride] = 0.0;
    out_limb1[29 * stride] = 0.0;
    out_limb1[30 * stride] = 0.0;
    out_limb1[31 * stride] = 0.0;
    out_limb1[32 * stride] = 0.0;
    out_limb1[33 * stride] = n1_x;
    out_limb1[34 * stride] = n1_y;
    out_limb1[35 * stride] = n1_z;
    out_limb2[0] = -0.5;
    out_limb2[stride] = SQRT3_2;
    out_limb2[2 * stride] = 0.0;
    out_limb2[3 * stride] = screw21_ox;
    out_limb2[4 * stride] = screw21_oy;
    out_limb2[5 * stride] = screw21_oz;
    out_limb2[6 * stride] = 0.0;
    out_limb2[7 * stride] = 0.0;
    out_limb2[8 * stride] = 0.0;
    out_limb2[9 * stride] = w2_x;
    out_limb2[10 * stride] = w2_y;
    out_limb2[11 * stride] = w2_z;
    out_limb2[12 * stride] = w2_x;
    out_limb2[13 * stride] = w2_y;
    out_limb2[14 * stride] = w2_z;
    out_limb2[15 * stride] = screw23_ox;
    out_limb2[16 * stride] = screw23_oy;
    out_limb2[17 * stride] = screw23_oz;
    out_limb2[18 * stride] = nw2_x;
    out_limb2[19 * stride] = nw2_y;
    out_limb2[20 * stride] = nw2_z;
    out_limb2[21 * stride] = screw24_ox;
    out_limb2[22 * stride] = screw24_oy;
    out_limb2[23 * stride] = screw24_oz;
    out_limb2[24 * stride] = n2_x;
    out_limb2[25 * stride] = n2_y;
    out_limb2[26 * stride] = n2_z;
    out_limb2[27 * stride] = 0.0;
    out_limb2[28 * stride] = 0.0;
    out_limb2[29 * stride] = 0.0;
    out_limb2[30 * stride] = 0.0;
    out_limb2[31 * stride] = 0.0;
    out_limb2[32 * stride] = 0.0;
    out_limb2[33 * stride] = n2_x;
    out_limb2[34 * stride] = n2_y;
    out_limb2[35 * stride] = n2_z;
    out_limb3[0] = -0.5;
    out_limb3[stride] = -SQRT3_2;
    out_limb3[2 * stride] = 0.0;
    out_limb3[3 * stride] = screw31_ox;
    out_limb3[4 * stride] = screw31_oy;
    out_limb3[5 * stride] = screw31_oz;
    out_limb3[6 * stride] = 0.0;
    out_limb3[7 * stride] = 0.0;
    out_limb3[8 * stride] = 0.0;
    out_limb3[9 * stride] = w3_x;
    out_limb3[10 * stride] = w3_y;
    out_limb3[11 * stride] = w3_z;
    out_limb3[12 * stride] = w3_x;
    out_limb3[13 * stride] = w3_y;
    out_limb3[14 * stride] = w3_z;
    out_limb3[15 * stride] = screw33_ox;
    out_limb3[16 * stride] = screw33_oy;
    out_limb3[17 * stride] = screw33_oz;
    out_limb3[18 * stride] = nw3_x;
    out_limb3[19 * stride] = nw3_y;
    out_limb3[20 * stride] = nw3_z;
    out_limb3[21 * stride] = screw34_ox;
    out_limb3[22 * stride] = screw34_oy;
    out_limb3[23 * stride] = screw34_oz;
    out_limb3[24 * stride] = n3_x;
    out_limb3[25 * stride] = n3_y;
    out_limb3[26 * stride] = n3_z;
    out_limb3[27 * stride] = 0.0;
    out_limb3[28 * stride] = 0.0;
    out_limb3[29 * stride] = 0.0;
    out_limb3[30 * stride] = 0.0;
    out_limb3[31 * stride] = 0.0;
    out_limb3[32 * stride] = 0.0;
    out_limb3[33 * stride] = n3_x;
    out_limb3[34 * stride] = n3_y;
    out_limb3[35 * stride] = n3_z;
    out_limb4[0] = 0.0;
    out_limb4[stride] = 0.0;
    out_limb4[2 * stride] = 1.0;
    out_limb4[3 * stride] = screw41_ox;
    out_limb4[4 * stride] = c_x;
    out_limb4[5 * stride] = 0.0;
    out_limb4[6 * stride] = axis_x;
    out_limb4[7 * stride] = axis_y;
    out_limb4[8 * stride] = 0.0;
    out_limb4[9 * stride] = screw42_ox;
    out_limb4[10 * stride] = screw42_oy;
    out_limb4[11 * stride] = screw42_oz;
    out_limb4[12 * stride] = 0.0;
    out_limb4[13 * stride] = 0.0;
    out_limb4[14 * stride] = 0.0;
    out_limb4[15 * stride] = lambda_x;
    out_limb4[16 * stride] = lambda_y;
    out_limb4[17 * stride] = lambda_z;
    out_limb4[18 * stride] = lambda_x;
    out_limb4[19 * stride] = lambda_y;
    out_limb4[20 * stride] = lambda_z;
    out_limb4[21 * stride] = 0.0;
    out_limb4[22 * stride] = 0.0;
    out_limb4[23 * stride] = 0.0;
    out_limb4[24 * stride] = n1_x;
    out_limb4[25 * stride] = n1_y;
    out_limb4[26 * stride] = n1_z;
    out_limb4[27 * stride] = 0.0;
    out_limb4[28 * stride] = 0.0;
    out_limb4[29 * stride] = 0.0;
    out_limb4[30 * stride] = screw46_x;
    out_limb4[31 * stride] = screw46_y;
    out_limb4[32 * stride] = screw46_z;
    out_limb4[33 * stride] = 0.0;
    out_limb4[34 * stride] = 0.0;
    out_limb4[35 * stride] = 0.0;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    screws_body(1, &in_a, in_c, in_R, in_heading, out_limb1, out_limb2, out_limb3, out_limb4, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void jacobians_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    double *RESTRICT out_J_v,
    double *RESTRICT out_J_q,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x16 - x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x16 + x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x18;
    const double axis_y = -heading_1*x18;
    /* lower revolute, actuated by q4 Section IV [1, m] */
    const double screw41_ox = -c_y;
    /* second revolute, actuated by q5 Section IV [1, m] */
    const double screw42_ox = axis_y*c_z;
    const double screw42_oy = -axis_x*c_z;
    const double screw42_oz = axis_x*c_y - axis_y*c_x;
    /* universal joint, second axis Section IV [1, m] */
    const double screw46_x = x1;
    const double screw46_y = x3;
    const double screw46_z = x5;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x19 = 1.0/rho1;
    /* unit vector from B_i to D_i (14) [1] */
    const double s1_x = x19*(m1_x*tau1 + nu_x*sigma1);
    const double s1_y = x19*(m1_y*tau1 + nu_y*sigma1);
    const double s1_z = x19*(m1_z*tau1 + nu_z*sigma1);
    const double x20 = e1*x19;
    /* moment of S_i about C (14) [m] */
    const double so1_x = x20*(-m1_x*sigma1 + nu_x*tau1);
    const double so1_y = x20*(-m1_y*sigma1 + nu_y*tau1);
    const double so1_z = x20*(-m1_z*sigma1 + nu_z*tau1);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -l1*x19*fabs(n1_x);
    const double x21 = 0.5*nu_y;
    const double x22 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x21 - x22);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x23 = 1.0/rho2;
    /* unit vector from B_i to D_i (14) [1] */
    const double s2_x = x23*(m2_x*tau2 + nu_x*sigma2);
    const double s2_y = x23*(m2_y*tau2 + nu_y*sigma2);
    const double s2_z = x23*(m2_z*tau2 + nu_z*sigma2);
    const double x24 = e2*x23;
    /* moment of S_i about C (14) [m] */
    const double so2_x = x24*(-m2_x*sigma2 + nu_x*tau2);
    const double so2_y = x24*(-m2_y*sigma2 + nu_y*tau2);
    const double so2_z = x24*(-m2_z*sigma2 + nu_z*tau2);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -l2*x23*fabs(p2);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x21 + x22);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x25 = 1.0/rho3;
    /* unit vector from B_i to D_i (14) [1] */
    const double s3_x = x25*(m3_x*tau3 + nu_x*sigma3);
    const double s3_y = x25*(m3_y*tau3 + nu_y*sigma3);
    const double s3_z = x25*(m3_z*tau3 + nu_z*sigma3);
    const double x26 = e3*x25;
    /* moment of S_i about C (14) [m] */
    const double so3_x = x26*(-m3_x*sigma3 + nu_x*tau3);
    const double so3_y = x26*(-m3_y*sigma3 + nu_y*tau3);
    const double so3_z = x26*(-m3_z*sigma3 + nu_z*tau3);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -l3*x25*fabs(p3);
    /* inverse Jacobian matrix (19), (22)-(24) [1, m] */
    const double J_q_54 = c_x*n1_y + n1_x*screw41_ox;
    const double J_q_55 = n1_x*screw42_ox + n1_y*screw42_oy + n1_z*screw42_oz;
    const double J_q_56 = lambda_x*n1_x + lambda_y*n1_y + lambda_z*n1_z;
    const double J_q_64 = c_x*screw46_y + screw41_ox*screw46_x;
    const double J_q_65 = screw42_ox*screw46_x + screw42_oy*screw46_y + screw42_oz*screw46_z;
    const double J_q_66 = lambda_x*screw46_x + lambda_y*screw46_y + lambda_z*screw46_z;
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    out_J_v[0] = s1_x;
    out_J_v[stride] = s2_x;
    out_J_v[2 * stride] = s3_x;
    out_J_v[3 * stride] = lambda_x;
    out_J_v[4 * stride] = n1_x;
    out_J_v[5 * stride] = screw46_x;
    out_J_v[6 * stride] = s1_y;
    out_J_v[7 * stride] = s2_y;
    out_J_v[8 * stride] = s3_y;
    out_J_v[9 * stride] = lambda_y;
    out_J_v[10 * stride] = n1_y;
    out_J_v[11 * stride] = screw46_y;
    out_J_v[12 * stride] = s1_z;
    out_J_v[13 * stride] = s2_z;
    out_J_v[14 * stride] = s3_z;
    out_J_v[15 * stride] = lambda_z;
    out_J_v[16 * stride] = n1_z;
    out_J_v[17 * stride] = screw46_z;
    out_J_v[18 * stride] = so1_x;
    out_J_v[19 * stride] = so2_x;
    out_J_v[20 * stride] = so3_x;
    out_J_v[21 * stride] = 0.0;
    out_J_v[22 * stride] = 0.0;
    out_J_v[23 * stride] = 0.0;
    out_J_v[24 * stride] = so1_y;
    out_J_v[25 * stride] = so2_y;
    out_J_v[26 * stride] = so3_y;
    out_J_v[27 * stride] = 0.0;
    out_J_v[28 * stride] = 0.0;
    out_J_v[29 * stride] = 0.0;
    out_J_v[30 * stride] = so1_z;
    out_J_v[31 * stride] = so2_z;
    out_J_v[32 * stride] = so3_z;
    out_J_v[33 * stride] = 0.0;
    out_J_v[34 * stride] = 0.0;
    out_J_v[35 * stride] = 0.0;
    out_J_q[0] = limb1;
    out_J_q[stride] = 0.0;
    out_J_q[2 * stride] = 0.0;
    out_J_q[3 * stride] = 0.0;
    out_J_q[4 * stride] = 0.0;
    out_J_q[5 * stride] = 0.0;
    out_J_q[6 * stride] = 0.0;
    out_J_q[7 * stride] = limb2;
    out_J_q[8 * stride] = 0.0;
    out_J_q[9 * stride] = 0.0;
    out_J_q[10 * stride] = 0.0;
    out_J_q[11 * stride] = 0.0;
    out_J_q[12 * stride] = 0.0;
    out_J_q[13 * stride] = 0.0;
    out_J_q[14 * stride] = limb3;
    out_J_q[15 * stride] = 0.0;
    out_J_q[16 * stride] = 0.0;
    out_J_q[17 * stride] = 0.0;
    out_J_q[18 * stride] = 0.0;
    out_J_q[19 * stride] = 0.0;
    out_J_q[20 * stride] = 0.0;
    out_J_q[21 * stride] = 0.0;
    out_J_q[22 * stride] = 0.0;
    out_J_q[23 * stride] = 1.0;
    out_J_q[24 * stride] = 0.0;
    out_J_q[25 * stride] = 0.0;
    out_J_q[26 * stride] = 0.0;
    out_J_q[27 * stride] = J_q_54;
    out_J_q[28 * stride] = J_q_55;
    out_J_q[29 * stride] = J_q_56;
    out_J_q[30 * stride] = 0.0;
    out_J_q[31 * stride] = 0.0;
    out_J_q[32 * stride] = 0.0;
    out_J_q[33 * stride] = J_q_64;
    out_J_q[34 * stride] = J_q_65;
    out_J_q[35 * stride] = J_q_66;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    jacobians_body(1, &in_a, in_c, in_R, in_heading, out_J_v, out_J_q, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void joints_and_jacobians_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    double *RESTRICT out_joints,
    double *RESTRICT out_J_v,
    double *RESTRICT out_J_q)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    /* elevation of the central limb (11) [rad] */
    const double q5 = angle_of(c_z, r);
    /* azimuth of the central limb, measured from the X axis (11) [rad] */
    const double q4 = angle_of(c_y, c_x);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = fabs(n1_x);
    /* length of the outer limb (10) [m] */
    const double q1 = l1/x14;
    const double x15 = SQRT3_2*c_y;
    const double x16 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x15 + x16;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x17 = 0.5*c_y;
    const double x18 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x17 - x18);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    const double x19 = fabs(p2);
    /* length of the outer limb (10) [m] */
    const double q2 = l2/x19;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x15 + x16;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x17 + x18);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x20 = fabs(p3);
    /* length of the outer limb (10) [m] */
    const double q3 = l3/x20;
    const double x21 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x21;
    const double axis_y = -heading_1*x21;
    /* lower revolute, actuated by q4 Section IV [1, m] */
    const double screw41_ox = -c_y;
    /* second revolute, actuated by q5 Section IV [1, m] */
    const double screw42_ox = axis_y*c_z;
    const double screw42_oy = -axis_x*c_z;
    const double screw42_oz = axis_x*c_y - axis_y*c_x;
    /* universal joint, second axis Section IV [1, m] */
    const double screw46_x = x1;
    const double screw46_y = x3;
    const double screw46_z = x5;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x22 = 1.0/rho1;
    /* unit vector from B_i to D_i (14) [1] */
    const double s1_x = x22*(m1_x*tau1 + nu_x*sigma1);
    const double s1_y = x22*(m1_y*tau1 + nu_y*sigma1);
    const double s1_z = x22*(m1_z*tau1 + nu_z*sigma1);
    const double x23 = e1*x22;
    /* moment of S_i about C (14) [m] */
    const double so1_x = x23*(-m1_x*sigma1 + nu_x*tau1);
    const double so1_y = x23*(-m1_y*sigma1 + nu_y*tau1);
    const double so1_z = x23*(-m1_z*sigma1 + nu_z*tau1);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -l1*x14*x22;
    const double x24 = 0.5*nu_y;
    const double x25 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x24 - x25);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x26 = 1.0/rho2;
    /* unit vector from B_i to D_i (14) [1] */
    const double s2_x = x26*(m2_x*tau2 + nu_x*sigma2);
    const double s2_y = x26*(m2_y*tau2 + nu_y*sigma2);
    const double s2_z = x26*(m2_z*tau2 + nu_z*sigma2);
    const double x27 = e2*x26;
    /* moment of S_i about C (14) [m] */
    const double so2_x = x27*(-m2_x*sigma2 + nu_x*tau2);
    const double so2_y = x27*(-m2_y*sigma2 + nu_y*tau2);
    const double so2_z = x27*(-m2_z*sigma2 + nu_z*tau2);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -l2*x19*x26;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x24 + x25);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x28 = 1.0/rho3;
    /* unit vector from B_i to D_i (14) [1] */
    const double s3_x = x28*(m3_x*tau3 + nu_x*sigma3);
    const double s3_y = x28*(m3_y*tau3 + nu_y*sigma3);
    const double s3_z = x28*(m3_z*tau3 + nu_z*sigma3);
    const double x29 = e3*x28;
    /* moment of S_i about C (14) [m] */
    const double so3_x = x29*(-m3_x*sigma3 + nu_x*tau3);
    const double so3_y = x29*(-m3_y*sigma3 + nu_y*tau3);
    const double so3_z = x29*(-m3_z*sigma3 + nu_z*tau3);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -l3*x20*x28;
    /* inverse Jacobian matrix (19), (22)-(24) [1, m] */
    const double J_q_54 = c_x*n1_y + n1_x*screw41_ox;
    const double J_q_55 = n1_x*screw42_ox + n1_y*screw42_oy + n1_z*screw42_oz;
    const double J_q_56 = lambda_x*n1_x + lambda_y*n1_y + lambda_z*n1_z;
    const double J_q_64 = c_x*screw46_y + screw41_ox*screw46_x;
    const double J_q_65 = screw42_ox*screw46_x + screw42_oy*screw46_y + screw42_oz*screw46_z;
    const double J_q_66 = lambda_x*screw46_x + lambda_y*screw46_y + lambda_z*screw46_z;
    out_joints[0] = q1;
    out_joints[stride] = q2;
    out_joints[2 * stride] = q3;
    out_joints[3 * stride] = q4;
    out_joints[4 * stride] = q5;
    out_joints[5 * stride] = q6;
    out_J_v[0] = s1_x;
    out_J_v[stride] = s2_x;
    out_J_v[2 * stride] = s3_x;
    out_J_v[3 * stride] = lambda_x;
    out_J_v[4 * stride] = n1_x;
    out_J_v[5 * stride] = screw46_x;
    out_J_v[6 * stride] = s1_y;
    out_J_v[7 * stride] = s2_y;
    out_J_v[8 * stride] = s3_y;
    out_J_v[9 * stride] = lambda_y;
    out_J_v[10 * stride] = n1_y;
    out_J_v[11 * stride] = screw46_y;
    out_J_v[12 * stride] = s1_z;
    out_J_v[13 * stride] = s2_z;
    out_J_v[14 * stride] = s3_z;
    out_J_v[15 * stride] = lambda_z;
    out_J_v[16 * stride] = n1_z;
    out_J_v[17 * stride] = screw46_z;
    out_J_v[18 * stride] = so1_x;
    out_J_v[19 * stride] = so2_x;
    out_J_v[20 * stride] = so3_x;
    out_J_v[21 * stride] = 0.0;
    out_J_v[22 * stride] = 0.0;
    out_J_v[23 * stride] = 0.0;
    out_J_v[24 * stride] = so1_y;
    out_J_v[25 * stride] = so2_y;
    out_J_v[26 * stride] = so3_y;
    out_J_v[27 * stride] = 0.0;
    out_J_v[28 * stride] = 0.0;
    out_J_v[29 * stride] = 0.0;
    out_J_v[30 * stride] = so1_z;
    out_J_v[31 * stride] = so2_z;
    out_J_v[32 * stride] = so3_z;
    out_J_v[33 * stride] = 0.0;
    out_J_v[34 * stride] = 0.0;
    out_J_v[35 * stride] = 0.0;
    out_J_q[0] = limb1;
    out_J_q[stride] = 0.0;
    out_J_q[2 * stride] = 0.0;
    out_J_q[3 * stride] = 0.0;
    out_J_q[4 * stride] = 0.0;
    out_J_q[5 * stride] = 0.0;
    out_J_q[6 * stride] = 0.0;
    out_J_q[7 * stride] = limb2;
    out_J_q[8 * stride] = 0.0;
    out_J_q[9 * stride] = 0.0;
    out_J_q[10 * stride] = 0.0;
    out_J_q[11 * stride] = 0.0;
    out_J_q[12 * stride] = 0.0;
    out_J_q[13 * stride] = 0.0;
    out_J_q[14 * stride] = limb3;
    out_J_q[15 * stride] = 0.0;
    out_J_q[16 * stride] = 0.0;
    out_J_q[17 * stride] = 0.0;
    out_J_q[18 * stride] = 0.0;
    out_J_q[19 * stride] = 0.0;
    out_J_q[20 * stride] = 0.0;
    out_J_q[21 * stride] = 0.0;
    out_J_q[22 * stride] = 0.0;
    out_J_q[23 * stride] = 1.0;
    out_J_q[24 * stride] = 0.0;
    out_J_q[25 * stride] = 0.0;
    out_J_q[26 * stride] = 0.0;
    out_J_q[27 * stride] = J_q_54;
    out_J_q[28 * stride] = J_q_55;
    out_J_q[29 * stride] = J_q_56;
    out_J_q[30 * stride] = 0.0;
    out_J_q[31 * stride] = 0.0;
    out_J_q[32 * stride] = 0.0;
    out_J_q[33 * stride] = J_q_64;
    out_J_q[34 * stride] = J_q_65;
    out_J_q[35 * stride] = J_q_66;
}

KLEINFORM_API void kleinform_joints_and_jacobians(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    const double in_heading[2],
    double out_joints[6],
    double out_J_v[36],
    double out_J_q[36])
{
    joints_and_jacobians_body(1, &in_a, in_c, in_R, in_heading, out_joints, out_J_v, out_J_q);
}

KLEINFORM_BODY void inverse_velocity_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_twist,
    double *RESTRICT out_rates,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double omega_x = in_twist[0];
    const double omega_y = in_twist[stride];
    const double omega_z = in_twist[2 * stride];
    const double v_x = in_twist[3 * stride];
    const double v_y = in_twist[4 * stride];
    const double v_z = in_twist[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x16 - x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x16 + x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    const double x18 = 0.5*nu_y;
    const double x19 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x18 - x19);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x18 + x19);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    /* rate of the outer limb 1 (15) [m/s] */
    const double dq1 = (-h1*(omega_x*(-m1_x*sigma1 + nu_x*tau1) + omega_y*(-m1_y*sigma1 + nu_y*tau1) + omega_z*(-m1_z*sigma1 + nu_z*tau1)) - n1_x*(v_x*(m1_x*tau1 + nu_x*sigma1) + v_y*(m1_y*tau1 + nu_y*sigma1) + v_z*(m1_z*tau1 + nu_z*sigma1)))/(l1*n1_x*fabs(n1_x));
    /* rate of the outer limb 2 (15) [m/s] */
    const double dq2 = (-h2*(omega_x*(-m2_x*sigma2 + nu_x*tau2) + omega_y*(-m2_y*sigma2 + nu_y*tau2) + omega_z*(-m2_z*sigma2 + nu_z*tau2)) - p2*(v_x*(m2_x*tau2 + nu_x*sigma2) + v_y*(m2_y*tau2 + nu_y*sigma2) + v_z*(m2_z*tau2 + nu_z*sigma2)))/(l2*p2*fabs(p2));
    /* rate of the outer limb 3 (15) [m/s] */
    const double dq3 = (-h3*(omega_x*(-m3_x*sigma3 + nu_x*tau3) + omega_y*(-m3_y*sigma3 + nu_y*tau3) + omega_z*(-m3_z*sigma3 + nu_z*tau3)) - p3*(v_x*(m3_x*tau3 + nu_x*sigma3) + v_y*(m3_y*tau3 + nu_y*sigma3) + v_z*(m3_z*tau3 + nu_z*sigma3)))/(l3*p3*fabs(p3));
    /* rate of the azimuth (16) [rad/s] */
    const double dq4 = (c_x*v_y - c_y*v_x)/((r*r));
    /* rate of the elevation (16) [rad/s] */
    const double dq5 = (-c_z*(c_x*v_x + c_y*v_y)/r + r*v_z)/((q6*q6));
    /* rate of the central limb's length (16) [m/s] */
    const double dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z;
    out_rates[0] = dq1;
    out_rates[stride] = dq2;
    out_rates[2 * stride] = dq3;
    out_rates[3 * stride] = dq4;
    out_rates[4 * stride] = dq5;
    out_rates[5 * stride] = dq6;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    inverse_velocity_body(1, &in_a, in_c, in_R, in_twist, out_rates, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void forward_velocity_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    const double *RESTRICT in_rates,
    double *RESTRICT out_twist,
    double *RESTRICT out_determinant,
    double *RESTRICT out_extension,
    double *RESTRICT out_extension_scale,
    double *RESTRICT out_orientation,
    double *RESTRICT out_orientation_scale,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double dq1 = in_rates[0];
    const double dq2 = in_rates[stride];
    const double dq3 = in_rates[2 * stride];
    const double dq4 = in_rates[3 * stride];
    const double dq5 = in_rates[4 * stride];
    const double dq6 = in_rates[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x16 - x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x16 + x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x18;
    const double axis_y = -heading_1*x18;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x19 = 0.5*nu_y;
    const double x20 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x19 - x20);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x19 + x20);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x21 = sigma2*sigma3;
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = x21;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    const double x22 = sigma1*sigma3;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = x22;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    const double x23 = sigma1*sigma2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = x23;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    const double x24 = SQRT3_2*tilt;
    const double x25 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)));
    /* orientation: the moments of B_iD_i about C are coplanar (27) [m³] */
    const double orientation = x24*x25;
    /* determinant of the moments of S_1, S_2, S_3 (27) [m³] */
    const double det_moments = e1*e2*e3*x24/(rho1*rho2*rho3);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x26 = a + q6;
    const double x27 = fabs(n1_x);
    /* scale of e1 [m] */
    const double e_scale1 = x26/x27;
    const double x28 = fabs(p2);
    /* scale of e2 [m] */
    const double e_scale2 = x26/x28;
    const double x29 = fabs(p3);
    /* scale of e3 [m] */
    const double e_scale3 = x26/x29;
    const double x30 = fabs(sigma1);
    const double x31 = fabs(sigma2);
    const double x32 = fabs(sigma3);
    const double x33 = fabs(tau2);
    const double x34 = fabs(tau3);
    const double x35 = fabs(tau1);
    /* scale of the orientation factor [m³] */
    const double orientation_scale = SQRT3_2*reach*x25*(x30*x31 + x30*x32 + x30*x33 + x30*x34 + x31*x32 + x31*x34 + x31*x35 + x32*x33 + x32*x35);
    const double x36 = c_z*dq5;
    /* velocity of C (12), (16) [m/s] */
    const double v_x = axis_y*x36 - c_y*dq4 + dq6*lambda_x;
    const double v_y = -axis_x*x36 + c_x*dq4 + dq6*lambda_y;
    const double v_z = dq5*(axis_x*c_y - axis_y*c_x) + dq6*lambda_z;
    /* what limb 1 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive1 = n1_x*(-dq1*l1*x27 - v_x*(m1_x*tau1 + nu_x*sigma1) - v_y*(m1_y*tau1 + nu_y*sigma1) - v_z*(m1_z*tau1 + nu_z*sigma1))/h1;
    /* what limb 2 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive2 = p2*(-dq2*l2*x28 - v_x*(m2_x*tau2 + nu_x*sigma2) - v_y*(m2_y*tau2 + nu_y*sigma2) - v_z*(m2_z*tau2 + nu_z*sigma2))/h2;
    /* what limb 3 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive3 = p3*(-dq3*l3*x29 - v_x*(m3_x*tau3 + nu_x*sigma3) - v_y*(m3_y*tau3 + nu_y*sigma3) - v_z*(m3_z*tau3 + nu_z*sigma3))/h3;
    const double x37 = n3_x*sigma3;
    const double x38 = n2_x*sigma2;
    const double x39 = n1_x*sigma1;
    const double x40 = 1.3333333333333333*SQRT3_2/tilt;
    /* angular velocity (17) [rad/s] */
    const double omega_x = x40*(drive1*(tau2*x37 - tau3*x38 + x20*x21) + drive2*(-tau1*x37 + tau3*x39 + x20*x22) + drive3*(tau1*x38 - tau2*x39 + x20*x23));
    const double x41 = n3_y*sigma3;
    const double x42 = n2_y*sigma2;
    const double x43 = SQRT3_2*nu_y;
    const double x44 = n1_y*sigma1;
    const double omega_y = x40*(drive1*(tau2*x41 - tau3*x42 + x21*x43) + drive2*(-tau1*x41 + tau3*x44 + x22*x43) + drive3*(tau1*x42 - tau2*x44 + x23*x43));
    const double x45 = n3_z*sigma3;
    const double x46 = n2_z*sigma2;
    const double x47 = SQRT3_2*nu_z;
    const double x48 = n1_z*sigma1;
    const double omega_z = x40*(drive1*(tau2*x45 - tau3*x46 + x21*x47) + drive2*(-tau1*x45 + tau3*x48 + x22*x47) + drive3*(tau1*x46 - tau2*x48 + x23*x47));
    out_twist[0] = omega_x;
    out_twist[stride] = omega_y;
    out_twist[2 * stride] = omega_z;
    out_twist[3 * stride] = v_x;
    out_twist[4 * stride] = v_y;
    out_twist[5 * stride] = v_z;
    out_determinant[0] = det_moments;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_extension_scale[0] = e_scale1;
    out_extension_scale[stride] = e_scale2;
    out_extension_scale[2 * stride] = e_scale3;
    out_orientation[0] = orientation;
    out_orientation_scale[0] = orientation_scale;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    forward_velocity_body(1, &in_a, in_c, in_R, in_heading, in_rates, out_twist, out_determinant, out_extension, out_extension_scale, out_orientation, out_orientation_scale, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void joint_rates_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    const double *RESTRICT in_twist,
    double *RESTRICT out_rates,
    double *RESTRICT out_wrist,
    double *RESTRICT out_wrist_scale,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double omega_x = in_twist[0];
    const double omega_y = in_twist[stride];
    const double omega_z = in_twist[2 * stride];
    const double v_x = in_twist[3 * stride];
    const double v_y = in_twist[4 * stride];
    const double v_z = in_twist[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    const double x14 = -c_x;
    const double x15 = a + x14;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = x15;
    const double x16 = 1.0/n1_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1*x16;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x17 = 1.0/fabs(n1_x);
    /* length of the outer limb (10) [m] */
    const double q1 = l1*x17;
    const double x18 = 1.0/q1;
    const double x19 = gt1*x18;
    /* unit vector along the outer limb Section IV [1] */
    const double w1_y = x16*x19;
    const double x20 = gz1*x18;
    const double w1_z = x16*x20;
    const double x21 = -0.5*a;
    /* position of A_2 Section II [m] */
    const double a2_x = x21;
    const double x22 = SQRT3_2*a;
    const double a2_y = x22;
    const double x23 = SQRT3_2*c_y;
    const double x24 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x23 + x24;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x25 = 1.0/p2;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2*x25;
    const double x26 = 0.5*n2_y;
    const double x27 = -SQRT3_2*n2_x - x26;
    const double x28 = 0.5*c_y;
    const double x29 = SQRT3_2*c_x;
    const double x30 = -x28 - x29;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*x27 + p2*x30;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    const double x31 = 1.0/fabs(p2);
    /* length of the outer limb (10) [m] */
    const double q2 = l2*x31;
    const double x32 = 1.0/q2;
    const double x33 = gt2*x32;
    const double x34 = x25*x33;
    /* unit vector along the outer limb Section IV [1] */
    const double w2_x = -SQRT3_2*x34;
    const double w2_y = -0.5*x34;
    const double x35 = x25*x32;
    const double w2_z = gz2*x35;
    /* position of A_3 Section II [m] */
    const double a3_x = x21;
    const double a3_y = -x22;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x23 + x24;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x36 = 1.0/p3;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3*x36;
    const double x37 = SQRT3_2*n3_x - 0.5*n3_y;
    const double x38 = -x28 + x29;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*x37 + p3*x38;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x39 = 1.0/fabs(p3);
    /* length of the outer limb (10) [m] */
    const double q3 = l3*x39;
    const double x40 = 1.0/q3;
    const double x41 = gt3*x40;
    const double x42 = x36*x41;
    /* unit vector along the outer limb Section IV [1] */
    const double w3_x = SQRT3_2*x42;
    const double w3_y = -0.5*x42;
    const double x43 = x36*x40;
    const double w3_z = gz3*x43;
    const double x44 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x44;
    const double axis_y = -heading_1*x44;
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw1_x = x18*(-c_y*n1_z + c_z*n1_y);
    const double nw1_y = -x20;
    const double nw1_z = x19;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    const double x45 = c_z*x27;
    const double x46 = n2_z*x30;
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw2_x = x32*(SQRT3_2*gz2 - 0.5*x45 + 0.5*x46);
    const double nw2_y = x32*(SQRT3_2*(x45 - x46) + 0.5*gz2);
    const double nw2_z = x33;
    const double x47 = 0.5*nu_y;
    const double x48 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x47 - x48);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    const double x49 = c_z*x37;
    /* axis of the upper revolute, not a unit vector Section IV [1] */
    const double nw3_x = x40*(-SQRT3_2*gz3 + 0.5*n3_z*x38 - 0.5*x49);
    const double nw3_y = x40*(-SQRT3_2*(-n3_z*x38 + x49) + 0.5*gz3);
    const double nw3_z = x41;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x47 + x48);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* wrist: the central limb in the platform's plane (26), (27) [1] */
    const double wrist = SQRT3_2*x13*(c_x*nu_x + c_y*nu_y + c_z*nu_z);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    /* rate of the outer limb 1 (15) [m/s] */
    const double dq1 = x16*x17*(-h1*(omega_x*(-m1_x*sigma1 + nu_x*tau1) + omega_y*(-m1_y*sigma1 + nu_y*tau1) + omega_z*(-m1_z*sigma1 + nu_z*tau1)) - n1_x*(v_x*(m1_x*tau1 + nu_x*sigma1) + v_y*(m1_y*tau1 + nu_y*sigma1) + v_z*(m1_z*tau1 + nu_z*sigma1)))/l1;
    /* rate of the outer limb 2 (15) [m/s] */
    const double dq2 = x25*x31*(-h2*(omega_x*(-m2_x*sigma2 + nu_x*tau2) + omega_y*(-m2_y*sigma2 + nu_y*tau2) + omega_z*(-m2_z*sigma2 + nu_z*tau2)) - p2*(v_x*(m2_x*tau2 + nu_x*sigma2) + v_y*(m2_y*tau2 + nu_y*sigma2) + v_z*(m2_z*tau2 + nu_z*sigma2)))/l2;
    /* rate of the outer limb 3 (15) [m/s] */
    const double dq3 = x36*x39*(-h3*(omega_x*(-m3_x*sigma3 + nu_x*tau3) + omega_y*(-m3_y*sigma3 + nu_y*tau3) + omega_z*(-m3_z*sigma3 + nu_z*tau3)) - p3*(v_x*(m3_x*tau3 + nu_x*sigma3) + v_y*(m3_y*tau3 + nu_y*sigma3) + v_z*(m3_z*tau3 + nu_z*sigma3)))/l3;
    /* rate of the azimuth (16) [rad/s] */
    const double dq4 = (c_x*v_y - c_y*v_x)/((r*r));
    /* rate of the elevation (16) [rad/s] */
    const double dq5 = (-c_z*(c_x*v_x + c_y*v_y)/r + r*v_z)/((q6*q6));
    /* rate of the central limb's length (16) [m/s] */
    const double dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z;
    const double x50 = nw1_x*v_x + nw1_y*v_y + nw1_z*v_z;
    /* rate of the base revolute (12) [rad/s] */
    const double rate11 = x16*x18*(e1*(omega_x*(n1_y*nw1_z - n1_z*nw1_y) + omega_y*(-n1_x*nw1_z + n1_z*nw1_x) + omega_z*(n1_x*nw1_y - n1_y*nw1_x)) + x50);
    const double x51 = -x15;
    /* rate of the cylindrical joint's rotation (12) [rad/s] */
    const double rate15 = x18*(-omega_x*(-c_y*nw1_z + c_z*nw1_y) - omega_y*(-c_z*nw1_x + nw1_z*x51) - omega_z*(c_y*nw1_x - nw1_y*x51) - x50)/((nw1_x*nw1_x) + (nw1_y*nw1_y) + (nw1_z*nw1_z));
    /* rate of the cylindrical joint's translation (12) [m/s] */
    const double rate16 = x16*(e1*(-n1_y*omega_z + n1_z*omega_y) + v_x);
    const double x52 = -omega_y;
    const double x53 = -n1_y*rate15 - x52;
    const double x54 = -omega_z;
    const double x55 = -n1_z*rate15 - x54;
    /* rate of the revolute along the leg (12) [rad/s] */
    const double rate13 = w1_y*x53 + w1_z*x55;
    /* rate of the upper revolute, whose axis is no unit vector (12) [rad/s] */
    const double rate14 = x16*(w1_y*x55 - w1_z*x53);
    const double x56 = nw2_x*v_x + nw2_y*v_y + nw2_z*v_z;
    /* rate of the base revolute (12) [rad/s] */
    const double rate21 = x35*(e2*(omega_x*(n2_y*nw2_z - n2_z*nw2_y) + omega_y*(-n2_x*nw2_z + n2_z*nw2_x) + omega_z*(n2_x*nw2_y - n2_y*nw2_x)) + x56);
    const double x57 = -c_y;
    const double x58 = -a2_y - x57;
    const double x59 = -a2_x - x14;
    /* rate of the cylindrical joint's rotation (12) [rad/s] */
    const double rate25 = x32*(-omega_x*(c_z*nw2_y - nw2_z*x58) - omega_y*(-c_z*nw2_x + nw2_z*x59) - omega_z*(nw2_x*x58 - nw2_y*x59) - x56)/((nw2_x*nw2_x) + (nw2_y*nw2_y) + (nw2_z*nw2_z));
    const double x60 = 0.5*v_x;
    const double x61 = SQRT3_2*v_y;
    const double x62 = 0.5*omega_y;
    /* rate of the cylindrical joint's translation (12) [m/s] */
    const double rate26 = x25*(e2*(SQRT3_2*(n2_x*omega_z - n2_z*omega_x) - n2_z*x62 + omega_z*x26) - x60 + x61);
    const double x63 = -omega_x;
    const double x64 = -n2_x*rate25 - x63;
    const double x65 = -n2_y*rate25 - x52;
    const double x66 = -n2_z*rate25 - x54;
    /* rate of the revolute along the leg (12) [rad/s] */
    const double rate23 = w2_x*x64 + w2_y*x65 + w2_z*x66;
    /* rate of the upper revolute, whose axis is no unit vector (12) [rad/s] */
    const double rate24 = x25*(SQRT3_2*w2_z*x64 + 0.5*w2_z*x65 + x66*(-SQRT3_2*w2_x - 0.5*w2_y));
    const double x67 = nw3_x*v_x + nw3_y*v_y + nw3_z*v_z;
    /* rate of the base revolute (12) [rad/s] */
    const double rate31 = x43*(e3*(omega_x*(n3_y*nw3_z - n3_z*nw3_y) + omega_y*(-n3_x*nw3_z + n3_z*nw3_x) + omega_z*(n3_x*nw3_y - n3_y*nw3_x)) + x67);
    const double x68 = -a3_y - x57;
    const double x69 = -a3_x - x14;
    /* rate of the cylindrical joint's rotation (12) [rad/s] */
    const double rate35 = x40*(-omega_x*(c_z*nw3_y - nw3_z*x68) - omega_y*(-c_z*nw3_x + nw3_z*x69) - omega_z*(nw3_x*x68 - nw3_y*x69) - x67)/((nw3_x*nw3_x) + (nw3_y*nw3_y) + (nw3_z*nw3_z));
    /* rate of the cylindrical joint's translation (12) [m/s] */
    const double rate36 = x36*(e3*(-SQRT3_2*(n3_x*omega_z - n3_z*omega_x) + 0.5*n3_y*omega_z - n3_z*x62) - x60 - x61);
    const double x70 = -n3_x*rate35 - x63;
    const double x71 = -n3_y*rate35 - x52;
    const double x72 = -n3_z*rate35 - x54;
    /* rate of the revolute along the leg (12) [rad/s] */
    const double rate33 = w3_x*x70 + w3_y*x71 + w3_z*x72;
    /* rate of the upper revolute, whose axis is no unit vector (12) [rad/s] */
    const double rate34 = x36*(-SQRT3_2*w3_z*x70 + 0.5*w3_z*x71 + x72*(SQRT3_2*w3_x - 0.5*w3_y));
    /* angular velocity that the passive joints of the central limb make (12) [rad/s] */
    const double spin_x = -axis_x*dq5 - x63;
    const double spin_y = -axis_y*dq5 - x52;
    const double spin_z = -dq4 - x54;
    /* rate of the revolute along the central limb (12) [rad/s] */
    const double rate44 = SQRT3_2*(nu_x*spin_x + nu_y*spin_y + nu_z*spin_z)/wrist;
    const double x73 = -lambda_x*rate44 + spin_x;
    const double x74 = -lambda_y*rate44 + spin_y;
    const double x75 = -lambda_z*rate44 + spin_z;
    /* rate of the universal joint's first axis (12) [rad/s] */
    const double rate45 = n1_x*x73 + n1_y*x74 + n1_z*x75;
    /* rate of the universal joint's second axis, of norm √3/2 (12) [rad/s] */
    const double rate46 = 1.3333333333333333*SQRT3_2*(m1_x*x73 + m1_y*x74 + m1_z*x75);
    out_rates[0] = rate11;
    out_rates[stride] = dq1;
    out_rates[2 * stride] = rate13;
    out_rates[3 * stride] = rate14;
    out_rates[4 * stride] = rate15;
    out_rates[5 * stride] = rate16;
    out_rates[6 * stride] = rate21;
    out_rates[7 * stride] = dq2;
    out_rates[8 * stride] = rate23;
    out_rates[9 * stride] = rate24;
    out_rates[10 * stride] = rate25;
    out_rates[11 * stride] = rate26;
    out_rates[12 * stride] = rate31;
    out_rates[13 * stride] = dq3;
    out_rates[14 * stride] = rate33;
    out_rates[15 * stride] = rate34;
    out_rates[16 * stride] = rate35;
    out_rates[17 * stride] = rate36;
    out_rates[18 * stride] = dq4;
    out_rates[19 * stride] = dq5;
    out_rates[20 * stride] = dq6;
    out_rates[21 * stride] = rate44;
    out_rates[22 * stride] = rate45;
    out_rates[23 * stride] = rate46;
    out_wrist[0] = wrist;
    out_wrist_scale[0] = SQRT3_2;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    joint_rates_body(1, &in_a, in_c, in_R, in_heading, in_twist, out_rates, out_wrist, out_wrist_scale, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void platform_wrench_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_forces,
    double *RESTRICT out_wrench,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double force1 = in_forces[0];
    const double force2 = in_forces[stride];
    const double force3 = in_forces[2 * stride];
    const double force4 = in_forces[3 * stride];
    const double force5 = in_forces[4 * stride];
    const double force6 = in_forces[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x16 - x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x16 + x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x18 = 1.0/rho1;
    /* unit vector from B_i to D_i (14) [1] */
    const double s1_x = x18*(m1_x*tau1 + nu_x*sigma1);
    const double s1_y = x18*(m1_y*tau1 + nu_y*sigma1);
    const double s1_z = x18*(m1_z*tau1 + nu_z*sigma1);
    const double x19 = e1*x18;
    /* moment of S_i about C (14) [m] */
    const double so1_x = x19*(-m1_x*sigma1 + nu_x*tau1);
    const double so1_y = x19*(-m1_y*sigma1 + nu_y*tau1);
    const double so1_z = x19*(-m1_z*sigma1 + nu_z*tau1);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -l1*x18*fabs(n1_x);
    const double x20 = 0.5*nu_y;
    const double x21 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x20 - x21);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x22 = 1.0/rho2;
    /* unit vector from B_i to D_i (14) [1] */
    const double s2_x = x22*(m2_x*tau2 + nu_x*sigma2);
    const double s2_y = x22*(m2_y*tau2 + nu_y*sigma2);
    const double s2_z = x22*(m2_z*tau2 + nu_z*sigma2);
    const double x23 = e2*x22;
    /* moment of S_i about C (14) [m] */
    const double so2_x = x23*(-m2_x*sigma2 + nu_x*tau2);
    const double so2_y = x23*(-m2_y*sigma2 + nu_y*tau2);
    const double so2_z = x23*(-m2_z*sigma2 + nu_z*tau2);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -l2*x22*fabs(p2);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x20 + x21);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x24 = 1.0/rho3;
    /* unit vector from B_i to D_i (14) [1] */
    const double s3_x = x24*(m3_x*tau3 + nu_x*sigma3);
    const double s3_y = x24*(m3_y*tau3 + nu_y*sigma3);
    const double s3_z = x24*(m3_z*tau3 + nu_z*sigma3);
    const double x25 = e3*x24;
    /* moment of S_i about C (14) [m] */
    const double so3_x = x25*(-m3_x*sigma3 + nu_x*tau3);
    const double so3_y = x25*(-m3_y*sigma3 + nu_y*tau3);
    const double so3_z = x25*(-m3_z*sigma3 + nu_z*tau3);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -l3*x24*fabs(p3);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x26 = 1.0/((r*r));
    /* force through C that a torque of 1 about the azimuth makes (16) [1/m] */
    const double grad_q4_x = -c_y*x26;
    const double grad_q4_y = c_x*x26;
    const double x27 = 1.0/((q6*q6));
    const double x28 = c_z*x27/r;
    /* force through C that a torque of 1 about the elevation makes (16) [1/m] */
    const double grad_q5_x = -c_x*x28;
    const double grad_q5_y = -c_y*x28;
    const double grad_q5_z = r*x27;
    const double x29 = force1/limb1;
    const double x30 = force2/limb2;
    const double x31 = force3/limb3;
    /* force that the platform exerts (15), (16) [N] */
    const double force_x = force4*grad_q4_x + force5*grad_q5_x + force6*lambda_x + s1_x*x29 + s2_x*x30 + s3_x*x31;
    const double force_y = force4*grad_q4_y + force5*grad_q5_y + force6*lambda_y + s1_y*x29 + s2_y*x30 + s3_y*x31;
    const double force_z = force5*grad_q5_z + force6*lambda_z + s1_z*x29 + s2_z*x30 + s3_z*x31;
    /* moment at C that the platform exerts (15) [N m] */
    const double moment_x = so1_x*x29 + so2_x*x30 + so3_x*x31;
    const double moment_y = so1_y*x29 + so2_y*x30 + so3_y*x31;
    const double moment_z = so1_z*x29 + so2_z*x30 + so3_z*x31;
    out_wrench[0] = force_x;
    out_wrench[stride] = force_y;
    out_wrench[2 * stride] = force_z;
    out_wrench[3 * stride] = moment_x;
    out_wrench[4 * stride] = moment_y;
    out_wrench[5 * stride] = moment_z;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    platform_wrench_body(1, &in_a, in_c, in_R, in_forces, out_wrench, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void actuator_forces_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    const double *RESTRICT in_wrench,
    double *RESTRICT out_forces,
    double *RESTRICT out_extension,
    double *RESTRICT out_extension_scale,
    double *RESTRICT out_orientation,
    double *RESTRICT out_orientation_scale,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double force_x = in_wrench[0];
    const double force_y = in_wrench[stride];
    const double force_z = in_wrench[2 * stride];
    const double moment_x = in_wrench[3 * stride];
    const double moment_y = in_wrench[4 * stride];
    const double moment_z = in_wrench[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x14 = SQRT3_2*c_y;
    const double x15 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x16 - x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x14 + x15;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x16 + x17);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x18;
    const double axis_y = -heading_1*x18;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x19 = 1.0/rho1;
    const double x20 = nu_x*sigma1;
    /* unit vector from B_i to D_i (14) [1] */
    const double s1_x = x19*(m1_x*tau1 + x20);
    const double x21 = nu_y*sigma1;
    const double s1_y = x19*(m1_y*tau1 + x21);
    const double x22 = nu_z*sigma1;
    const double s1_z = x19*(m1_z*tau1 + x22);
    const double x23 = fabs(n1_x);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -l1*x19*x23;
    const double x24 = 0.5*nu_y;
    const double x25 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x24 - x25);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x26 = 1.0/rho2;
    /* unit vector from B_i to D_i (14) [1] */
    const double s2_x = x26*(m2_x*tau2 + nu_x*sigma2);
    const double x27 = nu_y*sigma2;
    const double s2_y = x26*(m2_y*tau2 + x27);
    const double x28 = nu_z*sigma2;
    const double s2_z = x26*(m2_z*tau2 + x28);
    const double x29 = fabs(p2);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -l2*x26*x29;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x24 + x25);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x30 = 1.0/rho3;
    /* unit vector from B_i to D_i (14) [1] */
    const double s3_x = x30*(m3_x*tau3 + nu_x*sigma3);
    const double s3_y = x30*(m3_y*tau3 + nu_y*sigma3);
    const double s3_z = x30*(m3_z*tau3 + nu_z*sigma3);
    const double x31 = fabs(p3);
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -l3*x30*x31;
    const double x32 = sigma2*sigma3;
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = x32;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = sigma1*sigma3;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = sigma1*sigma2;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    const double x33 = SQRT3_2/(((n1_x*n1_x))*((p2*p2))*((p3*p3)));
    /* orientation: the moments of B_iD_i about C are coplanar (27) [m³] */
    const double orientation = tilt*x33;
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x34 = a + q6;
    /* scale of e1 [m] */
    const double e_scale1 = x34/x23;
    /* scale of e2 [m] */
    const double e_scale2 = x34/x29;
    /* scale of e3 [m] */
    const double e_scale3 = x34/x31;
    const double x35 = fabs(sigma1);
    const double x36 = fabs(sigma2);
    const double x37 = fabs(sigma3);
    const double x38 = fabs(tau2);
    const double x39 = fabs(tau3);
    const double x40 = fabs(tau1);
    /* scale of the orientation factor [m³] */
    const double orientation_scale = reach*x33*(x35*x36 + x35*x37 + x35*x38 + x35*x39 + x36*x37 + x36*x39 + x36*x40 + x37*x38 + x37*x40);
    const double x41 = sigma3*tau2;
    const double x42 = sigma2*tau3;
    const double x43 = SQRT3_2*sigma3;
    const double x44 = 1.3333333333333333*SQRT3_2/tilt;
    /* power of the moment at the omega that a drive of 1 of limb 1 alone makes (17) [N] */
    const double share1 = x44*(moment_x*(-n2_x*x42 + n3_x*x41 + x25*x32) + moment_y*(-n2_y*x42 + n3_y*x41 + x27*x43) + moment_z*(-n2_z*x42 + n3_z*x41 + x28*x43));
    /* force along S_1 (17) [N] */
    const double load1 = rho1*share1/e1;
    /* force of the actuator of limb 1 (15) [N] */
    const double force1 = limb1*load1;
    const double x45 = sigma1*tau3;
    const double x46 = sigma3*tau1;
    /* power of the moment at the omega that a drive of 1 of limb 2 alone makes (17) [N] */
    const double share2 = x44*(moment_x*(n1_x*x45 - n3_x*x46 + x20*x43) + moment_y*(n1_y*x45 - n3_y*x46 + x21*x43) + moment_z*(n1_z*x45 - n3_z*x46 + x22*x43));
    /* force along S_2 (17) [N] */
    const double load2 = rho2*share2/e2;
    /* force of the actuator of limb 2 (15) [N] */
    const double force2 = limb2*load2;
    const double x47 = sigma2*tau1;
    const double x48 = sigma1*tau2;
    const double x49 = SQRT3_2*sigma2;
    /* power of the moment at the omega that a drive of 1 of limb 3 alone makes (17) [N] */
    const double share3 = x44*(moment_x*(-n1_x*x48 + n2_x*x47 + x20*x49) + moment_y*(-n1_y*x48 + n2_y*x47 + x21*x49) + moment_z*(-n1_z*x48 + n2_z*x47 + x22*x49));
    /* force along S_3 (17) [N] */
    const double load3 = rho3*share3/e3;
    /* force of the actuator of limb 3 (15) [N] */
    const double force3 = limb3*load3;
    /* force through C that the central limb carries (16) [N] */
    const double central_force_x = force_x - load1*s1_x - load2*s2_x - load3*s3_x;
    const double central_force_y = force_y - load1*s1_y - load2*s2_y - load3*s3_y;
    const double central_force_z = force_z - load1*s1_z - load2*s2_z - load3*s3_z;
    /* torque of the actuator of the azimuth (16) [N m] */
    const double force4 = c_x*central_force_y - c_y*central_force_x;
    /* torque of the actuator of the elevation (16) [N m] */
    const double force5 = -axis_x*c_z*central_force_y + axis_y*c_z*central_force_x + central_force_z*(axis_x*c_y - axis_y*c_x);
    /* force of the actuator of the central limb's length (16) [N] */
    const double force6 = central_force_x*lambda_x + central_force_y*lambda_y + central_force_z*lambda_z;
    out_forces[0] = force1;
    out_forces[stride] = force2;
    out_forces[2 * stride] = force3;
    out_forces[3 * stride] = force4;
    out_forces[4 * stride] = force5;
    out_forces[5 * stride] = force6;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_extension_scale[0] = e_scale1;
    out_extension_scale[stride] = e_scale2;
    out_extension_scale[2 * stride] = e_scale3;
    out_orientation[0] = orientation;
    out_orientation_scale[0] = orientation_scale;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    actuator_forces_body(1, &in_a, in_c, in_R, in_heading, in_wrench, out_forces, out_extension, out_extension_scale, out_orientation, out_orientation_scale, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void inverse_acceleration_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_twist,
    const double *RESTRICT in_twist_rate,
    double *RESTRICT out_rates,
    double *RESTRICT out_accelerations,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double omega_x = in_twist[0];
    const double omega_y = in_twist[stride];
    const double omega_z = in_twist[2 * stride];
    const double v_x = in_twist[3 * stride];
    const double v_y = in_twist[4 * stride];
    const double v_z = in_twist[5 * stride];
    const double domega_x = in_twist_rate[0];
    const double domega_y = in_twist_rate[stride];
    const double domega_z = in_twist_rate[2 * stride];
    const double dv_x = in_twist_rate[3 * stride];
    const double dv_y = in_twist_rate[4 * stride];
    const double dv_z = in_twist_rate[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double x14 = c_z*x13;
    const double lambda_z = x14;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    const double x15 = 1.0/n1_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1*x15;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x16 = 1.0/fabs(n1_x);
    /* length of the outer limb (10) [m] */
    const double q1 = l1*x16;
    const double x17 = SQRT3_2*c_y;
    const double x18 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x17 + x18;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x19 = 1.0/p2;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2*x19;
    const double x20 = 0.5*n2_y;
    const double x21 = 0.5*c_y;
    const double x22 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - x20) + p2*(-x21 - x22);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    const double x23 = 1.0/fabs(p2);
    /* length of the outer limb (10) [m] */
    const double q2 = l2*x23;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x17 + x18;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x24 = 1.0/p3;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3*x24;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x21 + x22);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x25 = 1.0/fabs(p3);
    /* length of the outer limb (10) [m] */
    const double q3 = l3*x25;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    const double x26 = 0.5*nu_y;
    const double x27 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x26 - x27);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x26 + x27);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x28 = m1_x*tau1 + nu_x*sigma1;
    const double x29 = m1_y*tau1 + nu_y*sigma1;
    const double x30 = m1_z*tau1 + nu_z*sigma1;
    const double x31 = -m1_x*sigma1 + nu_x*tau1;
    const double x32 = -m1_y*sigma1 + nu_y*tau1;
    const double x33 = -m1_z*sigma1 + nu_z*tau1;
    const double x34 = x15*x16/l1;
    /* rate of the outer limb 1 (15) [m/s] */
    const double dq1 = x34*(-h1*(omega_x*x31 + omega_y*x32 + omega_z*x33) - n1_x*(v_x*x28 + v_y*x29 + v_z*x30));
    const double x35 = m2_x*tau2 + nu_x*sigma2;
    const double x36 = m2_y*tau2 + nu_y*sigma2;
    const double x37 = m2_z*tau2 + nu_z*sigma2;
    const double x38 = -m2_x*sigma2 + nu_x*tau2;
    const double x39 = -m2_y*sigma2 + nu_y*tau2;
    const double x40 = -m2_z*sigma2 + nu_z*tau2;
    const double x41 = x19*x23/l2;
    /* rate of the outer limb 2 (15) [m/s] */
    const double dq2 = x41*(-h2*(omega_x*x38 + omega_y*x39 + omega_z*x40) - p2*(v_x*x35 + v_y*x36 + v_z*x37));
    const double x42 = m3_x*tau3 + nu_x*sigma3;
    const double x43 = m3_y*tau3 + nu_y*sigma3;
    const double x44 = m3_z*tau3 + nu_z*sigma3;
    const double x45 = -m3_x*sigma3 + nu_x*tau3;
    const double x46 = -m3_y*sigma3 + nu_y*tau3;
    const double x47 = -m3_z*sigma3 + nu_z*tau3;
    const double x48 = x24*x25/l3;
    /* rate of the outer limb 3 (15) [m/s] */
    const double dq3 = x48*(-h3*(omega_x*x45 + omega_y*x46 + omega_z*x47) - p3*(v_x*x42 + v_y*x43 + v_z*x44));
    const double x49 = 1.0/((r*r));
    /* rate of the azimuth (16) [rad/s] */
    const double dq4 = x49*(c_x*v_y - c_y*v_x);
    const double x50 = c_x*v_x;
    const double x51 = c_y*v_y;
    const double x52 = 1.0/r;
    const double x53 = c_z*x52;
    /* rate of the elevation (16) [rad/s] */
    const double dq5 = (r*v_z - x53*(x50 + x51))/((q6*q6));
    /* rate of the central limb's length (16) [m/s] */
    const double dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z;
    const double x54 = -n1_y*omega_z + n1_z*omega_y;
    const double x55 = e1*x54 + v_x;
    /* rate of e_i (4) [m/s] */
    const double de1 = -x15*x55;
    /* velocity of B_i (3) [m/s] */
    const double db1_x = de1*n1_x + x55;
    const double x56 = n1_x*omega_z - n1_z*omega_x;
    const double db1_y = de1*n1_y + e1*x56 + v_y;
    const double x57 = -n1_x*omega_y + n1_y*omega_x;
    const double db1_z = de1*n1_z + e1*x57 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias1 = ((db1_x*db1_x) + (db1_y*db1_y) + (db1_z*db1_z) - (dq1*dq1) - (2.0*de1*(x28*x54 + x29*x56 + x30*x57) + e1*(n1_x*omega_x + n1_y*omega_y + n1_z*omega_z)*(omega_x*x28 + omega_y*x29 + omega_z*x30))/((n1_x*n1_x)))/q1;
    /* acceleration of the outer limb 1 (15) [m/s²] */
    const double ddq1 = bias1 - x34*(h1*(domega_x*x31 + domega_y*x32 + domega_z*x33) + n1_x*(dv_x*x28 + dv_y*x29 + dv_z*x30));
    const double x58 = SQRT3_2*v_y;
    const double x59 = n2_x*omega_z - n2_z*omega_x;
    /* rate of e_i (4) [m/s] */
    const double de2 = x19*(-e2*(SQRT3_2*x59 - 0.5*n2_z*omega_y + omega_z*x20) + 0.5*v_x - x58);
    const double x60 = -n2_y*omega_z + n2_z*omega_y;
    /* velocity of B_i (3) [m/s] */
    const double db2_x = de2*n2_x + e2*x60 + v_x;
    const double db2_y = de2*n2_y + e2*x59 + v_y;
    const double x61 = -n2_x*omega_y + n2_y*omega_x;
    const double db2_z = de2*n2_z + e2*x61 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias2 = ((db2_x*db2_x) + (db2_y*db2_y) + (db2_z*db2_z) - (dq2*dq2) - (2.0*de2*(x35*x60 + x36*x59 + x37*x61) + e2*(n2_x*omega_x + n2_y*omega_y + n2_z*omega_z)*(omega_x*x35 + omega_y*x36 + omega_z*x37))/((p2*p2)))/q2;
    /* acceleration of the outer limb 2 (15) [m/s²] */
    const double ddq2 = bias2 - x41*(h2*(domega_x*x38 + domega_y*x39 + domega_z*x40) + p2*(dv_x*x35 + dv_y*x36 + dv_z*x37));
    const double x62 = n3_x*omega_z - n3_z*omega_x;
    /* rate of e_i (4) [m/s] */
    const double de3 = x24*(-e3*(-SQRT3_2*x62 + 0.5*n3_y*omega_z - 0.5*n3_z*omega_y) + 0.5*v_x + x58);
    const double x63 = -n3_y*omega_z + n3_z*omega_y;
    /* velocity of B_i (3) [m/s] */
    const double db3_x = de3*n3_x + e3*x63 + v_x;
    const double db3_y = de3*n3_y + e3*x62 + v_y;
    const double x64 = -n3_x*omega_y + n3_y*omega_x;
    const double db3_z = de3*n3_z + e3*x64 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias3 = ((db3_x*db3_x) + (db3_y*db3_y) + (db3_z*db3_z) - (dq3*dq3) - (2.0*de3*(x42*x63 + x43*x62 + x44*x64) + e3*(n3_x*omega_x + n3_y*omega_y + n3_z*omega_z)*(omega_x*x42 + omega_y*x43 + omega_z*x44))/((p3*p3)))/q3;
    /* acceleration of the outer limb 3 (15) [m/s²] */
    const double ddq3 = bias3 - x48*(h3*(domega_x*x45 + domega_y*x46 + domega_z*x47) + p3*(dv_x*x42 + dv_y*x43 + dv_z*x44));
    /* acceleration of the azimuth (16) [rad/s²] */
    const double ddq4 = x49*(c_x*dv_y - c_y*dv_x - dq4*(2.0*x50 + 2.0*x51));
    /* acceleration of the central limb's length (16) [m/s²] */
    const double ddq6 = x13*(c_x*dv_x + c_y*dv_y + c_z*dv_z - (dq6*dq6) + (v_x*v_x) + (v_y*v_y) + (v_z*v_z));
    /* acceleration of the elevation (16) [rad/s²] */
    const double ddq5 = x53*(dq5*dq5) + x52*(-ddq6*x14 - 2.0*dq5*dq6*r*x13 + dv_z);
    out_rates[0] = dq1;
    out_rates[stride] = dq2;
    out_rates[2 * stride] = dq3;
    out_rates[3 * stride] = dq4;
    out_rates[4 * stride] = dq5;
    out_rates[5 * stride] = dq6;
    out_accelerations[0] = ddq1;
    out_accelerations[stride] = ddq2;
    out_accelerations[2 * stride] = ddq3;
    out_accelerations[3 * stride] = ddq4;
    out_accelerations[4 * stride] = ddq5;
    out_accelerations[5 * stride] = ddq6;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    inverse_acceleration_body(1, &in_a, in_c, in_R, in_twist, in_twist_rate, out_rates, out_accelerations, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void forward_acceleration_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    const double *RESTRICT in_heading,
    const double *RESTRICT in_rates,
    const double *RESTRICT in_accelerations,
    double *RESTRICT out_twist,
    double *RESTRICT out_twist_rate,
    double *RESTRICT out_extension,
    double *RESTRICT out_extension_scale,
    double *RESTRICT out_orientation,
    double *RESTRICT out_orientation_scale,
    double *RESTRICT out_incidence,
    double *RESTRICT out_scaled_legs,
    double *RESTRICT out_radial,
    double *RESTRICT out_central_length,
    double *RESTRICT out_reach)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double heading_1 = in_heading[0];
    const double heading_2 = in_heading[stride];
    const double dq1 = in_rates[0];
    const double dq2 = in_rates[stride];
    const double dq3 = in_rates[2 * stride];
    const double dq4 = in_rates[3 * stride];
    const double dq5 = in_rates[4 * stride];
    const double dq6 = in_rates[5 * stride];
    const double ddq1 = in_accelerations[0];
    const double ddq2 = in_accelerations[stride];
    const double ddq3 = in_accelerations[2 * stride];
    const double ddq4 = in_accelerations[3 * stride];
    const double ddq5 = in_accelerations[4 * stride];
    const double ddq6 = in_accelerations[5 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    const double x13 = 1.0/q6;
    /* unit vector along the central limb, from O to C (1) [1] */
    const double lambda_x = c_x*x13;
    const double lambda_y = c_y*x13;
    const double lambda_z = c_z*x13;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    const double x14 = 1.0/n1_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1*x14;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x15 = fabs(n1_x);
    const double x16 = 1.0/x15;
    /* length of the outer limb (10) [m] */
    const double q1 = l1*x16;
    const double x17 = SQRT3_2*c_y;
    const double x18 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x17 + x18;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x19 = 1.0/p2;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2*x19;
    const double x20 = 0.5*n2_y;
    const double x21 = 0.5*c_y;
    const double x22 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - x20) + p2*(-x21 - x22);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    const double x23 = fabs(p2);
    const double x24 = 1.0/x23;
    /* length of the outer limb (10) [m] */
    const double q2 = l2*x24;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x17 + x18;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x25 = 1.0/p3;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3*x25;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x21 + x22);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x26 = fabs(p3);
    const double x27 = 1.0/x26;
    /* length of the outer limb (10) [m] */
    const double q3 = l3*x27;
    const double x28 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)));
    /* axis of the second revolute of the central limb Section IV [1] */
    const double axis_x = heading_2*x28;
    const double axis_y = -heading_1*x28;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    const double x29 = 0.5*nu_y;
    const double x30 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x29 - x30);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x29 + x30);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    const double x31 = sigma2*sigma3;
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = x31;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    const double x32 = sigma1*sigma3;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = x32;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    const double x33 = sigma1*sigma2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = x33;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    const double x34 = 1.0/((n1_x*n1_x));
    const double x35 = 1.0/((p2*p2));
    const double x36 = 1.0/((p3*p3));
    const double x37 = SQRT3_2*x34*x35*x36;
    /* orientation: the moments of B_iD_i about C are coplanar (27) [m³] */
    const double orientation = tilt*x37;
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x38 = a + q6;
    /* scale of e1 [m] */
    const double e_scale1 = x16*x38;
    /* scale of e2 [m] */
    const double e_scale2 = x24*x38;
    /* scale of e3 [m] */
    const double e_scale3 = x27*x38;
    const double x39 = fabs(sigma1);
    const double x40 = fabs(sigma2);
    const double x41 = fabs(sigma3);
    const double x42 = fabs(tau2);
    const double x43 = fabs(tau3);
    const double x44 = fabs(tau1);
    /* scale of the orientation factor [m³] */
    const double orientation_scale = reach*x37*(x39*x40 + x39*x41 + x39*x42 + x39*x43 + x40*x41 + x40*x43 + x40*x44 + x41*x42 + x41*x44);
    const double x45 = dq6*lambda_x;
    const double x46 = c_z*dq5;
    const double x47 = axis_y*x46;
    /* velocity of C (12), (16) [m/s] */
    const double v_x = -c_y*dq4 + x45 + x47;
    const double x48 = dq6*lambda_y;
    const double x49 = axis_x*x46;
    const double v_y = c_x*dq4 + x48 - x49;
    const double x50 = dq6*lambda_z;
    const double x51 = axis_x*c_y - axis_y*c_x;
    const double v_z = dq5*x51 + x50;
    const double x52 = l1*x15;
    const double x53 = m1_x*tau1 + nu_x*sigma1;
    const double x54 = m1_y*tau1 + nu_y*sigma1;
    const double x55 = m1_z*tau1 + nu_z*sigma1;
    const double x56 = n1_x/h1;
    /* what limb 1 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive1 = x56*(-dq1*x52 - v_x*x53 - v_y*x54 - v_z*x55);
    const double x57 = l2*x23;
    const double x58 = m2_x*tau2 + nu_x*sigma2;
    const double x59 = m2_y*tau2 + nu_y*sigma2;
    const double x60 = m2_z*tau2 + nu_z*sigma2;
    const double x61 = p2/h2;
    /* what limb 2 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive2 = x61*(-dq2*x57 - v_x*x58 - v_y*x59 - v_z*x60);
    const double x62 = l3*x26;
    const double x63 = m3_x*tau3 + nu_x*sigma3;
    const double x64 = m3_y*tau3 + nu_y*sigma3;
    const double x65 = m3_z*tau3 + nu_z*sigma3;
    const double x66 = p3/h3;
    /* what limb 3 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s] */
    const double drive3 = x66*(-dq3*x62 - v_x*x63 - v_y*x64 - v_z*x65);
    const double x67 = n3_x*sigma3;
    const double x68 = n2_x*sigma2;
    const double x69 = tau2*x67 - tau3*x68 + x30*x31;
    const double x70 = n1_x*sigma1;
    const double x71 = -tau1*x67 + tau3*x70 + x30*x32;
    const double x72 = tau1*x68 - tau2*x70 + x30*x33;
    const double x73 = 1.3333333333333333*SQRT3_2/tilt;
    /* angular velocity (17) [rad/s] */
    const double omega_x = x73*(drive1*x69 + drive2*x71 + drive3*x72);
    const double x74 = n3_y*sigma3;
    const double x75 = n2_y*sigma2;
    const double x76 = SQRT3_2*nu_y;
    const double x77 = tau2*x74 - tau3*x75 + x31*x76;
    const double x78 = n1_y*sigma1;
    const double x79 = -tau1*x74 + tau3*x78 + x32*x76;
    const double x80 = tau1*x75 - tau2*x78 + x33*x76;
    const double omega_y = x73*(drive1*x77 + drive2*x79 + drive3*x80);
    const double x81 = n3_z*sigma3;
    const double x82 = n2_z*sigma2;
    const double x83 = SQRT3_2*nu_z;
    const double x84 = tau2*x81 - tau3*x82 + x31*x83;
    const double x85 = n1_z*sigma1;
    const double x86 = -tau1*x81 + tau3*x85 + x32*x83;
    const double x87 = tau1*x82 - tau2*x85 + x33*x83;
    const double omega_z = x73*(drive1*x84 + drive2*x86 + drive3*x87);
    const double x88 = c_z*ddq5;
    const double x89 = dq5*v_z;
    const double x90 = dq6*x13;
    /* acceleration of C (16) [m/s²] */
    const double dv_x = axis_y*x88 + axis_y*x89 - c_y*ddq4 + ddq6*lambda_x - dq4*v_y + dq4*x49 + x90*(v_x - x45);
    const double dv_y = -axis_x*x88 - axis_x*x89 + c_x*ddq4 + ddq6*lambda_y + dq4*v_x + dq4*x47 + x90*(v_y - x48);
    const double dv_z = ddq5*x51 + ddq6*lambda_z + dq4*dq5*(-axis_x*c_x - axis_y*c_y) + dq5*(axis_x*v_y - axis_y*v_x) + x90*(v_z - x50);
    const double x91 = -n1_y*omega_z + n1_z*omega_y;
    const double x92 = e1*x91 + v_x;
    /* rate of e_i (4) [m/s] */
    const double de1 = -x14*x92;
    /* velocity of B_i (3) [m/s] */
    const double db1_x = de1*n1_x + x92;
    const double x93 = n1_x*omega_z - n1_z*omega_x;
    const double db1_y = de1*n1_y + e1*x93 + v_y;
    const double x94 = -n1_x*omega_y + n1_y*omega_x;
    const double db1_z = de1*n1_z + e1*x94 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias1 = ((db1_x*db1_x) + (db1_y*db1_y) + (db1_z*db1_z) - (dq1*dq1) - x34*(2.0*de1*(x53*x91 + x54*x93 + x55*x94) + e1*(n1_x*omega_x + n1_y*omega_y + n1_z*omega_z)*(omega_x*x53 + omega_y*x54 + omega_z*x55)))/q1;
    /* what limb 1 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²] */
    const double ddrive1 = x56*(-dv_x*x53 - dv_y*x54 - dv_z*x55 - x52*(-bias1 + ddq1));
    const double x95 = SQRT3_2*v_y;
    const double x96 = n2_x*omega_z - n2_z*omega_x;
    /* rate of e_i (4) [m/s] */
    const double de2 = x19*(-e2*(SQRT3_2*x96 - 0.5*n2_z*omega_y + omega_z*x20) + 0.5*v_x - x95);
    const double x97 = -n2_y*omega_z + n2_z*omega_y;
    /* velocity of B_i (3) [m/s] */
    const double db2_x = de2*n2_x + e2*x97 + v_x;
    const double db2_y = de2*n2_y + e2*x96 + v_y;
    const double x98 = -n2_x*omega_y + n2_y*omega_x;
    const double db2_z = de2*n2_z + e2*x98 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias2 = ((db2_x*db2_x) + (db2_y*db2_y) + (db2_z*db2_z) - (dq2*dq2) - x35*(2.0*de2*(x58*x97 + x59*x96 + x60*x98) + e2*(n2_x*omega_x + n2_y*omega_y + n2_z*omega_z)*(omega_x*x58 + omega_y*x59 + omega_z*x60)))/q2;
    /* what limb 2 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²] */
    const double ddrive2 = x61*(-dv_x*x58 - dv_y*x59 - dv_z*x60 - x57*(-bias2 + ddq2));
    const double x99 = n3_x*omega_z - n3_z*omega_x;
    /* rate of e_i (4) [m/s] */
    const double de3 = x25*(-e3*(-SQRT3_2*x99 + 0.5*n3_y*omega_z - 0.5*n3_z*omega_y) + 0.5*v_x + x95);
    const double x100 = -n3_y*omega_z + n3_z*omega_y;
    /* velocity of B_i (3) [m/s] */
    const double db3_x = de3*n3_x + e3*x100 + v_x;
    const double db3_y = de3*n3_y + e3*x99 + v_y;
    const double x101 = -n3_x*omega_y + n3_y*omega_x;
    const double db3_z = de3*n3_z + e3*x101 + v_z;
    /* the part of the acceleration of an outer limb that the rates alone make (6) [m/s²] */
    const double bias3 = ((db3_x*db3_x) + (db3_y*db3_y) + (db3_z*db3_z) - (dq3*dq3) - x36*(2.0*de3*(x100*x63 + x101*x65 + x64*x99) + e3*(n3_x*omega_x + n3_y*omega_y + n3_z*omega_z)*(omega_x*x63 + omega_y*x64 + omega_z*x65)))/q3;
    /* what limb 3 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²] */
    const double ddrive3 = x66*(-dv_x*x63 - dv_y*x64 - dv_z*x65 - x62*(-bias3 + ddq3));
    /* angular acceleration (17) [rad/s²] */
    const double domega_x = x73*(ddrive1*x69 + ddrive2*x71 + ddrive3*x72);
    const double domega_y = x73*(ddrive1*x77 + ddrive2*x79 + ddrive3*x80);
    const double domega_z = x73*(ddrive1*x84 + ddrive2*x86 + ddrive3*x87);
    out_twist[0] = omega_x;
    out_twist[stride] = omega_y;
    out_twist[2 * stride] = omega_z;
    out_twist[3 * stride] = v_x;
    out_twist[4 * stride] = v_y;
    out_twist[5 * stride] = v_z;
    out_twist_rate[0] = domega_x;
    out_twist_rate[stride] = domega_y;
    out_twist_rate[2 * stride] = domega_z;
    out_twist_rate[3 * stride] = dv_x;
    out_twist_rate[4 * stride] = dv_y;
    out_twist_rate[5 * stride] = dv_z;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_extension_scale[0] = e_scale1;
    out_extension_scale[stride] = e_scale2;
    out_extension_scale[2 * stride] = e_scale3;
    out_orientation[0] = orientation;
    out_orientation_scale[0] = orientation_scale;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
    out_scaled_legs[0] = l1;
    out_scaled_legs[stride] = l2;
    out_scaled_legs[2 * stride] = l3;
    out_radial[0] = r;
    out_central_length[0] = q6;
    out_reach[0] = reach;
}

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
    double *out_reach)
{
    forward_acceleration_body(1, &in_a, in_c, in_R, in_heading, in_rates, in_accelerations, out_twist, out_twist_rate, out_extension, out_extension_scale, out_orientation, out_orientation_scale, out_incidence, out_scaled_legs, out_radial, out_central_length, out_reach);
}

KLEINFORM_BODY void inverse_singularity_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_determinant,
    double *RESTRICT out_limb,
    double *RESTRICT out_central,
    double *RESTRICT out_wrist,
    double *RESTRICT out_limb_scale,
    double *RESTRICT out_central_scale,
    double *RESTRICT out_wrist_scale)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x13 = SQRT3_2*c_y;
    const double x14 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x13 + x14;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x15 = 0.5*c_y;
    const double x16 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x15 - x16);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x13 + x14;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x15 + x16);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x17 = l1/rho1;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -x17*fabs(n1_x);
    const double x18 = 0.5*nu_y;
    const double x19 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x18 - x19);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x20 = l2/rho2;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -x20*fabs(p2);
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x18 + x19);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x21 = l3/rho3;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -x21*fabs(p3);
    /* central limb: q6² cos q5 (26) [m²] */
    const double central = q6*r;
    const double x22 = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z);
    /* wrist: the central limb in the platform's plane (26), (27) [1] */
    const double wrist = x22/q6;
    /* determinant of the inverse Jacobian (22)-(26) [m²] */
    const double det_J_q = limb1*limb2*limb3*r*x22;
    /* scale of limb 1's Klein form [1] */
    const double limb_scale1 = x17;
    /* scale of limb 2's Klein form [1] */
    const double limb_scale2 = x20;
    /* scale of limb 3's Klein form [1] */
    const double limb_scale3 = x21;
    /* scale of the central factor [m²] */
    const double central_scale = (q6*q6);
    out_determinant[0] = det_J_q;
    out_limb[0] = limb1;
    out_limb[stride] = limb2;
    out_limb[2 * stride] = limb3;
    out_central[0] = central;
    out_wrist[0] = wrist;
    out_limb_scale[0] = limb_scale1;
    out_limb_scale[stride] = limb_scale2;
    out_limb_scale[2 * stride] = limb_scale3;
    out_central_scale[0] = central_scale;
    out_wrist_scale[0] = SQRT3_2;
}

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
    double *out_wrist_scale)
{
    inverse_singularity_body(1, &in_a, in_c, in_R, out_determinant, out_limb, out_central, out_wrist, out_limb_scale, out_central_scale, out_wrist_scale);
}

KLEINFORM_BODY void direct_singularity_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_determinant,
    double *RESTRICT out_extension,
    double *RESTRICT out_orientation,
    double *RESTRICT out_wrist,
    double *RESTRICT out_extension_scale,
    double *RESTRICT out_orientation_scale,
    double *RESTRICT out_wrist_scale)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_x*c_x) + (c_y*c_y) + (c_z*c_z));
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    const double x12 = SQRT3_2*c_y;
    const double x13 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x12 + x13;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x14 = 0.5*c_y;
    const double x15 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x14 - x15);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x12 + x13;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x14 + x15);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x16 = 0.5*nu_y;
    const double x17 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x16 - x17);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x16 + x17);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = sigma2*sigma3;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = sigma1*sigma3;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = sigma1*sigma2;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* wrist: the central limb in the platform's plane (26), (27) [1] */
    const double wrist = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z)/q6;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    const double x18 = SQRT3_2*tilt;
    const double x19 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)));
    /* orientation: the moments of B_iD_i about C are coplanar (27) [m³] */
    const double orientation = x18*x19;
    /* determinant of the moments of S_1, S_2, S_3 (27) [m³] */
    const double det_moments = e1*e2*e3*x18/(rho1*rho2*rho3);
    /* determinant of the forward Jacobian (27) [m³] */
    const double det_J_v = -det_moments*wrist;
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    const double x20 = a + q6;
    /* scale of e1 [m] */
    const double e_scale1 = x20/fabs(n1_x);
    /* scale of e2 [m] */
    const double e_scale2 = x20/fabs(p2);
    /* scale of e3 [m] */
    const double e_scale3 = x20/fabs(p3);
    const double x21 = fabs(sigma1);
    const double x22 = fabs(sigma2);
    const double x23 = fabs(sigma3);
    const double x24 = fabs(tau2);
    const double x25 = fabs(tau3);
    const double x26 = fabs(tau1);
    /* scale of the orientation factor [m³] */
    const double orientation_scale = SQRT3_2*reach*x19*(x21*x22 + x21*x23 + x21*x24 + x21*x25 + x22*x23 + x22*x25 + x22*x26 + x23*x24 + x23*x26);
    out_determinant[0] = det_J_v;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_orientation[0] = orientation;
    out_wrist[0] = wrist;
    out_extension_scale[0] = e_scale1;
    out_extension_scale[stride] = e_scale2;
    out_extension_scale[2 * stride] = e_scale3;
    out_orientation_scale[0] = orientation_scale;
    out_wrist_scale[0] = SQRT3_2;
}

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
    double *out_wrist_scale)
{
    direct_singularity_body(1, &in_a, in_c, in_R, out_determinant, out_extension, out_orientation, out_wrist, out_extension_scale, out_orientation_scale, out_wrist_scale);
}

KLEINFORM_BODY void survey_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_joints,
    double *RESTRICT out_extension,
    double *RESTRICT out_inverse_determinant,
    double *RESTRICT out_direct_determinant,
    double *RESTRICT out_limb,
    double *RESTRICT out_central,
    double *RESTRICT out_wrist,
    double *RESTRICT out_orientation,
    double *RESTRICT out_limb_scale,
    double *RESTRICT out_central_scale,
    double *RESTRICT out_wrist_scale,
    double *RESTRICT out_extension_scale,
    double *RESTRICT out_orientation_scale,
    double *RESTRICT out_incidence)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    const double x12 = (c_x*c_x) + (c_y*c_y);
    /* length of the central limb (11) [m] */
    const double q6 = sqrt((c_z*c_z) + x12);
    /* distance of C from the Z axis (11) [m] */
    const double r = sqrt(x12);
    /* elevation of the central limb (11) [rad] */
    const double q5 = angle_of(c_z, r);
    /* azimuth of the central limb, measured from the X axis (11) [rad] */
    const double q4 = angle_of(c_y, c_x);
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    /* signed distance from C to B_i (4) [m] */
    const double e1 = h1/n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = c_y*n1_x + h1*n1_y;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    /* p_i times the leg, its length [m] */
    const double l1 = sqrt((gt1*gt1) + (gz1*gz1));
    const double x13 = fabs(n1_x);
    const double x14 = 1.0/x13;
    /* length of the outer limb (10) [m] */
    const double q1 = l1*x14;
    const double x15 = SQRT3_2*c_y;
    const double x16 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x15 + x16;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    /* signed distance from C to B_i (4) [m] */
    const double e2 = h2/p2;
    const double x17 = 0.5*c_y;
    const double x18 = SQRT3_2*c_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = h2*(-SQRT3_2*n2_x - 0.5*n2_y) + p2*(-x17 - x18);
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* p_i times the leg, its length [m] */
    const double l2 = sqrt((gt2*gt2) + (gz2*gz2));
    const double x19 = fabs(p2);
    const double x20 = 1.0/x19;
    /* length of the outer limb (10) [m] */
    const double q2 = l2*x20;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x15 + x16;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    /* signed distance from C to B_i (4) [m] */
    const double e3 = h3/p3;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*(SQRT3_2*n3_x - 0.5*n3_y) + p3*(-x17 + x18);
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i times the leg, its length [m] */
    const double l3 = sqrt((gt3*gt3) + (gz3*gz3));
    const double x21 = fabs(p3);
    const double x22 = 1.0/x21;
    /* length of the outer limb (10) [m] */
    const double q3 = l3*x22;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho1 = sqrt((sigma1*sigma1) + (tau1*tau1));
    const double x23 = 1.0/rho1;
    const double x24 = l1*x23;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb1 = -x13*x24;
    const double x25 = 0.5*nu_y;
    const double x26 = SQRT3_2*nu_x;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*(-x25 - x26);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - 0.5*m2_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho2 = sqrt((sigma2*sigma2) + (tau2*tau2));
    const double x27 = 1.0/rho2;
    const double x28 = l2*x27;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb2 = -x19*x28;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*(-x25 + x26);
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - 0.5*m3_y);
    /* p_i² times the distance from B_i to D_i [m] */
    const double rho3 = sqrt((sigma3*sigma3) + (tau3*tau3));
    const double x29 = 1.0/rho3;
    const double x30 = l3*x29;
    /* Klein form of S_i and the actuated screw (15), (23) [1] */
    const double limb3 = -x21*x30;
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = sigma2*sigma3;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = sigma1*sigma3;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = sigma1*sigma2;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* central limb: q6² cos q5 (26) [m²] */
    const double central = q6*r;
    const double x31 = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z);
    /* wrist: the central limb in the platform's plane (26), (27) [1] */
    const double wrist = x31/q6;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    const double x32 = SQRT3_2*tilt;
    const double x33 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)));
    /* orientation: the moments of B_iD_i about C are coplanar (27) [m³] */
    const double orientation = x32*x33;
    /* determinant of the inverse Jacobian (22)-(26) [m²] */
    const double det_J_q = limb1*limb2*limb3*r*x31;
    /* determinant of the moments of S_1, S_2, S_3 (27) [m³] */
    const double det_moments = e1*e2*e3*x23*x27*x29*x32;
    /* determinant of the forward Jacobian (27) [m³] */
    const double det_J_v = -det_moments*wrist;
    /* largest length in a leg's equations [m] */
    const double reach = a + 2.0*q6;
    /* scale of limb 1's Klein form [1] */
    const double limb_scale1 = x24;
    const double x34 = a + q6;
    /* scale of e1 [m] */
    const double e_scale1 = x14*x34;
    /* scale of limb 2's Klein form [1] */
    const double limb_scale2 = x28;
    /* scale of e2 [m] */
    const double e_scale2 = x20*x34;
    /* scale of limb 3's Klein form [1] */
    const double limb_scale3 = x30;
    /* scale of e3 [m] */
    const double e_scale3 = x22*x34;
    /* scale of the central factor [m²] */
    const double central_scale = (q6*q6);
    const double x35 = fabs(sigma1);
    const double x36 = fabs(sigma2);
    const double x37 = fabs(sigma3);
    const double x38 = fabs(tau2);
    const double x39 = fabs(tau3);
    const double x40 = fabs(tau1);
    /* scale of the orientation factor [m³] */
    const double orientation_scale = SQRT3_2*reach*x33*(x35*x36 + x35*x37 + x35*x38 + x35*x39 + x36*x37 + x36*x39 + x36*x40 + x37*x38 + x37*x40);
    out_joints[0] = q1;
    out_joints[stride] = q2;
    out_joints[2 * stride] = q3;
    out_joints[3 * stride] = q4;
    out_joints[4 * stride] = q5;
    out_joints[5 * stride] = q6;
    out_extension[0] = e1;
    out_extension[stride] = e2;
    out_extension[2 * stride] = e3;
    out_inverse_determinant[0] = det_J_q;
    out_direct_determinant[0] = det_J_v;
    out_limb[0] = limb1;
    out_limb[stride] = limb2;
    out_limb[2 * stride] = limb3;
    out_central[0] = central;
    out_wrist[0] = wrist;
    out_orientation[0] = orientation;
    out_limb_scale[0] = limb_scale1;
    out_limb_scale[stride] = limb_scale2;
    out_limb_scale[2 * stride] = limb_scale3;
    out_central_scale[0] = central_scale;
    out_wrist_scale[0] = SQRT3_2;
    out_extension_scale[0] = e_scale1;
    out_extension_scale[stride] = e_scale2;
    out_extension_scale[2 * stride] = e_scale3;
    out_orientation_scale[0] = orientation_scale;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
}

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
    double out_incidence[3])
{
    survey_body(1, &in_a, in_c, in_R, out_joints, out_extension, out_inverse_determinant, out_direct_determinant, out_limb, out_central, out_wrist, out_orientation, out_limb_scale, out_central_scale, out_wrist_scale, out_extension_scale, out_orientation_scale, out_incidence);
}

KLEINFORM_BODY void direct_locus_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_R,
    double *RESTRICT out_coefficients,
    double *RESTRICT out_incidence)
{
    const double a = in_a[0];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*m1_x;
    const double x5 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x4 - x5;
    const double x6 = 0.5*m1_y;
    const double x7 = SQRT3_2*n1_y;
    const double m2_y = -x6 - x7;
    const double x8 = 0.5*m1_z;
    const double x9 = SQRT3_2*n1_z;
    const double m2_z = -x8 - x9;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x4 + x5;
    const double m3_y = -x6 + x7;
    const double m3_z = -x8 + x9;
    /* derivative of tau_1 by the position [1] */
    const double tau_shift1_x = -m1_x;
    const double tau_shift1_y = -n1_x*nu_z;
    const double tau_shift1_z = n1_x*nu_y;
    /* derivative of sigma_1 by the position [1] */
    const double sigma_shift1_x = -nu_x;
    const double sigma_shift1_y = m1_z*n1_x;
    const double sigma_shift1_z = -m1_y*n1_x;
    /* tau_1, its coefficients in c [m, 1] */
    const double tau_part1_1 = a*m1_x;
    /* sigma_1, its coefficients in c [m, 1] */
    const double sigma_part1_1 = a*nu_x;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x10 = SQRT3_2*m2_y;
    const double x11 = nu_z*p2;
    /* derivative of tau_2 by the position [1] */
    const double tau_shift2_x = SQRT3_2*x11 - 0.25*m2_x + 0.5*x10;
    const double x12 = -0.5*m2_x + x10;
    const double tau_shift2_y = -SQRT3_2*x12 + 0.5*x11;
    const double x13 = 0.5*nu_y;
    const double x14 = SQRT3_2*nu_x;
    const double tau_shift2_z = p2*(-x13 - x14);
    const double x15 = 0.25*nu_x;
    const double x16 = SQRT3_2*x13;
    const double x17 = m2_z*p2;
    /* derivative of sigma_2 by the position [1] */
    const double sigma_shift2_x = -SQRT3_2*x17 - x15 + x16;
    const double x18 = 0.5*nu_x;
    const double x19 = SQRT3_2*nu_y;
    const double x20 = -x18 + x19;
    const double sigma_shift2_y = -SQRT3_2*x20 - 0.5*x17;
    const double sigma_shift2_z = p2*(SQRT3_2*m2_x + 0.5*m2_y);
    /* tau_2, its coefficients in c [m, 1] */
    const double tau_part2_1 = a*x12;
    /* sigma_2, its coefficients in c [m, 1] */
    const double sigma_part2_1 = a*x20;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x21 = SQRT3_2*m3_y;
    /* derivative of tau_3 by the position [1] */
    const double tau_shift3_x = -SQRT3_2*nu_z*p3 - 0.25*m3_x - 0.5*x21;
    const double x22 = 0.5*m3_x + x21;
    const double tau_shift3_y = -SQRT3_2*x22 + 0.5*nu_z*p3;
    const double tau_shift3_z = p3*(-x13 + x14);
    /* derivative of sigma_3 by the position [1] */
    const double sigma_shift3_x = SQRT3_2*m3_z*p3 - x15 - x16;
    const double x23 = x18 + x19;
    const double sigma_shift3_y = -SQRT3_2*x23 - 0.5*m3_z*p3;
    const double sigma_shift3_z = p3*(-SQRT3_2*m3_x + 0.5*m3_y);
    /* tau_3, its coefficients in c [m, 1] */
    const double tau_part3_1 = -a*x22;
    /* sigma_3, its coefficients in c [m, 1] */
    const double sigma_part3_1 = -a*x23;
    /* sigma_2 sigma_3, its coefficients in c [m², m, 1] */
    const double sigma23_1 = sigma_part2_1*sigma_part3_1;
    const double sigma23_2 = sigma_part2_1*sigma_shift3_x + sigma_part3_1*sigma_shift2_x;
    const double sigma23_3 = sigma_part2_1*sigma_shift3_y + sigma_part3_1*sigma_shift2_y;
    const double sigma23_4 = sigma_part2_1*sigma_shift3_z + sigma_part3_1*sigma_shift2_z;
    const double sigma23_5 = sigma_shift2_x*sigma_shift3_x;
    const double sigma23_6 = sigma_shift2_x*sigma_shift3_y + sigma_shift2_y*sigma_shift3_x;
    const double sigma23_7 = sigma_shift2_x*sigma_shift3_z + sigma_shift2_z*sigma_shift3_x;
    const double sigma23_8 = sigma_shift2_y*sigma_shift3_y;
    const double sigma23_9 = sigma_shift2_y*sigma_shift3_z + sigma_shift2_z*sigma_shift3_y;
    const double sigma23_10 = sigma_shift2_z*sigma_shift3_z;
    /* tau_2 sigma_3 + tau_3 sigma_2, its coefficients in c [m², m, 1] */
    const double tau23_1 = sigma_part2_1*tau_part3_1 + sigma_part3_1*tau_part2_1;
    const double tau23_2 = sigma_part2_1*tau_shift3_x + sigma_part3_1*tau_shift2_x + sigma_shift2_x*tau_part3_1 + sigma_shift3_x*tau_part2_1;
    const double tau23_3 = sigma_part2_1*tau_shift3_y + sigma_part3_1*tau_shift2_y + sigma_shift2_y*tau_part3_1 + sigma_shift3_y*tau_part2_1;
    const double tau23_4 = sigma_part2_1*tau_shift3_z + sigma_part3_1*tau_shift2_z + sigma_shift2_z*tau_part3_1 + sigma_shift3_z*tau_part2_1;
    const double tau23_5 = sigma_shift2_x*tau_shift3_x + sigma_shift3_x*tau_shift2_x;
    const double tau23_6 = sigma_shift2_x*tau_shift3_y + sigma_shift2_y*tau_shift3_x + sigma_shift3_x*tau_shift2_y + sigma_shift3_y*tau_shift2_x;
    const double tau23_7 = sigma_shift2_x*tau_shift3_z + sigma_shift2_z*tau_shift3_x + sigma_shift3_x*tau_shift2_z + sigma_shift3_z*tau_shift2_x;
    const double tau23_8 = sigma_shift2_y*tau_shift3_y + sigma_shift3_y*tau_shift2_y;
    const double tau23_9 = sigma_shift2_y*tau_shift3_z + sigma_shift2_z*tau_shift3_y + sigma_shift3_y*tau_shift2_z + sigma_shift3_z*tau_shift2_y;
    const double tau23_10 = sigma_shift2_z*tau_shift3_z + sigma_shift3_z*tau_shift2_z;
    /* cubic of direct singularities at one orientation, its coefficients in c (27) [m³, m², m, 1] */
    const double cubic_1 = sigma23_1*tau_part1_1 + sigma_part1_1*tau23_1;
    const double cubic_2 = sigma23_1*tau_shift1_x + sigma23_2*tau_part1_1 + sigma_part1_1*tau23_2 + sigma_shift1_x*tau23_1;
    const double cubic_3 = sigma23_1*tau_shift1_y + sigma23_3*tau_part1_1 + sigma_part1_1*tau23_3 + sigma_shift1_y*tau23_1;
    const double cubic_4 = sigma23_1*tau_shift1_z + sigma23_4*tau_part1_1 + sigma_part1_1*tau23_4 + sigma_shift1_z*tau23_1;
    const double cubic_5 = sigma23_2*tau_shift1_x + sigma23_5*tau_part1_1 + sigma_part1_1*tau23_5 + sigma_shift1_x*tau23_2;
    const double cubic_6 = sigma23_2*tau_shift1_y + sigma23_3*tau_shift1_x + sigma23_6*tau_part1_1 + sigma_part1_1*tau23_6 + sigma_shift1_x*tau23_3 + sigma_shift1_y*tau23_2;
    const double cubic_7 = sigma23_2*tau_shift1_z + sigma23_4*tau_shift1_x + sigma23_7*tau_part1_1 + sigma_part1_1*tau23_7 + sigma_shift1_x*tau23_4 + sigma_shift1_z*tau23_2;
    const double cubic_8 = sigma23_3*tau_shift1_y + sigma23_8*tau_part1_1 + sigma_part1_1*tau23_8 + sigma_shift1_y*tau23_3;
    const double cubic_9 = sigma23_3*tau_shift1_z + sigma23_4*tau_shift1_y + sigma23_9*tau_part1_1 + sigma_part1_1*tau23_9 + sigma_shift1_y*tau23_4 + sigma_shift1_z*tau23_3;
    const double cubic_10 = sigma23_10*tau_part1_1 + sigma23_4*tau_shift1_z + sigma_part1_1*tau23_10 + sigma_shift1_z*tau23_4;
    const double cubic_11 = sigma23_5*tau_shift1_x + sigma_shift1_x*tau23_5;
    const double cubic_12 = sigma23_5*tau_shift1_y + sigma23_6*tau_shift1_x + sigma_shift1_x*tau23_6 + sigma_shift1_y*tau23_5;
    const double cubic_13 = sigma23_5*tau_shift1_z + sigma23_7*tau_shift1_x + sigma_shift1_x*tau23_7 + sigma_shift1_z*tau23_5;
    const double cubic_14 = sigma23_6*tau_shift1_y + sigma23_8*tau_shift1_x + sigma_shift1_x*tau23_8 + sigma_shift1_y*tau23_6;
    const double cubic_15 = sigma23_6*tau_shift1_z + sigma23_7*tau_shift1_y + sigma23_9*tau_shift1_x + sigma_shift1_x*tau23_9 + sigma_shift1_y*tau23_7 + sigma_shift1_z*tau23_6;
    const double cubic_16 = sigma23_10*tau_shift1_x + sigma23_7*tau_shift1_z + sigma_shift1_x*tau23_10 + sigma_shift1_z*tau23_7;
    const double cubic_17 = sigma23_8*tau_shift1_y + sigma_shift1_y*tau23_8;
    const double cubic_18 = sigma23_8*tau_shift1_z + sigma23_9*tau_shift1_y + sigma_shift1_y*tau23_9 + sigma_shift1_z*tau23_8;
    const double cubic_19 = sigma23_10*tau_shift1_y + sigma23_9*tau_shift1_z + sigma_shift1_y*tau23_10 + sigma_shift1_z*tau23_9;
    const double cubic_20 = sigma23_10*tau_shift1_z + sigma_shift1_z*tau23_10;
    out_coefficients[0] = cubic_1;
    out_coefficients[stride] = cubic_2;
    out_coefficients[2 * stride] = cubic_3;
    out_coefficients[3 * stride] = cubic_4;
    out_coefficients[4 * stride] = cubic_5;
    out_coefficients[5 * stride] = cubic_6;
    out_coefficients[6 * stride] = cubic_7;
    out_coefficients[7 * stride] = cubic_8;
    out_coefficients[8 * stride] = cubic_9;
    out_coefficients[9 * stride] = cubic_10;
    out_coefficients[10 * stride] = cubic_11;
    out_coefficients[11 * stride] = cubic_12;
    out_coefficients[12 * stride] = cubic_13;
    out_coefficients[13 * stride] = cubic_14;
    out_coefficients[14 * stride] = cubic_15;
    out_coefficients[15 * stride] = cubic_16;
    out_coefficients[16 * stride] = cubic_17;
    out_coefficients[17 * stride] = cubic_18;
    out_coefficients[18 * stride] = cubic_19;
    out_coefficients[19 * stride] = cubic_20;
    out_incidence[0] = n1_x;
    out_incidence[stride] = p2;
    out_incidence[2 * stride] = p3;
}

KLEINFORM_API void kleinform_direct_locus(
    double in_a,
    const double in_R[9],
    double out_coefficients[20],
    double out_incidence[3])
{
    direct_locus_body(1, &in_a, in_R, out_coefficients, out_incidence);
}

KLEINFORM_BODY void orientation_locus_body(
    size_t stride,
    const double *RESTRICT in_a,
    const double *RESTRICT in_c,
    const double *RESTRICT in_R,
    double *RESTRICT out_value,
    double *RESTRICT out_by_turn,
    double *RESTRICT out_by_position)
{
    const double a = in_a[0];
    const double c_x = in_c[0];
    const double c_y = in_c[stride];
    const double c_z = in_c[2 * stride];
    const double n1_x = in_R[0];
    const double m1_x = in_R[stride];
    const double nu_x = in_R[2 * stride];
    const double n1_y = in_R[3 * stride];
    const double m1_y = in_R[4 * stride];
    const double nu_y = in_R[5 * stride];
    const double n1_z = in_R[6 * stride];
    const double m1_z = in_R[7 * stride];
    const double nu_z = in_R[8 * stride];
    const double x0 = 0.5*n1_x;
    const double x1 = SQRT3_2*m1_x;
    /* direction from C to B_2, n_1 turned by 120° about nu (5) [1] */
    const double n2_x = -x0 + x1;
    const double x2 = 0.5*n1_y;
    const double x3 = SQRT3_2*m1_y;
    const double n2_y = -x2 + x3;
    const double x4 = 0.5*n1_z;
    const double x5 = SQRT3_2*m1_z;
    const double n2_z = -x4 + x5;
    const double x6 = 0.5*m1_x;
    const double x7 = SQRT3_2*n1_x;
    /* platform direction normal to n_2 [1] */
    const double m2_x = -x6 - x7;
    const double x8 = 0.5*m1_y;
    const double x9 = SQRT3_2*n1_y;
    const double m2_y = -x8 - x9;
    const double x10 = 0.5*m1_z;
    const double x11 = SQRT3_2*n1_z;
    const double m2_z = -x10 - x11;
    /* direction from C to B_3, n_1 turned by 240° about nu (5) [1] */
    const double n3_x = -x0 - x1;
    const double n3_y = -x2 - x3;
    const double n3_z = -x4 - x5;
    /* platform direction normal to n_3 [1] */
    const double m3_x = -x6 + x7;
    const double m3_y = -x8 + x9;
    const double m3_z = -x10 + x11;
    /* distance of C from the plane of the limb (4) [m] */
    const double h1 = a - c_x;
    const double x12 = c_y*n1_x;
    /* p_i times the horizontal part of the leg [m] */
    const double gt1 = h1*n1_y + x12;
    /* p_i times the vertical part of the leg [m] */
    const double gz1 = c_z*n1_x + h1*n1_z;
    const double x13 = SQRT3_2*c_y;
    const double x14 = a + 0.5*c_x;
    /* distance of C from the plane of the limb (4) [m] */
    const double h2 = -x13 + x14;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p2 = SQRT3_2*n2_y - 0.5*n2_x;
    const double x15 = SQRT3_2*n2_x + 0.5*n2_y;
    const double x16 = 0.5*c_y;
    const double x17 = SQRT3_2*c_x;
    const double x18 = -x16 - x17;
    /* p_i times the horizontal part of the leg [m] */
    const double gt2 = -h2*x15 + p2*x18;
    /* p_i times the vertical part of the leg [m] */
    const double gz2 = c_z*p2 + h2*n2_z;
    /* distance of C from the plane of the limb (4) [m] */
    const double h3 = x13 + x14;
    /* cosine of the angle between n_i and u_i (4) [1] */
    const double p3 = -SQRT3_2*n3_y - 0.5*n3_x;
    const double x19 = SQRT3_2*n3_x - 0.5*n3_y;
    const double x20 = -x16 + x17;
    /* p_i times the horizontal part of the leg [m] */
    const double gt3 = h3*x19 + p3*x20;
    /* p_i times the vertical part of the leg [m] */
    const double gz3 = c_z*p3 + h3*n3_z;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau1 = -gt1*nu_z + gz1*nu_y;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma1 = gt1*m1_z - gz1*m1_y;
    const double x21 = 0.5*nu_y;
    const double x22 = SQRT3_2*nu_x;
    const double x23 = x21 + x22;
    const double x24 = -x23;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau2 = -gt2*nu_z + gz2*x24;
    const double x25 = 0.5*m2_y;
    const double x26 = SQRT3_2*m2_x + x25;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma2 = gt2*m2_z + gz2*x26;
    const double x27 = -x21 + x22;
    /* p_i² times the part of B_iD_i in the platform's plane [m] */
    const double tau3 = -gt3*nu_z + gz3*x27;
    const double x28 = 0.5*m3_y;
    const double x29 = SQRT3_2*m3_x - x28;
    /* p_i² times the part of B_iD_i normal to the platform [m] */
    const double sigma3 = gt3*m3_z - gz3*x29;
    const double x30 = sigma2*sigma3;
    /* sigma of the limbs beside 1 [m²] */
    const double sigma_pair1 = x30;
    /* term 1 of tilt (27) [m³] */
    const double tilt_part1 = sigma_pair1*tau1;
    const double x31 = sigma1*sigma3;
    /* sigma of the limbs beside 2 [m²] */
    const double sigma_pair2 = x31;
    /* term 2 of tilt (27) [m³] */
    const double tilt_part2 = sigma_pair2*tau2;
    const double x32 = sigma1*sigma2;
    /* sigma of the limbs beside 3 [m²] */
    const double sigma_pair3 = x32;
    /* term 3 of tilt (27) [m³] */
    const double tilt_part3 = sigma_pair3*tau3;
    /* the three lines S_i in the platform frame (27) [m³] */
    const double tilt = tilt_part1 + tilt_part2 + tilt_part3;
    /* derivative of tau_1 by the position [1] */
    const double tau_shift1_x = -m1_x;
    const double tau_shift1_y = -n1_x*nu_z;
    const double tau_shift1_z = n1_x*nu_y;
    /* derivative of sigma_1 by the position [1] */
    const double sigma_shift1_x = -nu_x;
    const double sigma_shift1_y = m1_z*n1_x;
    const double sigma_shift1_z = -m1_y*n1_x;
    /* moment about O of a unit force along u_1 at C [m] */
    const double lever1_y = -c_z;
    /* derivative of tau_1 by a turn of the platform [m] */
    const double tau_turn1_x = -n1_x*(c_y*nu_y - lever1_y*nu_z);
    const double x33 = -c_y*nu_z - lever1_y*nu_y;
    const double tau_turn1_y = h1*m1_z + n1_z*x33 + nu_x*x12;
    const double tau_turn1_z = -h1*m1_y - lever1_y*n1_x*nu_x - n1_y*x33;
    /* derivative of sigma_1 by a turn of the platform [m] */
    const double sigma_turn1_x = n1_x*(c_y*m1_y - lever1_y*m1_z);
    const double x34 = c_y*m1_z + lever1_y*m1_y;
    const double sigma_turn1_y = h1*nu_z - m1_x*x12 + n1_z*x34;
    const double sigma_turn1_z = -h1*nu_y + lever1_y*m1_x*n1_x - n1_y*x34;
    const double x35 = nu_z*p2;
    /* derivative of tau_2 by the position [1] */
    const double tau_shift2_x = SQRT3_2*x25 + SQRT3_2*x35 - 0.25*m2_x;
    const double tau_shift2_y = SQRT3_2*(-SQRT3_2*m2_y + 0.5*m2_x) + 0.5*x35;
    const double tau_shift2_z = p2*x24;
    const double x36 = 0.25*nu_x;
    const double x37 = SQRT3_2*x21;
    const double x38 = m2_z*p2;
    /* derivative of sigma_2 by the position [1] */
    const double sigma_shift2_x = -SQRT3_2*x38 - x36 + x37;
    const double x39 = SQRT3_2*nu_y;
    const double sigma_shift2_y = SQRT3_2*(0.5*nu_x - x39) - 0.5*x38;
    const double sigma_shift2_z = p2*x26;
    const double x40 = SQRT3_2*c_z;
    /* moment about O of a unit force along u_2 at C [m] */
    const double lever2_x = x40;
    const double x41 = 0.5*c_z;
    const double lever2_y = x41;
    const double lever2_z = x18;
    const double x42 = h2*m2_z;
    const double x43 = -lever2_x*nu_x - lever2_y*nu_y - lever2_z*nu_z;
    const double x44 = n2_z*x43;
    /* derivative of tau_2 by a turn of the platform [m] */
    const double tau_turn2_x = -SQRT3_2*x42 - SQRT3_2*x44 - p2*(-lever2_y*nu_z + lever2_z*nu_y);
    const double tau_turn2_y = -p2*(lever2_x*nu_z - lever2_z*nu_x) - 0.5*x42 - 0.5*x44;
    const double tau_turn2_z = h2*x26 - p2*(-lever2_x*nu_y + lever2_y*nu_x) + x15*x43;
    const double x45 = h2*nu_z;
    const double x46 = lever2_x*m2_x + lever2_y*m2_y + lever2_z*m2_z;
    const double x47 = n2_z*x46;
    /* derivative of sigma_2 by a turn of the platform [m] */
    const double sigma_turn2_x = -SQRT3_2*x45 - SQRT3_2*x47 + p2*(-lever2_y*m2_z + lever2_z*m2_y);
    const double sigma_turn2_y = p2*(lever2_x*m2_z - lever2_z*m2_x) - 0.5*x45 - 0.5*x47;
    const double sigma_turn2_z = h2*x23 + p2*(-lever2_x*m2_y + lever2_y*m2_x) + x15*x46;
    /* derivative of tau_3 by the position [1] */
    const double tau_shift3_x = -SQRT3_2*nu_z*p3 - SQRT3_2*x28 - 0.25*m3_x;
    const double tau_shift3_y = -SQRT3_2*(SQRT3_2*m3_y + 0.5*m3_x) + 0.5*nu_z*p3;
    const double tau_shift3_z = p3*x27;
    /* derivative of sigma_3 by the position [1] */
    const double sigma_shift3_x = SQRT3_2*m3_z*p3 - x36 - x37;
    const double sigma_shift3_y = -SQRT3_2*(0.5*nu_x + x39) - 0.5*m3_z*p3;
    const double x48 = -x29;
    const double sigma_shift3_z = p3*x48;
    /* moment about O of a unit force along u_3 at C [m] */
    const double lever3_x = -x40;
    const double lever3_y = x41;
    const double lever3_z = x20;
    const double x49 = h3*m3_z;
    const double x50 = -lever3_x*nu_x - lever3_y*nu_y - lever3_z*nu_z;
    const double x51 = n3_z*x50;
    /* derivative of tau_3 by a turn of the platform [m] */
    const double tau_turn3_x = SQRT3_2*x49 + SQRT3_2*x51 - p3*(-lever3_y*nu_z + lever3_z*nu_y);
    const double tau_turn3_y = -p3*(lever3_x*nu_z - lever3_z*nu_x) - 0.5*x49 - 0.5*x51;
    const double x52 = -x19;
    const double tau_turn3_z = h3*x48 - p3*(-lever3_x*nu_y + lever3_y*nu_x) + x50*x52;
    const double x53 = h3*nu_z;
    const double x54 = lever3_x*m3_x + lever3_y*m3_y + lever3_z*m3_z;
    const double x55 = n3_z*x54;
    /* derivative of sigma_3 by a turn of the platform [m] */
    const double sigma_turn3_x = SQRT3_2*x53 + SQRT3_2*x55 + p3*(-lever3_y*m3_z + lever3_z*m3_y);
    const double sigma_turn3_y = p3*(lever3_x*m3_z - lever3_z*m3_x) - 0.5*x53 - 0.5*x55;
    const double sigma_turn3_z = -h3*x27 + p3*(-lever3_x*m3_y + lever3_y*m3_x) + x52*x54;
    const double x56 = sigma2*tau3 + sigma3*tau2;
    const double x57 = sigma1*tau3 + sigma3*tau1;
    const double x58 = sigma1*tau2 + sigma2*tau1;
    /* derivative of theta by a turn of the platform (27) [m³] */
    const double tilt_turn_x = sigma_turn1_x*x56 + sigma_turn2_x*x57 + sigma_turn3_x*x58 + tau_turn1_x*x30 + tau_turn2_x*x31 + tau_turn3_x*x32;
    const double tilt_turn_y = sigma_turn1_y*x56 + sigma_turn2_y*x57 + sigma_turn3_y*x58 + tau_turn1_y*x30 + tau_turn2_y*x31 + tau_turn3_y*x32;
    const double tilt_turn_z = sigma_turn1_z*x56 + sigma_turn2_z*x57 + sigma_turn3_z*x58 + tau_turn1_z*x30 + tau_turn2_z*x31 + tau_turn3_z*x32;
    /* derivative of theta by the position (27) [m²] */
    const double tilt_shift_x = sigma_shift1_x*x56 + sigma_shift2_x*x57 + sigma_shift3_x*x58 + tau_shift1_x*x30 + tau_shift2_x*x31 + tau_shift3_x*x32;
    const double tilt_shift_y = sigma_shift1_y*x56 + sigma_shift2_y*x57 + sigma_shift3_y*x58 + tau_shift1_y*x30 + tau_shift2_y*x31 + tau_shift3_y*x32;
    const double tilt_shift_z = sigma_shift1_z*x56 + sigma_shift2_z*x57 + sigma_shift3_z*x58 + tau_shift1_z*x30 + tau_shift2_z*x31 + tau_shift3_z*x32;
    out_value[0] = tilt;
    out_by_turn[0] = tilt_turn_x;
    out_by_turn[stride] = tilt_turn_y;
    out_by_turn[2 * stride] = tilt_turn_z;
    out_by_position[0] = tilt_shift_x;
    out_by_position[stride] = tilt_shift_y;
    out_by_position[2 * stride] = tilt_shift_z;
}

KLEINFORM_API void kleinform_orientation_locus(
    double in_a,
    const double in_c[3],
    const double in_R[9],
    double *out_value,
    double out_by_turn[3],
    double out_by_position[3])
{
    orientation_locus_body(1, &in_a, in_c, in_R, out_value, out_by_turn, out_by_position);
}
