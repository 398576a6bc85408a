"""Words that may be meant by one with a slip in it, by what would be a step."""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from vrts.lang.dialect import Dialect
from vrts.lang.said_by_relatives import WORDS_IN_AS
from vrts.lang.spelling import edit_distance, near
from vrts.lang.steps.repair import Repair, Tried
from vrts.lang.vocabulary.lookup import look_up, spellings


class Near(NamedTuple):
    """A word that may be meant, and the step that it makes."""

    word: str
    tried: Tried


def meant_by(first: str, rest: str, repair: Repair, dialect: Dialect) -> list[Near]:
    """Return the instructions most likely meant by the first word of a step."""
    written = first.upper()
    fitting: list[tuple[int, int, Near]] = []
    for distance, known in near(written, _known(dialect)):
        own = known in spellings(dialect)
        word = known if own else WORDS_IN_AS[known]
        tried = repair.steps(word + rest)
        if tried is not None:
            fitting.append((tried.fixes, distance, Near(word, tried)))
    if not fitting:
        return []
    best = min((fixes, distance) for fixes, distance, _ in fitting)
    rivals = [found for fixes, distance, found in fitting if (fixes, distance) == best]
    for likelier in _LIKELIER:
        rivals = [rival for rival in rivals if likelier(rival.word, written)] or rivals
    return sorted(rivals, key=lambda rival: rival.word)


def _known(dialect: Dialect) -> frozenset[str]:
    """Return the words that one may be a slip for: in AS those of VAL-II too, which it renames."""
    return spellings(dialect) | WORDS_IN_AS.keys() if dialect.is_as else spellings(dialect)


def acting_at_once(word: str) -> str:
    """Return what else may be meant where a word of the hand is: the one that acts at once."""
    return f", or `{word}I`, which acts at once" if word in ("OPEN", "CLOSE", "RELAX") else ""


def slips(written: str, words: Iterable[str]) -> list[str]:
    """Return the words that one in the middle of a step may be a slip for."""
    return [
        word
        for word in sorted(words)
        if word != written
        and edit_distance(written, word, 2) <= 1 + (len(word) > 4)
        and (len(word) > 2 or written[0] == word[0])
    ]


def short_for(first: str, rest: str, repair: Repair, dialect: Dialect) -> str | None:
    """Return the word that is meant by a beginning of several: the one that the others go on."""
    words = [word.text for word in look_up(first, dialect).candidates]
    fitting = [word for word in words if repair.steps(word + rest) is not None]
    meant = [word for word in fitting if all(other.startswith(word) for other in fitting)]
    return meant[0] if meant else None


def _slipped_i(word: str, written: str) -> bool:
    """Whether only the I at the end is another letter: one that looks so, or lies beside it."""
    return word[-1] == "I" and word[:-1] == written[:-1] and written[-1] in "1LJUOK"


def _begins(word: str, written: str) -> bool:
    return written.startswith(word) or word.startswith(written)  # one letter more, or less


def _swapped(word: str, written: str) -> bool:
    return sorted(word) == sorted(written)


def _same_ends(word: str, written: str) -> bool:
    return word[0] == written[0] and word[-1] == written[-1]


def _same_start(word: str, written: str) -> bool:
    return word[0] == written[0]


_LIKELIER: tuple[Callable[[str, str], bool], ...] = (
    _slipped_i,
    _begins,
    _swapped,
    _same_ends,
    _same_start,
)
