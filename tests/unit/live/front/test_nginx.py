"""A real nginx before the server, with the very lines that the manual shows."""

import http.client
import json
import re
import shutil
import socket
import ssl
import subprocess
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import NamedTuple

import pytest
from websockets.sync.client import connect
from websockets.typing import Origin

from tests.places import ROOT
from tests.support_live import PATIENCE, Answer, Browser, LiveServer
from tests.support_proxy import certificate

NAME = "lab.example.org"
MANUAL = ROOT / "vrts" / "manual" / "learn" / "server.md"
WHOLE = """daemon off; user root; pid {folder}/pid; error_log {folder}/error.log;
events {{}} http {{ access_log off; client_body_temp_path {folder}/body;
proxy_temp_path {folder}/proxy; fastcgi_temp_path {folder}/f; scgi_temp_path {folder}/s;
uwsgi_temp_path {folder}/u; {lines} }}"""

pytestmark = [
    pytest.mark.skipif(shutil.which("nginx") is None, reason="needs nginx"),
    pytest.mark.skipif(shutil.which("openssl") is None, reason="makes its certificate by openssl"),
]


class Behind(NamedTuple):
    """A server behind nginx, which listens at two ports: with TLS, and in the clear."""

    server: LiveServer
    port: int
    plain: int
    context: ssl.SSLContext

    def post(self, body: dict[str, str], source: str, **headers: str) -> Answer:
        """Post to `/enter` from a page of `NAME`, from an address of this machine."""
        link = http.client.HTTPConnection(NAME, timeout=PATIENCE)
        raw = socket.create_connection(("127.0.0.1", self.port), source_address=(source, 0))
        with self.context.wrap_socket(raw, server_hostname=NAME) as link.sock:
            told = {"Origin": f"https://{NAME}", "Content-Type": "application/json", **headers}
            link.request("POST", "/enter", json.dumps(body), told)
            return Answer(link.getresponse())


def free_ports(count: int) -> list[int]:
    held = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in held]
    for one in held:
        one.close()
    return ports


def lines(folder: Path, target: int, port: int, plain: int) -> str:
    """Return the lines of the manual, with the ports and files of this machine."""
    (shown,) = re.findall(r"```text\n(server \{\n.*?)```", MANUAL.read_text("utf-8"), re.S)
    pem, key = certificate(folder, NAME)
    for printed, here in (
        ("listen 443 ssl;", f"listen 127.0.0.1:{port} ssl; listen 127.0.0.1:{plain};"),
        ("/etc/ssl/lab.pem", str(pem)),
        ("/etc/ssl/lab.key", str(key)),
        ("127.0.0.1:8000", f"127.0.0.1:{target}"),
    ):
        assert shown.count(printed) == 1, printed
        shown = shown.replace(printed, here)
    return shown


@pytest.fixture
def behind(tmp_path: Path) -> Iterator[Behind]:
    target, port, plain = free_ports(3)
    config = tmp_path / "nginx.conf"
    shown = lines(tmp_path, target, port, plain)
    config.write_text(WHOLE.format(folder=tmp_path, lines=shown))
    nginx = subprocess.Popen(["nginx", "-c", str(config), "-p", str(tmp_path)])
    try:
        flags = ("--behind-proxy", "--name", NAME)
        with LiveServer(tmp_path / "live", *flags, port=str(target)) as server:
            listens(nginx, port)
            context = ssl.create_default_context(cafile=str(tmp_path / "cert.pem"))
            yield Behind(server, port, plain, context)
    finally:
        nginx.terminate()
        nginx.wait(PATIENCE)


def listens(nginx: "subprocess.Popen[bytes]", port: int) -> None:
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        assert nginx.poll() is None, "nginx does not take the lines"
        try:
            with closing(socket.create_connection(("127.0.0.1", port))):
                return
        except ConnectionRefusedError:
            time.sleep(0.05)
    raise AssertionError("nginx does not listen")


def test_what_the_manual_prints_works_and_nobody_forges_an_address(behind: Behind) -> None:
    right = {"code": behind.server.code, "name": "Anna"}
    forged = {"X-Forwarded-For": "203.0.113.9, 127.0.0.1", "X-Real-IP": "203.0.113.9"}
    anna = behind.post(right, "127.0.0.2")
    assert anna.status == 200
    assert "Secure" in (anna.headers.get("set-cookie") or "")
    assert [behind.post(right, "127.0.0.3", **forged).status for _ in range(2)] == [200, 200]
    boss = behind.post({"code": behind.server.supervisor_token, "name": ""}, "127.0.0.2")
    ways = behind.server.request("GET", "/ways", cookie=boss.cookie).json
    found = [(row["address"], row["hour"]) for row in ways["most"]]
    assert found == [("127.0.0.3", 2), ("127.0.0.2", 1)]
    with connect(
        f"ws://{NAME}/ws",
        sock=socket.create_connection(("127.0.0.1", behind.plain)),
        origin=Origin(f"https://{NAME}"),
        additional_headers={"cookie": anna.cookie},
        compression=None,
        proxy=None,
    ) as raw:
        browser = Browser(raw)
        browser.send("join")
        assert browser.wait("welcome")["name"] == "Anna"
