"""The formats that a class can be exported to."""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

from vrts.marking.exports.autograders.classroom50 import classroom50
from vrts.marking.exports.autograders.gradescope import gradescope
from vrts.marking.exports.autograders.prairielearn import prairielearn
from vrts.marking.exports.class_json import class_json
from vrts.marking.exports.findings import findings
from vrts.marking.exports.folders import folders, moodle_feedback
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.exports.grade_books.canvas import canvas
from vrts.marking.exports.grade_books.moodle import moodle
from vrts.marking.exports.junit import junit
from vrts.marking.exports.marks_table import marks_table

Export: TypeAlias = Callable[[Given, Options], Product]


class Format(NamedTuple):
    """One format."""

    export: Export
    what: str
    fills: bool = False  # whether it fills in a file of the teacher's
    names: bool = False  # whether it is of use with names only, also after marking without
    final: bool = True  # whether its marks go to grade books or students, who take them for final
    lateness: bool = True  # whether unknown lateness is unsafe; else the platform judges it


FORMATS: dict[str, Format] = {
    "csv": Format(marks_table, "a table of all marks", names=True),
    "json": Format(class_json, "everything, as published", final=False),
    "moodle": Format(moodle, "Moodle's grading worksheet, filled in", fills=True, names=True),
    "canvas": Format(canvas, "the grade book of Canvas, filled in", fills=True, names=True),
    "moodle-feedback": Format(moodle_feedback, "zip of feedback files for Moodle", names=True),
    "folders": Format(folders, "a folder of feedback for each student"),
    "gradescope": Format(gradescope, "results.json of each submission", lateness=False),
    "prairielearn": Format(prairielearn, "results.json of each submission", lateness=False),
    "classroom50": Format(classroom50, "result.json of the submission of a run", lateness=False),
    "junit": Format(junit, "JUnit XML, a suite for each submission", final=False),
    "sarif": Format(findings, "what was found in all submissions", final=False),
}
