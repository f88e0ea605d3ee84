"""The text that runs the operations of a program: in C over vectors of lanes, and in NumPy over arrays of lanes."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sympy import Expr, Indexed, IndexedBase, Sum, Symbol, cancel

from derive.code.emit import filled
from derive.code.program import program
from derive.code.text import Language, statements
from derive.flow.operations import CELLS, OPERATIONS, Operation, k, n

C = Language("vector", "const V {name} = {text};", repr, "")
NUMPY = Language("python", "{name} = {text}", repr, "", "np")
ZERO = {"vector": "(V){0}", "python": "0.0"}


class _Sum(NamedTuple):
    """A sum of an operation's step: of weight a[k] b[n - k] from k = first to n - short.

    The weight is text, with a times sign, or nothing. Of a symmetric sum the second half repeats the first.
    """

    total: Sum
    name: str
    weight: str
    a: str
    b: str
    first: int
    short: int
    symmetric: bool


def _sums(o: Operation) -> list[_Sum]:
    """The sums of an operation's step."""
    sums = []
    totals = {total for e in o.step for total in e.atoms(Sum)}
    for i, total in enumerate(sorted(totals, key=str)):
        ((_, first, last),) = total.limits
        at_k, at_rest = sorted(total.function.atoms(Indexed), key=lambda x: x.indices != (k,))
        weight = cancel(total.function / (at_k * at_rest))
        _, (text,) = _texts([weight], NUMPY)
        factor = "" if weight == 1 else f"{text if weight.is_Symbol else f'({text})'} * "
        a = str(at_k.base)
        b = str(at_rest.base)
        sums.append(_Sum(total, f"sum{i}", factor, a, b, int(first), int(n - last), a == b and first == 0))
    return sums


def _texts(forms: Sequence[Expr], language: Language, sums: Iterable[_Sum] = ()) -> tuple[list[str], list[str]]:
    """Statements, and the text of each form; coefficients are inputs by their text, and 1/n is the number `by_n`."""
    names: dict[Expr, str] = {s.total: s.name for s in sums} | {1 / n: "by_n"}
    plain = []
    for e in forms:
        e = e.xreplace({x: Symbol(name, real=True) for x, name in names.items()})
        plain.append(e.xreplace({x: Symbol(str(x), real=True) for x in (*e.atoms(Indexed), n, k)}))
    inputs = sorted({x.name for e in plain for x in e.free_symbols})
    return statements(program("series", tuple(inputs), *plain), language)


def _body(o: Operation, language: Language, sums: Sequence[_Sum], end: str = "") -> tuple[list[str], list[str]]:
    """Statements for order 0, and for order n, in which sums are named; a result may be read by those after it."""
    start, texts = _texts(o.start, language)
    for x, e, text in zip(o.results, o.start, texts, strict=True):
        start.append(f"{x}[0] = {text if e else ZERO[language.templates]}{end}")
    step = []
    for x, e in zip(o.results, o.step, strict=True):
        lines, (text,) = _texts([e], language, sums)
        step += [*lines, f"{x}[n] = {text}{end}"]
    return start, step


def _read(o: Operation) -> list[IndexedBase]:
    """The series on which an operation's results depend."""
    used = {x.base for e in (*o.start, *o.step) for x in e.atoms(Indexed)}
    return [x for x in o.arguments if x in used]


def _means(o: Operation) -> str:
    return ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))


def _c_sums(sums: Sequence[_Sum]) -> Iterator[str]:
    """All sums of an operation in one loop."""
    if not sums:
        return
    below = "(n + 1) / 2" if sums[0].symmetric else f"n + {1 - sums[0].short}"
    adds = "; ".join(f"{s.name}_[j] += {s.weight}{s.a}[k] * {s.b}[n - k]" for s in sums)
    yield f"V {', '.join(f'{s.name}_[2] = {{{{0}}}}' for s in sums)};"
    yield f"OVER({sums[0].first}, {below}, {adds});"
    for s in sums:
        yield f"V {s.name} = {'2.0 * ' * s.symmetric}({s.name}_[0] + {s.name}_[1]);"
        if s.symmetric:
            yield f"if (n % 2 == 0) {s.name} += {s.a}[n / 2] * {s.a}[n / 2];"


def _c_case(o: Operation) -> str:
    at = {x: f"at[{i}]" for i, x in enumerate((*o.results, *o.arguments, *o.numbers), 1)}
    lines = [f"V *restrict {x} = r + (ptrdiff_t){at[x]} * stride;" for x in o.results]
    lines += [f"const V *{x} = r + (ptrdiff_t){at[x]} * stride;" for x in _read(o)]
    lines += [f"const V {x} = c[{at[x]}];" for x in o.numbers]
    sums = _sums(o)
    start, step = _body(o, C, sums, ";")
    lines += ["if (n == 0) {", *(f"    {x}" for x in start), "} else {"]
    lines += [*(f"    {x}" for x in (*_c_sums(sums), *step)), "}", f"return at + {len(at) + 1};"]
    return f"    case {o.name.upper()}: {{ /* {_means(o)} */\n" + "".join(f"        {x}\n" for x in lines) + "    }\n"


def c() -> dict[str, str]:
    """Codes and cases of the operations on series, each returning where the next begins, and on cells."""
    codes = (["LIN", "RAMP", *OPERATIONS], [f"S_{x}" for x in CELLS])
    cases = ""
    for name, operation in CELLS.items():
        text = operation.vector.format(*"abe")
        others = [(3, "b"), (4, "e")][: operation.python.count("{") - 1 - ("{space}" in operation.python)]
        loads = "".join(f"const V {x} = c[at[{i}]]; " for i, x in others)
        case = f"{{ {loads}*d = IN(choose)(here, {text}, *d); at += {3 + len(others)}; break; }}"
        cases += f"        case S_{name.upper()}: {case}\n"
    enums = (f"enum {{ {', '.join(x.upper() for x in names)} }};\n" for names in codes)
    return {"CODES": "".join(enums), "SERIES": "".join(map(_c_case, OPERATIONS.values())), "CELL_OPERATIONS": cases}


def _numpy_sum(s: _Sum) -> list[str]:
    last = f"n - {s.short}" if s.short else "n"
    if s.symmetric:
        return [
            f"{s.name} = 2.0 * _over({s.a}, {s.a}, n, {s.first}, (n - 1) // 2)",
            f"{s.name} += {s.a}[n // 2] ** 2 if n % 2 == 0 else 0.0",
        ]
    first = f"{s.weight}{s.a}[: n + 1]" if s.weight else s.a
    total = f"{s.name} = _over({first}, {s.b}, n, {s.first}, {last})"
    if s.weight:
        return ["k = np.arange(n + 1.0)[:, None]", total]
    return [total]


def _numpy_function(o: Operation) -> str:
    series = [*o.results, *_read(o)]
    sums = _sums(o)
    start, step = _body(o, NUMPY, sums)
    names = ", ".join(f"{x}_: int" for x in (*o.results, *o.arguments, *o.numbers))
    lines = [
        f"def _{o.name}(r: Floats, c: Floats, n: int, {names}) -> None:",
        f'    """{_means(o)}."""',
        f"    {', '.join(map(str, series))} = {', '.join(f'r[{x}_]' for x in series)}",
    ]
    lines += [f"    {x} = c[{x}_]" for x in o.numbers]
    lines += ["    if n == 0:", *(f"        {x}" for x in start), "    else:"]
    lines += [f"        {x}" for s in sums for x in _numpy_sum(s)]
    lines += [f"        {x.replace('by_n', '(1.0 / n)')}" for x in step]
    return "\n".join(lines) + "\n\n\n"


def numpy_text(digest: str) -> str:
    """The module `generated.series`, beside the source of the compiled integrator of which this is the digest."""
    named = {"less": "_less", "select": "_select"}
    scalars = {x: named.get(x, f"np.{o.meaning.__name__}") for x, o in CELLS.items()}
    return filled(
        "_series.py.in",
        {
            "DIGEST": digest,
            "CODES": repr({x: i for i, x in enumerate(("lin", "ramp", *OPERATIONS))}),
            "SCALAR_CODES": repr({x: i for i, x in enumerate(CELLS)}),
            "FUNCTIONS": "".join(map(_numpy_function, OPERATIONS.values())),
            "SERIES": ", ".join(f'"{x}": _{x}' for x in OPERATIONS),
            "SCALARS": "".join(f'    "{x}": {text},\n' for x, text in scalars.items()),
        },
    )
