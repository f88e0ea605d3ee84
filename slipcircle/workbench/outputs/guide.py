"""Reference of the scene file as text: every table, law and effect with its formula, keys, bounds and equation."""

import textwrap
from collections.abc import Iterator
from itertools import chain

from generated.effects import EFFECTS, LAWS, Effect, Law
from slipcircle.tree import path_of_part
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.files.keys import EFFECT_TABLES, FRICTION, TOP, WITH_ARC, KeyTable
from slipcircle.workbench.files.slopekeys import LOADS, SLOPING, WITH_LAYERS
from slipcircle.workbench.stability.stability import METHODS

WIDTH = 100
INDENT = 28
HEAD = """\
A scene is a TOML file. A key ends in the unit of its number: _deg, _m, _kPa, _kN_m3, ... [arc] and
[friction] are needed. Adding a table, even an empty one, enables its effect; an effect without a
table is not computed and costs nothing. In place of [arc], [ground] and [circle] describe a real
slope, [water] its water level, [soils.NAME] and [[layers]] its soils, then without [friction],
[cohesion] and [pore_pressure]. Vaiont has an [arc], as no citable profile is available.

Other units are accepted in place of the one at the end of a key: _ft, _in, _us_ft, _cm and _mm for
_m (also in _m_s, _m_s2 and _per_m_kPa), _psf, _ksf, _psi, _Pa and _MPa for _kPa, _pcf for _kN_m3:
radius_ft, speed_ft_s, cohesion_per_ft_psf. A table has one unit for each quantity. points_file of
[ground], level_file of [water] and top_file of [[layers]] name a file of points, relative to the
scene file: a spreadsheet (CSV) with columns x and y, "section.csv", or the lines on a layer of a
drawing (DXF), "section.dxf#GROUND". Its unit is in its header, or in points_file_unit = "ft", ...

The dimensionless balance of momentum (times over sqrt(R/g), stresses over sigma_ref = unit weight
R (1 - cos alpha); numbers in brackets are equations and figures of the paper):

  Theta domega/dt = J_theta - sign(omega) (resistance + lambda mu sigma'),
  sigma' = max(0, sigma - u);  without effects: sigma = J_r/lambda, u = resistance = 0

alpha is half the opening angle, psi the dip of the chord, Theta the moment of inertia, J_r the
radial weight and J_theta the moment of the weight; A and lambda are (2.24) and (3.14). An effect
adds to these; notebooks/0_the_method.ipynb derives them.
"""

# Comparison of the methods for factors of safety.
COMPARED = """\
The factor is the moment of this strength about the centre, divided by the moment of the weight and of k_h times it \
at half the height of the slices. The three agree for mu = 0, and nearly for flat arcs. On the circle of real-slope \
they are 0.942, 0.950 and 0.985; with r_u = 0.5, on the circle that is then critical, 0.431, 0.443 and 0.499. The \
paper's factor is the lowest, by 4 % and by 14 % of Bishop's, which assumes more normal stress on steep bases. The \
motion starts from the factor by the method of the search, or by start in [circle]: strength is multiplied by \
one number, which is constant during the motion; a Scene built by hand has 1. Below a water level the \
paper's factor is least on circles close to half discs, where Bishop's is two to three times as high: minimise \
Bishop's, or give a base. An [arc] has the paper's factor only, as its ground is not known. A pressure in kPa is \
uniform along the arc.

Near the top of steep slopes, and under high water pressure, the effective normal stress of slices is negative by \
Bishop's and by the ordinary method, and friction acts against stability. The share of such arc is printed, with a \
warning from 20 % on. Compared with Taylor's friction circles on vertical cuts with friction, Bishop's least factor is \
accurate to 1 % for a share below 14 %, and 2 % too low at 25 %, 5 % at 34 % and 9 % at 48 %; with those stresses set \
to 0 it would be 4 to 23 % too high. For mu = 0 the share has no meaning."""


def guide() -> str:
    """Return the reference of the scene file as text of at most 100 columns."""
    lines = [HEAD, "Above the first table", *_keys(TOP)]
    layered = {name: WITH_LAYERS.tables[name] for name in ("soils", "layers", "slip")}
    of_forms = [WITH_ARC.tables, SLOPING, layered, LOADS]
    apart = {*EFFECTS, "friction"}
    for name, table in chain.from_iterable(tables.items() for tables in of_forms):
        if name not in apart:
            lines += _tables(name, table)
    lines += ["", *_title("factors of safety", f"of a circle of a slope, by three methods. {COMPARED}")]
    for method, (name, description) in METHODS.items():
        lines += _title(f"  {method}", f"{name}: {description}")
    lines += [
        "",
        *_title("[friction]", "mu on the slip surface, by the laws below; for layers in [soils.NAME.friction]"),
    ]
    for name, law in LAWS.items():
        lines += ["", *_title(f'  law = "{name}"', _with_source(law)), *_keys(FRICTION.laws[name])]
    lines += ["", *_title("[friction.rate]", "a rate law that multiplies the slip law, with the keys of the rate law")]
    for name, effect in EFFECTS.items():
        lines += ["", *_title(f"[{name}]", _with_source(effect))]
        lines += [INDENT * " " + formula for formula in effect.formulas]
        lines += _keys(EFFECT_TABLES[name])
        for of_law, table in EFFECT_TABLES[name].laws.items():
            lines += [*_title(f'  law = "{of_law}"', table.title), *_keys(table)]
    lines += ["", *_title("uncertain numbers", _of_uncertain_numbers())]
    return "\n".join(lines)


def _tables(path: str, table: KeyTable) -> Iterator[str]:
    """Yield the lines of a table and of the tables inside it."""
    if table.repeats == "named":
        path = f"{path}.NAME"
    head = f"[[{path}]]" if table.repeats == "numbered" else f"[{path}]"
    words = table.title
    if table.laws:
        like = "cohesion" if path.endswith("cohesion") else "friction"
        words += f": with the keys of [{like}]; law is {' or '.join(table.laws)}"
    yield ""
    yield from _title(head, words)
    yield from _keys(table)
    for name, inner in table.tables.items():
        yield from _tables(path_of_part(path, name), inner)


def _with_source(declared: Law | Effect) -> str:
    """Return the description of a law or an effect with its source in brackets."""
    if declared.source:
        return f"{declared.help} ({declared.source})"
    return declared.help


def _of_uncertain_numbers() -> str:
    """Return the syntax of an uncertain number and the list of distributions as text."""
    example = '{ distribution = "normal", mean = 10, std = 1 }'
    kinds = [f"{name} ({', '.join(kind.parameters)})" for name, kind in DISTRIBUTIONS.items()]
    return f"instead of a number: {example}, in the key's unit, for `slipcircle sweep`; {', '.join(kinds)}"


def _title(head: str, words: str) -> list[str]:
    """Return an entry as lines: a head, and words beside it that are wrapped to `WIDTH`."""
    return textwrap.wrap(words, WIDTH, initial_indent=f"{head:<{INDENT - 2}}  ", subsequent_indent=" " * INDENT)


def _keys(table: KeyTable) -> Iterator[str]:
    """Yield lines for each key of a table; alternative keys share an entry if exactly one is required."""
    pairs = {pair[0]: pair[1] for pair in table.one_of}
    for k, key in table.keys.items():
        other = pairs.get(k)
        if other is not None:
            alternative = table.keys[other]
            words = f"{alternative.help}: {key.allowed} or {alternative.allowed}, needed"
            yield from _title(f"  {k} or {other}", words)
        elif k != "law" and k not in pairs.values():
            needed = ", needed" if not key.optional else ""
            yield from _title(f"  {k}", f"{key.help}: {key.allowed}{needed}")
    if table.any_of:
        yield f"{'':{INDENT}}needed: {' or '.join(table.any_of)}"
    if table.sets:
        yield from _title("", f"needed: {', or '.join(' with '.join(keys) for keys in table.sets)}")
