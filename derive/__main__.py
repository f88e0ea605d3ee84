"""Command line: `python -m derive [--check]`, `python -m derive verify | hard | prove`."""

import argparse
import sys
import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


def say(line: str) -> None:
    """Progress, on stderr."""
    print(line, file=sys.stderr, flush=True)


def timed(what: str, stage: str, told: str, work: Callable[..., T], *args: object) -> T:
    """Do one stage, and say how long it took and what came of it; ``{0}`` in ``told`` is the result."""
    start = time.perf_counter()
    result = work(*args)
    say(f"{what:<32} {stage:<11} {time.perf_counter() - start:6.2f} s  {told.format(result)}")
    return result


def derive_all() -> dict[str, str]:
    """Derive and prove everything, and return the text of `generated`; progress goes to stderr.

    Returns
    -------
    dict
        Text by file name.

    Raises
    ------
    ProofError
        If a step of the derivation does not hold.
    """
    from derive.algebra import dynamics, integrate, phase, sensitivity, slopes, stable
    from derive.check import measure
    from derive.code import functions, write
    from derive.declare import effects
    from derive.declare.quantities import MOMENTS
    from derive.flow import operations
    from derive.judge.appendices import APPENDICES, simplify

    derivations = []
    for moment in MOMENTS:
        told = "operations {0.operations[0]} -> {0.operations[1]}"
        derivation = timed(moment.name, "integrate", told, integrate.derive, moment)
        timed(moment.name, "quadrature", "worst relative difference {0}", integrate.compare, derivation, 30)
        derivations.append(derivation)
    kernels = {f.program.name: f for f in functions.kernels(derivations)}
    for name, closed in functions.closed_amplitudes(derivations).items():
        timed(name, "stable form", "proved equal to the closed form", stable.prove_kernel, name, closed)
        takes = f"{sum(kernels[name].program.operations().values())} float operations"
        timed(name, "measure", takes + ", worst error {0:.1f} ulp", measure.worst, kernels[name], closed)
    for appendix in APPENDICES:
        told = "operations {0.operations_before} -> {0.operations_after}, integrates {0.integrand}"
        timed(f"appendix {appendix.name}", "simplify", told, simplify, appendix)
    timed("equation of motion", "balance", "(2.20), (3.8)-(3.18), (3.21) derived", dynamics.balance)
    timed("equation of motion", "solve", "{0} claims proved", lambda: len(dynamics.prove_forms()))
    timed("flow", "series", "{0} operations proved", lambda: len(operations.prove()))
    timed("friction laws", "solve", "{0} claims proved", lambda: len(effects.prove_laws()))
    timed("phase plane", "solve", "{0} claims proved", lambda: len(phase.prove_energies()))
    for what, prove in (("phase plane", sensitivity.prove_energy_slopes), ("frozen", sensitivity.prove_frozen_slopes),
                        ("short motions", sensitivity.prove_energy_growth)):  # fmt: skip
        timed(what, "slopes", "{0} claims proved", lambda prove=prove: len(prove()))
    timed("slopes", "balance", "{0} claims proved", lambda: len(slopes.prove()))
    closed = functions.closed_amplitudes(derivations)
    timed("arc", "slopes", "{0} claims proved", lambda: len(sensitivity.prove_arc_growth(closed)))
    proved = timed("kernels", "certify", "", write.proofs)
    return timed("generated", "emit", "", write.files, derivations, proved)


def binary() -> str:
    """Compile what has another source than its binary, and say what serves now."""
    from derive.build import PARTS, NoBinaryError, build

    try:
        return ", ".join(build(name=name).name for name in PARTS)
    except NoBinaryError as error:
        return f"NumPy serves: {error}"


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0 is success, 1 a stale `generated` or a failed check, 2 a wrong call."""
    parser = argparse.ArgumentParser(
        "python -m derive",
        description="Derive and prove everything, and write generated/; or judge the paper.",
        epilog="exit status: 0 done, 1 generated/ is stale or a check failed, 2 a wrong call",
    )
    parser.add_argument("--check", action="store_true", help="write nothing; show a diff and exit 1 if stale")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", title="commands")

    def command(name: str, words: str) -> argparse.ArgumentParser:
        return commands.add_parser(name, help=words, description=f"{words[0].upper()}{words[1:]}.")

    verify = command("verify", "judge every numbered equation, table entry and appendix of the paper")
    form = verify.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="a list of objects on stdout")
    form.add_argument("--markdown", action="store_true", help="a page for a colleague")
    hard = command("hard", "the hard cases: error of the printed form beside ours")
    hard.add_argument("--json", action="store_true", help="a list of objects on stdout")
    command("prove", "prove the error bounds of the kernels again, from their certificates alone")
    options = parser.parse_args(argv)
    if options.command == "prove":
        from derive.check.certify import prove_all

        return 0 if prove_all() else 1
    if options.command == "verify":
        from derive.judge.verify import report

        print(report("json" if options.json else "markdown" if options.markdown else "table"))
        return 0
    if options.command == "hard":
        from derive.judge.hard import report as hard_report

        print(hard_report("json" if options.json else "table"))
        return 0
    from derive.code import write

    start = time.perf_counter()
    texts = derive_all()
    if options.check:
        diff = write.difference(texts)
        print(f"{diff}generated/ is stale: run `{write.MEND}`" if diff else "generated/ is up to date")
        return 1 if diff else 0
    changed = write.write(texts)
    timed("kernels", "compile", "{0}", binary)
    seconds = time.perf_counter() - start
    say(f"{'generated':<32} {'write':<11} {seconds:6.2f} s  in all; changed: {', '.join(changed) or 'nothing'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
