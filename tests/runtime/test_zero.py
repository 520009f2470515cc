"""One rule for what counts as zero: every call says the same of every pose, to the last bit.

The rounding of the robot is set to the ratio |f|/scale of a factor as each kernel gives it, and
a few ulp beside it: so every factor of every pose is on its threshold once.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from kleinform import PoseClass, SingularPoseError, UncoupledManipulator
from kleinform.codes import by_numpy
from kleinform.generated import kernels
from kleinform.limits import Limits
from kleinform.motion.paths import Poses
from kleinform.motion.quantities import quantities
from kleinform_kernels.uncoupled import numpy_kernels
from tests.support import EPS, NEAR, Case, many, random_cases, scaled

TWIST = np.array([0.3, -0.2, 0.5, 0.1, 0.4, -0.6])
LIMBS = (1, 2, 3)
STEPS = (-2, -1, 0, 1, 2)
#: How far the poses are from what they are near to.
DISTANCES = (0.0, 3e-16, 3e-15, 1e-9, 1e-3)


def raises(call: Callable[..., object], *arguments: object, **options: object) -> bool:
    try:
        call(*arguments, **options)
    except SingularPoseError:
        return True
    return False


def ratios(case: Case) -> set[float]:
    """|f|/scale of every factor, as each kernel that judges it gives it."""
    survey = kernels.survey(*case)
    heading = case.position[:2] if case.position[:2].any() else np.array([1.0, 0.0])
    forward = kernels.forward_velocity(*case, heading, TWIST)
    # B_i is at infinity where n_i·u_i = 0.
    with np.errstate(all="ignore"):
        pairs = [
            *((getattr(survey, name), getattr(survey, f"{name}_scale"))
              for name in ("limb", "extension", "central", "wrist", "orientation")),
            *((getattr(forward, name), getattr(forward, f"{name}_scale"))
              for name in ("extension", "orientation")),
            (forward.incidence, 1.0),
            (forward.scaled_legs, forward.reach),
            (survey.joints[:3] * abs(forward.incidence), forward.reach),
            (forward.radial, forward.central_length),
        ]  # fmt: skip
        found = np.concatenate([np.ravel(abs(value) / scale) for value, scale in pairs])
    return {float(ratio) for ratio in found if np.isfinite(ratio)}


def stepped(value: float, steps: int) -> float:
    """A number some ulp beside, and not below zero."""
    for _ in range(abs(steps)):
        value = float(np.nextafter(value, np.inf if steps > 0 else 0.0))
    return value


def said(robot: UncoupledManipulator, case: Case) -> Iterator[tuple[str, bool, bool]]:
    """What two calls say of one thing, with its name."""
    place, turn = case.position, case.rotation
    survey, classes = robot.survey(place, turn), robot.classify(place, turn)
    code, zero = PoseClass(int(classes.code)), survey.vanishing()
    parallel = [bool(zero[f"limb_{i}"]) for i in LIMBS]
    limb, central = bool(code & PoseClass.LIMB), bool(zero["central"])
    extended = [bool(zero[f"extension_{i}"]) for i in LIMBS]
    direct = any(e and not p for e, p in zip(extended, parallel, strict=True))
    direct |= bool(zero["orientation"]) and not limb
    yield "inverse", bool(code & PoseClass.INVERSE), any(parallel) or central
    yield "direct", bool(code & PoseClass.DIRECT), direct
    yield "wrist", bool(code & PoseClass.WRIST), bool(zero["wrist"])
    batch = robot.classify(np.stack([place, place]), np.stack([turn, turn])).code
    yield "in a batch", bool((batch == code).all()), True
    on_numpy = by_numpy(numpy_kernels.survey(*case), robot.radius, robot.rounding)
    yield "by NumPy", int(on_numpy) == int(code), True
    for part in (robot.inverse_singularity(place, turn), robot.direct_singularity(place, turn)):
        for name, value in part.vanishing().items():
            yield f"{type(part).__name__} {name}", bool(value), bool(zero[name])
    at_origin = not place.any()
    yield from refusals(robot, case, parallel, limb, code, central, at_origin)
    watched = quantities(robot, Poses(place[None], turn[None], survey.joints[None]), Limits())
    met = {name: bool(abs(value[0]) <= size[0]) for name, (value, size) in watched.items()}
    for name in zero:
        # Where a limb has no platform joint the factors with a pole there say nothing.
        if name != "orientation" or not any(parallel):
            yield f"watch {name}", met[name], bool(zero[name])
    yield "watch leg", limb, any(parallel) or any(met[f"leg_{i}"] for i in LIMBS)


def refusals(
    robot: UncoupledManipulator,
    case: Case,
    parallel: list[bool],
    limb: bool,
    code: PoseClass,
    central: bool,
    at_origin: bool,
) -> Iterator[tuple[str, bool, bool]]:
    """Which calls refuse the pose, with what the classes say of it."""
    pose = case.position, case.rotation
    wrist, direct = bool(code & PoseClass.WRIST), bool(code & PoseClass.DIRECT)
    given = {"azimuth": 0.3}
    displacement, screws = robot.inverse_displacement, robot.screws
    yield "displacement", raises(displacement, *pose), any(parallel) or central
    yield "displacement az", raises(displacement, *pose, **given), any(parallel) or at_origin
    yield "screws", raises(screws, *pose), limb or central
    yield "screws az", raises(screws, *pose, **given), limb or at_origin
    yield "inverse velocity", raises(robot.inverse_velocity, *pose, TWIST), limb or central
    yield "joint rates", raises(robot.joint_rates, *pose, TWIST), limb or central or wrist
    forward = limb or direct or at_origin
    yield "forward az", raises(robot.forward_velocity, *pose, TWIST, **given), forward
    yield "forward", raises(robot.forward_velocity, *pose, TWIST), forward or central
    yield "forces", raises(robot.actuator_forces, *pose, TWIST), forward or central
    yield "wrench", raises(robot.platform_wrench, *pose, TWIST), limb or central


def poses(rng: np.random.Generator, count: int) -> Iterator[Case]:
    """Random ones, and ones on and next to every kind of singular one, of any size."""
    for number in range(count):
        family = [*NEAR, None][number % (len(NEAR) + 1)]
        distance = DISTANCES[number // (len(NEAR) + 1) % len(DISTANCES)]
        case = NEAR[family](rng, distance) if family else random_cases(rng, 1)[0]
        yield scaled(case, (1.0, 1e-3, 1e3)[number % 3])


def search(count: int, seed: int) -> tuple[int, dict[str, int]]:
    """How often it was looked, and how many disagreements there were by what was compared."""
    looked, found = 0, {}
    for case in poses(np.random.default_rng(seed), count):
        for ratio, steps in itertools.product(ratios(case), STEPS):
            robot = UncoupledManipulator(case.radius, rounding=stepped(ratio / EPS, steps))
            for name, one, other in said(robot, case):
                looked += 1
                if one != other:
                    found[name] = found.get(name, 0) + 1
    return looked, found


@pytest.mark.long
@pytest.mark.filterwarnings("ignore:near a singularity")
def test_all_calls_say_the_same_on_every_threshold() -> None:
    looked, found = search(many(16, 1000), seed=5)
    assert looked >= 20_000
    assert found == {}


def stepped_poses(rng: np.random.Generator, count: int) -> Iterator[Case]:
    """Poses as near to a singular one as float64 can tell, a coordinate some ulp beside."""
    for number in range(count):
        family = [*NEAR][number % len(NEAR)]
        case = NEAR[family](rng, 0.0)
        place = case.position.copy()
        axis = int(rng.integers(3))
        place[axis] += int(rng.integers(-80, 81)) * np.spacing(place[axis])
        yield Case(1.0, place, case.rotation)


@pytest.mark.long
@pytest.mark.filterwarnings("ignore:near a singularity")
def test_all_calls_say_the_same_next_to_singular_poses() -> None:
    robot, found = UncoupledManipulator(), {}
    for case in stepped_poses(np.random.default_rng(6), many(400, 20_000)):
        for name, one, other in said(robot, case):
            if one != other:
                found[name] = found.get(name, 0) + 1
    assert found == {}
