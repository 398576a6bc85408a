"""What rows tell beside the file: times, groups, attempts, and the bytes themselves."""

import pickle
from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path

from tests.unit.marking.intake.support import OTHER, PDF, PICK, PROSE, UTF16, put, zipped
from tests.unit.marking.intake.test_cases import ANNA, LATER, METADATA
from vrts.marking.intake.candidate import data_of
from vrts.marking.intake.layouts.folders import LIST
from vrts.marking.intake.row import Attempt, Row
from vrts.marking.intake.take_in import take_in
from vrts.marking.intake.tree.opening import open_place

EXPORT = {
    "export/submission_metadata.yml": METADATA,
    "export/submission_7/pick.v2": PICK,
    "export/submission_8/pick.v2": PICK,
    "export/submission_9/lab.v2": LATER,
}
ONE_HOUR = timezone(timedelta(hours=1))


def one(place: Path) -> Row:
    (row,) = take_in(place, program="pick").rows
    return row


def test_gradescope_tells_identity_and_time(tmp_path: Path) -> None:
    anna, ben, eva = take_in(put(tmp_path / "d", EXPORT), program="pick").rows
    assert anna.student.name == "Anna Berger"
    assert anna.student.email == "anna@uni.at"
    assert anna.student.ids == {"gradescope": "7", "sis": "00123"}
    assert anna.received == datetime(2026, 3, 1, 22, 59, 30, tzinfo=UTC)
    assert eva.received == datetime(2026, 3, 1, 22, 59, 30, tzinfo=UTC)
    assert eva.group == "submission_8"
    assert (anna.group, ben.group) == ("", "")  # what counts of Ben he handed in alone


def test_the_latest_attempt_counts_and_the_others_can_be_marked(tmp_path: Path) -> None:
    _, ben, _ = take_in(put(tmp_path / "d", EXPORT), program="pick").rows
    assert ben.file == "export/submission_9/lab.v2"
    assert ben.why == "the latest of 2 attempts; the only file"
    assert ben.attempt == 2
    assert ben.attempts == (
        Attempt("export/submission_8/pick.v2", datetime(2026, 3, 1, 22, 59, 30, tzinfo=UTC)),
        Attempt("export/submission_9/lab.v2", datetime(2026, 3, 3, 8, tzinfo=UTC)),
    )
    assert ben.others == ("export/submission_8/pick.v2",)


def test_copies_are_attempts_in_order(tmp_path: Path) -> None:
    files = {f"{ANNA}/pick.v2": PICK, f"{ANNA}/pick (10).v2": LATER, f"{ANNA}/pick (9).v2": PICK}
    row = one(put(tmp_path / "d", files))
    assert [attempt.file for attempt in row.attempts] == [
        f"{ANNA}/pick.v2",
        f"{ANNA}/pick (9).v2",
        f"{ANNA}/pick (10).v2",
    ]


def test_times_in_names_of_folders_need_a_zone(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"anna/2026-03-01-10-00-00/pick.v2": PICK})
    assert take_in(place, program=None).rows[0].received is None
    row = take_in(place, program=None, zone=ONE_HOUR).rows[0]
    assert row.received == datetime(2026, 3, 1, 10, tzinfo=ONE_HOUR)


def test_times_of_files_never_count(tmp_path: Path) -> None:
    assert one(put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})).received is None


def test_canvas_tells_that_a_hand_in_is_late_but_not_when_it_came(tmp_path: Path) -> None:
    row = one(put(tmp_path / "d", {"bergeranna_LATE_31_901_pick.v2": PICK}))
    assert row.flagged
    assert row.received is None
    assert row.student.name == "bergeranna"
    assert row.student.ids == {"canvas": "31"}


def test_what_was_not_chosen_is_told(tmp_path: Path) -> None:
    files = {f"{ANNA}/a.v2": OTHER, f"{ANNA}/b.v2": PICK, f"{ANNA}/c.pdf": PDF}
    assert one(put(tmp_path / "d", files)).others == (f"{ANNA}/a.v2", f"{ANNA}/c.pdf")


def test_strays_of_a_download_are_remarked_on(tmp_path: Path) -> None:
    files = {f"{ANNA}/pick.v2": PICK, "list of names.txt": PROSE, "intake.csv": b"id,file\n"}
    put(tmp_path / "d", {**files, "Ben_2_assignsubmission_file_/x.v2": PICK})
    found = take_in(tmp_path / "d", program="pick")
    assert len(found.rows) == 2
    assert found.remarks == ("`list of names.txt` is not of a student",)


def test_what_teachers_keep_beside_hand_ins_is_none(tmp_path: Path) -> None:
    files = {"anna.v2": PICK, "README.md": PROSE, "names.csv": b"a,b", "notes.v2": PICK}
    found = take_in(put(tmp_path / "d", files), program="pick")
    assert [row.identifier for row in found.rows] == ["anna", "notes"]
    assert found.remarks == (
        "`README.md` is taken for no hand-in",
        "`names.csv` is taken for no hand-in",
    )


def test_copies_side_by_side_may_be_of_two_students(tmp_path: Path) -> None:
    found = take_in(put(tmp_path / "d", {"a.v2": PICK, "a (1).v2": PICK}), program="pick")
    assert [row.identifier for row in found.rows] == ["a", "a-1"]
    assert "are two rows" in found.remarks[0]


def test_bytes_are_those_that_were_handed_in(tmp_path: Path) -> None:
    files = {"anna.v2": UTF16, "ben.zip": zipped({"a!b/pick.v2": PICK}), "c!d.v2": LATER}
    place = put(tmp_path / "d", files)
    with open_place(place) as tree:
        found = {
            row.file: data_of(tree, row.file or "") for row in take_in(place, program="pick").rows
        }
    assert found == {"anna.v2": UTF16, "ben.zip!a!b/pick.v2": PICK, "c!d.v2": LATER}


def test_files_named_are_a_hand_in_each(tmp_path: Path) -> None:
    put(tmp_path, {"x/pick.v2": PICK, "y/pick.v2": LATER, "z/lab.v2": PICK, "z/.hidden": PICK})
    named = [tmp_path / "x" / "pick.v2", tmp_path / "y" / "pick.v2", tmp_path / "z"]
    found = take_in(named, program="pick")
    assert found.layout == LIST
    assert [row.identifier for row in found.rows] == ["lab", "pick", "pick-2"]
    assert [row.title for row in found.rows] == ["lab.v2", "pick.v2", "pick.v2"]


def test_the_same_bytes_give_the_same_rows(tmp_path: Path) -> None:
    files = {f"S {n % 7}_{n}_assignsubmission_file_/p.v2": PICK for n in range(40)}
    first = take_in(put(tmp_path / "a", files), program="pick")
    backwards = dict(reversed(files.items()))
    assert take_in(put(tmp_path / "b", backwards), program="pick") == first
    (tmp_path / "c").write_bytes(zipped(backwards))
    assert take_in(tmp_path / "c", program="pick") == first


def test_rows_go_to_other_processes(tmp_path: Path) -> None:
    row = one(put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK}))
    assert pickle.loads(pickle.dumps(row)) == row
