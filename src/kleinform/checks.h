/* SPDX-License-Identifier: BSD-3-Clause */
/* Loops over whole batches: whether every number keeps a rule, and what vanishes in each pose. */
#ifndef KLEINFORM_CHECKS_H
#define KLEINFORM_CHECKS_H

#include <stddef.h>
#include <stdint.h>

/* Values and the scales that they are judged by, one right after the other. */
struct factor {
    const double *values;
    const double *scales;
};

/* What a survey says of poses that lie one after the other. */
struct survey {
    /* Six a pose, q6 the last of them. */
    const double *joints;
    /* Three a pose: n_i·u_i, beside 1, and the e_i. */
    const double *incidence;
    struct factor extension;
    /* One a pose. */
    struct factor central, wrist, orientation;
    /* The manipulator's radii: one for all poses (step 0) or one a pose (step 1). */
    const double *radius;
    size_t radius_step;
};

/* The bits of a code, those of PoseClass. */
enum { INVERSE = 1, DIRECT = 2, WRIST = 4, LIMB = 8 };

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
    /* A code for each pose; what is zero is so within factor times its scale. */
    void (*classes)(const struct survey *survey, size_t poses, double factor, uint8_t *codes);
};

extern const struct checks kleinform_checks_baseline;
#ifdef KLEINFORM_X86
extern const struct checks kleinform_checks_avx2;
extern const struct checks kleinform_checks_avx512;
#endif

#endif
