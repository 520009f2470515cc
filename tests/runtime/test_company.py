"""A row's answer is the same bits alone and in any company, for every call that takes batches."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kleinform
from kleinform import Limits, UncoupledManipulator, maps, motion
from kleinform.generated import kernels
from kleinform.joints import TOLERANCE
from kleinform.motion.paths import Poses
from kleinform.motion.quantities import quantities
from kleinform.paper.examples import example_1
from kleinform_kernels.uncoupled import numpy_kernels
from tests.kernels.accuracy import KERNELS, arguments
from tests.runtime.company import (
    LAYOUTS,
    Call,
    any_poses,
    differing,
    joint_values,
    laid_out,
    rowwise,
)
from tests.support import many, random_cases

#: Some of so many poses are near a singularity, on purpose.
pytestmark = pytest.mark.filterwarnings("ignore::kleinform.SingularityWarning")

ROBOT = UncoupledManipulator()
COUNT = many(48, 2000)
POSITION, ROTATION = any_poses(np.random.default_rng(21), COUNT)
SIX, OTHERS = np.random.default_rng(22).normal(size=(2, COUNT, 6))
LIMITS = Limits({"q1": (0.6, 1.5), "q6": (0.7, 1.4)})
MODES = ("rotation", "directions", "platform_joints", "extension", "multiplicity")
#: The methods that answer with arrays, and what they take beside a pose.
ANALYSES = {
    "inverse_displacement": (),
    "screws": (),
    "jacobians": (),
    "inverse_velocity": (SIX,),
    "forward_velocity": (SIX,),
    "joint_rates": (SIX,),
    "inverse_acceleration": (SIX, OTHERS),
    "forward_acceleration": (SIX, OTHERS),
    "platform_wrench": (SIX,),
    "actuator_forces": (SIX,),
}


@pytest.mark.long
@pytest.mark.parametrize("tolerance", [TOLERANCE, 0.0, 1e-9])
def test_all_fields_of_all_modes(tolerance: float) -> None:
    def rows(joints: np.ndarray) -> list[object]:
        found = ROBOT.forward_displacement_batch(joints, tolerance=tolerance)
        determinants = np.split(found.direct_determinant, found.offsets[1:-1])
        return [fields(found[row], determinants[row]) for row in range(len(found))]

    def alone(joints: np.ndarray) -> object:
        found = ROBOT.forward_displacement(joints, tolerance=tolerance)
        return fields(found, found.direct_determinant)

    joints = joint_values(np.random.default_rng(23), many(64, 2000))
    assert not len(differing(Call("modes", (joints,), rows, alone)))


def fields(modes: kleinform.AssemblyModes, determinants: np.ndarray) -> list[object]:
    listed = [getattr(modes, name) for name in MODES]
    return [*listed, determinants, modes.position, modes.status, modes.degenerate]


@pytest.mark.long
@pytest.mark.parametrize("name", ANALYSES)
def test_analyses_of_poses(name: str) -> None:
    method = getattr(ROBOT, name)
    columns = (POSITION, ROTATION, *ANALYSES[name])
    call = rowwise(name, lambda *given: method(*given, errors="nan"), columns)
    assert not len(differing(call))


def surveyed(found: kleinform.Survey | kleinform.Singularity) -> list[object]:
    names = ("joints", "extension", "inverse_determinant", "direct_determinant", "determinant")
    own = [getattr(found, name) for name in names if hasattr(found, name)]
    named = [found.factors, found.scales, found.vanishing(), found.undefined()]
    return [*own, *(value for values in named for value in values.values())]


def classified(position: np.ndarray, rotation: np.ndarray) -> list[object]:
    found = ROBOT.classify(position, rotation)
    return [found.code, *surveyed(found.survey)]


LOCUS = maps.direct_locus(ROBOT, ROTATION[0])
TURNS = maps.orientation_locus(ROBOT, POSITION[0])
SPACE = maps.constant_orientation_workspace(ROBOT, np.eye(3), LIMITS)
#: Next to where q6 = 1.4, a limit of the workspace.
EDGE = POSITION / np.linalg.norm(POSITION, axis=1, keepdims=True) * 1.4
N_1, N_2 = ROTATION[..., 0], -0.5 * ROTATION[..., 0] + 0.75**0.5 * ROTATION[..., 1]
BOTH = (POSITION, ROTATION)
CALLS = {
    "survey": (lambda c, R: surveyed(ROBOT.survey(c, R)), BOTH),
    "survey at one place": (lambda R: surveyed(ROBOT.survey(POSITION[0], R)), (ROTATION,)),
    "inverse_singularity": (lambda c, R: surveyed(ROBOT.inverse_singularity(c, R)), BOTH),
    "direct_singularity": (lambda c, R: surveyed(ROBOT.direct_singularity(c, R)), BOTH),
    "classify": (classified, BOTH),
    "azimuth": (lambda c, R, q4: ROBOT.jacobians(c, R, azimuth=q4), (*BOTH, SIX[:, 3])),
    "conditioning": (lambda c, R: maps.conditioning(ROBOT, c, R), BOTH),
    "direct locus": (lambda c: (LOCUS.value(c), LOCUS.gradient(c)), (POSITION,)),
    "orientation locus": (lambda R: (TURNS.value(R), TURNS.gradient(R)), (ROTATION,)),
    "polynomial": (TURNS.polynomial, (POSITION,)),
    "contains": (SPACE.contains, (EDGE,)),
    "rpy": (kleinform.rpy_from_rotation, (ROTATION,)),
    "from rpy": (
        lambda angles: kleinform.rotation_from_rpy(
            roll=angles[..., 0], pitch=angles[..., 1], yaw=angles[..., 2]
        ),
        (SIX,),
    ),
    "from directions": (kleinform.rotation_from_directions, (N_1, N_2)),
}


@pytest.mark.long
@pytest.mark.parametrize("name", CALLS)
def test_surveys_maps_and_rotations(name: str) -> None:
    assert not len(differing(rowwise(name, *CALLS[name])))


@pytest.mark.long
@pytest.mark.parametrize("name", KERNELS)
def test_kernels(name: str) -> None:
    rng = np.random.default_rng(24)
    rows = [arguments(name, case, rng) for case in random_cases(rng, COUNT)]
    columns = tuple(np.stack([row[entry] for row in rows]) for entry in rows[0])
    functions: list[Callable[..., object]] = [getattr(numpy_kernels, name)]
    if kernels.BACKEND == "compiled":
        from kleinform_kernels.uncoupled import gufuncs

        functions += [getattr(kernels, name), getattr(gufuncs, name)]
    for function in functions:
        assert not len(differing(rowwise(name, function, columns)))


def motions() -> dict[str, Call]:
    """Motions at single times, and what is computed from states and poses at each time."""
    rng = np.random.default_rng(25)
    nodes, times = np.linspace(0.0, 5.0, 6), rng.uniform(0.0, 5.0, COUNT)
    home = example_1().sampled(6).joints
    place = np.array([0.25, 0.2, 1.0]) + 0.05 * rng.normal(size=(COUNT, 3))
    turn = Rotation.from_rotvec(0.1 * rng.normal(size=(COUNT, 3))).as_matrix()
    built = {
        "rest_to_rest": motion.rest_to_rest(home[0], home[5], 5.0),
        "through_joints": motion.through_joints(nodes, home),
        "interpolated": motion.interpolated(example_1().sampled(6)),
        "through_poses": motion.through_poses(nodes, place[:6], Rotation.random(6, rng=rng)),
    }
    shares = {name: (m.start + (m.end - m.start) / 5.0 * times) for name, m in built.items()}
    calls = {
        name: rowwise(name, lambda t, m=m: tuple(m.at(t)), (shares[name],), single=False)
        for name, m in built.items()
    }

    def states(*given: np.ndarray) -> motion.PlatformStates:
        return motion.PlatformStates(np.arange(float(len(given[0]))), *given)

    def backwards(*given: np.ndarray) -> tuple[np.ndarray, ...]:
        # q4 is followed from the first sample, so that its turns belong to the motion.
        found = ROBOT.inverse_motion(states(*given))
        return found.joints[:, [0, 1, 2, 4, 5]], found.rates, found.accelerations

    def watched(*given: np.ndarray) -> list[np.ndarray]:
        found = quantities(ROBOT, Poses(*given), LIMITS)
        return [array for quantity in found.values() for array in quantity]

    joints = ROBOT.inverse_displacement(place, turn)
    for name, function, columns in (
        ("of_point", lambda *g: states(*g).of_point([0.1, 0.2, 0.3])[1:], (SIX, OTHERS)),
        ("inverse_motion", backwards, (SIX, OTHERS)),
        ("watch", watched, (joints,)),
    ):
        calls[name] = rowwise(name, function, (place, turn, *columns), single=False)
    return calls


MOTIONS = motions()


@pytest.mark.long
@pytest.mark.parametrize("name", MOTIONS)
def test_motions(name: str) -> None:
    assert not len(differing(MOTIONS[name]))


def test_tracks_of_any_layout_on_any_number_of_threads() -> None:
    joints = example_1().sampled(500).joints
    found = set()
    for threads in (1, 2):
        kleinform.set_threads(threads)
        for layout in LAYOUTS:
            own = laid_out(joints, np.arange(len(joints)), layout)
            found.add(tuple(array.tobytes() for array in ROBOT.track(own, mode=0)))
    kleinform.set_threads(None)
    assert len(found) == 1


@pytest.mark.parametrize("threads", [1, 2])
def test_large_batches_in_parts(threads: int) -> None:
    """Larger than what one thread takes at once: poses, and joint values."""
    copies = 70_000 // COUNT + 1
    kleinform.set_threads(threads)
    large = ROBOT.survey(np.tile(POSITION, (copies, 1)), np.tile(ROTATION, (copies, 1, 1)))
    joints = joint_values(np.random.default_rng(26), 64)
    modes = ROBOT.forward_displacement_batch(np.tile(joints, (20, 1)))
    kleinform.set_threads(None)
    for one, other in zip(surveyed(large), surveyed(ROBOT.survey(*BOTH)), strict=True):
        assert one.tobytes() == other.tobytes() * copies
    few = ROBOT.forward_displacement_batch(joints)
    for name in (*MODES, "status_codes", "direct_determinant"):
        assert getattr(modes, name).tobytes() == getattr(few, name).tobytes() * 20
