"""Fragments of programs for single soils: fragments of `generated.flow` with the names of one soil.

Each soil with a separate friction law has an instance of the law and of the effect ``soil_friction``. Its number,
``#0``, marks names that are not shared.
"""

from typing import Any

from generated.effects import ALL_EFFECTS
from generated.flow import FRAGMENTS, RESULTS, Fragment
from generated.program import OF_COHESION
from slipcircle.core.scene.effects import soil_number, without_soil

_EFFECTS = (ALL_EFFECTS["soil_friction"], ALL_EFFECTS["softening_cohesion"])
_OF_ONE_SOIL = {p.symbol for effect in _EFFECTS for p in effect.parameters if p.symbol} | {"soil_mu", "cohesion_law"}


def fragments_of(name: str, turns: bool) -> list[Fragment]:
    """Return the fragments of a soil's law, ``linear#0``, or of its effect, ``soil_friction#0``, with its weight."""
    shared_name, number = without_soil(name), soil_number(name)
    own = _numbered(shared_name, number)
    if shared_name not in ALL_EFFECTS:  # a law, of which the effect takes the coefficient
        quantity = "cohesion_law" if number.startswith(OF_COHESION) else "soil_mu"
        return [own._replace(adds={quantity + number: own.adds["mu"]})]
    if number.startswith(OF_COHESION):
        return [own]
    weights = ["gravity", "rotation"] if turns else ["gravity"]
    return [own, *(_numbered(weight, number)._replace(adds={}, series=()) for weight in weights)]


def _numbered(shared_name: str, number: str) -> Fragment:
    """Return a fragment with the names of one soil: ``dsoil_mu#0``."""
    fragment = FRAGMENTS[shared_name]
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
    """Return the names of the cells and registers that a fragment computes. A table of time supplies its argument."""
    results = {operation[1] for operation in fragment.scalar}
    for kind, *names in fragment.series:
        count = RESULTS.get(str(kind), 1)
        results.update(map(str, names[:count]))
    for _, kind, argument, _ in fragment.tables:
        if kind == "time":
            results.add(argument)
    return results
