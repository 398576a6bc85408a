"""`TYPE "Area",, a` and `MOVE MOVE a`: a sign or a word that stands twice in a row."""

import re
from itertools import pairwise

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.lookup import look_up

_FIRST = re.compile(rf"(?P<given>{VARIABLE}[ \t]*=)|(?P<word>[A-Za-z][\w.]*)", re.ASCII)
_TOKEN = re.compile(r'"[^"]*"?|[$#]?[A-Za-z][\w.]*|\d[\w.]*|==|<>|<=|>=|[^\s]', re.ASCII)


def said_twice(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right without one of two equal tokens in a row."""
    first = _FIRST.match(text)
    begun = first is not None and (first["given"] or look_up(first["word"], dialect).word)
    if not dialect.has("2") and not begun:
        return None  # a block step of AS, for one
    tokens = list(_TOKEN.finditer(text))
    for first, second in pairwise(tokens):
        if first.group().upper() != second.group().upper():
            continue
        glued = first.end() == second.start()
        if glued and not (first.group()[-1].isalnum() or first.group() == ","):
            continue  # another sign, as `**`
        alone = repair.steps(first.group()) if first.group()[0].isalpha() else None
        if alone is not None and not alone.fixes:
            continue  # two steps
        start, end = first.end(), second.end()
        tried = repair.steps(text[:start] + text[end:])
        if tried is None or tried.fixes:
            continue
        written = first.group()
        return Meant(
            UNEXPECTED_TEXT,
            f"`{written}` stands twice",
            second.start(),
            second.end(),
            (f"remove one: write `{tried.text}`",),
            "",
            sure=True,
            notes=("VAL-II says *Illegal expression syntax*",),
        )
    return None
