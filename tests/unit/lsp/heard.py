"""A session of the language server in this process, without a stream, and what it says."""

import asyncio
import json
from collections.abc import Callable
from typing import Any

from vrts.lsp.server.serving import session_with_features
from vrts.lsp.server.session import Session

PATIENCE_S = 30
URI = "untitled:a.v2"
TEXT = ".PROGRAM main\n        MOVE part\n        SIGNAL 5\n.END\n"


class Heard:
    """A session without a stream, and what it says."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.said: list[dict[str, Any]] = []
        self.number = 0
        self._version = 1
        self._news = asyncio.Event()
        session.begin(asyncio.get_running_loop().create_future())
        session.followed.set_writer(self, include_headers=False)

    def write(self, data: bytes) -> None:
        self.said.append(json.loads(data))
        self._news.set()

    def close(self) -> None:
        """Leave nothing open."""

    def say(self, message: object) -> None:
        self.session.followed.take(json.dumps(message).encode())

    def tell(self, method: str, params: Any) -> None:
        self.say({"jsonrpc": "2.0", "method": method, "params": params})

    def open(self, uri: str, text: str) -> None:
        document = {"uri": uri, "languageId": "val2", "version": self._version, "text": text}
        self.tell("textDocument/didOpen", {"textDocument": document})

    def change(self, uri: str, text: str) -> None:
        """Replace a whole buffer."""
        self._version += 1
        about = {"uri": uri, "version": self._version}
        changes = [{"text": text}]
        self.tell("textDocument/didChange", {"textDocument": about, "contentChanges": changes})

    def begin_to_ask(self, method: str, params: Any) -> str:
        """Send a request; return its number."""
        self.number += 1
        number = f"mine-{self.number}"
        self.say({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
        return number

    async def ask(self, method: str, params: Any) -> dict[str, Any]:
        """Send a request, and return its answer."""
        return await self.answer(self.begin_to_ask(method, params))

    async def answer(self, number: str) -> dict[str, Any]:
        """Return the answer to a request that was sent."""
        return await self.next(lambda said: said.get("id") == number and "method" not in said)

    async def next(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """Return the first message that is wanted, as soon as it is said."""
        async with asyncio.timeout(PATIENCE_S):
            while True:
                for found in self.said:
                    if wanted(found):
                        return found
                self._news.clear()
                await self._news.wait()


async def begun(
    text: str = TEXT,
    able: dict[str, Any] | None = None,
    *,
    uri: str = URI,
    runs: bool = False,
    options: Any = None,
) -> Heard:
    """Return a session in which a buffer is open."""
    heard = Heard(session_with_features(runs=runs))
    asked: dict[str, Any] = {"processId": None, "rootUri": None, "capabilities": able or {}}
    if options is not None:
        asked["initializationOptions"] = options
    found = await heard.ask("initialize", asked)
    assert "result" in found
    heard.tell("initialized", {})
    heard.open(uri, text)
    return heard
