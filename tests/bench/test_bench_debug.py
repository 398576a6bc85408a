"""What the debugger costs of a processor: conditions on lines that are passed often, and steps.

`python -m pytest tests/bench/test_bench_debug.py -s -p no:xdist`
"""

import itertools
from collections.abc import Callable
from time import process_time

from tests.bench.usual import slowness
from tests.support_programs import compiled, robot_alone
from vrts.debug.breakpoints import Breakpoint, Watch
from vrts.debug.debugger import Debugger, Stop, Way, Why
from vrts.debug.evaluating import evaluate
from vrts.engine.controller import execute
from vrts.lang.dialect import DIALECTS
from vrts.scene.model import Limits, Scenario

PASSES = 100_000
SLOW_PASSES = 100_000  # each takes a while
LOOP = f""".PROGRAM main()
 FOR n = 1 TO {PASSES}
  x = n*0.5
  a[2] = x
  CALL twice(n, m)
 END
.END
.PROGRAM twice(a, b)
 b = a*2
.END
"""
ENDLESS = ".PROGRAM main\n n = 0\n10 n = n+1\n WAIT n > 0\n GOTO 10\n.END\n"
MANY = """.PROGRAM main()
 FOR n = 1 TO 25000
  SIGNAL 5
  CALL sub(n)
  SIGNAL -5
 END
.END
.PROGRAM sub(a)
 SIGNAL 7
 SIGNAL -7
.END
"""
QUESTIONS = (
    "events",
    "events where signal = 7 and time > 3 and value = 1",
    'events where program = sub or text ~ "signal 5" by line down',
    "events signal first 10",
    "calls",
    "calls where depth > 1 and took >= 0 by took down",
    'calls where arguments ~ "a = 777"',
)
# what is asked of the machine, in a loop whose passes each take a while
MACHINE = (
    *("RANDOM() < 0", "TAS(x, 1) < -1", "CAS(x, 1, 2) < -1", '$DECODE($s, ",", 0) == "no"'),
    *("DX(DEST) < -5000", "DEXT(#DEST, 1) > 999", "INRANGE(far) < 0", "SPEED(3) < 0"),
    *("PARAMETER(HAND.TIME) < 0", "ADC(1) < 0", "PRIORITY < 0", "STATE(2) < 0"),
    *('STATUS("main") < -1', "ERROR() < 0", "FREE(0) < 0", "TIME() < 0", "TIMER(5) < -9"),
    "TIMER(t) < -9",
    "HAND+TIMER(1)+DISTANCE(HERE, far) < 0",
)
SLOW = f""".PROGRAM main()
 t = 5
 TIMER t = 0
 $s = "a,b"
 MOVE far
 FOR n = 1 TO {SLOW_PASSES}
  x = n*0.5
  DELAY 0.028
 END
.END
.LOCATIONS
far 700 300 0 90 90 0
.END
"""
WISHES = {
    "a condition on a real": Breakpoint(1, "main.v2", 3, condition="n == 100000"),
    "... with arithmetic": Breakpoint(1, "main.v2", 4, condition="INT(x)+1 == 50001 AND n > 5"),
    "... on an element": Breakpoint(1, "main.v2", 5, condition="a[2] >= 50000"),
    "... on an argument": Breakpoint(1, "main.v2", 9, condition="a == 100000"),
    "... on a signal": Breakpoint(1, "main.v2", 3, condition="SIG(3) OR n == 100000"),
    "... on a timer and a place": Breakpoint(
        1, "main.v2", 3, condition="HAND+TIMER(1)+DISTANCE(HERE, NULL) < 0"
    ),
    "... never true": Breakpoint(1, "main.v2", 3, condition="n < 0"),
    "hits": Breakpoint(1, "main.v2", 3, hits="100000"),
    "a condition and hits": Breakpoint(1, "main.v2", 3, condition="n > 5", hits=">= 99990"),
    "a watch with a condition": Watch(1, "x", condition="x == 50000"),
    "a log point": Breakpoint(1, "main.v2", 3, log="n is {n}, x is {x+1}"),
}


def spent(d: Debugger) -> tuple[float, Stop]:
    before = process_time()
    stop = d.go_on()
    return process_time() - before, stop


def longest_deafness() -> tuple[Callable[[], float], Callable[[], None]]:
    """Return what tells the longest time [s] between two calls, and what is called."""
    calls = [process_time()]

    def longest() -> float:
        times = [*calls, process_time()]
        return max(after - before for before, after in itertools.pairwise(times))

    return longest, lambda: calls.append(process_time())


def test_conditions_on_a_hundred_thousand_passes() -> None:
    run = execute(compiled(LOOP, "val2+"), robot_alone())
    print(f"\n{run.statements:,} statements; behind each time the same on a usual machine")
    for words, wish in WISHES.items():
        d = Debugger(run, DIALECTS["val2+"])
        if isinstance(wish, Watch):
            d.wishes.watches = [wish]
        else:
            d.wishes.lines = [wish]
        slow = slowness()
        deaf, d.hear = longest_deafness()
        first, stop = spent(d)
        heard = f"heard after {deaf() * 1e3:.0f} ms at most"
        d.restart()
        again, _ = spent(d)
        times = f"{first:7.2f} s ({first / slow:.2f}), again {again:7.4f} s ({again / slow:.4f})"
        print(f"{words:28} {times}, {heard}, {stop.why.value} {stop.text}")
    d = Debugger(run, DIALECTS["val2+"])
    d.seek(run.horizon_s)
    before = process_time()
    for _ in range(20):
        evaluate(run, d.at, "n == 100000", d.dialect)
    print(f"{'one condition on a fork':28} {(process_time() - before) / 20 * 1e3:7.2f} ms")


def test_what_the_machine_tells_on_a_hundred_thousand_passes() -> None:
    limits = Limits(time_s=1e6)
    run = execute(compiled(SLOW, "val2+"), robot_alone(), Scenario(limits=limits))
    print(f"\n{run.statements:,} statements in {run.horizon_s:,.0f} s; as above")
    slow = slowness()
    for condition in MACHINE:
        d = Debugger(run, DIALECTS["val2+"])
        d.wishes.lines = [Breakpoint(1, "main.v2", 8, condition=condition)]
        deaf, d.hear = longest_deafness()
        first, stop = spent(d)
        assert (stop.why, stop.text) == (Why.END, ""), stop
        heard = f"heard after {deaf() * 1e3:.0f} ms at most"
        d.reverse()
        again, _ = spent(d)
        print(f"{condition:40} {first:7.2f} s ({first / slow:.2f}), again {again:.4f} s, {heard}")
    print("asked: 100,000 passes in 1 s on a usual machine")
    usual = f"(this machine: {slow:.2f} and {slowness():.2f} times slower)"
    print(f"asked: pause and cancel are heard in 50 ms {usual}")


def test_an_endless_loop_is_left() -> None:
    d = Debugger(execute(compiled(ENDLESS), robot_alone()), DIALECTS["val2"])
    d.wishes.lines = [Breakpoint(1, "main.v2", 3, condition="n < 0")]
    time_s, stop = spent(d)
    assert stop.why is Why.END
    print(f"\nan endless loop of {d.run.statements:,} statements: {time_s:.2f} s")


def test_steps() -> None:
    d = Debugger(execute(compiled(LOOP, "val2+"), robot_alone()), DIALECTS["val2+"])
    d.step(Way.INTO)
    before = process_time()
    for _ in range(1000):
        d.step(Way.INTO)
    for _ in range(1000):
        d.step_back()
    print(f"\na step: {(process_time() - before) / 2000 * 1e3:.3f} ms")


def test_tables_of_a_hundred_thousand_events() -> None:
    run = execute(compiled(MANY, "val2+"), robot_alone())
    print(f"\n{len(run.events):,} events")
    d = Debugger(run, DIALECTS["val2+"])
    for question in QUESTIONS:
        table, _, rest = question.partition(" ")
        before = process_time()
        found = d.tables.asked(table, rest, d.at)
        print(f"{question:62} {process_time() - before:6.2f} s, {found.total:,} rows")
