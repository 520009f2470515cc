# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""Compiled kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

The same functions as on NumPy: leading axes broadcast, trailing axes are the mathematical
shape, everything is float64. Nothing is raised for a singular pose: it gives inf, or NaN where
0/0. Large batches run on several threads, see ``kleinform_kernels._threads``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kleinform_kernels._apply import apply_compiled
from kleinform_kernels.uncoupled import _compiled
from kleinform_kernels.uncoupled.numpy_kernels import (
    ActuatorForces,
    Arms,
    CentralForward,
    CentralInverse,
    Circles,
    Closure,
    Cones,
    DirectLocus,
    DirectSingularity,
    Eliminant,
    Fold,
    ForwardAcceleration,
    ForwardVelocity,
    HalfTurn,
    InverseAcceleration,
    InverseDisplacement,
    InverseSingularity,
    InverseVelocity,
    Jacobians,
    JointRates,
    JointsAndJacobians,
    LegStep,
    LimbGeometry,
    NewtonStep,
    OrientationLocus,
    PlatformWrench,
    RotationDefect,
    RotationFromDirections,
    RotationFromRpy,
    RpyFromRotation,
    Screws,
    Survey,
    TurnedDirections,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


_inverse_displacement = _compiled.OnePose("inverse_displacement", InverseDisplacement)


def inverse_displacement(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> InverseDisplacement:
    """Joint values from the pose.

    Equations (3), (4), (10), (11) of the paper; base frame.
    111 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    joints : array (..., 6)
        q1 ... q6 [m, rad]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    platform_joints : array (..., 3, 3)
        B_i, a row each [m]
    incidence : array (..., 3)
        n_i·u_i [1]
    radial : array (...)
        distance of C from the Z axis [m]
    """
    return _inverse_displacement(a, c, R) or InverseDisplacement(
        *apply_compiled(
            _compiled.inverse_displacement,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (6,),
                (3,),
                (3, 3),
                (3,),
                (),
            ),
        )
    )


_central_forward = _compiled.OnePose("central_forward", CentralForward)


def central_forward(joints: ArrayLike) -> CentralForward:
    """Position of C from the joint values of the central limb.

    Equations (1) of the paper; base frame.
    9 operations.

    Parameters
    ----------
    joints : array (..., 3)
        q4, q5, q6 [rad, rad, m]

    Returns
    -------
    position : array (..., 3)
        position of C [m]
    direction : array (..., 3)
        unit vector lambda [1]
    """
    return _central_forward(joints) or CentralForward(
        *apply_compiled(
            _compiled.central_forward,
            (
                ("joints", joints, (3,)),
            ),
            (
                (3,),
                (3,),
            ),
        )
    )


_central_inverse = _compiled.OnePose("central_inverse", CentralInverse)


def central_inverse(c: ArrayLike) -> CentralInverse:
    """Joint values of the central limb from the position of C.

    Equations (11) of the paper; base frame.
    11 operations.

    Parameters
    ----------
    c : array (..., 3)
        position of the platform's centre C [m]

    Returns
    -------
    joints : array (..., 3)
        q4, q5, q6 [rad, rad, m]
    radial : array (...)
        distance of C from the Z axis [m]
    """
    return _central_inverse(c) or CentralInverse(
        *apply_compiled(
            _compiled.central_inverse,
            (
                ("c", c, (3,)),
            ),
            (
                (3,),
                (),
            ),
        )
    )


_closure = _compiled.OnePose("closure", Closure)


def closure(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, directions: ArrayLike) -> Closure:
    """Residual of the six quadratics in (n_1, n_2), and its Jacobian.

    Equations (6) of the paper; base frame.
    159 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    directions : array (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    residual : array (..., 6)
        three cones, three unit conditions [m², 1]
    jacobian : array (..., 6, 6)
        by (n_1, n_2) [m², 1]
    """
    return _closure(a, c, lengths, directions) or Closure(
        *apply_compiled(
            _compiled.closure,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("directions", directions, (2, 3)),
            ),
            (
                (6,),
                (6, 6),
            ),
        )
    )


_cones = _compiled.OnePose("cones", Cones)


def cones(a: ArrayLike, c: ArrayLike, lengths: ArrayLike) -> Cones:
    """The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.

    Equations (6) of the paper; base frame.
    81 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]

    Returns
    -------
    cone_1 : array (..., 3, 3)
        M_1, symmetric [m²]
    cone_2 : array (..., 3, 3)
        M_2, symmetric [m²]
    cone_3 : array (..., 3, 3)
        M_3, symmetric [m²]
    """
    return _cones(a, c, lengths) or Cones(
        *apply_compiled(
            _compiled.cones,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
            ),
            (
                (3, 3),
                (3, 3),
                (3, 3),
            ),
        )
    )


_eliminant = _compiled.OnePose("eliminant", Eliminant)


def eliminant(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, angle: ArrayLike, reference: ArrayLike) -> Eliminant:
    """The resultant that vanishes at the angles of leg 1 of the assembly modes.

    Equations (5), (6) of the paper; base frame.
    371 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    angle : array (..., 2)
        cos, sin of leg 1's angle [1]
    reference : array (..., 3)
        a vector not parallel to n_1 [1]

    Returns
    -------
    eliminant : array (...)
        resultant of the quartics of limbs 2, 3 [m¹⁶]
    bound : array (...)
        Hadamard's bound on it [m¹⁶]
    """
    return _eliminant(a, c, lengths, angle, reference) or Eliminant(
        *apply_compiled(
            _compiled.eliminant,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("angle", angle, (2,)),
                ("reference", reference, (3,)),
            ),
            (
                (),
                (),
            ),
        )
    )


_half_turn = _compiled.OnePose("half_turn", HalfTurn)


def half_turn(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, angle: ArrayLike, reference: ArrayLike) -> HalfTurn:
    """The turn about n_1 at a zero of the eliminant, as a half angle.

    Equations (5), (6) of the paper; base frame.
    368 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    angle : array (..., 2)
        cos, sin of leg 1's angle [1]
    reference : array (..., 3)
        a vector not parallel to n_1 [1]

    Returns
    -------
    frame : array (..., 3, 3)
        n_1, f, g, a row each [1]
    powers : array (..., 2, 4)
        along x³, x²y, xy², y³ twice [m¹²]
    """
    return _half_turn(a, c, lengths, angle, reference) or HalfTurn(
        *apply_compiled(
            _compiled.half_turn,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("angle", angle, (2,)),
                ("reference", reference, (3,)),
            ),
            (
                (3, 3),
                (2, 4),
            ),
        )
    )


_turned_directions = _compiled.OnePose("turned_directions", TurnedDirections)


def turned_directions(frame: ArrayLike, half_angle: ArrayLike) -> TurnedDirections:
    """n_1 and n_2 from the frame about n_1 and the half angle of the turn.

    Equations (5) of the paper; base frame.
    27 operations.

    Parameters
    ----------
    frame : array (..., 3, 3)
        n_1, f, g, a row each [1]
    half_angle : array (..., 2)
        (x, y), any length [1]

    Returns
    -------
    directions : array (..., 2, 3)
        n_1 and n_2, a row each [1]
    """
    return _turned_directions(frame, half_angle) or TurnedDirections(
        *apply_compiled(
            _compiled.turned_directions,
            (
                ("frame", frame, (3, 3)),
                ("half_angle", half_angle, (2,)),
            ),
            (
                (2, 3),
            ),
        )
    )


_circles = _compiled.OnePose("circles", Circles)


def circles(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, start: ArrayLike) -> Circles:
    """Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.

    Equations (5), (6) of the paper; base frame.
    716 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    start : array (..., 2, 2)
        cos, sin of the angles of legs 1, 2 at t = s = 0 [1]

    Returns
    -------
    angle : array (..., 5, 5)
        n_1 and n_2 are 120° apart [m⁴]
    cone : array (..., 5, 5)
        limb 3 closes [m⁶]
    first : array (..., 3, 3)
        (1 + t²)(b_1 − c) at 1, t, t², a row each [m]
    second : array (..., 3, 3)
        (1 + s²)(b_2 − c) at 1, s, s², a row each [m]
    """
    return _circles(a, c, lengths, start) or Circles(
        *apply_compiled(
            _compiled.circles,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("start", start, (2, 2)),
            ),
            (
                (5, 5),
                (5, 5),
                (3, 3),
                (3, 3),
            ),
        )
    )


_arms = _compiled.OnePose("arms", Arms)


def arms(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, start: ArrayLike, half_tangents: ArrayLike) -> Arms:
    """The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.

    Equations (3) of the paper; base frame.
    71 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    start : array (..., 2, 2)
        cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
    half_tangents : array (..., 2)
        t, s [1]

    Returns
    -------
    arms : array (..., 2, 3)
        from C to B_1 and B_2, a row each [m]
    """
    return _arms(a, c, lengths, start, half_tangents) or Arms(
        *apply_compiled(
            _compiled.arms,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("start", start, (2, 2)),
                ("half_tangents", half_tangents, (2,)),
            ),
            (
                (2, 3),
            ),
        )
    )


_newton_step = _compiled.OnePose("newton_step", NewtonStep)


def newton_step(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, directions: ArrayLike) -> NewtonStep:
    """One step of Newton's method on the rotation, for the three closure equations.

    Equations (6) of the paper; base frame.
    278 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    directions : array (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    next : array (..., 2, 3)
        n_1, n_2 turned [1]
    turn : array (..., 3)
        the step, a rotation vector [rad]
    residual : array (..., 3)
        F_1, F_2, F_3 [m²]
    gradient : array (..., 3, 3)
        of F_i by a turn, a row each [m²]
    volume : array (...)
        determinant of the gradient [m⁶]
    """
    return _newton_step(a, c, lengths, directions) or NewtonStep(
        *apply_compiled(
            _compiled.newton_step,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("directions", directions, (2, 3)),
            ),
            (
                (2, 3),
                (3,),
                (3,),
                (3, 3),
                (),
            ),
        )
    )


_leg_step = _compiled.OnePose("leg_step", LegStep)


def leg_step(a: ArrayLike, c: ArrayLike, lengths: ArrayLike, angle: ArrayLike, second: ArrayLike) -> LegStep:
    """One step of Newton's method in the angle of leg 1 and the turn about n_1.

    Equations (6) of the paper; base frame.
    303 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    lengths : array (..., 3)
        q1, q2, q3 [m]
    angle : array (..., 2)
        cos, sin of leg 1's angle [1]
    second : array (..., 3)
        n_2, or near it [1]

    Returns
    -------
    angle : array (..., 2)
        cos, sin of leg 1's angle [1]
    directions : array (..., 2, 3)
        n_1 and n_2 [1]
    extension : array (...)
        e_1, positive [m]
    steps : array (..., 2)
        of leg 1's angle and of the turn [rad]
    """
    return _leg_step(a, c, lengths, angle, second) or LegStep(
        *apply_compiled(
            _compiled.leg_step,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("lengths", lengths, (3,)),
                ("angle", angle, (2,)),
                ("second", second, (3,)),
            ),
            (
                (2,),
                (2, 3),
                (),
                (2,),
            ),
        )
    )


_fold = _compiled.OnePose("fold", Fold)


def fold(a: ArrayLike, joints: ArrayLike, directions: ArrayLike) -> Fold:
    """What decides whether two assembly modes have merged.

    Equations (6) of the paper; base frame.
    468 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    joints : array (..., 6)
        q1 ... q6 [m, rad]
    directions : array (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    residual : array (..., 3)
        F_1, F_2, F_3 [m²]
    gradient : array (..., 3, 3)
        of F_i by a turn, a row each [m²]
    volume : array (...)
        determinant of the gradient [m⁶]
    volume_gradient : array (..., 3)
        of the volume by a turn [m⁶]
    by_joints : array (..., 3, 6)
        of F_i by the logarithm of q_j [m²]
    """
    return _fold(a, joints, directions) or Fold(
        *apply_compiled(
            _compiled.fold,
            (
                ("a", a, ()),
                ("joints", joints, (6,)),
                ("directions", directions, (2, 3)),
            ),
            (
                (3,),
                (3, 3),
                (),
                (3,),
                (3, 6),
            ),
        )
    )


_rotation_from_rpy = _compiled.OnePose("rotation_from_rpy", RotationFromRpy)


def rotation_from_rpy(roll: ArrayLike, pitch: ArrayLike, yaw: ArrayLike) -> RotationFromRpy:
    """Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).

    Equations (9) of the paper; base frame.
    24 operations.

    Parameters
    ----------
    roll : array (...)
        about X, first [rad]
    pitch : array (...)
        about Y, second [rad]
    yaw : array (...)
        about Z, last [rad]

    Returns
    -------
    rotation : array (..., 3, 3)
        rotation of the platform [1]
    """
    return _rotation_from_rpy(roll, pitch, yaw) or RotationFromRpy(
        *apply_compiled(
            _compiled.rotation_from_rpy,
            (
                ("roll", roll, ()),
                ("pitch", pitch, ()),
                ("yaw", yaw, ()),
            ),
            (
                (3, 3),
            ),
        )
    )


_rpy_from_rotation = _compiled.OnePose("rpy_from_rotation", RpyFromRotation)


def rpy_from_rotation(R: ArrayLike) -> RpyFromRotation:
    """Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.

    Equations (9) of the paper; base frame.
    17 operations.

    Parameters
    ----------
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    roll : array (...)
        in [−π, π] [rad]
    pitch : array (...)
        in [−π/2, π/2] [rad]
    yaw : array (...)
        in [−π, π] [rad]
    """
    return _rpy_from_rotation(R) or RpyFromRotation(
        *apply_compiled(
            _compiled.rpy_from_rotation,
            (
                ("R", R, (3, 3)),
            ),
            (
                (),
                (),
                (),
            ),
        )
    )


_rotation_from_directions = _compiled.OnePose("rotation_from_directions", RotationFromDirections)


def rotation_from_directions(n1: ArrayLike, n2: ArrayLike) -> RotationFromDirections:
    """Rotation from the platform directions n_1 and n_2.

    Equations (8) of the paper; base frame.
    40 operations.

    Parameters
    ----------
    n1 : array (..., 3)
        direction from C to B_1 [1]
    n2 : array (..., 3)
        direction from C to B_2 [1]

    Returns
    -------
    rotation : array (..., 3, 3)
        rotation of the platform [1]
    """
    return _rotation_from_directions(n1, n2) or RotationFromDirections(
        *apply_compiled(
            _compiled.rotation_from_directions,
            (
                ("n1", n1, (3,)),
                ("n2", n2, (3,)),
            ),
            (
                (3, 3),
            ),
        )
    )


_rotation_defect = _compiled.OnePose("rotation_defect", RotationDefect)


def rotation_defect(R: ArrayLike) -> RotationDefect:
    """How far a matrix is from a rotation; zero for a rotation.

    Equations (8) of the paper; base frame.
    42 operations.

    Parameters
    ----------
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    defect : array (...)
        root of the squared defects [1]
    """
    return _rotation_defect(R) or RotationDefect(
        *apply_compiled(
            _compiled.rotation_defect,
            (
                ("R", R, (3, 3)),
            ),
            (
                (),
            ),
        )
    )


_limb_geometry = _compiled.OnePose("limb_geometry", LimbGeometry)


def limb_geometry(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> LimbGeometry:
    """Points D_i, unit vectors w_i and reciprocal lines S_i.

    Equations (7), (14) of the paper; base frame.
    264 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    d : array (..., 3, 3)
        D_i, a row each [m]
    w : array (..., 3, 3)
        w_i, a row each [1]
    lines : array (..., 3, 6)
        S_i, a row each [1, m]
    """
    return _limb_geometry(a, c, R) or LimbGeometry(
        *apply_compiled(
            _compiled.limb_geometry,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (3, 3),
                (3, 3),
                (3, 6),
            ),
        )
    )


_screws = _compiled.OnePose("screws", Screws)


def screws(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike) -> Screws:
    """The joint screws of the four limbs at pole C, a row a joint.

    Equations Section IV of the paper; base frame.
    262 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    limb1 : array (..., 6, 6)
        screws of limb 1 [1, m]
    limb2 : array (..., 6, 6)
        screws of limb 2 [1, m]
    limb3 : array (..., 6, 6)
        screws of limb 3 [1, m]
    limb4 : array (..., 6, 6)
        screws of limb 4 [1, m]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _screws(a, c, R, heading) or Screws(
        *apply_compiled(
            _compiled.screws,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
            ),
            (
                (6, 6),
                (6, 6),
                (6, 6),
                (6, 6),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_jacobians = _compiled.OnePose("jacobians", Jacobians)


def jacobians(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike) -> Jacobians:
    """Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.

    Equations (17)-(19), (22)-(24) of the paper; base frame.
    283 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    J_v : array (..., 6, 6)
        forward Jacobian [1, m]
    J_q : array (..., 6, 6)
        inverse Jacobian [1, m]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _jacobians(a, c, R, heading) or Jacobians(
        *apply_compiled(
            _compiled.jacobians,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
            ),
            (
                (6, 6),
                (6, 6),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_joints_and_jacobians = _compiled.OnePose("joints_and_jacobians", JointsAndJacobians)


def joints_and_jacobians(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike) -> JointsAndJacobians:
    """Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.

    Equations (10), (11), (17)-(19), (22)-(24) of the paper; base frame.
    286 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    joints : array (..., 6)
        q1 ... q6 [m, rad]
    J_v : array (..., 6, 6)
        forward Jacobian [1, m]
    J_q : array (..., 6, 6)
        inverse Jacobian [1, m]
    """
    return _joints_and_jacobians(a, c, R, heading) or JointsAndJacobians(
        *apply_compiled(
            _compiled.joints_and_jacobians,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
            ),
            (
                (6,),
                (6, 6),
                (6, 6),
            ),
        )
    )


_inverse_velocity = _compiled.OnePose("inverse_velocity", InverseVelocity)


def inverse_velocity(a: ArrayLike, c: ArrayLike, R: ArrayLike, twist: ArrayLike) -> InverseVelocity:
    """Joint rates from the twist.

    Equations (15), (16) of the paper; base frame.
    260 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    twist : array (..., 2, 3)
        [omega, v_C] [rad/s, m/s]

    Returns
    -------
    rates : array (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _inverse_velocity(a, c, R, twist) or InverseVelocity(
        *apply_compiled(
            _compiled.inverse_velocity,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("twist", twist, (2, 3)),
            ),
            (
                (6,),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_forward_velocity = _compiled.OnePose("forward_velocity", ForwardVelocity)


def forward_velocity(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike, rates: ArrayLike) -> ForwardVelocity:
    """Twist from the joint rates, and the determinant of its 3×3 with its factors.

    Equations (12), (17) of the paper; base frame.
    369 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    rates : array (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]

    Returns
    -------
    twist : array (..., 6)
        [omega, v_C] [rad/s, m/s]
    determinant : array (...)
        det of the moments of S_i [m³]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : array (..., 3)
        scales of the e_i [m]
    orientation : array (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : array (...)
        scale of orientation [m³]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _forward_velocity(a, c, R, heading, rates) or ForwardVelocity(
        *apply_compiled(
            _compiled.forward_velocity,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
                ("rates", rates, (6,)),
            ),
            (
                (6,),
                (),
                (3,),
                (3,),
                (),
                (),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_joint_rates = _compiled.OnePose("joint_rates", JointRates)


def joint_rates(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike, twist: ArrayLike) -> JointRates:
    """The rates of all joints of the four limbs from the twist.

    Equations (12) of the paper; base frame.
    628 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    twist : array (..., 2, 3)
        [omega, v_C] [rad/s, m/s]

    Returns
    -------
    rates : array (..., 4, 6)
        a row a limb [rad/s, m/s]
    wrist : array (...)
        (n_1 × n_2)·lambda [1]
    wrist_scale : array (...)
        scale of wrist [1]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _joint_rates(a, c, R, heading, twist) or JointRates(
        *apply_compiled(
            _compiled.joint_rates,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
                ("twist", twist, (2, 3)),
            ),
            (
                (4, 6),
                (),
                (),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_platform_wrench = _compiled.OnePose("platform_wrench", PlatformWrench)


def platform_wrench(a: ArrayLike, c: ArrayLike, R: ArrayLike, forces: ArrayLike) -> PlatformWrench:
    """Wrench that the platform exerts from the forces of the actuators.

    Equations (15), (16), by duality of the paper; base frame.
    304 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    forces : array (..., 6)
        f1 ... f6 [N, N m]

    Returns
    -------
    wrench : array (..., 6)
        [force, moment at C] [N, N m]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _platform_wrench(a, c, R, forces) or PlatformWrench(
        *apply_compiled(
            _compiled.platform_wrench,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("forces", forces, (6,)),
            ),
            (
                (6,),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_actuator_forces = _compiled.OnePose("actuator_forces", ActuatorForces)


def actuator_forces(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike, wrench: ArrayLike) -> ActuatorForces:
    """Forces of the actuators from the wrench that the platform exerts.

    Equations (16), (17), by duality of the paper; base frame.
    374 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    wrench : array (..., 2, 3)
        [force, moment at C] [N, N m]

    Returns
    -------
    forces : array (..., 6)
        f1 ... f6 [N, N m]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : array (..., 3)
        scales of the e_i [m]
    orientation : array (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : array (...)
        scale of orientation [m³]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _actuator_forces(a, c, R, heading, wrench) or ActuatorForces(
        *apply_compiled(
            _compiled.actuator_forces,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
                ("wrench", wrench, (2, 3)),
            ),
            (
                (6,),
                (3,),
                (3,),
                (),
                (),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_inverse_acceleration = _compiled.OnePose("inverse_acceleration", InverseAcceleration)


def inverse_acceleration(a: ArrayLike, c: ArrayLike, R: ArrayLike, twist: ArrayLike, twist_rate: ArrayLike) -> InverseAcceleration:
    """Joint rates and accelerations from the twist and its derivative.

    Equations (15), (16), differentiated of the paper; base frame.
    535 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    twist : array (..., 2, 3)
        [omega, v_C] [rad/s, m/s]
    twist_rate : array (..., 2, 3)
        [d omega/dt, dv_C/dt] [rad/s², m/s²]

    Returns
    -------
    rates : array (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    accelerations : array (..., 6)
        q̈1 ... q̈6 [m/s², rad/s²]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _inverse_acceleration(a, c, R, twist, twist_rate) or InverseAcceleration(
        *apply_compiled(
            _compiled.inverse_acceleration,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("twist", twist, (2, 3)),
                ("twist_rate", twist_rate, (2, 3)),
            ),
            (
                (6,),
                (6,),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_forward_acceleration = _compiled.OnePose("forward_acceleration", ForwardAcceleration)


def forward_acceleration(a: ArrayLike, c: ArrayLike, R: ArrayLike, heading: ArrayLike, rates: ArrayLike, accelerations: ArrayLike) -> ForwardAcceleration:
    """Twist and its derivative from the joint rates and accelerations.

    Equations (12), (17), differentiated of the paper; base frame.
    634 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]
    heading : array (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    rates : array (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    accelerations : array (..., 6)
        q̈1 ... q̈6 [m/s², rad/s²]

    Returns
    -------
    twist : array (..., 6)
        [omega, v_C] [rad/s, m/s]
    twist_rate : array (..., 6)
        its derivative [rad/s², m/s²]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : array (..., 3)
        scales of the e_i [m]
    orientation : array (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : array (...)
        scale of orientation [m³]
    incidence : array (..., 3)
        n_i·u_i [1]
    scaled_legs : array (..., 3)
        |n_i·u_i| q_i [m]
    radial : array (...)
        distance of C from the Z axis [m]
    central_length : array (...)
        distance from O to C [m]
    reach : array (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    return _forward_acceleration(a, c, R, heading, rates, accelerations) or ForwardAcceleration(
        *apply_compiled(
            _compiled.forward_acceleration,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
                ("heading", heading, (2,)),
                ("rates", rates, (6,)),
                ("accelerations", accelerations, (6,)),
            ),
            (
                (6,),
                (6,),
                (3,),
                (3,),
                (),
                (),
                (3,),
                (3,),
                (),
                (),
                (),
            ),
        )
    )


_inverse_singularity = _compiled.OnePose("inverse_singularity", InverseSingularity)


def inverse_singularity(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> InverseSingularity:
    """det J_q and its factors: the product of limb, central and wrist.

    Equations (22)-(26) of the paper; base frame.
    167 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    determinant : array (...)
        det J_q [m²]
    limb : array (..., 3)
        Klein forms of S_i and the actuated screw [1]
    central : array (...)
        q6² cos q5 [m²]
    wrist : array (...)
        (n_1 × n_2)·lambda [1]
    limb_scale : array (..., 3)
        scales of limb [1]
    central_scale : array (...)
        scale of central [m²]
    wrist_scale : array (...)
        scale of wrist [1]
    """
    return _inverse_singularity(a, c, R) or InverseSingularity(
        *apply_compiled(
            _compiled.inverse_singularity,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (),
                (3,),
                (),
                (),
                (3,),
                (),
                (),
            ),
        )
    )


_direct_singularity = _compiled.OnePose("direct_singularity", DirectSingularity)


def direct_singularity(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> DirectSingularity:
    """det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.

    Equations (27) of the paper; base frame.
    194 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    determinant : array (...)
        det J_v [m³]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    orientation : array (...)
        det[n_i × (d_i − c)] [m³]
    wrist : array (...)
        (n_1 × n_2)·lambda [1]
    extension_scale : array (..., 3)
        scales of the e_i [m]
    orientation_scale : array (...)
        scale of orientation [m³]
    wrist_scale : array (...)
        scale of wrist [1]
    """
    return _direct_singularity(a, c, R) or DirectSingularity(
        *apply_compiled(
            _compiled.direct_singularity,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (),
                (3,),
                (),
                (),
                (3,),
                (),
                (),
            ),
        )
    )


_survey = _compiled.OnePose("survey", Survey)


def survey(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> Survey:
    """Joint values, extensions, both determinants and their factors in one pass.

    Equations (4), (10), (11), (22)-(27) of the paper; base frame.
    237 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    joints : array (..., 6)
        q1 ... q6 [m, rad]
    extension : array (..., 3)
        signed distances e_i from C to B_i [m]
    inverse_determinant : array (...)
        det J_q [m²]
    direct_determinant : array (...)
        det J_v [m³]
    limb : array (..., 3)
        Klein forms of S_i and the actuated screw [1]
    central : array (...)
        q6² cos q5 [m²]
    wrist : array (...)
        (n_1 × n_2)·lambda [1]
    orientation : array (...)
        det[n_i × (d_i − c)] [m³]
    limb_scale : array (..., 3)
        scales of limb [1]
    central_scale : array (...)
        scale of central [m²]
    wrist_scale : array (...)
        scale of wrist [1]
    extension_scale : array (..., 3)
        scales of the e_i [m]
    orientation_scale : array (...)
        scale of orientation [m³]
    incidence : array (..., 3)
        n_i·u_i [1]
    """
    return _survey(a, c, R) or Survey(
        *apply_compiled(
            _compiled.survey,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (6,),
                (3,),
                (),
                (),
                (3,),
                (),
                (),
                (),
                (3,),
                (),
                (),
                (3,),
                (),
                (3,),
            ),
        )
    )


_direct_locus = _compiled.OnePose("direct_locus", DirectLocus)


def direct_locus(a: ArrayLike, R: ArrayLike) -> DirectLocus:
    """The cubic in c on which `orientation` vanishes, at one orientation of the platform: √3/2 times its value is (p_1 p_2 p_3)² orientation.

    Equations (27) of the paper; base frame.
    328 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    coefficients : array (..., 20)
        at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³ [m³, m², m, 1]
    incidence : array (..., 3)
        n_i·u_i [1]
    """
    return _direct_locus(a, R) or DirectLocus(
        *apply_compiled(
            _compiled.direct_locus,
            (
                ("a", a, ()),
                ("R", R, (3, 3)),
            ),
            (
                (20,),
                (3,),
            ),
        )
    )


_orientation_locus = _compiled.OnePose("orientation_locus", OrientationLocus)


def orientation_locus(a: ArrayLike, c: ArrayLike, R: ArrayLike) -> OrientationLocus:
    """The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: √3/2 times it is (p_1 p_2 p_3)² orientation.

    Equations (27) of the paper; base frame.
    419 operations.

    Parameters
    ----------
    a : array (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : array (..., 3)
        position of the platform's centre C [m]
    R : array (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    value : array (...)
        tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + ... [m³]
    by_turn : array (..., 3)
        its derivative by a turn of the platform [m³]
    by_position : array (..., 3)
        its derivative by the position [m²]
    """
    return _orientation_locus(a, c, R) or OrientationLocus(
        *apply_compiled(
            _compiled.orientation_locus,
            (
                ("a", a, ()),
                ("c", c, (3,)),
                ("R", R, (3, 3)),
            ),
            (
                (),
                (3,),
                (3,),
            ),
        )
    )
