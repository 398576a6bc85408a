"""The board over HTTP: for those who teach alone, and told by itself when something changes."""

from collections.abc import Iterator
from contextlib import closing
from http.client import HTTPConnection
from pathlib import Path
from time import monotonic

import pytest

from tests.support_board import NOON, fill, write_course
from tests.support_live import PATIENCE, LiveServer
from vrts.live.settings import DATABASE
from vrts.live.store.course.attempts import Attempt, add_attempt, keep_mark
from vrts.live.store.database import opened

ADDRESSES = (
    "/course/board/now",
    "/course/board/events",
    "/course/board/marks.csv",
    "/course/board/student/1",
)


class Served(LiveServer):
    """A course with students who have handed in."""

    def __init__(self, folder: Path) -> None:
        course = write_course(folder / "course", 2)
        self.kept = folder / "kept"
        self.students = fill(self.kept, 4, 2)
        super().__init__(self.kept, scenes=(str(course),))
        self.teacher = self.supervisor()  # the link lets in once


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    started = Served(tmp_path_factory.mktemp("course"))
    with started:
        yield started


@pytest.mark.parametrize("address", ADDRESSES)
def test_nobody_else_sees_the_board(server: Served, address: str) -> None:
    for cookie in ("", server.enter("Guest")):
        answer = server.request("GET", address, cookie=cookie)
        assert (answer.status, answer.json["code"]) == (403, "role")


def test_those_who_teach_see_everybody(server: Served) -> None:
    cookie = server.teacher
    told = server.request("GET", "/course/board/now", cookie=cookie).json
    assert [column["title"] for column in told["columns"]] == [
        "Pick and place 1",
        "Pick and place 2",
    ]
    assert sorted(row["id"] for row in told["students"]) == sorted(server.students)
    assert told["columns"][0]["due"] > 0
    table = server.request("GET", "/course/board/marks.csv?assignment=pick-2", cookie=cookie)
    assert table.body.count(b"\r\n") == 1 + len(server.students)
    assert "attachment" in table.headers["content-disposition"]
    unknown = server.request("GET", "/course/board/marks.csv?assignment=../x", cookie=cookie)
    assert unknown.status == 404
    assert server.request("GET", "/course/board/student/999", cookie=cookie).status == 404


def test_a_new_attempt_is_told_to_who_looks(server: Served) -> None:
    cookie, account = server.teacher, server.students[0]
    server.request("GET", "/course/board/now", cookie=cookie)
    link = HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
    with closing(link):
        link.putrequest("GET", "/course/board/events", skip_host=True)
        link.putheader("host", server.host)
        link.putheader("cookie", cookie)
        link.endheaders()
        events = link.getresponse()
        assert events.readline().startswith(b"retry")
        with closing(opened(server.kept / DATABASE)) as connection:
            number = add_attempt(connection, account, "pick-1", NOON + 9e6, account, "d")
            attempt = Attempt(account, "pick-1", number, 0.0, None, "d", "marked", "7", "10")
            keep_mark(connection, attempt)
        told, end = b"", monotonic() + PATIENCE  # signs of life would let it wait for ever
        while b'"students"' not in told or b'"last":7.0' not in told:
            told = events.readline()
            assert told, "the server has ended the connection"
            assert monotonic() < end, "nothing is told of the attempt"
    work = server.request("GET", f"/course/board/student/{account}", cookie=cookie).json
    assert work["attempts"][-1]["mark"] == 7.0
