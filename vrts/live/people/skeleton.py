"""What a name looks like: skeletons of Unicode Technical Standard 39, section 4.

Two names with one skeleton can be taken for each other. The table of characters that look alike is
Unicode's own (`vendored.toml` says where it is from), closed: what stands for a character stands
for itself. Upper and lower case are compared as well. Where directions of writing mix, the standard
orders a name as it is displayed; here such a name is alike to every other one of the same
characters, which errs on the safe side.
"""

import functools
import unicodedata
from importlib.resources import files
from typing import Final, NamedTuple

from vrts.live.people.letters import clusters, is_ignorable

TABLE: Final = "confusables.txt"
KNOWN: Final = 8192  # names whose looks are remembered: more than there are accounts


class Look(NamedTuple):
    """What somebody sees of a name, as keys to be compared: numbers of 64 bits, which take little.

    They are Python's hashes, with a key of this process that nobody outside knows.
    """

    shown: tuple[int, ...]
    watched: tuple[int, ...]  # a name that shows one of these can be taken for this one

    def alike(self, other: "Look") -> bool:
        """Return whether two names can be taken for each other."""
        return any(key in other.shown for key in self.watched)


def skeleton(text: str) -> str:
    """Return the skeleton of a text, in the order in which it is stored."""
    plain = unicodedata.normalize("NFD", text)
    prototypes = _prototypes()
    mapped = "".join(prototypes.get(c, c) for c in plain if not is_ignorable(c))
    return unicodedata.normalize("NFD", mapped)


@functools.lru_cache(maxsize=KNOWN)
def look(name: str) -> Look:
    """Return what somebody sees of a name; it is remembered, as each new name is compared."""
    return look_once(name)


def look_once(name: str) -> Look:
    """Return what somebody sees of a name that is compared only now."""
    kinds = {unicodedata.bidirectional(character) for character in name}
    leftward = bool(kinds & {"R", "AL"})
    if leftward and not kinds & {"L", "EN", "AN"}:
        name = "".join(reversed(clusters(name)))  # as it is displayed, from left to right
        leftward = False
    keys = {_folded(skeleton(name)), _folded(skeleton(name.casefold()))}
    same = {"".join(sorted(key)) for key in keys}
    mixed, all_ = ({f"{kind} {key}" for key in same} for kind in ("mixed", "all"))
    if leftward:
        return Look(_hashed(mixed | all_), _hashed(all_))
    shown = {f"is {key}" for key in keys}
    return Look(_hashed(shown | all_), _hashed(shown | mixed))


def _hashed(keys: set[str]) -> tuple[int, ...]:
    return tuple(map(hash, keys))


def _folded(text: str) -> str:
    return skeleton(text.casefold())


@functools.cache
def _prototypes() -> dict[str, str]:
    """Return what stands for each character that looks like another."""
    found: dict[str, str] = {}
    text = files("vrts.live.people").joinpath(TABLE).read_text("ascii")
    for line in text.splitlines():
        if line.startswith("#"):
            continue
        prototype, _, alike = line.partition(":")
        shown = "".join(chr(int(code, 16)) for code in prototype.split())
        found.update((chr(int(code, 16)), shown) for code in alike.split())
    # some prototypes have, taken apart, characters that look like another: the table closed
    while (closed := {source: _mapped(to, found) for source, to in found.items()}) != found:
        found = closed
    return found


def _mapped(text: str, prototypes: dict[str, str]) -> str:
    return "".join(prototypes.get(c, c) for c in unicodedata.normalize("NFD", text))
