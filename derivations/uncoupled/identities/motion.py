"""Table 2: the motion from rest to rest that Example 2 takes."""

from __future__ import annotations

from sympy import Matrix, symbols

from derivations.algebra.identities import Identity

TIME = symbols("s", real=True)
#: Coefficients of 1, s, ... s⁵.
QUINTIC = Matrix([0, 0, 0, 10, -15, 6])


def identities() -> list[Identity]:
    """The quintic."""
    return [
        Identity(
            "quintic from rest to rest",
            "10 s³ − 15 s⁴ + 6 s⁵ is the only quintic that goes from 0 to 1 with its first "
            "and second derivatives 0 at both ends",
            lambda: [conditions().inv() * ends() - QUINTIC],
            number="Table 2",
        )
    ]


def conditions() -> Matrix:
    """Value, first and second derivative at 0 and at 1 of each power: a regular matrix."""
    powers = [TIME**power for power in range(6)]
    return Matrix(
        [
            [power.diff(TIME, order).subs(TIME, end) for power in powers]
            for end in (0, 1)
            for order in range(3)
        ]
    )


def ends() -> Matrix:
    """0 at rest, and 1 at rest."""
    return Matrix([0, 0, 0, 1, 0, 0])
