"""What a schema says of a place in a file: the keys that a table takes, and what each means."""

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple, TypeAlias, cast

from vrts.schemas import input_schema

Node: TypeAlias = Mapping[str, Any]

_NOTHING: Node = {}


class Key(NamedTuple):
    """A key that a table takes."""

    name: str
    about: str  # what it means, with its unit
    kind: str  # "number from 0 to 10000", "one of can, base", "table"
    value: str  # as it may be written: a default, or an empty value of its kind
    is_table: bool
    is_list: bool  # of tables: `[[ ]]`
    required: bool


@cache
def top(kind: str) -> Node:
    """Return the schema of a kind of file, one of `vrts.schemas.KINDS`."""
    return cast("Node", json.loads(input_schema(kind)))


def nodes_at(kind: str, path: Sequence[str]) -> list[Node]:
    """Return what a schema says of a table or a value; several where it may be one of several."""
    found = list(_forms(top(kind)))
    for name in path:
        found = [form for node in found for child in _child(node, name) for form in _forms(child)]
    return found


def keys_at(kind: str, path: Sequence[str]) -> list[Key]:
    """Return the keys that the table at a path takes, each once."""
    known: dict[str, Key] = {}
    for node in nodes_at(kind, path):
        required = set(node.get("required", ()))
        for name, child in node.get("properties", {}).items():
            known.setdefault(name, _key(name, child, required=name in required))
    return list(known.values())


def key_at(kind: str, path: Sequence[str], name: str) -> Key | None:
    """Return a key of the table at a path; None where it takes none of this name."""
    found: Key | None = None
    for node in nodes_at(kind, path):
        for child in _child(node, name):
            found = found or _key(name, child, required=name in node.get("required", ()))
    choices = choices_at(kind, (*path, name)) if found is not None else []
    if found is not None and len(choices) > 1:
        return found._replace(kind=_one_of(choices))
    return found


def choices_at(kind: str, path: Sequence[str]) -> list[str]:
    """Return the values that the value at a path may have, as they are written; none: any."""
    found: dict[str, None] = {}
    for node in nodes_at(kind, path):
        for value in node.get("enum", ()):
            found[_written(value)] = None
        if node.get("type") == "boolean":
            found |= dict.fromkeys(("true", "false"))
    return list(found)


def _forms(node: Node) -> Iterator[Node]:
    """Yield the forms of a node: itself, or what it may be; of a list those of its elements."""
    yield node
    for form in node.get("anyOf", ()):
        yield from _forms(form)
    items = node.get("items")
    if isinstance(items, dict):
        yield from _forms(cast("Node", items))


def _child(node: Node, name: str) -> Iterator[Node]:
    properties = node.get("properties", _NOTHING)
    if name in properties:
        yield properties[name]
        return
    others = node.get("additionalProperties")
    if isinstance(others, dict):
        yield cast("Node", others)
    yield from node.get("patternProperties", _NOTHING).values()


def _key(name: str, node: Node, *, required: bool) -> Key:
    forms = list(_forms(node))
    first = next((form for form in forms if "type" in form), _NOTHING)
    items = node.get("items")
    holds_tables = isinstance(items, dict) and any(
        form.get("type") == "object" for form in _forms(cast("Node", items))
    )
    is_list = node.get("type") == "array" and holds_tables
    about = next((str(form["description"]) for form in forms if "description" in form), "")
    return Key(
        name,
        about,
        _kind(node, forms),
        _value(first),
        first.get("type") == "object",
        is_list,
        required,
    )


def _kind(node: Node, forms: Sequence[Node]) -> str:
    choices = [_written(value) for form in forms for value in form.get("enum", ())]
    if choices:
        return _one_of(choices)
    kind = {"object": "table", "array": "list", "string": "text", "boolean": "true or false"}.get(
        str(node.get("type", "")), str(node.get("type", ""))
    )
    if "minimum" in node or "maximum" in node:
        above = "above" if node.get("exclusiveMinimum") else "from"
        kind += f" {above} {node['minimum']:g}" if "minimum" in node else ""
        kind += f" to {node['maximum']:g}" if "maximum" in node else ""
    least, most = node.get("minItems"), node.get("maxItems")
    if least is not None or most is not None:
        kind += f" of {least}" if least == most else f" of {least or 0} to {most}" if most else ""
    if "default" in node:
        kind += f"; left out: {_written(node['default'])}"
    return kind


def _one_of(choices: Sequence[str]) -> str:
    return "one of " + ", ".join(choices[:12]) + (", …" if len(choices) > 12 else "")


def _value(node: Node) -> str:
    if "default" in node:
        return _written(node["default"])
    empty = {"string": '""', "array": "[]", "boolean": "true", "number": "0", "integer": "0"}
    return empty.get(str(node.get("type", "")), "")


def _written(value: object) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool):
        return "true" if value else "false"
    return json.dumps(value)
