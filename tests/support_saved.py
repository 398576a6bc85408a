"""Runs to save, what a run answers, and ways to change a saved run."""

import io
import json
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any, cast

import numpy as np

from tests.support_programs import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile, Span
from vrts.engine.run import Run, State
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.run_files.loading import load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate
from vrts.scene.model import FaultKind, Limits, PlannedFault, Region, Scenario, Sensor
from vrts.scene.planned import ScenarioFile

SOLUTION = (ROOT / "examples" / "01-cans-on-bases" / "solution.v2").read_bytes()
BUSY = b"""\
.PROGRAM main
 n = 0
 SET lifted = SHIFT(a BY 0, 0, 50)
 SET #up = #PPOINT(0, -90, 90, 0, 0, 0)
 $name = "a string"
 REACT 1001, blink, 5
 PCEXECUTE watch, -1
 WHILE n < 6 DO
   MOVE a
   CALL count(n, 2, m[])
   m[n,1] = RANDOM
   MOVES b
   IF n == 4 THEN
     $t[2] = "four"
     SET spot[1] = HERE
     SPEED 50 ALWAYS
   END
   SIGNAL 2001
   BREAK
   SIGNAL -2001
   TYPE "pass", n
   PROMPT "go ", x
 END
 TOOL TRANS(0, 0, 30, 90, -90, 0)
 PARAMETER HAND.TIME = 0.1
 MOVE #up
 MOVE unknown
.END
.PROGRAM count(k, by, list[])
 AUTO old
 old = k
 k = old+by
 list[k,2] = old
.END
.PROGRAM blink()
 SIGNAL 3
 DEPART 30
 SIGNAL -3
 REACT 1001, blink, 5
.END
.PROGRAM watch
 WAIT SIG(2001)
 seen = seen+1
 WAIT SIG(-2001)
.END
.LOCATIONS
a 900 200 100 90 90 0
b 900 -200 100 90 90 0
.END
.REALS
seen 0
.END
"""
TRAFFIC = Scenario(
    seed=3,
    inputs=((0.7, 1001, True), (1.4, 1001, False), (2.9, 1001, True)),
    answers=("1", "2", "3", "4"),
    sensors=(Sensor(1003, Region((0.0, -1.0, -1.0), (2.0, 1.0, 1.0)), ("tool",)),),
    faults=(PlannedFault(2.0, FaultKind.INPUT_STUCK, 1002, True),),
    monitor_speed=60.0,
    analog=((0.5, 2, 40), (1.5, 2, -40)),
    limits=Limits(time_s=60.0),
)


@cache
def busy() -> Simulated:
    """Return a run with calls, a process control program, reactions, strings and an error."""
    setting = with_scenario(robot_alone(), TRAFFIC)
    found = simulate(Request(ProgramFile(BUSY, "busy.v2"), setting, Reading("val2+")))
    assert found.run is not None, found.diagnostics
    return found


@cache
def carrying() -> Simulated:
    """Return the run of the first example: two cans are carried."""
    found = simulate(Request(ProgramFile(SOLUTION, "solution.v2"), load_scene("cans-on-bases")))
    assert found.run is not None
    return found


def with_scenario(setting: Setting, scenario: Scenario) -> Setting:
    """Return a setting in which runs go as a scenario says."""
    return replace(setting, scenario=ScenarioFile("test", scenario, ""))


@cache
def file_of(which: Callable[[], Simulated]) -> bytes:
    """Return the file of a run."""
    return saved_bytes(which())


def loaded(data: bytes) -> Run:
    """Return the run of a file."""
    run = load_run(data, "out.vrun").run
    assert run is not None
    return run


# --- what a run answers ---------------------------------------------------------------------------


def plain(value: object) -> object:
    """Return a value with sources told by their names, so that two compilations compare."""
    match value:
        case SourceFile():
            return value.name
        case Diagnostic():
            fields = (value.rule, value.headline, value.primary, value.notes, value.help)
            return plain((*fields, value.data, value.moment))
        case Mapping():
            items = cast(Mapping[str, object], value)
            return {name: plain(item) for name, item in items.items()}
        case Span() | tuple() | list():
            return [plain(item) for item in cast(tuple[object, ...], value)]
        case _:
            return value


def answers(run: Run) -> list[object]:
    """Return what a run answers as a whole."""
    return [
        plain(part)
        for part in (
            run.horizon_s,
            run.until_s,
            run.started_s,
            run.ended_s,
            run.ending,
            run.statements,
            run.output,
            list(run.motions),
            run.events,
            run.findings,
            run.placements,
            run.timeline.segments,
            run.scenario,
        )
    ]


STATE = (
    "time_s",
    "finished",
    "configuration",
    "velocity",
    "hand_opening",
    "X_WF",
    "X_FT",
    "X_WT",
    "base",
    "placements",
    "poses",
    "held",
    "signals",
    "switches",
    "parameters",
    "analog",
    "monitor_speed",
    "program_speed",
    "variables",
    "locals",
    "call_stack",
    "process_stack",
    "robot",
    "process",
    "awaits_answer",
    "cause",
    "instruction",
    "output",
)


def state_answers(state: State) -> dict[str, object]:
    """Return what a run answers about an instant."""
    return {name: plain(getattr(state, name)) for name in STATE}


def ask_everything(run: Run, times: int = 12) -> None:
    """Ask a run everything, at some times and after some statements."""
    answers(run)
    for k in range(times + 1):
        state_answers(run.at(min(run.horizon_s * k / times, run.horizon_s)))
        state_answers(run.at_statement(run.statements * k // times))


# --- changed files --------------------------------------------------------------------------------


def members(data: bytes) -> dict[str, bytes]:
    """Return the members of a file."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def packed(parts: Mapping[str, bytes]) -> bytes:
    """Return a file of members."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in parts.items():
            archive.writestr(name, data)
    return buffer.getvalue()


def with_manifest(data: bytes, change: Callable[[dict[str, Any]], None]) -> bytes:
    """Return a file whose description is changed."""
    parts = members(data)
    manifest = json.loads(parts["vrun.json"])
    change(manifest)
    return packed(parts | {"vrun.json": json.dumps(manifest).encode()})


def with_table(data: bytes, name: str, change: Callable[[Any], Any]) -> bytes:
    """Return a file in which an array is changed."""
    parts = members(data)
    table = np.load(io.BytesIO(parts[f"{name}.npy"]), allow_pickle=False)
    buffer = io.BytesIO()
    np.save(buffer, change(table.copy()), allow_pickle=False)
    return packed(parts | {f"{name}.npy": buffer.getvalue()})
