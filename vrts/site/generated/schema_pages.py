"""Every file key by key, made of the JSON Schemas that `vrts schema` prints."""

import json
import re
from collections.abc import Iterator, Mapping
from typing import cast

import click
from click.testing import CliRunner

from vrts.cli.schema_command import command
from vrts.site.generated.markdown import anchor, code, contents, text
from vrts.site.generated.markdown import table as markdown_table
from vrts.site.generated.schema_tables import Schema, Table, place_of, tables


def schema_pages() -> dict[str, str]:
    """Return a page for each schema, by their names in `look-up/files`."""
    schemas = {name: _printed(name) for name in schema_names()}
    pages = {name: schema_page(name, found) for name, found in schemas.items()}
    return {**pages, "index": _index(schemas)}


def schema_names() -> tuple[str, ...]:
    """Return what `vrts schema` takes."""
    choices = next(p.type for p in command.params if isinstance(p.type, click.Choice))
    return tuple(str(choice) for choice in choices.choices)


def _printed(name: str) -> Schema:
    answer = CliRunner().invoke(command, [name])
    if answer.exit_code:
        raise RuntimeError(f"`vrts schema {name}` failed: {answer.output}")
    return json.loads(answer.stdout)


def schema_page(name: str, schema: Schema) -> str:
    """Return the page of one file: its keys, then those of each table in it."""
    definitions: Mapping[str, Schema] = schema.get("$defs", {})
    pieces = [f"(file-{name})=\n# {_title(name, schema)}\n"]
    if schema.get("description"):
        pieces.append(text(schema["description"]) + "\n")
    pieces.append(f"`vrts schema {name}` prints this as a JSON Schema.\n")
    top = definitions.get(_reference(schema), schema)
    pieces += [_table(name, table) for table in tables(top)]
    shown = {_reference(schema)}
    queue = list(_references(top))
    while queue:
        reference = queue.pop(0)
        if reference in shown or reference not in definitions:
            continue
        shown.add(reference)
        found = definitions[reference]
        queue += _references(found)
        pieces.append(
            f"({anchor('file', name, reference)})=\n## {text(_heading(reference, found))}\n"
        )
        if found.get("description"):
            pieces.append(text(found["description"]) + "\n")
        pieces.append(_keys(name, (reference,), found))
    return "\n".join(pieces)


def _title(name: str, schema: Schema) -> str:
    return text(str(schema.get("title") or name))


def _heading(reference: str, found: Schema) -> str:
    return str(found.get("title") or reference)


def _table(name: str, table: Table) -> str:
    """Return a heading, and the keys of each thing that a table may be."""
    pieces: list[str] = []
    if table.path:
        pieces.append(f"({_label(name, table.path)})=\n## {code(table.heading)}\n")
    if table.says:
        pieces.append(text(table.says) + "\n")
    for shape in table.shapes:
        if len(table.shapes) > 1 and shape.get("title"):
            pieces.append(f"### {text(shape['title'])}\n")
        pieces.append(_keys(name, table.path, shape))
    return "\n".join(pieces)


def _label(name: str, path: tuple[str, ...]) -> str:
    return anchor("file", name, "at", *path)


def _keys(name: str, path: tuple[str, ...], schema: Schema) -> str:
    properties: Mapping[str, Schema] = schema.get("properties", {})
    if not properties:
        return f"{_kind(schema, name)}\n"
    needed = set(schema.get("required", ()))
    rows = [
        (
            code(key) + (" *(needed)*" if key in needed else ""),
            _value(name, (*path, key), found),
            _default(found),
            text(str(found.get("description", ""))),
        )
        for key, found in properties.items()
    ]
    head = ("key", "what it is", "left out", "meaning")
    kept = [i for i in range(len(head)) if i < 2 or any(row[i] for row in rows)]
    return markdown_table([head[i] for i in kept], ([row[i] for i in kept] for row in rows))


def _value(name: str, path: tuple[str, ...], schema: Schema) -> str:
    """Return what a value is; where it holds keys of its own, a link to them."""
    inner, many, found = place_of(path, schema)
    if not found:
        return _kind(schema, name)
    heading = Table(inner, many, "", ()).heading
    return f"[{code(heading)}](#{_label(name, inner)})"


def _default(schema: Schema) -> str:
    if "default" not in schema:
        return ""
    written = json.dumps(schema["default"], ensure_ascii=False)
    return code(written) if len(written) <= 40 else "see the schema"


def _kind(schema: Schema, name: str) -> str:
    """Return in words what a value has to be."""
    if "$ref" in schema:
        reference = _reference(schema)
        return f"[{text(reference)}](#{anchor('file', name, reference)})"
    if "const" in schema:
        return code(json.dumps(schema["const"]))
    if "enum" in schema:
        return ", ".join(code(json.dumps(value)) for value in schema["enum"])
    for several in ("anyOf", "oneOf"):
        if several in schema:
            kinds = dict.fromkeys(_kind(found, name) for found in schema[several])
            return " or ".join(kinds)
    return _plain(schema, name)


def _plain(schema: Schema, name: str) -> str:
    kind = schema.get("type", "anything")
    if isinstance(kind, list):
        return " or ".join(_plain({**schema, "type": one}, name) for one in cast("list[str]", kind))
    if kind == "array":
        return _array(schema, name)
    if kind == "object" and isinstance(schema.get("additionalProperties"), dict):
        return f"table of {_kind(schema['additionalProperties'], name)} by name"
    words = {"object": "table", "string": "text", "boolean": "`true` or `false`", "null": "nothing"}
    return words.get(kind, str(kind)) + _limits(schema)


def _array(schema: Schema, name: str) -> str:
    if schema.get("prefixItems"):
        return "list: " + ", ".join(_kind(found, name) for found in schema["prefixItems"])
    least, most = schema.get("minItems"), schema.get("maxItems")
    count = f"{least} " if least is not None and least == most else ""
    words = _kind(schema.get("items") or {}, name)
    many = re.sub(r"^(number|integer)", r"\1s", words) if count or words.startswith("n") else words
    return f"list of {count}{many}"


def _limits(schema: Schema) -> str:
    low, high = schema.get("minimum"), schema.get("maximum")
    above, below = schema.get("exclusiveMinimum"), schema.get("exclusiveMaximum")
    said = [
        _limit("more than", low) if above is True else _limit("at least", low),
        _limit("less than", high) if below is True else _limit("at most", high),
        "" if isinstance(above, bool) else _limit("more than", above),
        "" if isinstance(below, bool) else _limit("less than", below),
        f"of the form {code(schema['pattern'])}" if "pattern" in schema else "",
    ]
    return "".join(f", {words}" for words in said if words)


def _limit(words: str, number: float | None) -> str:
    return "" if number is None else f"{words} {number:g}"


def _reference(schema: Schema) -> str:
    return str(schema.get("$ref", "")).rpartition("/")[2]


def _references(schema: object) -> Iterator[str]:
    """Yield the definitions that a schema refers to, in its order."""
    if isinstance(schema, dict):
        known = cast("Schema", schema)
        if "$ref" in known:
            yield _reference(known)
        for value in known.values():
            yield from _references(value)
    elif isinstance(schema, list):
        for value in cast("list[object]", schema):
            yield from _references(value)


def _index(schemas: Mapping[str, Schema]) -> str:
    rows = "".join(
        f"- [{name}](#file-{name}): {_title(name, found)}\n" for name, found in schemas.items()
    )
    return (
        "# Files, key by key\n\nWhat may stand in the files that you write, and what stands in "
        "those that vrts writes. Each page is made of what `vrts schema` prints.\n\n"
        f"{rows}\n{contents(schemas, hidden=True)}"
    )
