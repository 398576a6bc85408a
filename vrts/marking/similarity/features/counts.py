"""How often a program has each word of the language, and how many programs its file has.

What everybody has weighs nothing where rare things are looked for. Where the programs of a class
are much alike, that one of them leaves out what the other leaves out still tells something.
"""

import re
from collections import Counter

from vrts.lang.dialect import VAL2
from vrts.lang.vocabulary.lookup import reserved_words
from vrts.marking.similarity.symbols import Readable

MOST_LINES = 20_000  # of a file

_STRING = re.compile(r'"[^"]*"?')
_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_RESERVED = frozenset(word.upper() for word in reserved_words(VAL2))
_PROGRAMS = ".PROGRAM"

Counts = tuple[tuple[str, int], ...]


def words_counted(file: Readable) -> Counts:
    """Return each word of the language with how often a file has it, sorted."""
    found: Counter[str] = Counter()
    room = MOST_LINES
    for section in file.sections:
        if section.kind != "program":
            continue
        found[_PROGRAMS] += 1
        for line in section.lines[:room]:
            words = map(str.upper, _WORD.findall(_STRING.sub("", line.text)))
            found.update(word for word in words if word in _RESERVED)
        room = max(0, room - len(section.lines))
    return tuple(sorted(found.items()))
