"""Writes what marking yields: results, an overview, and a page for each student."""

from collections.abc import Sequence
from pathlib import Path

from vrts.marking.grade import Marked, write_atomically
from vrts.pipeline.assess import with_curve
from vrts.report.json_form import Json, assessment_json, results_json
from vrts.report.json_text import json_text
from vrts.report.overview import overview
from vrts.report.page import page
from vrts.report.picture import moment_picture

MOMENT = "moment"


def write_student(row: Marked, out: Path, *, recordings: bool) -> None:
    """Write the folder of one submission."""
    a = with_curve(row.assessment)
    folder = out / "students" / a.identifier
    picture = moment_picture(a)
    stills = {} if picture is None else {MOMENT: picture}
    write_atomically(folder / "report.html", page(a, stills).encode())
    write_atomically(folder / "result.json", _json(assessment_json(a)))
    if row.fault is not None:
        write_atomically(folder / "fault.txt", row.fault.encode())
    if recordings and a.run is not None:
        from vrts.report.recording import write_recording  # rerun is heavy

        write_recording(a, folder / "run.rrd")


def write_class(rows: Sequence[Marked], out: Path, title: str) -> None:
    """Write the results of all, and the overview with links."""
    assessments = [row.assessment for row in rows]
    write_atomically(out / "results.json", _json(results_json(assessments)))
    text = overview(assessments, title, lambda a: f"students/{a.identifier}/report.html")
    write_atomically(out / "index.html", text.encode())


def _json(value: Json) -> bytes:
    return (json_text(value) + "\n").encode()
