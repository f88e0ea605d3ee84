"""The compiler `python -m derive [--check | --again]`, and `python -m derive verify | hard | prove | theorem`.

=======  =======================================================  =====================================================
stage    input                                                    output
=======  =======================================================  =====================================================
declare  `derive.declare`: moments, laws, effects                 the same without a fault, or one line about the first
lower    a moment; effects and laws                               closed form and approximants; fragments of programs
link     fragments                                                programs of scenes (`derive.flow`)
write    approximants, fragments, linker, templates               the files of `generated`, compiled
prove    each result above                                        claims, certificates, or `ProofError`
=======  =======================================================  =====================================================

It derives if sources, libraries or files have changed since the recorded run (`derive.stages`), or with ``--again``.
"""

import argparse
import sys
import time
import traceback
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from derive import stages
from derive.check.proof import ProofError
from derive.kinds import TextDict, Texts
from derive.progress import say
from derive.stages import stage


def declare() -> None:
    """Check the declarations, together and each alone; a fault that Python finds is a `ProofError` with its place."""

    def check() -> int:
        from derive import guards
        from derive.declare import effects, quantities

        alone = (*effects.LAWS, *effects.ALL_EFFECTS)
        every = (*alone, *quantities.MOMENTS)
        guards.check(every)
        for e in alone:
            guards.check_alone(e)
        return len(every)

    try:
        stage("declarations", "declare", check, "{} laws, effects and moments")
    except (ProofError, KeyboardInterrupt):
        raise
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        line = getattr(error, "lineno", place.lineno)
        file = Path(getattr(error, "filename", place.filename)).name
        found = f"{type(error).__name__}: {error}"
        raise ProofError(f"declarations, {file}, line {line}", found, "what Python can read") from None


def flow() -> TextDict:
    """Prove the balance and the operations on series, and return the files that depend on `derive.flow` by name."""
    from derive.algebra import phase_plane, pieces
    from derive.flow import closed, linked, recurrences, sliding
    from derive.generate import write

    stage("flow", "balance", linked.prove)
    stage("phase plane", "balance", phase_plane.prove)
    stage("flow", "closed form", closed.prove)
    stage("pieces of records", "balance", pieces.prove)
    stage("flow", "pieces", sliding.prove)
    stage("flow", "series", recurrences.prove)
    return stage("flow", "write", write.flow_files, "")


def derive_all() -> TextDict:
    """Derive and prove everything, and return the text of `generated` by file; progress is printed on stderr."""
    from derive.algebra import dynamics, integrate, slopes
    from derive.declare.quantities import MOMENTS
    from derive.generate import write

    for moment in MOMENTS:
        compared = partial(integrate.compare, integrate.derive(moment), 30)
        stage(moment.name, "integrate", compared, "quadrature within {}")
    stage("equation of motion", "balance", dynamics.prove)
    stage("slopes", "balance", slopes.prove)
    return write.slope_files() | write.kernel_files() | flow()


COMMANDS = {
    "verify": "judge the paper: a table of its wrong claims and misprints, or selected claims in full",
    "hard": "the hard cases: errors of the printed form, of the kernel and of solve",
    "prove": "prove the error bounds of the kernels again, from their certificates alone",
    "theorem": "enclose and prove the motion of an arc with friction; without a quantity, of the slide of Vaiont",
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
    parser.add_argument("--again", action="store_true", help="prove everything again, in spite of the record")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", title="commands")
    by_name = {}
    for name, words in COMMANDS.items():
        by_name[name] = commands.add_parser(name, help=words, description=f"{words[0].upper()}{words[1:]}.")
    verify = by_name["verify"]
    verify.add_argument("claims", nargs="*", metavar="CLAIM", help='place of a claim: 3.15, "Table 4-1", ...')
    verify.add_argument("--verdict", metavar="VERDICT", help="report the claims with this verdict: wrong, ...")
    choice = verify.add_mutually_exclusive_group()
    choice.add_argument("--json", action="store_true", help="a list of objects on stdout")
    choice.add_argument("--markdown", action="store_true", help="a page for a colleague")
    choice.add_argument("--all", action="store_true", help="report all claims in full")
    _add_quantities(by_name["theorem"])
    return parser


def _add_quantities(command: argparse.ArgumentParser) -> None:
    """Add the options of `theorem`: the quantities of a slide, its effects, digits and parts."""
    of_json = "an object for the given slide, or a list with the slides of Vaiont"
    command.add_argument("--json", action="store_true", help=of_json)
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
        text, decided = theorem_report(chosen, options.digits, "json" if options.json else "text", options.parts)
    except ValueError as faults:
        say(str(faults))
        return 1
    print(text)
    return 0 if decided else 1


def main(argv: Texts | None = None) -> int:
    """Run the command; 0 is success, 1 a stale `generated` or a failed check, 2 a wrong call or a missing package."""
    options = _parser().parse_args(argv)
    without_sympy = options.command in ("prove", "theorem")
    needed = ("flint",) if without_sympy else ("sympy", "mpmath", "flint")
    if missing := [name for name in needed if find_spec(name) is None]:
        say(f"python -m derive needs {' and '.join(missing)}: pip install 'slipcircle[derive]'")
        return 2
    if not without_sympy:
        for note in stages.other_versions():
            say(note)
    if options.command == "prove":
        from derive.check import certify

        return 0 if certify.prove_all() else 1
    if options.command == "theorem":
        return _prove_motion(options)
    if options.command == "verify":
        from derive.judge import report

        width = 100 if sys.stdout.isatty() or not options.all else sys.maxsize
        form = "json" if options.json else "markdown" if options.markdown else "text"
        try:
            print(report.judge_paper(form, width, options.claims, options.verdict, options.all))
        except ValueError as fault:
            say(f"python -m derive verify: {fault}")
            return 2
        return 0
    if options.command == "hard":
        from derive.judge import hard

        print(hard.hard_case_report())
        return 0
    return generate(options.check, options.again)


def generate(check: bool, again: bool) -> int:
    """Derive everything, and write `generated` and the record, or compare them with the files there.

    Nothing is written with ``check``, and with ``again`` the record is ignored. The result is the exit status.
    """
    start = time.perf_counter()
    try:
        declare()
        from derive.build import build_all, has_binary_alone
        from derive.generate import write

        present = write.present_files()
        if not again and stages.record(present) == stages.recorded():
            texts = present
        else:
            texts = derive_all()
        if check:
            expected = {name: text for name, text in texts.items() if not has_binary_alone(name, text)}
            diff = write.difference(expected)
            print(f"{diff}generated/ is stale: run `{write.MEND}`" if diff else "generated/ is up to date")
            return 1 if diff else 0
        changed = write.write(texts, tried=write.importable)
    except ProofError as fault:
        say(f"{fault}; nothing is written")
        return 1
    stages.save(texts)
    stage("kernels", "compile", build_all, "{0[1]}")
    seconds = time.perf_counter() - start
    say(f"{'generated':<32} {'write':<11} {seconds:6.2f} s  in all; changed: {', '.join(changed) or 'nothing'}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        say("interrupted")
        sys.exit(130)
