"""`CLOSE THE GRIPPER`: the hand named behind a word that needs no name."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import Meant

NAMES_OF_HAND = frozenset(
    {"gripper", "grippers", "hand", "hands", "grip", "finger", "fingers", "jaw", "jaws", "clamp"}
    | {"claw", "tongs", "pliers"}
)
_NAMED = re.compile(
    r"(?P<word>OPEN|CLOSE|RELAX)(?P<now>I)?[ \t]+(?P<rest>(?:(?:THE|MY|ROBOT|UP|IT)[ \t]+)*"
    r"(?P<name>[A-Za-z]+))",
    re.IGNORECASE,
)


def named_hand(text: str) -> Meant | None:
    """Return what is meant by OPEN, CLOSE or RELAX with a word for the hand behind it."""
    found = _NAMED.fullmatch(text)
    if found is None or found["name"].lower() not in NAMES_OF_HAND:
        return None
    word = found["word"].upper()
    return Meant(
        UNEXPECTED_TEXT,
        f"{word}{'I' if found['now'] else ''} has no name behind it: there is only one hand",
        0,
        len(text),
        (f"write `{word}I`: it acts at once, and waits for the hand",),
        f"{word}I",
        sure=True,
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
