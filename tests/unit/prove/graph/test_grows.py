"""Variables that grow round a cycle are found soon, and spend no budget."""

import pytest

from tests.unit.prove.explore.proofs import only, proven, wrongs
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Again, Environment
from vrts.prove.proof import Wrong

WAITS = "n = 0\nWHILE NOT SIG(1001) DO\nn = n+1\nDELAY 0.1\nEND\n"


def test_a_counter_at_which_nobody_looks_grows_and_hides_nothing() -> None:
    proof = proven(WAITS)
    assert proof.answer is Answer.HOLDS
    assert [(one.name, one.cause and one.cause.step) for one in proof.unbounded] == [("n", 3)]
    assert proof.covered.states < 10


def test_a_counter_that_decides_something_is_told_once_nothing_bounds_it() -> None:
    proof = proven(WAITS + "IF n < -5 THEN\nMOVE a\nEND\n")
    assert proof.answer is Answer.UNDETERMINED
    assert [one.name for one in proof.unbounded] == ["n"]
    assert "`n` grows without bound" in proof.open[0]
    assert proof.covered.states < 1000


def test_what_goes_wrong_before_it_grows_too_far_is_found_all_the_same() -> None:
    proof = proven("k = 0\n" + WAITS + "IF n == 7 THEN\nx = 1/k\nEND\n")
    assert wrongs(proof) == [(Wrong.ERROR, 8)]
    assert [one.name for one in proof.unbounded] == ["n"]


@pytest.mark.parametrize("bound", ["n < 60", "n < m"])
def test_a_counter_that_comes_to_its_bound_does_not_grow(bound: str) -> None:
    body = f"n = 0\nm = 60\nWHILE {bound} DO\nWAIT SIG(1001)\nWAIT SIG(-1001)\nn = n+1\nEND\n"
    proof = proven(body)
    assert proof.answer is Answer.HOLDS
    assert not proof.unbounded


def test_a_counter_that_is_typed_in_every_execution_ends_the_search() -> None:
    body = "IF NOT DEFINED(n) THEN\nn = 0\nEND\nn = n+1\nTYPE n\n"
    proof = proven(body, Environment(again=Again(None)))
    assert proof.answer is Answer.HOLDS
    assert [one.name for one in proof.unbounded] == ["n"]


def test_an_endless_loop_that_counts_its_rounds_is_endless() -> None:
    assert only(proven("n = 0\n10 n = n+1\nTYPE n\nGOTO 10\n")).wrong is Wrong.ENDLESS


def test_a_timer_matters_no_more_once_it_is_past_all_it_is_compared_with() -> None:
    body = "TIMER 1 = 0\nk = 0\nWAIT SIG(1001)\nIF TIMER(1) > 2 THEN\nx = 1/k\nEND\n"
    proof = proven(body)
    assert wrongs(proof) == [(Wrong.ERROR, 5)]
    assert not proof.open
    assert proof.found[0].time_s == pytest.approx(2.0, abs=0.06)
