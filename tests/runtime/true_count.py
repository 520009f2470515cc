"""How many assembly modes joint values have: counted in balls, by nothing of kleinform's.

B_1 at an angle of its circle gives n_1; limbs 2 and 3 are then two quartics in the half
tangent of the turn about n_1, and their resultant is a trigonometric polynomial of degree 16
in the angle. Its 32 roots z = exp(i angle) are isolated in balls of rising precision; those
whose ball meets its own mirror image in the unit circle, and no other one, are on it.
"""

from __future__ import annotations

from flint import acb, acb_poly, arb, arb_mat, ctx, fmpq

DEGREE, SAMPLES = 16, 33
LEAST_BITS, MOST_BITS = 192, 3072
Vector = list[arb]


def true_count(joints: list[float], radius: float = 1.0) -> int | None:
    """Pairs ±(n_1, n_2) of exactly these float64 values; None where they stay together."""
    bits = LEAST_BITS
    while bits <= MOST_BITS:
        for rank in range(3):  # two modes may share the angle of one leg
            with ctx.workprec(bits):
                count = _counted(joints, radius, rank)
            if count is not None:
                return count
        bits *= 4
    return None


def _counted(joints: list[float], radius: float, rank: int) -> int | None:
    samples = [_eliminant(joints, radius, rank, fmpq(2 * k, SAMPLES)) for k in range(SAMPLES)]
    turns = [_turn(fmpq(-2 * k, SAMPLES)) for k in range(SAMPLES)]
    coefficients = [
        sum((value * turns[k * m % SAMPLES] for k, value in enumerate(samples)), acb(0))
        for m in range(-DEGREE, DEGREE + 1)
    ]
    try:
        roots = acb_poly(coefficients).roots()
    except (ValueError, ArithmeticError):
        return None
    if len(roots) != 2 * DEGREE:
        return None
    count = 0
    for index, root in enumerate(roots):
        met = [k for k, other in enumerate(roots) if other.overlaps(1 / root.conjugate())]
        if len(met) != 1:
            return None
        count += met[0] == index
    return count


def _from_the_base(joints: list[float], radius: float, rank: int) -> tuple[Vector, Vector]:
    """The leg lengths and C, turned so that limb 1 is the one with C nearest to its plane, or next.

    There modes share their directions, and not the angle of this leg.
    """
    q = [arb(value) for value in joints]
    x, y, z = q[4].cos() * q[3].cos(), q[4].cos() * q[3].sin(), q[4].sin()
    turns = [arb.sin_cos_pi_fmpq(fmpq(2 * limb, 3)) for limb in range(3)]
    away = [abs(float(radius - q[5] * (cosine * x + sine * y))) for sine, cosine in turns]
    base = away.index(sorted(away)[rank])
    sine, cosine = turns[base]
    c = [q[5] * (cosine * x + sine * y), q[5] * (cosine * y - sine * x), q[5] * z]
    return [q[(base + limb) % 3] for limb in range(3)], c


def _turn(half_turns: fmpq) -> acb:
    sine, cosine = arb.sin_cos_pi_fmpq(half_turns)
    return acb(cosine, sine)


def _eliminant(joints: list[float], radius: float, rank: int, half_turns: fmpq) -> arb:
    """The resultant of limbs 2 and 3 with B_1 at an angle, times |B_1 − C|^16."""
    q, c, a = *_from_the_base(joints, radius, rank), arb(radius)
    sine, cosine = arb.sin_cos_pi_fmpq(half_turns)
    n = [a - c[0], q[0] * cosine - c[1], q[0] * sine - c[2]]
    # Any vector that is not along n: the resultant does not know which.
    axis = min(range(3), key=lambda k: abs(float(n[k])))
    f = _cross(n, [arb(int(k == axis)) for k in range(3)])
    length, across = _dot(n, n).sqrt(), _dot(f, f).sqrt()
    f = [entry * length / across for entry in f]
    g = [entry / length for entry in _cross(n, f)]
    first, second = (_quartic(a, c, q[limb], limb, n, f, g) for limb in (1, 2))
    rows = [[arb(0)] * k + first + [arb(0)] * (3 - k) for k in range(4)]
    rows += [[arb(0)] * k + second + [arb(0)] * (3 - k) for k in range(4)]
    return arb_mat(rows).det()


def _quartic(a: arb, c: Vector, q: arb, limb: int, n: Vector, f: Vector, g: Vector) -> list[arb]:
    """(p² (|B|² − a² − q²))(1 + t²)² in t, for n_i = −n/2 ± √3/2 (f cos + g sin), unscaled."""
    sine, cosine = arb.sin_cos_pi_fmpq(fmpq(2 * limb, 3))
    u = [cosine, sine, arb(0)]
    h, kappa = a - _dot(c, u), _dot(c, c) - a * a - q * q
    # n_i (1 + t²) = v_0 + v_1 t + v_2 t²
    v = [
        [cosine * x + sine * y for x, y in zip(n, f, strict=True)],
        [2 * sine * z for z in g],
        [cosine * x - sine * y for x, y in zip(n, f, strict=True)],
    ]
    result = [arb(0)] * 5
    for j, left in enumerate(v):
        for k, right in enumerate(v):
            incidence = _dot(left, u), _dot(right, u)
            form = kappa * incidence[0] * incidence[1] + h * h * _dot(left, right)
            form += h * (incidence[0] * _dot(right, c) + incidence[1] * _dot(left, c))
            result[j + k] = result[j + k] + form
    return result


def _dot(one: Vector, other: Vector) -> arb:
    return sum((x * y for x, y in zip(one, other, strict=True)), arb(0))


def _cross(one: Vector, two: Vector) -> Vector:
    ahead, behind = (1, 2, 0), (2, 0, 1)
    return [one[ahead[k]] * two[behind[k]] - one[behind[k]] * two[ahead[k]] for k in range(3)]
