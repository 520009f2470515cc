/* SPDX-License-Identifier: BSD-3-Clause */
/* Loops over whole batches that say whether every number keeps a rule. */
#ifndef KLEINFORM_CHECKS_H
#define KLEINFORM_CHECKS_H

#include <stddef.h>

struct checks {
    /* Every number is 0 or of a size between smallest and largest; NaN and inf are not. */
    int (*sized)(const double *numbers, size_t count, double smallest, double largest);
    /* Every 3x3 matrix, its rows one after the other, is a rotation within a defect. */
    int (*rotations)(const double *matrices, size_t count, double defect);
    /* No number is finite and within factor times its scale of 0: rows of `width` numbers, a
       scale each, `step` numbers from one scale to the next. */
    int (*none_zero)(
        const double *numbers, size_t rows, const double *scales, size_t step, size_t width,
        double factor);
};

extern const struct checks kleinform_checks_baseline;
#ifdef KLEINFORM_X86
extern const struct checks kleinform_checks_avx2;
extern const struct checks kleinform_checks_avx512;
#endif

#endif
