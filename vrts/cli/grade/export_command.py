"""`vrts grade export`."""

import os
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vrts.cli.grade.options import despite_option
from vrts.cli.shared.console import fail, guarded, say, show_diagnostics
from vrts.cli.shared.options import Option, color_option, file_option

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vrts.marking.exports.given import Options, Page
    from vrts.marking.layout import Layout
    from vrts.marking.row import Class

EPILOG = """\b
Formats:
  csv              a table of all marks
  json             everything, as in `vrts schema class`
  moodle           Moodle's grading worksheet, filled in with marks and comments
  canvas           the grade book of Canvas, filled in
  moodle-feedback  a zip for Moodle's "Upload multiple feedback files in a zip"
  folders          a folder for each student: feedback.txt, report, recording
  gradescope       results.json of each submission
  prairielearn     results.json of each submission
  classroom50      result.json, inside a run of Classroom 50
  junit            JUnit XML, a suite for each submission
  sarif            what compiler, run and checks found in all submissions

\b
Examples:
  vrts grade export out --to csv --to junit
  vrts grade export out --to csv --decimal comma
  vrts grade export out --to moodle --fill Grades-Robotics-Lab1.csv
  vrts grade export out --to canvas --fill gradebook.csv --column "Lab 1 (4711)"
  vrts grade export out --to moodle-feedback -o feedback.zip
"""

MOST_POINTS = 10_000
DECIMALS = {"comma": ",", "point": "."}
WITH_DECIMALS = ("csv", "moodle", "canvas")  # formats that --decimal changes
NAMES = (
    "csv",
    "json",
    "moodle",
    "canvas",
    "moodle-feedback",
    "folders",
    "gradescope",
    "prairielearn",
    "classroom50",
    "junit",
    "sarif",
)  # a test holds them against the table of formats, which is imported when it is used


def decimal_option() -> Option[Any]:
    """Return `--decimal`."""
    return click.option(
        "--decimal",
        type=click.Choice(sorted(DECIMALS)),
        help="Decimal sign; with `comma` a `csv` has semicolons. Without it as FILE writes them.",
    )


def require_decimals(decimal: str | None, names: "Sequence[str]") -> None:
    """Refuse `--decimal` where no format takes it."""
    if decimal is not None and not set(names) & set(WITH_DECIMALS):
        fail("`--decimal` is for the formats csv, moodle and canvas: the others have their own way")


@click.command(name="export", epilog=EPILOG)
@click.argument("folder", metavar="OUT", type=click.Path(path_type=Path))
@click.option(
    "--to",
    "names",
    type=click.Choice(NAMES),
    multiple=True,
    required=True,
    metavar="FORMAT",
    help="What to write; you may give it more than once.",
)
@file_option(
    "--fill",
    metavar="FILE",
    help="The worksheet or grade book that you exported; it is read, and stays as it is.",
)
@click.option("--column", default="", metavar="TITLE", help="The column in FILE for the marks.")
@click.option("--points", metavar="N", help="What the full mark is worth; without it as in FILE.")
@click.option("--no-comments", is_flag=True, help="Fill in marks only, no comments.")
@click.option("--no-pages", is_flag=True, help="Feedback without reports and recordings.")
@click.option(
    "--delimiter",
    type=click.Choice([",", ";"]),
    help="Separator of fields in `csv`, usually `,`; with `;` numbers have a decimal comma.",
)
@decimal_option()
@despite_option()
@file_option(
    "-o",
    "--output",
    "target",
    help="File to write, or folder if there are several; without it OUT/staff/exports.",
)
@color_option
@guarded
def command(
    folder: Path,
    names: tuple[str, ...],
    fill: Path | None,
    column: str,
    points: str | None,
    no_comments: bool,
    no_pages: bool,
    delimiter: str | None,
    decimal: str | None,
    despite: tuple[str, ...],
    target: Path | None,
    color: str,
) -> None:
    """Write the marks in OUT in the formats of other systems.

    OUT is the folder that `vrts grade` wrote with -o. The marks are final: after lateness, and
    after what is decided by hand in OUT/staff/overrides.toml and OUT/staff/decisions now. A
    worksheet or grade book is only filled in: every other field, the order of rows and columns,
    delimiter, decimal mark and line ends stay as they are. Students are found by id, then by
    address or login, then by name. What students get says nothing of hidden checks.

    Nothing that may be taken for final is written while marks are unsafe: late without a time,
    ambiguous, undetermined, and so on. `vrts grade change` decides one of them, `--despite` accepts
    them; then the export says so. Only json, junit and sarif are written in any case. For
    gradescope, prairielearn and classroom50 lateness is the platform's business: there nobody asks
    when it came.

    After marking with --pseudonyms, the files for Moodle and Canvas and the table have the names
    again, from OUT/staff/names.csv. All other files stay without names.
    """
    from vrts.marking.appeals.written import read_written
    from vrts.marking.by_hand.by_hand import all_lapses, rows_by_hand
    from vrts.marking.exports.autograders.classroom50 import from_environment
    from vrts.marking.exports.earlier_marks import with_times_judged
    from vrts.marking.exports.given import Options
    from vrts.marking.renewing.renewed import brought_up_to_date

    require_decimals(decimal, names)
    written = read_written(folder)
    by_hand = written.by_hand()
    show_diagnostics(by_hand.diagnostics, color)
    options = Options(
        given_page(fill),
        column,
        _full_marks(points, DECIMALS.get(decimal or "", "")),
        not no_comments,
        delimiter or (";" if decimal == "comma" else ","),
        not no_pages,
        from_environment(os.environ),
        datetime.now(UTC),
        DECIMALS.get(decimal or "", ""),
        frozenset(despite),
    )
    judged, said = with_times_judged(written.rows, written.about.place)
    rows = rows_by_hand(judged, by_hand)
    show_diagnostics((*said, *all_lapses(rows.rows, by_hand)), color)
    brought_up_to_date(written)  # pages that go out say what is decided
    export(names, rows, written.layout, options, color, target)


def given_page(path: Path | None) -> "Page | None":
    """Return the teacher's file that is to be filled in."""
    from vrts.marking.exports.given import Page
    from vrts.pipeline.files import read_bytes

    return None if path is None else Page(path.name, read_bytes(path))


def export(
    names: "Sequence[str]",
    rows: "Class",
    layout: "Layout",
    options: "Options",
    color: str,
    target: Path | None = None,
) -> None:
    """Write a class in some formats, and say what was written."""
    from vrts.marking.exports.write import write_exports

    write_exports(
        tuple(dict.fromkeys(names)),
        rows,
        layout,
        options,
        tell=lambda found: show_diagnostics(found, color),
        wrote=lambda path: say(f"wrote {path}"),
        target=target,
    )


def _full_marks(text: str | None, point: str) -> Fraction | None:
    """Return what full marks are worth, exactly; a comma will do, or `point` says what it parts."""
    from vrts.base.written_numbers import Doubtful, read_number

    if text is None:
        return None
    try:
        found = read_number(text, point)
    except Doubtful:
        hint = "write decimals with a point, 1.234, or say `--decimal`"
        fail(f"`{text}` may be a thousand or not", (hint,))
    if found is None or not 0 < found <= MOST_POINTS:
        fail(f"`{text}` is no number of points", (f"write a number up to {MOST_POINTS:,}",))
    return found
