"""A step of V+ or AS that is one of the mistakes which their students make."""

import re
from functools import cache

from vrts.lang.dialect import Dialect
from vrts.lang.steps.idioms.idiom import Idiom, filled, first_words, match
from vrts.lang.steps.idioms.tables import MOST_CHARACTERS, MOST_PARTS
from vrts.lang.steps.idioms.wording import first_word, what_to_write, with_article
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.misread.relatives.kawasaki import AS_SLIPS
from vrts.lang.steps.misread.relatives.vplus import VPLUS_SLIPS
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import OTHER_DIALECT
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Match

READABLE = frozenset(  # begin slips that the grammar takes for steps
    {
        *("ATTACH", "DETACH", "FCLOSE", "FEMPTY", "FDELETE"),
        *("WRITE", "READ", "FOPEN", "FOPENR", "FOPENW", "FOPENA", "SWAIT"),
        *("OPEN", "OPENI", "CLOSE", "CLOSEI", "RELAX", "RELAXI", "EXIT", "NEXT", "WAIT.EVENT"),
        *("XMOVE", "ON", "SPEED", "CASE", "ACCURACY", "ACCEL", "DECEL", "TWAIT", "STABLE"),
    }
)
_WORDS = re.compile(r"<([A-Za-z.|_]+)>")
_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_ONE_OF, _IN_SECONDS = "{w}", "{d/1000}"
_MILLI = 1000
_NO_WORD = Match(None)


def slip(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is one of these mistakes."""
    for idiom, parts in _matches(text, dialect):
        instead = filled(idiom.instead, parts)
        if instead and repair.at_once(instead) is None:
            continue
        help_ = filled(idiom.help, parts) or what_to_write(instead, text)
        rule, says = INVALID_EXPRESSION, filled(idiom.says, parts)
        notes = (idiom.note,) if idiom.note else ()
        first = first_word(text)
        if first and look_up(first, dialect) == _NO_WORD:
            rule, notes = OTHER_DIALECT, (says, *notes)
            says = f"{first.upper()} is not {with_article(dialect.title)} instruction"
        return Meant(
            rule,
            says,
            0,
            len(text),
            (help_,),
            instead or None,
            sure=idiom.sure,
            notes=notes,
        )
    return None


def readable_slip(text: str, dialect: Dialect) -> str:
    """Return what is wrong with a step that the grammar takes; empty where nothing is."""
    return next((filled(idiom.says, parts) for idiom, parts in _matches(text, dialect)), "")


def _matches(text: str, dialect: Dialect) -> list[tuple[Idiom, dict[str, str]]]:
    rows = _rows(dialect)
    if rows is None or len(text) > MOST_CHARACTERS or text.count(",") > MOST_PARTS:
        return []
    first = re.match(r"[A-Za-z]*", text)
    assert first is not None
    found = [(row, match(row, text)) for row in rows.get(first.group().upper(), ())]
    return [(_worded(row, text, m.parts), m.parts) for row, m in found if m is not None]


def _worded(idiom: Idiom, text: str, parts: dict[str, str]) -> Idiom:
    """Return a row with the word that was written, and a time in seconds, in their places."""
    listed = _WORDS.search(idiom.pattern)
    words = listed[1].upper().split("|") if listed is not None else []
    written = (found.group().upper() for found in _WORD.finditer(text))
    word = next((w for w in written if w in words), "")
    instead, says = idiom.instead.replace(_ONE_OF, word), idiom.says.replace(_ONE_OF, word)
    if _IN_SECONDS in instead:
        instead = instead.replace(_IN_SECONDS, f"{float(parts['d']) / _MILLI:g}")
    return idiom._replace(instead=instead, says=says)


@cache
def _rows(dialect: Dialect) -> dict[str, tuple[Idiom, ...]] | None:
    """Return the mistakes of a dialect by the letters that their steps begin with."""
    if not (dialect.is_vplus or dialect.is_as):
        return None
    found: dict[str, list[Idiom]] = {}
    for idiom in VPLUS_SLIPS if dialect.is_vplus else AS_SLIPS:
        for word in dict.fromkeys(first_words(idiom)):
            found.setdefault(word, []).append(idiom)
    return {word: tuple(idioms) for word, idioms in found.items()}
