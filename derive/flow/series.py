"""The text that runs the operations of a program: in C over vectors of lanes, and in NumPy over arrays of lanes."""

from collections.abc import Mapping
from typing import NamedTuple

from sympy import Expr, Function, Indexed, IndexedBase, Mul, Sum, cancel

from derive.flow.operations import OPERATIONS, SCALARS, Operation, k, n


class _Sum(NamedTuple):
    """A sum of an operation's step: of weight a[k] b[n - k] from k = first to n - short.

    The weight is text, with a times sign, or nothing. Of a symmetric sum the second half repeats the first.
    """

    name: str
    weight: str
    a: str
    b: str
    first: int
    short: int
    symmetric: bool


def _sums(o: Operation) -> dict[Sum, _Sum]:
    """The sums of an operation's step."""
    sums = {}
    totals = {total for e in o.step for total in e.atoms(Sum)}
    for i, total in enumerate(sorted(totals, key=str)):
        ((_, first, last),) = total.limits
        at_k, at_rest = sorted(total.function.atoms(Indexed), key=lambda x: x.indices != (k,))
        weight = cancel(total.function / (at_k * at_rest))
        factor = "" if weight == 1 else f"{_text(weight, {})} * "
        a = str(at_k.base)
        b = str(at_rest.base)
        sums[total] = _Sum(str(i), factor, a, b, int(first), int(n - last), a == b and first == 0)
    return sums


def _text(e: Expr, known: Mapping[Expr, str]) -> str:
    """An expression as C and Python both write it."""
    if e in known:
        return known[e]
    if isinstance(e, Indexed):
        return f"{e.base}[{e.indices[0]}]"
    if e.is_Symbol:
        return str(e)
    if e.is_Rational:
        return repr(float(e))
    if e.is_Add:
        terms = sorted(e.args, key=lambda x: (x.could_extract_minus_sign(), str(x)))
        return f"({' + '.join(_text(x, known) for x in terms).replace('+ -', '- ')})"
    if e.is_Mul:
        return f"-{_text(-e, known)}" if e.could_extract_minus_sign() else _product(e, known)
    if e.is_Pow:
        base = _text(e.base, known)
        return f"1.0 / {base}" if e.exp == -1 else " * ".join([base] * int(e.exp))
    raise ValueError(f"no text for {e}")


def _product(e: Mul, known: Mapping[Expr, str]) -> str:
    """Factors, then divisors; 1/n is the number `by_n`."""
    over = []
    under = ""
    for x in sorted(e.args, key=str):
        if not (x.is_Pow and x.exp == -1):
            over.append(_text(x, known))
        elif x.base == n:
            under += " * by_n"
        else:
            under += f" / {_text(x.base, known)}"
    return " * ".join(over or ["1.0"]) + under


def _body(o: Operation, let: str, call: str, zero: str, end: str) -> tuple[list[str], list[str]]:
    """Statements for order 0, functions first, and for order n, in which sums are named."""
    known: dict[Expr, str] = {total: f"sum{s.name}" for total, s in _sums(o).items()}
    functions = {f for e in o.start for f in e.atoms(Function)}
    start = []
    for i, f in enumerate(sorted(functions, key=lambda f: (len(f.atoms(Function)), -len(f.func.__name__), str(f)))):
        argument = _text(f.args[0], known)
        start.append(f"{let}f{i} = {call.format(type(f).__name__.lower(), argument)}{end}")
        known[f] = f"f{i}"
    start += [f"{x}[0] = {_text(e, known) if e else zero}{end}" for x, e in zip(o.results, o.start, strict=True)]
    return start, [f"{x}[n] = {_text(e, known)}{end}" for x, e in zip(o.results, o.step, strict=True)]


def _read(o: Operation) -> list[IndexedBase]:
    """The series on which an operation's results depend."""
    used = {x.base for e in (*o.start, *o.step) for x in e.atoms(Indexed)}
    return [x for x in o.arguments if x in used]


def _means(o: Operation) -> str:
    return ", ".join(f"{x} = {m}" for x, m in zip(o.results, o.means, strict=True))


def _c_sums(o: Operation) -> list[str]:
    """All sums of an operation in one loop."""
    sums = [*_sums(o).values()]
    if not sums:
        return []
    below = "(n + 1) / 2" if sums[0].symmetric else f"n + {1 - sums[0].short}"
    adds = "; ".join(f"part{s.name}[j] += {s.weight}{s.a}[k] * {s.b}[n - k]" for s in sums)
    parts = ", ".join(f"part{s.name}[2] = {{{{0}}}}" for s in sums)
    lines = [f"V {parts};", f"OVER({sums[0].first}, {below}, {adds});"]
    for s in sums:
        lines.append(f"V sum{s.name} = {'2.0 * ' if s.symmetric else ''}(part{s.name}[0] + part{s.name}[1]);")
        if s.symmetric:
            lines.append(f"if (n % 2 == 0) sum{s.name} += {s.a}[n / 2] * {s.a}[n / 2];")
    return lines


def _c_case(o: Operation) -> str:
    at = {x: f"at[{i}]" for i, x in enumerate((*o.results, *o.arguments, *o.numbers), 1)}
    lines = [f"V *restrict {x} = r + (ptrdiff_t){at[x]} * stride;" for x in o.results]
    lines += [f"const V *{x} = r + (ptrdiff_t){at[x]} * stride;" for x in _read(o)]
    lines += [f"const V {x} = c[{at[x]}];" for x in o.numbers]
    start, step = _body(o, "const V ", "IN(map)({}, {})", "(V){0}", ";")
    lines += ["if (n == 0) {", *(f"    {x}" for x in start), "} else {"]
    lines += [*(f"    {x}" for x in (*_c_sums(o), *step)), "}", f"return at + {len(at) + 1};"]
    return f"    case {o.name.upper()}: {{ /* {_means(o)} */\n" + "".join(f"        {x}\n" for x in lines) + "    }\n"


def c() -> dict[str, str]:
    """Codes and cases of the operations on series, each returning where the next begins, and on cells."""
    codes = (["LIN", "RAMP", *OPERATIONS], [f"S_{x}" for x in SCALARS])
    cases = ""
    for name, (means, text, _) in SCALARS.items():
        arguments = len(means.free_symbols)
        loads = "".join(f"const V {x} = c[at[{i}]]; " for i, x in ((3, "b"), (4, "e"))[: arguments - 1])
        case = f"{{ {loads}*d = IN(choose)(here, {text}, *d); at += {2 + arguments}; break; }}"
        cases += f"        case S_{name.upper()}: {case}\n"
    enums = (f"enum {{ {', '.join(x.upper() for x in names)} }};\n" for names in codes)
    return {"CODES": "".join(enums), "SERIES": "".join(map(_c_case, OPERATIONS.values())), "CELL_OPERATIONS": cases}


_NUMPY = '''"""The operations of flow programs, in NumPy: on numbers where a phase begins, and on series along it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Codes of the operations on series and on cells, as the compiled integrator numbers them.
SERIES = {codes!r}
SCALAR = {scalar_codes!r}
DIGEST = "{digest}"  # of the compiled integrator's source


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
_SERIES: dict[str, Any] = {{{series}}}
_SCALARS: dict[str, Any] = {{
{scalars}}}
'''


def _numpy_sum(s: _Sum) -> list[str]:
    name = f"sum{s.name}"
    last = f"n - {s.short}" if s.short else "n"
    if s.symmetric:
        return [
            f"{name} = 2.0 * _over({s.a}, {s.a}, n, {s.first}, (n - 1) // 2)",
            f"{name} += {s.a}[n // 2] ** 2 if n % 2 == 0 else 0.0",
        ]
    first = f"{s.weight}{s.a}[: n + 1]" if s.weight else s.a
    total = f"{name} = _over({first}, {s.b}, n, {s.first}, {last})"
    if s.weight:
        return ["k = np.arange(n + 1.0)[:, None]", total]
    return [total]


def _numpy_function(o: Operation) -> str:
    series = [*o.results, *_read(o)]
    start, step = _body(o, "", "np.{}({})", "0.0", "")
    names = ", ".join(f"{x}_: int" for x in (*o.results, *o.arguments, *o.numbers))
    lines = [
        f"def _{o.name}(r: Floats, c: Floats, n: int, {names}) -> None:",
        f'    """{_means(o)}."""',
        f"    {', '.join(map(str, series))} = {', '.join(f'r[{x}_]' for x in series)}",
    ]
    lines += [f"    {x} = c[{x}_]" for x in o.numbers]
    lines += ["    if n == 0:", *(f"        {x}" for x in start), "    else:"]
    lines += [f"        {x}" for s in _sums(o).values() for x in _numpy_sum(s)]
    lines += [f"        {x.replace('by_n', '(1.0 / n)')}" for x in step]
    return "\n".join(lines) + "\n\n\n"


def numpy_text(digest: str) -> str:
    """The module `generated.series`, beside the source of the compiled integrator of which this is the digest."""
    return _NUMPY.format(
        digest=digest,
        codes={x: i for i, x in enumerate(("lin", "ramp", *OPERATIONS))},
        scalar_codes={x: i for i, x in enumerate(SCALARS)},
        functions="".join(map(_numpy_function, OPERATIONS.values())),
        series=", ".join(f'"{x}": _{x}' for x in OPERATIONS),
        scalars="".join(f'    "{x}": {text},\n' for x, (_, _, text) in SCALARS.items()),
    )
