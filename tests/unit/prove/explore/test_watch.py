"""Properties of one's own, broken in some future."""

import pytest

from tests.unit.prove.explore.proofs import only, proven
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import (
    Afterwards,
    Answering,
    Environment,
    Held,
    Property,
    Quantifier,
    Span,
)
from vrts.prove.proof import What, Wrong


def environment(*properties: Property) -> Environment:
    return Environment(properties=properties)


BOTH = Property(Quantifier.NEVER, "output 1 beside output 2", signals=(1, 2))


def test_what_must_never_be_is_found_with_the_inputs_that_bring_it_about() -> None:
    body = "SIGNAL 1\nIF SIG(1001) THEN\nSIGNAL 2\nWAIT\nEND\nSIGNAL -2\nMOVE a\n"
    found = only(proven(body, environment(BOTH)))
    assert (found.wrong, found.headline) == (Wrong.PROPERTY, "never: output 1 beside output 2")
    assert [(one.what, one.number) for one in found.decisions] == [(What.INPUT, 1001)]
    assert proven(body.replace("SIGNAL 1\n", ""), environment(BOTH)).answer is Answer.HOLDS


def test_an_input_that_nobody_looks_at_may_break_a_property() -> None:
    one = Property(Quantifier.NEVER, "1004 while output 1 is on", signals=(1, 1004))
    found = only(proven("SIGNAL 1\nMOVE a\nBREAK\nSIGNAL -1\n", environment(one)))
    assert [(d.number, d.value) for d in found.decisions] == [(1004, True)]


def test_what_is_due_within_a_time_is_watched_while_the_arm_moves() -> None:
    soon = Property(
        Quantifier.ALWAYS, "output 2 follows output 1", signals=(2,), after=1, within_s=0.5
    )
    body = "SIGNAL 1\nIF SIG(1001) THEN\nDELAY 1\nBREAK\nEND\nSIGNAL 2\n"
    found = only(proven(body, environment(soon)))
    assert [one.value for one in found.decisions] == [True]


def test_an_input_is_no_more_than_the_environment_lets_it_be() -> None:
    one = Property(Quantifier.NEVER, "1004 while output 1 is on", signals=(1, 1004))
    body = "SIGNAL 1\nMOVE a\nBREAK\nSIGNAL -1\n"
    held = Environment(inputs={1004: Held(False)}, properties=(one,))
    assert proven(body, held).answer is Answer.HOLDS
    follows = Answering(output=2, on_s=Span(0.1, 0.2), off_s=Span(0.1, 0.2))
    after = Environment(inputs={1004: follows}, properties=(one,))
    assert proven(body, after).answer is Answer.HOLDS
    found = only(proven("SIGNAL 2\n" + body, after))
    assert [(d.number, d.value) for d in found.decisions] == [(1004, True)]


@pytest.mark.parametrize("after", [1001, -1001])
def test_what_is_due_may_have_begun_between_two_looks(after: int) -> None:
    soon = Property(Quantifier.ALWAYS, "4 in time", signals=(4,), after=after, within_s=0.5)
    body = "IF SIG(1001) THEN\nDELAY 0.1\nBREAK\nEND\nDELAY 2\nBREAK\nIF SIG(1001) THEN\nEND\n"
    found = only(proven(body, environment(soon)))
    assert found.wrong is Wrong.PROPERTY
    assert {one.number for one in found.decisions} == {1001}


def test_what_is_left_on_is_watched_until_the_arm_stands_after_a_stop() -> None:
    one = Property(Quantifier.NEVER, "output 5 at rest", signals=(5,), still=True)
    body = "MOVE a\nMOVE b\nSIGNAL 5\nMOVE c\nSIGNAL -5\nBREAK\n"
    assert proven(body, environment(one)).answer is Answer.HOLDS
    stops = Environment(stops=frozenset({Afterwards.NOTHING}), properties=(one,))
    found = only(proven(body, stops))
    assert [one.what for one in found.decisions] == [What.STOP]


def test_what_is_due_when_the_program_ends_may_still_come_too_late() -> None:
    soon = Property(Quantifier.ALWAYS, "4 in time", signals=(4,), after=1, within_s=0.5)
    found = only(proven("SIGNAL 1\n", environment(soon)))
    assert 0.5 <= found.time_s < 0.6
    assert proven("SIGNAL 1\nDELAY 0.2\nBREAK\nSIGNAL 4\n", environment(soon)).answer is (
        Answer.HOLDS
    )
