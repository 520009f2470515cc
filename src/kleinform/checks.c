/* SPDX-License-Identifier: BSD-3-Clause */
#include "checks.h"

#include <math.h>
#include <string.h>

#include "simd.h"

#define KLEINFORM_API static inline
#define KLEINFORM_BODY INLINE
#include "kernels.c"

/* Numbers that are looked at before a loop may end early. */
#define CHUNK 4096
/* Poses that are looked at together: if none of them is singular, none is looked at alone. */
#define FEW 64

INLINE size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

static int sized(const double *numbers, size_t count, double smallest, double largest)
{
    for (size_t start = 0; start < count; start += CHUNK) {
        const double *chunk = numbers + start;
        const size_t length = smaller(CHUNK, count - start);
        int bad = 0;
#pragma omp simd reduction(| : bad)
        for (size_t k = 0; k < length; ++k) {
            const double size = fabs(chunk[k]);
            /* A comparison with NaN is false. */
            bad |= !(size <= largest) | ((size < smallest) & (size != 0.0));
        }
        if (bad)
            return 0;
    }
    return 1;
}

/* Whether LANES matrices are rotations; `count` of them are there, the last one repeated. */
INLINE int lanes_are_rotations(const double *matrices, size_t count, double allowed)
{
    ALIGNED double entries[9 * LANES];
    ALIGNED double defect[LANES];
    int bad = 0;
    for (size_t lane = 0; lane < LANES; ++lane)
        for (size_t k = 0; k < 9; ++k)
            entries[k * LANES + lane] = matrices[9 * smaller(lane, count - 1) + k];
    SIMD
    for (size_t lane = 0; lane < LANES; ++lane)
        rotation_defect_body(LANES, entries + lane, defect + lane);
    for (size_t lane = 0; lane < LANES; ++lane)
        bad |= !(defect[lane] <= allowed);
    return !bad;
}

static int rotations(const double *matrices, size_t count, double allowed)
{
    size_t start = 0;
    for (; start + LANES <= count; start += LANES)
        if (!lanes_are_rotations(matrices + 9 * start, LANES, allowed))
            return 0;
    return start == count || lanes_are_rotations(matrices + 9 * start, count - start, allowed);
}

/* Rows of `width` numbers, a scale each, `step` numbers from one to the next. */
INLINE int rows_none_zero(
    const double *numbers, size_t rows, const double *scales, size_t step, size_t width,
    double factor)
{
    int zero = 0;
#pragma omp simd reduction(| : zero)
    for (size_t row = 0; row < rows; ++row)
        for (size_t k = 0; k < width; ++k) {
            const double size = fabs(numbers[row * width + k]);
            zero |= (size <= factor * scales[row * step]) & (size < INFINITY);
        }
    return !zero;
}

static int none_zero(
    const double *numbers, size_t rows, const double *scales, size_t step, size_t width,
    double factor)
{
    /* The widths that occur, so that compilers know them. */
    if (width == 1)
        return rows_none_zero(numbers, rows, scales, step, 1, factor);
    if (width == 3)
        return rows_none_zero(numbers, rows, scales, step, 3, factor);
    return rows_none_zero(numbers, rows, scales, step, width, factor);
}

/* The rule of zero.py: whether a size is finite and zero within its rounding. */
INLINE unsigned within(double size, double scale, double factor)
{
    return (size <= factor * scale) & (size < INFINITY);
}

/* Whether the value of this index is. */
INLINE unsigned vanishes(struct factor of, size_t index, double factor)
{
    return within(fabs(of.values[index]), of.scales[index], factor);
}

/* The same rules as those of codes.by_numpy, to the bit. */
static uint8_t class_of(const struct survey *survey, size_t pose, double factor)
{
    const double *joints = survey->joints + 6 * pose;
    const double reach = survey->radius[pose * survey->radius_step] + 2.0 * joints[5];
    unsigned undirected = 0, parallel = 0, extended = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t at = 3 * pose + i;
        const double incidence = fabs(survey->incidence[at]);
        const unsigned line_parallel = within(incidence, 1.0, factor);
        undirected |= within(joints[i] * incidence, reach, factor);
        parallel |= line_parallel;
        extended |= vanishes(survey->extension, at, factor) & !line_parallel;
    }
    undirected |= parallel;
    const unsigned inverse = parallel | vanishes(survey->central, pose, factor);
    const unsigned direct = extended | (vanishes(survey->orientation, pose, factor) & !undirected);
    const unsigned wrist = vanishes(survey->wrist, pose, factor);
    return (uint8_t)(inverse * INVERSE + direct * DIRECT + wrist * WRIST + undirected * LIMB);
}

/* Whether all values from an index on are surely not zero; NaN and inf are not sure. */
INLINE int surely_none_zero(struct factor of, size_t first, size_t count, double factor)
{
    const double *values = of.values + first, *scales = of.scales + first;
    int zero = 0;
#pragma omp simd reduction(| : zero)
    for (size_t k = 0; k < count; ++k)
        zero |= !(fabs(values[k]) > factor * scales[k]);
    return !zero;
}

/* Whether surely no outer leg of poses from an index on has a length or n_i·u_i of zero. */
INLINE int surely_no_leg_zero(
    const struct survey *survey, size_t first, size_t count, size_t radius_step, double factor)
{
    const double *joints = survey->joints + 6 * first, *radius = survey->radius;
    const double *incidence = survey->incidence + 3 * first;
    int zero = 0;
#pragma omp simd reduction(| : zero)
    for (size_t pose = 0; pose < count; ++pose) {
        const double allowed =
            factor * (radius[(first + pose) * radius_step] + 2.0 * joints[6 * pose + 5]);
        for (size_t i = 0; i < 3; ++i) {
            const double size = fabs(incidence[3 * pose + i]);
            zero |= !(size > factor) | !(joints[6 * pose + i] * size > allowed);
        }
    }
    return !zero;
}

static int surely_regular(const struct survey *survey, size_t first, size_t count, double factor)
{
    return surely_none_zero(survey->extension, 3 * first, 3 * count, factor) &&
           surely_none_zero(survey->central, first, count, factor) &&
           surely_none_zero(survey->wrist, first, count, factor) &&
           surely_none_zero(survey->orientation, first, count, factor) &&
           (survey->radius_step ? surely_no_leg_zero(survey, first, count, 1, factor)
                                : surely_no_leg_zero(survey, first, count, 0, factor));
}

static void classes(const struct survey *survey, size_t poses, double factor, uint8_t *codes)
{
    for (size_t first = 0; first < poses; first += FEW) {
        const size_t count = smaller(FEW, poses - first);
        if (surely_regular(survey, first, count, factor))
            memset(codes + first, 0, count);
        else
            for (size_t pose = first; pose < first + count; ++pose)
                codes[pose] = class_of(survey, pose, factor);
    }
}

const struct checks VARIANT_OF(kleinform_checks) = {sized, rotations, none_zero, classes};
