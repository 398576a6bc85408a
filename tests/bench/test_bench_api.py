"""What `import vrts` costs, and how fast a run answers for many times at once."""

import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

import vrts
from tests.places import ROOT

SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
TIMES = 100_000
REPEATED = 9


def test_importing() -> None:
    def started(program: str) -> float:
        begun = time.perf_counter()
        subprocess.run([sys.executable, "-c", program], check=True, cwd=ROOT)
        return time.perf_counter() - begun

    bare = min(started("pass") for _ in range(REPEATED))
    with_vrts = min(started("import vrts") for _ in range(REPEATED))
    print(
        f"\nimport vrts: {1e3 * (with_vrts - bare):.1f} ms more than {1e3 * bare:.1f} ms of Python"
    )


def test_many_times_at_once() -> None:
    run = vrts.run(SOLUTION)
    times_s = np.linspace(0.0, run.duration_s, TIMES)
    asked: dict[str, Callable[[], object]] = {
        "joints(times)": lambda: run.joints(times_s),
        "tool(times)": lambda: run.tool(times_s),
        "at(time)": lambda: [run.at(t).joints_deg for t in times_s[:: TIMES // 1000].tolist()],
    }
    for name, ask in asked.items():
        ask()
        begun = time.perf_counter()
        ask()
        took = time.perf_counter() - begun
        count = 1000 if name == "at(time)" else TIMES
        print(f"{name}: {1e6 * took / count:.2f} us for each of {count:,} times")


def test_what_a_notebook_shows() -> None:
    found = vrts.verify(SOLUTION)
    for thing in (found, found.run):
        begun = time.perf_counter()
        shown = str(thing._repr_html_())  # type: ignore[attr-defined] # pyright: ignore
        took = time.perf_counter() - begun
        print(f"{type(thing).__name__}: {len(shown) / 1e3:.0f} kB in {1e3 * took:.0f} ms")
