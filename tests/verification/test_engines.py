"""kleinform's motions are those of multibody programs that know the mechanism joint by joint."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from kleinform.errors import MissingExtraError
from kleinform.verification import by_exudyn, by_pinocchio, report
from kleinform.verification.__main__ import main
from kleinform.verification.mechanism import assembled

BOTH = pytest.mark.parametrize("name", report.EXAMPLES)
SAMPLES, STEPS = 60, (125, 250)


@pytest.fixture
def pinocchio() -> None:
    pytest.importorskip("pinocchio", reason="pinocchio is not installed: kleinform[verify]")


@pytest.fixture
def exudyn() -> None:
    pytest.importorskip("exudyn", reason="exudyn is not installed: kleinform[verify]")


def tilted(mechanism):
    """The base revolute of limb 1 is turned by 1e-3."""
    base, *others = mechanism.limbs[0]
    axis = base.axis + 1e-3 * others[0].axis
    base = base._replace(axis=axis / np.linalg.norm(axis))
    return mechanism._replace(limbs=((base, *others), *mechanism.limbs[1:]))


@pytest.fixture
def wrong(monkeypatch) -> None:
    """Both engines get a mechanism that is not the paper's."""
    right = report.start_of
    monkeypatch.setattr(report, "start_of", lambda platform: tilted(right(platform)))


def test_the_limbs_are_those_of_the_title() -> None:
    mechanism = assembled(np.array([0.25, 0.2, 1.0]), np.eye(3))
    kinds = ["".join(joint.kind for joint in limb) for limb in mechanism.limbs]
    assert kinds == ["RPRRC"] * 3 + ["RRPR" + "RR"]
    driven = [joint.actuator for limb in mechanism.limbs for joint in limb]
    assert [number for number in driven if number is not None] == [0, 1, 2, 3, 4, 5]


@BOTH
def test_the_engines_start_with_the_joint_values_of_the_motion(name) -> None:
    states = report.EXAMPLES[name].sampled(2)
    mechanism = report.start_of(report.ours(states))
    legs = [limb[2].point - limb[0].point for limb in mechanism.limbs[:3]]
    x, y, z = mechanism.position
    polar = [np.arctan2(y, x), np.arctan2(z, np.hypot(x, y)), np.linalg.norm([x, y, z])]
    values = [*np.linalg.norm(legs, axis=1), *polar]
    np.testing.assert_allclose(values, states.joints[0], rtol=0, atol=1e-14)


@BOTH
def test_pinocchio_moves_the_platform_as_kleinform_does(pinocchio, name) -> None:
    row = report.pinocchio_row(report.EXAMPLES[name], SAMPLES)
    assert row.agrees, row
    assert row.closure <= by_pinocchio.CLOSED


@BOTH
def test_exudyn_converges_to_kleinform_with_order_2(exudyn, name) -> None:
    coarse, fine = report.exudyn_rows(report.EXAMPLES[name], STEPS)
    assert report.second_order(coarse, fine), report.orders(coarse, fine)
    assert max(fine.differences) < 1e-3


@pytest.mark.usefixtures("wrong")
def test_pinocchio_sees_a_joint_axis_that_is_off_by_a_thousandth(pinocchio) -> None:
    row = report.pinocchio_row(report.EXAMPLES["Example 1"], SAMPLES)
    assert not row.agrees
    assert min(row.differences.orientation, row.angular_acceleration) > 1e4 * report.BOUND


@pytest.mark.usefixtures("wrong")
def test_exudyn_sees_a_joint_axis_that_is_off_by_a_thousandth(exudyn) -> None:
    coarse, fine = report.exudyn_rows(report.EXAMPLES["Example 2"], STEPS)
    assert fine.differences.orientation > 1e4 * report.BOUND
    assert not report.second_order(coarse, fine)


def test_pinocchio_and_exudyn_start_with_the_same_joint_rates(pinocchio) -> None:
    states = report.EXAMPLES["Example 1"].sampled(2)
    mechanism = report.start_of(report.ours(states))
    start = type(states)(*(values[:1] for values in states))
    followed = by_pinocchio.follow(mechanism, start)
    rates = by_exudyn.start_rates(mechanism, states.rates[0])
    np.testing.assert_allclose(followed.joint_rates[0], rates, rtol=0, atol=1e-14)


def test_a_mechanism_that_cannot_be_closed_is_refused(pinocchio) -> None:
    states = report.EXAMPLES["Example 2"].sampled(2)
    mechanism = report.start_of(report.ours(states))
    states.joints[1, 0] += 10.0
    with pytest.raises(ArithmeticError, match="sample 1: the loops stay open"):
        by_pinocchio.follow(mechanism, states)


@pytest.mark.parametrize(("engine", "module"), [("pinocchio", by_pinocchio), ("exudyn", by_exudyn)])
def test_a_missing_engine_names_the_extra(monkeypatch, engine, module) -> None:
    states = report.EXAMPLES["Example 2"].sampled(2)
    mechanism = report.start_of(report.ours(states))
    monkeypatch.setitem(sys.modules, engine, None)
    with pytest.raises(MissingExtraError, match=rf"{engine}: pip install 'kleinform\[verify\]'"):
        module.follow(mechanism, states)


def test_the_command_prints_both_tables(pinocchio, exudyn, capfd) -> None:
    assert main(SAMPLES, STEPS) == 0
    lines = capfd.readouterr().out.splitlines()
    assert sum(line.startswith("Example") for line in lines) == 6
    assert len(lines) == 13, lines


@pytest.mark.usefixtures("wrong")
def test_the_command_fails_for_a_wrong_mechanism(pinocchio, exudyn, capfd) -> None:
    assert main(SAMPLES, STEPS) == 1
    assert capfd.readouterr().out.count("NOT ALL") == 2
