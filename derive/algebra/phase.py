"""The phase plane: E = omega**2 against the rotation x since the phase began, in closed form, stable, and proved.

While nothing depends on time, E obeys a linear equation per direction of motion, E' = 2 (drive - brake E). With
constant friction on a turning mass the drive at x is S cos x - B sin x - K, where a = S - K is the drive at x = 0,
B its slope by psi (`tilt`) and K the part that does not turn with the mass (`constant`); q = 2 brake.
"""

from dataclasses import dataclass

import sympy as sp

from derive.algebra.prove import prove_zero
from derive.algebra.remainders import Remainder, sine_defect, unfold

X = sp.Symbol("x", real=True)
DRIVE, TILT, CONSTANT, BRAKE, START = sp.symbols("drive tilt constant brake start", real=True)
# Exponential softening: mu = mu(0) - drop (1 - exp(-p x)), so that friction's fall adds to the drive
# drop (1 - exp(-p x)) (press cos x + press_rise sin x - water), press and its rise with x relieved by r_u.
DROP, DECAY, PRESS, PRESS_RISE, WATER = sp.symbols("drop decay press press_rise water", real=True)
_HALF_SINE = sp.sin(X / 2)


@dataclass(frozen=True)
class Energy:
    """A closed form of E(x): its name, the equation that it solves, and its stable form."""

    name: str
    right: sp.Expr  # E' = right - 2 brake E
    braked: bool
    form: sp.Expr
    help: str


def _forms() -> tuple[Energy, ...]:
    sine, defect = sp.sin(X), X**3 * sine_defect(X)
    lift = 2 * _HALF_SINE**2  # 1 - cos x
    q = 2 * BRAKE
    excess = (q * X) ** 2 * Remainder(sp.exp, 2, -q * X)  # exp(-qx) - 1 + qx
    decay = sp.exp(-q * X)
    over = 2 / (1 + q**2)
    turning = 2 * ((DRIVE + CONSTANT) * sp.cos(X) - TILT * sp.sin(X) - CONSTANT)
    plain = START + 2 * (DRIVE * sine - CONSTANT * defect - TILT * lift)
    braked = START * decay + over * (
        DRIVE * (sine + q * (q * X * Remainder(sp.exp, 1, -q * X) - lift))
        + CONSTANT * (q * X**2 * Remainder(sp.exp, 2, -q * X) - defect - q * lift)
        - TILT * (lift + excess - q * defect)
    )
    # Softening adds 2 drop int (1 - exp(-py)) (press cos y + press_slope sin y - water) dy.
    p, rest = DECAY, sp.exp(-DECAY * X)
    px = p * X
    gone = px * Remainder(sp.exp, 1, -px)  # 1 - exp(-px)
    beyond = px**2 * Remainder(sp.exp, 2, -px)  # px - (1 - exp(-px))
    with_cos = (p * beyond + sine * gone - p**2 * defect - p * rest * lift) / (1 + p**2)
    with_sin = (lift * (p**2 + gone) + beyond - px * gone - p * rest * defect) / (1 + p**2)
    softened = 2 * DROP * (PRESS * with_cos + PRESS_RISE * with_sin - WATER * px * X * Remainder(sp.exp, 2, -px))
    adds = 2 * DROP * (1 - sp.exp(-p * X)) * (PRESS * sp.cos(X) + PRESS_RISE * sp.sin(X) - WATER)
    return (
        Energy("energy", turning, False, plain, "constant friction, nothing that grows with the speed"),
        Energy("energy_braked", turning, True, braked, "constant friction, centripetal stress or drag"),
        Energy("energy_softening", turning + adds, False, plain + softened, "exponential softening, no brake"),
    )


ENERGIES = _forms()


def prove_energies() -> list[str]:
    """Prove each closed form: it satisfies its equation, and starts at ``start``.

    Returns
    -------
    list of str
        The claims that were proved.
    """
    claims = []
    for energy in ENERGIES:
        exact = unfold(energy.form)
        braking = 2 * BRAKE * exact if energy.braked else 0
        claim = f"{energy.name}: E' = 2 (drive - brake E)"
        prove_zero((sp.diff(exact, X) + braking - energy.right).rewrite(sp.exp).expand(), claim)
        prove_zero(sp.limit(exact, X, 0) - START, f"{energy.name}: E(0) = start")
        claims += [claim, f"{energy.name}: E(0) = start"]
    return claims
