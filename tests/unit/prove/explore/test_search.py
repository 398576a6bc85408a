"""Every future of small programs: what goes wrong in one of them is found, and nothing else."""

import pytest

from tests.unit.prove.explore.proofs import ALONE, module_of, only, proven, wrongs
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.memory.records import Ending
from vrts.prove.asking import Asking, Told
from vrts.prove.environment.environment import Answers, Environment
from vrts.prove.proof import What, Wrong


def test_a_program_without_inputs_has_one_future() -> None:
    proof = proven("MOVE a\nMOVES b\n")
    assert proof.answer is Answer.HOLDS
    assert (proof.covered.decisions, proof.covered.ends) == (0, 1)


def test_an_error_that_two_inputs_show_together_is_found_with_both() -> None:
    found = only(proven("IF SIG(1001) THEN\nIF SIG(1002) THEN\nn = 1/0\nEND\nEND\n"))
    assert found.wrong is Wrong.ERROR
    assert found.headline == "division by zero"
    assert found.cause is not None
    assert found.cause.step == 3
    assert [(d.what, d.number, d.value) for d in found.decisions] == [
        (What.INPUT, 1001, True),
        (What.INPUT, 1002, True),
    ]


def test_the_scenario_of_a_counterexample_replays_it() -> None:
    body = "MOVE a\nBREAK\nWAIT SIG(1001)\nIF SIG(-1001) THEN\nELSE\nn = 1/0\nEND\n"
    found = only(proven(body))
    run = execute(module_of(body), ALONE, found.scenario)
    assert run.ending is Ending.ERROR
    assert run.ended_s == pytest.approx(found.time_s, abs=0.5)


def test_the_counterexample_with_the_fewest_decisions_is_told() -> None:
    body = (
        "FOR i = 1 TO 3\nWAIT\nIF SIG(1001) THEN\nn = n+1\nEND\nEND\nIF n > 0 THEN\nx = 1/0\nEND\n"
    )
    found = only(proven("n = 0\n" + body))
    assert [d.value for d in found.decisions] == [True], "it may come on and stay"


def test_errors_of_different_causes_are_told_each_once() -> None:
    body = "IF SIG(1001) THEN\nn = 1/0\nEND\nIF SIG(1002) THEN\nn = SQRT(-1)\nEND\n"
    assert wrongs(proven(body)) == [(Wrong.ERROR, 2), (Wrong.ERROR, 5)]


def test_a_wait_for_an_input_is_no_deadlock() -> None:
    proof = proven("WAIT SIG(1001)\nMOVE a\n")
    assert proof.answer is Answer.HOLDS
    assert "inputs for which a program waits come eventually" in proof.covered.assumed


def test_a_wait_that_nothing_may_end_is_a_deadlock() -> None:
    found = only(proven("WAIT SIG(1001)\nIF SIG(1002) THEN\nWAIT SIG(2001)\nEND\n"))
    assert found.wrong is Wrong.DEADLOCK
    assert found.cause is not None
    assert found.cause.step == 3
    assert "no program sets it" in found.headline


def test_a_wait_that_looks_at_an_input_and_a_signal_nobody_sets_is_a_deadlock() -> None:
    assert wrongs(proven("WAIT SIG(1001, 2001)\n")) == [(Wrong.DEADLOCK, 1)]


def test_two_programs_that_wait_for_each_other_are_told_as_a_circle() -> None:
    body = (
        "PCEXECUTE other\nIF SIG(1001) THEN\nWAIT SIG(2001)\nEND\nSIGNAL 2002\nWAIT SIG(2001)\n"
        ".END\n.PROGRAM other\nWAIT SIG(2002)\nSIGNAL 2001"
    )
    found = only(proven(body))
    assert found.wrong is Wrong.DEADLOCK
    assert "each waits for the other" in found.headline
    assert [d.value for d in found.decisions] == [True]


def test_a_loop_without_decisions_is_endless() -> None:
    found = only(proven("WAIT SIG(1001)\nIF SIG(1002) THEN\n10 n = 1\nGOTO 10\nEND\n"))
    assert found.wrong is Wrong.ENDLESS
    assert found.cause is not None
    assert found.cause.step in (3, 4)


def test_a_loop_that_an_input_may_end_is_not_endless() -> None:
    assert proven("10 IF SIG(-1001) GOTO 10\n").answer is Answer.HOLDS


def test_answers_are_tried_as_the_environment_says() -> None:
    body = 'PROMPT "how many? ", n\nIF n == 3 THEN\nx = 1/0\nEND\n'
    answers = Environment(answers=Answers(("1", "2", "3")))
    found = only(proven(body, answers))
    assert found.scenario.answers == ("3",)
    proof = proven(body)
    assert proof.answer is Answer.UNDETERMINED
    assert "nobody says what is typed at step 1" in proof.open[0]


def test_random_numbers_are_sampled_and_told_so() -> None:
    proof = proven("n = RANDOM\nIF n > 0.4 THEN\nMOVE a\nEND\n")
    assert proof.answer is Answer.HOLDS
    assert proof.covered.sampled == ("RANDOM: 0, 0.5, 0.9999 only",)
    assert proof.covered.decisions == 1


def test_a_budget_of_states_leaves_it_undetermined_and_says_how_much_is_open() -> None:
    body = "n = 0\nWHILE n < 1000 DO\nn = n+1\nIF SIG(1001) THEN\nm = n\nEND\nEND\n"
    proof = proven(body, asking=Asking(states=100))
    assert proof.answer is Answer.UNDETERMINED
    assert proof.covered.states == 100
    assert "after 100 states" in proof.open[0]


def test_a_search_that_is_told_that_it_is_enough_tells_what_it_knows() -> None:
    body = "IF SIG(1002) THEN\nx = 1/0\nEND\nn = 0\n"
    body += "WHILE n < 9000 DO\nn = n+SIG(1001)*SIG(1001)+1\nEND\n"
    told: list[Told] = []
    proof = proven(body, asking=Asking(told=told.append, enough=lambda: True))
    assert wrongs(proof) == [(Wrong.ERROR, 2)]
    assert proof.open
    assert told[0].states >= 1000


def test_steps_that_no_future_executes_are_told_with_the_reason() -> None:
    body = "IF SIG(1001) THEN\nHALT\nn = 1\nEND\nIF FALSE THEN\nn = 2\nEND\n"
    proof = proven(body)
    assert [(one.program, one.step) for one in proof.covered.dead] == [("main", 3), ("main", 6)]
    assert "no way leads to it" in proof.covered.dead[0].reason
    assert "step 5 never goes on to it" in proof.covered.dead[1].reason
