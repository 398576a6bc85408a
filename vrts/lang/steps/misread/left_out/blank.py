"""`GOTO20`: a number glued to the word of its instruction."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import UNKNOWN_INSTRUCTION
from vrts.lang.vocabulary.lookup import spellings

_GLUED = re.compile(
    r"(?P<before>|IF\b.*[\s)])(?P<word>[A-Za-z]{2,})(?P<number>\d+(?:\.\d+)?)(?P<rest>(?![\w.]).*)",
    re.ASCII | re.IGNORECASE,
)
_TEXT_WORDS = frozenset({"TYPE", "STOP", "PAUSE", "HALT"})  # the number would be a message


def glued_number(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by an instruction with its number directly behind it."""
    found = _GLUED.fullmatch(text)
    if found is None or found["word"].upper() not in spellings(dialect):
        return None
    word = found["word"].upper()
    if word in _TEXT_WORDS or (found["before"] and word != "GOTO"):
        return None
    if found["number"] == "1" and f"{word}I" in spellings(dialect):
        return None  # `OPEN1` is OPENI
    instead = f"{found['word']} {found['number']}"
    tried = repair.at_once(f"{found['before']}{instead}{found['rest']}")
    if tried is None:
        return None
    return Meant(
        UNKNOWN_INSTRUCTION,
        f"a blank is missing between {word} and {found['number']}",
        found.start("word"),
        found.end("number"),
        (f"write `{instead}{found['rest']}`",),
        instead,
        sure=True,
        notes=("VAL-II says *Unknown instruction*",),
    )
