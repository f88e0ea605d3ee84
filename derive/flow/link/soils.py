"""Fragments of single soils: the shared fragments of laws and effects with the names of one soil.

Each soil with a separate law of friction or of cohesion has an instance of the law and of its effect. Their number,
``#0`` or ``#c0``, marks names that are not shared.
"""

from collections.abc import Mapping
from typing import Any

from derive.flow.link.definitions import OF_COHESION, OF_SOIL
from derive.flow.lowering import Fragment

# Quantity that a law of one soil supplies, by the effect that takes it.
LAW_OF_EFFECT = {"soil_friction": "soil_mu", "softening_cohesion": "cohesion_law"}


def fragments_of(known: Mapping[str, Fragment], name: str, turns: bool) -> list[Fragment]:
    """Return the fragments of an effect or a law, of one soil if its name contains a number.

    The fragments ``known`` are shared by all soils, and ``turns`` is whether the mass rotates.

    The effect ``soil_friction#0`` includes the weight of its soil.
    """
    shared_name, mark, soil = name.partition(OF_SOIL)
    if not mark:
        return [known[name]]
    number = mark + soil
    own = _numbered(known, shared_name, number)
    if shared_name not in LAW_OF_EFFECT:  # a law, of which the effect takes the coefficient
        quantity = LAW_OF_EFFECT["softening_cohesion" if number.startswith(OF_COHESION) else "soil_friction"]
        return [own._replace(adds={quantity + number: own.adds["mu"]})]
    if shared_name == "softening_cohesion":
        return [own]
    weights = ["gravity", "rotation"] if turns else ["gravity"]
    return [own, *(_numbered(known, weight, number)._replace(adds={}, series=()) for weight in weights)]


def _numbered(known: Mapping[str, Fragment], shared_name: str, number: str) -> Fragment:
    """Return the shared fragment of a name with the names of one soil: ``dsoil_mu#0`` for the number ``#0``."""
    of_one_soil = set(LAW_OF_EFFECT.values())
    for effect in LAW_OF_EFFECT:
        of_one_soil.update(known[effect].inputs, (table for table, *_ in known[effect].tables))
    fragment = known[shared_name]
    tables = {table for table, *_ in fragment.tables}
    numbered = tables | _results(fragment)

    def of_soil(item: Any) -> Any:
        if isinstance(item, tuple):
            return tuple(map(of_soil, item))
        if not isinstance(item, str):
            return item
        quantity = item.removesuffix("_0").removeprefix("d")
        if quantity in of_one_soil:
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
    for _, names, *_ in fragment.series:
        results.update(names)
    for _, kind, argument, _ in fragment.tables:
        if kind == "time":
            results.add(argument)
    return results
