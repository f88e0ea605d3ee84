"""Fragments of programs by name: those of `generated.flow`, and the same with the names of one soil.

Each soil with a friction law of its own has an instance of the law and of the effect ``soil_friction``; its number,
``#0``, marks the names that are not shared.
"""

from typing import Any

from generated.effects import ALL_EFFECTS
from generated.flow import FRAGMENTS, Fragment
from slipcircle.core.flow.link import RESULTS
from slipcircle.core.scene.friction import soil_number, without_soil

_OF_ONE_SOIL = {str(p.symbol) for p in ALL_EFFECTS["soil_friction"].parameters} | {"soil_mu"}


def fragment_of(name: str) -> Fragment:
    """A fragment by name; of one soil, ``soil_friction#0``, its names are those of that soil: ``dsoil_mu#0``."""
    fragment = FRAGMENTS[without_soil(name)]
    number = soil_number(name)
    if not number:
        return fragment
    results = {operation[1] for operation in fragment.scalar}
    for names in fragment.series:
        count = RESULTS.get(str(names[0]), 1)
        results.update(map(str, names[1 : count + 1]))
    tables = {table for table, *_ in fragment.tables}
    results.update(argument for _, kind, argument, _ in fragment.tables if kind == "time")

    def renamed(item: Any) -> Any:
        if not isinstance(item, str):
            return tuple(map(renamed, item)) if isinstance(item, tuple) else item
        quantity = item.removesuffix("_0").removeprefix("d")
        if quantity in _OF_ONE_SOIL:
            return item.replace(quantity, quantity + number)
        table, dot, cell = item.partition(".")
        if dot and (table in tables or table == without_soil(name)):
            return f"{table}{number}.{cell}"
        return item + number if item in results or item in tables else item

    return fragment._replace(
        inputs=renamed(fragment.inputs),
        scalar=tuple((operation[0], *renamed(operation[1:])) for operation in fragment.scalar),
        series=tuple((operation[0], *renamed(operation[1:])) for operation in fragment.series),
        adds={quantity: renamed(added) for quantity, added in fragment.adds.items()},
        tables=renamed(fragment.tables),
    )
