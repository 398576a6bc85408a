"""The words for what happened, as the list of the page shows them."""

import pytest

from tests.support_runs import MOVES
from vrts.engine.memory.events import (
    AnalogChanged,
    Answered,
    CommandRefused,
    Event,
    MotionEnded,
    Printed,
    ProgramEnded,
    ProgramStarted,
    Prompted,
    Reacted,
    SpeedChanged,
    SwitchChanged,
)
from vrts.report.event_words import event_text

WORDS: list[tuple[Event, str, str]] = [
    (ProgramStarted(0.0, "main"), "program", "program main starts"),
    (ProgramStarted(0.0, "pc", process=True), "program", "process program pc starts"),
    (ProgramEnded(0.0, "halted", process=True), "program", "process program over: halted"),
    (SwitchChanged(0.0, "CP", False, None), "program", "switch CP off"),
    (AnalogChanged(0.0, 2, 512.0, None), "signal", "analog output 2 is 512"),
    (Prompted(0.0, None), "output", "the program waits for an answer"),
    (Answered(0.0, "12\n", None), "output", "answer: 12"),
    (Reacted(0.0, 1003, "alarm", None), "signal", "program alarm reacts to signal 1003"),
    (Reacted(0.0, 0, "rescue", None), "signal", "program rescue reacts to an error"),
    (SpeedChanged(0.0, 50.0), "program", "operator's speed 50 %"),
    (CommandRefused(0.0, "Undefined value"), "fault", "command refused: Undefined value"),
]


@pytest.mark.parametrize(("event", "kind", "text"), WORDS)
def test_an_event_has_its_words(event: Event, kind: str, text: str) -> None:
    assert event_text(event) == (kind, text)


@pytest.mark.parametrize("event", [MotionEnded(0.0, 0, MOVES), Printed(0.0, " \n", MOVES)])
def test_what_says_nothing_has_no_row(event: Event) -> None:
    assert event_text(event) is None
