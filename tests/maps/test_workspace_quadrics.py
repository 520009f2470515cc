"""The quadrics of limits against `survey`, and what the entry refuses."""

from math import inf, pi

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kleinform
from kleinform import InputError, Limits, SingularPoseError
from kleinform.errors import NotARotationError
from kleinform.maps.quadrics import constraints_of
from kleinform.maps.workspace import constant_orientation_workspace

RANGES = {
    **dict.fromkeys(("q1", "q2", "q3"), (0.6, 1.5)),
    **dict.fromkeys(("e1", "e2", "e3"), (-0.3, 1.8)),
    "q6": (0.7, 1.4),
}
CASES = {
    "typical": (1.0, Limits.typical(1.0)),
    "radius": (0.25, Limits.typical(0.25)),
    "narrow wedge": (1.0, Limits({**RANGES, "q4": (0.4, 1.9), "q5": (-0.2, 1.1)})),
    "wide wedge": (1.0, Limits({**RANGES, "q4": (-1.9, 2.4), "q5": (-1.2, -0.1)})),
    "level": (1.0, Limits({**RANGES, "q5": (0.0, pi / 2.0)})),
    "below": (1.0, Limits({"q1": (-inf, 1.2), "e2": (0.1, inf), "q5": (-2.0, 0.4)})),
}


@pytest.mark.parametrize("name", CASES)
def test_signs_agree_with_survey(name):
    radius, limits = CASES[name]
    robot = kleinform.UncoupledManipulator(radius)
    rng = np.random.default_rng(5)
    for rotation in Rotation.random(5, rng=rng).as_matrix():
        positions = radius * rng.uniform(-1.5, 1.5, (4000, 3))
        survey = robot.survey(positions, rotation)
        room = limits.room(survey.joints, survey.extension)
        points = np.concatenate([positions, np.ones((4000, 1))], axis=1)
        found = {}
        for constraint in constraints_of(radius, rotation, limits):
            values = [np.einsum("ni,ij,nj->n", points, f.matrix, points) for f in constraint.forms]
            key = f"{constraint.name} {constraint.end}"
            found[key] = np.minimum(found.get(key, inf), np.max(values, axis=0))
        for both in (room, found):  # one end of a wedge alone is half a plane
            ends = [both.pop(key) for key in list(both) if key.startswith("q4")]
            if ends:
                both["q4"] = np.min(ends, axis=0)
        # Ends beyond ±π/2 and lengths below 0 are no limits.
        assert set(found) <= set(room)
        for key, value in room.items():
            assert (
                ((found[key] >= 0.0) == (value >= 0.0)).all()
                if key in found
                else (value >= 0.0).all()
            )
        workspace = constant_orientation_workspace(robot, rotation, limits)
        feasible = np.all([value >= 0.0 for value in room.values()], axis=0)
        assert (workspace.contains(positions) == feasible).all()
        assert workspace.contains(positions.reshape(40, 100, 3)).shape == (40, 100)


def test_a_range_of_q4_is_one_modulo_a_turn():
    robot = kleinform.UncoupledManipulator(1.0)
    for low, high, inside in (
        (2.0, 4.0, [False, True, True]),
        (-0.5, 6.0, [True, True, True]),
        (-inf, 1.0, [True, True, True]),
        (0.5, 6.0, [False, True, True]),
    ):
        workspace = constant_orientation_workspace(robot, np.eye(3), Limits({"q4": (low, high)}))
        angles = np.array([0.0, 3.0, -2.5])
        points = np.stack([np.cos(angles), np.sin(angles), angles], axis=-1)
        assert workspace.contains(points).tolist() == inside


def test_refusals():
    robot = kleinform.UncoupledManipulator(1.0)
    typical = Limits.typical()
    with pytest.raises(InputError, match="margins are not bounded by quadrics, wrist arrived"):
        constant_orientation_workspace(robot, np.eye(3), Limits(margins={"wrist": 0.1}))
    turn = Rotation.from_euler("y", 90, degrees=True)
    with pytest.raises(SingularPoseError, match="n_1·u_1 = 0"):
        constant_orientation_workspace(robot, turn, typical)
    with pytest.raises(InputError, match="radius: one is needed"):
        constant_orientation_workspace(
            kleinform.UncoupledManipulator([1.0, 2.0]), np.eye(3), typical
        )
    with pytest.raises(NotARotationError):
        constant_orientation_workspace(robot, 2.0 * np.eye(3), typical)
    unbounded = constant_orientation_workspace(robot, np.eye(3), Limits({"e1": (0.1, 1.0)}))
    for ask in (unbounded.volume, unbounded.components, unbounded.mesh, lambda: unbounded.box):
        with pytest.raises(InputError, match="unbounded"):
            ask()
    workspace = constant_orientation_workspace(robot, np.eye(3), typical)
    with pytest.raises(InputError, match="from 1e-9 to 1"):
        workspace.volume(0.0)
    with pytest.raises(InputError, match="resolution: a positive integer"):
        workspace.mesh(0)
    with pytest.raises(InputError, match="lines: a positive integer"):
        workspace.components(2.5)
