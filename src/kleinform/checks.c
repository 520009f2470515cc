/* SPDX-License-Identifier: BSD-3-Clause */
#include "checks.h"

#include <math.h>

#include "simd.h"

#define KLEINFORM_API static inline
#define KLEINFORM_BODY INLINE
#include "kernels.c"

/* Numbers that are looked at before a loop may end early. */
#define CHUNK 4096

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

const struct checks VARIANT_OF(kleinform_checks) = {sized, rotations, none_zero};
