"""What it costs of a processor to go on with a changed text, beside a fresh run of that text.

`python -m pytest tests/bench/test_bench_editing.py -s -p no:xdist`
"""

from pathlib import Path
from statistics import median
from time import process_time

from tests.places import ROOT
from vrts.debug.alarms import DEFAULT
from vrts.debug.breakpoints import Breakpoint
from vrts.debug.debugger import Debugger
from vrts.debug.editing.text import take_up
from vrts.debug.opening import Asked, Opened, opened

EXAMPLE = ROOT / "examples" / "04-final-project" / "solution.v2"
TIMES = 5
EDITS = {
    "a step at 0 s": (20, '        TYPE "x"'),
    "a speed at 1 s": (34, "        SPEED 35"),
    "a text at the end": (12, '        TYPE "Done."'),
}


def spent(program: Path) -> tuple[Opened, float]:
    """Return a session that stands at its first stop, and what it cost [s]."""
    before = process_time()
    found = opened(Asked(program))
    assert found.debugger is not None
    wish(found.debugger)
    found.debugger.go_on()
    return found, process_time() - before


def wish(debugger: Debugger) -> None:
    debugger.wishes.filters = DEFAULT
    debugger.wishes.lines = [
        Breakpoint(1, debugger.run.module.programs["main"].span.source.name, 12)
    ]


def test_a_fork_with_its_first_stop_beside_a_fresh_run(tmp_path: Path) -> None:
    for file in EXAMPLE.parent.iterdir():
        if file.is_file():
            (tmp_path / file.name).write_bytes(file.read_bytes())
    path = tmp_path / EXAMPLE.name
    lines = EXAMPLE.read_text(encoding="utf-8").split("\n")
    for words, (line, text) in EDITS.items():
        new = "\n".join([*lines[:line], text, *lines[line + 1 :]])
        forks: list[float] = []
        fresh: list[float] = []
        said = ""
        for _ in range(TIMES):
            path.write_text("\n".join(lines), encoding="utf-8")
            old, _ = spent(path)
            assert old.debugger is not None
            assert old.console is not None
            path.write_text(new, encoding="utf-8")
            before = process_time()
            said = take_up(old.console, old.debugger)
            taken = process_time() - before
            old.debugger.seek(0.0)
            wish(old.debugger)
            before = process_time()
            stop = old.debugger.go_on()
            forks.append(taken + process_time() - before)
            other, cost = spent(path)
            fresh.append(cost)
            assert other.debugger is not None
            assert stop.instant == other.debugger.at
        one, both = median(forks), median(fresh)
        print(f"\n{words}: {1000 * one:.0f} ms, fresh {1000 * both:.0f} ms: {both / one:.1f} times")
        print(f"  {said}")
