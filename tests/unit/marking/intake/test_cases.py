"""What is handed in, and which row it becomes: every case once as a folder and once as a zip.

A result is the file that was chosen, or the kind of the problem.
"""

from pathlib import Path
from typing import NamedTuple

import pytest

from tests.unit.marking.intake.support import (
    DOCX,
    FILM,
    HEIC,
    HTML,
    JPEG,
    ODT,
    OLD_DOC,
    OTHER,
    PDF,
    PICK,
    PNG,
    PROSE,
    RAR,
    RTF,
    STEPS,
    TAR,
    UTF16,
    WITH_MARK,
    put,
    zipped,
)
from vrts.marking.intake.layouts.folders import FLAT, FOLDERS
from vrts.marking.intake.row import Intake, Kind
from vrts.marking.intake.take_in import take_in

ANNA = "Anna Berger_101_assignsubmission_file_"
LATER = PICK + b"; later\n"
METADATA = b"""---
submission_7:
  :submitters:
  - :name: Anna Berger
    :sid: '00123'
    :email: anna@uni.at
  :created_at: 2026-03-01 22:59:30.123456789 Z
  :score: 0.0
  :history: []
submission_8:
  :submitters:
  - &ben
    :name: Ben Wolf
    :sid: '77'
    :email: ben@uni.at
  - :name: Eva Maier
    :sid:
    :email: eva@uni.at
  :created_at: 2026-03-01 23:59:30 +0100
submission_9:
  :submitters:
  - *ben
  :created_at: 2026-03-03 08:00:00 Z
"""


class Case(NamedTuple):
    """A download, and the rows it becomes."""

    title: str
    files: dict[str, bytes]
    rows: dict[str, str | Kind]
    layout: str = "Moodle"
    program: str | None = "pick"
    why: str = ""  # part of the sentence in the first row, or of its problem


CASES = (
    # layouts
    Case(
        "Moodle, folders",
        {f"{ANNA}/pick.v2": PICK, "Ben Wolf_102_assignsubmission_file_/a/lab.v2": PICK},
        {
            "Anna-Berger-101": f"{ANNA}/pick.v2",
            "Ben-Wolf-102": "Ben Wolf_102_assignsubmission_file_/a/lab.v2",
        },
        why="the only file",
    ),
    Case(
        "Moodle, without folders",
        {f"{ANNA}pick.v2": PICK, "Ben Wolf_102_assignsubmission_file_x.v2": PICK},
        {
            "Anna-Berger-101": f"{ANNA}pick.v2",
            "Ben-Wolf-102": "Ben Wolf_102_assignsubmission_file_x.v2",
        },
    ),
    Case(
        "Moodle, a file that is named as if it were of somebody else",
        {f"{ANNA}Ben Wolf_102_assignsubmission_file_x.v2": PICK},
        {"Anna-Berger-101": f"{ANNA}Ben Wolf_102_assignsubmission_file_x.v2"},
    ),
    Case(
        "Moodle, the text typed into a form beside the file",
        {
            f"{ANNA}/pick.v2": PICK,
            "Anna Berger_101_assignsubmission_onlinetext_/onlinetext.html": HTML,
        },
        {"Anna-Berger-101": f"{ANNA}/pick.v2"},
    ),
    Case(
        "Moodle, all in one more folder",
        {f"Lab 1/{ANNA}/pick.v2": PICK},
        {"Anna-Berger-101": f"Lab 1/{ANNA}/pick.v2"},
    ),
    Case(
        "Moodle, blind",
        {"Participant_101_assignsubmission_file_/pick.v2": PICK},
        {"Participant-101": "Participant_101_assignsubmission_file_/pick.v2"},
    ),
    Case(
        "Canvas",
        {"bergeranna_31_901_pick-1.v2": PICK, "wolfben_LATE_32_902_lab_2_3_x.v2": PICK},
        {
            "bergeranna-31": "bergeranna_31_901_pick-1.v2",
            "wolfben-32": "wolfben_LATE_32_902_lab_2_3_x.v2",
        },
        "Canvas",
    ),
    Case(
        "Canvas, two files of one student, and a text typed into a form",
        {
            "bergeranna_31_901_pick.v2": PICK,
            "bergeranna_31_902_report.pdf": PDF,
            "wolfben_32_text.html": HTML,
        },
        {"bergeranna-31": "bergeranna_31_901_pick.v2", "wolfben-32": Kind.NOT_TEXT},
        "Canvas",
        why="the only file that has `.PROGRAM pick`",
    ),
    Case(
        "Canvas, anonymous",
        {"anon_Xy7_901_pick.v2": PICK, "LATE_anon_Zq9_902_pick.v2": PICK},
        {"anon_Xy7": "anon_Xy7_901_pick.v2", "anon_Zq9": "LATE_anon_Zq9_902_pick.v2"},
        "Canvas",
    ),
    Case(
        "Canvas, a second and a third hand-in among the files",
        {
            "bergeranna_31_901_pick.v2": OTHER + PICK,
            "bergeranna_31_950_pick-1.v2": PICK,
            "bergeranna_31_990_pick-2.v2": LATER,
        },
        {"bergeranna-31": "bergeranna_31_990_pick-2.v2"},
        "Canvas",
        why="the latest of its copies",
    ),
    Case(
        "Gradescope: a group, a student who handed in twice, and one without files",
        {
            "export/submission_metadata.yml": METADATA,
            "export/submission_7/": b"",
            "export/submission_8/pick.v2": PICK,
            "export/submission_9/lab.v2": LATER,
        },
        {
            "Anna-Berger-00123": Kind.MISSING,
            "Ben-Wolf-77": "export/submission_9/lab.v2",
            "Eva-Maier-8": "export/submission_8/pick.v2",
        },
        "Gradescope",
    ),
    Case(
        "Gradescope, a folder that the metadata do not name",
        {
            "submission_metadata.yml": METADATA[: METADATA.index(b"submission_8")],
            "submission_7/pick.v2": PICK,
            "submission_66/pick.v2": PICK,
        },
        {
            "Anna-Berger-00123": "submission_7/pick.v2",
            "submission_66": "submission_66/pick.v2",
        },
        "Gradescope",
    ),
    Case(
        "a folder for each student, one of them empty",
        {"anna/lab/pick.v2": PICK, "ben@uni.at/x.v2": PICK, "eva/": b""},
        {"anna": "anna/lab/pick.v2", "ben-uni.at": "ben@uni.at/x.v2", "eva": Kind.MISSING},
        FOLDERS,
    ),
    Case(
        "folders of attempts, named by their time, as VPL writes them",
        {
            "anna/2026-03-01-10-00-00/pick.v2": PICK,
            "anna/2026-03-02-09-00-00/pick.v2": LATER,
            "anna/2026-03-02-09-00-00.ceg/compilation.txt": b"ok",
            "ben/2026-03-01-10-00-00/pick.v2": PICK,
        },
        {
            "anna": "anna/2026-03-02-09-00-00/pick.v2",
            "ben": "ben/2026-03-01-10-00-00/pick.v2",
        },
        FOLDERS,
        why="the latest of 2 attempts; the only file",
    ),
    Case(
        "files side by side, with any ending",
        {"anna.v2": PICK, "ben.val": PICK, "eva.abc": PICK, "kim": PICK, "lee.PG": PICK},
        {"anna": "anna.v2", "ben": "ben.val", "eva": "eva.abc", "kim": "kim", "lee": "lee.PG"},
        FLAT,
    ),
    Case(
        "files side by side: a program and a report of one student",
        {"anna.v2": PICK, "anna.pdf": PDF, "ben.zip": zipped({"pick.v2": PICK})},
        {"anna": "anna.v2", "ben": "ben.zip!pick.v2"},
        FLAT,
    ),
    # names
    Case(
        "names of other scripts, and a mark on its own",
        {
            "Ольга Иванова_1_assignsubmission_file_/задача.v2": PICK,
            "अनीता_2_assignsubmission_file_/pick.v2": PICK,
            "Jose\u0301_3_assignsubmission_file_/pick.v2": PICK,
        },
        {
            "José-3": "José_3_assignsubmission_file_/pick.v2",
            "Ольга-Иванова-1": "Ольга Иванова_1_assignsubmission_file_/задача.v2",
            "अनीता-2": "अनीता_2_assignsubmission_file_/pick.v2",
        },
    ),
    Case(
        "two students of one name",
        {
            f"{ANNA}/pick.v2": PICK,
            "Anna Berger_102_assignsubmission_file_/pick.v2": PICK,
        },
        {
            "Anna-Berger-101": f"{ANNA}/pick.v2",
            "Anna-Berger-102": "Anna Berger_102_assignsubmission_file_/pick.v2",
        },
    ),
    Case(
        "names that differ in case only, and a name of Windows' own",
        {"a/Anna.v2": PICK, "b/con.v2": PICK, "ANNA/pick.v2": PICK, "anna.v2": PICK},
        {
            "ANNA": "ANNA/pick.v2",
            "a": "a/Anna.v2",
            "anna-2": "anna.v2",
            "b": "b/con.v2",
        },
        FOLDERS,
    ),
    Case(
        "files side by side named as a device, as a formula, and as a path",
        {"nul.v2": PICK, "=2+5.v2": PICK, "-x.v2": PICK},
        {"2-5": "=2+5.v2", "_nul": "nul.v2", "x": "-x.v2"},
        FLAT,
    ),
    # what is in files
    Case("UTF-16 from Notepad", {f"{ANNA}/pick.v2": UTF16}, {"Anna-Berger-101": f"{ANNA}/pick.v2"}),
    Case(
        "UTF-8 with its mark and lines of Windows, beside notes",
        {f"{ANNA}/pick.v2": WITH_MARK, f"{ANNA}/notes.txt": PROSE},
        {"Anna-Berger-101": f"{ANNA}/pick.v2"},
    ),
    Case(
        "`.v2.txt`, as Windows hides endings",
        {f"{ANNA}/pick.v2.txt": PICK, f"{ANNA}/todo.txt": PROSE},
        {"Anna-Berger-101": f"{ANNA}/pick.v2.txt"},
    ),
    Case(
        "`(1)`, as a browser numbers downloads",
        {f"{ANNA}/pick(1).v2": PICK},
        {"Anna-Berger-101": f"{ANNA}/pick(1).v2"},
    ),
    Case(
        "numbered copies: the latest",
        {
            f"{ANNA}/pick.v2": PICK,
            f"{ANNA}/pick (2).v2": LATER,
            f"{ANNA}/pick (1).v2": OTHER + PICK,
        },
        {"Anna-Berger-101": f"{ANNA}/pick (2).v2"},
        why="the latest of its copies",
    ),
    Case(
        "several programs: the one that has the task's",
        {f"{ANNA}/a.v2": OTHER, f"{ANNA}/b.txt": PICK.replace(b"pick", b"PICK")},
        {"Anna-Berger-101": f"{ANNA}/b.txt"},
        why="the only file that has `.PROGRAM pick`",
    ),
    Case(
        "several files, none with the task's program: the one that reads as VAL-II",
        {f"{ANNA}/a.txt": PROSE, f"{ANNA}/b.txt": STEPS},
        {"Anna-Berger-101": f"{ANNA}/b.txt"},
        why="the only file that reads as VAL-II; no file has `.PROGRAM pick`",
    ),
    Case(
        "several programs that fit",
        {f"{ANNA}/a.v2": PICK, f"{ANNA}/b.v2": LATER},
        {"Anna-Berger-101": Kind.AMBIGUOUS},
        why="2 files fit, and nothing says which: `a.v2`, `b.v2`",
    ),
    Case(
        "several programs, and a task that runs any",
        {f"{ANNA}/a.v2": PICK, f"{ANNA}/b.v2": OTHER},
        {"Anna-Berger-101": Kind.AMBIGUOUS},
        program=None,
    ),
    Case(
        "the same text twice",
        {f"{ANNA}/pick.v2": PICK, f"{ANNA}/copy/pick.v2": WITH_MARK[3:]},
        {"Anna-Berger-101": f"{ANNA}/pick.v2"},
        why="as others with the same text",
    ),
    Case(
        "a program and the same with comments in a text file",
        {f"{ANNA}/final.v2": PICK, f"{ANNA}/draft.txt": LATER},
        {"Anna-Berger-101": f"{ANNA}/final.v2"},
        why="is named as a program",
    ),
    Case(
        "a mistake in the first word: still the only file",
        {f"{ANNA}/pick.v2": b"PROGRM pick\nMOV a\n"},
        {"Anna-Berger-101": f"{ANNA}/pick.v2"},
    ),
    Case("an empty file", {f"{ANNA}/pick.v2": b""}, {"Anna-Berger-101": Kind.EMPTY}),
    Case("blanks only", {f"{ANNA}/pick.v2": b" \r\n\n"}, {"Anna-Berger-101": Kind.EMPTY}),
    Case("a folder without files", {f"{ANNA}/": b""}, {"Anna-Berger-101": Kind.MISSING}),
    Case(
        "nothing but what systems leave behind",
        {
            f"{ANNA}/__MACOSX/._pick.v2": b"\0\5\x16\7",
            f"{ANNA}/.DS_Store": b"\0\0\0\1Bud1",
            f"{ANNA}/desktop.ini": b"[.ShellClassInfo]",
            f"{ANNA}/Thumbs.db": OLD_DOC,
        },
        {"Anna-Berger-101": Kind.MISSING},
    ),
    Case(
        "a Word document",
        {f"{ANNA}/pick.v2.docx": DOCX},
        {"Anna-Berger-101": Kind.NOT_TEXT},
        why="`pick.v2.docx` is a Word document; copy the program into a plain editor",
    ),
    Case("an OpenDocument text", {f"{ANNA}/a.odt": ODT}, {"Anna-Berger-101": Kind.NOT_TEXT}),
    Case("an old document", {f"{ANNA}/a.doc": OLD_DOC}, {"Anna-Berger-101": Kind.NOT_TEXT}),
    Case(
        "a PDF that is called a program",
        {f"{ANNA}/pick.v2": PDF},
        {"Anna-Berger-101": Kind.NOT_TEXT},
        why="a PDF document",
    ),
    Case("rich text", {f"{ANNA}/pick.v2": RTF}, {"Anna-Berger-101": Kind.NOT_TEXT}),
    Case(
        "photos of the screen, and a film",
        {f"{ANNA}/1.jpg": JPEG, f"{ANNA}/2.png": PNG, f"{ANNA}/3.heic": HEIC, f"{ANNA}/4": FILM},
        {"Anna-Berger-101": Kind.NOT_TEXT},
        why="is a picture; type the program",
    ),
    Case(
        "notes and a Word document: the document was meant",
        {f"{ANNA}/README.txt": PROSE, f"{ANNA}/pick.docx": DOCX},
        {"Anna-Berger-101": Kind.NOT_TEXT},
    ),
    Case("binary data", {f"{ANNA}/pick.v2": bytes(range(256))}, {"Anna-Berger-101": Kind.NOT_TEXT}),
    Case(
        "a file that is too large for a program",
        {f"{ANNA}/pick.v2": b"; x\n" * 1_000_001},
        {"Anna-Berger-101": Kind.TOO_LARGE},
        why="has 4.0 MB",
    ),
    # archives
    Case(
        "a zip in the zip",
        {f"{ANNA}/work.zip": zipped({"lab/pick.v2": PICK, "lab/report.pdf": PDF})},
        {"Anna-Berger-101": f"{ANNA}/work.zip!lab/pick.v2"},
    ),
    Case(
        "a zip in a zip in the zip",
        {f"{ANNA}/work.zip": zipped({"inner.zip": zipped({"pick.v2": PICK})})},
        {"Anna-Berger-101": Kind.ARCHIVE},
        why="`inner.zip` is an archive in an archive, which is not opened",
    ),
    Case(
        "a Word document in a zip",
        {f"{ANNA}/work.zip": zipped({"pick.docx": DOCX})},
        {"Anna-Berger-101": Kind.NOT_TEXT},
    ),
    Case(
        "a zip from a Mac",
        {f"{ANNA}/work.zip": zipped({"pick.v2": PICK, "__MACOSX/._pick.v2": b"\0\5\x16\7"})},
        {"Anna-Berger-101": f"{ANNA}/work.zip!pick.v2"},
    ),
    Case("an empty zip", {f"{ANNA}/work.zip": zipped({})}, {"Anna-Berger-101": Kind.EMPTY}),
    Case(
        "a damaged zip",
        {f"{ANNA}/work.zip": zipped({"pick.v2": PICK})[:-9]},
        {"Anna-Berger-101": Kind.ARCHIVE},
        why="`work.zip` is damaged or not complete",
    ),
    Case(
        "other archives",
        {f"{ANNA}/work.tar": TAR, "Ben_2_assignsubmission_file_/x.rar": RAR},
        {"Anna-Berger-101": Kind.ARCHIVE, "Ben-2": Kind.ARCHIVE},
        why="`work.tar` is a tar archive, which is not opened",
    ),
)


@pytest.mark.parametrize("form", ["folder", "zip"])
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.title)
def test_case(case: Case, form: str, tmp_path: Path) -> None:
    place = tmp_path / "download"
    if form == "folder":
        put(place, case.files)
    else:
        place.write_bytes(zipped(case.files))
    found = take_in(place, program=case.program)
    assert outcome(found) == case.rows
    assert found.layout == case.layout
    first = found.rows[0]
    assert case.why in (first.why if first.problem is None else first.problem.sentence)


def outcome(intake: Intake) -> dict[str, str | Kind | None]:
    return {
        row.identifier: row.file if row.problem is None else row.problem.kind for row in intake.rows
    }


def test_there_are_thirty_cases() -> None:
    assert len({case.title for case in CASES}) == len(CASES) >= 30
