"""`PROMPT number of parts, n`: a text without its quotes."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair

_ASKED = re.compile(
    rf"PROMPT[ \t]+(?P<text>[A-Za-z][^\",()]*[^\",()\s])[ \t]*"
    rf"(?:,[ \t]*(?P<variables>{VARIABLE}(?:[ \t]*,[ \t]*{VARIABLE})*))",
    re.ASCII | re.IGNORECASE,
)
_WORDS = re.compile(r"[^\s]+[ \t]+[^\s]")


def unquoted_text(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a PROMPT whose text is several words without quotes."""
    found = _ASKED.fullmatch(text)
    if found is None or not _WORDS.match(found["text"]):
        return None
    instead = f'"{found["text"]} "'
    step = f"{text[: found.start('text')]}{instead}, {found['variables']}"
    tried = repair.at_once(step)
    if tried is None:
        return None
    return Meant(
        UNEXPECTED_TEXT,
        "a text stands between double quotes",
        found.start("text"),
        found.end("text"),
        (f"put the text in quotes: `{step}`",),
        instead,
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
