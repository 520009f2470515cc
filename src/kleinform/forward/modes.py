"""What the forward displacement returns: assembly modes, of one set of joint values or many."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError
from kleinform.forward.solve import STATUS
from kleinform.generated import kernels
from kleinform.screening import RotationLike, one_rotation

if TYPE_CHECKING:
    from kleinform.forward.certificate import Certificate

__all__ = ["AssemblyModes", "AssemblyModesBatch"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Mask = NDArray[np.bool_]

MEANING = {
    "regular": "every solution is simple",
    "merged": "at least two solutions have merged: a direct singularity",
    "none": "no pose has these joint values",
    "infinite": "C is on the circle of B_i of a limb, which then holds nothing: the platform can "
    "move with all joints locked, and no mode is listed",
    "undecided": "rounding hides whether all solutions were found, and no mode is listed",
    "invalid": "the joint values were refused",
}


@dataclass(frozen=True, eq=False)
class AssemblyModes:
    """All assembly modes of one set of joint values.

    Of each pair ``±n`` of solutions one is listed, that with more ``e_i > 0`` than
    ``e_i < 0``; `reflected` gives the others. Feasible modes come first; then the order is
    that of the angle of leg 1 about A_1 (and of leg 2 where it ties), falling from 2π to 0.

    Attributes
    ----------
    radius : float
        Radius a of the base circle [m].
    joints : array (6,)
    position : array (3,)
        C, the same for all modes [m].
    rotation : array (m, 3, 3)
    directions : array (m, 3, 3)
        n_1, n_2, n_3 as rows.
    platform_joints : array (m, 3, 3)
        B_1, B_2, B_3 as rows [m].
    extension : array (m, 3)
        Signed distances e_i from C to B_i [m].
    direct_determinant : array (m,)
        det J_v [m³], near 0 where modes merge; computed when it is first asked for.
    multiplicity : int array (m,)
        How many solutions have merged in the mode, 1 if it is simple.
    tolerance : float
        The answer holds for some joint values within ``q_j (1 ± tolerance)``: solutions that
        merge there count as merged. 0: for the joint values as they are.
    status : str
        ``"regular"``, ``"merged"``, ``"none"``, ``"infinite"`` or ``"undecided"``.
    degenerate : tuple of str
        Limbs and members with something special: ``"c·u_1 = a"``, ``"q_2 = 0"``, ``"q_6 = 0"``.
    certificate : Certificate or None
        With ``certify=True``, the proof that nothing is missing, or why there is none.
    """

    radius: float
    joints: Array
    position: Array
    rotation: Array
    directions: Array
    platform_joints: Array
    extension: Array
    multiplicity: Integers
    tolerance: float
    status: str
    degenerate: tuple[str, ...]
    certificate: Certificate | None = None

    def __len__(self) -> int:
        return len(self.rotation)

    @cached_property
    def direct_determinant(self) -> Array:
        survey = kernels.survey(self.radius, self.position, self.rotation)
        return survey.direct_determinant

    @property
    def reason(self) -> str:
        """What the status means, in words."""
        return MEANING[self.status]

    @property
    def feasible(self) -> Mask:
        """Where every e_i > 0, so that every B_i lies on its own side of C (m,)."""
        return np.asarray((self.extension > 0.0).all(axis=1))

    def reflected(self) -> AssemblyModes:
        """The other solution of each pair: the same B_i, n_i and e_i with the other sign."""
        rotation = self.rotation * np.array([-1.0, -1.0, 1.0])
        return replace(
            self, rotation=rotation, directions=-self.directions, extension=-self.extension
        )

    def nearest(self, rotation: RotationLike) -> int:
        """Index of the mode, or its reflection, whose rotation is nearest to a given one.

        Raises
        ------
        InputError
            There is no mode.
        ShapeError, NotARotationError
        """
        given = one_rotation("rotation", rotation)
        if not len(self):
            raise InputError(f"nearest: there is no mode, the status is {self.status!r}")
        # The trace of RᵀS falls with the angle between R and S; −n turns two columns round.
        columns = np.einsum("mij,ij->mj", self.rotation, given)
        turned = columns[:, 2] - columns[:, 0] - columns[:, 1]
        return int(np.argmax(np.maximum(columns.sum(axis=1), turned)))


@dataclass(frozen=True, eq=False)
class AssemblyModesBatch:
    """The assembly modes of many joint values, one after the other.

    The modes of row i stand from ``offsets[i]`` to ``offsets[i + 1]`` in the flat arrays, which
    are those of `AssemblyModes`; ``batch[i]`` collects them.

    Attributes
    ----------
    radius : array (N,)
    joints : array (N, 6)
    position : array (N, 3)
    offsets : int array (N + 1,)
    rotation, directions, platform_joints : array (M, 3, 3)
    extension : array (M, 3)
    direct_determinant, multiplicity : array (M,)
    tolerance : float
    status_codes : int array (N,)
        Index into `STATUS`: 0 regular, 1 merged, 2 none, 3 infinite, 4 undecided, 5 invalid.
    degenerate_codes : bool array (N, 7)
        ``c·u_i = a`` (3), ``q_i = 0`` (3), ``q_6 = 0``.
    """

    radius: Array
    joints: Array
    position: Array
    offsets: Integers
    rotation: Array
    directions: Array
    platform_joints: Array
    extension: Array
    multiplicity: Integers
    tolerance: float
    status_codes: Integers
    degenerate_codes: Mask

    STATUS = STATUS
    DEGENERATE = (*(f"c·u_{i} = a" for i in (1, 2, 3)), "q_1 = 0", "q_2 = 0", "q_3 = 0", "q_6 = 0")

    def __len__(self) -> int:
        return len(self.joints)

    @cached_property
    def direct_determinant(self) -> Array:
        row = np.repeat(np.arange(len(self)), self.count)
        survey = kernels.survey(self.radius[row], self.position[row], self.rotation)
        return survey.direct_determinant

    @property
    def count(self) -> Integers:
        """Modes of each row (N,)."""
        return np.diff(self.offsets)

    @property
    def feasible(self) -> Mask:
        """Where every e_i > 0 (M,)."""
        return np.asarray((self.extension > 0.0).all(axis=1))

    def __getitem__(self, row: int) -> AssemblyModes:
        index = range(len(self))[row]
        modes = slice(self.offsets[index], self.offsets[index + 1])
        names = np.array(self.DEGENERATE)[self.degenerate_codes[index]]
        return AssemblyModes(
            float(self.radius[index]),
            self.joints[index],
            self.position[index],
            self.rotation[modes],
            self.directions[modes],
            self.platform_joints[modes],
            self.extension[modes],
            self.multiplicity[modes],
            self.tolerance,
            STATUS[self.status_codes[index]],
            tuple(map(str, names)),
        )
