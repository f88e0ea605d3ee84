"""Runs too long for every day, ``python -m tests.campaigns.NAME``; tests run a sample of each."""

import argparse
from typing import Any


def options(doc: str | None, count: int | None = None, /, *flags: str, **others: Any) -> argparse.Namespace:
    """Return the options of a campaign: how many cases, by default ``count``, the seed, switches, and others.

    The first line of ``doc`` describes the campaign. Each keyword is an option with its arguments of `add_argument`.
    """
    parser = argparse.ArgumentParser(description=str(doc).partition("\n")[0])
    parser.add_argument("count", metavar="COUNT", type=int, nargs="?", default=count, help="cases (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (%(default)s)")
    for flag in flags:
        parser.add_argument(flag, action="store_true")
    for name, arguments in others.items():
        parser.add_argument(f"--{name}", **arguments)
    return parser.parse_args()
