"""Command line: `python -m derive [--check]`, `python -m derive verify`, `python -m derive hard`."""

import argparse
import sys
import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")
USAGE = "python -m derive [--check | verify [--json | --markdown] | hard [--json]]"


def say(line: str) -> None:
    """Progress, on stderr."""
    print(line, file=sys.stderr, flush=True)


def timed(what: str, stage: str, work: Callable[[], T], told: Callable[[T], str] = lambda _: "") -> T:
    """Do one stage and say how long it took and what came of it."""
    start = time.perf_counter()
    result = work()
    say(f"{what:<32} {stage:<11} {time.perf_counter() - start:6.2f} s  {told(result)}")
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
    from derive import dynamics, functions, integrate, measure, stable, write
    from derive.appendices import APPENDICES, simplify
    from derive.quantities import MOMENTS

    derivations = []
    for moment in MOMENTS:
        derivation = timed(moment.name, "integrate", lambda m=moment: integrate.derive(m), lambda d: f"operations {d.operations[0]} -> {d.operations[1]}")
        timed(moment.name, "quadrature", lambda d=derivation: integrate.compare(d, 30), lambda e: f"relative difference {e}")
        derivations.append(derivation)
    for name, closed in functions.closed_amplitudes(derivations).items():
        timed(name, "stable form", lambda n=name, c=closed: stable.prove_kernel(n, c), lambda _: "proved equal to the closed form")
    for appendix in APPENDICES:
        timed(appendix.name, "simplify", lambda x=appendix: simplify(x),
              lambda p: f"operations {p.operations_before} -> {p.operations_after}, integrates {p.integrand}")  # fmt: skip
    timed("equation of motion", "balance", dynamics.balance, lambda s: f"({'), ('.join(s)}) derived")
    timed("equation of motion", "solve", dynamics.prove_forms, lambda c: f"{len(c)} claims proved")
    texts = timed("generated", "emit", lambda: write.files(derivations), lambda f: f"{len(f)} files")
    timed("kernels", "measure", lambda: measure.worst(derivations), str)
    return texts


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0 is success, 1 a stale `generated` or a failed check, 2 a wrong call."""
    parser = argparse.ArgumentParser(prog="python -m derive", description="Derive, prove and write the package `generated`.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 and show a diff if `generated` is stale")
    commands = parser.add_subparsers(dest="command", metavar="{verify,hard}")
    verify = commands.add_parser("verify", help="judge every numbered equation, table entry and appendix of the paper")
    form = verify.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="a list of objects on stdout")
    form.add_argument("--markdown", action="store_true", help="a page for a colleague")
    hard = commands.add_parser("hard", help="the hard cases: error of the printed form beside ours")
    hard.add_argument("--json", action="store_true", help="a list of objects on stdout")
    options = parser.parse_args(argv)
    if options.command == "verify":
        from derive.verify import report

        print(report("json" if options.json else "markdown" if options.markdown else "table"))
        return 0
    if options.command == "hard":
        from derive.hard import report as hard_report

        print(hard_report("json" if options.json else "table"))
        return 0
    from derive import write

    start = time.perf_counter()
    texts = derive_all()
    if options.check:
        diff = write.difference(texts)
        print(f"{diff}generated/ is stale: run `{write.MEND}`" if diff else "generated/ is up to date")
        return 1 if diff else 0
    changed = write.write(texts)
    say(f"{'generated':<32} {'write':<11} {time.perf_counter() - start:6.2f} s  in all; {', '.join(changed) or 'nothing'} changed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
