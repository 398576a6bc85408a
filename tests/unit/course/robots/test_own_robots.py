"""A robot of their own for each student, opened, asleep, woken, nobody else's."""

from pathlib import Path

from tests.support_course import came_in, course_folder
from tests.support_live import LiveServer
from vrts.live.settings import SESSIONS

MORE = '[robots]\nawake = 5\n[slots]\ntime_zone = "UTC"\nhours = "00:00-24:00"\n'


def opened_robot(server: LiveServer, cookie: str, scene: str = "cans-on-bases") -> str:
    """Open one's own robot; return the room's id."""
    answer = server.request("POST", "/course/robots", {"scene": scene}, cookie=cookie)
    assert answer.status == 200, answer.body
    return answer.json["room"]


def sleeps(server: LiveServer, cookie: str, room: str) -> bool:
    """Whether somebody's own robot is asleep; the class's rooms are awake, or begin to be."""
    robots = server.request("GET", "/course/robots", cookie=cookie).json["robots"]
    (asleep,) = (one["asleep"] for one in robots if one["room"] == room)
    return asleep


def test_a_student_has_a_robot_that_nobody_else_enters_and_that_outlasts_the_server(
    tmp_path: Path,
) -> None:
    course = course_folder(tmp_path / "course", more=MORE)
    server = LiveServer(tmp_path / "live", scenes=(str(course),))
    anna_cookie, bo_cookie = came_in(server, "Cy Dahl"), came_in(server, "Di Ek")
    room = opened_robot(server, anna_cookie)
    assert opened_robot(server, anna_cookie) == room, "it is made once"
    assert sleeps(server, anna_cookie, room), "until it is entered"
    assert not [*(server.folder / SESSIONS).glob(f"{room}-*")], "so it never had a session"
    bo = server.join(bo_cookie, room=room)
    closed = bo.closed()
    assert closed is not None
    assert (closed["type"], closed["text"]) == ("closed", "there is no such room any more")
    bo = server.join(bo_cookie)
    assert room not in [row["id"] for row in bo.wait("snapshot")["rooms"]]
    guest = server.enter("Guest")
    answer = server.request("POST", "/course/robots", {"scene": "cans-on-bases"}, cookie=guest)
    assert answer.status == 403
    (first, *_) = server.request("GET", "/course/slots", cookie=bo_cookie).json["slots"]
    for who, more in ((guest, {}), (bo_cookie, {"name": "Cy Dahl"})):
        wanted = {"do": "book", "starts": first["starts"], **more}
        answer = server.request("POST", "/course/slots", wanted, cookie=who)
        assert answer.status == 403, "a guest, and for somebody else"
    anna = server.join(anna_cookie, room=room)
    assert anna.wait("snapshot")["room"]["own"] == "Cy Dahl"
    lease = anna.wait("control", lambda m: m["lease"] != "")["lease"]
    anna.wait("state", lambda m: m["state"] is not None)
    assert anna.answer(anna.command(lease, "line", line="DO a = 7"))["result"]["accepted"]
    anna.send("raise_hand", up=True, text="it does not close")
    bo.send("lower_hand", room=room)
    assert bo.wait("refused")["code"] == "role"
    boss_cookie = server.supervisor()
    boss = server.join(boss_cookie)
    (hand,) = boss.wait("hands", lambda m: m["hands"] != [])["hands"]
    assert (hand["room"], hand["name"], hand["place"]) == (room, "Cy Dahl", 1)
    board = server.request("GET", "/course/board/now", cookie=boss_cookie).json
    (waits,) = board["waits"]
    told = (waits["name"], waits["room"], waits["text"])
    assert told == ("Cy Dahl", room, "it does not close"), "and the board says so"
    number = anna.came[[m["type"] for m in anna.came].index("snapshot")]["session"]
    seen = server.request("GET", f"/scene/{room}/{number}", cookie=boss_cookie)
    assert seen.status in (403, 404), "nobody looks in unseen"
    anna.wait("hands", lambda m: m["hands"] != [])
    server.close_browsers()
    server.kill()
    server.start("0")
    with server:
        cookie = anna_cookie.replace(anna_cookie.partition("=")[0], f"vrts_{server.port}")
        assert opened_robot(server, cookie) == room
        assert sleeps(server, cookie, room), "a new server wakes nobody's"
        anna = server.join(cookie, room=room)
        lease = anna.wait("control", lambda m: m["lease"] != "")["lease"]
        assert anna.wait("hands")["hands"][0]["text"] == "it does not close"
        anna.wait("state", lambda m: m["state"] is not None)
        said = anna.answer(anna.command(lease, "line", line="LISTR a"))["result"]["text"]
        assert "7" in said, "it is as it was"
