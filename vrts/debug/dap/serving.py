"""The adapter on two streams: requests in, responses and events out, until the client is gone."""

import contextlib
from collections.abc import Sequence
from threading import Lock
from typing import Any, BinaryIO

from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.framing import Malformed, Message, read_message, write_message
from vrts.debug.dap.session import Event


class _Writer:
    """Numbers messages and writes them."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._number = 0
        self._lock = Lock()

    def send(self, message: dict[str, Any]) -> None:
        with self._lock:
            self._number += 1
            write_message(self._stream, {"seq": self._number, **message})

    def event(self, name: str, body: dict[str, Any]) -> None:
        self.send({"type": "event", "event": name, "body": body})


def serve(incoming: BinaryIO, outgoing: BinaryIO) -> None:
    """Serve one client until it disconnects or its end of the stream is closed."""
    writer = _Writer(outgoing)
    adapter = Adapter(writer.event)
    with contextlib.suppress(BrokenPipeError):  # nobody listens any more: that is the end
        while not adapter.over:
            try:
                message = read_message(incoming)
            except Malformed as problem:
                words = f"a malformed message came: {problem}\n"
                writer.event("output", {"category": "important", "output": words})
                continue
            if message is None:
                return
            _answer(adapter, writer, message)


def _answer(adapter: Adapter, writer: _Writer, message: Message) -> None:
    command, number = message.get("command"), message.get("seq")
    if message.get("type") != "request" or not isinstance(command, str):
        return
    response: dict[str, Any] = {
        "type": "response",
        "request_seq": number if isinstance(number, int) else 0,
        "command": command,
    }
    events: Sequence[Event] = ()
    try:
        answer = adapter.answer(command, Fields(message.get("arguments")))
        response |= {"success": True, "body": answer.body}
        events = answer.events
    except BadRequest as problem:
        shown = {"id": 1, "format": str(problem), "showUser": True}
        response |= {"success": False, "message": str(problem), "body": {"error": shown}}
    writer.send(response)
    for name, event in events:
        writer.event(name, event)
