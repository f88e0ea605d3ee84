"""Claims of the paper: their fields, causes of failure, and verdicts with their rules."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Literal

import mpmath as mp
from sympy import Expr, oo, pi

from derive.algebra.appendices import Appendix

VERDICTS = {
    "holds": "the form is proved equal to what precedes it, or every value lies where the paper places it",
    "holds to the printed digits": "the value, rounded at the last printed place or cut off there, is the printed one",
    "definition": "names what nothing before it names; its dimension is right, and what follows uses it so",
    "imprecise": "true, but not sharp, or in a notation that contradicts itself",
    "misprint": "one edit of the text makes it hold; if print or scan slipped, the text cannot tell",
    "wrong": "differs from what precedes it",
    "assumption": "does not follow: a state is exhibited that keeps all postulates before it and breaks this one",
    "not machine-checkable": "needs what is not in the text",
}

DIMENSIONS = {
    "R": "L", "r": "L", "ell": "L", "g": "L/T**2", "rho": "M/L**3", "dV": "L**3", "t": "T", "c0": "1/T", "c2": "1/T",
    **dict.fromkeys(("sigma_mean", "sigma_n", "tau_n"), "M/(L*T**2)"),
}  # fmt: skip

# Domains of the claimed forms: open intervals, or one value. Other symbols are real and positive.
DOMAINS = {"alpha": (0, pi / 2), "omega": (0, oo), "a": (0, oo), "b": (0, oo), "omega_0": (0, 0)}


@dataclass(frozen=True)
class Cause:
    """A cause for a claim to fail, and the verdict if it is demonstrated.

    For a number ``value`` is what the paper must have evaluated: it has to give the printed digits. For a form
    ``edit`` is a replacement in the transcription: afterwards the form has to hold.
    """

    words: str
    verdict: Literal["imprecise", "misprint", "wrong"]
    value: Callable[[], mp.mpf] | None = None
    edit: tuple[str, str] = ("", "")


@dataclass(frozen=True)
class Claim:
    """One claim of the paper.

    ``expression`` transcribes ``printed``; ``definition`` derives what it must equal; ``dimension`` (of what names
    something) and ``law`` are what else it has to satisfy, and ``weight`` the integrand whose quadrature it has to
    equal on its whole domain. What it takes for granted is data: ``domain`` where not that of `DOMAINS`, and ``given``.
    """

    id: str
    claim: str
    printed: str
    expression: str = ""
    definition: Callable[[], Any] = lambda: ()
    kind: Literal["form", "definition", "number", "range", "appendix"] = "form"
    causes: tuple[Cause, ...] = ()
    shows: str = "{}"  # how the derived value is written
    note: str | Callable[[], str] = ""  # remark if it holds, or how it is computed
    dimension: str = ""
    law: Callable[[Expr], Iterable[Expr]] | None = None
    weight: Expr | None = None
    given: tuple[str, ...] = ()
    domain: tuple[tuple[str, Any, Any], ...] = ()
    subject: Appendix | None = None

    @property
    def remark(self) -> str:
        """The note, computed where it has numbers."""
        return self.note if isinstance(self.note, str) else self.note()
