"""Which instruction a first word stands for [manual language/names#abbreviations]."""

from functools import cache, lru_cache

from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions, bare_functions
from vrts.lang.vocabulary.instructions import INSTRUCTIONS, VPLUS_FORMS
from vrts.lang.vocabulary.word import Match, Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

_PLAIN_WORDS = frozenset(  # of AS, that people give to signals and numbers
    {
        *("ABOVE", "ALIGN", "ANY", "BASE", "BELOW", "BITS", "BREAK", "CASE", "CLOSE", "DELAY"),
        *("DRAW", "DRIVE", "END", "HALT", "HERE", "HOME", "LOCK", "OPEN", "PAUSE", "POINT"),
        *("PRINT", "PROMPT", "PULSE", "RELAX", "RESET", "RETURN", "SIGNAL", "SPEED", "STABLE"),
        *("STEP", "STOP", "TIMER", "TOOL", "TYPE", "VALUE", "WAIT"),
    }
)


@cache
def instructions_of(dialect: Dialect) -> dict[str, Word]:
    """Return the instructions of a dialect."""
    words = {text: word for text, word in INSTRUCTIONS.items() if dialect.has(word.dialects)}
    return words if dialect.has("a12") else words | VPLUS_FORMS


@cache
def spellings(dialect: Dialect) -> frozenset[str]:
    """Return the spellings of the instructions of a dialect."""
    return frozenset(instructions_of(dialect))


@cache
def reserved_words(dialect: Dialect) -> frozenset[str]:
    """Return every word, in upper case, that a name had better not be."""
    qualifiers = {text for text, word in QUALIFIERS.items() if dialect.has(word.dialects)}
    functions = {
        name.upper()
        for name, signature in applied_functions(dialect).items()
        if dialect.has(signature.dialects)
    }
    return spellings(dialect) | qualifiers | OPERATORS.keys() | functions


@cache
def never_names(dialect: Dialect) -> frozenset[str]:
    """Return keywords that are hardly meant for a variable which nothing gives a value."""
    if not (dialect.is_vplus or dialect.is_as):
        return frozenset()
    words = instructions_of(dialect).values()
    keywords = {word.text for word in words if not word.opaque} | QUALIFIERS.keys()
    predefined = bare_functions(dialect).keys() | CONSTANTS.keys()
    return frozenset(keywords - {name.upper() for name in predefined})


def hardly_a_name(written: str, dialect: Dialect) -> bool:
    """Return whether a word is no name of anything that has no value in sight.

    People who write AS call signals and numbers `open` and `type`; its controllers store keywords
    in capitals and names in small letters.
    """
    upper = written.upper()
    if upper not in never_names(dialect):
        return False
    return not dialect.is_as or written == upper or upper not in _PLAIN_WORDS


def look_up(text: str, dialect: Dialect = VAL2) -> Match:
    """Return the instruction a first word stands for.

    An exact word wins, then a unique prefix; structure words are written in full. `val2+` also
    takes a prefix of several words of which one begins all the others: MOV for MOVE.
    """
    text = text.upper()
    words = instructions_of(dialect)
    exact = words.get(text)
    return Match(exact) if exact is not None else _abbreviated(text, dialect)


@lru_cache(4096)
def _abbreviated(text: str, dialect: Dialect) -> Match:
    if dialect.is_vplus and len(text) == 1:
        return Match(None)  # `i 0` of a file is `i = 0`, not IGNORE
    found = [
        word
        for word in instructions_of(dialect).values()
        if not word.full
        and (not word.means or dialect.is_as)
        and word.text.startswith(text)
        and not (word.shortest == "WH" and len(text) < 2)
    ]
    fixed = [word for word in found if word.shortest and text.startswith(word.shortest)]
    if fixed:
        return Match(fixed[0])
    if len(found) > 1 and dialect.takes_all:
        shortest = min(found, key=lambda word: len(word.text))
        if all(word.text.startswith(shortest.text) for word in found):
            return Match(shortest, tuple(found))
    if len(found) == 1:
        return Match(found[0])
    return Match(None, tuple(sorted(found, key=lambda word: word.text)))
