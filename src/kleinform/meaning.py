"""What a singular pose means: geometry in words, and the motions that nothing controls.

What coincides does so within rounding: a rank counts singular values above the rounding of the
lines S_i, which is ``rounding eps (a + 2 q6) / (p_i² |d_i − b_i|)`` for their directions and
``rounding eps / p_i²`` for their points in units of a + 2 q6, with p_i = n_i·u_i.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kleinform.codes import PoseClass, degenerate_limbs
from kleinform.generated import kernels
from kleinform.pose import Pose
from kleinform.results import Survey
from kleinform.zero import threshold

__all__ = ["OnePose"]

Array = NDArray[np.float64]

#: The directions of the limbs in the base plane, or in that of the platform, a row each.
STAR = np.array([[1.0, 0.0], [-0.5, 0.75**0.5], [-0.5, -(0.75**0.5)]])
AZIMUTH, ELEVATION = 3, 4
#: Of what words show, in units of a + 2 q6.
DECIMALS = 9


class OnePose:
    """One pose of any class."""

    @np.errstate(all="ignore")
    def __init__(self, code: PoseClass, pose: Pose, survey: Survey) -> None:
        self.code = code
        self.limbs = degenerate_limbs(survey.result, pose.radius, pose.rounding)
        self.vanishing = survey.vanishing()
        self.joints = survey.joints
        self.extension = survey.extension
        self.position = pose.position
        self.unit = float(pose.radius + 2.0 * survey.joints[5])
        self.directions = STAR @ pose.rotation[:, :2].T
        self.axes = STAR @ np.eye(3)[:2]
        geometry = kernels.limb_geometry(pose.radius, pose.position, pose.rotation)
        self.lines, self.feet = geometry.lines[:, :3], geometry.d
        platform_joints = pose.position + self.extension[:, np.newaxis] * self.directions
        spans = np.linalg.norm(self.feet - platform_joints, axis=1) / self.unit
        losses = np.maximum(1.0, 1.0 / spans) / np.sum(self.directions * self.axes, axis=1) ** 2
        directed = ~(self.limbs.parallel | self.limbs.legless)
        self.tolerance = threshold(pose.rounding) * losses[directed].max(initial=1.0)

    # Motions ----------------------------------------------------------------------------

    def idle(self) -> Array:
        """Joint rates (k, 6) that move nothing, unit vectors."""
        still = np.zeros(6, dtype=bool)
        still[:3] = self.limbs.parallel
        still[AZIMUTH] = self.vanishing["central"]
        still[ELEVATION] = self.joints[5] == 0.0
        return np.eye(6)[still & (self.code != PoseClass.INVALID)]

    def uncontrollable(self) -> Array:
        """Twists (k, 6) with all joints locked, an orthonormal basis."""
        if not self.code & PoseClass.DIRECT:
            return np.zeros((0, 6))
        _, sizes, axes = np.linalg.svd(self._constraints())
        free = sizes <= self.tolerance
        # The factor that vanishes is what says so; rounding could leave the last one larger.
        free[2] |= not self.code & PoseClass.LIMB
        return np.hstack([axes[free], np.zeros((int(free.sum()), 3))])

    def _constraints(self) -> Array:
        """Vectors that the angular velocity is normal to as long as all joints are locked."""
        rows = [np.zeros((3, 3))]
        for i, n in enumerate(self.directions):
            if self.limbs.extended[i]:
                continue
            if self.limbs.parallel[i]:  # S_i along u_i
                rows.append(np.cross(n, self.axes[i])[np.newaxis])
            elif self.limbs.legless[i]:  # every line through A_i that is normal to n_i
                rows.append(np.eye(3) - np.outer(n, n))
            else:
                rows.append(np.cross(n, self.lines[i])[np.newaxis])
        return np.concatenate(rows)

    # Words ------------------------------------------------------------------------------

    def meaning(self) -> list[str]:
        """A line for each thing that is singular."""
        if self.code == PoseClass.INVALID:
            return ["no pose: the row was refused"]
        words = self._central()
        for i in range(3):
            words += self._limb(i)
        if self.code & PoseClass.DIRECT and self._orientation():
            words += self._lines()
        return words

    def _orientation(self) -> bool:
        return bool(self.vanishing["orientation"]) and not self.code & PoseClass.LIMB

    def _central(self) -> list[str]:
        words = []
        if self.joints[5] == 0.0:
            words.append("C is at O, the central limb has no direction: q4 and q5 move nothing")
        elif self.vanishing["central"]:
            degrees = 90 if self.position[2] > 0.0 else -90
            words.append(
                f"the central limb is on the Z axis, elevation {degrees}°: q4 moves nothing"
            )
        if self.vanishing["wrist"]:
            words.append(
                "the central limb lies in the platform's plane, (n_1 × n_2)·λ = 0: passive, it "
                "cancels in the velocity map"
            )
        return words

    def _limb(self, i: int) -> list[str]:
        k = i + 1
        words = []
        if self.limbs.parallel[i]:
            words.append(f"n_{k} is parallel to the plane of leg {k}: " + self._slides(i))
        elif self.limbs.legless[i]:
            words.append(
                f"q{k} = 0: B_{k} and D_{k} are at A_{k}, the leg has no direction and the "
                "limb's screws have rank 5"
            )
        if self.limbs.extended[i]:
            words.append(f"e_{k} = 0: B_{k} is at C, and S_{k} passes through C")
        return words

    def _slides(self, i: int) -> str:
        k = i + 1
        if np.isnan(self.extension[i]) or self.vanishing[f"extension_{k}"]:
            return f"C lies in it too, B_{k} is anywhere on its line and q{k} moves nothing"
        return f"B_{k} is at infinity"

    def _lines(self) -> list[str]:
        """How S_1, S_2, S_3 lie when their moments about C are dependent."""
        from_c = (self.feet - self.position) / self.unit
        words = []
        parallel = self._rank(self.lines) == 1
        if parallel:
            words.append("S_1, S_2 and S_3 are parallel")
        if self._rank(self.lines, from_c) <= 2:
            words.append("S_1, S_2, S_3 and C lie in one plane")
        else:
            for i, j in combinations(range(3), 2):
                if self._rank(self.lines[[i, j]], from_c[[i, j]]) <= 2:
                    words.append(f"S_{i + 1}, S_{j + 1} and C lie in one plane")
        if not parallel:
            words += self._meeting(from_c)
        free = self.uncontrollable()
        if len(free) == 1:
            axis = _triple(np.round(free[0, :3], DECIMALS))
            words.append(
                f"the axis through C along {axis} meets S_1, S_2 and S_3 or is parallel to them: "
                "the platform turns about it"
            )
        return words

    def _rank(self, *vectors: Array) -> int:
        stacked = np.concatenate(vectors)
        sizes = np.linalg.svd(stacked, compute_uv=False)
        return int(np.sum(sizes > np.sqrt(len(stacked)) * self.tolerance))

    def _meeting(self, points: Array) -> list[str]:
        """The point that all lines pass through, if there is one."""
        across = np.eye(3) - self.lines[:, :, np.newaxis] * self.lines[:, np.newaxis, :]
        targets = np.einsum("ijk,ik->ij", across, points)
        nearest = np.linalg.lstsq(across.reshape(9, 3), targets.ravel())[0]
        away = np.linalg.norm(np.einsum("ijk,ik->ij", across, nearest - points), axis=1)
        if np.any(away > self.tolerance * (1.0 + np.linalg.norm(nearest - points, axis=1))):
            return []
        meeting = self.unit * np.round(self.position / self.unit + nearest, DECIMALS)
        return [f"S_1, S_2 and S_3 meet in the point {_triple(meeting)}"]


def _triple(vector: Array) -> str:
    return "({:.6g}, {:.6g}, {:.6g})".format(*(vector + 0.0))
