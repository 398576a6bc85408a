"""Diagnostics on a terminal: the layout of rustc, whatever the source holds."""

import re

import pytest

from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, error, warning
from vrts.base.source import SourceFile, Span
from vrts.base.units import DEG
from vrts.report.ordering import in_order
from vrts.report.screen.text import diagnostic_text

SPEED = Rule("V302", "joint-speed")
SYNTAX = Rule("V101", "syntax")

PROGRAM = SourceFile(
    "examples/03-via/pick.v2",
    ".PROGRAM main()\n  SPEED 80 ALWAYS\n  MOVES part:grip\n.END\n",
)


def at(source: SourceFile, text: str, nth: int = 0) -> Span:
    """Return the span of the nth occurrence of a text."""
    start = -1
    for _ in range(nth + 1):
        start = source.text.index(text, start + 1)
    return Span(source, start, start + len(text))


def plain(d: Diagnostic) -> str:
    return diagnostic_text(d, color=False)


def test_the_example_of_the_style_guide() -> None:
    d = error(
        SPEED,
        "joint 5 exceeds its speed limit on this move",
        Label(at(PROGRAM, "part:grip"), "needs 412 deg/s; the limit is 240 deg/s"),
        secondary=(Label(at(PROGRAM, "SPEED 80 ALWAYS"), "speed set here"),),
        help=("lower SPEED to 46 or less, or use MOVE instead of MOVES",),
    )
    assert plain(d) == (
        "error[V302 joint-speed]: joint 5 exceeds its speed limit on this move\n"
        " --> examples/03-via/pick.v2:3:9\n"
        "  |\n"
        "3 |   MOVES part:grip\n"
        "  |         ^^^^^^^^^ needs 412 deg/s; the limit is 240 deg/s\n"
        "  |\n"
        "2 |   SPEED 80 ALWAYS\n"
        "  |   --------------- speed set here\n"
        "help: lower SPEED to 46 or less, or use MOVE instead of MOVES"
    )


def test_labels_on_one_line_hang_below_it_rightmost_beside_it() -> None:
    d = error(
        SYNTAX,
        "three things on one line",
        Label(at(PROGRAM, ":"), "the colon"),
        secondary=(Label(at(PROGRAM, "part"), "first"), Label(at(PROGRAM, "grip"), "last")),
    )
    assert plain(d).split("\n")[3:] == [
        "3 |   MOVES part:grip",
        "  |         ----^---- last",
        "  |         |   |",
        "  |         |   the colon",
        "  |         first",
    ]


def test_moment_notes_and_help_follow_the_excerpt() -> None:
    d = error(
        SPEED,
        "too fast",
        Label(at(PROGRAM, "part")),
        notes=("first\nsecond line",),
        help=("slow down",),
        moment=Moment(12.44, (*(x * DEG for x in (0, -90, 90, 0, 12.345, 0)), 0.08), ("robot",)),
    )
    assert plain(d).split("\n")[4:] == [
        "  |         ^^^^",
        "  = at 12.4 s: robot; joints 0 -90 90 0 12.35 0 deg",
        "note: first",
        "      second line",
        "help: slow down",
    ]


def test_without_a_place_only_the_words_are_shown() -> None:
    assert plain(warning(SYNTAX, "no program in this file")) == (
        "warning[V101 syntax]: no program in this file"
    )


def test_tabs_wide_and_combining_characters_keep_the_marks_below_their_text() -> None:
    source = SourceFile("a.v2", '\t"語e\u0301" x = bad\n')
    lines = plain(error(SYNTAX, "bad", Label(at(source, "bad"), "here"))).split("\n")
    assert lines[3] == '1 |     "語e\u0301" x = bad'
    # the tab takes 4 columns, the ideograph 2, the combining accent none
    assert lines[4] == "  |               ^^^ here"


@pytest.mark.parametrize("hostile", ["\x1b[2J", "\u202e", "\x9b31m", "\x07", "\u2066", "\x7f"])
@pytest.mark.parametrize("color", [True, False])
def test_no_control_or_direction_character_reaches_the_terminal(hostile: str, color: bool) -> None:
    source = SourceFile(f"na{hostile}me.v2", f"x = {hostile}1 ; {hostile}\n")
    d = error(
        SYNTAX,
        f"`{hostile}` is bad",
        Label(at(source, "1"), f"label {hostile}"),
        notes=(hostile,),
        help=(hostile,),
        moment=Moment(1.0, (), (hostile,)),
    )
    text = diagnostic_text(d, color=color)
    ours = re.sub(r"\x1b\[[0-9;]*m", "", text) if color else text
    assert not [c for c in ours if c != "\n" and not c.isprintable()]
    assert hostile not in ours


def test_color_changes_nothing_but_color() -> None:
    d = error(SYNTAX, "bad", Label(at(PROGRAM, "part"), "here"), notes=("a note",))
    colored = diagnostic_text(d, color=True)
    assert colored != plain(d)
    assert re.sub(r"\x1b\[[0-9;]*m", "", colored) == plain(d)


def test_a_span_of_several_lines_shows_its_first_and_last() -> None:
    source = SourceFile("a.v2", "".join(f"  line{n}\n" for n in range(1, 12)))
    span = Span(source, source.text.index("line2"), source.text.index("line10") + 6)
    lines = plain(error(SYNTAX, "never closed", Label(span, "opened here"))).split("\n")
    assert lines[1:] == [
        "  --> a.v2:2:3",
        "   |",
        " 2 |   line2",
        "   |   ^^^^^",
        "...",
        "10 |   line10",
        "   |   ^^^^^^ opened here",
    ]


def test_a_very_long_line_is_cut_around_the_mark() -> None:
    source = SourceFile("a.v2", "x" * 5000 + "BAD" + "y" * 5000)
    lines = plain(error(SYNTAX, "bad", Label(at(source, "BAD"), "here"))).split("\n")
    assert max(map(len, lines)) < 160
    marks = lines[4].index("^")
    assert lines[3][marks : marks + 3] == "BAD"
    assert lines[4].rstrip().endswith("^^^ here")


def test_the_end_of_a_file_can_be_marked() -> None:
    source = SourceFile("a.v2", ".PROGRAM a()\n")
    end = len(source.text)
    lines = plain(error(SYNTAX, "no .END", Label(Span(source, end, end), "expected here")))
    assert lines.split("\n")[1:] == [" --> a.v2:2:1", "  |", "2 |", "  | ^ expected here"]


def test_a_label_in_another_file_names_it() -> None:
    scene = SourceFile("scene.toml", "[objects.can1]\n")
    d = error(
        SYNTAX,
        "two names",
        Label(at(PROGRAM, "part")),
        secondary=(Label(at(scene, "can1"), "the other"),),
    )
    assert " ::: scene.toml:1:10" in plain(d).split("\n")


def test_errors_come_before_warnings_and_nothing_twice() -> None:
    first, second = warning(SYNTAX, "a"), error(SYNTAX, "b")
    assert in_order((first, second, first)) == [second, first]
