"""A motion by Pinocchio: open chains, and the loops closed by its 6D constraints.

The central limb carries the platform. The last link of each outer limb is one body with the
platform: a ``RigidConstraintModel``, ``CONTACT_6D``.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.motion import JointStates, PlatformStates
from kleinform.verification.engines import load
from kleinform.verification.mechanism import Joint, Mechanism, freedoms

__all__ = ["CLOSED", "Followed", "PinocchioMechanism", "follow"]

Array = NDArray[np.float64]
#: Factors of a matrix and their pivots, of LAPACK's getrf.
Factors = tuple[Array, NDArray[np.int32]]
#: The loops are closed when the norm of log6 of their gaps does not exceed this [m, rad].
CLOSED = 1e-13
ITERATIONS = 20


class Followed(NamedTuple):
    """A motion as Pinocchio follows it.

    Attributes
    ----------
    platform : PlatformStates
    joint_rates : array (T, 4, 6)
        Rates of all joints in the order of `kleinform.results.Screws` [rad/s, m/s].
    closure : float
        The largest gap that was left in a loop [m, rad].
    """

    platform: PlatformStates
    joint_rates: Array
    closure: float


def follow(mechanism: Mechanism, states: JointStates) -> Followed:
    """The platform's motion, from that of the actuators.

    Parameters
    ----------
    mechanism : Mechanism
        At the first sample of the motion.
    states : JointStates

    Raises
    ------
    ArithmeticError
        The loops cannot be closed at a sample.
    MissingExtraError
        Pinocchio, or SciPy, is not installed.
    """
    return PinocchioMechanism(mechanism).follow(states)


class PinocchioMechanism:
    """The mechanism as a model of Pinocchio, with the data that it works on.

    Parameters
    ----------
    mechanism : Mechanism

    Raises
    ------
    MissingExtraError
        Pinocchio, or SciPy, is not installed.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.pin, self.lapack = load("pinocchio"), load("scipy.linalg.lapack")
        self.start = mechanism
        self.model = self.pin.Model()
        joints = [joint for limb in mechanism.limbs for joint in freedoms(limb)]
        ends = [self._add_limb(list(freedoms(limb))) for limb in mechanism.limbs]
        self.platform = ends[3]
        self.constraints = self.pin.StdVec_RigidConstraintModel()
        self.constraint_data = self.pin.StdVec_RigidConstraintData()
        for limb, end in zip(mechanism.limbs[:3], ends[:3], strict=True):
            constraint = self._closure(end, limb[-1])
            self.constraints.append(constraint)
            self.constraint_data.append(constraint.createData())
        self.loops = list(zip(self.constraints, self.constraint_data, strict=True))
        self.data = self.model.createData()
        actuators = [-1 if joint.actuator is None else joint.actuator for joint in joints]
        self.actuated = np.array([actuators.index(number) for number in range(6)])
        self.passive = np.flatnonzero(np.array(actuators) < 0)

    def _add_limb(self, joints: list[Joint]) -> int:
        """Add a chain from the base; all frames are parallel to the base's at the start."""
        parent, origin = 0, np.zeros(3)
        models = {
            "R": self.pin.JointModelRevoluteUnaligned,
            "P": self.pin.JointModelPrismaticUnaligned,
        }
        for joint in joints:
            placement = self.pin.SE3(np.eye(3), joint.point - origin)
            name = f"joint {self.model.njoints}"
            parent = self.model.addJoint(parent, models[joint.kind](joint.axis), placement, name)
            origin = joint.point
        return int(parent)

    def _closure(self, end: int, last: Joint) -> Any:
        """The last link of an outer limb and the platform are one body."""
        place = self.pin.SE3(np.eye(3), last.point - self.start.position)
        return self.pin.RigidConstraintModel(
            self.pin.ContactType.CONTACT_6D,
            self.model,
            end,
            self.pin.SE3.Identity(),
            self.platform,
            place,
            self.pin.ReferenceFrame.LOCAL,
        )

    def follow(self, states: JointStates) -> Followed:
        """As the function `follow`."""
        count = len(states.times)
        positions, rotations = np.empty((count, 3)), np.empty((count, 3, 3))
        twists, twist_rates = np.empty((count, 6)), np.empty((count, 6))
        joint_rates, closure = np.empty((count, 24)), 0.0
        q, v, a = np.zeros(24), np.zeros(24), np.zeros(24)
        driven = states.joints - states.joints[0]
        steps = np.diff(states.times, prepend=states.times[0])
        for k, step in enumerate(steps):
            q += step * (v + 0.5 * step * a)
            q[self.actuated] = driven[k]
            jacobian, factors, gap = self._close(q)
            if not gap <= CLOSED:
                raise ArithmeticError(f"sample {k}: the loops stay open by {gap:.1e}")
            v[self.actuated], a[self.actuated] = states.rates[k], states.accelerations[k]
            self._move(q, v, a, jacobian, factors)
            pose = self.data.oMi[self.platform]
            positions[k], rotations[k] = pose.translation, pose.rotation
            self._read(twists[k], twist_rates[k])
            joint_rates[k], closure = v, max(closure, gap)
        rotations = rotations @ self.start.rotation
        platform = PlatformStates(states.times, positions, rotations, twists, twist_rates)
        return Followed(platform, joint_rates.reshape(count, 4, 6), closure)

    def _close(self, q: Array) -> tuple[Array, Factors, float]:
        """Newton's method on the passive joints, in place.

        Returns the constraints' Jacobian, the factors of its passive columns, the gap left.
        """
        for _ in range(ITERATIONS):
            self.pin.computeJointJacobians(self.model, self.data, q)
            for constraint, data in self.loops:
                constraint.calc(self.model, self.data, data)
            # It reads the placements that calc has left in the constraints' data.
            jacobian: Array = self.pin.getConstraintsJacobian(
                self.model, self.data, self.constraints, self.constraint_data
            )
            gaps = np.concatenate([self.pin.log6(data.c1Mc2).vector for _, data in self.loops])
            factors: Factors = self.lapack.dgetrf(jacobian[:, self.passive])[:2]
            left = math.sqrt(gaps @ gaps)
            if left <= CLOSED:
                break
            q[self.passive] += self.lapack.dgetrs(*factors, gaps)[0]
        return jacobian, factors, left

    def _move(self, q: Array, v: Array, a: Array, jacobian: Array, factors: Factors) -> None:
        """Rates and accelerations of the passive joints, in place."""
        v[self.passive] = -self.lapack.dgetrs(
            *factors, jacobian[:, self.actuated] @ v[self.actuated]
        )[0]
        a[self.passive] = 0.0
        self.pin.forwardKinematics(self.model, self.data, q, v, a)
        a[self.passive] = -self.lapack.dgetrs(*factors, self._accelerations_apart())[0]
        self.pin.forwardKinematics(self.model, self.data, q, v, a)

    def _accelerations_apart(self) -> Array:
        """How the two sides of each loop accelerate against each other, in the frame of one."""
        world = self.pin.ReferenceFrame.WORLD
        other = self.pin.getAcceleration(self.model, self.data, self.platform, world)
        apart = [
            data.oMc1.actInv(
                self.pin.getAcceleration(self.model, self.data, constraint.joint1_id, world) - other
            ).vector
            for constraint, data in self.loops
        ]
        return np.concatenate(apart)

    def _read(self, twist: Array, twist_rate: Array) -> None:
        """The platform's twist and the accelerations of its frame and of C, in place."""
        aligned = self.pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        for into, function in (
            (twist, self.pin.getVelocity),
            (twist_rate, self.pin.getClassicalAcceleration),
        ):
            motion = function(self.model, self.data, self.platform, aligned)
            into[:3], into[3:] = motion.angular, motion.linear
