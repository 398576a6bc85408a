"""All idioms, found by the first word of a step."""

from collections.abc import Iterator
from functools import cache

from vrts.lang.steps.idioms.approaching import APPROACHING
from vrts.lang.steps.idioms.blocks import BLOCKS
from vrts.lang.steps.idioms.factory import FACTORY
from vrts.lang.steps.idioms.hand import HAND
from vrts.lang.steps.idioms.idiom import Idiom, Matched, first_words, match
from vrts.lang.steps.idioms.languages.compiled import COMPILED
from vrts.lang.steps.idioms.languages.methods import METHODS
from vrts.lang.steps.idioms.languages.scripts import SCRIPTS
from vrts.lang.steps.idioms.moving import MOVING
from vrts.lang.steps.idioms.places import PLACES
from vrts.lang.steps.idioms.robots.karel import KAREL
from vrts.lang.steps.idioms.robots.kawasaki import KAWASAKI
from vrts.lang.steps.idioms.robots.krl import KRL
from vrts.lang.steps.idioms.robots.rapid import RAPID
from vrts.lang.steps.idioms.robots.urscript import URSCRIPT
from vrts.lang.steps.idioms.robots.vplus import VPLUS
from vrts.lang.steps.idioms.signals import SIGNALS
from vrts.lang.steps.idioms.speeds import SPEEDS
from vrts.lang.steps.idioms.terminal import TERMINAL
from vrts.lang.steps.idioms.values import VALUES

IDIOMS = (
    *RAPID,
    *KRL,
    *URSCRIPT,
    *KAREL,
    *FACTORY,
    *VPLUS,
    *KAWASAKI,
    *SCRIPTS,
    *COMPILED,
    *BLOCKS,
    *SIGNALS,
    *TERMINAL,
    *PLACES,
    *MOVING,
    *APPROACHING,
    *SPEEDS,
    *HAND,
    *VALUES,
    *METHODS,
)
MOST_CHARACTERS = 300  # of a step that is looked at
MOST_PARTS = 12  # of a list in it: to try all ways to part more would take long


def matches(text: str) -> Iterator[Matched]:
    """Return the idioms that a step is, the likeliest first."""
    if len(text) > MOST_CHARACTERS or max(map(text.count, ",;")) > MOST_PARTS:
        return
    word = ""
    for sign in text:
        if not ("A" <= sign <= "Z" or "a" <= sign <= "z"):
            break
        word += sign
    by_word = _by_first_word()
    for idiom in (*by_word.get(word.upper(), ()), *by_word.get("", ())):
        found = match(idiom, text)
        if found is not None:
            yield found


@cache
def _by_first_word() -> dict[str, tuple[Idiom, ...]]:
    found: dict[str, list[Idiom]] = {}
    for idiom in IDIOMS:
        for word in dict.fromkeys(first_words(idiom)):
            found.setdefault(word, []).append(idiom)
    return {word: tuple(idioms) for word, idioms in found.items()}
