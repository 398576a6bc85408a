"""What a beginner reads first: whole messages of the commonest mistakes."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source


def problems(body: str, tail: str = "") -> tuple[Diagnostic, ...]:
    text = f".PROGRAM main\n{body}\n.END\n{tail}"
    return compile_source(SourceFile("test.v2", text)).diagnostics


def only(body: str, tail: str = "") -> Diagnostic:
    (found,) = problems(body, tail)
    return found


PART = ".LOCATIONS\npart 450 -120 -50 90 90 0\n.END\n"


def test_unknown_instruction_is_corrected() -> None:
    found = only("MOVEE part", PART)
    assert found.headline == "`MOVEE` is not an instruction"
    assert found.help == ("did you mean `MOVE`?",)
    assert found.notes == ("VAL-II says *Unknown instruction*",)
    assert found.primary is not None
    assert found.primary.span.text == "MOVEE"
    assert found.fix is not None
    assert found.fix.replacement == "MOVE"


def test_missing_comma_points_between_the_operands() -> None:
    found = only("APPRO part 50", PART)
    assert found.headline == "a comma is missing before `50`"
    assert found.primary is not None
    assert (found.primary.span.text, found.primary.text) == (" ", "a comma belongs here")
    assert found.help == ("write `APPRO location, distance`",)


def test_missing_end_points_at_the_opener_and_where_it_was_noticed() -> None:
    found = only("FOR i = 1 TO 3\nREADY")
    assert found.primary is not None
    assert found.primary.span.text == "FOR i = 1 TO 3"
    (noticed,) = found.secondary
    assert noticed.span.text == ".END"
    assert noticed.text == "still open where the program ends"


def test_single_equals_has_a_fix() -> None:
    found = only("n = 1\nIF n = 5 THEN\nEND")
    assert found.help == ("write `==`",)
    assert found.fix is not None
    assert found.fix.replacement == "=="


def test_curly_quotes_are_one_problem_however_many_there_are() -> None:
    found = only("TYPE “one”\nTYPE “two”\nTYPE “three”")
    assert found.headline == "`“` is a curly quote"
    assert found.notes[-1] == "2 more places, in lines 3, 4"
    assert found.help == ('replace every curly quote by the straight `"` of the keyboard',)
    assert found.data["places"] == 3


def test_undefined_location_carries_its_name() -> None:
    found = only("MOVE prat\nMOVES prat", PART)
    assert not found.is_error
    assert found.data["name"] == "prat"
    assert found.help == ("did you mean `part`?",)
    assert found.notes[0] == "used 1 more time"


def test_name_of_two_kinds_shows_both_places() -> None:
    found = only("part = 5\nMOVE part")
    assert found.headline == "`part` is used both as a number and as a location"
    assert found.primary is not None
    assert (found.primary.span.line, found.primary.text) == (3, "MOVE goes to a location")
    assert [(s.span.line, s.text) for s in found.secondary] == [(2, "a number here")]


def test_endless_loop_through_a_call() -> None:
    helper = ".PROGRAM step.on\nm = 2\nTYPE m\n.END\n"
    found = only("n = 1\nWHILE n <= 2 DO\nCALL step.on\nEND", helper)
    assert found.rule.code == "V222"
    assert found.help == ("change `n` in the loop, as in `n = n+1`",)


@pytest.mark.parametrize(
    "body",
    [
        "n = 1\nWHILE n <= 2 DO\nCALL step.on\nEND",  # the call changes n
        "n = 1\nWHILE n <= 2 DO\nCALL other(n)\nEND",  # by reference
        "WHILE SIG(1001) DO\nREADY\nEND",
        "n = 1\nWHILE n <= 2 DO\nIF SIG(1) GOTO 10\nEND\n10 READY",
        "WHILE TRUE DO\nREADY\nEND",
    ],
)
def test_loops_that_may_end_are_not_reported(body: str) -> None:
    helpers = ".PROGRAM step.on\nn = 2\nTYPE n\n.END\n.PROGRAM other(k)\nk = 2\n.END\n"
    assert problems(body, helpers) == ()


@pytest.mark.parametrize(
    "body",
    [
        "OPEN\nAPPRO part, 50\nMOVES part\nCLOSEI\nDEPARTS 50",
        "MOVES part\nCLOSE\nDELAY 0.5\nDEPARTS 50",  # acts with the delay, at rest
    ],
)
def test_hands_that_act_in_time_are_not_reported(body: str) -> None:
    assert problems(body, PART) == ()


def test_negative_height_is_seen_through_a_variable() -> None:
    found = only("h = -50\nAPPRO part, h", PART)
    assert found.headline == "APPRO by -50 mm goes beyond the location"
    assert found.data["distance_mm"] == -50.0


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("IF n == 1 THEN READY\nREADY", "V125"),  # the missing END is not said as well
        ("n = 1\nIF n == 1 THEN\nREADY\nENDIF", "V122"),
        ("FOR i = 1, 3\nTYPE i\nEND", "V130"),
        ("APPRO 50, part", "V202"),  # nor that part is a number here and a location there
        ("MOVE part-grip", "V202"),
        ("VALUE 5", "V164"),
    ],
)
def test_one_cause_is_one_diagnostic(body: str, code: str) -> None:
    assert only(body).rule.code == code


def test_every_label_lies_in_one_line() -> None:
    for found in problems('MOVE\nTYPE "a\nx = (1\nEND\nGOTO 5\nAPPRO part', ".END\n"):
        assert found.primary is not None
        assert "\n" not in found.primary.span.text


@pytest.mark.parametrize(
    ("body", "headline", "help_"),
    [
        ("OPENI()", "OPENI has no parentheses", "write `OPENI`"),
        ("// note", "`//` begins no comment", "begin comments with `;`"),
        ("WAIT SIG 1001", "SIG without parentheses", "write `SIG(1001)`"),
        ("APPRO 50, part", "the location comes first in APPRO", "write `APPRO part, 50`"),
        ("MOVESpart", "`MOVESpart` is not an instruction", "write a blank: `MOVES part`"),
        ("SPEED 50%", "SPEED takes percent, without a sign", "take `%` out: write `SPEED 50`"),
        ("n += 1", "`+=` is not an operator of VAL-II", "write `n = n+1`"),
        ("ENDIF", "ENDIF is not a VAL-II instruction", "write `END`"),
    ],
)
def test_habits_of_other_languages_are_named(body: str, headline: str, help_: str) -> None:
    found = problems(body)[0]
    assert found.headline == headline
    assert found.help == (help_,)
