"""``python -m kleinform.verification``: both examples of the paper beside two engines."""

from __future__ import annotations

import sys
from itertools import pairwise

from kleinform.errors import MissingExtraError
from kleinform.verification.engines import load
from kleinform.verification.report import (
    BOUND,
    EXAMPLES,
    ORDERS,
    exudyn_rows,
    orders,
    pinocchio_row,
    second_order,
)

SAMPLES = 1001
STEPS = (250, 500, 1000, 2000)
VELOCITIES = ("position", "orientation", "ang. vel.", "lin. vel.")
ACCELERATIONS = ("ang. acc.", "lin. acc.")


def main(samples: int = SAMPLES, steps: tuple[int, ...] = STEPS) -> int:
    """Print both tables; 0 if every difference and every order is as it must be, else 1."""
    agreed = [show_pinocchio(samples), show_exudyn(steps)]
    return 0 if all(agreed) else 1


def show_pinocchio(samples: int) -> bool:
    """Print a line an example; whether every difference is within the bound."""
    print(f"Pinocchio {load('pinocchio').__version__}: largest differences in m, rad, s")
    heads = cells((*VELOCITIES, *ACCELERATIONS, "limbs (12)", "closure"))
    print(f"{'':9}{'samples':>8}{heads}{'seconds':>9}")
    rows = {name: pinocchio_row(motion, samples) for name, motion in EXAMPLES.items()}
    for name, row in rows.items():
        _, differences, *others, seconds = row
        print(f"{name:9}{samples:8}{cells((*differences, *others))}{seconds:9.2f}")
    good = all(row.agrees for row in rows.values())
    print(f"{'all' if good else 'NOT ALL'} within {BOUND:.0e}\n")
    return good


def show_exudyn(steps: tuple[int, ...]) -> bool:
    """Print a line for each number of steps; whether the velocities converge as they must."""
    print(f"Exudyn {load('exudyn').__version__}: largest differences in m, rad, s; their orders")
    heads = cells((*VELOCITIES, "ang. order", "lin. order"))
    print(f"{'':9}{'steps':>8}{heads}{'seconds':>9}")
    good = True
    for name, motion in EXAMPLES.items():
        rows = list(exudyn_rows(motion, steps))
        observed = ["", *("{:12.3f}{:12.3f}".format(*orders(*pair)) for pair in pairwise(rows))]
        for row, shown in zip(rows, observed, strict=True):
            print(f"{name:9}{row.steps:8}{cells(row.differences)}{shown:24}{row.seconds:9.2f}")
        good = good and all(second_order(*pair) for pair in pairwise(rows))
    low, high = ORDERS
    print(f"{'all' if good else 'NOT ALL'} orders within {low} and {high}, poses {BOUND:.0e}")
    return good


def cells(values: tuple[float | str, ...]) -> str:
    """Titles or numbers in columns."""
    texts = [value if isinstance(value, str) else f"{value:.1e}" for value in values]
    return "".join(f"{text:>12}" for text in texts)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except MissingExtraError as error:
        sys.exit(str(error))
