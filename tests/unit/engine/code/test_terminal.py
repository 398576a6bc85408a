"""TYPE, PROMPT and MESSAGES."""

import pytest

from tests.support_engine import TICK, driven, lines, main, of_kind, runs, words
from tests.support_programs import codes
from vrts.engine.memory.events import Answered, Printed, Prompted
from vrts.engine.run import Run
from vrts.ir.commands import Answer
from vrts.scene.model import Scenario


def asked(body: str, *answers: str) -> Run:
    return runs(body, scenario=Scenario(answers=answers))


READ = [
    ("PROMPT x\nTYPE x", "5", "5"),
    ("PROMPT x, y, z\nTYPE x, y, z", "1 2 3", "1 2 3"),
    ("PROMPT x, y, z\nTYPE x, y, z", "1,2,3", "1 2 3"),
    ("PROMPT x, y, z\nTYPE x, y, z", "4", "4 0 0"),
    ("PROMPT x\nTYPE x", "7 8 9", "7"),
    ("PROMPT x, y\nTYPE x, y", "", "0 0"),
    ("PROMPT x, y\nTYPE x, y", " -1.5 , 2E2 ", "-1.5 200"),
    ("PROMPT x\nTYPE x", "^HFF", "255"),
    ("PROMPT $s\nTYPE $s", "two words", "two words"),
    ("PROMPT $s\nTYPE LEN($s)", "", "0"),
    ("PROMPT m[3]\nTYPE m[3]", "6", "6"),
]


@pytest.mark.parametrize(("body", "answer", "text"), READ)
def test_prompt_reads_a_line(body: str, answer: str, text: str) -> None:
    run = asked(body, answer)
    assert lines(run)[-1][1] == text
    (answered,) = of_kind(run, Answered)
    assert answered.text == answer


@pytest.mark.parametrize("answer", ["two", "1 x", "--1", "1E99"])
def test_what_is_no_number_stops_the_program(answer: str) -> None:
    assert words(asked("PROMPT x, y", answer)) == ["Invalid number format"]


def test_the_question_stands_on_the_line_of_the_answer() -> None:
    run = asked('PROMPT "how many? ", n\nTYPE "good"', "3")
    assert run.output == "how many? 3\r\ngood\r\n"


def test_prompt_without_variable_waits_for_return() -> None:
    run = asked('PROMPT "ready?"\nTYPE "go"', "")
    assert [text for _, text in lines(run)] == ["ready?", "", "go"]


def test_answers_are_taken_in_order_and_missing_ones_are_a_finding() -> None:
    run = asked("PROMPT x\nPROMPT y\nTYPE x-y\nPROMPT z", "9", "4")
    assert "5" in run.output
    assert codes(run) == ["V504"]
    assert "2 answers" in run.findings[0].notes[0]


def test_the_arm_goes_on_while_the_program_waits_for_an_answer() -> None:
    run = driven(main("MOVE a\nPROMPT x\nMOVE b\nTYPE x"), 9.0, (3.0, Answer("4")))
    (prompted,) = of_kind(run, Prompted)
    assert prompted.time_s == 0.0
    assert not run.motions[0].blended
    assert run.motions[1].start_s == pytest.approx(3.0, abs=3 * TICK)


def test_an_answer_may_be_given_before_it_is_asked_for() -> None:
    run = driven(main("DELAY 2\nBREAK\nPROMPT x\nTYPE x"), 5.0, (1.0, Answer("4")))
    assert lines(run)[-1][1] == "4"
    assert lines(run)[-1][0] < 2.5


def test_messages_off_hides_what_programs_type() -> None:
    run = runs('TYPE "one"\nDISABLE MESSAGES\nTYPE "two"\nENABLE MESSAGES\nTYPE "three"')
    assert run.output.split() == ["one", "three"]


def test_without_messages_questions_are_still_asked() -> None:
    run = asked('DISABLE MESSAGES\nPROMPT "n? ", n\nTYPE n', "3")
    assert run.output == "n? 3\r\n"


def test_every_line_names_the_step_that_wrote_it() -> None:
    run = runs('TYPE "one"\nx = 1\nTYPE "two", /S\nTYPE " and more"')
    causes = [event.cause for event in of_kind(run, Printed)]
    assert [cause.step for cause in causes if cause is not None] == [1, 3, 4]
    assert run.output == "one\r\ntwo and more\r\n"
