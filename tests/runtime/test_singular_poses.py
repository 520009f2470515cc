"""Which call raises at what: every row of the table in the design notes."""

from __future__ import annotations

import numpy as np
import pytest

from kleinform import (
    SingularityWarning,
    SingularPoseError,
    UncoupledManipulator,
    rotation_from_rpy,
)
from tests.support import BASE_AXES

ROBOT = UncoupledManipulator()
PLACE = np.array([0.25, 0.2, 1.0])
TURN = rotation_from_rpy(roll=np.deg2rad(10.0), pitch=np.deg2rad(3.0), yaw=np.deg2rad(6.0))
LEVEL = rotation_from_rpy(roll=0.3, pitch=0.0, yaw=0.0)
ONES = np.ones(6)

DISPLACEMENT = ROBOT.inverse_displacement
CALLS = {
    "inverse_displacement": DISPLACEMENT,
    "screws": ROBOT.screws,
    "jacobians": ROBOT.jacobians,
    "inverse_velocity": lambda c, turn, **more: ROBOT.inverse_velocity(c, turn, ONES, **more),
    "forward_velocity": lambda c, turn, **more: ROBOT.forward_velocity(c, turn, ONES, **more),
}
ANALYSES = (ROBOT.inverse_singularity, ROBOT.direct_singularity, ROBOT.survey)
ALL = set(CALLS)
LEGS = ALL - {"inverse_displacement"}


def quarter(i: int) -> np.ndarray:
    """Yaw 90°, pitch for the limb to be the only one with n_i·u_i = 0 is not needed: all are."""
    third = rotation_from_rpy(roll=0.0, pitch=0.0, yaw=2.0 * np.pi / 3.0 * i)
    tilted = rotation_from_rpy(roll=0.4, pitch=0.0, yaw=np.pi / 2.0)
    return third @ tilted @ third.T


def in_plane(i: int) -> np.ndarray:
    """C with c·u_i = a."""
    return BASE_AXES[i] + 0.3 * np.cross([0.0, 0.0, 1.0], BASE_AXES[i]) + [0.0, 0.0, 1.0]


def at_base(i: int) -> tuple[np.ndarray, np.ndarray]:
    """A pose with B_i at A_i, so that q_i = 0: n_i = u_i and C on the axis of limb i."""
    third = rotation_from_rpy(roll=0.0, pitch=0.0, yaw=2.0 * np.pi / 3.0 * i)
    return 0.25 * BASE_AXES[i], third @ LEVEL @ third.T


#: Name: pose, the calls that raise, what the message says.
POSES = {
    **{
        f"n_{i + 1}·u_{i + 1} = 0": (PLACE, quarter(i), ALL, rf"n_{i + 1}·u_{i + 1} = 0, B_{i + 1}")
        for i in range(3)
    },
    **{f"q_{i + 1} = 0": (*at_base(i), LEGS, rf"q_{i + 1} = 0, leg {i + 1}") for i in range(3)},
    **{
        f"e_{i + 1} = 0": (in_plane(i), TURN, {"forward_velocity"}, rf"direct .*, e_{i + 1} = 0")
        for i in range(3)
    },
    "identity": (PLACE, np.eye(3), {"forward_velocity"}, r"direct singularity, det\[n_i"),
    "axis": (np.array([0.0, 0.0, 1.0]), TURN, ALL, "on the Z axis|q6 cos q5 = 0"),
    "almost axis": (np.array([1e-17, -1e-17, 1.0]), TURN, ALL, "on the Z axis|q6 cos q5 = 0"),
    "origin": (np.zeros(3), TURN, ALL, "q6 = 0|q6 cos q5 = 0"),
    "wrist": (TURN[:, 0] - TURN[:, 1], TURN, set(), ""),
    "regular": (PLACE, TURN, set(), ""),
}


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("call", CALLS)
def test_who_raises_at_what(call: str, pose: str) -> None:
    place, turn, raising, message = POSES[pose]
    if call in raising:
        with pytest.raises(SingularPoseError, match=message) as caught:
            CALLS[call](place, turn)
        assert caught.value.mask.shape == ()
        assert caught.value.mask
    else:
        results = CALLS[call](place, turn)
        assert np.isfinite(results if call != "screws" else np.stack(results)).all()


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("call", CALLS)
def test_who_gives_nan_at_what(call: str, pose: str) -> None:
    """The singular pose between two regular ones: its row is NaN, theirs are as without it."""
    place, turn, raising, _ = POSES[pose]
    places, turns = np.stack([PLACE, place, 2.0 * PLACE]), np.stack([TURN, turn, TURN])
    result = CALLS[call](places, turns, errors="nan")
    parts = [result] if isinstance(result, np.ndarray) else list(result)
    alone = CALLS[call](places[[0, 0, 2]], turns[[0, 0, 2]])
    expected = [alone] if isinstance(alone, np.ndarray) else list(alone)
    for part, regular in zip(parts, expected, strict=True):
        assert np.array_equal(part[[0, 2]], regular[[0, 2]])
        assert np.isnan(part[1]).all() == (call in raising)
        assert np.isnan(part[1]).any() == (call in raising)


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("analysis", ANALYSES, ids=lambda analysis: analysis.__name__)
def test_singularity_analyses_never_raise(analysis: object, pose: str) -> None:
    place, turn, _, _ = POSES[pose]
    for errors in ("raise", "nan"):
        result = analysis(place, turn, errors=errors)
        assert result.valid
        nan = {name for name, value in result.factors.items() if np.isnan(value)}
        allowed = {f"q_{i}": f"limb_{i}" for i in (1, 2, 3)} | {"origin": "wrist"}
        assert nan <= {allowed.get(pose[:3]), allowed.get(pose)}


@pytest.mark.parametrize(
    "call", ["inverse_displacement", "screws", "jacobians", "forward_velocity"]
)
def test_an_azimuth_settles_the_axis(call: str) -> None:
    results = CALLS[call](np.array([0.0, 0.0, 1.0]), TURN, azimuth=0.4)
    parts = [results] if isinstance(results, np.ndarray) else list(results)
    assert all(np.isfinite(part).all() for part in parts)
    with pytest.raises(SingularPoseError, match="q6 = 0, the central limb has no direction"):
        CALLS[call](np.zeros(3), TURN, azimuth=0.4)


def test_azimuth_is_q4() -> None:
    """On the axis q4 is the azimuth and the second central screw is normal to it."""
    place = np.array([0.0, 0.0, 1.0])
    assert DISPLACEMENT(place, TURN, azimuth=0.4)[3:].tolist() == [0.4, np.pi / 2.0, 1.0]
    second = ROBOT.screws(place, TURN, azimuth=0.4).screw(4, 2)
    assert second[:3] == pytest.approx([np.sin(0.4), -np.cos(0.4), 0.0], abs=1e-16)


def test_forward_velocity_at_the_axis_is_a_limit() -> None:
    """With an azimuth, the twist on the axis is that of poses closing in along it."""
    rates = np.arange(1.0, 7.0)
    near = 1e-8 * np.array([np.cos(0.4), np.sin(0.4), 0.0]) + [0.0, 0.0, 1.0]
    at_axis = ROBOT.forward_velocity([0.0, 0.0, 1.0], TURN, rates, azimuth=0.4)
    with pytest.warns(SingularityWarning, match="central 1e-08"):
        closing_in = ROBOT.forward_velocity(near, TURN, rates)
    assert at_axis == pytest.approx(closing_in, abs=1e-5)


@pytest.mark.parametrize(
    "call", ["inverse_displacement", "screws", "jacobians", "forward_velocity"]
)
def test_azimuths_broadcast(call: str) -> None:
    """Several azimuths for one pose, and one for several."""
    place, azimuths = np.array([0.0, 0.0, 1.0]), np.array([0.1, 0.2, 0.3])
    for errors in ("raise", "nan"):
        together = CALLS[call](place, TURN, azimuth=azimuths, errors=errors)
        alone = [CALLS[call](place, TURN, azimuth=azimuth) for azimuth in azimuths]
        if isinstance(together, np.ndarray):
            together, alone = [together], [[one] for one in alone]
        for index, part in enumerate(together):
            assert part.shape[0] == 3
            assert np.allclose(part, np.stack([one[index] for one in alone]), rtol=1e-15, atol=0)


def test_messages_count_and_name_the_first() -> None:
    """The first offending pose in row-major order and the number of them."""
    places = np.broadcast_to(PLACE, (2, 3, 3)).copy()
    places[0, 2], places[1, 1] = [0.0, 0.0, 1.0], [0.0, 0.0, 2.0]
    with pytest.raises(SingularPoseError, match=r"0\.0 arrived, .* \(0, 2\); 2 of 6 poses") as one:
        DISPLACEMENT(places, TURN)
    assert one.value.mask.tolist() == [[False, False, True], [False, True, False]]
    with pytest.raises(SingularPoseError, match=r"first at pose 2; 1 of 3 poses"):
        DISPLACEMENT(places[0], TURN)


def test_q4_is_in_its_documented_range() -> None:
    """[−π, π]: atan2 tells the zeros of c_y apart."""
    assert DISPLACEMENT([-0.5, 0.0, 1.0], TURN)[3] == np.pi
    assert DISPLACEMENT([-0.5, -0.0, 1.0], TURN)[3] == -np.pi
