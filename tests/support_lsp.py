"""A client of the language server protocol: that of pytest-lsp, with a real process, real pipes.

What comes is checked against the types of the protocol and against what the client says it can do.
"""

import asyncio
import json
import logging
import sys
import threading
import time
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any, TypeAlias, TypeVar, cast

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.io_ import run_async
from pygls.lsp.client import LanguageClient as PlainClient
from pygls.protocol import default_converter
from pytest_lsp import LanguageClient, client_capabilities
from pytest_lsp.client import register_lsp_features
from pytest_lsp.protocol import LanguageClientProtocol

from tests.support_commands import waiting_for_editors
from tests.support_forked import Forked

Result = TypeVar("Result")

PATIENCE = 60.0  # [s] on a busy machine
EDITOR = "neovim@v0.11"
SERVER = ("-m", "vrts.cli.main", "lsp")  # words for an interpreter that starts
Process: TypeAlias = asyncio.subprocess.Process | Forked
CONVERTER = default_converter()


def is_settled(diagnostics: list[dict[str, Any]]) -> bool:
    """Return whether the other files of the folder have been read."""
    return not any("are still being read" in found["message"] for found in diagnostics)


class Recorder(LanguageClientProtocol):
    """Keeps everything that the server says by itself."""

    came: Callable[[str, Any], None]

    def _handle_notification(self, method_name: str, params: Any) -> None:
        super()._handle_notification(method_name, params)
        self.came(method_name, params)

    def _handle_request(self, msg_id: Any, method_name: str, params: Any) -> None:
        super()._handle_request(msg_id, method_name, params)
        self.came(method_name, params)


class Driven(LanguageClient):
    """A client that keeps what its server says, and the server's process."""

    def __init__(self, came: Callable[[str, Any], None]) -> None:
        super().__init__(protocol_cls=Recorder, converter_factory=default_converter)  # pyright: ignore[reportUnknownMemberType]
        register_lsp_features(self)
        for method in (
            types.WORKSPACE_INLAY_HINT_REFRESH,
            types.WORKSPACE_SEMANTIC_TOKENS_REFRESH,
            types.WORKSPACE_CODE_LENS_REFRESH,
        ):
            self.feature(method)(_nothing)
        self.feature(types.WINDOW_SHOW_MESSAGE_REQUEST)(_first)
        assert isinstance(self.protocol, Recorder)
        self.protocol.came = came

    async def begin(self, *words: str) -> asyncio.subprocess.Process:
        """Start a server; what it writes to stderr is left to the caller."""
        await PlainClient.start_io(self, *words)  # pyright: ignore[reportUnknownMemberType]
        assert self._server is not None
        return self._server

    async def fork(self, *words: str) -> Forked:
        """Begin a server that need not be loaded first."""
        server = await Forked.begin(waiting_for_editors(), *words)
        self.protocol.set_writer(server.stdin)
        listening = run_async(
            stop_event=self._stop_event,
            reader=server.stdout,
            protocol=self.protocol,
            logger=logging.getLogger(__name__),
            error_handler=self.report_server_error,
        )
        self._server = cast("asyncio.subprocess.Process", server)  # what pygls uses of one
        self._async_tasks += [
            asyncio.create_task(listening),
            asyncio.create_task(self._server_exit()),
        ]
        return server


class Client:
    """Talks to `vrts lsp`; positions are (line, character) from 0.

    Its event loop runs in a thread, so that tests read from top to bottom.
    """

    def __init__(
        self,
        folder: Path,
        encodings: list[str] | None = None,
        editor: str = EDITOR,
        server: tuple[str, ...] | None = None,
    ) -> None:
        """Begin a server, forked or started with words of one's own, and say hello."""
        self.folder = folder
        self.said: list[tuple[str, Any]] = []  # by the server: nobody has taken it yet
        self.errors: list[str] = []
        self._versions: dict[str, int] = {}
        self._news = threading.Condition()
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        self.client, self.process, self._listening = self._wait(self._start(server))
        able = client_capabilities(editor)
        if encodings:
            wanted = [types.PositionEncodingKind(encoding) for encoding in encodings]
            able.general = types.GeneralClientCapabilities(position_encodings=wanted)
        asked = types.InitializeParams(able, root_uri=folder.as_uri())
        found = self._wait(self.client.initialize_session(asked))
        self.able: dict[str, Any] = CONVERTER.unstructure(found.capabilities)

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.leave()

    def leave(self) -> int:
        """Say goodbye, or find the server gone; return its exit status."""
        if self.process.returncode is None:
            self._wait(self.client.shutdown_async(None))
            self._loop.call_soon_threadsafe(self.client.exit, None)
        return self.gone()

    def gone(self) -> int:
        """Close this end; return the exit status of the other."""
        status = self._wait(self._end())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(PATIENCE)
        self._loop.close()
        return status

    async def _start(
        self, server: tuple[str, ...] | None
    ) -> tuple[Driven, Process, asyncio.Task[None]]:
        client = Driven(self._heard)
        process: Process
        if server is None:
            process = await client.fork("lsp")
        else:
            process = await client.begin(sys.executable, *server)
        return client, process, asyncio.ensure_future(self._listen(process))

    async def _listen(self, process: Process) -> None:
        assert process.stderr is not None
        async for line in process.stderr:
            self.errors.append(line.decode())

    async def _end(self) -> int:
        assert self.process.stdin is not None
        self.process.stdin.close()
        status = await asyncio.wait_for(self.process.wait(), PATIENCE)
        await self._listening
        await self.client.stop()
        if isinstance(self.process, Forked):
            self.process.close()
        return status

    # --- buffers --------------------------------------------------------------------------------

    def uri(self, name: str) -> str:
        """Return the address of a file of the folder."""
        return (self.folder / name).as_uri()

    def open(self, name: str, text: str) -> None:
        """Open a buffer, whatever the file on disk holds."""
        self._versions[name] = 1
        document = {"uri": self.uri(name), "languageId": "val2", "version": 1, "text": text}
        self.tell("textDocument/didOpen", textDocument=document)

    def change(self, name: str, text: str, *at: tuple[int, int]) -> None:
        """Replace what is between two positions, or the whole buffer."""
        self._versions[name] += 1
        change: dict[str, Any] = {"text": text}
        if at:
            first, last = at
            change["range"] = {"start": place(first), "end": place(last)}
        self.tell(
            "textDocument/didChange",
            textDocument={"uri": self.uri(name), "version": self._versions[name]},
            contentChanges=[change],
        )

    def close(self, name: str) -> None:
        """Close a buffer."""
        self.tell("textDocument/didClose", textDocument={"uri": self.uri(name)})

    def diagnostics(
        self, name: str, wanted: Callable[[list[dict[str, Any]]], bool] = is_settled
    ) -> list[dict[str, Any]]:
        """Return what is said about the present text of a buffer, once it is what is wanted."""

        def matches(method: str, params: Any) -> bool:
            return (
                method == types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS
                and params["uri"] == self.uri(name)
                and params.get("version") == self._versions[name]
                and wanted(params["diagnostics"])
            )

        return self._next(matches)["diagnostics"]

    # --- messages -------------------------------------------------------------------------------

    def about(self, method: str, name: str, at: tuple[int, int] | None = None, **more: Any) -> Any:
        """Ask about a buffer, or a place in it; return the result."""
        where = {"position": place(at)} if at is not None else {}
        return self.do(
            f"textDocument/{method}", textDocument={"uri": self.uri(name)}, **where, **more
        )

    def do(self, method: str, **params: Any) -> Any:
        """Send a request that has to succeed; return its result."""
        found = self.ask(method, **params)
        assert "error" not in found, found
        return found["result"]

    def ask(self, method: str, **params: Any) -> dict[str, Any]:
        """Send a request; return its result or its error."""
        asked = _structured(method, params)

        async def answer() -> Any:
            return await self.client.protocol.send_request_async(method, asked)

        try:
            return {"result": CONVERTER.unstructure(self._wait(answer()))}
        except JsonRpcException as problem:
            return {"error": {"code": problem.code, "message": problem.message}}

    def tell(self, method: str, **params: Any) -> None:
        """Send a notification."""
        told = _structured(method, params)
        self._loop.call_soon_threadsafe(self.client.protocol.notify, method, told)

    def send(self, message: object) -> None:
        """Send any message, also one that the protocol does not have."""
        data = json.dumps(message).encode()
        self.raw(b"Content-Length: %d\r\n\r\n" % len(data) + data)

    def raw(self, data: bytes) -> None:
        """Write bytes as they are."""
        assert self.process.stdin is not None
        self._loop.call_soon_threadsafe(self.process.stdin.write, data)

    def said_next(self, method: str) -> Any:
        """Return the parameters of the next notification or request of a kind."""
        return self._next(lambda m, _: m == method)

    def _heard(self, method: str, params: Any) -> None:
        with self._news:
            self.said.append((method, CONVERTER.unstructure(params)))
            self._news.notify_all()

    def _next(self, wanted: Callable[[str, Any], bool]) -> Any:
        """Return the parameters of what is wanted; what came before it is kept."""
        latest = time.monotonic() + PATIENCE
        with self._news:
            while True:
                for number, (method, params) in enumerate(self.said):
                    if wanted(method, params):
                        del self.said[number]
                        return params
                left = latest - time.monotonic()
                gone = self.process.returncode is not None
                assert left > 0.0, f"nothing comes; so far {self.said} {self.errors}"
                assert not gone, f"the server is gone: {''.join(self.errors)}"
                self._news.wait(min(left, 0.5))

    def _wait(self, work: Coroutine[Any, Any, Result]) -> Result:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(PATIENCE)


def _structured(method: str, params: dict[str, Any]) -> Any:
    """Return parameters as the protocol has them; as they are for a method that it has not."""
    known: Any = types.METHOD_TO_TYPES.get(method)  # type: ignore[call-overload]
    return params if known is None else CONVERTER.structure(params, known[2])


def _nothing(_: None) -> None:
    """Answer a request that wants no more than an answer."""


def _first(asked: types.ShowMessageRequestParams) -> types.MessageActionItem | None:
    """Choose the first of the answers that are offered."""
    return asked.actions[0] if asked.actions else None


def place(at: tuple[int, int]) -> dict[str, int]:
    """Return a position of the protocol."""
    return {"line": at[0], "character": at[1]}


def where(text: str, piece: str, number: int = 1) -> tuple[int, int]:
    """Return where a piece of a text begins the n-th time: line and character from 0."""
    at = -1
    for _ in range(number):
        at = text.index(piece, at + 1)
    return text.count("\n", 0, at), at - (text.rfind("\n", 0, at) + 1)
