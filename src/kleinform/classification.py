"""Classes of singular poses, and of one pose what they mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.codes import PoseClass, sound_survey_and_codes, survey_and_codes
from kleinform.errors import InputError
from kleinform.pose import Geometry, Pose, check_pose
from kleinform.results import Survey
from kleinform.screening import Errors, RotationLike, Screen

if TYPE_CHECKING:
    from kleinform.meaning import OnePose

__all__ = ["Classes", "PoseClass", "classify"]

Array = NDArray[np.float64]

#: The words for every code, in their order in the enumeration.
WORDS = (
    (PoseClass.COMBINED, "combined"),
    (PoseClass.INVERSE, "inverse"),
    (PoseClass.DIRECT, "direct"),
    (PoseClass.WRIST, "wrist"),
    (PoseClass.LIMB, "limb"),
    (PoseClass.INVALID, "invalid"),
)


def name_of(code: int) -> str:
    """``"regular"``, or the classes that add up to a code, as in ``"combined, wrist"``."""
    names, left = [], code
    for flag, word in WORDS:
        if left & flag == flag:
            names.append(word)
            left &= ~flag
    return ", ".join(names) or "regular"


@dataclass(eq=False, repr=False)
class Classes:
    """The classes of poses; of one pose also what they mean.

    Attributes
    ----------
    code : uint8 array (...)
        A sum of `PoseClass`: ``code & PoseClass.DIRECT`` tells the direct singularities.
    survey : Survey
        All factors, determinants and joint values.
    """

    code: NDArray[np.uint8]
    survey: Survey
    pose: Pose

    def __repr__(self) -> str:
        return f"Classes({np.array2string(self.names(), threshold=6)})"

    def names(self) -> NDArray[np.str_]:
        """The classes (...) as text: ``"regular"``, ``"direct"``, ``"combined, wrist"``, ..."""
        named: NDArray[np.str_] = np.array([name_of(code) for code in range(32)])[self.code]
        return named

    @property
    def meaning(self) -> list[str]:
        """The geometry of one pose in words, a line for each thing that is singular."""
        return self._one("meaning").meaning()

    @property
    def uncontrollable(self) -> Array:
        """An orthonormal basis (k, 6) of the twists that locked joints leave to one pose.

        Twists ``[omega, 0]`` with all joint rates zero; k = 0 away from direct singularities.
        C stands still in all of them, because the central limb alone moves it.
        """
        return self._one("uncontrollable").uncontrollable()

    @property
    def idle(self) -> Array:
        """A basis (k, 6) of the joint rates that move nothing of one pose: J_q q̇ = 0.

        Unit vectors, because J_q is diagonal once the wrist is left out; k = 0 away from
        inverse singularities.
        """
        return self._one("idle").idle()

    def _one(self, asked: str) -> OnePose:
        if self.code.shape:
            raise InputError(
                f"{asked}: one pose is needed, a batch of shape {self.code.shape} arrived: "
                "classify the one"
            )
        from kleinform.meaning import OnePose

        return OnePose(PoseClass(int(self.code)), self.pose, self.survey)


def classify(
    robot: Geometry, position: ArrayLike, rotation: RotationLike, errors: Errors
) -> Classes:
    """The classes of poses; no pose is refused for being singular."""
    found = sound_survey_and_codes(robot, position, rotation)
    if found is not None:
        result, codes = found
        screen = Screen(codes.shape, errors)
        place, turn = np.asarray(position), np.asarray(rotation)
        pose = Pose(robot.radius, robot.rounding, place, turn, None, screen)
        return Classes(codes, Survey(result, robot.rounding, screen), pose)
    pose = check_pose(robot, position, rotation, errors)
    result, codes = survey_and_codes(pose)
    pose.screen.blank(*result)
    return Classes(codes[()], Survey(result, pose.rounding, pose.screen), pose)
