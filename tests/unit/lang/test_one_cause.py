"""One cause, one message: consequences and doubts are not told beside it."""

import pytest

from tests.mistakes import said
from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\n.END\n"


def found(text: str) -> list[Diagnostic]:
    """Return all that is told of a file whose language nobody names."""
    return list(compile_source(SourceFile("a.v2", text), Options()).diagnostics)


def codes(text: str) -> list[str]:
    return [d.rule.code for d in found(text)]


@pytest.mark.parametrize(
    "text",
    [
        ".PROGRAM select()\n TYPE 1\n.END\n",
        ".PROGRAM id()\n TYPE 1\n.END\n",
        ".PROGRAM main()\n CALL select(1)\n.END\n.PROGRAM select(n)\n TYPE n\n.END\n",
    ],
)
def test_the_name_of_a_program_tells_nothing_of_its_language(text: str) -> None:
    assert codes(text) == []


@pytest.mark.parametrize(
    ("step", "code"), [("ACCEL 50", "V122"), ("NEXT i", "V122"), ("GOTO k", "V136")]
)
def test_a_word_of_another_language_is_told_once(step: str, code: str) -> None:
    """No doubt about the language beside the error."""
    text = f".PROGRAM main()\n k = 10\n FOR i = 1 TO k\n  {step}\n TYPE i\n.END\n"
    told = codes(text)
    assert code in told
    assert "V157" not in told


def test_labels_with_a_name_still_speak_for_another_language() -> None:
    """A name that has no value is no variable."""
    text = ".PROGRAM main()\n GOTO again\n GOTO done\n.END\n"
    assert "V157" in codes(text)


def test_a_header_of_another_language_is_told_once() -> None:
    assert codes(f"def main():\n MOVE pick\n.END\n{DATA}") == ["V144"]


def test_what_a_program_that_is_not_understood_sets_is_open() -> None:
    """`y` may get its value in the line that could not be read."""
    text = (
        ".PROGRAM main\n CALL twice(5, y)\n TYPE y\n.END\n.PROGRAM twice(x, r)\n RETURN 2*x\n.END\n"
    )
    assert codes(text) == ["V156"]


def test_signal_and_program_of_reacti_swapped() -> None:
    text = (
        f".PROGRAM main\n REACTI stopper, 1003\n MOVE pick\n.END\n"
        f".PROGRAM stopper\n READY\n.END\n{DATA}"
    )
    (told,) = found(text)
    assert told.help == ("write `REACTI 1003, stopper`",)
    assert told.fix is not None
    assert told.fix.sure
    assert found(with_edits(text, edits_of([told]))) == []


def test_a_process_control_program_waits_by_a_timer() -> None:
    text = ".PROGRAM main\n PCEXECUTE lamp\n.END\n.PROGRAM lamp\n SIGNAL 4\n DELAY 1.5\n.END\n"
    (told,) = found(text)
    assert "`TIMER 2 = 0`, then `WAIT TIMER(2) > 1.5`" in told.help[0]


def test_separators_that_are_thrown_away_are_no_unused_string() -> None:
    text = (
        '.PROGRAM main\n $l = "1,2"\n $a = $DECODE($l, ",", 0)\n $b = $DECODE($l, ",", 1)\n'
        " TYPE $a, $l\n.END\n"
    )
    assert codes(text) == []


def test_locations_of_a_file_without_data_are_told_together() -> None:
    """They are in the scene, or in the controller."""
    text = ".PROGRAM main\n MOVE a\n MOVE b\n MOVE a\n MOVE c\n.END\n"
    (told,) = found(text)
    assert told.rule.code == "V204"
    assert told.headline.startswith("the locations `a`, `b` and `c` are never given")
    assert told.data["names"] == ("a", "b", "c")


def test_locations_missing_from_the_data_of_a_file_are_told_apart() -> None:
    """Each of them may be a slip."""
    text = f".PROGRAM main\n MOVE pick\n MOVE over\n MOVE home\n.END\n{DATA}"
    assert [d.headline.split("`")[1] for d in said(compile_source(SourceFile("a.v2", text)))] == [
        "over",
        "home",
    ]


def test_many_locations_are_counted() -> None:
    moves = "".join(f" MOVE p{i}\n" for i in range(12))
    (told,) = found(f".PROGRAM main\n{moves}.END\n")
    assert "`p7` and 4 more" in told.headline


def test_any_before_other_groups_is_told_once_and_at_itself() -> None:
    """One group is in the wrong place, however many stand behind it."""
    groups = "".join(f"  VALUE {n}:\n   TYPE {n}\n" for n in (1, 2, 3))
    (told,) = found(f".PROGRAM main(n)\n CASE n OF\n  ANY\n   READY\n{groups} END\n.END\n")
    assert told.primary is not None
    assert told.primary.span.line == 3
    assert "below the last VALUE" in told.help[0]


@pytest.mark.parametrize("word", ["ELSE", "ANY"])
def test_a_second_last_group_is_told_at_the_second(word: str) -> None:
    opener = "IF n THEN" if word == "ELSE" else "CASE n OF\n VALUE 1:"
    (told,) = found(
        f".PROGRAM main(n)\n {opener}\n READY\n {word}\n READY\n {word}\n READY\n END\n.END\n"
    )
    assert told.headline == f"a second {word}"
    assert f"has one {word}" in told.help[0]
