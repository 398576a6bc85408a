"""A text rehearsed: run to its end, stepped forward and back, marked; and what does not run."""

import pytest

from tests.unit.live.rehearsing.support import CALLS, ENDLESS, HITS, TASK, Questions
from vrts.live.rehearsing import begun
from vrts.live.rehearsing.told import Refused
from vrts.live.rehearsing.within import CAN


@pytest.fixture(scope="module")
def questions() -> Questions:
    return Questions(TASK)


def test_a_run_is_marked_as_it_would_be_handed_in(questions: Questions) -> None:
    ready = questions.ready(HITS, 2, 12, 400)
    assert [(p.line, p.verified, p.at) for p in ready.breakpoints] == [
        (2, True, 3),  # a comment: the next step
        (12, True, 12),
        (400, False, 400),
    ]
    (contact,) = [mark for mark in ready.marks if mark.kind == "contact"]
    assert (contact.line, contact.text) == (11, "can1 touches base1, 59 mm deep")
    assert contact.time_s == pytest.approx(4.87, abs=0.01)
    assert [row["line"] for row in ready.contacts] == [11]
    assert ready.mark is not None
    assert ready.mark.mark == 7.0
    assert [lost.kind for lost in ready.mark.lost] == ["contact", "time"]
    assert (ready.ended.why, ready.note, ready.undetermined) == ("completed", "", False)
    assert ready.marks[-1].text == "program over: completed"
    assert ready.marks[-1].time_s == ready.duration_s


def test_steps_go_forward_and_back_through_programs_that_call_each_other() -> None:
    questions = Questions()
    ready = questions.ready(CALLS)
    assert ready.mark is None
    assert ready.programs == ("main", "add")
    assert (questions.go("start").line, questions.go("over").line) == (2, 3)
    inside = questions.go("into")
    assert (inside.program, inside.line, inside.depth) == ("add", 9, 2)
    assert {v.name: (v.value, v.group) for v in inside.variables}["n"] == ("3", "local")
    inside = questions.go("over")
    values = {v.name: v.value for v in inside.variables}
    assert (values["twice"], values["total"]) == ("6", "0")
    assert questions.go("out").line == 4
    after = questions.go("over")
    assert (after.line, after.typed) == (5, ("total  6",))
    back = questions.go("back")
    assert (back.line, back.typed) == (4, ())
    assert [questions.go("back").line for _ in range(2)] == [10, 9]
    assert questions.go("end").why == "end"
    assert questions.go("end").typed == ("total  6", "total  14")
    assert questions.go("start").variables == ()


def test_it_stops_at_breakpoints_in_both_directions(questions: Questions) -> None:
    questions.ready(HITS, 7, 12)
    there = [questions.go("run") for _ in range(3)]
    assert [(one.why, one.line) for one in there] == [
        ("breakpoint", 7),
        ("breakpoint", 12),
        ("end", 0),
    ]
    back = [questions.go("back_run") for _ in range(3)]
    assert [(one.why, one.line) for one in back] == [
        ("breakpoint", 12),
        ("breakpoint", 7),
        ("start", 3),
    ]
    assert back[0].time_s == there[1].time_s
    at = questions.at(back[0].time_s + 0.05)
    assert (at.why, at.line) == ("time", 12)
    assert questions.at(1e6).time_s == there[2].time_s


def test_poses_come_in_blocks_that_are_whole(questions: Questions) -> None:
    ready = questions.ready(HITS)
    block = questions.block(0).data
    assert block is not None
    assert block["whole"] is True
    assert block["until"] == ready.duration_s
    steps = block["steps"]
    assert isinstance(steps, list)
    assert {"program": "main", "line": 10, "at": 11, "text": "APPROS base2_put, 60"} in steps
    beyond = questions.block(1)
    assert beyond.data is None
    assert beyond.message == "the rehearsal does not reach so far"


@pytest.mark.thorough
def test_a_program_without_end_is_run_to_a_limit_which_is_said() -> None:
    questions = Questions()
    ready = questions.ready(ENDLESS)
    assert ready.ended.why == "limit"
    assert ready.note == "the program is still running after 600 s, and was stopped there"
    assert 600.0 < ready.duration_s < 610.0
    assert ready.ended.line in (3, 4, 5, 6)
    assert any(mark.kind == "fault" for mark in ready.marks)
    last = questions.go("end")
    assert last.time_s == ready.duration_s
    assert float({v.name: v.value for v in last.variables}["i"]) > 10
    assert questions.block(9).data is not None
    assert questions.go("back").line in (3, 4, 5, 6)


def test_a_program_that_fails_ends_where_it_fails(questions: Questions) -> None:
    ready = questions.ready(HITS.replace("OPENI\nMOVE safe", "OPENI\nMOVE nowhere"))
    assert (ready.ended.why, ready.ended.line) == ("error", 5)
    assert "`nowhere` has no value" in ready.ended.text
    end = questions.go("run")
    assert (end.why, end.line, end.program) == ("error", 5, "main")
    assert any("nowhere" in problem.message for problem in ready.problems)
    assert ready.mark is not None
    assert ready.mark.mark == 0.0


def test_what_waits_for_an_operator_ends_as_it_does_offline() -> None:
    questions = Questions()
    asks = questions.ready('.PROGRAM main()\n  PROMPT "how many", n\n  TYPE n\n.END\n')
    assert (asks.ended.why, asks.ended.line) == ("limit", 2)
    assert "waits for an answer that nobody gives" in asks.note
    pauses = questions.ready(".PROGRAM main()\n  TYPE 1\n  PAUSE\n  TYPE 2\n.END\n")
    assert (pauses.ended.why, pauses.ended.line) == ("paused", 3)
    assert questions.go("end").typed == (" 1",)


def test_what_does_not_compile_is_refused_with_places(questions: Questions) -> None:
    refused = questions.rehearse(HITS.replace("MOVE ", "MOVEE "))
    assert isinstance(refused, Refused)
    first = refused.problems[0]
    assert (first.line, first.column, first.end_line, first.end_column) == (5, 1, 5, 6)
    assert (first.code, first.help) == ("V120", "did you mean `MOVE`?")
    assert refused.message == "line 5: `MOVEE` is not an instruction"
    for text, words in (
        ("", "is empty"),
        ("\ud800", "has no meaning"),
        (".PROGRAM\n", "line 1"),
        ("MOVE " * 30_000, "a line of 150,000 characters"),
        ("(" * 100_000, "a line of 100,000 characters"),
        (".PROGRAM a()\n" + "(" * 250 + "\n.END\n", "line 2"),
        (".REALS\nx 1\n.END\n", "this file holds no program"),
    ):
        refused = questions.rehearse(text)
        assert isinstance(refused, Refused), text[:20]
        assert words in refused.message, refused
        assert len(refused.problems) <= 100
    assert questions.ready(HITS).mark is not None


@pytest.mark.skipif(not CAN, reason="this system cannot tell how much of the processor is used")
def test_what_takes_too_much_computing_is_given_up_and_what_was_run_is_shown(
    questions: Questions, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(begun, "CHECK_S", 0.002)
    ready = questions.ready(HITS)
    assert (ready.note, ready.undetermined) == (begun.NOT_CHECKED, True)
    assert (ready.contacts, ready.mark, ready.ended.why) == ((), None, "completed")
    assert questions.go("end").typed == ("finished",)
    monkeypatch.setattr(begun, "RUN_S", 0.002)
    long = ".PROGRAM main()\n" + "".join(f"  x = {k}\n" for k in range(4000)) + ".END\n"
    refused = questions.rehearse(long)
    assert isinstance(refused, Refused)
    assert refused.message == begun.TOO_LONG
    monkeypatch.undo()
    assert questions.ready(HITS).mark is not None
