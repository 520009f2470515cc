/* SPDX-License-Identifier: BSD-3-Clause */
/* One step of a velocity controller: from the pose and a wanted twist to joint values and rates.

   Copy kernels.h and kernels.c beside this file, or say where they are:

   cc -std=c99 -O2 -Igenerated/kleinform_kernels/uncoupled examples/controller.c \
      generated/kleinform_kernels/uncoupled/kernels.c -lm -o controller && ./controller */
#include <math.h>
#include <stdio.h>

#include "kernels.h"

int main(void)
{
    const double pi = 3.14159265358979323846;
    const double a = 1.0;                                  /* radius of the base circle [m] */
    const double c[3] = {0.25, 0.2, 1.0};                  /* position of C [m] */
    const double twist[6] = {0.0, 0.0, 0.1, 0.2, 0.0, 0.0}; /* [omega, v_C] [rad/s, m/s] */
    double R[9], q[6], e[3], B[9], p[3], r, rates[6], l[3], radial, length, reach;

    kleinform_rotation_from_rpy(10.0 * pi / 180.0, 3.0 * pi / 180.0, 6.0 * pi / 180.0, R);
    kleinform_inverse_displacement(a, c, R, q, e, B, p, &r);
    kleinform_inverse_velocity(a, c, R, twist, rates, p, l, &radial, &length, &reach);
    for (int j = 0; j < 6; ++j) {
        /* Nothing is checked on the way: a singular pose shows here. */
        if (!isfinite(q[j]) || !isfinite(rates[j])) {
            fprintf(stderr, "joint %d: the pose is singular\n", j + 1);
            return 1;
        }
        printf("q%d = %.17g, rate %.17g\n", j + 1, q[j], rates[j]);
    }
    return 0;
}
