"""atan2 as a straight line of C, without branches, so that it runs on several poses at once.

A quotient ``t`` with ``|t| <= tan(π/8)`` and a multiple of π/4 make the angle. With ``z = t²``,
``atan(t) = t + t z p(z)``: the polynomial p interpolates at Chebyshev's points in 50 digits
and is then rounded to float64.
"""

from __future__ import annotations

from mpmath import atan, chebyfit, frexp, ldexp, mpf, nint, pi, sqrt, tan, workdps

__all__ = ["print_atan2"]

TERMS = 11
#: What p may add to the relative error of atan(t): a fortieth of the rounding of float64.
ALLOWED = 6e-18

TEXT = """\
/* The angle of (x, y) in [-pi, pi] [rad], within 3 ulp; signed zeros, inf and NaN as in libm.
   Not for |x| + |y| that overflows, nor for x and y that are both subnormal. */
KLEINFORM_BODY double angle_of(double y, double x)
{{
    const double across = fabs(x), along = fabs(y);
    const double low = along < across ? along : across;
    const double high = along < across ? across : along;
    const int steep = (low > {tangent} * high) | ((low == high) & (high > 0.0));
    const double difference = low == high ? 0.0 : low - high;
    const double over = steep ? difference : low;
    const double under = steep ? low + high : (high == 0.0 ? 1.0 : high);
    const double t = over / under;
    const double z = t * t;
    const double p = {polynomial};
    const double first = t + t * (z * p);
    const double eighths = steep ? 1.0 : 0.0;
    const double second = along > across ? -first : first;
    const double quarters = along > across ? 2.0 - eighths : eighths;
    const double third = copysign(1.0, x) < 0.0 ? -second : second;
    const double halves = copysign(1.0, x) < 0.0 ? 4.0 - quarters : quarters;
    /* pi/4 in two parts, the first of so few bits that its multiples are exact. */
    return copysign(halves * {quarter} + (third + halves * {rest}), y);
}}"""


def print_atan2() -> str:
    """The C function ``angle_of(y, x)``."""
    with workdps(50):
        coefficients, error = chebyfit(_remainder, [0, tan(pi / 8) ** 2], TERMS, error=True)
        if error * tan(pi / 8) ** 2 > ALLOWED:
            raise ArithmeticError(f"{TERMS} terms leave an error of {error} in atan")
        quarter = _leading_bits(pi / 4, 50)
        polynomial = repr(float(coefficients[0]))
        for coefficient in coefficients[1:]:
            polynomial = f"({polynomial} * z + {float(coefficient)!r})"
        return TEXT.format(
            tangent=repr(float(tan(pi / 8))),
            polynomial=polynomial.replace("+ -", "- "),
            quarter=repr(float(quarter)),
            rest=repr(float(pi / 4 - quarter)),
        )


def _remainder(z: mpf) -> mpf:
    """(atan(t)/t − 1)/z at t = √z."""
    if z == 0:
        return mpf(-1) / 3
    t = sqrt(z)
    return (atan(t) / t - 1) / z


def _leading_bits(value: mpf, bits: int) -> mpf:
    exponent = frexp(value)[1]
    return ldexp(nint(ldexp(value, bits - exponent)), exponent - bits)
