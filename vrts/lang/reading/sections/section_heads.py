"""Lines that begin or end a section, and those that were meant to: `.LOCATION`, `REALS`."""

import re
from string import ascii_letters, digits
from typing import NamedTuple

from vrts.lang.spelling import nearest

_KINDS = {
    ".PROGRAM": "program",
    ".LOCATIONS": "locations",
    ".TRANS": "locations",
    ".JOINTS": "locations",
    ".REALS": "reals",
    ".DOUBLES": "reals",
    ".STRINGS": "strings",
    ".END": "end",
}
_USUAL = (".PROGRAM", ".LOCATIONS", ".REALS", ".STRINGS", ".END")
_OTHERS = {  # what is written in place of the usual words
    ".LOC": ".LOCATIONS",
    ".LOCS": ".LOCATIONS",
    ".POINT": ".LOCATIONS",
    ".POINTS": ".LOCATIONS",
    ".POSITIONS": ".LOCATIONS",
    ".POSES": ".LOCATIONS",
    ".NUMBERS": ".REALS",
    ".STR": ".STRINGS",
    ".TEXTS": ".STRINGS",
    ".PROG": ".PROGRAM",
    ".PROC": ".PROGRAM",
    ".PROCEDURE": ".PROGRAM",
    ".SUB": ".PROGRAM",
    ".SUBROUTINE": ".PROGRAM",
    ".FUNCTION": ".PROGRAM",
    ".ENDPROGRAM": ".END",
    ".ENDPROG": ".END",
    ".ENDSUB": ".END",
    ".ENDLOCATIONS": ".END",
    ".ENDREALS": ".END",
    ".ENDSTRINGS": ".END",
}
_DOTTED = re.compile(r"\.(?P<blank>[ \t]*)(?P<word>[A-Za-z_*][\w*]*)")
_GLUED = re.compile(r"\.PROGRAM[A-Za-z]\w*$", re.IGNORECASE | re.ASCII)
_PROGRAM = re.compile(r"PROGRAM[ \t]+[A-Za-z][\w.]*(?:[ \t]*\(.*\))?$", re.IGNORECASE)
_DATA = re.compile(  # a section of data without its dot, or with another sign
    r"[^\w\s.;\"]?[ \t]*(?P<word>LOCATIONS?|REALS?|STRINGS?|LOC[A-Z]{5,8})[ \t]*[:.\]]?$",
    re.IGNORECASE,
)
_ALPHANUMERIC = frozenset(ascii_letters + digits)
_BEGINNINGS = frozenset({"pr", "lo", "re", "st"})  # of the words of _PROGRAM and _DATA
_SIGN = re.compile(r"[,:>!*/@-][ \t]*(?P<word>PROGRAM|END)\b", re.IGNORECASE)


_FOREIGN = re.compile(  # how other languages begin a program
    r"(?P<word>DEF|SUB|PROCEDURE|PROC|FUNCTION|FUNC|VOID|INT)[ \t]+"
    r"[A-Za-z][\w.]*[ \t]*(?:\([^()]*\))?"
    r"(?P<behind>[ \t]*(?:[:;{]|BEGIN|IS|AS)?)$",
    re.IGNORECASE,
)


class SectionHead(NamedTuple):
    """The word of a line that begins or ends a section."""

    kind: str  # "program", "locations", "reals", "strings", "end"; "" where it is not known
    end: int  # of the word, in the line
    meant: str = ""  # the word, where another is written
    behind: int = 0  # characters too much at the end of the line


def section_head(text: str, *, strict: bool) -> SectionHead | None:
    """Return the section that a line begins or ends; None for any other line.

    Args:
        text: A line without its comment, blanks stripped.
        strict: Whether words are corrected; AS has many sections of its own.
    """
    if text[:1] == ".":
        return _dotted(text, strict=strict)
    if text[0] in _ALPHANUMERIC and text[:2].lower() not in _BEGINNINGS:
        return None  # as nearly every line
    if _PROGRAM.match(text):
        return SectionHead("program", len("PROGRAM"))
    return _undotted(text) if strict else None


def foreign_head(text: str) -> SectionHead | None:
    """Return what `def grip():` and its like begin, where no program is open."""
    match = _FOREIGN.match(text)
    if match is None:
        return None
    return SectionHead("program", match.end("word"), ".PROGRAM", len(match["behind"]))


def _dotted(text: str, *, strict: bool) -> SectionHead | None:
    match = _DOTTED.match(text)
    if match is None:
        return None
    word, end = "." + match["word"].upper(), match.end()
    known = _KINDS.get(word)
    if known is not None and not match["blank"]:
        return SectionHead(known, end)
    if match["blank"] and (known is None or not strict):
        return None
    if _GLUED.match(text):
        return SectionHead("program", end)  # the header says what is wrong
    meant = word if known else (_OTHERS.get(word) or nearest(word, _USUAL)) if strict else None
    return SectionHead(_KINDS[meant], end, meant) if meant else SectionHead("", end)


def _undotted(text: str) -> SectionHead | None:
    match = _DATA.match(text)
    if match is not None:
        word = "." + match["word"].upper()
        meant = word if word in _USUAL else nearest(word, _USUAL)
        return SectionHead(_KINDS[meant], len(text), meant) if meant else None
    match = _SIGN.match(text)
    if match is not None:
        meant = "." + match["word"].upper()
        return SectionHead(_KINDS[meant], match.end(), meant)
    return None
