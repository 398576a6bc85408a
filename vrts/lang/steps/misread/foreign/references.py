"""`CALL measure(&height)`, `CALL measure(ByRef h)`, `CALL fetch(n = 3)`: arguments with more."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.idioms.wording import smallest_change
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair

_CALL = re.compile(r"CALLS?[ \t]+[A-Za-z$][\w.]*[ \t]*\(.*\)", re.IGNORECASE)
_WORDS = (
    "BYREF|BYVAL|REF|INOUT|OUT|VAR|CONST|INT|INTEGER|REAL|FLOAT|DOUBLE|NUM|STRING|BOOL|LOC|POSE"
    "|IN|PERS"
)
_MORE = re.compile(
    rf"(?<=[(,])[ \t]*(?P<more>&|\*|@|(?:{_WORDS})[ \t]+(?=[A-Za-z$#.&]))[ \t]*(?=[A-Za-z$#.])",
    re.IGNORECASE,
)
_NAMED = re.compile(r"(?<=[(,])[ \t]*(?P<more>[A-Za-z][\w.]*[ \t]*:?=(?!=))[ \t]*", re.ASCII)
_TYPES_OF_AS = frozenset({"&"})  # before locations that are handed over


def more_in_argument(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a CALL that says more of an argument than its value."""
    if _CALL.fullmatch(text) is None or '"' in text:
        return None
    for pattern, says in (
        (_MORE, "`{w}` does not belong here: a variable is handed over itself, and may be changed"),
        (_NAMED, "`{w}` does not belong here: arguments have no names, their order tells"),
    ):
        first = pattern.search(text)
        if first is None or (dialect.is_as and first["more"] in _TYPES_OF_AS):
            continue
        tried = repair.at_once(re.sub(r",(?=\S)", ", ", pattern.sub("", text)))
        if tried is None:
            continue
        start, end, instead = smallest_change(text, tried.text)
        return Meant(
            UNEXPECTED_TEXT,
            says.replace("{w}", first["more"].strip()),
            start,
            end,
            (f"leave it out: write `{tried.text}`",),
            instead,
            sure=True,
            notes=("VAL-II says *Illegal expression syntax*",),
        )
    return None
