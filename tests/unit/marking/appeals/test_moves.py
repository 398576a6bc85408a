"""Who moves and why; that nobody falls who is not to fall."""

import json
from pathlib import Path

import msgspec
import pytest
from click.testing import CliRunner, Result

from tests.unit.marking.appeals.support import class_of, result, row
from vrts.cli.main import vrts
from vrts.marking.appeals.moves import diff
from vrts.marking.appeals.moves_text import diff_text
from vrts.marking.by_hand.by_hand import ByHand, rows_by_hand
from vrts.marking.by_hand.override_text import load_overrides
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.result import Kind, Named
from vrts.marking.row import Change, Class, Lateness, class_to_bytes

REPAIRED = Named("lab1", "Lab 1", 64 * "e")
OLD = class_of(row("anna", 8.5), row("ben", 6.0), row("cara", 4.0), row("dora", None), row("emil"))


def write(folder: Path, rows: Class) -> Path:
    """Write the rows of a class as marking does."""
    write_atomically(Layout(folder).results, class_to_bytes(rows))
    return folder


def call(*words: object) -> Result:
    """Call `vrts grade diff`."""
    return CliRunner().invoke(vrts, ["grade", "diff", *map(str, words)])


def repaired() -> Class:
    """Return the class after a repair of the task: ben falls, cara rises, emil is gone."""
    anna = row("anna", 8.5, task=REPAIRED)
    ben = row("ben", 4.8, task=REPAIRED)
    check = ben.result.checks[0]
    worse = msgspec.structs.replace(check, answer="violated", points=0.5)
    fallen = msgspec.structs.replace(ben.result, checks=(worse, *ben.result.checks[1:]))
    ben = msgspec.structs.replace(ben, result=fallen)
    cara, dora, finn = row("cara", 9.0, task=REPAIRED), row("dora", 2.0), row("finn", 1.0)
    return class_of(anna, ben, cara, dora, finn)


def test_who_moves_from_what_to_what_and_why() -> None:
    found = diff(OLD, repaired())
    assert [(m.id, m.old, m.new, m.by) for m in found.moves] == [
        ("ben", 6.0, 4.8, "-6/5"),
        ("cara", 4.0, 9.0, "5"),
        ("dora", None, 2.0, None),
    ]
    check = result().checks[0]
    ben, _, dora = found.moves
    assert ben.reasons == (
        f"{check.title}: {check.answer} → violated, {check.points:g} → 0.5 points",
    )
    assert dora.reasons[0].startswith("resource → graded: ")
    assert found.conditions[0].startswith("the task has changed for 3 of 4 students: `")
    assert len(found.conditions) == 1
    assert (found.same, found.gone, found.added) == (1, ("emil",), ("finn",))


def test_lateness_and_changes_by_hand_are_reasons() -> None:
    late = Lateness(3600, "1", "1 h late: 1 point less")
    new = row("anna", 8.5, late)
    changed = msgspec.structs.replace(
        row("ben", 6.0), change=Change("1/2", "goal 2", "RH", "2026-11-30"), final=6.5
    )
    found = diff(OLD, class_of(new, changed))
    assert [m.reasons for m in found.moves] == [("for lateness 0 → -1",), ("by hand 0 → +0.5",)]
    assert found.conditions == ()


def test_losses_are_reasons_where_no_check_says_more() -> None:
    (loss,) = result().losses
    less = msgspec.structs.replace(result(mark=9.0), losses=())
    found = diff(OLD, class_of(msgspec.structs.replace(row("anna", 9.0), result=less)))
    (reason,) = found.moves[0].reasons
    assert reason == f"no longer lost: +{loss.points:g}, {loss.sentence}"


def test_a_class_does_not_move_from_itself(tmp_path: Path) -> None:
    same = write(tmp_path, OLD)
    found = call(same, same)
    assert found.exit_code == 0
    assert "0 of 5 move" in found.stdout
    assert "task, scene and versions are the same" in found.stdout


def test_rounding_is_no_reason() -> None:
    (check, *_) = result().checks
    rounding = msgspec.structs.replace(check, id="rounding", kind="rounding", points=0.02)
    worse = msgspec.structs.replace(check, points=1 / 3)
    old = msgspec.structs.replace(row("anna", 5.0), result=result(checks=(check, rounding)))
    new = msgspec.structs.replace(row("anna", 4.0), result=result(checks=(worse,)))
    (move,) = diff(class_of(old), class_of(new)).moves
    assert move.reasons == (f"{check.title}: {check.answer}, {check.points:g} → 0.3333 points",)


def test_text_shows_marks_side_by_side() -> None:
    text = diff_text(diff(OLD, repaired()))
    assert "ben    6.0    4.8   -1.2   " in text
    assert "dora     -    2.0          " in text
    assert "3 of 4 move: 1 up, 1 down, by 1.2 at most, 1 between a mark and none" in text
    assert "only in the old marking: emil" in text


def test_names_cannot_paint_the_terminal() -> None:
    nasty = "x\x1b[31m\ny"
    found = diff(class_of(row(nasty, 5.0)), class_of(row(nasty, 4.0)))
    assert "\x1b" not in diff_text(found)
    assert len([line for line in diff_text(found).split("\n") if "5.0" in line]) == 1


def test_never_lower_gives_back_what_a_repair_has_taken(tmp_path: Path) -> None:
    old, new = write(tmp_path / "old", OLD), write(tmp_path / "new", repaired())
    assert call(old, new).exit_code == 1
    found = call(old, new, "--never-lower", "--who", "R. Huber")
    assert found.exit_code == 0, found.output
    place = Layout(new).overrides
    (change,) = load_overrides(place, ("ben",)).changes["ben"]
    assert (change.who, change.reason) == (
        "R. Huber",
        "never lowered after marking again by `Lab 1`",
    )
    rows = rows_by_hand(repaired(), ByHand(load_overrides(place, ("ben",))))
    assert [row.final for row in rows.rows] == [8.5, 6.0, 9.0, 2.0, 1.0]
    before = place.read_bytes()
    again = call(old, new, "--never-lower")
    assert "nobody falls" in again.stderr
    assert place.read_bytes() == before


def test_never_lower_reaches_the_old_mark_also_from_below_zero(tmp_path: Path) -> None:
    old, new = write(tmp_path / "old", OLD), write(tmp_path / "new", class_of(row("ben", 1.0)))
    place = Layout(new).overrides
    write_atomically(
        place,
        b'[[change]]\nstudent="ben"\ndelta=-3\nreason="copied"\nwho="RH"\ndate="2026-11-30"\n',
    )
    call(old, new, "--never-lower")
    rows = rows_by_hand(class_of(row("ben", 1.0)), ByHand(load_overrides(place, ("ben",))))
    assert rows.rows[0].final == 6.0


def test_changes_by_hand_that_were_left_behind_are_told(tmp_path: Path) -> None:
    change = Change("1/2", "goal 2", "RH", "2026-11-30")
    changed = msgspec.structs.replace(row("anna", 6.0), change=change, final=6.5)
    old, new = write(tmp_path / "old", class_of(changed)), write(tmp_path / "new", OLD)
    found = call(old, new)
    assert "note: 1 changed by hand in OLD and not in NEW, as `anna`" in found.stderr
    assert "by hand +0.5 → 0" in found.stdout


def test_json_and_files(tmp_path: Path) -> None:
    old, new = write(tmp_path / "old", OLD), write(tmp_path / "new", repaired())
    found = call(Layout(old).results, Layout(new).results, "--format", "json")
    told = json.loads(found.stdout)
    assert told["schema"] == "vrts.diff/1"
    assert told["moves"][0]["id"] == "ben"
    assert call(Layout(old).results, Layout(new).results, "--never-lower").exit_code == 2


@pytest.mark.parametrize("damage", [b"", b"{}", b'{"schema": "vrts.class/9"}', b"\xff"])
def test_what_is_no_marking_is_told(tmp_path: Path, damage: bytes) -> None:
    old = write(tmp_path / "old", OLD)
    write_atomically(Layout(tmp_path / "new").results, damage)
    found = call(old, tmp_path / "new")
    assert found.exit_code == 1
    assert "error[V760 no-marking]: `" in found.stderr
    assert found.stderr.count("error[") == 1
    assert call(old, tmp_path / "nowhere").exit_code == 1


def test_kinds_tell_why_a_mark_is_gone() -> None:
    lost = row("anna", None)
    found = diff(OLD, class_of(lost))
    assert found.moves[0].new is None
    assert found.moves[0].reasons[0].startswith(f"graded → {Kind.RESOURCE.value}")
