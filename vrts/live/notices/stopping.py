"""When the notice that an arm was stopped is over: as soon as it moves again."""

from typing import Final

import msgspec

MOVING: Final = frozenset(("running", "moving", "jogging"))


class _Mode(msgspec.Struct, frozen=True):
    mode: str = ""


_modes = msgspec.json.Decoder(_Mode)


def moves(status: bytes) -> bool:
    """Return whether a session's `Status`, as JSON, says that the arm moves or a program runs."""
    return _modes.decode(status).mode in MOVING
