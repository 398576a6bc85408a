"""Marks of an earlier vrts are kept back where a time that nobody told may cost points."""

import json
from pathlib import Path

from click.testing import CliRunner, Result

from tests.places import ROOT
from tests.support_rows import plain_result, plain_row
from vrts.cli.grade import export_command
from vrts.marking.exports.earlier_marks import with_times_judged
from vrts.marking.layout import Layout
from vrts.marking.result import Kind, to_bytes
from vrts.marking.row import Class, HandedIn, Student, class_from_bytes, class_to_bytes, row_of
from vrts.marking.submission.setting import Place
from vrts.marking.unsafe import Reason

LATE = "\n[late]\ndue = 2026-11-01T12:00:00+01:00\nper_day = 1\n"
TASK = (ROOT / "examples" / "01-cans-on-bases" / "task.toml").read_text("utf-8")


def earlier(folder: Path, task: Path) -> Path:
    """Write what an earlier vrts left: it did not tell what is unsafe."""
    timed = row_of(plain_result("ben"), Student("Ben"), HandedIn("b.v2", "", "2026-10-31T12:00:00"))
    cem = Student("C", ids={"canvas": "3"})
    canvas = row_of(plain_result("cem"), cem, HandedIn("d/cem_3_901_c.zip!c.v2"))
    nothing = plain_row("dora", kind=Kind.MISSING, mark=None)
    rows = (plain_row("anna", "Anna"), timed, canvas, nothing)
    found = json.loads(class_to_bytes(Class("vrts.class/1", "Lab", rows)))
    del found["unsafe"]
    for row in found["rows"]:
        del row["unsafe"]
    layout = Layout(folder)
    layout.staff.mkdir(parents=True)
    layout.results.write_text(json.dumps(found))
    about: dict[str, object] = {
        "schema": "vrts.marking/1",
        "title": "Lab",
        "place": {"task": str(task)},
        "submissions": [],
        "wanted": {},
        "vrts": "0.1",
        "command": [],
        "finished": "2026-11-20T12:00:00Z",
    }
    (layout.staff / "marking.json").write_text(json.dumps(about))
    for row in rows:
        layout.student(row.id).mkdir(parents=True)
        (layout.student(row.id) / "result.json").write_bytes(to_bytes(row.result))
    return folder


def test_a_file_from_elsewhere_is_not_on_time_for_an_id_of_canvas(tmp_path: Path) -> None:
    place = Place(str(task(tmp_path, TASK + LATE)))
    cem = Student("C", ids={"canvas": "3"})
    for file, found in (("cem_3_901_c.v2", ()), ("mailed.v2", (Reason.LATE,))):
        whole = Class("vrts.class/1", "Lab", (row_of(plain_result("cem"), cem, HandedIn(file)),))
        (row,) = with_times_judged(whole, place).rows.rows
        assert tuple(doubt.reason for doubt in row.unsafe) == found


def exported(out: Path, name: str) -> Result:
    return CliRunner().invoke(export_command.command, [str(out), "--to", name])


def task(folder: Path, text: str) -> Path:
    place = folder / "task.toml"
    place.write_text(text, "utf-8")
    return place


def test_where_lateness_costs_points_marks_without_a_time_are_kept_back(tmp_path: Path) -> None:
    out = earlier(tmp_path / "out", task(tmp_path, TASK + LATE))
    said = exported(out, "csv")
    assert said.exit_code == 1
    assert "V754 lateness-untold]: 1 hand-in has no time, and the vrts that" in said.output
    assert "1 of 4 marks is unsafe, so nothing is written: `anna` (late)" in said.output
    assert exported(out, "gradescope").exit_code == 0


def test_where_the_task_is_gone_nobody_knows_what_lateness_costs(tmp_path: Path) -> None:
    said = exported(earlier(tmp_path / "out", tmp_path / "gone.toml"), "csv")
    assert said.exit_code == 1
    assert "the task cannot be read any more" in said.output
    assert "`anna` (late)" in said.output


def test_where_lateness_costs_nothing_nothing_is_said(tmp_path: Path) -> None:
    out = earlier(tmp_path / "out", task(tmp_path, TASK))
    said = exported(out, "csv")
    assert said.exit_code == 0, said.output
    assert "V75" not in said.output


def test_nobody_counts_what_an_earlier_vrts_did_not_judge(tmp_path: Path) -> None:
    for name, text in (("a", TASK), ("b", TASK + LATE)):
        home = tmp_path / name
        home.mkdir()
        out = earlier(home / "out", task(home, text))
        assert exported(out, "json").exit_code == 0
        document = json.loads((out / "staff" / "exports" / "class.json").read_bytes())
        assert document["unsafe"] is None
        (late,) = [bool(row["unsafe"]) for row in document["rows"] if row["id"] == "anna"]
        assert late == (name == "b")


def test_what_this_vrts_marked_is_judged_already(tmp_path: Path) -> None:
    whole = class_from_bytes(class_to_bytes(Class("vrts.class/1", "Lab", (plain_row("anna"),))))
    place = Place(str(task(tmp_path, TASK + LATE)))
    assert with_times_judged(whole, place) == (whole, ())
    judged, _ = with_times_judged(Class("vrts.class/1", "Lab", whole.rows), place)
    assert [doubt.reason for doubt in judged.rows[0].unsafe] == [Reason.LATE]
