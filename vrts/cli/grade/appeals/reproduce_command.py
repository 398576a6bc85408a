"""`vrts grade reproduce`."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    UNDETERMINED,
    WRONG,
    guarded,
    out,
    say,
    show_diagnostics,
)
from vrts.cli.shared.options import color_option

if TYPE_CHECKING:
    from vrts.marking.result import Result

EPILOG = """\b
Examples:
  vrts grade reproduce evidence-anna.zip
"""


@click.command(name="reproduce", epilog=EPILOG)
@click.argument("evidence", type=click.Path(path_type=Path))
@color_option
@guarded
def command(evidence: Path, color: str) -> None:
    """Mark what is in EVIDENCE again, and say whether the result is the same.

    EVIDENCE is a zip of `vrts grade evidence`. Every file must match its sha256. Then the program
    is marked by the task in the zip, in a process of its own. Both results are compared in
    everything: the one for the staff and the one for the student. Exit status 0 for the same
    result; 1 for another one, or for a zip that is damaged or was changed; 3 when nothing was
    handed in that could be marked, or when another version of vrts came to the same mark and
    said something else about it.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.appeals.evidence_zip import read_evidence
    from vrts.marking.appeals.reproduce import other_versions, reproduce
    from vrts.report.plain import one_line

    found = read_evidence(evidence)
    for sentence in other_versions(found):
        say(f"note: {sentence}")
    name = one_line(found.contents.id)
    again = reproduce(found)
    if again is None:
        out(f"{name}: nothing to mark again: {one_line(found.staff.cause)}")
        sys.exit(UNDETERMINED)
    now, then = _mark(again.result), _mark(found.staff)
    if again.unread is not None:
        show_diagnostics([again.unread], color)
    if again.first is None:
        out(f"{name}: the same result, {now}")
        if again.proof is not None:
            count = len(again.proof.claims.meetings)
            words = {0: "nothing touches anything", 1: "one contact, and no other"}
            what = words.get(count, f"{count} contacts, and no others")
            out(f"  its certificate holds: {what}")
        sys.exit(HOLDS)
    only_words = again.same_points and again.other_vrts
    if only_words:
        out(f"{name}: the same mark, {now}; what is said about it comes from another vrts")
    elif again.same_points:
        out(f"{name}: another result, with the same mark: {now}")
    else:
        out(f"{name}: another result: {then} in the evidence, {now} now")
    first = again.first
    values = f"was {one_line(first.old)}, is now {one_line(first.new)}"
    out(f"  first difference, in the result {again.whose}: {one_line(first.path)} {values}")
    sys.exit(UNDETERMINED if only_words else WRONG)


def _mark(result: "Result") -> str:
    return "no mark" if result.mark is None else f"{result.mark:.1f} of {result.total:g}"
