"""Whole processes as users start them: medians, printed.

Run by hand: `python -m pytest tests/bench/test_bench_cli.py -s`.
"""

import statistics
import subprocess
import sys
import time
from pathlib import Path

from tests.places import ROOT

SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
VRTS = Path(sys.executable).parent / "vrts"
ROUNDS = 9


def median(*words: str | Path) -> float:
    """Return the median time of a cold process [s]."""
    times: list[float] = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        subprocess.run([VRTS, *map(str, words)], capture_output=True, check=True, cwd=ROOT)
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def long_program(path: Path, rounds: int) -> Path:
    """Write a program of the cans scene that carries one can to and fro."""
    block = SOLUTION.read_text().partition(".LOCATIONS")[2]
    carry = SOLUTION.read_text().partition(".PROGRAM carry")[2].partition(".LOCATIONS")[0]
    path.write_text(
        ".PROGRAM main()\n SPEED 100 ALWAYS\n OPENI\n MOVE safe\n"
        f" FOR i = 1 TO {rounds}\n"
        "  CALL carry(can1_grip, base2_put)\n  CALL carry(base2_put, can1_grip)\n END\n"
        f".END\n.PROGRAM carry{carry}.LOCATIONS{block}"
    )
    return path


def test_cold_processes(tmp_path: Path) -> None:
    program = long_program(tmp_path / "long.v2", 6)
    hundred = tmp_path / "hundred.v2"
    hundred.write_text(".PROGRAM a\n" + " x = 1+2*3\n" * 98 + ".END\n")
    rows = {
        "vrts --help": ("--help",),
        "vrts compile, 100 lines": ("compile", hundred),
        "vrts verify, 60 s program": ("verify", program, "--scene", "cans-on-bases"),
        "the same with a recording": (
            "verify", program, "--scene", "cans-on-bases", "--record", tmp_path / "run.rrd"
        ),
    }  # fmt: skip
    for name, words in rows.items():
        print(f"\n{name:<28} {median(*words):.3f} s", end="")
    print()


def test_stages_in_a_warm_process(tmp_path: Path) -> None:
    from vrts.check.judge import judge
    from vrts.engine.controller import execute
    from vrts.pipeline.assess import assess
    from vrts.pipeline.requesting import request_for
    from vrts.pipeline.scenes import load_scene
    from vrts.report.page.page import page
    from vrts.report.picture.moments import moment_picture
    from vrts.report.recording import write_recording

    setting = load_scene("cans-on-bases")
    program = long_program(tmp_path / "long.v2", 6)
    found = assess(request_for(program, setting=setting))
    module, run = found.module, found.run
    assert module is not None
    assert run is not None
    times = [run.horizon_s * k / 2000 for k in range(2000)]
    stages = {
        "simulate": lambda: execute(module, setting.scene),
        "judge (collisions, limits)": lambda: judge(setting.scene, run, None),
        "write the recording": lambda: write_recording(found, tmp_path / "x.rrd"),
        "write the page": lambda: page(found, {}),
        "draw the moment": lambda: moment_picture(found),
        "2000 x Run.at(t), motion": lambda: [
            (state.configuration, state.hand_opening) for state in map(run.at, times)
        ],
    }
    print(f"\nprogram of {run.horizon_s:.1f} s, {len(run.timeline.segments)} segments")
    for name, stage in stages.items():
        stage()
        measured: list[float] = []
        for _ in range(ROUNDS):
            start = time.perf_counter()
            stage()
            measured.append(time.perf_counter() - start)
        print(f"{name:<28} {1000 * statistics.median(measured):8.2f} ms")
