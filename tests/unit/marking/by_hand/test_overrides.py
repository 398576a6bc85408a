"""Changes by hand: read strictly, made in order, added without touching what is there."""

from fractions import Fraction
from pathlib import Path

import pytest

from tests.unit.marking.appeals.support import class_of, row
from vrts.base.source import SourceFile
from vrts.marking.by_hand.by_hand import ByHand, rows_by_hand
from vrts.marking.by_hand.override_text import add_overrides, load_overrides, override_text
from vrts.marking.by_hand.overrides import (
    Override,
    change_of,
    lapses,
    program_of,
    read_overrides,
)
from vrts.marking.row import Lateness, Row
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
        (
            "delta = 0.3",
            'delta = 0.3\nprogram = "mine"',
            'V770 `program` is no sha256 @ "mine"',
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
    anna, ben, cara = rows_by_hand(rows, ByHand(overrides)).rows
    assert anna.final == 9.3  # 8.5 - 1 = 7.5; to 9; 0.3 more
    assert anna.change is not None
    assert anna.change.delta == "9/5"
    assert anna.result.mark == 8.5
    assert ben.final == 4.0  # where no mark was computed
    assert (cara.final, cara.change) == (3.0, None)


def test_rows_lose_changes_that_are_not_in_the_file_any_more() -> None:
    changed = rows_by_hand(
        class_of(row("anna", 8.5)), ByHand(read_overrides(SourceFile("o.toml", WHOLE), KNOWN))
    )
    assert changed.rows[0].final == 8.8
    again = rows_by_hand(changed, ByHand(read_overrides(SourceFile("o.toml", ""), KNOWN)))
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


# what changes settle

IN_DOUBT = row("anna", 8.0, lowest=6.0, review=())
MINE = program_of(IN_DOUBT.result)


def decided(
    whole: Row, *said: str, settles: str = 'settles = ["undetermined"]'
) -> tuple[Row, list[str]]:
    """Return a row after changes that say something, and what is said of them."""
    text = "\n".join(
        WHOLE.replace("delta = 0.3", f"{one}\n{settles}").replace("camera", f"camera {k}")
        for k, one in enumerate(said)
    )
    overrides = read_overrides(SourceFile("o.toml", text), KNOWN)
    assert not overrides.diagnostics
    (changed,) = rows_by_hand(class_of(whole), ByHand(overrides)).rows
    return changed, [note for d in lapses([changed], overrides) for note in d.notes]


def test_a_decision_is_about_one_program_and_lapses_with_another() -> None:
    assert [d.reason.value for d in IN_DOUBT.unsafe] == ["undetermined"]
    bound = f'delta = 0\nprogram = "{MINE}"'
    changed, said = decided(IN_DOUBT, bound)
    assert (changed.unsafe, said) == ((), [])
    foreign = bound.replace(MINE, "0" * 64)
    changed, said = decided(IN_DOUBT, foreign)
    assert changed.unsafe == IN_DOUBT.unsafe
    assert said == ["it was decided about another program"]
    changed, said = decided(IN_DOUBT, "delta = 0")
    assert changed.unsafe == IN_DOUBT.unsafe
    assert said == [f'it does not say about which program: write `program = "{MINE}"`']
    assert decided(IN_DOUBT, foreign, bound)[1] == [], "it was decided again"
    assert decided(row("anna", 8.0), foreign)[1] == [], "there is nothing to settle"


def test_a_mark_settles_that_of_its_program_and_counts_with_any() -> None:
    for text in ("mark = 7", f'mark = 7\nprogram = "{MINE}"'):
        changed, said = decided(IN_DOUBT, text, settles="")
        assert (changed.unsafe, changed.final, said) == ((), 7.0, [])
    foreign = 'mark = 7\nprogram = "none"'
    changed, said = decided(IN_DOUBT, foreign, settles="")
    assert (changed.unsafe, changed.final) == (IN_DOUBT.unsafe, 7.0)
    assert said == ["it was decided about another program"]


def test_where_there_is_no_mark_only_a_mark_decides() -> None:
    lost = row("anna", None, program=None)
    for settles in ('settles = ["resource"]', 'settles = ["all"]'):
        changed, said = decided(lost, 'delta = 0\nprogram = "none"', settles=settles)
        assert [d.reason.value for d in changed.unsafe] == ["resource"]
        assert said == ["where there is no mark only `mark` decides"]
    changed, said = decided(lost, 'mark = 0\nprogram = "none"', settles="")
    assert (changed.unsafe, changed.final, said) == ((), 0.0, [])
