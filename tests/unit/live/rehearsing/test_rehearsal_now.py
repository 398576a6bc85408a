"""A text rehearsed in the state of a room's session: it does what the session would do, unmoved."""

import base64
from pathlib import Path
from typing import cast

import pytest

from tests.unit.live.rehearsing.support import HITS, TASK, Questions
from tests.unit.live.session.support import Driven
from vrts.live.actions import Upload
from vrts.live.rehearsing.begun import OTHER_SCENE
from vrts.live.rehearsing.going_on import STOPPED
from vrts.live.rehearsing.told import Ready, Refused
from vrts.live.session.looking.state import state_bytes
from vrts.live.session.setting import scene_sha256

SUB = ".PROGRAM sub()\n  DRIVE 1, 10, 100\n  n = n + 1\n.END\n"
MAIN = """.PROGRAM main()
  TYPE n
  CALL sub
  TYPE n
  MOVE spot
  BREAK
  SIGNAL 2
.END
"""
GRASP = HITS[: HITS.index("DEPARTS 40")] + ".END\n" + HITS[HITS.index(".END") + 5 :]
CARRY = ".PROGRAM carry()\n  DEPARTS 40\n  APPROS base2_put, 60\n  BREAK\n.END\n"


class Room(Driven):
    """A session that somebody rehearses beside."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder, scene="", task=str(TASK))
        self.questions = Questions(TASK)

    def upload(self, text: str) -> None:
        self.act(Upload("file.v2", text))
        self.run(0.1)

    def rehearse(self, text: str, *breakpoints: int) -> Ready | Refused:
        """Rehearse in the state of now."""
        return self.questions.rehearse(text, *breakpoints, state=self.state)

    @property
    def seen(self) -> object:
        """What somebody in the room could see."""
        run = self.session.run
        now = run.at(self.session.growing.time_s)
        texts = dict(self.session.conversation.monitor.desk.programs)
        return now.time_s, now.configuration, now.variables, now.poses, run.events, texts

    @property
    def state(self) -> str:
        return base64.b64encode(state_bytes(self.session)).decode()


@pytest.fixture
def room(tmp_path: Path) -> Room:
    return Room(tmp_path)


def test_it_does_what_the_session_would_do_which_stays_as_it_is(room: Room) -> None:
    room.upload(SUB)
    room.typed("DO n = 5", "HERE spot", "", "DO DRIVE 2,-20,100", seconds=2.0)
    before = room.seen
    ready = room.rehearse(MAIN, 2)
    assert isinstance(ready, Ready), ready
    assert room.seen == before
    assert (ready.problems, ready.note, ready.mark) == ((), "", None)
    assert ready.begin_s == pytest.approx(room.session.growing.time_s, abs=0.05)
    ask = room.questions
    first = ask.go("run")
    assert (first.why, first.line, first.time_s) == ("breakpoint", 2, ready.begin_s)
    assert {v.name: v.value for v in first.variables}["n"] == "5"
    inside = [ask.go("over"), ask.go("into")]
    assert [(one.program, one.line) for one in inside] == [("main", 3), ("sub", 0)]
    assert inside[1].step_text == "DRIVE 1, 10, 100"
    assert ask.go("end").typed == (" 5", " 6")
    assert [ask.go("back").line for _ in range(2)] == [8, 7]
    assert ask.go("start").line == 2
    assert ask.at(0.0).time_s == ready.begin_s

    room.upload(MAIN)
    room.typed("EXECUTE main", seconds=ready.duration_s + 1.0)
    happened = room.session.run.at(room.session.growing.time_s)
    rehearsed = ask.run.at(ask.run.horizon_s)
    assert rehearsed.configuration == pytest.approx(happened.configuration, abs=1e-12)
    assert set(rehearsed.signals) == set(happened.signals) == {2}
    assert rehearsed.variables["n"] == happened.variables["n"] == 6.0


def test_what_the_hand_holds_touches_what_is_on_the_way(room: Room) -> None:
    room.upload(GRASP)
    room.typed("EXECUTE main", seconds=8.0)
    assert room.session.run.at(room.session.growing.time_s).held == "can1"
    ready = room.rehearse(CARRY)
    assert isinstance(ready, Ready), ready
    assert [(c["held"], c["second"], c["line"]) for c in ready.contacts] == [("can1", "base1", 3)]
    block = room.questions.block(0).data
    assert block is not None
    assert (block["begin"], block["reaches"]) == (ready.begin_s, ready.begin_s)


def test_what_moves_in_the_room_is_stopped_in_the_rehearsal_alone(room: Room) -> None:
    room.upload(SUB)
    room.typed("DO n = 1", "DO SPEED 10 ALWAYS", "EXECUTE sub", seconds=0.3)
    ready = room.rehearse(".PROGRAM sub()\n  DRIVE 1, 5, 100\n.END\n")
    assert isinstance(ready, Ready), ready
    assert ready.note == STOPPED
    assert ready.begin_s > room.session.growing.time_s
    assert [step["text"] for step in _steps(room)] == ["DRIVE 1, 5, 100"]
    room.run(6.0)
    assert room.session.run.at(room.session.growing.time_s).variables["n"] == 2.0


def test_the_start_of_another_scene_than_the_sessions_is_refused(room: Room) -> None:
    own = scene_sha256(room.session.setting)
    assert isinstance(Questions(TASK, own).rehearse(HITS), Ready)
    refused = Questions(scene_sha256=own).rehearse(HITS)
    assert isinstance(refused, Refused)
    assert refused.message == OTHER_SCENE


def test_what_fails_in_a_program_of_the_room_is_in_no_line_of_the_text(room: Room) -> None:
    room.upload(".PROGRAM sub()\n  MOVE nowhere\n.END\n")
    ready = room.rehearse(".PROGRAM main()\n  CALL sub\n.END\n")
    assert isinstance(ready, Ready), ready
    (failed,) = [one for one in ready.problems if one.severity == "error"]
    assert (failed.line, failed.end_line, failed.program) == (0, 0, "sub")


def test_limits_count_from_now(room: Room) -> None:
    room.typed("DO n = 1", seconds=1.0)
    ready = room.rehearse(".PROGRAM main()\n  10 n = n + 1\n  TYPE n\n  GOTO 10\n.END\n")
    assert isinstance(ready, Ready), ready
    assert ready.ended.why == "limit"
    assert ready.note.endswith("and was stopped there")
    assert 0.0 < ready.duration_s < 30.0


def test_a_state_that_does_not_fit_is_refused(room: Room) -> None:
    state = room.state
    wrong = Questions()  # of a robot alone
    for text in ("", "AAAA", "?", state[:-100]):
        if text:
            refused = room.questions.rehearse(CARRY, state=text)
            assert isinstance(refused, Refused)
            assert refused.message == OTHER_SCENE
    refused = wrong.rehearse(CARRY, state=state)
    assert isinstance(refused, Refused)
    assert refused.message == OTHER_SCENE
    refused = room.questions.rehearse(".PROGRAM a()\n  MOVEE spot\n.END\n", state=state)
    assert isinstance(refused, Refused)
    assert refused.problems[0].line == 2


def _steps(room: Room) -> list[dict[str, object]]:
    block = room.questions.block(0).data
    assert block is not None
    return cast("list[dict[str, object]]", block["steps"])
