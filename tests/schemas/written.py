"""The schemas as they are to be: made by asking the readers, with words from `words.toml`."""

import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from tests.places import ROOT
from tests.schemas.asking import Asked, asked
from tests.schemas.probes import KINDS, PROBES, READERS, library, scene_of, source_of
from tests.schemas.shape import Schema, Words, schema_of

FOLDER = ROOT / "vrts" / "schemas"
DRAFT = "http://json-schema.org/draft-04/schema#"  # all that Taplo knows


def written() -> Mapping[str, str]:
    """Return the text of every schema by its kind of file."""
    return {kind: json.dumps(_schema(kind), indent=2) + "\n" for kind in KINDS}


@cache
def questions(kind: str) -> tuple[Asked, ...]:
    """Return what the readers of a kind of file ask, over all probes and the library."""
    found: list[Asked] = []
    for path, scene in probes(kind):
        with asked() as notes:
            READERS[kind](source_of(path), scene, folder_of(path))
        found += [note for note in notes if _of(kind, note)]
    return tuple(found)


def probes(kind: str) -> Iterator[tuple[Path, Any]]:
    """Return the files that are asked about, each with the scene that it is set in."""
    own = sorted(PROBES.glob(f"{kind}-*.toml"))
    for path in own:
        named = re.search(r'^scene = "(.*)"', path.read_text("utf-8"), re.M)
        for scene in (named[1],) if named else ("cans-on-bases", "one-can-ur5"):
            needed = kind in ("task", "scenario")
            yield path, scene_of(library(scene)) if needed else None
    if kind == "scene":
        for path in sorted((ROOT / "scenes").glob("*/scene.toml")):
            yield path, None


def folder_of(path: Path) -> Path:
    """Return where what a file names is: of a probe, the arm that the library describes.

    Only the pieces of a mesh lie beside their probe.
    """
    elsewhere = path.parent == PROBES and path.stem != "scene-mesh"
    return library("one-can-urdf").parent if elsewhere else path.parent


@cache
def words() -> Mapping[str, Words]:
    """Return what is said of keys, by kind of file."""
    return tomllib.loads((PROBES.parent / "words.toml").read_text("utf-8"))


def words_of(kind: str) -> Words:
    """Return what is said of the keys of a kind of file; a lab's are those of a scene too."""
    own = dict(words()[kind])
    if kind in ("scene", "lab"):
        scene = dict(words()["scene"])
        parts = ("robot", "gripper", "controller")
        own = {f"lab.{key}": text for key, text in scene.items() if key.startswith(parts)} | own
        own = {**scene, **words()["lab"], **own}
    return own


def _of(kind: str, note: Asked) -> bool:
    """Return whether a question is about a file itself, not what it is laid over."""
    return kind != "lab" or note.pattern.startswith("lab") or note.pattern == "objects.*"


def _schema(kind: str) -> Schema:
    notes = questions(kind)
    said = words_of(kind)
    if kind == "lab":
        body: Schema = {
            "type": "object",
            "properties": {"lab": {"description": said["lab"], **_lab()}},
            "required": ["lab"],
            "additionalProperties": False,
        }
    else:
        body = schema_of("", notes, said)
    if kind == "scene":
        body["properties"]["lab"] = {"description": said["lab"], **_lab()}
    if kind == "task":
        _with_environment(body)
    return {"$schema": DRAFT, "title": said[""], **body}


def _lab() -> Schema:
    """Return the schema of `[lab]`; its table says what it likes of a table."""
    said = words_of("lab")
    notes = questions("lab")
    found = schema_of("lab", notes, said)
    tables = schema_of("objects.*", [n for n in questions("scene") if n.variant == "table"], said)
    (table,) = tables["anyOf"]
    del table["required"]
    found["properties"]["table"] = {"description": said["lab.table"], **table}
    described = schema_of("robot", [n for n in questions("scene") if n.variant == "urdf"], said)
    needed = [key for key in described["anyOf"][0]["required"] if key != "urdf"]
    found["properties"]["robot"]["dependencies"] = {"urdf": needed}
    return found


def _with_environment(task: Schema) -> None:
    """Let `environment` of `[prove]` be a file, or an environment in the task itself."""
    prove = task["properties"]["prove"]["properties"]
    inner = {key: value for key, value in _schema("environment").items() if key != "$schema"}
    said = words_of("task")["prove.environment"]
    prove["environment"] = {"description": said, "anyOf": [{"type": "string"}, inner]}
