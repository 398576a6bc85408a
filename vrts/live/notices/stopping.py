"""Which commands stop an arm, and when the notice of that is over: as soon as it moves again."""

from typing import Final

import msgspec

MOVING: Final = frozenset(("running", "moving", "jogging"))


class _Mode(msgspec.Struct, frozen=True):
    mode: str = ""


class _Command(msgspec.Struct, frozen=True):
    type: str
    line: str = ""


_commands = msgspec.json.Decoder(_Command)
_modes = msgspec.json.Decoder(_Mode)


def moves(status: bytes) -> bool:
    """Return whether a session's `Status`, as JSON, says that the arm moves or a program runs."""
    return _modes.decode(status).mode in MOVING


def is_panic(action: bytes) -> bool:
    """Return whether a command, JSON as the log has it, is PANIC: pressed, or typed."""
    told = _commands.decode(action)
    return told.type == "panic" or (told.type == "line" and told.line.strip().upper() == "PANIC")
