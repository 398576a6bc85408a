"""Pages of a course as those who use them see them: axe in both themes, wide and on a phone."""

import os
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import ALL_RULES, AXE
from tests.browser.support_sessions import SHOWN, Desk, desk
from tests.support_board import CAUSES
from tests.support_course import came_in, course_folder, letter
from tests.support_handing import EXAMPLE
from tests.support_live import LiveServer
from vrts.live.settings import DATABASE
from vrts.live.store.course.attempts import Attempt, Loss, add_attempt, keep_mark
from vrts.live.store.course.people import people
from vrts.live.store.database import opened

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

WIDE, PHONE = 1366, 390
LOOKS = [(width, dark) for width in (WIDE, PHONE) for dark in (False, True)]
SHOTS = os.environ.get("SHOTS", "")  # folder for pictures to look at
ROSTER = """\
name,email,team
Cy Dahl,cy@example.org,Red
Di Ek,di@example.org,Red
Ann-Kathrin Oberbauer-Wiśniewska,ann-kathrin.oberbauer-wisniewska@students.uni-example.org,Blue
Jun,jun@example.org,
"""
MORE = """
[slots]
time_zone = "Europe/Berlin"
days = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"]

[login]
issuer = "https://id.example.org"
client = "vrts"
name = "Log in with the school"

[[assignment]]
task = "tasks/cans"
attempts = 3

[[assignment]]
task = "tasks/team"
team = true
"""
NOON = 1_795_780_800.0  # Unix time [s]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    """Serve a course of a teacher, an assistant, students and teams with some attempts."""
    folder = tmp_path_factory.mktemp("pages")
    course = course_folder(folder / "course", more=MORE)
    (course / "roster.csv").write_text(ROSTER, encoding="utf-8")
    for name in ("cans", "team"):
        task = course / "tasks" / name
        task.mkdir(parents=True)
        for one in ("task.toml", "README.md", "solution.v2"):
            (task / one).write_bytes((EXAMPLE / one).read_bytes())
    said = course / "tasks" / "team" / "task.toml"
    said.write_text(said.read_text("utf-8").replace("Cans on bases", "Cans, together"), "utf-8")
    with LiveServer(folder / "live", scenes=(str(course),)) as started:
        started.request("GET", "/door")  # is answered when it has begun
        attempts(started.folder / DATABASE)
        yield started


def attempts(database: Path) -> None:
    """Let students have handed in, and lose by this and that."""
    with closing(opened(database)) as connection:
        whose = {one.called: one.account for one in people(connection)}
        for name, causes in (("Cy Dahl", (3, 1)), ("Jun", (2, 2, 2))):
            account = whose[name]
            for k, count in enumerate(causes):
                at, digest = NOON + 3600.0 * k, f"{name} {k}"
                number = add_attempt(connection, account, "cans", at, account, digest)
                lost = tuple(Loss(*cause) for cause in CAUSES[:count])
                mark = str(10.0 - sum(float(loss.points) for loss in lost))
                who = (account, "cans", number, at, account, digest)
                keep_mark(connection, Attempt(*who, "marked", mark, "10", "", lost))


# what stands in a table of people is seen without scrolling sideways
ALL_SEEN = """[...document.querySelectorAll(".people-scroll")]
  .every((one) => one.scrollWidth <= one.clientWidth)"""


class People:
    """Who has come in, each once."""

    def __init__(self, server: LiveServer) -> None:
        self.server = server
        self.cookies: dict[str, str] = {}

    def page(self, browser: Browser, name: str) -> Desk:
        """Open a page of somebody; of nobody where there is no name.

        It is the one of a first entry, with a link that is not whole.
        """
        one = desk(browser, self.server, "/course/first", width=WIDE, drawn=bool(SHOTS))
        if name and name not in self.cookies:
            self.cookies[name] = came_in(self.server, name)
        for cookie in self.cookies.get(name, "").split("; ") if name else ():
            key, _, value = cookie.partition("=")
            url = f"http://{self.server.host}"
            one.context.add_cookies([{"name": key, "value": value, "url": url}])
        return one


@pytest.fixture(scope="module")
def crowd(server: LiveServer) -> People:
    return People(server)


def own_robot(one: Desk) -> None:
    """Go to a robot of one's own, and raise a hand."""
    one.until(SHOWN)
    one.page.click("#tab-own")
    one.page.click("#panel-own button:text-is('Open') >> nth=0")
    one.until("Boolean(vrts.store.now.room?.own) && vrts.store.now.alive")
    one.page.fill("#hand-text", "the hand does not close round the can")
    one.page.click("button:text('Raise hand')")
    one.until("document.getElementById('panel-own').textContent.includes('1st in the queue')")


def new_link(one: Desk) -> None:
    """Make a new link, which is shown."""
    one.page.click("#people-rows tr:has-text('Jun') button")
    one.page.wait_for_selector("#people-new:visible")


def refused(one: Desk) -> None:
    """See that there is nothing to fill in for who may not."""
    assert not one.page.locator("form:visible").count()


def nothing(one: Desk) -> None:
    """Look only."""


SEEN = {
    "door": ("", "/", "#enter-provider:visible", nothing),
    "first": ("", "/course/first#{letter}", "#first-form:visible", nothing),
    "board": ("Ada Lind", "/course/board", "#marks tbody tr >> nth=3", nothing),
    "people": ("Ada Lind", "/course/people", "#people-rows tr >> nth=5", new_link),
    "people refused": ("Bo Berg", "/course/people", "#people-problem:visible", refused),
    "work": ("Cy Dahl", "/course/work", ".words h3 >> nth=0", nothing),
    "own robot": ("Di Ek", "/", "#room:visible", own_robot),
}


@pytest.mark.parametrize("name", SEEN)
def test_nothing_stands_in_the_way_of_anybody(
    browser: Browser, server: LiveServer, crowd: People, name: str
) -> None:
    """Each page once, in every look; nothing sticks out at the side."""
    who, path, ready, then = SEEN[name]
    one = crowd.page(browser, who)
    if "{letter}" in path:
        path = path.format(letter=letter(server, "Jun"))
    one.page.goto(f"http://{server.host}{path}")
    one.page.wait_for_selector(ready)
    then(one)
    one.page.evaluate(AXE)
    for width, dark in LOOKS:
        one.page.set_viewport_size({"width": width, "height": 900})
        one.page.emulate_media(color_scheme="dark" if dark else "light")
        found = one.page.evaluate(ALL_RULES)
        wide = one.page.evaluate("document.documentElement.scrollWidth")
        if SHOTS:
            look = f"{name.replace(' ', '-')}-{width}-{'dark' if dark else 'light'}"
            one.page.screenshot(path=f"{SHOTS}/{look}.png", full_page=True)
        assert found["passes"] > 15  # there is little on some of these pages
        assert found["violations"] == [], (width, dark)
        assert wide <= width
        assert one.page.evaluate(ALL_SEEN)
    said = one.complaints()
    assert [words for words in said if then is not refused or "403" not in words] == []
    one.context.close()
