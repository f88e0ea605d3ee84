"""Wrong declarations of laws, effects and moments: one line that says what is wrong, exit status 1, nothing written.

Each is what a user types at the end of a list. Right ones are used in `test_extending`.
"""

import hashlib
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import slipcircle
from derive import __main__ as command
from derive import guards
from derive.check.proof import ProofError
from derive.declare import effects, quantities
from derive.generate import write
from derive.judge.paper import CLAIMS
from slipcircle.__main__ import main
from tests.campaigns import all_weights

NUMBER = 'Parameter("n", "", "a number", "n")'
WIDTH = 'Parameter("width", "m", "a width", "width_m", lower=0.0)'


def law(coefficient: str, parameters: str = "_SOFTENING", name: str = "new", more: str = "") -> str:
    return f'Law("{name}", "help", {parameters}, {coefficient}{more})'


def effect(terms: str, parameter: str = "", name: str = "new", more: str = "") -> str:
    of = f'Parameter({parameter}, symbol=sp.Symbol("c_new", real=True))' if parameter else ""
    return f'Effect("{name}", "help", ({of}{"," * bool(of)}), {terms}{more})'


def moment(weight: str, name: str = "new", more: str = "") -> str:
    return f'Moment("{name}", "N", {weight}, "help"{more})'


SLIPS = 'Parameter("slip", "m", "slips", "slip_m", kind="list")'
SLIPS_IN_S = SLIPS.replace('"m"', '"s"').replace("slip_m", "slip_s")
COEFFICIENTS = '_friction("coefficient", "coefficients", "angle_deg", "list")'
FALLS = "_R + (_P - _R) * sp.exp(-SLIP / _L)"
C = 'sp.Symbol("c_new", real=True)'
SECOND = 'sp.Symbol("second", real=True)'
WITH_SECOND = '(*_SOFTENING, Parameter("second", "m", "a second slip", "second_m", lower=0.0))'
DROP = 'Parameter("drop", "", "peak less residual", "drop")'
OF_PRESSURE = '"c", "Pa", "help", "c_kPa"'
STATE = 'sp.Symbol("gathered", real=True)'
# Declarations as expressions, and below each what is said of it.
WRONG = """
# names
law(FALLS, name='exponential')
    name: found 'exponential', a name in use
law(FALLS, name='drag')
    name: found 'drag', a name in use
law(FALLS, name='balance')
    name: found 'balance', a name in use
law(FALLS, name=' ')
    name: found ' ', wanted a description
law(FALLS, name='my law')
    name: found 'my law', wanted small letters
law(FALLS, name='lambda')
    name: found 'lambda', a keyword of Python
effect(f'pressure={C}', OF_PRESSURE, 'friction')
    name: found 'friction', a name in use
moment('r', 'class')
    name: found 'class', a keyword of Python
moment('r', 'Area')
    name: found 'Area', wanted small letters
moment('r', 'sin')
    name: found 'sin', a name in use
moment('r', 'float')
    name: found 'float', a name in use
moment('r', 'tiers')
    name: found 'tiers', a name in use
moment('r', 'solve')
    name: found 'solve', a name in use
moment('r', 'polar_moment')
    name: found 'polar_moment', a name in use
moment('r', 'resistance_factor')
    name: found 'resistance_factor', a name in use
moment('-r*sp.sin(theta)', 'new', ', amplitude=("polar_moment", "K")')
    name: found 'polar_moment', a name
# moments, friction and states
moment('r**2')
    weight: found r**2, as of polar_moment, wanted another weight
moment('sp.Symbol("r")')
    new: weight: found Symbol('r'), wanted r of derive.declare.symbols
effect('friction=-' + C, '"c", "", "help", "c"')
    mu: found -3.16 at c_new = 3.16, wanted finite numbers, of resis
effect(f'pressure={STATE}, states=({STATE},), growth={STATE}*{C}', '"c", "", "help", "c"')
    growth: found c_new*gathered, which rises with gathered, wanted a bounded
# help and source
moment('r', more=', equation="9.9"')
    equation: found '9.9', wanted an equation of the paper
moment('r', more=', equation="2.4", source="Bell"')
    equation: found '2.4' beside source='Bell'
'Law("new", " ", _SOFTENING, ' + FALLS + ')'
    help: found ' ', wanted a description
# parameters
law(FALLS, '(*_SOFTENING, _SOFTENING[0])')
    parameter 'peak': found 'peak', a name in use
effect('pressure=' + C, '"radius", "m", "help", "radius_m"')
    parameter 'radius': found 'radius', a name
effect('pressure=' + C, '"c", "kPa", "help", "c_kPa"')
    parameter 'c', unit: found 'kPa', wanted a unit of
effect('pressure=' + C, '"c", "Pa", "help", "c_psi"')
    parameter 'c', key: found 'c_psi', wanted letters
effect('pressure=' + C, OF_PRESSURE + ', lower=1.0, upper=0.0')
    parameter 'c', bounds: found 1.0 and 0.0
effect('pressure=' + C, OF_PRESSURE + ', kind="numbers"')
    parameter 'c', kind: found 'numbers'
law(FALLS, '(*_SOFTENING, Parameter("stiffness", "Pa", "help", "stiffness_Pa"))')
    unit: found 'Pa', wanted
effect('pressure=' + C, '"c", "Pa", "", "c_Pa"')
    parameter 'c', help: found '', wanted a description
effect('pressure=' + C, '"c", "", "help", ""')
    parameter 'c', key: found '', wanted a key for scene files, as
effect('pressure=' + C, '"c", "", "help", "c", kind="text"')
    parameter 'c', kind: found 'text', wanted a kind with
effect('pressure=' + C, '"c", "", "help", "c", kind="|"')
    parameter 'c', kind: found '|', wanted number, series
effect('pressure=' + C, '"c", "", "help", "c", kind="rotation"')
    parameter 'c', key: found 'c', wanted none, as
effect('pressure=' + C, '"c", "", "help", "c", dimensionless=sp.Integer(1)')
    found 1, wanted a formula of the
effect('pressure=' + C, '"c", "", "help", "c", dimensionless=1 / VALUE')
    a pole or a complex number next to c =
# types
law(FALLS, '[*_SOFTENING]')
    parameters: found [Parameter(
law(FALLS, '("peak",)')
    parameters: found ('peak',), wanted tuple[Parameter, ...]
law(FALLS, more=', equation=3.11')
    equation: found 3.11, wanted str
law(FALLS, more=', source=" "')
    source: found ' ', wanted a description
law('_P * sp.oo', '_SOFTENING[:1]')
    coefficient: found oo*peak, wanted an expression of SymPy in real numbers
effect(f'pressure={C}', '"c", "", "help", "c"', more=", any_of='c'")
    any_of: found 'c', wanted tuple[str, ...]
moment('r*sp.cos(theta)', more=', amplitude=("k", "K", "L")')
    amplitude: found ('k', 'K', 'L'), wanted
# symbols
law('_P * sp.Symbol("strange", real=True)')
    coefficient: found the symbol strange, which is not declared
law("_P * sp.exp(-SLIP / sp.Symbol('length'))")
    the symbol length, which is not declared, wanted sp.Symbol('len
law('_P + 0 * _R')
    parameters: found residual, length in no formula, wanted a use of each
law('_R + (_P - _R) * sp.exp(-SLIP / _L) / (1 + SPEED / _V)', '(*_SOFTENING, _WEAKENING[2])')
    slip and speed
law('None')
    coefficient: found none, wanted a formula, or two lists
effect("pressure=sp.Symbol('strange', real=True)")
    u: found the symbol strange
effect('pressure=sp.Integer(1)', OF_PRESSURE + ', dimensionless=VALUE / REFERENCE')
    c in no formula
effect('pressure=_DRAG', '"c", "", "help", "c", symbol=_DRAG').replace(', symbol=sp.Symbol("c_new", real=True)', '')
    symbols: found drag, wanted each for one quantity of one effect
effect(f'pressure={C}', '"c", "", "help", "c"').replace('c_new', 'normal')
    symbols: found normal, wanted each
effect(f'pressure={C}', '"c", "", "help", "c"').replace('c_new', 'J_r')
    symbols: found J_r, wanted each for one
effect('pressure=' + C, '"c", "", "help", "c"').replace(', real=True', '')
    symbols: found Symbol('c_new'), wanted
effect(f'growth={C}', '"c", "", "help", "c"')
    states: found (), wanted symbols that its terms contain
effect(f'pressure={C}', more=f', states=({C},)')
    states: found (c_new,), wanted symbols that its terms contain
effect('pressure=SLIP_MU')
    u: found the symbol slip_mu, which is not declared
# functions
law('_P * (1 + sp.atan(SLIP / _L)) + _R')
    coefficient: found atan(slip/length), wanted sums, products
law('_P + (_R - _P) * sp.Min(SLIP / _L, 2)')
    a branch that changes at a slip of 2*length, wanted at a parameter
law('_R + (_P - _R) * sp.Min(SLIP / _L, 1, _R)')
    found Min(1, residual, slip/length), wanted min and max of two
law(f'_P + _R * (sp.Min(SLIP / _L, 1) + sp.Min(SLIP / {SECOND}, 1))', WITH_SECOND)
    found branches that change at length and second, wanted one slip
law('sp.Piecewise((_P, SLIP < _L), (_R, True))')
    Piecewise((peak, length > slip), (residual, True)), wanted su
effect('resistance=LAMBDA * sp.Piecewise((1, SLIP < 1), (2, True))')
    found Piecewise((1, slip < 1), (2, True))
law('_P + (_P - _R) * SLIP / (SLIP + _L)')
    residual = 6.58, length = 1, wanted numbers that are not negative
law('_P + _R * sp.Max(sp.Min(SLIP / _L, 1), 0)')
    found Max(0, Min(1, slip/length)), wanted min and max of two
law('sp.I * _P + _R * SLIP / _L')
    coefficient: found I*peak + residual*slip/length, wanted an expression
law('_R + _P * sp.exp(-sp.Min(SLIP / _L, 1))')
    piece between branches: found
law('_R + (_P - _R) * (1 - sp.Min(SLIP / _L, 1)) ** 8')
    degree of a piece: found 8, wanted at most 7
law(FALLS, more=', degree=3')
    degree: found 3, wanted none, as it follows from the formula
law('None', f'({SLIPS}, {COEFFICIENTS})', more=', degree=8')
    degree: found 8, wanted 0 to 7
law('None', f'({SLIPS},)')
    coefficient: found none, wanted a formula, or two lists
law('None', f'({SLIPS_IN_S}, {COEFFICIENTS})')
    coefficient: found none, wanted a formula, or two
# dimensions
law('_P * sp.exp(-SLIP)', '_SOFTENING[:1]')
    found exp(-slip), where -slip is in m, wanted -slip over a parameter
law('_R + (_P - _R) / (1 + SLIP)', '_SOFTENING[:2]')
    found slip + 1, of terms in numbers and m, wanted terms of
law('_P * SLIP', '_SOFTENING[:1]')
    found peak*slip, in m, wanted a number without a dimension
law('_R + _P * sp.exp(-SLIP / _L) ** SLIP')
    is in m, wanted
effect(f'pressure={C}', OF_PRESSURE)
    parameter 'c', dimensionless: found value, in kg/(m*s^2)
effect(f'resistance=LAMBDA * sp.exp(-SLIP / {C})', '"c", "m", "help", "c_m", dimensionless=VALUE / (2 * RADIUS)')
    found exp(-slip/c_new), where -slip/c_new is in m
# domains
law('_P - _R * SLIP / _L')
    coefficient: found -3.16e+03 at slip = 1e+03, peak = 3.16, residual = 3.16, length = 1
law('_P / (1 - SLIP / _L)', '(_SOFTENING[0], _SOFTENING[2])')
    coefficient: found -
law('_P / (1 - SLIP / _L) ** 2', '(_SOFTENING[0], _SOFTENING[2])')
    a pole or a complex number next to slip =
law('_P * sp.sqrt(1 - SLIP / _L)', '(_SOFTENING[0], _SOFTENING[2])')
    a pole or a complex number next to slip =
law('_P * sp.log(SLIP / _L)', '(_SOFTENING[0], _SOFTENING[2])')
    coefficient: found -
law('_P * sp.sqrt(SLIP / _L)', '(_SOFTENING[0], _SOFTENING[2])')
    a pole or a complex number next to slip =
law('_P * sp.cos(SLIP / _L)', '(_SOFTENING[0], _SOFTENING[2])')
    coefficient: found -
law('_P * _V / SPEED', '(_SOFTENING[0], _WEAKENING[2])')
    a pole or a complex number next to speed =
effect(f'resistance=-LAMBDA * {C}', '"c", "", "help", "c"')
    resistance: found -
effect(f'resistance=LAMBDA / {C}', '"c", "", "help", "c"')
    resistance: found a pole or a complex number next to
# moments
moment('r', 'np')
    name: found 'np', a name in use
moment('r', 'lost')
    name: found 'lost', a name in use
moment('sp.sqrt(r)')
    weight that can be certified: found sqrt(r), wanted r**n, +-r**n*sin(theta)
moment('r**6')
    weight that can be certified: found r**6, wanted r**n
moment('2 * r')
    weight that can be certified: found 2*r, wanted
moment('r * sp.cos(2 * theta)', more=', amplitude=("k", "K")')
    found r*cos(2*theta), wanted
moment('r * sp.sin(theta)')
    amplitude of the weight r*sin(theta): found None, wanted a name and a symbol
moment('r**2', more=', amplitude=("k", "K")')
    amplitude of the weight r**2: found ('k', 'K'), wanted none
# effects
effect("equation=''")
    terms: found none, wanted a term of the balance
effect(f'pressure={C}', OF_PRESSURE + ', dimensionless=VALUE / REFERENCE', more=", any_of=('d',)")
    any_of: found {'d'}
effect(f'driving_moment=J_R * {C}, normal_load=J_R * {C}', '"c", "", "help", "c"')
    signs of its parameters: found
"""
OF = {"Law": (effects, "LAWS"), "Effect": (effects, "EFFECTS"), "Moment": (quantities, "MOMENTS")}


def declare(text: str, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Append a declaration to its list, as its module reads it."""
    module, name = OF[text.partition("(")[0]]
    declared = eval(text, dict(vars(module)))
    entries = (*getattr(module, name), declared)
    monkeypatch.setattr(module, name, entries)
    if name == "EFFECTS":
        monkeypatch.setattr(module, "ALL_EFFECTS", (*entries, *effects.SECTION_EFFECTS))
    return declared


def test_wrong_declarations_are_one_line_each(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """It names the declaration, what it says and what it may say, in less than 5 s.

    Answers in the table of the page on extending are among these lines, word by word.
    """

    def no(*_: Any, **__: Any) -> None:
        pytest.fail("it was not refused, and something is derived and written")

    monkeypatch.setattr(command, "derive_all", no)  # which takes minutes
    answers = set[str]()
    lines = [line.strip() for line in WRONG.splitlines() if line and not line.startswith("#")]
    for declaration, said in zip(lines[::2], lines[1::2], strict=True):
        text = eval(declaration)
        with monkeypatch.context() as declared:
            declare(text, declared)
            start = time.process_time()
            assert command.main([]) == 1, text
            assert time.process_time() - start < 5.0, text
        out, err = capsys.readouterr()
        assert not out
        (line,) = err.splitlines()
        assert said in line
        assert len(line) <= 240
        answer, end, rest = line.partition("; nothing is written")
        assert end
        assert not rest
        assert re.search(r"^(Law|Effect|Moment)\('.*'\), |^new|^normal", line), line
        answers.add(answer)
    page = (Path(__file__).parents[1] / "notebooks" / "extending.md").read_text("utf-8")
    shown = re.findall(r"^\| .* \| `(.*)` \|$", page, re.MULTILINE)
    assert len(shown) == 19
    assert {*shown} <= answers


def test_what_is_not_decided_is_said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """A coefficient that touches zero without a change of sign cannot be enclosed; the laws that ship are decided."""
    for known in effects.LAWS:
        guards.check_alone(known)
    assert capsys.readouterr().err == ""
    touches = law("_P * (1 + sp.sin(SLIP / _L))", "(_SOFTENING[0], _SOFTENING[2])")
    guards.check_alone(declare(touches, monkeypatch))
    (line,) = capsys.readouterr().err.splitlines()
    start = "Law('new'), coefficient: not shown to be finite and not negative next to slip = "
    assert line.startswith(start)
    assert line.endswith("; narrow the bounds of its parameters")


def test_a_drop_replaces_a_condition_on_two_parameters(monkeypatch: pytest.MonkeyPatch) -> None:
    """A law that is negative if peak < residual is accepted with the difference as a parameter. Kinks may coincide."""
    drop = 'sp.Symbol("drop", real=True)'
    formula = f"_R + {drop} + {drop} * SLIP / (SLIP + _L)"
    guards.check_alone(declare(law(formula, f"({DROP}, *_SOFTENING[1:])"), monkeypatch))
    twice = declare(law("_R * sp.Min(SLIP / _L, 1) + _P * (1 - sp.Max(SLIP / _L, 1)) ** 2"), monkeypatch)
    guards.check_alone(twice)
    assert list(map(str, twice.kinks)) == ["length"]


def digests(folder: Path) -> dict[str, str]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and "__pycache__" not in path.parts)
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def test_the_command_says_it_and_leaves_every_byte(tmp_path: Path) -> None:
    """The command prints the answer and changes no file, also for text that Python cannot read."""
    all_weights.copy(tmp_path)
    file = tmp_path / "derive" / "declare" / "effects.py"
    text = file.read_text("utf-8")
    before = digests(tmp_path / "generated")
    line = text[: text.index(")  # fmt: skip")].count("\n") + 1
    wrong = {
        law(
            "_P * sp.exp(-SLIP)", "_SOFTENING[:1]"
        ): r"Law\('new'\), coefficient: found exp\(-slip\), where -slip is in m",
        law("_Q"): rf"declarations, effects.py, line {line}: found NameError: name '_Q' is not defined",
        "Law)": rf"declarations, effects.py, line {line + 1}: found SyntaxError: ",
    }
    for declaration, said in wrong.items():
        file.write_text(text.replace(")  # fmt: skip", f"    {declaration},\n)  # fmt: skip", 1), "utf-8")
        alone = os.environ | {"PYTHONPATH": str(tmp_path)}
        done = subprocess.run(
            [sys.executable, "-m", "derive"], cwd=tmp_path, env=alone, capture_output=True, text=True, check=False
        )
        assert done.returncode == 1
        (found,) = done.stderr.splitlines()
        assert re.match(said, found), found
        assert digests(tmp_path / "generated") == before
    write.importable(tmp_path)


def test_what_cannot_be_imported_replaces_nothing(tmp_path: Path) -> None:
    """Neither a module that Python cannot read nor one that the package cannot use."""
    folder = tmp_path / "generated"
    texts = write.present_files()
    write.write(texts, folder, write.importable)
    before = digests(folder)
    assert before
    broken = {
        "kernels.py": (texts["kernels.py"] + "def class(): pass\n", "SyntaxError"),
        "effects.py": (texts["effects.py"].replace("LIMITS =", "BOUNDS ="), "LIMITS"),
    }
    for name, (text, said) in broken.items():
        with pytest.raises(ProofError, match=f"generated: import: found .*{said}"):
            write.write({**texts, name: text, "new.py": ""}, folder, write.importable)
        assert digests(folder) == before
        assert [*tmp_path.iterdir()] == [folder]


def test_names_that_are_taken_are_those_of_the_package(capsys: pytest.CaptureFixture[str]) -> None:
    main(["schema"])
    keys = json.loads(capsys.readouterr().out)["properties"].keys()
    assert set(guards.TABLES.split()) == keys - {e.name for e in effects.EFFECTS}
    modules = {path.stem for path in write.FOLDER.glob("[a-z]*.py")}
    assert set(guards.MODULES.split()) == modules | {"generated"}
    assert set(guards.FUNCTIONS.split()) == {name for name in slipcircle.__all__ if name.islower()}


def test_equations_of_the_paper_are_those_that_are_judged() -> None:
    judged = {match[1] for claim in CLAIMS if (match := re.fullmatch(r"\((\d\.\d+)\)", claim.id))}
    every = {f"{chapter}.{number}" for chapter in range(10) for number in range(100)}
    assert {x for x in every if guards.PAPER.fullmatch(x)} == judged
