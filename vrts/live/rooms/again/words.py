"""Why a room has no session, and what its supervisor can choose."""

from typing import Final

import msgspec

from vrts.live.names import readable
from vrts.live.protocol.from_server import NoSession

LONGEST: Final = 80  # characters of a command that are shown
AGAIN, WITHOUT_LAST, ANEW = "again", "without_last", "begin"  # as `GoOn` and `SetScene` do them


def not_offered(scene: str) -> NoSession:
    """Return the words for a room whose scene is none of the server's."""
    return NoSession(
        f"this room is in the scene `{scene}`, which this server does not offer now;"
        " all that was done is kept",
        f"stop the server and start it with this scene too: `vrts serve {scene} ...`, by its name"
        " or the path of its folder. Then the room goes on. Or choose another scene: that begins"
        " another session",
    )


def died_too_often(why: str, row: int, last: str, *, recorded: bool) -> NoSession:
    """Return the words for a session that dies again and again.

    Args:
        why: How it died.
        row: How often.
        last: The last command, as `command_words` has it; empty: there was none.
        recorded: Whether it is in the log, so that it is done again each time.
    """
    if not last:
        told, choices = "there was no command before", (AGAIN, ANEW)
    elif recorded:
        told, choices = f"the last command was {last}", (AGAIN, WITHOUT_LAST, ANEW)
    else:
        told, choices = f"it died while it did {last}, which is not recorded", (AGAIN, ANEW)
    return NoSession(
        f"the session has died {row} times in a row ({why}); {told}",
        "choose how to go on; the log is kept whole in every case",
        choices,
    )


class _Command(msgspec.Struct, frozen=True):
    type: str
    line: str = ""


def command_words(action: bytes) -> str:
    """Return a command, JSON as the log has it, as people are told of it."""
    told = msgspec.json.decode(action, type=_Command)
    text = readable(told.line) if told.type == "line" else told.type
    return f"`{text if len(text) <= LONGEST else text[: LONGEST - 1] + '…'}`"
