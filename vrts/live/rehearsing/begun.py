"""A rehearsal begun: what there is to tell of the whole run, before anybody steps through it."""

from collections.abc import Iterator, Sequence
from typing import Final

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.mark.losses import mishaps_of
from vrts.check.mark.mark import grade
from vrts.check.rules.hints import Hints, without_remedy
from vrts.check.verdict import CollisionReport
from vrts.debug.alarms import Alarms, Filter
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Ending
from vrts.live.rehearsing.asked import Begin
from vrts.live.rehearsing.going_on import run_from_now
from vrts.live.rehearsing.problems import in_one_sentence, problems
from vrts.live.rehearsing.rehearsal import Rehearsal
from vrts.live.rehearsing.running import Outcome, run_from_start
from vrts.live.rehearsing.told import End, Mark, Ready, Refused
from vrts.live.rehearsing.within import TooLong, within
from vrts.live.session.channel.messages import Marked
from vrts.live.session.looking.state import StateLost
from vrts.live.session.marks.checker import certified
from vrts.live.session.marks.public_mark import marked
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused as SettingRefused
from vrts.report.page.replay_data import contact_rows, contact_sentence, near_rows, near_sentence
from vrts.report.plain import one_line

RUN_S: Final = 15.0  # of processor for compiling and running [s]
CHECK_S: Final = 10.0  # ... for finding contacts and the mark [s]
MOST_MARKS: Final = 2000

TOO_LONG: Final = "the program takes too much computing to be rehearsed"
OTHER_SCENE: Final = "the room's session has another scene than the server offers now"
NOT_CHECKED: Final = "the run is too long to look for contacts in a rehearsal"
_ENDS: Final = {
    Ending.COMPLETED: "the program is over",
    Ending.HALTED: "the program halts",
    Ending.PAUSED: "the program pauses: PROCEED would go on, and a rehearsal ends here",
    Ending.ABORTED: "the program was stopped",
    Ending.RUNNING: "the program still runs where the rehearsal ends",
    Ending.NOT_STARTED: "the program did not start",
}
_FAULTS: Final = frozenset(Filter) - {Filter.CONTACT, Filter.NEAR_MISS}


def begun(begin: Begin) -> tuple[Rehearsal | None, Ready | Refused]:
    """Run a text; return the rehearsal and what there is to tell of it, or why there is none."""
    of = begin.order.id
    try:
        with within(RUN_S):
            outcome = run_from_now(begin) if begin.state else run_from_start(begin)
    except TooLong:
        return None, Refused(of, TOO_LONG)
    except StateLost:
        return None, Refused(of, OTHER_SCENE)
    except CannotRead as problem:
        return None, Refused(of, problem.message)
    except SettingRefused as refused:
        text = SourceFile(begin.order.name, begin.order.text)  # which is not what has errors
        return None, Refused(of, in_one_sentence(refused.diagnostics, text))
    if outcome.run is None or outcome.source is None:
        found, more = problems(_allowed(outcome, outcome.diagnostics), outcome.source)
        return None, Refused(of, in_one_sentence(outcome.diagnostics, outcome.source), found, more)
    said = (*outcome.diagnostics, *outcome.run.findings)
    found, more = problems(_allowed(outcome, said), outcome.source)
    rehearsal = Rehearsal(outcome.run, outcome.source, outcome.dialect, outcome.begin)
    report, mark, note = None, None, outcome.note
    try:
        with within(CHECK_S):
            report, mark = _judged(rehearsal, outcome)
    except TooLong:
        note = "; ".join(filter(None, (note, NOT_CHECKED)))
    run, source = rehearsal.run, rehearsal.source
    ended = _end(rehearsal)
    if run.ending is Ending.LIMIT:
        note = "; ".join(filter(None, (f"{ended.text}, and was stopped there", note)))
    contacts = () if report is None else report.contacts
    near = () if report is None else report.near_misses
    return rehearsal, Ready(
        of,
        rehearsal.begin_s,
        run.horizon_s - rehearsal.begin_s,
        ended,
        rehearsal.stop_at(begin.order.breakpoints),
        tuple(_marks(rehearsal, report, ended))[:MOST_MARKS],
        tuple(contact_rows(contacts, source)),
        tuple(near_rows(near, source)),
        report is None or bool(report.undetermined),
        mark,
        found,
        outcome.programs,
        note,
        more,
    )


def _allowed(outcome: Outcome, said: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
    """Return what is told, without remedies where the task allows no hints."""
    silent = outcome.task is not None and outcome.task.hints is Hints.NOTHING
    return tuple(map(without_remedy, said)) if silent else said


def _judged(rehearsal: Rehearsal, outcome: Outcome) -> tuple[CollisionReport | None, Marked | None]:
    """Return the certified contacts, and the mark by the public checks of the task.

    The mark is that of `vrts grade` where a task keeps nothing back. Of a run that goes on from a
    session there is none: what was done before would count, too.
    """
    run, task = rehearsal.run, outcome.task
    if outcome.goes_on:
        return certified(run, rehearsal.begin_s, outcome.near_miss_m), None
    judgement = judge(run.scene, run, task)
    if task is None:
        return judgement.collisions, None
    given = grade(task, run, judgement, outcome.diagnostics)
    return judgement.collisions, marked(given, run, mishaps_of(run, judgement))


def _end(rehearsal: Rehearsal) -> End:
    run = rehearsal.run
    at_s = run.horizon_s if run.ended_s is None else run.ended_s
    ending = run.ending
    if ending in (Ending.ERROR, Ending.LIMIT) and run.findings:
        last = run.findings[-1]
        return End(ending.value, _line(rehearsal, last), at_s, one_line(last.headline))
    passages = rehearsal.debugger.passages(process=False)
    cause = passages.cause(passages.count - 1) if passages.count else None
    return End(ending.value, rehearsal.line_of(cause), at_s, _ENDS.get(ending, ending.value))


def _line(rehearsal: Rehearsal, found: Diagnostic) -> int:
    if found.primary is None:
        return 0
    span = found.primary.span
    return rehearsal.line_of(Cause("", 0, span))


def _marks(rehearsal: Rehearsal, report: CollisionReport | None, ended: End) -> Iterator[Mark]:
    """Return what should not happen, and the end, in time order."""
    found: list[Mark] = []
    if report is not None:
        found += [
            Mark(one.start_s, "contact", contact_sentence(one), rehearsal.line_of(one.cause))
            for one in report.contacts
        ]
        found += [
            Mark(one.start_s, "near", near_sentence(one), rehearsal.line_of(one.cause))
            for one in report.near_misses
        ]
    found += _faults(rehearsal)
    over = f"program over: {ended.why}"  # as the events of the block say it
    found.append(Mark(ended.time_s, "program", over, ended.line))
    return iter(sorted(found, key=lambda mark: mark.time_s))


def _faults(rehearsal: Rehearsal) -> Sequence[Mark]:
    run = rehearsal.run
    marks: list[Mark] = []
    for alarm in Alarms(run, None).of(_FAULTS):
        if alarm.instant.time_s < rehearsal.begin_s:
            continue
        line = 0 if alarm.diagnostic is None else _line(rehearsal, alarm.diagnostic)
        if line == 0:
            passages = rehearsal.debugger.passages(process=False)
            number = passages.following(alarm.instant)
            line = rehearsal.line_of(passages.cause(number - 1)) if number else 0
        marks.append(Mark(alarm.instant.time_s, "fault", one_line(alarm.text), line))
    return marks
