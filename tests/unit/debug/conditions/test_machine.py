"""What is asked of the machine itself is told by what was noted of it, and not by forks."""

import random

import pytest

from tests.support_engine import driven
from tests.support_programs import compiled, robot_alone
from vrts.debug.breakpoints import Breakpoint
from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Interrupted, nobody
from vrts.debug.debugger import Debugger, Why
from vrts.debug.passages import Instant, Passages
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.commands import StartProcess
from vrts.lang.dialect import DIALECTS
from vrts.scene.model import Scenario

READING = """.PROGRAM main()
 PCEXECUTE watch, -1
 n = 2
 TIMER n = 0.5
 SPEED 40 ALWAYS
 FOR k = 1 TO 3
  SPEED 20+k
  sp = SPEED(3)
  MOVE far
  s2 = STATE(2)
  SET goal = DEST
  SET #goal = #DEST
  in = INRANGE(SHIFT(far BY 300*k, 0, 0))
  r1 = RANDOM()
  r2 = RANDOM()+RANDOM()
  ad = ADC(1)
  pr = PRIORITY
  own = STATUS("main")
  other = STATUS("watch")
  er = ERROR()
  fr = FREE(0)
  tm = TIMER(n)
  pa = PARAMETER(HAND.TIME)
  told = TAS(flag, k)
  cast = CAS(flag, k, -k)
  $w = $DECODE($list, ",", 0)
  PARAMETER HAND.TIME = 0.1*k
  MOVE near
  BREAK
  sr = STATE(2)
 END
.END
.PROGRAM watch()
 pown = STATUS("watch")
 pother = STATUS("main")
 ppr = PRIORITY
 ps2 = STATE(2)
 pr1 = RANDOM()
 ptm = TIMER(n)
 seen = seen+1
 WAIT TIMER(0) > seen/5
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 -300 0 90 90 0
.END
.REALS
seen 0
flag 7
n 1
.END
.STRINGS
$list "a,b,c,d,e,f"
.END
"""
WORDS = """sp s2 sr goal #goal in r1 r2 ad pr own other er fr tm pa told cast $w
pown pother ppr ps2 pr1 ptm"""
READ = WORDS.split()


def reading() -> Run:
    scenario = Scenario(analog=((0.0, 1, 5), (2.0, 1, 17), (4.0, 1, 3)))
    return execute(compiled(READING, "val2+"), robot_alone(), scenario)


@pytest.mark.thorough
def test_what_the_machine_tells_is_what_the_program_itself_reads_there() -> None:
    run = reading()
    d = Debugger(run, DIALECTS["val2+"])
    known = Expressions(run, d.dialect)
    values: dict[str, set[object]] = {}
    asked: list[tuple[str, str, bool, int]] = []
    for process in (False, True):
        passages = d.passages(process=process)
        for k in range(passages.count):
            name, equals, text = passages.cause(k).span.text.partition(" = ")
            name = name.strip().removeprefix("SET ")
            if equals and name in READ:
                asked.append((name, text, process, k))
    asked += random.Random(1).sample(asked, 10)  # and backward
    for name, text, process, k in asked:
        passages = d.passages(process=process)
        trace = (run.history.process if process else run.history.robot).trace
        at = passages.instant(k)
        expression = known.of(text)
        value = expression.value(at, trace.activation(at.finished), nobody, process=process)
        after = run.at_statement(int(passages.before[k]) + 1).variables[name]
        assert value == after, (name, text, at)
        assert expression.forks == 0
        values.setdefault(name, set()).add(value)
    assert set(values) == set(READ)
    several = {name for name in values if len(values[name]) > 1}
    assert several >= {"sp", "in", "r1", "ad", "tm", "pa", "told", "cast", "$w"}
    assert (values["s2"], values["sr"]) == ({1.0}, {0.0})


def test_breakpoints_stop_where_the_machine_is_as_they_ask_and_the_run_stays_as_it_was() -> None:
    run = reading()
    before = run.events, run.at(run.horizon_s).variables
    d = Debugger(run, DIALECTS["val2+"])
    line = next(
        number for number, text in enumerate(READING.splitlines(), 1) if "s2 = STATE(2)" in text
    )
    name = d.passages(process=False).cause(0).span.source.name
    for condition, stops in {
        "STATE(2) == 1": 3,
        '(STATUS("main") == 1) AND (SPEED(3) == 40)': 3,
        "(DISTANCE(DEST, far) < 0.01) AND (PRIORITY == 0)": 3,
        "(TAS(flag, 9) == 7) OR (RANDOM() < 0)": 1,
        "PARAMETER(HAND.TIME) > 0.15": 2,
        "ADC(1) <> 5": 2,
    }.items():
        d.restart()
        d.wishes.lines = [Breakpoint(1, name, line, condition=condition)]
        instants: list[Instant] = []
        while (stop := d.go_on()).why is Why.BREAKPOINT:
            assert not stop.text, (condition, stop.text)
            instants.append(stop.instant)
        backward: list[Instant] = []
        while (stop := d.reverse()).why is Why.BREAKPOINT:
            backward.append(stop.instant)
        assert len(instants) == stops, condition
        assert backward == instants[::-1], condition
    assert (run.events, run.at(run.horizon_s).variables) == before


def test_somebody_is_heard_between_blocks_and_it_goes_on_afterwards() -> None:
    program = ".PROGRAM main()\n n = 0\n10 n = n+1\n IF n < 20000 GOTO 10\n.END\n"
    d = Debugger(execute(compiled(program), robot_alone()), DIALECTS["val2"])
    name = d.passages(process=False).cause(0).span.source.name
    d.wishes.lines = [Breakpoint(1, name, 3, condition="SPEED(1)+n == 20099")]
    heard: list[int] = []

    def hear() -> None:
        heard.append(1)
        if len(heard) == 10:
            raise Interrupted

    d.hear = hear
    begin = d.at
    with pytest.raises(Interrupted):
        d.go_on()
    assert d.at == begin
    stop = d.go_on()
    assert (stop.why, stop.text) == (Why.BREAKPOINT, "")
    assert d.state.variables["n"] == 19999.0


LATE = """.PROGRAM main()
 n = 1
 DELAY 3
 n = 2
 DELAY 1
.END
.PROGRAM watch()
 a = STATUS("main")
.END
"""


def test_who_begins_while_the_other_one_is_blocked_is_told_that_it_waits() -> None:
    starts = [(time_s, StartProcess("watch")) for time_s in (0.5, 1.0, 2.0, 3.5)]
    run = driven(LATE, 5.0, *starts)
    passages, known = Passages(run, process=True), Expressions(run, DIALECTS["val2"])
    expression, asked = known.of('STATUS("main")'), 0
    for k in range(passages.count):
        if passages.cause(k).span.text.startswith("a ="):
            asked += 1
            before = int(passages.before[k])
            at = Instant(run.history.time_of(before + 1), before)  # when it is executed
            after = run.at_statement(before + 1).variables["a"]
            assert expression.value(at, None, nobody, process=True) == after
    assert (asked, expression.forks) == (len(starts), 0)
