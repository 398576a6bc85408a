"""Feedback to be sent: a folder for each student, and the zip that Moodle takes."""

import io
import zipfile
from random import Random

import pytest

from tests.support_exports import HOSTILE, given, hostile, row
from vrts.marking.exports.folders import folders, moodle_feedback
from vrts.marking.exports.given import Options, Page, Product
from vrts.marking.row import Row, Student


def names(product: Product) -> list[str]:
    ((_, data),) = product.files
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert archive.testzip() is None
        return archive.namelist()


def participant(path: str) -> tuple[str, str] | None:
    """Return id and file of a path as Moodle reads it (importziplib.php, Moodle 3.1 to 5).

    Of the first part that has four fields between `_`, of which the second is a number, the plugin
    is the third and fourth, and what follows is the file.
    """
    parts = path.split("/")
    while parts:
        fields = parts.pop(0).split("_", 4)
        if len(fields) < 4 or not fields[1].isdecimal():
            continue
        assert fields[2:4] == ["assignsubmission", "file"]
        return fields[1], "/".join([fields[4] if len(fields) > 4 else "", *parts]).lstrip("/")
    return None


def moodler(name: str, number: str = "123456") -> Row:
    return row("anna", student=Student(name, ids={"moodle": number}))


def test_a_folder_holds_feedback_report_and_recording() -> None:
    found = [name for name, _ in folders(given([row()]), Options()).files]
    assert found == [
        "folders/anna/feedback.txt",
        "folders/anna/report.html",
        "folders/anna/run.rrd",
    ]
    brief = folders(given([row()]), Options(pages=False)).files
    assert [name for name, _ in brief] == ["folders/anna/feedback.txt"]


def test_the_zip_has_the_folders_of_moodle_s_own_download() -> None:
    found = moodle_feedback(given([moodler("Anna Berger")]), Options())
    assert found.diagnostics == ()
    assert names(found) == [
        "Anna Berger_123456_assignsubmission_file_/feedback.txt",
        "Anna Berger_123456_assignsubmission_file_/report.html",
    ]


def test_who_has_no_number_is_told() -> None:
    found = moodle_feedback(given([row("zoe"), moodler("Ben")]), Options())
    (warning,) = found.diagnostics
    assert warning.rule.code == "V748"
    assert warning.headline == "1 student has no number of Moodle, and no feedback in the zip"
    assert warning.notes == ("`zoe`",)
    assert len(names(found)) == 2


@pytest.mark.thorough
def test_a_zip_that_is_too_large_for_most_sites_is_told() -> None:
    report = Page("report.html", Random(1).randbytes(51_000_000))

    def pages(identifier: str) -> tuple[Page, ...]:
        return (report,) if identifier == "anna" else ()

    large = given([moodler("Ben")])._replace(pages=pages)
    (warning,) = moodle_feedback(large, Options()).diagnostics
    assert (warning.rule.code, warning.headline) == (
        "V752",
        "the zip has 51 MB, more than most sites of Moodle take",
    )
    assert moodle_feedback(large, Options(pages=False)).diagnostics == ()


@pytest.mark.parametrize("words", [*HOSTILE, "A_9_assignsubmission_file_", "", "_", "Çelik Ömer"])
def test_moodle_finds_the_right_student_whatever_the_name(words: str) -> None:
    found = names(moodle_feedback(given([moodler(words, "77")]), Options()))
    assert [participant(f"/import/{name}") for name in found] == [
        ("77", "feedback.txt"),
        ("77", "report.html"),
    ]
    for name in found:
        assert name.count("/") == 1
        assert not {"\\", ":", "*", "?", '"', "<", ">", "|"} & set(name)


def test_ids_that_are_no_numbers_make_no_folder() -> None:
    found = moodle_feedback(given([moodler("Anna", "../1")]), Options())
    assert names(found) == []
    assert [d.rule.code for d in found.diagnostics] == ["V748"]


def test_hostile_words_name_no_folder() -> None:
    rows = [hostile(words, n) for n, words in enumerate(HOSTILE)]
    for name, _ in folders(given(rows), Options(pages=False)).files:
        assert name.startswith("folders/s")
        assert name.endswith("/feedback.txt")
