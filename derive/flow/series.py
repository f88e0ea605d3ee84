"""Source that executes the operations of a program: in C over vectors of lanes, and in NumPy over arrays of lanes."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sympy import Expr, Indexed, IndexedBase, Sum, Symbol

from derive.code.emit import filled
from derive.code.program import program
from derive.code.text import Language, statements
from derive.flow.recurrences import CELLS, OPERATIONS, SCALAR, SERIES, SeriesOperation, k, n
from derive.kinds import TextDict, Texts


class Target(NamedTuple):
    """Notation of operations on series in a language: statements, zero, and sums, also of a series with itself."""

    language: Language
    zero: str
    end: str
    sum: str
    symmetric: str


C = Target(Language("vector", "const V {name} = {text};", repr), "(V){0}", ";", *2 * ("const V {name} = {slot}[n];",))
NUMPY = Target(
    Language("python", "{name} = {text}", repr, "np"),
    "0.0",
    "",
    "{name} = _over({a}, {b}, n, n - 1)",
    "{name} = 2.0 * _over({a}, {a}, n, (n - 1) // 2)\n{name} += {a}[n // 2] ** 2 if n % 2 == 0 else 0.0",
)
# Sums in C: their terms that are known before an order. One loop at even orders also adds those of the next order, so
# that coefficients are read once for two orders. Until an operation needs a sum it is where the result will be.
SUMS = """\
if (n % 2 == 0) {{
{start}
    for (int i = 1; 2 * i < n; i++) {{
{terms}
    }}
{last}
}} else {{
{rest}
}}"""
OF_PRODUCT = {
    "start": "V {name} = {a}[1] * {b}[n - 1], {name}_next = {{0}}, {name}_before = {b}[n - 1];",
    "terms": """\
{name}_next += {a}[2 * i] * {name}_before; {name}_before = {b}[n - 2 * i];
{name} += {a}[2 * i] * {name}_before; {name}_next += {a}[2 * i + 1] * {name}_before;
{name}_before = {b}[n - 2 * i - 1]; {name} += {a}[2 * i + 1] * {name}_before;""",
    "last": "{slot}[n] = {name}, {slot}[n + 1] = {name}_next;",
    "rest": "{slot}[n] = n > 1 ? {slot}[n] + {a}[1] * {b}[n - 1] + {a}[n - 1] * {b}[1] : (V){{0}};",
}
OF_SQUARE = {
    "start": "V {name} = {{0}}, {name}_next = {{0}};",
    "terms": """\
const V {name}_now = {a}[n - i]; {name} += {a}[i] * {name}_now; {name}_next += {a}[i + 1] * {name}_now;""",
    "last": "{when}{slot}[n] = 2.0 * {name} + {a}[n / 2] * {a}[n / 2], {slot}[n + 1] = 2.0 * {name}_next;",
    "rest": "{when}{slot}[n] = n > 1 ? {slot}[n] + 2.0 * {a}[1] * {a}[n - 1] : (V){{0}};",
}
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


class OneSum(NamedTuple):
    """Sum of a[k] b[n - k] in an operation's step, its name, and the result in which its known terms wait."""

    total: Sum
    name: str
    a: IndexedBase | str
    b: IndexedBase | str
    slot: IndexedBase | str
    when: str = ""  # condition in C of using it


def sums_in(o: SeriesOperation) -> list[OneSum]:
    """Return the sums in the steps of an operation's results."""
    sums = []
    totals = {total for e in o.step for total in e.atoms(Sum)}
    for i, total in enumerate(sorted(totals, key=str)):
        at_k, at_rest = sorted(total.function.atoms(Indexed), key=lambda x: x.indices != (k,))
        sums.append(OneSum(total, f"sum{i}", at_k.base, at_rest.base, o.results[i]))
    return sums


def known_terms(sums: Iterable[OneSum]) -> Texts:
    """Return lines of C that compute the terms of sums which are known before order n, none without sums."""
    parts: dict[str, Texts] = {part: [] for part in OF_PRODUCT}
    for s in sums:
        for part, form in (OF_SQUARE if s.a == s.b else OF_PRODUCT).items():
            parts[part] += form.format(**s._asdict()).split("\n")
    if not parts["start"]:
        return []
    texts = {part: indented(lines, 8 if part == "terms" else 4) for part, lines in parts.items()}
    return SUMS.format(**texts).split("\n")


def _texts(forms: Sequence[Expr], language: Language, sums: Iterable[OneSum] = ()) -> tuple[Texts, Texts]:
    """Return statements in a language that compute the forms, and the text of each form.

    Coefficients of series are inputs by their text, 1/n is `by_n`, and ``sums`` are replaced by their names.
    """
    names: dict[Expr, str] = {s.total: s.name for s in sums}
    names[1 / n] = "by_n"
    plain = []
    for e in forms:
        e = e.xreplace({x: Symbol(name, real=True) for x, name in names.items()})
        plain.append(e.xreplace({x: Symbol(str(x), real=True) for x in (*e.atoms(Indexed), n)}))
    inputs = {x.name for e in plain for x in e.free_symbols}
    return statements(program("series", tuple(sorted(inputs)), *plain), language)


def body(o: SeriesOperation, target: Target) -> tuple[Texts, Texts]:
    """Return statements for order 0 and for order n. A result may be used by later results."""
    of_order_0 = {x: x[0] for x in o.arguments}
    start, texts = _texts([e.xreplace(of_order_0) for e in o.start], target.language)
    for x, e, text in zip(o.results, o.start, texts, strict=True):
        start.append(f"{x}[0] = {text if e else target.zero}{target.end}")
    sums = sums_in(o)
    step = []
    for s in sums:
        step += (target.symmetric if s.a == s.b else target.sum).format(**s._asdict()).split("\n")
    for x, e in zip(o.results, o.step, strict=True):
        lines, (text,) = _texts([e], target.language, sums)
        step += [*lines, f"{x}[n] = {text}{target.end}"]
    return start, step


def _means(o: SeriesOperation) -> str:
    """Return the meanings of an operation's results as text, ``result = formula`` for each."""
    return ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))


def indented(lines: Iterable[str], by: int) -> str:
    """Return lines as one text, each indented by this number of blanks."""
    return "\n".join(" " * by + x for x in lines)


def _c_case(o: SeriesOperation) -> str:
    """Return the case of an operation in the C function that interprets operations on series."""
    operands = (*o.results, *o.arguments)
    places = {x: i for i, x in enumerate(operands, 1)}
    names = [f"V *restrict {x} = r + at[{places[x]}];" for x in o.results]
    names += [f"const V *{x} = r + at[{places[x]}];" for x in o.arguments]
    start, step = body(o, C)
    return CASE.format(
        code=o.name.upper(),
        means=_means(o),
        names=indented(names, 8),
        start=indented(start, 12),
        step=indented([*known_terms(sums_in(o)), *step], 12),
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
        case = f"{{ {loads}*d = IN(choose)(here, {text}, *d); at += {3 + len(others)}; NEXT; }}"
        arguments.append(1 + len(others))
        cases += f"    S_{name.upper()}: {case}\n"
    return {
        "CODES": "".join(enums),
        "REGISTERS": ", ".join(map(str, registers)),
        "ARGUMENTS": ", ".join(map(str, arguments)),
        "SERIES": "".join(map(_c_case, OPERATIONS.values())),
        "CELL_OPERATIONS": cases,
        "LABELS": ", ".join(f"&&S_{x.upper()}" for x in CELLS),
    }


def _numpy_function(o: SeriesOperation) -> str:
    """Return the source of the NumPy function that performs an operation on series."""
    series = [*map(str, (*o.results, *o.arguments))]
    start, step = body(o, NUMPY)
    names = [f"{', '.join(series)} = {', '.join(f'r[{x}_]' for x in series)}"]
    return FUNCTION.format(
        code=o.name,
        parameters=", ".join(f"{x}_: int" for x in series),
        means=_means(o),
        names=indented(names, 4),
        start=indented(start, 8),
        step=indented(step, 8).replace("by_n", "(1.0 / n)"),
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
