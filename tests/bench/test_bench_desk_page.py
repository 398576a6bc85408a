"""The desk's first screen for 1,000 rows in Chromium, and how long going on takes.

By hand: `python -m pytest tests/bench/test_bench_desk_page.py -s -p no:xdist`. Each time a browser
without anything kept opens the desk: from the navigation to the work list and the source of the
first program on the screen, in the page's own clock. A process that only sleeps tells how busy the
machine is.
"""

import statistics
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.bench.machine import Metronome
from tests.bench.usual import scaled, slowness
from tests.browser.support import chromium
from tests.support_desk import write_desk_class
from tests.support_desk_server import DeskProcess

ROWS = 1000
TIMES = 7
ASKED_S = 1.0
READY = (
    'document.querySelector("#list [role=option][aria-selected=true]")'
    ' && document.querySelector("#code li code")'
)
# until what is ready has been given to the screen
FIRST = f"""new Promise((done) => {{
  const look = () => {READY}
    ? requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() / 1000)))
    : setTimeout(look, 4);
  look();
}})"""
MOVED = """
window.moved = 0;
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) window.moved += entry.value;
}).observe({ type: "layout-shift", buffered: true });
"""
# leafing: from the key to the next program's lines on the screen
NEXT = """new Promise((done) => {
  const begun = performance.now();
  const before = document.getElementById("row-name").textContent;
  document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "j", bubbles: true }));
  const look = () => document.getElementById("row-name").textContent !== before
    && document.querySelector("#code li code")
    ? requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() - begun)))
    : setTimeout(look, 2);
  look();
})"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DeskProcess]:
    folder: Path = tmp_path_factory.mktemp("desk")
    write_desk_class(folder, ROWS)
    with DeskProcess(folder / "out", "R. Huber", measured=True) as started:
        yield started


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium(measured=True) as opened:
        yield opened


def test_first_screen_of_a_thousand_rows(server: DeskProcess, browser: Browser) -> None:
    took: list[float] = []
    leafed: list[float] = []
    moved = 0.0
    before = slowness()
    with Metronome() as control:
        for _ in range(TIMES):
            context = browser.new_context(viewport={"width": 1366, "height": 768})
            context.add_init_script(MOVED)
            page = context.new_page()
            page.goto(server.address, wait_until="commit")
            page.wait_for_url(server.page + "*", wait_until="commit")
            page.wait_for_selector("#list")
            took.append(page.evaluate(FIRST))
            assert page.locator("#list [role=option]").count() < 60  # those that can be seen
            leafed += [page.evaluate(NEXT) for _ in range(5)]
            page.wait_for_timeout(500)  # nothing that comes later moves anything either
            moved = max(moved, page.evaluate("window.moved"))
            context.close()
        late = control.so_far()
    slow = before, slowness()
    print(
        f"\nfirst screen of {ROWS} rows: median {statistics.median(took):.2f} s,"
        f" fastest {min(took):.2f}, slowest {max(took):.2f}\n  "
        + scaled("median", statistics.median(took), ASKED_S, slow)
        + "\n  "
        + scaled("fastest, which others disturb least", min(took), ASKED_S, slow)
        + f"\n  next program: median {statistics.median(leafed):.0f} ms, slowest {max(leafed):.0f};"
        f" layout shift {moved:.4f}; who only sleeps wakes {late.p95:.1f} ms late (p95)",
        end="",
    )
    assert moved < 0.01
    assert min(took) < 10.0
