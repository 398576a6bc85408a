"""What the readers of TOML files ask for: every key, of which kind, within which bounds.

While `asked()` holds, the getters of `Table` note what they are asked. So a schema made of these
questions is what the readers read, and nothing that somebody thinks they read.
"""

import re
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from functools import wraps
from typing import Any, NamedTuple

from vrts.base.toml.reading import Table

# tables whose keys are names: [objects.can1]
NAMED = {"objects": "objects.*", "locations": "locations.*"}
GETTERS = {
    "string": "string",
    "number": "number",
    "fraction": "number",
    "integer": "integer",
    "boolean": "boolean",
    "time": "time",
    "numbers": "numbers",
    "strings": "strings",
    "names": "names",
    "array": "array",
    "table": "table",
    "tables": "tables",
}
DISCRIMINATORS = {  # the key that says of which kind a table is
    "objects.*": "kind",
    "faults[]": "kind",
    "operator[]": "does",
    "inputs[]": "is",
}


class Question(NamedTuple):
    """What a reader asks about one key."""

    kind: str  # a value of `GETTERS`
    choices: tuple[str, ...] | None = None
    minimum: float | None = None
    maximum: float | None = None
    above: float | None = None
    counts: tuple[int, ...] | None = None  # lengths that a list may have
    required: bool = False
    default: object = None


class Asked(NamedTuple):
    """One question about one table."""

    pattern: str  # of the table: "", "objects.*", "goal[].place[]"
    variant: str | None  # of the table's kind, where there are several
    table: int  # which one: questions about one table have the same number
    key: str
    question: Question


@contextmanager
def asked() -> Generator[list[Asked]]:
    """Note every question that readers ask."""
    notes: list[Asked] = []
    kept: list[Table] = []  # so that no number is given twice
    usual = {name: getattr(Table, name) for name in GETTERS}
    for name, kind in GETTERS.items():
        setattr(Table, name, _noting(usual[name], kind, notes, kept))
    try:
        yield notes
    finally:
        for name, function in usual.items():
            setattr(Table, name, function)


def _noting(
    function: Callable[..., Any], kind: str, notes: list[Asked], kept: list[Table]
) -> Callable[..., Any]:
    @wraps(function)
    def noting(self: Table, key: str, *args: Any, **given: Any) -> Any:
        kept.append(self)
        where = pattern(self.path)
        notes.append(
            Asked(where, _variant(where, self), id(self), key, _question(kind, args, given))
        )
        return function(self, key, *args, **given)

    return noting


def pattern(path: str) -> str:
    """Return the path of a table without names and numbers: "goal[].place[]"."""
    plain = re.sub(r" \d+", "[]", path)
    for parent, instead in NAMED.items():
        plain = re.sub(rf"^{parent}\.[^.]+", instead, plain)
    return plain


def variant(where: str, fields: Mapping[str, object]) -> str | None:
    """Return of which kind a table is: "can"; None where a table has but one, or does not say."""
    if where == "robot":  # that of a lab may be laid over either
        return "urdf" if "urdf" in fields else "name"
    said = fields.get(DISCRIMINATORS.get(where, ""))
    if where == "objects.*" and said == "base":
        return "base, round" if "radius_mm" in fields else "base, square"
    return said if isinstance(said, str) else None


def _variant(where: str, table: Table) -> str | None:
    return variant(where, table._fields)  # pyright: ignore[reportPrivateUsage]


def _question(kind: str, args: tuple[Any, ...], given: Mapping[str, Any]) -> Question:
    choices, count = given.get("choices"), given.get("count")
    return Question(
        kind,
        None if choices is None else tuple(choices),
        given.get("minimum"),
        given.get("maximum"),
        given.get("above"),
        (count,) if isinstance(count, int) else count,
        bool(given.get("required", False)),
        given.get("default", args[0] if args else None),
    )
