"""C source of programs: inline functions with names, and the lists from which the template makes loops and ufuncs."""

import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from derive.approximate.programs import Code, Variant, logarithm, parts_of_ends
from derive.check.ends import LIMIT
from derive.code import emit
from derive.code.emit import identifier
from derive.code.operations import OPERATIONS
from derive.code.program import Program, without_dead
from derive.code.text import Language, Part, Reader, seam, statements
from derive.kinds import Texts

HALF_PI = float.fromhex("0x1.921fb54442d18p+0")
# Largest alpha of the domain, since half discs given in degrees are slightly above pi/2.
END = {name: HALF_PI * (1.0 + 4.0 * eps) for name, eps in (("double", 2.0**-52), ("float", 2.0**-23))}
MOST = 24  # degrees of polynomials are smaller


def _number(value: float) -> str:
    """Return small multiples of 1/16 in decimal and other numbers in hexadecimal notation."""
    if abs(value) < 16 and (16 * value).is_integer():
        return repr(value)
    return value.hex()


C = Language(
    "c", "const double {name} = {text};", _number, several="double {names}; {function}({arguments}, {places});"
)
FORMS = {"fused": "__builtin_fma(a, b, c)", "plain": "((a) * (b) + (c))"}  # definition of FMA(a, b, c)


class CText:
    """Inline functions of one form. Each is read back after it is written, and may call earlier functions."""

    def __init__(self, form: str) -> None:
        self.reader = Reader({"hexadecimal": float.fromhex})
        scope = self.reader.scope
        for kind, operation in OPERATIONS.items():
            name = operation.c.partition("(")[0]
            if name.isidentifier():
                scope[name] = partial(self.reader.builder.put, kind)
        polynomial = self.reader.builder.polynomial
        scope |= {f"POLY{degree}": lambda x, *c: polynomial(x, c, form == "fused") for degree in range(1, MOST)}
        if form == "plain":
            scope["FMA"] = lambda a, b, c: a * b + c
        self.parts: list[Part] = []
        code = Code(form, "b")
        part = Part(f"logarithm_{form}", code.program("logarithm", logarithm(code, code.x)))
        comment = "/* ln b of a b >= 0; at 0 something finite, which a factor 0 waits for. */"
        self.text = f"{comment}\n{self.body(part.name, part.program)}"
        self.parts.append(part)

    def body(self, name: str, program: Program, parts: Sequence[Part] = ()) -> str:
        """Return the inline function of one program."""
        lines, results = statements(program, C, [*parts, *self.parts])
        code = textwrap.indent("\n".join([*lines, f"return {', '.join(results)};", ""]), "    ")
        python = re.sub(r"const double (\w+ = )", r"\1", code).replace(";\n", "\n")
        python = re.sub(r"double ([\w, ]+); (\w+\([^&]*), &.*\)", r"\1 = \2)", python)
        python = re.sub(r"-?0x[0-9a-f.]+p[-+]\d+", r"hexadecimal('\g<0>')", python)
        self.reader.check(program, name, f"def {name}({', '.join(program.inputs)}):\n{python}")
        arguments = ", ".join(f"double {x}" for x in program.inputs)
        if len(results) == 1:
            return f"INLINE double {name}({arguments})\n{{\n{code}}}\n"
        start, _, _ = code.rpartition("    return ")
        for k, result in enumerate(results):
            arguments += f", double *to_{k}"
            start += f"    *to_{k} = {result};\n"
        return f"INLINE void {name}({arguments})\n{{\n{start}}}\n"

    def functions(self, name: str, program: Program) -> str:
        """Return the inline functions of a program, one for each of its pieces, and its kind of loop as a macro."""
        pieces = seam(program)
        if not pieces:
            return f"{self.body(name, program)}#define {name}_KIND whole\n"
        at, *outputs = pieces
        comments = (f"/* alpha < {at} */", f"/* alpha >= {at}, in b = pi/2 - alpha */")
        parts = []
        text = ""
        for side, output, comment in zip(("near", "far"), outputs, comments, strict=True):
            piece = without_dead(replace(program, outputs=(output,)))
            part = Part(f"{name}_{side}", piece)
            parts.append(part)
            text += f"{comment}\n{self.body(part.name, piece)}"
        text += self.body(name, program, parts)
        text += f"#define {name}_KIND pieces\n"
        for number in ("double", "float"):
            text += f"#define {name}_BELOW_{number} {pattern(at, number, False)}\n"
        return text


def pattern(limit: float, number: str, included: bool = True) -> str:
    """Return the bits of the largest ``number``, double or float, that does not exceed a positive limit.

    Without ``included`` it is below the limit.
    """
    width = {"double": 64, "float": 32}[number]
    nearest = np.array(limit, f"float{width}")
    bits = int(nearest.view(f"uint{width}"))
    value = float(nearest)
    if value > limit or (value == limit and not included):
        bits -= 1
    return f"UINT{width}_C({bits:#x})"


def source(variants: Sequence[Variant], words: Mapping[tuple[str, str, str], str] | None = None) -> str:
    """Return the source of the extension module: fused and plain programs of the variants, each with its comment.

    ``words`` are the comments by kernel, tier and form.
    """
    written = [v for v in variants if v.form != "numpy"]
    bodies = {form: _bodies(form, [v for v in written if v.form == form], words or {}) for form in FORMS}
    loops, table = _loops_and_table(written)
    polynomials = (f"#define POLY{n}(x, c0, ...) FMA(POLY{n - 1}(x, __VA_ARGS__), x, c0)\n" for n in range(2, MOST))
    marks = {
        "PROCESSOR": emit.PROCESSOR,
        "HALF_PI": HALF_PI.hex(),
        "LIMIT": repr(LIMIT),
        "END_double": END["double"].hex(),
        "END_float": END["float"].hex(),
        "LAST_double": pattern(HALF_PI, "double"),
        "LAST_float": pattern(HALF_PI, "float"),
        "POLYNOMIALS": "".join(polynomials),
        "BODIES": f"#ifndef NO_FMA\n{bodies['fused']}#endif\n\n{bodies['plain']}",
        "LOOPS": _macro("LOOPS", loops),
        "UFUNCS": _macro("UFUNCS", table),
    }
    return emit.filled("_kernels.c", marks)


def _loops_and_table(variants: Sequence[Variant]) -> tuple[Texts, Texts]:
    """Return a loop for each tier in double and for each kernel in float, and the table of ufuncs."""
    tiers = {(v.kernel, v.tier): v for v in variants}
    double_loops = []
    float_loops = []
    rows = []
    for (kernel, tier), variant in tiers.items():
        if tier == "float32":
            continue
        loop = "LOOP_ENDS" if variant.part else "LOOP"
        name = identifier(kernel, tier)
        double_loops.append(f"{loop}(double, {name}, FORM, LEVEL)")
        of_float = "NULL"
        if tier == "best":
            single = identifier(kernel, "float32") if (kernel, "float32") in tiers else name
            float_loops.append(f"{loop}(float, {single}, FORM, LEVEL)")
            of_float = f"(void *){single}_##LEVEL##_float"
        of_double = f"(void *){name}_##LEVEL##_double"
        inputs = len(variant.program.inputs)
        rows.append(f'{{"{kernel}", "{tier}", {inputs}, {{{of_float}, {of_double}}}}},')
    return double_loops + float_loops, ["static Ufunc ufuncs_##LEVEL[] = {", *rows, "{NULL, NULL, 0, {NULL, NULL}}};"]


def _bodies(form: str, variants: Sequence[Variant], words: Mapping[tuple[str, str, str], str]) -> str:
    """Return the inline functions of one form; ``words`` are their comments by kernel, tier and form."""
    c = CText(form)
    text = f"#undef FMA\n#define FMA(a, b, c) {FORMS[form]}\n\n{c.text}"
    for p in parts_of_ends():
        part = Part(f"{p.name}_{form}", p)
        text += f"\n{c.body(part.name, p)}"
        c.parts.append(part)
    for v in variants:
        name = f"{identifier(v.kernel, v.tier)}_{form}"
        comment = ""
        if said := words.get((v.kernel, v.tier, form)):
            comment = "/* " + "\n * ".join(textwrap.wrap(said.replace("*/", "* /"), 112)) + " */\n"
        if v.part:
            part = Part(f"{identifier(v.part.kernel, v.part.tier)}_{form}", v.part.program)
            text += f"\n{comment}{c.body(name, v.program, [part])}"
        else:
            text += f"\n{comment}{c.functions(name, v.program)}"
    return text


def _macro(name: str, lines: Sequence[str]) -> str:
    """Return a macro of these lines with the parameters LEVEL and FORM, expanded for every level of processors."""
    return " \\\n    ".join([f"#define {name}(LEVEL, FORM)", *lines]) + f"\nLEVELS({name})\n"
