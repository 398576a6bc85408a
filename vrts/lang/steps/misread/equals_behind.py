"""`SPEED = 50 ALWAYS`, `APPRO = part, 50`: an instruction with `=` behind its word."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.lookup import look_up

_EQUALS = re.compile(r"(?P<word>[A-Za-z]+)(?P<equals>[ \t]*:?=(?!=)[ \t]*)(?P<rest>.+)", re.ASCII)


def equals_behind(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right without its `=`."""
    found = _EQUALS.fullmatch(text)
    if found is None:
        return None
    word = look_up(found["word"], dialect).word
    if word is None or word.text != found["word"].upper():
        return None
    tried = repair.at_once(f"{found['word']} {found['rest']}")
    if tried is None:
        return None
    return Meant(
        UNEXPECTED_TEXT,
        f"{word.text} takes no `=`",
        found.start("equals"),
        found.end("equals"),
        (f"write `{tried.text}`",),
        " ",
        sure=True,
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
