"""Names that people give themselves: what is shown of one, and a number where it is another's."""

import unicodedata
from collections.abc import Iterable
from typing import Final

from vrts.live.people.letters import BLANK, allowed, clusters, plain
from vrts.live.people.skeleton import look, look_once

LONGEST: Final = 40  # letters, as people count them
LONGEST_GIVEN: Final = 160  # characters
# words of roles, of the page and of the server: no guest is called so
RESERVED: Final = (
    *("supervisor", "operator", "viewer", "guest"),
    *("vrts", "server", "system", "admin", "administrator", "moderator"),
    *("all", "everybody", "somebody", "nobody", "you"),
)


def person_name(given: str) -> str:
    """Return a name as it can be shown, in Unicode's form NFC; empty where nothing is left of it.

    Characters that no name has become blanks: symbols, emoji, brackets, controls. Invisible ones
    are left out. A character that is dressed up, such as a bold or wide one, becomes the plain one.
    """
    spelt = unicodedata.normalize("NFC", "".join(map(plain, given[:LONGEST_GIVEN])))
    name = unicodedata.normalize("NFC", BLANK.join(allowed(spelt).split()))
    name = "".join(clusters(name)[:LONGEST]).strip()
    return name if any(character.isalnum() for character in name) else ""


class Taken:
    """Names that nobody else may have, nor what can be taken for them."""

    def __init__(self, names: Iterable[str]) -> None:
        """Take the names of those who are or were here."""
        self._names = set(names)
        self._shown: set[int] = set()
        for name in self._names:
            self._shown.update(look(name).shown)

    def add(self, name: str) -> None:
        """Take one more."""
        self._names.add(name)
        self._shown.update(look(name).shown)

    def has(self, name: str) -> bool:
        """Return whether a name can be taken for one of these."""
        return name in self._names or not self._shown.isdisjoint(look(name).watched)


def own_name(name: str, taken: Taken, *, guest: bool) -> str:
    """Return a name that nobody else has: with a number where another's looks the same.

    Args:
        name: As it can be shown.
        taken: The others' names.
        guest: Whether the words of roles are not to be had.
    """
    if not taken.has(name) and not (guest and is_role(name)):
        return name
    number = 2
    while taken.has(f"{name} {number}"):
        number += 1
    return f"{name} {number}"


def is_role(name: str) -> bool:
    """Return whether a name can be taken for a word of a role, blanks and signs left out."""
    letters = "".join(c for c in name if c.isalnum() or unicodedata.category(c)[0] == "M")
    seen = look_once(letters)
    return any(look(word).alike(seen) for word in RESERVED)
