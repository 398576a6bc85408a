"""What simulating costs: statements, motions, and looking at any moment of a run."""

import gc
import tracemalloc
from collections.abc import Callable
from statistics import median
from time import perf_counter

import numpy as np

from tests.bench.tree_walk import walk
from tests.support_programs import ROOT, cans, compiled
from vrts.engine.batch import batch_of
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.scene.default import robot_alone
from vrts.scene.model import Limits, Scenario

SOLUTION = (ROOT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8")
THERE = "        CALL carry(can1_grip, base2_put)\n        CALL carry(can2_grip, base1_put)\n"
BACK = "        CALL carry(base2_put, can1_grip)\n        CALL carry(base1_put, can2_grip)\n"
PATIENT = Scenario(limits=Limits(statements=20_000_000, time_s=7200.0))

SCALAR = """.PROGRAM main()
        n = 0
        FOR i = 1 TO 50000
            n = n+i*2-1
            x = n/3
        END
.END
"""
MIX = """.PROGRAM main()
        ; arrays, arguments by reference, conditions, a reaction armed
        REACT 1001, alarm
        total = 0
        FOR lap = 1 TO 400
            CALL work(a[], total, lap)
        END
.END
.PROGRAM work(v[], sum, k)
        FOR i = 0 TO 49
            v[i] = v[i]+k*0.5
            IF v[i] > 100 THEN
                v[i] = v[i]-100
            END
            sum = sum+v[i]-i
            IF sum > 1000 GOTO 10
            count = count+1
 10         IF i MOD 2 == 0 THEN
                last = sum
            END
        END
        sum = sum/2
.END
.PROGRAM alarm()
.END
"""
MIX_DATA = ".REALS\ncount 0\n" + "".join(f"a[{k}] {k}\n" for k in range(50)) + ".END\n"
RECORDED = """.PROGRAM main()
        FOR i = 1 TO 4000
            n = i*2
            a[i MOD 100] = n
            x = n-i
            IF n > 5 THEN
                y = x
            END
            k = k+1
            IF k == 20 THEN
                SET here.now = SHIFT(home BY n,i,0)
                $t = $ENCODE(/I0, n)
                k = 0
            END
        END
.END
.LOCATIONS
home 900 0 100 90 90 0
.END
.REALS
k 0
.END
"""


def timed(work: Callable[[], object], rounds: int = 5) -> float:
    """Return the median time of some work [s]."""
    found: list[float] = []
    for _ in range(rounds):
        begin = perf_counter()
        work()
        found.append(perf_counter() - begin)
    return median(found)


def run_of(module: Module) -> Run:
    run = execute(module, robot_alone(), PATIENT)
    assert run.findings == ()
    return run


def test_statements() -> None:
    for name, text in (("scalars", SCALAR), ("the mix", MIX + MIX_DATA)):
        module = compiled(text)
        statements = run_of(module).statements
        rates = {"engine": 0.0, "tree walk": 0.0}
        engine: list[float] = []
        tree: list[float] = []
        for _ in range(5):  # in turns: the machine is shared
            engine.append(timed(lambda module=module: run_of(module), 1))
            tree.append(timed(lambda module=module: walk(module), 1))
        rates = {"engine": statements / median(engine), "tree walk": walk(module) / median(tree)}
        print(
            f"\n{name}: {rates['engine'] / 1e6:.2f} million statements/s of {statements:,}"
            f" (a plain tree walk, without ticks, limits, history: "
            f"{rates['tree walk'] / 1e6:.2f} million;"
            f" ratio {rates['engine'] / rates['tree walk']:.1f})"
        )


def test_memory_of_a_statement() -> None:
    module = compiled(RECORDED)
    execute(module, robot_alone(), PATIENT)
    gc.collect()
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    run = execute(module, robot_alone(), PATIENT)
    gc.collect()
    used = tracemalloc.get_traced_memory()[0] - before
    tracemalloc.stop()
    assert run.findings == ()
    print(f"\n{used / run.statements:.1f} bytes a statement of {run.statements:,}")
    assert used / run.statements <= 64.0


def test_an_hour_of_motions() -> None:
    lines = [
        "APPRO a, 100",
        "MOVES a",
        "DEPARTS 100",
        "APPRO b, 80",
        "MOVES b",
        "MOVES c",
        "MOVE d",
    ]
    body = "\n".join(f"{line}{'' if k % 3 else chr(10) + 'BREAK'}" for k, line in enumerate(lines))
    laps = 143
    text = (
        f".PROGRAM main()\nSPEED 8 ALWAYS\nFOR i = 1 TO {laps}\n{body}\nEND\n.END\n.LOCATIONS\n"
        "a 900 400 -100 90 90 0\nb 800 -400 -200 90 90 0\n"
        "c 900 0 200 80 80 10\nd 700 500 200 90 90 0\n.END\n"
    )
    module = compiled(text)
    run = run_of(module)
    assert len(run.motions) >= 1000
    assert run.ended_s is not None
    blended = sum(motion.blended for motion in run.motions)
    seconds = timed(lambda: run_of(module), 3)
    print(
        f"\n{len(run.motions)} motions, {blended} corners rounded, {run.ended_s / 60:.0f} min of"
        f" robot time, {len(run.timeline.segments):,} segments: {seconds:.2f} s"
    )


def test_a_minute_of_carrying_cans() -> None:
    assert THERE in SOLUTION
    module = compiled(SOLUTION.replace(THERE, (THERE + BACK) * 3))
    scene = cans()
    run = execute(module, scene)
    assert run.findings == ()
    assert run.ended_s is not None
    ms = 1e3 * timed(lambda: execute(module, scene))
    print(
        f"\n{run.ended_s:.1f} s of carrying: {ms:.1f} ms, {60 * ms / run.ended_s:.1f} ms a minute"
    )
    times = [k * run.horizon_s / 2000 for k in range(2001)]
    run.at(0.0).configuration  # noqa: B018 -- the timeline is worked out once
    for name in ("configuration", "velocity", "X_WT", "poses", "cause"):
        begin = perf_counter()
        for time_s in times:
            getattr(run.at(time_s), name)
        print(f"Run.at(t).{name}: {1e6 * (perf_counter() - begin) / len(times):.1f} us")
    many = np.linspace(0.0, run.horizon_s, 10_000)
    batch_of(run.timeline).values(many)
    begin = perf_counter()
    batch_of(run.timeline).values(many)
    print(f"10,000 times at once: {1e6 * (perf_counter() - begin) / len(many):.2f} us each")


def test_the_state_of_a_program() -> None:
    text = ".PROGRAM main()\nFOR i = 1 TO 20000\na[i MOD 200] = i\nEND\n.END\n"
    run = run_of(compiled(text))
    states = [run.at_statement(k * run.statements // 500) for k in range(500)]
    begin = perf_counter()
    for state in states:
        state.variables  # noqa: B018
    us = 1e6 * (perf_counter() - begin) / len(states)
    print(f"\nall {len(states[-1].variables)} variables after any statement: {us:.1f} us")
    cell = run.history.memory.bound[0]
    begin = perf_counter()
    for state in states:
        cell.at(state.finished)  # type: ignore[union-attr]
    print(f"one variable: {1e6 * (perf_counter() - begin) / len(states):.2f} us")
