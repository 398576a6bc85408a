"""Who may do what in a course: teachers everywhere, assistants in their rooms, others nothing."""

import asyncio
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

import pytest

from tests.support_course import COURSE, PASSWORD, ROSTER, came_in, course_folder, letter
from tests.support_live import Browser, LiveServer
from vrts.live.passwords import Passwords
from vrts.live.rooms.supervising import Supervision
from vrts.live.store.accounts import NOT_CHOSEN


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = course_folder(tmp_path_factory.mktemp("rights") / "course")
    with LiveServer(folder.parent / "live", scenes=(str(folder),)) as started:
        yield started


@pytest.fixture(autouse=True)
def nobody_stays(server: LiveServer) -> Iterator[None]:
    yield
    server.close_browsers()


@pytest.fixture(scope="module")
def ada(server: LiveServer) -> str:
    return came_in(server, "Ada Lind")


@pytest.fixture(scope="module")
def bo(server: LiveServer) -> str:
    return came_in(server, "Bo Berg")


@pytest.fixture(scope="module")
def cy(server: LiveServer) -> str:
    return came_in(server, "Cy Dahl")


def rooms(server: LiveServer, cookie: str) -> dict[str, str]:
    told = server.request("GET", "/me", cookie=cookie).json
    return {room["name"]: room["id"] for room in told["rooms"]}


def inside(server: LiveServer, cookie: str, room: str) -> tuple[Browser, dict[str, Any]]:
    """Join a room; return the browser and its welcome."""
    browser = server.join(cookie, room=room)
    welcome = browser.wait("welcome")
    browser.wait("snapshot")
    return browser, welcome


def refusal(browser: Browser, type_: str, **fields: Any) -> str:
    """Send a message that must be refused; return the words."""
    browser.send(type_, **fields)
    return browser.wait("refused", lambda m: m["code"] == "role")["text"]


def messages(room: str, person: str) -> dict[str, dict[str, Any]]:
    """Return every message of supervisors."""
    return {
        "hand_over": {"person": person},
        "lower_hand": {"room": room},
        "lock": {"on": True},
        "freeze": {"on": True},
        "kick": {"person": person},
        "allow": {"name": "Cy Dahl"},
        "mute": {"person": person, "on": True},
        "unmute": {"name": "Cy Dahl"},
        "set_chat": {"on": False},
        "set_turn": {"turn_s": 10.0, "idle_s": 10.0},
        "set_scene": {"scene": "cans-on-bases"},
        "go_on": {},
        "make_rooms": {"rooms": [{"name": "More", "scene": "cans-on-bases"}]},
        "close_room": {"room": room},
        "broadcast": {"text": "hear"},
        "end_announcement": {},
        "watch_wall": {"on": True},
        "project": {"room": room},
        "export_log": {"room": room, "of": 1},
    }


def test_no_message_of_supervisors_is_left_out() -> None:
    tags = {str(kind.__struct_config__.tag) for kind in get_args(Supervision)}
    assert tags | {"lower_hand"} == set(messages("", ""))


def test_an_assistant_elsewhere_can_do_nothing_that_a_student_cannot(
    server: LiveServer, bo: str, cy: str
) -> None:
    there = rooms(server, bo)
    browser, welcome = inside(server, bo, there["Class"])
    student, you = inside(server, cy, there["Class"])
    assert not welcome["supervisor"]
    for type_, fields in messages(there["Class"], you["you"]).items():
        assert refusal(browser, type_, **fields).startswith("only"), type_
    browser.send("panic")
    assert browser.wait("refused")["code"] == "role"
    for path in (
        f"/log/{there['Class']}",
        f"/replay/{there['Class']}",
        "/code",
        "/ways",
        "/code.svg",
    ):
        assert server.request("GET", path, cookie=bo).status == 403, path
    for path in ("/admin/now", "/course/people/list"):
        assert server.request("GET", path, cookie=bo).status == 403, path
    body = {"room": there["Lab"]}
    assert server.request("POST", "/link", body, cookie=bo).status == 403
    assert server.request("POST", "/ways", {"do": "renew"}, cookie=bo).status == 403
    for path in ("add", "link", "end"):
        answer = server.request("POST", f"/course/people/{path}", {"account": 1}, cookie=bo)
        assert answer.status == 403, path
    student.send("say", text="to whom it leads", private=True)
    student.wait("chat", lambda m: m["private"])
    student.send("say", text="to all")
    browser.wait("chat", lambda m: m["text"] == "to all")
    assert not [m for m in browser.came if m["type"] == "chat" and m.get("private")]
    told = [m for m in browser.came if m["type"] == "people"] or [browser.wait("people")]
    assert {one["role"] for m in told for one in m["people"]} == {"viewer"}
    assert not [m for m in browser.came if m["type"] in ("code", "wall", "log_file")]


def test_an_assistant_leads_their_own_room_and_no_more(
    server: LiveServer, ada: str, bo: str, cy: str
) -> None:
    there = rooms(server, bo)
    browser, welcome = inside(server, bo, there["Lab"])
    student, you = inside(server, cy, there["Lab"])
    assert welcome["supervisor"]
    assert browser.wait("people")["people"][0]["role"] == "supervisor"
    student.send("say", text="help", private=True)
    assert browser.wait("chat", lambda m: m["private"])["text"] == "help"
    for on in (True, False):
        browser.send("set_chat", on=on)
        browser.wait("control", lambda m, on=on: m["chat"] is on)
    browser.send("set_chat", on=True)
    browser.send("watch_wall", on=True)
    assert [row["name"] for row in browser.wait("wall")["rooms"]] == ["Lab"]
    beyond = {
        "mute": {"person": you["you"], "on": True},
        "unmute": {"name": "Cy Dahl"},
        "make_rooms": {"rooms": [{"name": "More", "scene": "cans-on-bases"}]},
        "close_room": {"room": there["Class"]},
        "broadcast": {"text": "hear"},
        "end_announcement": {},
        "project": {"room": there["Lab"]},
        "export_log": {"room": there["Class"], "of": 1},
        "freeze": {"on": True, "everywhere": True},
    }
    for type_, fields in beyond.items():
        refusal(browser, type_, **fields)
    assert server.request("GET", f"/log/{there['Lab']}", cookie=bo).status == 200
    assert server.request("GET", f"/log/{there['Class']}", cookie=bo).status == 403
    assert [m for m in browser.came if m["type"] == "code"] == []
    teacher, _ = inside(server, ada, there["Lab"])
    teacher.wait("code")
    browser.send("kick", person=teacher.came[0]["you"])
    assert browser.wait("refused")["text"] == "a supervisor cannot be sent away"


def test_somebody_comes_in_by_a_link_once_and_by_a_password_later(server: LiveServer) -> None:
    code = letter(server, "Di Ek")
    body = {"code": code, "password": PASSWORD}
    told = server.request("POST", "/course/letter", {"code": code}).json
    assert told == {"course": "Robotics", "name": "Di Ek", "email": "di@example.org"}
    assert server.request("POST", "/course/password", body | {"password": "short"}).status == 400
    assert server.request("POST", "/course/password", body).status == 200
    assert server.request("POST", "/course/password", body).status == 403
    assert server.request("POST", "/course/letter", {"code": code}).status == 403
    for user in ("Di@Example.org", "Di Ek"):
        answer = server.request("POST", "/login", {"user": user, "password": PASSWORD})
        assert answer.status == 200, user
    wrong = {"user": "di@example.org", "password": "another one"}
    assert server.request("POST", "/login", wrong).status == 403
    fresh = server.request("GET", "/me", cookie=answer.cookie)
    assert (fresh.json["name"], fresh.json["supervisor"]) == ("Di Ek", False)


def test_who_has_not_chosen_a_password_does_not_log_in_without_one() -> None:
    for typed in (NOT_CHOSEN, "anything"):
        assert asyncio.run(Passwords().right(typed, NOT_CHOSEN, "an address")) is False


@pytest.mark.thorough
def test_people_follow_the_files_while_the_server_runs(
    server: LiveServer, ada: str, cy: str, tmp_path: Path
) -> None:
    folder = server.folder.parent / "course"
    room = rooms(server, cy)["Class"]
    teacher, _ = inside(server, ada, room)
    student, welcome = inside(server, cy, room)
    assert not welcome["supervisor"]

    def write(name: str, text: str) -> None:
        new = tmp_path / name
        new.write_text(text)
        os.replace(new, folder / name)

    # Cy teaches from now on: the page comes back by itself, with the rights of a teacher
    course = COURSE.format(guests="true")
    cy_too = '\n[[teacher]]\nname = "Cy Dahl"\nemail = "cy@example.org"\n'
    write("course.toml", course + cy_too)
    student.closed()
    student, welcome = inside(server, cy, room)
    assert welcome["supervisor"]
    assert server.request("GET", "/course/people/list", cookie=cy).status == 200
    # a faulty file changes nothing, and teachers are told
    write("course.toml", course + "[[teacher]]\n")
    teacher.wait("chat", lambda m: "people stay as they were" in m["text"])
    told = server.request("GET", "/course/people/list", cookie=cy).json  # who teaches still
    assert told["fault"] == "`[teacher 2]` needs `name`, and 1 more"
    # who is taken off both lists is sent away, and does not come in again
    write("course.toml", course)
    write("roster.csv", "name,email\nDi Ek,di@example.org\n")
    student.closed()
    assert student.came[-1]["type"] == "closed"
    assert server.request("GET", "/me", cookie=cy).status == 401
    answer = server.request("POST", "/login", {"user": "cy@example.org", "password": PASSWORD})
    assert (answer.status, answer.json["code"]) == (403, "left")
    write("roster.csv", ROSTER)
