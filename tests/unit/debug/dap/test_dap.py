"""The debug adapter as editors use it: over pipes, forward and backward."""

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import pytest

from tests.support_dap import Client
from tests.support_framing import framed
from tests.support_programs import ROOT
from tests.unit.debug.test_debugger import TEXT
from vrts.debug.dap.framing import Incoming, Malformed

HITS = ROOT / "examples/01-cans-on-bases/submissions/hits-base.v2"
EXAMPLES = sorted((ROOT / "examples").glob("*/solution.v2"))
FIRST_AND_OTHERS = [
    pytest.param(path, id=path.parent.name, marks=(pytest.mark.thorough,) if i > 0 else ())
    for i, path in enumerate(EXAMPLES)
]


@pytest.fixture
def client() -> Iterator[Client]:
    with Client() as made:
        yield made


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "loop.v2"
    path.write_text(TEXT)
    return path


def test_steps_and_breakpoints_go_both_ways(client: Client, program: Path) -> None:
    assert client.launch(program, [5], dialect="val2+")["reason"] == "entry"
    assert client.line() == 2
    assert client.go("continue")["reason"] == "breakpoint"
    assert (client.line(), client.value("n")) == (5, "0")
    assert client.go("next")["reason"] == "step"
    assert (client.line(), client.value("n")) == (6, "1")
    client.go("stepIn")
    trace = client.do("stackTrace", threadId=1)["stackFrames"]
    assert [frame["name"] for frame in trace] == ["twice, step 1", "main, step 5"]
    assert Path(trace[0]["source"]["path"]) == program
    client.go("stepOut")
    assert client.line() == 7
    for line in (15, 6, 5):
        client.go("stepBack")
        assert client.line() == line
    assert client.go("continue")["reason"] == "breakpoint"
    assert client.value("n+10") == "11"
    client.go("reverseContinue")
    assert client.value("n") == "0"
    assert client.go("reverseContinue")["reason"] == "entry"
    threads = client.do("threads")["threads"]
    assert [thread["name"] for thread in threads] == ["robot program", "process control program"]


def test_a_wait_of_the_other_program_is_stepped_by_itself(client: Client, program: Path) -> None:
    client.launch(program, dialect="val2+")
    client.go("next", threadId=2)
    stopped = client.go("next", threadId=2)
    assert stopped["threadId"] == 2
    assert client.line(2) == 21
    assert "5" in client.shown()["Signals"]["on"]["value"]


def test_the_first_contact_is_where_it_stops(client: Client) -> None:
    client.launch(HITS)
    client.do("setExceptionBreakpoints", filters=["contact"])
    stopped = client.go("continue")
    assert (stopped["reason"], stopped["threadId"]) == ("exception", 1)
    assert "base" in stopped["text"]
    told = client.do("exceptionInfo", threadId=1)
    assert told["exceptionId"] == "contact"
    assert "in line 11: APPROS base2_put, 60" in told["description"], "the line that caused it"
    assert "caused by line 11; the program is at line 12" in stopped["text"]
    top, present = client.do("stackTrace", threadId=1)["stackFrames"][:2]
    assert (top["line"], present["line"]) == (11, 12)
    assert "the cause; now at step" in top["name"]
    assert client.in_frame(top["id"], "DX(HERE)") == client.in_frame(present["id"], "DX(HERE)")
    time_s = float(client.shown()["Time"]["time"]["value"].split()[0])
    client.go("stepBack")
    assert client.line() == 11, "one step back stands on the cause"
    client.go("next")
    assert client.line() == 12, "one step forward goes on from it"
    client.go("stepBack")
    assert client.line() == 11
    assert float(client.shown()["Time"]["time"]["value"].split()[0]) < time_s
    assert "under way" in client.shown()["Time"]


def test_another_value_is_another_future(client: Client, program: Path) -> None:
    client.launch(program, [5], dialect="val2+")
    client.go("continue")
    reals = next(
        scope["variablesReference"]
        for scope in client.do("scopes", frameId=100_000)["scopes"]
        if scope["name"] == "Variables"
    )
    client.do("variables", variablesReference=reals)
    given = client.do("setVariable", variablesReference=reals, name="n", value="1+2")
    assert given["value"] == "3"
    assert client.value("n") == "3"
    assert client.go("continue")["reason"] == "pause"
    assert client.output() == "done 8\n" or "8" in client.output()
    client.go("restart")
    assert client.go("continue")["reason"] == "breakpoint"
    assert client.value("n") == "0"


def test_a_location_is_given_as_it_is_shown(client: Client, program: Path) -> None:
    client.launch(program, [5], dialect="val2+")
    shown = client.shown()["Locations"]["far"]["value"]
    assert shown.split() == ["700", "300", "0", "90", "90", "0"]
    client.do("setExpression", expression="far", value=shown.replace("300", "310.5"))
    assert client.value("DY(far)") == "310.5"
    client.do("setExpression", expression="#p", value="0, -90, 90, 0, 0, 0")
    assert client.shown()["Locations"]["#p"]["value"].split() == ["0", "-90", "90", "0", "0", "0"]


def test_the_console_takes_commands_and_expressions(client: Client, program: Path) -> None:
    client.launch(program, [9], dialect="val2+")
    client.go("continue")
    assert client.value("DX(HERE)", "repl") == "700"
    assert "JT1" in client.value("WHERE", "repl")
    assert client.value("n = 3", "repl") == "3"
    client.event("invalidated")
    assert client.value("n", "repl") == "3"
    assert client.value("SPEED 50", "repl") == ""
    assert "50" in client.shown()["Arm"]["speed"]["value"]
    assert client.value("why n", "repl").startswith("`n` is 3")
    assert "the arm stands still" in client.value("why", "repl")
    assert "no value" in client.value("nosuch", "repl")
    assert "nobody" in client.value("nobody 5", "repl").lower() or client.value("!", "repl")


def test_data_breakpoints_and_log_points(client: Client, program: Path) -> None:
    client.launch(program, dialect="val2+")
    assert client.do("dataBreakpointInfo", name="nosuch")["dataId"] is None
    info = client.do("dataBreakpointInfo", name="seen")
    client.do("setDataBreakpoints", breakpoints=[{"dataId": info["dataId"]}])
    client.lines(program, 9, logMessage="n = {n}")
    stopped = client.go("continue")
    assert stopped["reason"] == "data breakpoint"
    assert stopped["text"] == "seen: 0 -> 1"
    client.do("threads")
    logged = [e["body"]["output"] for e in client.events if e["event"] == "output"]
    assert any("n = 1" in text for text in logged)


def test_ticks_goto_and_targets(client: Client, program: Path) -> None:
    client.launch(program, [8], dialect="val2+")
    client.go("continue")
    before = client.shown()["Time"]["time"]["value"]
    client.go("next", granularity="instruction")
    assert client.shown()["Time"]["time"]["value"] != before
    client.go("stepBack", granularity="instruction")
    assert client.shown()["Time"]["time"]["value"] == before
    client.go("vrts.tick", count=1)
    assert client.event("continued")["allThreadsContinued"]
    assert client.shown()["Time"]["time"]["value"] != before
    client.go("vrts.tick", count=-1)
    assert client.shown()["Time"]["time"]["value"] == before
    targets = client.do("gotoTargets", source={"path": str(program)}, line=12)["targets"]
    assert client.go("goto", targetId=targets[0]["id"])["reason"] == "goto"
    assert client.line() == 12
    assert client.go("continue")["reason"] == "pause"
    found = client.do("breakpointLocations", source={"path": str(program)}, line=14, endLine=18)
    assert [place["line"] for place in found["breakpoints"]] == [15, 17, 18]


def test_without_debugging_it_runs_to_its_end(client: Client, program: Path) -> None:
    client.do("initialize")
    client.do("launch", program=str(program), dialect="val2+", noDebug=True)
    client.do("configurationDone")
    assert client.event("exited")["exitCode"] == 0
    client.event("terminated")
    assert client.output() == "done 8\n"


def test_a_program_that_waits_for_a_line_is_answered(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "ask.v2"
    path.write_text('.PROGRAM main\n PROMPT "how many? ", k\n TYPE k*2\n.END\n')
    client.launch(path)
    client.go("continue")
    client.value("21", "repl")
    client.go("continue")
    assert "42" in client.output()


@pytest.mark.parametrize("example", FIRST_AND_OTHERS)
def test_every_example_goes_forward_and_back(client: Client, example: Path) -> None:
    client.launch(example)
    client.do("setExceptionBreakpoints", filters=["contact", "run-time-error"])
    lines = [client.line()]
    times: list[str] = []
    for _ in range(12):
        if client.go("next")["reason"] == "pause":
            break
        lines.append(client.line())
        times.append(client.shown()["Time"]["time"]["value"])
    client.go("continue")
    client.go("reverseContinue")
    for _ in times:
        client.go("next")
    for k in range(len(times) - 1, 0, -1):
        client.go("stepBack")
        assert client.line() == lines[k]
        assert client.shown()["Time"]["time"]["value"] == times[k - 1]
    assert client.go("continue")["reason"] == "pause", "nothing touches anything"


def test_what_does_not_compile_is_told(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "bad.v2"
    path.write_text(".PROGRAM main\n MOVE\n.END\n")
    client.do("initialize")
    refused = client.ask("launch", program=str(path))
    assert not refused["success"]
    assert "line 2" in refused["message"]
    missing = client.ask("launch", program=str(tmp_path / "none.v2"))
    assert not missing["success"]
    assert "none.v2" in missing["message"]


def test_bad_messages_do_no_harm(client: Client, program: Path) -> None:
    assert not client.ask("next", threadId=1)["success"], "nothing is being debugged"
    client.launch(program, dialect="val2+")
    client.raw(b"Content-Length: 5\r\n\r\n{nope")
    assert "malformed" in client.event("output")["output"]
    client.raw(b"Content-Length: 2\r\n\r\n[]")
    for command, arguments in (
        ("nonsense", {}),
        ("__class__", {}),
        ("setBreakpoints", {"source": 5}),
        ("setBreakpoints", {"source": {"path": str(program)}, "breakpoints": [{"line": "x"}]}),
        ("variables", {"variablesReference": 99_999}),
        ("goto", {"targetId": -1}),
        ("evaluate", {"expression": "1/0"}),
        ("evaluate", {"expression": "x" * 5_000}),
        ("setVariable", {"variablesReference": 1, "name": "JT1", "value": "5"}),
    ):
        assert not client.ask(command, **arguments)["success"], command
    assert client.line() == 2, "and it still answers"


@pytest.mark.parametrize(
    "data",
    [
        b"Content-Length: -5\r\n\r\n",
        b"Content-Length: many\r\n\r\n{}",
        b"Content-Length: 999999999\r\n\r\n{}",
        b"no header\r\n\r\n",
        b"X-Long: " + b"x" * 3_000_000 + b"\r\n\r\n",
        b"\r\n\r\n",
    ],
)
def test_after_a_bad_header_it_goes_on(data: bytes) -> None:
    asked = framed({"seq": 1, "type": "request", "command": "initialize"})
    incoming = Incoming(BytesIO(data + asked + asked))
    with pytest.raises(Malformed):
        incoming.read_message()
    found = [incoming.read_message() for _ in range(3)]
    assert [message and message["command"] for message in found] == ["initialize"] * 2 + [None]


@pytest.mark.thorough
def test_it_is_heard_while_it_works_on_conditions(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "endless.v2"
    path.write_text(".PROGRAM main\n n = 0\n10 n = n+1\n WAIT n > 0\n GOTO 10\n.END\n")
    client.launch(path)
    client.raw(b"Content-Length: -5\r\n\r\n")
    client.lines(path, 3, condition="TIMER(1) < 0")
    client.do("continue", threadId=1)
    client.do("pause", threadId=1)
    assert client.event("stopped")["reason"] == "pause"
    assert client.line() == 2, "it stands where it stood"
    number = client.post("evaluate", expression="n", context="watch")
    client.do("cancel", requestId=number)
    client.lines(path, 3, condition="n == 100000")
    assert client.go("continue")["reason"] == "breakpoint"
    assert client.value("n").replace(",", "") == "100000"
    assert not any(event["event"] == "stopped" for event in client.events)


def test_it_ends_with_its_client(program: Path) -> None:
    client = Client()
    client.launch(program, dialect="val2+")
    assert client.leave() == 0
    other = Client()
    other.raw(b"x" * 10_000)
    assert other.leave() == 0


def test_a_program_that_changes_on_disk_is_debugged_as_it_was_until_restart(
    client: Client, program: Path
) -> None:
    client.launch(program, [5], dialect="val2+")
    text = program.read_text()
    program.write_text(text.replace("n < 4", "n < "))
    client.go("continue")
    told = [e["body"]["output"] for e in client.events if e["event"] == "output"]
    assert any("`loop.v2` has changed on disk" in words for words in told)
    assert client.line() == 5
    assert client.value("n") == "0"
    refused = client.ask("restart")
    assert not refused["success"]
    assert "line 4" in refused["message"]
    assert client.go("continue")["reason"] == "breakpoint", "it is still there, as it was"
    program.write_text(text.replace("n < 4", "n < 1"))
    assert client.go("restart")["reason"] == "entry"
    assert client.go("continue")["reason"] == "breakpoint", "wishes outlive a restart"
    assert client.go("continue")["reason"] == "pause", "the loop is entered once now"
    assert client.value("m") == "2"


LOCALS = """.PROGRAM main()
 AUTO k
 PCEXECUTE other, 2
 k = 7
 CALL inner(k)
 WAIT SIG(5)
.END
.PROGRAM inner(a)
 AUTO b
 b = a+1
 b = b+1
.END
.PROGRAM other()
 AUTO c
 c = c_begin
 c = c+1
 SIGNAL 5
.END
.REALS
c_begin 40
.END
"""


def test_each_program_has_its_own_variables(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "locals.v2"
    path.write_text(LOCALS)
    client.launch(path, [11], dialect="val2+")
    assert client.go("continue")["reason"] == "breakpoint"
    inner, outer = (f["id"] for f in client.do("stackTrace", threadId=1)["stackFrames"])
    assert client.in_frame(inner, "b+a") == "15"
    assert client.in_frame(outer, "k") == "7"
    refused = client.ask("evaluate", expression="b", frameId=outer, context="watch")
    assert not refused["success"]
    refused = client.ask("setExpression", expression="k", value="8", frameId=outer)
    assert "once `main` goes on" in refused["message"]
    client.lines(path, 17, condition="c == 41")
    stopped = client.go("continue")
    assert (stopped["reason"], stopped["threadId"]) == ("breakpoint", 2)
    other = client.do("stackTrace", threadId=2)["stackFrames"][0]["id"]
    names = [scope["name"] for scope in client.do("scopes", frameId=other)["scopes"]]
    assert names[0] == "Arguments and AUTO"
    given = client.do("setExpression", expression="c", value="c+1", frameId=other)
    assert given["value"] == "42"
    assert client.in_frame(client.do("stackTrace", threadId=2)["stackFrames"][0]["id"], "c") == "42"


def test_arguments_are_watched_in_the_call_that_is_looked_at(client: Client, program: Path) -> None:
    client.launch(program, [15], dialect="val2+")
    client.go("continue")
    client.go("continue")
    assert "there is no signal 99" in client.do("dataBreakpointInfo", name="SIG(99)")["description"]
    inner, outer = (f["id"] for f in client.do("stackTrace", threadId=1)["stackFrames"])
    assert client.do("dataBreakpointInfo", name="a", frameId=outer)["dataId"] is None
    info = client.do("dataBreakpointInfo", name="b", frameId=inner)
    assert info["description"] == "`b` of `twice`, in its 2nd call only"
    client.do("setBreakpoints", source={"path": str(program)}, breakpoints=[])
    client.do("setDataBreakpoints", breakpoints=[{"dataId": info["dataId"]}])
    stopped = client.go("continue")
    assert (stopped["reason"], stopped["text"]) == ("data breakpoint", "b: 2 -> 4")
    assert client.go("continue")["reason"] == "pause", "the other calls have a `b` of their own"


def test_changes_are_chosen_by_conditions_and_hits(client: Client, program: Path) -> None:
    client.launch(program, dialect="val2+")
    client.do("setDataBreakpoints", breakpoints=[{"dataId": "m", "condition": "m > 4"}])
    assert client.go("continue")["text"] == "m: 4 -> 6"
    client.go("restart")
    client.do("setDataBreakpoints", breakpoints=[{"dataId": "m", "hitCondition": "%2"}])
    stopped = client.go("continue")
    assert stopped["text"] == "m: 2 -> 4"
    assert len(stopped["hitBreakpointIds"]) == 1
    answer = client.do("setDataBreakpoints", breakpoints=[{"dataId": "m", "hitCondition": "x"}])
    assert not answer["breakpoints"][0]["verified"]


def test_it_says_what_of_a_client_it_does_not_understand(client: Client) -> None:
    assert not client.ask("initialize", linesStartAt1=False)["success"]
    assert not client.ask("initialize", pathFormat="uri")["success"]


@pytest.mark.thorough
def test_a_program_that_never_ends_is_over_and_can_be_asked(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "endless.v2"
    path.write_text(".PROGRAM main\n n = 0\n10 n = n+1\n WAIT n > 0\n GOTO 10\n.END\n")
    client.launch(path, scenario=None)
    stopped = client.go("continue")
    assert stopped["reason"] == "exception"
    assert "still running" in stopped["text"]
    client.go("stepBack")
    client.go("stepBack")
    assert int(client.value("n+0").replace(",", "")) > 1_000


def test_causes_are_asked_for_and_gone_to(client: Client, program: Path) -> None:
    client.launch(program, [9], dialect="val2+")
    client.go("continue")
    assert "line 5 `n = n+1`: 0 -> 1" in client.value("who n", "repl")
    client.value("go", "repl")
    client.event("stopped")
    assert client.value("n") == "0"
    (row,) = client.do("vrts/next", name="n")["rows"]
    assert (row["old"], row["new"], row["line"]) == ("0", "1", 5)
    client.do("vrts/go", time=row["go"]["time"], statements=row["go"]["statements"])
    client.event("stopped")
    assert client.value("n") == "1"
    (row,) = client.do("vrts/who", name="n")["rows"]
    assert row["source"]["path"] == str(program)
    assert client.do("vrts/why", name="n")["rows"][0]["line"] == 5
    assert not client.ask("vrts/who", name="nobody")["success"]
    assert not client.ask("vrts/who")["success"]


def test_events_and_calls_are_asked_and_gone_to(client: Client, program: Path) -> None:
    client.launch(program, dialect="val2+")
    found = client.do("vrts/events", query="where signal = 5")
    (row,) = found["rows"]
    assert (row["kind"], row["what"], row["line"]) == ("signal", "on", 9)
    assert row["source"]["path"] == str(program)
    assert {"name": "depth", "unit": "mm", "says": "how deep a contact gets"} in found["columns"]
    client.do("vrts/go", row=1)
    assert client.event("stopped")["text"] == "signal 5 on"
    assert client.line() == 9
    client.do("evaluate", expression="mark here", context="repl")
    rows = client.do("vrts/events", table="calls", query="where caller = main by from")["rows"]
    assert [each["program"] for each in rows] == ["twice"] * 4
    client.do("vrts/go", row=4)
    assert client.event("stopped")["reason"] == "goto"
    assert (client.line(), client.value("a")) == (15, "4")
    client.do("vrts/go", mark="here")
    client.event("stopped")
    assert client.line() == 9
    said = client.do("evaluate", expression="calls where line = 6 first 1", context="repl")
    assert "twice(a = 1, b = undefined)" in said["result"]
    said = client.do("evaluate", expression="link", context="repl")["result"]
    assert f"vscode://file{program}:9:" in said
    for wrong in ({"query": "where bodi = 3"}, {"table": "x"}, {"query": 5}, {"query": "x" * 501}):
        assert not client.ask("vrts/events", **wrong)["success"]
    assert not client.ask("vrts/go", row=99)["success"]
