"""Whatever is done to a saved run: it is refused in one diagnostic, or it answers everything."""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_programs import program
from tests.support_saved import (
    answers,
    ask_everything,
    busy,
    carrying,
    file_of,
    loaded,
    members,
    packed,
    state_answers,
    with_table,
)
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.engine.run import Run
from vrts.engine.storage.load import LAYOUT
from vrts.lang.compiler import Compilation, Options, compile_sources
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.run_files import loading
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import simulate
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene


class Saved(bytes):
    """A saved run, named by its length where Hypothesis tells of an example."""

    def __repr__(self) -> str:
        """Return its length."""
        return f"<saved run of {len(self)} bytes>"


MODULES: dict[object, Compilation] = {}
SCENES: dict[object, tuple[Scene | None, tuple[Diagnostic, ...]]] = {}


def compiled_once(sources: Sequence[SourceFile], options: Options) -> Compilation:
    """Return what the compiler makes of programs, again where the texts are the same."""
    key = (tuple((one.name, one.text) for one in sources), options)
    if key not in MODULES:
        MODULES[key] = compile_sources(sources, options)
    return MODULES[key]


def read_once(
    source: SourceFile, folder: Path | None, *, files: Mapping[str, bytes] | None
) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    """Return what a scene's text says, again where it is the same."""
    assert files is None
    key = (source.name, source.text, folder)
    if key not in SCENES:
        SCENES[key] = read_scene(source, folder)
    return SCENES[key]


FILES = (Saved(file_of(busy)), Saved(file_of(carrying)))
CODES = {"V540", "V541", "V542", "V543"}
BODIES = st.lists(
    st.sampled_from(
        [
            "MOVE a",
            "MOVES b",
            "APPRO c, 50",
            "DEPART 20",
            "SPEED 30",
            "OPENI",
            "CLOSEI",
            "SIGNAL 1, -2",
            "DELAY 0.3",
            "n = n+1",
            "m[n] = n",
            '$s[n] = "x"',
            "SET d = HERE",
            "SET #p = #HERE",
            'TYPE "n is", n',
            "SPEED 40 MONITOR",
            "TOOL SHIFT(NULL BY 0, 0, 20)",
            "FOR i = 1 TO 3\nn = n+i\nEND",
            "x = 1/0",
            "BRAKE",
        ]
    ),
    max_size=12,
)


def answers_or_is_refused(data: bytes) -> None:
    found = taken(data)
    if isinstance(found, Run):
        ask_everything(found, 6)
    else:
        assert len(found) == 1
        assert found[0].rule.code in CODES


def taken(data: bytes) -> Run | tuple[Diagnostic, ...]:
    """Return the run of a file, or why it is not taken.

    Most changes are not in its texts: of those that are the same, programs and scene are made once.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(loading, "compile_sources", compiled_once)
        patch.setattr(loading, "read_scene", read_once)
        try:
            return loaded(data)
        except Refused as refused:
            return refused.diagnostics


@settings(max_examples=examples(25))
@given(BODIES, st.sampled_from([100.0, 50.0, 12.5]))
def test_what_is_loaded_answers_as_what_was_saved(lines: list[str], speed: float) -> None:
    body = "\n".join(["n = 0", *lines]).replace("SPEED 40 MONITOR", f"SPEED {speed}")
    found = simulate(Request(ProgramFile(program(body).encode(), "main.v2"), robot_alone()))
    run = found.run
    assert run is not None, found.diagnostics
    data = saved_bytes(found)
    again = loaded(data)
    assert answers(again) == answers(run)
    for k in range(9):
        time_s = min(run.horizon_s * k / 8, run.horizon_s)
        assert state_answers(again.at(time_s)) == state_answers(run.at(time_s))
    assert check_again(load_run(data, "out.vrun")) is None


@given(st.sampled_from(FILES), st.data())
def test_changed_bytes(data: bytes, draw: st.DataObject) -> None:
    at = draw.draw(st.integers(0, len(data) - 1))
    new = draw.draw(st.binary(max_size=4))
    answers_or_is_refused(data[:at] + new + data[at + draw.draw(st.integers(0, 4)) :])


@given(st.sampled_from(FILES), st.data())
def test_changed_ends(data: bytes, draw: st.DataObject) -> None:
    """The directory of a zip is at its end: that is where hostile files lie."""
    at = len(data) - draw.draw(st.integers(1, 3000))
    new = draw.draw(st.binary(min_size=1, max_size=4))
    answers_or_is_refused(data[:at] + new + data[at + len(new) :])


@given(
    st.sampled_from(FILES),
    st.sampled_from(sorted(LAYOUT)),
    st.integers(0, 10**6),
    st.sampled_from([-1.0, 0.0, 1.0, 2.0, 3.0, 7.0, 1e3, 1e9, 2.0**32 - 1, 1e300, 0.5, -1e-300]),
)
def test_changed_numbers(data: bytes, name: str, row: int, value: float) -> None:
    def change(table: Any) -> Any:
        flat = table.reshape(-1)
        if len(flat):
            info = np.iinfo(table.dtype) if table.dtype.kind in "ui" else None
            kept = value if info is None else int(min(max(value, info.min), info.max))
            flat[row % len(flat)] = kept
        return table

    answers_or_is_refused(with_table(data, name, change))


@given(st.sampled_from(FILES), st.sampled_from(sorted(LAYOUT)), st.integers(0, 40))
def test_missing_rows(data: bytes, name: str, kept: int) -> None:
    answers_or_is_refused(with_table(data, name, lambda table: table[:kept]))


JUNK: tuple[object, ...] = (
    *(None, True, 0, 1, -1, 7, 10**20, 1e308, -0.5, 1e5),
    *("", "x", "\ud800", (), ((),), {"x": 1}),
)


def keys_of(node: Any) -> list[Any]:
    """Return what leads further down in JSON."""
    if isinstance(node, dict):
        return list(cast(dict[str, Any], node))
    return list(range(len(cast(list[Any], node)))) if isinstance(node, list) else []


@pytest.mark.thorough
@settings(max_examples=examples(300))
@given(
    st.sampled_from(FILES),
    st.lists(st.integers(0, 10**6), min_size=1, max_size=6),
    st.sampled_from(JUNK),
)
def test_changed_descriptions(data: bytes, way: list[int], new: object) -> None:
    """Go down into the description, some way, and put something else there."""
    parts = members(data)
    manifest = json.loads(parts["vrun.json"])
    inside: Any = manifest
    for k, step in enumerate(way):
        keys = keys_of(inside)
        key = keys[step % len(keys)]
        if not keys_of(inside[key]) or k == len(way) - 1:
            inside[key] = new
            break
        inside = inside[key]
    answers_or_is_refused(packed(parts | {"vrun.json": json.dumps(manifest).encode()}))


def kinds_of_places(node: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield a way to each kind of place in JSON: of a long list, its beginning only."""
    if way:
        yield way
    for key in keys_of(node):
        if not isinstance(key, int) or key < 3:
            yield from kinds_of_places(node[key], (*way, key))


@pytest.mark.thorough
@pytest.mark.parametrize("data", FILES, ids=["busy", "carrying"])
def test_each_kind_of_place_in_a_description(data: bytes) -> None:
    parts = members(data)
    manifest = json.loads(parts["vrun.json"])
    places = list(kinds_of_places(manifest))
    assert len(places) > 100
    for place in places:
        inside = manifest
        for key in place[:-1]:
            inside = inside[key]
        before = inside[place[-1]]
        for new in ((), 1, "x"):
            inside[place[-1]] = new
            answers_or_is_refused(packed(parts | {"vrun.json": json.dumps(manifest).encode()}))
        inside[place[-1]] = before


@pytest.mark.parametrize("length", [0, 4, 30, 38, 100, 5000])
def test_beginnings(length: int) -> None:
    answers_or_is_refused(FILES[0][:length])
