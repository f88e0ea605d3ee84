"""Panels for linear equations and the quadrature on them, against closed forms."""

import math
from typing import Any

import numpy as np
import pytest
from slipcircle.methods.chebyshev import quadrature, resolve
from slipcircle.methods.collocation import MEAN, RESOLVED, Z, joined, over_panels, propose, series_at, solved

Floats = Any


def linear(right: list[float], matrix: list[list[float]]) -> Any:
    """The equation y' = right - matrix y with constant coefficients."""

    def equation(x: Floats) -> tuple[Floats, Floats]:
        return np.multiply.outer(np.array(right), np.ones_like(x)), np.multiply.outer(np.array(matrix), np.ones_like(x))

    return equation


@pytest.mark.parametrize("brake", [0.0, 1e-9, 1.0, 5.0])
def test_a_brake_that_does_not_change(brake: float) -> None:
    # y = (1 - exp(-brake x))/brake, from zero without losing digits.
    panels = solved(*propose(linear([1.0], [[brake]]), np.array([0.0, 0.1, 0.3, 0.7]), 0.0, 0.0), np.zeros(1))
    assert (panels.missing <= RESOLVED).all()
    energy, at = (
        over_panels(panels.edges, panels.values[:-1, 0], panels.means[:, 0].T),
        np.array([1e-12, 0.05, 0.3, 0.7]),
    )
    exact = -np.expm1(-brake * at) / brake if brake else at
    np.testing.assert_allclose(energy(at), exact, rtol=1e-14)
    k, past, rate = series_at(panels.edges, panels.rates[:, 0])(0.2)
    assert (k, past) == (1, 0.2 - 0.1)
    assert rate == pytest.approx(math.exp(-brake * 0.2), rel=1e-13)


def test_two_equations_at_once() -> None:
    # y1' = 1 - 2 y2, y2' = 2 y1: circles about (0, 1/2).
    equation = linear([1.0, 0.0], [[0.0, 2.0], [-2.0, 0.0]])
    one = solved(*propose(equation, np.array([0.0, 0.2, 0.4]), 0.0, 0.0), np.zeros(2))
    two = solved(*propose(equation, np.array([0.4, 0.5]), 0.0, 0.0), one.values[-1])
    panels = joined([one, two])
    assert panels.edges.tolist() == [0.0, 0.2, 0.4, 0.5]
    np.testing.assert_allclose(panels.values[:, 0], np.sin(2 * panels.edges) / 2, atol=1e-15)
    np.testing.assert_allclose(panels.values[:, 1], np.sin(panels.edges) ** 2, atol=1e-15)


def test_panels_end_where_nothing_is_left() -> None:
    panels = solved(*propose(linear([-1.0], [[0.0]]), np.array([0.0, 0.5, 1.5, 3.0]), 0.0, 0.0), np.ones(1))
    assert panels.edges.tolist() == [0.0, 0.5, 1.5]
    np.testing.assert_allclose(panels.values[:, 0], [1.0, 0.5, -0.5], rtol=1e-14)


@pytest.mark.parametrize("width", [0.3, 0.01])
def test_a_sharp_change_is_proposed_smaller_panels(width: float) -> None:
    def equation(x: Floats) -> tuple[Floats, Floats]:
        return np.tanh((x - 0.3) / width)[None], np.zeros((1, 1, *x.shape))

    panels = solved(*propose(equation, np.array([0.0, 0.2, 0.6, 1.4]), 0.0, 0.0), np.ones(1))
    assert (panels.missing <= 10 * RESOLVED).all()
    primitive = width * (np.logaddexp((panels.edges - 0.3) / width, (0.3 - panels.edges) / width))
    np.testing.assert_allclose(panels.values[:, 0], 1.0 + primitive - primitive[0], rtol=3e-14)


def test_rounding_is_no_reason_for_smaller_panels() -> None:
    def equation(x: Floats) -> tuple[Floats, Floats]:  # a small difference of large terms
        return ((1.0 + 1e-9 * x) - 1.0)[None], np.zeros((1, 1, *x.shape))

    assert len(propose(equation, np.array([0.0, 1.0]), 0.0, 0.0)[0]) == 2
    assert len(propose(equation, np.array([0.0, 1.0, 2.0]), 1.0, 0.0)[0]) == 3


@pytest.mark.parametrize("near", [1e-6, 1e-3, 1.0])
def test_quadrature_against_a_closed_form(near: float) -> None:
    # The integral of (near + x)**-0.5: a root close to the first panel.
    edges = np.array([0.0, 0.25, 1.0])
    whole, part, missing = quadrature(lambda x: 1.0 / np.sqrt(near + x), edges, 0.25)
    for found, end in ((whole, 1.0), (part, 0.25)):
        exact = 2 * end / (math.sqrt(near + end) + math.sqrt(near))
        assert abs(found - exact) <= missing + 1e-15 * exact
    assert missing < 1e-13


def test_what_quadrature_does_not_resolve_it_does_not_pass_off() -> None:
    assert quadrature(lambda x: 2.0 + np.sign(x - 0.4), np.array([0.0, 1.0]), 1.0)[2] == math.inf


def test_a_series_of_a_constant_has_no_other_terms() -> None:
    found = resolve(np.ones_like, np.array([0.0, 1.0]), 4e-15).coefficients[:, 0]
    assert found[0] == 1.0
    assert np.abs(found[1:]).max() < 2e-16
    np.testing.assert_allclose(MEAN @ Z, Z / 2, atol=2e-16)
