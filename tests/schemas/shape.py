"""From questions of readers to a JSON Schema, of draft 4: the one that editors of TOML know."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias, cast

from tests.schemas.asking import DISCRIMINATORS, Asked, Question

Schema: TypeAlias = dict[str, Any]
Words: TypeAlias = Mapping[str, str]

OPEN = {
    "objects": "objects.*",
    "locations": "",
    "parameters": "",
    "variants.without[]": "",
}  # whose keys are names
REFUSED = {("robot", "urdf", "name")}  # asked for, to say so
DATE_TIME = r"^\d{4}-\d\d-\d\d[Tt ]\d\d:\d\d.*([Zz]|[+-]\d\d:\d\d)$"
CHANGING = ("title", "name")  # defaults that depend on the name of the file, or a number


def schema_of(where: str, notes: Sequence[Asked], words: Words) -> Schema:
    """Return the schema of the table with a pattern, and of all in it."""
    own = [note for note in notes if note.pattern == where]
    if where in OPEN:
        return _open(where, own, notes, words)
    variants = sorted({note.variant for note in own if note.variant is not None})
    if not variants:
        return _closed(where, own, None, notes, words)
    return {
        "anyOf": [
            _closed(where, [note for note in own if note.variant == one], one, notes, words)
            for one in variants
        ]
    }


def _closed(
    where: str, own: Sequence[Asked], variant: str | None, notes: Sequence[Asked], words: Words
) -> Schema:
    """Return the schema of a table that has none but the keys that are asked for."""
    by_key: dict[str, list[Question]] = {}
    for note in own:
        if (where, variant, note.key) not in REFUSED:
            by_key.setdefault(note.key, []).append(note.question)
    tables = {note.table for note in own}
    required = [
        key
        for key, questions in by_key.items()
        if all(question.required for question in questions)
        and {note.table for note in own if note.key == key} == tables
    ]
    found: Schema = {"type": "object"}
    title = words.get(f"{where}:{variant}") if variant is not None else None
    if title is not None:
        found["title"] = title
    found["properties"] = {
        key: _value(where, key, questions, variant, notes, words)
        for key, questions in by_key.items()
    }
    if required:
        found["required"] = sorted(required)
    found["additionalProperties"] = False
    return found


def _open(where: str, own: Sequence[Asked], notes: Sequence[Asked], words: Words) -> Schema:
    inner = OPEN[where]
    if inner:
        return {"type": "object", "additionalProperties": schema_of(inner, notes, words)}
    values = [note for note in own if note.question.kind in ("number", "numbers", "array")]
    value = plain([note.question for note in values])
    if where == "locations":  # with numbers of its own, or after another one
        value = {"anyOf": [value, schema_of("locations.*", notes, words)]}
    if where == "parameters":
        return _named_anyhow({note.key.lower() for note in values}, value)
    return {"type": "object", "additionalProperties": value}


def _named_anyhow(names: set[str], value: Schema) -> Schema:
    """Return the schema of a table with known names, in letters of either kind.

    A name with a dot may stand in quotation marks or without: then it is a table in the table.
    """
    found: Schema = {_either(name): value for name in sorted(names)}
    for group in sorted({name.split(".", 1)[0] for name in names if "." in name}):
        own = {name.split(".", 1)[1] for name in names if name.startswith(f"{group}.")}
        found[_either(group)] = _named_anyhow(own, value)
    return {"type": "object", "patternProperties": found, "additionalProperties": False}


def _either(name: str) -> str:
    letters = (f"[{c.upper()}{c}]" if c.isalpha() else f"\\{c}" for c in name)
    return f"^{''.join(letters)}$"


def _value(
    where: str,
    key: str,
    questions: Sequence[Question],
    variant: str | None,
    notes: Sequence[Asked],
    words: Words,
) -> Schema:
    path = f"{where}.{key}" if where else key
    kinds = sorted({question.kind for question in questions})
    found: list[Schema] = []
    for kind in kinds:
        if kind == "table":
            found.append(schema_of(path, notes, words))
        elif kind == "tables":
            inner = schema_of(f"{path}[]", notes, words)
            found.append({"type": "array", "items": inner})
        else:
            found.append(plain([question for question in questions if question.kind == kind]))
    schema = found[0] if len(found) == 1 else {"anyOf": found}
    if variant is not None and DISCRIMINATORS.get(where) == key:
        schema = {"type": "string", "enum": [variant.split(",", 1)[0]]}
    said = words.get(f"{path}:{variant}", words.get(path))
    if said is not None:
        schema = {"description": said, **schema}
    default = _default(key, questions)
    return schema if default is None else {**schema, "default": default}


def plain(questions: Sequence[Question]) -> Schema:
    """Return the schema of a value that is no table."""
    choices = _same(question.choices for question in questions)
    match questions[0].kind:
        case "string":
            return {"type": "string"} | ({} if choices is None else {"enum": list(choices)})
        case "number":
            return {"type": "number", **_bounds(questions)}
        case "integer":
            return {"type": "integer", **_bounds(questions)}
        case "boolean":
            return {"type": "boolean"}
        case "time":
            return {"type": "string", "format": "date-time", "pattern": DATE_TIME}
        case "numbers":
            items = {"type": "number", **_bounds(questions)}
            counts = _same(question.counts for question in questions)
            length = {} if not counts else {"minItems": min(counts), "maxItems": max(counts)}
            return {"type": "array", "items": items, **length}
        case "strings":
            return {"type": "array", "items": {"type": "string"}}
        case "array":
            return {"type": "array", "minItems": 1}
        case "names":
            one: Schema = {"type": "string"} | ({} if choices is None else {"enum": list(choices)})
            many = {"type": "array", "items": one, "minItems": 1, "uniqueItems": True}
            return {"anyOf": [one, many]}
        case kind:
            raise AssertionError(f"a table is no plain value: {kind}")


def _bounds(questions: Sequence[Question]) -> Schema:
    """Return the bounds of a number: those alone that do not depend on the rest of the file."""
    least = _same(question.minimum for question in questions)
    above = _same(question.above for question in questions)
    most = _same(question.maximum for question in questions)
    found: Schema = {}
    if above is not None:
        found |= {"minimum": above, "exclusiveMinimum": True}
    elif least is not None:
        found["minimum"] = least
    if most is not None:
        found["maximum"] = most
    return found


def _default(key: str, questions: Sequence[Question]) -> object:
    default = _same(question.default for question in questions)
    if default is None or default == () or key in CHANGING:
        return None
    if isinstance(default, tuple):
        return list(cast("tuple[object, ...]", default))
    return default if isinstance(default, str | bool | int) else float(default)  # type: ignore[arg-type]


def _same(values: Iterable[Any]) -> Any:
    """Return the value that all have; None where they differ."""
    found = list(values)
    return found[0] if all(value == found[0] for value in found) else None
