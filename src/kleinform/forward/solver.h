/* SPDX-License-Identifier: BSD-3-Clause */
/* All assembly modes of many joint values, where every solution is simple and sure. */
#ifndef KLEINFORM_SOLVER_H
#define KLEINFORM_SOLVER_H

#include <stddef.h>
#include <stdint.h>

/* Modes one after the other, in memory that grows; the caller frees it. */
struct modes {
    size_t count, room;
    double *rotation;        /* 9 numbers each */
    double *directions;      /* 9 */
    double *platform_joints; /* 9 */
    double *extension;       /* 3 */
};

/* Joint values as they enter the closure equations: a number, three and three a row. */
struct given {
    size_t rows;
    const double *radius, *position, *lengths;
    double tolerance;
};

/* Fill in the number of modes of each row, -1 where it was left to others, and append the
   modes. False if there is not enough memory. */
typedef int solver(const struct given *given, int64_t *count, struct modes *modes);

solver kleinform_solver_baseline;
#ifdef KLEINFORM_X86
solver kleinform_solver_avx2;
solver kleinform_solver_avx512;
#endif

#endif
