"""The uncoupled manipulator 3-RPRRC+RRPRU: checks, kernels, named results."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kleinform.classification import Classes, classify
from kleinform.errors import InputError
from kleinform.generated import kernels
from kleinform.joints import TOLERANCE
from kleinform.limits import Limits
from kleinform.pose import check_pose
from kleinform.results import (
    DirectSingularity,
    InverseSingularity,
    Jacobians,
    Screws,
    Singularity,
    Survey,
)
from kleinform.screening import (
    SMALLEST,
    Errors,
    RotationLike,
    Screen,
    real_array,
    reject_bad_numbers,
)
from kleinform.tracking import refuse_crossings, track

if TYPE_CHECKING:
    from kleinform.conditioning import Conditioning
    from kleinform.forward.modes import AssemblyModes, AssemblyModesBatch
    from kleinform.motion.joint_motion import JointMotion
    from kleinform.motion.pose_motion import PoseMotion
    from kleinform.motion.states import JointStates, PlatformStates
    from kleinform.motion.watch import Watch

__all__ = ["UncoupledManipulator"]

Array = NDArray[np.float64]


class UncoupledManipulator:
    """The manipulator of the paper, with an ideal geometry: base and platform angles of 120°.

    Positions are in metres, angles in radians, everything is in the base frame O_XYZ. Leading
    axes of all arguments broadcast, the radius among them; trailing axes are the mathematical
    shape. Joint order: q1, q2, q3 [m], q4, q5 [rad], q6 [m].

    Parameters
    ----------
    radius : array_like (...)
        Radius a of the circle through A_1, A_2, A_3 [m], positive.
    rounding : float
        A factor f counts as zero when ``|f| <= rounding * eps * scale(f)``, where the scale
        is the size of the terms that f is a sum of, and eps is that of float64.

    Notes
    -----
    With ``errors="raise"``, the default of every method, the first broken rule raises an
    error that names the first offending pose and the number of them, and has their mask.
    With ``errors="nan"`` the offending rows, and they alone, are NaN. Wrong shapes and dtypes
    always raise.
    """

    def __init__(self, radius: ArrayLike = 1.0, *, rounding: float = 16.0) -> None:
        values = real_array("radius", radius, ()).copy()
        screen = Screen(values.shape, "raise")
        reject_bad_numbers(screen, "radius", values, 0)
        rule = f"radius: positive, at least {SMALLEST:g} m, is needed"
        screen.reject(values < SMALLEST, InputError, rule, values)
        screen.settle()
        values.setflags(write=False)
        self._radius = values
        factor = real_array("rounding", rounding, ())
        if factor.ndim or not (np.isfinite(factor) and factor >= 0.0):
            raise InputError(f"rounding: one number >= 0 is needed, {rounding!r} arrived")
        self._rounding = float(factor)

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Copies and unpickled ones are read-only too."""
        self.__dict__.update(state)
        self._radius.setflags(write=False)

    @property
    def radius(self) -> Array:
        """Radius a of the circle through A_1, A_2, A_3 [m], read-only."""
        return self._radius

    @property
    def rounding(self) -> float:
        """The k of "a factor counts as zero when |f| <= k eps scale(f)"."""
        return self._rounding

    def __repr__(self) -> str:
        return f"UncoupledManipulator(radius={self.radius.tolist()!r}, rounding={self.rounding!r})"

    # Displacement analysis --------------------------------------------------------------

    def inverse_displacement(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Array:
        """Joint values of a pose, equations (10) and (11).

        Parameters
        ----------
        position : array_like (..., 3)
            Position of C [m].
        rotation : array_like (..., 3, 3), or anything with ``as_matrix()``
            Rotation of the platform; its columns are n_1, the platform's y axis, its normal.
        azimuth : array_like (...), optional
            q4 [rad] for the poses with C on the Z axis, where the position leaves it free;
            returned there as given.
        errors : {"raise", "nan"}

        Returns
        -------
        array (..., 6)
            q1, q2, q3 [m], q4 in [−π, π], q5 in [−π/2, π/2] [rad], q6 [m].

        Raises
        ------
        SingularPoseError
            ``n_i·u_i = 0`` (B_i is not defined), or C on the Z axis without ``azimuth``,
            or C at O.
        InputError
            An argument broke a rule of its own: shape, dtype, NaN or inf, no rotation.
        """
        pose = check_pose(self, position, rotation, errors, azimuth=azimuth)
        result = kernels.inverse_displacement(pose.radius, pose.position, pose.rotation)
        pose.reject_incidence(result.incidence)
        # The azimuth is an arc tangent: nothing is divided by the distance from the Z axis.
        pose.reject_axis(result.radial, result.joints[..., 5], divided=False)
        if pose.azimuth is not None:
            on_axis = pose.on_axis(result.radial, result.joints[..., 5])
            result.joints[..., 3] = np.where(on_axis, pose.azimuth, result.joints[..., 3])
        pose.blank(result.joints)
        return result.joints

    def forward_displacement(
        self, joints: ArrayLike, *, tolerance: float = TOLERANCE, certify: bool = False
    ) -> AssemblyModes:
        """All real assembly modes of joint values, equations (5) and (6).

        Parameters
        ----------
        joints : array_like (6,)
            q1, q2, q3 [m], q4, q5 [rad], q6 [m].
        tolerance : float
            Relative: solutions that merge for some joint values ``q_j (1 ± tolerance)`` are
            one mode with its multiplicity. The default, 4 eps, makes a double root of joint
            values that were rounded to float64 one; 0 takes the joint values as exact: the
            modes are those of just these numbers, or the status is ``"undecided"``.
        certify : bool
            Prove with ball arithmetic, for all joint values within the tolerance, that
            nothing is missing (extra ``certify``). The proof, or why there is none, is
            ``.certificate``.

        Returns
        -------
        AssemblyModes
            Joint values that no pose has give none; ``.status`` and ``.degenerate`` name what
            is special.

        Raises
        ------
        JointRangeError
            A length is negative, or q5 is outside [−π/2, π/2].
        InputError
        """
        from kleinform.forward.displacement import all_modes

        return all_modes(self.radius, joints, tolerance, certify)

    def forward_displacement_batch(
        self, joints: ArrayLike, *, tolerance: float = TOLERANCE, errors: Errors = "raise"
    ) -> AssemblyModesBatch:
        """All real assembly modes of many joint values, in flat arrays with offsets.

        Parameters
        ----------
        joints : array_like (N, 6)
        tolerance
            As in `forward_displacement`.
        errors : {"raise", "nan"}
            With "nan" a row that is refused has no modes and the status ``"invalid"``.

        Returns
        -------
        AssemblyModesBatch
        """
        from kleinform.forward.displacement import all_modes_batch

        return all_modes_batch(self.radius, joints, tolerance, errors)

    # Velocity analysis ------------------------------------------------------------------

    def screws(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Screws:
        """The joint screws of the four limbs at pole C, Section IV.

        Parameters are those of `inverse_displacement`.

        Returns
        -------
        Screws
            ``.limb_1``, ``.limb_2``, ``.limb_3``, ``.central``, each (..., 6, 6), a row a
            joint, and ``.screw(limb, joint)``.

        Raises
        ------
        SingularPoseError
            ``n_i·u_i = 0`` or ``q_i = 0`` (the leg has no direction), or C on the Z axis
            without ``azimuth``, or C at O.
        InputError
        """
        pose = check_pose(self, position, rotation, errors, azimuth=azimuth)
        result = kernels.screws(pose.radius, pose.position, pose.rotation, pose.heading())
        pose.reject_legs(result)
        pose.reject_axis(result.radial, result.central_length)
        screws = Screws(result.limb1, result.limb2, result.limb3, result.limb4)
        pose.blank(*screws)
        return screws

    def jacobians(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Jacobians:
        """Forward Jacobian J_v (18) and inverse Jacobian J_q (19), ``J_vᵀ Δ V = J_q q̇``.

        Parameters, errors as in `screws`. A Jacobian that is singular is returned, not
        refused.

        Returns
        -------
        Jacobians
            ``(J_v, J_q)``, each (..., 6, 6). The columns of J_v are S_1, S_2, S_3 and the
            wrist screws, each ``[primal; dual]``.
        """
        pose = check_pose(self, position, rotation, errors, azimuth=azimuth)
        result = kernels.jacobians(pose.radius, pose.position, pose.rotation, pose.heading())
        pose.reject_legs(result)
        pose.reject_axis(result.radial, result.central_length)
        pose.blank(result.J_v, result.J_q)
        return Jacobians(result.J_v, result.J_q)

    def inverse_velocity(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        twist: ArrayLike,
        *,
        errors: Errors = "raise",
    ) -> Array:
        """Joint rates of a twist, equations (15) and (16) solved without a matrix.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_displacement`.
        twist : array_like (..., 6)
            ``[omega, v_C]``: angular velocity [rad/s] and velocity of C [m/s].

        Returns
        -------
        array (..., 6)
            q̇1, q̇2, q̇3 [m/s], q̇4, q̇5 [rad/s], q̇6 [m/s].

        Raises
        ------
        SingularPoseError
            ``q6 cos q5 = 0``, or ``n_i·u_i = 0``, or ``q_i = 0``: inverse singularities. Not
            at the wrist singularity, which cancels.
        InputError
        """
        motion = real_array("twist", twist, (6,))
        pose = check_pose(self, position, rotation, errors, twist=motion)
        halves = motion.reshape((*motion.shape[:-1], 2, 3))
        result = kernels.inverse_velocity(pose.radius, pose.position, pose.rotation, halves)
        pose.reject_inverse(result)
        pose.reject_overflow(result.rates)
        pose.blank(result.rates)
        return result.rates

    def forward_velocity(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        rates: ArrayLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Array:
        """Twist of given joint rates, equation (17) solved in decoupled closed form.

        Parameters
        ----------
        position, rotation, azimuth, errors
            As in `inverse_displacement`.
        rates : array_like (..., 6)
            q̇1, q̇2, q̇3 [m/s], q̇4, q̇5 [rad/s], q̇6 [m/s].

        Returns
        -------
        array (..., 6)
            ``[omega, v_C]`` in rad/s and m/s.

        Raises
        ------
        SingularPoseError
            ``e_i = 0`` or ``det[n_i × (d_i − c)] = 0``: direct singularities; or the errors of
            `screws`. Not at the wrist singularity, which cancels.
        InputError
        """
        speeds = real_array("rates", rates, (6,))
        pose = check_pose(self, position, rotation, errors, azimuth=azimuth, rates=speeds)
        result = kernels.forward_velocity(
            pose.radius, pose.position, pose.rotation, pose.heading(), speeds
        )
        pose.reject_direct(result)
        pose.reject_overflow(result.twist)
        pose.blank(result.twist)
        return result.twist

    def joint_rates(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        twist: ArrayLike,
        *,
        errors: Errors = "raise",
    ) -> Array:
        """Rates of all 24 joints, passive ones among them: equation (12) solved limb by limb.

        Parameters
        ----------
        position, rotation, twist, errors
            As in `inverse_velocity`.

        Returns
        -------
        array (..., 4, 6)
            A row a limb, 1, 2, 3 and the central one; a column a joint, in the order of
            `screws`: in each limb the screws times their rates sum up to the twist. Rates are
            in rad/s, of prismatic joints and of the cylindrical joint's translation in m/s. The
            fourth screw of an outer limb and the last of the central limb are no unit vectors;
            their rates are those of the screws as they are. The paper fixes both axes of the
            universal joint to the platform, as they are at one pose: along a motion its last
            three rates are no encoder values.

        Raises
        ------
        SingularPoseError
            ``(n_1 × n_2)·λ = 0``: the wrist screws span no rotation; or the errors of
            `inverse_velocity`.
        InputError
        """
        motion = real_array("twist", twist, (6,))
        pose = check_pose(self, position, rotation, errors, twist=motion)
        halves = motion.reshape((*motion.shape[:-1], 2, 3))
        result = kernels.joint_rates(
            pose.radius, pose.position, pose.rotation, pose.heading(), halves
        )
        pose.reject_inverse(result)
        pose.reject_wrist(result)
        in_a_row = result.rates.reshape((*result.rates.shape[:-2], 24))
        pose.reject_overflow(in_a_row)
        pose.blank(result.rates)
        return result.rates

    # Acceleration analysis --------------------------------------------------------------

    def inverse_acceleration(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        twist: ArrayLike,
        twist_rate: ArrayLike,
        *,
        errors: Errors = "raise",
    ) -> Array:
        """Joint accelerations of a twist and its derivative: (15), (16), differentiated.

        Parameters
        ----------
        position, rotation, twist, errors
            As in `inverse_velocity`.
        twist_rate : array_like (..., 6)
            ``[d omega/dt, dv_C/dt]``: angular acceleration [rad/s²], acceleration of C [m/s²].

        Returns
        -------
        array (..., 6)
            q̈1, q̈2, q̈3 [m/s²], q̈4, q̈5 [rad/s²], q̈6 [m/s²].

        Raises
        ------
        SingularPoseError, InputError
            As `inverse_velocity`.
        """
        motion = real_array("twist", twist, (6,))
        change = real_array("twist_rate", twist_rate, (6,))
        pose = check_pose(self, position, rotation, errors, twist=motion, twist_rate=change)
        result = kernels.inverse_acceleration(
            pose.radius,
            pose.position,
            pose.rotation,
            motion.reshape((*motion.shape[:-1], 2, 3)),
            change.reshape((*change.shape[:-1], 2, 3)),
        )
        pose.reject_inverse(result)
        pose.reject_overflow(result.accelerations)
        pose.blank(result.accelerations)
        return result.accelerations

    def forward_acceleration(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        rates: ArrayLike,
        accelerations: ArrayLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Array:
        """Derivative of the twist from joint rates and accelerations: (17), differentiated.

        Parameters
        ----------
        position, rotation, rates, azimuth, errors
            As in `forward_velocity`.
        accelerations : array_like (..., 6)
            q̈1, q̈2, q̈3 [m/s²], q̈4, q̈5 [rad/s²], q̈6 [m/s²].

        Returns
        -------
        array (..., 6)
            ``[d omega/dt, dv_C/dt]`` in rad/s² and m/s².

        Raises
        ------
        SingularPoseError, InputError
            As `forward_velocity`.
        """
        speeds = real_array("rates", rates, (6,))
        changes = real_array("accelerations", accelerations, (6,))
        pose = check_pose(
            self, position, rotation, errors, azimuth=azimuth, rates=speeds, accelerations=changes
        )
        result = kernels.forward_acceleration(
            pose.radius, pose.position, pose.rotation, pose.heading(), speeds, changes
        )
        pose.reject_direct(result)
        pose.reject_overflow(result.twist_rate)
        pose.blank(result.twist_rate)
        return result.twist_rate

    # Statics ----------------------------------------------------------------------------

    def platform_wrench(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        forces: ArrayLike,
        *,
        errors: Errors = "raise",
    ) -> Array:
        """Wrench that the platform exerts with given forces of the actuators: (17) by duality.

        Quasi-static, without gravity: ``F·v_C + M·omega = Σ f_j q̇_j`` for every twist. What
        acts on the platform from outside is minus this wrench.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_displacement`.
        forces : array_like (..., 6)
            Forces and torques of the actuators, positive where they drive their joints on:
            f1, f2, f3 [N], f4, f5 [N m], f6 [N].

        Returns
        -------
        array (..., 6)
            ``[F, M]``: force [N], and moment at C [N m]. The force comes first, so that
            ``wrench @ [v_C, omega]`` is the power; with the twist ``[omega, v_C]`` that is the
            Klein form (13).

        Raises
        ------
        SingularPoseError
            As `inverse_velocity`: inverse singularities, not at the wrist singularity.
        InputError
        """
        drives = real_array("forces", forces, (6,))
        pose = check_pose(self, position, rotation, errors, forces=drives)
        result = kernels.platform_wrench(pose.radius, pose.position, pose.rotation, drives)
        pose.reject_inverse(result)
        pose.reject_overflow(result.wrench)
        pose.blank(result.wrench)
        return result.wrench

    def actuator_forces(
        self,
        position: ArrayLike,
        rotation: RotationLike,
        wrench: ArrayLike,
        *,
        azimuth: ArrayLike | None = None,
        errors: Errors = "raise",
    ) -> Array:
        """Forces of the actuators with which the platform exerts a wrench: (17) by duality.

        Quasi-static, without gravity, as in `platform_wrench`.

        Parameters
        ----------
        position, rotation, azimuth, errors
            As in `inverse_displacement`.
        wrench : array_like (..., 6)
            ``[F, M]``: force [N] and moment at C [N m] that the platform exerts.

        Returns
        -------
        array (..., 6)
            f1, f2, f3 [N], f4, f5 [N m], f6 [N].

        Raises
        ------
        SingularPoseError
            As `forward_velocity`: direct singularities, not at the wrist singularity.
        InputError
        """
        exerted = real_array("wrench", wrench, (6,))
        pose = check_pose(self, position, rotation, errors, azimuth=azimuth, wrench=exerted)
        halves = exerted.reshape((*exerted.shape[:-1], 2, 3))
        result = kernels.actuator_forces(
            pose.radius, pose.position, pose.rotation, pose.heading(), halves
        )
        pose.reject_direct(result)
        pose.reject_overflow(result.forces)
        pose.blank(result.forces)
        return result.forces

    # Singularity analysis ---------------------------------------------------------------

    def inverse_singularity(
        self, position: ArrayLike, rotation: RotationLike, *, errors: Errors = "raise"
    ) -> Singularity:
        """det J_q and its factors, equations (22) to (26).

        ``det J_q`` is the product of the factors ``limb_1``, ``limb_2``, ``limb_3`` (Klein
        forms of S_i and the actuated screw), ``central`` (q6² cos q5) and ``wrist``
        ((n_1 × n_2)·λ).

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_displacement`. A singular pose never raises here. A factor is NaN
            where it is 0/0, and ``.undefined()`` tells where: ``limb_i`` where the leg has no
            direction (q_i = 0, or n_i·u_i = 0 = a − c·u_i), ``wrist`` at c = 0.
        """
        pose = check_pose(self, position, rotation, errors)
        result = kernels.survey(pose.radius, pose.position, pose.rotation)
        pose.screen.blank(*result)
        return InverseSingularity(result, self.rounding, pose.screen)

    def direct_singularity(
        self, position: ArrayLike, rotation: RotationLike, *, errors: Errors = "raise"
    ) -> Singularity:
        """det J_v and its factors, which the paper leaves out.

        ``det J_v = −∏(e_i / |d_i − b_i|) · orientation · wrist`` with the factors
        ``extension_1`` to ``extension_3`` (e_i), ``orientation`` (det[n_i × (d_i − c)]) and
        ``wrist``.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_singularity`. At ``n_i·u_i = 0`` the point B_i is at infinity, and
            so are e_i and what contains it; if also ``a = c·u_i``, both are 0/0.
        """
        pose = check_pose(self, position, rotation, errors)
        result = kernels.survey(pose.radius, pose.position, pose.rotation)
        pose.screen.blank(*result)
        return DirectSingularity(result, self.rounding, pose.screen)

    def survey(
        self, position: ArrayLike, rotation: RotationLike, *, errors: Errors = "raise"
    ) -> Survey:
        """Joint values, extensions, both determinants and all factors in one pass.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_singularity`: no pose is refused for being singular. On the Z axis
            q4 is atan2(0, 0) = 0.
        """
        pose = check_pose(self, position, rotation, errors)
        result = kernels.survey(pose.radius, pose.position, pose.rotation)
        pose.screen.blank(*result)
        return Survey(result, self.rounding, pose.screen)

    def classify(
        self, position: ArrayLike, rotation: RotationLike, *, errors: Errors = "raise"
    ) -> Classes:
        """The class of every pose: regular, inverse, direct, combined, wrist, limb.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_singularity`: no pose is refused for being singular. With "nan" a
            row that is refused has the class ``PoseClass.INVALID``.

        Returns
        -------
        Classes
            ``.code`` (...), uint8, a sum of `PoseClass`, ``.names()`` and ``.survey``. Of one
            pose also ``.meaning``, the geometry in words, ``.uncontrollable``, the twists that
            locked joints leave free, and ``.idle``, the joint rates that move nothing. All but
            the codes is computed when it is asked for, from the arrays as they are then.
        """
        return classify(self, position, rotation, errors)

    def conditioning(
        self, position: ArrayLike, rotation: RotationLike, *, errors: Errors = "raise"
    ) -> Conditioning:
        """How near poses are to each singularity: ratios and singular values, with their units.

        Parameters
        ----------
        position, rotation, errors
            As in `inverse_singularity`: no pose is refused for being singular.

        Returns
        -------
        Conditioning
            ``.ratios``, |f|/scale of each factor by its name, and ``.singular_values`` of the
            parts of the velocity map that have one unit. There is no invariant distance to a
            singularity on SE(3), and so no single number here.
        """
        from kleinform.conditioning import conditioning

        return conditioning(self, position, rotation, errors)

    # Motion -----------------------------------------------------------------------------

    def track(
        self,
        joints: ArrayLike,
        start_rotation: RotationLike | None = None,
        *,
        mode: int | None = None,
    ) -> tuple[Array, Array]:
        """Follow one assembly mode along a motion of the joints.

        Parameters
        ----------
        joints : array_like (T, 6)
            Joint values over time; samples are joined by straight segments of joint space,
            q4 the shorter way round.
        start_rotation : array_like (3, 3), or anything with ``as_matrix()``
            A rotation near that of the mode to follow at the first sample.
        mode : int
            Instead of it, the number of the mode in ``forward_displacement(joints[0])``.

        Returns
        -------
        positions : array (T, 3)
        rotations : array (T, 3, 3)

        Raises
        ------
        TrackingError
            It names the sample: Newton's method cannot be trusted to stay on the mode, or a
            factor of the direct singularity changes its sign.
        JointRangeError, InputError
        """
        if (start_rotation is None) == (mode is None):
            raise InputError("track: either start_rotation or mode= is needed")
        if start_rotation is None:
            from kleinform.forward.displacement import start_of

            start_rotation = start_of(self.radius, joints, mode)
        positions, rotations = track(self.radius, joints, start_rotation)
        refuse_crossings(self.direct_singularity(positions, rotations))
        return positions, rotations

    def forward_motion(
        self,
        states: JointStates,
        start_rotation: RotationLike | None = None,
        *,
        mode: int | None = None,
    ) -> PlatformStates:
        """The platform along a motion of the joints: pose, twist and its derivative.

        One assembly mode is followed with `track`; velocities and accelerations are those of
        `forward_velocity` and `forward_acceleration`.

        Parameters
        ----------
        states : JointStates
            Times (T,) [s], increasing; joint values, rates and accelerations (T, 6).
        start_rotation, mode
            As in `track`.

        Returns
        -------
        PlatformStates
            ``.of_point(offset)`` moves a point that is fixed to the platform.

        Raises
        ------
        TrackingError, JointRangeError
            As `track`.
        SingularPoseError
            As `forward_velocity`, but for C on the Z axis, where q4 says the azimuth.
        InputError
        """
        from kleinform.motion.platform import forward_motion

        return forward_motion(self, states, start_rotation, mode)

    def inverse_motion(self, states: PlatformStates) -> JointStates:
        """The joints along a motion of the platform: values, rates and accelerations.

        Parameters
        ----------
        states : PlatformStates
            Times (T,) [s], increasing; positions (T, 3), rotations (T, 3, 3), twists and
            their derivatives (T, 6).

        Returns
        -------
        JointStates
            q4 counts turns: it goes the shorter way round from one sample to the next.

        Raises
        ------
        SingularPoseError, InputError
            As `inverse_velocity`.
        """
        from kleinform.motion.platform import inverse_motion

        return inverse_motion(self, states)

    def watch(
        self,
        motion: JointMotion | PoseMotion,
        count: int,
        *,
        limits: Limits | None = None,
        start_rotation: RotationLike | None = None,
        mode: int | None = None,
    ) -> Watch:
        """Singularities and limits along a motion, and the first of them that is met.

        Parameters
        ----------
        motion : JointMotion or PoseMotion
        count : int
            How many samples it is looked at with. What happens between them is seen when a
            quantity changes its sign, or when the lines through the samples on both sides come
            down to zero.
        limits : Limits, optional
            ``Limits({"q1": (0.8, 1.4)})``, say.
        start_rotation, mode
            For a motion of the joints, as in `track`.

        Returns
        -------
        Watch
            Factors, and how far limits are away, over time; ``.first`` is the first meeting,
            its time to 1e-9 s.

        Raises
        ------
        TrackingError
            The mode cannot be followed from the first sample.
        InputError, JointRangeError
        """
        from kleinform.motion.watch import watch

        return watch(self, motion, count, limits or Limits(), start_rotation, mode)
