"""Who hands in the whole folder, with `start.v2` in it as it was given, means the other program."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.unit.marking.intake.support import PICK, put, zipped
from vrts.assignments.pack import student_zip
from vrts.assignments.task_folder import read_folder
from vrts.marking.intake.choice import GIVEN
from vrts.marking.intake.given import essence, given_to_all
from vrts.marking.intake.row import Kind
from vrts.marking.intake.take_in import take_in

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
START = b"""; Lab 1
.PROGRAM pick()
        OPENI   ; the hand is closed at first
.END
.LOCATIONS
safe 900 30 100 90 90 0
.END
"""
OF_VARIANT = b"; variant bcdf-ghjk\n" + START.replace(b"900 30", b"920 40")
GIVEN_NOW = frozenset({essence(START.decode())})


@pytest.mark.parametrize("start", [START, OF_VARIANT, START.replace(b"\n", b"\r\n")])
def test_what_was_given_is_no_hand_in_beside_a_program(start: bytes, tmp_path: Path) -> None:
    folder = zipped({"lab1/mine.v2": PICK, "lab1/start.v2": start, "lab1/README.md": b"# Lab"})
    place = put(tmp_path / "d", {"ann/lab1.zip": folder})
    (row,) = take_in(place, program="pick", given=GIVEN_NOW).rows
    assert row.title == "mine.v2"
    assert GIVEN in row.why
    (unknown,) = take_in(place, program="pick").rows
    assert unknown.problem is not None


@pytest.mark.parametrize(
    ("files", "file", "kind"),
    [
        ({"start.v2": START}, "start.v2", None),  # there is nothing else
        ({"start.v2": START.replace(b"OPENI", b"CLOSEI")}, "start.v2", None),
        ({"start.v2": START.replace(b"OPENI", b"CLOSEI"), "mine.v2": PICK}, "", Kind.AMBIGUOUS),
        ({"start.v2": START, "a.v2": PICK, "b.v2": PICK + b"; b"}, "", Kind.AMBIGUOUS),
    ],
)
def test_what_a_student_has_changed_is_looked_at(
    files: dict[str, bytes], file: str, kind: Kind | None, tmp_path: Path
) -> None:
    place = put(tmp_path / "d", {f"ann/{name}": data for name, data in files.items()})
    (row,) = take_in(place, program="pick", given=GIVEN_NOW).rows
    assert row.title == file
    assert (row.problem and row.problem.kind) == kind


def test_a_task_tells_what_was_given_packed_or_not(tmp_path: Path) -> None:
    lab = Path(shutil.copytree(LAB, tmp_path / "lab1"))
    (lab / "start.v2").unlink(missing_ok=True)
    assert not given_to_all(lab)
    (lab / "start.v2").write_bytes(START)
    assert given_to_all(lab) == given_to_all(lab / "task.toml") == GIVEN_NOW
    packed = tmp_path / "lab1-student.zip"
    packed.write_bytes(student_zip(read_folder(lab), 0))
    assert given_to_all(packed) == GIVEN_NOW
