"""Values behind the lines, and a recording that gives way: in this process, without pipes."""

import os
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from io import FileIO
from pathlib import Path
from typing import Any

import pytest

from tests.support_framing import framed
from tests.support_lsp import PATIENCE
from tests.unit.debug.dap.test_dap import HITS
from vrts.debug.conditions.hearing import Interrupted
from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.framing import Incoming
from vrts.debug.dap.listening import Listening

TEXT = """.PROGRAM main()
  n = 2
  $m = "a text that is much too long for a line"
  SET p = TRANS(600, -200.04, 0, 90, 90, 0)
  SIGNAL 3
  CALL deeper(n)
  IF SIG(3) THEN
    n = n + q
  END
.END
.PROGRAM deeper(k)
  AUTO own
  own = k * 2
  k = own
.END
"""


class Told:
    """An adapter that is asked as a client asks, and what it is to hear."""

    def __init__(self, program: Path, **more: object) -> None:
        self.calls = 0
        self.hear: Callable[[], None] = lambda: None
        self.path = str(program.resolve())
        self.adapter = Adapter(lambda name, body: None, self._heard)
        self.ask("launch", program=str(program), **more)

    def _heard(self) -> None:
        self.calls += 1
        self.hear()

    def ask(self, command: str, **arguments: object) -> dict[str, object]:
        return self.adapter.answer(command, Fields({"threadId": 1, **arguments})).body

    def lines(self) -> dict[int, str]:
        found: Any = self.ask("vrts.inline", path=self.path)["values"]
        return {row["line"]: row["text"] for row in found}


def test_lines_show_what_they_use_as_it_is_where_the_debugger_stands(tmp_path: Path) -> None:
    program = tmp_path / "values.v2"
    program.write_text(TEXT)
    told = Told(program, dialect="val2+")
    assert told.lines() == {}, "nothing has a value yet"
    for _ in range(4):
        told.ask("next")
    place = "p = 600 −200 0"
    assert told.lines() == {
        2: "n = 2",
        3: '$m = "a text that is much too…"',
        4: place,
        5: "SIG(3) on",
        6: "n = 2",
    }
    told.ask("stepBack")
    assert told.lines() == {
        2: "n = 2",
        3: '$m = "a text that is much too…"',
        4: place,
        5: "SIG(3) off",
    }
    told.ask("next")
    told.ask("stepIn")
    told.ask("next")
    assert told.lines() == {13: "own = 4, k = 2", 14: "k = 2, own = 4"}, "of the program called"
    told.ask("stepOut")
    assert told.lines()[6] == "n = 4", "given by reference"
    assert told.lines()[7] == "SIG(3) on"
    told.ask("next")
    assert told.lines()[8] == "n = 4", "`q` has no value"
    assert told.ask("vrts.inline", path="/elsewhere.v2") == {"values": []}


def test_a_recording_can_be_ended_and_is_whole_the_next_time() -> None:
    told = Told(HITS)

    def stop() -> None:
        raise Interrupted

    told.hear = stop
    with pytest.raises(Interrupted):
        told.ask("vrts.recording")
    told.hear, told.calls = lambda: None, 0
    recording = told.ask("vrts.recording")["recording"]
    assert isinstance(recording, dict)
    assert told.calls > 5, "it is heard all the time, not once"
    assert recording["contacts"]
    goals_are_told_with_their_times(recording)
    told.hear = stop
    with pytest.raises(Interrupted):
        told.ask("vrts.recording")  # the curve is sampled anew


def goals_are_told_with_their_times(recording: Any) -> None:
    titles = [row["title"] for row in recording["reached"]]
    assert titles == [goal["title"] for goal in recording["scene"]["goals"]]
    for row in recording["reached"]:
        assert all(0.0 < start < end <= recording["judged"] for start, end in row["spans"])
    assert any(row["spans"] for row in recording["reached"])


def test_a_future_has_another_number_after_a_change_and_after_a_restart(tmp_path: Path) -> None:
    program = tmp_path / "values.v2"
    program.write_text(TEXT)
    told = Told(program, dialect="val2+")
    first = told.ask("vrts.where")["future"]
    assert told.ask("vrts.where")["future"] == first
    told.ask("evaluate", expression="SPEED 50", context="repl")
    changed = told.ask("vrts.where")["future"]
    program.write_text(TEXT.replace("n = 2", "n = 3"))
    told.ask("restart")
    assert len({first, changed, told.ask("vrts.where")["future"]}) == 3


@pytest.mark.parametrize("later", ["next", "vrts.seek", "pause"])
def test_what_moves_the_debugger_ends_a_recording_that_is_worked_on(later: str) -> None:
    with asking("vrts.recording", "threads") as (listening, client):
        listening.next()
        listening.hear()  # that somebody asks for something does not end it
        client.write(request(later))
        with pytest.raises(Interrupted):
            hear_until(listening, time.monotonic() + PATIENCE)


def test_what_moves_the_debugger_ends_nothing_else() -> None:
    with asking("continue", "next") as (listening, _):
        listening.next()
        listening.hear()
        listening.next()
        listening.hear()


def hear_until(listening: Listening, latest: float) -> None:
    while time.monotonic() < latest:
        listening.hear()


@contextmanager
def asking(*commands: str) -> Generator[tuple[Listening, FileIO]]:
    """Give who listens to a client that has asked for something, and the client's end."""
    reading, writing = os.pipe()
    with os.fdopen(reading, "rb") as stream, FileIO(writing, "wb") as client:
        for command in commands:
            client.write(request(command))
        yield Listening(Incoming(stream)), client


def request(command: str) -> bytes:
    return framed({"seq": 1, "type": "request", "command": command})
