"""A server behind a proxy that does TLS: its name, its cookies, its WebSockets, who is who."""

import http.client
import json
import shutil
import socket
import ssl
from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from tests.support_live import PATIENCE, Answer, Browser, LiveServer
from tests.support_proxy import TlsProxy

NAME = "lab.example.org"

pytestmark = pytest.mark.skipif(
    shutil.which("openssl") is None, reason="makes its certificate with openssl"
)


class Behind(NamedTuple):
    """A server, and the proxy before it."""

    server: LiveServer
    proxy: TlsProxy
    context: ssl.SSLContext

    def link(self) -> ssl.SSLSocket:
        """Return a connection to the proxy, as a browser makes it for `NAME`."""
        plain = socket.create_connection(("127.0.0.1", self.proxy.port))
        return self.context.wrap_socket(plain, server_hostname=NAME)

    def open(self, cookie: str, origin: str) -> ClientConnection:
        """Open a WebSocket."""
        return connect(
            f"ws://{NAME}/ws",
            sock=socket.create_connection(("127.0.0.1", self.proxy.plain_port)),
            origin=Origin(origin),
            additional_headers={"cookie": cookie},
            compression=None,
            proxy=None,
        )

    def post(self, path: str, body: dict[str, Any], **headers: str) -> Answer:
        """Post from a page of `NAME`."""
        connection = http.client.HTTPConnection(NAME, timeout=PATIENCE)
        with self.link() as connection.sock:
            all_headers = {
                "Origin": f"https://{NAME}",
                "Content-Type": "application/json",
                "Connection": "close",
            }
            all_headers |= {name.replace("_", "-"): value for name, value in headers.items()}
            connection.request("POST", path, json.dumps(body), all_headers)
            return Answer(connection.getresponse())


@pytest.fixture
def behind(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Behind]:
    folder = tmp_path_factory.mktemp("proxy")
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = str(free.getsockname()[1])
    flags = ("--behind-proxy", "--name", NAME)
    with (
        TlsProxy(folder, NAME) as proxy,
        LiveServer(folder / "live", *flags, port=port) as server,
    ):
        proxy.target = server.port
        context = ssl.create_default_context(cafile=str(proxy.certificate))
        yield Behind(server, proxy, context)


def test_a_browser_finds_the_name_secure_cookies_and_its_socket(behind: Behind) -> None:
    assert behind.server.said[0].rstrip().endswith(f"https://{NAME}")
    answer = behind.post("/enter", {"code": behind.server.code, "name": "Anna"})
    assert answer.status == 200
    assert "Secure" in (answer.headers.get("set-cookie") or "")
    assert answer.headers.get("strict-transport-security")
    with behind.open(answer.cookie, f"https://{NAME}") as socket_:
        browser = Browser(socket_)
        browser.send("join")
        assert browser.wait("welcome")["name"] == "Anna"
        browser.wait("snapshot")
    with pytest.raises(InvalidStatus) as refused:
        behind.open(answer.cookie, "https://evil.example")
    assert refused.value.response.status_code == 403


@pytest.mark.thorough
def test_only_the_hop_of_the_proxy_is_believed(behind: Behind) -> None:
    right = {"code": behind.server.code, "name": "x"}
    behind.proxy.client = "198.51.100.7"
    for n in range(3):
        assert behind.post("/enter", right, x_forwarded_for=f"203.0.113.{n}").status == 200
    behind.proxy.client = "198.51.100.8"
    assert behind.post("/enter", right, x_real_ip="203.0.113.77").status == 200
    supervisor = behind.post("/enter", {"code": behind.server.supervisor_token, "name": ""})
    ways = behind.server.request("GET", "/ways", cookie=supervisor.cookie).json
    assert [(row["address"], row["hour"]) for row in ways["most"]] == [
        ("198.51.100.7", 3),
        ("198.51.100.8", 1),
    ], "what a client says of its own address does not count"
