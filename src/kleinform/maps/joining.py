"""Whether two assembly modes of the same joint values can be joined without a singularity.

Along any motion that meets no direct singularity, and neither n_i·u_i = 0 nor q_i = 0, the
signs of e_1, e_2, e_3 and of the orientation factor stay: modes that differ in one of them cannot
be joined so. Where they agree, a way is looked for with C at rest: the platform turns straight
from one mode to the other, or through orientations in between. What is found is proven in ball
arithmetic (extra ``certify``).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kleinform.errors import InputError, MissingExtraError
from kleinform.forward.modes import AssemblyModes
from kleinform.manipulator import UncoupledManipulator
from kleinform.motion import PoseMotion
from kleinform.motion.clock import checked_span
from kleinform.screening import is_whole

try:
    from scipy.spatial.transform import Rotation, Slerp
except ModuleNotFoundError as missing:  # pragma: no cover
    raise MissingExtraError("joining needs SciPy: pip install 'kleinform[maps]'") from missing

__all__ = ["Joining", "join_modes"]

Array = NDArray[np.float64]
#: Samples of a turn, and orientations that are tried in between.
SAMPLES = 65
TRIED = 400
NEIGHBOURS = 12
INVARIANTS = ("e_1", "e_2", "e_3", "the orientation factor")


@dataclass(frozen=True, eq=False)
class Joining:
    """A way from one assembly mode to another, or why there is none.

    Attributes
    ----------
    position : array (3,)
        C, at rest [m].
    rotations : array (k, 3, 3)
        From the one mode to the other; between two of them the platform turns about one axis.
        Empty if no way was found.
    radius : float
        Of the robot [m].
    reason : str
        What was found, or why nothing was.
    least : dict of name to float
        The least size of the direct factors ``orientation`` [m³] and ``extension`` [m] over
        samples of the way.
    """

    position: Array
    rotations: Array
    radius: float
    reason: str
    least: dict[str, float]

    def __bool__(self) -> bool:
        return len(self.rotations) > 0

    def motion(self, duration: float = 1.0) -> PoseMotion:
        """The way as a motion of the platform, every turn at one angular velocity [s]."""
        if not self:
            raise InputError(f"motion: there is no way, {self.reason}")
        _, last = checked_span(0.0, duration)
        ends = Rotation.from_matrix(self.rotations)
        times = np.linspace(0.0, last, len(ends))
        slerp = Slerp(times, ends)
        vectors = (ends[1:] * ends[:-1].inv()).as_rotvec() / np.diff(times)[:, np.newaxis]

        def function(at: Array) -> tuple[Array, ...]:
            twists = np.zeros((len(at), 6))
            part = np.clip(np.searchsorted(times, at, side="right") - 1, 0, len(vectors) - 1)
            twists[:, :3] = vectors[part]
            place = np.broadcast_to(self.position, (len(at), 3))
            return place, slerp(at).as_matrix(), twists, np.zeros((len(at), 6))

        return PoseMotion(function, 0.0, last)

    def proven(self) -> bool:
        """Whether ball arithmetic proves that no direct factor vanishes on the way.

        It holds for the turns between these matrices, as their entries are.

        Raises
        ------
        InputError
            There is no way.
        MissingExtraError
        """
        if not self:
            raise InputError(f"proven: there is no way, {self.reason}")
        from kleinform.maps.turning import signs_stay

        return all(
            signs_stay(self.radius, self.position, start, end)
            for start, end in pairwise(self.rotations)
        )


def join_modes(
    robot: UncoupledManipulator, modes: AssemblyModes, first: int, second: int, *, seed: int = 0
) -> Joining:
    """A way between two modes that meets no direct singularity, n_i·u_i = 0 or q_i = 0.

    Parameters
    ----------
    robot : UncoupledManipulator
        That of the modes.
    modes : AssemblyModes
        Of ``robot.forward_displacement(joints)``.
    first, second : int
        Their numbers.
    seed : int
        Of the orientations that are tried in between.

    Returns
    -------
    Joining
        Without a way it is false, and ``.reason`` says why.

    Raises
    ------
    InputError
        There is no mode of that number.
    """
    for number in (first, second):
        if not (is_whole(number) and number in range(len(modes))):
            raise InputError(f"join_modes: there are {len(modes)} modes, {number!r} arrived")
    if robot.radius.ndim or float(robot.radius) != modes.radius:
        raise InputError(
            f"join_modes: the modes are of radius {modes.radius!r}, that of the robot is "
            f"{robot.radius.tolist()!r}"
        )
    ends = modes.rotation[[first, second]]
    signs = _signs(robot, modes.position, ends)
    if (modes.multiplicity[[first, second]] > 1).any():
        return Joining(
            modes.position,
            ends[:0],
            modes.radius,
            "other modes have merged with one of them: it is singular",
            {},
        )
    different = [name for name, pair in zip(INVARIANTS, signs.T, strict=True) if np.ptp(pair)]
    if different:
        signs_differ = f"the sign of {' and of '.join(different)} differs"
        reason = f"no way exists without n_i·u_i = 0 or q_i = 0: {signs_differ}"
        return Joining(modes.position, ends[:0], modes.radius, reason, {})
    way = _way(robot, modes.position, ends, signs[0], seed)
    if not len(way):
        reason = f"none was found through {TRIED} orientations with C at rest"
        return Joining(modes.position, ends[:0], modes.radius, reason, {})
    corners = "straight" if len(way) == 2 else f"through {len(way) - 2} orientations"
    least = _least(robot, modes.position, way)
    return Joining(modes.position, way, modes.radius, f"joined {corners}, with C at rest", least)


def _signs(robot: UncoupledManipulator, position: Array, rotations: Array) -> Array:
    """The signs of e_1, e_2, e_3 and of the orientation factor (..., 4)."""
    places = np.broadcast_to(position, (*rotations.shape[:-2], 3))
    factors = robot.direct_singularity(places, rotations).factors
    names = ("extension_1", "extension_2", "extension_3", "orientation")
    return np.sign(np.stack([factors[name] for name in names], axis=-1))


def _turn(start: Array, end: Array) -> Array:
    """Rotations (SAMPLES, ..., 3, 3) from some to others, each about one axis."""
    one = Rotation.from_matrix(start)
    vector = (Rotation.from_matrix(end) * one.inv()).as_rotvec()
    shares = np.linspace(0.0, 1.0, SAMPLES)
    turned = [(Rotation.from_rotvec(share * vector) * one).as_matrix() for share in shares]
    return np.stack(turned)


def _free(
    robot: UncoupledManipulator, position: Array, start: Array, end: Array, signs: Array
) -> NDArray[np.bool_]:
    """For pairs of rotations (n, 3, 3), whether no sign changes on the turn between them."""
    return np.asarray((_signs(robot, position, _turn(start, end)) == signs).all(axis=(0, -1)))


def _way(
    robot: UncoupledManipulator, position: Array, ends: Array, signs: Array, seed: int
) -> Array:
    """Rotations from one end to the other, with free turns between them, or none."""
    if _free(robot, position, ends[:1], ends[1:], signs)[0]:
        return ends
    random = Rotation.random(64 * TRIED, rng=np.random.default_rng(seed)).as_matrix()
    kept = random[(_signs(robot, position, random) == signs).all(axis=1)][:TRIED]
    nodes = np.concatenate([ends, kept])
    # The trace of RᵀS falls with the angle between R and S.
    near = np.argsort(-np.einsum("aij,bij->ab", nodes, nodes), axis=1)[:, 1 : NEIGHBOURS + 1]
    origin = np.repeat(np.arange(len(nodes)), near.shape[1])
    free = _free(robot, position, nodes[origin], nodes[near.ravel()], signs)
    before = _search(origin[free], near.ravel()[free], len(nodes))
    return nodes[before] if before else ends[:0]


def _search(origin: NDArray[np.int64], target: NDArray[np.int64], count: int) -> list[int]:
    """The shortest chain of nodes from 0 to 1 in an undirected graph, or none."""
    neighbours: list[list[int]] = [[] for _ in range(count)]
    for one, other in zip(origin.tolist(), target.tolist(), strict=True):
        neighbours[one].append(other)
        neighbours[other].append(one)
    chains, seen = [[0]], {0}
    while chains:
        chains = [[*chain, node] for chain in chains for node in neighbours[chain[-1]]]
        fresh = []
        for chain in chains:
            if chain[-1] not in seen:
                seen.add(chain[-1])
                fresh.append(chain)
            if chain[-1] == 1:
                return chain
        chains = fresh
    return []


def _least(robot: UncoupledManipulator, position: Array, way: Array) -> dict[str, float]:
    """The least sizes over the samples of a way."""
    turned = np.concatenate(list(_turn(way[:-1], way[1:]).swapaxes(0, 1)))
    places = np.broadcast_to(position, (len(turned), 3))
    factors = robot.direct_singularity(places, turned).factors
    extensions = [abs(factors[f"extension_{i}"]).min() for i in (1, 2, 3)]
    return {
        "orientation": float(abs(factors["orientation"]).min()),
        "extension": float(min(extensions)),
    }
