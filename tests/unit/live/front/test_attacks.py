"""What hostile pages, clients and people try against a real server."""

import contextlib
import json
import sqlite3
from collections.abc import Iterator

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from tests.support_live import LiveServer
from vrts.live.front.sockets.socket import MOST_BAD
from vrts.live.limits import EXCESS
from vrts.live.protocol.fields import LONGEST_CHAT, LONGEST_MESSAGE
from vrts.live.settings import DATABASE

NASTY = [
    "'; DROP TABLE account; --",
    '" OR "1"="1',
    "<img src=x onerror=alert(1)>",
    "../../../etc/passwd",
    "..\\..\\windows",
    "%2e%2e%2f",
    "\x00\x1b[2J",
    "{{7*7}} ${7*7}",
    "=cmd|' /C calc'!A0",
]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("attacks") / "live") as started:
        yield started


@pytest.fixture(autouse=True)
def nobody_stays(server: LiveServer) -> Iterator[None]:
    yield
    server.close_browsers()


@pytest.mark.parametrize("origin", ["https://evil.example", "null", "http://127.0.0.1:1", ""])
def test_a_page_of_another_site_gets_no_socket(server: LiveServer, origin: str) -> None:
    cookie = server.enter("Anna")
    with pytest.raises(InvalidStatus) as refused:
        server.open(cookie, origin=origin)
    assert refused.value.response.status_code == 403
    server.open(cookie)


def test_a_page_of_another_site_posts_nothing(server: LiveServer) -> None:
    body = {"code": server.code, "name": "Eve"}
    assert server.request("POST", "/enter", body, origin="https://evil.example").status == 403
    assert server.request("POST", "/enter", body, origin="").status == 403
    assert server.request("POST", "/enter", body, content_type="text/plain").status == 415


def test_a_rebound_name_gets_nothing(server: LiveServer) -> None:
    for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1.evil.example", ""):
        for path in ("/", "/me", "/web/viewer/player.js"):
            assert server.request("GET", path, host=host, origin="").status in (400, 421)
    with pytest.raises(InvalidStatus) as refused:
        server.open("", origin="http://evil.example", host="evil.example")
    assert refused.value.response.status_code in (403, 421, 400)


def test_every_answer_binds_the_browser(server: LiveServer) -> None:
    for path in ("/", "/web/viewer/player.js", "/me", "/nothing", "/log/x"):
        headers = server.request("GET", path).headers
        policy = headers["content-security-policy"]
        assert "default-src 'none'" in policy
        assert "script-src 'self';" in policy
        assert "unsafe" not in policy
        assert "frame-ancestors 'none'" in policy
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"
        assert headers["server"] is None


def test_cookies_are_out_of_reach_and_kept_as_digests(server: LiveServer) -> None:
    body = {"code": server.code, "name": "Anna"}
    answer = server.request("POST", "/enter", body)
    cookie = answer.headers["set-cookie"] or ""
    assert "HttpOnly" in cookie
    assert "SameSite=strict" in cookie
    token = answer.cookie.split("=", 1)[1]
    assert len(token) >= 43
    with sqlite3.connect(server.folder / DATABASE) as connection:
        dump = "\n".join(connection.iterdump())
    connection.close()
    for secret in (token, server.code, server.supervisor_token):
        assert secret not in dump
    assert server.request("GET", "/me", cookie=answer.cookie).json["name"].startswith("Anna")
    assert server.request("POST", "/logout", cookie=answer.cookie).status == 204
    assert server.request("GET", "/me", cookie=answer.cookie).status == 401
    with pytest.raises(InvalidStatus) as refused:
        server.open(answer.cookie)
    assert refused.value.response.status_code == 401


def test_paths_lead_nowhere_else(server: LiveServer) -> None:
    for path in (
        "/web/../cli/main.py",
        "/web/%2e%2e/cli/main.py",
        "/web/..%2f..%2fpyproject.toml",
        "/web//etc/passwd",
        "/web/assets.py",
        "/web/__init__.py",
        "/web/vendor/vendored.toml",
        "/web/viewer",
        "/web/viewer/player.js%00.html",
        "/scene/..%2f..%2fx/1",
        "/log/..%2f..%2fetc%2fpasswd",
    ):
        assert server.request("GET", path).status in (401, 403, 404), path
    assert server.request("GET", "/web/viewer/player.js").status == 200


def test_files_are_sent_once(server: LiveServer) -> None:
    path = "/web/viewer/player.js"
    first = server.request("GET", path, accept_encoding="gzip")
    assert first.headers["content-encoding"] == "gzip"
    again = server.request("GET", path, if_none_match=first.headers["etag"])
    assert (again.status, again.body) == (304, b"")


@pytest.mark.thorough
@pytest.mark.parametrize("text", NASTY)
def test_names_lines_and_files_are_only_text(server: LiveServer, text: str) -> None:
    answer = server.request("POST", "/enter", {"code": server.code, "name": text})
    assert answer.status == 200
    assert "\x00" not in answer.json["name"]
    anna = server.join(answer.cookie)
    state = anna.wait("snapshot")["state"]
    anna.wait("control")
    if state is None:
        anna.wait("state")
    anna.send("say", text=text)
    said = anna.wait("chat")["text"]
    assert said.isprintable()
    lease = anna.take_control()
    number = anna.command(lease, "upload", name=text, text=".PROGRAM a\n.END\n")
    anna.wait("result", lambda m: m["of"] == number)
    if text.isprintable():
        number = anna.command(lease, "line", line=text)
        anna.wait("result", lambda m: m["of"] == number)
        number = anna.command(lease, "line", line=f"STORE {text}")
        anna.wait("result", lambda m: m["of"] == number)
    anna.send("hand_back")
    anna.wait("control", lambda m: m["holder"] == "")
    inside = server.folder.resolve()
    written = [p for p in inside.parent.rglob("*") if p.is_file()]
    assert all(p.resolve().is_relative_to(inside) for p in written)
    assert server.request("GET", "/me", cookie=answer.cookie).status == 200, (
        "tables are still there"
    )


FORGED = [
    "",
    "null",
    "[]",
    "{}",
    '{"type":"welcome"}',
    '{"type":"rate"}',
    '{"type":"rate","rate":0}',
    '{"type":"rate","rate":61}',
    '{"type":"rate","rate":"50"}',
    '{"type":"rate","rate":5,"supervisor":true}',
    '{"type":"say","text":"' + "x" * (LONGEST_CHAT + 1) + '"}',
    '{"type":"say","text":"\\ud800"}',
    '{"type":"command","lease":"x","number":-1,"action":{"type":"ready"}}',
    '{"type":"command","lease":"x","number":1,"action":{"type":"shell"}}',
    '{"type":"command","lease":"x","number":1,"action":{"type":"step","frame":"x"}}',
    '{"type":"reach","of":1,"position_m":[1,2],"oat_rad":[0,0,0]}',
    '{"type":"reach","of":1,"position_m":[1e999,0,0],"oat_rad":[0,0,0]}',
    "[" * 20_000,
]


def test_forged_messages_are_refused_one_by_one_and_then_the_connection_ends(
    server: LiveServer,
) -> None:
    cookie = server.enter("Forger")
    anna = server.join(cookie)
    anna.wait("control")
    for text in FORGED:
        anna.socket.send(text)
        assert anna.wait("refused")["code"] == "message", text[:80]
    anna.socket.send(b"\x01\x02")
    assert anna.wait("refused")["code"] == "message"
    for _ in range(MOST_BAD - len(FORGED)):
        anna.socket.send("x")
    closed = anna.closed()
    assert closed is not None
    assert (closed["type"], closed["code"]) == ("closed", "message")
    server.join(cookie).wait("welcome")


def test_an_oversized_message_ends_the_connection(server: LiveServer) -> None:
    anna = server.join(server.enter("Anna"))
    anna.wait("control")
    anna.socket.send(json.dumps({"type": "say", "text": "x" * LONGEST_MESSAGE}))
    with pytest.raises(ConnectionClosed) as closed:
        anna.wait("chat")
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1009
    assert server.request("POST", "/enter", b"x" * 100_000).status == 413


def test_the_first_message_must_be_join(server: LiveServer) -> None:
    for first in ('{"type":"panic"}', '{"type":"hand_over"}', "x"):
        browser = server.open(server.enter("Anna"))
        browser.socket.send(first)
        closed = browser.closed()
        assert closed is not None
        assert closed["type"] == "closed"


def test_one_account_has_few_connections(server: LiveServer) -> None:
    cookie = server.enter("Many")
    for _ in range(8):
        server.join(cookie).wait("welcome")
    closed = server.join(cookie).closed()
    assert closed is not None
    assert closed["code"] == "limit"


@pytest.mark.thorough
def test_a_flood_is_refused_and_then_ended(server: LiveServer) -> None:
    anna = server.join(server.enter("Flood"))
    anna.wait("control")
    with contextlib.suppress(ConnectionClosed):  # it may end before all are sent
        for _ in range(EXCESS + 300):
            anna.socket.send('{"type":"rate","rate":50}')
    closed = anna.closed()
    assert closed is not None
    assert closed["type"] == "closed"
    assert {m["code"] for m in anna.came if m["type"] == "refused"} == {"rate"}
