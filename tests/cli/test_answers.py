"""What each command answers, beside the same calls of the library."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from kleinform import UncoupledManipulator, rotation_from_rpy, rpy_from_rotation
from kleinform.commands.streams import Streams
from kleinform.paper.examples import example_1, example_2
from tests.cli.support import PAPER, array, random_poses, read, read_csv, write

ROBOT = UncoupledManipulator()
POSITION = np.array([0.25, 0.2, 1.0])
ROTATION = rotation_from_rpy(
    **dict(zip(("roll", "pitch", "yaw"), np.radians([10, 3, 6]), strict=True))
)
TWIST = np.array([0.1, -0.2, 0.3, 0.4, 0.5, -0.6])
#: Angles among q1 ... q6, and in a twist.
JOINT_UNITS = np.array([1, 1, 1, np.pi / 180, np.pi / 180, 1])
TWIST_UNITS = np.array([np.pi / 180] * 3 + [1] * 3)


def of_table(poses):
    angles = {name: np.radians(poses[name]) for name in ("roll", "pitch", "yaw")}
    position = np.stack([poses[name] for name in "xyz"], axis=-1)
    return position, rotation_from_rpy(**angles)


def test_inverse_of_one_pose(run) -> None:
    ran = run("inverse", *PAPER)
    assert (ran.code, ran.err) == (0, "")
    answer = read_csv(ran.out)
    assert list(answer) == ["q1", "q2", "q3", "q4", "q5", "q6"]
    expected = ROBOT.inverse_displacement(POSITION, ROTATION)
    np.testing.assert_allclose(array(answer)[0] * JOINT_UNITS, expected, rtol=4e-16)


def test_radians_are_the_default(run) -> None:
    rpy = map(repr, map(float, np.radians([10, 3, 6])))
    answer = read_csv(run("inverse", "--position", 0.25, 0.2, 1.0, "--rpy", *rpy).out)
    expected = ROBOT.inverse_displacement(POSITION, ROTATION)
    np.testing.assert_array_equal(array(answer)[0], expected)


def test_the_radius(run) -> None:
    answer = read_csv(run("inverse", *PAPER, "--radius", 1.5).out)
    expected = UncoupledManipulator(1.5).inverse_displacement(POSITION, ROTATION)
    np.testing.assert_allclose(array(answer)[0] * JOINT_UNITS, expected, rtol=4e-16)


def test_the_azimuth_on_the_z_axis(run) -> None:
    pose = ("--position", 0, 0, 1, "--rpy", 1, 2, 3, "--degrees")
    refused = run("inverse", *pose)
    assert refused.code == 2
    assert refused.err.startswith("kleinform: C is on the Z axis, q4 is free")
    answer = read_csv(run("inverse", *pose, "--azimuth", 30).out)
    assert answer["q4"] == pytest.approx(30)


def test_forward_finds_the_pose_again(run, tmp_path) -> None:
    poses = random_poses(300)
    write(tmp_path / "poses.csv", poses)
    assert run("inverse", "--input", "poses.csv", "--output", "q.csv", "--degrees").code == 0
    assert run("forward", "--input", "q.csv", "--output", "modes.csv", "--degrees").code == 0
    modes = read(tmp_path / "modes.csv")
    found = np.stack([modes[name] for name in poses], axis=-1)
    for row, pose in enumerate(array(poses)):
        distance = abs(found[modes["row"] == row] - pose).max(axis=1)
        assert distance.min() < 1e-8


def test_forward_is_a_row_a_mode(run) -> None:
    joints = ROBOT.inverse_displacement(POSITION, ROTATION)
    modes = ROBOT.forward_displacement(joints)
    answer = read_csv(run("forward", "--joints", *map(repr, joints.tolist())).out)
    np.testing.assert_array_equal(answer["mode"], np.arange(len(modes)))
    assert set(answer["status"]) == {"regular"}
    angles = np.stack(rpy_from_rotation(modes.rotation), axis=-1)
    found = np.stack([answer[name] for name in ("roll", "pitch", "yaw")], axis=-1)
    np.testing.assert_array_equal(found, angles)
    extension = np.stack([answer[name] for name in ("e1", "e2", "e3")], axis=-1)
    np.testing.assert_array_equal(extension, modes.extension)
    np.testing.assert_array_equal(answer["direct_determinant"], modes.direct_determinant)
    np.testing.assert_array_equal(answer["multiplicity"], modes.multiplicity)
    np.testing.assert_array_equal(answer["feasible"] == "true", modes.feasible)


def test_forward_without_a_mode(run, tmp_path) -> None:
    """Joint values without a mode have a row, and say why; rows count over the blocks."""
    joints = np.tile([1.0, 1.2, 0.9, 0.7, 1.2, 1.0], (9001, 1))
    joints[9000] = [0.01, 0.01, 0.01, 0.0, 0.1, 5.0]
    names = [f"q{i}" for i in range(1, 7)]
    write(tmp_path / "q.npz", dict(zip(names, joints.T, strict=True)))
    assert run("forward", "--input", "q.npz", "--output", "modes.npz").code == 0
    modes = read(tmp_path / "modes.npz")
    assert np.array_equal(np.unique(modes["row"]), np.arange(9001))
    assert (modes["row"][-1], modes["mode"][-1], modes["status"][-1]) == (9000, -1, "none")
    assert np.isnan(modes["roll"][-1])
    assert (modes["mode"][:-1] >= 0).all()


def test_forward_with_what_is_degenerate(run) -> None:
    answer = read_csv(run("forward", "--joints", 1, 1, 1, 0, 1, 0).out)
    assert set(answer["status"]) == {"merged"}
    assert set(answer["degenerate"]) == {"q_6=0"}


def test_certify(run) -> None:
    pytest.importorskip("flint", reason="the extra kleinform[certify] is not installed")
    joints = ("--joints", 1.0, 1.191, 0.869, 38.657, 72.247, 1.05, "--degrees")
    proven, plain = run("forward", *joints, "--certify"), run("forward", *joints)
    assert proven.code == 0
    assert proven.out == plain.out
    assert proven.err.startswith("kleinform: proven: ")
    assert proven.err.count("\n") == 1


def test_certify_without_a_proof(run) -> None:
    """Exit code 1: what is not proven is not an error, and not an answer."""
    pytest.importorskip("flint", reason="the extra kleinform[certify] is not installed")
    ran = run("forward", "--joints", 1, 1, 1, 0, 1, 0, "--certify")
    assert ran.code == 1
    assert ran.err.startswith("kleinform: not proven: ")


def test_velocity_both_ways(run, tmp_path) -> None:
    twist = (TWIST / TWIST_UNITS).tolist()
    rates = read_csv(run("velocity", *PAPER, "--twist", *map(repr, twist)).out)
    expected = ROBOT.inverse_velocity(POSITION, ROTATION, TWIST)
    np.testing.assert_allclose(array(rates)[0] * JOINT_UNITS, expected, rtol=1e-14)
    given = map(repr, array(rates)[0].tolist())
    back = read_csv(run("velocity", *PAPER, "--rates", *given).out)
    assert list(back) == ["wx", "wy", "wz", "vx", "vy", "vz"]
    np.testing.assert_allclose(array(back)[0], twist, rtol=1e-12)


def test_velocity_of_a_table(run, tmp_path) -> None:
    poses = random_poses(50)
    names = ("wx", "wy", "wz", "vx", "vy", "vz")
    twists = np.random.default_rng(2).normal(size=(50, 6))
    write(tmp_path / "in.csv", {**poses, **dict(zip(names, twists.T, strict=True))})
    assert run("velocity", "--input", "in.csv", "--degrees", "--output", "out.csv").code == 0
    rates = read(tmp_path / "out.csv")
    write(tmp_path / "back.csv", {**poses, **rates})
    assert run("velocity", "--input", "back.csv", "--degrees", "--output", "back.npz").code == 0
    np.testing.assert_allclose(array(read(tmp_path / "back.npz")), twists, atol=1e-10)


def test_singularity(run, tmp_path) -> None:
    poses = random_poses(20)
    for name in poses:
        poses[name][7] = {"x": 0.3, "z": 1.0}.get(name, 0.0)
    poses["roll"][8] = 180.0
    poses["x"][9] = poses["y"][9] = 0.0
    write(tmp_path / "poses.csv", poses)
    ran = run("singularity", "--input", "poses.csv", "--degrees", "--output", "out.csv")
    assert (ran.code, ran.err) == (0, "")
    answer = read(tmp_path / "out.csv")
    survey = ROBOT.survey(*of_table(poses))
    np.testing.assert_array_equal(answer["inverse_determinant"], survey.inverse_determinant)
    np.testing.assert_array_equal(answer["direct_determinant"], survey.direct_determinant)
    for name, factor in survey.factors.items():
        np.testing.assert_array_equal(answer[name], factor)
    zero = survey.vanishing()
    for row, words in enumerate(answer["vanishing"]):
        assert words.split() == [name for name in survey.factors if zero[name][row]]
    assert answer["vanishing"][9] == "central"


@pytest.mark.parametrize(("number", "motion"), [(1, example_1()), (2, example_2())])
def test_the_paper_s_motions(run, number: int, motion) -> None:
    ran = run("trajectory", "--example", number, "--samples", 40)
    answer = read_csv(ran.out)
    platform = ROBOT.forward_motion(motion.sampled(40), ROTATION)
    np.testing.assert_array_equal(answer["t"], platform.times)
    twist = np.stack([answer[name] for name in ("wx", "wy", "wz", "vx", "vy", "vz")], axis=-1)
    np.testing.assert_array_equal(twist, platform.twists)
    np.testing.assert_array_equal(answer["dvz"], platform.twist_rates[:, 5])


def motion_table(rates: bool):
    states = example_2().sampled(30)
    columns = {"t": states.times[:, np.newaxis], "q": states.joints}
    if rates:
        columns |= {"dq": states.rates, "ddq": states.accelerations}
    return {
        name + str(index + 1) * (name != "t"): column
        for name, array in columns.items()
        for index, column in enumerate(array.T)
    }


@pytest.mark.parametrize("rates", [False, True])
def test_a_motion_that_is_read(run, tmp_path: Path, rates: bool) -> None:
    """The table of an example is followed as the example is, from a rotation or a number."""
    write(tmp_path / "motion.csv", motion_table(rates))
    start = map(repr, np.radians([10.0, 3.0, 6.0]).tolist())
    near = run("trajectory", "--input", "motion.csv", "--start-rpy", *start)
    numbered = run("trajectory", "--input", "motion.csv", "--mode", 1)
    example = read_csv(run("trajectory", "--example", 2, "--samples", 30).out)
    answer = read_csv(near.out)
    assert list(answer) == list(example)[: 19 if rates else 7]
    for name, column in answer.items():
        np.testing.assert_allclose(column, example[name], atol=1e-12)
        np.testing.assert_allclose(read_csv(numbered.out)[name], column, atol=1e-12)


def test_paper(run) -> None:
    ran = run("paper")
    assert ran.code == 0
    assert "confirmed" in ran.out.splitlines()[-1]


def test_verify_runs_the_engines(run, monkeypatch: pytest.MonkeyPatch) -> None:
    from kleinform.verification import __main__ as verification

    for code in (0, 1):
        monkeypatch.setattr(verification, "main", lambda code=code: code)
        assert run("verify").code == code


def test_without_a_command_there_is_help(run) -> None:
    ran = run()
    assert ran.code == 0
    assert "Usage: kleinform" in ran.out


def test_one_answer_at_a_terminal(run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Aligned, with units; a file or a format asks for something else."""
    monkeypatch.setattr(Streams, "on_terminal", True)
    lines = run("inverse", *PAPER).out.splitlines()
    assert lines[0] == "q1 [m]      1.000131"
    assert lines[3] == "q4 [deg]   38.659808"
    assert len({len(line) for line in lines}) == 1
    assert run("inverse", *PAPER, "--format", "csv").out.startswith("q1,q2,")
    assert run("trajectory", "--example", 1).out.startswith("t,x,y,z,")


def test_many_modes_at_a_terminal(run, monkeypatch: pytest.MonkeyPatch) -> None:
    """In groups that fit the terminal; numbers that are tiny or huge with an exponent."""
    monkeypatch.setattr(Streams, "on_terminal", True)
    monkeypatch.setenv("COLUMNS", "50")
    ran = run("forward", "--joints", 1.0, 1.191, 0.869, 38.657, 72.247, 1.05, "--degrees")
    assert max(map(len, ran.out.splitlines())) <= 50
    assert [line.split()[1:] for line in ran.out.splitlines() if line.startswith("mode")] == [
        ["0", "1"],
        ["2", "3"],
    ]
    pose = ("--position", 1e-9, 0, 1, "--rpy", 0, 0, 1e-5)
    lines = run("singularity", *pose, "--radius", 1e4).out.splitlines()
    assert lines[5] == "central [m²]              1.0000e-09"
    assert lines[7] == "extension_1 [m]           1.0000e+04"
