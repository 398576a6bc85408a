"""A text that is saved while it is debugged: taken up, refused, and what stays where it was."""

import os
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_dap import Client
from tests.unit.debug.scripted.test_commands import refused, said, session
from vrts.debug.editing.lines import changed_lines, line_after
from vrts.debug.editing.text import take_up
from vrts.debug.opening import Asked, opened
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.session import Session

TEXT = """.PROGRAM main()
 x = 3
 MOVE far
 BREAK
 y = x+1
 MOVE near
 BREAK
 z = y*2
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 250 0 90 90 0
.END
"""


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "prog.v2"
    path.write_text(TEXT, encoding="utf-8")
    return path


def opened_session(program: Path) -> Session:
    found = opened(Asked(program))
    assert found.debugger is not None
    assert found.console is not None
    return Session(found.debugger, found.console)


def test_a_saved_text_is_taken_up_and_the_place_stays(program: Path) -> None:
    s = opened_session(program)
    carry_out(s, "break 8")
    carry_out(s, "to 5")
    before, at = s.debugger.run, s.debugger.at
    program.write_text(TEXT.replace(" MOVE near", "; a note\n MOVE far"), encoding="utf-8")
    done = carry_out(s, "reload")
    assert done.ok, done
    assert done.said[0].startswith("2 lines from 6 to 7 changed: the first step that differs")
    assert s.debugger.at == at
    assert s.debugger.run is not before
    assert [point.line for point in s.debugger.wishes.lines] == [9]
    stop = carry_out(s, "continue").place
    assert stop is not None
    assert (stop.line, stop.source) == (9, "z = y*2")
    assert said(s, "print y") == "4"
    assert "BREAK" in said(s, "LISTP main")  # the console has the new program, too
    assert "future 1" in said(s, "undo")
    assert s.debugger.run is before


def test_a_step_that_differs_before_leads_to_the_same_time(program: Path) -> None:
    s = opened_session(program)
    carry_out(s, "at 2")
    program.write_text(TEXT.replace("x = 3", "x = 30"), encoding="utf-8")
    done = carry_out(s, "reload")
    assert "you stand at 2.000 s of the new future" in done.said[0]
    assert said(s, "print x") == "30"


def test_what_does_not_compile_is_told_and_changes_nothing(program: Path) -> None:
    s = opened_session(program)
    carry_out(s, "to 5")
    program.write_text(TEXT.replace("y = x+1", "y = (x+1"), encoding="utf-8")
    assert refused(s, "reload") == "line 5: `(` is never closed (V128); nothing has changed"
    program.unlink()
    assert "nothing has changed" in refused(s, "reload")
    program.write_text(TEXT, encoding="utf-8")
    assert refused(s, "reload") == "the text is as it was"


def test_a_text_that_an_editor_sends_is_no_news_when_it_is_saved(program: Path) -> None:
    s = opened_session(program)
    files = s.console.files
    assert files is not None
    for number in ("30", "31", "32"):  # saved after it was sent, as by itself; the last one before
        text = TEXT.replace("x = 3", f"x = {number}")
        if number == "32":
            program.write_text(text, encoding="utf-8")
        take_up(s.console, s.debugger, {str(program.resolve()): text})
        assert files.news() == ""
        program.write_bytes(text.replace("\n", "\r\n").encode("latin-1"))
        assert files.news() == ""
        assert files.stale  # `restart` begins with it
    program.write_text(TEXT.replace("x = 3", "x = 99"), encoding="utf-8")
    assert files.news().startswith("`prog.v2` has changed on disk: type `reload`")
    assert files.news() == ""
    os.utime(program, ns=(1, 1))  # written again as it was
    assert files.news() == ""


def test_a_run_from_nowhere_has_no_other_text(tmp_path: Path) -> None:
    assert "saved run" in refused(session(tmp_path), "reload")


def test_lines_are_found_again() -> None:
    assert line_after("a\nb\nc", "new\na\nb\nc", 2) == 3
    assert line_after("a\nb\nc", "a\nx\nc", 2) == 2
    assert line_after("a\nb\nc", "a", 3) == 1
    assert changed_lines({"f": "a\nb"}, {"f": "a\nc"}) == "line 2 changed"
    assert changed_lines({"f": "a\nb"}, {"f": "a"}) == "line 2 changed"


def test_an_editor_sends_its_text_and_goes_through_the_futures(program: Path) -> None:
    path = str(program)
    with Client() as client:
        client.ask("initialize")
        client.ask("launch", program=path)
        client.ask("setBreakpoints", source={"path": path}, breakpoints=[{"line": 8}])
        client.ask("configurationDone")
        sent = "; first\n" + TEXT.replace("x = 3", "x = 5")
        answer = client.ask("vrts/edit", path=path, text=sent)
        assert answer["success"], answer
        assert answer["body"]["branch"] == "2"
        assert client.ask("continue", threadId=1)["success"]
        while client.event("stopped")["reason"] != "breakpoint":
            pass
        frame = client.ask("stackTrace", threadId=1)["body"]["stackFrames"][0]
        assert frame["line"] == 9
        assert client.ask("evaluate", expression="y")["body"]["result"] == "6"
        broken = client.ask("vrts/edit", path=path, text=sent.replace("y*2", "(y*2"))
        assert not broken["success"]
        assert "is never closed" in broken["message"]
        strange = client.ask("vrts/edit", path="/nowhere.v2", text=TEXT)
        assert "no text of this program" in strange["message"]
        assert client.ask("vrts/name", name="five")["success"]
        assert client.ask("vrts/undo")["body"]["branch"] == "1"
        typed = client.ask("evaluate", expression="branches", context="repl")["body"]["result"]
        assert typed.splitlines()[0] == "* 1: the program as it was opened"
        rows = client.ask("vrts/branches")["body"]["branches"]
        assert [(r["name"], r["by"], r["current"]) for r in rows] == [
            ("", "first", True),
            ("five", "text", False),
        ]
        assert client.ask("vrts/branch", name="five")["body"]["branch"] == "five"
        assert "clearance" in "\n".join(
            client.ask("vrts/compare", one="1", other="five")["body"]["rows"]
        )
    assert program.read_text(encoding="utf-8") == TEXT


def test_the_task_of_an_example_is_marked_in_both_futures(tmp_path: Path) -> None:
    example = ROOT / "examples" / "01-cans-on-bases"
    for file in example.iterdir():
        if file.is_file():
            (tmp_path / file.name).write_bytes(file.read_bytes())
    path = tmp_path / "solution.v2"
    s = opened_session(path)
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("MOVES goal", "MOVE start"), encoding="utf-8")
    carry_out(s, "reload")
    lines = said(s, "compare 1 2").split("\n")
    assert lines[1].split()[:4] == ["mark", "10", "of", "10"]
    assert lines[1].split()[4] != "10"
    assert any(line.startswith("lost") for line in lines)
