/* SPDX-License-Identifier: BSD-3-Clause */
#include "tables.h"

#include <math.h>

struct tables kleinform_tables;

/* The harmonic of a coefficient, and whether it is a sine. */
static int harmonic_of(int coefficient, int *is_sine)
{
    static const struct {
        int start, first, step, is_sine;
    } groups[] = {
        {COSINES_0, 0, 4, 0}, {SINES_0, 4, 4, 1}, {COSINES_2, 2, 4, 0}, {SINES_2, 2, 4, 1},
        {COSINES_1, 1, 2, 0}, {SINES_1, 1, 2, 1}, {COEFFICIENTS, DEGREE + 1, 1, 0},
    };
    int group = 0;
    while (group < 6 && coefficient >= groups[group + 1].start)
        ++group;
    *is_sine = groups[group].is_sine;
    return groups[group].first + groups[group].step * (coefficient - groups[group].start);
}

static void fill_samples(struct tables *tables)
{
    /* The padding repeats the first sample, so that nothing odd is computed there. */
    for (int k = 0; k < PADDED; ++k) {
        const double half = PI * (k < SAMPLES ? k : 0) / SAMPLES;
        tables->half_cosine[k] = cos(half);
        tables->half_sine[k] = sin(half);
    }
}

/* Angle of harmonic h at sample k, reduced before it is rounded. */
static double phase_of(int harmonic, int sample)
{
    return 2.0 * PI * ((harmonic * sample) % SAMPLES) / SAMPLES;
}

static void fill_harmonics(struct tables *tables)
{
    for (int k = 0; k < SAMPLES; ++k) {
        double *sums = tables->harmonics[k];
        for (int i = 0; i < PADDED; ++i)
            sums[i] = 0.0;
        for (int i = 0; i < COEFFICIENTS; ++i) {
            int is_sine;
            const int harmonic = harmonic_of(i, &is_sine);
            const double angle = phase_of(harmonic, k) - harmonic * (OFFSET * CELL);
            const double scale = (harmonic ? 2.0 : 1.0) / SAMPLES;
            sums[i] = scale * (is_sine ? sin(angle) : cos(angle));
        }
        sums[COEFFICIENTS] = cos(phase_of(DEGREE + 1, k)) / SAMPLES;
        sums[COEFFICIENTS + 1] = sin(phase_of(DEGREE + 1, k)) / SAMPLES;
        sums[COEFFICIENTS + 2] = (k % 2 ? -1.0 : 1.0) / SAMPLES;
    }
}

static void fill_binomials(struct tables *tables)
{
    tables->binomials[0] = 1.0;
    for (int k = 1; k <= LOCAL; ++k)
        tables->binomials[k] = tables->binomials[k - 1] * (LOCAL - k + 1) / k;
}

/* Row by row the Bernstein coefficients of x^power on [-1, 1]: those of t^power in
   (1 + t)^i (1 - t)^(LOCAL - i), whole numbers, over binomials. */
static void bernstein_of_powers(const double *binomials, double basis[][LOCAL + 1])
{
    for (int i = 0; i <= LOCAL; ++i) {
        long product[LOCAL + 1] = {1};
        for (int factor = 0; factor < LOCAL; ++factor)
            for (int k = LOCAL; k > 0; --k)
                product[k] += (factor < i ? 1 : -1) * product[k - 1];
        for (int power = 0; power <= LOCAL; ++power)
            basis[power][i] = (double)product[power] / binomials[power];
    }
}

/* Coefficients of powers of x, from -1 to 1 on a cell, of a cosine or sine. */
static void taylor(int harmonic, int is_sine, double middle, double *powers)
{
    const double angle = harmonic * middle;
    double scale = 1.0;
    for (int power = 0; power <= LOCAL; ++power) {
        /* Each derivative adds 90 degrees, and a sine is a cosine 270 degrees ahead. */
        const int quarter = (power + (is_sine ? 3 : 0)) % 4;
        const double wave = quarter % 2 ? sin(angle) : cos(angle);
        powers[power] = (quarter == 1 || quarter == 2 ? -scale : scale) * wave;
        scale *= 0.5 * CELL * harmonic / (power + 1);
    }
}

static void fill_cells(struct tables *tables)
{
    double basis[LOCAL + 1][LOCAL + 1], powers[LOCAL + 1];
    bernstein_of_powers(tables->binomials, basis);
    for (int c = 0; c < COEFFICIENTS; ++c)
        for (int cell = 0; cell < BASE_CELLS; ++cell) {
            int is_sine;
            const int harmonic = harmonic_of(c, &is_sine);
            taylor(harmonic, is_sine, (cell + 0.5) * CELL, powers);
            for (int i = 0; i <= LOCAL; ++i) {
                double sum = 0.0;
                for (int power = LOCAL; power >= 0; --power)
                    sum += powers[power] * basis[power][i];
                tables->cells[i][c][cell] = sum;
            }
        }
}

static void fill_middles(struct tables *tables)
{
    for (int cell = 0; cell < CELLS; ++cell) {
        const double half = 0.5 * (cell + OFFSET + 0.5) * CELL;
        tables->middle_cosine[cell] = cos(half);
        tables->middle_sine[cell] = sin(half);
    }
}

void kleinform_fill_tables(void)
{
    struct tables *tables = &kleinform_tables;
    fill_samples(tables);
    fill_harmonics(tables);
    fill_binomials(tables);
    fill_cells(tables);
    fill_middles(tables);
}
