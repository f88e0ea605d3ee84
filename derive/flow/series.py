"""Source that executes the operations of a program: in C over vectors of lanes, and in NumPy over arrays of lanes."""

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sympy import Expr, Indexed, IndexedBase, Sum, Symbol, cancel

from derive.code.emit import filled
from derive.code.program import program
from derive.code.text import Language, statements
from derive.flow.recurrences import CELLS, OPERATIONS, SCALAR, SERIES, SeriesOperation, k, n
from derive.kinds import TextDict, Texts


class _Sum(NamedTuple):
    """Sum in an operation's step: weight a[k] b[n - k] from k = first to last.

    The weight is text that ends with a product sign, or empty. In a symmetric sum the second half repeats the first.
    """

    total: Sum
    name: str
    weight: str
    a: str
    b: str
    first: str
    last: str
    symmetric: bool


class _Target(NamedTuple):
    """Notation of operations on series in a language: statements, zero, and sums with or without weights.

    The terms of a sum with coefficient n of an argument, k = 0 and k = n, are added last if ``newest`` has a form, so
    that other terms do not wait for them.
    """

    language: Language
    zero: str
    end: str
    plain: str
    weighted: str
    symmetric: str
    newest: str


C = _Target(
    Language("vector", "const V {name} = {text};", repr),
    "(V){0}",
    ";",
    "V {name} = {name}_[0] + {name}_[1];",
    "V {name} = {name}_[0] + {name}_[1];",
    "V {name} = 2.0 * ({name}_[0] + {name}_[1]);\nif (n % 2 == 0) {name} += {a}[n / 2] * {a}[n / 2];",
    "{name} += {factor}{a}[{k}] * {b}[{rest}];",
)
NUMPY = _Target(
    Language("python", "{name} = {text}", repr, "np"),
    "0.0",
    "",
    "{name} = _over({a}, {b}, n, {first}, {last})",
    "k = np.arange(n + 1.0)[:, None]\n{name} = _over({weight}{a}[: n + 1], {b}, n, {first}, {last})",
    "{name} = 2.0 * _over({a}, {a}, n, {first}, (n - 1) // 2)\n{name} += {a}[n // 2] ** 2 if n % 2 == 0 else 0.0",
    "",
)
# In C all sums of an operation are one loop, each in two parts.
PARTS = "{name}_[2] = {{{{0}}}}"
TERMS = "{name}_[j] += {weight}{a}[k] * {b}[n - k]"
CASE = """\
    case {code}: {{ /* {means} */
{names}
        if (n == 0) {{
{start}
        }} else {{
{step}
        }}
        return at + {following};
    }}
"""
FUNCTION = """\
def _{code}(r: Floats, n: int, {parameters}) -> None:
    \"""Compute {means}.\"""
{names}
    if n == 0:
{start}
    else:
{step}


"""


def _sums(o: SeriesOperation) -> list[_Sum]:
    """Return the sums in the steps of an operation's results."""
    sums = []
    totals = {total for e in o.step for total in e.atoms(Sum)}
    for i, total in enumerate(sorted(totals, key=str)):
        ((_, first, last),) = total.limits
        at_k, at_rest = sorted(total.function.atoms(Indexed), key=lambda x: x.indices != (k,))
        weight = cancel(total.function / (at_k * at_rest))
        factor = ""
        if weight != 1:
            _, (text,) = _texts([weight], NUMPY.language)
            factor = f"{text} * " if weight.is_Symbol else f"({text}) * "
        a = str(at_k.base)
        b = str(at_rest.base)
        symmetric = a == b and first == 0
        sums.append(_Sum(total, f"sum{i}", factor, a, b, str(first), str(last), symmetric))
    return sums


def _texts(forms: Sequence[Expr], language: Language, sums: Iterable[_Sum] = ()) -> tuple[Texts, Texts]:
    """Return statements in a language that compute the forms, and the text of each form.

    Coefficients of series are inputs by their text, 1/n is `by_n`, and ``sums`` are replaced by their names.
    """
    names: dict[Expr, str] = {s.total: s.name for s in sums}
    names[1 / n] = "by_n"
    plain = []
    for e in forms:
        e = e.xreplace({x: Symbol(name, real=True) for x, name in names.items()})
        coefficients = (*e.atoms(Indexed), n, k)
        plain.append(e.xreplace({x: Symbol(str(x), real=True) for x in coefficients}))
    inputs = {x.name for e in plain for x in e.free_symbols}
    return statements(program("series", tuple(sorted(inputs)), *plain), language)


def _body(o: SeriesOperation, target: _Target) -> tuple[Texts, Texts]:
    """Return statements for order 0 and for order n. A result may be used by later results."""
    start, texts = _texts(o.start, target.language)
    for x, e, text in zip(o.results, o.start, texts, strict=True):
        start.append(f"{x}[0] = {text if e else target.zero}{target.end}")
    sums = _sums(o)
    step = []
    for s in sums:
        form = target.symmetric if s.symmetric else target.weighted if s.weight else target.plain
        step += form.format(**s._asdict()).split("\n")
        step += _newest(s, target)
    for x, e in zip(o.results, o.step, strict=True):
        lines, (text,) = _texts([e], target.language, sums)
        step += [*lines, f"{x}[n] = {text}{target.end}"]
    return start, step


def _newest(s: _Sum, target: _Target) -> Iterator[str]:
    """Yield the statements that add the terms k = 0 and k = n of a sum last, none if the target has none for them."""
    if target.newest:
        for at_k, rest in (("0", "n"),) if s.symmetric else (("0", "n"), ("n", "0")):
            if at_k in (s.first, s.last):
                factor = "2.0 * " if s.symmetric else re.sub(r"\bk\b", at_k, s.weight)
                yield target.newest.format(**s._asdict(), k=at_k, rest=rest, factor=factor)


def _read(o: SeriesOperation) -> list[IndexedBase]:
    """Return the series on which an operation's results depend."""
    used = {x.base for e in (*o.start, *o.step) for x in e.atoms(Indexed)}
    return [x for x in o.arguments if x in used]


def _means(o: SeriesOperation) -> str:
    """Return the meanings of an operation's results as text, ``result = formula`` for each."""
    return ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))


def _indented(lines: Iterable[str], by: int) -> str:
    """Return lines as one text, each indented by this number of blanks."""
    return "\n".join(" " * by + x for x in lines)


def _loop(sums: Sequence[_Sum]) -> Texts:
    """Return the lines of C with the loop of all sums of an operation, none without sums."""
    if not sums:
        return []
    parts = (PARTS.format(**s._asdict()) for s in sums)
    terms = (TERMS.format(**s._asdict()) for s in sums)
    below = "(n + 1) / 2" if sums[0].symmetric else "n"
    return [f"V {', '.join(parts)};", f"OVER({below}, {'; '.join(terms)});"]


def _c_case(o: SeriesOperation) -> str:
    """Return the case of an operation in the C function that interprets operations on series."""
    operands = (*o.results, *o.arguments)
    places = {x: i for i, x in enumerate(operands, 1)}
    names = [f"V *restrict {x} = r + at[{places[x]}];" for x in o.results]
    names += [f"const V *{x} = r + at[{places[x]}];" for x in _read(o)]
    start, step = _body(o, C)
    return CASE.format(
        code=o.name.upper(),
        means=_means(o),
        names=_indented(names, 8),
        start=_indented(start, 12),
        step=_indented([*_loop(_sums(o)), *step], 12),
        following=len(places) + 1,
    )


def c_operations() -> TextDict:
    """Return codes, operands and cases of the operations on series and cells as C text, by marks of the template."""
    codes = (SERIES, [f"S_{x}" for x in CELLS])
    enums = (f"enum {{ {', '.join(x.upper() for x in names)} }};\n" for names in codes)
    registers = [1, *(len(o.results) + len(o.arguments) for o in OPERATIONS.values())]
    arguments = []
    cases = ""
    for name, operation in CELLS.items():
        text = operation.vector.format(*"abe")
        others = [(i, x) for i, x in ((3, "b"), (4, "e")) if f"{{{i - 2}}}" in operation.vector]
        loads = "".join(f"const V {x} = c[at[{i}]]; " for i, x in others)
        case = f"{{ {loads}*d = IN(choose)(here, {text}, *d); at += {3 + len(others)}; break; }}"
        arguments.append(1 + len(others))
        cases += f"        case S_{name.upper()}: {case}\n"
    return {
        "CODES": "".join(enums),
        "REGISTERS": ", ".join(map(str, registers)),
        "ARGUMENTS": ", ".join(map(str, arguments)),
        "SERIES": "".join(map(_c_case, OPERATIONS.values())),
        "CELL_OPERATIONS": cases,
    }


def _numpy_function(o: SeriesOperation) -> str:
    """Return the source of the NumPy function that performs an operation on series."""
    series = [*o.results, *_read(o)]
    parameters = (*o.results, *o.arguments)
    start, step = _body(o, NUMPY)
    names = [f"{', '.join(map(str, series))} = {', '.join(f'r[{x}_]' for x in series)}"]
    return FUNCTION.format(
        code=o.name,
        parameters=", ".join(f"{x}_: int" for x in parameters),
        means=_means(o),
        names=_indented(names, 4),
        start=_indented(start, 8),
        step=_indented(step, 8).replace("by_n", "(1.0 / n)"),
    )


def numpy_text(digest: str) -> str:
    """Return the module `generated.series` with the digest of the corresponding C source."""
    named = {"less": "_less", "select": "_select"}
    scalars = {x: named.get(x, f"np.{o.meaning.__name__}") for x, o in CELLS.items()}
    return filled(
        "_series.py.in",
        {
            "DIGEST": digest,
            "CODES": repr(SERIES),
            "SCALAR_CODES": repr(SCALAR),
            "FUNCTIONS": "".join(map(_numpy_function, OPERATIONS.values())),
            "SERIES": ", ".join(f'"{x}": _{x}' for x in OPERATIONS),
            "SCALARS": "".join(f'    "{x}": {text},\n' for x, text in scalars.items()),
        },
    )
