"""What was looked at is known by way, by part of the situation, and by interval."""

from vrts.base.pose import translation
from vrts.engine.memory.records import Lie
from vrts.prove.certify.seen import Seen
from vrts.prove.certify.situation import Lying, Part, What

ITSELF = Part(What.ITSELF)
HERE = Part(What.TOUCHED, Lying("can", Lie.RESTING, translation(0.0, 0.0, 0.0)))
THERE = Part(What.TOUCHED, Lying("can", Lie.RESTING, translation(1.0, 0.0, 0.0)))
FIRST, SECOND = (ITSELF, HERE), (ITSELF, THERE)


def test_an_interval_is_new_once() -> None:
    seen = Seen()
    assert seen.added((0,), 0, FIRST, (0.0, 1.0)) == [((0.0, 1.0), FIRST)]
    assert seen.added((0,), 0, FIRST, (0.2, 0.8)) == []
    assert seen.added((0,), 0, FIRST, (0.5, 1.5)) == [((1.0, 1.5), FIRST)]
    assert seen.added((0,), 0, FIRST, (-1.0, 2.0)) == [((-1.0, 0.0), FIRST), ((1.5, 2.0), FIRST)]
    assert seen.added((1,), 0, FIRST, (0.0, 1.0)) == [((0.0, 1.0), FIRST)]


def test_parts_that_are_the_same_elsewhere_are_not_new() -> None:
    seen = Seen()
    seen.added((0,), 0, FIRST, (0.0, 1.0))
    found = seen.added((0,), 1, SECOND, (0.5, 2.0))
    assert found == [((1.0, 2.0), (ITSELF,)), ((0.5, 2.0), (THERE,))]
    found = seen.added((0,), 0, FIRST, (0.0, 3.0))
    assert found == [((2.0, 3.0), (ITSELF,)), ((1.0, 3.0), (HERE,))]
