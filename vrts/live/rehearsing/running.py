"""A text compiled and run to its end, within limits, from the beginning of its scene or task."""

from dataclasses import replace
from typing import Final, NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.task.task import Task
from vrts.debug.passages import Instant
from vrts.engine.run import Run
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.live.rehearsing.asked import Begin
from vrts.live.session.looking.state import StateLost
from vrts.live.session.setting import scene_sha256, setting_of
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.execution import executed
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of
from vrts.scene.model import Limits

LIMITS: Final = Limits(statements=500_000, time_s=600.0, motions=5_000, output_characters=200_000)


class Outcome(NamedTuple):
    """A text as far as it could be compiled and run."""

    source: SourceFile | None  # None: it is no text of a program
    run: Run | None  # None: it does not compile
    diagnostics: tuple[Diagnostic, ...]  # of the compiler
    dialect: Dialect
    task: Task | None = None
    near_miss_m: float | None = None
    programs: tuple[str, ...] = ()
    begin: Instant = Instant(0.0, 0)
    goes_on: bool = False  # from a session: what was before does not count
    note: str = ""


def run_from_start(begin: Begin) -> Outcome:
    """Compile and run a text from the beginning, with the limits of its task and those here.

    Raises:
        CannotRead: A file of the scene or task is not there.
        Refused: A file of them has errors.
        StateLost: They are not those of the room's session.
    """
    where, order = begin.where, begin.order
    setting = setting_of(where)
    if where.scene_sha256 not in ("", scene_sha256(setting)):
        raise StateLost
    limits = narrower(scenario_of(setting).limits)
    program = ProgramFile(order.text.encode("utf-8", "replace"), order.name)
    found = executed(Request(program, setting, Reading(where.dialect), limits=limits))
    source = found.compiled.source
    task = setting.task
    return Outcome(
        source,
        found.run,
        found.diagnostics,
        DIALECTS[where.dialect],
        task,
        None if task is None else task.near_miss,
        () if found.module is None else tuple(found.module.programs),
    )


def narrower(limits: Limits) -> Limits:
    """Return limits within those of a rehearsal."""
    return replace(
        limits,
        statements=min(limits.statements, LIMITS.statements),
        time_s=min(limits.time_s, LIMITS.time_s),
        motions=min(limits.motions, LIMITS.motions),
        output_characters=min(limits.output_characters, LIMITS.output_characters),
    )
