"""The grading desk in a process of its own, and a browser reduced to its requests."""

import http.client
import json
import re
import signal
import socket
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from tests.support_commands import Begun
from tests.support_live import PATIENCE, Answer, Json, alone


class DeskProcess:
    """`vrts grade desk` of somebody, on a free port."""

    def __init__(
        self, folder: Path, who: str = "R. Huber", port: int = 0, *, measured: bool = False
    ) -> None:
        """Begin; one that is `measured` has an interpreter of its own."""
        words = ("grade", "desk", str(folder), "--who", who, "--port", str(port), "--no-browser")
        self.process = alone(*words) if measured else Begun(*words)
        assert self.process.stderr is not None
        self.said: list[str] = []
        for line in self.process.stderr:
            self.said.append(line)
            if "Ctrl-C ends it" in line:
                break
        found = re.search(r"http://127\.0\.0\.1:(\d+)/\?token=(\S+)", "".join(self.said))
        assert found is not None, self.said
        self.address, self.page = found[0], found[0].split("?")[0]
        self.port, self.token = int(found[1]), found[2]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.end()

    def end(self) -> None:
        """End it as Ctrl-C does."""
        if self.process.poll() is not None:
            return
        self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)
        assert self.process.stderr is not None
        faults = self.process.stderr.read()
        self.process.stderr.close()
        assert "Traceback" not in faults, faults


class DeskServer(DeskProcess):
    """One that a browser reduced to its requests has come into."""

    def __init__(self, folder: Path, who: str = "R. Huber", port: int = 0) -> None:
        """Start it, and come in by the address that it prints."""
        super().__init__(folder, who, port)
        self.host = f"127.0.0.1:{self.port}"
        self.cookie = ""
        self.entered = self.get(f"/?token={self.token}")
        self.cookie = self.entered.cookie

    def kill(self) -> None:
        """Kill -9."""
        self.process.kill()
        self.process.wait(PATIENCE)
        assert self.process.stderr is not None
        self.process.stderr.close()

    def request(self, method: str, path: str, body: Any = None, **headers: str) -> Answer:
        """Ask as a page of the desk would; a header that is "" is left out."""
        link = http.client.HTTPConnection("127.0.0.1", self.port, timeout=4 * PATIENCE)
        data = body if isinstance(body, bytes | None) else json.dumps(body).encode()
        every = {"host": self.host, "origin": f"http://{self.host}", "cookie": self.cookie}
        if data is not None:
            every |= {"content-type": "application/json", "content-length": str(len(data))}
        every |= {name.replace("_", "-"): value for name, value in headers.items()}
        try:
            link.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
            for name, value in every.items():
                if value:
                    link.putheader(name, value)
            link.endheaders(data)
            return Answer(link.getresponse())
        finally:
            link.close()

    def get(self, path: str, **headers: str) -> Answer:
        """Read something."""
        return self.request("GET", path, **headers)

    @property
    def whole(self) -> Json:
        """The class as the first screen has it."""
        answer = self.get("/api/class")
        assert answer.status == 200, answer.body
        return answer.json

    def row(self, student: str) -> Json:
        """Everything about a row."""
        answer = self.get(f"/api/row/{student}")
        assert answer.status == 200, answer.body
        return answer.json

    def add(self, *records: Json, expect: str = "") -> Answer:
        """Write decisions about what is shown now, or was at a revision."""
        body = {"records": list(records), "expect": expect or self.whole["revision"]}
        return self.request("POST", "/api/records", body)

    @contextmanager
    def events(self) -> "Generator[Iterator[tuple[str, Json]]]":
        """Listen to what happens."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=4 * PATIENCE) as link:
            head = f"GET /api/events HTTP/1.1\r\nhost: {self.host}\r\ncookie: {self.cookie}\r\n\r\n"
            link.sendall(head.encode())
            with link.makefile("rb") as lines:
                while lines.readline().strip():
                    pass
                while b"hello" not in lines.readline():
                    pass
                yield _events(lines)


def _events(lines: Any) -> "Iterator[tuple[str, Json]]":
    name = ""
    for line in lines:
        text = line.decode().strip()
        if text.startswith("event: "):
            name = text.removeprefix("event: ")
        elif text.startswith("data: "):
            yield name, json.loads(text.removeprefix("data: "))
