# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""mpmath kernels of the uncoupled manipulator 3-RPRRC+RRPRU.

One pose at a time, nested sequences in and nested lists out, at the working precision of
``mpmath.mp``: the reference against which the NumPy kernels are tested.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from mpmath import atan2, cos, mpf, sin, sqrt
from mpmath import fabs as absolute

Nested = Any


def _exact(value: Nested) -> Nested:
    """Turn every entry of a nested sequence into an mpf, without loss."""
    try:
        entries = iter(value)
    except TypeError:
        return mpf(value)
    return [_exact(entry) for entry in entries]


class InverseDisplacement(NamedTuple):
    """What `inverse_displacement` returns."""

    joints: Nested
    extension: Nested
    platform_joints: Nested
    incidence: Nested
    radial: Nested


def inverse_displacement(a: Nested, c: Nested, R: Nested) -> InverseDisplacement:
    """Joint values from the pose.

    Equations (3), (4), (10), (11) of the paper; base frame.
    111 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    joints : nested list (..., 6)
        q1 ... q6 [m, rad]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    platform_joints : nested list (..., 3, 3)
        B_i, a row each [m]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    radial : nested list (...)
        distance of C from the Z axis [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    x6 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x6)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x6)
    # elevation of the central limb (11) [rad]
    q5 = atan2(c_z, r)
    # azimuth of the central limb, measured from the X axis (11) [rad]
    q4 = atan2(c_y, c_x)
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # position of B_i (3) [m]
    b1_x = c_x + e1*n1_x
    b1_y = c_y + e1*n1_y
    b1_z = c_z + e1*n1_z
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    # length of the outer limb (10) [m]
    q1 = l1/absolute(n1_x)
    x7 = SQRT3_2*c_y
    x8 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x7 + x8
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    # position of B_i (3) [m]
    b2_x = c_x + e2*n2_x
    b2_y = c_y + e2*n2_y
    b2_z = c_z + e2*n2_z
    x9 = mpf(1)/2*c_y
    x10 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x10 - x9)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # length of the outer limb (10) [m]
    q2 = l2/absolute(p2)
    # distance of C from the plane of the limb (4) [m]
    h3 = x7 + x8
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # position of B_i (3) [m]
    b3_x = c_x + e3*n3_x
    b3_y = c_y + e3*n3_y
    b3_z = c_z + e3*n3_z
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(x10 - x9)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # length of the outer limb (10) [m]
    q3 = l3/absolute(p3)
    return InverseDisplacement(
        [q1, q2, q3, q4, q5, q6],
        [e1, e2, e3],
        [[b1_x, b1_y, b1_z], [b2_x, b2_y, b2_z], [b3_x, b3_y, b3_z]],
        [n1_x, p2, p3],
        r,
    )


class CentralForward(NamedTuple):
    """What `central_forward` returns."""

    position: Nested
    direction: Nested


def central_forward(joints: Nested) -> CentralForward:
    """Position of C from the joint values of the central limb.

    Equations (1) of the paper; base frame.
    9 operations.

    Parameters
    ----------
    joints : nested list (..., 3)
        q4, q5, q6 [rad, rad, m]

    Returns
    -------
    position : nested list (..., 3)
        position of C [m]
    direction : nested list (..., 3)
        unit vector lambda [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    joints = _exact(joints)
    q4, q5, q6 = joints
    x0 = cos(q5)
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = x0*cos(q4)
    lambda_y = x0*sin(q4)
    lambda_z = sin(q5)
    # position of the platform's centre C (1) [m]
    c_x = lambda_x*q6
    c_y = lambda_y*q6
    c_z = lambda_z*q6
    return CentralForward(
        [c_x, c_y, c_z],
        [lambda_x, lambda_y, lambda_z],
    )


class CentralInverse(NamedTuple):
    """What `central_inverse` returns."""

    joints: Nested
    radial: Nested


def central_inverse(c: Nested) -> CentralInverse:
    """Joint values of the central limb from the position of C.

    Equations (11) of the paper; base frame.
    11 operations.

    Parameters
    ----------
    c : nested list (..., 3)
        position of the platform's centre C [m]

    Returns
    -------
    joints : nested list (..., 3)
        q4, q5, q6 [rad, rad, m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    c = _exact(c)
    c_x, c_y, c_z = c
    x0 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x0)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x0)
    # elevation of the central limb (11) [rad]
    q5 = atan2(c_z, r)
    # azimuth of the central limb, measured from the X axis (11) [rad]
    q4 = atan2(c_y, c_x)
    return CentralInverse(
        [q4, q5, q6],
        r,
    )


class Closure(NamedTuple):
    """What `closure` returns."""

    residual: Nested
    jacobian: Nested


def closure(a: Nested, c: Nested, lengths: Nested, directions: Nested) -> Closure:
    """Residual of the six quadratics in (n_1, n_2), and its Jacobian.

    Equations (6) of the paper; base frame.
    159 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    directions : nested list (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    residual : nested list (..., 6)
        three cones, three unit conditions [m², 1]
    jacobian : nested list (..., 6, 6)
        by (n_1, n_2) [m², 1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    directions = _exact(directions)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    (n1_x, n1_y, n1_z), (n2_x, n2_y, n2_z) = directions
    # the third direction (5) [1]
    n3_x = -n1_x - n2_x
    n3_y = -n1_y - n2_y
    n3_z = -n1_z - n2_z
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    x0 = (n1_x*n1_x)
    x1 = (q1*q1)
    # closure equation of limb i, times p_i squared (6) [m²]
    F1 = (gt1*gt1) + (gz1*gz1) - x0*x1
    x2 = 2.0*gt1
    x3 = 2.0*gz1
    x4 = 2.0*n1_x
    # gradient of F_i in n_i (6) [m²]
    dF1_x = c_y*x2 + c_z*x3 - x1*x4
    dF1_y = h1*x2
    dF1_z = h1*x3
    x5 = SQRT3_2*c_y
    x6 = mpf(1)/2*c_x
    x7 = a + x6
    # distance of C from the plane of the limb (4) [m]
    h2 = -x5 + x7
    x8 = mpf(1)/4*c_y
    x9 = SQRT3_2*x6
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x8 + x9
    x10 = mpf(1)/2*c_y
    x11 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x10 - x11) - mpf(1)/2*h2
    x12 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x12
    x13 = SQRT3_2*c_z
    hz2_y = x13
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # p_i times the horizontal part of the leg [m]
    gt2 = ht2_x*n2_x + ht2_y*n2_y
    # p_i times the vertical part of the leg [m]
    gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2)
    x14 = 2.0*gt2
    x15 = 2.0*gz2
    x16 = 2.0*p2*q2
    # gradient of F_i in n_i (6) [m²]
    dF2_x = -hp2_x*x16 + ht2_x*x14 + hz2_x*x15
    dF2_y = -hp2_y*x16 + ht2_y*x14 + hz2_y*x15
    dF2_z = h2*x15
    # distance of C from the plane of the limb (4) [m]
    h3 = x5 + x7
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x8 - x9
    ht3_y = -SQRT3_2*(-x10 + x11) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x12
    hz3_y = -x13
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # p_i times the horizontal part of the leg [m]
    gt3 = ht3_x*n3_x + ht3_y*n3_y
    # p_i times the vertical part of the leg [m]
    gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3)
    x17 = 2.0*gt3
    x18 = 2.0*gz3
    x19 = 2.0*p3*q3
    # gradient of F_i in n_i (6) [m²]
    dF3_x = -hp3_x*x19 + ht3_x*x17 + hz3_x*x18
    dF3_y = -hp3_y*x19 + ht3_y*x17 + hz3_y*x18
    dF3_z = h3*x18
    # n_1 is a unit vector (5) [1]
    F4 = (n1_y*n1_y) + (n1_z*n1_z) + x0 - 1.0
    # n_2 is a unit vector (5) [1]
    F5 = (n2_x*n2_x) + (n2_y*n2_y) + (n2_z*n2_z) - 1.0
    # n_1, n_2 are 120° apart (5) [1]
    F6 = n1_x*n2_x + n1_y*n2_y + n1_z*n2_z + mpf(1)/2
    x20 = -dF3_x
    # derivatives of F by (n_1, n_2) (6) [m², 1]
    dF_31 = x20
    x21 = -dF3_y
    dF_32 = x21
    x22 = -dF3_z
    dF_33 = x22
    dF_34 = x20
    dF_35 = x21
    dF_36 = x22
    dF_41 = x4
    dF_42 = 2.0*n1_y
    dF_43 = 2.0*n1_z
    dF_54 = 2.0*n2_x
    dF_55 = 2.0*n2_y
    dF_56 = 2.0*n2_z
    return Closure(
        [F1, F2, F3, F4, F5, F6],
        [[dF1_x, dF1_y, dF1_z, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, dF2_x, dF2_y, dF2_z], [dF_31, dF_32, dF_33, dF_34, dF_35, dF_36], [dF_41, dF_42, dF_43, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, dF_54, dF_55, dF_56], [n2_x, n2_y, n2_z, n1_x, n1_y, n1_z]],
    )


class Cones(NamedTuple):
    """What `cones` returns."""

    cone_1: Nested
    cone_2: Nested
    cone_3: Nested


def cones(a: Nested, c: Nested, lengths: Nested) -> Cones:
    """The closure equations as quadratic cones, F_i = n_iᵀ M_i n_i.

    Equations (6) of the paper; base frame.
    81 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]

    Returns
    -------
    cone_1 : nested list (..., 3, 3)
        M_1, symmetric [m²]
    cone_2 : nested list (..., 3, 3)
        M_2, symmetric [m²]
    cone_3 : nested list (..., 3, 3)
        M_3, symmetric [m²]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²]
    M1_11 = (c_y*c_y) + (c_z*c_z) - (q1*q1)
    x0 = c_y*h1
    M1_12 = x0
    x1 = c_z*h1
    M1_13 = x1
    M1_21 = x0
    x2 = (h1*h1)
    M1_22 = x2
    M1_31 = x1
    M1_33 = x2
    x3 = SQRT3_2*c_y
    x4 = mpf(1)/2*c_x
    x5 = a + x4
    # distance of C from the plane of the limb (4) [m]
    h2 = -x3 + x5
    x6 = mpf(1)/4*c_y
    x7 = SQRT3_2*x4
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x6 + x7
    x8 = mpf(1)/2*c_y
    x9 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x8 - x9) - mpf(1)/2*h2
    x10 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x10
    x11 = SQRT3_2*c_z
    hz2_y = x11
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    # matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²]
    M2_11 = -(hp2_x*hp2_x) + (ht2_x*ht2_x) + (hz2_x*hz2_x)
    x12 = -hp2_x*hp2_y + ht2_x*ht2_y + hz2_x*hz2_y
    M2_12 = x12
    x13 = h2*hz2_x
    M2_13 = x13
    M2_21 = x12
    M2_22 = -(hp2_y*hp2_y) + (ht2_y*ht2_y) + (hz2_y*hz2_y)
    x14 = h2*hz2_y
    M2_23 = x14
    M2_31 = x13
    M2_32 = x14
    M2_33 = (h2*h2)
    # distance of C from the plane of the limb (4) [m]
    h3 = x3 + x5
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x6 - x7
    ht3_y = -SQRT3_2*(-x8 + x9) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x10
    hz3_y = -x11
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    # matrix of the cone, which is F_i = n_i · M_i n_i (6) [m²]
    M3_11 = -(hp3_x*hp3_x) + (ht3_x*ht3_x) + (hz3_x*hz3_x)
    x15 = -hp3_x*hp3_y + ht3_x*ht3_y + hz3_x*hz3_y
    M3_12 = x15
    x16 = h3*hz3_x
    M3_13 = x16
    M3_21 = x15
    M3_22 = -(hp3_y*hp3_y) + (ht3_y*ht3_y) + (hz3_y*hz3_y)
    x17 = h3*hz3_y
    M3_23 = x17
    M3_31 = x16
    M3_32 = x17
    M3_33 = (h3*h3)
    return Cones(
        [[M1_11, M1_12, M1_13], [M1_21, M1_22, 0.0], [M1_31, 0.0, M1_33]],
        [[M2_11, M2_12, M2_13], [M2_21, M2_22, M2_23], [M2_31, M2_32, M2_33]],
        [[M3_11, M3_12, M3_13], [M3_21, M3_22, M3_23], [M3_31, M3_32, M3_33]],
    )


class Eliminant(NamedTuple):
    """What `eliminant` returns."""

    eliminant: Nested
    bound: Nested


def eliminant(a: Nested, c: Nested, lengths: Nested, angle: Nested, reference: Nested) -> Eliminant:
    """The resultant that vanishes at the angles of leg 1 of the assembly modes.

    Equations (5), (6) of the paper; base frame.
    371 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    angle : nested list (..., 2)
        cos, sin of leg 1's angle [1]
    reference : nested list (..., 3)
        a vector not parallel to n_1 [1]

    Returns
    -------
    eliminant : nested list (...)
        resultant of the quartics of limbs 2, 3 [m¹⁶]
    bound : nested list (...)
        Hadamard's bound on it [m¹⁶]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    angle = _exact(angle)
    reference = _exact(reference)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    cos_theta, sin_theta = angle
    reference_x, reference_y, reference_z = reference
    # from C to B_1, leg 1 at the angle theta [m]
    arm_x = a - c_x
    arm_y = -c_y + cos_theta*q1
    arm_z = -c_z + q1*sin_theta
    x0 = 1.0/(sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z)))
    # direction from C to B_1 (3) [1]
    n1_x = arm_x*x0
    n1_y = arm_y*x0
    n1_z = arm_z*x0
    x1 = -n1_y*reference_z + n1_z*reference_y
    x2 = -n1_x*reference_y + n1_y*reference_x
    x3 = n1_x*reference_z - n1_z*reference_x
    x4 = 1.0/(sqrt((x1*x1) + (x2*x2) + (x3*x3)))
    # a unit vector normal to n_1 [1]
    f_x = x1*x4
    f_y = x3*x4
    f_z = x2*x4
    # completes the frame of n_1 [1]
    g_x = -f_y*n1_z + f_z*n1_y
    g_y = f_x*n1_z - f_z*n1_x
    g_z = -f_x*n1_y + f_y*n1_x
    x5 = SQRT3_2*c_y
    x6 = mpf(1)/2*c_x
    x7 = a + x6
    # distance of C from the plane of the limb (4) [m]
    h2 = -x5 + x7
    x8 = mpf(1)/4*c_y
    x9 = SQRT3_2*x6
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x8 + x9
    x10 = mpf(1)/2*h2
    x11 = mpf(1)/2*c_y
    x12 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x11 - x12) - x10
    x13 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x13
    x14 = SQRT3_2*c_z
    hz2_y = x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    x15 = SQRT3_2*(f_x*ht2_x + f_y*ht2_y)
    x16 = mpf(1)/2*n1_x
    x17 = mpf(1)/2*n1_y
    x18 = ht2_x*x16 + ht2_y*x17
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    htx2_x = x15 - x18
    x19 = 2.0*SQRT3_2
    htx2_y = x19*(g_x*ht2_x + g_y*ht2_y)
    htx2_z = -x15 - x18
    x20 = SQRT3_2*(f_x*hz2_x + f_y*hz2_y + f_z*h2)
    x21 = hz2_x*x16 + hz2_y*x17 + n1_z*x10
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    hzx2_x = x20 - x21
    hzx2_y = x19*(g_x*hz2_x + g_y*hz2_y + g_z*h2)
    hzx2_z = -x20 - x21
    x22 = SQRT3_2*(f_x*hp2_x + f_y*hp2_y)
    x23 = hp2_x*x16 + hp2_y*x17
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    hpx2_x = x22 - x23
    hpx2_y = x19*(g_x*hp2_x + g_y*hp2_y)
    hpx2_z = -x22 - x23
    # coefficients of (x² + y²)² F_2 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²]
    K2_1 = -(hpx2_x*hpx2_x) + (htx2_x*htx2_x) + (hzx2_x*hzx2_x)
    x24 = 2.0*hpx2_x
    x25 = 2.0*htx2_x
    x26 = 2.0*hzx2_x
    K2_2 = -hpx2_y*x24 + htx2_y*x25 + hzx2_y*x26
    K2_3 = -(hpx2_y*hpx2_y) - hpx2_z*x24 + (htx2_y*htx2_y) + htx2_z*x25 + (hzx2_y*hzx2_y) + hzx2_z*x26
    K2_4 = -2.0*hpx2_y*hpx2_z + 2.0*htx2_y*htx2_z + 2.0*hzx2_y*hzx2_z
    K2_5 = -(hpx2_z*hpx2_z) + (htx2_z*htx2_z) + (hzx2_z*hzx2_z)
    # distance of C from the plane of the limb (4) [m]
    h3 = x5 + x7
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x8 - x9
    x27 = mpf(1)/2*h3
    ht3_y = -SQRT3_2*(-x11 + x12) - x27
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x13
    hz3_y = -x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    x28 = SQRT3_2*(f_x*ht3_x + f_y*ht3_y)
    x29 = ht3_x*x16 + ht3_y*x17
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    htx3_x = -x28 - x29
    htx3_y = -x19*(g_x*ht3_x + g_y*ht3_y)
    htx3_z = x28 - x29
    x30 = SQRT3_2*(f_x*hz3_x + f_y*hz3_y + f_z*h3)
    x31 = hz3_x*x16 + hz3_y*x17 + n1_z*x27
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    hzx3_x = -x30 - x31
    hzx3_y = -x19*(g_x*hz3_x + g_y*hz3_y + g_z*h3)
    hzx3_z = x30 - x31
    x32 = SQRT3_2*(f_x*hp3_x + f_y*hp3_y)
    x33 = hp3_x*x16 + hp3_y*x17
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    hpx3_x = -x32 - x33
    hpx3_y = -x19*(g_x*hp3_x + g_y*hp3_y)
    hpx3_z = x32 - x33
    # coefficients of (x² + y²)² F_3 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²]
    K3_1 = -(hpx3_x*hpx3_x) + (htx3_x*htx3_x) + (hzx3_x*hzx3_x)
    x34 = 2.0*hpx3_x
    x35 = 2.0*htx3_x
    x36 = 2.0*hzx3_x
    K3_2 = -hpx3_y*x34 + htx3_y*x35 + hzx3_y*x36
    K3_3 = -(hpx3_y*hpx3_y) - hpx3_z*x34 + (htx3_y*htx3_y) + htx3_z*x35 + (hzx3_y*hzx3_y) + hzx3_z*x36
    K3_4 = -2.0*hpx3_y*hpx3_z + 2.0*htx3_y*htx3_z + 2.0*hzx3_y*hzx3_z
    K3_5 = -(hpx3_z*hpx3_z) + (htx3_z*htx3_z) + (hzx3_z*hzx3_z)
    # brackets of the two quartics [m⁴]
    brackets_12 = K2_1*K3_2 - K2_2*K3_1
    brackets_13 = K2_1*K3_3 - K2_3*K3_1
    brackets_14 = K2_1*K3_4 - K2_4*K3_1
    brackets_15 = K2_1*K3_5 - K2_5*K3_1
    brackets_23 = K2_2*K3_3 - K2_3*K3_2
    brackets_24 = K2_2*K3_4 - K2_4*K3_2
    brackets_25 = K2_2*K3_5 - K2_5*K3_2
    brackets_34 = K2_3*K3_4 - K2_4*K3_3
    brackets_35 = K2_3*K3_5 - K2_5*K3_3
    brackets_45 = K2_4*K3_5 - K2_5*K3_4
    # Bezoutian of the two quartics [m⁴]
    Z_22 = brackets_14 + brackets_23
    x37 = brackets_15 + brackets_24
    Z_23 = x37
    Z_32 = x37
    Z_33 = brackets_25 + brackets_34
    x38 = (brackets_13*brackets_13)
    # minors of rows 1 and 2 of the Bezoutian [m⁸]
    upper_x = Z_22*brackets_12 - x38
    upper_y = Z_23*brackets_12 - brackets_13*brackets_14
    upper_z = brackets_12*brackets_25 - brackets_13*brackets_15
    upper_ox = -Z_22*brackets_14 + Z_23*brackets_13
    upper_oy = -Z_22*brackets_15 + brackets_13*brackets_25
    x39 = -brackets_14*brackets_25
    upper_oz = -Z_23*brackets_15 - x39
    # minors of rows 3 and 4 of the Bezoutian [m⁸]
    lower_x = -Z_32*brackets_15 - x39
    lower_y = -Z_33*brackets_15 + brackets_14*brackets_35
    lower_z = brackets_14*brackets_45 - brackets_15*brackets_35
    lower_ox = Z_32*brackets_35 - Z_33*brackets_25
    lower_oy = Z_32*brackets_45 - brackets_25*brackets_35
    x40 = (brackets_35*brackets_35)
    lower_oz = Z_33*brackets_45 - x40
    # resultant of the two quartics, the determinant [m¹⁶]
    eliminant = lower_ox*upper_z - lower_oy*upper_y + lower_oz*upper_x + lower_x*upper_oz - lower_y*upper_oy + lower_z*upper_ox
    x41 = (brackets_25*brackets_25)
    x42 = (brackets_14*brackets_14)
    x43 = (brackets_15*brackets_15)
    # Hadamard's bound on the eliminant: the product of the lengths of the rows [m¹⁶]
    bound = sqrt((Z_22*Z_22) + (Z_23*Z_23) + x38 + x41)*sqrt((brackets_12*brackets_12) + x38 + x42 + x43)*sqrt((brackets_45*brackets_45) + x40 + x41 + x43)*sqrt((Z_32*Z_32) + (Z_33*Z_33) + x40 + x42)
    return Eliminant(
        eliminant,
        bound,
    )


class HalfTurn(NamedTuple):
    """What `half_turn` returns."""

    frame: Nested
    powers: Nested


def half_turn(a: Nested, c: Nested, lengths: Nested, angle: Nested, reference: Nested) -> HalfTurn:
    """The turn about n_1 at a zero of the eliminant, as a half angle.

    Equations (5), (6) of the paper; base frame.
    368 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    angle : nested list (..., 2)
        cos, sin of leg 1's angle [1]
    reference : nested list (..., 3)
        a vector not parallel to n_1 [1]

    Returns
    -------
    frame : nested list (..., 3, 3)
        n_1, f, g, a row each [1]
    powers : nested list (..., 2, 4)
        along x³, x²y, xy², y³ twice [m¹²]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    angle = _exact(angle)
    reference = _exact(reference)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    cos_theta, sin_theta = angle
    reference_x, reference_y, reference_z = reference
    # from C to B_1, leg 1 at the angle theta [m]
    arm_x = a - c_x
    arm_y = -c_y + cos_theta*q1
    arm_z = -c_z + q1*sin_theta
    x0 = 1.0/(sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z)))
    # direction from C to B_1 (3) [1]
    n1_x = arm_x*x0
    n1_y = arm_y*x0
    n1_z = arm_z*x0
    x1 = -n1_y*reference_z + n1_z*reference_y
    x2 = -n1_x*reference_y + n1_y*reference_x
    x3 = n1_x*reference_z - n1_z*reference_x
    x4 = 1.0/(sqrt((x1*x1) + (x2*x2) + (x3*x3)))
    # a unit vector normal to n_1 [1]
    f_x = x1*x4
    f_y = x3*x4
    f_z = x2*x4
    # completes the frame of n_1 [1]
    g_x = -f_y*n1_z + f_z*n1_y
    g_y = f_x*n1_z - f_z*n1_x
    g_z = -f_x*n1_y + f_y*n1_x
    x5 = SQRT3_2*c_y
    x6 = mpf(1)/2*c_x
    x7 = a + x6
    # distance of C from the plane of the limb (4) [m]
    h2 = -x5 + x7
    x8 = mpf(1)/4*c_y
    x9 = SQRT3_2*x6
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x8 + x9
    x10 = mpf(1)/2*h2
    x11 = mpf(1)/2*c_y
    x12 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x11 - x12) - x10
    x13 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x13
    x14 = SQRT3_2*c_z
    hz2_y = x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    x15 = SQRT3_2*(f_x*ht2_x + f_y*ht2_y)
    x16 = mpf(1)/2*n1_x
    x17 = mpf(1)/2*n1_y
    x18 = ht2_x*x16 + ht2_y*x17
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    htx2_x = x15 - x18
    x19 = 2.0*SQRT3_2
    htx2_y = x19*(g_x*ht2_x + g_y*ht2_y)
    htx2_z = -x15 - x18
    x20 = SQRT3_2*(f_x*hz2_x + f_y*hz2_y + f_z*h2)
    x21 = hz2_x*x16 + hz2_y*x17 + n1_z*x10
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    hzx2_x = x20 - x21
    hzx2_y = x19*(g_x*hz2_x + g_y*hz2_y + g_z*h2)
    hzx2_z = -x20 - x21
    x22 = SQRT3_2*(f_x*hp2_x + f_y*hp2_y)
    x23 = hp2_x*x16 + hp2_y*x17
    # form of limb 2 in the half angle of the turn, at x², xy, y² [m]
    hpx2_x = x22 - x23
    hpx2_y = x19*(g_x*hp2_x + g_y*hp2_y)
    hpx2_z = -x22 - x23
    # coefficients of (x² + y²)² F_2 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²]
    K2_1 = -(hpx2_x*hpx2_x) + (htx2_x*htx2_x) + (hzx2_x*hzx2_x)
    x24 = 2.0*hpx2_x
    x25 = 2.0*htx2_x
    x26 = 2.0*hzx2_x
    K2_2 = -hpx2_y*x24 + htx2_y*x25 + hzx2_y*x26
    K2_3 = -(hpx2_y*hpx2_y) - hpx2_z*x24 + (htx2_y*htx2_y) + htx2_z*x25 + (hzx2_y*hzx2_y) + hzx2_z*x26
    K2_4 = -2.0*hpx2_y*hpx2_z + 2.0*htx2_y*htx2_z + 2.0*hzx2_y*hzx2_z
    K2_5 = -(hpx2_z*hpx2_z) + (htx2_z*htx2_z) + (hzx2_z*hzx2_z)
    # distance of C from the plane of the limb (4) [m]
    h3 = x5 + x7
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x8 - x9
    x27 = mpf(1)/2*h3
    ht3_y = -SQRT3_2*(-x11 + x12) - x27
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x13
    hz3_y = -x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    x28 = SQRT3_2*(f_x*ht3_x + f_y*ht3_y)
    x29 = ht3_x*x16 + ht3_y*x17
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    htx3_x = -x28 - x29
    htx3_y = -x19*(g_x*ht3_x + g_y*ht3_y)
    htx3_z = x28 - x29
    x30 = SQRT3_2*(f_x*hz3_x + f_y*hz3_y + f_z*h3)
    x31 = hz3_x*x16 + hz3_y*x17 + n1_z*x27
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    hzx3_x = -x30 - x31
    hzx3_y = -x19*(g_x*hz3_x + g_y*hz3_y + g_z*h3)
    hzx3_z = x30 - x31
    x32 = SQRT3_2*(f_x*hp3_x + f_y*hp3_y)
    x33 = hp3_x*x16 + hp3_y*x17
    # form of limb 3 in the half angle of the turn, at x², xy, y² [m]
    hpx3_x = -x32 - x33
    hpx3_y = -x19*(g_x*hp3_x + g_y*hp3_y)
    hpx3_z = x32 - x33
    # coefficients of (x² + y²)² F_3 at x⁴, x³y, x²y², xy³, y⁴ (6) [m²]
    K3_1 = -(hpx3_x*hpx3_x) + (htx3_x*htx3_x) + (hzx3_x*hzx3_x)
    x34 = 2.0*hpx3_x
    x35 = 2.0*htx3_x
    x36 = 2.0*hzx3_x
    K3_2 = -hpx3_y*x34 + htx3_y*x35 + hzx3_y*x36
    K3_3 = -(hpx3_y*hpx3_y) - hpx3_z*x34 + (htx3_y*htx3_y) + htx3_z*x35 + (hzx3_y*hzx3_y) + hzx3_z*x36
    K3_4 = -2.0*hpx3_y*hpx3_z + 2.0*htx3_y*htx3_z + 2.0*hzx3_y*hzx3_z
    K3_5 = -(hpx3_z*hpx3_z) + (htx3_z*htx3_z) + (hzx3_z*hzx3_z)
    # brackets of the two quartics [m⁴]
    brackets_12 = K2_1*K3_2 - K2_2*K3_1
    brackets_13 = K2_1*K3_3 - K2_3*K3_1
    brackets_14 = K2_1*K3_4 - K2_4*K3_1
    brackets_15 = K2_1*K3_5 - K2_5*K3_1
    brackets_23 = K2_2*K3_3 - K2_3*K3_2
    brackets_24 = K2_2*K3_4 - K2_4*K3_2
    brackets_25 = K2_2*K3_5 - K2_5*K3_2
    brackets_34 = K2_3*K3_4 - K2_4*K3_3
    brackets_35 = K2_3*K3_5 - K2_5*K3_3
    brackets_45 = K2_4*K3_5 - K2_5*K3_4
    # Bezoutian of the two quartics [m⁴]
    Z_22 = brackets_14 + brackets_23
    x37 = brackets_15 + brackets_24
    Z_23 = x37
    Z_32 = x37
    Z_33 = brackets_25 + brackets_34
    # minors of rows 1 and 2 of the Bezoutian [m⁸]
    upper_x = Z_22*brackets_12 - (brackets_13*brackets_13)
    upper_y = Z_23*brackets_12 - brackets_13*brackets_14
    upper_z = brackets_12*brackets_25 - brackets_13*brackets_15
    upper_ox = -Z_22*brackets_14 + Z_23*brackets_13
    upper_oy = -Z_22*brackets_15 + brackets_13*brackets_25
    x38 = -brackets_14*brackets_25
    upper_oz = -Z_23*brackets_15 - x38
    # minors of rows 3 and 4 of the Bezoutian [m⁸]
    lower_x = -Z_32*brackets_15 - x38
    lower_y = -Z_33*brackets_15 + brackets_14*brackets_35
    lower_z = brackets_14*brackets_45 - brackets_15*brackets_35
    lower_ox = Z_32*brackets_35 - Z_33*brackets_25
    lower_oy = Z_32*brackets_45 - brackets_25*brackets_35
    lower_oz = Z_33*brackets_45 - (brackets_35*brackets_35)
    # row 1 of the adjugate [m¹²]
    adj1_1 = Z_22*lower_oz - Z_23*lower_oy + brackets_25*lower_ox
    adj1_2 = Z_23*lower_z - brackets_13*lower_oz - brackets_25*lower_y
    adj1_3 = -Z_22*lower_z + brackets_13*lower_oy + brackets_25*lower_x
    adj1_4 = Z_22*lower_y - Z_23*lower_x - brackets_13*lower_ox
    # row 4 of the adjugate [m¹²]
    adj4_1 = -Z_32*upper_oz + Z_33*upper_oy - brackets_35*upper_ox
    adj4_2 = -Z_33*upper_z + brackets_14*upper_oz + brackets_35*upper_y
    adj4_3 = Z_32*upper_z - brackets_14*upper_oy - brackets_35*upper_x
    adj4_4 = -Z_32*upper_y + Z_33*upper_x + brackets_14*upper_ox
    return HalfTurn(
        [[n1_x, n1_y, n1_z], [f_x, f_y, f_z], [g_x, g_y, g_z]],
        [[adj1_1, adj1_2, adj1_3, adj1_4], [adj4_1, adj4_2, adj4_3, adj4_4]],
    )


class TurnedDirections(NamedTuple):
    """What `turned_directions` returns."""

    directions: Nested


def turned_directions(frame: Nested, half_angle: Nested) -> TurnedDirections:
    """n_1 and n_2 from the frame about n_1 and the half angle of the turn.

    Equations (5) of the paper; base frame.
    27 operations.

    Parameters
    ----------
    frame : nested list (..., 3, 3)
        n_1, f, g, a row each [1]
    half_angle : nested list (..., 2)
        (x, y), any length [1]

    Returns
    -------
    directions : nested list (..., 2, 3)
        n_1 and n_2, a row each [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    frame = _exact(frame)
    half_angle = _exact(half_angle)
    (n1_x, n1_y, n1_z), (f_x, f_y, f_z), (g_x, g_y, g_z) = frame
    x, y = half_angle
    x0 = (x*x)
    x1 = (y*y)
    x2 = 1.0/(x0 + x1)
    x3 = 2.0*x*x2*y
    x4 = x2*(x0 - x1)
    # direction from C to B_2, the platform turned by phi about n_1 (5) [1]
    n2_x = SQRT3_2*(f_x*x4 + g_x*x3) - mpf(1)/2*n1_x
    n2_y = SQRT3_2*(f_y*x4 + g_y*x3) - mpf(1)/2*n1_y
    n2_z = SQRT3_2*(f_z*x4 + g_z*x3) - mpf(1)/2*n1_z
    return TurnedDirections(
        [[n1_x, n1_y, n1_z], [n2_x, n2_y, n2_z]],
    )


class Circles(NamedTuple):
    """What `circles` returns."""

    angle: Nested
    cone: Nested
    first: Nested
    second: Nested


def circles(a: Nested, c: Nested, lengths: Nested, start: Nested) -> Circles:
    """Two equations in the half angles t, s of legs 1 and 2: entry [k, l] is at t^k s^l.

    Equations (5), (6) of the paper; base frame.
    716 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    start : nested list (..., 2, 2)
        cos, sin of the angles of legs 1, 2 at t = s = 0 [1]

    Returns
    -------
    angle : nested list (..., 5, 5)
        n_1 and n_2 are 120° apart [m⁴]
    cone : nested list (..., 5, 5)
        limb 3 closes [m⁶]
    first : nested list (..., 3, 3)
        (1 + t²)(b_1 − c) at 1, t, t², a row each [m]
    second : nested list (..., 3, 3)
        (1 + s²)(b_2 − c) at 1, s, s², a row each [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    start = _exact(start)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    (cos_start1, sin_start1), (cos_start2, sin_start2) = start
    # from C to A_1 [m]
    center1_x = a - c_x
    x0 = -c_y
    center1_y = x0
    x1 = -c_z
    center1_z = x1
    # direction of leg 1 a quarter turn on [1]
    up1_y = -sin_start1
    x2 = cos_start1*q1
    # from C to B_1 times 1 + t², its part at 1 [m]
    va1_y = center1_y + x2
    x3 = q1*sin_start1
    va1_z = center1_z + x3
    # from C to B_1 times 1 + t², its part at t [m]
    vb1_y = 2.0*q1*up1_y
    vb1_z = 2.0*x2
    # from C to B_1 times 1 + t², its part at t² [m]
    vc1_y = center1_y - x2
    vc1_z = center1_z - x3
    # from C to A_2 [m]
    center2_x = -mpf(1)/2*a - c_x
    center2_y = SQRT3_2*a + x0
    center2_z = x1
    # direction of leg 2 at half angle 0 [1]
    near2_x = -SQRT3_2*cos_start2
    near2_y = -mpf(1)/2*cos_start2
    # direction of leg 2 a quarter turn on [1]
    up2_x = SQRT3_2*sin_start2
    up2_y = mpf(1)/2*sin_start2
    x4 = near2_x*q2
    # from C to B_2 times 1 + s², its part at 1 [m]
    va2_x = center2_x + x4
    x5 = near2_y*q2
    va2_y = center2_y + x5
    x6 = q2*sin_start2
    va2_z = center2_z + x6
    x7 = 2.0*q2
    # from C to B_2 times 1 + s², its part at s [m]
    vb2_x = up2_x*x7
    vb2_y = up2_y*x7
    vb2_z = cos_start2*x7
    # from C to B_2 times 1 + s², its part at s² [m]
    vc2_x = center2_x - x4
    vc2_y = center2_y - x5
    vc2_z = center2_z - x6
    x8 = mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h3 = SQRT3_2*c_y + a + x8
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 - SQRT3_2*x8 + mpf(1)/4*c_y
    ht3_y = -SQRT3_2*(SQRT3_2*c_x - mpf(1)/2*c_y) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = -mpf(1)/2*c_z
    hz3_y = -SQRT3_2*c_z
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    x9 = (center1_x*center1_x)
    # square of the arm to B_1, its coefficients [m²]
    N1_1 = (va1_y*va1_y) + (va1_z*va1_z) + x9
    x10 = 2.0*va1_y
    x11 = 2.0*va1_z
    N1_2 = vb1_y*x10 + vb1_z*x11
    N1_3 = (vb1_y*vb1_y) + (vb1_z*vb1_z) + vc1_y*x10 + vc1_z*x11 + 2.0*x9
    N1_4 = 2.0*vb1_y*vc1_y + 2.0*vb1_z*vc1_z
    N1_5 = (vc1_y*vc1_y) + (vc1_z*vc1_z) + x9
    x12 = center1_x*ht3_x
    # form of limb 3 along the arm to B_1, its coefficients [m²]
    htv1_x = ht3_y*va1_y + x12
    htv1_y = ht3_y*vb1_y
    htv1_z = ht3_y*vc1_y + x12
    x13 = center1_x*hz3_x
    # form of limb 3 along the arm to B_1, its coefficients [m²]
    hzv1_x = h3*va1_z + hz3_y*va1_y + x13
    hzv1_y = h3*vb1_z + hz3_y*vb1_y
    hzv1_z = h3*vc1_z + hz3_y*vc1_y + x13
    x14 = center1_x*hp3_x
    # form of limb 3 along the arm to B_1, its coefficients [m²]
    hpv1_x = hp3_y*va1_y + x14
    hpv1_y = hp3_y*vb1_y
    hpv1_z = hp3_y*vc1_y + x14
    # cone of limb 3 at the arm to B_1, its coefficients [m⁴]
    C1_1 = -(hpv1_x*hpv1_x) + (htv1_x*htv1_x) + (hzv1_x*hzv1_x)
    x15 = 2.0*hpv1_x
    x16 = 2.0*htv1_x
    x17 = 2.0*hzv1_x
    C1_2 = -hpv1_y*x15 + htv1_y*x16 + hzv1_y*x17
    C1_3 = -(hpv1_y*hpv1_y) - hpv1_z*x15 + (htv1_y*htv1_y) + htv1_z*x16 + (hzv1_y*hzv1_y) + hzv1_z*x17
    C1_4 = -2.0*hpv1_y*hpv1_z + 2.0*htv1_y*htv1_z + 2.0*hzv1_y*hzv1_z
    C1_5 = -(hpv1_z*hpv1_z) + (htv1_z*htv1_z) + (hzv1_z*hzv1_z)
    # square of the arm to B_2, its coefficients [m²]
    N2_1 = (va2_x*va2_x) + (va2_y*va2_y) + (va2_z*va2_z)
    x18 = 2.0*va2_x
    x19 = 2.0*va2_y
    x20 = 2.0*va2_z
    N2_2 = vb2_x*x18 + vb2_y*x19 + vb2_z*x20
    N2_3 = (vb2_x*vb2_x) + (vb2_y*vb2_y) + (vb2_z*vb2_z) + vc2_x*x18 + vc2_y*x19 + vc2_z*x20
    N2_4 = 2.0*vb2_x*vc2_x + 2.0*vb2_y*vc2_y + 2.0*vb2_z*vc2_z
    N2_5 = (vc2_x*vc2_x) + (vc2_y*vc2_y) + (vc2_z*vc2_z)
    # form of limb 3 along the arm to B_2, its coefficients [m²]
    htv2_x = ht3_x*va2_x + ht3_y*va2_y
    htv2_y = ht3_x*vb2_x + ht3_y*vb2_y
    htv2_z = ht3_x*vc2_x + ht3_y*vc2_y
    # form of limb 3 along the arm to B_2, its coefficients [m²]
    hzv2_x = h3*va2_z + hz3_x*va2_x + hz3_y*va2_y
    hzv2_y = h3*vb2_z + hz3_x*vb2_x + hz3_y*vb2_y
    hzv2_z = h3*vc2_z + hz3_x*vc2_x + hz3_y*vc2_y
    # form of limb 3 along the arm to B_2, its coefficients [m²]
    hpv2_x = hp3_x*va2_x + hp3_y*va2_y
    hpv2_y = hp3_x*vb2_x + hp3_y*vb2_y
    hpv2_z = hp3_x*vc2_x + hp3_y*vc2_y
    # cone of limb 3 at the arm to B_2, its coefficients [m⁴]
    C2_1 = -(hpv2_x*hpv2_x) + (htv2_x*htv2_x) + (hzv2_x*hzv2_x)
    x21 = 2.0*hpv2_x
    x22 = 2.0*htv2_x
    x23 = 2.0*hzv2_x
    C2_2 = -hpv2_y*x21 + htv2_y*x22 + hzv2_y*x23
    C2_3 = -(hpv2_y*hpv2_y) - hpv2_z*x21 + (htv2_y*htv2_y) + htv2_z*x22 + (hzv2_y*hzv2_y) + hzv2_z*x23
    C2_4 = -2.0*hpv2_y*hpv2_z + 2.0*htv2_y*htv2_z + 2.0*hzv2_y*hzv2_z
    C2_5 = -(hpv2_z*hpv2_z) + (htv2_z*htv2_z) + (hzv2_z*hzv2_z)
    x24 = center1_x*va2_x
    # product of the arms to B_1 and B_2, its coefficients [m²]
    N12_11 = va1_y*va2_y + va1_z*va2_z + x24
    x25 = center1_x*vb2_x
    N12_12 = va1_y*vb2_y + va1_z*vb2_z + x25
    x26 = center1_x*vc2_x
    N12_13 = va1_y*vc2_y + va1_z*vc2_z + x26
    N12_21 = va2_y*vb1_y + va2_z*vb1_z
    N12_22 = vb1_y*vb2_y + vb1_z*vb2_z
    N12_23 = vb1_y*vc2_y + vb1_z*vc2_z
    N12_31 = va2_y*vc1_y + va2_z*vc1_z + x24
    N12_32 = vb2_y*vc1_y + vb2_z*vc1_z + x25
    N12_33 = vc1_y*vc2_y + vc1_z*vc2_z + x26
    # cone of limb 3 between the arms to B_1 and B_2, its coefficients [m⁴]
    C12_11 = -hpv1_x*hpv2_x + htv1_x*htv2_x + hzv1_x*hzv2_x
    C12_12 = -hpv1_x*hpv2_y + htv1_x*htv2_y + hzv1_x*hzv2_y
    C12_13 = -hpv1_x*hpv2_z + htv1_x*htv2_z + hzv1_x*hzv2_z
    C12_21 = -hpv1_y*hpv2_x + htv1_y*htv2_x + hzv1_y*hzv2_x
    C12_22 = -hpv1_y*hpv2_y + htv1_y*htv2_y + hzv1_y*hzv2_y
    C12_23 = -hpv1_y*hpv2_z + htv1_y*htv2_z + hzv1_y*hzv2_z
    C12_31 = -hpv1_z*hpv2_x + htv1_z*htv2_x + hzv1_z*hzv2_x
    C12_32 = -hpv1_z*hpv2_y + htv1_z*htv2_y + hzv1_z*hzv2_y
    C12_33 = -hpv1_z*hpv2_z + htv1_z*htv2_z + hzv1_z*hzv2_z
    # condition that n_1 and n_2 are 120° apart, its coefficients (5) [m⁴]
    angle_11 = 4.0*(N12_11*N12_11) - N1_1*N2_1
    x27 = 8.0*N12_11
    angle_12 = N12_12*x27 - N1_1*N2_2
    angle_13 = 4.0*(N12_12*N12_12) + N12_13*x27 - N1_1*N2_3
    x28 = 8.0*N12_12
    angle_14 = N12_13*x28 - N1_1*N2_4
    angle_15 = 4.0*(N12_13*N12_13) - N1_1*N2_5
    angle_21 = N12_21*x27 - N1_2*N2_1
    angle_22 = N12_21*x28 + N12_22*x27 - N1_2*N2_2
    x29 = 8.0*N12_13
    angle_23 = N12_21*x29 + N12_22*x28 + N12_23*x27 - N1_2*N2_3
    angle_24 = N12_22*x29 + N12_23*x28 - N1_2*N2_4
    angle_25 = N12_23*x29 - N1_2*N2_5
    angle_31 = 4.0*(N12_21*N12_21) + N12_31*x27 - N1_3*N2_1
    x30 = 8.0*N12_21
    angle_32 = N12_22*x30 + N12_31*x28 + N12_32*x27 - N1_3*N2_2
    angle_33 = 4.0*(N12_22*N12_22) + N12_23*x30 + N12_31*x29 + N12_32*x28 + N12_33*x27 - N1_3*N2_3
    x31 = 8.0*N12_22
    angle_34 = N12_23*x31 + N12_32*x29 + N12_33*x28 - N1_3*N2_4
    angle_35 = 4.0*(N12_23*N12_23) + N12_33*x29 - N1_3*N2_5
    angle_41 = N12_31*x30 - N1_4*N2_1
    angle_42 = N12_31*x31 + N12_32*x30 - N1_4*N2_2
    x32 = 8.0*N12_23
    angle_43 = N12_31*x32 + N12_32*x31 + N12_33*x30 - N1_4*N2_3
    angle_44 = N12_32*x32 + N12_33*x31 - N1_4*N2_4
    angle_45 = N12_33*x32 - N1_4*N2_5
    angle_51 = 4.0*(N12_31*N12_31) - N1_5*N2_1
    x33 = 8.0*N12_31
    angle_52 = N12_32*x33 - N1_5*N2_2
    angle_53 = 4.0*(N12_32*N12_32) + N12_33*x33 - N1_5*N2_3
    angle_54 = 8.0*N12_32*N12_33 - N1_5*N2_4
    angle_55 = 4.0*(N12_33*N12_33) - N1_5*N2_5
    x34 = 4.0*C12_11
    # condition that limb 3 closes, its coefficients (6) [m⁶]
    cone_11 = C1_1*N2_1 + C2_1*N1_1 - N12_11*x34
    x35 = 4.0*C12_12
    cone_12 = C1_1*N2_2 + C2_2*N1_1 - N12_11*x35 - N12_12*x34
    x36 = 4.0*C12_13
    cone_13 = C1_1*N2_3 + C2_3*N1_1 - N12_11*x36 - N12_12*x35 - N12_13*x34
    cone_14 = C1_1*N2_4 + C2_4*N1_1 - N12_12*x36 - N12_13*x35
    cone_15 = C1_1*N2_5 + C2_5*N1_1 - N12_13*x36
    x37 = 4.0*C12_21
    cone_21 = C1_2*N2_1 + C2_1*N1_2 - N12_11*x37 - N12_21*x34
    x38 = 4.0*C12_22
    cone_22 = C1_2*N2_2 + C2_2*N1_2 - N12_11*x38 - N12_12*x37 - N12_21*x35 - N12_22*x34
    x39 = 4.0*C12_23
    cone_23 = C1_2*N2_3 + C2_3*N1_2 - N12_11*x39 - N12_12*x38 - N12_13*x37 - N12_21*x36 - N12_22*x35 - N12_23*x34
    cone_24 = C1_2*N2_4 + C2_4*N1_2 - N12_12*x39 - N12_13*x38 - N12_22*x36 - N12_23*x35
    cone_25 = C1_2*N2_5 + C2_5*N1_2 - N12_13*x39 - N12_23*x36
    x40 = 4.0*C12_31
    cone_31 = C1_3*N2_1 + C2_1*N1_3 - N12_11*x40 - N12_21*x37 - N12_31*x34
    x41 = 4.0*C12_32
    cone_32 = C1_3*N2_2 + C2_2*N1_3 - N12_11*x41 - N12_12*x40 - N12_21*x38 - N12_22*x37 - N12_31*x35 - N12_32*x34
    x42 = 4.0*C12_33
    cone_33 = C1_3*N2_3 + C2_3*N1_3 - N12_11*x42 - N12_12*x41 - N12_13*x40 - N12_21*x39 - N12_22*x38 - N12_23*x37 - N12_31*x36 - N12_32*x35 - N12_33*x34
    cone_34 = C1_3*N2_4 + C2_4*N1_3 - N12_12*x42 - N12_13*x41 - N12_22*x39 - N12_23*x38 - N12_32*x36 - N12_33*x35
    cone_35 = C1_3*N2_5 + C2_5*N1_3 - N12_13*x42 - N12_23*x39 - N12_33*x36
    cone_41 = C1_4*N2_1 + C2_1*N1_4 - N12_21*x40 - N12_31*x37
    cone_42 = C1_4*N2_2 + C2_2*N1_4 - N12_21*x41 - N12_22*x40 - N12_31*x38 - N12_32*x37
    cone_43 = C1_4*N2_3 + C2_3*N1_4 - N12_21*x42 - N12_22*x41 - N12_23*x40 - N12_31*x39 - N12_32*x38 - N12_33*x37
    cone_44 = C1_4*N2_4 + C2_4*N1_4 - N12_22*x42 - N12_23*x41 - N12_32*x39 - N12_33*x38
    cone_45 = C1_4*N2_5 + C2_5*N1_4 - N12_23*x42 - N12_33*x39
    cone_51 = C1_5*N2_1 + C2_1*N1_5 - N12_31*x40
    cone_52 = C1_5*N2_2 + C2_2*N1_5 - N12_31*x41 - N12_32*x40
    cone_53 = C1_5*N2_3 + C2_3*N1_5 - N12_31*x42 - N12_32*x41 - N12_33*x40
    cone_54 = C1_5*N2_4 + C2_4*N1_5 - N12_32*x42 - N12_33*x41
    cone_55 = C1_5*N2_5 + C2_5*N1_5 - N12_33*x42
    return Circles(
        [[angle_11, angle_12, angle_13, angle_14, angle_15], [angle_21, angle_22, angle_23, angle_24, angle_25], [angle_31, angle_32, angle_33, angle_34, angle_35], [angle_41, angle_42, angle_43, angle_44, angle_45], [angle_51, angle_52, angle_53, angle_54, angle_55]],
        [[cone_11, cone_12, cone_13, cone_14, cone_15], [cone_21, cone_22, cone_23, cone_24, cone_25], [cone_31, cone_32, cone_33, cone_34, cone_35], [cone_41, cone_42, cone_43, cone_44, cone_45], [cone_51, cone_52, cone_53, cone_54, cone_55]],
        [[center1_x, va1_y, va1_z], [0.0, vb1_y, vb1_z], [center1_x, vc1_y, vc1_z]],
        [[va2_x, va2_y, va2_z], [vb2_x, vb2_y, vb2_z], [vc2_x, vc2_y, vc2_z]],
    )


class Arms(NamedTuple):
    """What `arms` returns."""

    arms: Nested


def arms(a: Nested, c: Nested, lengths: Nested, start: Nested, half_tangents: Nested) -> Arms:
    """The directions to B_1 and B_2 at half angles t, s of legs 1 and 2.

    Equations (3) of the paper; base frame.
    71 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    start : nested list (..., 2, 2)
        cos, sin of the angles of legs 1, 2 at t = s = 0 [1]
    half_tangents : nested list (..., 2)
        t, s [1]

    Returns
    -------
    arms : nested list (..., 2, 3)
        from C to B_1 and B_2, a row each [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    start = _exact(start)
    half_tangents = _exact(half_tangents)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    (cos_start1, sin_start1), (cos_start2, sin_start2) = start
    t, s = half_tangents
    # from C to A_1 [m]
    center1_x = a - c_x
    x0 = -c_y
    center1_y = x0
    x1 = -c_z
    center1_z = x1
    # direction of leg 1 a quarter turn on [1]
    up1_y = -sin_start1
    x2 = cos_start1*q1
    # from C to B_1 times 1 + t², its part at 1 [m]
    va1_y = center1_y + x2
    x3 = q1*sin_start1
    va1_z = center1_z + x3
    # from C to B_1 times 1 + t², its part at t [m]
    vb1_y = 2.0*q1*up1_y
    vb1_z = 2.0*x2
    # from C to B_1 times 1 + t², its part at t² [m]
    vc1_y = center1_y - x2
    vc1_z = center1_z - x3
    # from C to A_2 [m]
    center2_x = -mpf(1)/2*a - c_x
    center2_y = SQRT3_2*a + x0
    center2_z = x1
    # direction of leg 2 at half angle 0 [1]
    near2_x = -SQRT3_2*cos_start2
    near2_y = -mpf(1)/2*cos_start2
    # direction of leg 2 a quarter turn on [1]
    up2_x = SQRT3_2*sin_start2
    up2_y = mpf(1)/2*sin_start2
    x4 = near2_x*q2
    # from C to B_2 times 1 + s², its part at 1 [m]
    va2_x = center2_x + x4
    x5 = near2_y*q2
    va2_y = center2_y + x5
    x6 = q2*sin_start2
    va2_z = center2_z + x6
    x7 = 2.0*q2
    # from C to B_2 times 1 + s², its part at s [m]
    vb2_x = up2_x*x7
    vb2_y = up2_y*x7
    vb2_z = cos_start2*x7
    # from C to B_2 times 1 + s², its part at s² [m]
    vc2_x = center2_x - x4
    vc2_y = center2_y - x5
    vc2_z = center2_z - x6
    x8 = (t*t)
    x9 = 1.0/(x8 + 1.0)
    # from C to B_1 [m]
    arm1_x = x9*(center1_x*x8 + center1_x)
    arm1_y = x9*(t*vb1_y + va1_y + vc1_y*x8)
    arm1_z = x9*(t*vb1_z + va1_z + vc1_z*x8)
    x10 = (s*s)
    x11 = 1.0/(x10 + 1.0)
    # from C to B_2 [m]
    arm2_x = x11*(s*vb2_x + va2_x + vc2_x*x10)
    arm2_y = x11*(s*vb2_y + va2_y + vc2_y*x10)
    arm2_z = x11*(s*vb2_z + va2_z + vc2_z*x10)
    return Arms(
        [[arm1_x, arm1_y, arm1_z], [arm2_x, arm2_y, arm2_z]],
    )


class NewtonStep(NamedTuple):
    """What `newton_step` returns."""

    next: Nested
    turn: Nested
    residual: Nested
    gradient: Nested
    volume: Nested


def newton_step(a: Nested, c: Nested, lengths: Nested, directions: Nested) -> NewtonStep:
    """One step of Newton's method on the rotation, for the three closure equations.

    Equations (6) of the paper; base frame.
    278 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    directions : nested list (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    next : nested list (..., 2, 3)
        n_1, n_2 turned [1]
    turn : nested list (..., 3)
        the step, a rotation vector [rad]
    residual : nested list (..., 3)
        F_1, F_2, F_3 [m²]
    gradient : nested list (..., 3, 3)
        of F_i by a turn, a row each [m²]
    volume : nested list (...)
        determinant of the gradient [m⁶]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    directions = _exact(directions)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    (n1_x, n1_y, n1_z), (n2_x, n2_y, n2_z) = directions
    # the third direction (5) [1]
    n3_x = -n1_x - n2_x
    n3_y = -n1_y - n2_y
    n3_z = -n1_z - n2_z
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    x0 = (q1*q1)
    # closure equation of limb i, times p_i squared (6) [m²]
    F1 = (gt1*gt1) + (gz1*gz1) - x0*(n1_x*n1_x)
    x1 = 2.0*gt1
    x2 = 2.0*gz1
    # gradient of F_i in n_i (6) [m²]
    dF1_x = c_y*x1 + c_z*x2 - 2.0*n1_x*x0
    dF1_y = h1*x1
    dF1_z = h1*x2
    x3 = SQRT3_2*c_y
    x4 = mpf(1)/2*c_x
    x5 = a + x4
    # distance of C from the plane of the limb (4) [m]
    h2 = -x3 + x5
    x6 = mpf(1)/4*c_y
    x7 = SQRT3_2*x4
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x6 + x7
    x8 = mpf(1)/2*c_y
    x9 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x8 - x9) - mpf(1)/2*h2
    x10 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x10
    x11 = SQRT3_2*c_z
    hz2_y = x11
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # p_i times the horizontal part of the leg [m]
    gt2 = ht2_x*n2_x + ht2_y*n2_y
    # p_i times the vertical part of the leg [m]
    gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2)
    x12 = 2.0*gt2
    x13 = 2.0*gz2
    x14 = 2.0*p2*q2
    # gradient of F_i in n_i (6) [m²]
    dF2_x = -hp2_x*x14 + ht2_x*x12 + hz2_x*x13
    dF2_y = -hp2_y*x14 + ht2_y*x12 + hz2_y*x13
    dF2_z = h2*x13
    # distance of C from the plane of the limb (4) [m]
    h3 = x3 + x5
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x6 - x7
    ht3_y = -SQRT3_2*(-x8 + x9) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x10
    hz3_y = -x11
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # p_i times the horizontal part of the leg [m]
    gt3 = ht3_x*n3_x + ht3_y*n3_y
    # p_i times the vertical part of the leg [m]
    gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3)
    x15 = 2.0*gt3
    x16 = 2.0*gz3
    x17 = 2.0*p3*q3
    # gradient of F_i in n_i (6) [m²]
    dF3_x = -hp3_x*x17 + ht3_x*x15 + hz3_x*x16
    dF3_y = -hp3_y*x17 + ht3_y*x15 + hz3_y*x16
    dF3_z = h3*x16
    # derivative of F_i by a turn of the platform (6) [m²]
    G1_x = -dF1_y*n1_z + dF1_z*n1_y
    G1_y = dF1_x*n1_z - dF1_z*n1_x
    G1_z = -dF1_x*n1_y + dF1_y*n1_x
    # derivative of F_i by a turn of the platform (6) [m²]
    G2_x = -dF2_y*n2_z + dF2_z*n2_y
    G2_y = dF2_x*n2_z - dF2_z*n2_x
    G2_z = -dF2_x*n2_y + dF2_y*n2_x
    # derivative of F_i by a turn of the platform (6) [m²]
    G3_x = -dF3_y*n3_z + dF3_z*n3_y
    G3_y = dF3_x*n3_z - dF3_z*n3_x
    G3_z = -dF3_x*n3_y + dF3_y*n3_x
    x18 = G2_y*G3_z - G2_z*G3_y
    x19 = -G2_x*G3_z + G2_z*G3_x
    x20 = G2_x*G3_y - G2_y*G3_x
    # triple product of the derivatives: zero where modes meet [m⁶]
    volume = G1_x*x18 + G1_y*x19 + G1_z*x20
    x21 = 1.0/volume
    # Newton's turn, which cancels every F_i [rad]
    turn_x = -x21*(F1*x18 + F2*(-G1_y*G3_z + G1_z*G3_y) + F3*(G1_y*G2_z - G1_z*G2_y))
    turn_y = -x21*(F1*x19 + F2*(G1_x*G3_z - G1_z*G3_x) + F3*(-G1_x*G2_z + G1_z*G2_x))
    turn_z = -x21*(F1*x20 + F2*(-G1_x*G3_y + G1_y*G3_x) + F3*(G1_x*G2_y - G1_y*G2_x))
    # half of the turn [1]
    half_turn_x = mpf(1)/2*turn_x
    half_turn_y = mpf(1)/2*turn_y
    half_turn_z = mpf(1)/2*turn_z
    # factor of Cayley's rotation [1]
    cayley = 2.0/((half_turn_x*half_turn_x) + (half_turn_y*half_turn_y) + (half_turn_z*half_turn_z) + 1.0)
    x22 = half_turn_x*n1_y - half_turn_y*n1_x + n1_z
    x23 = -half_turn_x*n1_z + half_turn_z*n1_x + n1_y
    # n_1 turned [1]
    next1_x = cayley*(half_turn_y*x22 - half_turn_z*x23) + n1_x
    x24 = half_turn_y*n1_z - half_turn_z*n1_y + n1_x
    next1_y = cayley*(-half_turn_x*x22 + half_turn_z*x24) + n1_y
    next1_z = cayley*(half_turn_x*x23 - half_turn_y*x24) + n1_z
    x25 = half_turn_x*n2_y - half_turn_y*n2_x + n2_z
    x26 = -half_turn_x*n2_z + half_turn_z*n2_x + n2_y
    # n_2 turned [1]
    next2_x = cayley*(half_turn_y*x25 - half_turn_z*x26) + n2_x
    x27 = half_turn_y*n2_z - half_turn_z*n2_y + n2_x
    next2_y = cayley*(-half_turn_x*x25 + half_turn_z*x27) + n2_y
    next2_z = cayley*(half_turn_x*x26 - half_turn_y*x27) + n2_z
    return NewtonStep(
        [[next1_x, next1_y, next1_z], [next2_x, next2_y, next2_z]],
        [turn_x, turn_y, turn_z],
        [F1, F2, F3],
        [[G1_x, G1_y, G1_z], [G2_x, G2_y, G2_z], [G3_x, G3_y, G3_z]],
        volume,
    )


class LegStep(NamedTuple):
    """What `leg_step` returns."""

    angle: Nested
    directions: Nested
    extension: Nested
    steps: Nested


def leg_step(a: Nested, c: Nested, lengths: Nested, angle: Nested, second: Nested) -> LegStep:
    """One step of Newton's method in the angle of leg 1 and the turn about n_1.

    Equations (6) of the paper; base frame.
    303 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    lengths : nested list (..., 3)
        q1, q2, q3 [m]
    angle : nested list (..., 2)
        cos, sin of leg 1's angle [1]
    second : nested list (..., 3)
        n_2, or near it [1]

    Returns
    -------
    angle : nested list (..., 2)
        cos, sin of leg 1's angle [1]
    directions : nested list (..., 2, 3)
        n_1 and n_2 [1]
    extension : nested list (...)
        e_1, positive [m]
    steps : nested list (..., 2)
        of leg 1's angle and of the turn [rad]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    lengths = _exact(lengths)
    angle = _exact(angle)
    second = _exact(second)
    c_x, c_y, c_z = c
    q1, q2, q3 = lengths
    cos_theta, sin_theta = angle
    guess_x, guess_y, guess_z = second
    x0 = a - c_x
    # from C to B_1, leg 1 at the angle theta [m]
    arm_x = x0
    arm_y = -c_y + cos_theta*q1
    x1 = -q1*sin_theta
    arm_z = -c_z - x1
    # distance from C to B_1 [m]
    span = sqrt((arm_x*arm_x) + (arm_y*arm_y) + (arm_z*arm_z))
    x2 = 1.0/span
    # direction from C to B_1 (3) [1]
    n1_x = arm_x*x2
    n1_y = arm_y*x2
    n1_z = arm_z*x2
    # derivative of B_1 by theta [m]
    tangent_y = x1
    tangent_z = cos_theta*q1
    # the turn that takes n_1 along with theta [1]
    by_angle_x = x2*(n1_y*tangent_z - n1_z*tangent_y)
    x3 = n1_x*x2
    by_angle_y = -tangent_z*x3
    by_angle_z = tangent_y*x3
    x4 = -guess_x*n1_x - guess_y*n1_y - guess_z*n1_z
    # part of the guess normal to n_1 [1]
    side_part_x = guess_x + n1_x*x4
    side_part_y = guess_y + n1_y*x4
    side_part_z = guess_z + n1_z*x4
    x5 = SQRT3_2/(sqrt((side_part_x*side_part_x) + (side_part_y*side_part_y) + (side_part_z*side_part_z)))
    # direction from C to B_2 (5) [1]
    n2_x = -mpf(1)/2*n1_x + side_part_x*x5
    n2_y = -mpf(1)/2*n1_y + side_part_y*x5
    n2_z = -mpf(1)/2*n1_z + side_part_z*x5
    # the third direction (5) [1]
    n3_x = -n1_x - n2_x
    n3_y = -n1_y - n2_y
    n3_z = -n1_z - n2_z
    x6 = SQRT3_2*c_y
    x7 = mpf(1)/2*c_x
    x8 = a + x7
    # distance of C from the plane of the limb (4) [m]
    h2 = -x6 + x8
    x9 = mpf(1)/4*c_y
    x10 = SQRT3_2*x7
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x10 + x9
    x11 = mpf(1)/2*c_y
    x12 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x11 - x12) - mpf(1)/2*h2
    x13 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x13
    x14 = SQRT3_2*c_z
    hz2_y = x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # p_i times the horizontal part of the leg [m]
    gt2 = ht2_x*n2_x + ht2_y*n2_y
    # p_i times the vertical part of the leg [m]
    gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F2 = (gt2*gt2) + (gz2*gz2) - (p2*p2)*(q2*q2)
    x15 = 2.0*gt2
    x16 = 2.0*gz2
    x17 = 2.0*p2*q2
    # gradient of F_i in n_i (6) [m²]
    dF2_x = -hp2_x*x17 + ht2_x*x15 + hz2_x*x16
    dF2_y = -hp2_y*x17 + ht2_y*x15 + hz2_y*x16
    dF2_z = h2*x16
    # distance of C from the plane of the limb (4) [m]
    h3 = x6 + x8
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 - x10 + x9
    ht3_y = -SQRT3_2*(-x11 + x12) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x13
    hz3_y = -x14
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # p_i times the horizontal part of the leg [m]
    gt3 = ht3_x*n3_x + ht3_y*n3_y
    # p_i times the vertical part of the leg [m]
    gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y
    # closure equation of limb i, times p_i squared (6) [m²]
    F3 = (gt3*gt3) + (gz3*gz3) - (p3*p3)*(q3*q3)
    x18 = 2.0*gt3
    x19 = 2.0*gz3
    x20 = 2.0*p3*q3
    # gradient of F_i in n_i (6) [m²]
    dF3_x = -hp3_x*x20 + ht3_x*x18 + hz3_x*x19
    dF3_y = -hp3_y*x20 + ht3_y*x18 + hz3_y*x19
    dF3_z = h3*x19
    # derivative of F_i by a turn of the platform (6) [m²]
    G2_x = -dF2_y*n2_z + dF2_z*n2_y
    G2_y = dF2_x*n2_z - dF2_z*n2_x
    G2_z = -dF2_x*n2_y + dF2_y*n2_x
    # derivative of F_i by theta [m²]
    Ft2 = G2_x*by_angle_x + G2_y*by_angle_y + G2_z*by_angle_z
    # derivative of F_i by phi [m²]
    Fp2 = G2_x*n1_x + G2_y*n1_y + G2_z*n1_z
    # derivative of F_i by a turn of the platform (6) [m²]
    G3_x = -dF3_y*n3_z + dF3_z*n3_y
    G3_y = dF3_x*n3_z - dF3_z*n3_x
    G3_z = -dF3_x*n3_y + dF3_y*n3_x
    # derivative of F_i by theta [m²]
    Ft3 = G3_x*by_angle_x + G3_y*by_angle_y + G3_z*by_angle_z
    # derivative of F_i by phi [m²]
    Fp3 = G3_x*n1_x + G3_y*n1_y + G3_z*n1_z
    # determinant of the derivatives [m⁴]
    det_leg = -Fp2*Ft3 + Fp3*Ft2
    x21 = 1.0/det_leg
    # step of theta [rad]
    dtheta = x21*(-F2*Fp3 + F3*Fp2)
    # step of phi [rad]
    dphi = x21*(F2*Ft3 - F3*Ft2)
    # half of the step of theta [1]
    half_step = mpf(1)/2*dtheta
    x22 = (half_step*half_step)
    x23 = 1.0/(x22 + 1.0)
    x24 = 2.0*half_step
    x25 = 1.0 - x22
    # cosine and sine of theta after the step [1]
    next_leg_1 = x23*(cos_theta*x25 - sin_theta*x24)
    next_leg_2 = x23*(cos_theta*x24 + sin_theta*x25)
    # n_2 moved by both steps, in first order [1]
    next_guess_x = dphi*(n1_y*n2_z - n1_z*n2_y) + dtheta*(by_angle_y*n2_z - by_angle_z*n2_y) + n2_x
    next_guess_y = dphi*(-n1_x*n2_z + n1_z*n2_x) + dtheta*(-by_angle_x*n2_z + by_angle_z*n2_x) + n2_y
    next_guess_z = dphi*(n1_x*n2_y - n1_y*n2_x) + dtheta*(by_angle_x*n2_y - by_angle_y*n2_x) + n2_z
    # from C to B_1 after the step [m]
    next_arm_x = x0
    next_arm_y = -c_y + next_leg_1*q1
    next_arm_z = -c_z + next_leg_2*q1
    # distance from C to B_1 after the step [m]
    next_span = sqrt((next_arm_x*next_arm_x) + (next_arm_y*next_arm_y) + (next_arm_z*next_arm_z))
    x26 = 1.0/next_span
    # n_1 after the step (3) [1]
    next_n1_x = next_arm_x*x26
    next_n1_y = next_arm_y*x26
    next_n1_z = next_arm_z*x26
    x27 = -next_guess_x*next_n1_x - next_guess_y*next_n1_y - next_guess_z*next_n1_z
    # part of the moved n_2 normal to n_1 after the step [1]
    next_side_x = next_guess_x + next_n1_x*x27
    next_side_y = next_guess_y + next_n1_y*x27
    next_side_z = next_guess_z + next_n1_z*x27
    x28 = SQRT3_2/(sqrt((next_side_x*next_side_x) + (next_side_y*next_side_y) + (next_side_z*next_side_z)))
    # n_2 after the step (5) [1]
    next_n2_x = -mpf(1)/2*next_n1_x + next_side_x*x28
    next_n2_y = -mpf(1)/2*next_n1_y + next_side_y*x28
    next_n2_z = -mpf(1)/2*next_n1_z + next_side_z*x28
    return LegStep(
        [next_leg_1, next_leg_2],
        [[next_n1_x, next_n1_y, next_n1_z], [next_n2_x, next_n2_y, next_n2_z]],
        next_span,
        [dtheta, dphi],
    )


class Fold(NamedTuple):
    """What `fold` returns."""

    residual: Nested
    gradient: Nested
    volume: Nested
    volume_gradient: Nested
    by_joints: Nested


def fold(a: Nested, joints: Nested, directions: Nested) -> Fold:
    """What decides whether two assembly modes have merged.

    Equations (6) of the paper; base frame.
    468 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    joints : nested list (..., 6)
        q1 ... q6 [m, rad]
    directions : nested list (..., 2, 3)
        n_1 and n_2, a row each [1]

    Returns
    -------
    residual : nested list (..., 3)
        F_1, F_2, F_3 [m²]
    gradient : nested list (..., 3, 3)
        of F_i by a turn, a row each [m²]
    volume : nested list (...)
        determinant of the gradient [m⁶]
    volume_gradient : nested list (..., 3)
        of the volume by a turn [m⁶]
    by_joints : nested list (..., 3, 6)
        of F_i by the logarithm of q_j [m²]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    joints = _exact(joints)
    directions = _exact(directions)
    q1, q2, q3, q4, q5, q6 = joints
    (n1_x, n1_y, n1_z), (n2_x, n2_y, n2_z) = directions
    x0 = cos(q4)
    x1 = cos(q5)
    x2 = x0*x1
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = x2
    x3 = sin(q4)
    x4 = x1*x3
    lambda_y = x4
    x5 = sin(q5)
    lambda_z = x5
    # position of the platform's centre C (1) [m]
    c_x = lambda_x*q6
    c_y = lambda_y*q6
    c_z = lambda_z*q6
    # the third direction (5) [1]
    n3_x = -n1_x - n2_x
    n3_y = -n1_y - n2_y
    n3_z = -n1_z - n2_z
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    x6 = (q1*q1)
    x7 = x6*(n1_x*n1_x)
    # closure equation of limb i, times p_i squared (6) [m²]
    F1 = (gt1*gt1) + (gz1*gz1) - x7
    x8 = 2.0*gt1
    x9 = 2.0*gz1
    x10 = 2.0*x6
    # gradient of F_i in n_i (6) [m²]
    dF1_x = c_y*x8 + c_z*x9 - n1_x*x10
    dF1_y = h1*x8
    dF1_z = h1*x9
    x11 = SQRT3_2*c_y
    x12 = mpf(1)/2*c_x
    x13 = a + x12
    # distance of C from the plane of the limb (4) [m]
    h2 = -x11 + x13
    x14 = mpf(1)/4*c_y
    x15 = SQRT3_2*x12
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht2_x = -SQRT3_2*h2 + x14 + x15
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    ht2_y = SQRT3_2*(-x16 - x17) - mpf(1)/2*h2
    x18 = -mpf(1)/2*c_z
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz2_x = x18
    x19 = SQRT3_2*c_z
    hz2_y = x19
    # p_i times the length of the leg, as a form in n_i [m]
    hp2_x = -mpf(1)/2*q2
    hp2_y = SQRT3_2*q2
    x20 = mpf(1)/2*n2_x
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - x20
    # p_i times the horizontal part of the leg [m]
    gt2 = ht2_x*n2_x + ht2_y*n2_y
    # p_i times the vertical part of the leg [m]
    gz2 = h2*n2_z + hz2_x*n2_x + hz2_y*n2_y
    x21 = (p2*p2)*(q2*q2)
    # closure equation of limb i, times p_i squared (6) [m²]
    F2 = (gt2*gt2) + (gz2*gz2) - x21
    x22 = 2.0*gt2
    x23 = 2.0*gz2
    x24 = 2.0*p2*q2
    # gradient of F_i in n_i (6) [m²]
    dF2_x = -hp2_x*x24 + ht2_x*x22 + hz2_x*x23
    dF2_y = -hp2_y*x24 + ht2_y*x22 + hz2_y*x23
    dF2_z = h2*x23
    # distance of C from the plane of the limb (4) [m]
    h3 = x11 + x13
    # p_i times the horizontal part of the leg, as a form in n_i [m]
    ht3_x = SQRT3_2*h3 + x14 - x15
    ht3_y = -SQRT3_2*(-x16 + x17) - mpf(1)/2*h3
    # p_i times the vertical part of the leg, as a form in n_i [m]
    hz3_x = x18
    hz3_y = -x19
    # p_i times the length of the leg, as a form in n_i [m]
    hp3_x = -mpf(1)/2*q3
    hp3_y = -SQRT3_2*q3
    x25 = mpf(1)/2*n3_x
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - x25
    # p_i times the horizontal part of the leg [m]
    gt3 = ht3_x*n3_x + ht3_y*n3_y
    # p_i times the vertical part of the leg [m]
    gz3 = h3*n3_z + hz3_x*n3_x + hz3_y*n3_y
    x26 = (p3*p3)*(q3*q3)
    # closure equation of limb i, times p_i squared (6) [m²]
    F3 = (gt3*gt3) + (gz3*gz3) - x26
    x27 = 2.0*gt3
    x28 = 2.0*gz3
    x29 = 2.0*p3*q3
    # gradient of F_i in n_i (6) [m²]
    dF3_x = -hp3_x*x29 + ht3_x*x27 + hz3_x*x28
    dF3_y = -hp3_y*x29 + ht3_y*x27 + hz3_y*x28
    dF3_z = h3*x28
    # derivative of F_i by a turn of the platform (6) [m²]
    G1_x = -dF1_y*n1_z + dF1_z*n1_y
    G1_y = dF1_x*n1_z - dF1_z*n1_x
    G1_z = -dF1_x*n1_y + dF1_y*n1_x
    # derivative of F_i by a turn of the platform (6) [m²]
    G2_x = -dF2_y*n2_z + dF2_z*n2_y
    G2_y = dF2_x*n2_z - dF2_z*n2_x
    G2_z = -dF2_x*n2_y + dF2_y*n2_x
    # derivative of F_i by a turn of the platform (6) [m²]
    G3_x = -dF3_y*n3_z + dF3_z*n3_y
    G3_y = dF3_x*n3_z - dF3_z*n3_x
    G3_z = -dF3_x*n3_y + dF3_y*n3_x
    x30 = G2_y*G3_z - G2_z*G3_y
    x31 = -G2_x*G3_z + G2_z*G3_x
    x32 = G2_x*G3_y - G2_y*G3_x
    # triple product of the derivatives: zero where modes meet [m⁶]
    volume = G1_x*x30 + G1_y*x31 + G1_z*x32
    # cofactor of the derivative of F_i by a turn [m⁴]
    across1_x = x30
    across1_y = x31
    across1_z = x32
    # change of n_i by a turn [m⁴]
    slide1_x = across1_y*n1_z - across1_z*n1_y
    slide1_y = -across1_x*n1_z + across1_z*n1_x
    slide1_z = across1_x*n1_y - across1_y*n1_x
    x33 = 2.0*slide1_x
    x34 = 2.0*h1
    x35 = c_y*x33 + slide1_y*x34
    x36 = c_z*x33 + slide1_z*x34
    # change of the gradient of F_i with n_i [m⁶]
    bend1_x = c_y*x35 + c_z*x36 - slide1_x*x10
    bend1_y = h1*x35
    bend1_z = h1*x36
    # cofactor of the derivative of F_i by a turn [m⁴]
    across2_x = -G1_y*G3_z + G1_z*G3_y
    across2_y = G1_x*G3_z - G1_z*G3_x
    across2_z = -G1_x*G3_y + G1_y*G3_x
    # change of n_i by a turn [m⁴]
    slide2_x = across2_y*n2_z - across2_z*n2_y
    slide2_y = -across2_x*n2_z + across2_z*n2_x
    slide2_z = across2_x*n2_y - across2_y*n2_x
    x37 = 2.0*slide2_x
    x38 = 2.0*slide2_y
    x39 = -hp2_x*x37 - hp2_y*x38
    x40 = ht2_x*x37 + ht2_y*x38
    x41 = 2.0*h2*slide2_z + hz2_x*x37 + hz2_y*x38
    # change of the gradient of F_i with n_i [m⁶]
    bend2_x = hp2_x*x39 + ht2_x*x40 + hz2_x*x41
    bend2_y = hp2_y*x39 + ht2_y*x40 + hz2_y*x41
    bend2_z = h2*x41
    # cofactor of the derivative of F_i by a turn [m⁴]
    across3_x = G1_y*G2_z - G1_z*G2_y
    across3_y = -G1_x*G2_z + G1_z*G2_x
    across3_z = G1_x*G2_y - G1_y*G2_x
    # change of n_i by a turn [m⁴]
    slide3_x = across3_y*n3_z - across3_z*n3_y
    slide3_y = -across3_x*n3_z + across3_z*n3_x
    slide3_z = across3_x*n3_y - across3_y*n3_x
    x42 = 2.0*slide3_x
    x43 = 2.0*slide3_y
    x44 = -hp3_x*x42 - hp3_y*x43
    x45 = ht3_x*x42 + ht3_y*x43
    x46 = 2.0*h3*slide3_z + hz3_x*x42 + hz3_y*x43
    # change of the gradient of F_i with n_i [m⁶]
    bend3_x = hp3_x*x44 + ht3_x*x45 + hz3_x*x46
    bend3_y = hp3_y*x44 + ht3_y*x45 + hz3_y*x46
    bend3_z = h3*x46
    x47 = -across1_x*dF1_y + across1_y*dF1_x + bend1_z
    x48 = -across2_x*dF2_y + across2_y*dF2_x + bend2_z
    x49 = -across3_x*dF3_y + across3_y*dF3_x + bend3_z
    x50 = across1_x*dF1_z - across1_z*dF1_x + bend1_y
    x51 = across2_x*dF2_z - across2_z*dF2_x + bend2_y
    x52 = across3_x*dF3_z - across3_z*dF3_x + bend3_y
    # derivative of the triple product by a turn of the platform [m⁶]
    dvolume_x = n1_y*x47 - n1_z*x50 + n2_y*x48 - n2_z*x51 + n3_y*x49 - n3_z*x52
    x53 = -across1_y*dF1_z + across1_z*dF1_y + bend1_x
    x54 = -across2_y*dF2_z + across2_z*dF2_y + bend2_x
    x55 = -across3_y*dF3_z + across3_z*dF3_y + bend3_x
    dvolume_y = -n1_x*x47 + n1_z*x53 - n2_x*x48 + n2_z*x54 - n3_x*x49 + n3_z*x55
    dvolume_z = n1_x*x50 - n1_y*x53 + n2_x*x51 - n2_y*x54 + n3_x*x52 - n3_y*x55
    # derivative of lambda by q4 [1]
    dlambda4_x = -x4
    dlambda4_y = x2
    # derivative of lambda by q5 [1]
    dlambda5_x = -x0*x5
    dlambda5_y = -x3*x5
    dlambda5_z = x1
    # gradient of F_i by the position of C (6) [m]
    cF1_x = -n1_y*x8 - n1_z*x9
    cF1_y = n1_x*x8
    cF1_z = n1_x*x9
    x56 = gz2*n2_z
    # gradient of F_i by the position of C (6) [m]
    cF2_x = x22*(-SQRT3_2*p2 - SQRT3_2*x20 - mpf(1)/4*n2_y) + x56
    x57 = 2.0*SQRT3_2
    cF2_y = 2.0*gt2*(SQRT3_2*(SQRT3_2*n2_x + mpf(1)/2*n2_y) - mpf(1)/2*p2) - x56*x57
    cF2_z = p2*x23
    x58 = gz3*n3_z
    # gradient of F_i by the position of C (6) [m]
    cF3_x = x27*(SQRT3_2*p3 + SQRT3_2*x25 - mpf(1)/4*n3_y) + x58
    cF3_y = x27*(-SQRT3_2*(-SQRT3_2*n3_x + mpf(1)/2*n3_y) - mpf(1)/2*p3) + x57*x58
    cF3_z = p3*x28
    # derivatives of F by the logarithms of the joint values (6) [m²]
    qF_11 = -2.0*x7
    x59 = q4*q6
    qF_14 = x59*(cF1_x*dlambda4_x + cF1_y*dlambda4_y)
    x60 = q5*q6
    qF_15 = x60*(cF1_x*dlambda5_x + cF1_y*dlambda5_y + cF1_z*dlambda5_z)
    qF_16 = cF1_x*c_x + cF1_y*c_y + cF1_z*c_z
    qF_22 = -2.0*x21
    qF_24 = x59*(cF2_x*dlambda4_x + cF2_y*dlambda4_y)
    qF_25 = x60*(cF2_x*dlambda5_x + cF2_y*dlambda5_y + cF2_z*dlambda5_z)
    qF_26 = cF2_x*c_x + cF2_y*c_y + cF2_z*c_z
    qF_33 = -2.0*x26
    qF_34 = x59*(cF3_x*dlambda4_x + cF3_y*dlambda4_y)
    qF_35 = x60*(cF3_x*dlambda5_x + cF3_y*dlambda5_y + cF3_z*dlambda5_z)
    qF_36 = cF3_x*c_x + cF3_y*c_y + cF3_z*c_z
    return Fold(
        [F1, F2, F3],
        [[G1_x, G1_y, G1_z], [G2_x, G2_y, G2_z], [G3_x, G3_y, G3_z]],
        volume,
        [dvolume_x, dvolume_y, dvolume_z],
        [[qF_11, 0.0, 0.0, qF_14, qF_15, qF_16], [0.0, qF_22, 0.0, qF_24, qF_25, qF_26], [0.0, 0.0, qF_33, qF_34, qF_35, qF_36]],
    )


class RotationFromRpy(NamedTuple):
    """What `rotation_from_rpy` returns."""

    rotation: Nested


def rotation_from_rpy(roll: Nested, pitch: Nested, yaw: Nested) -> RotationFromRpy:
    """Rotation from roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll).

    Equations (9) of the paper; base frame.
    24 operations.

    Parameters
    ----------
    roll : nested list (...)
        about X, first [rad]
    pitch : nested list (...)
        about Y, second [rad]
    yaw : nested list (...)
        about Z, last [rad]

    Returns
    -------
    rotation : nested list (..., 3, 3)
        rotation of the platform [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    roll = _exact(roll)
    pitch = _exact(pitch)
    yaw = _exact(yaw)
    gamma = roll
    beta = pitch
    alpha = yaw
    x0 = cos(alpha)
    x1 = cos(beta)
    # rotation of the platform (9) [1]
    R_11 = x0*x1
    x2 = sin(alpha)
    x3 = cos(gamma)
    x4 = x2*x3
    x5 = sin(beta)
    x6 = sin(gamma)
    R_12 = x0*x5*x6 - x4
    x7 = x2*x6
    x8 = x0*x3
    R_13 = x5*x8 + x7
    R_21 = x1*x2
    R_22 = x5*x7 + x8
    R_23 = -x0*x6 + x4*x5
    R_31 = -x5
    R_32 = x1*x6
    R_33 = x1*x3
    return RotationFromRpy(
        [[R_11, R_12, R_13], [R_21, R_22, R_23], [R_31, R_32, R_33]],
    )


class RpyFromRotation(NamedTuple):
    """What `rpy_from_rotation` returns."""

    roll: Nested
    pitch: Nested
    yaw: Nested


def rpy_from_rotation(R: Nested) -> RpyFromRotation:
    """Roll, pitch and yaw from the rotation; yaw is zero where R_11 = R_21 = 0.

    Equations (9) of the paper; base frame.
    17 operations.

    Parameters
    ----------
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    roll : nested list (...)
        in [−π, π] [rad]
    pitch : nested list (...)
        in [−π/2, π/2] [rad]
    yaw : nested list (...)
        in [−π, π] [rad]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    R = _exact(R)
    (R_11, R_12, R_13), (R_21, R_22, R_23), (R_31, R_32, R_33) = R
    # yaw (9) [rad]
    alpha = atan2(R_21, R_11)
    # pitch (9) [rad]
    beta = atan2(-R_31, sqrt((R_11*R_11) + (R_21*R_21)))
    x0 = sin(alpha)
    x1 = cos(alpha)
    # roll (9) [rad]
    gamma = atan2(R_13*x0 - R_23*x1, -R_12*x0 + R_22*x1)
    return RpyFromRotation(
        gamma,
        beta,
        alpha,
    )


class RotationFromDirections(NamedTuple):
    """What `rotation_from_directions` returns."""

    rotation: Nested


def rotation_from_directions(n1: Nested, n2: Nested) -> RotationFromDirections:
    """Rotation from the platform directions n_1 and n_2.

    Equations (8) of the paper; base frame.
    40 operations.

    Parameters
    ----------
    n1 : nested list (..., 3)
        direction from C to B_1 [1]
    n2 : nested list (..., 3)
        direction from C to B_2 [1]

    Returns
    -------
    rotation : nested list (..., 3, 3)
        rotation of the platform [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    n1 = _exact(n1)
    n2 = _exact(n2)
    n1_x, n1_y, n1_z = n1
    n2_x, n2_y, n2_z = n2
    x0 = n1_y*n2_z - n1_z*n2_y
    x1 = n1_x*n2_y - n1_y*n2_x
    x2 = -n1_x*n2_z + n1_z*n2_x
    x3 = 1.0/(sqrt((x0*x0) + (x1*x1) + (x2*x2)))
    # normal of the platform (8) [1]
    nu_x = x0*x3
    nu_y = x2*x3
    nu_z = x1*x3
    x4 = -n1_y*x1 + n1_z*x2
    x5 = n1_x*x1 - n1_z*x0
    x6 = -n1_x*x2 + n1_y*x0
    x7 = 1.0/(sqrt((x4*x4) + (x5*x5) + (x6*x6)))
    # platform y axis (8) [1]
    m1_x = x4*x7
    m1_y = x5*x7
    m1_z = x6*x7
    return RotationFromDirections(
        [[n1_x, m1_x, nu_x], [n1_y, m1_y, nu_y], [n1_z, m1_z, nu_z]],
    )


class RotationDefect(NamedTuple):
    """What `rotation_defect` returns."""

    defect: Nested


def rotation_defect(R: Nested) -> RotationDefect:
    """How far a matrix is from a rotation; zero for a rotation.

    Equations (8) of the paper; base frame.
    42 operations.

    Parameters
    ----------
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    defect : nested list (...)
        root of the squared defects [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    R = _exact(R)
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    # n_1 × m_1 − ν, zero for a rotation [1]
    gap_x = -m1_y*n1_z + m1_z*n1_y - nu_x
    gap_y = m1_x*n1_z - m1_z*n1_x - nu_y
    gap_z = -m1_x*n1_y + m1_y*n1_x - nu_z
    # root of the squared defects of |n_1| = |m_1| = 1, n_1·m_1 = 0, n_1 × m_1 = ν [1]
    defect = sqrt((gap_x*gap_x) + (gap_y*gap_y) + (gap_z*gap_z) + ((m1_x*n1_x + m1_y*n1_y + m1_z*n1_z)*(m1_x*n1_x + m1_y*n1_y + m1_z*n1_z)) + (((m1_x*m1_x) + (m1_y*m1_y) + (m1_z*m1_z) - 1.0)*((m1_x*m1_x) + (m1_y*m1_y) + (m1_z*m1_z) - 1.0)) + (((n1_x*n1_x) + (n1_y*n1_y) + (n1_z*n1_z) - 1.0)*((n1_x*n1_x) + (n1_y*n1_y) + (n1_z*n1_z) - 1.0)))
    return RotationDefect(
        defect,
    )


class LimbGeometry(NamedTuple):
    """What `limb_geometry` returns."""

    d: Nested
    w: Nested
    lines: Nested


def limb_geometry(a: Nested, c: Nested, R: Nested) -> LimbGeometry:
    """Points D_i, unit vectors w_i and reciprocal lines S_i.

    Equations (7), (14) of the paper; base frame.
    264 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    d : nested list (..., 3, 3)
        D_i, a row each [m]
    w : nested list (..., 3, 3)
        w_i, a row each [1]
    lines : nested list (..., 3, 6)
        S_i, a row each [1, m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    x12 = 1.0/n1_x
    # signed distance from C to B_i (4) [m]
    e1 = h1*x12
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    # length of the outer limb (10) [m]
    q1 = l1/absolute(n1_x)
    x13 = x12/q1
    # unit vector along the outer limb Section IV [1]
    w1_y = gt1*x13
    w1_z = gz1*x13
    # p_i times the part of the leg along n_i [m]
    ng1 = gt1*n1_y + gz1*n1_z
    # signed distance from O to D_i (7) [m]
    delta1 = a + ng1/((n1_x*n1_x))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x16 = 1.0/p2
    # signed distance from C to B_i (4) [m]
    e2 = h2*x16
    x17 = -SQRT3_2*n2_x - mpf(1)/2*n2_y
    x18 = mpf(1)/2*c_y
    x19 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*x17 + p2*(-x18 - x19)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # length of the outer limb (10) [m]
    q2 = l2/absolute(p2)
    x20 = x16/q2
    x21 = gt2*x20
    # unit vector along the outer limb Section IV [1]
    w2_x = -SQRT3_2*x21
    w2_y = -mpf(1)/2*x21
    w2_z = gz2*x20
    # p_i times the part of the leg along n_i [m]
    ng2 = gt2*x17 + gz2*n2_z
    # signed distance from O to D_i (7) [m]
    delta2 = a + ng2/((p2*p2))
    # position of D_i (7) [m]
    d2_x = -mpf(1)/2*delta2
    d2_y = SQRT3_2*delta2
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x22 = 1.0/p3
    # signed distance from C to B_i (4) [m]
    e3 = h3*x22
    x23 = SQRT3_2*n3_x - mpf(1)/2*n3_y
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*x23 + p3*(-x18 + x19)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # length of the outer limb (10) [m]
    q3 = l3/absolute(p3)
    x24 = x22/q3
    x25 = gt3*x24
    # unit vector along the outer limb Section IV [1]
    w3_x = SQRT3_2*x25
    w3_y = -mpf(1)/2*x25
    w3_z = gz3*x24
    # p_i times the part of the leg along n_i [m]
    ng3 = gt3*x23 + gz3*n3_z
    # signed distance from O to D_i (7) [m]
    delta3 = a + ng3/((p3*p3))
    # position of D_i (7) [m]
    d3_x = -mpf(1)/2*delta3
    d3_y = -SQRT3_2*delta3
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x26 = 1.0/rho1
    # unit vector from B_i to D_i (14) [1]
    s1_x = x26*(m1_x*tau1 + nu_x*sigma1)
    s1_y = x26*(m1_y*tau1 + nu_y*sigma1)
    s1_z = x26*(m1_z*tau1 + nu_z*sigma1)
    x27 = e1*x26
    # moment of S_i about C (14) [m]
    so1_x = x27*(-m1_x*sigma1 + nu_x*tau1)
    so1_y = x27*(-m1_y*sigma1 + nu_y*tau1)
    so1_z = x27*(-m1_z*sigma1 + nu_z*tau1)
    x28 = mpf(1)/2*nu_y
    x29 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x28 - x29)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x30 = 1.0/rho2
    # unit vector from B_i to D_i (14) [1]
    s2_x = x30*(m2_x*tau2 + nu_x*sigma2)
    s2_y = x30*(m2_y*tau2 + nu_y*sigma2)
    s2_z = x30*(m2_z*tau2 + nu_z*sigma2)
    x31 = e2*x30
    # moment of S_i about C (14) [m]
    so2_x = x31*(-m2_x*sigma2 + nu_x*tau2)
    so2_y = x31*(-m2_y*sigma2 + nu_y*tau2)
    so2_z = x31*(-m2_z*sigma2 + nu_z*tau2)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x28 + x29)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x32 = 1.0/rho3
    # unit vector from B_i to D_i (14) [1]
    s3_x = x32*(m3_x*tau3 + nu_x*sigma3)
    s3_y = x32*(m3_y*tau3 + nu_y*sigma3)
    s3_z = x32*(m3_z*tau3 + nu_z*sigma3)
    x33 = e3*x32
    # moment of S_i about C (14) [m]
    so3_x = x33*(-m3_x*sigma3 + nu_x*tau3)
    so3_y = x33*(-m3_y*sigma3 + nu_y*tau3)
    so3_z = x33*(-m3_z*sigma3 + nu_z*tau3)
    return LimbGeometry(
        [[delta1, 0.0, 0.0], [d2_x, d2_y, 0.0], [d3_x, d3_y, 0.0]],
        [[0.0, w1_y, w1_z], [w2_x, w2_y, w2_z], [w3_x, w3_y, w3_z]],
        [[s1_x, s1_y, s1_z, so1_x, so1_y, so1_z], [s2_x, s2_y, s2_z, so2_x, so2_y, so2_z], [s3_x, s3_y, s3_z, so3_x, so3_y, so3_z]],
    )


class Screws(NamedTuple):
    """What `screws` returns."""

    limb1: Nested
    limb2: Nested
    limb3: Nested
    limb4: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def screws(a: Nested, c: Nested, R: Nested, heading: Nested) -> Screws:
    """The joint screws of the four limbs at pole C, a row a joint.

    Equations Section IV of the paper; base frame.
    262 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    limb1 : nested list (..., 6, 6)
        screws of limb 1 [1, m]
    limb2 : nested list (..., 6, 6)
        screws of limb 2 [1, m]
    limb3 : nested list (..., 6, 6)
        screws of limb 3 [1, m]
    limb4 : nested list (..., 6, 6)
        screws of limb 4 [1, m]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    x6 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x6)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x6)
    x7 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x7
    lambda_y = c_y*x7
    lambda_z = c_z*x7
    x8 = -c_x
    x9 = a + x8
    # distance of C from the plane of the limb (4) [m]
    h1 = x9
    x10 = 1.0/n1_x
    # signed distance from C to B_i (4) [m]
    e1 = h1*x10
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    # length of the outer limb (10) [m]
    q1 = l1/absolute(n1_x)
    x11 = 1.0/q1
    x12 = gt1*x11
    # unit vector along the outer limb Section IV [1]
    w1_y = x10*x12
    x13 = gz1*x11
    w1_z = x10*x13
    x14 = -mpf(1)/2*a
    # position of A_2 Section II [m]
    a2_x = x14
    x15 = SQRT3_2*a
    a2_y = x15
    x16 = SQRT3_2*c_y
    x17 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x16 + x17
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x18 = 1.0/p2
    # signed distance from C to B_i (4) [m]
    e2 = h2*x18
    x19 = -SQRT3_2*n2_x - mpf(1)/2*n2_y
    x20 = mpf(1)/2*c_y
    x21 = SQRT3_2*c_x
    x22 = -x20 - x21
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*x19 + p2*x22
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # length of the outer limb (10) [m]
    q2 = l2/absolute(p2)
    x23 = 1.0/q2
    x24 = gt2*x23
    x25 = x18*x24
    # unit vector along the outer limb Section IV [1]
    w2_x = -SQRT3_2*x25
    w2_y = -mpf(1)/2*x25
    w2_z = gz2*x18*x23
    # position of A_3 Section II [m]
    a3_x = x14
    a3_y = -x15
    # distance of C from the plane of the limb (4) [m]
    h3 = x16 + x17
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x26 = 1.0/p3
    # signed distance from C to B_i (4) [m]
    e3 = h3*x26
    x27 = SQRT3_2*n3_x - mpf(1)/2*n3_y
    x28 = -x20
    x29 = x21 + x28
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*x27 + p3*x29
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # length of the outer limb (10) [m]
    q3 = l3/absolute(p3)
    x30 = 1.0/q3
    x31 = gt3*x30
    x32 = x26*x31
    # unit vector along the outer limb Section IV [1]
    w3_x = SQRT3_2*x32
    w3_y = -mpf(1)/2*x32
    w3_z = gz3*x26*x30
    x33 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x33
    axis_y = -heading_1*x33
    x34 = -c_y
    # lower revolute, actuated by q4 Section IV [1, m]
    screw41_ox = x34
    # second revolute, actuated by q5 Section IV [1, m]
    screw42_ox = axis_y*c_z
    screw42_oy = -axis_x*c_z
    screw42_oz = axis_x*c_y - axis_y*c_x
    # universal joint, second axis Section IV [1, m]
    screw46_x = x1
    screw46_y = x3
    screw46_z = x5
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw1_x = x11*(-c_y*n1_z + c_z*n1_y)
    nw1_y = -x13
    nw1_z = x12
    # base revolute Section IV [1, m]
    screw11_oy = -c_z
    # revolute along the leg Section IV [1, m]
    screw13_ox = -c_y*w1_z + c_z*w1_y
    x35 = -x9
    screw13_oy = w1_z*x35
    screw13_oz = -w1_y*x35
    # upper revolute Section IV [1, m]
    screw14_ox = e1*(n1_y*nw1_z - n1_z*nw1_y)
    screw14_oy = e1*(-n1_x*nw1_z + n1_z*nw1_x)
    screw14_oz = e1*(n1_x*nw1_y - n1_y*nw1_x)
    x36 = c_z*x19
    x37 = n2_z*x22
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw2_x = x23*(SQRT3_2*gz2 - mpf(1)/2*x36 + mpf(1)/2*x37)
    nw2_y = x23*(SQRT3_2*(x36 - x37) + mpf(1)/2*gz2)
    nw2_z = x24
    x38 = SQRT3_2*c_z
    # base revolute Section IV [1, m]
    screw21_ox = x38
    x39 = mpf(1)/2*c_z
    screw21_oy = x39
    x40 = -a2_x - x8
    screw21_oz = -SQRT3_2*x40 + mpf(1)/2*a2_y - x20
    x41 = -a2_y - x34
    # revolute along the leg Section IV [1, m]
    screw23_ox = c_z*w2_y - w2_z*x41
    screw23_oy = -c_z*w2_x + w2_z*x40
    screw23_oz = w2_x*x41 - w2_y*x40
    # upper revolute Section IV [1, m]
    screw24_ox = e2*(n2_y*nw2_z - n2_z*nw2_y)
    screw24_oy = e2*(-n2_x*nw2_z + n2_z*nw2_x)
    screw24_oz = e2*(n2_x*nw2_y - n2_y*nw2_x)
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw3_x = x30*(-SQRT3_2*gz3 + mpf(1)/2*n3_z*x29 - x27*x39)
    nw3_y = x30*(-SQRT3_2*(c_z*x27 - n3_z*x29) + mpf(1)/2*gz3)
    nw3_z = x31
    # base revolute Section IV [1, m]
    screw31_ox = -x38
    screw31_oy = x39
    x42 = -a3_x - x8
    screw31_oz = SQRT3_2*x42 + mpf(1)/2*a3_y + x28
    x43 = -a3_y - x34
    # revolute along the leg Section IV [1, m]
    screw33_ox = c_z*w3_y - w3_z*x43
    screw33_oy = -c_z*w3_x + w3_z*x42
    screw33_oz = w3_x*x43 - w3_y*x42
    # upper revolute Section IV [1, m]
    screw34_ox = e3*(n3_y*nw3_z - n3_z*nw3_y)
    screw34_oy = e3*(-n3_x*nw3_z + n3_z*nw3_x)
    screw34_oz = e3*(n3_x*nw3_y - n3_y*nw3_x)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    return Screws(
        [[1.0, 0.0, 0.0, 0.0, screw11_oy, c_y], [0.0, 0.0, 0.0, 0.0, w1_y, w1_z], [0.0, w1_y, w1_z, screw13_ox, screw13_oy, screw13_oz], [nw1_x, nw1_y, nw1_z, screw14_ox, screw14_oy, screw14_oz], [n1_x, n1_y, n1_z, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, n1_x, n1_y, n1_z]],
        [[mpf(-1)/2, SQRT3_2, 0.0, screw21_ox, screw21_oy, screw21_oz], [0.0, 0.0, 0.0, w2_x, w2_y, w2_z], [w2_x, w2_y, w2_z, screw23_ox, screw23_oy, screw23_oz], [nw2_x, nw2_y, nw2_z, screw24_ox, screw24_oy, screw24_oz], [n2_x, n2_y, n2_z, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, n2_x, n2_y, n2_z]],
        [[mpf(-1)/2, -SQRT3_2, 0.0, screw31_ox, screw31_oy, screw31_oz], [0.0, 0.0, 0.0, w3_x, w3_y, w3_z], [w3_x, w3_y, w3_z, screw33_ox, screw33_oy, screw33_oz], [nw3_x, nw3_y, nw3_z, screw34_ox, screw34_oy, screw34_oz], [n3_x, n3_y, n3_z, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, n3_x, n3_y, n3_z]],
        [[0.0, 0.0, 1.0, screw41_ox, c_x, 0.0], [axis_x, axis_y, 0.0, screw42_ox, screw42_oy, screw42_oz], [0.0, 0.0, 0.0, lambda_x, lambda_y, lambda_z], [lambda_x, lambda_y, lambda_z, 0.0, 0.0, 0.0], [n1_x, n1_y, n1_z, 0.0, 0.0, 0.0], [screw46_x, screw46_y, screw46_z, 0.0, 0.0, 0.0]],
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class Jacobians(NamedTuple):
    """What `jacobians` returns."""

    J_v: Nested
    J_q: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def jacobians(a: Nested, c: Nested, R: Nested, heading: Nested) -> Jacobians:
    """Forward and inverse Jacobian, J_vᵀ Δ V = J_q q̇.

    Equations (17)-(19), (22)-(24) of the paper; base frame.
    283 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    J_v : nested list (..., 6, 6)
        forward Jacobian [1, m]
    J_q : nested list (..., 6, 6)
        inverse Jacobian [1, m]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x16 - x17)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x16 + x17)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x18
    axis_y = -heading_1*x18
    # lower revolute, actuated by q4 Section IV [1, m]
    screw41_ox = -c_y
    # second revolute, actuated by q5 Section IV [1, m]
    screw42_ox = axis_y*c_z
    screw42_oy = -axis_x*c_z
    screw42_oz = axis_x*c_y - axis_y*c_x
    # universal joint, second axis Section IV [1, m]
    screw46_x = x1
    screw46_y = x3
    screw46_z = x5
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x19 = 1.0/rho1
    # unit vector from B_i to D_i (14) [1]
    s1_x = x19*(m1_x*tau1 + nu_x*sigma1)
    s1_y = x19*(m1_y*tau1 + nu_y*sigma1)
    s1_z = x19*(m1_z*tau1 + nu_z*sigma1)
    x20 = e1*x19
    # moment of S_i about C (14) [m]
    so1_x = x20*(-m1_x*sigma1 + nu_x*tau1)
    so1_y = x20*(-m1_y*sigma1 + nu_y*tau1)
    so1_z = x20*(-m1_z*sigma1 + nu_z*tau1)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -l1*x19*absolute(n1_x)
    x21 = mpf(1)/2*nu_y
    x22 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x21 - x22)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x23 = 1.0/rho2
    # unit vector from B_i to D_i (14) [1]
    s2_x = x23*(m2_x*tau2 + nu_x*sigma2)
    s2_y = x23*(m2_y*tau2 + nu_y*sigma2)
    s2_z = x23*(m2_z*tau2 + nu_z*sigma2)
    x24 = e2*x23
    # moment of S_i about C (14) [m]
    so2_x = x24*(-m2_x*sigma2 + nu_x*tau2)
    so2_y = x24*(-m2_y*sigma2 + nu_y*tau2)
    so2_z = x24*(-m2_z*sigma2 + nu_z*tau2)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -l2*x23*absolute(p2)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x21 + x22)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x25 = 1.0/rho3
    # unit vector from B_i to D_i (14) [1]
    s3_x = x25*(m3_x*tau3 + nu_x*sigma3)
    s3_y = x25*(m3_y*tau3 + nu_y*sigma3)
    s3_z = x25*(m3_z*tau3 + nu_z*sigma3)
    x26 = e3*x25
    # moment of S_i about C (14) [m]
    so3_x = x26*(-m3_x*sigma3 + nu_x*tau3)
    so3_y = x26*(-m3_y*sigma3 + nu_y*tau3)
    so3_z = x26*(-m3_z*sigma3 + nu_z*tau3)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -l3*x25*absolute(p3)
    # inverse Jacobian matrix (19), (22)-(24) [1, m]
    J_q_54 = c_x*n1_y + n1_x*screw41_ox
    J_q_55 = n1_x*screw42_ox + n1_y*screw42_oy + n1_z*screw42_oz
    J_q_56 = lambda_x*n1_x + lambda_y*n1_y + lambda_z*n1_z
    J_q_64 = c_x*screw46_y + screw41_ox*screw46_x
    J_q_65 = screw42_ox*screw46_x + screw42_oy*screw46_y + screw42_oz*screw46_z
    J_q_66 = lambda_x*screw46_x + lambda_y*screw46_y + lambda_z*screw46_z
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    return Jacobians(
        [[s1_x, s2_x, s3_x, lambda_x, n1_x, screw46_x], [s1_y, s2_y, s3_y, lambda_y, n1_y, screw46_y], [s1_z, s2_z, s3_z, lambda_z, n1_z, screw46_z], [so1_x, so2_x, so3_x, 0.0, 0.0, 0.0], [so1_y, so2_y, so3_y, 0.0, 0.0, 0.0], [so1_z, so2_z, so3_z, 0.0, 0.0, 0.0]],
        [[limb1, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, limb2, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, limb3, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, J_q_54, J_q_55, J_q_56], [0.0, 0.0, 0.0, J_q_64, J_q_65, J_q_66]],
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class JointsAndJacobians(NamedTuple):
    """What `joints_and_jacobians` returns."""

    joints: Nested
    J_v: Nested
    J_q: Nested


def joints_and_jacobians(a: Nested, c: Nested, R: Nested, heading: Nested) -> JointsAndJacobians:
    """Joint values and both Jacobians in one pass, J_vᵀ Δ V = J_q q̇.

    Equations (10), (11), (17)-(19), (22)-(24) of the paper; base frame.
    286 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]

    Returns
    -------
    joints : nested list (..., 6)
        q1 ... q6 [m, rad]
    J_v : nested list (..., 6, 6)
        forward Jacobian [1, m]
    J_q : nested list (..., 6, 6)
        inverse Jacobian [1, m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    # elevation of the central limb (11) [rad]
    q5 = atan2(c_z, r)
    # azimuth of the central limb, measured from the X axis (11) [rad]
    q4 = atan2(c_y, c_x)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = absolute(n1_x)
    # length of the outer limb (10) [m]
    q1 = l1/x14
    x15 = SQRT3_2*c_y
    x16 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x15 + x16
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x17 = mpf(1)/2*c_y
    x18 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x17 - x18)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    x19 = absolute(p2)
    # length of the outer limb (10) [m]
    q2 = l2/x19
    # distance of C from the plane of the limb (4) [m]
    h3 = x15 + x16
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x17 + x18)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x20 = absolute(p3)
    # length of the outer limb (10) [m]
    q3 = l3/x20
    x21 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x21
    axis_y = -heading_1*x21
    # lower revolute, actuated by q4 Section IV [1, m]
    screw41_ox = -c_y
    # second revolute, actuated by q5 Section IV [1, m]
    screw42_ox = axis_y*c_z
    screw42_oy = -axis_x*c_z
    screw42_oz = axis_x*c_y - axis_y*c_x
    # universal joint, second axis Section IV [1, m]
    screw46_x = x1
    screw46_y = x3
    screw46_z = x5
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x22 = 1.0/rho1
    # unit vector from B_i to D_i (14) [1]
    s1_x = x22*(m1_x*tau1 + nu_x*sigma1)
    s1_y = x22*(m1_y*tau1 + nu_y*sigma1)
    s1_z = x22*(m1_z*tau1 + nu_z*sigma1)
    x23 = e1*x22
    # moment of S_i about C (14) [m]
    so1_x = x23*(-m1_x*sigma1 + nu_x*tau1)
    so1_y = x23*(-m1_y*sigma1 + nu_y*tau1)
    so1_z = x23*(-m1_z*sigma1 + nu_z*tau1)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -l1*x14*x22
    x24 = mpf(1)/2*nu_y
    x25 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x24 - x25)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x26 = 1.0/rho2
    # unit vector from B_i to D_i (14) [1]
    s2_x = x26*(m2_x*tau2 + nu_x*sigma2)
    s2_y = x26*(m2_y*tau2 + nu_y*sigma2)
    s2_z = x26*(m2_z*tau2 + nu_z*sigma2)
    x27 = e2*x26
    # moment of S_i about C (14) [m]
    so2_x = x27*(-m2_x*sigma2 + nu_x*tau2)
    so2_y = x27*(-m2_y*sigma2 + nu_y*tau2)
    so2_z = x27*(-m2_z*sigma2 + nu_z*tau2)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -l2*x19*x26
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x24 + x25)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x28 = 1.0/rho3
    # unit vector from B_i to D_i (14) [1]
    s3_x = x28*(m3_x*tau3 + nu_x*sigma3)
    s3_y = x28*(m3_y*tau3 + nu_y*sigma3)
    s3_z = x28*(m3_z*tau3 + nu_z*sigma3)
    x29 = e3*x28
    # moment of S_i about C (14) [m]
    so3_x = x29*(-m3_x*sigma3 + nu_x*tau3)
    so3_y = x29*(-m3_y*sigma3 + nu_y*tau3)
    so3_z = x29*(-m3_z*sigma3 + nu_z*tau3)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -l3*x20*x28
    # inverse Jacobian matrix (19), (22)-(24) [1, m]
    J_q_54 = c_x*n1_y + n1_x*screw41_ox
    J_q_55 = n1_x*screw42_ox + n1_y*screw42_oy + n1_z*screw42_oz
    J_q_56 = lambda_x*n1_x + lambda_y*n1_y + lambda_z*n1_z
    J_q_64 = c_x*screw46_y + screw41_ox*screw46_x
    J_q_65 = screw42_ox*screw46_x + screw42_oy*screw46_y + screw42_oz*screw46_z
    J_q_66 = lambda_x*screw46_x + lambda_y*screw46_y + lambda_z*screw46_z
    return JointsAndJacobians(
        [q1, q2, q3, q4, q5, q6],
        [[s1_x, s2_x, s3_x, lambda_x, n1_x, screw46_x], [s1_y, s2_y, s3_y, lambda_y, n1_y, screw46_y], [s1_z, s2_z, s3_z, lambda_z, n1_z, screw46_z], [so1_x, so2_x, so3_x, 0.0, 0.0, 0.0], [so1_y, so2_y, so3_y, 0.0, 0.0, 0.0], [so1_z, so2_z, so3_z, 0.0, 0.0, 0.0]],
        [[limb1, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, limb2, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, limb3, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, J_q_54, J_q_55, J_q_56], [0.0, 0.0, 0.0, J_q_64, J_q_65, J_q_66]],
    )


class InverseVelocity(NamedTuple):
    """What `inverse_velocity` returns."""

    rates: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def inverse_velocity(a: Nested, c: Nested, R: Nested, twist: Nested) -> InverseVelocity:
    """Joint rates from the twist.

    Equations (15), (16) of the paper; base frame.
    260 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    twist : nested list (..., 2, 3)
        [omega, v_C] [rad/s, m/s]

    Returns
    -------
    rates : nested list (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    twist = _exact(twist)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    (omega_x, omega_y, omega_z), (v_x, v_y, v_z) = twist
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x16 - x17)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x16 + x17)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    x18 = mpf(1)/2*nu_y
    x19 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x18 - x19)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x18 + x19)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    # rate of the outer limb 1 (15) [m/s]
    dq1 = (-h1*(omega_x*(-m1_x*sigma1 + nu_x*tau1) + omega_y*(-m1_y*sigma1 + nu_y*tau1) + omega_z*(-m1_z*sigma1 + nu_z*tau1)) - n1_x*(v_x*(m1_x*tau1 + nu_x*sigma1) + v_y*(m1_y*tau1 + nu_y*sigma1) + v_z*(m1_z*tau1 + nu_z*sigma1)))/(l1*n1_x*absolute(n1_x))
    # rate of the outer limb 2 (15) [m/s]
    dq2 = (-h2*(omega_x*(-m2_x*sigma2 + nu_x*tau2) + omega_y*(-m2_y*sigma2 + nu_y*tau2) + omega_z*(-m2_z*sigma2 + nu_z*tau2)) - p2*(v_x*(m2_x*tau2 + nu_x*sigma2) + v_y*(m2_y*tau2 + nu_y*sigma2) + v_z*(m2_z*tau2 + nu_z*sigma2)))/(l2*p2*absolute(p2))
    # rate of the outer limb 3 (15) [m/s]
    dq3 = (-h3*(omega_x*(-m3_x*sigma3 + nu_x*tau3) + omega_y*(-m3_y*sigma3 + nu_y*tau3) + omega_z*(-m3_z*sigma3 + nu_z*tau3)) - p3*(v_x*(m3_x*tau3 + nu_x*sigma3) + v_y*(m3_y*tau3 + nu_y*sigma3) + v_z*(m3_z*tau3 + nu_z*sigma3)))/(l3*p3*absolute(p3))
    # rate of the azimuth (16) [rad/s]
    dq4 = (c_x*v_y - c_y*v_x)/((r*r))
    # rate of the elevation (16) [rad/s]
    dq5 = (-c_z*(c_x*v_x + c_y*v_y)/r + r*v_z)/((q6*q6))
    # rate of the central limb's length (16) [m/s]
    dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z
    return InverseVelocity(
        [dq1, dq2, dq3, dq4, dq5, dq6],
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class ForwardVelocity(NamedTuple):
    """What `forward_velocity` returns."""

    twist: Nested
    determinant: Nested
    extension: Nested
    extension_scale: Nested
    orientation: Nested
    orientation_scale: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def forward_velocity(a: Nested, c: Nested, R: Nested, heading: Nested, rates: Nested) -> ForwardVelocity:
    """Twist from the joint rates, and the determinant of its 3×3 with its factors.

    Equations (12), (17) of the paper; base frame.
    369 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    rates : nested list (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]

    Returns
    -------
    twist : nested list (..., 6)
        [omega, v_C] [rad/s, m/s]
    determinant : nested list (...)
        det of the moments of S_i [m³]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : nested list (..., 3)
        scales of the e_i [m]
    orientation : nested list (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : nested list (...)
        scale of orientation [m³]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    rates = _exact(rates)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    dq1, dq2, dq3, dq4, dq5, dq6 = rates
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x16 - x17)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x16 + x17)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x18
    axis_y = -heading_1*x18
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x19 = mpf(1)/2*nu_y
    x20 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x19 - x20)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x19 + x20)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x21 = sigma2*sigma3
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = x21
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    x22 = sigma1*sigma3
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = x22
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    x23 = sigma1*sigma2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = x23
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    x24 = SQRT3_2*tilt
    x25 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)))
    # orientation: the moments of B_iD_i about C are coplanar (27) [m³]
    orientation = x24*x25
    # determinant of the moments of S_1, S_2, S_3 (27) [m³]
    det_moments = e1*e2*e3*x24/(rho1*rho2*rho3)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x26 = a + q6
    x27 = absolute(n1_x)
    # scale of e1 [m]
    e_scale1 = x26/x27
    x28 = absolute(p2)
    # scale of e2 [m]
    e_scale2 = x26/x28
    x29 = absolute(p3)
    # scale of e3 [m]
    e_scale3 = x26/x29
    x30 = absolute(sigma1)
    x31 = absolute(sigma2)
    x32 = absolute(sigma3)
    x33 = absolute(tau2)
    x34 = absolute(tau3)
    x35 = absolute(tau1)
    # scale of the orientation factor [m³]
    orientation_scale = SQRT3_2*reach*x25*(x30*x31 + x30*x32 + x30*x33 + x30*x34 + x31*x32 + x31*x34 + x31*x35 + x32*x33 + x32*x35)
    x36 = c_z*dq5
    # velocity of C (12), (16) [m/s]
    v_x = axis_y*x36 - c_y*dq4 + dq6*lambda_x
    v_y = -axis_x*x36 + c_x*dq4 + dq6*lambda_y
    v_z = dq5*(axis_x*c_y - axis_y*c_x) + dq6*lambda_z
    # what limb 1 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive1 = n1_x*(-dq1*l1*x27 - v_x*(m1_x*tau1 + nu_x*sigma1) - v_y*(m1_y*tau1 + nu_y*sigma1) - v_z*(m1_z*tau1 + nu_z*sigma1))/h1
    # what limb 2 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive2 = p2*(-dq2*l2*x28 - v_x*(m2_x*tau2 + nu_x*sigma2) - v_y*(m2_y*tau2 + nu_y*sigma2) - v_z*(m2_z*tau2 + nu_z*sigma2))/h2
    # what limb 3 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive3 = p3*(-dq3*l3*x29 - v_x*(m3_x*tau3 + nu_x*sigma3) - v_y*(m3_y*tau3 + nu_y*sigma3) - v_z*(m3_z*tau3 + nu_z*sigma3))/h3
    x37 = n3_x*sigma3
    x38 = n2_x*sigma2
    x39 = n1_x*sigma1
    x40 = mpf(4)/3*SQRT3_2/tilt
    # angular velocity (17) [rad/s]
    omega_x = x40*(drive1*(tau2*x37 - tau3*x38 + x20*x21) + drive2*(-tau1*x37 + tau3*x39 + x20*x22) + drive3*(tau1*x38 - tau2*x39 + x20*x23))
    x41 = n3_y*sigma3
    x42 = n2_y*sigma2
    x43 = SQRT3_2*nu_y
    x44 = n1_y*sigma1
    omega_y = x40*(drive1*(tau2*x41 - tau3*x42 + x21*x43) + drive2*(-tau1*x41 + tau3*x44 + x22*x43) + drive3*(tau1*x42 - tau2*x44 + x23*x43))
    x45 = n3_z*sigma3
    x46 = n2_z*sigma2
    x47 = SQRT3_2*nu_z
    x48 = n1_z*sigma1
    omega_z = x40*(drive1*(tau2*x45 - tau3*x46 + x21*x47) + drive2*(-tau1*x45 + tau3*x48 + x22*x47) + drive3*(tau1*x46 - tau2*x48 + x23*x47))
    return ForwardVelocity(
        [omega_x, omega_y, omega_z, v_x, v_y, v_z],
        det_moments,
        [e1, e2, e3],
        [e_scale1, e_scale2, e_scale3],
        orientation,
        orientation_scale,
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class JointRates(NamedTuple):
    """What `joint_rates` returns."""

    rates: Nested
    wrist: Nested
    wrist_scale: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def joint_rates(a: Nested, c: Nested, R: Nested, heading: Nested, twist: Nested) -> JointRates:
    """The rates of all joints of the four limbs from the twist.

    Equations (12) of the paper; base frame.
    628 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    twist : nested list (..., 2, 3)
        [omega, v_C] [rad/s, m/s]

    Returns
    -------
    rates : nested list (..., 4, 6)
        a row a limb [rad/s, m/s]
    wrist : nested list (...)
        (n_1 × n_2)·lambda [1]
    wrist_scale : nested list (...)
        scale of wrist [1]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    twist = _exact(twist)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    (omega_x, omega_y, omega_z), (v_x, v_y, v_z) = twist
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    x14 = -c_x
    x15 = a + x14
    # distance of C from the plane of the limb (4) [m]
    h1 = x15
    x16 = 1.0/n1_x
    # signed distance from C to B_i (4) [m]
    e1 = h1*x16
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x17 = 1.0/absolute(n1_x)
    # length of the outer limb (10) [m]
    q1 = l1*x17
    x18 = 1.0/q1
    x19 = gt1*x18
    # unit vector along the outer limb Section IV [1]
    w1_y = x16*x19
    x20 = gz1*x18
    w1_z = x16*x20
    x21 = -mpf(1)/2*a
    # position of A_2 Section II [m]
    a2_x = x21
    x22 = SQRT3_2*a
    a2_y = x22
    x23 = SQRT3_2*c_y
    x24 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x23 + x24
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x25 = 1.0/p2
    # signed distance from C to B_i (4) [m]
    e2 = h2*x25
    x26 = mpf(1)/2*n2_y
    x27 = -SQRT3_2*n2_x - x26
    x28 = mpf(1)/2*c_y
    x29 = SQRT3_2*c_x
    x30 = -x28 - x29
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*x27 + p2*x30
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    x31 = 1.0/absolute(p2)
    # length of the outer limb (10) [m]
    q2 = l2*x31
    x32 = 1.0/q2
    x33 = gt2*x32
    x34 = x25*x33
    # unit vector along the outer limb Section IV [1]
    w2_x = -SQRT3_2*x34
    w2_y = -mpf(1)/2*x34
    x35 = x25*x32
    w2_z = gz2*x35
    # position of A_3 Section II [m]
    a3_x = x21
    a3_y = -x22
    # distance of C from the plane of the limb (4) [m]
    h3 = x23 + x24
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x36 = 1.0/p3
    # signed distance from C to B_i (4) [m]
    e3 = h3*x36
    x37 = SQRT3_2*n3_x - mpf(1)/2*n3_y
    x38 = -x28 + x29
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*x37 + p3*x38
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x39 = 1.0/absolute(p3)
    # length of the outer limb (10) [m]
    q3 = l3*x39
    x40 = 1.0/q3
    x41 = gt3*x40
    x42 = x36*x41
    # unit vector along the outer limb Section IV [1]
    w3_x = SQRT3_2*x42
    w3_y = -mpf(1)/2*x42
    x43 = x36*x40
    w3_z = gz3*x43
    x44 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x44
    axis_y = -heading_1*x44
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw1_x = x18*(-c_y*n1_z + c_z*n1_y)
    nw1_y = -x20
    nw1_z = x19
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    x45 = c_z*x27
    x46 = n2_z*x30
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw2_x = x32*(SQRT3_2*gz2 - mpf(1)/2*x45 + mpf(1)/2*x46)
    nw2_y = x32*(SQRT3_2*(x45 - x46) + mpf(1)/2*gz2)
    nw2_z = x33
    x47 = mpf(1)/2*nu_y
    x48 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x47 - x48)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    x49 = c_z*x37
    # axis of the upper revolute, not a unit vector Section IV [1]
    nw3_x = x40*(-SQRT3_2*gz3 + mpf(1)/2*n3_z*x38 - mpf(1)/2*x49)
    nw3_y = x40*(-SQRT3_2*(-n3_z*x38 + x49) + mpf(1)/2*gz3)
    nw3_z = x41
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x47 + x48)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # wrist: the central limb in the platform's plane (26), (27) [1]
    wrist = SQRT3_2*x13*(c_x*nu_x + c_y*nu_y + c_z*nu_z)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    # rate of the outer limb 1 (15) [m/s]
    dq1 = x16*x17*(-h1*(omega_x*(-m1_x*sigma1 + nu_x*tau1) + omega_y*(-m1_y*sigma1 + nu_y*tau1) + omega_z*(-m1_z*sigma1 + nu_z*tau1)) - n1_x*(v_x*(m1_x*tau1 + nu_x*sigma1) + v_y*(m1_y*tau1 + nu_y*sigma1) + v_z*(m1_z*tau1 + nu_z*sigma1)))/l1
    # rate of the outer limb 2 (15) [m/s]
    dq2 = x25*x31*(-h2*(omega_x*(-m2_x*sigma2 + nu_x*tau2) + omega_y*(-m2_y*sigma2 + nu_y*tau2) + omega_z*(-m2_z*sigma2 + nu_z*tau2)) - p2*(v_x*(m2_x*tau2 + nu_x*sigma2) + v_y*(m2_y*tau2 + nu_y*sigma2) + v_z*(m2_z*tau2 + nu_z*sigma2)))/l2
    # rate of the outer limb 3 (15) [m/s]
    dq3 = x36*x39*(-h3*(omega_x*(-m3_x*sigma3 + nu_x*tau3) + omega_y*(-m3_y*sigma3 + nu_y*tau3) + omega_z*(-m3_z*sigma3 + nu_z*tau3)) - p3*(v_x*(m3_x*tau3 + nu_x*sigma3) + v_y*(m3_y*tau3 + nu_y*sigma3) + v_z*(m3_z*tau3 + nu_z*sigma3)))/l3
    # rate of the azimuth (16) [rad/s]
    dq4 = (c_x*v_y - c_y*v_x)/((r*r))
    # rate of the elevation (16) [rad/s]
    dq5 = (-c_z*(c_x*v_x + c_y*v_y)/r + r*v_z)/((q6*q6))
    # rate of the central limb's length (16) [m/s]
    dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z
    x50 = nw1_x*v_x + nw1_y*v_y + nw1_z*v_z
    # rate of the base revolute (12) [rad/s]
    rate11 = x16*x18*(e1*(omega_x*(n1_y*nw1_z - n1_z*nw1_y) + omega_y*(-n1_x*nw1_z + n1_z*nw1_x) + omega_z*(n1_x*nw1_y - n1_y*nw1_x)) + x50)
    x51 = -x15
    # rate of the cylindrical joint's rotation (12) [rad/s]
    rate15 = x18*(-omega_x*(-c_y*nw1_z + c_z*nw1_y) - omega_y*(-c_z*nw1_x + nw1_z*x51) - omega_z*(c_y*nw1_x - nw1_y*x51) - x50)/((nw1_x*nw1_x) + (nw1_y*nw1_y) + (nw1_z*nw1_z))
    # rate of the cylindrical joint's translation (12) [m/s]
    rate16 = x16*(e1*(-n1_y*omega_z + n1_z*omega_y) + v_x)
    x52 = -omega_y
    x53 = -n1_y*rate15 - x52
    x54 = -omega_z
    x55 = -n1_z*rate15 - x54
    # rate of the revolute along the leg (12) [rad/s]
    rate13 = w1_y*x53 + w1_z*x55
    # rate of the upper revolute, whose axis is no unit vector (12) [rad/s]
    rate14 = x16*(w1_y*x55 - w1_z*x53)
    x56 = nw2_x*v_x + nw2_y*v_y + nw2_z*v_z
    # rate of the base revolute (12) [rad/s]
    rate21 = x35*(e2*(omega_x*(n2_y*nw2_z - n2_z*nw2_y) + omega_y*(-n2_x*nw2_z + n2_z*nw2_x) + omega_z*(n2_x*nw2_y - n2_y*nw2_x)) + x56)
    x57 = -c_y
    x58 = -a2_y - x57
    x59 = -a2_x - x14
    # rate of the cylindrical joint's rotation (12) [rad/s]
    rate25 = x32*(-omega_x*(c_z*nw2_y - nw2_z*x58) - omega_y*(-c_z*nw2_x + nw2_z*x59) - omega_z*(nw2_x*x58 - nw2_y*x59) - x56)/((nw2_x*nw2_x) + (nw2_y*nw2_y) + (nw2_z*nw2_z))
    x60 = mpf(1)/2*v_x
    x61 = SQRT3_2*v_y
    x62 = mpf(1)/2*omega_y
    # rate of the cylindrical joint's translation (12) [m/s]
    rate26 = x25*(e2*(SQRT3_2*(n2_x*omega_z - n2_z*omega_x) - n2_z*x62 + omega_z*x26) - x60 + x61)
    x63 = -omega_x
    x64 = -n2_x*rate25 - x63
    x65 = -n2_y*rate25 - x52
    x66 = -n2_z*rate25 - x54
    # rate of the revolute along the leg (12) [rad/s]
    rate23 = w2_x*x64 + w2_y*x65 + w2_z*x66
    # rate of the upper revolute, whose axis is no unit vector (12) [rad/s]
    rate24 = x25*(SQRT3_2*w2_z*x64 + mpf(1)/2*w2_z*x65 + x66*(-SQRT3_2*w2_x - mpf(1)/2*w2_y))
    x67 = nw3_x*v_x + nw3_y*v_y + nw3_z*v_z
    # rate of the base revolute (12) [rad/s]
    rate31 = x43*(e3*(omega_x*(n3_y*nw3_z - n3_z*nw3_y) + omega_y*(-n3_x*nw3_z + n3_z*nw3_x) + omega_z*(n3_x*nw3_y - n3_y*nw3_x)) + x67)
    x68 = -a3_y - x57
    x69 = -a3_x - x14
    # rate of the cylindrical joint's rotation (12) [rad/s]
    rate35 = x40*(-omega_x*(c_z*nw3_y - nw3_z*x68) - omega_y*(-c_z*nw3_x + nw3_z*x69) - omega_z*(nw3_x*x68 - nw3_y*x69) - x67)/((nw3_x*nw3_x) + (nw3_y*nw3_y) + (nw3_z*nw3_z))
    # rate of the cylindrical joint's translation (12) [m/s]
    rate36 = x36*(e3*(-SQRT3_2*(n3_x*omega_z - n3_z*omega_x) + mpf(1)/2*n3_y*omega_z - n3_z*x62) - x60 - x61)
    x70 = -n3_x*rate35 - x63
    x71 = -n3_y*rate35 - x52
    x72 = -n3_z*rate35 - x54
    # rate of the revolute along the leg (12) [rad/s]
    rate33 = w3_x*x70 + w3_y*x71 + w3_z*x72
    # rate of the upper revolute, whose axis is no unit vector (12) [rad/s]
    rate34 = x36*(-SQRT3_2*w3_z*x70 + mpf(1)/2*w3_z*x71 + x72*(SQRT3_2*w3_x - mpf(1)/2*w3_y))
    # angular velocity that the passive joints of the central limb make (12) [rad/s]
    spin_x = -axis_x*dq5 - x63
    spin_y = -axis_y*dq5 - x52
    spin_z = -dq4 - x54
    # rate of the revolute along the central limb (12) [rad/s]
    rate44 = SQRT3_2*(nu_x*spin_x + nu_y*spin_y + nu_z*spin_z)/wrist
    x73 = -lambda_x*rate44 + spin_x
    x74 = -lambda_y*rate44 + spin_y
    x75 = -lambda_z*rate44 + spin_z
    # rate of the universal joint's first axis (12) [rad/s]
    rate45 = n1_x*x73 + n1_y*x74 + n1_z*x75
    # rate of the universal joint's second axis, of norm √3/2 (12) [rad/s]
    rate46 = mpf(4)/3*SQRT3_2*(m1_x*x73 + m1_y*x74 + m1_z*x75)
    return JointRates(
        [[rate11, dq1, rate13, rate14, rate15, rate16], [rate21, dq2, rate23, rate24, rate25, rate26], [rate31, dq3, rate33, rate34, rate35, rate36], [dq4, dq5, dq6, rate44, rate45, rate46]],
        wrist,
        SQRT3_2,
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class PlatformWrench(NamedTuple):
    """What `platform_wrench` returns."""

    wrench: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def platform_wrench(a: Nested, c: Nested, R: Nested, forces: Nested) -> PlatformWrench:
    """Wrench that the platform exerts from the forces of the actuators.

    Equations (15), (16), by duality of the paper; base frame.
    304 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    forces : nested list (..., 6)
        f1 ... f6 [N, N m]

    Returns
    -------
    wrench : nested list (..., 6)
        [force, moment at C] [N, N m]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    forces = _exact(forces)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    force1, force2, force3, force4, force5, force6 = forces
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x16 - x17)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x16 + x17)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x18 = 1.0/rho1
    # unit vector from B_i to D_i (14) [1]
    s1_x = x18*(m1_x*tau1 + nu_x*sigma1)
    s1_y = x18*(m1_y*tau1 + nu_y*sigma1)
    s1_z = x18*(m1_z*tau1 + nu_z*sigma1)
    x19 = e1*x18
    # moment of S_i about C (14) [m]
    so1_x = x19*(-m1_x*sigma1 + nu_x*tau1)
    so1_y = x19*(-m1_y*sigma1 + nu_y*tau1)
    so1_z = x19*(-m1_z*sigma1 + nu_z*tau1)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -l1*x18*absolute(n1_x)
    x20 = mpf(1)/2*nu_y
    x21 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x20 - x21)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x22 = 1.0/rho2
    # unit vector from B_i to D_i (14) [1]
    s2_x = x22*(m2_x*tau2 + nu_x*sigma2)
    s2_y = x22*(m2_y*tau2 + nu_y*sigma2)
    s2_z = x22*(m2_z*tau2 + nu_z*sigma2)
    x23 = e2*x22
    # moment of S_i about C (14) [m]
    so2_x = x23*(-m2_x*sigma2 + nu_x*tau2)
    so2_y = x23*(-m2_y*sigma2 + nu_y*tau2)
    so2_z = x23*(-m2_z*sigma2 + nu_z*tau2)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -l2*x22*absolute(p2)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x20 + x21)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x24 = 1.0/rho3
    # unit vector from B_i to D_i (14) [1]
    s3_x = x24*(m3_x*tau3 + nu_x*sigma3)
    s3_y = x24*(m3_y*tau3 + nu_y*sigma3)
    s3_z = x24*(m3_z*tau3 + nu_z*sigma3)
    x25 = e3*x24
    # moment of S_i about C (14) [m]
    so3_x = x25*(-m3_x*sigma3 + nu_x*tau3)
    so3_y = x25*(-m3_y*sigma3 + nu_y*tau3)
    so3_z = x25*(-m3_z*sigma3 + nu_z*tau3)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -l3*x24*absolute(p3)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x26 = 1.0/((r*r))
    # force through C that a torque of 1 about the azimuth makes (16) [1/m]
    grad_q4_x = -c_y*x26
    grad_q4_y = c_x*x26
    x27 = 1.0/((q6*q6))
    x28 = c_z*x27/r
    # force through C that a torque of 1 about the elevation makes (16) [1/m]
    grad_q5_x = -c_x*x28
    grad_q5_y = -c_y*x28
    grad_q5_z = r*x27
    x29 = force1/limb1
    x30 = force2/limb2
    x31 = force3/limb3
    # force that the platform exerts (15), (16) [N]
    force_x = force4*grad_q4_x + force5*grad_q5_x + force6*lambda_x + s1_x*x29 + s2_x*x30 + s3_x*x31
    force_y = force4*grad_q4_y + force5*grad_q5_y + force6*lambda_y + s1_y*x29 + s2_y*x30 + s3_y*x31
    force_z = force5*grad_q5_z + force6*lambda_z + s1_z*x29 + s2_z*x30 + s3_z*x31
    # moment at C that the platform exerts (15) [N m]
    moment_x = so1_x*x29 + so2_x*x30 + so3_x*x31
    moment_y = so1_y*x29 + so2_y*x30 + so3_y*x31
    moment_z = so1_z*x29 + so2_z*x30 + so3_z*x31
    return PlatformWrench(
        [force_x, force_y, force_z, moment_x, moment_y, moment_z],
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class ActuatorForces(NamedTuple):
    """What `actuator_forces` returns."""

    forces: Nested
    extension: Nested
    extension_scale: Nested
    orientation: Nested
    orientation_scale: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def actuator_forces(a: Nested, c: Nested, R: Nested, heading: Nested, wrench: Nested) -> ActuatorForces:
    """Forces of the actuators from the wrench that the platform exerts.

    Equations (16), (17), by duality of the paper; base frame.
    374 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    wrench : nested list (..., 2, 3)
        [force, moment at C] [N, N m]

    Returns
    -------
    forces : nested list (..., 6)
        f1 ... f6 [N, N m]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : nested list (..., 3)
        scales of the e_i [m]
    orientation : nested list (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : nested list (...)
        scale of orientation [m³]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    wrench = _exact(wrench)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    (force_x, force_y, force_z), (moment_x, moment_y, moment_z) = wrench
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x14 = SQRT3_2*c_y
    x15 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x16 - x17)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x14 + x15
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x16 + x17)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x18 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x18
    axis_y = -heading_1*x18
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x19 = 1.0/rho1
    x20 = nu_x*sigma1
    # unit vector from B_i to D_i (14) [1]
    s1_x = x19*(m1_x*tau1 + x20)
    x21 = nu_y*sigma1
    s1_y = x19*(m1_y*tau1 + x21)
    x22 = nu_z*sigma1
    s1_z = x19*(m1_z*tau1 + x22)
    x23 = absolute(n1_x)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -l1*x19*x23
    x24 = mpf(1)/2*nu_y
    x25 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x24 - x25)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x26 = 1.0/rho2
    # unit vector from B_i to D_i (14) [1]
    s2_x = x26*(m2_x*tau2 + nu_x*sigma2)
    x27 = nu_y*sigma2
    s2_y = x26*(m2_y*tau2 + x27)
    x28 = nu_z*sigma2
    s2_z = x26*(m2_z*tau2 + x28)
    x29 = absolute(p2)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -l2*x26*x29
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x24 + x25)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x30 = 1.0/rho3
    # unit vector from B_i to D_i (14) [1]
    s3_x = x30*(m3_x*tau3 + nu_x*sigma3)
    s3_y = x30*(m3_y*tau3 + nu_y*sigma3)
    s3_z = x30*(m3_z*tau3 + nu_z*sigma3)
    x31 = absolute(p3)
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -l3*x30*x31
    x32 = sigma2*sigma3
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = x32
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = sigma1*sigma3
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = sigma1*sigma2
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    x33 = SQRT3_2/(((n1_x*n1_x))*((p2*p2))*((p3*p3)))
    # orientation: the moments of B_iD_i about C are coplanar (27) [m³]
    orientation = tilt*x33
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x34 = a + q6
    # scale of e1 [m]
    e_scale1 = x34/x23
    # scale of e2 [m]
    e_scale2 = x34/x29
    # scale of e3 [m]
    e_scale3 = x34/x31
    x35 = absolute(sigma1)
    x36 = absolute(sigma2)
    x37 = absolute(sigma3)
    x38 = absolute(tau2)
    x39 = absolute(tau3)
    x40 = absolute(tau1)
    # scale of the orientation factor [m³]
    orientation_scale = reach*x33*(x35*x36 + x35*x37 + x35*x38 + x35*x39 + x36*x37 + x36*x39 + x36*x40 + x37*x38 + x37*x40)
    x41 = sigma3*tau2
    x42 = sigma2*tau3
    x43 = SQRT3_2*sigma3
    x44 = mpf(4)/3*SQRT3_2/tilt
    # power of the moment at the omega that a drive of 1 of limb 1 alone makes (17) [N]
    share1 = x44*(moment_x*(-n2_x*x42 + n3_x*x41 + x25*x32) + moment_y*(-n2_y*x42 + n3_y*x41 + x27*x43) + moment_z*(-n2_z*x42 + n3_z*x41 + x28*x43))
    # force along S_1 (17) [N]
    load1 = rho1*share1/e1
    # force of the actuator of limb 1 (15) [N]
    force1 = limb1*load1
    x45 = sigma1*tau3
    x46 = sigma3*tau1
    # power of the moment at the omega that a drive of 1 of limb 2 alone makes (17) [N]
    share2 = x44*(moment_x*(n1_x*x45 - n3_x*x46 + x20*x43) + moment_y*(n1_y*x45 - n3_y*x46 + x21*x43) + moment_z*(n1_z*x45 - n3_z*x46 + x22*x43))
    # force along S_2 (17) [N]
    load2 = rho2*share2/e2
    # force of the actuator of limb 2 (15) [N]
    force2 = limb2*load2
    x47 = sigma2*tau1
    x48 = sigma1*tau2
    x49 = SQRT3_2*sigma2
    # power of the moment at the omega that a drive of 1 of limb 3 alone makes (17) [N]
    share3 = x44*(moment_x*(-n1_x*x48 + n2_x*x47 + x20*x49) + moment_y*(-n1_y*x48 + n2_y*x47 + x21*x49) + moment_z*(-n1_z*x48 + n2_z*x47 + x22*x49))
    # force along S_3 (17) [N]
    load3 = rho3*share3/e3
    # force of the actuator of limb 3 (15) [N]
    force3 = limb3*load3
    # force through C that the central limb carries (16) [N]
    central_force_x = force_x - load1*s1_x - load2*s2_x - load3*s3_x
    central_force_y = force_y - load1*s1_y - load2*s2_y - load3*s3_y
    central_force_z = force_z - load1*s1_z - load2*s2_z - load3*s3_z
    # torque of the actuator of the azimuth (16) [N m]
    force4 = c_x*central_force_y - c_y*central_force_x
    # torque of the actuator of the elevation (16) [N m]
    force5 = -axis_x*c_z*central_force_y + axis_y*c_z*central_force_x + central_force_z*(axis_x*c_y - axis_y*c_x)
    # force of the actuator of the central limb's length (16) [N]
    force6 = central_force_x*lambda_x + central_force_y*lambda_y + central_force_z*lambda_z
    return ActuatorForces(
        [force1, force2, force3, force4, force5, force6],
        [e1, e2, e3],
        [e_scale1, e_scale2, e_scale3],
        orientation,
        orientation_scale,
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class InverseAcceleration(NamedTuple):
    """What `inverse_acceleration` returns."""

    rates: Nested
    accelerations: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def inverse_acceleration(a: Nested, c: Nested, R: Nested, twist: Nested, twist_rate: Nested) -> InverseAcceleration:
    """Joint rates and accelerations from the twist and its derivative.

    Equations (15), (16), differentiated of the paper; base frame.
    535 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    twist : nested list (..., 2, 3)
        [omega, v_C] [rad/s, m/s]
    twist_rate : nested list (..., 2, 3)
        [d omega/dt, dv_C/dt] [rad/s², m/s²]

    Returns
    -------
    rates : nested list (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    accelerations : nested list (..., 6)
        q̈1 ... q̈6 [m/s², rad/s²]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    twist = _exact(twist)
    twist_rate = _exact(twist_rate)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    (omega_x, omega_y, omega_z), (v_x, v_y, v_z) = twist
    (domega_x, domega_y, domega_z), (dv_x, dv_y, dv_z) = twist_rate
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    x14 = c_z*x13
    lambda_z = x14
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    x15 = 1.0/n1_x
    # signed distance from C to B_i (4) [m]
    e1 = h1*x15
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x16 = 1.0/absolute(n1_x)
    # length of the outer limb (10) [m]
    q1 = l1*x16
    x17 = SQRT3_2*c_y
    x18 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x17 + x18
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x19 = 1.0/p2
    # signed distance from C to B_i (4) [m]
    e2 = h2*x19
    x20 = mpf(1)/2*n2_y
    x21 = mpf(1)/2*c_y
    x22 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - x20) + p2*(-x21 - x22)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    x23 = 1.0/absolute(p2)
    # length of the outer limb (10) [m]
    q2 = l2*x23
    # distance of C from the plane of the limb (4) [m]
    h3 = x17 + x18
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x24 = 1.0/p3
    # signed distance from C to B_i (4) [m]
    e3 = h3*x24
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x21 + x22)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x25 = 1.0/absolute(p3)
    # length of the outer limb (10) [m]
    q3 = l3*x25
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    x26 = mpf(1)/2*nu_y
    x27 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x26 - x27)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x26 + x27)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x28 = m1_x*tau1 + nu_x*sigma1
    x29 = m1_y*tau1 + nu_y*sigma1
    x30 = m1_z*tau1 + nu_z*sigma1
    x31 = -m1_x*sigma1 + nu_x*tau1
    x32 = -m1_y*sigma1 + nu_y*tau1
    x33 = -m1_z*sigma1 + nu_z*tau1
    x34 = x15*x16/l1
    # rate of the outer limb 1 (15) [m/s]
    dq1 = x34*(-h1*(omega_x*x31 + omega_y*x32 + omega_z*x33) - n1_x*(v_x*x28 + v_y*x29 + v_z*x30))
    x35 = m2_x*tau2 + nu_x*sigma2
    x36 = m2_y*tau2 + nu_y*sigma2
    x37 = m2_z*tau2 + nu_z*sigma2
    x38 = -m2_x*sigma2 + nu_x*tau2
    x39 = -m2_y*sigma2 + nu_y*tau2
    x40 = -m2_z*sigma2 + nu_z*tau2
    x41 = x19*x23/l2
    # rate of the outer limb 2 (15) [m/s]
    dq2 = x41*(-h2*(omega_x*x38 + omega_y*x39 + omega_z*x40) - p2*(v_x*x35 + v_y*x36 + v_z*x37))
    x42 = m3_x*tau3 + nu_x*sigma3
    x43 = m3_y*tau3 + nu_y*sigma3
    x44 = m3_z*tau3 + nu_z*sigma3
    x45 = -m3_x*sigma3 + nu_x*tau3
    x46 = -m3_y*sigma3 + nu_y*tau3
    x47 = -m3_z*sigma3 + nu_z*tau3
    x48 = x24*x25/l3
    # rate of the outer limb 3 (15) [m/s]
    dq3 = x48*(-h3*(omega_x*x45 + omega_y*x46 + omega_z*x47) - p3*(v_x*x42 + v_y*x43 + v_z*x44))
    x49 = 1.0/((r*r))
    # rate of the azimuth (16) [rad/s]
    dq4 = x49*(c_x*v_y - c_y*v_x)
    x50 = c_x*v_x
    x51 = c_y*v_y
    x52 = 1.0/r
    x53 = c_z*x52
    # rate of the elevation (16) [rad/s]
    dq5 = (r*v_z - x53*(x50 + x51))/((q6*q6))
    # rate of the central limb's length (16) [m/s]
    dq6 = lambda_x*v_x + lambda_y*v_y + lambda_z*v_z
    x54 = -n1_y*omega_z + n1_z*omega_y
    x55 = e1*x54 + v_x
    # rate of e_i (4) [m/s]
    de1 = -x15*x55
    # velocity of B_i (3) [m/s]
    db1_x = de1*n1_x + x55
    x56 = n1_x*omega_z - n1_z*omega_x
    db1_y = de1*n1_y + e1*x56 + v_y
    x57 = -n1_x*omega_y + n1_y*omega_x
    db1_z = de1*n1_z + e1*x57 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias1 = ((db1_x*db1_x) + (db1_y*db1_y) + (db1_z*db1_z) - (dq1*dq1) - (2.0*de1*(x28*x54 + x29*x56 + x30*x57) + e1*(n1_x*omega_x + n1_y*omega_y + n1_z*omega_z)*(omega_x*x28 + omega_y*x29 + omega_z*x30))/((n1_x*n1_x)))/q1
    # acceleration of the outer limb 1 (15) [m/s²]
    ddq1 = bias1 - x34*(h1*(domega_x*x31 + domega_y*x32 + domega_z*x33) + n1_x*(dv_x*x28 + dv_y*x29 + dv_z*x30))
    x58 = SQRT3_2*v_y
    x59 = n2_x*omega_z - n2_z*omega_x
    # rate of e_i (4) [m/s]
    de2 = x19*(-e2*(SQRT3_2*x59 - mpf(1)/2*n2_z*omega_y + omega_z*x20) + mpf(1)/2*v_x - x58)
    x60 = -n2_y*omega_z + n2_z*omega_y
    # velocity of B_i (3) [m/s]
    db2_x = de2*n2_x + e2*x60 + v_x
    db2_y = de2*n2_y + e2*x59 + v_y
    x61 = -n2_x*omega_y + n2_y*omega_x
    db2_z = de2*n2_z + e2*x61 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias2 = ((db2_x*db2_x) + (db2_y*db2_y) + (db2_z*db2_z) - (dq2*dq2) - (2.0*de2*(x35*x60 + x36*x59 + x37*x61) + e2*(n2_x*omega_x + n2_y*omega_y + n2_z*omega_z)*(omega_x*x35 + omega_y*x36 + omega_z*x37))/((p2*p2)))/q2
    # acceleration of the outer limb 2 (15) [m/s²]
    ddq2 = bias2 - x41*(h2*(domega_x*x38 + domega_y*x39 + domega_z*x40) + p2*(dv_x*x35 + dv_y*x36 + dv_z*x37))
    x62 = n3_x*omega_z - n3_z*omega_x
    # rate of e_i (4) [m/s]
    de3 = x24*(-e3*(-SQRT3_2*x62 + mpf(1)/2*n3_y*omega_z - mpf(1)/2*n3_z*omega_y) + mpf(1)/2*v_x + x58)
    x63 = -n3_y*omega_z + n3_z*omega_y
    # velocity of B_i (3) [m/s]
    db3_x = de3*n3_x + e3*x63 + v_x
    db3_y = de3*n3_y + e3*x62 + v_y
    x64 = -n3_x*omega_y + n3_y*omega_x
    db3_z = de3*n3_z + e3*x64 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias3 = ((db3_x*db3_x) + (db3_y*db3_y) + (db3_z*db3_z) - (dq3*dq3) - (2.0*de3*(x42*x63 + x43*x62 + x44*x64) + e3*(n3_x*omega_x + n3_y*omega_y + n3_z*omega_z)*(omega_x*x42 + omega_y*x43 + omega_z*x44))/((p3*p3)))/q3
    # acceleration of the outer limb 3 (15) [m/s²]
    ddq3 = bias3 - x48*(h3*(domega_x*x45 + domega_y*x46 + domega_z*x47) + p3*(dv_x*x42 + dv_y*x43 + dv_z*x44))
    # acceleration of the azimuth (16) [rad/s²]
    ddq4 = x49*(c_x*dv_y - c_y*dv_x - dq4*(2.0*x50 + 2.0*x51))
    # acceleration of the central limb's length (16) [m/s²]
    ddq6 = x13*(c_x*dv_x + c_y*dv_y + c_z*dv_z - (dq6*dq6) + (v_x*v_x) + (v_y*v_y) + (v_z*v_z))
    # acceleration of the elevation (16) [rad/s²]
    ddq5 = x53*(dq5*dq5) + x52*(-ddq6*x14 - 2.0*dq5*dq6*r*x13 + dv_z)
    return InverseAcceleration(
        [dq1, dq2, dq3, dq4, dq5, dq6],
        [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6],
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class ForwardAcceleration(NamedTuple):
    """What `forward_acceleration` returns."""

    twist: Nested
    twist_rate: Nested
    extension: Nested
    extension_scale: Nested
    orientation: Nested
    orientation_scale: Nested
    incidence: Nested
    scaled_legs: Nested
    radial: Nested
    central_length: Nested
    reach: Nested


def forward_acceleration(a: Nested, c: Nested, R: Nested, heading: Nested, rates: Nested, accelerations: Nested) -> ForwardAcceleration:
    """Twist and its derivative from the joint rates and accelerations.

    Equations (12), (17), differentiated of the paper; base frame.
    634 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]
    heading : nested list (..., 2)
        horizontal vector at azimuth q4: (c_x, c_y) off the Z axis [m]
    rates : nested list (..., 6)
        q̇1 ... q̇6 [m/s, rad/s]
    accelerations : nested list (..., 6)
        q̈1 ... q̈6 [m/s², rad/s²]

    Returns
    -------
    twist : nested list (..., 6)
        [omega, v_C] [rad/s, m/s]
    twist_rate : nested list (..., 6)
        its derivative [rad/s², m/s²]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    extension_scale : nested list (..., 3)
        scales of the e_i [m]
    orientation : nested list (...)
        det[n_i × (d_i − c)] [m³]
    orientation_scale : nested list (...)
        scale of orientation [m³]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    scaled_legs : nested list (..., 3)
        |n_i·u_i| q_i [m]
    radial : nested list (...)
        distance of C from the Z axis [m]
    central_length : nested list (...)
        distance from O to C [m]
    reach : nested list (...)
        a + 2 |c|, against which the legs' rounding is judged [m]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    heading = _exact(heading)
    rates = _exact(rates)
    accelerations = _exact(accelerations)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    heading_1, heading_2 = heading
    dq1, dq2, dq3, dq4, dq5, dq6 = rates
    ddq1, ddq2, ddq3, ddq4, ddq5, ddq6 = accelerations
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    x13 = 1.0/q6
    # unit vector along the central limb, from O to C (1) [1]
    lambda_x = c_x*x13
    lambda_y = c_y*x13
    lambda_z = c_z*x13
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    x14 = 1.0/n1_x
    # signed distance from C to B_i (4) [m]
    e1 = h1*x14
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x15 = absolute(n1_x)
    x16 = 1.0/x15
    # length of the outer limb (10) [m]
    q1 = l1*x16
    x17 = SQRT3_2*c_y
    x18 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x17 + x18
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x19 = 1.0/p2
    # signed distance from C to B_i (4) [m]
    e2 = h2*x19
    x20 = mpf(1)/2*n2_y
    x21 = mpf(1)/2*c_y
    x22 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - x20) + p2*(-x21 - x22)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    x23 = absolute(p2)
    x24 = 1.0/x23
    # length of the outer limb (10) [m]
    q2 = l2*x24
    # distance of C from the plane of the limb (4) [m]
    h3 = x17 + x18
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x25 = 1.0/p3
    # signed distance from C to B_i (4) [m]
    e3 = h3*x25
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x21 + x22)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x26 = absolute(p3)
    x27 = 1.0/x26
    # length of the outer limb (10) [m]
    q3 = l3*x27
    x28 = 1.0/(sqrt((heading_1*heading_1) + (heading_2*heading_2)))
    # axis of the second revolute of the central limb Section IV [1]
    axis_x = heading_2*x28
    axis_y = -heading_1*x28
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    x29 = mpf(1)/2*nu_y
    x30 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x29 - x30)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x29 + x30)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    x31 = sigma2*sigma3
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = x31
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    x32 = sigma1*sigma3
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = x32
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    x33 = sigma1*sigma2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = x33
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    x34 = 1.0/((n1_x*n1_x))
    x35 = 1.0/((p2*p2))
    x36 = 1.0/((p3*p3))
    x37 = SQRT3_2*x34*x35*x36
    # orientation: the moments of B_iD_i about C are coplanar (27) [m³]
    orientation = tilt*x37
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x38 = a + q6
    # scale of e1 [m]
    e_scale1 = x16*x38
    # scale of e2 [m]
    e_scale2 = x24*x38
    # scale of e3 [m]
    e_scale3 = x27*x38
    x39 = absolute(sigma1)
    x40 = absolute(sigma2)
    x41 = absolute(sigma3)
    x42 = absolute(tau2)
    x43 = absolute(tau3)
    x44 = absolute(tau1)
    # scale of the orientation factor [m³]
    orientation_scale = reach*x37*(x39*x40 + x39*x41 + x39*x42 + x39*x43 + x40*x41 + x40*x43 + x40*x44 + x41*x42 + x41*x44)
    x45 = dq6*lambda_x
    x46 = c_z*dq5
    x47 = axis_y*x46
    # velocity of C (12), (16) [m/s]
    v_x = -c_y*dq4 + x45 + x47
    x48 = dq6*lambda_y
    x49 = axis_x*x46
    v_y = c_x*dq4 + x48 - x49
    x50 = dq6*lambda_z
    x51 = axis_x*c_y - axis_y*c_x
    v_z = dq5*x51 + x50
    x52 = l1*x15
    x53 = m1_x*tau1 + nu_x*sigma1
    x54 = m1_y*tau1 + nu_y*sigma1
    x55 = m1_z*tau1 + nu_z*sigma1
    x56 = n1_x/h1
    # what limb 1 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive1 = x56*(-dq1*x52 - v_x*x53 - v_y*x54 - v_z*x55)
    x57 = l2*x23
    x58 = m2_x*tau2 + nu_x*sigma2
    x59 = m2_y*tau2 + nu_y*sigma2
    x60 = m2_z*tau2 + nu_z*sigma2
    x61 = p2/h2
    # what limb 2 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive2 = x61*(-dq2*x57 - v_x*x58 - v_y*x59 - v_z*x60)
    x62 = l3*x26
    x63 = m3_x*tau3 + nu_x*sigma3
    x64 = m3_y*tau3 + nu_y*sigma3
    x65 = m3_z*tau3 + nu_z*sigma3
    x66 = p3/h3
    # what limb 3 asks of omega: (τ_i ν − σ_i m_i)·omega (15) [m/s]
    drive3 = x66*(-dq3*x62 - v_x*x63 - v_y*x64 - v_z*x65)
    x67 = n3_x*sigma3
    x68 = n2_x*sigma2
    x69 = tau2*x67 - tau3*x68 + x30*x31
    x70 = n1_x*sigma1
    x71 = -tau1*x67 + tau3*x70 + x30*x32
    x72 = tau1*x68 - tau2*x70 + x30*x33
    x73 = mpf(4)/3*SQRT3_2/tilt
    # angular velocity (17) [rad/s]
    omega_x = x73*(drive1*x69 + drive2*x71 + drive3*x72)
    x74 = n3_y*sigma3
    x75 = n2_y*sigma2
    x76 = SQRT3_2*nu_y
    x77 = tau2*x74 - tau3*x75 + x31*x76
    x78 = n1_y*sigma1
    x79 = -tau1*x74 + tau3*x78 + x32*x76
    x80 = tau1*x75 - tau2*x78 + x33*x76
    omega_y = x73*(drive1*x77 + drive2*x79 + drive3*x80)
    x81 = n3_z*sigma3
    x82 = n2_z*sigma2
    x83 = SQRT3_2*nu_z
    x84 = tau2*x81 - tau3*x82 + x31*x83
    x85 = n1_z*sigma1
    x86 = -tau1*x81 + tau3*x85 + x32*x83
    x87 = tau1*x82 - tau2*x85 + x33*x83
    omega_z = x73*(drive1*x84 + drive2*x86 + drive3*x87)
    x88 = c_z*ddq5
    x89 = dq5*v_z
    x90 = dq6*x13
    # acceleration of C (16) [m/s²]
    dv_x = axis_y*x88 + axis_y*x89 - c_y*ddq4 + ddq6*lambda_x - dq4*v_y + dq4*x49 + x90*(v_x - x45)
    dv_y = -axis_x*x88 - axis_x*x89 + c_x*ddq4 + ddq6*lambda_y + dq4*v_x + dq4*x47 + x90*(v_y - x48)
    dv_z = ddq5*x51 + ddq6*lambda_z + dq4*dq5*(-axis_x*c_x - axis_y*c_y) + dq5*(axis_x*v_y - axis_y*v_x) + x90*(v_z - x50)
    x91 = -n1_y*omega_z + n1_z*omega_y
    x92 = e1*x91 + v_x
    # rate of e_i (4) [m/s]
    de1 = -x14*x92
    # velocity of B_i (3) [m/s]
    db1_x = de1*n1_x + x92
    x93 = n1_x*omega_z - n1_z*omega_x
    db1_y = de1*n1_y + e1*x93 + v_y
    x94 = -n1_x*omega_y + n1_y*omega_x
    db1_z = de1*n1_z + e1*x94 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias1 = ((db1_x*db1_x) + (db1_y*db1_y) + (db1_z*db1_z) - (dq1*dq1) - x34*(2.0*de1*(x53*x91 + x54*x93 + x55*x94) + e1*(n1_x*omega_x + n1_y*omega_y + n1_z*omega_z)*(omega_x*x53 + omega_y*x54 + omega_z*x55)))/q1
    # what limb 1 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²]
    ddrive1 = x56*(-dv_x*x53 - dv_y*x54 - dv_z*x55 - x52*(-bias1 + ddq1))
    x95 = SQRT3_2*v_y
    x96 = n2_x*omega_z - n2_z*omega_x
    # rate of e_i (4) [m/s]
    de2 = x19*(-e2*(SQRT3_2*x96 - mpf(1)/2*n2_z*omega_y + omega_z*x20) + mpf(1)/2*v_x - x95)
    x97 = -n2_y*omega_z + n2_z*omega_y
    # velocity of B_i (3) [m/s]
    db2_x = de2*n2_x + e2*x97 + v_x
    db2_y = de2*n2_y + e2*x96 + v_y
    x98 = -n2_x*omega_y + n2_y*omega_x
    db2_z = de2*n2_z + e2*x98 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias2 = ((db2_x*db2_x) + (db2_y*db2_y) + (db2_z*db2_z) - (dq2*dq2) - x35*(2.0*de2*(x58*x97 + x59*x96 + x60*x98) + e2*(n2_x*omega_x + n2_y*omega_y + n2_z*omega_z)*(omega_x*x58 + omega_y*x59 + omega_z*x60)))/q2
    # what limb 2 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²]
    ddrive2 = x61*(-dv_x*x58 - dv_y*x59 - dv_z*x60 - x57*(-bias2 + ddq2))
    x99 = n3_x*omega_z - n3_z*omega_x
    # rate of e_i (4) [m/s]
    de3 = x25*(-e3*(-SQRT3_2*x99 + mpf(1)/2*n3_y*omega_z - mpf(1)/2*n3_z*omega_y) + mpf(1)/2*v_x + x95)
    x100 = -n3_y*omega_z + n3_z*omega_y
    # velocity of B_i (3) [m/s]
    db3_x = de3*n3_x + e3*x100 + v_x
    db3_y = de3*n3_y + e3*x99 + v_y
    x101 = -n3_x*omega_y + n3_y*omega_x
    db3_z = de3*n3_z + e3*x101 + v_z
    # the part of the acceleration of an outer limb that the rates alone make (6) [m/s²]
    bias3 = ((db3_x*db3_x) + (db3_y*db3_y) + (db3_z*db3_z) - (dq3*dq3) - x36*(2.0*de3*(x100*x63 + x101*x65 + x64*x99) + e3*(n3_x*omega_x + n3_y*omega_y + n3_z*omega_z)*(omega_x*x63 + omega_y*x64 + omega_z*x65)))/q3
    # what limb 3 asks of d omega/dt: (τ_i ν − σ_i m_i)·d omega/dt (15) [m/s²]
    ddrive3 = x66*(-dv_x*x63 - dv_y*x64 - dv_z*x65 - x62*(-bias3 + ddq3))
    # angular acceleration (17) [rad/s²]
    domega_x = x73*(ddrive1*x69 + ddrive2*x71 + ddrive3*x72)
    domega_y = x73*(ddrive1*x77 + ddrive2*x79 + ddrive3*x80)
    domega_z = x73*(ddrive1*x84 + ddrive2*x86 + ddrive3*x87)
    return ForwardAcceleration(
        [omega_x, omega_y, omega_z, v_x, v_y, v_z],
        [domega_x, domega_y, domega_z, dv_x, dv_y, dv_z],
        [e1, e2, e3],
        [e_scale1, e_scale2, e_scale3],
        orientation,
        orientation_scale,
        [n1_x, p2, p3],
        [l1, l2, l3],
        r,
        q6,
        reach,
    )


class InverseSingularity(NamedTuple):
    """What `inverse_singularity` returns."""

    determinant: Nested
    limb: Nested
    central: Nested
    wrist: Nested
    limb_scale: Nested
    central_scale: Nested
    wrist_scale: Nested


def inverse_singularity(a: Nested, c: Nested, R: Nested) -> InverseSingularity:
    """det J_q and its factors: the product of limb, central and wrist.

    Equations (22)-(26) of the paper; base frame.
    167 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    determinant : nested list (...)
        det J_q [m²]
    limb : nested list (..., 3)
        Klein forms of S_i and the actuated screw [1]
    central : nested list (...)
        q6² cos q5 [m²]
    wrist : nested list (...)
        (n_1 × n_2)·lambda [1]
    limb_scale : nested list (..., 3)
        scales of limb [1]
    central_scale : nested list (...)
        scale of central [m²]
    wrist_scale : nested list (...)
        scale of wrist [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x13 = SQRT3_2*c_y
    x14 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x13 + x14
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x15 = mpf(1)/2*c_y
    x16 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x15 - x16)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    # distance of C from the plane of the limb (4) [m]
    h3 = x13 + x14
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x15 + x16)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x17 = l1/rho1
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -x17*absolute(n1_x)
    x18 = mpf(1)/2*nu_y
    x19 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x18 - x19)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x20 = l2/rho2
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -x20*absolute(p2)
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x18 + x19)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x21 = l3/rho3
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -x21*absolute(p3)
    # central limb: q6² cos q5 (26) [m²]
    central = q6*r
    x22 = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z)
    # wrist: the central limb in the platform's plane (26), (27) [1]
    wrist = x22/q6
    # determinant of the inverse Jacobian (22)-(26) [m²]
    det_J_q = limb1*limb2*limb3*r*x22
    # scale of limb 1's Klein form [1]
    limb_scale1 = x17
    # scale of limb 2's Klein form [1]
    limb_scale2 = x20
    # scale of limb 3's Klein form [1]
    limb_scale3 = x21
    # scale of the central factor [m²]
    central_scale = (q6*q6)
    return InverseSingularity(
        det_J_q,
        [limb1, limb2, limb3],
        central,
        wrist,
        [limb_scale1, limb_scale2, limb_scale3],
        central_scale,
        SQRT3_2,
    )


class DirectSingularity(NamedTuple):
    """What `direct_singularity` returns."""

    determinant: Nested
    extension: Nested
    orientation: Nested
    wrist: Nested
    extension_scale: Nested
    orientation_scale: Nested
    wrist_scale: Nested


def direct_singularity(a: Nested, c: Nested, R: Nested) -> DirectSingularity:
    """det J_v and its factors: −∏(e_i / |d_i − b_i|) · orientation · wrist.

    Equations (27) of the paper; base frame.
    194 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    determinant : nested list (...)
        det J_v [m³]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    orientation : nested list (...)
        det[n_i × (d_i − c)] [m³]
    wrist : nested list (...)
        (n_1 × n_2)·lambda [1]
    extension_scale : nested list (..., 3)
        scales of the e_i [m]
    orientation_scale : nested list (...)
        scale of orientation [m³]
    wrist_scale : nested list (...)
        scale of wrist [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    # length of the central limb (11) [m]
    q6 = sqrt((c_x*c_x) + (c_y*c_y) + (c_z*c_z))
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    x12 = SQRT3_2*c_y
    x13 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x12 + x13
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x14 = mpf(1)/2*c_y
    x15 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x14 - x15)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # distance of C from the plane of the limb (4) [m]
    h3 = x12 + x13
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x14 + x15)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x16 = mpf(1)/2*nu_y
    x17 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x16 - x17)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x16 + x17)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = sigma2*sigma3
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = sigma1*sigma3
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = sigma1*sigma2
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # wrist: the central limb in the platform's plane (26), (27) [1]
    wrist = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z)/q6
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    x18 = SQRT3_2*tilt
    x19 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)))
    # orientation: the moments of B_iD_i about C are coplanar (27) [m³]
    orientation = x18*x19
    # determinant of the moments of S_1, S_2, S_3 (27) [m³]
    det_moments = e1*e2*e3*x18/(rho1*rho2*rho3)
    # determinant of the forward Jacobian (27) [m³]
    det_J_v = -det_moments*wrist
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    x20 = a + q6
    # scale of e1 [m]
    e_scale1 = x20/absolute(n1_x)
    # scale of e2 [m]
    e_scale2 = x20/absolute(p2)
    # scale of e3 [m]
    e_scale3 = x20/absolute(p3)
    x21 = absolute(sigma1)
    x22 = absolute(sigma2)
    x23 = absolute(sigma3)
    x24 = absolute(tau2)
    x25 = absolute(tau3)
    x26 = absolute(tau1)
    # scale of the orientation factor [m³]
    orientation_scale = SQRT3_2*reach*x19*(x21*x22 + x21*x23 + x21*x24 + x21*x25 + x22*x23 + x22*x25 + x22*x26 + x23*x24 + x23*x26)
    return DirectSingularity(
        det_J_v,
        [e1, e2, e3],
        orientation,
        wrist,
        [e_scale1, e_scale2, e_scale3],
        orientation_scale,
        SQRT3_2,
    )


class Survey(NamedTuple):
    """What `survey` returns."""

    joints: Nested
    extension: Nested
    inverse_determinant: Nested
    direct_determinant: Nested
    limb: Nested
    central: Nested
    wrist: Nested
    orientation: Nested
    limb_scale: Nested
    central_scale: Nested
    wrist_scale: Nested
    extension_scale: Nested
    orientation_scale: Nested
    incidence: Nested


def survey(a: Nested, c: Nested, R: Nested) -> Survey:
    """Joint values, extensions, both determinants and their factors in one pass.

    Equations (4), (10), (11), (22)-(27) of the paper; base frame.
    237 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    joints : nested list (..., 6)
        q1 ... q6 [m, rad]
    extension : nested list (..., 3)
        signed distances e_i from C to B_i [m]
    inverse_determinant : nested list (...)
        det J_q [m²]
    direct_determinant : nested list (...)
        det J_v [m³]
    limb : nested list (..., 3)
        Klein forms of S_i and the actuated screw [1]
    central : nested list (...)
        q6² cos q5 [m²]
    wrist : nested list (...)
        (n_1 × n_2)·lambda [1]
    orientation : nested list (...)
        det[n_i × (d_i − c)] [m³]
    limb_scale : nested list (..., 3)
        scales of limb [1]
    central_scale : nested list (...)
        scale of central [m²]
    wrist_scale : nested list (...)
        scale of wrist [1]
    extension_scale : nested list (..., 3)
        scales of the e_i [m]
    orientation_scale : nested list (...)
        scale of orientation [m³]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    x12 = (c_x*c_x) + (c_y*c_y)
    # length of the central limb (11) [m]
    q6 = sqrt((c_z*c_z) + x12)
    # distance of C from the Z axis (11) [m]
    r = sqrt(x12)
    # elevation of the central limb (11) [rad]
    q5 = atan2(c_z, r)
    # azimuth of the central limb, measured from the X axis (11) [rad]
    q4 = atan2(c_y, c_x)
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    # signed distance from C to B_i (4) [m]
    e1 = h1/n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = c_y*n1_x + h1*n1_y
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    # p_i times the leg, its length [m]
    l1 = sqrt((gt1*gt1) + (gz1*gz1))
    x13 = absolute(n1_x)
    x14 = 1.0/x13
    # length of the outer limb (10) [m]
    q1 = l1*x14
    x15 = SQRT3_2*c_y
    x16 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x15 + x16
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    # signed distance from C to B_i (4) [m]
    e2 = h2/p2
    x17 = mpf(1)/2*c_y
    x18 = SQRT3_2*c_x
    # p_i times the horizontal part of the leg [m]
    gt2 = h2*(-SQRT3_2*n2_x - mpf(1)/2*n2_y) + p2*(-x17 - x18)
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # p_i times the leg, its length [m]
    l2 = sqrt((gt2*gt2) + (gz2*gz2))
    x19 = absolute(p2)
    x20 = 1.0/x19
    # length of the outer limb (10) [m]
    q2 = l2*x20
    # distance of C from the plane of the limb (4) [m]
    h3 = x15 + x16
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    # signed distance from C to B_i (4) [m]
    e3 = h3/p3
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*(SQRT3_2*n3_x - mpf(1)/2*n3_y) + p3*(-x17 + x18)
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i times the leg, its length [m]
    l3 = sqrt((gt3*gt3) + (gz3*gz3))
    x21 = absolute(p3)
    x22 = 1.0/x21
    # length of the outer limb (10) [m]
    q3 = l3*x22
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    # p_i² times the distance from B_i to D_i [m]
    rho1 = sqrt((sigma1*sigma1) + (tau1*tau1))
    x23 = 1.0/rho1
    x24 = l1*x23
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb1 = -x13*x24
    x25 = mpf(1)/2*nu_y
    x26 = SQRT3_2*nu_x
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*(-x25 - x26)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z - gz2*(-SQRT3_2*m2_x - mpf(1)/2*m2_y)
    # p_i² times the distance from B_i to D_i [m]
    rho2 = sqrt((sigma2*sigma2) + (tau2*tau2))
    x27 = 1.0/rho2
    x28 = l2*x27
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb2 = -x19*x28
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*(-x25 + x26)
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*(SQRT3_2*m3_x - mpf(1)/2*m3_y)
    # p_i² times the distance from B_i to D_i [m]
    rho3 = sqrt((sigma3*sigma3) + (tau3*tau3))
    x29 = 1.0/rho3
    x30 = l3*x29
    # Klein form of S_i and the actuated screw (15), (23) [1]
    limb3 = -x21*x30
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = sigma2*sigma3
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = sigma1*sigma3
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = sigma1*sigma2
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # central limb: q6² cos q5 (26) [m²]
    central = q6*r
    x31 = SQRT3_2*(c_x*nu_x + c_y*nu_y + c_z*nu_z)
    # wrist: the central limb in the platform's plane (26), (27) [1]
    wrist = x31/q6
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    x32 = SQRT3_2*tilt
    x33 = 1.0/(((n1_x*n1_x))*((p2*p2))*((p3*p3)))
    # orientation: the moments of B_iD_i about C are coplanar (27) [m³]
    orientation = x32*x33
    # determinant of the inverse Jacobian (22)-(26) [m²]
    det_J_q = limb1*limb2*limb3*r*x31
    # determinant of the moments of S_1, S_2, S_3 (27) [m³]
    det_moments = e1*e2*e3*x23*x27*x29*x32
    # determinant of the forward Jacobian (27) [m³]
    det_J_v = -det_moments*wrist
    # largest length in a leg's equations [m]
    reach = a + 2.0*q6
    # scale of limb 1's Klein form [1]
    limb_scale1 = x24
    x34 = a + q6
    # scale of e1 [m]
    e_scale1 = x14*x34
    # scale of limb 2's Klein form [1]
    limb_scale2 = x28
    # scale of e2 [m]
    e_scale2 = x20*x34
    # scale of limb 3's Klein form [1]
    limb_scale3 = x30
    # scale of e3 [m]
    e_scale3 = x22*x34
    # scale of the central factor [m²]
    central_scale = (q6*q6)
    x35 = absolute(sigma1)
    x36 = absolute(sigma2)
    x37 = absolute(sigma3)
    x38 = absolute(tau2)
    x39 = absolute(tau3)
    x40 = absolute(tau1)
    # scale of the orientation factor [m³]
    orientation_scale = SQRT3_2*reach*x33*(x35*x36 + x35*x37 + x35*x38 + x35*x39 + x36*x37 + x36*x39 + x36*x40 + x37*x38 + x37*x40)
    return Survey(
        [q1, q2, q3, q4, q5, q6],
        [e1, e2, e3],
        det_J_q,
        det_J_v,
        [limb1, limb2, limb3],
        central,
        wrist,
        orientation,
        [limb_scale1, limb_scale2, limb_scale3],
        central_scale,
        SQRT3_2,
        [e_scale1, e_scale2, e_scale3],
        orientation_scale,
        [n1_x, p2, p3],
    )


class DirectLocus(NamedTuple):
    """What `direct_locus` returns."""

    coefficients: Nested
    incidence: Nested


def direct_locus(a: Nested, R: Nested) -> DirectLocus:
    """The cubic in c on which `orientation` vanishes, at one orientation of the platform: √3/2 times its value is (p_1 p_2 p_3)² orientation.

    Equations (27) of the paper; base frame.
    328 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    coefficients : nested list (..., 20)
        at 1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³ [m³, m², m, 1]
    incidence : nested list (..., 3)
        n_i·u_i [1]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    R = _exact(R)
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*m1_x
    x5 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x4 - x5
    x6 = mpf(1)/2*m1_y
    x7 = SQRT3_2*n1_y
    m2_y = -x6 - x7
    x8 = mpf(1)/2*m1_z
    x9 = SQRT3_2*n1_z
    m2_z = -x8 - x9
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    # platform direction normal to n_3 [1]
    m3_x = -x4 + x5
    m3_y = -x6 + x7
    m3_z = -x8 + x9
    # derivative of tau_1 by the position [1]
    tau_shift1_x = -m1_x
    tau_shift1_y = -n1_x*nu_z
    tau_shift1_z = n1_x*nu_y
    # derivative of sigma_1 by the position [1]
    sigma_shift1_x = -nu_x
    sigma_shift1_y = m1_z*n1_x
    sigma_shift1_z = -m1_y*n1_x
    # tau_1, its coefficients in c [m, 1]
    tau_part1_1 = a*m1_x
    # sigma_1, its coefficients in c [m, 1]
    sigma_part1_1 = a*nu_x
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x10 = SQRT3_2*m2_y
    x11 = nu_z*p2
    # derivative of tau_2 by the position [1]
    tau_shift2_x = SQRT3_2*x11 - mpf(1)/4*m2_x + mpf(1)/2*x10
    x12 = -mpf(1)/2*m2_x + x10
    tau_shift2_y = -SQRT3_2*x12 + mpf(1)/2*x11
    x13 = mpf(1)/2*nu_y
    x14 = SQRT3_2*nu_x
    tau_shift2_z = p2*(-x13 - x14)
    x15 = mpf(1)/4*nu_x
    x16 = SQRT3_2*x13
    x17 = m2_z*p2
    # derivative of sigma_2 by the position [1]
    sigma_shift2_x = -SQRT3_2*x17 - x15 + x16
    x18 = mpf(1)/2*nu_x
    x19 = SQRT3_2*nu_y
    x20 = -x18 + x19
    sigma_shift2_y = -SQRT3_2*x20 - mpf(1)/2*x17
    sigma_shift2_z = p2*(SQRT3_2*m2_x + mpf(1)/2*m2_y)
    # tau_2, its coefficients in c [m, 1]
    tau_part2_1 = a*x12
    # sigma_2, its coefficients in c [m, 1]
    sigma_part2_1 = a*x20
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x21 = SQRT3_2*m3_y
    # derivative of tau_3 by the position [1]
    tau_shift3_x = -SQRT3_2*nu_z*p3 - mpf(1)/4*m3_x - mpf(1)/2*x21
    x22 = mpf(1)/2*m3_x + x21
    tau_shift3_y = -SQRT3_2*x22 + mpf(1)/2*nu_z*p3
    tau_shift3_z = p3*(-x13 + x14)
    # derivative of sigma_3 by the position [1]
    sigma_shift3_x = SQRT3_2*m3_z*p3 - x15 - x16
    x23 = x18 + x19
    sigma_shift3_y = -SQRT3_2*x23 - mpf(1)/2*m3_z*p3
    sigma_shift3_z = p3*(-SQRT3_2*m3_x + mpf(1)/2*m3_y)
    # tau_3, its coefficients in c [m, 1]
    tau_part3_1 = -a*x22
    # sigma_3, its coefficients in c [m, 1]
    sigma_part3_1 = -a*x23
    # sigma_2 sigma_3, its coefficients in c [m², m, 1]
    sigma23_1 = sigma_part2_1*sigma_part3_1
    sigma23_2 = sigma_part2_1*sigma_shift3_x + sigma_part3_1*sigma_shift2_x
    sigma23_3 = sigma_part2_1*sigma_shift3_y + sigma_part3_1*sigma_shift2_y
    sigma23_4 = sigma_part2_1*sigma_shift3_z + sigma_part3_1*sigma_shift2_z
    sigma23_5 = sigma_shift2_x*sigma_shift3_x
    sigma23_6 = sigma_shift2_x*sigma_shift3_y + sigma_shift2_y*sigma_shift3_x
    sigma23_7 = sigma_shift2_x*sigma_shift3_z + sigma_shift2_z*sigma_shift3_x
    sigma23_8 = sigma_shift2_y*sigma_shift3_y
    sigma23_9 = sigma_shift2_y*sigma_shift3_z + sigma_shift2_z*sigma_shift3_y
    sigma23_10 = sigma_shift2_z*sigma_shift3_z
    # tau_2 sigma_3 + tau_3 sigma_2, its coefficients in c [m², m, 1]
    tau23_1 = sigma_part2_1*tau_part3_1 + sigma_part3_1*tau_part2_1
    tau23_2 = sigma_part2_1*tau_shift3_x + sigma_part3_1*tau_shift2_x + sigma_shift2_x*tau_part3_1 + sigma_shift3_x*tau_part2_1
    tau23_3 = sigma_part2_1*tau_shift3_y + sigma_part3_1*tau_shift2_y + sigma_shift2_y*tau_part3_1 + sigma_shift3_y*tau_part2_1
    tau23_4 = sigma_part2_1*tau_shift3_z + sigma_part3_1*tau_shift2_z + sigma_shift2_z*tau_part3_1 + sigma_shift3_z*tau_part2_1
    tau23_5 = sigma_shift2_x*tau_shift3_x + sigma_shift3_x*tau_shift2_x
    tau23_6 = sigma_shift2_x*tau_shift3_y + sigma_shift2_y*tau_shift3_x + sigma_shift3_x*tau_shift2_y + sigma_shift3_y*tau_shift2_x
    tau23_7 = sigma_shift2_x*tau_shift3_z + sigma_shift2_z*tau_shift3_x + sigma_shift3_x*tau_shift2_z + sigma_shift3_z*tau_shift2_x
    tau23_8 = sigma_shift2_y*tau_shift3_y + sigma_shift3_y*tau_shift2_y
    tau23_9 = sigma_shift2_y*tau_shift3_z + sigma_shift2_z*tau_shift3_y + sigma_shift3_y*tau_shift2_z + sigma_shift3_z*tau_shift2_y
    tau23_10 = sigma_shift2_z*tau_shift3_z + sigma_shift3_z*tau_shift2_z
    # cubic of direct singularities at one orientation, its coefficients in c (27) [m³, m², m, 1]
    cubic_1 = sigma23_1*tau_part1_1 + sigma_part1_1*tau23_1
    cubic_2 = sigma23_1*tau_shift1_x + sigma23_2*tau_part1_1 + sigma_part1_1*tau23_2 + sigma_shift1_x*tau23_1
    cubic_3 = sigma23_1*tau_shift1_y + sigma23_3*tau_part1_1 + sigma_part1_1*tau23_3 + sigma_shift1_y*tau23_1
    cubic_4 = sigma23_1*tau_shift1_z + sigma23_4*tau_part1_1 + sigma_part1_1*tau23_4 + sigma_shift1_z*tau23_1
    cubic_5 = sigma23_2*tau_shift1_x + sigma23_5*tau_part1_1 + sigma_part1_1*tau23_5 + sigma_shift1_x*tau23_2
    cubic_6 = sigma23_2*tau_shift1_y + sigma23_3*tau_shift1_x + sigma23_6*tau_part1_1 + sigma_part1_1*tau23_6 + sigma_shift1_x*tau23_3 + sigma_shift1_y*tau23_2
    cubic_7 = sigma23_2*tau_shift1_z + sigma23_4*tau_shift1_x + sigma23_7*tau_part1_1 + sigma_part1_1*tau23_7 + sigma_shift1_x*tau23_4 + sigma_shift1_z*tau23_2
    cubic_8 = sigma23_3*tau_shift1_y + sigma23_8*tau_part1_1 + sigma_part1_1*tau23_8 + sigma_shift1_y*tau23_3
    cubic_9 = sigma23_3*tau_shift1_z + sigma23_4*tau_shift1_y + sigma23_9*tau_part1_1 + sigma_part1_1*tau23_9 + sigma_shift1_y*tau23_4 + sigma_shift1_z*tau23_3
    cubic_10 = sigma23_10*tau_part1_1 + sigma23_4*tau_shift1_z + sigma_part1_1*tau23_10 + sigma_shift1_z*tau23_4
    cubic_11 = sigma23_5*tau_shift1_x + sigma_shift1_x*tau23_5
    cubic_12 = sigma23_5*tau_shift1_y + sigma23_6*tau_shift1_x + sigma_shift1_x*tau23_6 + sigma_shift1_y*tau23_5
    cubic_13 = sigma23_5*tau_shift1_z + sigma23_7*tau_shift1_x + sigma_shift1_x*tau23_7 + sigma_shift1_z*tau23_5
    cubic_14 = sigma23_6*tau_shift1_y + sigma23_8*tau_shift1_x + sigma_shift1_x*tau23_8 + sigma_shift1_y*tau23_6
    cubic_15 = sigma23_6*tau_shift1_z + sigma23_7*tau_shift1_y + sigma23_9*tau_shift1_x + sigma_shift1_x*tau23_9 + sigma_shift1_y*tau23_7 + sigma_shift1_z*tau23_6
    cubic_16 = sigma23_10*tau_shift1_x + sigma23_7*tau_shift1_z + sigma_shift1_x*tau23_10 + sigma_shift1_z*tau23_7
    cubic_17 = sigma23_8*tau_shift1_y + sigma_shift1_y*tau23_8
    cubic_18 = sigma23_8*tau_shift1_z + sigma23_9*tau_shift1_y + sigma_shift1_y*tau23_9 + sigma_shift1_z*tau23_8
    cubic_19 = sigma23_10*tau_shift1_y + sigma23_9*tau_shift1_z + sigma_shift1_y*tau23_10 + sigma_shift1_z*tau23_9
    cubic_20 = sigma23_10*tau_shift1_z + sigma_shift1_z*tau23_10
    return DirectLocus(
        [cubic_1, cubic_2, cubic_3, cubic_4, cubic_5, cubic_6, cubic_7, cubic_8, cubic_9, cubic_10, cubic_11, cubic_12, cubic_13, cubic_14, cubic_15, cubic_16, cubic_17, cubic_18, cubic_19, cubic_20],
        [n1_x, p2, p3],
    )


class OrientationLocus(NamedTuple):
    """What `orientation_locus` returns."""

    value: Nested
    by_turn: Nested
    by_position: Nested


def orientation_locus(a: Nested, c: Nested, R: Nested) -> OrientationLocus:
    """The polynomial of degree 12 in Euler parameters on which `orientation` vanishes: √3/2 times it is (p_1 p_2 p_3)² orientation.

    Equations (27) of the paper; base frame.
    419 operations.

    Parameters
    ----------
    a : nested list (...)
        radius of the circle through A_1, A_2, A_3 [m]
    c : nested list (..., 3)
        position of the platform's centre C [m]
    R : nested list (..., 3, 3)
        rotation of the platform [1]

    Returns
    -------
    value : nested list (...)
        tau1 sigma2 sigma3 + tau2 sigma3 sigma1 + ... [m³]
    by_turn : nested list (..., 3)
        its derivative by a turn of the platform [m³]
    by_position : nested list (..., 3)
        its derivative by the position [m²]
    """
    SQRT3_2 = sqrt(mpf(3)) / 2
    a = _exact(a)
    c = _exact(c)
    R = _exact(R)
    c_x, c_y, c_z = c
    (n1_x, m1_x, nu_x), (n1_y, m1_y, nu_y), (n1_z, m1_z, nu_z) = R
    x0 = mpf(1)/2*n1_x
    x1 = SQRT3_2*m1_x
    # direction from C to B_2, n_1 turned by 120° about nu (5) [1]
    n2_x = -x0 + x1
    x2 = mpf(1)/2*n1_y
    x3 = SQRT3_2*m1_y
    n2_y = -x2 + x3
    x4 = mpf(1)/2*n1_z
    x5 = SQRT3_2*m1_z
    n2_z = -x4 + x5
    x6 = mpf(1)/2*m1_x
    x7 = SQRT3_2*n1_x
    # platform direction normal to n_2 [1]
    m2_x = -x6 - x7
    x8 = mpf(1)/2*m1_y
    x9 = SQRT3_2*n1_y
    m2_y = -x8 - x9
    x10 = mpf(1)/2*m1_z
    x11 = SQRT3_2*n1_z
    m2_z = -x10 - x11
    # direction from C to B_3, n_1 turned by 240° about nu (5) [1]
    n3_x = -x0 - x1
    n3_y = -x2 - x3
    n3_z = -x4 - x5
    # platform direction normal to n_3 [1]
    m3_x = -x6 + x7
    m3_y = -x8 + x9
    m3_z = -x10 + x11
    # distance of C from the plane of the limb (4) [m]
    h1 = a - c_x
    x12 = c_y*n1_x
    # p_i times the horizontal part of the leg [m]
    gt1 = h1*n1_y + x12
    # p_i times the vertical part of the leg [m]
    gz1 = c_z*n1_x + h1*n1_z
    x13 = SQRT3_2*c_y
    x14 = a + mpf(1)/2*c_x
    # distance of C from the plane of the limb (4) [m]
    h2 = -x13 + x14
    # cosine of the angle between n_i and u_i (4) [1]
    p2 = SQRT3_2*n2_y - mpf(1)/2*n2_x
    x15 = SQRT3_2*n2_x + mpf(1)/2*n2_y
    x16 = mpf(1)/2*c_y
    x17 = SQRT3_2*c_x
    x18 = -x16 - x17
    # p_i times the horizontal part of the leg [m]
    gt2 = -h2*x15 + p2*x18
    # p_i times the vertical part of the leg [m]
    gz2 = c_z*p2 + h2*n2_z
    # distance of C from the plane of the limb (4) [m]
    h3 = x13 + x14
    # cosine of the angle between n_i and u_i (4) [1]
    p3 = -SQRT3_2*n3_y - mpf(1)/2*n3_x
    x19 = SQRT3_2*n3_x - mpf(1)/2*n3_y
    x20 = -x16 + x17
    # p_i times the horizontal part of the leg [m]
    gt3 = h3*x19 + p3*x20
    # p_i times the vertical part of the leg [m]
    gz3 = c_z*p3 + h3*n3_z
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau1 = -gt1*nu_z + gz1*nu_y
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma1 = gt1*m1_z - gz1*m1_y
    x21 = mpf(1)/2*nu_y
    x22 = SQRT3_2*nu_x
    x23 = x21 + x22
    x24 = -x23
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau2 = -gt2*nu_z + gz2*x24
    x25 = mpf(1)/2*m2_y
    x26 = SQRT3_2*m2_x + x25
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma2 = gt2*m2_z + gz2*x26
    x27 = -x21 + x22
    # p_i² times the part of B_iD_i in the platform's plane [m]
    tau3 = -gt3*nu_z + gz3*x27
    x28 = mpf(1)/2*m3_y
    x29 = SQRT3_2*m3_x - x28
    # p_i² times the part of B_iD_i normal to the platform [m]
    sigma3 = gt3*m3_z - gz3*x29
    x30 = sigma2*sigma3
    # sigma of the limbs beside 1 [m²]
    sigma_pair1 = x30
    # term 1 of tilt (27) [m³]
    tilt_part1 = sigma_pair1*tau1
    x31 = sigma1*sigma3
    # sigma of the limbs beside 2 [m²]
    sigma_pair2 = x31
    # term 2 of tilt (27) [m³]
    tilt_part2 = sigma_pair2*tau2
    x32 = sigma1*sigma2
    # sigma of the limbs beside 3 [m²]
    sigma_pair3 = x32
    # term 3 of tilt (27) [m³]
    tilt_part3 = sigma_pair3*tau3
    # the three lines S_i in the platform frame (27) [m³]
    tilt = tilt_part1 + tilt_part2 + tilt_part3
    # derivative of tau_1 by the position [1]
    tau_shift1_x = -m1_x
    tau_shift1_y = -n1_x*nu_z
    tau_shift1_z = n1_x*nu_y
    # derivative of sigma_1 by the position [1]
    sigma_shift1_x = -nu_x
    sigma_shift1_y = m1_z*n1_x
    sigma_shift1_z = -m1_y*n1_x
    # moment about O of a unit force along u_1 at C [m]
    lever1_y = -c_z
    # derivative of tau_1 by a turn of the platform [m]
    tau_turn1_x = -n1_x*(c_y*nu_y - lever1_y*nu_z)
    x33 = -c_y*nu_z - lever1_y*nu_y
    tau_turn1_y = h1*m1_z + n1_z*x33 + nu_x*x12
    tau_turn1_z = -h1*m1_y - lever1_y*n1_x*nu_x - n1_y*x33
    # derivative of sigma_1 by a turn of the platform [m]
    sigma_turn1_x = n1_x*(c_y*m1_y - lever1_y*m1_z)
    x34 = c_y*m1_z + lever1_y*m1_y
    sigma_turn1_y = h1*nu_z - m1_x*x12 + n1_z*x34
    sigma_turn1_z = -h1*nu_y + lever1_y*m1_x*n1_x - n1_y*x34
    x35 = nu_z*p2
    # derivative of tau_2 by the position [1]
    tau_shift2_x = SQRT3_2*x25 + SQRT3_2*x35 - mpf(1)/4*m2_x
    tau_shift2_y = SQRT3_2*(-SQRT3_2*m2_y + mpf(1)/2*m2_x) + mpf(1)/2*x35
    tau_shift2_z = p2*x24
    x36 = mpf(1)/4*nu_x
    x37 = SQRT3_2*x21
    x38 = m2_z*p2
    # derivative of sigma_2 by the position [1]
    sigma_shift2_x = -SQRT3_2*x38 - x36 + x37
    x39 = SQRT3_2*nu_y
    sigma_shift2_y = SQRT3_2*(mpf(1)/2*nu_x - x39) - mpf(1)/2*x38
    sigma_shift2_z = p2*x26
    x40 = SQRT3_2*c_z
    # moment about O of a unit force along u_2 at C [m]
    lever2_x = x40
    x41 = mpf(1)/2*c_z
    lever2_y = x41
    lever2_z = x18
    x42 = h2*m2_z
    x43 = -lever2_x*nu_x - lever2_y*nu_y - lever2_z*nu_z
    x44 = n2_z*x43
    # derivative of tau_2 by a turn of the platform [m]
    tau_turn2_x = -SQRT3_2*x42 - SQRT3_2*x44 - p2*(-lever2_y*nu_z + lever2_z*nu_y)
    tau_turn2_y = -p2*(lever2_x*nu_z - lever2_z*nu_x) - mpf(1)/2*x42 - mpf(1)/2*x44
    tau_turn2_z = h2*x26 - p2*(-lever2_x*nu_y + lever2_y*nu_x) + x15*x43
    x45 = h2*nu_z
    x46 = lever2_x*m2_x + lever2_y*m2_y + lever2_z*m2_z
    x47 = n2_z*x46
    # derivative of sigma_2 by a turn of the platform [m]
    sigma_turn2_x = -SQRT3_2*x45 - SQRT3_2*x47 + p2*(-lever2_y*m2_z + lever2_z*m2_y)
    sigma_turn2_y = p2*(lever2_x*m2_z - lever2_z*m2_x) - mpf(1)/2*x45 - mpf(1)/2*x47
    sigma_turn2_z = h2*x23 + p2*(-lever2_x*m2_y + lever2_y*m2_x) + x15*x46
    # derivative of tau_3 by the position [1]
    tau_shift3_x = -SQRT3_2*nu_z*p3 - SQRT3_2*x28 - mpf(1)/4*m3_x
    tau_shift3_y = -SQRT3_2*(SQRT3_2*m3_y + mpf(1)/2*m3_x) + mpf(1)/2*nu_z*p3
    tau_shift3_z = p3*x27
    # derivative of sigma_3 by the position [1]
    sigma_shift3_x = SQRT3_2*m3_z*p3 - x36 - x37
    sigma_shift3_y = -SQRT3_2*(mpf(1)/2*nu_x + x39) - mpf(1)/2*m3_z*p3
    x48 = -x29
    sigma_shift3_z = p3*x48
    # moment about O of a unit force along u_3 at C [m]
    lever3_x = -x40
    lever3_y = x41
    lever3_z = x20
    x49 = h3*m3_z
    x50 = -lever3_x*nu_x - lever3_y*nu_y - lever3_z*nu_z
    x51 = n3_z*x50
    # derivative of tau_3 by a turn of the platform [m]
    tau_turn3_x = SQRT3_2*x49 + SQRT3_2*x51 - p3*(-lever3_y*nu_z + lever3_z*nu_y)
    tau_turn3_y = -p3*(lever3_x*nu_z - lever3_z*nu_x) - mpf(1)/2*x49 - mpf(1)/2*x51
    x52 = -x19
    tau_turn3_z = h3*x48 - p3*(-lever3_x*nu_y + lever3_y*nu_x) + x50*x52
    x53 = h3*nu_z
    x54 = lever3_x*m3_x + lever3_y*m3_y + lever3_z*m3_z
    x55 = n3_z*x54
    # derivative of sigma_3 by a turn of the platform [m]
    sigma_turn3_x = SQRT3_2*x53 + SQRT3_2*x55 + p3*(-lever3_y*m3_z + lever3_z*m3_y)
    sigma_turn3_y = p3*(lever3_x*m3_z - lever3_z*m3_x) - mpf(1)/2*x53 - mpf(1)/2*x55
    sigma_turn3_z = -h3*x27 + p3*(-lever3_x*m3_y + lever3_y*m3_x) + x52*x54
    x56 = sigma2*tau3 + sigma3*tau2
    x57 = sigma1*tau3 + sigma3*tau1
    x58 = sigma1*tau2 + sigma2*tau1
    # derivative of theta by a turn of the platform (27) [m³]
    tilt_turn_x = sigma_turn1_x*x56 + sigma_turn2_x*x57 + sigma_turn3_x*x58 + tau_turn1_x*x30 + tau_turn2_x*x31 + tau_turn3_x*x32
    tilt_turn_y = sigma_turn1_y*x56 + sigma_turn2_y*x57 + sigma_turn3_y*x58 + tau_turn1_y*x30 + tau_turn2_y*x31 + tau_turn3_y*x32
    tilt_turn_z = sigma_turn1_z*x56 + sigma_turn2_z*x57 + sigma_turn3_z*x58 + tau_turn1_z*x30 + tau_turn2_z*x31 + tau_turn3_z*x32
    # derivative of theta by the position (27) [m²]
    tilt_shift_x = sigma_shift1_x*x56 + sigma_shift2_x*x57 + sigma_shift3_x*x58 + tau_shift1_x*x30 + tau_shift2_x*x31 + tau_shift3_x*x32
    tilt_shift_y = sigma_shift1_y*x56 + sigma_shift2_y*x57 + sigma_shift3_y*x58 + tau_shift1_y*x30 + tau_shift2_y*x31 + tau_shift3_y*x32
    tilt_shift_z = sigma_shift1_z*x56 + sigma_shift2_z*x57 + sigma_shift3_z*x58 + tau_shift1_z*x30 + tau_shift2_z*x31 + tau_shift3_z*x32
    return OrientationLocus(
        tilt,
        [tilt_turn_x, tilt_turn_y, tilt_turn_z],
        [tilt_shift_x, tilt_shift_y, tilt_shift_z],
    )
