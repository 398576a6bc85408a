"""The adapter on two streams: requests in, responses and events out, until the client is gone."""

import contextlib
from threading import Lock
from typing import Any, BinaryIO

from vrts.debug.conditions.hearing import Interrupted
from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.framing import Incoming, Message, write_message
from vrts.debug.dap.listening import Listening
from vrts.debug.dap.session import Answer


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
    listening = Listening(Incoming(incoming))
    adapter = Adapter(writer.event, listening.hear)
    with contextlib.suppress(BrokenPipeError):  # nobody listens any more: that is the end
        while not adapter.over:
            heard = listening.next()
            if heard.message is None:
                return
            if heard.problem:
                words = f"a malformed message came: {heard.problem}\n"
                writer.event("output", {"category": "important", "output": words})
            else:
                _answer(adapter, writer, heard.message)


def _answer(adapter: Adapter, writer: _Writer, message: Message) -> None:
    command, number = message.get("command"), message.get("seq")
    if message.get("type") != "request" or not isinstance(command, str):
        return
    response: dict[str, Any] = {
        "type": "response",
        "request_seq": number if isinstance(number, int) else 0,
        "command": command,
    }
    answer = Answer({})
    try:
        answer = adapter.answer(command, Fields(message.get("arguments")))
        response |= {"success": True, "body": answer.body}
    except BadRequest as problem:
        response |= _refused(str(problem))
    except Interrupted:
        response |= {"success": False, "message": "cancelled"}
    except Exception as fault:
        response |= _refused(f"a fault in vrts: {type(fault).__name__}: {fault}")
    writer.send(response)
    for name, event in (*answer.events, *adapter.gone(answer)):
        writer.event(name, event)


def _refused(words: str) -> dict[str, Any]:
    shown = {"id": 1, "format": "{words}", "variables": {"words": words}, "showUser": True}
    return {"success": False, "message": words, "body": {"error": shown}}
