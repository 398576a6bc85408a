"""A verified run as an editor shows it beside the text: the mark in short, and a recording."""

import json

from vrts.check.judgement import Judgement
from vrts.check.mark.mark import grade
from vrts.engine.run import Run
from vrts.lsp.channel.showing import Shown
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.curve import with_curve
from vrts.pipeline.files import unwritable
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.audience import as_allowed, for_student
from vrts.report.first_screen import first_screen
from vrts.report.locations.rows import location_rows
from vrts.report.page.page import replay_data
from vrts.report.page.replay_lanes import goal_times
from vrts.report.quantities import full, mark


def shown(setting: Setting, compiled: Compiled, run: Run, judgement: Judgement) -> Shown:
    """Return what is shown of a run: what a student may see, and without hints where none may be.

    Args:
        setting: Where the program ran.
        compiled: The program.
        run: What happened.
        judgement: What the checks said of it; every future is not among them.
    """
    task = setting.task
    source, diagnostics = compiled.source, (*compiled.diagnostics, *setting.stamps)
    marked = None if task is None else grade(task, run, judgement, compiled.diagnostics)
    module = None if compiled.compilation is None else compiled.compilation.module
    found = Assessment(
        "program",
        "program" if source is None else source.name,
        source,
        diagnostics,
        module=module,
        scene=setting.scene,
        task=task,
        run=run,
        judgement=judgement,
        grade=marked,
    )
    a = with_curve(for_student(as_allowed(found, setting.stamps)))
    screen = first_screen(a)
    places = [] if module is None else location_rows(module, run, unwritable)
    recorded = {**replay_data(a), **goal_times(run, task), "locations": places}
    span = screen.span
    return Shown(
        "" if screen.mark is None else f"{mark(screen.mark)} / {full(screen.total)}",
        screen.ready,
        screen.ready_in,
        screen.obstacles,
        screen.cause,
        setting.environment is None,
        json.dumps(recorded, separators=(",", ":"), allow_nan=False),
        span.line if span is not None and span.source is source else 0,
    )
