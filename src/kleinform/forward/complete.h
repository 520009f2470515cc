/* SPDX-License-Identifier: BSD-3-Clause */
/* Everything that follows from the directions of modes: _complete of solve.py, in lanes.

   Included after the kernels. */
#ifndef KLEINFORM_COMPLETE_H
#define KLEINFORM_COMPLETE_H

#include "tables.h"

/* Closure equations (6) of a mode: their residual relative to the sum of their terms. */
#define RESIDUAL 1e-12

/* Joint values of unit size. */
struct row {
    double radius, position[3], lengths[3];
    /* What makes them as large as they were: a power of two. */
    double size;
};

/* A mode as it was found: n of the base limb and of the next, and e of the base limb. */
struct found {
    double directions[6], distance;
    int row, base;
};

/* A mode as it is listed. */
struct mode {
    double rotation[9], directions[9], platform_joints[9], extension[3];
    /* Modes are listed in falling order. */
    double rank;
    /* Whether the closure equations hold. */
    double holds;
};

#define MODE_NUMBERS (sizeof(struct mode) / sizeof(double))

/* Cosine and sine of the turn about Z that takes limb 1, 2, 3 to the place of limb 1. */
static const double COSINE[3] = {1.0, -0.5, -0.5};
static const double SINE[3] = {0.0, -SQRT3_2, SQRT3_2};

/* Modes side by side. */
struct lanes {
    double found[7][LANES];
    double base[LANES];
    double row[7][LANES];
    double size[LANES];
};

/* The angle of B_i about A_i from the horizontal t_i, in [0, 2 pi). */
INLINE double leg_angle(double along, double height)
{
    const double angle = angle_of(height, along);
    return angle < 0.0 ? angle + 2.0 * PI : angle;
}

/* n_1, n_2, n_3 of the platform from those of the base limb and of the next, turned back. */
INLINE void original(const struct lanes *in, double (*n)[LANES], int lane)
{
    const int is_1 = in->base[lane] == 1.0, is_2 = in->base[lane] == 2.0;
    const double cosine = is_1 || is_2 ? COSINE[1] : COSINE[0];
    const double sine = is_1 ? SINE[1] : (is_2 ? SINE[2] : SINE[0]);
    double own[3], next[3];
    for (int k = 0; k < 2; ++k) {
        const double x = in->found[3 * k][lane], y = in->found[3 * k + 1][lane];
        double *to = k ? next : own;
        to[0] = cosine * x + sine * y;
        to[1] = cosine * y - sine * x;
        to[2] = in->found[3 * k + 2][lane];
    }
    for (int k = 0; k < 3; ++k) {
        const double last = -own[k] - next[k];
        const double first = is_1 ? last : (is_2 ? next[k] : own[k]);
        const double second = is_1 ? own[k] : (is_2 ? last : next[k]);
        n[k][lane] = first;
        n[3 + k][lane] = second;
        n[6 + k][lane] = -first - second;
    }
}

/* e_i by (4), that of the base limb as it is known, and one step of Gauss and Newton. */
INLINE double fitted(const struct lanes *in, double (*n)[LANES], int limb, int lane)
{
    const double u_x = COSINE[limb], u_y = -SINE[limb], radius = in->row[0][lane];
    const double x = n[3 * limb][lane], y = n[3 * limb + 1][lane], z = n[3 * limb + 2][lane];
    const double foot_x = in->row[1][lane] - radius * u_x;
    const double foot_y = in->row[2][lane] - radius * u_y, foot_z = in->row[3][lane];
    const double incidence = x * u_x + y * u_y;
    const double by_plane = -(foot_x * u_x + foot_y * u_y) / incidence;
    const double e = in->base[lane] == (double)limb ? in->found[6][lane] : by_plane;
    const double leg_x = foot_x + e * x, leg_y = foot_y + e * y, leg_z = foot_z + e * z;
    const double length = sqrt(leg_x * leg_x + leg_y * leg_y + leg_z * leg_z);
    const double along = (leg_x * x + leg_y * y + leg_z * z) / length;
    const double excess = length - in->row[4 + limb][lane];
    const double slope = incidence * (leg_x * u_x + leg_y * u_y) + along * excess;
    const double step = slope / (incidence * incidence + along * along);
    return length > 0.0 ? e - step : e;
}

/* -1 for the one of the pair n, -n that is not listed: fewer e_i > 0 than e_i < 0, or as
   many and the first e_i < 0. */
INLINE double listed_sign(double e_1, double e_2, double e_3)
{
    const double sign_1 = (e_1 > 0.0 ? 1.0 : 0.0) - (e_1 < 0.0 ? 1.0 : 0.0);
    const double sign_2 = (e_2 > 0.0 ? 1.0 : 0.0) - (e_2 < 0.0 ? 1.0 : 0.0);
    const double sign_3 = (e_3 > 0.0 ? 1.0 : 0.0) - (e_3 < 0.0 ? 1.0 : 0.0);
    /* The balance counts 4 times, so that the first sign decides only between equals. */
    const double later = sign_2 != 0.0 ? sign_2 : sign_3;
    const double first = sign_1 != 0.0 ? sign_1 : later;
    return 4.0 * (sign_1 + sign_2 + sign_3) + first < 0.0 ? -1.0 : 1.0;
}

/* B_i = c + e_i n_i, and whether the closure equations hold. */
INLINE void place_joints(
    const struct lanes *in, double (*n)[LANES], double (*e)[LANES], double (*b)[LANES],
    double *holds, int lane)
{
    double all = 1.0;
    for (int limb = 0; limb < 3; ++limb) {
        const double extension = e[limb][lane], size = in->size[lane];
        const double length = in->row[4 + limb][lane], radius = in->row[0][lane];
        double square = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double entry = in->row[1 + k][lane] + extension * n[3 * limb + k][lane];
            square += entry * entry;
            b[3 * limb + k][lane] = size * entry;
        }
        const double terms = radius * radius + length * length;
        const double residual = fabs(square - terms) / (square + terms);
        all = residual <= RESIDUAL ? all : 0.0;
        e[limb][lane] = size * extension;
    }
    holds[lane] = all;
}

static void complete_lanes(const struct lanes *in, double out[MODE_NUMBERS][LANES])
{
    double(*rotation)[LANES] = out, (*n)[LANES] = out + 9, (*b)[LANES] = out + 18;
    double(*e)[LANES] = out + 27;
    SIMD
    for (int lane = 0; lane < LANES; ++lane)
        original(in, n, lane);
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        const double e_1 = fitted(in, n, 0, lane), e_2 = fitted(in, n, 1, lane);
        const double e_3 = fitted(in, n, 2, lane);
        const double sign = listed_sign(e_1, e_2, e_3);
        e[0][lane] = sign * e_1;
        e[1][lane] = sign * e_2;
        e[2][lane] = sign * e_3;
        for (int k = 0; k < 9; ++k)
            n[k][lane] *= sign;
    }
    SIMD
    for (int lane = 0; lane < LANES; ++lane)
        rotation_from_directions_body(LANES, n[0] + lane, n[3] + lane, rotation[0] + lane);
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        const int feasible = (e[0][lane] > 0.0) & (e[1][lane] > 0.0) & (e[2][lane] > 0.0);
        place_joints(in, n, e, b, out[31], lane);
        out[30][lane] = leg_angle(b[1][lane], b[2][lane]) + (feasible ? 8.0 : 0.0);
    }
}

/* Complete modes that are given by their directions, LANES at once. */
static void complete(
    const struct row *rows, const struct found *found, size_t count, struct mode *modes)
{
    ALIGNED struct lanes in;
    ALIGNED double out[MODE_NUMBERS][LANES];
    for (size_t start = 0; start < count; start += LANES) {
        const int used = count - start < LANES ? (int)(count - start) : LANES;
        for (int lane = 0; lane < LANES; ++lane) {
            const struct found *own = found + start + (lane < used ? lane : used - 1);
            const struct row *row = rows + own->row;
            for (int k = 0; k < 6; ++k)
                in.found[k][lane] = own->directions[k];
            in.found[6][lane] = own->distance;
            in.base[lane] = own->base;
            in.row[0][lane] = row->radius;
            for (int k = 0; k < 3; ++k) {
                in.row[1 + k][lane] = row->position[k];
                in.row[4 + k][lane] = row->lengths[k];
            }
            in.size[lane] = row->size;
        }
        complete_lanes(&in, out);
        for (int lane = 0; lane < used; ++lane) {
            double *to = (double *)(modes + start + lane);
            for (size_t k = 0; k < MODE_NUMBERS; ++k)
                to[k] = out[k][lane];
        }
    }
}

/* Whether a mode is listed before another. */
static int before(const struct mode *one, const struct mode *other)
{
    if (one->rank != other->rank)
        return one->rank > other->rank;
    double angle[2];
    for (int k = 0; k < 2; ++k) {
        const double *b = (k ? other : one)->platform_joints + 3;
        angle[k] = leg_angle(-0.5 * b[1] - SQRT3_2 * b[0], b[2]);
    }
    return angle[0] > angle[1];
}

#endif
