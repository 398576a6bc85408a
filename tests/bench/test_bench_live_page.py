"""From joining a session to the first picture in Chromium, and what a page weighs.

By hand: `python -m pytest tests/bench/test_bench_live_page.py -s -p no:xdist`. Chromium draws in
software here; a graphics card is much faster. A process that only sleeps
tells how busy the machine is.
"""

import statistics
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.bench.machine import Metronome
from tests.browser.support import chromium
from tests.browser.support_sessions import SHOWN, desk
from tests.support_live import LiveServer

TIMES = 7
ASKED_S = 1.5
ASKED_BYTES = 1_000_000
# counted from the beginning of the navigation, in the page's own clock, until a picture with the
# arm in it has been given to the screen
FIRST = f"""new Promise((done) => {{
  const look = () => {SHOWN}
    ? requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() / 1000)))
    : setTimeout(look, 5);
  look();
}})"""
WEIGHT = """["navigation", "resource"]
  .flatMap((kind) => performance.getEntriesByType(kind))
  .map((entry) => [entry.transferSize, entry.decodedBodySize])"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("page") / "live", measured=True) as started:
        yield started


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium(measured=True) as opened:
        yield opened


def test_from_joining_to_the_first_picture(server: LiveServer, browser: Browser) -> None:
    link = f"/#enter={server.supervisor_token}"
    first = desk(browser, server, link, width=1280)  # the session starts
    first.until(SHOWN)
    took: list[float] = []
    weights: list[tuple[int, int]] = []
    with Metronome() as control:
        for k in range(TIMES):
            opened = desk(browser, server, "/", width=1280)
            opened.page.fill("#enter-code", server.code)
            opened.page.fill("#enter-name", f"viewer{k}")
            begun = opened.value("performance.now() / 1000")
            opened.page.click("#enter-form button")
            took.append(opened.value(FIRST) - begun)
            found = opened.value(WEIGHT)
            weights.append((sum(row[0] for row in found), sum(row[1] for row in found)))
            opened.context.close()
        late = control.so_far()
    sent, unpacked = weights[-1]
    print(
        f"\njoin to first picture: median {statistics.median(took):.2f} s, fastest {min(took):.2f},"
        f" slowest {max(took):.2f} (asked {ASKED_S})"
        f"\n  page {sent / 1e6:.2f} MB sent, {unpacked / 1e6:.2f} MB unpacked (asked"
        f" {ASKED_BYTES / 1e6:.0f}); who only sleeps wakes {late.p95:.1f} ms late (p95)",
        end="",
    )
    assert sent <= 1.1 * ASKED_BYTES
    assert min(took) < 20.0
