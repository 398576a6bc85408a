"""A program run, verified or shown to be debugged, when somebody orders that in an editor.

`python -m vrts.lsp.runs.carrying_out` reads a line of JSON from stdin and writes one to stdout. It
ends where stdin ends. What is done is what the commands `run`, `verify` and `debug` do with a file,
but with the text of the buffer.
"""

import sys
from collections.abc import Sequence
from pathlib import Path
from threading import Thread

from vrts.assignments.packed import public_answer
from vrts.base.diagnostic import Diagnostic
from vrts.check.verdict import Answer
from vrts.lsp.channel.ordered import CPU_S, Done, Ordered, line_of_ordered, ordered_of
from vrts.lsp.runs.stdin import end_with_server
from vrts.marking.supervise.limits import Limits, impose
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import setting_for
from vrts.report.assessment import Assessment
from vrts.report.page.page import page
from vrts.report.page.stills import page_stills
from vrts.report.plain import plain_text
from vrts.report.screen.assessment_text import assessment_text
from vrts.report.screen.text import diagnostic_text
from vrts.run_files.simulated import simulate

HOLDS, WRONG, UNDETERMINED = 0, 1, 3  # statuses
MOST_TOLD = 20  # diagnostics
MOST_SHORT = 4  # lines
MOST_TYPED = 20_000  # letters that a program types


def carry_out(ordered: Ordered) -> Done:
    """Do what is ordered; return what came of it."""
    path = ordered.path
    try:
        setting = setting_for(Path(path)) or robot_alone()
    except CannotRead as problem:
        return _refused(str(problem), ())
    except Refused as problem:
        return _refused("the task beside this program cannot be read", problem.diagnostics)
    others = tuple(_file(text, name) for name, text in ordered.others)
    name = Path(path)
    file = _file(ordered.text, path)
    dialect = "val2" if ordered.work == "verify" else None
    request = Request(
        file, setting, Reading(dialect, others=others), ordered.entry, title=name.name
    )
    if ordered.work == "run":
        return _run(request)
    if ordered.work == "verify":
        return _verified(request._replace(checks=Checks(causes=True)))
    return _shown(request._replace(checks=Checks(causes=True, curve=True)), ordered)


def _where(setting: Setting) -> str:
    return f"in the scene `{setting.scene.name}`" if setting.task else "with the robot alone"


def _run(request: Request) -> Done:
    found = simulate(request)
    told = _told(found.diagnostics)
    status = WRONG if any(d.is_error for d in found.diagnostics) else HOLDS
    if found.run is None:
        return Done(WRONG, _first(found.diagnostics, "nothing ran"), told)
    run = found.run
    ended = run.ended_s if run.ended_s is not None else run.horizon_s
    entry = run.module.main if request.entry is None else request.entry
    end = f"{run.ending.value} after {ended:.3f} s of simulated time, {_where(request.setting)}"
    typed = plain_text(run.output.replace("\r\n", "\n")[:MOST_TYPED])
    rows = typed.rstrip("\n").split("\n") if typed.strip() else []
    short = "\n".join([f"`{entry}`: {end}", *rows[-MOST_SHORT:]])
    if status:
        short += f"\n{_first(found.diagnostics, '')}"
    return Done(status, short, f"{typed}{end}\n\n{told}".rstrip("\n") + "\n")


def _verified(request: Request) -> Done:
    found = assess(request)
    text = assessment_text(found, color=False)
    hidden = public_answer(found.grade.ready, request.setting) if found.grade else None
    if hidden is not None:
        text += f"\n\n{hidden}"
    head = text.split("\n\n", 1)[0].split("\n")[:MOST_SHORT]
    return Done(_status(found), "\n".join(head), f"{text}\n")


def _shown(request: Request, ordered: Ordered) -> Done:
    found = assess(request)
    told = _told(found.findings)
    if found.run is None:
        return Done(WRONG, _first(found.findings, "nothing ran"), told)
    entry = f" --entry {ordered.entry}" if ordered.entry else ""
    short = (
        "the page shows the run, forward and back, with its lines; to set breakpoints and change"
        f" values: `vrts debug {Path(ordered.path).name}{entry}`, or the debugger of the editor"
    )
    text = page(found, page_stills(found), more=request.setting.more)
    return Done(HOLDS, short, f"{short}\n\n{told}", text)


def _status(found: Assessment) -> int:
    if found.judgement is None or any(d.is_error for d in found.findings):
        return WRONG
    return {Answer.HOLDS: HOLDS, Answer.VIOLATED: WRONG, Answer.UNDETERMINED: UNDETERMINED}[
        found.judgement.answer
    ]


def _refused(why: str, found: Sequence[Diagnostic]) -> Done:
    return Done(WRONG, why, f"{why}\n\n{_told(found)}".rstrip("\n") + "\n")


def _told(found: Sequence[Diagnostic]) -> str:
    several = [diagnostic_text(d, color=False) for d in found[:MOST_TOLD]]
    if len(found) > MOST_TOLD:
        several.append(f"{len(found) - MOST_TOLD} more findings are not shown here")
    return "\n\n".join(several) + "\n" if several else ""


def _first(found: Sequence[Diagnostic], otherwise: str) -> str:
    return next((d.headline for d in found if d.is_error), otherwise)


def _file(text: str, name: str) -> ProgramFile:
    return ProgramFile(text.encode("utf-8", "replace"), name)


def main() -> None:
    """Carry out one order."""
    ordered = ordered_of(sys.stdin.buffer.readline())
    Thread(target=end_with_server, daemon=True).start()
    impose(Limits(cpu_s=CPU_S))
    outgoing, sys.stdout = sys.stdout.buffer, sys.stderr
    outgoing.write(line_of_ordered(carry_out(ordered)))
    outgoing.flush()


if __name__ == "__main__":
    main()
