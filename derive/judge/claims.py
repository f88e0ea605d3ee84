"""Claims of the paper: their fields, causes of failure, and verdicts with their rules."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import mpmath as mp
from sympy import Expr, oo, pi

from derive.algebra.appendices import Appendix
from derive.kinds import Names, TextPair

VERDICTS = {
    "holds": "the form equals the form derived from what precedes it, or every value lies in the claimed range",
    "holds to the printed digits": "the value agrees with the printed number after rounding or truncation",
    "definition": "introduces a quantity; its dimension is consistent and it is used consistently",
    "imprecise": "true, but not sharp, for another reason, without its range, or in contradictory notation",
    "misprint": "a single edit of the text makes it hold; print and scan cannot be told apart",
    "wrong": "contradicts what precedes it",
    "assumption": "does not follow from what precedes it; a counterexample is given",
    "not machine-checkable": "depends on information that the text does not contain",
}

# Units of symbols in definitions; the others are numbers.
UNITS = {
    "R": "m", "r": "m", "ell": "m", "g": "m/s^2", "rho": "kg/m^3", "dV": "m^3", "t": "s", "c0": "1/s", "c2": "1/s",
    "omega": "1/s", "sigma_mean": "Pa", "sigma_n": "Pa", "tau_n": "Pa",
}  # fmt: skip

# Domains of the claimed forms: open intervals, or one value. Other symbols are real and positive.
DOMAINS = {"alpha": (0, pi / 2), "omega": (0, oo), "a": (0, oo), "b": (0, oo), "omega_0": (0, 0)}


@dataclass(frozen=True)
class Cause:
    """Cause of a failed claim, and the verdict if the cause is demonstrated.

    For a number, ``value`` computes the presumed evaluation of the paper, which must give the printed digits. For a
    form, ``edit`` is a replacement in the transcription, after which the form must be correct.
    """

    words: str
    verdict: Literal["imprecise", "misprint", "wrong"]
    value: Callable[[], mp.mpf] | None = None
    edit: TextPair = ("", "")


@dataclass(frozen=True)
class Claim:
    """Claim of the paper.

    ``expression`` transcribes ``printed``, and ``definition`` derives the form that it must equal. ``law`` is a further
    requirement, as are the ``unit`` of a quantity that the claim defines and the ``weight``, the integrand whose
    quadrature the form must equal on its whole domain. Assumptions are data: ``domain`` if it differs from `DOMAINS`,
    and ``given``.
    """

    id: str
    claim: str
    printed: str
    expression: str = ""
    definition: Callable[[], Any] = lambda: ()
    kind: Literal["form", "number", "range", "small", "appendix"] = "form"
    causes: tuple[Cause, ...] = ()
    shows: str = "{}"  # format of the derived value
    remark: str = ""  # if the claim is correct
    unit: str = ""
    law: Callable[[Expr], Iterable[Expr]] = lambda form: ()
    weight: Expr | None = None
    given: Names = ()
    domain: tuple[tuple[str, Any, Any], ...] = ()
    subject: Appendix | None = None

    @cached_property
    def derived(self) -> tuple[Any, ...]:
        """Forms or values that the transcription must equal."""
        forms = self.definition()
        return tuple(forms) if isinstance(forms, (tuple, list)) else (forms,)
