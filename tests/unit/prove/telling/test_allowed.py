"""A counterexample says nothing that its environment forbids."""

from tests.support_programs import compiled
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Environment, Held, Property, Pulsed, Quantifier, Span
from vrts.prove.proof import Decided, Proof, What
from vrts.prove.prove import prove
from vrts.prove.telling.allowed import allowed
from vrts.scene.default import robot_alone

TICK = 0.028
GATE = Pulsed(on_s=Span(5.0, float("inf")), off_s=Span(0.5, 10.0))
WAITS = ".PROGRAM main\n WAIT SIG(1001)\n SIGNAL 3\n DELAY 1\n BREAK\n SIGNAL -3\n.END\n"


def decided(time_s: float, value: bool) -> Decided:
    return Decided(time_s, What.INPUT, 1001, value, None)


def is_allowed(behaviour: Held | Pulsed, *left: Decided, until_s: float = 8.0) -> bool:
    environment = Environment(inputs={1001: behaviour})
    return allowed(environment, left, [decided(0.7, value=True)], until_s, TICK)


def test_an_input_stays_for_as_long_as_its_environment_says() -> None:
    assert is_allowed(GATE), "off all the time"
    assert not is_allowed(GATE, until_s=11.0), "but not for longer than 10 s"
    assert is_allowed(GATE, decided(2.0, value=True), until_s=60.0)
    assert not is_allowed(GATE, decided(2.0, value=True), decided(3.0, value=False))
    assert is_allowed(GATE, decided(2.0, value=True), decided(7.5, value=False))


def test_an_input_that_is_held_cannot_be_left_out() -> None:
    assert not is_allowed(Held(True))
    assert is_allowed(Held(None)), "nobody says which"
    assert not is_allowed(Held(None), decided(1.0, value=True))


def test_what_was_explored_so_is_not_asked_again() -> None:
    assert is_allowed(Held(True), decided(0.7, value=True))


def proven(behaviour: Held | Pulsed, *signals: int, text: str = WAITS) -> Proof:
    never = Property(Quantifier.NEVER, "3 while it is shut", signals=signals)
    environment = Environment(inputs={1001: behaviour}, properties=(never,))
    return prove(compiled(text), robot_alone(), environment, entry="main")


def test_a_property_looks_at_inputs_as_their_environment_has_them() -> None:
    assert proven(GATE, 3, -1001).answer is Answer.HOLDS, "it stays on for 5 s"
    short = Pulsed(on_s=Span(0.5, 0.6), off_s=Span(0.5, 10.0))
    (found,) = proven(short, 3, -1001).found
    on, off = found.decisions
    assert 0.5 - TICK <= off.time_s - on.time_s <= 0.6 + 2 * TICK


def test_a_counterexample_keeps_inputs_that_cannot_be_off() -> None:
    looks = ".PROGRAM main\n IF SIG(1001) THEN\n TYPE 1\n END\n SIGNAL 3\n DELAY 1\n BREAK\n.END\n"
    (found,) = proven(Held(True), 3, text=looks).found
    assert [(one.number, one.value) for one in found.decisions] == [(1001, True)]
