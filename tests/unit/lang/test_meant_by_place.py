"""Words and names that are right elsewhere: the help says what belongs in their place."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.base.source import SourceFile
from vrts.lang.reading.detection import detect


def only(text: str) -> Diagnostic:
    """Return the one message about a file."""
    (found,) = said(compiled(text))
    return found


@pytest.mark.parametrize(
    ("step", "wanted"),
    [
        ("IF CLOSE THEN\nREADY\nEND", "HAND == 0"),
        ("WAIT CLOSEI", "HAND == 0"),
        ("IF NOT OPEN THEN\nREADY\nEND", "HAND > 0"),
        ("WAIT OPEN", "HAND > 0"),
    ],
)
def test_an_instruction_does_not_tell_how_the_hand_stands(step: str, wanted: str) -> None:
    found = only(f".PROGRAM m\n{step}\n.END\n")
    assert "moves the hand" in found.headline
    assert wanted in found.help[0]
    assert found.fix is None


def test_a_variable_named_like_an_instruction_stays_one() -> None:
    texts = [d.headline for d in compiled(".PROGRAM m\nclose = 2\nWAIT close\n.END\n").diagnostics]
    assert not any("moves the hand" in text for text in texts)


def test_a_jump_to_a_number_is_told_how_numbers_choose() -> None:
    body = 'PROMPT "job ", k\nGOTO k\n10 READY\nIF k == 3 GOTO 10'
    assert "`IF k == 10 GOTO 10`" in only(f".PROGRAM m\n{body}\n.END\n").help[0]
    other = only(".PROGRAM m\nGOTO bin\n10 READY\nIF SIG(1) GOTO 10\n.END\n")
    assert "MOVE bin" in other.help[0]


@pytest.mark.parametrize(
    ("step", "after"),
    [
        ("$OUT[1] = TRUE", "SIGNAL 1"),
        ("$DOUT[3] = FALSE", "SIGNAL -3"),
        ("$OUT[n+1] = OFF", "SIGNAL -(n+1)"),
    ],
)
def test_an_output_of_krl_is_a_signal(step: str, after: str) -> None:
    text = f".PROGRAM m\nn = 1\nTYPE n\n{step}\n.END\n"
    found = only(text)
    assert "KRL" in found.headline
    assert with_edits(text, edits_of([found])) == text.replace(step, after)


def test_an_array_of_strings_may_be_named_like_outputs() -> None:
    assert not said(compiled('.PROGRAM m\n$out[1] = "on"\nTYPE $out[1]\n.END\n'))


def test_default_in_a_case_is_no_command_for_the_monitor() -> None:
    text = ".PROGRAM m\nk = 2\nCASE k OF\nVALUE 1:\nREADY\nDEFAULT:\nOPENI\nEND\n.END\n"
    found = [d for d in said(compiled(text)) if d.is_error]
    assert len(found) == 1
    told = " ".join((found[0].headline, *found[0].notes))
    assert "monitor" not in told
    assert "all other values" in told
    assert "\nANY\n" in with_edits(text, edits_of(found))


def test_joint_angles_in_a_data_line_want_the_sign_of_a_precision_point() -> None:
    text = ".PROGRAM m\nMOVE #rst\n.END\n.LOCATIONS\nrst {}\n.END\n"
    found = only(text.format("0 -90 180 0 90 0"))
    assert "write `#rst` in line 5" in found.help[0]
    assert found.fix is None
    assert "did you mean `rst`" in only(text.format("400 -90 180 0 90 0")).help[0]


def test_the_name_of_a_location_is_not_given_a_number_below() -> None:
    found = only(
        ".PROGRAM m\nMOVE block\nblock = 1\n.END\n.LOCATIONS\nother 500 0 0 0 90 0\n.END\n"
    )
    assert found.primary is not None
    assert found.primary.span.line == 3
    assert "give the number another name" in found.help[0]


def test_a_declaration_is_told_to_be_needless() -> None:
    text = ".PROGRAM m\nAUTO REAL i\nFOR i = 1 TO 3\nTYPE i\nEND\n.END\n"
    _, note = detect(SourceFile("main.v2", text))
    assert note is not None
    assert any("leave the line with AUTO out" in line for line in note.help)


def test_a_call_with_too_much_is_written_as_it_stands() -> None:
    text = ".PROGRAM m\nCALL put(3, 40)\n.END\n.PROGRAM put(n)\nTYPE n\n.END\n"
    assert "write `CALL put(3)`" in only(text).help[0]
