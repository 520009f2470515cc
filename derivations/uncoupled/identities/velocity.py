"""Section IV: the screws and the reciprocal lines S_i."""

from __future__ import annotations

from sympy import Basic, atan2, cos, sin, sqrt

from derivations.algebra.identities import Identity
from derivations.algebra.unfolding import Unfolding, computed_form
from derivations.algebra.vectors import Cross
from derivations.uncoupled.displacement import q4, r
from derivations.uncoupled.geometry import LIMBS, c, nu
from derivations.uncoupled.identities.facts import (
    QUATERNION_RELATION,
    any_frame,
    azimuth,
    central_facts,
    directions,
    leg,
    line_from_leg,
    line_in_platform,
    moment,
    named,
    pose,
    scalars,
    span,
    stated,
    vectors,
)
from derivations.uncoupled.velocity import heading


def identities() -> list[Identity]:
    """Screws and lines; what is reciprocal to what stands in `reciprocity`."""
    proofs = central_screws()
    for i in LIMBS:
        proofs += [*outer_screws(i), *line_direction(i), *line_in_frame(i), *line_moment(i)]
    return proofs


def central_screws() -> list[Identity]:
    """The axis of the second revolute, and the screws whose axes pass through C."""
    hx, hy = heading[0, 0], heading[1, 0]
    aimed = {cos(q4): cos(atan2(hy, hx)), sin(q4): sin(atan2(hy, hx))}
    wrist = Unfolding(pose(), directions(), ("lambda",))
    position = Unfolding(pose(), azimuth() | {1 / sqrt(hx**2 + hy**2): 1 / r}, ("r",))
    axis = pose()["axis"]
    return [
        computed_form(Unfolding(pose(), aimed), "axis"),
        Identity(
            "axis at the position",
            "off the Z axis the axis of the second revolute is (c_y, −c_x, 0)/r",
            lambda: [position(axis.computed_as) - position(central_facts()[axis.symbol])],
            number="Section IV",
        ),
        computed_form(wrist, "screw44"),
        computed_form(wrist, "screw45", QUATERNION_RELATION),
        computed_form(wrist, "screw46", QUATERNION_RELATION),
    ]


def outer_screws(i: int) -> list[Identity]:
    """The screws of limb i; the arm c − b_i is −e_i n_i, and b_i − a_i is along w_i."""
    n, w = vectors("n w", i)
    along_leg = {symbol: pose()[symbol.name].computed_as for symbol in (w, *scalars("gt gz", i))}
    short = Unfolding(pose(), leg(i) | {w: along_leg[w]}, (*named("gt gz p q", i), "c"))
    hinge = Unfolding(pose(), along_leg, (*named("n q", i), "c"))
    unfold = Unfolding(pose(), {Cross(n, w): vectors("nw", i)[0]}, (*named("n w e nw", i), "c"))
    return [
        computed_form(hinge, f"nw{i}"),
        computed_form(short, f"screw{i}3"),
        computed_form(unfold, f"screw{i}4"),
        computed_form(unfold, f"screw{i}5"),
    ]


def line_direction(i: int) -> list[Identity]:
    """The direction of S_i from the leg."""
    n, m = vectors("n m", i)
    by_leg = Unfolding(pose(), leg(i), named("n gt gz", i))
    normal = Unfolding(pose(), leg(i) | {nu: Cross(n, m)}, named("n m gt gz", i))
    across = Unfolding(pose(), leg(i) | {m: Cross(nu, n)}, (*named("n gt gz", i), "nu"))
    return [
        stated(
            f"line {i} from the leg",
            f"p_{i}² (d_{i} − b_{i}) = (n_{i}·g_{i}) u_{i} − p_{i} g_{i}, "
            f"g_{i} = p_{i} (b_{i} − a_{i})",
            line_from_leg(i),
            by_leg,
            number="(7)",
        ),
        computed_form(normal, f"tau{i}"),
        computed_form(across, f"sigma{i}"),
    ]


def line_in_frame(i: int) -> list[Identity]:
    """The direction of S_i in the platform frame, and the distance from B_i to D_i."""
    (d,) = vectors("d", i)
    from_leg = {symbol: pose()[symbol.name].computed_as for symbol in scalars("tau sigma", i)}
    in_frame = Unfolding(pose(), any_frame(i) | from_leg, named("b gt gz", i))
    kept = named("b p tau sigma rho", i)
    frame = Unfolding(pose(), any_frame(i) | line_in_platform(i), kept)
    facts = line_in_platform(i) | span(i)
    symbolic = Unfolding(pose(), facts, (*named("n m", i), "nu", *kept))
    return [
        Identity(
            f"line {i} in the platform frame",
            f"p_{i}² (d_{i} − b_{i}) = tau_{i} m_{i} + sigma_{i} nu",
            lambda: [in_frame(line_from_leg(i)[d]) - in_frame(line_in_platform(i)[d])],
            QUATERNION_RELATION,
            "(7)",
        ),
        computed_form(frame, f"rho{i}", QUATERNION_RELATION, squared=True),
        computed_form(symbolic, f"s{i}"),
    ]


def line_moment(i: int) -> list[Identity]:
    """The moment of S_i about C."""
    n, b = vectors("n b", i)
    arm = {c - b: -scalars("e", i)[0] * n}
    kept = named("b e p tau sigma rho", i)
    frame = Unfolding(pose(), any_frame(i) | line_in_platform(i), kept)
    by_arm = Unfolding(pose(), frame.facts | span(i) | arm, kept)
    return [
        stated(
            f"arm {i}",
            f"c − b_{i} = −e_{i} n_{i}",
            arm,
            Unfolding(pose(), {}, (*named("n e", i), "c")),
            number="(3)",
        ),
        computed_form(by_arm, f"so{i}", QUATERNION_RELATION),
        computed_form(by_arm, f"S{i}", QUATERNION_RELATION),
        Identity(
            f"moment {i}",
            f"n_{i} × (d_{i} − c) = (tau_{i} nu − sigma_{i} m_{i})/p_{i}²",
            lambda: moments(i, frame),
            QUATERNION_RELATION,
            "(14)",
        ),
    ]


def moments(i: int, frame: Unfolding) -> list[Basic]:
    """n_i × (d_i − c) = n_i × (d_i − b_i), and that in the platform frame."""
    n, b, d = vectors("n b d", i)
    ((printed, in_frame),) = moment(i).items()
    arms = Unfolding(pose(), {}, (*named("n d e", i), "c"))
    return [arms(printed - Cross(n, d - b)), frame(Cross(n, d - b)) - frame(in_frame)]
