"""What is said of repairs: of one change or two, in words that others share, with a range."""

from fractions import Fraction

from vrts.base.source import SourceFile, Span
from vrts.check.rules.hints import Hints
from vrts.repair.edit import Change, Does, both, changed, replacement
from vrts.repair.ranking import Repair
from vrts.repair.telling import cause, place, sentence, shows
from vrts.repair.trying.reach import Reach

SOURCE = SourceFile("p.v2", "APPRO a, 10\nMOVES b\nCLOSEI\n")


def number(line: int, start: int, old: str, new: str) -> Change:
    """Return a change of a number."""
    edits = (replacement(SOURCE, start, start + len(old), new),)
    return Change(Does.NUMBER, line, edits, 1, old, new)


def added(source: SourceFile, line: int, text: str) -> Change:
    """Return a change that adds a step before a line."""
    at = source.line_starts[line - 1]
    return Change(Does.ADD, line, (replacement(source, at, at, f"{text}\n"),), 1, "", text)


def repair(change: Change, cost: float = 1.0) -> Repair:
    """Return a repair by a change."""
    return Repair(change, cost, "", Fraction(10))


def test_two_changes_are_one_of_the_program_as_it_stands() -> None:
    first = added(SOURCE, 2, "BREAK")
    between = SourceFile("p.v2", changed(SOURCE.text, first.edits))
    at = between.text.index("CLOSEI")
    second = Change(
        Does.WORD, 4, (replacement(between, at, at + 6, "OPENI"),), 1, "CLOSEI", "OPENI"
    )
    whole = both(SOURCE, first, second)
    assert whole is not None
    assert changed(SOURCE.text, whole.edits) == changed(between.text, second.edits)
    assert all(edit.span.source is SOURCE for edit in whole.edits)
    assert [part.line for part in whole.each] == [2, 3], "lines of the file as it stands"
    assert whole.size == 2
    told = sentence([repair(whole)], Hints.EDIT)
    assert told == (
        "two changes away: 10 with line 2: `BREAK` is missing before it, "
        "and line 3: `OPENI` for `CLOSEI`"
    )
    assert sentence([repair(whole)], Hints.PLACE) == "look at lines 2 and 3"


def test_changes_of_what_another_wrote_are_not_two() -> None:
    first = added(SOURCE, 2, "BREAK")
    between = SourceFile("p.v2", changed(SOURCE.text, first.edits))
    at = between.text.index("BREAK")
    second = Change(Does.WORD, 2, (replacement(between, at, at + 5, "OPENI"),), 1, "BREAK", "OPENI")
    assert both(SOURCE, first, second) is None


def test_a_range_is_told_as_tried_and_only_where_a_number_may_be() -> None:
    found = [repair(number(1, 9, "10", "120"))]
    reach = Reach(60.0, 250.0, 9)
    also = "from 60 to 250 would do, tried at 9 values"
    away = "one change away: 10 with line 1: `120` for `10`"
    assert sentence(found, Hints.EDIT, reach) == f"{away}; {also}"
    look = "look at line 1: 10 is too small, 120 would do"
    assert sentence(found, Hints.NUMBER, reach) == f"{look}; {also}"
    assert sentence(found, Hints.DIRECTION, reach) == "look at line 1: 10 is too small"
    assert sentence(found, Hints.PLACE, reach) == "look at line 1"
    assert sentence(found, Hints.NOTHING, reach) is None


def test_what_is_certified_is_told_apart_from_what_is_tried() -> None:
    found = [repair(number(1, 9, "10", "120"))]
    told = sentence(found, Hints.EDIT, Reach(60.0, 130.0, 0, (60.0, 130.0)))
    assert told is not None
    assert told.endswith("; every whole number from 60 to 130 would do, certified")
    told = sentence(found, Hints.EDIT, Reach(60.0, 250.0, 9, (60.0, 130.0)))
    assert told is not None
    assert "every whole number from 60 to 130 would do, certified; from 60 to 250" in told
    assert told.endswith("tried at 9 values")


def test_a_name_without_a_value_is_looked_for_where_it_is_used() -> None:
    """It may be given one anywhere: by a step at the top, or by a row."""
    step = added(SOURCE, 1, "SET b = a")
    at = SOURCE.line_starts[2]
    row = Change(Does.ROW, 3, (replacement(SOURCE, at, at, "b 0 0\n"),), 7, "", "b 0 0")
    assert [place(change) for change in (step, row)] == ["look at line 2"] * 2
    again = SourceFile("p.v2", "SET b = c\nMOVES b\n")
    assert place(added(again, 2, "SET b = a")) == "look at line 2"
    assert place(added(SOURCE, 1, "SET b[2] = a")) == "look at line 1"


def test_where_nothing_mends_a_program_the_lines_are_told_at_which_points_go() -> None:
    assert shows((9, 11, 12), Hints.PLACE) == "what is lost shows at lines 9 and 11"
    assert shows((9,), Hints.EDIT) == "what is lost shows at line 9"
    assert shows((9,), Hints.NOTHING) is None
    assert shows((), Hints.EDIT) is None


def test_where_several_lines_are_as_likely_only_a_place_is_told() -> None:
    found = [repair(number(1, 9, "10", "120")), repair(added(SOURCE, 3, "BREAK"), 1.1)]
    assert sentence(found, Hints.EDIT) == "look at line 1"


def test_the_same_mistake_has_the_same_words_in_other_programs() -> None:
    assert cause(number(1, 9, "10", "120"), SOURCE) == "a number of `APPRO` is too small"
    assert cause(added(SOURCE, 3, "BREAK"), SOURCE) == "`BREAK` is missing"
    assert Span(SOURCE, 0, 5).text == "APPRO"
