"""`WAIT DI[1]=ON`, `IF $IN[3] THEN`: an input as an element of an array, which SIG asks for."""

import re
from typing import NamedTuple

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair

NAMES = frozenset({"di", "din", "ri", "sdi", "ui", "in", "gi", "$in", "$di", "$input", "$din"})
_FIRST = 1000  # input 1 is signal 1001
_KEPT = frozenset({"TYPE", "PROMPT", "CALL"})  # hardly ask for a signal
_INPUT = re.compile(
    r"(?<![\w.$#])(?P<name>\$IN|\$DI|\$DIN|\$INPUT|DI|DIN|RI|SDI|UI|IN)[ \t]*"
    r"(?:\[[ \t]*(?P<index>\d+)[ \t]*(?::[^\]]*)?\]|\([ \t]*(?P<argument>\d+)[ \t]*\))"
    r"(?:[ \t]*(?P<sign>==?|<>|!=)[ \t]*(?P<state>ON|OFF|TRUE|FALSE|HIGH|LOW|1|0)\b)?",
    re.ASCII | re.IGNORECASE,
)
_WAITED = re.compile(r"(?P<word>WAIT)[ \t]+(?:FOR|UNTIL)[ \t]+", re.IGNORECASE)
_OFF = frozenset({"OFF", "FALSE", "LOW", "0"})


class Asked(NamedTuple):
    """An input in a text, and SIG for it."""

    start: int
    end: int
    instead: str


def inputs(text: str) -> list[Asked]:
    """Return the inputs of a text that are written as elements of an array."""
    return [_asked(place) for place in _INPUT.finditer(text)]


def input_at(text: str, at: int) -> Asked | None:
    """Return the input that begins at an offset."""
    place = _INPUT.match(text, at)
    return _asked(place) if place is not None else None


def _asked(place: re.Match[str]) -> Asked:
    number = int(place["index"] or place["argument"])
    number += _FIRST if number < _FIRST else 0
    off = (place["state"] or "").upper() in _OFF
    unlike = place["sign"] in ("<>", "!=")
    sign = "-" if off is not unlike else ""
    return Asked(place.start(), place.end(), f"SIG({sign}{number})")


def asked_input(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right with SIG in the place of its inputs."""
    places = inputs(text)
    first = re.match(r"[A-Za-z]+", text)
    if not places or first is None or first.group().upper() in _KEPT or '"' in text:
        return None
    step, end = text, 0
    for place in reversed(places):
        step = f"{step[: place.start]}{place.instead}{step[place.end :]}"
    plain = _WAITED.sub(r"\g<word> ", step)
    tried = repair.steps(plain)
    if tried is None:
        return None
    start, end = places[0].start, places[-1].end
    name = re.split(r"[ \t\[(]", text[start:], maxsplit=1)[0]
    if plain != step or tried.text != plain:
        start, end = 0, len(text)
    instead = tried.text if (start, end) == (0, len(text)) else _between(step, text, start, end)
    return Meant(
        INVALID_EXPRESSION,
        f"an input is asked for by SIG, not as `{name}[...]`",
        start,
        end,
        (f"write `{tried.text}`: input 1 is signal 1001",),
        instead,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )


def _between(step: str, text: str, start: int, end: int) -> str:
    """Return what stands in the new step where the old one had a range."""
    return step[start : len(step) - (len(text) - end)]
