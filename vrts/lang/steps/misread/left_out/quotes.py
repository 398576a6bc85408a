"""`PROMPT number of parts, n`: a text without its quotes."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.reading.literals import MISSING_QUOTE
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


_NO_OPENING = re.compile(
    r"(?P<head>(?:TYPE|PROMPT|STOP|PAUSE|HALT)[ \t]+|\$[\w.]+[ \t]*=[ \t]*)"
    r"(?P<text>[A-Za-z][^\"]*)\"(?P<rest>[^\"]*)",
    re.IGNORECASE | re.ASCII,
)


def opening_quote(text: str, repair: Repair) -> Meant | None:
    """`TYPE Part done"`: return what is meant by a text of which only the end is quoted."""
    found = _NO_OPENING.fullmatch(text)
    if found is None or found["text"].rstrip().endswith((",", "+")):
        return None
    meant = f'{found["head"]}"{found["text"]}"{found["rest"]}'
    if repair.at_once(meant) is None:
        return None
    return Meant(
        MISSING_QUOTE,
        "this text has no double quote before it",
        found.start("text"),
        found.end("text") + 1,
        (f'write `"` before it, too: `{meant}`',),
        f'"{found["text"]}"',
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )
