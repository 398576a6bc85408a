"""The editor in the page: from opening it, and from a key, to the diagnostic.

By hand: `python -m pytest tests/bench/test_bench_live_editor.py -s -p no:xdist`. A process that
only sleeps tells how busy the machine is.
"""

import statistics
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.bench.machine import Metronome
from tests.browser.support import chromium
from tests.browser.support_sessions import Desk, student
from tests.support_live import LiveServer
from tests.unit.live.editing.support import helpers
from vrts.web.assets import closure
from vrts.web.assets import served as served_text

pytest.importorskip("pygls", reason='needs pip install "vrts[ide]"')

TIMES = 5
KEYS = 20
# seconds from what is done to the mark that it brings, in the page's own clock
MARKED = """(what) => new Promise((done) => {
  const begun = performance.now();
  what();
  const marks = () => document.querySelector(".bench .host")?.shadowRoot
    ?.querySelector(".cm-lintRange-error");
  const look = () => marks() ? done((performance.now() - begun) / 1000) : setTimeout(look, 2);
  look();
})"""
WRONG = ".PROGRAM pick\n  MOVE part\n  APPROO part,50\n.END\n"
KEY = """(fresh) => () => {
  const { view } = editing;
  const changes = { from: 0, to: view.state.doc.length, insert: fresh };
  view.dispatch({ changes, userEvent: "input.type" });
}"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("editor") / "live", measured=True) as started:
        yield started


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium(measured=True) as opened:
        yield opened


def opened_with(person: Desk, text: str) -> float:
    """Open the editor with a draft; return the seconds to its first diagnostic."""
    draft = {"text": text, "saved": "", "opened": {"shelf": "own", "name": "", "seen": 0}}
    key = person.value("`vrts draft ${vrts.store.now.room.id}`")
    person.page.evaluate(
        "([key, draft]) => sessionStorage.setItem(key, JSON.stringify(draft))", [key, draft]
    )
    return person.value(f"({MARKED})(() => document.getElementById('tab-editor').click())")


def test_from_opening_and_from_a_key_to_the_diagnostic(
    server: LiveServer, browser: Browser
) -> None:
    opening: list[float] = []
    typing: list[float] = []
    memory = 0
    with Metronome() as control:
        for number in range(TIMES):
            person = student(browser, server, f"viewer{number}")
            opening.append(opened_with(person, WRONG))
            if number == TIMES - 1:
                for k in range(KEYS):
                    person.value(f"({KEY})('.PROGRAM pick\\n.END\\n')()")
                    person.until(
                        "document.querySelector('.bench .host').shadowRoot"
                        ".querySelector('.cm-lintRange-error') === null"
                    )
                    text = WRONG.replace("part", f"part{k}")
                    typing.append(person.value(f"({MARKED})(({KEY})({text!r}))"))
                (pid,) = helpers(server)
                status = Path(f"/proc/{pid}/status").read_text()
                memory = int(status.split("VmHWM:")[1].split()[0]) * 1024
            person.context.close()
        late = control.so_far()
    modules = closure("live/editor/workbench.js")
    weight = sum(len(served_text(path).encode()) for path in modules)
    print(
        f"\nopening to the first diagnostic: median {statistics.median(opening):.2f} s, fastest"
        f" {min(opening):.2f}, slowest {max(opening):.2f}"
        f"\n  key to diagnostic: median {1000 * statistics.median(typing):.0f} ms, slowest"
        f" {1000 * max(typing):.0f} (80 and 150 of them are pauses after the last key)"
        f"\n  {len(modules)} modules, {weight / 1e6:.2f} MB, when it is opened; a language server"
        f" {memory / 1e6:.0f} MB; who only sleeps wakes {late.p95:.1f} ms late (p95)",
        end="",
    )
    assert min(opening) < 20.0
