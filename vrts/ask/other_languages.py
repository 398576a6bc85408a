"""What other languages call a word of VAL-II: read from the tables that diagnostics advise by.

So there is one place in which anybody notes that LIN of KRL is MOVES here.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache

from vrts.lang.steps.idioms.idiom import Idiom, first_words
from vrts.lang.steps.idioms.tables import IDIOMS
from vrts.lang.vocabulary.foreign import FOREIGN, INSTEAD
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.functions_elsewhere import NAMES_ELSEWHERE
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

_WORD = re.compile(r"\$?[A-Za-z][\w.]*")
_CAPITALS = re.compile(r"\$?[A-Z][A-Z0-9.]*")
_TICKS = re.compile(r"`([^`]*)`")
_SMALL = "A ALL AND BY CALL DO ELSE END FOR IF NOT OF OR SET STEP THEN TO TYPE WHILE"
_ORDINARY = frozenset(_SMALL.split())  # English, too, or only there to hold others together


@cache
def names_elsewhere() -> Mapping[str, tuple[str, ...]]:
    """Return what other languages say for a word of VAL-II, by that word, the likeliest first."""
    found: dict[str, Counter[str]] = {}
    for foreign, own in _pairs():
        if foreign.upper() != own:
            found.setdefault(own, Counter())[foreign.lower()] += 1
    return {own: tuple(word for word, _ in count.most_common()) for own, count in found.items()}


@cache
def own_words() -> Mapping[str, tuple[str, ...]]:
    """Return the words of VAL-II that a word of another language stands for, by that word."""
    found: dict[str, Counter[str]] = {}
    for foreign, own in _pairs():
        if foreign.upper() != own:
            found.setdefault(foreign.lower(), Counter())[own] += 1
    return {word: tuple(own for own, _ in count.most_common(3)) for word, count in found.items()}


def _pairs() -> Iterator[tuple[str, str]]:
    """Yield a word of another language and one that VAL-II has for it."""
    for foreign, (_, help_) in FOREIGN.items():
        yield from ((foreign, own) for own in _own(help_))
    for help_, words in INSTEAD:
        whole = [word for word in words.split() if "*" not in word]
        yield from ((foreign, own) for foreign in whole for own in _own(help_))
    for foreign, templates in NAMES_ELSEWHERE.items():
        yield from ((foreign, own) for text in templates for own in _own(text))
    for idiom in IDIOMS:
        own = tuple(_own(idiom.instead or " ".join(_TICKS.findall(idiom.help))))
        for foreign in _foreign(idiom):
            yield from ((foreign, word) for word in own[:1])


def _own(text: str) -> Iterator[str]:
    """Yield the words of VAL-II in some text, each once."""
    found: dict[str, None] = dict.fromkeys(_CAPITALS.findall(text))
    known = [w for w in found if w in INSTRUCTIONS or w.lower() in FUNCTIONS]
    told = [w for w in known if w not in _ORDINARY]
    yield from told or known


def _foreign(idiom: Idiom) -> Iterator[str]:
    """Yield the words that a pattern begins with, unless VAL-II has them itself."""
    head = re.match(r"<([^<>]*)>|([A-Za-z$][\w$.]*)", idiom.pattern)
    if head is None:
        return
    for words in (head[1] or head[2]).split("|"):
        name = _WORD.match(words.strip("_ "))
        if name and len(name[0]) > 1 and name[0].strip("_").upper() not in INSTRUCTIONS:
            yield name[0].strip("_")
    if idiom.pattern[0] != "<":  # the first word alone: `tpwrite {s}`
        yield from (w for w in first_words(idiom) if len(w) > 1 and w not in INSTRUCTIONS)
