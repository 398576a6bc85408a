"""Lines while they are typed, and text that fits a screen."""

from hypothesis import given
from hypothesis import strategies as st

from vrts.debug.terminal.fitting import cut, fitted, typed, wrapped
from vrts.debug.terminal.line import LONGEST, Line
from vrts.report.plain import width

TEXTS = st.text(st.sampled_from("ab xyz. ä漢\u0301"), max_size=60)
MOVES = ("left", "right", "home", "end", "c-a", "c-e", "c-k", "c-u", "c-w")
KEYS = (*MOVES, "backspace", "delete", "up", "down", "tab", "a", " ", "漢")


def typed_so(line: Line, *keys: str) -> str:
    for key in keys:
        line.press(key)
    return line.text


def test_keys_edit() -> None:
    assert typed_so(Line("print n"), "c-a", "c-k") == ""
    assert typed_so(Line("print n"), "c-w", "m") == "print m"
    assert typed_so(Line("print n"), "left", "left", "c-u") == " n"
    assert typed_so(Line("print n"), "home", "delete", "P", "end", "backspace") == "Print "


def test_lines_typed_before_come_back_and_the_one_begun_is_kept() -> None:
    line = Line("be", ["first", "second"])
    assert typed_so(line, "up") == "second"
    assert typed_so(line, "up", "up") == "first"
    assert typed_so(line, "down", "down") == "be"
    assert typed_so(line, "down") == "be"


def test_words_are_completed_as_far_as_it_is_sure() -> None:
    line = Line("print co", words=lambda: ["count", "counter", "other"])
    assert typed_so(line, "tab") == "print count"
    assert line.offered == ["count", "counter"]
    assert typed_so(line, "e", "tab") == "print counter"
    assert line.offered == []


@given(TEXTS, st.lists(st.sampled_from(KEYS), max_size=30), st.integers(4, 30))
def test_a_line_is_shown_with_its_cursor_in_any_room(text: str, keys: list[str], room: int) -> None:
    line = Line(text, ["before", text], lambda: ["abc", "abd", text])
    typed_so(line, *keys)
    assert 0 <= line.at <= len(line.text) <= LONGEST
    row = typed(line.text, line.at, room)
    assert sum(width(part) for _, part in row) <= room
    assert [part for style, part in row if style == "cursor"] == [line.text[line.at :][:1] or " "]


@given(TEXTS, st.integers(1, 40))
def test_what_is_cut_has_a_mark_and_what_is_wrapped_is_whole(text: str, room: int) -> None:
    short = cut(text, room)
    assert width(short) <= room
    assert short == text or short.endswith("…")
    rows = wrapped([text], max(room, 6))
    assert all(width(row) <= max(room, 6) for row in rows)
    assert "".join("".join(rows).split()) == "".join(text.split())
    assert sum(width(part) for _, part in fitted([("", text), ("x", text)], room)) == room
