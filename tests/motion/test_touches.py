"""When something is touched, or barely passed: on a sample, next to one, and between two."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform.limits import Limits
from kleinform.motion import JointMotion
from tests.motion.touching import HOME, KINDS, ROBOT, START, Shallow, error, factor_along
from tests.support import many

#: The documented figure [s].
SOON = 1e-9


@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS)
def test_a_touch_is_timed_by_its_slope(kind: str) -> None:
    rng = np.random.default_rng(41)
    for _ in range(many(25, 200)):
        assert error(KINDS[kind](rng)) <= SOON


@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS)
def test_a_shallow_passage_is_timed_where_the_sign_changes(kind: str) -> None:
    """With slopes down to 1e-6: what counts as zero there lies 1e-9 to 1e-8 s before."""
    rng = np.random.default_rng(42)
    for _ in range(many(15, 200)):
        assert error(KINDS[kind](rng, 10.0 ** rng.uniform(-6.0, -2.0))) <= SOON


@pytest.mark.parametrize("k", [0.1, 1.0, 2.0])
def test_touches_on_every_sample(k: float) -> None:
    """C = (1 − k (t − t_0)², 0.2, 1) with t_0 on each of 101 samples but the first."""
    for time in np.linspace(0.0, 1.0, 101)[1:]:
        assert error(factor_along(Shallow(float(time), k, 0.0, 0.0), float(time), 101)) <= SOON


def resting(power: float) -> JointMotion:
    """q1 comes to rest at t = 1 as a power of the time that is left."""
    start = ROBOT.inverse_displacement(HOME, START)

    def function(times: np.ndarray) -> tuple[np.ndarray, ...]:
        joints, still = np.tile(start, (len(times), 1)), np.zeros((len(times), 6))
        joints[:, 0] += 0.05 - 0.05 * np.maximum(1.0 - times, 0.0) ** power
        return joints, still, still

    return JointMotion(function, 0.0, 2.0)


@pytest.mark.parametrize("count", [11, 64, 101])
def test_what_rests_is_met_when_it_arrives(count: int) -> None:
    """What a motion does afterwards does not blur when it was met, but a smooth stop does."""
    limits = Limits({"q1": (0.0, float(resting(1.0).at([1.5]).joints[0, 0]))})
    for power, early in ((1.0, SOON), (2.0, SOON), (3.0, 1e-4)):
        first = ROBOT.watch(resting(power), count, limits=limits, start_rotation=START).first
        assert first.name == "q1 high"
        assert -SOON <= 1.0 - first.time <= early
