"""A session as its page shows it: its whole run, and the mark of it where the room has a task."""

from dataclasses import replace

from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.engine.run import Run
from vrts.live.session.views.program import as_program
from vrts.marking.submission.session_run import session_run
from vrts.pipeline.curve import with_curve
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment

SHOWN = "session.v2"  # what was done, as a program


def shown_session(identifier: str, title: str, setting: Setting, run: Run) -> Assessment:
    """Return what is known of a session, marked by the public checks of its task if it has one.

    Args:
        identifier: Short name, for files.
        title: Above the page.
        setting: Scene and task of the session.
        run: All that happened.
    """
    source = SourceFile(SHOWN, as_program(run, "session"))
    task = setting.task
    bare = Assessment(
        *(identifier, title, source, setting.stamps),
        module=run.module,
        scene=run.scene,
        task=task,
    )
    if task is None:
        return with_curve(replace(bare, run=run, judgement=judge(run.scene, run, None)))
    seen = session_run(run, task.t_max)
    found = check_collisions(run.scene, run, near_miss=task.near_miss)
    report = replace(
        found,
        contacts=tuple(c for c in found.contacts if c.start_s < seen.horizon_s),
        undetermined=tuple(c for c in found.undetermined if c.start_s < seen.horizon_s),
    )
    judgement = judge(run.scene, seen, task, report=report)
    whole = Run(seen.history, run.horizon_s)  # also what came after the task's longest time
    marked = replace(bare, run=whole, judgement=judgement, grade=grade(task, seen, judgement))
    return with_curve(marked)
