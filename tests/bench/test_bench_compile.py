"""Compiling 100 lines from a cold process: at most 0.30 s, and no heavy library."""

import statistics
import subprocess
import sys
import time
from pathlib import Path

from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source

HEAVY = ("numpy", "pinocchio", "coal", "fcl", "trimesh", "rerun", "lark")
LIMIT_S = 0.30
RUNS = 11

STEPS = """        APPRO part, 50
        SPEED 30
        MOVES part:TRANS(0,0,n*10,90,-90,0)
        CLOSEI
        DEPARTS 50
        IF (n > 2) AND SIG(1001) THEN
            TYPE "part", /I3, n
        END
        n = n+1
"""
PROGRAM = (
    ".PROGRAM main\n        n = 0\n" + STEPS * 11 + ".END\n"
    ".LOCATIONS\npart            450 -120 -50 90 90 0\n.END\n"
)
IN_PROCESS = f"""
import sys
from pathlib import Path
from vrts.lang.compiler import compile_source
from vrts.lang.reading import decode
path = Path(sys.argv[1])
assert compile_source(decode(path.read_bytes(), path.name)).module is not None
heavy = sorted(set({HEAVY!r}) & set(sys.modules))
assert not heavy, heavy
"""


def median(command: list[str]) -> float:
    times: list[float] = []
    for _ in range(RUNS):
        began = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        times.append(time.perf_counter() - began)
    return statistics.median(times)


def test_cold_process(tmp_path: Path) -> None:
    path = tmp_path / "program.v2"
    path.write_text(PROGRAM, "utf-8")
    library = median([sys.executable, "-c", IN_PROCESS, str(path)])
    command = Path(sys.executable).with_name("vrts")
    whole = median([str(command), "compile", str(path)])
    print(f"\ncompile 100 lines, cold: library {library:.3f} s, `vrts compile` {whole:.3f} s")
    assert whole <= LIMIT_S


def test_lines_per_second() -> None:
    text = PROGRAM.replace(STEPS, STEPS * 100, 1)
    lines = text.count("\n")
    source = SourceFile("long.v2", text)
    began = time.perf_counter()
    assert compile_source(source).module is not None
    seconds = time.perf_counter() - began
    print(f"\n{lines} lines in {seconds:.3f} s: {lines / seconds:,.0f} lines/s")
