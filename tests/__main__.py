"""Run the checks of the project: `python -m tests`.

Format, lint, types, types of the browser's modules (tsc by their JSDoc, as Deno has it), import
contracts, and beside them every test that is not thorough. Prints the time of each; exit status 0
when all pass. `python -m tests lint types` runs those stages only.

--all      also what is thorough: long tests, laws with all their examples, live sessions that need
           a machine with nothing else to do, and the patches of `tests/sabotage`, for 25 minutes
--rest     only what `--all` adds
--minutes=N  with these: end after about so many. Thorough tests that would begin later are
           skipped, the patches get what is left, and both say how many were not tried
--changed  only what the changes since the last commit can affect, the nearest tests first
--times    the CPU time of each stage and the 40 slowest tests; keeps the seconds of each file,
           from which the next runs know what to start first
"""

import math
import os
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import NamedTuple

from tests import changed, laws, times, until
from tests.places import ROOT
from tests.says_all import SAYS_ALL

BIN = Path(sys.executable).parent
PYTHON = sys.executable
WORKERS = str((os.cpu_count() or 1) + 2)  # many tests wait

WEB = ROOT / "vrts" / "web"
MODULES = sorted(str(p) for p in WEB.rglob("*.js") if WEB / "vendor" not in p.parents)

FIXED: dict[str, list[str]] = {  # what looks at the text only
    "format": [str(BIN / "ruff"), "format", "--check", "--quiet", "."],
    "lint": [str(BIN / "ruff"), "check", "--quiet", "."],
    "types": [str(BIN / "basedpyright"), "--level", "error", "--pythonpath", PYTHON],
    "imports": [str(BIN / "lint-imports"), "--no-cache"],
    "browser-types": [
        *(str(BIN / "deno"), "check", "--quiet", "--no-remote", "--no-npm"),
        *("--config", str(ROOT / "vrts" / "stubs" / "browser" / "deno.json"), *MODULES),
    ],
}
PYTEST = [PYTHON, "-m", "pytest"]
TESTS = {"tests": [*PYTEST, "-n", WORKERS]}
THOROUGH, PATCHES = "thorough", "sabotage"
MINUTES = "--minutes="  # what says how long
PATCHES_MIN = 25.0  # [min] that patches are tried for at most
ENDING_MIN = 2.0  # [min] that what has begun may need to end
REST: dict[str, list[str]] = {
    "live": [*PYTEST, "-p", "no:xdist", "-m", "live"],  # before what takes all the time there is
    THOROUGH: [*PYTEST, "-n", WORKERS, "-m", "thorough and not live"],
    PATCHES: [  # other stages see that without a patch all pass; a fast machine tries every one
        *("nice", "-n", "10", PYTHON, "-m", "tests.sabotage", "--passed", MINUTES),
    ],
}
STAGES = FIXED | TESTS | REST
COMPILED = ROOT / "tests" / "unit" / "__pycache__"  # not there: nobody has run a test here yet


class Ended(NamedTuple):
    """What became of a stage."""

    name: str
    failed: bool
    wall_s: float
    cpu_s: float  # of its processes that were waited for


def main(words: list[str]) -> int:
    """Run the chosen stages, or the usual ones, and return the exit status."""
    start = time.monotonic()
    limits = [float(word.removeprefix(MINUTES)) for word in words if word.startswith(MINUTES)]
    end = start + 60.0 * limits[-1] if limits else None
    words = [word for word in words if not word.startswith(MINUTES)]
    options = {word for word in words if word.startswith("--")}
    names = [word for word in words if not word.startswith("--")]
    unknown = [
        *(options - {"--all", "--rest", "--changed", "--times"}),
        *(set(names) - set(STAGES)),
    ]
    if unknown:
        print(f"no such stage: {', '.join(sorted(unknown))}; stages: {', '.join(STAGES)}")
        return 2
    with tempfile.TemporaryDirectory() as folder:
        measured = Path(folder) if "--times" in options else None
        if "--changed" in options:
            chosen = changed.stages(FIXED, TESTS["tests"])
        elif names:
            chosen = {name: STAGES[name] for name in names}
        elif "--rest" in options:
            chosen = REST
        else:
            chosen = FIXED | TESTS | (REST if "--all" in options else {})
        ended = run(chosen, measured, end)
        if measured is not None:
            report(ended, measured)
    took = time.monotonic() - start
    failed = [stage.name for stage in ended if stage.failed]
    print("== " + ", ".join(f"{stage.name} {stage.wall_s:.1f} s" for stage in ended))
    print(f"== failed: {', '.join(failed)}" if failed else f"== everything passed in {took:.0f} s")
    return 1 if failed else 0


def run(chosen: dict[str, list[str]], measured: Path | None, end: float | None) -> list[Ended]:
    """Run the stages of each phase beside each other, and one phase after another.

    Args:
        chosen: The command of each stage.
        measured: The folder that takes what tests cost; None: nobody asks.
        end: When all ought to be over, by the monotonic clock [s]; None: nobody waits.
    """
    ended: list[Ended] = []
    for phase in phases(list(chosen)):
        looking = threading.Thread(
            target=run_quietly, args=({name: chosen[name] for name in phase.beside}, ended, end)
        )
        looking.start()
        if phase.name:
            print(f"== {phase.name}", flush=True)
            if phase.name in TESTS and not COMPILED.exists():
                compile_once()
            if phase.name == THOROUGH and minutes_left(end) <= 0.0:  # nor is there to read them
                print(f"{until.REASON}: no thorough test was tried", flush=True)
                ended.append(Ended(THOROUGH, failed=False, wall_s=0.0, cpu_s=0.0))
            else:
                command = with_time(chosen[phase.name], end)
                ended.append(run_one(phase.name, command, environment(phase.name, measured, end)))
        looking.join()
    return sorted(ended, key=lambda stage: list(chosen).index(stage.name))


def compile_once() -> None:
    """Read all tests once, so that not every worker compiles them and the libraries beside others.

    To compile takes as long as to read. What is wrong with a test, the stage will say.
    """
    command = [*PYTEST, "-p", "no:xdist", "--collect-only", "-qqq"]
    subprocess.run(
        command, cwd=ROOT, env=environment("", None, None), capture_output=True, check=False
    )


class Phase(NamedTuple):
    """Stages that share the machine."""

    name: str  # that says what it does as it goes; "": none
    beside: tuple[str, ...]  # that are told when they are over


def phases(names: list[str]) -> list[Phase]:
    """Return what runs beside what.

    What looks at the text only runs beside the first tests. Patches are tried beside thorough
    tests, which wait often. Live sessions want the machine for themselves.
    """
    fixed = tuple(name for name in names if name in FIXED)
    found: list[Phase] = []
    for name in names:
        if name in FIXED or (name == PATCHES and THOROUGH in names):
            continue
        beside = (PATCHES,) if name == THOROUGH and PATCHES in names else ()
        found.append(Phase(name, (*(() if found else fixed), *beside)))
    return found or [Phase("", fixed)]


def run_quietly(chosen: dict[str, list[str]], ended: list[Ended], end: float | None) -> None:
    """Run stages one after another; print what they say when they are over.

    Patches give way to the tests that they run beside.
    """
    for name, command in chosen.items():
        with tempfile.TemporaryFile() as said:
            stage = run_one(
                name, with_time(command, end), environment(name, None, end), said.fileno()
            )
            said.seek(0)
            text = said.read().decode()
        ended.append(stage)
        print(f"\n== {name}: {'FAILED' if stage.failed else 'passed'}\n{text}", end="", flush=True)


def minutes_left(end: float | None) -> float:
    """Return for how many minutes anything may begin."""
    return math.inf if end is None else (end - time.monotonic()) / 60.0 - ENDING_MIN


def with_time(command: list[str], end: float | None) -> list[str]:
    """Return a command that is told how many minutes it has, where it asks for them."""
    told = f"{MINUTES}{max(0.0, min(PATCHES_MIN, minutes_left(end))):.1f}"
    return [told if word == MINUTES else word for word in command]


def run_one(
    name: str, command: list[str], environment: dict[str, str], said: int | None = None
) -> Ended:
    """Run a stage."""
    start = time.perf_counter()
    process = subprocess.Popen(command, cwd=ROOT, env=environment, stdout=said, stderr=said)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - start
    return Ended(name, process.returncode != 0, wall, used.ru_utime + used.ru_stime)


def environment(name: str, measured: Path | None, end: float | None) -> dict[str, str]:
    """Return the environment of a stage: what is compiled once is kept beside its text."""
    found = dict(
        os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", DENO_NO_UPDATE_CHECK="1"
    )
    for unwanted in ("PYTHONDONTWRITEBYTECODE", *SAYS_ALL):
        found.pop(unwanted, None)
    if name == THOROUGH:
        found[laws.ALL_NAME] = "1"
        if end is not None:
            found[until.NAME] = str(end - 60.0 * ENDING_MIN)
    if measured is not None and name in ("tests", THOROUGH, "live"):
        found |= {times.FOLDER: str(measured), "PYTEST_PLUGINS": "tests.times"}
    return found


def report(ended: list[Ended], measured: Path) -> None:
    """Print what everything cost, and keep the seconds of files."""
    costs = times.read(measured)
    print("\n== CPU time of each stage [s]")
    for stage in ended:
        print(f"{stage.cpu_s:8.1f}  {stage.name}")
    if costs:
        print("\n== the slowest tests by CPU time, with the processes below them")
        print(times.table(costs))
        times.keep(costs)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
