"""Changes by hand: read strictly, made in order, added without touching what is there."""

from fractions import Fraction
from pathlib import Path

import pytest

from tests.unit.marking.appeals.support import class_of, row
from vrts.base.source import SourceFile
from vrts.marking.by_hand.override_text import add_overrides, load_overrides, override_text
from vrts.marking.by_hand.overrides import Override, change_of, read_overrides, with_overrides
from vrts.marking.row import Lateness
from vrts.pipeline.refused import Refused

KNOWN = ("anna", "ben")
WHOLE = """\
# by the board
[[change]]
student = "anna"
delta = 0.3
reason = "the camera had moved"
who = "R. Huber"
date = "2026-11-30"
"""


def read(text: str) -> tuple[list[str], object]:
    """Return what is said about a file, with the text it points at, and the changes."""
    found = read_overrides(SourceFile("overrides.toml", text), KNOWN)
    said = [
        f"{d.rule.code} {d.headline} @ {d.primary.span.text if d.primary else '-'}"
        for d in found.diagnostics
    ]
    return said, dict(found.changes)


def test_a_change_is_read_exactly() -> None:
    said, changes = read(WHOLE)
    anna = Override("anna", Fraction(3, 10), None, "the camera had moved", "R. Huber", "2026-11-30")
    assert said == []
    assert changes == {"anna": (anna,)}


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "delta = 0.3",
            "delta = 0.3\nmark = 8",
            "V770 a change has either `delta` or `mark`, not both @ mark",
        ),
        ("delta = 0.3\n", "", "V770 a change has either `delta` or `mark` @ [[change]]"),
        ("0.3", "11", "V605 `delta` must be at least -10 and at most 10 @ 11"),
        ("delta = 0.3", "mark = -1", "V605 `mark` must be at least 0 and at most 10 @ -1"),
        ('reason = "the camera had moved"\n', "", "V603 `[change 1]` needs `reason` @ [[change]]"),
        ("R. Huber", "  ", 'V770 `who` is empty @ "  "'),
        ("2026-11-30", "30.11.2026", 'V770 `30.11.2026` is no date @ "30.11.2026"'),
        (
            "delta = 0.3",
            'delta = 0.3\nsettles = ["tardy"]',
            'V770 `tardy` is no reason why a mark is unsafe @ ["tardy"]',
        ),
        ("delta", "dleta", "V602 unknown key `dleta` in `[change 1]` @ dleta"),
        ("[[change]]", "[[changes]]", "V602 unknown key `changes` in the file @ changes"),
    ],
)
def test_what_is_wrong_is_said_where_it_stands(old: str, new: str, said: str) -> None:
    assert old in WHOLE
    found, changes = read(WHOLE.replace(old, new))
    assert said in found
    assert changes == {}


def test_an_unknown_student_is_told_and_the_others_count() -> None:
    text = WHOLE + "\n" + WHOLE.replace("anna", "bne")
    found = read_overrides(SourceFile("overrides.toml", text), KNOWN)
    (only,) = found.diagnostics
    assert not found.wrong
    assert only.headline == "there is no student `bne` in this class"
    assert only.help == ("did you mean `ben`?",)
    assert "anna" in found.changes


def test_the_same_change_twice_is_refused() -> None:
    said, changes = read(WHOLE + "\n" + WHOLE)
    assert said == ["V770 the same change of `anna` is there twice @ [[change]]"]
    assert changes == {}


def test_changes_are_made_one_after_the_other_upon_the_mark_after_lateness() -> None:
    late = Lateness(3600, "1", "1 h late: 1 point less")
    rows = class_of(row("anna", 8.5, late), row("ben", None), row("cara", 3.0))
    text = (
        WHOLE.replace("delta = 0.3", "mark = 9")
        + WHOLE
        + WHOLE.replace("delta = 0.3", "mark = 4").replace("anna", "ben")
    )
    overrides = read_overrides(SourceFile("o.toml", text), ("anna", "ben", "cara"))
    assert not overrides.diagnostics
    anna, ben, cara = with_overrides(rows, overrides).rows
    assert anna.final == 9.3  # 8.5 - 1 = 7.5; to 9; 0.3 more
    assert anna.change is not None
    assert anna.change.delta == "9/5"
    assert anna.result.mark == 8.5
    assert ben.final == 4.0  # where no mark was computed
    assert (cara.final, cara.change) == (3.0, None)


def test_rows_lose_changes_that_are_not_in_the_file_any_more() -> None:
    changed = with_overrides(
        class_of(row("anna", 8.5)), read_overrides(SourceFile("o.toml", WHOLE), KNOWN)
    )
    assert changed.rows[0].final == 8.8
    again = with_overrides(changed, read_overrides(SourceFile("o.toml", ""), KNOWN))
    assert (again.rows[0].final, again.rows[0].change) == (8.5, None)


def test_no_change_is_no_change() -> None:
    assert change_of(Fraction(5), ()) is None


def test_adding_keeps_every_byte_that_is_there(tmp_path: Path) -> None:
    path = tmp_path / "overrides.toml"
    before = b"\xef\xbb\xbf" + WHOLE.replace("\n", "\r\n").encode().rstrip()
    path.write_bytes(before)
    nasty = 'he said "no" \\ \x7f\ttwice\n[[change]]'
    added = Override("ben", Fraction(-1, 10), None, nasty, "Ü\u2028", "2026-12-01")
    found = add_overrides(path, [added], KNOWN)
    assert path.read_bytes().startswith(before)
    assert found.changes["ben"] == (added._replace(who="Ü"),)  # spaces around are not kept
    assert load_overrides(path, KNOWN).changes == found.changes


def test_a_new_file_explains_itself(tmp_path: Path) -> None:
    path = tmp_path / "staff" / "overrides.toml"
    added = Override("anna", None, Fraction(7), "regraded", "R. Huber", "2026-12-01")
    add_overrides(path, [added], KNOWN)
    assert path.read_text("utf-8").startswith("# Changes of marks by hand.")
    assert override_text(added) in path.read_text("utf-8")


def test_a_wrong_file_is_left_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "overrides.toml"
    path.write_text(WHOLE)
    same = Override("anna", Fraction(3, 10), None, "the camera had moved", "R. Huber", "2026-11-30")
    with pytest.raises(Refused):
        add_overrides(path, [same], KNOWN)
    assert path.read_text() == WHOLE
    path.write_text("[[change]\n")
    with pytest.raises(Refused):
        add_overrides(path, [same], KNOWN)
    assert path.read_text() == "[[change]\n"
