"""Motions of the joints as data and as functions of time."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import InputError, JointRangeError, NotFiniteError, ShapeError
from kleinform.motion import JointMotion, polynomials, rest_to_rest, rest_to_rest_coefficients
from kleinform.paper.examples import example_1, example_2

START = np.array([1.0, 1.2, 0.9, 0.7, 1.26, 1.05])
END = np.array([1.1, 1.0, 1.2, 0.5, 1.0, 1.5])
MOTIONS = {
    "Example 1": example_1(),
    "Example 2": example_2(),
    "rest to rest": rest_to_rest(START, END, 5.0),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_rates_and_accelerations_are_derivatives(name: str) -> None:
    motion, step = MOTIONS[name], 1e-5
    times = np.linspace(motion.start + 0.1, motion.end - 0.1, 50)
    before, here, after = (motion.at(times + shift) for shift in (-step, 0.0, step))
    for lower, upper in (("joints", "rates"), ("rates", "accelerations")):
        difference = (getattr(after, lower) - getattr(before, lower)) / (2.0 * step)
        assert abs(difference - getattr(here, upper)).max() <= 1e-9


def test_quintics_rest_at_both_ends() -> None:
    states = rest_to_rest(START, END, 5.0).at([0.0, 5.0])
    np.testing.assert_allclose(states.joints, [START, END], rtol=0, atol=1e-14)
    assert abs(states.rates).max() <= 1e-14
    assert abs(states.accelerations).max() <= 1e-14


def test_quintics_have_no_first_and_second_power() -> None:
    assert not rest_to_rest_coefficients(START, END, 2.0)[:, 1:3].any()


def test_sampled_has_both_ends() -> None:
    states = example_1().sampled(7)
    assert states.times[[0, -1]].tolist() == [0.0, 2.0 * np.pi]
    assert states.joints.shape == states.rates.shape == states.accelerations.shape == (7, 6)


@pytest.mark.parametrize("times", [[-0.1], [0.0, 5.1], [np.nan], [np.inf]])
def test_times_outside_are_refused(times: list[float]) -> None:
    with pytest.raises(InputError, match=r"^times: "):
        example_2().at(times)


@pytest.mark.parametrize("span", [(1.0, 1.0), (1.0, 0.0), (0.0, np.inf), (np.nan, 1.0)])
def test_a_motion_needs_time(span: tuple[float, float]) -> None:
    with pytest.raises(InputError, match=r"^start < end"):
        polynomials(np.ones((6, 2)), *span)


def test_fewer_than_two_samples_are_refused() -> None:
    with pytest.raises(InputError, match=r"^count: "):
        example_1().sampled(1)


@pytest.mark.parametrize(
    ("returned", "error"),
    [
        (lambda t: np.ones((len(t), 6)), InputError),
        (lambda t: (np.ones((len(t), 6)),) * 2, InputError),
        (lambda t: (np.ones((len(t), 5)),) * 3, ShapeError),
        (lambda t: (np.ones(6),) * 3, ShapeError),
        (lambda t: (np.full((len(t), 6), np.nan),) * 3, NotFiniteError),
        (lambda t: (-np.ones((len(t), 6)),) * 3, JointRangeError),
    ],
)
def test_a_function_that_returns_something_else(returned, error: type[Exception]) -> None:
    with pytest.raises(error):
        JointMotion(returned, 0.0, 1.0).sampled(3)
