"""A real server and real sockets: a class works together, and the server decides who may what."""

import itertools
import json
import re
from collections.abc import Iterator
from time import monotonic
from typing import Any

import msgspec
import pytest

from tests.support_live import PATIENCE, Browser, LiveServer
from vrts.live.session.views.frame import unpacked


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("serving") / "live"
    with LiveServer(folder, "--students-reset", scenes=("cans-on-bases", "one-can-ur5")) as started:
        yield started


@pytest.fixture(autouse=True)
def nobody_stays(server: LiveServer) -> Iterator[None]:
    yield
    server.close_browsers()


def entered(server: LiveServer, name: str) -> Browser:
    """Return somebody who is in the room, with a session that runs."""
    browser = server.join(server.enter(name))
    arrive(browser)
    return browser


def arrive(browser: Browser) -> None:
    browser.wait("welcome")
    state = browser.wait("snapshot")["state"]
    browser.wait("control")
    if state is None:
        browser.wait("state")


def teacher(server: LiveServer) -> Browser:
    """Return a supervisor: further ones come by a link that the database is given."""
    from vrts.live.settings import DATABASE
    from vrts.live.store.accounts import add_link
    from vrts.live.store.database import opened
    from vrts.live.tokens import new_token

    token = new_token()
    connection = opened(server.folder / DATABASE)
    add_link(connection, token, 4e9, supervisor=True, name="teacher")
    connection.close()
    browser = server.join(server.enter("", token))
    arrive(browser)
    return browser


def free(browser: Browser) -> None:
    browser.send("hand_back")
    browser.wait("control", lambda m: m["holder"] == "")


def test_what_the_operator_does_everybody_sees(server: LiveServer) -> None:
    anna, ben = entered(server, "Anna"), entered(server, "Ben")
    lease = anna.take_control()
    assert ben.wait("control", lambda m: m["holder"] != "")["lease"] == "", "only the holder has it"
    of = anna.command(lease, "line", line="DO DRIVE 1,10,100")
    result = anna.wait("result", lambda m: m["of"] == of)
    assert result["result"]["accepted"]
    moved = ben.wait("now", lambda m: abs(m["status"]["joints_rad"][0]) > 0.1)
    ben.wait("now", lambda m: m["status"]["mode"] == "idle")
    assert moved["status"]["mode"] == "moving"
    frames = [unpacked(frame) for frame in ben.frames]
    assert all(len(frame) <= 100 for frame in ben.frames)
    assert [f.sequence for f in frames] == sorted(f.sequence for f in frames)
    assert max(abs(f.joints[0]) for f in frames) > 0.1
    free(anna)


def test_a_viewer_commands_nothing(server: LiveServer) -> None:
    anna, ben = entered(server, "Anna"), entered(server, "Ben")
    lease = anna.take_control()
    for action in ({"type": "ready"}, {"type": "line", "line": "DO READY"}):
        ben.send("command", lease=lease, number=1, action=action)
        assert ben.wait("refused")["code"] == "role", "a stolen lease is of no use"
    ben.send("panic")
    assert ben.wait("refused")["code"] == "role"
    free(anna)


SUPERVISION: list[dict[str, Any]] = [
    {"type": "hand_over", "person": ""},
    {"type": "lock", "on": True},
    {"type": "freeze", "on": True, "everywhere": True},
    {"type": "kick", "person": "x"},
    {"type": "allow", "name": "x"},
    {"type": "mute", "person": "x", "on": True},
    {"type": "unmute", "name": "x"},
    {"type": "set_chat", "on": False},
    {"type": "set_turn", "turn_s": 1, "idle_s": 1},
    {"type": "set_scene", "scene": "one-can-ur5"},
    {"type": "go_on", "without_last": True},
    {"type": "make_rooms", "rooms": [{"name": "x", "scene": "cans-on-bases"}]},
    {"type": "close_room", "room": "x"},
    {"type": "broadcast", "text": "x"},
    {"type": "end_announcement"},
    {"type": "watch_wall", "on": True},
    {"type": "project", "room": "x"},
    {"type": "export_log", "of": 1, "room": "x"},
]


def test_only_a_supervisor_supervises(server: LiveServer) -> None:
    from vrts.live.rooms.supervising import Supervision

    kinds = {kind.__struct_config__.tag for kind in Supervision.__args__}
    assert {fields["type"] for fields in SUPERVISION} == kinds, "each is tried"
    anna = entered(server, "Anna")
    lease = anna.take_control()
    assert lease
    for fields in SUPERVISION:
        anna.socket.send(json.dumps(fields))
        refused = anna.wait("refused")
        assert (refused["code"], refused["text"]) == (
            "role",
            "only a supervisor may do this",
        ), fields
    free(anna)


def test_repeated_old_and_foreign_commands_do_not_count(server: LiveServer) -> None:
    anna = entered(server, "Anna")
    lease = anna.take_control()
    of = anna.command(lease, "hand", open=True)
    assert anna.wait("result")["of"] == of
    anna.send("command", lease=lease, number=of, action={"type": "hand", "open": True})
    assert anna.wait("refused")["code"] == "replayed"
    anna.send("command", lease="x" * 43, number=of + 1, action={"type": "ready"})
    assert anna.wait("refused")["code"] == "lease"
    free(anna)
    anna.send("command", lease=lease, number=of + 2, action={"type": "ready"})
    assert anna.wait("refused")["code"] == "role"
    again = anna.take_control()
    anna.send("command", lease=lease, number=of + 3, action={"type": "ready"})
    assert anna.wait("refused")["code"] == "lease"
    assert again != lease
    free(anna)


def test_the_right_passes_on_when_the_holder_hands_it_back(server: LiveServer) -> None:
    anna, ben = entered(server, "Anna"), entered(server, "Ben")
    anna.take_control()
    ben.send("request_control")
    queue = anna.wait("control", lambda m: m["queue"] != [])
    anna.send("hand_back")
    mine = ben.wait("control", lambda m: m["lease"] != "")
    assert mine["holder"] == queue["queue"][0]
    free(ben)


def test_a_supervisor_takes_locks_and_freezes(server: LiveServer) -> None:
    anna, boss = entered(server, "Anna"), teacher(server)
    lease = anna.take_control()
    boss.send("lock", on=True)
    anna.wait("control", lambda m: m["locked"])
    anna.command(lease, "ready")
    assert anna.wait("refused")["code"] == "locked"
    boss.send("lock", on=False)
    boss.send("freeze", on=True)
    anna.wait("control", lambda m: m["frozen"])
    anna.command(lease, "ready")
    assert anna.wait("refused")["code"] == "frozen"
    boss.send("freeze", on=False)
    anna.wait("control", lambda m: not m["frozen"])
    boss.send("hand_over", person=person_of(boss))
    taken = boss.wait("control", lambda m: m["lease"] != "")
    anna.command(lease, "ready")
    assert anna.wait("refused")["code"] == "role"
    me = next(p["id"] for p in people(anna) if p["name"] == name_of(anna))
    boss.send("hand_over", person=me)
    assert anna.wait("control", lambda m: m["lease"] != "")["lease"] != taken["lease"]
    boss.send("request_control")
    boss.wait("control", lambda m: m["queue"] != [])
    boss.send("hand_over")
    boss.wait("control", lambda m: m["lease"] != "", patience=5.0)
    boss.send("hand_over")
    assert anna.wait("control", lambda m: m["holder"] == "")["queue"] == []


def people(browser: Browser) -> list[dict[str, object]]:
    told = [m for m in browser.came if m["type"] == "people"]
    return (told[-1] if told else browser.wait("people"))["people"]


def person_of(browser: Browser) -> str:
    return next(m["you"] for m in browser.came if m["type"] == "welcome")


def name_of(browser: Browser) -> str:
    return next(m["name"] for m in browser.came if m["type"] == "welcome")


def test_panic_stops_the_arm_and_is_never_held_back(server: LiveServer) -> None:
    anna, boss = entered(server, "Anna"), teacher(server)
    lease = anna.take_control()
    anna.command(lease, "line", line="DO DRIVE 1,-120,100")
    anna.wait("now", lambda m: m["status"]["mode"] == "moving")
    for _ in range(200):  # far beyond every limit
        anna.send("rate", rate=50)
    anna.wait("refused", lambda m: m["code"] == "rate")
    boss.send("panic")
    anna.send("panic")
    anna.wait("now", lambda m: m["status"]["mode"] == "idle")
    anna.quiet(0.5)
    before, after = (unpacked(frame).joints for frame in anna.take_frames(2)[-2:])
    assert after == before
    assert before[0] > -1.9, "it stopped on its way"
    anna.quiet(1.0)  # until messages count again
    free(anna)


def test_a_held_key_moves_until_its_heartbeat_ends(server: LiveServer) -> None:
    anna = entered(server, "Anna")
    lease = anna.take_control()
    start = unpacked(anna.take_frames(1)[-1]).joints[0]
    anna.command(lease, "jog", frame="joint", axis=0, way=1, speed=0.5)
    moving, latest = start, monotonic() + PATIENCE
    while moving <= start + 0.02 and monotonic() < latest:
        anna.quiet(0.1)
        anna.command(lease, "keep")
        moving = unpacked(anna.frames[-1]).joints[0]
    assert moving > start + 0.02
    now, before = moving, start
    while now != before and monotonic() < latest:  # no heartbeat
        before = now
        anna.quiet(0.5)
        now = unpacked(anna.take_frames(1)[-1]).joints[0]
    assert now == before
    assert now < 2.6, "it was not the end of the joint that stopped it"
    free(anna)


def test_chat_reaches_the_room_and_private_lines_only_their_ends(server: LiveServer) -> None:
    anna, ben, boss = entered(server, "Anna"), entered(server, "Ben"), teacher(server)
    anna.send("say", text="hello <script>alert(1)</script>\u202e")
    for one in (anna, ben, boss):
        said = one.wait("chat", lambda m: m["text"].startswith("hello"))
        assert said["text"] == "hello <script>alert(1)</script>�", "escaped by the page, not here"
    anna.send("say", text="to you alone", private=True)
    assert boss.wait("chat", lambda m: m["private"])["text"] == "to you alone"
    person = boss.came[-1]["person"]
    boss.send("say", text="answer", to=person)
    assert anna.wait("chat", lambda m: m["text"] == "answer")["to"] == name_of(anna)
    anna.send("say", text="public again")
    ben.wait("chat", lambda m: m["text"] == "public again")
    assert not any(m["type"] == "chat" and m["private"] for m in ben.came)
    late = server.join(server.enter("Late"))
    history = [line["text"] for line in late.wait("snapshot")["chat"]]
    assert "public again" in history
    assert "answer" not in history


def test_chat_can_be_off_and_people_muted_and_sent_away(server: LiveServer) -> None:
    anna, boss = entered(server, "Anna"), teacher(server)
    boss.send("set_chat", on=False)
    anna.wait("control", lambda m: not m["chat"])
    anna.send("say", text="x")
    assert anna.wait("refused")["code"] == "chat"
    boss.send("set_chat", on=True)
    anna.wait("control", lambda m: m["chat"])
    me = next(m["you"] for m in anna.came if m["type"] == "welcome")
    boss.wait("people", lambda m: any(p["id"] == me for p in m["people"]))
    boss.send("mute", person=me, on=True)
    anna.wait("people", lambda m: any(p["id"] == me and p["muted"] for p in m["people"]))
    anna.send("say", text="x")
    assert anna.wait("refused")["code"] == "muted"
    boss.send("kick", person=me)
    closed = anna.closed()
    assert closed is not None
    assert (closed["type"], closed["code"]) == ("closed", "kicked")


def test_rates_are_chosen_by_each(server: LiveServer) -> None:
    fast, slow = entered(server, "Fast"), entered(server, "Slow")
    slow.send("rate", rate=5)
    slow.take_frames(4)  # some may have been on their way
    rates: list[tuple[float, float]] = []
    for browser, count in ((slow, 12), (fast, 60)):
        times = [unpacked(frame).time_s for frame in browser.take_frames(count)]
        gaps = [later - earlier for earlier, later in itertools.pairwise(times)]
        rates.append((sum(gaps) / len(gaps), min(gaps)))
    (mean_slow, least_slow), (mean_fast, least_fast) = rates
    assert mean_slow > 0.15, "five in a second of the session"
    assert mean_slow > 2.0 * mean_fast, "and more to who asked for nothing else"
    assert least_slow < 0.3, "no fewer than asked for, but where the machine is busy"
    assert least_fast < 0.05


def test_reach_and_programs_are_answered(server: LiveServer) -> None:
    anna = entered(server, "Anna")
    anna.send("reach", of=3, position_m=[9.0, 0.0, 0.0], oat_rad=[0.0, 1.57, 0.0])
    far = anna.wait("reached", lambda m: m["of"] == 3)
    assert not far["result"]["reachable"]
    anna.send("reach", of=4, position_m=[0.7, 0.2, 0.1], oat_rad=[0.0, 1.5707963, 0.0])
    assert anna.wait("reached", lambda m: m["of"] == 4)["result"]["reachable"]
    anna.send("program", of=5, name="demo")
    assert ".PROGRAM" in anna.wait("program_text")["result"]["text"]


@pytest.mark.thorough
def test_rooms_walls_and_logs(server: LiveServer) -> None:
    boss = teacher(server)
    rooms = [{"name": f"Group {n}", "scene": "one-can-ur5"} for n in (1, 2)]
    boss.send("make_rooms", rooms=[*rooms, {"name": "x", "scene": "../../etc/passwd"}])
    assert boss.wait("refused")["code"] == "scene"
    boss.send("make_rooms", rooms=rooms)
    told = boss.wait("rooms", lambda m: len(m["rooms"]) == 3)
    group = next(room for room in told["rooms"] if room["name"] == "Group 1")
    boss.send("watch_wall", on=True)
    row = boss.wait("wall", lambda m: all(r["bodies"] for r in m["rooms"]))["rooms"][1]
    assert (row["name"], len(row["joints_rad"])) == ("Group 1", 6)
    assert [(body["lie"], len(body["X"])) for body in row["bodies"]] == [("resting", 12)]
    later = boss.wait("wall", lambda m: m["rooms"][1]["time_s"] > row["time_s"] + 0.5)
    assert later["rooms"][1]["joints_rad"] == row["joints_rad"], "time goes on where nothing moves"
    boss.send("project", room=group["id"])
    boss.wait("rooms", lambda m: m["projector"] == group["id"])

    cookie = server.enter("Gina")
    gina = server.join(cookie, room=group["id"])
    assert gina.wait("snapshot")["room"]["name"] == "Group 1"
    lease = gina.take_control()
    gina.command(lease, "line", line="DO READY")
    gina.wait("result")
    boss.send("broadcast", text="five minutes left")
    gina.wait("chat", lambda m: m["text"] == "five minutes left")

    boss.send("export_log", of=9, room=group["id"])
    url = boss.wait("log_file")["url"]
    assert server.request("GET", url, cookie=cookie).status == 403
    boss_cookie = boss.socket.request.headers["cookie"]  # type: ignore[union-attr]
    replay = f"/replay/{group['id']}"
    assert server.request("GET", replay, cookie=cookie).status == 403
    page = server.request("GET", replay, cookie=boss_cookie)
    assert page.status == 200, page.body
    assert page.headers["content-disposition"].startswith("attachment;")
    assert b"READY" in page.body
    nothing = next(room["id"] for room in told["rooms"] if room["name"] == "Group 2")
    refused = server.request("GET", f"/replay/{nothing}", cookie=boss_cookie)
    assert (refused.status, refused.json["text"]) == (409, "nothing was done in this room yet")
    text = server.request("GET", url, cookie=boss_cookie).body
    rows = [msgspec.json.decode(line) for line in text.splitlines()]
    commands = [row for row in rows[1:] if row["kind"] == "line"]
    assert commands[0]["text"]["action"] == {"type": "line", "line": "DO READY"}
    assert commands[0]["text"]["result"]["at_s"] == pytest.approx(commands[0]["at_s"], abs=1e-6)
    assert commands[0]["name"] == "Gina"
    kinds = [row["kind"] for row in rows[1:]]
    assert kinds[0] == "begin"
    assert "join" in kinds
    assert [kind for kind in kinds if kind != "join"][1] == "control"

    boss.send("close_room", room=group["id"])
    closed = gina.closed()
    assert closed is not None
    assert closed["code"] == "room closed"
    boss.send("close_room", room=nothing)
    boss.wait("rooms", lambda m: len(m["rooms"]) == 1)
    boss.send("close_room", room=told["rooms"][0]["id"])
    assert boss.wait("refused")["text"] == "the last room stays open"


def test_another_scene_begins_anew(server: LiveServer) -> None:
    anna, boss = entered(server, "Anna"), teacher(server)
    session = next(m["session"] for m in anna.came if m["type"] == "snapshot")
    boss.send("set_scene", scene="one-can-ur5")
    gone = anna.wait("state")
    assert (gone["session"], gone["scene_url"], gone["state"]) == (session, "", None)
    state = anna.wait("state", lambda m: m["session"] != session)
    cookie = server.enter("Gerd")
    scene = server.request("GET", state["scene_url"], cookie=cookie)
    assert scene.json["robot"]["arm"]["name"] == "ur5"
    again = server.request(
        "GET", state["scene_url"], cookie=cookie, if_none_match=scene.headers["etag"]
    )
    assert again.status == 304
    assert server.request("GET", state["scene_url"]).status == 401
    latest = monotonic() + PATIENCE
    while unpacked(anna.take_frames(1)[-1]).session != state["session"]:
        assert monotonic() < latest, "the page is shown the robot of before"


def test_who_comes_back_has_missed_nothing(server: LiveServer) -> None:
    anna, ben = entered(server, "Anna"), entered(server, "Ben")
    cookie = anna.socket.request.headers["cookie"]  # type: ignore[union-attr]
    lease = anna.take_control()
    welcome = next(m for m in anna.came if m["type"] == "welcome")
    seen = max(m["number"] for m in anna.came if "number" in m)
    anna.socket.close()
    ben.wait("people", lambda m: any(p["id"] == welcome["you"] and p["away"] for p in m["people"]))
    for n in range(3):
        ben.send("say", text=f"line {n}")
    ben.wait("chat", lambda m: m["text"] == "line 2")
    back = server.join(cookie, resume=welcome["resume"], seen=seen)
    again = back.wait("welcome")
    assert (again["you"], again["resumed"]) == (welcome["you"], True)
    back.wait("snapshot")
    chat = [m["text"] for m in back.came if m["type"] == "chat"]
    assert chat[-3:] == ["line 0", "line 1", "line 2"]
    numbers = [m["number"] for m in back.came if m["type"] in ("chat", "event", "result")]
    assert numbers == sorted(set(numbers))
    assert numbers[0] > seen
    assert back.wait("control")["lease"] == lease, "the control right was kept meanwhile"
    foreign = server.join(server.enter("Eve"), resume=welcome["resume"], seen=seen)
    assert not foreign.wait("welcome")["resumed"], "a token of somebody else is of no use"
    free(back)


def carried(server: LiveServer, path: str, cookie: str) -> Any:
    """Return what the page brings along, None when it is the page of everybody."""
    page = server.request("GET", path, cookie=cookie)
    assert page.status == 200
    text = page.body.decode()
    found = re.findall(r'<script type="application/json" id="carried">(.*)</script>', text)
    assert (page.headers["cache-control"] == "no-store") == bool(found), "nobody else may keep it"
    assert text.count("</script>") == 2 + len(found), "no name ends the block"
    return json.loads(found[0]) if found else None


def test_the_page_brings_along_how_the_arm_stands_now(server: LiveServer) -> None:
    cookie = server.enter("Eve </script><b>")
    eve = server.join(cookie)
    arrive(eve)
    lease = eve.take_control()
    of = eve.command(lease, "line", line="DO DRIVE 2,-15,100")
    eve.wait("result", lambda m: m["of"] == of)
    eve.wait("now", lambda m: m["status"]["mode"] == "idle")
    last = unpacked(eve.frames[-1])
    brought = carried(server, "/", cookie)
    still = brought["still"]
    assert brought["me"] == server.request("GET", "/me", cookie=cookie).json
    assert still["joints_rad"] == pytest.approx(last.joints, abs=1e-4)
    assert still["scene"] == server.request("GET", still["scene_url"], cookie=cookie).json
    movable = {body["name"] for body in still["scene"]["bodies"] if body["movable"]}
    assert {row["body"] for row in still["bodies"]} == movable != set()
    assert len(still["tool"]) == 12
    free(eve)


def test_the_page_brings_nothing_to_who_may_not_see_it(server: LiveServer) -> None:
    assert carried(server, "/", "") is None
    assert carried(server, "/", "vrts=made-up") is None
    cookie = server.enter("Finn")
    assert carried(server, "/?wall", cookie) is None
    assert carried(server, "/admin", cookie) is None
    assert carried(server, "/?room=elsewhere", cookie)["still"] is None
    finn = server.join(cookie)
    arrive(finn)
    own = finn.wait("rooms")["rooms"][0]["id"]
    assert carried(server, f"/?room={own}", cookie)["still"]["scene_url"].split("/")[2] == own
    boss = teacher(server)
    person = boss.wait("people", lambda m: any(p["name"] == "Finn" for p in m["people"]))
    id_ = next(p["id"] for p in person["people"] if p["name"] == "Finn")
    boss.send("kick", person=id_)
    assert finn.closed() is not None
    assert carried(server, f"/?room={own}", cookie)["still"] is None, "sent away from it"
