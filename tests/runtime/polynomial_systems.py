"""Polynomial systems of the literature whose numbers of solutions are known."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

#: A polynomial: the coefficient of every monomial, by its exponents.
Polynomial = Mapping[tuple[int, ...], complex]


class Polynomials:
    """A square system, made homogeneous by x_0, with coefficients of order 1."""

    def __init__(self, polynomials: Iterable[Polynomial]) -> None:
        polynomials = list(polynomials)
        self.degrees = tuple(max(map(sum, terms)) for terms in polynomials)
        self.rows = np.repeat(np.arange(len(polynomials)), [len(p) for p in polynomials])
        self.exponents = np.array(
            [
                (degree - sum(powers), *powers)
                for degree, terms in zip(self.degrees, polynomials, strict=True)
                for powers in terms
            ]
        )
        self.coefficients = np.concatenate(
            [
                np.array(list(terms.values())) / max(map(abs, terms.values()))
                for terms in polynomials
            ]
        )

    @property
    def paths(self) -> int:
        return int(np.prod(self.degrees))

    def __call__(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        columns = np.arange(x.shape[1])
        powers = x[:, :, np.newaxis] ** np.arange(self.exponents.max() + 1)
        factors = powers[:, columns, self.exponents]
        lower = powers[:, columns, np.maximum(self.exponents - 1, 0)] * self.exponents
        ones = np.ones_like(factors[..., :1])
        before = np.cumprod(np.concatenate([ones, factors[..., :-1]], axis=-1), axis=-1)
        after = np.concatenate([factors[..., 1:], ones], axis=-1)
        after = np.cumprod(after[..., ::-1], axis=-1)[..., ::-1]
        terms = self.coefficients * before[..., -1] * factors[..., -1]
        derivatives = self.coefficients[:, np.newaxis] * before * lower * after
        starts = np.flatnonzero(np.diff(self.rows, prepend=-1))
        return np.add.reduceat(terms, starts, axis=1), np.add.reduceat(derivatives, starts, axis=1)


class Benchmark(NamedTuple):
    """A system and its number of finite solutions, all of them simple."""

    system: Polynomials
    solutions: int


def monomial(n: int, *variables: int) -> tuple[int, ...]:
    """Exponents of a product of variables, of n."""
    return tuple(np.bincount(np.array(variables, dtype=int), minlength=n).tolist())


def parsed(names: str, *polynomials: str) -> Polynomials:
    """A system from text: ``"2 x x y - 1"``, every sign between blanks."""
    n = len(names)

    def terms(text: str) -> Polynomial:
        found: dict[tuple[int, ...], complex] = {}
        words, sign = [*text.split(), "+"], 1.0
        coefficient, variables = 1.0, list[int]()
        for position, word in enumerate(words):
            if word in ("+", "-"):
                if position > 0:
                    key = monomial(n, *variables)
                    found[key] = found.get(key, 0.0) + sign * coefficient
                sign, coefficient, variables = (1.0 if word == "+" else -1.0), 1.0, []
            elif word in names:
                variables.append(names.index(word))
            else:
                coefficient *= float(word)
        return found

    return Polynomials(terms(text) for text in polynomials)


def katsura(n: int) -> Benchmark:
    """Magnetism: u_m = Σ u_|l| u_|m-l|, Σ u_l = 1; n + 1 unknowns, 2^n solutions."""
    equations: list[dict[tuple[int, ...], complex]] = []
    for m in range(n):
        terms: dict[tuple[int, ...], complex] = {monomial(n + 1, m): -1.0}
        for index in range(-n, n + 1):
            if abs(m - index) <= n:
                key = monomial(n + 1, abs(index), abs(m - index))
                terms[key] = terms.get(key, 0.0) + 1.0
        equations.append(terms)
    total: dict[tuple[int, ...], complex] = {monomial(n + 1, k): 2.0 for k in range(1, n + 1)}
    equations.append({**total, monomial(n + 1, 0): 1.0, monomial(n + 1): -1.0})
    return Benchmark(Polynomials(equations), 2**n)


def cyclic(n: int) -> Benchmark:
    """Cyclic roots: sums of products of k neighbours are 0, the product of all is 1."""
    equations: list[Polynomial] = [
        {monomial(n, *(np.arange(i, i + k) % n)): 1.0 for i in range(n)} for k in range(1, n)
    ]
    equations.append({monomial(n, *range(n)): 1.0, monomial(n): -1.0})
    return Benchmark(Polynomials(equations), {5: 70, 6: 156}[n])


def noon(n: int) -> Benchmark:
    """A neural network: x_i Σ x_j² - 1.1 x_i + 1, the sum over all j but i."""
    equations: list[Polynomial] = [
        {
            **{monomial(n, i, j, j): 1.0 for j in range(n) if j != i},
            monomial(n, i): -1.1,
            monomial(n): 1.0,
        }
        for i in range(n)
    ]
    return Benchmark(Polynomials(equations), 3**n - 2 * n)


def reimer(n: int) -> Benchmark:
    """2 Σ (-1)^j x_j^k = 1 for k = 2 to n + 1."""
    equations: list[Polynomial] = [
        {**{monomial(n, *[j] * k): (-1.0) ** j * 2.0 for j in range(n)}, monomial(n): -1.0}
        for k in range(2, n + 2)
    ]
    return Benchmark(Polynomials(equations), {3: 8, 4: 36, 5: 144}[n])


def eco(n: int) -> Benchmark:
    """An economy: (x_k + Σ x_i x_(i+k)) x_n = k, Σ x_i = -1; 2^(n-2) solutions."""
    equations: list[Polynomial] = []
    for k in range(1, n):
        terms: dict[tuple[int, ...], complex] = {
            monomial(n, k - 1, n - 1): 1.0,
            monomial(n): -float(k),
        }
        for i in range(n - 1 - k):
            terms[monomial(n, i, i + k, n - 1)] = 1.0
        equations.append(terms)
    equations.append({**{monomial(n, i): 1.0 for i in range(n - 1)}, monomial(n): 1.0})
    return Benchmark(Polynomials(equations), 2 ** (n - 2))


def trinks() -> Benchmark:
    """The larger system of Trinks, of number theory."""
    system = parsed(
        "wpzstb",
        "45 p + 35 s - 165 b - 36",
        "35 p + 40 z + 25 t - 27 s",
        "15 w + 25 p s + 30 z - 18 t - 165 b b",
        "- 9 w + 15 p t + 20 z s",
        "w p + 2 z t - 11 b b b",
        "99 w - 11 s b + 3 b b",
    )
    return Benchmark(system, 10)


def puma() -> Benchmark:
    """Hand position and orientation of a PUMA robot (Morgan and Shapiro)."""
    system = parsed(
        "abcdefgh",
        "a a + b b - 1",
        "c c + d d - 1",
        "e e + f f - 1",
        "g g + h h - 1",
        "0.004731 a c - 0.3578 b c - 0.1238 a - 0.001637 b - 0.9338 d + g - 0.3571",
        "0.2238 a c + 0.7623 b c + 0.2638 a - 0.07745 b - 0.6734 d - 0.6022",
        "f h + 0.3578 a + 0.004731 b",
        "- 0.7623 a + 0.2238 b + 0.3461",
    )
    return Benchmark(system, 16)


def heart() -> Benchmark:
    """The dipoles of a heart (Nelsen and Hodgkin)."""
    system = parsed(
        "abcdtuvw",
        "a + b - 0.63254",
        "c + d + 1.34534",
        "t a + u b - v c - w d + 0.8365348",
        "v a + w b + t c + u d - 1.7345334",
        "a t t - a v v - 2 c t v + b u u - b w w - 2 d u w - 1.352352",
        "c t t - c v v + 2 a t v + d u u - d w w + 2 b u w + 0.843453",
        "a t t t - 3 a t v v + c v v v - 3 c v t t"
        " + b u u u - 3 b u w w + d w w w - 3 d w u u + 0.9563453",
        "c t t t - 3 c t v v - a v v v + 3 a v t t"
        " + d u u u - 3 d u w w - b w w w + 3 b w u u - 1.2342523",
    )
    return Benchmark(system, 4)
