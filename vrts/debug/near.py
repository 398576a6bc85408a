"""Words that are nearly a word, as a question: what somebody may have meant."""

from collections.abc import Iterable, Sequence
from difflib import get_close_matches

_MOST = 3


def near_words(word: str, known: Iterable[str], least: float = 0.6) -> str:
    """Return words that are nearly one, as a question behind a colon; nothing where none is.

    Args:
        word: What was written.
        known: What there is.
        least: How like it a word has to be, from 0 to 1.
    """
    near = get_close_matches(word, sorted(known), _MOST, least)
    return f": {either(near)}?" if near else ""


def either(words: Sequence[str]) -> str:
    """Return words in quotes, with `or` before the last."""
    quoted = [f"`{word}`" for word in words]
    return " or ".join([", ".join(quoted[:-1]), quoted[-1]] if len(quoted) > 1 else quoted)
