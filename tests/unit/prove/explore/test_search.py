"""Every future of small programs: what goes wrong in one of them is found, and nothing else."""

import pytest

from tests.support_programs import cans, compiled, program
from tests.unit.prove.explore.proofs import ALONE, module_of, only, proven, wrongs
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.memory.records import Ending
from vrts.prove.asking import Asking, Told
from vrts.prove.environment.environment import Afterwards, Again, Answers, Environment
from vrts.prove.proof import What, Wrong
from vrts.prove.prove import prove
from vrts.scene.model import Deed


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


def test_a_program_that_nothing_from_outside_ends_is_told_as_meant() -> None:
    asks = "WHILE {} DO\nIF SIG(1001) THEN\n{} = 0\nEND\nEND\n"
    wrong = proven("going = 1\ngong = 1\n" + asks.format("going == 1", "gong"))
    assert wrong.answer is Answer.HOLDS
    assert "going round for ever at step 4 of `main` is meant" in wrong.covered.assumed
    right = proven("going = 1\n" + asks.format("going == 1", "going"))
    assert not [one for one in right.covered.assumed if "for ever" in one]


def test_a_wait_for_an_input_is_no_deadlock() -> None:
    proof = proven("WAIT SIG(1001)\nMOVE a\n")
    assert proof.answer is Answer.HOLDS
    assert "inputs for which a program waits come eventually" in proof.covered.assumed


BESIDE = """\
PCEXECUTE beside
DELAY 0.5
BREAK
SIGNAL 2001
WAIT
SIGNAL 2002
BREAK
.END
.PROGRAM beside()
WAIT SIG(2001)
IF SIG(2002) THEN
x = 1/0
END
"""


def test_either_of_two_programs_may_go_on_first_in_a_tick() -> None:
    proof = proven(BESIDE)
    found = only(proof)
    assert found.wrong is Wrong.ERROR
    assert [one.what for one in found.decisions] == [What.TURN]
    (time_s,) = found.scenario.process_first
    assert found.decisions[0].time_s - ALONE.robot.arm.tick < time_s < found.decisions[0].time_s
    said = proof.covered.quantified
    assert any(line.startswith("two programs: either has its turn first") for line in said)


def test_an_environment_may_say_which_program_goes_on_first() -> None:
    proof = proven(BESIDE, Environment(turns=False))
    assert proof.answer is Answer.HOLDS
    order = "in each tick the robot program has its turn before the process control program"
    assert order in proof.covered.assumed


def test_what_is_begun_may_go_on_in_the_same_tick_or_in_the_next() -> None:
    looks = ".END\n.PROGRAM beside()\nIF SIG(-2001) THEN\nx = 1/0\nEND\n"
    found = only(proven(f"PCEXECUTE beside\nSIGNAL 2001\nWAIT\nSIGNAL -2001\n{looks}"))
    assert [one.what for one in found.decisions] == [What.TURN]


def test_programs_that_share_nothing_have_no_order() -> None:
    apart = "PCEXECUTE beside\nMOVE a\nREADY\n.END\n.PROGRAM beside()\nSIGNAL 3\n"
    assert proven(apart).covered.decisions == 0


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
    proof = proven('PROMPT "how many? ", n\nDRIVE 1, n, 50\n')
    assert proof.answer is Answer.UNDETERMINED
    assert "nothing says what is typed at step 1" in proof.open[0]


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


# --- the operator, and what is missing ------------------------------------------------------------

COUNTS = "IF NOT DEFINED(n) THEN\nn = 0\nEND\nn = n+1\n"


def test_a_program_is_executed_again_until_its_memory_comes_again() -> None:
    again = Environment(again=Again(None))
    proof = proven(COUNTS + "IF n == 5 THEN\nn = 0\nEND\nMOVE a\n", again)
    assert proof.answer is Answer.HOLDS
    assert proof.covered.ends == 6, "the first begins elsewhere than the others"


def test_what_only_the_sixth_execution_shows_is_found_and_replayed() -> None:
    body = COUNTS + "MOVE a\nBREAK\nIF n == 6 THEN\nx = 1/(n-6)\nEND\n"
    found = only(proven(body, Environment(again=Again(None))))
    assert [one.what for one in found.decisions] == [What.AGAIN] * 5
    run = execute(module_of(body), ALONE, found.scenario)
    assert run.ending is Ending.ERROR
    assert proven(body, Environment(again=Again(4))).answer is Answer.HOLDS


HIGH = "n = 0\nMOVE c\nMOVE b\nBREAK\nHERE p\nIF DZ(p) > 250 THEN\nx = 1/n\nEND\n"


def test_a_stop_in_any_tick_of_a_motion_is_tried() -> None:
    assert proven(HIGH).answer is Answer.HOLDS
    found = only(proven(HIGH, Environment(stops=frozenset({Afterwards.PROCEED}))))
    assert [one.value for one in found.decisions] == ["stop", "proceed"]
    assert [act.deed for act in found.scenario.operator] == [Deed.STOP, Deed.PROCEED]
    run = execute(module_of(HIGH), ALONE, found.scenario)
    assert run.ending is Ending.ERROR


def test_a_stop_after_which_the_motion_is_done_again_comes_to_the_same_place() -> None:
    retried = proven(HIGH, Environment(stops=frozenset({Afterwards.RETRY, Afterwards.NOTHING})))
    assert retried.answer is Answer.HOLDS
    assert retried.covered.decisions > 50


def test_every_monitor_speed_is_tried() -> None:
    body = "n = 0\nTIMER 1 = 0\nMOVE a\nBREAK\nIF TIMER(1) > 2.5 THEN\nx = 1/n\nEND\n"
    assert proven(body).answer is Answer.HOLDS
    found = only(proven(body, Environment(speeds=(100.0, 50.0))))
    assert found.scenario.monitor_speed == 50.0
    assert [one.what for one in found.decisions] == [What.SPEED]


def test_random_numbers_of_a_counterexample_stand_in_its_scenario() -> None:
    body = "n = RANDOM\nm = RANDOM\nIF (n > 0.9) AND (m < 0.9) THEN\nx = 1/(n-n)\nEND\n"
    found = only(proven(body))
    assert found.scenario.draws == (0.9999, 0.0)


def test_a_part_that_is_missing_is_tried_where_the_environment_says_so() -> None:
    body = (
        "n = 0\nOPENI\nAPPRO grip, 120\nMOVES grip\nGRASP 20, 10\nDEPARTS 100\nHALT\n10 n = 1/n\n"
    )
    module = compiled(program(body, {"grip": "800 -450 -225 90 90 0"}))
    scene = cans()
    assert prove(module, scene, Environment(), entry="main").answer is Answer.HOLDS
    found = only(prove(module, scene, Environment(misses=True), entry="main"))
    assert [one.what for one in found.decisions] == [What.GRIP]
    assert execute(module, scene, found.scenario).ending is Ending.ERROR


def test_a_search_ends_soon_after_something_is_found_and_says_that_more_is_open() -> None:
    body = "k = 0\nIF SIG(-1001) THEN\nx = 1/k\nEND\nn = 0\nm = 0\nWHILE n < 20000 DO\n"
    body += "n = n+1\nIF SIG(1002) THEN\nm = n\nEND\nWAIT\nEND\nIF m < 0 THEN\nMOVE a\nEND\n"
    proof = proven(body)
    assert wrongs(proof) == [(Wrong.ERROR, 3)]
    assert proof.covered.states < 8_000
    assert "futures were left" in proof.open[0]


WATCHES = """\
.PROGRAM main()
  WAIT SIG(-1002)
  REACTI 1002, gone
  MOVE a
  BREAK
  MOVE b
  BREAK
  IF SIG(1002) AND (n == 0) THEN
    x = 1/n
  END
.END
.PROGRAM gone()
  n = 1
.END
.REALS
n 0
.END
.LOCATIONS
a 700 200 300 90 90 0
b 700 -200 300 90 90 0
.END
"""


@pytest.mark.thorough
def test_what_comes_on_while_the_program_stands_is_lost_to_reactions() -> None:
    module = compiled(WATCHES)
    free = prove(module, ALONE, Environment(), Asking(), entry="main")
    assert free.answer is Answer.HOLDS, "the reaction is taken before SIG is looked at"
    stops = Environment(stops=frozenset({Afterwards.PROCEED}))
    proof = prove(module, ALONE, stops, Asking(), entry="main")
    assert proof.answer is Answer.VIOLATED
    found = proof.found[0]
    assert found.headline == "division by zero"
    assert [d.what for d in found.decisions] == [What.STOP, What.INPUT, What.STOP]
    assert execute(module, ALONE, found.scenario).ending is Ending.ERROR
