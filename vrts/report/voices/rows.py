"""What people said and did while a session went on, beside its events on the page."""

from collections.abc import Sequence
from typing import Final, NamedTuple

from vrts.report.plain import one_line
from vrts.report.quantities import seconds

MOST_VOICES: Final = 2000  # rows
LONGEST: Final = 1000  # characters of a text
KINDS: Final = ("control", "people", "chat", "note", "stop")


class Voice(NamedTuple):
    """One of them."""

    at_s: float  # session time
    kind: str  # one of `KINDS`
    name: str  # of the person; empty: the server
    text: str  # "presses PANIC"; what was said
    end_s: float | None = None  # until when it was so; None: it has no duration


def voice_rows(voices: Sequence[Voice]) -> list[dict[str, object]]:
    """Return rows for the lanes and the list of events, in time order."""
    rows: list[dict[str, object]] = [
        {
            "t": seconds(voice.at_s),
            "end": None if voice.end_s is None else seconds(voice.end_s),
            "kind": voice.kind,
            "name": one_line(voice.name),
            "text": one_line(voice.text)[:LONGEST],
        }
        for voice in sorted(voices, key=lambda voice: voice.at_s)[:MOST_VOICES]
    ]
    if len(voices) > MOST_VOICES:
        text = f"{len(voices) - MOST_VOICES} more are not listed"
        rows.append({**rows[-1], "end": None, "name": "", "text": text})
    return rows
