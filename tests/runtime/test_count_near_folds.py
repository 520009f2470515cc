"""The number of modes within an ulp or a hundred of a fold, beside a count in balls.

Joint values of poses at which modes merge, one of them moved by some ulp. What the solver
says is the count of exactly these float64 values (with a tolerance: of some joint values
within it), or that it is undecided.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kleinform import AssemblyModes, UncoupledManipulator
from kleinform.joints import TOLERANCE
from tests.runtime.modes_support import SPREADS, double_root_within, posed, poses_on_the_locus
from tests.runtime.true_count import true_count
from tests.support import BASE_AXES, EPS, many

ROBOT = UncoupledManipulator()
STEPS = (0, 1, -1, 2, -2, 10, -10, 100, -100)
#: Counts that a search from outside found wrong.
KNOWN = {
    (
        5.044988482593572,
        2.2969302749048603,
        2.296930264063669,
        0.0,
        -1.5502527085771662,
        1.425919192844184,
    ): 16,
    (
        0.2386739128570893,
        1.1544885577114092,
        8.676567960776802,
        -0.6164172696984916,
        -0.8021336464751606,
        1.4691412644730875,
    ): 2,
    (
        1.019803902718557,
        1.0488928783194318,
        1.0067639891309077,
        0.6747409422235527,
        1.2609516870532695,
        1.05,
    ): 4,
    (
        0.7457557637843909,
        0.8217596225091961,
        0.7231583545023934,
        0.6279497650354187,
        1.0208719234217316,
        0.8229799439473606,
    ): 2,
    (
        1.6126816629627323,
        1.3331521711419239,
        2.8843327579309066,
        1.1726464167825585,
        0.3550130386241244,
        0.9506174145532926,
    ): 16,
}


def anywhere(rng: np.random.Generator, count: int) -> np.ndarray:
    parts = [
        poses_on_the_locus(rng, max(count, 40), spread)[0].joints[: -(-count // 3)]
        for spread in SPREADS
    ]
    return np.concatenate(parts)[:count]


def level(rng: np.random.Generator, count: int) -> np.ndarray:
    """R = 1, where two modes merge wherever C is."""
    position = rng.normal([0.0, 0.0, 1.0], 0.4, (count, 3))
    return posed(position, np.tile(np.eye(3), (count, 1, 1))).joints


def pitched(rng: np.random.Generator, count: int) -> np.ndarray:
    """Poses that are their own mirror image: C in the XZ plane, and a pure pitch."""
    position = rng.normal([0.0, 0.0, 1.0], 0.5, (count, 3)) * [1.0, 0.0, 1.0]
    pitch = Rotation.from_euler("Y", rng.uniform(-1.2, 1.2, count)[:, np.newaxis])
    return posed(position, pitch.as_matrix(), least=1e-3).joints


def by_a_plane(rng: np.random.Generator, count: int) -> np.ndarray:
    """R = 1 and C near the plane of a leg, down to 1e-9 of it."""
    axis = BASE_AXES[rng.integers(3, size=count)]
    position = rng.normal([0.0, 0.0, 1.0], 0.4, (count, 3))
    away = 10.0 ** rng.uniform(-9.0, -2.0, count) * rng.choice([-1.0, 1.0], count)
    away += 1.0 - np.sum(position * axis, axis=1)
    position += away[:, np.newaxis] * axis
    return posed(position, np.tile(np.eye(3), (count, 1, 1))).joints


FAMILIES = {"anywhere": anywhere, "level": level, "pitched": pitched, "by a plane": by_a_plane}
#: Joint values of each; close to a plane they take a hundred times as long.
COUNTS = {
    "anywhere": many(25, 800),
    "level": many(25, 800),
    "pitched": many(25, 800),
    "by a plane": many(6, 150),
}
Family = Callable[[np.random.Generator, int], np.ndarray]


def stepped(rng: np.random.Generator, joints: np.ndarray) -> tuple[np.ndarray, int]:
    """The joint values with one of them some ulp away, and how many."""
    ulps, moved, joint = int(rng.choice(STEPS)), joints.copy(), int(rng.integers(6))
    for _ in range(abs(ulps)):
        moved[joint] = np.nextafter(moved[joint], np.inf * ulps)
    return moved, abs(ulps)


def searched(
    family: Family, seed: int, count: int, judge: Callable[[np.ndarray], str]
) -> Counter[str]:
    rng = np.random.default_rng(seed)
    found: Counter[str] = Counter()
    for joints in family(rng, count):
        moved, ulps = stepped(rng, joints)
        verdict = judge(moved)
        found[f"{verdict}, {'far' if ulps > 20 else 'near'}"] += 1
        if verdict.startswith("wrong"):
            print(verdict, moved.tolist(), ulps)
    print(dict(found))
    return found


def exactly(joints: np.ndarray) -> str:
    """Tolerance 0: the count of these very numbers."""
    modes = ROBOT.forward_displacement(joints, tolerance=0.0)
    return judged(modes, true_count(joints.tolist()))


def judged(modes: AssemblyModes, truth: int | None) -> str:
    if modes.status == "undecided":
        return "undecided"
    if truth is None:
        return "unknown"
    simple = np.all(modes.multiplicity == 1) and (modes.status == "none") == (truth == 0)
    return "right" if simple and len(modes) == truth else f"wrong {len(modes)} for {truth}"


def test_known_ones() -> None:
    for joints, count in KNOWN.items():
        assert true_count(list(joints)) == count
        assert exactly(np.array(joints)) == "right"


@pytest.mark.long
@pytest.mark.parametrize("family", FAMILIES)
def test_exact_joint_values(family: str) -> None:
    found = searched(FAMILIES[family], 11, COUNTS[family], exactly)
    assert not [verdict for verdict in found if verdict.startswith("wrong")]
    # Close to a plane rounding may hide more, which is no wrong answer.
    if family != "by a plane":
        assert found["undecided, far"] <= 0.25 * (found["right, far"] + found["undecided, far"])


def within(tolerance: float) -> Callable[[np.ndarray], str]:
    """A double root within the tolerance, or the count of these very numbers."""

    def judge(joints: np.ndarray) -> str:
        modes = ROBOT.forward_displacement(joints, tolerance=tolerance)
        if modes.status != "merged":
            return judged(modes, true_count(joints.tolist()))
        double = modes.directions[modes.multiplicity == 2]
        away = max(double_root_within(joints, directions) for directions in double)
        inside = away * EPS <= tolerance * (1.0 + 1e-9)
        return "right" if inside else f"wrong, a double root {away:.2f} eps away"

    return judge


@pytest.mark.long
@pytest.mark.parametrize("family", ["anywhere", "level", "pitched"])
@pytest.mark.parametrize("tolerance", [0.25 * EPS, TOLERANCE, 100.0 * EPS])
def test_joint_values_within_a_tolerance(family: str, tolerance: float) -> None:
    found = searched(FAMILIES[family], 12, many(10, 200), within(tolerance))
    assert not [verdict for verdict in found if verdict.startswith("wrong")]
    assert found["undecided, far"] + found["undecided, near"] <= 0.1 * sum(found.values())


def certified(joints: np.ndarray) -> str:
    """Modes, certificate and truth: no two of them disagree."""
    modes = ROBOT.forward_displacement(joints, tolerance=0.0, certify=True)
    proof, truth = modes.certificate, true_count(joints.tolist())
    assert proof is not None
    if truth is not None and (proof.real > truth or (proof.complete and proof.real != truth)):
        return f"wrong, {proof.real} proven for {truth}"
    if modes.status != "undecided":
        for center, radius in zip(
            proof.centers[proof.is_real].real, proof.radii[proof.is_real], strict=True
        ):
            listed = modes.directions[:, :2]
            gaps = [abs(listed - sign * center).max(axis=(1, 2)) for sign in (1.0, -1.0)]
            # Beside a fold float64 knows a mode to its eps over the distance from the fold.
            if not np.min(gaps, initial=np.inf) <= radius + 1e-6:
                return "wrong, a mode that is proven is not listed"
        if len(modes) < proof.real or (proof.complete and len(modes) != proof.real):
            return f"wrong, {len(modes)} listed and {proof.real} proven"
    return judged(modes, truth)


@pytest.mark.long
@pytest.mark.parametrize("family", FAMILIES)
def test_with_a_certificate(family: str) -> None:
    found = searched(FAMILIES[family], 13, COUNTS[family] // 6, certified)
    assert not [verdict for verdict in found if verdict.startswith("wrong")]


@pytest.mark.parametrize(
    "joints",
    [
        np.zeros(6),
        # q_1 = 0 with C at A_1, and C on the circle of B_1.
        np.array([0.0, 1.0, 1.0, 0.0, 0.0, 1.0]),
        np.array([1.0, 1.0, 1.0, 0.0, np.pi / 4.0, np.sqrt(2.0)]),
    ],
)
def test_without_a_tolerance_nothing_says_that_equations_agree(joints: np.ndarray) -> None:
    modes = ROBOT.forward_displacement(joints, tolerance=0.0)
    assert (modes.status, len(modes)) == ("undecided", 0)
