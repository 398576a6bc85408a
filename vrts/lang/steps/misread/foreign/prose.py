"""`grip the part`: words to be read by people, without the `;` before them."""

import re

from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.unknown_words import UNKNOWN_INSTRUCTION
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

_WORDS = re.compile(r"[A-Za-z]+(?:[ \t]+[A-Za-z0-9']+){2,}[.!]?", re.ASCII)
_ENGLISH = (
    "the a an is are was has have this that these it its then now until till before after again "
    "here there with from into onto to back and we you i he robot gripper should must will can "
    "when while because first next last all every same"
)
_STEPS = (
    "IF ELSE ELSEIF WHILE FOR CASE SWITCH DO UNTIL VALUE ANY END TYPE PROMPT STOP HALT PAUSE "
    "PRINT INPUT REM CALL GOSUB GOTO SET LET REPEAT LOOP"
)
_OF_ENGLISH, _OF_STEPS = frozenset(_ENGLISH.split()), frozenset(_STEPS.split())
_BETWEEN = re.compile(r"MOVES?[ \t]+(?:FROM[ \t]+)?\w+[ \t]+TO[ \t]+\w+", re.IGNORECASE)
_OF_STEPS_TOO = frozenset({"a", "i", "to", "from", "with", "on", "for"})  # or names, there
_LONG = 4  # words from which on a line that begins with an instruction is prose
_ARTICLES = frozenset({"the", "a", "an", "is", "are", "this", "that"})


def prose(text: str) -> Meant | None:
    """Return what is meant by a line that is a sentence."""
    if _WORDS.fullmatch(text) is None:
        return None
    words = text.lower().rstrip(".!").split()
    if words[0].upper() in _OF_STEPS:
        return None
    if _BETWEEN.fullmatch(text):
        return None
    if text[: len(words[0])].isupper() and words[0].upper() in INSTRUCTIONS:  # `MOVE a b`
        words = [word for word in words if word not in _OF_STEPS_TOO]
    if not _OF_ENGLISH.intersection(words[1:]):
        return None
    if len(words) < _LONG and not _ARTICLES.intersection(words):
        return None
    return Meant(
        UNKNOWN_INSTRUCTION,
        "this reads as a remark, and is no step",
        0,
        len(text),
        (f"begin a comment with `;`: `; {text}`",),
        f"; {text}",
        notes=("VAL-II says *Unknown instruction*",),
    )
