"""Every NumPy kernel against its mpmath twin at 50 digits, also next to singular poses."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform_kernels import uncoupled
from tests.kernels.accuracy import KERNELS, arguments, ratios
from tests.support import DISTANCES, NEAR, Case, random_cases, scaled

#: Errors in units of `accuracy.unit` times eps. Over 2,000 poses of these families the worst
#: of any output was 1.3: what is above 4 is a cancellation, not rounding.
MOST = 4.0
RADII = (1e-3, 1.0, 1e3)


def check(name: str, case: Case, rng: np.random.Generator) -> None:
    for output, ratio, value in ratios(name, arguments(name, case, rng)):
        assert ratio <= MOST, f"{name}.{output} = {value}: error of {ratio:.3g} units, {case}"


@pytest.mark.parametrize("name", KERNELS)
@pytest.mark.parametrize("radius", RADII)
def test_random_poses(name: str, radius: float) -> None:
    rng = np.random.default_rng(1)
    for case in random_cases(rng, 4):
        check(name, scaled(case, radius), rng)


@pytest.mark.parametrize("name", KERNELS)
@pytest.mark.parametrize("family", NEAR)
def test_close_to_a_singular_pose(name: str, family: str) -> None:
    rng = np.random.default_rng(2)
    for index, distance in enumerate(DISTANCES):
        check(name, scaled(NEAR[family](rng, distance), RADII[index % 3]), rng)


def test_every_kernel_is_exported() -> None:
    public = {name for name in uncoupled.__all__ if name.islower()}
    assert public == set(KERNELS)
