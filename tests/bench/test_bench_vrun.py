"""What saved runs cost: bytes, and the time to save and to load them."""

from statistics import median
from time import perf_counter

from tests.support_saved import SOLUTION, ask_everything
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.report.formats.run_csv import run_csv
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate

LOOP = b"""\
.PROGRAM main
  n = 0
  FOR i = 1 TO 25000
    n = n+i*2-1
    CALL add(n, 2, x)
    b[i MOD 7, 2] = x
    $s[i MOD 10] = "abc"
  END
.END
.PROGRAM add(a, b, c)
  AUTO d
  d = a+b
  c = d
.END
"""
ROUNDS = 5


def measured(name: str, text: bytes, setting: Setting) -> tuple[Simulated, bytes]:
    begin = perf_counter()
    found = simulate(Request(ProgramFile(text, "main.v2"), setting, Reading("val2+")))
    executing = perf_counter() - begin
    assert found.run is not None
    saving: list[float] = []
    loading: list[float] = []
    data = b""
    for _ in range(ROUNDS):
        begin = perf_counter()
        data = saved_bytes(found)
        saving.append(perf_counter() - begin)
        begin = perf_counter()
        load_run(data, "out.vrun")
        loading.append(perf_counter() - begin)
    statements = found.run.statements
    print(
        f"\n{name}: {statements:,} statements, {len(data):,} bytes"
        f" ({len(data) / statements:.1f} a statement); executed in {1e3 * executing:.0f} ms,"
        f" saved in {1e3 * median(saving):.0f} ms, loaded in {1e3 * median(loading):.0f} ms"
    )
    return found, data


def test_the_solution_of_the_first_example() -> None:
    found, data = measured("solution of example 01", SOLUTION, load_scene("cans-on-bases"))
    run = load_run(data, "out.vrun").run
    assert run is not None
    begin = perf_counter()
    ask_everything(run, 100)
    print(f"everything at 101 times and statements: {1e3 * (perf_counter() - begin):.0f} ms")
    begin = perf_counter()
    assert check_again(found) is None
    print(f"checked again in {1e3 * (perf_counter() - begin):.0f} ms")
    for rate in (50.0, 1000.0):
        begin = perf_counter()
        rows = sum(piece.count("\n") for piece in run_csv(run, rate))
        seconds = perf_counter() - begin
        print(f"table at {rate:.0f} Hz: {rows:,} rows, {1e6 * seconds / rows:.1f} us each")


def test_two_hundred_thousand_statements() -> None:
    found, _ = measured("loop with calls", LOOP, robot_alone())
    assert found.run is not None
    assert found.run.statements > 200_000
