"""A program verified in the background: its times, and everything that its run has against it.

`python -m vrts.lsp.runs.verifying` reads a line of JSON from stdin and writes answers to stdout,
one a line and each more complete than the one before, so that the server never waits for a run and
loses nothing with it. It ends where stdin ends.
"""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from threading import Thread

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.rules.hints import Hints, without_remedy
from vrts.engine.run import Run
from vrts.lang.findings.names.untaught import names_of
from vrts.lsp.channel.findings import Finding, Found, told
from vrts.lsp.channel.verification import CPU_S, Answer, Asked, asked_of, header_of, line_of
from vrts.lsp.documents.documents import Document
from vrts.lsp.runs.bounds import bounded, said_by
from vrts.lsp.runs.causes import causes_of, lost_of, with_causes
from vrts.lsp.runs.futures import for_some_inputs
from vrts.lsp.runs.motion_times import timings
from vrts.lsp.runs.showing import shown as shown_beside
from vrts.lsp.runs.speeds import with_speeds
from vrts.lsp.runs.stdin import end_with_server
from vrts.marking.supervise.limits import Limits, impose
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.execution import compiled_for, entry_in, executed
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of
from vrts.pipeline.settings import setting_for

NO_SETTING = Rule("V798", "task-not-read")
SEARCH_CPU_S = CPU_S / 2  # of this process, at which the search of all futures ends


def verify(asked: Asked, tell: Callable[[Answer], None] = lambda _: None) -> Answer:
    """Run a program where its task says, and check everything; return the whole answer.

    Args:
        asked: The program.
        tell: Told what is known on the way.
    """
    path = asked.path
    first = header_of(asked)
    try:
        setting = setting_for(Path(path)) or robot_alone()
    except (CannotRead, Refused) as problem:
        refused = Found(_not_read(problem, first))
        return Answer(findings=told([refused], path, first), is_whole=True)
    full = scenario_of(setting).limits
    reading = Reading(None, others=tuple(_file(text, name) for name, text in asked.others))
    request = Request(_file(asked.text, path), setting, reading, limits=bounded(full))
    compiled = compiled_for(request)
    module = None if compiled.compilation is None else compiled.compilation.module
    if module is None or module.main is None:
        return Answer(is_whole=True)
    if asked.is_called and (setting.task is None or setting.task.program is None):
        return Answer(is_whole=True)
    entry, chosen = entry_in(module, request)
    said = [Found(d) for d in chosen]
    known = {name for d in compiled.diagnostics for name in names_of(d)}
    where = f"in the scene `{setting.scene.name}`" if setting.task else "with the robot alone"
    is_here = any(p.name == entry for p in Document(path, asked.text).names.programs)
    header = header_of(asked, entry) if is_here or entry is None else None

    def shown(found: list[Found]) -> tuple[Finding, ...]:
        new = [f for f in found if f.diagnostic.data.get("name") not in known]
        if setting.task is not None and setting.task.hints is Hints.NOTHING:
            new = [f._replace(diagnostic=without_remedy(f.diagnostic)) for f in new]
        return told(new, path, header, where)

    def again(text: str) -> Run | None:
        return executed(request._replace(program=_file(text, path))).run

    run = executed(request, compiled).run
    if run is None:
        return Answer((), shown(said), is_whole=True)
    of_run = [*said, *(Found(d) for d in said_by(run, full, setting))]
    tell(Answer(timings(setting, run, path, near=False), shown(of_run)))

    judgement = judge(setting.scene, run, setting.task)
    all_timings = timings(setting, run, path, near=True)
    found = [Found(d) for verdict in judgement.verdicts for d in verdict.findings]
    beside = shown_beside(setting, compiled, run, judgement) if asked.is_shown else None
    tell(Answer(all_timings, shown([*of_run, *found]), shown=beside))
    found = with_speeds(SourceFile(path, asked.text), run, judgement, setting.task, again)
    tell(Answer(all_timings, shown([*of_run, *found])))
    known = [one.diagnostic for one in (*of_run, *found)]
    causes = causes_of(run, judgement, setting.task, compiled.diagnostics)
    of_run, found = with_causes(of_run, causes), with_causes(found, causes)
    lost = lost_of(causes, path)
    mendable = causes.mendable and not asked.others and not setting.hidden
    found += for_some_inputs(request, module, known, SEARCH_CPU_S)
    return Answer(all_timings, shown([*of_run, *found]), True, lost, mendable)


def _file(text: str, name: str) -> ProgramFile:
    return ProgramFile(text.encode("utf-8", "replace"), name)


def _not_read(problem: Exception, header: Label) -> Diagnostic:
    """Return what to say when the task beside a program, or its scene, cannot be read."""
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


def main() -> None:
    """Answer one request."""
    asked = asked_of(sys.stdin.buffer.readline())
    Thread(target=end_with_server, daemon=True).start()
    impose(Limits(cpu_s=CPU_S))
    if hasattr(os, "nice"):
        os.nice(5)  # answers to the editor come first
    outgoing, sys.stdout = sys.stdout.buffer, sys.stderr

    def tell(answer: Answer) -> None:
        outgoing.write(line_of(answer))
        outgoing.flush()

    tell(verify(asked, tell))


if __name__ == "__main__":
    main()
