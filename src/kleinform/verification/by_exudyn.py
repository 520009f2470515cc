"""A motion by Exudyn: rigid bodies, joints as constraints, integrated over time (index 3).

The driven mechanism has no freedom left, so that masses and forces do not matter: positions
follow from the constraints, velocities from the implicit trapezoidal rule, of order 2.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kleinform.motion import JointStates
from kleinform.verification.engines import load
from kleinform.verification.mechanism import Joint, Mechanism, freedoms, screw, start_rates

__all__ = ["Integrated", "follow"]

Array = NDArray[np.float64]
MASS, INERTIA = 1.0, 0.1
#: Of Newton's method in a step.
TOLERANCE = 1e-12
#: Which relative motions in a joint's frame it prevents: three translations, three rotations.
#: The axis of the joint is z.
PREVENTED = {"R": [1, 1, 1, 1, 1, 0], "P": [1, 1, 0, 1, 1, 1], "C": [1, 1, 0, 1, 1, 0]}
MEASURED = ("Position", "RotationMatrix", "Velocity", "AngularVelocity")


class Integrated(NamedTuple):
    """The platform as Exudyn integrates it: the implicit trapezoidal rule has no accelerations.

    Attributes
    ----------
    positions, rotations, twists : array (T, 3), (T, 3, 3), (T, 6)
        As in `kleinform.motion.PlatformStates`.
    """

    positions: Array
    rotations: Array
    twists: Array


def follow(mechanism: Mechanism, states: JointStates) -> Integrated:
    """The platform's motion, from that of the actuators, a time step a sample.

    Parameters
    ----------
    mechanism : Mechanism
        At the first sample of the motion.
    states : JointStates
        Evenly spaced times. The joint values are used, and the rates at the first sample.

    Raises
    ------
    ArithmeticError
        The time integration failed.
    MissingExtraError
        Exudyn is not installed.
    """
    exudyn = load("exudyn")
    exudyn.config.printToConsole = False
    container = exudyn.SystemContainer()  # the system lives as long as it
    system = container.AddSystem()
    platform = _build(exudyn, system, mechanism, states)
    sensors = [_add_sensor(exudyn, system, platform, quantity) for quantity in MEASURED]
    system.Assemble()
    if not system.SolveDynamic(_settings(exudyn, states)):
        raise ArithmeticError("Exudyn's time integration failed")
    positions, rotations, velocities, omegas = (
        system.GetSensorStoredData(sensor)[:, 1:] for sensor in sensors
    )
    rotations = rotations.reshape(-1, 3, 3) @ mechanism.rotation
    return Integrated(positions, rotations, np.hstack([omegas, velocities]))


def _add_sensor(exudyn: Any, system: Any, body: Any, quantity: str) -> Any:
    """Record a quantity of a body's frame at every step."""
    sensor = exudyn.itemInterface.SensorBody(
        bodyNumber=body,
        outputVariableType=getattr(exudyn.OutputVariableType, quantity),
        storeInternal=True,
        writeToFile=False,
    )
    return system.AddSensor(sensor)


def _settings(exudyn: Any, states: JointStates) -> Any:
    """Implicit trapezoidal rule: Newmark's with beta 1/4 and gamma 1/2."""
    settings = exudyn.SimulationSettings()
    count, duration = len(states.times) - 1, float(states.times[-1] - states.times[0])
    integration = settings.timeIntegration
    integration.numberOfSteps, integration.endTime = count, duration
    integration.adaptiveStep = False
    integration.generalizedAlpha.useNewmark = True
    integration.newton.absoluteTolerance = integration.newton.relativeTolerance = TOLERANCE
    settings.linearSolver.solverType = exudyn.LinearSolverType.EigenSparse
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = duration / count
    return settings


def _build(exudyn: Any, system: Any, mechanism: Mechanism, states: JointStates) -> Any:
    """Add all bodies, joints and drives; return the platform."""
    rates = start_rates(mechanism, states.rates[0])
    screws = [[screw(joint) for joint in freedoms(limb)] for limb in mechanism.limbs]
    twists = np.cumsum(rates[..., np.newaxis] * screws, axis=1)
    ground = system.CreateGround()
    platform = _add_body(exudyn, system, mechanism.position, twists[3, 5])
    for limb, own in zip(mechanism.limbs, twists, strict=True):
        bodies = [
            _add_body(exudyn, system, joint.point, twist)
            for joint, twist in zip(limb[:-1], own, strict=False)
        ]
        links = [ground, *bodies, platform]
        for joint, pair in zip(limb, pairwise(links), strict=True):
            _add_joint(system, joint, list(pair), states)
    return platform


def _add_body(exudyn: Any, system: Any, point: Array, twist: Array) -> Any:
    """A rigid body with its frame at a point, moving with a twist ``[omega, v_O]``."""
    return system.CreateRigidBody(
        referencePosition=point,
        inertia=load("exudyn.rigidBodyUtilities").RigidBodyInertia(MASS, INERTIA * np.eye(3)),
        initialVelocity=twist[3:] + np.cross(twist[:3], point),
        initialAngularVelocity=twist[:3],
    )


def _add_joint(system: Any, joint: Joint, links: list[Any], states: JointStates) -> None:
    """A joint between two links, and its drive.

    Where all translations are prevented Exudyn takes an offset in global axes. So the drive of
    a prismatic joint is a constraint of its own.
    """

    def add(prevented: list[int], offset: Any = 0) -> None:
        system.CreateGenericJoint(
            itemNumbers=links,
            position=joint.point,
            rotationMatrixAxes=_frame(joint.axis),
            constrainedAxes=prevented,
            offsetUserFunction=offset,
        )

    if joint.actuator is None:
        add(PREVENTED[joint.kind])
    elif joint.kind == "P":
        add(PREVENTED["P"])
        add([0, 0, 1, 0, 0, 0], _drive(states, joint.actuator, 2))
    else:
        add([1, 1, 1, 1, 1, 1], _drive(states, joint.actuator, 5))


def _frame(axis: Array) -> Array:
    """A rotation whose z axis is the unit vector given."""
    x = np.cross(axis, np.eye(3)[np.argmin(abs(axis))])
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])


def _drive(states: JointStates, actuator: int, axis: int) -> Callable[..., list[float]]:
    """The offset of a joint at a time since the start, along or about one of its six axes."""
    travel = (states.joints[:, actuator] - states.joints[0, actuator]).tolist()
    step = (states.times[-1] - states.times[0]) / (len(travel) - 1)

    def offset(system: Any, time: float, item: int, parameters: Any) -> list[float]:
        values = [0.0] * 6
        values[axis] = travel[round(time / step)]
        return values

    return offset
