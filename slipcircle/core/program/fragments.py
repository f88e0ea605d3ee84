"""Fragments of programs by name: those of `generated.flow`, and the same with the names of one soil.

Each soil with a friction law of its own has an instance of the law and of the effect ``soil_friction``; its number,
``#0``, marks the names that are not shared.
"""

from typing import Any

from generated.effects import ALL_EFFECTS
from generated.flow import FRAGMENTS, Fragment
from slipcircle.core.program.link import RESULTS
from slipcircle.core.scene.effects import soil_number, without_soil

_OF_ONE_SOIL = {str(p.symbol) for p in ALL_EFFECTS["soil_friction"].parameters} | {"soil_mu"}


def fragment_of(name: str) -> Fragment:
    """A fragment by name; of one soil, ``soil_friction#0``, its names are those of that soil: ``dsoil_mu#0``."""
    shared_name = without_soil(name)
    fragment = FRAGMENTS[shared_name]
    number = soil_number(name)
    if not number:
        return fragment
    tables = {table for table, *_ in fragment.tables}
    numbered = tables | _results(fragment)

    def of_soil(item: Any) -> Any:
        if isinstance(item, tuple):
            return tuple(map(of_soil, item))
        if not isinstance(item, str):
            return item
        quantity = item.removesuffix("_0").removeprefix("d")
        if quantity in _OF_ONE_SOIL:
            return item.replace(quantity, quantity + number)
        prefix, dot, cell = item.partition(".")
        if dot and prefix in {*tables, shared_name}:
            return f"{prefix}{number}.{cell}"
        return item + number if item in numbered else item

    return fragment._replace(
        inputs=of_soil(fragment.inputs),
        scalar=of_soil(fragment.scalar),
        series=of_soil(fragment.series),
        adds={quantity: of_soil(added) for quantity, added in fragment.adds.items()},
        tables=of_soil(fragment.tables),
    )


def _results(fragment: Fragment) -> set[str]:
    """Names of the cells and registers that a fragment computes; a table of time provides its argument."""
    results = {operation[1] for operation in fragment.scalar}
    for kind, *names in fragment.series:
        count = RESULTS.get(str(kind), 1)
        results.update(map(str, names[:count]))
    for _, kind, argument, _ in fragment.tables:
        if kind == "time":
            results.add(argument)
    return results
