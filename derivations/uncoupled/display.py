"""What is shown of this mechanism, in the order of the paper.

A family of three limbs is written once with the index i. What stands in a graph only to
collect scalars into the array that a kernel returns is not shown.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from sympy import Basic, Expr, MatrixSymbol, Symbol

from derivations.algebra.equations import Equation, bindings
from derivations.algebra.screws import Screw
from derivations.algebra.vectors import components, scalar
from derivations.uncoupled import (
    accelerations,
    circles,
    closure,
    correction,
    displacement,
    eliminant,
    joint_rates,
    leg_step,
    loci,
    orientation,
    rates,
    relations,
    statics,
)
from derivations.uncoupled import geometry as topology
from derivations.uncoupled import singularity as singular
from derivations.uncoupled import velocity as motion
from derivations.uncoupled.relations import Relation

__all__ = ["COLLECTIONS", "SECTIONS", "Displayed", "displayed", "family_name", "known_components"]

#: Arrays of scalars or rows, as kernels return them.
COLLECTIONS = (
    *("q", "e", "B", "D", "W", "S", *(f"screws{limb}" for limb in range(1, 5))),
    *("powers", "arms", "pair", "steps", "limb_rates"),
)

SECTIONS = {
    "II": "Topology of the manipulator",
    "III": "Displacement analysis",
    "IV": "Jacobian matrices and velocity analysis",
    "V": "Singularity analysis",
}

#: Names of files that are not the symbol's: readable, and unique where case does not count.
FILE_NAMES = {
    "si": "direction_i",
    "soi": "moment_i",
    "dFi": "grad_F_i",
    "dF": "J_F",
    "dqi": "rate_i",
    "dq": "rates",
    "ddqi": "acceleration_i",
    "ddq": "accelerations",
    "domega": "omega_rate",
    "dv": "v_C_rate",
    "dV": "twist_rate",
    "nwi": "hinge_i",
    "footi": "foot_line_i",
    "guidei": "guide_line_i",
    "spin": "passive_omega",
    "r": "radial",
    "v": "v_C",
    "V": "twist",
    "tilt": "theta",
    "alpha": "yaw",
    "beta": "pitch",
    "gamma": "roll",
    "gap": "rotation_gap",
    "defect": "rotation_defect",
    "f": "frame_f",
    "g": "frame_g",
    "cFi": "grad_c_F_i",
    "Fti": "F_i_by_theta",
    "Fpi": "F_i_by_phi",
    "dtheta": "step_theta",
    "dphi": "step_phi",
    "qF": "F_by_joints",
}

STEMS = {"dq": "rate", "ddq": "acceleration"}

#: What the reader of one formula should know, by the name of its file.
NOTES = {
    "e_i": "The paper prints b_i on the left of (4).",
    "m_1": "The paper prints the last two columns of (8) without normalising them.",
    "axis": "η is a horizontal vector at azimuth q4: (c_x, c_y) unless C lies on the Z axis.",
    "condition26": "The paper prints λ_X i + λ_Y j for the axis μ; so printed, (26) is always 0.",
    "det_J_v": "The paper leaves this determinant without a closed form.",
    "K_i": "The coefficients of a product of two polynomials are a ∗ b, a and b those of both.",
    "angle": "Row k and column l are at powers k − 1 of t and l − 1 of s; ∗ is as for K_i.",
    "cubic": "The coefficients of a product of two polynomials in c = (x, y, z) are a ∗ b, both at "
    "1, x, y, z, x², xy, xz, y², yz, z², x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³.",
    "htx_i": "ε_i is 1 for limb 2 and −1 for limb 3.",
    "va_i": "Here the angle of leg i is θ_i at t = 0. For B_2, s stands for t.",
    "limb_acceleration_i": "L_i is the Lie screw of the limb: its screws times their rates, the "
    "Lie products of each with each that comes after it, summed up.",
    "screw_46": "Its norm √3/2 stays, as in the paper.",
}


@dataclass(frozen=True)
class Displayed:
    """One formula under the name of its file."""

    name: str
    section: str
    equation: Equation | Relation

    @property
    def words(self) -> str:
        """One line of words, with the family's index where a limb's number stood."""
        return re.sub(r"\b([a-z])i\b", r"\1_i", self.equation.words)

    @property
    def note(self) -> str:
        """What the reader should know besides, or ""."""
        return NOTES.get(self.name, "")


def displayed() -> list[Displayed]:
    """Every formula, in the order of the paper."""
    parts = {"II": _topology(), "III": _displacement(), "IV": _velocity(), "V": _singularity()}
    return [
        Displayed(name, section, equation)
        for section, entries in parts.items()
        for name, equation in entries
    ]


def known_components() -> dict[Symbol, Expr]:
    """The components of i, j, k and of the operator of polarity: component forms put them in."""
    known: list[Equation | Relation] = [*_pick(topology.constants(), "i", "j", "k")]
    known.append(relations.polarity()[1])
    values: dict[Symbol, Expr] = {}
    for equation in known:
        values |= bindings(equation.symbol, components(equation.expression))
    return values


def family_name(name: str) -> str:
    """The name that stands for all limbs: ``e1``, ``e2``, ``e3`` are ``ei``."""
    joint = re.fullmatch(r"(screw|rate)[123](\d)", name)
    if joint:
        return f"{joint[1]}i{joint[2]}"
    return name if name.startswith("screw") else re.sub(r"(?<=[A-Za-z])[123]$", "i", name)


Entry = tuple[str, Equation | Relation]


def _topology() -> Iterator[Entry]:
    constants = topology.constants()
    for name in "ijk":
        yield f"base_{name}", _pick(constants, name)[0]
    yield from _named(_pick(constants, "u1", "u2", "u3"))
    yield from _named(_families(_pick(constants, "t1")))
    yield from _named([topology.base_joint("i"), *topology.platform_directions()])
    yield relations.platform_symmetry()


def _displacement() -> Iterator[Entry]:
    limb = displacement.limb_inverse("i")
    geometry = displacement.limb_geometry("i")
    yield from _named([displacement.central_direction()])
    yield from _named(_pick(displacement.central_forward(), "c"))
    yield relations.base_revolute()
    yield from _named(_pick(limb, "hi", "pi", "ei", "bi", "gti", "gzi", "li"))
    yield relations.leg_length()
    yield from _closure()
    yield relations.line_normal()
    yield from _named(_pick(geometry, "ngi", "deltai", "di"))
    yield from _named(orientation.directions_graph())
    yield from _named(orientation.defect_graph())
    yield "R_rpy", _pick(orientation.from_angles_graph(), "R")[0]
    yield from _named(orientation.to_angles_graph())
    yield from _named([*_pick(limb, "qi"), *displacement.central_inverse()])
    yield from _one_unknown()
    yield from _two_unknowns()
    yield from _newton()


def _closure() -> Iterator[Entry]:
    cone = closure.cone("i")
    for equation in [*_pick(closure.closure_graph(), "n3"), *_pick(cone, "gti", "gzi")]:
        yield f"closure_{_file_name(equation)}", equation
    yield from _named(_pick(cone, "Fi", "dFi"))
    yield from _named([*closure.unit_conditions(), *closure.system()])
    yield from _named([*_pick(closure.forms("i"), "hti", "hzi", "hpi"), closure.form_matrix("i")])


def _one_unknown() -> Iterator[Entry]:
    yield from _named(eliminant.first_limb())
    yield from _named(eliminant.quartic("i", scalar("side")))
    yield from _named([*eliminant.bezoutian(), *eliminant.null_vectors()[:2]])
    yield "turned_n_2", _pick(eliminant.turn_graph(), "n2")[0]


def _two_unknowns() -> Iterator[Entry]:
    yield from _named(circles.circle("i", circles.HALVES[0]))
    yield from _named([*circles.own_products("i"), *circles.mixed_products()])
    yield from _named([*circles.conditions(), circles.arm("i", circles.HALVES[0])])


def _newton() -> Iterator[Entry]:
    rotations = _pick(correction.gradients(), "volume"), _pick(correction.residuals(), "G")
    yield from _named([correction.turned("i"), *itertools.chain(*rotations)])
    yield from _named([*correction.newton(), *correction.lever("i", "j", "k")])
    yield from _named(_pick(correction.fold(), "dvolume"))
    yield from _named([*correction.central_slopes(), correction.position_slope("i")])
    yield from _named(_pick(correction.by_joints(), "qF"))
    yield from _named(_pick(leg_step.first_leg(), "span", "tangent", "by_angle", "side_part"))
    yield "leg_n_2", _pick(leg_step.first_leg(), "n2")[0]
    yield from _named(_pick(leg_step.slopes("i"), "Fti", "Fpi"))
    steps = leg_step.steps()
    yield from _named(_pick(steps, "det_leg", "dtheta", "dphi", "half_step", "next_leg"))
    after = ("next_guess", "next_arm", "next_span", "next_n1", "next_side", "next_n2")
    yield from _named(_pick(steps, *after))


def _velocity() -> Iterator[Entry]:
    yield from _named(motion.central_screws())
    yield from _named(_pick(displacement.limb_geometry("i"), "wi"))
    yield from _named(motion.outer_screws("i"))
    yield relations.klein_form()
    lines = motion.reciprocal_line("i")
    yield from _named(_pick(lines, "taui", "sigmai", "rhoi", "si", "soi", "Si"))
    yield relations.limb_velocity()
    yield from _named(_pick(lines, "limbi"))
    yield relations.central_velocity()
    yield relations.input_output()
    yield relations.polarity()
    yield from _named(motion.jacobians())
    twist = {Screw(rates.omega, rates.velocity): relations.TWIST}
    passive = [*joint_rates.outer_rates("i"), *joint_rates.central_rates()]
    for equation in [*_limb_first(rates.inverse_rates()), *passive]:
        yield (
            _file_name(equation),
            replace(equation, expression=equation.expression.xreplace(twist)),
        )
    yield from _named(_limb_first(rates.forward_twist()))
    yield from _named([*statics.exerted_wrench(), *statics.line_load("i", "j", "k")])
    forces = statics.required_forces()
    yield from _named(_limb_first(_pick(forces, "force1", "central_force")))
    yield from _named(_pick(forces, "force4", "force5", "force6", "forces"))
    change = {Screw(accelerations.angular, accelerations.linear): relations.TWIST_RATE}
    yield from _named(accelerations.biases("i"))
    for equation in _limb_first(accelerations.inverse_accelerations()):
        if not equation.name.startswith(("de", "db", "bias")):
            expression = equation.expression.xreplace(change)
            yield _file_name(equation), replace(equation, expression=expression)
    for equation in _limb_first(accelerations.forward_accelerations()):
        if not equation.name.startswith(("de", "db", "bias")):
            yield _file_name(equation), equation
    yield relations.lie_product()
    yield relations.reduced_acceleration()
    yield relations.limb_acceleration()


def _singularity() -> Iterator[Entry]:
    yield from _named(singular.inverse_condition())
    yield from _named([*singular.factors(), *singular.determinants()])
    yield from _named(_limb_first(singular.scales()))
    yield from _named([*loci.affine_parts("i"), *loci.cubic()])
    yield from _named([*loci.limb_slopes("i"), *loci.slopes()])


def _named(equations: Iterable[Equation]) -> Iterator[Entry]:
    for equation in equations:
        yield _file_name(equation), equation


def _file_name(equation: Equation) -> str:
    """``e_i`` for the symbol ``ei``, ``screw_41`` for ``screw41``, ``rate_4`` for ``dq4``."""
    name = equation.name
    if name in FILE_NAMES:
        return FILE_NAMES[name]
    indexed = r"(screw|rate)([1-4i][1-6])|([A-Za-z_]+?)([1-6i])"
    match = re.fullmatch(indexed, name)
    if match is None:
        return name
    stem, index = filter(None, match.groups())
    return f"{STEMS.get(stem, stem)}_{index}"


def _pick(equations: Iterable[Equation], *names: str) -> list[Equation]:
    """The equations of these names, in this order."""
    found = {equation.name: equation for equation in equations}
    return [found[name] for name in names]


def _limb_first(equations: Iterable[Equation]) -> list[Equation]:
    """Equations of limb 1 as those of the family, those of limbs 2 and 3 left out."""
    kept = []
    for equation in equations:
        if family_name(equation.name) == equation.name:
            kept.append(equation)
        elif equation.name.endswith("1"):
            kept += _families([equation])
    return kept


def _families(equations: Iterable[Equation]) -> list[Equation]:
    """Equations of limb 1 with the index i."""
    return [
        replace(
            equation,
            symbol=_renamed(equation.symbol),
            expression=_with_index(equation.expression),
            computed_as=equation.computed_as and _with_index(equation.computed_as),
            words=re.sub(r"(?<=[A-Za-z_ ])1\b", "i", equation.words),
        )
        for equation in equations
    ]


def _with_index(expression: Basic) -> Basic:
    return expression.xreplace({symbol: _renamed(symbol) for symbol in expression.free_symbols})


def _renamed(symbol: Symbol | MatrixSymbol) -> Symbol | MatrixSymbol:
    name = family_name(symbol.name)
    return scalar(name) if isinstance(symbol, Symbol) else MatrixSymbol(name, *symbol.shape)
