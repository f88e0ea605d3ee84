"""The compiler `python -m derive [--check | --again | flow]`, and `python -m derive verify | hard | prove | theorem`.

=======  =======================================================  =====================================================
stage    input                                                    output
=======  =======================================================  =====================================================
declare  `derive.declare`: moments, laws, effects                 the same without a fault, or one line about the first
lower    a moment; effects and laws                               closed form and approximants; fragments of programs
link     fragments                                                programs of scenes (`derive.flow`)
write    approximants, fragments, linker, templates               the files of `generated`, compiled
prove    each result above                                        claims, certificates, or `ProofError`
=======  =======================================================  =====================================================

A stage runs when its inputs have changed since they were recorded (`derive.stages`), or with ``--again``.
"""

import argparse
import sys
import time
import traceback
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from derive.check.proof import ProofError
from derive.progress import say
from derive.stages import Stages


def declare(stages: Stages) -> None:
    """Check the declarations, together and each alone; a fault that Python finds is a `ProofError` with its place."""

    def check() -> int:
        from derive.declare import effects, quantities

        alone = (*effects.LAWS, *effects.ALL_EFFECTS)
        every = (*alone, *quantities.MOMENTS)
        stages.run("all declarations", "declare", "derive.guards:check", every, shown="")
        for e in alone:
            stages.run(e.name, "declare", "derive.guards:check_alone", e, shown="")
        return len(every)

    try:
        stages.line("declarations", "declare", check, "{} laws, effects and moments")
    except (ProofError, KeyboardInterrupt):
        raise
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        line = getattr(error, "lineno", place.lineno)
        file = Path(getattr(error, "filename", place.filename)).name
        found = f"{type(error).__name__}: {error}"
        raise ProofError(f"declarations, {file}, line {line}", found, "what Python can read") from None


def flow(stages: Stages, present: dict[str, str]) -> dict[str, str]:
    """Prove the balance and the operations on series, and return the files that depend on `derive.flow` by name.

    ``present`` are the texts of the present files, which are returned where the records match them.
    """
    from derive.declare.effects import EFFECTS, LAWS, SECTION_EFFECTS
    from derive.flow.fragments import CALLABLE
    from derive.flow.linked import cases

    def prove() -> int:
        claims = []
        for effects, laws in cases(EFFECTS, (*LAWS, CALLABLE)):
            of_effects = " ".join(x.name for x in effects)
            of_laws = " ".join(x.name for x in laws)
            case = f"{of_effects}, {of_laws}"
            claims += stages.run(case, "balance", "derive.flow.linked:prove_case", effects, laws, shown="")
        return len(claims)

    stages.line("flow", "balance", prove, "{} claims proved")
    stages.run("phase plane", "balance", "derive.algebra.phase_plane:prove", shown="{}")
    stages.run("flow", "closed form", "derive.flow.closed:prove", shown="{}")
    stages.run("pieces of records", "balance", "derive.algebra.pieces:prove", shown="{}")
    stages.run("flow", "pieces", "derive.flow.sliding:prove", shown="{}")
    stages.run("flow", "series", "derive.flow.recurrences:prove", 6, shown="{}")
    return stages.files("flow", "derive.generate.write:flow_files", present, LAWS, EFFECTS, SECTION_EFFECTS)


def derive_all(stages: Stages | None = None) -> dict[str, str]:
    """Derive and prove everything, and return the text of `generated` by file; progress is printed on stderr.

    Without ``stages`` no record is used.
    """
    from derive.algebra.slopes import MEANS, SLOPES
    from derive.declare.quantities import MOMENTS
    from derive.generate.write import present_files

    stages = stages or Stages(again=True)
    shown = "operations {0[operations][0]} -> {0[operations][1]}, quadrature within {0[difference]}"
    for moment in MOMENTS:
        stages.run(moment.name, "integrate", "derive.algebra.integrate:recorded", moment, shown=shown)
    stages.run("equation of motion", "balance", "derive.algebra.dynamics:prove", shown="{}")
    of_slopes = [moment for moment in MOMENTS if moment.name in MEANS | SLOPES]
    stages.run("slopes", "balance", "derive.algebra.slopes:prove", *of_slopes, shown="{}")
    texts = present_files()
    of_flow = flow(stages, texts)
    of_slope = stages.files("slopes", "derive.generate.write:slope_files", texts, *of_slopes)
    return of_flow | of_slope | stages.files("kernels", "derive.generate.write:kernel_files", texts)


class Command(NamedTuple):
    """A command: its help, and the formats of its report with their help."""

    help: str
    forms: dict[str, str]


_JSON = {"json": "a list of objects on stdout"}
COMMANDS = {
    "flow": Command("derive and prove only what depends on derive/flow", {}),
    "verify": Command(
        "judge the paper: a table of its wrong claims and misprints, or selected claims in full",
        _JSON | {"markdown": "a page for a colleague"},
    ),
    "hard": Command("the hard cases: errors of the printed form, of the kernel and of solve", {}),
    "prove": Command("prove the error bounds of the kernels again, from their certificates alone", {}),
    "theorem": Command(
        "enclose and prove the motion of an arc with friction; without a quantity, of the slide of Vaiont",
        {"json": "an object for the given slide, or a list with the slides of Vaiont"},
    ),
}
# Quantities of `theorem`: decimals, which are exact, and may have an uncertainty: 10+-0.1.
QUANTITIES = {
    "radius-m": "of the arc",
    "theta-1-deg": "polar angle of its first end about the centre, counterclockwise; 270 is straight below",
    "theta-2-deg": "of its second end",
    "friction-deg": "angle of friction; the residual one if there is a peak",
    "peak-friction-deg": "angle of friction at the start, which falls exponentially with slip",
    "length-m": "slip in which it falls by a factor of e",
    "cohesion-kPa": "needs the unit weight",
    "pore-pressure-kPa": "on the arc, constant; needs the unit weight",
    "unit-weight-kN-m3": "of the mass",
    "gravity-m-s2": "by default 9.81",
}


def _parser() -> argparse.ArgumentParser:
    """Return the parser of the command line, with the options of all commands."""
    parser = argparse.ArgumentParser(
        "python -m derive",
        description="Derive and prove everything, and write generated/; or judge the paper.",
        epilog="exit status: 0 done, 1 generated/ is stale or a check failed, 2 a wrong call or a missing package",
    )
    parser.add_argument("--check", action="store_true", help="write nothing; show a diff and exit 1 if stale")
    parser.add_argument("--again", action="store_true", help="prove everything again, in spite of the records")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", title="commands")
    for name, (words, forms) in COMMANDS.items():
        command = commands.add_parser(name, help=words, description=f"{words[0].upper()}{words[1:]}.")
        choice = command.add_mutually_exclusive_group() if forms else command
        for form, shown in forms.items():
            choice.add_argument(f"--{form}", dest="form", action="store_const", const=form, default="text", help=shown)
        if name == "verify":
            command.add_argument("claims", nargs="*", metavar="CLAIM", help='place of a claim: 3.15, "Table 4-1", ...')
            command.add_argument("--verdict", metavar="VERDICT", help="report the claims with this verdict: wrong, ...")
            choice.add_argument("--all", action="store_true", help="report all claims in full")
        if name == "theorem":
            _add_quantities(command)
    return parser


def _add_quantities(command: argparse.ArgumentParser) -> None:
    """Add the options of `theorem`: the quantities of a slide, its effects, digits and parts."""
    for quantity, help in QUANTITIES.items():
        command.add_argument(f"--{quantity}", metavar="X", default=argparse.SUPPRESS, help=help)
    for effect, help in {"rotation": "the mass slides as it stands", "centripetal": "speed does not press"}.items():
        suppressed = argparse.SUPPRESS
        command.add_argument(f"--no-{effect}", dest=effect, action="store_false", default=suppressed, help=help)
    command.add_argument("--digits", type=int, choices=range(5, 101), default=20, metavar="N", help="5 to 100 (20)")
    parts = "most parts into which uncertain inputs are divided, 1 to 100000 (2000)"
    command.add_argument("--parts", type=int, choices=range(1, 100001), default=2000, metavar="N", help=parts)


def _prove_motion(options: argparse.Namespace) -> int:
    """Print the theorem on the slide of these options; return 1 if the input is refused or nothing can be decided."""
    from derive.theorem.report import theorem_report

    given = vars(options)
    chosen = {name: given[name] for name in given if name.replace("_", "-") in (*QUANTITIES, "rotation", "centripetal")}
    try:
        text, decided = theorem_report(chosen, options.digits, options.form, options.parts)
    except ValueError as faults:
        say(str(faults))
        return 1
    print(text)
    return 0 if decided else 1


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0 is success, 1 a stale `generated` or a failed check, 2 a wrong call or a missing package."""
    options = _parser().parse_args(argv)
    needed = ("flint",) if options.command in ("prove", "theorem") else ("sympy", "mpmath", "flint")
    if missing := [name for name in needed if find_spec(name) is None]:
        say(f"python -m derive needs {' and '.join(missing)}: pip install 'slipcircle[derive]'")
        return 2
    if options.command not in ("prove", "theorem"):
        for note in Stages().other_versions():
            say(note)
    if options.command == "prove":
        from derive.check import certify

        return 0 if certify.prove_all() else 1
    if options.command == "theorem":
        return _prove_motion(options)
    if options.command == "verify":
        from derive.judge import report

        width = 100 if sys.stdout.isatty() or not options.all else sys.maxsize
        try:
            print(report.judge_paper(options.form, width, options.claims, options.verdict, options.all))
        except ValueError as fault:
            say(f"python -m derive verify: {fault}")
            return 2
        return 0
    if options.command == "hard":
        from derive.judge import hard

        print(hard.hard_case_report())
        return 0
    return generate(options.check, options.again, options.command)


def generate(check: bool, again: bool = False, part: str | None = None) -> int:
    """Derive everything, or the flow, and write `generated` and the records, or compare them with the files there.

    Nothing is written with ``check``. With ``again`` records are ignored, and any ``part`` means the flow alone. The
    result is the exit status.
    """
    start = time.perf_counter()
    stages = Stages(again)
    try:
        declare(stages)
        from derive.build import build_all, has_binary_alone
        from derive.generate import write

        present = write.present_files()
        texts = present | flow(stages, present) if part else derive_all(stages)
        if check:
            expected = {name: text for name, text in texts.items() if not has_binary_alone(name, text)}
            diff = write.difference(expected)
            print(f"{diff}generated/ is stale: run `{write.MEND}`" if diff else "generated/ is up to date")
            return 1 if diff else 0
        changed = write.write(texts, tried=write.importable)
    except ProofError as fault:
        say(f"{fault}; nothing is written")
        return 1
    stages.save(keep=bool(part))
    stages.line("kernels", "compile", build_all, "{0[1]}")
    seconds = time.perf_counter() - start
    say(f"{'generated':<32} {'write':<11} {seconds:6.2f} s  in all; changed: {', '.join(changed) or 'nothing'}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        say("interrupted")
        sys.exit(130)
