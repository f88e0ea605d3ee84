"""Programs become C: one inline function each, and the lists from which the template makes loops and ufuncs."""

import struct
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from derive.approximate.programs import Variant
from derive.code.emit import identifier
from derive.code.program import Op, Program, without_dead

TEMPLATE = Path(__file__).resolve().parent / "templates" / "_kernels.c"
HALF_PI = float.fromhex("0x1.921fb54442d18p+0")
# The largest alpha that is inside: half discs given in degrees land a little above pi/2.
END = {name: HALF_PI * (1.0 + 4.0 * eps) for name, eps in (("double", 2.0**-52), ("float", 2.0**-23))}
SHORT = 16  # operations of a program for which it costs more to look at a block than to be careful
_INFIX = {"add": "+", "sub": "-", "mul": "*", "div": "/", "less": "<"}
_CALLS = {"sqrt": "sqrt", "abs": "fabs", "exponent": "exponent_of", "significand": "significand_of"}


def body(name: str, program: Program) -> str:
    """The inline function of one program; one operation is one statement."""
    text: list[str] = []
    lines = []
    for index, op in enumerate(program.ops):
        expression = _expression(op, text)
        if op.kind in ("input", "const"):
            text.append(expression)
        else:
            text.append(f"v{index}")
            lines.append(f"    const {'int' if op.kind == 'less' else 'double'} v{index} = {expression};\n")
    (argument,), (output,) = program.inputs, program.outputs
    return f"INLINE double {name}(double {argument})\n{{\n{''.join(lines)}    return {text[output]};\n}}\n"


def pattern(limit: float, number: str, included: bool = True) -> str:
    """The bits of the largest double, or float, that is not above a positive limit, or below it."""
    letter, width = {"double": ("dQ", 64), "float": ("fI", 32)}[number]
    (bits,) = struct.unpack(f"<{letter[1]}", struct.pack(f"<{letter[0]}", limit))
    (nearest,) = struct.unpack(f"<{letter[0]}", struct.pack(f"<{letter[0]}", limit))
    return f"UINT{width}_C({bits if nearest < limit or (included and nearest == limit) else bits - 1:#x})"


def below(program: Program) -> tuple[float, Program] | None:
    """Where the result is a choice between two pieces at a seam: the seam, and the first piece alone."""
    output = program.ops[program.outputs[0]]
    if output.kind != "select":
        return None
    less = program.ops[output.args[0]]
    if less.kind != "less" or [program.ops[i].kind for i in less.args] != ["input", "const"]:
        return None
    return float(program.ops[less.args[1]].value), without_dead(replace(program, outputs=output.args[1:2]))  # type: ignore[arg-type]


def _expression(op: Op, text: Sequence[str]) -> str:
    args = [text[i] for i in op.args]
    match op.kind:
        case "input":
            return str(op.value)
        case "const":
            value = float(op.value)  # type: ignore[arg-type]
            return value.hex() if value >= 0 else f"({value.hex()})"
        case "neg":
            return f"-{args[0]}"
        case "min":
            return f"{args[0]} < {args[1]} ? {args[0]} : {args[1]}"
        case "max":
            return f"{args[0]} > {args[1]} ? {args[0]} : {args[1]}"
        case "select":
            return f"{args[0]} ? {args[1]} : {args[2]}"
        case "fma":
            return f"__builtin_fma({', '.join(args)})"
        case "call" if op.value in _CALLS:
            return f"{_CALLS[str(op.value)]}({args[0]})"
        case "call":
            raise ValueError(f"{op.value} is a library call: it has no place in a loop")
        case kind:
            return f"{args[0]} {_INFIX[kind]} {args[1]}"


def source(variants: Sequence[Variant]) -> str:
    """The extension module of these variants: their fused and plain programs."""
    programs = {(v.kernel, v.tier, v.form): v.program for v in variants if v.form != "numpy"}
    tiers = list(dict.fromkeys((kernel, tier) for kernel, tier, _ in programs))
    single = {k: identifier(k, "float32" if (k, "float32") in tiers else "best") for k, t in tiers if t == "best"}
    bodies = {
        form: "\n".join(_functions(f"{identifier(k, t)}_{form}", programs[k, t, form]) for k, t in tiers)
        for form in ("fused", "plain")
    }
    loops = [f"LOOP(double, {identifier(k, t)}, FORM, LEVEL)" for k, t in tiers if t != "float32"]
    loops += [f"LOOP(float, {name}, FORM, LEVEL)" for name in single.values()]
    ufuncs = []
    for k, t in tiers:
        if t != "float32":  # it is the float32 loop of the best tier
            of_float = f"(void *){single[k]}_##LEVEL##_float" if t == "best" else "NULL"
            ufuncs.append(f'{{"{k}", "{t}", {{{of_float}, (void *){identifier(k, t)}_##LEVEL##_double}}}},')
    filled = {
        "HALF_PI": HALF_PI.hex(),
        "END_double": END["double"].hex(),
        "END_float": END["float"].hex(),
        "LAST_double": pattern(HALF_PI, "double"),
        "LAST_float": pattern(HALF_PI, "float"),
        "BODIES": f"#ifndef NO_FMA\n{bodies['fused']}#endif\n\n{bodies['plain']}",
        "LOOPS": _macro("LOOPS(LEVEL, FORM)", loops) + "LEVELS(LOOPS)\n",
        "UFUNCS": _macro(
            "UFUNCS(LEVEL, FORM)", ["static Ufunc ufuncs_##LEVEL[] = {", *ufuncs, "{NULL, NULL, {NULL, NULL}}};"]
        )
        + "LEVELS(UFUNCS)\n",
    }
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, value in filled.items():
        text = text.replace(f"@{name}@", value)
    return text


def _functions(name: str, program: Program) -> str:
    """The function of a program, of its first piece if it has two, and what kind of loop suits it."""
    text, piece = body(name, program), below(program)
    if piece:
        limits = "".join(f"#define {name}_BELOW_{t} {pattern(piece[0], t, False)}\n" for t in ("double", "float"))
        return f"{text}#define {name}_KIND pieces\n{limits}{body(f'{name}_below', piece[1])}"
    return f"{text}#define {name}_KIND {'short' if sum(program.operations().values()) <= SHORT else 'whole'}\n"


def _macro(head: str, lines: Sequence[str]) -> str:
    return " \\\n    ".join([f"#define {head}", *lines]) + "\n"
