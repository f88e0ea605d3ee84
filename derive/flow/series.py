"""The text that runs the operations of a program: in C over vectors of lanes, and in NumPy over arrays of lanes."""

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from derive.flow.fragments import CELLS
from derive.flow.operations import OPERATIONS, SCALARS, Operation, k, n

_BOUND = {"C": "const V {} = {};", "NumPy": "{} = {}"}


@dataclass(frozen=True)
class _Sum:
    """A sum of an operation's step: of weight a[k] b[n - k] from k = first to n - short."""

    name: str
    weight: sp.Expr
    a: sp.Indexed
    b: sp.Indexed
    first: int
    short: int

    @property
    def symmetric(self) -> bool:
        """Whether its second half repeats the first."""
        return self.a.base == self.b.base and self.weight == 1

    def factor(self, at: str, order: str) -> str:
        """The weight as text, with a times sign, where there is one."""
        known = {k: at, n: order} | {x: str(x) for x in self.weight.free_symbols - {k, n}}
        return "" if self.weight == 1 else f"{_text(self.weight, known)} * "


def _sums(o: Operation) -> dict[sp.Sum, _Sum]:
    """The sums of an operation's step."""
    found = {}
    for i, total in enumerate(sorted({x for e in o.step for x in e.atoms(sp.Sum)}, key=str)):
        ((_, first, last),) = total.limits
        parts = {x: x.base if isinstance(x, sp.Pow) else x for x in sp.Mul.make_args(total.function)}
        series = {x: base for x, base in parts.items() if isinstance(base, sp.Indexed)}
        a, b = sorted((*series.values(), *series.values())[:2], key=lambda x: x.indices != (k,))
        found[total] = _Sum(f"sum{i}", sp.cancel(total.function / sp.Mul(*series)), a, b, int(first), int(n - last))
    return found


def _text(e: sp.Expr, known: Mapping[sp.Expr, str]) -> str:
    """An expression as C and Python both write it."""
    if e in known:
        return known[e]
    if isinstance(e, sp.Add):
        terms = sorted(e.args, key=lambda x: (x.could_extract_minus_sign(), str(x)))
        return f"({' + '.join(_text(x, known) for x in terms).replace('+ -', '- ')})"
    if isinstance(e, sp.Mul) and e.could_extract_minus_sign():
        return f"-{_text(-e, known)}"
    if isinstance(e, sp.Mul):
        factors = sorted(e.args, key=str)
        under = [x.base for x in factors if isinstance(x, sp.Pow) and x.exp == -1]
        over = [x for x in factors if not (isinstance(x, sp.Pow) and x.exp == -1)] or [sp.Integer(1)]
        divided = [" * by_n" if x == n else f" / {_text(x, known)}" for x in under]
        return " * ".join(_text(x, known) for x in over) + "".join(divided)
    if isinstance(e, sp.Pow):
        return f"1.0 / {_text(e.base, known)}" if e.exp == -1 else " * ".join([_text(e.base, known)] * int(e.exp))
    if isinstance(e, sp.Rational):
        return repr(float(e))
    raise ValueError(f"no text for {e}")


def _start(o: Operation, language: str, at: str) -> tuple[list[str], list[str]]:
    """Order 0: functions by name, then the results; ``at`` is how the first coefficient of a series is written."""
    known: dict[sp.Expr, str] = {x: at.format(x.base) for e in o.start for x in e.atoms(sp.Indexed)}
    known |= {x: str(x) for x in o.numbers}
    lines = []
    functions = sorted(
        {f for e in o.start for f in e.atoms(sp.Function)}, key=lambda f: (len(f.atoms(sp.Function)), str(f))
    )
    for i, f in enumerate(functions):
        name, argument = type(f).__name__.lower(), _text(f.args[0], known)
        call = f"IN(map)({name}, {argument})" if language == "C" else f"np.{name}({argument})"
        lines.append(_BOUND[language].format(f"f{i}", call))
        known[f] = f"f{i}"
    return lines, [_text(e, known) if e != 0 else "" for e in o.start]


def _step(o: Operation, at: str) -> list[str]:
    """Order n: the results, with sums by name."""
    known: dict[sp.Expr, str] = {total: s.name for total, s in _sums(o).items()} | {n: "order"}
    for x in {x for e in o.step for x in e.atoms(sp.Indexed)}:
        known[x] = at.format(x.base, x.indices[0])
    return [_text(e, known) for e in o.step]


# --- C -------------------------------------------------------------------------------------------------------------

_C = """\
/* One operation on series at order n: coefficient n of its results, and where the next operation stands. It is its
 * code, its results, its arguments and the cells of its numbers; a sum is its code, its result, the cell of its
 * constant or -1, how many terms, and the cell and the register of each. What is read off a table is there already.
 * Register i begins at r + i * stride; by_n is 1 / n. */
static inline __attribute__((always_inline)) const int32_t *IN(operate)(const int32_t *at, V *r, const V *c, int stride,
                                                                        int n, double by_n) {{
    const double order = n;
    switch (at[0]) {{
    case LIN: {{
        V sum = n == 0 && at[2] >= 0 ? c[at[2]] : (V){{0}};
        const int32_t *const end = at + 4 + 2 * at[3];
        for (const int32_t *term = at + 4; term < end; term += 2)
            sum += c[term[0]] * r[(ptrdiff_t)term[1] * stride + n];
        r[(ptrdiff_t)at[1] * stride + n] = sum;
        return end;
    }}
    case RAMP:
        return at + 3;
{cases}    default:
        __builtin_unreachable();
    }}
}}

/* The operations on cells of a prologue, to their end, in some of the lanes: each its code, its result, its arguments. */
static void IN(prologue)(const int32_t *at, const int32_t *end, V *c, M here) {{
    while (at < end) {{
        const V a = c[at[2]];
        V *const d = c + at[1];
        switch (at[0]) {{
{scalar_cases}        }}
    }}
}}
"""


def _c_loop(sums: list[_Sum]) -> list[str]:
    """Sums over the same k, two terms at a time so that they do not wait for each other."""

    def term(s: _Sum, at: str) -> str:
        return f"{s.factor(f'(double)({at})', 'order')}{s.a.base}[{at}] * {s.b.base}[n - {at.replace('+', '-')}]"

    s = sums[0]
    limit = "n - k" if s.symmetric else f"n{f' - {s.short}' if s.short else ''} + 1"  # k stays below it
    both = " ".join(f"{s.name} += {term(s, 'k')}, {s.name}_ += {term(s, 'k + 1')};" for s in sums)
    lines = [f"V {', '.join(f'{s.name} = {{0}}, {s.name}_ = {{0}}' for s in sums)};", f"int k = {s.first};",
             f"for (; k + 1 < {limit.replace('n - k', 'n - k - 1')}; k += 2) {{ {both} }}",
             f"if (k < {limit}) {{ {' '.join(f'{s.name} += {term(s, chr(107))};' for s in sums)} }}",
             *(f"{s.name} += {s.name}_;" for s in sums)]  # fmt: skip
    if s.symmetric:
        lines += [f"{s.name} *= 2.0;", f"if (n % 2 == 0) {s.name} += {s.a.base}[n / 2] * {s.a.base}[n / 2];"]
    return lines


def _c_case(o: Operation) -> str:
    place = iter(range(1, 9))
    lines = [f"V *restrict {x} = r + (ptrdiff_t)at[{next(place)}] * stride;" for x in o.results]
    used = {x.base for e in (*o.start, *o.step) for x in e.atoms(sp.Indexed)}
    for x in o.arguments:
        i = next(place)
        lines += [f"const V *{x} = r + (ptrdiff_t)at[{i}] * stride;"] if x in used else []
    lines += [f"const V {x} = c[at[{next(place)}]];" for x in o.numbers]
    functions, start = _start(o, "C", "{}[0]")
    body = [*functions, *(f"{x}[0] = {e or '(V){0}'};" for x, e in zip(o.results, start, strict=True))]
    lines += ["if (n == 0) {", *(f"    {x}" for x in body), "} else {"]
    sums = [*_sums(o).values()]
    body = _c_loop(sums) if sums else []
    body += [f"{x}[n] = {e};" for x, e in zip(o.results, _step(o, "{}[{}]"), strict=True)]
    lines += [*(f"    {x}" for x in body), "}", f"return at + {next(place)};"]
    means = ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))
    return f"    case {o.name.upper()}: {{ /* {means} */\n" + "".join(f"        {x}\n" for x in lines) + "    }\n"


def c_text() -> str:
    """The C of all operations."""
    scalar = ""
    for name, (means, text, _) in SCALARS.items():
        arguments = len(means.free_symbols)
        loads = "".join(f"const V {x} = c[at[{i}]]; " for i, x in ((3, "b"), (4, "e"))[: arguments - 1])
        scalar += f"        case S_{name.upper()}: {{ {loads}*d = IN(choose)(here, {text}, *d); at += {2 + arguments}; break; }}\n"
    return _C.format(cases="".join(map(_c_case, OPERATIONS.values())), scalar_cases=scalar)


def c_enums() -> str:
    """The cells that every lane has, and the codes of the operations."""
    codes = [*CELLS], ["LIN", "RAMP", *OPERATIONS], [f"S_{x}" for x in SCALARS]
    return "".join(f"enum {{ {', '.join(x.upper() for x in names)} }};\n" for names in codes)


# --- NumPy ---------------------------------------------------------------------------------------------------------

_NUMPY = '''"""The operations of flow programs, in NumPy: on numbers where a phase begins, and on series along it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Codes of the operations on series and on cells, as the compiled walk knows them.
SERIES = {codes!r}
SCALAR = {scalar_codes!r}


def scalar_ops(operations: Sequence[tuple[Any, ...]], c: Floats) -> None:
    """Do the operations on cells, (cells, lanes), in place."""
    for name, d, *arguments in operations:
        _SCALARS[name](*(c[i] for i in arguments), out=c[d])


def series_ops(operations: Sequence[tuple[Any, ...]], r: Floats, c: Floats, n: int) -> None:
    """Fill coefficient n of all registers, (registers, orders, lanes); those of states and tables are there."""
    for name, *names in operations:
        if name == "lin":
            d, constant, terms = names
            total = r[d, n]
            if terms:
                (cell, register), *rest = terms
                np.multiply(c[cell], r[register, n], out=total)
                for cell, register in rest:
                    total += c[cell] * r[register, n]
            else:
                total[...] = 0.0
            if n == 0 and constant >= 0:
                total += c[constant]
        elif name != "ramp":
            _SERIES[name](r, c, n, *names)


def _less(a: Floats, b: Floats, out: Floats) -> None:
    out[...] = a < b


def _select(a: Floats, b: Floats, e: Floats, out: Floats) -> None:
    out[...] = np.where(a > 0.0, b, e)


def _over(a: Floats, b: Floats, n: int, first: int, last: int) -> Any:
    """The sum of a[k] b[n - k] from k = first to last."""
    return np.einsum("kl,kl->l", a[first : last + 1], b[n - last : n - first + 1][::-1])


{functions}
_SERIES = {{{series}}}
_SCALARS: dict[str, Any] = {{
{scalars}}}
'''


def _numpy_sum(s: _Sum) -> list[str]:
    a, b, last = s.a.base, s.b.base, f"n - {s.short}" if s.short else "n"
    if s.symmetric:
        return [f"{s.name} = 2.0 * _over({a}, {a}, n, {s.first}, (n - 1) // 2)",
                f"{s.name} += {a}[n // 2] ** 2 if n % 2 == 0 else 0.0"]  # fmt: skip
    if s.weight == 1:
        return [f"{s.name} = _over({a}, {b}, n, {s.first}, {last})"]
    return ["k = np.arange(n + 1.0)[:, None]",
            f"{s.name} = _over({s.factor('k', 'n')}{a}[: n + 1], {b}, n, {s.first}, {last})"]  # fmt: skip


def _numpy_function(o: Operation) -> str:
    names = [*o.results, *o.arguments, *o.numbers]
    used = {x.base for e in (*o.start, *o.step) for x in e.atoms(sp.Indexed)}
    means = ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))
    lines = [f"def _{o.name}(r: Floats, c: Floats, n: int, {', '.join(f'{x}_: int' for x in names)}) -> None:",
             f'    """{means}."""']  # fmt: skip
    taken = [x for x in (*o.results, *o.arguments) if x in o.results or x in used]
    lines.append(f"    {', '.join(map(str, taken))} = {', '.join(f'r[{x}_]' for x in taken)}")
    lines += [f"    {x} = c[{x}_]" for x in o.numbers]
    functions, start = _start(o, "NumPy", "{}[0]")
    lines += ["    if n == 0:", *(f"        {x}" for x in functions)]
    lines += [f"        {x}[0] = {e or '0.0'}" for x, e in zip(o.results, start, strict=True)]
    step = _step(o, "{}[{}]")
    lines += ["    else:", *(f"        {x}" for s in _sums(o).values() for x in _numpy_sum(s))]
    lines += [
        f"        {x}[n] = {e.replace('by_n', '(1.0 / n)').replace('order', 'n')}"
        for x, e in zip(o.results, step, strict=True)
    ]
    return "\n".join(lines) + "\n\n\n"


def numpy_text() -> str:
    """The module `generated.series`."""
    return _NUMPY.format(
        codes={x: i for i, x in enumerate(("lin", "ramp", *OPERATIONS))},
        scalar_codes={x: i for i, x in enumerate(SCALARS)},
        functions="".join(map(_numpy_function, OPERATIONS.values())),
        series=", ".join(f'"{x}": _{x}' for x in OPERATIONS),
        scalars="".join(f'    "{x}": {text},\n' for x, (_, _, text) in SCALARS.items()),
    )
