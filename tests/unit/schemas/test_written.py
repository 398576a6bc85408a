"""The schemas of input files are what their readers ask for, with a word about every key."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft4Validator

from tests.places import ROOT
from tests.schemas.asking import GETTERS
from tests.schemas.documents import schema
from tests.schemas.shape import OPEN
from tests.schemas.written import FOLDER, words, written
from vrts.schemas import KINDS

READERS = {  # where the keys of each kind of file are asked for
    "scene": [
        *(f"vrts/scene/reading/{name}.py" for name in ("scene_file", "robot_section")),
        *(f"vrts/scene/reading/{name}.py" for name in ("built_section", "form_section")),
        *(f"vrts/scene/reading/{name}.py" for name in ("gripper_section", "controller_section")),
    ],
    "lab": ["vrts/scene/reading/lab.py"],
    "task": [
        *sorted(str(p.relative_to(ROOT)) for p in ROOT.glob("vrts/check/task/*_file.py")),
        *sorted(str(p.relative_to(ROOT)) for p in ROOT.glob("vrts/check/rules/*.py")),
    ],
    "scenario": sorted(
        str(p.relative_to(ROOT)) for p in ROOT.glob("vrts/scene/reading/scenario_*")
    ),
    "environment": [f"vrts/prove/environment/{name}.py" for name in ("reading", "analog")],
    "columns": ["vrts/validate/log/columns_file.py"],
}
UNITS = {  # how a key ends, and what has to be said of it
    "_mm": "mm",
    "_deg": "degrees",
    "_s": "second",
    "_h": "hours",
    "_min": "minutes",
    "_percent": "percent",
    "_mm_s": "mm per second",
    "_deg_s": "degrees per second",
    "_xyzoat": "mm, then O, A, T in degrees",
}


def test_the_schemas_are_up_to_date() -> None:
    for kind, text in written().items():
        is_now = (FOLDER / f"{kind}.schema.json").read_text("utf-8")
        assert is_now == text, "`python -m tests.schemas` writes the schemas anew"


@pytest.mark.parametrize("kind", KINDS)
def test_a_schema_is_one(kind: str) -> None:
    Draft4Validator.check_schema(schema(kind))


@pytest.mark.parametrize("kind", KINDS)
def test_every_key_that_stands_in_a_reader_stands_in_the_schema(kind: str) -> None:
    known = {path.rpartition(".")[2] for path, _ in _keys(schema(kind))}
    asked = {key for reader in READERS[kind] for key in _literals(ROOT / reader)}
    assert asked
    assert asked - known == set(), "a probe in tests/schemas/probes has to lead there"


@pytest.mark.parametrize("kind", KINDS)
def test_every_key_says_what_it_is_and_its_unit(kind: str) -> None:
    for path, found in _keys(schema(kind)):
        said = found.get("description", "")
        assert said.endswith("."), path
        ends = [ending for ending in UNITS if path.endswith(ending)]
        if ends:
            assert UNITS[max(ends, key=len)] in said, path


def test_no_words_are_about_keys_that_nobody_asks_for() -> None:
    for kind in KINDS:
        known = {path for path, _ in _keys(schema(kind))} | {""} | set(OPEN)
        for about in words()[kind]:
            path = about.partition(":")[0]
            assert path in known or path in ("objects.*", "faults[]", "operator[]", "inputs[]"), (
                f"{kind}: {about}"
            )


def _keys(found: dict[str, Any], path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """Give every key of a schema, by its path, with what is said of it."""
    for one in found.get("anyOf", ()):
        yield from _keys(one, path)
    if isinstance(found.get("items"), dict):
        yield from _keys(found["items"], f"{path}[]")
    if isinstance(found.get("additionalProperties"), dict):
        yield from _keys(found["additionalProperties"], f"{path}.*")
    for key, value in found.get("properties", {}).items():
        inner = f"{path}.{key}" if path else key
        yield inner, value
        yield from _keys(value, inner)


def _literals(path: Path) -> Iterator[str]:
    """Give every key that a module asks a table for by name."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
            continue
        if node.func.attr in {*GETTERS, "named_tables"} and node.args:
            key = node.args[0]
            literal = key.value if isinstance(key, ast.Constant) else None
            if isinstance(literal, str) and re.fullmatch(r"[a-z_]+", literal):
                yield literal
