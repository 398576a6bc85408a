"""Writes what marking yields: results, an overview, and a page for each of two readers.

`students/ID` may be sent to the student; `staff` holds what those who mark read.
"""

from collections.abc import Sequence
from pathlib import Path

from vrts.marking.grade import Marked, write_atomically
from vrts.pipeline.assess import with_curve
from vrts.report.audience import Audience, for_student, hidden_checks
from vrts.report.json_form import Json, assessment_json, results_json
from vrts.report.json_text import json_text
from vrts.report.overview import overview
from vrts.report.page import page
from vrts.report.stills import page_stills

STAFF = "staff"


def write_reports(
    row: Marked, public: Marked, out: Path, *, recordings: bool, more: int = 0
) -> None:
    """Write the folders of one submission.

    Args:
        row: As marked by all checks.
        public: As marked by the checks that students know; the same row where there are no others.
        out: The folder of all.
        recordings: Whether to write a recording, for the student.
        more: How many hidden checks there are.
    """
    whole = with_curve(row.assessment)
    known = whole if public is row else with_curve(public.assessment)
    stills = page_stills(whole)
    folder = out / STAFF / "students" / whole.identifier
    hidden = hidden_checks(whole, known)
    text = page(whole, stills, audience=Audience.GRADER, hidden=hidden)
    write_atomically(folder / "report.html", text.encode())
    write_atomically(folder / "result.json", _json(assessment_json(whole)))
    if row.fault is not None:
        write_atomically(folder / "fault.txt", row.fault.encode())

    if known is not whole:
        stills = page_stills(known)
    folder = out / "students" / known.identifier
    write_atomically(folder / "report.html", page(known, stills, more=more).encode())
    write_atomically(folder / "result.json", _json(assessment_json(for_student(known))))
    if recordings and known.run is not None:
        from vrts.report.recording import write_recording  # rerun is heavy

        write_recording(known, folder / "run.rrd")


def write_class(rows: Sequence[Marked], out: Path, title: str, *, pages: str) -> None:
    """Write the results of all, and the overview; `pages` is the folder of its links."""
    assessments = [row.assessment for row in rows]
    write_atomically(out / "results.json", _json(results_json(assessments)))
    text = overview(assessments, title, lambda a: f"{pages}/{a.identifier}/report.html")
    write_atomically(out / "index.html", text.encode())


def _json(value: Json) -> bytes:
    return (json_text(value) + "\n").encode()
