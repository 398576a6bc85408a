"""Properties of one's own, broken in some future."""

from tests.unit.prove.explore.proofs import only, proven
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Environment, Property, Quantifier
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
