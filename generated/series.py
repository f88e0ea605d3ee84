# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 321404b615eb52441e9d8bc3552ae83c14e82d997d0674c7624e4f19bfa03c9b
"""Operations of flow programs in NumPy: on numbers at the start of a phase, and on series during it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Codes of the operations on series and on cells, as the compiled integrator numbers them.
SERIES = {'lin': 0, 'mul': 1, 'sqr': 2, 'powers': 3, 'tim': 4, 'turn': 5, 'exp': 6, 'rec': 7, 'log': 8}
SCALAR = {'add': 0, 'sub': 1, 'mul': 2, 'div': 3, 'neg': 4, 'sin': 5, 'cos': 6, 'tan': 7, 'exp': 8, 'expm1': 9,
    'log': 10, 'log1p': 11, 'sqrt': 12, 'abs': 13, 'min': 14, 'max': 15, 'less': 16, 'select': 17}
DIGEST = "62499e5f9b0abaec2ebdd128437aa5a170e140194230cbecec0b08478a1f680c"  # of the compiled integrator's source


def scalar_ops(operations: Sequence[tuple[Any, ...]], c: Floats) -> None:
    """Perform the operations on cells, (cells, lanes), in place."""
    for name, d, *arguments in operations:
        _SCALARS[name](*(c[i] for i in arguments), out=c[d])


def series_ops(operations: Sequence[tuple[Any, ...]], r: Floats, c: Floats, n: int) -> None:
    """Compute coefficient n of all registers, (registers, orders, lanes), from the registers of states and tables."""
    for name, results, registers, cells in operations:
        if name == "lin":
            total = r[results[0], n]
            total[...] = 0.0 if n else c[cells[0]]
            for cell, register in zip(cells[1:], registers, strict=True):
                total += c[cell] * r[register, n]
        else:
            _SERIES[name](r, n, *results, *registers)


def _less(a: Floats, b: Floats, out: Floats) -> None:
    out[...] = a < b


def _select(a: Floats, b: Floats, e: Floats, out: Floats) -> None:
    out[...] = np.where(a > 0.0, b, e)


def _over(a: Floats, b: Floats, n: int, last: int) -> Any:
    """Return the sum of a[k] b[n - k] from k = 1 to last."""
    return np.einsum("kl,kl->l", a[1 : last + 1], b[n - last : n][::-1])


def _mul(r: Floats, n: int, d_: int, a_: int, b_: int) -> None:
    """Compute d = a*b."""
    d, a, b = r[d_], r[a_], r[b_]
    if n == 0:
        d[0] = a[0] * b[0]
    else:
        sum0 = _over(a, b, n, n - 1)
        d[n] = sum0 + a[0] * b[n] + a[n] * b[0]


def _sqr(r: Floats, n: int, d_: int, a_: int) -> None:
    """Compute d = a**2."""
    d, a = r[d_], r[a_]
    if n == 0:
        d[0] = a[0] * a[0]
    else:
        sum0 = 2.0 * _over(a, a, n, (n - 1) // 2)
        sum0 += a[n // 2] ** 2 if n % 2 == 0 else 0.0
        d[n] = sum0 + 2.0 * a[0] * a[n]


def _powers(r: Floats, n: int, p2_: int, p3_: int, p4_: int, p5_: int, p6_: int, p7_: int, x_: int) -> None:
    """Compute p2 = x**2, p3 = x**3, p4 = x**4, p5 = x**5, p6 = x**6, p7 = x**7."""
    p2, p3, p4, p5, p6, p7, x = r[p2_], r[p3_], r[p4_], r[p5_], r[p6_], r[p7_], r[x_]
    if n == 0:
        t1 = x[0] * x[0]
        t2 = x[0] * t1
        t3 = t1 * t1
        p2[0] = t1
        p3[0] = t2
        p4[0] = t3
        p5[0] = x[0] * t3
        p6[0] = t1 * t3
        p7[0] = t2 * t3
    else:
        sum0 = _over(x, p2, n, n - 1)
        sum1 = _over(x, p3, n, n - 1)
        sum2 = _over(x, p4, n, n - 1)
        sum3 = _over(x, p5, n, n - 1)
        sum4 = _over(x, p6, n, n - 1)
        sum5 = 2.0 * _over(x, x, n, (n - 1) // 2)
        sum5 += x[n // 2] ** 2 if n % 2 == 0 else 0.0
        p2[n] = sum5 + 2.0 * x[0] * x[n]
        p3[n] = sum0 + p2[0] * x[n] + p2[n] * x[0]
        p4[n] = sum1 + p3[0] * x[n] + p3[n] * x[0]
        p5[n] = sum2 + p4[0] * x[n] + p4[n] * x[0]
        p6[n] = sum3 + p5[0] * x[n] + p5[n] * x[0]
        p7[n] = sum4 + p6[0] * x[n] + p6[n] * x[0]


def _tim(r: Floats, n: int, q_: int, a_: int) -> None:
    """Compute q = t*Derivative(a, t)."""
    q, a = r[q_], r[a_]
    if n == 0:
        q[0] = 0.0
    else:
        q[n] = a[n] * n


def _turn(r: Floats, n: int, s_: int, v_: int, q_: int, x_: int) -> None:
    """Compute s = sin(x), v = 1 - cos(x)."""
    s, v, q, x = r[s_], r[v_], r[q_], r[x_]
    if n == 0:
        t1 = np.sin(0.5 * x[0])
        s[0] = np.sin(x[0])
        v[0] = 2.0 * (t1 * t1)
    else:
        sum0 = _over(q, s, n, n - 1)
        sum1 = _over(q, v, n, n - 1)
        b = 1.0 - v[0]
        s[n] = b * x[n] - (1.0 / n) * sum1
        v[n] = (1.0 / n) * sum0 + s[0] * x[n]


def _exp(r: Floats, n: int, e_: int, m_: int, q_: int, z_: int) -> None:
    """Compute e = exp(z), m = exp(z) - 1."""
    e, m, q, z = r[e_], r[m_], r[q_], r[z_]
    if n == 0:
        e[0] = np.exp(z[0])
        m[0] = np.expm1(z[0])
    else:
        sum0 = _over(q, e, n, n - 1)
        e[n] = (1.0 / n) * sum0 + e[0] * z[n]
        m[n] = e[n]


def _rec(r: Floats, n: int, h_: int, m_: int, z_: int) -> None:
    """Compute h = 1/(z + 1), m = -z/(z + 1)."""
    h, m, z = r[h_], r[m_], r[z_]
    if n == 0:
        t1 = 1.0 + z[0]
        h[0] = 1.0 / t1
        m[0] = -(z[0] / t1)
    else:
        sum0 = _over(z, h, n, n - 1)
        h[n] = -((sum0 + h[0] * z[n]) * h[0])
        m[n] = h[n]


def _log(r: Floats, n: int, u_: int, l_: int, q_: int, z_: int) -> None:
    """Compute u = t*Derivative(z, t)/(z + 1), l = log(z + 1)."""
    u, l, q, z = r[u_], r[l_], r[q_], r[z_]
    if n == 0:
        u[0] = 0.0
        l[0] = np.log1p(z[0])
    else:
        sum0 = _over(u, z, n, n - 1)
        u[n] = (q[n] - sum0) / (1.0 + z[0])
        l[n] = (1.0 / n) * u[n]


_SERIES: dict[str, Any] = {"mul": _mul, "sqr": _sqr, "powers": _powers, "tim": _tim, "turn": _turn, "exp": _exp,
    "rec": _rec, "log": _log}
_SCALARS: dict[str, Any] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "neg": np.negative,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "exp": np.exp,
    "expm1": np.expm1,
    "log": np.log,
    "log1p": np.log1p,
    "sqrt": np.sqrt,
    "abs": np.absolute,
    "min": np.minimum,
    "max": np.maximum,
    "less": _less,
    "select": _select,
}
