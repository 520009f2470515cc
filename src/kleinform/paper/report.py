"""Each printed number beside the computed one, with its difference and a verdict."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kleinform import AssemblyModes, UncoupledManipulator, rotation_from_rpy, rpy_from_rotation
from kleinform.generated import kernels
from kleinform.homotopy import quadratics, solve
from kleinform.motion import rest_to_rest_coefficients
from kleinform.paper import printed
from kleinform.paper.examples import example_1, example_2

__all__ = [
    "Row",
    "closure_rows",
    "geometry_rows",
    "motion_rows",
    "pose_rows",
    "report",
    "table_2_rows",
]

Array = NDArray[np.float64]
ROBOT = UncoupledManipulator(radius=printed.RADIUS)


@dataclass(frozen=True)
class Row:
    """One printed number, or one claim about a motion."""

    item: str
    printed: str
    computed: str
    difference: float
    verdict: str

    @property
    def confirmed(self) -> bool:
        return self.verdict.startswith("confirmed")


def count(item: str, text: str, computed: int) -> Row:
    """A printed number of things against the number that was found."""
    difference = computed - int(text)
    verdict = f"corrected: {computed}" if difference else "confirmed"
    return Row(item, text, str(computed), difference, verdict)


def compare(item: str, text: str, computed: float) -> Row:
    """A printed number against the computed one, to the digits that are printed."""
    places = len(text.partition(".")[2])
    unit = 10.0**-places
    difference = computed - float(text)
    if abs(difference) <= 0.5 * unit * (1.0 + 1e-9):
        verdict = "confirmed"
    elif 0.0 < np.sign(computed) * difference < unit:
        verdict = "confirmed (truncated)"
    else:
        verdict = f"corrected: {computed:.{places}f}"
    return Row(item, text, f"{computed:.{max(places + 2, 5)}f}", difference, verdict)


def reached(item: str, intended: float, computed: float, tolerance: float) -> Row:
    """What a motion was meant to reach, and what it reaches with the printed coefficients."""
    difference = computed - intended
    verdict = "confirmed" if abs(difference) <= tolerance else f"missed: {computed:.5g}"
    return Row(item, f"{intended:g}", f"{computed:.5f}", difference, verdict)


def bound(item: str, claim: str, value: float, limit: float) -> Row:
    """A difference that should not exceed a limit."""
    verdict = "confirmed" if value <= limit else "refuted"
    shown = f"< {limit:.0e}" if value <= limit else f"{value:.1e}"
    return Row(item, claim, shown, value, verdict)


def rotation_of(angles: tuple[float, float, float]) -> Array:
    """The rotation of roll, pitch, yaw in degrees."""
    roll, pitch, yaw = np.radians(angles)
    return rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)


def start_joints() -> Array:
    """Joint values of the paper's pose, at full precision."""
    rotation = rotation_of(printed.ROLL_PITCH_YAW_DEGREES)
    return ROBOT.inverse_displacement(printed.POSITION, rotation)


def end_joints() -> Array:
    """Joint values at the end of Example 2."""
    rotation = rotation_of(printed.END_ROLL_PITCH_YAW_DEGREES)
    return ROBOT.inverse_displacement(printed.END_POSITION, rotation)


def pose_rows() -> Iterator[Row]:
    """Section VI, first part: inverse displacement and e_i."""
    survey = ROBOT.survey(printed.POSITION, rotation_of(printed.ROLL_PITCH_YAW_DEGREES))
    values = survey.joints.copy()
    values[3:5] = np.degrees(values[3:5])
    for (name, text), value in zip(printed.JOINTS.items(), values, strict=True):
        yield compare(name, text, float(value))
    for (name, text), value in zip(printed.EXTENSIONS.items(), survey.extension, strict=True):
        yield compare(name, text, float(value))


def geometry_rows() -> Iterator[Row]:
    """Section VI: the directions u_i, the points A_i, and C regained by (1)."""
    sine = float(np.sqrt(3.0) / 2.0)
    for name, text, value in (
        ("u_2, X", "-0.5", -0.5),
        ("u_2, Y", "0.866", sine),
        ("u_3, Y", "-0.866", -sine),
        ("A_2, Y", "0.866", printed.RADIUS * sine),
        ("A_3, Y", "-0.866", -printed.RADIUS * sine),
    ):
        yield compare(name, text, value)
    position = kernels.central_forward(start_joints()[3:]).position
    for axis, text, value in zip("XYZ", ("0.25", "0.2", "1.0"), position, strict=True):
        yield compare(f"{axis} of C by (1)", text, float(value))


def closure_rows() -> Iterator[Row]:
    """Table 1: each row put back into the closure equations, then beside all assembly modes."""
    joints = start_joints()
    modes = ROBOT.forward_displacement(joints)
    yield count("real solutions, one of each pair", str(len(printed.TABLE_1)), len(modes))
    for number, row in enumerate(printed.TABLE_1, start=1):
        points = np.array(row, dtype=np.float64)
        name = f"Table 1, row {number}"
        squares = np.einsum("ij,ij->i", points, points)
        residual = float(abs(squares - printed.RADIUS**2 - joints[:3] ** 2).max())
        # Six printed digits, truncated: each square is off by up to 2e-6 times its root.
        yield bound(f"{name}: closure (6)", "b_i·b_i = a² + q_i²", residual, 5e-6)
        for limb in range(3):
            for axis in range(3):
                item = f"{name}: {'XYZ'[axis]} of B_{limb + 1}"
                computed = float(modes.platform_joints[number - 1, limb, axis])
                yield compare(item, row[limb][axis], computed)
    yield from _homotopy_rows(modes)


def _homotopy_rows(modes: AssemblyModes) -> Iterator[Row]:
    """The same by the paper's own method: continuation of all paths of the six quadratics."""
    cones = np.stack(kernels.cones(printed.RADIUS, modes.position, modes.joints[:3]))
    ends = solve(quadratics(cones.astype(np.complex128)), (2,) * 6, seed=0)
    regular = ends.status == "regular"
    x = ends.points[regular]
    pairs = x[:, 1:] / x[:, :1]
    real = pairs[abs(pairs.imag).max(axis=1) <= 1e-9].real.reshape(-1, 1, 2, 3)
    yield count("homotopy: regular ends of its paths", "64", int(regular.sum()))
    yield count("homotopy: real ends, in pairs ±n", "8", len(real))
    both = np.concatenate([modes.directions[:, :2], -modes.directions[:, :2]])
    apart = abs(real - both).max(axis=(2, 3)).min(axis=1)
    yield bound("homotopy: real ends", "the modes above", float(apart.max(initial=0.0)), 1e-12)


def table_2_rows() -> Iterator[Row]:
    """Table 2: the coefficients derived from the two poses."""
    every = rest_to_rest_coefficients(start_joints(), end_joints(), printed.END_TIME)
    derived = every[:, [0, 3, 4, 5]]
    for joint, (texts, values) in enumerate(zip(printed.TABLE_2, derived, strict=True), start=1):
        for power, text, value in zip((0, 3, 4, 5), texts, values, strict=True):
            yield compare(f"Table 2: mu_{joint},{power}", text, float(value))


def motion_rows(samples: int = 201) -> Iterator[Row]:
    """Both motions tracked from the paper's pose; the joint values of every pose put back."""
    start = rotation_of(printed.ROLL_PITCH_YAW_DEGREES)
    for name, motion in (("Example 1", example_1()), ("Example 2", example_2())):
        joints = motion.sampled(samples).joints
        positions, rotations = ROBOT.track(joints, start)
        back = ROBOT.inverse_displacement(positions, rotations)
        worst = float(abs(back - joints).max())
        yield bound(f"{name}: {samples} poses tracked", "joint values regained", worst, 1e-12)
        yield from _landmarks(name, positions, rotations)


def _landmarks(name: str, positions: Array, rotations: Array) -> Iterator[Row]:
    """Where a motion begins or ends, beside the pose that the paper means."""
    first = name == "Example 1"
    index, when = (0, "t = 0") if first else (-1, "t = 5 s")
    angles = printed.ROLL_PITCH_YAW_DEGREES if first else printed.END_ROLL_PITCH_YAW_DEGREES
    place = printed.POSITION if first else printed.END_POSITION
    found = np.degrees(rpy_from_rotation(rotations[index]))
    for angle, value, intended in zip(("roll", "pitch", "yaw"), found, angles, strict=True):
        yield reached(f"{name}: {angle} at {when} [deg]", intended, float(value), 5e-3)
    for axis, value, intended in zip("XYZ", positions[index], place, strict=True):
        yield reached(f"{name}: {axis} of C at {when}", intended, float(value), 5e-4)


def report() -> dict[str, list[Row]]:
    """Every row, by the part of the paper that it belongs to."""
    return {
        "Geometry and C (Section VI)": list(geometry_rows()),
        "Inverse displacement and e_i (Section VI)": list(pose_rows()),
        "Table 1, coordinates of B_i": list(closure_rows()),
        "Table 2, coefficients of Example 2": list(table_2_rows()),
        "Worked motions": list(motion_rows()),
    }
