"""Bugs planted on purpose, one at a time: each must turn a named check red, and the text without it must not."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import oracle
import pytest
import sympy as sp
import test_generated
import test_kernels
import test_motion_formulas

from derive.algebra import dynamics, integrate, rules
from derive.algebra.integrate import PSI, Derivation
from derive.check.proof import ProofError
from derive.declare import quantities
from derive.declare.quantities import MOMENTS
from derive.declare.symbols import a, alpha, omega_0, r
from generated import kernels

FOLDER = test_generated.FOLDER


def accurate(module: ModuleType, name: str) -> None:
    test_kernels.check_accuracy(getattr(module, name), name, 3)


def weighs_right(module: ModuleType, name: str) -> None:
    test_kernels.check_weight(getattr(module, name), test_kernels.amplitude(name), name)


def has_limits(module: ModuleType, name: str) -> None:
    test_kernels.check_landmarks(getattr(module, name), name)


def moves_right(module: ModuleType, name: str) -> None:
    test_motion_formulas.check_accuracy(getattr(module, name), name, 5)


def ends(module: ModuleType, name: str) -> None:
    test_motion_formulas.check_ended(getattr(module, name), name)


@dataclass(frozen=True)
class Bug:
    """What is changed in a function's text, private half or public, and the check that it turns red.

    A bug of every kernel is planted in the function of `_compiled` that is named, and seen in this one.
    """

    what: str
    function: str
    pattern: str
    replacement: str
    check: Callable[[ModuleType, str], None]
    of_all: str = ""

    @property
    def module(self) -> str:
        return "motion" if self.function.startswith("frozen") else "_compiled" if self.of_all else "kernels"


PIECES = r"xp\.where\((\w+) < (\S+), "
VELOCITY, ROTATION, ACCELERATION = test_motion_formulas.RIDE
domain = test_generated.check_domain
BUGS = (
    Bug("a sign", "moment_of_inertia", r"1\.5707963267948966 - alpha", "alpha - 1.5707963267948966", accurate),
    Bug("a coefficient's last digits", "weight_moment_amplitude", r"(0\.5833333)\d+", r"\1", accurate),
    Bug("a series cut short", "weight_moment_amplitude", r",\s+-?[\d.e-]+\)\)", "))", accurate),
    Bug("swapped branches", "radial_weight_amplitude", PIECES, r"xp.where(\1 >= \2, ", accurate),
    Bug("a seam out of place", "polar_moment", PIECES, r"xp.where(\1 < 1.4, ", accurate),
    Bug("2 alpha for alpha", "radial_weight_amplitude", r"alpha \* alpha", "2.0 * alpha * alpha", accurate),
    Bug("2 alpha for alpha, in a quotient", "dynamic_coefficient", r"alpha \* alpha", "2.0 * alpha * alpha", accurate),
    Bug("alpha not clipped at pi/2", "moment_of_inertia", r"np\.minimum\(.*\)\)", "alpha)", has_limits, "clipped"),
    Bug("negative alpha let in", "polar_moment", r"alpha >= 0\.0", "alpha >= -2.0", domain, "inside"),
    Bug("too large an alpha let in", "polar_moment", r"4\.0 \* eps", "64.0 * eps", domain, "inside"),
    Bug("theta_1 for theta_m, J_r", "radial_weight", r"np\.sin\(theta_m\)", "np.sin(theta_1)", weighs_right),
    Bug("theta_1 for theta_m, J_theta", "weight_moment", r"np\.cos\(theta_m\) -", "np.cos(theta_1) -", weighs_right),
    Bug("the sign of J_theta", "weight_moment", r"return (-?\()", r"return -\1", weighs_right),
    Bug("theta_m's rounding error lost", "weight_moment", r"0\.5 \* \(theta_1 - ", "0.0 * (theta_1 - ", weighs_right),
    Bug("a sign of b", VELOCITY, r"(t\d+ = b) \* omega_0", r"\1 * -omega_0", moves_right),
    Bug("swapped branches, a b t**2 = 1", ROTATION, r"(t\d+) = 1\.0 < z", r"\1 = 1.0 >= z", moves_right),
    Bug("a sign, omega_0**2", ACCELERATION, r"a - (\w+) \* omega_0", r"a + \1 * omega_0", moves_right),
    Bug("the pole overlooked", VELOCITY, r"(t\d+) = 0\.0 < np\.minimum\(y, .*\)$", r"\1 = 1e9 > y", ends),
    Bug("half the arrest", "frozen_arrest_rotation", r"-\(0\.5 \* ", "-(", moves_right),
    Bug("t for -t", "frozen_arrest_time", r"-\(", "(", moves_right),
)


def build(name: str, text: str) -> ModuleType:
    """A module of `generated` from its text; what it computes is that text, not a compiled loop."""
    module = ModuleType(f"planted_{name}")
    at_numpy = re.sub(r'(= kernel\("\w+", TEXTS\["\w+"\])\)', r'\1, "numpy")', text)
    exec(compile(at_numpy, f"<planted {name}>", "exec"), module.__dict__)
    return module


def built(bug: Bug, text: str) -> ModuleType:
    """The module in which the bug is to be seen."""
    module = build(bug.module, text)
    if bug.of_all:
        made = module.kernel(bug.function, kernels.TEXTS[bug.function], "numpy")
        setattr(module, bug.function, lambda alpha, /, out=None, *, where=True: made(alpha, out, where))
    return module


def plant(bug: Bug) -> str:
    """The module's text with the bug in the one function, body and domain."""
    text = (FOLDER / f"{bug.module}.py").read_text("utf-8")
    start = text.index(f"def _{bug.of_all or bug.function}(")
    end = text.find("\n\n\ndef _", start)
    before, own, after = text[:start], text[start:end], text[end:] if end != -1 else ""
    own = own if end != -1 else text[start:]
    changed, count = re.subn(bug.pattern, bug.replacement, own, flags=re.MULTILINE)
    assert count, f"{bug.what}: nothing to change in {bug.function}"
    return before + changed + after


@pytest.mark.parametrize("bug", BUGS, ids=lambda b: f"{b.what}, {b.function}")
def test_a_bug_in_the_text_turns_its_check_red(bug: Bug) -> None:
    right, wrong = (FOLDER / f"{bug.module}.py").read_text("utf-8"), plant(bug)
    bug.check(built(bug, right), bug.function)
    with pytest.raises((AssertionError, FloatingPointError, pytest.fail.Exception)):
        bug.check(built(bug, wrong), bug.function)


# --- before the text: the derivation -------------------------------------------------------------------------------


@pytest.mark.parametrize("name", oracle.BASE)
def test_a_wrong_stable_form_is_not_proved(name: str) -> None:
    closed = integrate.closed_forms()[name]
    right = rules.stable(closed).form
    rules.prove_equal(right, closed, name)
    for wrong in (-right, right.subs(alpha, 2 * alpha), right + alpha**2 / 10**6, right * sp.cos(alpha)):
        with pytest.raises(ProofError, match=name):
            rules.prove_equal(wrong, closed, name)


def test_a_wrong_antiderivative_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    right: Callable[..., Any] = sp.integrate
    monkeypatch.setattr(sp, "integrate", lambda e, x: right(e, x) + x)
    with pytest.raises(ProofError, match="antiderivative"):
        integrate.derive.__wrapped__(MOMENTS[0])


@pytest.mark.parametrize("moment", MOMENTS, ids=lambda m: m.name)
def test_a_wrong_closed_form_is_found_by_quadrature(moment: quantities.Moment) -> None:
    right = integrate.derive(moment)
    turned = {sp.Integer(1): sp.cos(PSI), sp.cos(PSI): sp.sin(PSI), sp.sin(PSI): sp.cos(PSI)}[right.direction]
    amplitude = right.amplitude
    wrongs: tuple[Derivation, ...] = (
        replace(right, amplitude=-amplitude),
        replace(right, amplitude=amplitude.subs(alpha, 2 * alpha)),  # as the paper's tables evaluate (2.24) and (3.15)
        replace(right, amplitude=amplitude * (1 + sp.Rational(1, 10**18))),
        replace(right, direction=turned),
        replace(right, moment=replace(moment, weight=moment.weight / r)),  # as its Appendix II integrates (3.13)
    )
    for wrong in wrongs:
        with pytest.raises(ProofError, match=moment.name):
            integrate.compare(wrong, 20)


@pytest.mark.parametrize("name", [f.name for f in dynamics.FORMS])
def test_a_wrong_motion_formula_is_not_proved(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A sign of a or of omega_0 in the result, and a factor."""
    (form,) = (f for f in dynamics.FORMS if f.name == name)
    swaps = [form.result.subs(x, -x) for x in (a, omega_0)] + [2 * form.result]
    for wrong in (replace(form, result=x) for x in swaps):
        if wrong == form:
            continue  # even in it
        monkeypatch.setattr(dynamics, "FORMS", tuple(wrong if f.name == name else f for f in dynamics.FORMS))
        with pytest.raises(ProofError):
            dynamics.prove_forms()
        monkeypatch.undo()
