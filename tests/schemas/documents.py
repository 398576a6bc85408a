"""Documents beside their schemas: what JSON Schema sees of a TOML file, and TOML made of values."""

import json
import tomllib
from collections.abc import Iterator
from datetime import date, datetime, time
from functools import cache
from typing import Any, TypeAlias, cast

from jsonschema import Draft4Validator

from vrts.schemas import input_schema

Document: TypeAlias = dict[str, Any]
Path: TypeAlias = tuple[str | int, ...]


@cache
def schema(kind: str) -> dict[str, Any]:
    """Return the schema of a kind of file."""
    return json.loads(input_schema(kind))


@cache
def _validator(kind: str) -> Any:
    return Draft4Validator(schema(kind))


def refusals(kind: str, text: str) -> list[str]:
    """Return what the schema has against the text of a file."""
    return [
        f"{'.'.join(map(str, one.absolute_path))}: {one.message[:300]}"
        for one in _validator(kind).iter_errors(_plain(tomllib.loads(text)))
    ]


def _plain(value: Any) -> Any:
    """Return a value as JSON has it: times as text."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in cast("Document", value).items()}
    if isinstance(value, list):
        return [_plain(item) for item in cast("list[Any]", value)]
    return value.isoformat() if isinstance(value, datetime | date | time) else value


def toml_of(document: Document) -> str:
    """Return a document as TOML: a header for each table of the top, a line for all other keys."""
    tables: dict[str, Document] = {
        key: value for key, value in document.items() if isinstance(value, dict)
    }
    found = [
        f"{_key(key)} = {_value(value)}\n" for key, value in document.items() if key not in tables
    ]
    for name, table in tables.items():
        found.append(f"[{_key(name)}]\n")
        found += [f"{_key(key)} = {_value(value)}\n" for key, value in table.items()]
    return "".join(found)


def _key(key: str) -> str:
    return json.dumps(key)


def _value(value: Any) -> str:
    if isinstance(value, dict):
        fields = cast("Document", value).items()
        inside = ", ".join(f"{_key(key)} = {_value(item)}" for key, item in fields)
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list):
        return f"[{', '.join(map(_value, cast('list[Any]', value)))}]"
    if isinstance(value, datetime):
        return value.isoformat()
    return json.dumps(value)


def keys(value: Any, path: Path = ()) -> Iterator[Path]:
    """Give the way to every key of a document."""
    if isinstance(value, dict):
        for key, item in cast("Document", value).items():
            yield (*path, key)
            yield from keys(item, (*path, key))
    elif isinstance(value, list):
        for index, item in enumerate(cast("list[Any]", value)):
            yield from keys(item, (*path, index))


def at(document: Any, path: Path) -> Any:
    """Return what stands at a place of a document."""
    for step in path:
        document = document[step]
    return document
