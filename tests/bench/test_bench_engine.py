"""What simulating costs."""

from statistics import median
from time import perf_counter

from tests.support_programs import ROOT, cans, compiled
from vrts.engine.controller import execute
from vrts.scene.default import robot_alone
from vrts.scene.model import Limits, Scenario

SOLUTION = (ROOT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8")
THERE = "        CALL carry(can1_grip, base2_put)\n        CALL carry(can2_grip, base1_put)\n"
BACK = "        CALL carry(base2_put, can1_grip)\n        CALL carry(base1_put, can2_grip)\n"
STATEMENTS = 300_000


def test_a_minute_of_carrying_cans() -> None:
    assert THERE in SOLUTION
    module = compiled(SOLUTION.replace(THERE, (THERE + BACK) * 3))
    scene = cans()
    seconds: list[float] = []
    run = execute(module, scene)
    for _ in range(5):
        begin = perf_counter()
        execute(module, scene)
        seconds.append(perf_counter() - begin)
    assert run.findings == ()
    assert run.ended_s is not None
    ms = 1e3 * median(seconds)
    print(
        f"\n{run.ended_s:.1f} s of carrying: {ms:.1f} ms, {60 * ms / run.ended_s:.1f} ms a minute"
    )
    times = [k * run.horizon_s / 2000 for k in range(2001)]
    run.at(0.0).configuration  # noqa: B018 -- the timeline is worked out once
    begin = perf_counter()
    for time_s in times:
        run.at(time_s).configuration  # noqa: B018
    print(f"Run.at(t).configuration: {1e6 * (perf_counter() - begin) / len(times):.1f} us")
    begin = perf_counter()
    for time_s in times:
        run.at(time_s).poses  # noqa: B018
    print(f"Run.at(t).poses: {1e6 * (perf_counter() - begin) / len(times):.1f} us")


def test_statements_of_a_scalar_loop() -> None:
    body = f"n = 0\nFOR i = 1 TO {STATEMENTS // 4}\nn = n+i*2-1\nx = n/3\nEND"
    module = compiled(f".PROGRAM main\n{body}\n.END\n")
    scenario = Scenario(limits=Limits(statements=10_000_000))
    begin = perf_counter()
    run = execute(module, robot_alone(), scenario)
    seconds = perf_counter() - begin
    assert run.findings == ()
    print(f"\n{run.machine.statements / seconds / 1e6:.2f} million steps/s")
