"""Feedback to be sent: a folder for each student, or the zip that Moodle gives out to them."""

import unicodedata
from collections.abc import Iterator, Sequence

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.base.safe_names import safe
from vrts.base.zips import packed_in_turn
from vrts.marking.exports.feedback import NAME, feedback_text
from vrts.marking.exports.given import Given, Options, Page, Product, Returned, returned
from vrts.marking.intake.row import Platform
from vrts.marking.row import Row
from vrts.marking.submission.report_files import RECORDING

NO_MOODLE_ID = Rule("V748", "no-moodle-id")
LARGE_UPLOAD = Rule("V752", "large-upload")
ZIP = "moodle-feedback.zip"
MODE = 0o644  # of members
LARGE = 50_000_000  # bytes of an upload; assumed
LONGEST_NAME = 60
SHOWN = 10  # names in a diagnostic


def folders(given: Given, options: Options) -> Product:
    """Return a folder for each student, by id."""
    return Product(
        (f"folders/{told.row.id}/{page.name}", page.data)
        for told in returned(given)
        for page in _pages(told, given, options)
    )


def moodle_feedback(given: Given, options: Options) -> Product:
    """Return the zip for "Upload multiple feedback files in a zip".

    Moodle reads name, id and plugin from the folders, parted by `_`, and goes by the id alone.
    """
    numbers = {row.id: row.student.ids.get(Platform.MOODLE.value, "") for row in given.whole.rows}
    without = [name for name, text in numbers.items() if not (text.isascii() and text.isdecimal())]
    members = (
        (f"{_name(told.row)}_{numbers[told.row.id]}_assignsubmission_file_/{page.name}", page.data)
        for told in returned(given)
        if told.row.id not in without
        for page in _pages(told, given, options)
        if page.name != RECORDING  # too large for an upload
    )
    data = packed_in_turn(members, MODE)
    return Product([(ZIP, data)], (*_without_number(without), *_large(len(data))))


def _without_number(without: Sequence[str]) -> Iterator[Diagnostic]:
    if without:
        names = ", ".join(f"`{name}`" for name in without[:SHOWN])
        rest = f" and {len(without) - SHOWN} more" if len(without) > SHOWN else ""
        who = "student has" if len(without) == 1 else "students have"
        yield warning(
            NO_MOODLE_ID,
            f"{len(without)} {who} no number of Moodle, and no feedback in the zip",
            notes=(f"{names}{rest}",),
            help=("mark Moodle's own download, or send `folders` in another way",),
        )


def _large(size: int) -> Iterator[Diagnostic]:
    if size > LARGE:
        yield warning(
            LARGE_UPLOAD,
            f"the zip has {size // 1_000_000} MB, more than most sites of Moodle take",
            help=("leave the reports out with `--no-pages`",),
        )


def _pages(told: Returned, given: Given, options: Options) -> Iterator[Page]:
    yield Page(NAME, feedback_text(told))
    if options.pages:
        yield from given.pages(told.row.id)


def _name(row: Row) -> str:
    """Return a name as a part of a folder's: nothing that parts names, folders or drives."""
    kept = (c if unicodedata.category(c)[0] in "LMN" else " " for c in row.student.name)
    plain = " ".join("".join(kept).split())[:LONGEST_NAME].strip()
    return safe(plain).replace("-", " ").replace("_", " ").strip() if plain else "Participant"
