"""Ways in, tried by those who guess, flood and come too often, against a real server."""

import http.client
import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support_live import Answer, Json, LiveServer
from vrts.live.entrance.entries import UNUSED
from vrts.live.entrance.log_ins import FREE
from vrts.live.limits import CONNECTIONS
from vrts.live.new_account import add_user
from vrts.live.rooms.pulse import AWAY
from vrts.live.tokens import LETTERS


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("ways") / "live") as started:
        yield started


@pytest.fixture(autouse=True)
def nobody_stays(server: LiveServer) -> Iterator[None]:
    yield
    server.close_browsers()


@pytest.mark.thorough
def test_who_is_right_comes_in_whatever_others_typed(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as own:
        told: set[tuple[int, str]] = set()
        for n in range(300):
            wrong = own.code[:-3] + "".join(LETTERS[n // 31**k % 31] for k in range(3))
            if wrong != own.code:
                answer = own.request("POST", "/enter", {"code": wrong, "name": "x"})
                told.add((answer.status, answer.json["code"]))
        assert own.request("POST", "/enter", {"code": "W" * 43, "name": "x"}).status == 403
        assert told == {(403, "code")}
        cookie = own.enter("Anna")
        own.join(cookie).wait("welcome")
        boss = own.supervisor()
        room = own.request("GET", "/me", cookie=boss).json["rooms"][0]["id"]
        link = own.request("POST", "/link", {"room": room}, cookie=boss).json["url"]
        own.enter("Ben", link.partition("#enter=")[2])
        ways = own.request("GET", "/ways", cookie=boss).json
        assert ways["wrong"] in (299, 300)
        assert [(way["kind"], way["used"]) for way in ways["ways"]] == [("code", 1), ("link", 1)]
        assert own.request("GET", "/ways", cookie=cookie).status == 403
        assert own.request("POST", "/ways", {"do": "renew"}, cookie=cookie).status == 403

        own.kill()
        own.start(str(own.port))
        boss = own.supervisor()
        assert own.request("GET", "/ways", cookie=boss).json["wrong"] >= ways["wrong"]
        own.close_browsers()


def test_a_new_code_is_on_every_wall_at_once_and_the_old_one_says_so(server: LiveServer) -> None:
    old = server.code
    boss_cookie = further_supervisor(server)
    walls = [server.join(boss_cookie) for _ in range(3)]
    assert {wall.wait("code")["code"].replace("-", "") for wall in walls} == {old}
    anna = server.join(server.enter("Anna"))
    anna.wait("control")
    told = server.request("POST", "/ways", {"do": "renew"}, cookie=boss_cookie).json
    server.code = told["code"].replace("-", "")
    assert server.code != old
    for wall in walls:
        shown = wall.wait("code")
        assert (shown["code"], shown["url"]) == (told["code"], told["url"])
    late = server.request("POST", "/enter", {"code": old, "name": "Late"})
    assert (late.status, late.json["text"]) == (403, "there is another class code now")
    server.enter("Late")
    anna.send("say", text="still here")
    anna.wait("chat", lambda m: m["text"] == "still here")
    assert "code" not in {m["type"] for m in anna.came}, "students are not told"

    command = (sys.executable, "-m", "vrts.cli.main", "serve", "--folder", str(server.folder))
    done = subprocess.run([*command, "--renew-code"], capture_output=True, text=True, check=True)
    server.code = re.findall(r"class code: ([\w-]+)", done.stdout)[0].replace("-", "")
    assert {wall.wait("code")["code"].replace("-", "") for wall in walls} == {server.code}
    server.enter("Later")

    shown = server.request("GET", "/ways", cookie=boss_cookie).json["ways"][0]
    body = {"do": "end", "id": shown["id"], "away": True}
    left = server.join(server.enter("Leaves"))
    left.wait("control")
    server.request("POST", "/ways", body, cookie=boss_cookie)
    closed = left.closed()
    assert closed is not None
    assert (closed["code"], closed["text"]) == ("kicked", AWAY)
    assert all(wall.wait("code")["code"] == "" for wall in walls)
    gone = server.request("POST", "/enter", {"code": server.code, "name": "x"})
    assert gone.status == 403
    anna.send("say", text="by the first code")
    anna.wait("chat", lambda m: m["text"] == "by the first code")
    again = server.request("POST", "/ways", {"do": "renew"}, cookie=boss_cookie).json
    server.code = again["code"].replace("-", "")


def further_supervisor(server: LiveServer) -> str:
    """Enter by a link that the command line makes."""
    command = (sys.executable, "-m", "vrts.cli.main", "serve", "--folder", str(server.folder))
    words = [*command, "--supervisor-link"]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    return server.enter("", done.stdout.partition("#enter=")[2].split()[0])


@pytest.mark.thorough
def test_a_flood_of_entries_takes_nobody_s_place(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as own:
        cookies = [own.enter(f"Student {n}") for n in range(5)]
        for cookie in cookies:
            own.join(cookie).wait("welcome")
        own.close_browsers()  # they are away meanwhile
        link = http.client.HTTPConnection("127.0.0.1", own.port)
        headers = {"origin": f"http://{own.host}", "content-type": "application/json"}
        body = json.dumps({"code": own.code, "name": "Flood"})
        begun = time.monotonic()
        for _ in range(2 * UNUSED):
            link.request("POST", "/enter", body, headers)
            answer = link.getresponse()
            answer.read()
            assert answer.status == 200
        print(f"{2 * UNUSED} entries in {time.monotonic() - begun:.1f} s")
        link.close()
        for cookie in cookies:
            assert own.request("GET", "/me", cookie=cookie).status == 200
        own.join(own.enter("New")).wait("welcome")
        ways = own.request("GET", "/ways", cookie=own.supervisor()).json
        assert ways["hour"] == 2 * UNUSED + 6
        assert ways["most"][0] == {"address": "127.0.0.1", "hour": ways["hour"], "day": ways["day"]}
        assert ways["unused"] <= UNUSED
        assert ways["guests"] <= UNUSED + 6


def row(people: Json, you: str) -> Json:
    """Return somebody's row of a list of people."""
    nobody: Json = {}
    return next((person for person in people["people"] if person["id"] == you), nobody)


def test_one_person_holds_eight_places_at_most(server: LiveServer) -> None:
    cookie = server.enter("Comes and goes")
    viewer = server.join(server.enter("Viewer"))
    viewer.wait("control")
    for _ in range(CONNECTIONS + 3):
        browser = server.join(cookie)
        you = browser.wait("welcome")["you"]
        browser.socket.close()
        viewer.wait(
            "people", lambda m, you=you: any(p["id"] == you and p["away"] for p in m["people"])
        )
    people = next(m for m in reversed(viewer.came) if m["type"] == "people")["people"]
    assert sum(p["name"] == "Comes and goes" for p in people) == CONNECTIONS


@pytest.mark.thorough
def test_nobody_is_locked_out_of_an_account_by_who_guesses_at_it(tmp_path: Path) -> None:
    user = add_user(tmp_path / "live", "Dr. Lee", "correct horse", supervisor=True)
    right, wrong = {"user": user, "password": "correct horse"}, {"user": user, "password": "x"}
    with LiveServer(tmp_path / "live") as own:
        first = own.request("POST", "/login", right)
        known = "; ".join(c.split(";")[0] for c in first.headers.get_all("set-cookie") or ())
        told = [own.request("POST", "/login", wrong) for _ in range(FREE + 1)]
        assert [answer.status for answer in told] == [403] * FREE + [429]
        assert int(told[-1].headers["retry-after"] or 0) >= 1
        assert own.request("POST", "/login", right, cookie=known).status == 200, "a known browser"
        for user_of_nobody in ("nobody", user + "x"):
            body = {"user": user_of_nobody, "password": "x"}
            assert own.request("POST", "/login", body).status == 403
        assert from_elsewhere(own, right).status == 200, "a fresh browser elsewhere"


def from_elsewhere(server: LiveServer, body: Json) -> Answer:
    """Log in from another address."""
    link = http.client.HTTPConnection("127.0.0.1", server.port, source_address=("127.0.0.2", 0))
    headers = {"origin": f"http://{server.host}", "content-type": "application/json"}
    link.request("POST", "/login", json.dumps(body), headers)
    answer = Answer(link.getresponse())
    link.close()
    return answer
