"""A program verified in the background: its times, and everything that its run has against it.

`python -m vrts.lsp.runs.verifying` reads a line of JSON from stdin and writes answers to stdout,
one a line and each more complete than the one before, so that the server never waits for a run and
loses nothing with it. It ends where stdin ends.
"""

import json
import os
import sys
from collections.abc import Callable
from dataclasses import replace
from enum import Enum
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Any, NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import SourceFile, Span
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.documents.documents import Document
from vrts.lsp.runs.findings import Finding, Found, Mending, Related, told
from vrts.lsp.runs.timing import Timing, timings

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.ir.module import Module
    from vrts.pipeline.settings import Setting
    from vrts.scene.model import Limits, Scenario

STOPPED = Rule("V797", "verification-stopped")
NO_SETTING = Rule("V798", "task-not-read")

CPU_S = 20  # of one verification
_STATEMENTS, _MOTIONS, _SIMULATED_S = 200_000, 5_000, 600.0


class Asked(NamedTuple):
    """What is to be verified."""

    path: str  # of the program; a task beside it tells scene and scenario
    text: str  # of the buffer
    others: tuple[tuple[str, str], ...] = ()  # paths and texts of what belongs together with it
    is_called: bool = False  # by one of them, so it is no program by itself


class Answer(NamedTuple):
    """What is known so far."""

    timings: tuple[Timing, ...] = ()
    findings: tuple[Finding, ...] = ()
    is_whole: bool = False  # nothing more comes


def verify(asked: Asked, tell: Callable[[Answer], None] = lambda _: None) -> Answer:
    """Run a program where its task says, and check everything; return the whole answer.

    Args:
        asked: The program.
        tell: Told what is known on the way.
    """
    from vrts.pipeline.files import CannotRead
    from vrts.pipeline.programs import ProgramFile, Reading, compile_bytes
    from vrts.pipeline.settings import Refused, robot_alone, setting_for

    path = asked.path
    first = _header(asked)
    try:
        setting = setting_for(Path(path)) or robot_alone()
    except (CannotRead, Refused) as problem:
        refused = Found(_not_read(problem, first))
        return Answer(findings=told([refused], path, first), is_whole=True)
    files = tuple(ProgramFile(t.encode("utf-8", "replace"), p) for p, t in asked.others)

    def compiled(text: str) -> "tuple[Module | None, tuple[Diagnostic, ...]]":
        data = text.encode("utf-8", "replace")
        found = compile_bytes(data, path, Reading(None, others=files))
        module = found.compilation.module if found.compilation is not None else None
        return module, found.diagnostics

    module, diagnostics = compiled(asked.text)
    if module is None or module.main is None:
        return Answer(is_whole=True)
    asked_for = setting.task.program if setting.task is not None else None
    if asked_for is None and asked.is_called:
        return Answer(is_whole=True)
    entry = (asked_for or module.main).lower()
    known = {d.data["name"] for d in diagnostics if "name" in d.data}
    where = f"in the scene `{setting.scene.name}`" if setting.task else "with the robot alone"
    is_here = any(p.name == entry for p in Document(path, asked.text).names.programs)
    header = _header(asked, entry) if is_here or entry not in module.programs else None

    def shown(found: list[Found]) -> tuple[Finding, ...]:
        new = [f for f in found if f.diagnostic.data.get("name") not in known]
        return told(new, path, header, where)

    if entry not in module.programs:
        from vrts.pipeline.assess import no_program

        return Answer((), shown([Found(no_program(module, entry))]), is_whole=True)
    scenario, full = _bounded(setting)

    def again(text: str) -> "Run | None":
        changed, _ = compiled(text)
        return None if changed is None else executed(changed)

    def executed(module: "Module") -> "Run":
        from vrts.engine.controller import execute

        return execute(module, setting.scene, scenario, entry)

    run = executed(module)
    of_run = [Found(d) for d in _of_run(run, full, setting)]
    tell(Answer(timings(setting, run, path, near=False), shown(of_run)))

    from vrts.check.judge import judge
    from vrts.lsp.runs.speeds import with_speeds

    judgement = judge(setting.scene, run, setting.task)
    all_timings = timings(setting, run, path, near=True)
    found = [Found(d) for verdict in judgement.verdicts for d in verdict.findings]
    tell(Answer(all_timings, shown([*of_run, *found])))
    found = with_speeds(SourceFile(path, asked.text), run, judgement, setting.task, again)
    return Answer(all_timings, shown([*of_run, *found]), is_whole=True)


def stopped(asked: Asked, so_far: Answer, why: str) -> Answer:
    """Return an answer that says that a verification did not come to its end."""
    header = _header(asked)
    note = Diagnostic(
        STOPPED,
        Severity.NOTE,
        f"the verification in the background was stopped {why}",
        header,
        help=("`vrts verify` takes the time it needs",),
    )
    (finding,) = told([Found(note)], asked.path, header)
    return Answer(so_far.timings, (*so_far.findings, finding), is_whole=True)


def answer_of(text: bytes) -> Answer:
    """Return an answer from the line that it was written as."""
    times, findings, is_whole = json.loads(text)
    return Answer(
        tuple(Timing(line, tuple(ends), *more) for line, ends, *more in times),
        tuple(_finding(row) for row in findings),
        is_whole,
    )


def _finding(row: list[Any]) -> Finding:
    path, code, severity, message, start, end, related, mending = row
    return Finding(
        path,
        code,
        Severity(severity),
        message,
        start,
        end,
        tuple(Related(*place) for place in related),
        None if mending is None else Mending(mending[0], tuple(Edit(*e) for e in mending[1])),
    )


def _of_run(run: "Run", full: "Limits", setting: "Setting") -> list[Diagnostic]:
    """Return what a run says itself, as far as it is true of a run without our bounds."""
    from vrts.engine.hand.hand import CLOSED_ON_NOTHING
    from vrts.engine.outcomes import MOTIONS, STATEMENTS

    ours = {STATEMENTS: full.statements > _STATEMENTS, MOTIONS: full.motions > _MOTIONS}
    found: list[Diagnostic] = []
    for d in run.findings:
        if ours.get(d.rule, False):
            text = f"the verification in the background stops here: {d.headline}"
            help_ = ("`vrts verify` takes the time it needs", *d.help)
            found.append(Diagnostic(STOPPED, Severity.NOTE, text, d.primary, help=help_))
        elif d.rule != CLOSED_ON_NOTHING or setting.task is not None:
            found.append(d)  # where there is no scene there is nothing to grasp
    return found


def _bounded(setting: "Setting") -> "tuple[Scenario, Limits]":
    """Return a scenario with bounds for an editor, and the bounds that it has without."""
    from vrts.pipeline.assess import scenario_for

    scenario = scenario_for(setting.task, setting.scenario)
    full = scenario.limits
    limits = replace(
        full,
        statements=min(full.statements, _STATEMENTS),
        motions=min(full.motions, _MOTIONS),
        time_s=min(full.time_s, _SIMULATED_S),
    )
    return replace(scenario, limits=limits), full


def _not_read(problem: Exception, header: Label) -> Diagnostic:
    """Return what to say when the task beside a program, or its scene, cannot be read."""
    from vrts.pipeline.settings import Refused

    notes = (str(problem),)
    if isinstance(problem, Refused):
        notes = tuple(
            f"{_place(d)}{d.headline}" for d in problem.diagnostics if d.severity is Severity.ERROR
        )
    return Diagnostic(
        NO_SETTING,
        Severity.WARNING,
        "nothing is verified: the task beside this program cannot be read",
        header,
        notes=notes[:3],
        help=("`vrts verify` shows where",),
    )


def _place(diagnostic: Diagnostic) -> str:
    primary = diagnostic.primary
    if primary is None:
        return ""
    return f"{os.path.basename(primary.span.source.name)}:{primary.span.line}: "


def _header(asked: Asked, entry: str | None = None) -> Label:
    """Return where a program of a text begins; the first one, if there is none of that name."""
    programs = Document(asked.path, asked.text).names.programs
    chosen = next((p for p in programs if p.name == entry), programs[0] if programs else None)
    source = SourceFile(asked.path, asked.text)
    if chosen is None:
        return Label(Span(source, 0, 0))
    return Label(Span(source, chosen.name_start, chosen.name_end))


def main() -> None:
    """Answer one request."""
    from vrts.marking.supervise.limits import Limits, impose

    path, text, others, is_called = json.loads(sys.stdin.buffer.readline())
    Thread(target=_end_with_server, daemon=True).start()
    impose(Limits(cpu_s=CPU_S))
    if hasattr(os, "nice"):
        os.nice(5)  # answers to the editor come first
    outgoing, sys.stdout = sys.stdout, sys.stderr

    def tell(answer: Answer) -> None:
        outgoing.write(json.dumps(answer, default=_plain) + "\n")
        outgoing.flush()

    tell(verify(Asked(path, text, tuple((p, t) for p, t in others), is_called), tell))


def _end_with_server() -> None:
    """End when the other end of stdin is closed: nobody is left who would read the answer."""
    while os.read(0, 4096):  # not by `sys.stdin`, whose lock would be held when this process ends
        pass
    os._exit(1)


def _plain(value: object) -> object:
    assert isinstance(value, Enum)
    return value.value


if __name__ == "__main__":
    main()
