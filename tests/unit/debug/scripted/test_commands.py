"""Commands: what each does, what is refused, and what a script tells of it."""

import json
import threading
from pathlib import Path

import msgspec
import pytest

from tests.unit.debug.test_debugger import debugger
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.scripted.breaking import Asked, read_breakpoint, written
from vrts.debug.scripted.commander import DEEDS, carry_out
from vrts.debug.scripted.reading import LONGEST, TooMuch, commands_in, commands_of
from vrts.debug.scripted.script import performed
from vrts.debug.scripted.session import Done, Session
from vrts.debug.scripted.table import BY_WORD, COMMANDS
from vrts.debug.scripted.telling import MOST_LINES, as_text, json_line
from vrts.lang.vocabulary.commands import COMMANDS as MONITOR
from vrts.report.formats.debug_schema import Debugged


def session(tmp_path: Path, there: Debugger | None = None) -> Session:
    there = there or debugger()
    sources = {p.span.source.name: p.span.source for p in there.run.module.programs.values()}
    return Session(there, Console(there, tmp_path, tuple(sources.values())))


def said(session: Session, line: str) -> str:
    done = carry_out(session, line)
    assert done.ok, done
    return "\n".join(done.said)


def refused(session: Session, line: str) -> str:
    before = session.debugger.at, session.debugger.run
    done = carry_out(session, line)
    assert not done.ok, done
    assert (session.debugger.at, session.debugger.run) == before
    return "\n".join(done.said)


def test_every_command_of_the_table_is_there_and_four_words_are_also_of_the_monitor() -> None:
    assert {*DEEDS} == {entry.word for entry in COMMANDS}
    assert {word.lower() for word in MONITOR} & {*BY_WORD} == {"help", "next", "watch", "where"}


def test_going_stops_where_it_is_wished(tmp_path: Path) -> None:
    s = session(tmp_path)
    assert said(s, "break 5:n>2") == "line 5: stops, where n>2"
    place = carry_out(s, "continue").place
    assert place is not None
    assert (place.line, place.source, place.program) == (5, "n = n+1", "main")
    assert said(s, "print n") == "3"
    assert said(s, "assert n == 3") == "`n == 3` holds"
    assert "does not hold" in refused(s, "assert n == 4")
    assert said(s, "n*2") == "6"
    carry_out(s, "step into")
    assert said(s, "unbreak 5") == ""
    carry_out(s, "step back")
    assert s.debugger.at.time_s == place.time_s
    carry_out(s, "at end")
    assert s.debugger.at_end


def test_a_value_makes_another_future_and_restart_the_first(tmp_path: Path) -> None:
    s = session(tmp_path)
    first = s.debugger.run
    carry_out(s, "to 4")
    assert said(s, "set n = 3") == "n = 3"
    assert s.debugger.run is not first
    carry_out(s, "at end")
    assert said(s, "print n") == "4"
    assert said(s, "n = 7") == "7"
    carry_out(s, "restart")
    assert s.debugger.run is first


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("watch sen", "there is no `sen` here: `seen`"),
        ("watch i+1", "no name of a variable"),
        ("watch SIG(99)", "there is no signal 99"),
        ("break 5:n >", "a value is missing"),
        ("break 5:sen > 1", "there is no `sen` here: `seen`"),
        ("break 5:far", "a condition is a number"),
        ("break five", "a breakpoint is a line"),
        ("break 99", "no step of a program follows"),
        ("at noon", "takes a time"),
        ("at inf", "the run goes from 0"),
        ("step bakc", "takes one of"),
        ("stepp", "did you mean a command: `step`"),
        ("alarms conatct", "`contact`"),
        ("jump 15", "only a step of the program that is being executed"),
        ("answer 5", "waits for no line"),
        ("STORE x", "a script changes no file"),
        ("SPEED x", "has no value"),
        ("x = nosuch", "has no value"),
    ],
)
def test_what_cannot_be_is_refused_with_the_reason(tmp_path: Path, line: str, words: str) -> None:
    assert words in refused(session(tmp_path), line)
    assert not [*tmp_path.iterdir()]


def test_a_name_of_a_command_is_a_variable_where_it_is_given_a_value(tmp_path: Path) -> None:
    s = session(tmp_path)
    assert said(s, "stops = 5") == "5"
    assert said(s, "print stops") == "5"
    assert s.debugger.at.time_s == 0.0


ARRAYS = """\
.PROGRAM main
        FOR i = 1 TO 3
          a[i] = i*i
          CALL sub(a[i])
        END
.END
.PROGRAM sub(k)
        AUTO REAL c[3]
        c[2] = k
        c[3] = c[2]+1
.END
"""


def test_elements_of_arrays_stand_in_conditions_before_they_have_values(tmp_path: Path) -> None:
    s = session(tmp_path, debugger(ARRAYS))
    assert said(s, "break 4:DEFINED(a[2])")
    assert carry_out(s, "continue").place is not None
    assert said(s, "print i") == "2"
    assert said(s, "unbreak all") == ""
    assert said(s, "break 10:c[2] > 1")
    carry_out(s, "continue")
    assert said(s, "print c[2]") == "4"
    assert "both with and without an index" in refused(s, "break 4:a > 1")
    assert "no `q` here" in refused(s, "break 4:q[1] > 1")


def test_breakpoints_are_read_as_they_are_written() -> None:
    for parts in (
        ("", "", ""),
        ("n > 3", "", ""),
        ("a:b == 2", ">= 5", "n is {n}"),
        ("", "% 3", ""),
    ):
        assert read_breakpoint(written(12, *parts)) == Asked("", 12, *parts)
    assert read_breakpoint("other.v2:7") == Asked("other.v2", 7)


def test_commands_are_parted_and_remarks_left_out() -> None:
    found = commands_of(('step; $s = "a;b" ;; print $s', "why"))
    assert [line.text for line in found] == ["step", '$s = "a;b"', "print $s", "why"]
    lines = commands_in(b"\xef\xbb\xbf# first\n step\n\n  # more\nprint n\r\n")
    assert [(line.number, line.text) for line in lines] == [(2, "step"), (5, "print n")]
    with pytest.raises(TooMuch, match="line 1: a command has at most"):
        commands_in(b"x" * (LONGEST + 1))


def test_what_is_told_as_json_is_of_its_schema(tmp_path: Path) -> None:
    s = session(tmp_path)
    lines = commands_of(("watch n; break 6 log n is {n}; continue; continue; print n; print far",))
    lines += commands_of(("why; events all; stepp; state; where",))
    told = [json_line(k, done) for k, done in enumerate(performed(s, lines, 60.0), start=1)]
    assert all(one.isascii() and "\n" not in one for one in told)
    found = [msgspec.json.decode(one, type=Debugged) for one in told]
    assert [one["command"] for one in found] == [line.text for line in lines]
    assert (found[3]["stopped"]["why"], found[3].get("line")) == ("change", 6)
    assert found[4].get("value") == {"kind": "real", "value": 1.0}
    assert found[5].get("value") == {"kind": "pose", "value": [700.0, 300.0, 0.0, 90.0, 90.0, 0.0]}
    assert found[8]["ok"] is False
    assert json.loads(told[7])["events"][0]["text"] == "program main starts"


def test_the_log_of_a_breakpoint_is_told(tmp_path: Path) -> None:
    s = session(tmp_path)
    carry_out(s, "break 6 log n is {n}")
    done = carry_out(s, "continue")
    assert [row.text for row in done.log] == ["n is 1", "n is 2", "n is 3", "n is 4"]
    assert "n is 4" in as_text(done)


def test_much_is_cut() -> None:
    text = as_text(Done("print", said=["x"] * (MOST_LINES + 5)))
    assert text.endswith("and 5 lines more")
    assert len(text.splitlines()) == MOST_LINES + 2


def test_a_script_that_takes_too_long_ends_and_says_so(tmp_path: Path) -> None:
    s = session(tmp_path)
    waits = threading.Event()
    s.restart = lambda: str(waits.wait(3.0))
    lines = commands_of(("step; restart; step",))
    *first, last = performed(s, lines, 0.2)
    assert [done.command for done in first] == ["step"]
    assert (last.command, last.ok) == ("restart", False)
    assert "took longer than 0.2 s" in last.said[0]


def test_ctrl_c_ends_a_script(tmp_path: Path) -> None:
    s = session(tmp_path)

    def interrupted() -> str:
        raise KeyboardInterrupt

    s.restart = interrupted
    with pytest.raises(KeyboardInterrupt):
        list(performed(s, commands_of(("restart",)), 60.0))


def test_the_process_control_program_has_steps_of_its_own(tmp_path: Path) -> None:
    s = session(tmp_path)
    carry_out(s, "program process")
    place = carry_out(s, "step").place
    assert place is not None
    assert place.program == "watch"
    assert "there is no process control program" in refused(
        session(tmp_path, debugger(".PROGRAM main()\n n = 1\n.END\n")), "program process"
    )


def test_a_line_that_a_program_waits_for_is_answered(tmp_path: Path) -> None:
    s = session(tmp_path, debugger('.PROGRAM main()\n PROMPT "how many", n\n TYPE n\n.END\n'))
    carry_out(s, "at end")
    assert carry_out(s, "answer 5").ok
    carry_out(s, "at end")
    assert said(s, "print n") == "5"
