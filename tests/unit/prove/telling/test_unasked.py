"""What has one value alone here is told: nobody knows what comes of another one."""

from tests.support_programs import compiled
from tests.unit.prove.explore.proofs import ALONE, FREE, proven
from vrts.check.verdict import Answer
from vrts.prove.prove import prove


def test_what_is_always_the_same_here_proves_nothing() -> None:
    proof = proven("n = 0\nv = PENDANT(1)\nIF v > 30000 THEN\nn = 1/0\nEND\n")
    words = "nobody presses a key here, and nothing else was tried"
    assert proof.answer is Answer.UNDETERMINED
    assert proof.open == (f"step 2 of `main` reads PENDANT: {words}",)


def test_it_is_told_in_a_condition_and_in_a_subscript() -> None:
    proof = proven(
        "IF (PENDANT(1) > 3) OR (PENDANT(2) > 3) THEN\nx[PENDANT(3)] = 1\nEND\nx[PENDANT(3)] = 2\n"
    )
    assert [one.partition(":")[0] for one in proof.open] == [
        "step 1 of `main` reads PENDANT",
        "step 4 of `main` reads PENDANT",
    ], "step 2 is never come to"


def test_what_is_only_typed_decides_nothing() -> None:
    assert proven("TYPE PENDANT(1)\nMOVE a\n").answer is Answer.HOLDS


def test_what_goes_wrong_whatever_it_is_goes_wrong() -> None:
    assert proven("v = PENDANT(1)\nn = 0\nn = v/n\n").answer is Answer.VIOLATED


def test_the_day_and_the_time_of_day_are_told() -> None:
    text = '.PROGRAM main()\n IF $TIME() == "x" THEN\n HALT\n END\n.END\n'
    proof = prove(compiled(text, "vplus"), ALONE, FREE, entry="main")
    (told,) = proof.open
    assert told.startswith("step 1 of `main` reads $TIME: here the controller is switched on")


def test_that_a_timer_is_never_set_is_taken_for_granted() -> None:
    words = "timers that no step sets stand at 0 when the program is executed first"
    assert words in proven("t = TIMER(1)\nMOVE a\n").covered.assumed
    assert words not in proven("TIMER 1 = 0\nt = TIMER(1)\nMOVE a\n").covered.assumed
