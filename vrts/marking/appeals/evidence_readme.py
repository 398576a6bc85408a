"""What stands at the top of an evidence zip for whoever opens it without vrts."""

from vrts.marking.appeals.evidence import (
    CHANGES,
    CONTENTS,
    DECISIONS,
    INTAKE,
    ROW,
    STAFF,
    STUDENT,
    TASK,
    Contents,
)
from vrts.marking.appeals.proof import PROOF
from vrts.marking.row import Row
from vrts.report.plain import one_line
from vrts.report.quantities import full


def readme(row: Row, contents: Contents) -> str:
    """Return the text."""
    result = row.result
    of_all = f"of {full(result.exact_total)}"
    mark = "no mark" if result.mark is None else f"{result.mark:.1f} {of_all}"
    final = "no mark" if row.final is None else f"{row.final:.1f} {of_all}"
    lines = [
        f"Evidence for the mark of {one_line(row.id)}",
        "",
        f"computed    {mark} ({result.kind.value})",
        f"lateness    {one_line(row.late.sentence) if row.late else 'no deduction'}",
        f"by hand     {one_line(row.change.reason) if row.change else 'no change'}",
        f"final       {final}",
        f"marked      {contents.marked} by vrts {result.versions.vrts}",
        f"command     {one_line(' '.join(contents.command))}",
        "",
        "The hidden part of the task is in this zip: it is for those who decide, not for students.",
        "",
        f"{contents.program or 'no program':24}as it was handed in",
        f"{TASK:24}the task, with its hidden checks",
        f"{STAFF + '/':24}result and report for those who mark",
        f"{STUDENT + '/':24}result, report and recording as the student has them",
        f"{PROOF:24}what proves the contacts, if it could be shown: vrts check-proof",
        f"{ROW:24}whose it is, lateness, changes by hand, final mark",
        f"{INTAKE:24}the line of the table of hand-ins, if there is one",
        f"{CHANGES:24}the changes by hand, if there are any",
        f"{DECISIONS:24}what graders decided about this student, if they did",
        f"{CONTENTS:24}versions, and the sha256 of every file",
        "",
        "To mark it again and compare:  vrts grade reproduce EVIDENCE.zip",
        "",
    ]
    return "\n".join(lines)
