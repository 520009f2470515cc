/* SPDX-License-Identifier: BSD-3-Clause */
/* What the solver knows beforehand: samples on the circle, harmonics, Bernstein's basis.

   circle.py and isolate.py say what all this is for. The eliminant is a trigonometric
   polynomial f of psi. Here it is written in phi = psi - OFFSET cells, so that cell i is
   from i to i + 1 cells in phi: a quarter turn takes cells to cells, and so does phi -> -phi.
   That leaves 8 of the 64 cells to be tabulated. */
#ifndef KLEINFORM_TABLES_H
#define KLEINFORM_TABLES_H

#define PI 3.14159265358979323846

/* Degree of the eliminant, and its samples: two more than needed, which show the rounding. */
#define DEGREE 16
#define SAMPLES (2 * DEGREE + 4)
/* Samples, and as many sums over them, padded to whole registers. */
#define PADDED 40

/* Degree of the local polynomials. */
#define LOCAL 14
#define CELLS 64
/* Cells that are tabulated; the others come from them by quarter turns and reflections. */
#define BASE_CELLS 8
#define CELL (2.0 * PI / CELLS)
/* Zeros at multiples of 30 degrees should not lie on edges of cells. */
#define OFFSET 0.37

/* Where the coefficients of a polynomial are: those of cosines and those of sines, by the
   harmonic modulo 4, because a quarter turn treats these alike. */
#define COSINES_0 0 /* 0, 4, 8, 12, 16 */
#define SINES_0 5   /* 4, 8, 12, 16 */
#define COSINES_2 9 /* 2, 6, 10, 14 */
#define SINES_2 13
#define COSINES_1 17 /* 1, 3, ..., 15 */
#define SINES_1 25
#define COEFFICIENTS 33
/* And behind them the harmonics above the degree: cosine and sine of 17, cosine of 18. */
#define SURPLUS 3

struct tables {
    /* psi of the samples. */
    double half_cosine[PADDED], half_sine[PADDED];
    /* From a sample to all coefficients, and to the harmonics that should be zero. */
    double harmonics[SAMPLES][PADDED];
    /* From coefficients to Bernstein coefficients on cells 0 to 7. */
    double cells[LOCAL + 1][COEFFICIENTS][BASE_CELLS];
    double binomials[LOCAL + 1];
    /* Half of psi in the middle of each cell. */
    double middle_cosine[CELLS], middle_sine[CELLS];
};

extern struct tables kleinform_tables;

/* To be called once, before anything is solved. */
void kleinform_fill_tables(void);

#endif
