"""Expressions worked out from histories are what the controller itself answers, on a fork."""

import random
import re
from functools import cache

import pytest

from tests.laws import first
from tests.support_programs import compiled, robot_alone
from tests.unit.debug.conditions.support import told_both
from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Interrupted, nobody
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell, evaluate
from vrts.debug.frames import frames
from vrts.debug.passages import at_time
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.dialect import DIALECTS

TEXT = """.PROGRAM main()
 AUTO q1
 PCEXECUTE watch, -1
 $s = "abc"
 n = 0
 DO
  n = n+1
  TIMER 1 = 0
  q1 = n/3
  g[n] = n/7
  IF n == 3 THEN
   DISABLE UPPER
  END
  CALL twice(n, m)
  MOVE far
  BREAK
  SIGNAL 5
  TIMER 2 = 7.5
  SET p = SHIFT(far BY n, 0, 0)
  MOVE near
  BREAK
  SIGNAL -5, 2001
  z = 1/3
 UNTIL n >= 3
 TYPE "done", m
.END
.PROGRAM twice(a, b)
 AUTO n
 b = a*2
 n = b+0.1
 TYPE n
.END
.PROGRAM watch()
 WAIT SIG(5)
 seen = seen+1
 WAIT SIG(-5)
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 -300 0 90 90 0
#safe 0 -90 90 0 0 0
.END
.REALS
seen 0
.END
"""
WORDS = """
n m q1 g[n] g[2] g[n-1] z seen a b nosuch g far near p $s #safe pi main twice HERE
0 1 2.5 -3 1E20 0.1 "abc" "ABC" 16777217
INT({}) ABS({}) SQRT({}) SIG({}) TIMER({}) DISTANCE({},{}) DX({}) LEN({}) MAX({},{}) SIGN({}) \
LAST(g[]) DEFINED({}) BITS(1,4) $ENCODE({}) VAL({}) ASC({}) HAND SPEED(1) INRANGE({}) \
INVERSE({}) SWITCH(UPPER) \
TIMER(1) TIMER(2) TIMER(0) $TIME() PENDANT(1) $ERROR(-400) #HERE DISTANCE(HERE,{}) \
SIG(5) SIG(-5) SIG(2001) SIG(5,-3) PRIORITY
+ - * / == <> < <= > >= AND OR XOR MOD BAND ^ =
"""
MOVING = re.compile(r"TIMER|HAND|HERE|TIME")
NAMES, CONSTANTS, FUNCTIONS, OPERATORS = (row.split() for row in WORDS.strip().split("\n"))


@cache
def ran() -> Run:
    return execute(compiled(TEXT, "val2+"), robot_alone())


def there() -> Debugger:
    """Return a debugger of one's own: wherever others went, it stands before the first step."""
    return Debugger(ran(), DIALECTS["val2+"])


def expression(chance: random.Random, depth: int) -> str:
    kind = chance.random()
    if depth == 0 or kind < 0.35:
        return chance.choice(NAMES)
    if kind < 0.5:
        return chance.choice(CONSTANTS)
    inner = [expression(chance, depth - 1) for _ in range(2)]
    if kind < 0.75:
        return chance.choice(FUNCTIONS).format(*inner)
    if kind < 0.83:
        return f"{chance.choice(('-', 'NOT '))}{inner[0]}"
    return f"({inner[0]} {chance.choice(OPERATORS)} {inner[1]})"


@pytest.mark.parametrize("seed", first(1, range(8)))
def test_what_histories_tell_is_what_the_controller_tells(seed: int) -> None:
    d, chance = there(), random.Random(seed)
    known = Expressions(d.run, d.dialect)
    for _ in range(60):
        text = expression(chance, chance.choice((1, 2, 3)))
        process = chance.random() < 0.2
        passages = d.passages(process=process)
        at = passages.instant(chance.randrange(passages.count))
        inside = frames(d.run, at, process=process)
        activation = inside[0].activation if inside else None
        wanted, found = told_both(d, known, text, at, activation)
        if process and MOVING.search(text):
            continue  # a fork goes on in the next tick there: what programs read is tested below
        assert repr(found) == repr(wanted), (text, at, process)


READING = """.PROGRAM main()
 PCEXECUTE watch, -1
 TIMER 1 = 0
 FOR n = 1 TO 3
  OPENI
  MOVE far
  CALL look(n)
  CLOSEI
  TIMER 2 = 1.5
  MOVE near
  CALL look(n)
 END
.END
.PROGRAM look(n)
 t = TIMER(1)+100*TIMER(2)+TIMER(3)
 h = HAND
 d = DISTANCE(HERE, far)
 s = SWITCH(UPPER)
 SET #q = #HERE
 $w = $TIME()
.END
.PROGRAM watch()
 k = k+1
 pt = TIMER(1)+100*TIMER(2)+TIMER(3)
 ph = HAND
 pd = DISTANCE(HERE, far)
 IF k < 60 THEN
  WAIT TIMER(1) > k/10
 END
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 -300 0 90 90 0
.END
.REALS
k 0
.END
"""


def test_what_moves_is_what_the_program_itself_reads_there() -> None:
    run = execute(compiled(READING, "val2+"), robot_alone())
    d = Debugger(run, DIALECTS["val2+"])
    known = Expressions(run, d.dialect)
    seen: set[str] = set()
    for process in (False, True):
        passages = d.passages(process=process)
        for k in range(passages.count):
            name, equals, text = passages.cause(k).span.text.partition(" = ")
            name = name.strip().removeprefix("SET ")
            if not equals or not MOVING.search(text):
                continue
            at = passages.instant(k)
            expression = known.of(text)
            value = expression.value(at, None, nobody)
            after = run.at_statement(int(passages.before[k]) + 1).variables[name]
            assert value == after, (name, at)
            assert expression.forks == 0
            seen.add(name)
    assert seen == {"t", "h", "d", "#q", "$w", "pt", "ph", "pd"}


@pytest.mark.parametrize("text", ["TIMER(1)", "TIMER(2)"])
def test_a_timer_that_is_worked_out_is_what_the_machine_tells(text: str) -> None:
    program = ".PROGRAM main()\n n = 1\n TIMER n = 0.5\n DELAY 1\n TYPE n\n.END\n"
    d = Debugger(execute(compiled(program), robot_alone()), DIALECTS["val2"])
    at = d.passages(process=False).instant(3)
    expression = Expressions(d.run, d.dialect).of(text)
    assert expression.value(at, None, nobody) == evaluate(d.run, at, text, d.dialect)
    assert expression.forks == 0


def test_numbers_have_the_precision_of_the_controller() -> None:
    d = there()
    d.seek(d.run.horizon_s)
    known = Expressions(d.run, d.dialect)
    assert known.of("z == 0.3333333").value(d.at, None, nobody) == 0.0
    assert known.of("z == 1/3").value(d.at, None, nobody) == -1.0
    assert known.of("z*3").value(d.at, None, nobody) == 1.0
    assert known.of("16777216+1").value(d.at, None, nobody) == 16777216.0


def test_an_automatic_variable_without_a_value_hides_a_global_one() -> None:
    d = there()
    passages = d.passages(process=False)
    entered = next(
        at
        for at in map(passages.instant, range(passages.count))
        if frames(d.run, at, process=False)[:1]
        and frames(d.run, at, process=False)[0].cause.program == "twice"
    )
    inside = frames(d.run, entered, process=False)[0]
    with pytest.raises(CannotTell, match="no value"):
        Expressions(d.run, d.dialect).of("n+0").value(entered, inside.activation, nobody)
    with pytest.raises(CannotTell, match="no value"):
        evaluate(d.run, entered, "n+0", d.dialect, inside.seen(d.run, entered))


def test_who_asks_the_controller_is_heard_before_and_what_it_says_is_remembered() -> None:
    d = there()
    asked: list[int] = []
    timer = Expressions(d.run, d.dialect).of("TIMER(1)")
    at, later = (at_time(d.run, ticks * d.run.history.tick_s) for ticks in (4.5, 5.5))

    def hear() -> None:
        asked.append(1)

    first = timer.value(at, None, hear)
    before = len(asked)
    assert (before > 0, timer.forks) == (True, 1)
    assert timer.value(at, None, hear) == first
    assert (len(asked), timer.forks) == (before, 1)

    def leave() -> None:
        raise Interrupted

    with pytest.raises(Interrupted):
        timer.value(later, None, leave)
    assert timer.value(later, None, nobody) > first  # type: ignore[operator]
