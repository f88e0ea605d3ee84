"""A scene's flow program, joined of the fragments in `generated.flow` that its effects and friction law call for.

What is nothing (a frozen mass does not turn, a constant does not change) is left out with all that it is a factor of.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.flow import FRAGMENTS, INPUTS, QUANTITIES
from generated.layout import CELLS, TABLE
from slipcircle.core.flow.link import ZERO, Linker, Operation, needed, places

Floats = NDArray[np.float64]
Log = list[tuple[int, float, float, float]]  # events: kind, time, rotation, direction


class Samples(NamedTuple):
    """States at given times, filled while the lanes walk: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


@dataclass(frozen=True)
class Table:
    """A piecewise function as a program knows it: what of, the register of its argument (or, of time, of its
    increment), the first of its cells, and the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


class Tangent(NamedTuple):
    """What a direction adds to a program: cells and registers of derivatives, by those that they are derivatives of."""

    cells: Mapping[int, int]
    registers: Mapping[int, int]


@dataclass(frozen=True, eq=False)
class Program:
    """Cells and registers by name, operations on cells and on series by their indices, and who plays which role.

    The first ``given`` cells are a lane's own at its start, the first ``lasting`` hold a lane on its way; beyond are
    ``constants``, by name, and what a prologue needs while it runs.
    ``states`` are (cell, register, register of the rate); the tangents of all states follow, direction by direction.
    """

    cells: tuple[str, ...]
    given: int
    lasting: int
    registers: tuple[str, ...]
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    constants: Mapping[str, float]
    tangents: tuple[Tangent, ...] = ()

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Where the cells are, by name."""
        return {name: k for k, name in enumerate(self.cells)}

    @cached_property
    def autonomous(self) -> bool:
        """Whether d(omega)/dt depends on omega alone between breaks in time: frozen geometry, friction without slip."""
        arguments = set[int]()
        for kind, *names in self.series:
            if kind != "ramp":
                arguments |= {r for _, r in names[2]} if kind == "lin" else {*names[1:]}
        return len(self.states) == 2 and self.roles["x"] not in arguments

    def blank(self, lanes: int) -> NDArray[np.float64]:
        """Cells of lanes of which nothing is known but the constants; memory that nobody writes to is not taken."""
        found = np.zeros((len(self.cells), lanes))
        for name, value in self.constants.items():
            found[self.places[name]] = value
        return found


# Cells that the walk reads, by role: what drives and the size of its terms, what presses, and the weight's components.
OUTPUTS = {
    "cell_drive": "drive",
    "cell_drive_scale": "drive_scale",
    "cell_normal0": "normal_0",
    "cell_f0": "fall_0",
    "cell_p0": "press_0",
    "cell_ps0": "press_slope_0",
    "cell_driving": "driving_0",
    "cell_resisting": "resisting_0",
    "cell_mu": "mu_0",
    "cell_limit": "limit",
}
ROLES = ("net", "normal", "upright")  # registers that the walk reads


def _load(link: Linker, name: str, sums: dict[str, list[Any]], friction: str = "mu") -> None:
    """Take a fragment's definitions; the quantity of a law may be one of two friction coefficients."""
    fragment = FRAGMENTS[name]
    link.define(fragment.scalar, fragment.series)
    for quantity, added in fragment.adds.items():
        sums.setdefault(friction if quantity == "mu" else quantity, []).append(added)


def _powers(degree: int) -> list[str]:
    """The cells of a piece's coefficients beyond its value."""
    return [f"Q{k}" for k in range(1, degree + 1)]


@lru_cache(maxsize=256)
def join(
    effects: tuple[str, ...],
    laws: tuple[str, ...],
    moving: tuple[str, ...] = (),
    absent: tuple[str, ...] = (),
    asked: tuple[str, ...] = (),
    directions: int = 0,
) -> Program:
    """The program of a scene.

    Parameters
    ----------
    effects : tuple of str
        Names, as in `generated.effects.EFFECTS`.
    laws : tuple of str
        The friction law, as in `generated.effects.LAWS` or "callable", and the law of speed that multiplies it, if any.
    moving : tuple of str
        Symbols of parameters that are functions of time, or of the rotation.
    absent : tuple of str
        Symbols of optional parameters that are not given, and left out.
    asked : tuple of str
        What else to compute: registers, such as ``mu``, ``pressing`` or ``friction``, and "energy", which stands for
        the states ``work`` and ``dissipation``.
    directions : int
        How many derivatives the program carries along: `Program.tangents`.

    Returns
    -------
    Program
    """
    link, sums, tables = Linker(), dict[str, list[Any]](), list[tuple[str, str, str, int]]()
    for name in ("gravity", *effects):
        _load(link, name, sums)
        for table in FRAGMENTS[name].tables:
            tables += [table] if table[0] in moving else []
            own = (table[0], *(f"{table[0]}.{x}" for x in _powers(table[3])))
            link.cells |= {} if table[0] in moving else dict.fromkeys(own, ("set", ZERO))
    turned = {name for name, _, _, _ in tables}
    for slot, name in enumerate(laws):
        _load(link, name, sums, "mu" if len(laws) == 1 else ("slip_mu", "rate_mu")[slot])
        tables += FRAGMENTS[name].tables
    if len(laws) > 1:
        _load(link, "product", sums)
    for name in ("balance", *(x for x in asked if x in FRAGMENTS)):
        _load(link, name, sums)
    for symbol in moving:
        link.cells[symbol] = ("set", f"{symbol}.VALUE")
        tables += [] if symbol in turned else [(symbol, "time", f"d{symbol}", 0)]
    for name, kind, register, _ in tables:
        if kind == "time":
            link.registers[register] = ("ramp", register, name)
    link.cells |= dict.fromkeys(absent, ("set", ZERO)) | {
        f"LIMIT'{j}": ("set", f"limit_0'{j}") for j in range(directions)
    }
    chosen = ("gravity", *effects, *laws, *(x for x in asked if x in FRAGMENTS))
    for quantity in (*QUANTITIES, "mu", *(("slip_mu", "rate_mu") if len(laws) > 1 else ())):
        for part, which in (("_0", 0), ("_size", 1)):
            total = ZERO
            for i, added in enumerate(sums.get(quantity, ())):
                link.cells[f"{quantity}{part}.{i}"] = ("add", total, added[which])
                total = f"{quantity}{part}.{i}"
            link.cells[f"{quantity}{part}"] = ("set", total)
        terms = tuple(term for added in sums.get(quantity, ()) for term in added[2])
        link.registers[f"d{quantity}"] = ("lin", f"d{quantity}", "", terms)
    given = [*INPUTS, *(x for name in chosen for x in FRAGMENTS[name].inputs if x not in link.cells)]
    rates = {"x": "omega", "omega": "net"} | {s: r for name in chosen for s, r in FRAGMENTS[name].states}
    return _linked(link, given, rates, tables, [x for x in asked if x not in FRAGMENTS], directions)


def _linked(
    link: Linker,
    given: list[str],
    rates: dict[str, str],
    tables: list[tuple[str, str, str, int]],
    asked: list[str],
    directions: int,
) -> Program:
    """Names to indices: from what is wanted back to what it takes."""
    own = [f"{t}.{x}" for t, _, _, d in tables for x in (*TABLE[:-1], *_powers(d))]
    varied = [*rates, "ROTATION", "SLIP", *given, *(x for x in own if x.rpartition(".")[2][0] in "VQ")]
    primes = [f"'{j}" for j in range(directions)]
    fixed = [*dict.fromkeys((*CELLS, *rates, *given, *own, *(x + prime for prime in primes for x in varied)))]
    read = [*rates, *rates.values(), *ROLES, *(a for _, _, a, _ in tables)]
    rates |= {s + prime: r + prime for prime in primes for s, r in rates.items()}
    roots = [*dict.fromkeys((*read, *asked, *(x + prime for prime in primes for x in read)))]
    link.known |= {x: x for x in fixed}
    link.made |= {x: x for x in rates}
    # The limit friction given is that of the start, until something has changed of what it depends on.
    of = link.origins(("driving_0", "resisting_0", "normal_0"))
    later = "TIME" if of & {*rates, *own} else "SLIP" if "SLIP" in of else "ROTATION" if "ROTATION" in of else ZERO
    link.cells["departed"] = ("abs" if later == "ROTATION" else "set", later)
    link.keep(roots)
    made = {x: link.register(x) for x in roots}
    still = {d[0] for op, d in link.series.items() if op[0] == "lin" and not op[2]}  # as where the phase began
    made |= {x: None for x in ROLES[1:] if made[x] in still and x not in asked}
    made |= {
        x: link.series.setdefault(("lin", ZERO, ()), (x,))[0] for x in (*rates.values(), *asked) if made[x] is None
    }
    outputs = {name: link.cell(name) for name in (*OUTPUTS.values(), *(f"drive{prime}" for prime in primes))}
    series = needed(link.series.items(), {x for x in made.values() if x} | {*rates})
    lasting = {x for op, _ in series for x in ((op[1], *(c for c, _ in op[2])) if op[0] == "lin" else op[1:])}
    lasting |= {*outputs.values()}
    scalar = needed(((op, (d,)) for op, d in link.scalar.items()), lasting)
    held = [*fixed, *(d for _, (d,) in scalar if d in lasting)]
    numbers = sorted({x for op, _ in scalar for x in op[1:] if x[0] == "="} | {x for x in lasting if x[0] == "="})
    place = places(scalar, [*held, *numbers])
    cells = [*held, *numbers, *(f"scratch{i}" for i in range(max(place.values()) + 1 - len(held) - len(numbers)))]
    registers = [*rates, *(x for _, results in series for x in results)]
    at = {x: i for i, x in enumerate(registers)}
    order = {register: i for i, (_, _, register, _) in enumerate(tables)}

    def indexed(op: Operation, results: tuple[str, ...]) -> tuple[Any, ...]:
        kind, *names = op
        made = [at[x] for x in results]
        if kind == "lin":
            terms = tuple((place[c], at[r]) for c, r in names[1])
            return (kind, *made, -1 if names[0] == ZERO else place[names[0]], terms)
        if kind == "ramp":
            return (kind, *made, order[names[0].partition("'")[0]])
        return (kind, *made, *(at[x] if x in at else place[x] for x in names))

    def tangent(prime: str) -> Tangent:
        registers = {at[str(made[x])]: at[str(made[x + prime])] for x in read if made[x] and made[x + prime]}
        return Tangent(
            {place[x]: place[x + prime] for x in varied} | {place[outputs["drive"]]: place[outputs[f"drive{prime}"]]},
            registers,
        )

    roles = {x: at[x] for x in ("x", "omega")} | {x: at.get(str(made[x]), -1) for x in (*ROLES, *asked)}
    return Program(
        cells=tuple(cells),
        given=len(fixed),
        lasting=len(held),
        registers=tuple(registers),
        scalar=tuple((op[0], place[d], *(place[x] for x in op[1:])) for op, (d,) in scalar),
        series=tuple(indexed(op, results) for op, results in series),
        states=tuple((place[s], at[s], at[str(made[rate])]) for s, rate in rates.items()),
        tables=tuple(Table(t, kind, at[str(made[a])], place[f"{t}.PIECE"], d) for t, kind, a, d in tables),
        roles=roles | {role: place[outputs[name]] for role, name in OUTPUTS.items()},
        constants={x: float(x[1:]) for x in numbers},
        tangents=tuple(map(tangent, primes)),
    )
