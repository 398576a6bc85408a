"""The tables of a file: each object in a JSON Schema, with the path at which it stands."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

Schema = Mapping[str, Any]


class Table(NamedTuple):
    """One place in a file that holds keys, and what may stand there: one schema or several."""

    path: tuple[str, ...]  # empty: the file itself; NAME where a name is free
    many: bool  # a list of such tables
    says: str
    shapes: tuple[Schema, ...]

    @property
    def heading(self) -> str:
        """How TOML writes it."""
        inner = ".".join(self.path)
        return f"[[{inner}]]" if self.many else f"[{inner}]"


def tables(schema: Schema) -> Iterator[Table]:
    """Yield the file itself and every table in it, each before what is in it.

    What is named by a `$ref` is left out: it has a section of its own.
    """
    yield from _within(Table((), many=False, says="", shapes=(schema,)))


def shapes(schema: Schema) -> list[Schema]:
    """Return the objects with keys of their own that a value may be."""
    if "$ref" in schema:
        return []
    alternatives = schema.get("anyOf") or schema.get("oneOf")
    if alternatives:
        return [shape for one in alternatives for shape in shapes(one)]
    return [schema] if schema.get("properties") else []


def place_of(path: tuple[str, ...], schema: Schema) -> tuple[tuple[str, ...], bool, list[Schema]]:
    """Return where the keys of a value stand, whether many stand there, and their schemas."""
    found = shapes(schema)
    if found:
        return path, False, found
    for one in (schema, *(schema.get("anyOf") or schema.get("oneOf") or ())):
        if one.get("type") == "array" and isinstance(one.get("items"), dict):
            inner, _, found = place_of(path, one["items"])
            if found:
                return inner, True, found
        if isinstance(one.get("additionalProperties"), dict):
            inner, many, found = place_of((*path, "NAME"), one["additionalProperties"])
            if found:
                return inner, many, found
    return path, False, []


def _within(table: Table) -> Iterator[Table]:
    yield table
    seen: set[tuple[str, ...]] = set()
    for shape in table.shapes:
        for key, value in shape.get("properties", {}).items():
            path, many, found = place_of((*table.path, key), value)
            if found and path not in seen:
                seen.add(path)
                says = str(value.get("description", ""))
                yield from _within(Table(path, many, says, tuple(found)))
