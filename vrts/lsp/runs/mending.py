"""A change of a program that earns the full mark, looked for when somebody asks an editor for it.

`python -m vrts.lsp.runs.mending` reads a line of JSON from stdin and writes one to stdout. It ends
where stdin ends.
"""

import sys
from pathlib import Path
from threading import Thread

from vrts.base.units import mm
from vrts.check.rules.hints import Hints
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.channel.mend import NOTHING, Mend, line_of_mend
from vrts.lsp.channel.verification import Asked, asked_of
from vrts.lsp.runs.stdin import end_with_server
from vrts.marking.supervise.limits import Limits, impose
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import CannotRead
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.repair.ranking import standing_out
from vrts.repair.telling import sentence
from vrts.report.assessment import Assessment

CPU_S = 60  # of one search


def mend(asked: Asked) -> Mend:
    """Return the change that stands out, and what comes of it, as far as the task allows."""
    try:
        setting = setting_for(Path(asked.path))
    except (CannotRead, Refused):
        return NOTHING
    if setting is None or setting.task is None:
        return NOTHING
    others = tuple(_file(text, name) for name, text in asked.others)
    request = Request(_file(asked.text, asked.path), setting, Reading(None, others=others))
    found = mended(request)
    level = setting.task.hints
    said = found.refused or sentence(found.repairs, level) or "no small change was found"
    best = standing_out(found.repairs)
    if best is None or level is not Hints.EDIT or found.refused is not None:
        return Mend(said)
    after = assess(request._replace(program=_file(best.text, asked.path)))
    edits = tuple(Edit(e.span.start, e.span.end, e.replacement) for e in best.change.edits)
    return Mend(said, future(found.assessment, after), edits)


def future(before: Assessment, after: Assessment) -> str:
    """Return what comes of a change: the mark, the time, and the least clearance."""
    words: list[str] = []
    if before.grade is not None and after.grade is not None:
        marks = f"{float(after.grade.mark):g} of {float(after.grade.total):g}"
        words.append(f"{marks} instead of {float(before.grade.mark):g}")
        if after.grade.duration_s is not None:
            words.append(f"in {float(after.grade.duration_s):.1f} s")
    report = None if after.judgement is None else after.judgement.collisions
    if report is not None and report.clearance is not None:
        words.append(f"at least {mm(report.clearance.distance_m):.0f} mm from everything")
    return ", ".join(words)


def _file(text: str, name: str) -> ProgramFile:
    return ProgramFile(text.encode("utf-8", "replace"), name)


def main() -> None:
    """Answer one request."""
    asked = asked_of(sys.stdin.buffer.readline())
    Thread(target=end_with_server, daemon=True).start()
    impose(Limits(cpu_s=CPU_S))
    outgoing, sys.stdout = sys.stdout.buffer, sys.stderr
    outgoing.write(line_of_mend(mend(asked)))
    outgoing.flush()


if __name__ == "__main__":
    main()
