"""What is typed where no environment says it: all that a program can tell apart, or nothing."""

import pytest

from tests.unit.prove.explore.proofs import module_of, only, proven
from vrts.check.verdict import Answer
from vrts.ir import instructions as ir
from vrts.prove.explore.bounded import Within, usage

ASKS = 'PROMPT "how many? ", n\n'
REFUSES = "IF (n < 1) OR (n > 3) THEN\nHALT\nEND\n"
TURNS = "DRIVE 1, n, 50\n"
OTHER = ".END\n.PROGRAM other()\n"


def test_a_number_that_is_only_compared_is_told_apart_by_the_numbers_beside_it() -> None:
    proof = proven(ASKS + "IF n == 3 THEN\nx = 1/0\nEND\n")
    assert only(proof).scenario.answers == ("3",)
    (told,) = (one for one in proof.covered.quantified if "PROMPT" in one)
    assert told.endswith("every number, told apart by 3")
    assert not proof.covered.sampled
    assert "where PROMPT asks for numbers, numbers are typed" in proof.covered.assumed


def test_nothing_is_missed_between_two_numbers_or_beyond_them() -> None:
    for asked, answer in (("(n > 1) AND (n < 1.5)", "1.25"), ("n > 7", "8"), ("n < -2", "-3")):
        found = only(proven(ASKS + f"IF {asked} THEN\nx = 1/0\nEND\n"))
        assert found.scenario.answers == (answer,)


def test_a_number_that_the_program_bounds_is_tried_between_its_bounds() -> None:
    proof = proven(ASKS + REFUSES + TURNS)
    assert proof.answer is Answer.HOLDS
    (sampled,) = proof.covered.sampled
    assert sampled.startswith("answers to PROMPT at step 1 of `main`, any number: 0, 1, ")
    assert sampled.endswith(" 3, 4 only")
    found = only(proven(ASKS + REFUSES + "x = 1/(n-2.5)\n"))
    assert found.scenario.answers == ("2.5",)


def test_text_is_told_apart_by_the_texts_of_the_program() -> None:
    asks = 'PROMPT "go? ", $a\n'
    found = only(proven(asks + 'IF $a == "y" THEN\nx = 1/0\nEND\n'))
    assert found.scenario.answers == ("y",)
    assert only(proven(asks + 'IF $a <> "y" THEN\nx = 1/0\nEND\n')).scenario.answers == ("x",)
    assert proven(asks + "x = VAL($a)\n" + "DRIVE 1, x, 50\n").answer is Answer.UNDETERMINED


def test_what_is_typed_and_never_asked_for_decides_nothing() -> None:
    for asks in ('PROMPT "who? ", $a\n', 'PROMPT "how many? ", n\n'):
        proof = proven(asks + 'TYPE "thanks"\n')
        assert proof.answer is Answer.HOLDS
        assert any(one.endswith(", as nothing depends on it") for one in proof.covered.quantified)


BOUNDED = {
    "a loop that asks until it is right": (
        "DO\n" + ASKS + "UNTIL (n >= 0) AND (n <= 9)\n" + TURNS,
        Within(0.0, 9.0),
    ),
    "two conditions": ("IF n < 1 GOTO 9\nIF NOT (n <= 2) GOTO 9\n" + TURNS + "9 HALT\n", (1, 2)),
    "the number on the left": ("IF (5 > n) AND (-4 <= n) THEN\n" + TURNS + "END\n", (-4, 5)),
    "a case": ("CASE n OF\nVALUE 1, 4:\n" + TURNS + "VALUE 2:\nx = n\nEND\n", (1, 4)),
    "printed before": ('TYPE "n is", n\n' + REFUSES + TURNS, (1, 3)),
    "passed on within bounds": (REFUSES + "CALL other(n)\n", (1, 3)),
}
OPEN = {
    "one bound": "IF n > 3 THEN\nHALT\nEND\n" + TURNS,
    "a bound on one way only": "IF SIG(1001) THEN\n" + REFUSES + "END\n" + TURNS,
    "either bound": "IF (n >= 1) OR (n <= 3) THEN\n" + TURNS + "END\n",
    "asked again behind the bound": REFUSES + ASKS + TURNS,
    "used before": "x = n*2\n" + REFUSES + TURNS,
    "a bound that is no number": "IF (n < low) OR (n > 3) THEN\nHALT\nEND\n" + TURNS,
    "used by another program": REFUSES + "CALL other(n)\n.END\n.PROGRAM more()\nDRIVE 1, n, 50\n",
    "the other value of a case": "CASE n OF\nVALUE 1:\nx = 1\nANY\n" + TURNS + "END\n",
    "an element": 'PROMPT "? ", q[1]\nDRIVE 1, q[1], 50\n',
    "asked by a reaction": REFUSES + "REACT 1001, main\n" + TURNS,
}


def uses(body: str) -> list[Within | None]:
    module = module_of(ASKS + body + OTHER.replace("()", "(a)") + "DRIVE 1, a, 50\n")
    program = module.programs["main"]
    prompts = (each for each in program.instructions if isinstance(each, ir.Prompt))
    found = [usage(module, program, place) for prompt in prompts for place in prompt.places]
    return [None if each is None else each.within for each in found]


@pytest.mark.parametrize("name", BOUNDED)
def test_bounds_are_found_on_every_way(name: str) -> None:
    body, within = BOUNDED[name]
    assert set(uses(body)) == {Within(*within)}


def test_what_the_execution_before_has_left_is_bounded_by_nobody() -> None:
    body = "IF DEFINED(n) THEN\n" + TURNS + "END\n" + ASKS + "IF n > 3 THEN\nHALT\nEND\n"
    assert proven(body).answer is Answer.UNDETERMINED


@pytest.mark.parametrize("name", OPEN)
def test_no_bounds_are_claimed_where_a_way_has_none(name: str) -> None:
    assert None in uses(OPEN[name])
