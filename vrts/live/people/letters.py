"""Characters of names: which a name may have, and which of them stand together as one letter.

Letters, marks and digits of every script; blanks, hyphens, apostrophes and the few signs that the
names of people have (Unicode Standard Annex 31, table 3a). No symbols, no emoji, nothing
invisible but the joiners that some scripts write with (RFC 5892, appendix A).
"""

import unicodedata
from typing import Final

BLANK: Final = " "
SIGNS: Final = frozenset("-'.·\u058a\u05be\u05f3\u05f4\u0f0b\u2010\u2019\u2027\u30a0\u30fb")
MOST_MARKS: Final = 4  # on one letter: Unicode Technical Standard 39, section 5.4
NON_JOINER, JOINER = "\u200c", "\u200d"

# how characters are dressed up that say the same without it
_DRESSED = frozenset(
    ("<font>", "<super>", "<sub>", "<circle>", "<square>", "<wide>", "<narrow>", "<vertical>")
) | frozenset(("<initial>", "<medial>", "<final>", "<isolated>", "<small>", "<noBreak>"))
_VIRAMA = 9  # combining class of what joins the letters of Indic scripts
# Default_Ignorable_Code_Point, a property that Unicode keeps stable: shown as nothing
_IGNORABLE = (
    range(0xAD, 0xAE),
    range(0x34F, 0x350),
    range(0x61C, 0x61D),
    range(0x115F, 0x1161),
    range(0x17B4, 0x17B6),
    range(0x180B, 0x1810),
    range(0x200B, 0x2010),
    range(0x202A, 0x202F),
    range(0x2060, 0x2070),
    range(0x3164, 0x3165),
    range(0xFE00, 0xFE10),
    range(0xFEFF, 0xFF00),
    range(0xFFA0, 0xFFA1),
    range(0xFFF0, 0xFFF9),
    range(0x1BCA0, 0x1BCA4),
    range(0x1D173, 0x1D17B),
    range(0xE0000, 0xE1000),
)


def is_ignorable(character: str) -> bool:
    """Return whether a character is shown as nothing."""
    return any(ord(character) in among for among in _IGNORABLE)


def plain(character: str) -> str:
    """Return what a character says without being dressed up: wide, bold, raised, in a circle."""
    kind = unicodedata.decomposition(character).partition(" ")[0]
    return unicodedata.normalize("NFKC", character) if kind in _DRESSED else character


def allowed(text: str) -> str:
    """Return a text with blanks where it has characters that no name has, and nothing invisible."""
    kept: list[str] = []
    marks = 0
    for at, character in enumerate(text):
        kind = unicodedata.category(character)
        if character in (NON_JOINER, JOINER):
            if _joins(character, text, at):
                kept.append(character)
        elif is_ignorable(character):
            continue
        elif kind in ("Mn", "Mc"):
            marks += 1
            if marks <= MOST_MARKS and kept and kept[-1] != BLANK and character != kept[-1]:
                kept.append(character)
            continue
        else:
            own = kind[0] == "L" or kind == "Nd" or character in SIGNS
            kept.append(character if own else BLANK)
        marks = 0
    return "".join(kept)


def clusters(text: str) -> list[str]:
    """Return the letters of a name as people count them, each with what stands on it."""
    found: list[str] = []
    for character in text:
        if found and _goes_on(found[-1], character):
            found[-1] += character
        else:
            found.append(character)
    return found


def _goes_on(before: str, character: str) -> bool:
    if unicodedata.category(character)[0] == "M" or character in (NON_JOINER, JOINER):
        return True
    last = before[-1]
    jamo = "\u1160" <= character <= "\u11ff" and "\u1100" <= last <= "\u11ff"
    joined = last == JOINER or unicodedata.combining(last) == _VIRAMA
    return jamo or (joined and unicodedata.category(character) == "Lo")


def _joins(joiner: str, text: str, at: int) -> bool:
    """Return whether a joiner changes how the letters beside it are written."""
    if at and unicodedata.combining(text[at - 1]) == _VIRAMA:
        return True
    before = next((c for c in reversed(text[:at]) if unicodedata.category(c) != "Mn"), "")
    after = next((c for c in text[at + 1 :] if unicodedata.category(c) != "Mn"), "")
    connected = all(c and unicodedata.bidirectional(c) == "AL" for c in (before, after))
    return joiner == NON_JOINER and connected
