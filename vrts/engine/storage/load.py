"""The bytes of a `.vrun` file to a run, without executing anything.

First `opened` tells what the run was made of; when its programs are compiled again and its scene is
read, `restored` gives the run. Both answer with one diagnostic where a file is not sound.
"""

import json
import math
from array import array
from collections.abc import Mapping
from itertools import pairwise
from typing import NamedTuple

from vrts import __version__
from vrts.base.diagnostic import Diagnostic, error
from vrts.base.pose import Pose
from vrts.engine.history import (
    ArmHistory,
    Code,
    HandHistory,
    History,
    MemoryHistory,
    ProgramHistory,
)
from vrts.engine.memory.cells import Cell
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.events import Cause, Event
from vrts.engine.memory.records import Ending, Lie, Placement, Stroke
from vrts.engine.memory.trace import Trace
from vrts.engine.motion.time_scale import Knot
from vrts.engine.run import Run
from vrts.engine.storage import arm, cells, traces
from vrts.engine.storage.columns import ascending, check_below, counts_of, wholes
from vrts.engine.storage.container import Container, Table
from vrts.engine.storage.damage import OTHER_FORMAT, RUN_AGAIN, Damaged, not_remade, require
from vrts.engine.storage.origin import Origin, module_digest, read_origin
from vrts.engine.storage.plain import Json, Plain, listed, named, number, text, truth, whole
from vrts.engine.storage.save import FORMAT, MAIN_LAYOUT
from vrts.engine.storage.sound_events import LONGEST_S, check_events
from vrts.engine.storage.sound_scenario import check_scenario
from vrts.ir.commands import Execute, TimedCommand
from vrts.ir.module import Module
from vrts.robots.model import Configuration
from vrts.scene.model import Mobility, Scenario, Scene

LAYOUT = {**MAIN_LAYOUT, **arm.LAYOUT, **traces.LAYOUT, **cells.LAYOUT}
BEFORE = "vrts.run/2"  # the format before, which is still read
MOST_STATEMENTS = 2**31
LARGEST_TURN = 1e3  # [rad]
WIDEST = 10.0  # [m] opening of a hand


class SavedRun(NamedTuple):
    """A file that was opened, not yet believed."""

    name: str
    container: Container | None  # None: only what the run was made of is known
    manifest: Mapping[str, Json]
    origin: Origin
    module_digest: str


def opened(data: bytes, name: str) -> SavedRun | Diagnostic:
    """Return what a file says that its run was made of."""
    try:
        container = Container(data)
        manifest = _json(container.manifest())
        said = manifest.get("format")
        if said not in (FORMAT, BEFORE):
            return _other_format(name, said, manifest.get("vrts"))
        origin, digest = read_origin(manifest.get("origin"), names_controller=said == FORMAT)
    except Damaged as damage:
        return damage.diagnostic(name)
    return SavedRun(name, container, manifest, origin, digest)


def restored(saved: SavedRun, module: Module, scene: Scene) -> Run | Diagnostic:
    """Return the run of a file.

    Args:
        saved: The file.
        module: Its programs, compiled again.
        scene: Its scene, read again.
    """
    if module_digest(module) != saved.module_digest:
        made_by = saved.manifest.get("vrts")
        return not_remade(
            saved.name,
            "its programs compile to something else now",
            f"it was saved by vrts {made_by}, this is vrts {__version__}",
        )
    if scene.digest != saved.origin.scene.digest:
        what = "files that its scene names are missing, or were changed"
        return not_remade(saved.name, what, f"the scene is `{scene.name}`")
    try:
        return _run(saved, module, scene)
    except Damaged as damage:
        return damage.diagnostic(saved.name)


def _other_format(name: str, said: Json, made_by: Json) -> Diagnostic:
    known = isinstance(said, str) and isinstance(made_by, str)
    note = f"it is `{said}` of vrts {made_by}; this vrts reads `{FORMAT}` and `{BEFORE}`"
    return error(
        OTHER_FORMAT,
        f"the saved run `{name}` has a format that is not known here",
        notes=(note,) if known else (),
        help=(RUN_AGAIN,),
    )


def _json(data: bytes) -> dict[str, Json]:
    try:
        return named(json.loads(data, parse_constant=_no_number))
    except (ValueError, RecursionError) as problem:
        raise Damaged("what it says about itself is not JSON") from problem


def _no_number(word: str) -> float:
    raise ValueError(word)


# --- parts ----------------------------------------------------------------------------------------


def _run(saved: SavedRun, module: Module, scene: Scene) -> Run:
    said = saved.manifest
    assert saved.container is not None
    tables = saved.container.tables(LAYOUT)
    plain = Plain(saved.origin.programs.sources)
    plain.read_causes(said.get("causes"))
    code = _code(module)
    finished = _count(said.get("statements"), MOST_STATEMENTS)
    texts = [text(item) for item in listed(said.get("texts"))]
    known = cells.ReadCells(tables, texts, finished)
    both = traces.read_traces(tables, code, known.bounds, finished)
    check_below(tables["memory"], len(known.bounds), "global variables")
    system = named(said.get("system"))
    scenario = plain.read(Scenario, said.get("scenario"))
    check_scenario(scenario, scene)
    ended = said.get("ended_s")
    history = History(
        module=module,
        code=code,
        scene=scene,
        scenario=scenario,
        issued=checked_commands(plain.read(tuple[TimedCommand, ...], said.get("commands")), module),
        tick_s=scene.robot.arm.tick,
        now_s=time_of(said.get("now_s")),
        started_s=time_of(said.get("started_s")),
        ended_s=None if ended is None else time_of(ended),
        closed=truth(said.get("closed")),
        finished=finished,
        ticks=counts_of(tables["ticks"]),
        counts=_checked_counts(tables, finished),
        robot=_program(said.get("robot"), both["robot"], len(code.causes), is_robot=True),
        process=_program(said.get("process"), both["process"], len(code.causes), is_robot=False),
        arm=_arm(said.get("arm"), tables, plain),
        hand=_hand(said.get("hand"), plain, scene),
        memory=MemoryHistory(
            [known.bounds[row] for row in wholes(tables["memory"])],
            _cell(known, system.get("tool")),
            _cell(known, system.get("base")),
            {name: _cell(known, row) for name, row in named(system.get("parameters")).items()},
        ),
        events=_events(plain.read(tuple[Event, ...], said.get("events")), tables, finished),
    )
    check_events(history)
    return Run(history, time_of(said.get("until_s")))


def _code(module: Module) -> Code:
    programs = list(module.programs.values())
    bases: list[int] = []
    causes = [
        Cause(program.name, step, span) for program in programs for step, span in program.origins
    ]
    at = 0
    for program in programs:
        bases.append(at)
        at += len(program.origins)
    return Code(programs, bases, causes)


def time_of(data: Json) -> float:
    """Return a time of a run [s].

    Raises:
        Damaged: It is none.
    """
    found = number(data)
    require(0.0 <= found <= LONGEST_S, "a time is out of range")
    return found


def _count(data: Json, limit: int) -> int:
    found = whole(data)
    require(0 <= found < limit, "a count is out of range")
    return found


def _checked_counts(tables: Mapping[str, Table], finished: int) -> "array[int]":
    ticks, counts = tables["ticks"], tables["counts"]
    require(len(ticks) == len(counts), "columns of ticks differ in length")
    require(ascending(ticks) and ascending(counts), "ticks are not in order")
    check_below(counts, finished + 1, "ticks")
    return counts_of(counts)


def _events(events: tuple[Event, ...], tables: Mapping[str, Table], finished: int) -> EventLog:
    numbers = counts_of(tables["event_numbers"])
    require(len(numbers) == len(events), "events have no numbers")
    check_below(tables["event_numbers"], finished + 1, "events")
    log = EventLog()
    for event, count in zip(events, numbers, strict=True):
        log.add(event, count)
    return log


def checked_commands(
    commands: tuple[TimedCommand, ...], module: Module
) -> tuple[TimedCommand, ...]:
    """Return commands that a controller with these programs can be given.

    Raises:
        Damaged: It cannot.
    """
    for timed in commands:
        require(0.0 <= timed.time_s <= LONGEST_S, "a command comes at no time")
        match timed.command:
            case Execute(program=program):
                require(program in module.programs, "it executes a program that is not there")
            case _:
                pass
    require(all(a.time_s <= b.time_s for a, b in pairwise(commands)), "commands are not in order")
    return commands


def _program(data: Json, trace: Trace, steps: int, *, is_robot: bool) -> ProgramHistory:
    said = named(data)
    place = said.get("next")
    endings = {ending.value: ending for ending in Ending}
    ending = text(said.get("ending"))
    require(ending in endings, f"there is no ending `{ending}`")
    return ProgramHistory(
        is_robot,
        trace,
        None if place is None else _count(place, steps),
        endings[ending],
        whole(said.get("cycles_done")),
        whole(said.get("cycles_left")),
        whole(said.get("priority")),
        truth(said.get("waits")),
    )


def _arm(data: Json, tables: Mapping[str, Table], plain: Plain) -> ArmHistory:
    said = named(data)
    configuration = plain.read(Configuration, said.get("configuration"))
    require(all(abs(q) <= LARGEST_TURN for q in configuration), "a joint is out of range")
    knots = plain.read(tuple[Knot, ...], said.get("knots"))
    scale = arm.scale_of(number(said.get("rate")), knots)
    return arm.read_arm(tables, plain, configuration, scale)


def _hand(data: Json, plain: Plain, scene: Scene) -> HandHistory:
    said = named(data)
    opening = number(said.get("opening_m"))
    strokes: tuple[Stroke, ...] = plain.read(tuple[Stroke, ...], said.get("strokes"))
    openings = [opening, *(x for s in strokes for x in (s.start_m, s.end_m))]
    require(all(abs(x) <= WIDEST for x in openings), "an opening of the hand is out of range")
    for stroke in strokes:
        require(0.0 <= stroke.start_s <= stroke.end_s <= LONGEST_S, "a stroke has no time")
    # files of before may have two of one instant that differ by a last digit
    ordered = all(a.start_s - arm.OVERLAP <= b.start_s for a, b in pairwise(strokes))
    require(ordered, "strokes are not in order")
    movable = {body.name for body in scene.bodies if body.mobility is Mobility.MOVABLE}
    tracks = named(said.get("placements"))
    require(tracks.keys() == movable, "it places other objects than the scene has")
    return HandHistory(
        opening, strokes, {name: _track(name, rows, plain, scene) for name, rows in tracks.items()}
    )


def _track(name: str, data: Json, plain: Plain, scene: Scene) -> list[Placement]:
    rows = [listed(row, 4) for row in listed(data)]
    starts = [time_of(row[0]) for row in rows]
    require(bool(starts) and starts[0] == 0.0, "an object is nowhere at the start")
    require(all(a <= b for a, b in pairwise(starts)), "placements are not in order")
    bodies = {body.name for body in scene.bodies}
    found: list[Placement] = []
    for row, start, end in zip(rows, starts, [*starts[1:], math.inf], strict=True):
        lie, X = row[1:3]
        support = None if row[3] is None else text(row[3])
        require(support is None or support in bodies, "an object rests on nothing in the scene")
        found.append(
            Placement(name, start, end, plain.read(Lie, lie), plain.read(Pose, X), support)
        )
    return found


def _cell(known: cells.ReadCells, data: Json) -> Cell:
    return known.cells[_count(data, len(known.cells))]
