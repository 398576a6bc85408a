"""A schema and its reader agree: on every file that there is, and on files made wrong."""

import copy
import re
import tomllib
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.schemas.documents import Document, at, keys, refusals, toml_of
from tests.schemas.documents import Path as Way
from tests.schemas.probes import PROBES, errors, library, scene_of, source_of
from tests.schemas.written import folder_of
from vrts.base.source import SourceFile
from vrts.scene.model import Scene
from vrts.schemas import KINDS

NAMES = ("objects", "locations")  # tables whose keys are names of one's own
EXCLUDED = ("variants", "without")  # tables in a list whose keys are names of one's own
FOLDERS = ("scenes", "examples", "tests/schemas/probes")
WRITTEN = ("vrts/manual", "vrts/pages", "tests/data/prove", "tests/spec", "examples")


@cache
def _scene(path: Path) -> Scene:
    return scene_of(path)


def _set_in(path: Path) -> Scene:
    """Return the scene that a file is set in: as a task in the folder names it, or the usual."""
    for said in (path, path.parent / "task.toml"):
        found = (
            re.search(r'^scene = "(.*)"', said.read_text("utf-8"), re.M) if said.is_file() else None
        )
        if found is not None:
            beside = path.parent / found[1]
            named = library(found[1])
            return _scene(beside if beside.suffix == ".toml" and beside.is_file() else named)
    return _scene(library("cans-on-bases"))


def _kinds_of(folders: Iterable[str]) -> set[str]:
    """Return which kinds of file there are in folders, where all are valid by their schemas."""
    kinds: set[str] = set()
    for path in (path for folder in folders for path in sorted((ROOT / folder).rglob("*.toml"))):
        for kind in _accepted(source_of(path), _set_in(path), folder_of(path)):
            assert refusals(kind, path.read_text("utf-8")) == [], f"{kind}: {path}"
            kinds.add(kind)
    return kinds


def _accepted(text: SourceFile, scene: Scene, folder: Path) -> Iterator[str]:
    """Give every kind of file that a text is, as the readers see it."""
    for kind in KINDS:
        if not errors(kind, text, scene, folder):
            yield kind


def test_what_is_accepted_is_valid_by_its_schema() -> None:
    assert _kinds_of(FOLDERS) == set(KINDS)


@pytest.mark.thorough
def test_what_tests_accept_is_valid_by_its_schema() -> None:
    assert _kinds_of(["tests/data"]) >= {"scene", "task", "scenario"}


@pytest.mark.thorough
def test_what_is_accepted_of_what_is_written_about_is_valid_by_its_schema() -> None:
    seen = 0
    for folder in WRITTEN:
        for page in sorted((ROOT / folder).rglob("*.md")):
            for block in re.findall(r"^```toml\n(.*?)^```", page.read_text("utf-8"), re.M | re.S):
                text = SourceFile(str(page), block)
                for kind in _accepted(text, _scene(library("cans-on-bases")), page.parent):
                    assert refusals(kind, block) == [], f"{kind}: {page}\n{block}"
                    seen += 1
    assert seen > 20


def _probes(kind: str) -> list[Path]:
    return sorted(PROBES.glob(f"{kind}-*.toml"))


@pytest.mark.thorough
@pytest.mark.parametrize("kind", ["columns", "environment", "task"])
def test_what_is_wrong_is_refused_by_both(kind: str) -> None:
    made = sum(_refused_by_both(kind, path) for path in _probes(kind))
    assert made > 10


@pytest.mark.thorough
@pytest.mark.parametrize("path", sorted(PROBES.glob("*.toml")), ids=lambda path: path.stem)
def test_whatever_is_wrong_is_refused_by_both(path: Path) -> None:
    assert _refused_by_both(path.name.partition("-")[0], path) > 5


def _refused_by_both(kind: str, path: Path) -> int:
    """Make every key of a file wrong in three ways; return how many files that makes."""
    document = tomllib.loads(path.read_text("utf-8"))
    scene, made = _set_in(path), 0

    def told(changed: Document) -> tuple[list[str], list[str]]:
        text = toml_of(changed)
        found = errors(kind, SourceFile(path.name, text), scene, folder_of(path))
        return [one.rule.code for one in found], refusals(kind, text)

    assert told(document) == ([], [])
    for way in keys(document):
        if (way[-2:-1] != () and way[-2] in NAMES and len(way) == 2) or way[:-2] == EXCLUDED:
            continue  # a name of one's own
        for changed in (_misspelt(document, way), _of_another_type(document, way)):
            by_reader, by_schema = told(changed)
            assert by_reader, f"{way}: the reader takes it"
            assert by_schema, f"{way}: the schema takes it"
            made += 1
        by_reader, by_schema = told(_without(document, way))
        if by_schema:
            assert by_reader, f"{way}: the schema needs it, the reader does not"
        if "V603" in by_reader:
            assert by_schema, f"{way}: the reader needs it, the schema does not"
    return made


def _misspelt(document: Document, way: Way) -> Document:
    changed = copy.deepcopy(document)
    table = at(changed, way[:-1])
    table[f"{way[-1]}_x"] = table.pop(way[-1])
    return changed


def _of_another_type(document: Document, way: Way) -> Document:
    changed = copy.deepcopy(document)
    table = at(changed, way[:-1])
    table[way[-1]] = 7 if isinstance(table[way[-1]], str | bool | dict | list) else "seven"
    return changed


def _without(document: Document, way: Way) -> Document:
    changed = copy.deepcopy(document)
    del at(changed, way[:-1])[way[-1]]
    return changed
