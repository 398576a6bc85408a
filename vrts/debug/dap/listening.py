"""Requests as they come, heard also while another one is worked on.

A thread reads them and puts them in a row. `pause`, `cancel`, the end of the client: whoever works
on an earlier request asks now and then whether one of these has come.
"""

from queue import Queue
from threading import Lock, Thread
from typing import NamedTuple

from vrts.debug.conditions.hearing import Interrupted
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.framing import Incoming, Malformed, Message

_STOP = frozenset({"pause", "disconnect", "terminate"})
_SHOWN = "vrts.recording"  # gives way to whatever moves the debugger: it is asked for again then
_MOVES = frozenset(
    {
        *("continue", "reverseContinue", "next", "stepIn", "stepOut", "stepBack", "goto"),
        *("restart", "setVariable", "setExpression", "vrts.tick", "vrts.seek", "vrts/go"),
        *("vrts/edit", "vrts/branch", "vrts/undo", "vrts/redo"),
    }
)
MOST_WAITING = 1_000  # requests that wait; a client that sends more waits itself


class Heard(NamedTuple):
    """What has come."""

    number: int  # from 1
    message: Message | None  # None: the client is gone
    problem: str = ""  # why what came is no message


class Listening:
    """One client, listened to by a thread of its own."""

    def __init__(self, incoming: Incoming) -> None:
        """Begin to listen."""
        self._incoming = incoming
        self._row: Queue[Heard] = Queue(MOST_WAITING)
        self._lock = Lock()
        self._stop = 0  # number of the last message that stops what is worked on
        self._moves = 0  # number of the last one that moves the debugger
        self._cancelled: set[int] = set()  # `seq` of requests
        self._now = Heard(0, None)
        Thread(target=self._listen, name="requests", daemon=True).start()

    def next(self) -> Heard:
        """Wait for the next message, and return it: it is worked on from now on."""
        found = self._row.get()
        with self._lock:
            self._now = found
        return found

    def hear(self) -> None:
        """Return if nobody minds that the present request is still worked on.

        Raises:
            Interrupted: Somebody does.
        """
        with self._lock:
            now = self._now
            seq = None if now.message is None else now.message.get("seq")
            if self._stop > now.number or (isinstance(seq, int) and seq in self._cancelled):
                raise Interrupted
            shows = now.message is not None and now.message.get("command") == _SHOWN
            if shows and self._moves > now.number:
                raise Interrupted

    def _listen(self) -> None:
        number = 0
        over = False
        while not over:
            number += 1
            try:
                message = self._incoming.read_message()
                found = Heard(number, message)
                over = message is None
            except Malformed as problem:
                found = Heard(number, {}, str(problem))
            except (OSError, ValueError):  # the stream was closed: the client is gone
                found, over = Heard(number, None), True
            self._note(found)
            self._row.put(found)

    def _note(self, found: Heard) -> None:
        """Note what stops the request that is worked on."""
        message = found.message
        command = None if message is None else message.get("command")
        with self._lock:
            if message is None or (isinstance(command, str) and command in _STOP):
                self._stop = found.number
            elif isinstance(command, str) and command in _MOVES:
                self._moves = found.number
            elif command == "cancel":
                which = Fields(message.get("arguments")).whole_or_none("requestId")
                if which is not None and len(self._cancelled) < MOST_WAITING:
                    self._cancelled.add(which)
