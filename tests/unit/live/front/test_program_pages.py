"""Programs that are kept, as pages ask for them: whose they are, versions, limits, nonsense."""

from collections.abc import Iterator
from typing import Any
from urllib.parse import quote

import pytest

from tests.support_live import Answer, Browser, LiveServer
from vrts.live.front.program_pages import RATE

TEXT = ".PROGRAM pick\n  MOVE part\n.END\n"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("programs") / "live") as started:
        yield started


class Person:
    """Somebody with a cookie."""

    def __init__(self, server: LiveServer, cookie: str) -> None:
        self.server, self.cookie = server, cookie
        self.page: Browser | None = None
        self.room = self.get("/me")["rooms"][0]["id"]

    def get(self, path: str) -> Any:
        answer = self.server.request("GET", path, cookie=self.cookie)
        assert answer.status == 200, answer.body
        return answer.json

    def post(self, what: str, **fields: Any) -> Answer:
        body = {"room": self.room, **fields}
        return self.server.request("POST", f"/programs/{what}", body, cookie=self.cookie)

    def take_control(self) -> None:
        self.page = self.page or self.server.join(self.cookie)
        self.page.take_control()

    def hand_back(self) -> None:
        assert self.page is not None
        self.page.send("hand_back")
        self.page.wait("control", lambda m: m["holder"] == "")

    def keep(self, text: str, seen: int, shelf: str = "room", name: str = "pick") -> Any:
        answer = self.post("keep", shelf=shelf, name=name, text=text, seen=seen)
        assert answer.status == 200, answer.body
        return answer.json

    def text(self, number: int, shelf: str = "room", name: str = "pick") -> Answer:
        where = f"room={self.room}&shelf={shelf}&name={quote(name)}&number={number}"
        return self.server.request("GET", f"/programs/text?{where}", cookie=self.cookie)


def test_two_persons_share_the_rooms_programs_and_lose_none(server: LiveServer) -> None:
    anna, ben = (Person(server, server.enter(name)) for name in ("Anna", "Ben"))
    viewer = anna.post("keep", shelf="room", name="pick", text=TEXT, seen=0)
    assert (viewer.status, viewer.json["code"]) == (403, "role"), "who may not command"
    assert "who has control" in viewer.json["text"]
    assert "save it for yourself" in viewer.json["help"]
    anna.take_control()
    assert anna.keep(TEXT, 0)["saved"]
    anna.hand_back()
    ben.take_control()
    assert ben.keep("Ben's", 1)["version"]["number"] == 2
    ben.hand_back()
    anna.take_control()
    refused = anna.keep("Anna's", 1)
    assert not refused["saved"]
    assert (refused["version"]["saver"], refused["version"]["mine"]) == ("Ben", False)
    assert anna.keep("Anna's", 2)["saved"]
    assert ben.text(2).json == {"text": "Ben's"}
    rows = ben.get(f"/programs/versions?room={ben.room}&shelf=room&name=pick")
    assert [(row["number"], row["saver"]) for row in rows] == [(3, "Anna"), (2, "Ben"), (1, "Anna")]
    anna.keep(TEXT, 0, shelf="own", name="mine alone")
    assert [row["name"] for row in anna.get(f"/programs?room={anna.room}")["own"]] == ["mine alone"]
    assert ben.get(f"/programs?room={ben.room}")["own"] == []
    assert ben.text(1, shelf="own", name="mine alone").status == 404
    assert ben.post("drop", shelf="room", name="pick").status == 403
    assert anna.post("drop", shelf="own", name="mine alone").status == 204
    assert anna.get(f"/programs?room={anna.room}")["own"] == []
    lead = Person(server, server.supervisor())
    assert lead.post("drop", shelf="room", name="pick").status == 204
    assert lead.get(f"/programs?room={lead.room}")["room"] == []


def test_strangers_and_nonsense_keep_nothing(server: LiveServer) -> None:
    anna = Person(server, server.enter("Anna"))
    fields: dict[str, Any] = {"shelf": "own", "name": "a", "text": TEXT, "seen": 0}
    for changed, status in (
        ({"name": "../../etc/passwd"}, 400),
        ({"name": ""}, 400),
        ({"name": "x" * 41}, 400),
        ({"name": "a\n"}, 400),
        ({"shelf": "own 1"}, 400),
        ({"seen": -1}, 400),
        ({"text": "x" * 200_001}, 400),
        ({"text": "x" * 1_400_000}, 413),
        ({"shelf": "room", "room": "elsewhere"}, 404),
        ({"path": "/etc"}, 400),
    ):
        assert anna.post("keep", **{**fields, **changed}).status == status, str(changed)[:80]
    nobody = {"room": anna.room, **fields}
    assert server.request("POST", "/programs/keep", nobody).status == 401
    foreign = {"cookie": anna.cookie, "origin": "https://evil.example"}
    assert server.request("POST", "/programs/keep", nobody, **foreign).status == 403
    for address in ("number=-1", "number=1e9", "number=%D9%A3", "number=", "shelf=own"):
        path = f"/programs/text?room={anna.room}&name=a&{address}"
        assert server.request("GET", path, cookie=anna.cookie).status == 404
    assert anna.get(f"/programs?room={anna.room}")["own"] == []


def test_who_is_in_no_room_saves_for_themselves(server: LiveServer) -> None:
    dora = Person(server, server.enter("Dora"))
    dora.room = "closed"  # such as by the supervisor, while she wrote
    assert dora.keep(TEXT, 0, shelf="own", name="late")["saved"]
    assert dora.text(1, shelf="own", name="late").json == {"text": TEXT}


def test_who_saves_too_often_waits(server: LiveServer) -> None:
    eve = Person(server, server.enter("Eve"))
    found = [
        eve.post("keep", shelf="own", name="a", text="x", seen=1).status
        for _ in range(int(RATE[1]) + 3)
    ]
    assert found[0] == 200
    assert 429 in found
