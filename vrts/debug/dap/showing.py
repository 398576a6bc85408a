"""What shows the arm beside the text asks for: the run as a recording, and where it stands in it.

They are ours, so their names begin with `vrts.`; another client never asks.
"""

import math
from collections.abc import Callable, Mapping

from vrts.base.source import SourceFile
from vrts.check.judgement import Judgement
from vrts.debug.conditions.heard_proposer import HeardProposer
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.session import PROCESS, ROBOT, Answer, Event, Session
from vrts.engine.run import Run
from vrts.pipeline.curve import with_curve
from vrts.pipeline.files import unwritable
from vrts.report.assessment import Assessment
from vrts.report.locations.rows import location_rows
from vrts.report.page.page import recording
from vrts.report.page.replay_data import run_data
from vrts.report.page.replay_lanes import goal_times


def _where(session: Session, a: Fields) -> Answer:
    """Return where it stands [s], in which line, and which of its futures that is."""
    debugger = session.debugger
    source = _source(session, a)
    stack = session.stack(process=debugger.stop.process)
    here = next((c.span.line for c in stack if c.span.source is source), 0)
    body = {
        "time": debugger.at.time_s,
        "line": here,
        "future": session.future,
        "thread": PROCESS if debugger.stop.process else ROBOT,
    }
    return Answer(body)


def _recording(session: Session, a: Fields) -> Answer:
    """Return the run as it goes with all changes so far, as the page of a report holds it.

    Raises:
        Interrupted: Somebody wants the debugger to go on meanwhile.
    """
    run, source = session.debugger.run, _source(session, a)
    found = Assessment(
        "debugged",
        source.name,
        source,
        (),
        module=run.module,
        scene=run.scene,
        task=session.debugger.task,
        run=run,
        judgement=Judgement((), session.debugger.alarms.report),
    )
    curved = with_curve(found, HeardProposer(session.debugger.hear))
    shown = {
        **recording(curved, None),
        **goal_times(run, session.debugger.task),
        "locations": location_rows(run.module, run, unwritable),
    }
    return Answer({"recording": shown, "future": session.future})


def _other(session: Session, a: Fields) -> Answer:
    """Return another future, to be drawn beside the present one, and how long both take [s]."""
    tree = session.debugger.tree
    number = a.whole("number", 0)
    branch = next((b for b in tree.branches if b.number == number), None)
    if branch is None:
        raise BadRequest(f"`number` is one of: {', '.join(str(b.number) for b in tree.branches)}")
    return Answer(
        {
            "number": branch.number,
            "label": branch.label,
            "words": branch.words,
            "took": _took(branch.run),
            "present": _took(session.debugger.run),
            "run": run_data(branch.run, None),
        }
    )


def _took(run: Run) -> float:
    ended = run.horizon_s if run.ended_s is None else run.ended_s
    return round(ended - run.started_s, 3)


def _seek(session: Session, a: Fields) -> Answer:
    """Go to a time [s], as near as the run reaches; the client has to be told that it goes."""
    time_s = a.number("time", math.nan)
    if not math.isfinite(time_s):
        raise BadRequest("`time` is a number of seconds")
    going: Event = ("continued", {"threadId": ROBOT, "allThreadsContinued": True})
    events = session.stopped(session.debugger.jump(max(time_s, 0.0)))
    return Answer({"time": session.debugger.at.time_s}, [going, *events])


def _source(session: Session, a: Fields) -> SourceFile:
    """Return the text that a request is about; the first one, where it names none of them."""
    wanted = a.optional("path")
    return next((s for s in session.sources if s.name == wanted), session.sources[0])


SHOWING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "vrts.where": _where,
    "vrts.recording": _recording,
    "vrts.seek": _seek,
    "vrts.other": _other,
}
