"""A robot of their own for each student, opened, asleep, woken, nobody else's."""

from pathlib import Path

from tests.support_course import came_in, course_folder
from tests.support_live import Browser, Json, LiveServer, session_processes


def opened_robot(server: LiveServer, cookie: str, scene: str = "cans-on-bases") -> str:
    """Open one's own robot; return the room's id."""
    answer = server.request("POST", "/course/robots", {"scene": scene}, cookie=cookie)
    assert answer.status == 200, answer.body
    return answer.json["room"]


def woken(browser: Browser) -> Json:
    """Wait until the session of the room that was entered runs; return its state."""
    state = browser.wait("snapshot")["state"]
    while state is None:
        state = browser.wait("state")["state"]
    return state


def test_a_student_has_a_robot_that_nobody_else_enters_and_that_outlasts_the_server(
    tmp_path: Path,
) -> None:
    course = course_folder(tmp_path / "course", more="[robots]\nawake = 5\n")
    server = LiveServer(tmp_path / "live", scenes=(str(course),))
    anna_cookie, bo_cookie = came_in(server, "Cy Dahl"), came_in(server, "Di Ek")
    room = opened_robot(server, anna_cookie)
    assert opened_robot(server, anna_cookie) == room, "it is made once"
    assert len(session_processes(server.process.pid)) <= 1, "it sleeps until it is entered"
    bo = server.join(bo_cookie, room=room)
    closed = bo.closed()
    assert closed is not None
    assert (closed["type"], closed["text"]) == ("closed", "there is no such room any more")
    bo = server.join(bo_cookie)
    assert room not in [row["id"] for row in bo.wait("snapshot")["rooms"]]
    guest = server.enter("Guest")
    answer = server.request("POST", "/course/robots", {"scene": "cans-on-bases"}, cookie=guest)
    assert answer.status == 403
    anna = server.join(anna_cookie, room=room)
    assert anna.wait("snapshot")["room"]["own"] == "Cy Dahl"
    lease = anna.wait("control", lambda m: m["lease"] != "")["lease"]
    anna.wait("state", lambda m: m["state"] is not None)
    assert anna.answer(anna.command(lease, "line", line="DO a = 7"))["result"]["accepted"]
    server.close_browsers()
    server.kill()
    server.start("0")
    with server:
        assert len(session_processes(server.process.pid)) <= 1, "all sleep"
        cookie = anna_cookie.replace(anna_cookie.partition("=")[0], f"vrts_{server.port}")
        assert opened_robot(server, cookie) == room
        anna = server.join(cookie, room=room)
        lease = anna.wait("control", lambda m: m["lease"] != "")["lease"]
        anna.wait("state", lambda m: m["state"] is not None)
        said = anna.answer(anna.command(lease, "line", line="LISTR a"))["result"]["text"]
        assert "7" in said, "it is as it was"
