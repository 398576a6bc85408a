"""A run to the bytes of a `.vrun` file."""

import json
from array import array
from bisect import bisect_right

from vrts import __version__
from vrts.base.diagnostic import Diagnostic, error
from vrts.engine.history import HandHistory, History, ProgramHistory
from vrts.engine.memory.events import Event
from vrts.engine.memory.records import Lie, Stroke
from vrts.engine.motion.time_scale import Knot
from vrts.engine.run import Run
from vrts.engine.storage.arm import write_arm
from vrts.engine.storage.cells import CellWriter
from vrts.engine.storage.columns import column
from vrts.engine.storage.container import Table, pack
from vrts.engine.storage.damage import NOT_SAVED, TooLarge
from vrts.engine.storage.origin import Origin, write_origin
from vrts.engine.storage.plain import Json, Plain, Unwritable
from vrts.engine.storage.traces import write_traces
from vrts.ir.commands import DeletePrograms, Do, Load, TimedCommand
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario

FORMAT = "vrts.run/3"  # 2 does not say by which controller model the run went
MAIN_LAYOUT = {
    "event_numbers": ("<u4", 0),  # beside the events: statements finished with each
    "ticks": ("<u4", 0),  # in which statements were executed
    "counts": ("<u4", 0),  # statements finished after each
    "memory": ("<u4", 0),  # numbers of the names of global variables
}


def run_bytes(run: Run, origin: Origin) -> bytes | Diagnostic:
    """Return the file of a run, or why it cannot be saved. The same run gives the same bytes."""
    changed = [c for c in run.history.issued if isinstance(c.command, Load | Do | DeletePrograms)]
    if changed:
        return _refused("the programs in memory were changed on the way")
    try:
        manifest, tables = _parts(run, origin)
        return pack(json.dumps(manifest, separators=(",", ":"), allow_nan=False).encode(), tables)
    except TooLarge as problem:
        return _refused(f"it is too large: {problem.reason}")
    except Unwritable as problem:
        return _refused(str(problem))


def _refused(reason: str) -> Diagnostic:
    return error(NOT_SAVED, f"the run cannot be saved: {reason}")


def _parts(run: Run, origin: Origin) -> tuple[Json, dict[str, Table]]:
    history = run.history
    plain = Plain(origin.programs.sources)
    cells = CellWriter(history.finished)
    kept = bisect_right(history.counts, history.finished)
    memory = history.memory
    names = [cells.number(bound) for bound in memory.bound]
    system = {
        "tool": cells.cell_number(memory.tool),
        "base": cells.cell_number(memory.base),
        "parameters": {
            name: cells.cell_number(cell) for name, cell in sorted(memory.parameters.items())
        },
    }
    traces = {"robot": history.robot.trace, "process": history.process.trace}
    tables = {
        "ticks": column(history.ticks[:kept], "<u4"),
        "counts": column(history.counts[:kept], "<u4"),
        "event_numbers": column(array("I", history.events.numbers), "<u4"),
        "memory": column(names, "<u4"),
        **write_arm(history.arm, plain),
        **write_traces(traces, history.finished, cells),
    }
    tables |= cells.tables()
    manifest = {
        "format": FORMAT,
        "vrts": __version__,
        "origin": write_origin(origin, history.module),
        "scenario": plain.write(Scenario, history.scenario),
        "commands": plain.write(tuple[TimedCommand, ...], history.issued),
        "until_s": plain.write(float, run.until_s),
        "now_s": history.now_s,
        "started_s": history.started_s,
        "ended_s": history.ended_s,
        "closed": history.closed,
        "statements": history.finished,
        "robot": _program(history.robot),
        "process": _program(history.process),
        "arm": _arm(history, plain),
        "hand": _hand(history.hand, plain),
        "system": system,
        "texts": cells.texts,
        "events": plain.write(tuple[Event, ...], tuple(history.events)),
        "causes": plain.write_causes(),
    }
    return manifest, tables


def _program(program: ProgramHistory) -> Json:
    return {
        "next": program.place,
        "ending": program.ending.value,
        "cycles_done": program.cycles_done,
        "cycles_left": program.cycles_left,
        "priority": program.priority,
        "waits": program.waits,
    }


def _arm(history: History, plain: Plain) -> Json:
    arm = history.arm
    return {
        "configuration": plain.write(Configuration, arm.configuration),
        "rate": arm.scale.rate,
        "knots": plain.write(tuple[Knot, ...], tuple(arm.scale.knots)),
    }


def _hand(hand: HandHistory, plain: Plain) -> Json:
    return {
        "opening_m": hand.opening_m,
        "strokes": plain.write(tuple[Stroke, ...], tuple(hand.strokes)),
        "placements": {
            name: [
                [
                    p.start_s,
                    plain.write(Lie, p.lie),
                    list(p.X.rotation + p.X.translation),
                    p.support,
                ]
                for p in track
            ]
            for name, track in hand.placements.items()
        },
    }
