"""Polynomials of degree three in x, y, z by their coefficients: values, and division by a plane.

The coefficients are at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z,
yz², z³; those of a lower degree are the first of these.
"""

from __future__ import annotations

from itertools import combinations_with_replacement, permutations

import numpy as np
from numpy.typing import NDArray

__all__ = ["DEGREES", "cube", "division", "points_of", "tensor_of"]

Array = NDArray[np.float64]

#: The factors 1, x, y, z (as 0, 1, 2, 3) of each monomial, in the order of the coefficients.
FACTORS = [
    (0,) * (3 - degree) + places
    for degree in range(4)
    for places in combinations_with_replacement((1, 2, 3), degree)
]
DEGREES = np.array([sum(place > 0 for place in factors) for factors in FACTORS])
#: How many monomials there are up to a degree.
COUNTS = (1, 4, 10, 20)


def points_of(position: Array) -> Array:
    """(1, x, y, z) (..., 4) of positions (..., 3)."""
    return np.concatenate([np.ones_like(position[..., :1]), position], axis=-1)


def cube(tensor: Array, points: Array) -> Array:
    """The product of a tensor (4, 4, 4) with points (..., 4), three times."""
    once = np.einsum("abc,...a->...bc", tensor, points)
    twice = np.einsum("...bc,...b->...c", once, points)
    found: Array = (twice * points).sum(axis=-1)
    return found


def tensor_of(coefficients: Array) -> Array:
    """Symmetric, (4, 4, 4): the polynomial is its product with (1, x, y, z) three times."""
    tensor = np.zeros((4, 4, 4))
    for factors, coefficient in zip(FACTORS, coefficients, strict=True):
        places = set(permutations(factors))
        for place in places:
            tensor[place] = coefficient / len(places)
    return tensor


def division(coefficients: Array, plane: Array) -> tuple[Array, Array]:
    """Quotient by a plane and what is left, by least squares: nothing if the plane divides."""
    degree = COUNTS.index(len(coefficients))
    products = np.zeros((len(coefficients), COUNTS[degree - 1]))
    numbers = {tuple(sorted(filter(None, factors))): row for row, factors in enumerate(FACTORS)}
    for factors, column in list(numbers.items())[: products.shape[1]]:
        for place, entry in enumerate(plane):
            products[numbers[tuple(sorted(filter(None, (*factors, place))))], column] += entry
    quotient = np.asarray(np.linalg.lstsq(products, coefficients, rcond=None)[0], dtype=np.float64)
    return quotient, coefficients - products @ quotient
