"""Assignments over HTTP: marks as marking gives them, and clients that want more than theirs."""

import json
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from tests.support_handing import PASSWORD, STUDENTS, course_folder, enrol, example, log_in, work
from tests.support_live import Json, LiveServer
from vrts.course.handing.public_marker import public_mark
from vrts.marking.submission.marker import STUDENT, Marker, read_marks
from vrts.marking.submission.one import Order, Wanted
from vrts.marking.submission.setting import Place

SECRET = "the-secret-place"
STAFF = f"""
[[via]]
name = "{SECRET}"
at_mm = [900, 0, -100]
radius_mm = 40
"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("work")
    course = course_folder(folder / "course")
    hidden = course / "tasks" / "cans" / "staff"
    hidden.mkdir()
    (hidden / "task.toml").write_text(STAFF)
    enrol(folder / "live", password=PASSWORD)
    with LiveServer(folder / "live", scenes=(str(course),)) as started:
        yield started


@pytest.fixture(scope="module")
def cookies(server: LiveServer) -> tuple[str, str]:
    return log_in(server, STUDENTS[0][0]), log_in(server, STUDENTS[1][0])


def hand_in(server: LiveServer, cookie: str, text: str, number: int) -> Json:
    body = {"assignment": "cans", "text": text, "attempt": number, "late": ""}
    answer = server.request("POST", "/course/work/hand-in", body, cookie=cookie)
    return {"status": answer.status, **answer.json}


def marked(server: LiveServer, cookie: str) -> Json:
    """Return the latest attempt once it is marked; each look waits for the server's answer."""
    for _ in range(5000):
        latest = work(server, cookie)["attempts"][0]
        if latest["state"] != "waiting":
            return latest
    raise AssertionError("it was never marked")


@pytest.mark.thorough
def test_the_public_mark_is_that_of_marking_and_nothing_hidden_leaves(
    server: LiveServer, cookies: tuple[str, str], tmp_path: Path
) -> None:
    own, other = cookies
    text = example("hits-base")
    assert hand_in(server, own, text, 1)["status"] == 200
    found = marked(server, own)
    task = server.folder.parent / "course" / "tasks" / "cans" / "task.toml"
    marker = Marker(Place(str(task)), Wanted())
    (tmp_path / STUDENT).mkdir()
    marks = read_marks(marker.work(Order("cy", "program.v2", text.encode()), tmp_path))
    public = public_mark(marks.student, [])
    assert (found["mark"], found["total"]) == (f"{marks.student.mark:g}.0"[:3], "10.0")
    assert [one["cause"] for one in found["losses"]] == [one.cause for one in public.losses]
    assert found["losses"][0]["why"][0].startswith("← at 4.3 s, line 11")
    page = server.request("GET", "/course/work/page/cans/1", cookie=own)
    assert page.status == 200
    assert page.headers["content-security-policy"].startswith("sandbox allow-scripts;")
    assert SECRET not in page.body.decode()
    said = server.request("GET", "/course/work/text/cans", cookie=own)
    assert said.json["problem"] == ""
    assert "marking has more checks" in said.body.decode()
    told = server.request("GET", "/course/work/now", cookie=own).body.decode()
    assert SECRET not in said.body.decode() + told
    assert work(server, other).get("attempts", []) == []


def test_nobody_gets_what_is_not_theirs(server: LiveServer, cookies: tuple[str, str]) -> None:
    own, other = cookies
    if not work(server, own).get("attempts"):
        hand_in(server, own, example("solution"), 1)
    for path in ("page/cans/1", "program/cans/1"):
        assert server.request("GET", f"/course/work/{path}", cookie=other).status == 404
        assert server.request("GET", f"/course/work/{path}").status == 401
    strange = ("..%2f..%2fcourse.toml", "..", ".pending", "%00", "cans%2f..%2fcans", "x" * 3000)
    for name in strange:
        for path in (f"text/{name}", f"page/{name}/1", f"program/{name}/1"):
            assert server.request("GET", f"/course/work/{path}", cookie=own).status in (400, 404)
    for body in ({"assignment": "../cans"}, {"assignment": "nothing"}):
        asked = {"text": "x", "attempt": 1, "late": "", **body}
        assert server.request("POST", "/course/work/hand-in", asked, cookie=own).status == 404
    guest = server.enter("Guest")
    refused = hand_in(server, guest, "x", 1)
    assert (refused["status"], refused["code"]) == (409, "role")


def test_storms_and_floods_are_refused(server: LiveServer, cookies: tuple[str, str]) -> None:
    other = cookies[1]
    flood = json.dumps(
        {"assignment": "cans", "text": "x" * 10_000_000, "attempt": 1, "late": ""}
    ).encode()
    with suppress(ConnectionError):  # it hears no more once it is too much
        assert server.request("POST", "/course/work/hand-in", flood, cookie=other).status == 413
    assert work(server, other).get("attempts", []) == []
    statuses = [
        server.request("POST", "/course/work/hand-in", {"no": 1}, cookie=other).status
        for _ in range(12)
    ]
    assert statuses.count(400) <= 5
    assert statuses[-1] == 429
    foreign = server.request(
        "POST", "/course/work/hand-in", {"no": 1}, cookie=other, origin="http://elsewhere.org"
    )
    assert foreign.status == 403
