"""The board's first screen for 300 students in Chromium, and what a change costs the server.

By hand: `python -m pytest tests/bench/test_bench_board.py -s -p no:xdist`. Each time the server has
made no board before, and the browser has kept nothing: from the navigation to the table on the
screen, in the page's own clock.
"""

import statistics
from contextlib import closing
from pathlib import Path
from time import perf_counter

from tests.bench.usual import scaled, slowness
from tests.browser.support import chromium
from tests.support_board import NOON, fill, write_course
from tests.support_live import LiveServer
from vrts.live.settings import DATABASE
from vrts.live.store.course.attempts import add_attempt
from vrts.live.store.database import opened

STUDENTS, ASSIGNMENTS, ATTEMPTS = 300, 10, 8
TIMES = 5
ASKED_S = 1.0
READY = """new Promise((done) => {
  const look = () => document.querySelector("#marks tbody tr")
    ? requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() / 1000)))
    : setTimeout(look, 4);
  look();
})"""


def test_first_screen_of_300_students(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    students = fill(kept, STUDENTS, ASSIGNMENTS, ATTEMPTS)
    course = str(write_course(tmp_path / "course", ASSIGNMENTS))
    took: list[float] = []
    again: list[float] = []
    size = 0
    before = slowness()
    with LiveServer(kept, scenes=(course,), measured=True) as server, chromium(measured=True) as b:
        cookie = server.supervisor()
        for k in range(TIMES):
            with closing(opened(kept / DATABASE)) as connection:  # so the board is made again
                add_attempt(connection, students[k], "pick-1", NOON + 9e7 + k, students[k], "d")
            context = b.new_context(viewport={"width": 1366, "height": 768})
            for one in cookie.split("; "):
                name, _, value = one.partition("=")
                url = f"http://{server.host}"
                context.add_cookies([{"name": name, "value": value, "url": url}])
            page = context.new_page()
            page.goto(f"http://{server.host}/course/board", wait_until="commit")
            took.append(float(page.evaluate(READY)))
            page.wait_for_function(
                f"document.querySelectorAll('#marks tbody tr').length === {STUDENTS}"
            )
            context.close()
            begun = perf_counter()
            told = server.request("GET", "/course/board/now", cookie=cookie, accept_encoding="gzip")
            again.append(perf_counter() - begun)
            size = len(told.body)
    slow = (before, slowness())
    print()
    print(f"first of all, nothing remembered: {took[0]:.2f} s here")
    first = statistics.median(took)
    print(scaled(f"first screen of {STUDENTS} students, median of {TIMES}", first, ASKED_S, slow))
    print(f"{size} bytes, asked again {1000 * statistics.median(again):.0f} ms")
