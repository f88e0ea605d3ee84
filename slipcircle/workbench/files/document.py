"""Validation of a TOML document against the tables of a scene file, with conversion to SI units.

All mistakes are reported together, each with its path in the file, the value and the allowed values. For an unknown key
the message suggests a similar known key, which is then not reported as missing.
"""

import json
import math
import re
from collections.abc import Mapping
from difflib import get_close_matches
from itertools import chain
from typing import Any

from slipcircle.base.kinds import TextDict, TextMap, TextPair, Texts, ValueDict, Values
from slipcircle.ground import points_errors
from slipcircle.tree import path_of_part
from slipcircle.workbench.common.distributions import distribution_mistakes, distribution_of
from slipcircle.workbench.common.units import UNITS_OF_KEYS, published, spelt_like, suffix
from slipcircle.workbench.files.keys import VARYING, Key, KeyTable

_UNITS = re.compile(f"_(deg|s|{'|'.join(suffix(next(iter(units))) for units in UNITS_OF_KEYS.values())})$")


class Document:
    """Validated content of a scene file, and the mistakes found in it.

    Attributes
    ----------
    arguments : dict of dict
        Values by path of the table and name of the argument, in SI units; a distribution is replaced by its median.
    typed : dict
        Key in the file by argument, both as paths such as ``friction.angle_deg`` and ``friction.coefficient``.
    uncertain : dict
        Distributions (mappings) by key, in the order that samples follow.
    mistakes : list of str
        A message for each mistake.
    wrong : set of str
        Names of the top-level tables that contain a mistake.
    """

    def __init__(self, content: Values, tables: Mapping[str, KeyTable]) -> None:
        self.arguments: dict[str, ValueDict] = {}
        self.typed: TextDict = {}
        self.uncertain: ValueDict = {}
        self.mistakes: Texts = []
        self.wrong: set[str] = set()
        self._tables = tables
        self._odd_distributions: dict[str, Texts] = {}
        self._missing: TextDict = {}
        self._meant: set[str] = set()  # keys that were misspelt
        self._read_table("", content)
        for path, words in self._missing.items():
            if path in self._meant:
                self._report(path)
            else:
                self._report(path, f"{path}: is missing: {words}")
        self._put_in_order_of_samples()

    def _report(self, path: str, *sentences: str) -> None:
        """Store messages about a path such as "friction.angle_deg", and mark its top-level table as wrong."""
        self.mistakes.extend(sentences)
        self.wrong.add(path.partition(".")[0])

    def _put_in_order_of_samples(self) -> None:
        """Sort the distributions into the order of samples, and put their mistakes first."""
        order = [path_of_part(path, name) for path, table in self._tables.items() for name in table.keys]

        def place(key: str) -> int:
            return order.index(published(key)[0])

        self.uncertain = {key: self.uncertain[key] for key in sorted(self.uncertain, key=place)}
        odd = chain.from_iterable(self._odd_distributions[key] for key in sorted(self._odd_distributions, key=place))
        self.mistakes = [*odd, *self.mistakes]

    def _read_table(self, path: str, content: Values) -> None:
        """Read a table and the tables inside it into `arguments`, and report its mistakes.

        `path` is the path of the table in the file, empty for the top level.
        """
        arguments = self.arguments.setdefault(path, {})
        table = self._tables[path]
        if table.is_of_unknown_law:
            content = {"law": content["law"]}
        spelt: TextDict = {}  # keys as typed, by their published spelling
        for name, value in content.items():
            full = path_of_part(path, name)
            spelling, *_ = published(name)
            if spelling not in table.keys:
                spelling = name
            if spelling in spelt:
                self._report(full, f"{path_of_part(path, spelt[spelling])} and {full}: are one quantity; remove one")
            elif name in table.tables and isinstance(value, dict):
                self._read_table(full, value)
            elif name in table.tables:
                self._report(full, f"{full} = {shown_value(value)}: must be {self._described(full)}")
            elif spelling in table.keys:
                key = table.keys[spelling]
                self.typed[path_of_part(path, key.name)] = path_of_part(path, spelling)
                arguments[key.name] = self._argument(full, key.spelt(name), value, content, table)
            else:
                meant, advice = _advice(path, name, self._tables)
                self._meant.add(meant)
                self._report(full, f"{full} = {shown_value(value)}: is unknown; {advice}")
            spelt.setdefault(spelling, name)
        self._report_mixed_units(path, table, spelt)
        self._note_missing(path, spelt)
        self._check_sets(path, spelt)
        self._check_choices(path, spelt)

    def _report_mixed_units(self, path: str, table: KeyTable, spelt: TextMap) -> None:
        """Report quantities of one table that are given in different units.

        `spelt` maps the published spelling of each key to the key as typed.
        """
        units: dict[str, TextDict] = {}
        for spelling, name in spelt.items():
            if spelling in table.keys:
                quantity = units.setdefault(table.keys[spelling].unit, {})
                quantity.setdefault(published(name)[1], path_of_part(path, name))
        for typed in units.values():
            if len(typed) > 1:
                words = " and ".join(f"{key} in {unit}" for unit, key in typed.items())
                self._report(path, f"{words}: are mixed units in one table; give both in one unit")

    def _described(self, path: str) -> str:
        """Return the heading of a table and its title, for messages."""
        return f"{self._heading(path)}: {self._tables[path].title}"

    def _heading(self, path: str) -> str:
        """Return the heading of a table as a file writes it, such as "a table [water]" or "tables [[layers]]".

        `path` is the path of the table.
        """
        if self._tables[path].repeats == "numbered":
            return f"tables [[{path}]]"
        return f"a table [{path}]"

    def _argument(self, full: str, key: Key, value: Any, content: Values, table: KeyTable) -> Any:
        """Return a value in SI units, or the median of a distribution; report a wrong value and return None.

        `full` is the path of the key in the file, and `content` are all keys of its table.
        """
        if isinstance(value, dict) and key.kind in VARYING:
            odd = distribution_mistakes(value, (key.low, key.high))
            if odd:
                self._odd_distributions[full] = [f"{full}: {mistake}" for mistake in odd]
                self._report(full)
                return None
            self.uncertain[full] = value
            value = float(distribution_of(value).ppf(0.5))
        wrong = []
        for place, entry in key.wrong(value):
            advice = _question(key, entry, table)
            wrong.append(f"{full}{place} = {shown_value(entry)}: must be {key.allowed}{advice}")
        if key.kind == "points" and not wrong:
            wrong += points_errors(full, value, many=False)
        if key.kind == "series" and isinstance(value, list) and "time_s" not in content:
            needs = "is a list, which needs a list of times, time_s, in the same table; or give one number"
            wrong.append(f"{full} = {shown_value(value)}: {needs}")
        if wrong:
            self._report(full, *wrong)
            return None
        return key.convert(value)

    def _note_missing(self, path: str, content: Values) -> None:
        """Collect the missing required keys and tables; they are reported when all misspelt keys are known.

        `path` is the path of the table, and `content` has its keys in their published spelling.
        """
        for name, key in self._tables[path].keys.items():
            if not key.optional and name not in content:
                self._missing[path_of_part(path, name)] = f"{key.help}, {key.allowed}"
        for name, table in self._tables[path].tables.items():
            full = path_of_part(path, name)
            if table.required and name not in content:
                self._missing[full] = f"{table.title}, {self._heading(full)}"

    def _check_sets(self, path: str, content: Values) -> None:
        """Report a table whose keys do not match exactly one of its sets.

        `content` has its keys in their published spelling.
        """
        sets = self._tables[path].sets
        present = {key for keys in sets for key in keys if key in content}
        misspelt = any(key.startswith(path_of_part(path, "")) for key in self._meant)
        if not sets or present in map(set, sets) or misspelt:
            return
        fault = "keys are missing"
        if present:
            fault = f"{' and '.join(sorted(present))} do not go together"
        allowed = [" with ".join(keys) for keys in sets]
        self._report(path, f"{path}: {fault}; give {', or '.join(allowed)}")

    def _check_choices(self, path: str, content: Values) -> None:
        """Report a table without exactly one key of a choice, or without any key of `any_of`.

        `content` has its keys in their published spelling.
        """
        table = self._tables[path]
        for choice in table.one_of:
            present = [key for key in choice if key in content]
            if len(present) > 1:
                self._report(path, f"{path}: {' and '.join(present)} exclude each other; remove one")
        for choice in (*table.one_of, table.any_of):
            paths = [path_of_part(path, key) for key in choice]
            if not choice or any(key in content for key in choice):
                continue
            if self._meant.isdisjoint(paths):
                title = table.keys[choice[-1]].help
                self._report(path, f"{path}: {' or '.join(choice)} is missing: {title}")
            else:
                self._report(path)


def shown_value(value: Any) -> str:
    """Return a value in the notation of a scene file, shortened to 60 characters."""
    if isinstance(value, bool | float):
        text = str(value).lower()
    else:
        text = json.dumps(value, default=str, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}..."


def _question(key: Key, entry: Any, table: KeyTable) -> str:
    """Return additional advice on a wrong value: the key's title, and a similar word, another unit or an angle.

    `entry` is the wrong value, or the wrong item of a list.
    """
    title = f": {key.help}"
    if "|" in key.kind or key.name == "law":
        choice = table.laws or key.kind.split("|")
        for word in get_close_matches(str(entry), choice, 1):
            title += f"; did you mean {word}?"
        return title
    is_number = isinstance(entry, int | float) and not isinstance(entry, bool)
    if not is_number or not abs(entry) < math.inf:
        return title
    low = key.limits.get("gt", 0.0)
    high = key.high
    if entry > high and key.per_unit == 1e3:
        meant = f"was {entry / 1e3:g} {key.written} meant, which are {entry:g} {key.unit}?"
        bound = "" if f"{high:g}" in key.allowed else f", at most {high:g}"
        return f"{title}{bound}; {meant}".replace("^", "")
    angles = [k for k, other in table.keys.items() if other.tangent and other.name == key.name]
    if entry >= high and angles and not key.tangent:
        return f"{title}; an angle? say {angles[0]}"
    beyond = 0.0 < entry <= low or abs(entry) >= high
    if beyond and f"{high:g}" not in key.allowed:
        return f"{title}; between {low:g} and {high:g}: is that another unit?"
    return title


def _advice(path: str, unknown: str, tables: Mapping[str, KeyTable]) -> TextPair:
    """Return the path of the known key most similar to an unknown one ("" if none), and advice in words.

    In the same table, a similar key or the only key with the same unit is suggested. In other tables, only an almost
    identical key is suggested.
    """
    typed = unknown
    unknown, _, _ = published(typed)
    if unknown == "reach_m":
        return "", "use run_out_m, which is the greatest displacement"
    within = {path: list(table.keys) for path, table in tables.items()}
    for table in filter(None, tables):
        parent, _, key = table.rpartition(".")
        within[parent].append(key)
    here = within[path]
    laws = [law for law, table in tables[path].laws.items() if unknown in table.keys]
    if laws:
        law = tables[path].keys["law"].kind
        return f"{path}.{here[-1]}", f"it belongs to law = {' or '.join(laws)}, and the law is {law}; give law"
    key = _similar(unknown, here, tables[path])
    if key:
        return path_of_part(path, key), f"did you mean {spelt_like(typed, key)}?"
    for table in tables:
        for key in get_close_matches(unknown, within[table], 1, 0.9):
            place = f" in [{table}]" if table else " above the first table"
            return path_of_part(table, key), f"did you mean {spelt_like(typed, key)}{place}?"
    if not here:
        return "", "this table has no keys"
    return "", f"known are {', '.join(here)}"


def _similar(unknown: str, here: Texts, table: KeyTable) -> str:
    """Return the key or table most similar to an unknown key, or the only key with its unit; "" without a candidate.

    `here` are the keys and tables allowed at this place.
    """
    units = {key: ending[1] for key in (unknown, *here) if (ending := _UNITS.search(key))}
    of_unit = [key for key in here if key in units and units[key] == units.get(unknown)]
    similar = get_close_matches(unknown, here, 1)
    if not similar:
        return of_unit[0] if len(of_unit) == 1 else ""
    arguments = {name: key.name for name, key in table.keys.items()}
    argument = arguments.get(similar[0], "")
    same = [key for key in of_unit if arguments.get(key) == argument]
    return next(iter(same), similar[0])  # for coefficient_deg not coefficient, but angle_deg
