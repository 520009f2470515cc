"""Every claim reduces to exactly zero, and a wrong one is refused."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from dataclasses import replace

import pytest
from sympy import Float, pi, sqrt, symbols, sympify

import derivations.uncoupled
from derivations.algebra.equations import Graph
from derivations.algebra.identities import Identity, IdentityError, remainder, vanishes
from derivations.algebra.unfolding import covers, quaternion_rotation
from derivations.uncoupled.counterexamples import counterexamples
from derivations.uncoupled.identities import identities
from derivations.uncoupled.identities.facts import inverse_velocity, pose
from derivations.uncoupled.kernels import kernels

IDENTITIES = identities()
COUNTEREXAMPLES = counterexamples()
X, Y, Z = symbols("x y z", real=True)
CIRCLE = (X**2 + Y**2 - 1,)


def named(claims):
    return pytest.mark.parametrize("claim", claims, ids=[claim.name for claim in claims])


def every_graph() -> list[Graph]:
    """The graphs of all kernels, and whatever else a module of the manipulator builds."""
    graphs = [kernel.graph for kernel in kernels()]
    for module in pkgutil.iter_modules(derivations.uncoupled.__path__):
        members = vars(importlib.import_module(f"derivations.uncoupled.{module.name}"))
        for name in sorted(members):
            if name.endswith("_graph") and inspect.isfunction(members[name]):
                graphs += [members[name]()]
    return graphs


@named(IDENTITIES)
def test_identity_is_exactly_zero(claim):
    assert claim.prove() > 0


@named(COUNTEREXAMPLES)
def test_counterexample_contradicts_the_claim(claim):
    facts = claim.check()
    assert facts
    for value in map(sympify, facts.values()):
        assert not value.has(Float)
        assert not value.free_symbols


def test_names_are_unique_and_claims_have_words():
    for claims in (IDENTITIES, COUNTEREXAMPLES):
        names = [claim.name for claim in claims]
        assert len(set(names)) == len(names)
        assert all(claim.claim and "\n" not in claim.claim for claim in claims)


def test_every_computed_form_is_proven():
    proven = {covers(identity) for identity in IDENTITIES}
    computed = {}
    for graph in every_graph():
        for equation in graph:
            if equation.computed_as is None:
                continue
            forms = (equation.expression, equation.computed_as)
            assert computed.setdefault(equation.name, forms) == forms, "two meanings of one name"
    assert len(computed) > 60
    assert sorted(set(computed) - proven) == []
    assert sorted(proven - set(computed) - {""}) == []


@pytest.mark.parametrize("name", ["tau1", "q2", "delta3", "S1", "J_q", "det_J_q", "dq2"])
def test_wrong_computed_form_is_refused(name, monkeypatch):
    graph = inverse_velocity() if name.startswith("dq") else pose()
    wrong = replace(graph[name], computed_as=2 * graph[name].computed_as)
    monkeypatch.setitem(graph.equations, name, wrong)
    (claim,) = (identity for identity in identities() if covers(identity) == name)
    with pytest.raises(IdentityError, match="not zero, this is left"):
        claim.prove()


@pytest.mark.parametrize("name", ["q1", "rho3"])
def test_computed_root_of_wrong_sign_is_refused(name, monkeypatch):
    wrong = replace(pose()[name], computed_as=-pose()[name].computed_as)
    monkeypatch.setitem(pose().equations, name, wrong)
    (claim,) = (identity for identity in identities() if covers(identity) == name)
    with pytest.raises(IdentityError, match="may be negative"):
        claim.prove()


def test_wrong_identity_is_refused():
    assert Identity(
        "right", "on the circle", lambda: [(X + Y) ** 2 - 1 - 2 * X * Y], CIRCLE
    ).prove()
    wrong = Identity("wrong", "off the circle", lambda: [X**2 + Y**2 - 2], CIRCLE)
    with pytest.raises(IdentityError, match="wrong: off the circle\nnot zero, this is left: -1"):
        wrong.prove()


def test_identity_needs_its_relation():
    without = Identity("any point", "no circle", lambda: [X**2 + Y**2 - 1])
    with pytest.raises(IdentityError, match="not zero"):
        without.prove()


def test_empty_identity_is_refused():
    with pytest.raises(IdentityError, match="nothing to prove"):
        Identity("empty", "says nothing", list).prove()


def test_relations_that_share_a_leading_symbol_are_refused():
    shared = Identity("shared", "two circles", lambda: [X - Y], (X**2 - 1, X * Y - 1))
    with pytest.raises(IdentityError, match="leading terms of the relations share x"):
        shared.prove()


@pytest.mark.parametrize("divisor", [X**2 + Y**2 - 1, (X**2 + Y**2 - 1) ** 2 * X])
def test_division_by_a_relation_is_refused(divisor):
    with pytest.raises(IdentityError, match="divides by zero"):
        remainder(Z / divisor, CIRCLE)


@pytest.mark.parametrize(
    ("expression", "relations"),
    [
        (sqrt(3) * X * sqrt(3) - 3 * X, ()),
        ((X / (1 + sqrt(3)) - X * (sqrt(3) - 1) / 2), ()),
        (sqrt(X**2 + Y) ** 3 / sqrt(X**2 + Y) - X**2 - Y, ()),
        (1 / (X + Y) + 1 / (X - Y) - 2 * X / (X**2 - Y**2), ()),
        ((X**2 + Y**2) / Z - 1 / Z, CIRCLE),
        (quaternion_rotation() - quaternion_rotation(), ()),
    ],
)
def test_exact_zero_is_recognised(expression, relations):
    assert vanishes(expression, relations)


@pytest.mark.parametrize(
    "expression", [sqrt(3) - sqrt(2), sqrt(X**2) - X, X / Y - Y / X, pi**2 - 9, X + 1e-30 - X]
)
def test_anything_else_is_not_zero(expression):
    assert not vanishes(expression)
