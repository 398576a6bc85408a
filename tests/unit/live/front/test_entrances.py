"""Ways in and out of a server: TLS, accounts with passwords, rooms for groups, administration."""

import http.client
import re
import shutil
import socket
import ssl
import subprocess
import sys
from pathlib import Path

import pytest
import uvicorn
from click.testing import CliRunner

from tests.support_live import LiveServer
from vrts.cli.main import vrts
from vrts.live.new_account import add_user
from vrts.live.places import places_of
from vrts.live.serving import Entrances, Listening, greeting
from vrts.live.settings import Settings


def test_it_says_loudly_what_it_exposes(tmp_path: Path) -> None:
    settings = Settings(tmp_path, places_of(("cans-on-bases",)))
    entrances = Entrances("http://x", "token", "ABCDEF")
    alone = "\n".join(greeting(settings, Listening(), entrances))
    assert "only this machine" in alone
    assert "EXPOSED" not in alone
    everywhere = greeting(settings, Listening("0.0.0.0"), entrances)
    assert sum("EXPOSED" in line for line in everywhere) == 2
    by_name = greeting(settings, Listening("lab.example.org"), entrances)
    assert sum("EXPOSED" in line for line in by_name) == 2


def test_quiet_leaves_the_ways_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def ended(_: uvicorn.Server, sockets: list[socket.socket]) -> None:
        for listener in sockets:
            listener.close()

    monkeypatch.setattr(uvicorn.Server, "run", ended)
    words = ["serve", "cans-on-bases", "-q", "--port", "0", "--folder", str(tmp_path / "live")]
    said = CliRunner().invoke(vrts, words)
    assert said.exit_code == 0, said.output
    assert re.search(r"^serving cans-on-bases at http://127\.0\.0\.1:\d+$", said.stderr, re.M)
    assert re.search(r"^supervisor, once: http\S+#enter=\S+$", said.stderr, re.M)
    assert re.search(r"^class code: \w{3}-\w{3}-\w{3},", said.stderr, re.M)


@pytest.mark.thorough
@pytest.mark.skipif(shutil.which("openssl") is None, reason="makes its certificate with openssl")
def test_tls_by_flags_makes_secure_cookies(tmp_path: Path) -> None:
    certificate, key = tmp_path / "cert.pem", tmp_path / "key.pem"
    words = "req -x509 -newkey rsa:2048 -nodes -subj /CN=localhost -days 2"
    words += f" -addext subjectAltName=DNS:localhost -keyout {key} -out {certificate}"
    subprocess.run(["openssl", *words.split()], check=True, capture_output=True)
    flags = ("--tls-cert", str(certificate), "--tls-key", str(key))
    with LiveServer(tmp_path / "live", *flags) as server:
        assert server.said[0].rstrip().endswith(f"https://127.0.0.1:{server.port}")
        context = ssl.create_default_context(cafile=str(certificate))
        link = http.client.HTTPSConnection("localhost", server.port, context=context, timeout=20)
        headers = {
            "origin": f"https://localhost:{server.port}",
            "content-type": "application/json",
        }
        body = f'{{"code":"{server.code}","name":"Anna"}}'
        link.request("POST", "/enter", body, headers)
        answer = link.getresponse()
        answer.read()
        assert answer.status == 200
        assert "Secure" in (answer.getheader("set-cookie") or "")
        assert answer.getheader("strict-transport-security")
        link.close()


@pytest.mark.thorough
def test_accounts_groups_and_administration(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    name = add_user(folder, "Dr. Lee", "correct horse", supervisor=True)
    names = tmp_path / "groups.txt"
    names.write_text("Group A\n\nGroup B\n")
    with LiveServer(
        folder, "--rooms", str(names), scenes=("cans-on-bases", "one-can-ur5")
    ) as server:
        wrong = {"user": name, "password": "wrong"}
        assert server.request("POST", "/login", wrong).status == 403
        nobody = {"user": "nobody", "password": "wrong"}
        assert server.request("POST", "/login", nobody).json == {
            "code": "login",
            "text": "user or password is wrong",
            "help": "",
        }
        answer = server.request("POST", "/login", {"user": name, "password": "correct horse"})
        rooms = answer.json["rooms"]
        assert [room["name"] for room in rooms] == ["Group A", "Group B"]
        code = server.request("GET", "/code", cookie=answer.cookie)
        assert code.json["code"] == server.code
        picture = server.request("GET", "/code.svg", cookie=answer.cookie)
        assert picture.body.startswith(b"<svg")

        wanted = {"room": rooms[1]["id"]}
        link = server.request("POST", "/link", wanted, cookie=answer.cookie).json
        assert link["picture"].startswith("<svg")
        cookie = server.enter("Ben", link["url"].partition("#enter=")[2])
        assert server.request("GET", "/code", cookie=cookie).status == 403
        assert server.request("POST", "/link", wanted, cookie=cookie).status == 403
        gone = server.request("POST", "/link", {"room": "x"}, cookie=answer.cookie)
        assert gone.status == 404
        me = server.request("GET", "/me", cookie=cookie).json
        assert [room["name"] for room in me["rooms"]] == ["Group B"]
        inside = server.join(cookie)
        snapshot = inside.wait("snapshot")
        assert snapshot["room"]["name"] == "Group B"
        if snapshot["state"] is None:
            inside.wait("state")  # its log has begun
        closed = server.join(cookie, room=rooms[0]["id"]).closed()
        assert closed is not None
        assert closed["code"] == "room"

        words = [sys.executable, "-m", "vrts.cli.main", "serve", "--folder", str(folder)]
        copy = tmp_path / "copy.sqlite"
        subprocess.run([*words, "--backup", str(copy)], check=True, capture_output=True)
        assert copy.stat().st_mode & 0o777 == 0o600
        subprocess.run([*words, "--purge-user", "Ben"], check=True, capture_output=True)
        assert server.request("GET", "/me", cookie=cookie).status == 401
        done = subprocess.run([*words, "--verify-logs"], check=True, capture_output=True)
        assert b"unbroken" in done.stderr
