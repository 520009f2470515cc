/* SPDX-License-Identifier: BSD-3-Clause */
/* All real zeros of the eliminants of a block of rows, none missed: isolate.py, in lanes. */
#ifndef KLEINFORM_ISOLATE_H
#define KLEINFORM_ISOLATE_H

#include <math.h>
#include <stddef.h>

#include "simd.h"
#include "tables.h"

/* Rows of a block: as many as the padded samples, because the kernels know one stride. */
#define ROWS PADDED
/* Zeros of a row: as many as the degree allows. */
#define MOST_ZEROS (2 * DEGREE)
/* Cells that stay open after so many halvings are clusters, as in isolate.py; more of them in a
   row than this come from rounding, and another limb may do better. */
#define HALVINGS 6
#define MOST_CLUSTERS 6
/* A cluster is halved further, at most to this level, because a fold is left to others. */
#define DEEPEST 9
#define REFINEMENTS 3

enum verdict { EMPTY, SIMPLE, OPEN };

/* Cells with just one zero. Places are in cells, from the low edge of the whole cell. */
struct zeros {
    size_t count;
    int row[ROWS * MOST_ZEROS];
    int cell[ROWS * MOST_ZEROS];
    double low[ROWS * MOST_ZEROS];
    double width[ROWS * MOST_ZEROS];
    double local[ROWS * MOST_ZEROS / LANES][LOCAL + 1][LANES];
};

/* A cell, or a part of it, of which nothing is known yet. */
struct part {
    double local[LOCAL + 1];
    double low, width, rounding;
    int row, cell, level;
};

/* All cells of a block, and as the last part comes first, a few batches of halves. */
#define MOST_PARTS (ROWS * CELLS + DEEPEST * LANES)

struct isolation {
    struct zeros zeros;
    size_t parts;
    struct part part[MOST_PARTS];
    /* The zeros of each row, by number, and the rows that were given up. */
    int count[ROWS];
    int zero[ROWS][MOST_ZEROS];
    int failed[ROWS];
    int clusters[ROWS];
    /* The level to which each row is halved, and rows with cells that stayed open there. */
    int deepest[ROWS];
    int folded[ROWS];
};

INLINE double dot(const double *weights, const double *values, int count)
{
    double sum = weights[0] * values[0];
    for (int k = 1; k < count; ++k)
        sum += weights[k] * values[k * BASE_CELLS];
    return sum;
}

/* Bernstein coefficients on all cells: span s has cells 8 s to 8 s + 7, the odd ones
   backwards, because they are mirror images. */
static void local_polynomials(
    const double *RESTRICT c, double local[CELLS / BASE_CELLS][LOCAL + 1][BASE_CELLS])
{
    /* The odd harmonics, a quarter turn ahead. */
    double cosines[8], sines[8];
    for (int k = 0; k < 8; ++k) {
        cosines[k] = k % 2 ? -c[SINES_1 + k] : c[SINES_1 + k];
        sines[k] = k % 2 ? c[COSINES_1 + k] : -c[COSINES_1 + k];
    }
    for (int i = 0; i <= LOCAL; ++i) {
        const double(*t)[BASE_CELLS] = kleinform_tables.cells[i];
        const int back = LOCAL - i;
        SIMD
        for (int cell = 0; cell < BASE_CELLS; ++cell) {
            const double cosine_0 = dot(c + COSINES_0, t[COSINES_0] + cell, 5);
            const double cosine_2 = dot(c + COSINES_2, t[COSINES_2] + cell, 4);
            const double cosine_1 = dot(c + COSINES_1, t[COSINES_1] + cell, 8);
            const double cosine_3 = dot(cosines, t[COSINES_1] + cell, 8);
            const double sine_0 = dot(c + SINES_0, t[SINES_0] + cell, 4);
            const double sine_2 = dot(c + SINES_2, t[SINES_2] + cell, 4);
            const double sine_1 = dot(c + SINES_1, t[SINES_1] + cell, 8);
            const double sine_3 = dot(sines, t[SINES_1] + cell, 8);
            const double same_cosine = cosine_0 + cosine_2, same_sine = sine_0 + sine_2;
            const double other_cosine = cosine_0 - cosine_2, other_sine = sine_0 - sine_2;
            const double even[4] = {same_cosine + cosine_1, other_cosine + cosine_3,
                                    same_cosine - cosine_1, other_cosine - cosine_3};
            const double odd[4] = {same_sine + sine_1, other_sine + sine_3,
                                   same_sine - sine_1, other_sine - sine_3};
            local[0][i][cell] = even[0] + odd[0];
            local[1][back][cell] = even[1] - odd[1];
            local[2][i][cell] = even[1] + odd[1];
            local[3][back][cell] = even[2] - odd[2];
            local[4][i][cell] = even[2] + odd[2];
            local[5][back][cell] = even[3] - odd[3];
            local[6][i][cell] = even[3] + odd[3];
            local[7][back][cell] = even[0] - odd[0];
        }
    }
}

/* No change of sign proves that there is no zero, one that there is just one; coefficients
   within rounding of zero prove nothing. */
INLINE double judged(const double *local, int stride, double rounding)
{
    double changes = 0.0, least = fabs(local[0]);
    for (int i = 1; i <= LOCAL; ++i) {
        const double before = local[(i - 1) * stride], after = local[i * stride];
        changes += (before > 0.0) != (after > 0.0) ? 1.0 : 0.0;
        least = fabs(after) < least ? fabs(after) : least;
    }
    const double open = changes > 1.0 ? (double)OPEN : changes;
    return least <= rounding ? (double)OPEN : open;
}

static void add_zero(
    struct isolation *found, int row, int cell, double low, double width,
    const double *local, int stride)
{
    struct zeros *zeros = &found->zeros;
    if (found->count[row] == MOST_ZEROS) {
        found->failed[row] = 1;
        return;
    }
    const size_t number = zeros->count++;
    found->zero[row][found->count[row]++] = (int)number;
    zeros->row[number] = row;
    zeros->cell[number] = cell;
    zeros->low[number] = low;
    zeros->width[number] = width;
    double(*to)[LANES] = zeros->local[number / LANES];
    for (int i = 0; i <= LOCAL; ++i)
        to[i][number % LANES] = local[i * stride];
}

static void add_part(
    struct isolation *found, int row, int cell, int level, double low, double rounding,
    const double *local, int stride)
{
    if (found->parts == MOST_PARTS) {
        found->failed[row] = 1;
        return;
    }
    struct part *part = found->part + found->parts++;
    part->row = row;
    part->cell = cell;
    part->level = level;
    part->low = low;
    part->rounding = rounding;
    part->width = 1.0 / (double)(1 << level);
    for (int i = 0; i <= LOCAL; ++i)
        part->local[i] = local[i * stride];
}

/* The cells of one row: those with one zero are noted, and those that must be halved. */
static void isolate_row(
    struct isolation *found, int row, const double *coefficients, double rounding)
{
    ALIGNED double local[CELLS / BASE_CELLS][LOCAL + 1][BASE_CELLS];
    ALIGNED double verdicts[CELLS];
    int kept[CELLS], count = 0;
    local_polynomials(coefficients, local);
    for (int span = 0; span < CELLS / BASE_CELLS; ++span) {
        SIMD
        for (int lane = 0; lane < BASE_CELLS; ++lane)
            verdicts[span * BASE_CELLS + lane] =
                judged(&local[span][0][lane], BASE_CELLS, rounding);
    }
    for (int k = 0; k < CELLS; ++k) {
        kept[count] = k;
        count += verdicts[k] > (double)EMPTY;
    }
    for (int k = 0; k < count; ++k) {
        const int span = kept[k] / BASE_CELLS, lane = kept[k] % BASE_CELLS;
        const int cell = span * BASE_CELLS + (span % 2 ? BASE_CELLS - 1 - lane : lane);
        const double *own = &local[span][0][lane];
        if (verdicts[kept[k]] == (double)SIMPLE)
            add_zero(found, row, cell, 0.0, 1.0, own, BASE_CELLS);
        else
            add_part(found, row, cell, 0, 0.0, rounding, own, BASE_CELLS);
    }
}

/* De Casteljau's subdivision at the middle. What is halved ends as the right half. */
static void halve(double whole[LOCAL + 1][LANES], double left[LOCAL + 1][LANES])
{
    for (int step = 0; step < LOCAL; ++step) {
        SIMD
        for (int lane = 0; lane < LANES; ++lane)
            left[step][lane] = whole[0][lane];
        for (int i = 0; i < LOCAL - step; ++i) {
            SIMD
            for (int lane = 0; lane < LANES; ++lane)
                whole[i][lane] = 0.5 * (whole[i + 1][lane] + whole[i][lane]);
        }
    }
    SIMD
    for (int lane = 0; lane < LANES; ++lane)
        left[LOCAL][lane] = whole[0][lane];
}

/* One half of a part, after it was judged. */
static void sort_in(
    struct isolation *found, const struct part *part, double low, const double *local,
    double verdict)
{
    const int level = part->level + 1, row = part->row;
    if (verdict == (double)EMPTY || found->failed[row])
        return;
    if (verdict == (double)SIMPLE) {
        add_zero(found, row, part->cell, low, 0.5 * part->width, local, LANES);
        return;
    }
    if (level == HALVINGS && ++found->clusters[row] > MOST_CLUSTERS)
        found->failed[row] = 1;
    else if (level < found->deepest[row])
        add_part(found, row, part->cell, level, low, part->rounding, local, LANES);
    else
        found->folded[row] = 1;
}

/* Halve LANES parts at once, until none is left. */
static void isolate_parts(struct isolation *found)
{
    ALIGNED double left[LOCAL + 1][LANES], right[LOCAL + 1][LANES];
    ALIGNED double rounding[LANES], left_verdict[LANES], right_verdict[LANES];
    struct part taken[LANES];
    while (found->parts) {
        int count = 0;
        while (found->parts && count < LANES) {
            taken[count] = found->part[--found->parts];
            count += !found->failed[taken[count].row];
        }
        if (!count)
            break;
        for (int lane = 0; lane < LANES; ++lane) {
            const struct part *part = taken + (lane < count ? lane : count - 1);
            for (int i = 0; i <= LOCAL; ++i)
                right[i][lane] = part->local[i];
            rounding[lane] = part->rounding;
        }
        halve(right, left);
        SIMD
        for (int lane = 0; lane < LANES; ++lane) {
            left_verdict[lane] = judged(&left[0][lane], LANES, rounding[lane]);
            right_verdict[lane] = judged(&right[0][lane], LANES, rounding[lane]);
        }
        for (int k = 0; k < count; ++k) {
            const struct part *part = taken + k;
            const double middle = part->low + 0.5 * part->width;
            sort_in(found, part, part->low, &left[0][k], left_verdict[k]);
            sort_in(found, part, middle, &right[0][k], right_verdict[k]);
        }
    }
}

/* Coefficients of powers: differences, times binomials. */
static void to_powers(const double local[LOCAL + 1][LANES], double power[LOCAL + 1][LANES])
{
    memcpy(power, local, (LOCAL + 1) * sizeof *power);
    for (int order = 1; order <= LOCAL; ++order)
        for (int i = LOCAL; i >= order; --i) {
            SIMD
            for (int lane = 0; lane < LANES; ++lane)
                power[i][lane] -= power[i - 1][lane];
        }
    for (int i = 0; i <= LOCAL; ++i) {
        SIMD
        for (int lane = 0; lane < LANES; ++lane)
            power[i][lane] *= kleinform_tables.binomials[i];
    }
}

/* Where the control polygon of a polynomial crosses zero. */
INLINE double crossed(const double *local, double sign)
{
    double before = local[(LOCAL - 1) * LANES], after = local[LOCAL * LANES];
    double first = LOCAL - 1;
    for (int i = LOCAL - 2; i >= 0; --i) {
        const int there = sign * local[(i + 1) * LANES] > 0.0;
        before = there ? local[i * LANES] : before;
        after = there ? local[(i + 1) * LANES] : after;
        first = there ? (double)i : first;
    }
    return (first + before / (before - after)) / LOCAL;
}

/* The zero of polynomials on [0, 1] that change their sign once, by safeguarded Newton. */
static void crossing(const double local[LOCAL + 1][LANES], double *RESTRICT place)
{
    ALIGNED double power[LOCAL + 1][LANES], sign[LANES], low[LANES], high[LANES];
    to_powers(local, power);
    SIMD
    for (int lane = 0; lane < LANES; ++lane) {
        sign[lane] = local[LOCAL][lane] > local[0][lane] ? 1.0 : -1.0;
        low[lane] = 0.0;
        high[lane] = 1.0;
        place[lane] = crossed(&local[0][lane], sign[lane]);
    }
    for (int round = 0; round < REFINEMENTS; ++round) {
        SIMD
        for (int lane = 0; lane < LANES; ++lane) {
            const double at = place[lane];
            double value = 0.0, slope = 0.0;
            for (int i = LOCAL; i >= 0; --i) {
                slope = slope * at + value;
                value = value * at + power[i][lane];
            }
            const int above = sign[lane] * value > 0.0;
            const double step = at - value / slope;
            high[lane] = above ? at : high[lane];
            low[lane] = above ? low[lane] : at;
            const int inside = (step >= low[lane]) & (step <= high[lane]);
            place[lane] = inside ? step : 0.5 * (low[lane] + high[lane]);
        }
    }
}

#endif
