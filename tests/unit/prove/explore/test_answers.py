"""Numbers typed at PROMPT: all, or the ends, what the program compares with, and between."""

from tests.unit.prove.explore.proofs import module_of, only, proven
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Answers, Environment
from vrts.prove.explore.answers import tried

COMPARES = 'PROMPT "x ", x\nk = 0\nIF (x > 40) AND (x < 40.5) THEN\nn = 1/k\nEND\n'


def test_all_whole_numbers_of_a_range_are_tried() -> None:
    environment = Environment(answers=Answers(least=0.5, most=9.0, whole=True))
    proof = proven('PROMPT "n ", n\nk = n-7\nn = 1/k\n', environment)
    assert only(proof).scenario.answers == ("7",)
    assert "answers to PROMPT: every whole number from 1 to 9" in proof.covered.quantified
    assert not proof.covered.sampled


def test_numbers_between_those_that_a_program_compares_with_are_tried() -> None:
    proof = proven(COMPARES, Environment(answers=Answers(least=1.0, most=100.0)))
    (answer,) = only(proof).scenario.answers
    assert 40.0 < float(answer) < 40.5
    assert proof.covered.sampled[0].startswith("answers to PROMPT, 1 to 100: 1, ")


def test_many_whole_numbers_are_sampled_at_ends_and_boundaries() -> None:
    found = tried(Answers(least=0.0, most=1e4, whole=True), module_of(COMPARES))
    assert {0.0, 1.0, 9999.0, 10000.0, 39.0, 40.0, 41.0} <= set(found.numbers)
    assert all(number == round(number) for number in found.numbers)
    assert found.sampled


def test_every_value_that_a_prompt_reads_is_tried_with_every_other() -> None:
    environment = Environment(answers=Answers(least=1.0, most=3.0, whole=True))
    proof = proven('PROMPT "x ", x, y\nk = (x-3)*10+y-1\nn = 1/k\n', environment)
    assert only(proof).scenario.answers == ("3 1",)


def test_texts_are_tried_beside_a_range() -> None:
    environment = Environment(answers=Answers(("none",), 1.0, 2.0, whole=True))
    assert only(proven('PROMPT "x ", x\n', environment)).scenario.answers == ("none",)
    assert proven('PROMPT "x ", $x\n', environment).answer is Answer.HOLDS
