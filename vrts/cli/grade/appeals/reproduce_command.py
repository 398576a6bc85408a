"""`vrts grade reproduce`."""

import os
import sys
from pathlib import Path

import click

from vrts.cli.shared.console import HOLDS, UNDETERMINED, WRONG, guarded, out, say
from vrts.cli.shared.options import color_option

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
    handed in that could be marked.
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
    if again.first is None:
        mark = (
            "no mark"
            if again.result.mark is None
            else f"{again.result.mark:.1f} of {again.result.total:g}"
        )
        out(f"{name}: the same result, {mark}")
        if again.proof is not None:
            count = len(again.proof.claims.meetings)
            words = {0: "nothing touches anything", 1: "one contact, and no other"}
            what = words.get(count, f"{count} contacts, and no others")
            out(f"  its certificate holds: {what}")
        sys.exit(HOLDS)
    first = again.first
    out(f"{name}: another result")
    values = f"was {one_line(first.old)}, is now {one_line(first.new)}"
    out(f"  first difference, in the result {again.whose}: {one_line(first.path)} {values}")
    sys.exit(WRONG)
